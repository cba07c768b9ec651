// Cheap tests come first: conditions on parameters, then those that need the solution, a whole cycle, a drawing.
#include "constructions/positions/variants.hpp"

#include <algorithm>
#include <utility>

#include "constructions/solving/solve.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;

/// Default choice of results if the file requests none.
std::vector<NamedResult> suited(const std::vector<NamedResult>& results) {
    for (const Kind kind : {Kind::effort, Kind::omega}) {
        std::vector<NamedResult> chosen;
        for (const NamedResult& each : results)
            if (each.column.kind == Column::Kind::result && each.column.quantity.kind == kind) chosen.push_back(each);
        if (!chosen.empty()) return chosen;
    }
    return results;
}

/// A fault that occurs only with these values: its place, without the numbers.
Words of_these_values(const Error& error) {
    return {lang::positions::no_mechanism_with_these_values, error.where.empty() ? std::string("/") : error.where};
}

}  // namespace

Result<Variants> Variants::of(std::string text, std::string source, std::vector<Setting> set, std::uint64_t seed) {
    auto original = read_mechanism(text, source, set);
    if (!original) return tl::unexpected(std::move(original.error()));
    const auto size = original->exercise ? Lattice::size(original->exercise->vary) : std::nullopt;
    if (!size || original->exercise->vary.empty())
        return tl::unexpected(Errors{{ErrorCode::bad_input, {}, {lang::positions::nothing_varies_add_vary}}});
    return Variants(std::move(text), std::move(source), std::move(set), *std::move(original), seed, *size);
}

void Variants::reject(Words why) {
    const auto known =
        std::find_if(rejections_.begin(), rejections_.end(), [&](const Rejection& each) { return each.why == why; });
    if (known != rejections_.end())
        ++known->count;
    else
        rejections_.push_back({std::move(why), 1});
}

Result<std::optional<Variant>> Variants::next(const IsReadable& is_readable, const std::function<bool()>& stops) {
    for (std::uint64_t in_a_row = 0; looked_at_ < size_ && in_a_row < most_in_a_row; ++in_a_row) {
        if (stops && stops()) break;
        auto found = drawn(order_.at(looked_at_++), is_readable);
        if (!found || *found) return found;
    }
    return std::optional<Variant>();
}

Result<std::optional<Variant>> Variants::drawn(std::uint64_t number, const IsReadable& is_readable) {
    const auto rejected = [&](Words why) {
        reject(std::move(why));
        return std::optional<Variant>();
    };
    const auto named = [](const Condition& condition) { return Words(quoted(condition.text)); };
    std::vector<Setting> values = Lattice::at(original_.exercise->vary, number);
    std::vector<Setting> all = set_;
    for (const Setting& each : values) {
        std::erase_if(all, [&](const Setting& other) { return other.name == each.name; });
        all.push_back(each);
    }
    auto mechanism = read_mechanism(text_, source_, all);
    if (!mechanism) return rejected(of_these_values(mechanism.error().front()));
    const auto exercise = mechanism->exercise;
    for (const Condition& each : exercise->require)
        if (each.holds && !*each.holds) return rejected(named(each));
    if (drawn_.contains(exercise->comes_to)) return rejected({lang::positions::the_same_mechanism_as_another_variants});
    auto solved = solve(*std::move(mechanism));
    if (!solved) return rejected(of_these_values(solved.error().front()));
    if (!solved->unsolved.empty()) return rejected({lang::positions::no_unique_answer});
    std::vector<NamedResult> results = results_for(*exercise, *solved);
    for (const Condition& each : exercise->require)
        if (auto missing = missing_polygon(*solved, each)) return tl::unexpected(Errors{*std::move(missing)});
    for (const Condition& each : exercise->require) {
        const bool compares = each.kind == Condition::Kind::compares || each.kind == Condition::Kind::lies_between;
        if (!compares || each.holds) continue;
        const auto fits = holds(each, *solved, results);
        if (!fits) return tl::unexpected(fits.error());
        if (!*fits) return rejected(named(each));
    }
    for (const Condition& each : exercise->require)
        if (each.kind == Condition::Kind::crank_turns_fully && !crank_turns_fully(solved->mechanism, solved->pose))
            return rejected(named(each));
    for (const Condition& each : exercise->require)
        if (each.kind == Condition::Kind::polygon_readable && !is_readable(*solved, each.polygon))
            return rejected(named(each));
    auto asked = asked_of_results(*solved, results);
    if (!asked) return tl::unexpected(std::move(asked.error()));
    if (exercise->ask.empty()) *asked = suited(results);
    drawn_.insert(exercise->comes_to);
    return std::optional(Variant{std::move(values), *std::move(solved), *std::move(asked)});
}

}  // namespace kinegraph
