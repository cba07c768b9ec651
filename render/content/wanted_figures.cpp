// Collects the figures: the mechanism, the polygons of motion, those of forces, the free bodies, the lever.
#include "render/content/wanted_figures.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "lang/keys/sentences.hpp"
#include "render/figures/truss_figures.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/tables/truss_table.hpp"

namespace kinegraph::render {

bool has_forces(const Solution& solution) { return !solution.free_bodies.empty() || solution.truss; }
bool has_motion(const Solution& solution) {
    return !solution.centres.empty() ||
           std::any_of(solution.protocol.polygons.begin(), solution.protocol.polygons.end(),
                       [](const Polygon& p) { return p.plane == Plane::velocity || p.plane == Plane::acceleration; });
}
bool is_mixed(const Solution& solution) { return has_forces(solution) && has_motion(solution); }

std::string name_of(const Solution& solution, const FreeBody& body) {
    const Mechanism& mechanism = solution.mechanism;
    return body.body != none ? "body-" + mechanism.bodies[at_index(body.body)].name
                             : "pin-" + mechanism.points[at_index(body.pin)].name;
}

std::string name_of(const Solution& solution, const Curvature& found) {
    return "curvature-" + solution.mechanism.body(found.body).name;
}

std::string name_of(const Solution& solution, const TakenTogether& together) {
    return solution.protocol.polygons[at_index(together.polygon)].id;
}

namespace {

/// The circle diagram shows the order of Kennedy's theorem. It is useful if there are more centres than can be followed
/// directly, and readable if its chords can be distinguished.
bool has_circle(const Solution& solution) {
    constexpr std::size_t most = 16;
    const std::size_t bodies = solution.mechanism.bodies.size();
    return bodies >= 3 && bodies <= most && !solution.centres.empty();
}
bool has_some(const Solution& solution, Recorded<Vector> PointMotion::*vector) {
    // The figure of an instantaneous motion shows the centres itself.
    return !solution.instantaneous_motion &&
           std::any_of(solution.points.begin(), solution.points.end(),
                       [&](const PointMotion& m) { return m.point != none && m.*vector && !(m.*vector)->is_zero(); });
}

/// The polygons of three or more forces. Two equal and opposite forces have no polygon; the steps say so.
std::size_t polygons_of(const LoadCase& loads) {
    const auto& polygons = loads.solution().protocol.polygons;
    const auto count = std::count_if(loads.bodies().begin(), loads.bodies().end(), [&](const FreeBody& body) {
        return body.polygon >= 0 && polygons[at_index(body.polygon)].vectors.size() > 2;
    });
    return static_cast<std::size_t>(count) + loads.together().size();
}

/// Whether an input force or couple was found by virtual work, for which the lever is the construction.
bool found_by_works(const Solution& solution) {
    return std::any_of(
        solution.virtual_motions.begin(), solution.virtual_motions.end(), [&](const VirtualMotion& motion) {
            const Statement& said = solution.protocol.statements[at_index(motion.statement)];
            return said.message.sentence == lang::sentences::virtual_work_alone &&
                   std::any_of(said.finds.begin(), said.finds.end(),
                               [](const Quantity& found) { return found.kind == Quantity::Kind::effort; });
        });
}

}  // namespace

WantedFigures::WantedFigures(const DrawingContext& context, bool joukowsky, SolutionDetail detail)
    : context_(context), detail_(detail) {
    if (has_motion(context.solution) || !has_forces(context.solution)) collect_motion();
    if (has_forces(context.solution)) collect_forces(joukowsky);
    if (has_loops_figure(context.solution)) add_loops();
    add_moving_axes();
    add_displacements();
    add_small();
}

bool WantedFigures::shows_centres() const {
    const Find& find = context_.solution.mechanism.find;
    const bool asked = detail_ == SolutionDetail::full || (find.stated && find.instant_centres) ||
                       context_.solution.instantaneous_motion;
    return asked && !context_.solution.centres.empty();
}

std::optional<std::size_t> WantedFigures::named(const std::string& name) const {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Wanted& each) { return each.name == name; });
    if (found == list.end()) return std::nullopt;
    return static_cast<std::size_t>(found - list.begin());
}

Wanted& WantedFigures::add(Wanted wanted) {
    wanted.extent_x = std::max(wanted.extent_x, 1e-30);
    wanted.extent_y = std::max(wanted.extent_y, 1e-30);
    return list.emplace_back(std::move(wanted));
}

/// Symbols and letters keep their size, so that a small mechanism is crowded.
Wanted WantedFigures::mechanism(const std::string& name, bool with_centres) const {
    const Box extent = extent_of_mechanism(context_.solution, with_centres);
    Wanted mechanism;
    mechanism.name = name;
    mechanism.extent_x = extent.width();
    mechanism.extent_y = extent.height();
    mechanism.asked = asked("mechanism", 1);
    // Distant centres may take most of the figure; the links need a minimum size, and theirs is the figure's score.
    constexpr double least_of_links = 28;
    const Box links = with_centres ? extent_of_mechanism(context_.solution, false) : extent;
    const double size = std::max(links.width(), links.height());
    mechanism.subject = size;
    mechanism.least = size > 0 ? least_of_links * std::max(extent.width(), extent.height()) / size : least_of_links;
    mechanism.weight = context_.solution.instantaneous_motion ? 2 : 1.2;
    return mechanism;
}

void WantedFigures::collect_forces(bool joukowsky) {
    const Solution& s = context_.solution;
    if (s.truss) add_truss();
    if (s.free_bodies.empty()) {
        add_polygons_of_bodies(context_);
        return;
    }
    add_lines_of_action();
    if (has_force_polygons(s))
        add_force_polygons("forces", "forces", extent_of_forces(s), [this](Spot room, const ScaleWish& wish) {
            return force_polygons_figure(context_, room.x, room.y, wish);
        }).is_row = true;
    add_polygons_of_bodies(context_);
    if (s.superposition) add_superposition();
    for (const int p : closed_polygons(s)) {
        const PolygonScene scene = polygon_scene(s, p);
        add_force_polygons("closure", scene.id, rectangle(0, 0, scene.width(), scene.height()),
                           [this, p](Spot room, const ScaleWish& wish) {
                               return closed_polygon_figure(context_, p, room.x, room.y, wish);
                           });
    }
    keep_forces_readable();
    add_free_bodies();
    if (!(joukowsky || found_by_works(s)) || no_lever(s) != NoLever::drawn) return;
    Wanted lever;
    lever.name = "joukowsky";
    lever.extent_x = extent_of_lever(s).width();
    lever.extent_y = extent_of_lever(s).height();
    lever.least = 20;
    lever.draw = [this](Spot room, const ScaleWish& wish) { return joukowsky_figure(context_, room.x, room.y, wish); };
    add(std::move(lever));
}

/// The polygons of single bodies, then those of bodies taken together.
void WantedFigures::add_polygons_of_bodies(const DrawingContext& context) {
    const Solution& s = context.solution;
    const auto add_polygon = [&](const std::string& name, int polygon) {
        const PolygonScene scene = polygon_scene(s, polygon);
        add_force_polygons("forces", name, rectangle(0, 0, scene.width(), scene.height()),
                           [&context, polygon](Spot room, const ScaleWish& wish) {
                               return force_polygons_figure(context, room.x, room.y, wish, false, polygon);
                           })
            .may_be_larger = true;
    };
    for (const FreeBody& body : s.free_bodies) {
        if (!has_force_polygon(s, body)) continue;
        add_polygon("forces-" + name_of(s, body).substr(name_of(s, body).find('-') + 1), body.polygon);
        // The pole of the rays is as far to the side as the forces are long.
        if (body.funicular) list.back().extent_x += std::max(list.back().extent_x, list.back().extent_y);
    }
    for (const TakenTogether& together : s.taken_together) {
        add_polygon(name_of(s, together), together.polygon);
        if (together.funicular) list.back().extent_x += std::max(list.back().extent_x, list.back().extent_y);
    }
}

/// The loads of each body with their lines and polygons; then the sums.
void WantedFigures::add_superposition() {
    const Solution& s = context_.solution;
    for (int part = 0; part < parts_of(s); ++part) {
        const LoadCase alone(s, part);
        const std::string& load = alone.load();
        if (detail_ == SolutionDetail::full || has_meets(alone, false)) {
            Wanted lines = mechanism("lines-load-" + load, false);
            lines.asked.reset();
            lines.draw = [this, part](Spot room, const ScaleWish& wish) {
                return mechanism_with_forces(context_, room.x, room.y, part, wish);
            };
            add(std::move(lines));
        }
        if (detail_ == SolutionDetail::full)
            for (std::size_t b = 0; b < alone.bodies().size(); ++b)
                if (has_force_polygon(alone, alone.bodies()[b])) add_free_body(alone, b);
        if (polygons_of(alone) == 0) continue;
        Wanted& polygons = add_force_polygons("forces", "forces-load-" + load, extent_of_forces(alone),
                                              [this, part, load](Spot room, const ScaleWish& wish) {
                                                  Figure figure = force_polygons_figure(context_, room.x, room.y, wish,
                                                                                        true, -1, part);
                                                  figure.id = "forces-load-" + load;
                                                  return figure;
                                              });
        polygons.is_row = polygons.may_be_larger = true;
    }
    if (s.superposition->sums.empty()) return;
    add_force_polygons("forces", "sums", extent_of_partial_sums(s), [this](Spot room, const ScaleWish& wish) {
        return partial_sums_figure(context_, room.x, room.y, wish);
    }).is_row = true;
}

void WantedFigures::add_truss() {
    Wanted wanted = mechanism("truss", false);
    const Box extent = extent_of_truss(context_.solution);
    const double bars = std::max(wanted.extent_x, wanted.extent_y);
    wanted.extent_x = extent.width();
    wanted.extent_y = extent.height();
    // The bars; strings run between their letters, too.
    constexpr double least_of_bars = 48;
    wanted.least = least_of_bars * std::max(extent.width(), extent.height()) / std::max(bars, 1e-30);
    wanted.weight = 1.5;
    wanted.draw = [this](Spot room, const ScaleWish& wish) { return truss_figure(context_, room.x, room.y, wish); };
    add(std::move(wanted));
    if (!has_plan(context_.solution)) return;
    Wanted& plan = add_force_polygons(
        "closure", "cremona", extent_of_plan(context_.solution),
        [this](Spot room, const ScaleWish& wish) { return cremona_figure(context_, room.x, room.y, wish); });
    // It needs space for its letters, independently of the other polygons.
    plan.to_force_scale = false;
    plan.least = 40;
    plan.weight = 1.2;
}

void WantedFigures::add_lines_of_action() {
    Wanted wanted = mechanism("lines-of-action", false);
    wanted.draw = [this](Spot room, const ScaleWish& wish) {
        return mechanism_with_forces(context_, room.x, room.y, all_loads, wish);
    };
    add(std::move(wanted));
}

/// `kind`: the key of its scale in the file; without one it has the common scale.
Wanted& WantedFigures::add_force_polygons(const std::string& kind, const std::string& name, const Box& extent,
                                          Wanted::Draw draw) {
    const double si = context_.solution.mechanism.units.force.si.to_double();
    Wanted wanted;
    wanted.name = name;
    wanted.extent_x = extent.width();
    wanted.extent_y = extent.height();
    wanted.least = 0;
    wanted.enough = 110;
    for (const std::string& figure : {kind, std::string("forces"), std::string("closure")})
        if (!wanted.asked) wanted.asked = asked(figure, si);
    wanted.to_force_scale = true;
    wanted.draw = std::move(draw);
    return add(std::move(wanted));
}

/// All force polygons have one scale, so that the sides of the closed polygon can be copied with compasses. The largest
/// polygon must be readable at it.
void WantedFigures::keep_forces_readable() {
    constexpr double least = 25;
    if (Wanted* largest = largest_of_forces(); largest != nullptr) largest->least = std::max(largest->least, least);
}

Wanted* WantedFigures::largest_of_forces() {
    Wanted* largest = nullptr;
    for (Wanted& each : list)
        if (each.to_force_scale && each.name != "forces" && (largest == nullptr || each.extent() > largest->extent()))
            largest = &each;
    return largest;
}

/// In the order of the bodies, pins after them.
void WantedFigures::add_free_bodies() {
    const Solution& s = context_.solution;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < s.free_bodies.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto rank = [&](std::size_t i) {
            return s.free_bodies[i].body == none ? 1 << 20 : s.free_bodies[i].body.number();
        };
        return rank(a) < rank(b);
    });
    for (const std::size_t i : order) add_free_body(s, i);
}

void WantedFigures::add_free_body(const LoadCase& loads, std::size_t index) {
    const FreeBody& free = loads.bodies()[index];
    Wanted body;
    body.name = name_of(loads.solution(), free) + (loads.is_alone() ? "-load-" + loads.load() : "");
    const Box box = extent_of_free_body(loads, index);
    body.extent_x = std::max(box.width(), 0.3 * box.height());
    body.extent_y = std::max(box.height(), 0.3 * box.width());
    // A minimum for letters; the true size is known after drawing.
    body.rim_x = 14;
    body.rim_y = 20;
    body.fills = true;
    body.least = 10;
    body.enough = 70;
    body.weight = 0.6;
    // A longer link with two forces on one line shows no more: the space is better used for polygons.
    constexpr double enough_for_two_forces = 50;
    if (body.extent() > 0 && !has_force_polygon(loads, free)) body.enough = enough_for_two_forces;
    body.draw = [this, index, part = loads.part()](Spot room, const ScaleWish&) {
        return free_body_figure(context_, index, room.x, room.y, detail_ == SolutionDetail::full, part);
    };
    add(std::move(body));
}

void WantedFigures::add_small() {
    const auto add_on_mechanism = [&](const std::string& name, Figure (*draw)(const DrawingContext&, double, double,
                                                                              const ScaleWish&)) -> Wanted& {
        Wanted wanted = mechanism(name, false);
        wanted.asked.reset();
        wanted.draw = [this, draw](Spot room, const ScaleWish& wish) { return draw(context_, room.x, room.y, wish); };
        return add(std::move(wanted));
    };
    if (has_some(context_.solution, &PointMotion::velocity)) add_on_mechanism("velocities", velocities_on_mechanism);
    if (has_some(context_.solution, &PointMotion::acceleration))
        add_on_mechanism("accelerations", accelerations_on_mechanism).spare = true;
    if (!has_circle(context_.solution) || detail_ == SolutionDetail::brief) return;
    Wanted circle;
    circle.name = "circle-diagram";
    circle.extent_x = circle.extent_y =
        std::clamp(8.4 * static_cast<double>(context_.solution.mechanism.bodies.size()), 24.0, 56.0);
    circle.rim_x = circle.rim_y = 13;
    circle.fills = circle.spare = true;
    circle.enough = circle.extent_x;
    circle.weight = 0.03;
    circle.draw = [this](Spot room, const ScaleWish&) { return circle_diagram(context_, room.x, room.y); };
    add(std::move(circle));
}

void WantedFigures::collect_motion() {
    add_mechanism();
    const std::vector<Polygon>& polygons = context_.solution.protocol.polygons;
    for (std::size_t p = 0; p < polygons.size(); ++p)
        if (polygons[p].plane != Plane::force) add_polygon(static_cast<int>(p));
    add_curvature();
}

void WantedFigures::add_curvature() {
    const Solution& s = context_.solution;
    for (std::size_t i = 0; i < s.curvature.size(); ++i) {
        if (!has_curvature_figure(s.curvature[i])) continue;
        const Box extent = extent_of_curvature(s, i);
        Wanted wanted;
        wanted.name = name_of(s, s.curvature[i]);
        wanted.extent_x = extent.width();
        wanted.extent_y = extent.height();
        wanted.least = 48;
        wanted.weight = 1.5;
        wanted.draw = [this, i](Spot room, const ScaleWish& wish) {
            return curvature_figure(context_, i, room.x, room.y, wish);
        };
        add(std::move(wanted));
    }
}

void WantedFigures::add_loops() {
    const Box extent = extent_of_loops(context_.solution);
    Wanted wanted;
    wanted.name = "loops";
    wanted.extent_x = extent.width();
    wanted.extent_y = extent.height();
    wanted.least = 64;
    wanted.weight = 1.5;
    wanted.draw = [this](Spot room, const ScaleWish& wish) { return loops_figure(context_, room.x, room.y, wish); };
    add(std::move(wanted));
}

void WantedFigures::add_displacements() {
    for (std::size_t i = 0; i < displacement_figures(context_.solution); ++i) {
        Wanted wanted = mechanism(displacement_figure_name(i), false);
        wanted.asked.reset();
        wanted.least = 48;
        wanted.draw = [this, i](Spot room, const ScaleWish& wish) {
            return displacement_figure(context_, i, room.x, room.y, wish);
        };
        add(std::move(wanted));
    }
}

void WantedFigures::add_moving_axes() {
    const Solution& s = context_.solution;
    if (detail_ == SolutionDetail::brief) return;
    for (std::size_t i = 0; i < s.relative_motion.size(); ++i) {
        if (!has_moving_axes(s.relative_motion[i])) continue;
        Wanted wanted = mechanism(moving_axes_name(s, i), false);
        wanted.asked.reset();
        wanted.least = 32;
        wanted.draw = [this, i](Spot room, const ScaleWish& wish) {
            return moving_axes_figure(context_, i, room.x, room.y, wish);
        };
        add(std::move(wanted));
    }
}

void WantedFigures::add_mechanism() {
    const Solution& s = context_.solution;
    const bool centres = shows_centres();
    Wanted wanted = mechanism(!centres || s.instantaneous_motion ? "mechanism" : "centres", centres);
    wanted.plain_name = "mechanism";
    wanted.draw = [this, centres](Spot room, const ScaleWish& wish) {
        if (context_.solution.instantaneous_motion) return instantaneous_motion_figure(context_, room.x, room.y, wish);
        return mechanism_figure(context_, room.x, room.y, centres, wish);
    };
    if (!s.instantaneous_motion && detail_ == SolutionDetail::full)
        wanted.enrich = [this, centres](const Figure& plain, Spot room) {
            return mechanism_with_found_turnings(context_, plain, room, centres);
        };
    add(std::move(wanted));
}

void WantedFigures::add_polygon(int polygon) {
    const PolygonScene& scene = scenes_.emplace_back(polygon_scene(context_.solution, polygon));
    Wanted wanted;
    wanted.name = scene.id;
    wanted.empty = scene.empty();
    wanted.extent_x = scene.width();
    wanted.extent_y = scene.height();
    wanted.least = 16;
    wanted.enough = 110;
    wanted.weight = 1.5;
    const double si = scene.unit.si.to_double();
    wanted.asked = asked(scene.id, si);
    if (!wanted.asked)
        wanted.asked = asked(scene.kind == PolygonScene::Kind::acceleration ? "acceleration" : "velocity", si);
    wanted.draw = [this, &scene](Spot room, const ScaleWish& wish) {
        return polygon_figure(context_, scene, room.x, room.y, wish);
    };
    wanted.has_corner = !wanted.empty;
    add(std::move(wanted));
}

std::optional<double> WantedFigures::asked(const std::string& figure, double si) const {
    for (const AskedScale& scale : context_.solution.mechanism.scales)
        if (scale.figure == figure) return scale.per_millimetre.to_double() / si;
    return std::nullopt;
}

}  // namespace kinegraph::render
