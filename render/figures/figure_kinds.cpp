// The only text that makes words of a figure's identity: names, ids, attributes. The list of figures in its order.
#include "render/figures/figure_kinds.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < figure_table.size(); ++i)
        if (static_cast<std::size_t>(figure_table[i].kind) != i) return false;
    return true;
}
static_assert(is_in_order(), "rows and enumerators stand in the same order");

/// What is drawn for each load that acts alone, in this order.
constexpr FigureKind under_each_load[]{FigureKind::lines_of_action, FigureKind::free_body, FigureKind::forces};

std::string after_dash(const std::string& name) { return "-" + name; }
std::string numbered(int before) { return before == 0 ? "" : "-" + std::to_string(before + 1); }
std::string of_load(const LoadCase& loads) { return loads.is_alone() ? "-load-" + loads.load() : ""; }
const FreeBody& free_body_of(const LoadCase& loads, FigureId id) { return loads.bodies()[at_index(id.of)]; }
const std::string& member_name(const Mechanism& mechanism, const FreeBody& body) {
    return body.body != none ? mechanism.body(body.body).name : mechanism.point(body.pin).name;
}

}  // namespace

namespace figure_columns {

std::string name_of_polygon(const Solution& solution, FigureId id) {
    return id.of < 0 ? "" : solution.protocol.polygons[at_index(id.of)].id;
}
std::string name_of_curvature(const Solution& solution, FigureId id) {
    return after_dash(solution.mechanism.body(solution.curvature[at_index(id.of)].body).name);
}
std::string name_of_member(const Solution& solution, FigureId id) {
    return after_dash(member_name(solution.mechanism, free_body_of(solution, id)));
}
std::string name_of_group(const Solution& solution, FigureId id) {
    return name_of_polygon(solution, {id.kind, solution.taken_together[at_index(id.of)].polygon});
}
std::string name_of_free_body(const Solution& solution, FigureId id) {
    const LoadCase loads(solution, id.part);
    const FreeBody& body = free_body_of(loads, id);
    return (body.body != none ? "body-" : "pin-") + member_name(solution.mechanism, body) + of_load(loads);
}
std::string name_of_loads(const Solution& solution, FigureId id) { return of_load({solution, id.part}); }
std::string name_of_lines(const Solution& solution, FigureId id) {
    return id.part == all_loads ? "-of-action" : of_load({solution, id.part});
}
std::string number_of_freedom(const Solution& /*any*/, FigureId id) { return numbered(id.of); }
std::string number_of_axes(const Solution& solution, FigureId id) {
    const auto& all = solution.relative_motion;
    return numbered(static_cast<int>(std::count_if(all.begin(), all.begin() + id.of, has_moving_axes)));
}

}  // namespace figure_columns

const FigureRow& row_of(FigureKind kind) { return figure_table.at(static_cast<std::size_t>(kind)); }

std::string name_of(const Solution& solution, FigureId id) {
    const FigureRow& row = row_of(id.kind);
    return std::string(row.key) + (row.rest == nullptr ? "" : row.rest(solution, id));
}

std::optional<BodyIndex> free_body_in(const Solution& solution, FigureId id) {
    if (id.kind != FigureKind::free_body) return std::nullopt;
    return free_body_of(LoadCase(solution, id.part), id).body;
}

std::string prefix_of_load(const Solution& solution, FigureId id) {
    const LoadCase loads(solution, id.part);
    return loads.is_alone() ? "load-" + loads.load() + "-" : "";
}

Figure begun(const DrawingContext& context, FigureId id) {
    const FigureRow& row = row_of(id.kind);
    Figure figure;
    figure.traits = row.traits;
    figure.id = row.svg_id.empty() || id.part != all_loads ? legal_id(name_of(context.solution, id)) : row.svg_id;
    figure.data_figure = row.data_figure.empty() ? figure.id : row.data_figure;
    if (row.caption) figure.caption = one_piece(word(*row.caption, context.language));
    return figure;
}

std::optional<double> asked_scale(const Mechanism& mechanism, FigureKind kind) {
    for (const std::string_view key : row_of(kind).scales)
        for (const AskedScale& scale : mechanism.scales)
            if (!key.empty() && scale.figure == key) return scale.per_millimetre.to_double();
    return std::nullopt;
}

bool Shown::has_centres() const {
    const Find& find = solution().mechanism.find;
    const bool asked = !is_brief || (find.stated && find.instant_centres) || solution().instantaneous_motion;
    return asked && !solution().centres.empty();
}

const PolygonScene& Shown::scene(int polygon) const {
    const auto known = scenes_.find(polygon);
    if (known != scenes_.end()) return known->second;
    return scenes_.emplace(polygon, polygon_scene(solution(), polygon)).first->second;
}

std::vector<FigureId> all_figures(const Shown& shown) {
    std::vector<FigureId> all;
    const auto add = [&](const FigureRow& row, const LoadCase& loads) {
        if (row.by == nullptr || row.by->all == nullptr) return;
        for (const int of : row.by->all(shown, loads)) all.push_back({row.kind, of, loads.part()});
    };
    for (const FigureRow& row : figure_table) {
        if (row.kind == FigureKind::partial_sums)
            for (int part = 0; part < parts_of(shown.solution()); ++part)
                for (const FigureKind kind : under_each_load) add(row_of(kind), {shown.solution(), part});
        add(row, shown.solution());
    }
    // Polygons of motion stand in the order in which they are drawn.
    const auto is_of_motion = [](const FigureId& id) {
        return id.kind == FigureKind::velocity_polygon || id.kind == FigureKind::acceleration_polygon;
    };
    const auto first = std::find_if(all.begin(), all.end(), is_of_motion);
    std::sort(first, std::find_if_not(first, all.end(), is_of_motion),
              [](const FigureId& one, const FigureId& other) { return one.of < other.of; });
    return all;
}

SizeWanted size_of(const Shown& shown, FigureId id) {
    const FigureRow& row = row_of(id.kind);
    const Units& units = shown.solution().mechanism.units;
    const Unit* unit = row.traits.measured == QuantityKind::velocity       ? &units.velocity
                       : row.traits.measured == QuantityKind::acceleration ? &units.acceleration
                       : row.traits.measured == QuantityKind::force        ? &units.force
                                                                           : nullptr;
    SizeWanted size = row.size;
    if (const auto asked = asked_scale(shown.solution().mechanism, id.kind))
        size.asked = unit == nullptr ? *asked : *asked / unit->si.to_double();
    row.by->measure(shown, id, size);
    constexpr double nothing = 1e-30;
    size.extent_x = std::max(size.extent_x, nothing);
    size.extent_y = std::max(size.extent_y, nothing);
    return size;
}

Figure draw_figure(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    const FigureRow& row = row_of(id.kind);
    KG_ASSERT(row.by != nullptr, "a figure of its own has a function that draws it");
    return row.by->draw(shown, id, room, wish);
}

FigureId motion_polygon(const Solution& solution, int polygon) {
    const bool acceleration = solution.protocol.polygons[at_index(polygon)].plane == Plane::acceleration;
    return {acceleration ? FigureKind::acceleration_polygon : FigureKind::velocity_polygon, polygon};
}

bool has_forces(const Solution& solution) { return !solution.free_bodies.empty() || solution.truss; }
bool has_motion(const Solution& solution) {
    return !solution.centres.empty() ||
           std::any_of(solution.protocol.polygons.begin(), solution.protocol.polygons.end(),
                       [](const Polygon& p) { return p.plane == Plane::velocity || p.plane == Plane::acceleration; });
}
bool is_mixed(const Solution& solution) { return has_forces(solution) && has_motion(solution); }

}  // namespace kinegraph::render
