#include "engine/board.hpp"

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

std::size_t position(int element) {
    KG_ASSERT(element >= 0, "a handle that no stroke made");
    return static_cast<std::size_t>(element);
}
const ProjectivePoint& point_in(const std::vector<Value>& values, int element) {
    return std::get<ProjectivePoint>(values[position(element)]);
}
const ProjectiveLine& line_in(const std::vector<Value>& values, int element) {
    return std::get<ProjectiveLine>(values[position(element)]);
}
const Vector& vector_in(const std::vector<Value>& values, int element) { return std::get<Vector>(values[position(element)]); }
const Exact& scalar_in(const std::vector<Value>& values, int element) { return std::get<Exact>(values[position(element)]); }

/// k with v = k·w: the component along w, so that a replay on another pose, where they are parallel only nearly, is defined too.
Exact ratio_of(const Vector& v, const Vector& w) {
    if (w.x.is_zero()) return v.y / w.y;
    if (w.y.is_zero()) return v.x / w.x;
    return dot(v, w) / squared_length(w);
}

/// How far from "yes" a predicate is: excess / unit, both ≥ 0, squares. Zero excess is an exact yes.
struct Measure {
    Exact excess;
    Exact unit = 1;
};

Measure angle_between(const Vector& d, const Vector& e) { return {square(cross(d, e)), squared_length(d) * squared_length(e)}; }

Vector direction_in(const Value& value) {
    if (const auto* line = std::get_if<ProjectiveLine>(&value)) return line->direction();
    return std::get<Vector>(value);
}

bool is_line_at_infinity(const Value& value) {
    const auto* line = std::get_if<ProjectiveLine>(&value);
    return line != nullptr && line->at_infinity();
}

/// The square of the largest length of a plane so far: what "small" is compared with.
Exact largest_square(const std::vector<Stroke>& strokes, const std::vector<Value>& values, Plane plane, const Pose& pose) {
    if (plane == Plane::drawing) return square(pose.size);
    Exact largest;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (strokes[i].plane != plane) continue;
        Exact here;
        if (const auto* tip = std::get_if<ProjectivePoint>(&values[i])) here = squared_length(tip->place());
        if (const auto* vector = std::get_if<Vector>(&values[i])) here = squared_length(*vector);
        if (here > largest) largest = here;
    }
    return largest;
}

Exact largest_scalar_square(const std::vector<Value>& values) {
    Exact largest;
    for (const Value& value : values) {
        if (const auto* scalar = std::get_if<Exact>(&value); scalar != nullptr && square(*scalar) > largest)
            largest = square(*scalar);
    }
    return largest;
}

Measure measure(const Guard& guard, const std::vector<Stroke>& strokes, const std::vector<Value>& values, const Pose& pose) {
    const int a = guard.inputs[0], b = guard.inputs[1];
    const Plane plane = strokes[position(a)].plane;
    switch (guard.question) {
        case Guard::Question::coincide: {
            const ProjectivePoint& p = point_in(values, a);
            const ProjectivePoint& q = point_in(values, b);
            if (p.at_infinity() && q.at_infinity()) return angle_between(p.place(), q.place());
            if (p.at_infinity() || q.at_infinity()) return {1, 1};
            const Exact excess = squared_length(p.place() - q.place());
            return {excess, excess.is_zero() || pose.exact ? Exact(1) : largest_square(strokes, values, plane, pose)};
        }
        case Guard::Question::parallel: {
            const bool first = is_line_at_infinity(values[position(a)]), second = is_line_at_infinity(values[position(b)]);
            if (first || second) return {first && second ? 0 : 1, 1};
            return angle_between(direction_in(values[position(a)]), direction_in(values[position(b)]));
        }
        case Guard::Question::zero_vector: {
            const Exact excess = squared_length(vector_in(values, a));
            return {excess, excess.is_zero() || pose.exact ? Exact(1) : largest_square(strokes, values, plane, pose)};
        }
        case Guard::Question::zero_scalar: {
            const Exact excess = square(scalar_in(values, a));
            return {excess, excess.is_zero() || pose.exact ? Exact(1) : largest_scalar_square(values)};
        }
        case Guard::Question::on_line: {
            const ProjectivePoint& p = point_in(values, a);
            const ProjectiveLine& l = line_in(values, b);
            if (incident(p, l)) return {};
            if (pose.exact) return {1, 1};
            if (l.at_infinity()) return {1, 1};
            if (p.at_infinity()) return angle_between(p.place(), l.direction());
            return {square(l.a * p.x + l.b * p.y + l.c),
                    (square(l.a) + square(l.b)) * largest_square(strokes, values, plane, pose)};
        }
    }
    KG_ASSERT(false, "every question has a measure");
}

}  // namespace

/// The same strokes on the finer pose, continued only when a predicate asks.
struct Board::Replay {
    std::vector<Value> values;
};

Board::Board(const Pose& pose, std::function<const Pose&()> finer)
    : pose_(pose),
      finer_(std::move(finer)),
      places_(pose.points.size(), -1),
      guides_(pose.guides.size(), -1),
      guide_units_(pose.guides.size(), -1),
      normals_(pose.guides.size(), -1),
      driver_directions_(pose.driver_directions.size(), -1),
      driver_units_(pose.driver_directions.size(), -1) {}

Board::~Board() = default;

int Board::state(Statement statement) {
    if (current_statement_ >= 0)
        protocol_.statements[position(current_statement_)].last_stroke = static_cast<int>(protocol_.strokes.size());
    statement.first_stroke = statement.last_stroke = static_cast<int>(protocol_.strokes.size());
    protocol_.statements.push_back(std::move(statement));
    current_statement_ = static_cast<int>(protocol_.statements.size()) - 1;
    return current_statement_;
}

Statement& Board::statement(int index) { return protocol_.statements[position(index)]; }

int Board::enter(const Stroke& stroke) {
    protocol_.values.push_back(evaluate(stroke, protocol_.values, pose_));
    protocol_.strokes.push_back(stroke);
    protocol_.strokes.back().statement = current_statement_;
    return static_cast<int>(protocol_.strokes.size()) - 1;
}

Value Board::evaluate(const Stroke& stroke, const std::vector<Value>& values, const Pose& pose) const {
    const int a = stroke.inputs[0], b = stroke.inputs[1];
    const auto index = [&] { return position(stroke.index); };
    const auto vector = [&](int element) -> const Vector& { return vector_in(values, element); };
    const auto scalar = [&](int element) -> const Exact& { return scalar_in(values, element); };
    switch (stroke.verb) {
        case Verb::given_place:
            return ProjectivePoint{pose.points[index()].x, pose.points[index()].y, 1};
        case Verb::given_guide:
            return pose.guides[index()];
        case Verb::given_unit_guide:
            return pose.guide_units[index()];
        case Verb::given_normal:
            return pose.normals[index()];
        case Verb::given_driver_direction:
            return pose.driver_directions[index()];
        case Verb::given_unit_driver_direction:
            return pose.driver_units[index()];
        case Verb::given_direction:
        case Verb::given_scalar:
            return constants_[index()];
        case Verb::pole:
            return ProjectivePoint{0, 0, 1};
        case Verb::vector_between:
            return point_in(values, b).place() - point_in(values, a).place();
        case Verb::perpendicular:
        case Verb::turn:
            return quarter_turn(vector(a));
        case Verb::direction_of_line:
            return line_in(values, a).direction();
        case Verb::point_at_infinity:
            return ProjectivePoint{vector(a).x, vector(a).y, 0};
        case Verb::through:
            return line_through(point_in(values, a), vector(b));
        case Verb::join:
            return line_joining(point_in(values, a), point_in(values, b));
        case Verb::meet:
            return finite_meet(line_in(values, a), line_in(values, b));
        case Verb::meet_at_infinity: {
            const ProjectiveLine& l = line_in(values, a);
            return point_at_infinity_of(l.at_infinity() ? line_in(values, b) : l);
        }
        case Verb::carry: {
            const Vector tip = point_in(values, a).place() + vector(b);
            return ProjectivePoint{tip.x, tip.y, 1};
        }
        case Verb::add:
            return vector(a) + vector(b);
        case Verb::subtract:
            return vector(a) - vector(b);
        case Verb::negate:
            return -vector(a);
        case Verb::scale:
            return scalar(a) * vector(b);
        case Verb::ratio:
            return ratio_of(vector(a), vector(b));
        case Verb::product:
            return scalar(a) * scalar(b);
        case Verb::sum:
            return scalar(a) + scalar(b);
        case Verb::difference:
            return scalar(a) - scalar(b);
    }
    KG_ASSERT(false, "every verb is evaluated");
}

int Board::given_once(std::vector<int>& known, Verb verb, int index) {
    int& element = known[position(index)];
    if (element < 0) {
        Stroke stroke;
        stroke.verb = verb;
        stroke.index = index;
        element = enter(stroke);
    }
    return element;
}

PointOn<Plane::drawing> Board::place(PointIndex point) { return {given_once(places_, Verb::given_place, point)}; }
DirectionHandle Board::guide(JointIndex joint) { return {given_once(guides_, Verb::given_guide, joint)}; }
DirectionHandle Board::guide_unit(JointIndex joint) { return {given_once(guide_units_, Verb::given_unit_guide, joint)}; }
DirectionHandle Board::normal(JointIndex joint) { return {given_once(normals_, Verb::given_normal, joint)}; }

DirectionHandle Board::driver_direction(int driver) { return {given_once(driver_directions_, Verb::given_driver_direction, driver)}; }
DirectionHandle Board::driver_unit(int driver) { return {given_once(driver_units_, Verb::given_unit_driver_direction, driver)}; }

DirectionHandle Board::given_direction(const Vector& direction) {
    constants_.emplace_back(direction);
    Stroke stroke;
    stroke.verb = Verb::given_direction;
    stroke.index = static_cast<int>(constants_.size()) - 1;
    return {enter(stroke)};
}

ScalarHandle Board::given(const Exact& value) {
    constants_.emplace_back(value);
    Stroke stroke;
    stroke.verb = Verb::given_scalar;
    stroke.index = static_cast<int>(constants_.size()) - 1;
    return {enter(stroke)};
}

int Board::pole(Plane plane) {
    int& element = poles_[static_cast<std::size_t>(plane)];
    if (element < 0) {
        Stroke stroke;
        stroke.verb = Verb::pole;
        stroke.plane = plane;
        element = enter(stroke);
    }
    return element;
}

int Board::unary(Verb verb, Plane plane, int a) { return binary(verb, plane, a, -1); }

int Board::binary(Verb verb, Plane plane, int a, int b) {
    Stroke stroke;
    stroke.verb = verb;
    stroke.plane = plane;
    stroke.inputs[0] = a;
    stroke.inputs[1] = b;
    return enter(stroke);
}

int Board::join(Plane plane, int p, int q) {
    KG_ASSERT(!ask(Guard::Question::coincide, p, q), "two points that coincide have no join: ask first");
    return binary(Verb::join, plane, p, q);
}

int Board::meet(Plane plane, int l, int m) {
    if (!ask(Guard::Question::parallel, l, m)) {
        const bool one_at_infinity = protocol_.line(l).at_infinity() || protocol_.line(m).at_infinity();
        return binary(one_at_infinity ? Verb::meet_at_infinity : Verb::meet, plane, l, m);
    }
    if (protocol_.line(l).at_infinity()) return -1;
    // Parallel: the same line where a point of one lies on the other.
    const Stroke& first = protocol_.strokes[position(l)];
    int on_first = first.inputs[0];
    if (first.verb == Verb::join && protocol_.point(on_first).at_infinity()) on_first = first.inputs[1];
    if (ask(Guard::Question::on_line, on_first, m)) return -1;
    return binary(Verb::meet_at_infinity, plane, l, m);
}

bool Board::ask(Guard::Question question, int a, int b) {
    Guard guard;
    guard.question = question;
    guard.inputs[0] = a;
    guard.inputs[1] = b;
    guard.verdict = decide(guard);
    protocol_.guards.push_back(guard);
    return guard.verdict;
}

bool Board::decide(Guard& guard) {
    const Measure here = measure(guard, protocol_.strokes, protocol_.values, pose_);
    if (here.excess.is_zero()) return true;
    if (pose_.exact) return false;
    // Squares: a leftover of 2^-bits may show as 2^-2bits times what several meets amplify. Far above that nothing is suspicious.
    if (here.excess > here.unit * Exact::power_of_two(-(9 * pose_.bits) / 10)) return false;
    if (!replay_) replay_ = std::make_unique<Replay>();
    const Pose& fine = finer_();
    for (std::size_t i = replay_->values.size(); i < protocol_.strokes.size(); ++i) {
        replay_->values.push_back(evaluate(protocol_.strokes[i], replay_->values, fine));
    }
    const Measure finer = measure(guard, protocol_.strokes, replay_->values, fine);
    guard.by_finer_pose = true;
    // What shrinks with the pose is zero, what stays is not.
    return finer.excess * here.unit <= here.excess * finer.unit * Exact::power_of_two(-pose_.bits);
}

int Board::add_polygon(Polygon polygon) {
    protocol_.polygons.push_back(std::move(polygon));
    return static_cast<int>(protocol_.polygons.size()) - 1;
}

void Board::draw(DrawnVector vector) {
    vector.statement = current_statement_;
    protocol_.polygons[position(vector.polygon)].vectors.push_back(static_cast<int>(protocol_.vectors.size()));
    protocol_.vectors.push_back(std::move(vector));
}

void Board::label(Image image) {
    protocol_.polygons[position(image.polygon)].images.push_back(static_cast<int>(protocol_.images.size()));
    protocol_.images.push_back(std::move(image));
}

void Board::draw(DrawnLine line) {
    line.statement = current_statement_;
    protocol_.lines.push_back(std::move(line));
}

Protocol Board::finish() && {
    if (current_statement_ >= 0)
        protocol_.statements[position(current_statement_)].last_stroke = static_cast<int>(protocol_.strokes.size());
    return std::move(protocol_);
}

}  // namespace kinegraph
