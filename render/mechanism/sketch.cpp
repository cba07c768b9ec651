// Conversion of a sketch to a figure: its layers in order, each a group with the role of its marks; scale bar and
// labels.
#include "render/mechanism/sketch.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "render/page/free_room.hpp"

namespace kinegraph::render::drawing {

Spot room_for_labels(Spot room) {
    constexpr double scale_bar = 8;
    return {room.x, room.y - scale_bar};
}

GroupId Sketch::id(std::string_view kind, std::string_view name) {
    std::string element = element_of(kind, name);
    // Different names can give the same id, such as "a b" and "a_x20_b".
    while (!elements_.insert(element).second) element += "_";
    return GroupId(figure_, std::move(element));
}

RichText Sketch::name_of_point(PointIndex point) const {
    return typeset(Symbol{Symbol::Letter::point, mechanism.point(point).name, ""}, context.language);
}

LabelRequest& Sketch::add_label(RichText text, Colour colour, Spot at, double clearance, StatementIndex statement) {
    labels.push_back({.text = std::move(text),
                      .size = theme.label,
                      .colour = colour,
                      .anchor = at,
                      .clearance = clearance,
                      .statement = statement});
    return labels.back();
}

Figure Sketch::finish(Figure blank, std::string unit_name) {
    Figure figure = std::move(blank);
    figure.scale = figure.places = scale();
    figure.unit = std::move(unit_name);
    // Links, joints, centres and vectors have nested groups.
    struct Layer {
        const char* role;
        std::vector<Mark>& marks;
    };
    const std::array layers{
        Layer{"tint", tints},    Layer{"construction", construction}, Layer{"ground", ground},
        Layer{"links", bodies},  Layer{"construction", over_bodies},  Layer{"joints", pins},
        Layer{"arrows", arrows}, Layer{"centres", centres},           Layer{"dimensions", dimensions}};
    std::size_t count = 2;  // including the figure's own group
    for (const auto& [role, marks] : layers) count += marks.size() + 2;
    figure.marks.reserve(count);
    for (const auto& [role, marks] : layers) {
        if (marks.empty()) continue;
        figure.marks.emplace_back(GroupBegin{role, {}, {}, {}});
        for (Mark& mark : marks) figure.marks.push_back(std::move(mark));
        figure.marks.emplace_back(GroupEnd{});
        marks.clear();
    }
    figure.labels = std::move(labels);
    figure.box = box_of(figure.marks);
    return figure;
}

Box Sketch::with_more_on_one_side(const Box& own, const std::vector<LabelRequest>& requests, Spot within) const {
    const double spare = within.x - own.width();
    if (spare <= 0) return own;
    constexpr double near_edge = 0.25;  // of the width
    double left = 0, right = 0;
    for (const LabelRequest& request : requests) {
        if (request.toward) continue;
        const double width = context.fonts.shape(request.text, request.size).width + request.clearance;
        if (request.anchor.x < own.min.x + near_edge * own.width())
            left = std::max(left, own.min.x - (request.anchor.x - width));
        if (request.anchor.x > own.max.x - near_edge * own.width())
            right = std::max(right, request.anchor.x + width - own.max.x);
    }
    const double more = std::clamp(left - right, -spare, spare);
    return {{own.min.x - std::max(more, 0.0), own.min.y}, {own.max.x + std::max(-more, 0.0), own.max.y}};
}

void Sketch::close(Figure& figure, Spot room, bool fixed, double bar_scale, const Unit& bar_unit, bool strict) const {
    // Already too large: labels are not placed, only requested.
    if (!fixed && (figure.box.width() > room.x || figure.box.height() > room.y)) return;
    const double target = std::min(30.0, std::max(8.0, room.x / 4));
    std::vector<Mark> bar;
    draw_scale_bar(bar, context.fonts, theme, {0, 0}, target, bar_scale, bar_unit.si.to_double(), bar_unit.symbol,
                   context.language);
    figure.marks.insert(figure.marks.begin(), group_of(figure));
    figure.marks.emplace_back(GroupEnd{});
    const Box size_of_bar = box_of(bar);
    const Spot bar_size{size_of_bar.width(), size_of_bar.height()};
    constexpr double above_bar = 3;
    const Spot of_names = space.value_or(room_for_labels(room));
    const Box own = figure.box;
    if (space) figure.box = with_more_on_one_side(own, figure.labels, of_names);
    place_labels(figure, context.fonts, of_names, strict ? Labelling::strict : Labelling::free,
                 context.theme.secondary);
    if (space) {
        figure.box = box_of(figure.marks);
        figure.box.include(own);
    }
    // The scale bar stands along a free edge of the figure, or else below it.
    const std::optional<Spot> place = free_place(figure.marks, figure.box, bar_size);
    const Spot corner = place.value_or(Spot{figure.box.min.x, figure.box.max.y + above_bar});
    move(bar, corner.x - size_of_bar.min.x, corner.y - size_of_bar.min.y);
    const Box at = box_of(bar);
    figure.marks.pop_back();
    for (Mark& mark : bar) figure.marks.push_back(std::move(mark));
    figure.marks.emplace_back(GroupEnd{});
    figure.box.max = {std::max(figure.box.max.x, at.max.x), std::max(figure.box.max.y, at.max.y)};
    figure.move(-figure.box.min.x, -figure.box.min.y);
}

}  // namespace kinegraph::render::drawing
