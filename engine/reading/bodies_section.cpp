#include "engine/file/spelling.hpp"
#include "engine/reading/sections.hpp"
#include "lang/keys/bodies.hpp"
#include "lang/keys/common.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace kinegraph {
namespace {

constexpr std::array body_circle_rows{
    FormRow("centre", "P", values::point_name).needed(lang::common::the_centre_of_the_circle), values::radius};
constexpr Form body_circle{lang::bodies::a_body_circle, body_circle_rows, "A disc, a wheel, a pitch circle."};

constexpr FormValue points_of_body = values::list(values::point_in_array);
constexpr FormValue body_colour =
    values::json(R"("type": "string", "pattern": "^#[0-9A-Fa-f]{6}$", "examples": ["#c04020"])");
constexpr std::array body_rows{
    FormRow("points", "[…]", points_of_body, "The points that move with it.").called(lang::bodies::an_array_of_points),
    FormRow("label", "\"…\"", values::texts),
    FormRow("circle", R"({"centre": P, "radius": r})", values::object(body_circle)).called(lang::bodies::centre_radius),
    FormRow("colour", R"("#RRGGBB")", body_colour, "The body's colour in all figures, in place of the theme's.")};
constexpr Form body_form{lang::bodies::a_body, body_rows};
constexpr std::array body_choices{points_of_body, values::object(body_form)};

}  // namespace

constinit const FormValue forms::body =
    values::any(body_choices).named("body", "A body: the points that move with it, or an object.");

void BodiesSection::register_bodies(JsonValue stated, JsonValue bodies) {
    std::string_view frame_name = "0";
    if (stated) {
        if (stated.is_string() || is_whole_number(stated)) {
            frame_name = stated.text();
            file_.check_name(stated, frame_name);
        } else {
            file_.wrong(stated, {lang::common::a_name_of_a_body});
            file_.know_bodies(false);
        }
    }
    const auto add = [&](std::string_view name, std::string where) {
        if (!file_.add_body(name)) return false;
        Body added;
        added.name = name;
        added.where = std::move(where);
        mechanism_.bodies.push_back(std::move(added));
        return true;
    };
    add(frame_name, stated ? stated.pointer() : "");
    if (!bodies) return;
    for (const JsonValue member : bodies) {
        if (add(member.key(), member.pointer())) {
            file_.check_name(member, member.key());
        } else if (member.key() == frame_name) {
            mechanism_.bodies.front().where = member.pointer();
        }
    }
}

void BodiesSection::read_bodies(JsonValue bodies) {
    for (const JsonValue member : bodies) {
        const BodyIndex index = file_.index_of_body(member.key());
        JsonValue points = member;
        if (member.is_object()) {
            const Members form = file_.members(member, body_form);
            if (form["label"]) body_at(index).label = file_.words(form["label"]);
            if (const Members circle = form.form("circle"))
                body_at(index).circle = Circle{circle.point("centre"), circle.quantity_or_default("radius")};
            if (form["colour"]) read_colour(form["colour"], index);
            points = form.expected("points");
            if (!points) continue;
        } else if (!file_.expect(points, Kind::array, {lang::bodies::an_array_of_points_or_points})) {
            continue;
        }
        for (const JsonValue name : points) carry(index, file_.point(name, true));
    }
}

void BodiesSection::read_colour(JsonValue colour, BodyIndex index) {
    const auto read = colour.is_string() ? colour_of_text(colour.text()) : std::nullopt;
    if (!read) {
        file_.fault(colour, {lang::bodies::a_colour_is_written});
    } else if (index == frame) {
        file_.fault(colour, {lang::bodies::the_frame_has_no_colour});
    } else if (index != none) {
        body_at(index).colour = *read;
    }
}

void BodiesSection::carry(BodyIndex on, PointIndex carried) {
    if (on == none || carried == none) return;
    const std::uint64_t pair =
        (static_cast<std::uint64_t>(on.number()) << 32U) | static_cast<std::uint64_t>(carried.number());
    if (carried_.insert(pair).second) body_at(on).points.push_back(carried);
}

}  // namespace kinegraph
