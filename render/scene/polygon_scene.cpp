// Polygon scene: extracted from the protocol. Each element is converted to doubles only once, because the rationals are
// long.
#include "render/scene/polygon_scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "engine/number/assert.hpp"
#include "engine/solution/solution.hpp"
#include "render/ink/spot.hpp"
#include "render/scene/drawn_by.hpp"
#include "render/scene/load_case.hpp"

namespace kinegraph::render {
namespace {

/// A direction as a unit vector, whatever the size of its coordinates.
Place direction(const Vector& vector) {
    const Exact largest = std::max(abs(vector.x), abs(vector.y));
    if (largest.is_zero()) return {1, 0};
    const Spot along = unit({(vector.x / largest).to_double(), (vector.y / largest).to_double()});
    return {along.x, along.y};
}

const Unit& unit_of(const Polygon& polygon, const Units& units) {
    if (polygon.plane == Plane::force) return units.force;
    return polygon.plane == Plane::acceleration ? units.acceleration : units.velocity;
}
PolygonScene::Kind kind_of(const Polygon& polygon) {
    if (polygon.plane == Plane::acceleration) return PolygonScene::Kind::acceleration;
    if (polygon.plane == Plane::velocity) return PolygonScene::Kind::velocity;
    return polygon.kind == Polygon::Kind::joined_forces ? PolygonScene::Kind::closure : PolygonScene::Kind::forces;
}

/// Whether the sentence of a statement names the symbol.
bool names(const Protocol& protocol, StatementIndex statement, const Symbol& symbol) {
    if (statement == none) return false;
    const auto& said = protocol.statements[at_index(statement)].message.arguments;
    return std::any_of(said.begin(), said.end(), [&](const auto& argument) {
        const auto* named = std::get_if<Symbol>(&argument);
        return named != nullptr && *named == symbol;
    });
}

class Reading {
public:
    Reading(const Solution& solution, int polygon)
        : solution_(solution),
          protocol_(solution.protocol),
          index_(polygon),
          polygon_(protocol_.polygons[at_index(polygon)]) {
        scene_.kind = kind_of(polygon_);
        scene_.id = polygon_.id;
        scene_.point = polygon_.point;
        scene_.observer = polygon_.observer;
        scene_.translating = polygon_.translating;
        scene_.unit = unit_of(polygon_, solution.mechanism.units);
        si_is_one_ = scene_.unit.si == Exact(1);
    }

    PolygonScene scene() {
        measure();
        add_vectors();
        if (polygon_.plane == Plane::force) {
            add_faces();
        } else {
            add_trials();
            add_lines();
            add_images();
            if (polygon_.kind == Polygon::Kind::motion) add_images_of_bodies();
        }
        return std::move(scene_);
    }

private:
    static constexpr double near_the_solution = 0.5;  // of its size

    bool of_motion() const { return polygon_.plane != Plane::force; }
    double in_unit(const Exact& si_value) const {
        return (si_is_one_ ? si_value : si_value / scene_.unit.si).to_double();
    }
    Place place(ElementIndex element) {
        const auto [found, fresh] = places_.try_emplace(element);
        if (fresh) {
            const ProjectivePoint& point = protocol_.point(element);
            found->second = {in_unit(point.x), in_unit(point.y)};
        }
        return found->second;
    }
    Place direction_of(ElementIndex line) {
        const auto [found, fresh] = directions_.try_emplace(line);
        if (fresh) found->second = direction(protocol_.line(line).direction());
        return found->second;
    }

    /// In a polygon of motion the pole, at the origin, is part of the polygon.
    void measure() {
        bool any = of_motion();
        const auto add = [&](ElementIndex element) {
            if (protocol_.point(element).at_infinity()) return;
            const Place p = place(element);
            if (!any) scene_.least = scene_.most = p;
            any = true;
            scene_.least = {std::min(scene_.least.x, p.x), std::min(scene_.least.y, p.y)};
            scene_.most = {std::max(scene_.most.x, p.x), std::max(scene_.most.y, p.y)};
        };
        for (const int v : polygon_.vectors) {
            add(protocol_.vectors[at_index(v)].tail);
            add(protocol_.vectors[at_index(v)].tip);
        }
        if (of_motion())
            for (const int i : polygon_.images) add(protocol_.images[at_index(i)].point);
    }

    void add_vectors() {
        std::set<std::string> names;
        std::set<std::tuple<ElementIndex, ElementIndex, std::string>> seen;
        std::optional<Vector> longest;
        Exact square;
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[at_index(index)];
            const Vector exact = protocol_.value_of(vector);
            if (!of_motion())
                if (Exact own = dot(exact, exact); !longest || square < own) longest = exact, square = std::move(own);
            const double value =
                kinegraph::length(si_is_one_ ? exact : Vector{exact.x / scene_.unit.si, exact.y / scene_.unit.si});
            if (!(value > scene_.size() * 1e-12)) continue;  // zero vectors are not drawn; the tables state them
            const std::string base = name_of(vector.symbol);
            if (!seen.emplace(vector.tail, vector.tip, base).second) continue;
            SceneVector& shown = scene_.vectors.emplace_back();
            shown.symbol = vector.symbol;
            shown.name = base;
            for (int n = 2; !names.insert(shown.name).second; ++n) shown.name = base + "-" + std::to_string(n);
            shown.tail = place(vector.tail);
            shown.tip = place(vector.tip);
            shown.value = value;
            scene_.longest = std::max(scene_.longest, value);
            shown.body = vector.body;
            const Part part = part_shown_by(vector);
            shown.is_part =
                part.force != nullptr && (part.force->is_reaction() || part.force->kind == Quantity::Kind::effort);
            shown.falls_out = scene_.kind == PolygonScene::Kind::closure && vector.role == DrawnVector::Role::internal;
            shown.has_right_angles =
                vector.role == DrawnVector::Role::normal || vector.role == DrawnVector::Role::coriolis;
            shown.statement = statement_of(vector);
            if (vector.role == DrawnVector::Role::coriolis) add_coriolis(vector, exact);
        }
        if (longest) scene_.along = direction(*longest);
    }
    void add_coriolis(const DrawnVector& vector, const Vector& exact) {
        const BodyIndex guide = vector.seen.to.body;
        if (guide == none || !solution_.bodies[at_index(guide)].omega) return;
        SceneCoriolis& shown = scene_.coriolis.emplace_back();
        shown.coriolis = vector.symbol;
        // The velocity that belongs to a Coriolis term: v^rel for a^cor; at a joint v_AA* is the relative velocity.
        shown.velocity = velocity_of_coriolis(vector.symbol, polygon_.kind == Polygon::Kind::relative_motion);
        shown.omega = {Symbol::Letter::omega, solution_.mechanism.bodies[at_index(guide)].name, ""};
        shown.counter_clockwise = solution_.bodies[at_index(guide)].omega->sign() > 0;
        const Place turned = direction(exact);
        shown.along = shown.counter_clockwise ? Place{turned.y, -turned.x} : Place{-turned.y, turned.x};
        shown.body = vector.body;
        shown.guide = guide;
        shown.statement = statement_of(vector);
    }
    /// A force is drawn by the statement that finds it; the polygon of one body by the statement that closes it, with
    /// all its sides.
    StatementIndex statement_of(const DrawnVector& vector) const {
        if (of_motion()) return vector.statement;
        if (scene_.kind == PolygonScene::Kind::closure) return statement_of_force(solution_, vector.quantity);
        for (int part = all_loads; part < parts_of(solution_); ++part) {
            const LoadCase loads(solution_, part);
            for (const FreeBody& body : loads.bodies())
                if (body.polygon == index_) return body.statement;
            for (const TakenTogether& together : loads.together())
                if (together.polygon == index_) return together.statement;
        }
        if (solution_.superposition)
            for (const Superposition::Sum& sum : solution_.superposition->sums)
                if (sum.polygon == index_) return solution_.superposition->statement;
        return statement_of_part(vector);
    }
    /// What a side shows of a body under the loads of one body, in a polygon that joins such parts.
    struct Part {
        const FreeBody* body = nullptr;
        const AppliedForce* force = nullptr;
    };
    const Superposition::Joined* joined() const {
        if (!solution_.superposition) return nullptr;
        const auto& all = solution_.superposition->joined;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.polygon == index_; });
        return found == all.end() ? nullptr : &*found;
    }
    Part part_shown_by(const DrawnVector& vector) const {
        const Superposition::Joined* const of = joined();
        if (of == nullptr) return {};
        for (const Superposition::Part& part : solution_.superposition->parts)
            for (const FreeBody& body : part.bodies)
                if (body.body == of->body && body.pin == of->pin)
                    for (const AppliedForce& each : body.forces)
                        if (each.symbol == vector.symbol) return {&body, &each};
        return {};
    }
    /// A polygon that joins parts is drawn load by load: a side by the statement that closes the body under that load,
    /// the sums by the one that adds them.
    StatementIndex statement_of_part(const DrawnVector& vector) const {
        if (joined() == nullptr) return none;
        const Part part = part_shown_by(vector);
        return part.body != nullptr ? part.body->statement : solution_.superposition->statement;
    }

    void add_faces() {
        for (const kinegraph::Face& face : polygon_.faces) {
            SceneFace& shown = scene_.faces.emplace_back();
            shown.body = face.body;
            for (const ElementIndex corner : face.corners) shown.corners.push_back(place(corner));
        }
    }

    void add_lines() {
        for (const DrawnLine& each : protocol_.lines) {
            if (each.polygon != index_ || each.line == none || protocol_.line(each.line).at_infinity()) continue;
            std::vector<ElementIndex> finite;
            std::copy_if(each.points.begin(), each.points.end(), std::back_inserter(finite),
                         [&](ElementIndex element) { return !protocol_.point(element).at_infinity(); });
            if (finite.empty()) continue;
            scene_.lines.push_back(
                {each.reason, place(finite.front()), place(finite.back()), direction_of(each.line), each.statement});
        }
    }

    /// The errors of closing belong in the picture, since a sentence speaks of them: where one lies apart from the
    /// solution, the picture grows, as far as the solution stays large enough to be read.
    void make_room_for_misses() {
        constexpr double most_growth = 6;
        Place least = scene_.least, most = scene_.most;
        for (const DrawnMiss& miss : protocol_.trials.misses)
            for (const ElementIndex element : {miss.through, miss.foot, miss.tip}) {
                if (miss.polygon != index_) continue;
                if (protocol_.point(element).at_infinity()) return;
                const Place p = place(element);
                least = {std::min(least.x, p.x), std::min(least.y, p.y)};
                most = {std::max(most.x, p.x), std::max(most.y, p.y)};
            }
        const double size = scene_.size(), off = near_the_solution * size;
        const bool is_near = least.x > scene_.least.x - off && least.y > scene_.least.y - off &&
                             most.x < scene_.most.x + off && most.y < scene_.most.y + off;
        if (is_near || std::max(most.x - least.x, most.y - least.y) > most_growth * size) return;
        scene_.least = least;
        scene_.most = most;
    }

    /// Trial lines are clipped to the neighbourhood of the solution.
    void add_trials() {
        make_room_for_misses();
        const Trials& trials = protocol_.trials;
        const double near = near_the_solution * scene_.size();
        const auto is_near = [&](ElementIndex element) {
            if (protocol_.point(element).at_infinity()) return false;
            const Place p = place(element);
            return p.x > scene_.least.x - near && p.x < scene_.most.x + near && p.y > scene_.least.y - near &&
                   p.y < scene_.most.y + near;
        };
        const auto add = [&](ElementIndex from, ElementIndex to, bool is_line, StatementIndex statement) {
            if (is_near(from) && is_near(to)) scene_.trials.push_back({place(from), place(to), is_line, statement});
        };
        for (const DrawnVector& vector : trials.vectors)
            if (vector.polygon == index_) add(vector.tail, vector.tip, false, vector.statement);
        for (const DrawnLine& each : trials.lines)
            if (each.polygon == index_ && each.points.size() > 1)
                add(each.points.front(), each.points.back(), true, each.statement);
        for (const DrawnMiss& miss : trials.misses)
            if (miss.polygon == index_ && is_near(miss.through) && is_near(miss.foot) && is_near(miss.tip))
                scene_.misses.push_back(
                    {miss.symbol, place(miss.through), place(miss.foot), place(miss.tip), miss.statement});
        for (const Image& image : trials.images)
            if (image.polygon == index_ && is_near(image.point))
                scene_.images.push_back({SceneImage::Kind::trial, image.symbol, place(image.point), image.trial,
                                         is_in_a_sentence(image), image.statement});
    }
    /// Whether a sentence on trials, that begins them or closes them, names the point of an image.
    bool is_in_a_sentence(const Image& image) const {
        const auto& misses = protocol_.trials.misses;
        return names(protocol_, image.statement, image.symbol) ||
               std::any_of(misses.begin(), misses.end(), [&](const DrawnMiss& miss) {
                   return miss.polygon == index_ && names(protocol_, miss.statement, image.symbol);
               });
    }

    void add_images() {
        SceneImage& pole = scene_.images.emplace_back();
        pole.kind = SceneImage::Kind::pole;
        pole.symbol = {Symbol::Letter::pole, polygon_.plane == Plane::acceleration ? "a" : "v", ""};
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[at_index(index)];
            if (image.symbol.letter == Symbol::Letter::pole && !image.symbol.about.empty()) pole.symbol = image.symbol;
        }
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[at_index(index)];
            if (image.symbol.letter == Symbol::Letter::pole || protocol_.point(image.point).at_infinity()) continue;
            scene_.images.push_back(
                {SceneImage::Kind::image, image.symbol, place(image.point), 0, true, statement_of(image)});
        }
    }
    /// The statement that draws an image: the first with a vector that ends in it; otherwise the one that finds its
    /// point.
    StatementIndex statement_of(const Image& image) const {
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[at_index(index)];
            if (vector.tip == image.point || vector.tail == image.point) return vector.statement;
        }
        return image.statement;
    }

    /// A body with three or more points has a similar image.
    void add_images_of_bodies() {
        std::map<ElementIndex, StatementIndex> statements;  // by point
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[at_index(index)];
            StatementIndex& statement = statements.try_emplace(image.point, none).first->second;
            if (image.body > frame) statement = std::max(statement, statement_of(image));
        }
        for (const BodyIndex body : indices(solution_.mechanism.bodies.size(), frame.next())) {
            SceneFace face{body, {}, none};
            for (const PointMotion& point : solution_.points) {
                if (std::find(point.bodies.begin(), point.bodies.end(), body) == point.bodies.end()) continue;
                const auto& found = polygon_.plane == Plane::velocity ? point.velocity : point.acceleration;
                const auto drawn = found ? statements.find(found.element()) : statements.end();
                if (drawn == statements.end()) continue;
                face.corners.push_back(place(drawn->first));
                face.statement = std::max(face.statement, drawn->second);
            }
            if (face.corners.size() > 2) scene_.faces.push_back(std::move(face));
        }
    }

    const Solution& solution_;
    const Protocol& protocol_;
    int index_;
    const Polygon& polygon_;
    bool si_is_one_ = true;
    std::map<ElementIndex, Place> places_, directions_;
    PolygonScene scene_;
};

}  // namespace

PolygonScene polygon_scene(const Solution& solution, int polygon) {
    KG_ASSERT(polygon >= 0 && at_index(polygon) < solution.protocol.polygons.size(), "a polygon of the protocol");
    return Reading(solution, polygon).scene();
}

bool PolygonScene::is_straight() const {
    constexpr double seen = 1e-3;  // of the longest vector: about a tenth of a millimetre
    const auto way = [](const SceneVector& vector) {
        return Place{vector.tip.x - vector.tail.x, vector.tip.y - vector.tail.y};
    };
    const auto chief = std::max_element(vectors.begin(), vectors.end(),
                                        [](const auto& one, const auto& other) { return one.value < other.value; });
    return std::all_of(vectors.begin(), vectors.end(), [&](const SceneVector& vector) {
        const Place with = way(*chief), by = way(vector);
        return std::abs(with.x * by.y - with.y * by.x) <= seen * longest * longest;
    });
}

std::vector<int> closed_polygons(const Solution& solution) {
    std::vector<int> found;
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
        if (solution.protocol.polygons[p].kind == Polygon::Kind::joined_forces &&
            solution.protocol.polygons[p].faces.size() > 1)
            found.push_back(static_cast<int>(p));
    return found;
}

}  // namespace kinegraph::render
