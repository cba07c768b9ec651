#include "problems/reye/reye.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/reye.hpp"

namespace kinegraph {
namespace {

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
    const auto read_members = [&](std::initializer_list<std::string_view> own) {
        std::vector<std::string_view> names{"kind", "force", "friction", "wear", "time"};
        names.insert(names.end(), own.begin(), own.end());
        return file_.members(section, std::span<const std::string_view>(names), {lang::reye::reye});
    };
    const bool slides = problem.kind == ReyeProblem::Kind::pad || problem.kind == ReyeProblem::Kind::block;
    const Members form =
        problem.kind == ReyeProblem::Kind::pad     ? read_members({"length", "width", "offset", "speed"})
        : problem.kind == ReyeProblem::Kind::block ? read_members({"length", "width", "speed"})
        : problem.kind == ReyeProblem::Kind::disc
            ? read_members({"inner", "outer", "surfaces", "omega"})
            : read_members({"radius", "width", "pivot", "arm", "from", "to", "inside", "sense", "omega"});
    problem.force = file_.positive(file_.required(form, "force", {lang::reye::the_force_that_presses}),
                                   QuantityKind::force, {lang::common::the_force});
    if (!slides) file_.required(form, "friction", {lang::reye::the_coefficient_of_friction_which_makes});
    if (const JsonValue friction = form["friction"]) {
        problem.friction = file_.bare_number(friction).value_or(Exact(1));
        if (problem.friction->sign() <= 0) file_.fault(friction, {lang::reye::the_coefficient_of_friction_must});
    }
    const std::string_view speed = slides ? "speed" : "omega";
    const std::initializer_list<std::string_view> of_wear{"wear", speed, "time"};
    if (std::any_of(of_wear.begin(), of_wear.end(), [&](std::string_view key) { return bool(form[key]); })) {
        const Words needs(lang::reye::the_depth_worn_off_needs_wear, quoted(speed));
        problem.wear = file_.positive(file_.required(form, "wear", needs), QuantityKind::wear,
                                      {lang::reye::the_coefficient_of_wear});
        problem.speed =
            file_.positive(file_.required(form, speed, needs),
                           slides ? QuantityKind::velocity : QuantityKind::angular_velocity, {lang::reye::the_speed});
        problem.time = file_.positive(file_.required(form, "time", needs), QuantityKind::time, {lang::reye::the_time});
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
    constexpr std::array kinds{std::pair{std::string_view("pad"), ReyeProblem::Kind::pad},
                               std::pair{std::string_view("block"), ReyeProblem::Kind::block},
                               std::pair{std::string_view("disc"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("collar"), ReyeProblem::Kind::disc},
                               std::pair{std::string_view("shoe"), ReyeProblem::Kind::shoe}};
    const Words wanted(lang::reye::pad_block_disc_collar_or_shoe);
    const JsonValue kind = section["kind"];
    if (!kind) {
        file_.fault(section, {lang::reye::kind_is_missing, wanted});
        return std::nullopt;
    }
    const auto* found = std::find_if(kinds.begin(), kinds.end(),
                                     [&](const auto& each) { return kind.is_string() && each.first == kind.text(); });
    if (found == kinds.end()) {
        file_.wrong(kind, wanted);
        return std::nullopt;
    }
    return found->second;
}

void ReyeSection::read_pad(const Members& form, ReyeProblem& problem) {
    problem.length = file_.positive(file_.required(form, "length", {lang::reye::the_pad_length_along_the_sliding}),
                                    QuantityKind::length, {lang::common::the_length});
    problem.width = file_.positive(file_.required(form, "width", {lang::reye::the_pad_width}), QuantityKind::length,
                                   {lang::reye::the_width});
    if (problem.kind == ReyeProblem::Kind::block) return;
    const JsonValue offset = file_.required(form, "offset", {lang::reye::how_far_from_its_end});
    problem.offset = file_.quantity_or_zero(offset, QuantityKind::length);
    if (offset && (problem.offset.sign() <= 0 || problem.offset >= problem.length))
        file_.fault(offset, {lang::reye::the_force_must_act_over});
}

void ReyeSection::read_disc(const Members& form, ReyeProblem& problem) {
    const Words radius(lang::common::a_radius);
    const JsonValue inner = file_.required(form, "inner", {lang::reye::the_inner_radius});
    problem.inner = file_.positive(inner, QuantityKind::length, radius);
    problem.outer =
        file_.positive(file_.required(form, "outer", {lang::reye::the_outer_radius}), QuantityKind::length, radius);
    if (inner && form["outer"] && problem.inner >= problem.outer)
        file_.fault(inner, {lang::reye::the_inner_radius_must_be_less});
    if (const JsonValue surfaces = form["surfaces"]) {
        const Exact count = file_.bare_number(surfaces).value_or(Exact(1));
        constexpr int most = 1000;
        if (!is_whole_number(surfaces) || count.sign() <= 0 || count > Exact(most))
            file_.fault(surfaces, {lang::reye::the_number_of_rubbing_surfaces});
        else
            problem.surfaces = static_cast<int>(count.to_double());
    }
}

void ReyeSection::read_shoe(const Members& form, ReyeProblem& problem) {
    const Words length(lang::common::a_length);
    problem.radius = file_.positive(file_.required(form, "radius", {lang::reye::the_drum_radius}), QuantityKind::length,
                                    {lang::common::a_radius});
    problem.width =
        file_.positive(file_.required(form, "width", {lang::reye::the_shoe_width}), QuantityKind::length, length);
    const JsonValue pivot = file_.required(form, "pivot", {lang::reye::the_distance_of_the_pivot});
    problem.pivot = file_.positive(pivot, QuantityKind::length, length);
    problem.arm =
        file_.positive(file_.required(form, "arm", {lang::reye::the_arm_of_the_force}), QuantityKind::length, length);
    const Words end(lang::reye::the_angle_from_the_pivot);
    const JsonValue to = file_.required(form, "to", end);
    problem.from = file_.quantity_or_zero(file_.required(form, "from", end), QuantityKind::angle);
    problem.to = file_.quantity_or_zero(to, QuantityKind::angle);
    if (to && form["from"] && (problem.from.sign() < 0 || problem.to <= problem.from || problem.to > kinegraph::pi()))
        file_.fault(to, {lang::reye::a_shoe_reaches_from_an_angle});
    if (form["inside"] && file_.expect(form["inside"], Kind::boolean, {lang::common::true_or_false})) {
        problem.inside = is_true(form["inside"]);
        if (problem.inside && pivot && problem.pivot >= problem.radius)
            file_.fault(pivot, {lang::reye::the_pivot_of_an_inner_shoe});
    }
    if (const JsonValue sense = form["sense"]) {
        if (!sense.is_string() || (sense.text() != "leading" && sense.text() != "trailing"))
            file_.wrong(sense, {lang::reye::leading_or_trailing});
        problem.leading = sense.text() != "trailing";
    }
}

}  // namespace

std::any read_reye(FormReader& file, Mechanism&, JsonValue section) {
    if (!file.expect(section, JsonValue::Kind::object, {lang::common::an_object})) return {};
    auto problem = ReyeSection(file).read(section);
    return problem ? std::any(*std::move(problem)) : std::any();
}

}  // namespace kinegraph
