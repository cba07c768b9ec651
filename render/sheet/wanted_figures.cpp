// Wanted figures: the mechanism, the polygons of motion, those of forces, the bodies cut free, the lever.
#include "render/sheet/wanted_figures.hpp"

#include <algorithm>
#include <string>

#include "render/page/shapes.hpp"
#include "render/sheet/beside.hpp"

namespace kinegraph::render {

bool has_forces(const Solution& solution) { return !solution.free_bodies.empty(); }
bool has_motion(const Solution& solution) {
    return !solution.centres.empty() ||
           std::any_of(solution.protocol.polygons.begin(), solution.protocol.polygons.end(),
                       [](const Polygon& p) { return p.plane == Plane::velocity || p.plane == Plane::acceleration; });
}
bool is_mixed(const Solution& solution) { return has_forces(solution) && has_motion(solution); }

Wanted::Expected Wanted::expected(double room_x, double room_y) const {
    constexpr double least_room = 12, as_good_as = 0.5;
    const double x = room_x - rim_x, y = room_y - rim_y;
    double scale = x < least_room || y < least_room ? any_scale : choose_scale(extent_x, extent_y, x, y, std::nullopt);
    bool lacks_details = false;
    for (const NoFiner& each : no_finer)
        if (room_x <= each.room_x + as_good_as && room_y <= each.room_y + as_good_as && scale <= each.scale) {
            scale = each.scale;
            lacks_details = each.lacks_details;
        }
    if (const Drawn* known = finest_within(room_x, room_y); known && known->figure.scale < scale) {
        scale = known->figure.scale;
        lacks_details = known->figure.lacks_details;
    }
    return {scale, lacks_details};
}

const Wanted::Drawn* Wanted::finest_within(double room_x, double room_y) const {
    const Drawn* finest = nullptr;
    for (const Drawn& each : drawn)
        if (each.figure.box.width() <= room_x && each.figure.box.height() <= room_y &&
            (!finest || each.figure.scale < finest->figure.scale))
            finest = &each;
    return finest;
}

const Figure& Wanted::drawn_into(double room_x, double room_y, double coarsest) {
    constexpr double air = 16;
    const Drawn* finest = finest_within(room_x, room_y);
    // Not even without lettering; what fills its room, or stands in rows, has no such bound.
    const bool bounded = is_fitted() && std::max(extent_x, extent_y) > 0;
    const double largest = bounded ? choose_scale(extent_x, extent_y, room_x, room_y, std::nullopt) * (1 + 1e-9) : 0;
    for (const Drawn& each : drawn) {
        const double width = each.figure.box.width(), height = each.figure.box.height();
        if (finest && each.figure.scale > finest->figure.scale) continue;
        // Names that a narrower room kept in may stand better in this one, and details find their places.
        const bool at_ease = width + air <= each.room_x && height + air <= each.room_y && !each.figure.lacks_details;
        if ((each.room_x == room_x && each.room_y == room_y) ||
            (width <= room_x && height <= room_y &&
             ((each.room_x >= room_x && each.room_y >= room_y) || (at_ease && each.figure.scale <= largest))))
            return each.figure;
    }
    const double worst = finest && is_fitted() ? std::min(coarsest, finest->figure.scale) : coarsest;
    Figure figure = draw(room_x, room_y, worst);
    const bool refused = figure.scale > worst;
    if (is_fitted()) learn(room_x, room_y, figure, refused ? next_scale(worst) : figure.scale);
    if (!refused) {
        drawn.push_back({room_x, room_y, std::move(figure)});
        return drawn.back().figure;
    }
    if (finest && finest->figure.scale <= coarsest) return finest->figure;
    too_coarse = std::move(figure);
    return too_coarse;
}

void Wanted::learn(double room_x, double room_y, const Figure& figure, double scale) {
    no_finer.push_back({room_x, room_y, scale, figure.lacks_details});
    if (figure.scale > scale || figure.scale == any_scale) return;
    // What the letters took where they had the room; in a narrower one they take less.
    constexpr double spare = 5, leeway = 6;
    if (figure.box.width() + spare < room_x) rim_x = std::max(rim_x, figure.box.width() - extent_x / scale - leeway);
    if (figure.box.height() + spare < room_y) rim_y = std::max(rim_y, figure.box.height() - extent_y / scale - leeway);
}

bool has_circle(const Solution& solution) {
    constexpr std::size_t most = 16;  // of whose chords one can still be told from the next
    const std::size_t bodies = solution.mechanism.bodies.size();
    return bodies >= 3 && bodies <= most && !solution.centres.empty();
}
bool has_velocities(const Solution& solution) {
    // An act of motion has them in its own figure.
    return !solution.act_of_motion && std::any_of(solution.points.begin(), solution.points.end(), [](const PointMotion& m) {
        return m.point != none && m.velocity && !m.velocity->is_zero();
    });
}

WantedFigures::WantedFigures(const DrawingContext& context, double measure, bool joukowsky)
    : context_(context), measure_(measure) {
    if (has_motion(context.solution) || !has_forces(context.solution)) collect_motion();
    if (has_forces(context.solution)) collect_forces(joukowsky);
    const auto add_late = [&](const char* name, auto draw) {
        late.emplace_back();
        late.back().name = name;
        late.back().draw = [this, draw](double x, double y, double) { return draw(context_, x, y); };
    };
    if (has_velocities(context.solution)) add_late("velocities", velocities_on_mechanism);
    if (has_circle(context.solution)) add_late("circle-diagram", circle_diagram);
}

namespace {

/// What places span, m.
struct Span {
    double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
    void add(const Vector& at) {
        const double x = at.x.to_double(), y = at.y.to_double();
        left = std::min(left, x), right = std::max(right, x), low = std::min(low, y), high = std::max(high, y);
    }
    explicit Span(const std::vector<Vector>& points) {
        for (const Vector& at : points) add(at);
    }
    double width() const { return std::max(right - left, 1e-30); }
    double height() const { return std::max(high - low, 1e-30); }
};

}  // namespace

/// Its symbols and letters do not shrink with the mechanism: drawn small, it is crowded.
Wanted WantedFigures::mechanism(const std::string& name, double extent_x, double extent_y) const {
    Wanted mechanism;
    mechanism.name = name;
    mechanism.extent_x = extent_x;
    mechanism.extent_y = extent_y;
    mechanism.asked = asked("mechanism", 1);
    mechanism.caption_width = 95;
    mechanism.weight = context_.solution.act_of_motion ? 2.6 : 1.7;
    return mechanism;
}

void WantedFigures::collect_forces(bool joukowsky) {
    const Solution& s = context_.solution;
    first_of_forces = list.size();
    add_lines_of_action();
    if (has_force_polygons(s)) {
        const Box extent = extent_of_forces(s);
        add_force_polygons("forces", "forces", extent.width(), extent.height(),
                           [this](double x, double y, std::optional<double> scale, bool fixed) {
                               return force_polygons_figure(context_, x, y, scale, fixed);
                           });
        list.back().items = force_polygon_count(s);
        list.back().rim_x = 14;
        list.back().rim_y = 16;
    }
    for (const int p : closed_polygons(s)) {
        const PolygonScene scene = polygon_scene(s, p);
        add_force_polygons("closure", scene.id, scene.width(), scene.height(),
                           [this, p](double x, double y, std::optional<double> scale, bool fixed) {
                               return closed_polygon_figure(context_, p, x, y, scale, fixed);
                           });
    }
    add_free_bodies();
    if (joukowsky && no_lever(s) == NoLever::none) add_lever();
}

void WantedFigures::add_lines_of_action() {
    const Span span(context_.solution.pose.points);
    Wanted wanted = mechanism("lines-of-action", span.width(), span.height());
    wanted.rim_x = 34;
    wanted.rim_y = 40;
    wanted.starts_page = true;
    wanted.draw = [this](double x, double y, double) {
        Figure figure = mechanism_with_forces(context_, x, y);
        if (!asked("mechanism", 1) || (figure.box.width() <= x && figure.box.height() <= y)) return figure;
        return mechanism_with_forces(unscaled(), x, y);
    };
    list.push_back(std::move(wanted));
}

/// `kind`: by which the file asks for a scale; where it does not, that of the others holds.
void WantedFigures::add_force_polygons(const std::string& kind, const std::string& name, double extent_x, double extent_y,
                                       DrawForces draw) {
    const double si = context_.solution.mechanism.units.force.si.to_double();
    Wanted wanted;
    wanted.name = name;
    wanted.extent_x = std::max(extent_x, 1e-30);
    wanted.extent_y = std::max(extent_y, 1e-30);
    for (const std::string& figure : {kind, std::string("forces"), std::string("closure")})
        if (!wanted.asked) wanted.asked = asked(figure, si);
    wanted.to_force_scale = true;
    wanted.draw = [this, draw = std::move(draw), scale = wanted.asked](double x, double y, double) {
        const bool fixed = scale && !force_scale;
        return draw(x, y, fixed ? scale : force_scale, fixed);
    };
    list.push_back(std::move(wanted));
}

/// In the order of the bodies, pins after them.
void WantedFigures::add_free_bodies() {
    const Solution& s = context_.solution;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < s.free_bodies.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto rank = [&](std::size_t i) { return std::pair{s.free_bodies[i].body == none, s.free_bodies[i].body}; };
        return rank(a) < rank(b);
    });
    for (const std::size_t i : order) {
        Wanted body;
        const FreeBody& free = s.free_bodies[i];
        body.name = free.body != none ? "body-" + s.mechanism.bodies[at_index(free.body)].name
                                      : "pin-" + s.mechanism.points[at_index(free.pin)].name;
        const Box box = extent_of_free_body(s, i);
        body.extent_x = std::max(box.width(), 0.3 * box.height());
        body.extent_y = std::max(box.height(), 0.3 * box.width());
        if (!(body.extent_x > 0)) body.extent_x = body.extent_y = 1;
        body.rim_x = body.rim_y = 38;
        body.fills = true;
        body.weight = box.width() + box.height() > 0 ? 1 : 0.4;
        body.starts_page = i == order.front();
        body.draw = [this, i](double x, double y, double) { return free_body_figure(context_, i, x, y); };
        list.push_back(std::move(body));
    }
}

void WantedFigures::add_lever() {
    Wanted wanted;
    wanted.name = "joukowsky";
    lever_table = joukowsky_block(context_, measure_);
    const Box extent = extent_of_lever(context_.solution);
    wanted.extent_x = std::max(extent.width(), 1e-30);
    wanted.extent_y = std::max(extent.height(), 1e-30);
    wanted.rim_x = 40;  // forces on either side
    wanted.rim_y = 40 + 0.6 * lever_table.height;
    wanted.weight = 1.3;
    wanted.draw = [this](double x, double y, double) { return lever_with_table(x, y); };
    lever = list.size();
    list.push_back(std::move(wanted));
}

/// The table in a corner that the lever leaves free, beside it or above it, whichever leaves the figure largest; the lever
/// alone where none of these has room.
Figure WantedFigures::lever_with_table(double room_x, double room_y) const {
    const Box room = rectangle(0, 0, room_x, room_y);
    const auto fits = [](const Figure& figure, const Box& box) {
        return figure.box.width() <= box.width() && figure.box.height() <= box.height();
    };
    Figure alone = joukowsky_figure(context_, room_x, room_y);
    const Block block = joukowsky_block(context_, std::min(room_x, measure_));
    std::optional<Figure> best;
    std::vector<Mark> table;
    {
        Figure figure = alone;
        if (set_beside(table, figure, {block, block}, room)) best = std::move(figure);
    }
    for (const bool above : {true, false}) {
        Box left = room;
        (above ? left.min.y : left.min.x) += above ? block.height + 6 : block.width + 8;
        if (left.width() < 30 || left.height() < 30 || block.width > room_x || block.height > room_y) continue;
        Figure figure = joukowsky_figure(context_, left.width(), left.height());
        if (!fits(figure, left) || (best && best->scale <= figure.scale)) continue;
        centre(figure, left);
        best = std::move(figure);
        table.clear();
        set(table, block, {0, 0});
    }
    if (!best || best->scale > 6 * alone.scale) return alone;
    best->marks.insert(best->marks.end(), table.begin(), table.end());
    best->has_table = true;
    best->box = box_of(best->marks);
    return *best;
}
const DrawingContext& WantedFigures::unscaled() {
    if (!unscaled_) {
        unscaled_ = context_.solution;
        unscaled_->mechanism.scales.clear();
        unscaled_context_.emplace(
            DrawingContext{*unscaled_, context_.theme, context_.fonts, context_.language, context_.dimensions});
    }
    return *unscaled_context_;
}

void WantedFigures::collect_motion() {
    add_mechanism();
    const Protocol& protocol = context_.solution.protocol;
    std::map<StatementIndex, int> polygon_of;
    for (const DrawnVector& vector : protocol.vectors) polygon_of.emplace(vector.statement, vector.polygon);
    for (const DrawnLine& drawn : protocol.lines)
        if (drawn.polygon >= 0) polygon_of.emplace(drawn.statement, drawn.polygon);
    for (std::size_t p = 0; p < protocol.polygons.size(); ++p)
        if (protocol.polygons[p].plane != Plane::force) add_polygon(static_cast<int>(p), polygon_of);
}

void WantedFigures::add_mechanism() {
    const Solution& s = context_.solution;
    Span span(s.pose.points);
    const double near = (s.act_of_motion ? 1.2 : 0.6) * std::max({span.right - span.left, span.high - span.low, 1e-30});
    const Box body = rectangle(span.left - near, span.low - near, span.right + near, span.high + near);
    for (const InstantCentre& centre : s.centres) {
        if (!centre.at || centre.at->at_infinity()) continue;
        const Vector at = centre.at->place();
        const double x = at.x.to_double(), y = at.y.to_double();
        if (x > body.min.x && x < body.max.x && y > body.min.y && y < body.max.y) span.add(at);
    }
    Wanted wanted = mechanism(s.centres.empty() || s.act_of_motion ? "mechanism" : "centres", span.width(), span.height());
    wanted.rim_x = 22;
    wanted.rim_y = 26;
    const auto draw = [](const DrawingContext& context, double x, double y, double coarsest) {
        if (context.solution.act_of_motion) return act_of_motion_figure(context, x, y);
        return mechanism_figure(context, x, y, !context.solution.centres.empty(), coarsest);
    };
    wanted.draw = [this, draw](double x, double y, double coarsest) {
        Figure figure = draw(context_, x, y, coarsest);
        if (!list.front().asked || (figure.box.width() <= x && figure.box.height() <= y)) return figure;
        // The scale that the file asks for is too large for the paper: ours, then.
        return draw(unscaled(), x, y, coarsest);
    };
    list.push_back(std::move(wanted));
}

/// `polygon_of`: by statement, the polygon that it draws in.
void WantedFigures::add_polygon(int polygon, const std::map<StatementIndex, int>& polygon_of) {
    const Protocol& protocol = context_.solution.protocol;
    const PolygonScene& scene = scenes_.emplace_back(polygon_scene(context_.solution, polygon));
    Wanted wanted;
    wanted.name = scene.id;
    wanted.empty = scene.empty();
    wanted.extent_x = std::max(scene.width(), 1e-30);
    wanted.extent_y = std::max(scene.height(), 1e-30);
    const double si = scene.unit.si.to_double();
    wanted.asked = asked(scene.id, si);
    if (!wanted.asked) wanted.asked = asked(scene.kind == PolygonScene::Kind::acceleration ? "acceleration" : "velocity", si);
    wanted.draw = [this, &scene](double x, double y, double coarsest) { return polygon_figure(context_, scene, x, y, coarsest); };
    std::vector<Block> equations;
    for (const StatementIndex i : indices_of(protocol.statements)) {
        const auto& equation = protocol.statements[at_index(i)].equation;
        const auto found = polygon_of.find(i);
        if (!equation || found == polygon_of.end() || found->second != polygon) continue;
        equations.push_back(equation_block(context_, *equation, 1.25 * measure_));
        belong(equations.back().marks, 0, i);
        equation_polygon[i] = list.size();
    }
    wanted.has_equations = !equations.empty();
    wanted.equations = {arranged(equations, false), arranged(equations, true)};
    list.push_back(std::move(wanted));
}

std::optional<double> WantedFigures::asked(const std::string& figure, double si) const {
    for (const AskedScale& scale : context_.solution.mechanism.scales)
        if (scale.figure == figure) return scale.per_millimetre.to_double() / si;
    return std::nullopt;
}

}  // namespace kinegraph::render
