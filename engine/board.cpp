#include "engine/board.hpp"

#include <algorithm>

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

/// How far from "yes" a predicate is: an exact excess, zero for an exact yes, and the binary order of magnitude of what it is
/// small beside. Orders are enough to tell what is suspicious, and cost nothing beside the exact numbers.
struct Measure {
    bool yes = false;  ///< the excess is exactly zero
    long excess_order = 0;
    long unit_order = 0;

    long relative_order() const { return excess_order - unit_order; }
};

/// Order of magnitudes that stands for zero: below anything a file may hold.
constexpr long order_of_zero = -1000000;

/// log2 |value| within one.
long order_of(const Exact& value) {
    if (value.is_zero()) return order_of_zero;
    return static_cast<long>(mpz_sizeinbase(value.rational().get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(value.rational().get_den_mpz_t(), 2));
}
long order_of(const Vector& vector) { return std::max(order_of(vector.x), order_of(vector.y)); }

Measure angle_between(const Vector& d, const Vector& e) {
    const Exact sine = cross(d, e);
    return {sine.is_zero(), order_of(sine), order_of(d) + order_of(e)};
}

Measure beside(const Vector& excess, long unit_order) { return {excess.is_zero(), order_of(excess), unit_order}; }

constexpr Measure no{false, 0, 0};
constexpr Measure exact_yes{true, order_of_zero, 0};

Vector direction_in(const Value& value) {
    if (const auto* line = std::get_if<ProjectiveLine>(&value)) return line->direction();
    return std::get<Vector>(value);
}

bool is_line_at_infinity(const Value& value) {
    const auto* line = std::get_if<ProjectiveLine>(&value);
    return line != nullptr && line->at_infinity();
}

/// The order of the largest length of a plane so far: what "small" is compared with.
long largest_length(const std::vector<Stroke>& strokes, const std::vector<Value>& values, Plane plane, const Pose& pose) {
    if (plane == Plane::drawing) return order_of(pose.size);
    long largest = order_of_zero;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (strokes[i].plane != plane) continue;
        if (const auto* tip = std::get_if<ProjectivePoint>(&values[i])) largest = std::max(largest, order_of(tip->place()));
        if (const auto* vector = std::get_if<Vector>(&values[i])) largest = std::max(largest, order_of(*vector));
    }
    return largest;
}

long largest_scalar(const std::vector<Value>& values) {
    long largest = order_of_zero;
    for (const Value& value : values) {
        if (const auto* scalar = std::get_if<Exact>(&value)) largest = std::max(largest, order_of(*scalar));
    }
    return largest;
}

Measure measure(const Guard& guard, const std::vector<Stroke>& strokes, const std::vector<Value>& values, const Pose& pose) {
    const int a = guard.inputs[0], b = guard.inputs[1];
    const auto unit = [&] { return pose.exact ? 0 : largest_length(strokes, values, strokes[position(a)].plane, pose); };
    switch (guard.question) {
        case Guard::Question::coincide: {
            const ProjectivePoint& p = point_in(values, a);
            const ProjectivePoint& q = point_in(values, b);
            if (p.at_infinity() && q.at_infinity()) return angle_between(p.place(), q.place());
            if (p.at_infinity() || q.at_infinity()) return no;
            return beside(p.place() - q.place(), unit());
        }
        case Guard::Question::parallel: {
            const bool first = is_line_at_infinity(values[position(a)]), second = is_line_at_infinity(values[position(b)]);
            if (first || second) return first && second ? exact_yes : no;
            return angle_between(direction_in(values[position(a)]), direction_in(values[position(b)]));
        }
        case Guard::Question::zero_vector:
            return beside(vector_in(values, a), unit());
        case Guard::Question::zero_scalar: {
            const Exact& scalar = scalar_in(values, a);
            return {scalar.is_zero(), order_of(scalar), pose.exact ? 0 : largest_scalar(values)};
        }
        case Guard::Question::on_line: {
            const ProjectivePoint& p = point_in(values, a);
            const ProjectiveLine& l = line_in(values, b);
            if (incident(p, l)) return exact_yes;
            if (pose.exact || l.at_infinity()) return no;
            if (p.at_infinity()) return angle_between(p.place(), l.direction());
            const Exact excess = l.a * p.x + l.b * p.y + l.c;
            return {false, order_of(excess), order_of(l.direction()) + unit()};
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
      tangents_(pose.guides.size(), -1),
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
        case Verb::given_tangent:
            return pose.tangents[index()];
        case Verb::given_driver_direction:
            return pose.driver_directions[index()];
        case Verb::given_unit_driver_direction:
            return pose.driver_units[index()];
        case Verb::given_by_pose:
            return by_pose_[index()](pose);
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
        case Verb::quotient:
            return scalar(a) / scalar(b);
        case Verb::moment:
            return cross(vector(a), vector(b));
        case Verb::arm:
            return (-scalar(a) / squared_length(vector(b))) * quarter_turn(vector(b));
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
DirectionHandle Board::tangent(JointIndex joint) { return {given_once(tangents_, Verb::given_tangent, joint)}; }

DirectionHandle Board::driver_direction(int driver) {
    return {given_once(driver_directions_, Verb::given_driver_direction, driver)};
}
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

int Board::given_by_pose(Plane plane, std::function<Vector(const Pose&)> vector) {
    by_pose_.push_back(std::move(vector));
    Stroke stroke;
    stroke.verb = Verb::given_by_pose;
    stroke.plane = plane;
    stroke.index = static_cast<int>(by_pose_.size()) - 1;
    return enter(stroke);
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
    if (here.yes) return true;
    if (pose_.exact) return false;
    // A leftover of 2^-bits shows amplified by the meets in between; what stands half the bits above it is not suspicious.
    if (here.relative_order() > -pose_.bits / 2) return false;
    if (!replay_) replay_ = std::make_unique<Replay>();
    const Pose& fine = finer_();
    for (std::size_t i = replay_->values.size(); i < protocol_.strokes.size(); ++i) {
        replay_->values.push_back(evaluate(protocol_.strokes[i], replay_->values, fine));
    }
    const Measure finer = measure(guard, protocol_.strokes, replay_->values, fine);
    guard.by_finer_pose = true;
    // What shrinks with the pose is zero, what stays is not.
    return finer.yes || finer.relative_order() <= here.relative_order() - pose_.bits / 2;
}

int Board::add_polygon(Polygon polygon) {
    protocol_.polygons.push_back(std::move(polygon));
    return static_cast<int>(protocol_.polygons.size()) - 1;
}

void Board::draw(DrawnVector vector) {
    vector.statement = current_statement_;
    if (vector.trial != 0) return protocol_.trials.vectors.push_back(std::move(vector));
    protocol_.polygons[position(vector.polygon)].vectors.push_back(static_cast<int>(protocol_.vectors.size()));
    protocol_.vectors.push_back(std::move(vector));
}

void Board::label(Image image) {
    if (image.trial != 0) return protocol_.trials.images.push_back(std::move(image));
    protocol_.polygons[position(image.polygon)].images.push_back(static_cast<int>(protocol_.images.size()));
    protocol_.images.push_back(std::move(image));
}

void Board::add_face(int polygon, Face face) { protocol_.polygons[position(polygon)].faces.push_back(std::move(face)); }

void Board::draw(DrawnLine line) {
    line.statement = current_statement_;
    if (line.trial != 0) return protocol_.trials.lines.push_back(std::move(line));
    protocol_.lines.push_back(std::move(line));
}

Protocol Board::finish() && {
    if (current_statement_ >= 0)
        protocol_.statements[position(current_statement_)].last_stroke = static_cast<int>(protocol_.strokes.size());
    return std::move(protocol_);
}

}  // namespace kinegraph
