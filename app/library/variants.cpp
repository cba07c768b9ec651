// Variants of an exercise for the public interface.
#include "kinegraph/variants.hpp"

#include <array>
#include <utility>

#include "app/library/state.hpp"
#include "constructions/positions/variants.hpp"
#include "engine/file/json_source.hpp"
#include "engine/reading/file_text.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph {

static_assert(ExerciseVariants::most_in_a_row == Variants::most_in_a_row);

struct ExerciseVariants::State {
    JsonSource file;
    std::vector<Setting> set;
    kinegraph::Variants variants;
    render::SheetOptions options;
};

ExerciseVariants::ExerciseVariants(ExerciseVariants&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
ExerciseVariants& ExerciseVariants::operator=(ExerciseVariants&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}
ExerciseVariants::~ExerciseVariants() { delete state_; }

Expected<ExerciseVariants> ExerciseVariants::parse(std::string_view text, std::string name, std::uint64_t seed,
                                                   const std::vector<ParameterValue>& set,
                                                   const DrawingOptions& options) {
    auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    std::vector<Setting> settings = settings_of(set);
    auto variants = kinegraph::Variants::of(std::string(text), std::move(name), settings, seed);
    if (!variants) return tl::unexpected(diagnostics_of(variants.error()));
    return ExerciseVariants(
        new State{*JsonSource::read(text), std::move(settings), *std::move(variants), *std::move(sheet)});
}

Expected<std::optional<ExerciseVariant>> ExerciseVariants::next(const std::string& name,
                                                                const std::function<bool()>& stops) {
    std::optional<Diagnostics> no_fonts;
    const auto is_readable = [&](const Solution& solution, Condition::Polygon polygon) {
        const auto fonts = fonts_of_thread();
        if (!fonts) no_fonts = fonts.error();
        return fonts && render::is_readable(solution, polygon, state_->options, **fonts);
    };
    auto found = state_->variants.next(is_readable, [&] { return no_fonts || (stops && stops()); });
    if (no_fonts) return tl::unexpected(*no_fonts);
    if (!found) return tl::unexpected(diagnostics_of(found.error()));
    if (!*found) return std::nullopt;
    Variant& variant = **found;
    if (!name.empty()) variant.solution.mechanism.source = name;
    ExerciseVariant made{{}, solved(std::move(variant.solution), std::nullopt, std::move(variant.results)), {}, {}};
    const Solved::State& state = made.solved.state();
    std::vector<Setting> set = variant.values;
    set.insert(set.end(), state_->set.begin(), state_->set.end());
    for (const Setting& each : variant.values) made.values.push_back({each.name, each.value});
    for (const NamedResult& each : state.asked) made.asked.push_back(value_of(each, state.solution));
    constexpr std::array<std::string_view, 2> without{"vary", "require"};
    made.file = file_with(state_->file, set, without);
    return made;
}

Text ExerciseVariants::title() const { return text_of(state_->variants.original().title); }
std::vector<std::string> ExerciseVariants::parameters() const {
    std::vector<std::string> names;
    for (const Variation& each : state_->variants.original().exercise->vary) names.push_back(each.parameter);
    return names;
}
std::uint64_t ExerciseVariants::combinations() const { return state_->variants.combinations(); }
std::uint64_t ExerciseVariants::looked_at() const { return state_->variants.looked_at(); }
std::vector<ExerciseVariants::Rejection> ExerciseVariants::rejections() const {
    std::vector<Rejection> all;
    for (const Variants::Rejection& each : state_->variants.rejections())
        all.push_back({text_of(each.why), each.count});
    return all;
}

}  // namespace kinegraph
