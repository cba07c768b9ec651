// sweep FILE --over r: see sweep_parameter.hpp.
#include "app/sweep_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/outputs.hpp"
#include "app/row_file.hpp"
#include "constructions/named_results.hpp"
#include "constructions/solve.hpp"
#include "engine/result_names.hpp"
#include "engine/spelling.hpp"
#include "engine/variation.hpp"

namespace kinegraph::app {
namespace {

/// In SI: a formula counts angles in degrees.
double si_of(const Measured& value) { return value.value.to_double() * std::pow(std::numbers::pi / 180, value.dimension.angle); }

tl::expected<Measured, Words> value_of(const std::string& option, const std::string& text) {
    if (text.empty()) return tl::unexpected(Words("--over wants --from and --to", "--over vuole --from e --to"));
    auto read = is_formula(text) ? tl::expected<Measured, Words>(tl::unexpected(
                                       Words("a value is wanted here, no formula", "qui serve un valore, non una formula")))
                                 : read_measured(text, {});
    if (read) return *std::move(read);
    return tl::unexpected(option + std::string(": ") + read.error());
}

/// The values that a parameter takes, as settings; one step beyond `to` is not taken.
tl::expected<Variation, Words> values_of(const SweepRequest& request) {
    constexpr int most = 1'000'000;
    const auto from = value_of("--from", request.from), to = value_of("--to", request.to);
    if (!from) return tl::unexpected(from.error());
    if (!to) return tl::unexpected(to.error());
    std::optional<Measured> step;
    if (!request.step.empty()) {
        auto read = value_of("--step", request.step.front());
        if (!read) return tl::unexpected(read.error());
        step = *std::move(read);
    }
    for (const Measured* other : {&*to, step ? &*step : &*to})
        if (other->is_bare != from->is_bare || !(other->dimension == from->dimension))
            return tl::unexpected(Words("--from is {0}, and --to or --step is {1}", "--from è {0}, e --to o --step è {1}",
                                        described(*from), described(*other)));
    const Exact way = to->value - from->value;
    if (way.is_zero())
        return tl::unexpected(Words("--from and --to are the same; solve --set gives one value",
                                    "--from e --to sono uguali; solve --set dà un valore solo"));
    if (!step && (request.steps < 1 || request.steps > most))
        return tl::unexpected(Words("--steps: 1 to {0}", "--steps: da 1 a {0}", std::to_string(most)));
    const Exact each = step ? step->value : way / Exact::ratio(request.steps, 1);
    const Exact count = each.is_zero() ? Exact(-1) : way / each;
    if (count.sign() < 0)
        return tl::unexpected(
            Words("--step {0} does not lead from --from to --to", "--step {0} non porta da --from a --to", request.step.front()));
    if (count > Exact(most))
        return tl::unexpected(Words("--step: more than {0} values; take a larger step",
                                    "--step: più di {0} valori; prendere un passo più grande", std::to_string(most)));
    Variation values;
    values.parameter = request.over;
    values.count = static_cast<std::uint64_t>(mpz_class(count.rational().get_num() / count.rational().get_den()).get_ui()) + 1;
    Exact unit = 1;
    if (!from->is_bare) {
        values.unit = read_quantity(request.from, QuantityKind::dimensionless)->unit->symbol;
        unit = read_measured("1 " + values.unit, {})->value;
    }
    values.from = from->value / unit;
    values.step = each / unit;
    return values;
}

class ParameterSweep {
public:
    ParameterSweep(const SweepRequest& request, std::string text, Variation values)
        : request_(request), text_(std::move(text)), values_(std::move(values)) {}

    Status run(const std::vector<Target>& targets) {
        Progress progress(static_cast<long>(values_.count));
        std::vector<std::vector<double>> rows;
        for (std::uint64_t i = 0; i < values_.count; ++i) {
            progress.at(static_cast<long>(i));
            if (auto row = row_of(values_.value(i)))
                rows.push_back(*std::move(row));
            else
                left_out_.push_back(values_.value(i));
        }
        if (rows.empty()) return say(spoken(request_.file), fault_, request_.sheet.language);
        std::vector<Output> outputs;
        for (const Target& target : targets) {
            auto growing = Growing::open(target.path);
            if (!growing) return fail_to_write(growing.error(), request_.sheet.language);
            RowFile file(*std::move(growing), target.format);
            file.head(columns_, "\"parameter\": " + in_json(request_.over) + ",\n  \"from\": " + decimal_of(si(0)) +
                                    ",\n  \"to\": " + decimal_of(si(values_.count - 1)));
            for (const auto& row : rows) file.row(row);
            file.tail("");
            if (file.failure()) return fail_to_write(*file.failure(), request_.sheet.language);
            outputs.push_back(file.finish());
        }
        if (const auto failure = write_all(outputs)) return fail_to_write(*failure, request_.sheet.language);
        return report();
    }

private:
    double si(std::uint64_t i) const { return si_of(*read_measured(values_.value(i), {})); }

    /// The results with one value; nothing where there are none.
    std::optional<std::vector<double>> row_of(const std::string& value) {
        const auto note = [&](Errors errors) {
            if (fault_.empty()) fault_ = std::move(errors);
            return std::nullopt;
        };
        std::vector<Setting> set = request_.set;
        std::erase_if(set, [&](const Setting& each) { return each.name == request_.over; });
        set.push_back({request_.over, value});
        auto mechanism = read_mechanism(text_, bare_name(request_.file), set);
        if (!mechanism) return note(mechanism.error());
        auto solution = solve(*std::move(mechanism));
        if (!solution) return note(solution.error());
        if (!solution->unsolved.empty())
            return note(
                {{ErrorCode::no_unique_answer, {}, {"no value has a unique answer", "nessun valore ha una risposta unica"}}});
        std::vector<NamedResult> results = named_results(*solution);
        std::erase_if(results, [](const NamedResult& each) { return is_modulus(each.column); });
        if (columns_.empty()) choose_columns(results);
        std::vector<double> row{si_of(*read_measured(value, {}))};
        for (std::size_t i = 1; i < columns_.size(); ++i) {
            const auto found = std::find_if(results.begin(), results.end(),
                                            [&](const NamedResult& each) { return each.column.name == columns_[i].name; });
            if (found == results.end()) return std::nullopt;
            row.push_back(columns_[i].kind == Column::Kind::angle && !last_.empty() ? beside(found->value, last_[i])
                                                                                    : found->value);
        }
        last_ = row;
        return row;
    }
    void choose_columns(const std::vector<NamedResult>& results) {
        columns_.push_back({Column::Kind::named, {}, request_.over, QuantityKind::dimensionless});
        for (const NamedResult& each : results) columns_.push_back(each.column);
    }
    /// The same angle, within half a turn of the one before.
    static double beside(double angle, double before) {
        constexpr double turn = 2 * std::numbers::pi;
        return angle + turn * std::round((before - angle) / turn);
    }

    Status report() const {
        const auto line = [&](const Words& words) { say(spoken(request_.file), words, request_.sheet.language); };
        if (left_out_.empty()) return Status::done;
        if (left_out_.size() == 1)
            line({"1 row is left out, where the file gives no unique answer: {0} = {1}",
                  "1 riga è omessa, dove il file non dà una risposta unica: {0} = {1}", request_.over, left_out_.front()});
        else
            line({"{0} rows are left out, where the file gives no unique answer: {1} = {2} … {3}",
                  "{0} righe sono omesse, dove il file non dà una risposta unica: {1} = {2} … {3}",
                  std::to_string(left_out_.size()), request_.over, left_out_.front(), left_out_.back()});
        return Status::unsolved;
    }

    const SweepRequest& request_;
    std::string text_;
    Variation values_;
    std::vector<Column> columns_;
    std::vector<double> last_;
    std::vector<std::string> left_out_;
    Errors fault_;  ///< of the first value that has one
};

/// Why a parameter cannot be swept so; empty where it can.
Words meaningless(const SweepRequest& request, JsonValue parameters) {
    if (!request.drivers.empty() || request.branch != 0 || !request.plots.empty() || !request.traces.empty() ||
        !request.centrodes.empty() || request.poses != 0)
        return {"--over moves no driver: --driver, --branch, --plot, --trace, --centrodes and --poses do not go with it",
                "--over non muove nessun movente: --driver, --branch, --plot, --trace, --centrodes e --poses non vanno con esso"};
    if (request.step.size() > 1) return {"--step is given twice", "--step è dato due volte"};
    std::vector<std::string_view> names;
    if (parameters && parameters.is_object())
        for (const JsonValue each : parameters) names.push_back(each.key());
    if (std::find(names.begin(), names.end(), request.over) != names.end()) return {};
    return {"--over {0}: the file has no parameter named {0}{1}", "--over {0}: il file non ha un parametro {0}{1}",
            quoted(request.over), did_you_mean(Speller().nearest(request.over, names))};
}

}  // namespace

Status sweep_parameter(const SweepRequest& request) {
    const Language language = request.sheet.language;
    constexpr std::array formats{Format::csv, Format::json};
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    auto text = read_whole(request.file, {"mechanism file", "file di meccanismo"});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return Status::bad_input;
    }
    // Its own faults come first.
    if (const auto own = read_mechanism(*text, bare_name(request.file), request.set); !own)
        return say(spoken(request.file), own.error(), language);
    const auto source = JsonSource::read(*text);
    if (const Words why = meaningless(request, source->root()["parameters"]); !why.empty()) return refuse(why, language);
    auto values = values_of(request);
    if (!values) return refuse(values.error(), language);
    return ParameterSweep(request, *std::move(text), *std::move(values)).run(*targets);
}

}  // namespace kinegraph::app
