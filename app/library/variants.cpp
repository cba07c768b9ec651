// Variants of an exercise for the public interface.
#include "kinegraph/variants.hpp"

#include <array>
#include <utility>

#include "app/library/state.hpp"
#include "constructions/positions/variants.hpp"
#include "engine/file/json_source.hpp"
#include "engine/reading/file_text.hpp"
#include "render/sheet/readable.hpp"
#include "render/text/text.hpp"

namespace kinegraph {

struct ExerciseVariants::State {
    std::string text;
    std::vector<Setting> set;
    kinegraph::Variants variants;
    render::SheetOptions options;
    std::optional<render::Fonts> fonts;  ///< opened by the first condition on a polygon
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
        new State{std::string(text), std::move(settings), *std::move(variants), *std::move(sheet), std::nullopt});
}

Expected<std::optional<ExerciseVariant>> ExerciseVariants::next() {
    std::optional<Words> missing_font;
    const auto is_readable = [&](const Solution& solution, Condition::Polygon polygon) {
        if (!state_->fonts) {
            auto opened = render::Fonts::open();
            if (!opened) missing_font = opened.error();
            if (!opened) return false;
            state_->fonts.emplace(*std::move(opened));
        }
        return render::is_readable(solution, polygon, state_->options, *state_->fonts);
    };
    auto found = state_->variants.next(is_readable, [&] { return missing_font.has_value(); });
    if (missing_font) return refused(Diagnostic::Kind::output, *missing_font);
    if (!found) return tl::unexpected(diagnostics_of(found.error()));
    if (!*found) return std::nullopt;
    Variant& variant = **found;
    ExerciseVariant made{{}, solved(std::move(variant.solution)), {}, {}};
    std::vector<Setting> set = variant.values;
    set.insert(set.end(), state_->set.begin(), state_->set.end());
    for (const Setting& each : variant.values) made.values.push_back({each.name, each.value});
    for (const NamedResult& each : variant.results) made.asked.push_back(value_of(each, made.solved.state().solution));
    constexpr std::array<std::string_view, 2> without{"vary", "require"};
    made.file = file_with(*JsonSource::read(state_->text), set, without);
    return made;
}

std::uint64_t ExerciseVariants::combinations() const { return state_->variants.combinations(); }
std::uint64_t ExerciseVariants::looked_at() const { return state_->variants.looked_at(); }

}  // namespace kinegraph
