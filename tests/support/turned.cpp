#include "tests/support/turned.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::tests {
namespace {

Exact written(double value, int digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return *Exact::from_decimal(text.data());
}

class Turner {
public:
    explicit Turner(int digits) : digits_(digits) {}

    void turn(Vector& vector, const Exact& unit) const {
        const double x = (vector.x / unit).to_double(), y = (vector.y / unit).to_double();
        const double c = std::cos(tests::turn), s = std::sin(tests::turn);
        vector = {written(c * x - s * y, digits_) * unit, written(s * x + c * y, digits_) * unit};
    }
    void turn(Bearing& bearing) const {
        if (auto* angle = std::get_if<Angle>(&bearing.form)) {
            const double by = angle->in_degrees ? tests::turn * 180 / std::numbers::pi : tests::turn;
            angle->value = written(angle->value.to_double() + by, digits_);
        } else if (auto* vector = std::get_if<Vector>(&bearing.form)) {
            turn(*vector, 1);
        }
    }
    void turn(Joint& joint) const {
        if (joint.along) turn(*joint.along);
        for (auto& each : joint.profiles)
            if (auto* line = std::get_if<LineProfile>(&each.second)) turn(line->along);
        if (joint.tangent) turn(*joint.tangent);
        if (joint.pushes) turn(*joint.pushes, 1);
    }
    void turn(GivenMotion& given, const Exact& unit) const {
        if (auto* vector = std::get_if<Vector>(&given.value))
            turn(*vector, unit);
        else
            turn(std::get<Bearing>(given.value));
    }

private:
    int digits_;
};

/// x, y turned back by the same angle.
std::array<double, 2> back(const Vector& vector) {
    const double x = vector.x.to_double(), y = vector.y.to_double(), c = std::cos(turn), s = std::sin(turn);
    return {c * x + s * y, c * y - s * x};
}

/// Values of one kind, compared with the largest of them.
class Values {
public:
    explicit Values(double least) : largest_(least) {}
    /// `spread`: an allowed difference in addition to the tolerance.
    void add(const std::string& name, double as_given, double now, double spread) {
        largest_ = std::max(largest_, std::abs(as_given));
        pairs_.push_back({name, as_given, now, spread});
    }
    void add(const std::string& name, const Vector& as_given, const Vector& now, double spread) {
        const auto turned_back = back(now);
        add(name + " x", as_given.x.to_double(), turned_back[0], spread);
        add(name + " y", as_given.y.to_double(), turned_back[1], spread);
    }
    void expect_near(double tolerance) const {
        for (const auto& [name, as_given, now, spread] : pairs_)
            EXPECT_NEAR(as_given, now, tolerance * largest_ + spread) << name;
    }

private:
    struct Pair {
        std::string name;
        double as_given, now, spread;
    };
    double largest_;
    std::vector<Pair> pairs_;
};

std::vector<std::string> sentences_of(const Solution& solution) {
    std::vector<std::string> all;
    for (const Statement& statement : solution.protocol.statements) {
        Message said = statement.message;
        constexpr std::size_t without_its_place = 4;  // the place differs in another drawing
        if (said.sentence == lang::sentences::auxiliary_point)
            said.arguments.resize(std::min(said.arguments.size(), without_its_place));
        all.push_back(english(said));
    }
    return all;
}
std::vector<std::string> unsolved_of(const Solution& solution) {
    std::vector<std::string> all;
    for (const Unsolved& unsolved : solution.unsolved) all.push_back(english_of(unsolved));
    return all;
}
/// The statements about the mechanism, without those about its numbers: of a branch's ratios only the zero ones.
std::vector<std::string> verdicts_of(const Solution& solution) {
    std::vector<std::string> all;
    for (Message remark : solution.remarks) {
        if (remark.sentence.index < lang::sentences::repeated_constraints.index) continue;
        // It says what one unit of the last digit does, and is not said where no printed digit shows that.
        if (remark.sentence == lang::sentences::is_ill_conditioned) continue;
        for (Argument& argument : remark.arguments)
            if (auto* ratios = std::get_if<Ratios>(&argument))
                for (Ratio& ratio : *ratios) ratio.value = ratio.value == 0 ? 0 : 1;
        all.push_back(english(remark));
    }
    return all;
}

double distance(const Value& a, const Value& b) {
    if (const auto* p = std::get_if<ProjectivePoint>(&a))
        return length(p->place() - std::get<ProjectivePoint>(b).place());
    if (const auto* v = std::get_if<Vector>(&a)) return length(*v - std::get<Vector>(b));
    return std::abs((std::get<Exact>(a) - std::get<Exact>(b)).to_double());
}

/// Four times the effect of the data's precision on an element; 0 without `amplified`.
double spread_of(ElementIndex element, const Protocol* amplified) {
    double spread = 0;
    for (std::size_t i = 0; amplified != nullptr && element != none && i < amplified->shifted.size(); ++i)
        spread = std::max(spread,
                          4 * distance(amplified->values[at_index(element)], amplified->shifted[i][at_index(element)]));
    return spread;
}

template <class T>
void expect_known_alike(const std::string& name, const Recorded<T>& a, const Recorded<T>& b, const Protocol* amplified,
                        Values& values) {
    EXPECT_EQ(a.has_value(), b.has_value()) << name;
    if (!a || !b) return;
    const double spread = spread_of(b.element(), amplified);
    if constexpr (std::is_same_v<T, Exact>) {
        values.add(name, a->to_double(), b->to_double(), spread);
    } else {
        values.add(name, *a, *b, spread);
    }
}

double fastest_driver(const Solution& solution) {
    const double size = solution.pose.size.to_double();
    double fastest = 0;
    for (const Driver& driver : solution.mechanism.drivers)
        fastest = std::max(fastest, std::visit(
                                        [&](const auto& given) {
                                            if constexpr (requires { given.omega; }) {
                                                return std::abs(given.omega.to_double());
                                            } else {
                                                return std::abs(given.speed.to_double()) / size;
                                            }
                                        },
                                        driver));
    return fastest;
}

void expect_same_centres(const Solution& as_given, const Solution& turned, double tolerance) {
    const double size = as_given.pose.size.to_double();
    ASSERT_EQ(as_given.centres.size(), turned.centres.size());
    for (std::size_t i = 0; i < as_given.centres.size(); ++i) {
        const InstantCentre &a = as_given.centres[i], &b = turned.centres[i];
        SCOPED_TRACE("centre " + std::to_string(a.first.number()) + "," + std::to_string(a.second.number()));
        EXPECT_EQ(a.everywhere, b.everywhere);
        EXPECT_EQ(a.at.has_value(), b.at.has_value());
        if (!a.at || !b.at) continue;
        EXPECT_EQ(a.at->at_infinity(), b.at->at_infinity());
        if (a.at->at_infinity() || b.at->at_infinity()) continue;
        // A turn of a ray by δ moves the intersection by δ·d²/L at the distance d.
        const double distance = length(a.at->place() - as_given.pose.points.front()) / size;
        const double allowed = tolerance * size * std::max(1.0, distance * distance);
        const auto found = back(b.at->place());
        EXPECT_NEAR(a.at->place().x.to_double(), found[0], allowed);
        EXPECT_NEAR(a.at->place().y.to_double(), found[1], allowed);
    }
}

}  // namespace

Mechanism turned(const Mechanism& mechanism, const Pose& pose, int digits) {
    Mechanism now = mechanism;
    now.precision.reset();
    const Turner turner(digits);
    for (std::size_t i = 0; i < now.points.size(); ++i) {
        Vector place = pose.points[i];
        turner.turn(place, now.units.length.si);
        now.points[i].placement = Coordinates{place};
    }
    for (Joint& joint : now.joints) turner.turn(joint);
    for (Driver& driver : now.drivers)
        if (auto* point = std::get_if<PointDriver>(&driver)) turner.turn(point->along);
    if (now.gravity) turner.turn(*now.gravity, 1);
    for (Load& load : now.loads) {
        if (auto* distributed = std::get_if<DistributedLoad>(&load)) turner.turn(distributed->along);
        if (auto* force = std::get_if<ForceLoad>(&load)) {
            if (force->value) turner.turn(*force->value, now.units.force.si);
            if (force->magnitude) turner.turn(force->magnitude->second);
        }
    }
    for (Effort& effort : now.efforts)
        if (auto* force = std::get_if<ForceEffort>(&effort)) turner.turn(force->along);
    if (now.motion) {
        for (GivenMotion& given : now.motion->velocities) turner.turn(given, now.units.velocity.si);
        for (GivenMotion& given : now.motion->accelerations) turner.turn(given, now.units.acceleration.si);
    }
    return now;
}

Exact precision_of(const Mechanism& turned, int digits) {
    double largest = 0;
    for (const NamedPoint& point : turned.points) {
        const Vector& place = std::get<Coordinates>(point.placement).at;
        for (const Exact& each : {place.x, place.y})
            largest = std::max(largest, std::abs((each / turned.units.length.si).to_double()));
    }
    Exact half_digit = Exact::ratio(1, 2);
    const int exponent = static_cast<int>(std::floor(std::log10(largest))) + 1 - digits;
    for (int i = 0; i < std::abs(exponent); ++i) half_digit = exponent < 0 ? half_digit / 10 : half_digit * 10;
    return half_digit * turned.units.length.si;
}

void expect_same_but_turned(const Solution& as_given, const Solution& turned, double tolerance, bool amplified) {
    const Protocol* const shifted = amplified ? &turned.protocol : nullptr;
    EXPECT_EQ(as_given.mobility.gruebler, turned.mobility.gruebler);
    EXPECT_EQ(as_given.mobility.effective, turned.mobility.effective);
    EXPECT_EQ(as_given.mobility.driven, turned.mobility.driven);
    EXPECT_EQ(as_given.mobility.idle_drivers, turned.mobility.idle_drivers);
    EXPECT_EQ(as_given.mobility.determined, turned.mobility.determined);
    EXPECT_EQ(unsolved_of(as_given), unsolved_of(turned));
    EXPECT_EQ(verdicts_of(as_given), verdicts_of(turned));
    if (!amplified) {
        EXPECT_EQ(sentences_of(as_given), sentences_of(turned));
        expect_same_centres(as_given, turned, tolerance);
    }

    const double size = as_given.pose.size.to_double(), fastest = fastest_driver(as_given);
    Values spins(fastest), angular(fastest * fastest), velocities(fastest * size),
        accelerations(fastest * fastest * size), forces(0);
    for (std::size_t b = 1; b < as_given.bodies.size(); ++b) {
        const std::string name = as_given.mechanism.bodies[b].name;
        expect_known_alike("omega " + name, as_given.bodies[b].omega, turned.bodies[b].omega, shifted, spins);
        expect_known_alike("alpha " + name, as_given.bodies[b].alpha, turned.bodies[b].alpha, shifted, angular);
    }
    ASSERT_EQ(as_given.points.size(), turned.points.size());
    for (std::size_t i = 0; i < as_given.points.size(); ++i) {
        const PointMotion &a = as_given.points[i], &b = turned.points[i];
        expect_known_alike("v " + a.label, a.velocity, b.velocity, shifted, velocities);
        expect_known_alike("a " + a.label, a.acceleration, b.acceleration, shifted, accelerations);
    }
    ASSERT_EQ(as_given.forces.size(), turned.forces.size());
    for (std::size_t i = 0; i < as_given.forces.size(); ++i)
        expect_known_alike("force " + std::to_string(i), as_given.forces[i].force, turned.forces[i].force, shifted,
                           forces);
    for (const Values* each : {&spins, &angular, &velocities, &accelerations, &forces}) each->expect_near(tolerance);
}

double excess_over_drivers(const Solution& solution) {
    const double fastest = fastest_driver(solution), size = solution.pose.size.to_double();
    double largest = 0;
    for (const BodyMotion& body : solution.bodies)
        if (body.omega) largest = std::max(largest, std::abs(body.omega->to_double()));
    for (const PointMotion& point : solution.points)
        if (point.velocity) largest = std::max(largest, length(*point.velocity) / size);
    return fastest > 0 ? largest / fastest : 0;
}

}  // namespace kinegraph::tests
