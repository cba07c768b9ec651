#include "problems/reye/reye.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/reye.hpp"

namespace kinegraph {
namespace {

constexpr FormRow kind_of_reye(std::span<const std::string_view> words) {
    return FormRow("kind", "…", values::word(words), "What rubs.").needed();
}
constexpr FormRow reye_force =
    FormRow("force", "F", values::force).needed(lang::reye::the_force_that_presses).positive(lang::common::the_force);
constexpr FormRow reye_friction =
    FormRow("friction", "f", values::number, "Coefficient of friction.").within(R"("exclusiveMinimum": 0)");
constexpr FormRow needed_friction = reye_friction.needed(lang::reye::the_coefficient_of_friction_which_makes);
constexpr FormRow reye_wear = FormRow("wear", "k", values::quantity(QuantityKind::wear), "Coefficient of wear.")
                                  .positive(lang::reye::the_coefficient_of_wear);
constexpr FormRow reye_time = FormRow("time", "t", values::time).positive(lang::reye::the_time);
constexpr FormRow reye_speed = FormRow("speed", "v", values::velocity).positive(lang::reye::the_speed);
constexpr FormRow reye_omega = FormRow("omega", "ω", values::angular_velocity).positive(lang::reye::the_speed);
constexpr FormRow reye_length(std::string_view key, std::string_view letter, Key meaning, Key noun) {
    return FormRow(key, letter, values::length).needed(meaning).positive(noun);
}
constexpr FormRow pad_length =
    reye_length("length", "l", lang::reye::the_pad_length_along_the_sliding, lang::common::the_length);
constexpr FormRow pad_width = reye_length("width", "b", lang::reye::the_pad_width, lang::reye::the_width);

constexpr std::array<std::string_view, 1> pads{"pad"}, blocks{"block"}, shoes{"shoe"};
constexpr std::array<std::string_view, 2> discs{"disc", "collar"}, senses_of_shoe{"leading", "trailing"};
constexpr std::array pad_rows{
    kind_of_reye(pads), reye_force,
    reye_friction,      reye_wear,
    reye_time,          pad_length,
    pad_width,          FormRow("offset", "e", values::length).needed(lang::reye::how_far_from_its_end),
    reye_speed};
constexpr std::array block_rows{kind_of_reye(blocks), reye_force, reye_friction, reye_wear, reye_time,
                                pad_length,           pad_width,  reye_speed};
constexpr std::array disc_rows{
    kind_of_reye(discs),
    reye_force,
    needed_friction,
    reye_wear,
    reye_time,
    reye_length("inner", "r1", lang::reye::the_inner_radius, lang::common::a_radius),
    reye_length("outer", "r2", lang::reye::the_outer_radius, lang::common::a_radius),
    FormRow("surfaces", "n", values::number, "How many rub. Default: 1.").within(R"("minimum": 1, "maximum": 1000)"),
    reye_omega};
constexpr std::array shoe_rows{kind_of_reye(shoes),
                               reye_force,
                               needed_friction,
                               reye_wear,
                               reye_time,
                               reye_length("radius", "r", lang::reye::the_drum_radius, lang::common::a_radius),
                               reye_length("width", "b", lang::reye::the_shoe_width, lang::common::a_length),
                               reye_length("pivot", "a", lang::reye::the_distance_of_the_pivot, lang::common::a_length),
                               reye_length("arm", "c", lang::reye::the_arm_of_the_force, lang::common::a_length),
                               FormRow("from", "a1", values::angle).needed(lang::reye::the_angle_from_the_pivot),
                               FormRow("to", "a2", values::angle).needed(lang::reye::the_angle_from_the_pivot),
                               FormRow("inside", "true", values::flag, "The shoe lies within the drum."),
                               FormRow("sense", "…", values::word(senses_of_shoe), "Default: leading."),
                               reye_omega};
/// In the order of ReyeProblem::Kind.
constexpr std::array reye_forms{Form{lang::reye::reye, pad_rows}, Form{lang::reye::reye, block_rows},
                                Form{lang::reye::reye, disc_rows}, Form{lang::reye::reye, shoe_rows}};
constexpr std::array reye_choices = values::objects(reye_forms);

/// "reye": wear of a pad, a block, a disc, a collar or the shoe of a drum brake.
class ReyeSection {
public:
    explicit ReyeSection(FormReader& file) : file_(file) {}

    std::optional<ReyeProblem> read(JsonValue section);

private:
    using Kind = FormReader::Kind;

    std::optional<ReyeProblem::Kind> read_kind(JsonValue section);
    void read_pad(const Members& form, ReyeProblem& problem);
    void read_disc(const Members& form, ReyeProblem& problem);
    void read_shoe(const Members& form, ReyeProblem& problem);

    FormReader& file_;
};

std::optional<ReyeProblem> ReyeSection::read(JsonValue section) {
    const auto kind = read_kind(section);
    if (!kind) return std::nullopt;
    ReyeProblem problem;
    problem.kind = *kind;
    problem.where = section.pointer();
    const bool slides = problem.kind == ReyeProblem::Kind::pad || problem.kind == ReyeProblem::Kind::block;
    const Members form = file_.members(section, reye_forms.at(static_cast<std::size_t>(problem.kind)));
    problem.force = form.quantity_or_default("force");
    if (const JsonValue friction = form.value("friction")) {
        problem.friction = form.number("friction").value_or(Exact(1));
        if (problem.friction->sign() <= 0) file_.fault(friction, {lang::reye::the_coefficient_of_friction_must});
    }
    const std::string_view speed = slides ? "speed" : "omega";
    const std::initializer_list<std::string_view> of_wear{"wear", speed, "time"};
    if (std::any_of(of_wear.begin(), of_wear.end(), [&](std::string_view key) { return bool(form[key]); })) {
        const Words needs(lang::reye::the_depth_worn_off_needs_wear, quoted(speed));
        for (const std::string_view key : of_wear) file_.required(form, key, needs);
        problem.wear = form.quantity_or_default("wear");
        problem.speed = form.quantity_or_default(speed);
        problem.time = form.quantity_or_default("time");
    }
    if (slides)
        read_pad(form, problem);
    else if (problem.kind == ReyeProblem::Kind::disc)
        read_disc(form, problem);
    else
        read_shoe(form, problem);
    return problem;
}

std::optional<ReyeProblem::Kind> ReyeSection::read_kind(JsonValue section) {
    const Words wanted(lang::reye::pad_block_disc_collar_or_shoe);
    const JsonValue kind = section["kind"];
    if (!kind) {
        file_.fault(section, {lang::reye::kind_is_missing, wanted});
        return std::nullopt;
    }
    for (std::size_t i = 0; i < reye_forms.size(); ++i) {
        const auto words = reye_forms.at(i).rows.front().value.words;
        if (kind.is_string() && std::find(words.begin(), words.end(), kind.text()) != words.end())
            return static_cast<ReyeProblem::Kind>(i);
    }
    file_.wrong(kind, wanted);
    return std::nullopt;
}

void ReyeSection::read_pad(const Members& form, ReyeProblem& problem) {
    problem.length = form.quantity_or_default("length");
    problem.width = form.quantity_or_default("width");
    if (problem.kind == ReyeProblem::Kind::block) return;
    problem.offset = form.quantity_or_default("offset");
    const JsonValue offset = form["offset"];
    if (offset && (problem.offset.sign() <= 0 || problem.offset >= problem.length))
        file_.fault(offset, {lang::reye::the_force_must_act_over});
}

void ReyeSection::read_disc(const Members& form, ReyeProblem& problem) {
    problem.inner = form.quantity_or_default("inner");
    problem.outer = form.quantity_or_default("outer");
    const JsonValue inner = form["inner"];
    if (inner && form["outer"] && problem.inner >= problem.outer)
        file_.fault(inner, {lang::reye::the_inner_radius_must_be_less});
    if (const JsonValue surfaces = form["surfaces"]) {
        const Exact count = form.number("surfaces").value_or(Exact(1));
        constexpr int most = 1000;
        if (!is_whole_number(surfaces) || count.sign() <= 0 || count > Exact(most))
            file_.fault(surfaces, {lang::reye::the_number_of_rubbing_surfaces});
        else
            problem.surfaces = static_cast<int>(count.to_double());
    }
}

void ReyeSection::read_shoe(const Members& form, ReyeProblem& problem) {
    problem.radius = form.quantity_or_default("radius");
    problem.width = form.quantity_or_default("width");
    problem.pivot = form.quantity_or_default("pivot");
    problem.arm = form.quantity_or_default("arm");
    problem.to = form.quantity_or_default("to");
    problem.from = form.quantity_or_default("from");
    const JsonValue to = form["to"], pivot = form["pivot"];
    if (to && form["from"] && (problem.from.sign() < 0 || problem.to <= problem.from || problem.to > kinegraph::pi()))
        file_.fault(to, {lang::reye::a_shoe_reaches_from_an_angle});
    problem.inside = form.flag("inside");
    if (problem.inside && pivot && problem.pivot >= problem.radius)
        file_.fault(pivot, {lang::reye::the_pivot_of_an_inner_shoe});
    if (const JsonValue sense = form["sense"]) {
        if (!sense.is_string() || (sense.text() != "leading" && sense.text() != "trailing"))
            file_.wrong(sense, {lang::reye::leading_or_trailing});
        problem.leading = sense.text() != "trailing";
    }
}

}  // namespace

constinit const FormValue reye_section =
    values::any(reye_choices).named({}, "A rubbing contact and its wear (Reye), in place of joints.");

std::any read_reye(FormReader& file, Mechanism&, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = ReyeSection(file).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
