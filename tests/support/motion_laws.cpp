#include "tests/support/motion_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/results/quantity_name.hpp"
#include "engine/solution/solution.hpp"
#include "tests/support/told.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }

/// The construction is exact and the check works in doubles. Each dyad's angle is at least 5°, so its 2×2 system loses
/// at most a factor 1/sin² 5° ≈ 130 of the 2⁻⁵² of a double, relative to its own quantity, and the check's refinement
/// recovers most of that. In a chain the errors add and do not multiply, relative to the largest quantity of the kind.
/// 1e-9 is three orders above the largest error found (5e-12 in 3,000 mechanisms) and five below a wrong term, which is
/// of the order of the largest quantity.
constexpr double tolerance = 1e-9;

/// A pose by compass is exact to 2⁻¹⁰⁰ of its size. An intersection of two lines at 5° enlarges the error by about 2⁴,
/// and a centre by Kennedy depends on several of them: 2⁻⁶⁰ allows ten such intersections in a row, and is far below an
/// error in any printed digit.
const Exact least_share = Exact::power_of_two(-60);

/// A solved mechanism and its motion as fields, on which the laws are tested.
class Held {
public:
    explicit Held(const Solution& solution) : solution_(solution), carried_(solution.mechanism.bodies.size()) {
        for (const PointMotion& point : solution.points) {
            for (const BodyIndex body : point.bodies) carried_[at(body)].push_back(&point);
        }
    }

    void all() {
        checks_agree();
        if (testing::Test::HasFatalFailure()) return;
        second_ways_agree();
        bodies_are_rigid();
        slidings_follow_their_guides();
        rolling_does_not_slip();
        equations_close();
        drawn_vectors_are_the_results();
        centres_have_one_velocity();
        three_centres_lie_on_a_line();
    }

private:
    using Pick = std::optional<Vector> PointMotion::*;

    const std::string& name(PointIndex point) const { return solution_.mechanism.points[at(point)].name; }
    const std::string& body_name(BodyIndex body) const { return solution_.mechanism.bodies[at(body)].name; }
    Exact omega(BodyIndex body) const { return body == frame ? Exact() : solution_.bodies[at(body)].omega.value(); }
    Exact alpha(BodyIndex body) const { return body == frame ? Exact() : solution_.bodies[at(body)].alpha.value(); }

    // --- the numeric check ---
    using Kind = Quantity::Kind;

    static Kind kind_of(const Quantity& quantity) {
        switch (quantity.kind) {
            case Kind::sliding_velocity: return Kind::velocity;
            case Kind::sliding_acceleration:
            case Kind::sliding_coriolis: return Kind::acceleration;
            default: return quantity.kind;
        }
    }

    /// Rows that the laws of statics test.
    static bool of_forces(Kind kind) {
        return kind == Kind::force || kind == Kind::couple || kind == Kind::effort || kind == Kind::virtual_power;
    }

    /// N; of the loads given by components or magnitude.
    double largest_load() const {
        double largest = 0;
        for (const Load& load : solution_.mechanism.loads) {
            const auto* force = std::get_if<ForceLoad>(&load);
            if (force == nullptr) continue;
            largest =
                std::max(largest, force->value ? length(*force->value) : std::abs(force->magnitude->first.to_double()));
        }
        return largest;
    }

    void checks_agree() {
        std::map<Kind, double> largest;
        std::map<Kind, int> rows;
        for (const CheckRow& row : solution_.checks) {
            const Kind kind = kind_of(row.quantity);
            largest[kind] = std::max(largest[kind], std::abs(row.numeric));
            ++rows[kind];
        }
        // If nothing turns, an angular velocity is compared with the speeds divided by the size of the drawing, and
        // vice versa.
        const double size = solution_.pose.size.to_double();
        for (const auto& [spin, speed] :
             {std::pair(Kind::omega, Kind::velocity), std::pair(Kind::alpha, Kind::acceleration)}) {
            largest[spin] = std::max(largest[spin], largest[speed] / size);
            largest[speed] = std::max(largest[speed], largest[spin] * size);
        }
        for (const CheckRow& row : solution_.checks) {
            if (of_forces(kind_of(row.quantity))) continue;
            ASSERT_TRUE(std::isfinite(row.graphical) && std::isfinite(row.numeric)) << name_of(row.quantity, solution_);
            double scale = std::max(std::abs(row.numeric), largest[kind_of(row.quantity)]);
            if (kind_of(row.quantity) == Kind::centre) scale = reach_of_centre(row);
            // Components may all be zero: they are then small beside the loads.
            if (kind_of(row.quantity) == Kind::force_component) scale = std::max(scale, largest_load());
            EXPECT_LE(std::abs(row.difference), tolerance * scale)
                << name_of(row.quantity, solution_) << ": " << row.graphical << ", numeric " << row.numeric;
        }
        const int moving = static_cast<int>(solution_.mechanism.bodies.size()) - 1;
        EXPECT_EQ(rows[Kind::omega], moving);
        EXPECT_EQ(rows[Kind::alpha], moving);
        for (const PointMotion& point : solution_.points)
            ASSERT_TRUE(point.velocity && point.acceleration) << "nothing known of " << name(point.point);
        EXPECT_EQ(solution_.sliding.size(), sliding_joints());
    }

    /// The error of a centre is relative to its distance from the mechanism: the check divides by ω_rel, and if that is
    /// a small difference of large angular velocities, the centre is far away.
    double reach_of_centre(const CheckRow& row) const {
        const Quantity centre = row.quantity.along(Quantity::Component::whole);
        double reach = solution_.pose.size.to_double();
        for (const CheckRow& other : solution_.checks) {
            if (other.quantity.along(Quantity::Component::whole) == centre)
                reach = std::max(reach, std::abs(other.numeric));
        }
        return reach;
    }

    std::size_t sliding_joints() const {
        return static_cast<std::size_t>(
            std::count_if(solution_.mechanism.joints.begin(), solution_.mechanism.joints.end(), [](const Joint& joint) {
                return joint.kind == JointKind::prismatic || joint.kind == JointKind::pin_slot ||
                       joint.kind == JointKind::contact;
            }));
    }

    void second_ways_agree() {
        for (const SecondWay& way : solution_.second_way)
            EXPECT_TRUE(way.agrees) << "omega of body " << body_name(way.body)
                                    << " by centres: " << way.omega->to_double();
    }

    // --- laws of a rigid body ---
    /// Rivals' theorem between every two points of a body, which includes the theorem of projections.
    void bodies_are_rigid() {
        for (std::size_t b = 1; b < carried_.size(); ++b) {
            const BodyIndex body(b);
            for (const PointMotion* p : carried_[b]) {
                for (const PointMotion* q : carried_[b]) {
                    if (p == q) break;
                    const Vector join = solution_.pose.at(p->point) - solution_.pose.at(q->point);
                    const Vector v = *p->velocity - *q->velocity, a = *p->acceleration - *q->acceleration;
                    EXPECT_EQ(dot(*p->velocity, join), dot(*q->velocity, join))
                        << "projections of " << p->label << q->label;
                    EXPECT_EQ(v, omega(body) * quarter_turn(join))
                        << "v_" << p->label << q->label << " of " << body_name(body);
                    EXPECT_EQ(a, alpha(body) * quarter_turn(join) - square(omega(body)) * join)
                        << "a_" << p->label << q->label << " of " << body_name(body);
                }
            }
        }
    }

    /// The velocity (acceleration) of the point of a body at that place.
    std::optional<Vector> velocity_on(BodyIndex body, const Vector& place) const {
        if (body == frame) return Vector{};
        if (carried_[at(body)].empty()) return std::nullopt;
        const PointMotion& base = *carried_[at(body)].front();
        return *base.velocity + omega(body) * quarter_turn(place - solution_.pose.at(base.point));
    }
    std::optional<Vector> acceleration_on(BodyIndex body, const Vector& place) const {
        if (body == frame) return Vector{};
        if (carried_[at(body)].empty()) return std::nullopt;
        const PointMotion& base = *carried_[at(body)].front();
        const Vector join = place - solution_.pose.at(base.point);
        return *base.acceleration + alpha(body) * quarter_turn(join) - square(omega(body)) * join;
    }

    void slidings_follow_their_guides() {
        for (const Sliding& sliding : solution_.sliding) {
            const Joint& joint = solution_.mechanism.joints[at(sliding.joint)];
            ASSERT_TRUE(sliding.velocity && sliding.acceleration && sliding.coriolis) << joint.name;
            const BodyIndex i = joint.bodies[0], j = joint.bodies[1];
            const Vector& place = solution_.pose.at(joint.point);
            const auto v_i = velocity_on(i, place), v_j = velocity_on(j, place);
            const auto a_i = acceleration_on(i, place), a_j = acceleration_on(j, place);
            ASSERT_TRUE(v_i && v_j && a_i && a_j) << joint.name;
            EXPECT_EQ(*sliding.velocity, *v_i - *v_j) << joint.name;
            EXPECT_EQ(*sliding.coriolis, 2 * omega(j) * quarter_turn(*sliding.velocity)) << joint.name;
            EXPECT_EQ(*sliding.acceleration, *a_i - *a_j - *sliding.coriolis) << joint.name;
            if (joint.arc != none) {
                const Vector radius = place - solution_.pose.at(joint.arc);
                EXPECT_TRUE(dot(*sliding.velocity, radius).is_zero()) << joint.name << " runs off its slot";
                EXPECT_EQ(dot(*sliding.acceleration, radius), -squared_length(*sliding.velocity)) << joint.name;
            } else if (joint.kind == JointKind::contact) {
                EXPECT_TRUE(dot(*sliding.velocity, solution_.pose.normals[at(sliding.joint)]).is_zero())
                    << joint.name << " lifts off or digs in";
            } else {
                const Vector& guide = solution_.pose.guides[at(sliding.joint)];
                EXPECT_TRUE(cross(*sliding.velocity, guide).is_zero()) << joint.name << " runs off its guide";
                EXPECT_TRUE(cross(*sliding.acceleration, guide).is_zero()) << joint.name << " runs off its guide";
            }
            if (joint.kind == JointKind::prismatic) {
                EXPECT_EQ(omega(i), omega(j)) << joint.name;
                EXPECT_EQ(alpha(i), alpha(j)) << joint.name;
            }
        }
    }

    /// The points in contact have equal velocities, and their relative acceleration is normal.
    void rolling_does_not_slip() {
        for (std::size_t j = 0; j < solution_.mechanism.joints.size(); ++j) {
            const Joint& joint = solution_.mechanism.joints[j];
            if (joint.kind != JointKind::rolling) continue;
            const Vector& place = solution_.pose.at(joint.point);
            const auto v_i = velocity_on(joint.bodies[0], place), v_j = velocity_on(joint.bodies[1], place);
            const auto a_i = acceleration_on(joint.bodies[0], place), a_j = acceleration_on(joint.bodies[1], place);
            ASSERT_TRUE(v_i && v_j && a_i && a_j) << joint.name;
            EXPECT_EQ(*v_i, *v_j) << joint.name << " slips";
            EXPECT_TRUE(cross(*a_i - *a_j, solution_.pose.normals[j]).is_zero()) << joint.name << " begins to slip";
        }
    }

    // --- polygons ---
    /// The vector of a term as this statement draws it, else as an earlier one drew it in the same figure.
    std::optional<Vector> drawn(const Symbol& symbol, StatementIndex statement) const {
        const Protocol& protocol = solution_.protocol;
        const Plane plane =
            protocol.statements[at(statement)].section == Topic::velocity ? Plane::velocity : Plane::acceleration;
        const auto is_of_it = [&](int polygon) {
            return protocol.polygons[at(polygon)].kind == Polygon::Kind::motion &&
                   protocol.polygons[at(polygon)].plane == plane;
        };
        std::optional<Vector> earlier;
        for (const DrawnVector& vector : protocol.vectors) {
            if (!(vector.symbol == symbol) || !is_of_it(vector.polygon)) continue;
            if (vector.statement == statement) return protocol.value_of(vector);
            if (!earlier) earlier = protocol.value_of(vector);
        }
        if (earlier) return earlier;
        // Assur's point has an image, but no vector of its own.
        for (const Image& image : protocol.images) {
            if (image.symbol.about == symbol.about && symbol.term.empty() && is_of_it(image.polygon))
                return protocol.point(image.point).place();
        }
        return std::nullopt;
    }

    /// Each equation closes exactly with the vectors of its polygon.
    void equations_close() {
        for (std::size_t i = 0; i < solution_.protocol.statements.size(); ++i) {
            const Statement& statement = solution_.protocol.statements[i];
            if (!statement.equation ||
                (statement.section != Topic::velocity && statement.section != Topic::acceleration))
                continue;
            std::optional<Vector> first;
            for (const std::vector<Term>& side : statement.equation->sides) {
                Vector sum;
                for (const Term& term : side) {
                    const auto vector = drawn(term.symbol, StatementIndex(i));
                    EXPECT_TRUE(vector) << name_of(term.symbol) << " stands in an equation and is drawn nowhere";
                    if (!vector) return;
                    sum = sum + *vector;
                }
                if (!first) {
                    first = sum;
                } else {
                    EXPECT_EQ(*first, sum) << "an equation for " << name_of(side.front().symbol) << " does not close";
                }
            }
        }
    }

    void drawn_vectors_are_the_results() {
        for (const DrawnVector& vector : solution_.protocol.vectors) {
            const Polygon& polygon = solution_.protocol.polygons[at(vector.polygon)];
            const bool velocity = polygon.plane == Plane::velocity;
            if (vector.role != DrawnVector::Role::absolute || !vector.symbol.term.empty() ||
                polygon.kind != Polygon::Kind::motion)
                continue;
            for (const PointMotion& point : solution_.points) {
                if (point.label != vector.symbol.about) continue;
                EXPECT_EQ(solution_.protocol.value_of(vector), velocity ? *point.velocity : *point.acceleration)
                    << name_of(vector.symbol);
            }
        }
    }

    // --- centres ---
    /// Exactly zero; in a pose by compass, a share of `beside` that its inexact points can explain.
    void expect_nothing(const Exact& value, const Exact& beside, const std::string& what) const {
        if (solution_.pose.exact) {
            EXPECT_TRUE(value.is_zero()) << what << ": off by " << value.to_double();
        } else {
            EXPECT_LE(abs(value), least_share * beside) << what << ": off by " << (value / beside).to_double();
        }
    }
    static Exact largest_of(const Vector& vector) { return std::max(abs(vector.x), abs(vector.y)); }

    void centres_have_one_velocity() {
        Exact fastest = 1;
        for (const PointMotion& point : solution_.points) fastest = std::max(fastest, largest_of(*point.velocity));
        for (const InstantCentre& centre : solution_.centres) {
            const BodyIndex i = centre.first, j = centre.second;
            const std::string what = "centre " + body_name(i) + "," + body_name(j);
            ASSERT_TRUE(centre.at || centre.everywhere) << what;
            Exact spins = abs(omega(i)) + abs(omega(j)) + 1;
            if (centre.everywhere || centre.at->at_infinity()) expect_nothing(omega(i) - omega(j), spins, what);
            if (!centre.everywhere && centre.at->at_infinity()) {
                const auto v_i = velocity_on(i, {}), v_j = velocity_on(j, {});
                ASSERT_TRUE(v_i && v_j) << what;
                const Vector relative = *v_j - *v_i;
                expect_nothing(dot(relative, centre.at->place()), fastest * largest_of(centre.at->place()), what);
                continue;
            }
            const Vector place = centre.at ? centre.at->place() : solution_.pose.points.front();
            if (centre.at && centre.at->at_infinity()) continue;
            const auto v_i = velocity_on(i, place), v_j = velocity_on(j, place);
            ASSERT_TRUE(v_i && v_j) << what;
            const Exact beside = fastest + spins * largest_of(place);
            expect_nothing(v_i->x - v_j->x, beside, what);
            expect_nothing(v_i->y - v_j->y, beside, what);
        }
    }

    /// The Aronhold–Kennedy theorem, for all triples of bodies in which every pair has its own centre. Bodies at
    /// relative rest have none; bodies in relative translation have theirs on the line at infinity, where the theorem
    /// holds as well.
    void three_centres_lie_on_a_line() {
        const Mechanism& mechanism = solution_.mechanism;
        std::map<std::pair<BodyIndex, BodyIndex>, const InstantCentre*> centres;
        for (const InstantCentre& centre : solution_.centres) centres[{centre.first, centre.second}] = &centre;
        for (const BodyIndex i : indices_of(mechanism.bodies)) {
            for (const BodyIndex j : mechanism.bodies_after(i)) {
                for (const BodyIndex k : mechanism.bodies_after(j)) {
                    const InstantCentre* three[] = {centres.at({i, j}), centres.at({i, k}), centres.at({j, k})};
                    if (std::any_of(std::begin(three), std::end(three), [](const auto* c) { return c->everywhere; }))
                        continue;
                    std::array<ProjectivePoint, 3> p;
                    Exact beside = 1;
                    for (std::size_t n = 0; n < 3; ++n) {
                        p[n] = *three[n]->at;
                        if (!p[n].at_infinity()) {
                            p[n].x /= solution_.pose.size;
                            p[n].y /= solution_.pose.size;
                        }
                        beside *= std::max({abs(p[n].x), abs(p[n].y), p[n].w});
                    }
                    const Exact determinant = p[0].x * (p[1].y * p[2].w - p[2].y * p[1].w) -
                                              p[0].y * (p[1].x * p[2].w - p[2].x * p[1].w) +
                                              p[0].w * (p[1].x * p[2].y - p[2].x * p[1].y);
                    expect_nothing(determinant, beside,
                                   "centres of " + body_name(i) + ", " + body_name(j) + ", " + body_name(k));
                }
            }
        }
    }

    const Solution& solution_;
    std::vector<std::vector<const PointMotion*>> carried_;  ///< by BodyIndex
};

}  // namespace

void expect_whole_motion(const Solution& solution) {
    if (!solution.unsolved.empty()) {
        ADD_FAILURE() << english_of(solution.unsolved.front());
        return;
    }
    Held(solution).all();
}

void expect_laws_of_motion(const Solution& solution) { Held(solution).all(); }

}  // namespace kinegraph
