// Every example: solved, in agreement with the check, with the laws of rigid bodies and of three centres, and with the
// closed form or the published numbers that examples/README.md names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <string>
#include <tuple>

#include "lang/keys/sentences.hpp"
#include "tests/support/near_the_check.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::examples_test {
namespace {

using tests::example;
using tests::example_names;
using tests::worst_difference;

using Complex = std::complex<double>;
constexpr Complex i{0, 1};
constexpr double degree = 3.14159265358979323846 / 180;

Complex complex(const Vector& v) { return {v.x.to_double(), v.y.to_double()}; }
double along(Complex v, Complex direction) { return (v * std::conj(direction)).real() / std::abs(direction); }

/// Reading a solution by the names of its file.
struct Reading {
    const Solution& solution;

    BodyIndex body(const char* name) const { return solution.mechanism.body_named(name).value(); }
    PointIndex point(const char* name) const { return solution.mechanism.point_named(name).value(); }
    const Vector& place(const char* name) const { return solution.pose.at(point(name)); }
    Complex at(const char* name) const { return complex(place(name)); }
    /// The point as the body carries it.
    const PointMotion& motion(const char* name, const char* carrier) const {
        for (const PointMotion& node : solution.points)
            if (node.point == point(name) && std::count(node.bodies.begin(), node.bodies.end(), body(carrier)) > 0)
                return node;
        throw std::out_of_range(std::string(name) + " on " + carrier + " has no motion");
    }
    const Vector& exact_v(const char* name, const char* carrier) const {
        return motion(name, carrier).velocity.value();
    }
    const Vector& exact_a(const char* name, const char* carrier) const {
        return motion(name, carrier).acceleration.value();
    }
    Complex v(const char* name, const char* carrier) const { return complex(exact_v(name, carrier)); }
    Complex a(const char* name, const char* carrier) const { return complex(exact_a(name, carrier)); }
    const Exact& exact_omega(const char* name) const { return solution.bodies.at(at_index(body(name))).omega.value(); }
    const Exact& exact_alpha(const char* name) const { return solution.bodies.at(at_index(body(name))).alpha.value(); }
    double omega(const char* name) const { return exact_omega(name).to_double(); }
    double alpha(const char* name) const { return exact_alpha(name).to_double(); }
    const ProjectivePoint& centre(const char* first, const char* second) const {
        for (const InstantCentre& c : solution.centres)
            if (c.first == body(first) && c.second == body(second)) return c.at.value();
        throw std::out_of_range(std::string("no centre ") + first + "," + second);
    }
    const Sliding& sliding(const char* joint) const {
        for (const Sliding& slide : solution.sliding)
            if (solution.mechanism.joints.at(at_index(slide.joint)).name == joint) return slide;
        throw std::out_of_range(std::string("nothing slides in ") + joint);
    }
};

/// Within 1e-12 of the larger of the two and of `scale`.
void expect_near(Complex actual, Complex expected, const char* what, double scale = 0) {
    const double size = std::max({std::abs(expected), std::abs(actual), scale});
    EXPECT_LE(std::abs(actual - expected), 1e-12 * size) << what << ": " << actual << " instead of " << expected;
}

// --- all of them
// -------------------------------------------------------------------------------------------------------------

TEST(Examples, AreAllSolved) {
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        // What has no answer, or several, has tests of its own.
        if (name == "slider_driven_dead_point" || name == "dead_point_rounded" ||
            name == "act_of_motion_projections_differ" || name == "change_point_parallelogram")
            continue;
        for (const Unsolved& unsolved : solution.unsolved) ADD_FAILURE() << name << ": " << english_of(unsolved);
        EXPECT_TRUE(solution.remarks.empty()) << name << ": " << english(solution.remarks.front());
        EXPECT_FALSE(solution.checks.empty()) << name;
        const Find& find = solution.mechanism.find;
        const std::size_t bodies = solution.mechanism.bodies.size();
        // Loads at rest ask for forces alone.
        const bool at_rest = solution.mechanism.drivers.empty() && !solution.mechanism.loads.empty();
        if (find.stated ? find.instant_centres : !at_rest) {
            EXPECT_EQ(solution.centres.size(), bodies * (bodies - 1) / 2) << name;
        }
        for (const InstantCentre& centre : solution.centres)
            EXPECT_TRUE(centre.at || centre.everywhere)
                << name << ": centre " << centre.first.number() << "," << centre.second.number();
        if (find.stated ? find.forces : !solution.mechanism.efforts.empty()) {
            EXPECT_FALSE(solution.forces.empty()) << name;
        }
        for (const JointForce& action : solution.forces) EXPECT_TRUE(action.force && action.couple) << name;
        for (const EffortValue& effort : solution.efforts) EXPECT_TRUE(effort.value) << name << ": " << effort.name;
        const std::map<std::string, int> freedoms{{"scara", 2},
                                                  {"beam", 0},
                                                  {"four_force_body", 0},
                                                  {"five_bar", 2},
                                                  {"slider_on_moving_guide", 3},
                                                  {"cantilever", 0},
                                                  {"gerber_beam", 0},
                                                  {"three_hinged_arch", 0},
                                                  {"plate_under_forces", 3},
                                                  {"truss_simple", 0},
                                                  {"truss_roof_wind", 0},
                                                  {"excavator_arm", 3}};
        const int free_body = solution.mechanism.motion ? 3 : 1;
        EXPECT_EQ(solution.mobility.gruebler, freedoms.count(name) > 0 ? freedoms.at(name) : free_body) << name;
        EXPECT_EQ(solution.mobility.effective, solution.mobility.gruebler) << name;
    }
}

TEST(Examples, AgreeWithTheCheckTo1e9) {
    for (const std::string& name : example_names()) EXPECT_LE(worst_difference(example(name)), 1e-9) << name;
}

TEST(Examples, BodiesAreRigid) {
    // (v_P − v_Q)·PQ = 0 (velocities project alike on their join) and (a_P − a_Q)·PQ = −|v_P − v_Q|²: exactly, since
    // the drawing is the truth, with or without a leftover.
    std::size_t compared = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        for (const BodyIndex body : solution.mechanism.moving_bodies()) {
            std::vector<const PointMotion*> carried;
            for (const PointMotion& node : solution.points)
                if (std::count(node.bodies.begin(), node.bodies.end(), body) > 0) carried.push_back(&node);
            for (const PointMotion* p : carried) {
                for (const PointMotion* q : carried) {
                    const Vector join = solution.pose.at(p->point) - solution.pose.at(q->point);
                    if (p->velocity && q->velocity) {
                        compared += p == q ? 0 : 1;
                        EXPECT_EQ(dot(*p->velocity - *q->velocity, join), Exact(0)) << name << body.number();
                    }
                    if (p->acceleration && q->acceleration) {
                        EXPECT_EQ(dot(*p->acceleration - *q->acceleration, join),
                                  -squared_length(*p->velocity - *q->velocity))
                            << name << body.number();
                    }
                }
            }
        }
    }
    EXPECT_GT(compared, example_names().size());
}

TEST(Examples, ThreeCentresLieOnALine) {
    std::size_t lines = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const auto centre = [&solution](BodyIndex a, BodyIndex b) -> const ProjectivePoint* {
            for (const InstantCentre& c : solution.centres)
                if (c.first == std::min(a, b) && c.second == std::max(a, b) && c.at) return &*c.at;
            return nullptr;
        };
        const Mechanism& mechanism = solution.mechanism;
        for (const BodyIndex a : indices_of(mechanism.bodies))
            for (const BodyIndex b : mechanism.bodies_after(a))
                for (const BodyIndex c : mechanism.bodies_after(b)) {
                    const auto *p = centre(a, b), *q = centre(b, c), *r = centre(a, c);
                    if (!p || !q || !r) continue;
                    ++lines;
                    const Exact determinant = p->x * (q->y * r->w - q->w * r->y) - p->y * (q->x * r->w - q->w * r->x) +
                                              p->w * (q->x * r->y - q->y * r->x);
                    if (solution.pose.exact) {
                        EXPECT_EQ(determinant, Exact(0)) << name << ": " << a.number() << b.number() << c.number();
                    } else {
                        EXPECT_LE(std::abs(determinant.to_double()), 1e-24)
                            << name << ": " << a.number() << b.number() << c.number();
                    }
                }
    }
    EXPECT_GT(lines, example_names().size());
}

// --- one by one
// --------------------------------------------------------------------------------------------------------------

TEST(Examples, FourBarHasTheCentresOfAronholdAndKennedy) {
    const Solution& solution = example("four_bar");
    const Reading read{solution};
    expect_near(read.omega("2"), -4 * 180 * degree, "-120 rpm");
    expect_near(std::abs(read.at("B") - read.at("A")), 0.15, "the coupler");
    expect_near(std::abs(read.at("B") - read.at("O4")), 0.08, "the rocker");
    EXPECT_GT(read.at("B").imag(), 0) << "left of A → O4";
    // v_A = ω₃ ∧ P₁₃A and v_B = ω₃ ∧ P₁₃B
    const Complex p13 = complex(read.centre("1", "3").place());
    ASSERT_EQ(read.centre("1", "3").w, Exact(1));
    expect_near(read.v("A", "3"), i * read.omega("3") * (read.at("A") - p13), "v_A about P13");
    expect_near(read.v("B", "3"), i * read.omega("3") * (read.at("B") - p13), "v_B about P13");
    // ω₄ / ω₂ = O₂P₂₄ / O₄P₂₄
    const Complex p24 = complex(read.centre("2", "4").place());
    expect_near(read.omega("4") / read.omega("2"), (p24 - read.at("O2")) / (p24 - read.at("O4")), "the ratio by P24");
}

/// c, dc/dα, d²c/dα² of the slider-crank whose guide passes e below the crank's centre.
struct SliderCrank {
    double c, first, second;
};
SliderCrank slider_crank(double a, double b, double e, double angle) {
    const double beta = std::asin(-(a * std::sin(angle) + e) / b);
    const double beta_1 = -a * std::cos(angle) / (b * std::cos(beta));
    const double beta_2 = (a * std::sin(angle) + b * std::sin(beta) * beta_1 * beta_1) / (b * std::cos(beta));
    return {a * std::cos(angle) + b * std::cos(beta), -a * std::sin(angle) - b * std::sin(beta) * beta_1,
            -a * std::cos(angle) - b * std::cos(beta) * beta_1 * beta_1 - b * std::sin(beta) * beta_2};
}

TEST(Examples, SliderCrankFollowsItsClosedForm) {
    const Solution& solution = example("slider_crank");
    const Reading read{solution};
    const double a = 0.05, b = 0.15, angle = 60 * degree, omega = 10, lambda = a / b;
    const SliderCrank closed = slider_crank(a, b, 0, angle);
    // The notes' own forms of c and Λ.
    EXPECT_NEAR(closed.c, a * std::cos(angle) + b * std::sqrt(1 - std::pow(lambda * std::sin(angle), 2)), 1e-15);
    const double beta = std::asin(-lambda * std::sin(angle));
    EXPECT_NEAR(closed.first, -a * (std::sin(angle) - std::cos(angle) * std::tan(beta)), 1e-15);
    expect_near(read.at("B"), closed.c, "c");
    expect_near(read.v("B", "4"), closed.first * omega, "v_B = Λ ω");
    expect_near(read.a("B", "4"), closed.second * omega * omega, "a_B");
    EXPECT_EQ(read.exact_v("B", "4").y, Exact(0)) << "the slider's point stays on its guide";
    expect_near(read.v("G", "3"), 0.6 * read.v("A", "3") + 0.4 * read.v("B", "3"), "v_G");
    expect_near(read.a("G", "3"), 0.6 * read.a("A", "3") + 0.4 * read.a("B", "3"), "a_G");
    EXPECT_TRUE(read.centre("1", "4").at_infinity());
    EXPECT_EQ(read.centre("1", "4").x, Exact(0)) << "⟂ to the guide";
    EXPECT_EQ(complex(read.sliding("B").velocity.value()), read.v("B", "4"));
}

TEST(Examples, OffsetSliderCrankFollowsItsClosedForm) {
    const Solution& solution = example("slider_crank_offset");
    const Reading read{solution};
    const SliderCrank closed = slider_crank(0.05, 0.15, 0.02, 60 * degree);
    expect_near(read.at("B"), Complex(closed.c, -0.02), "B");
    expect_near(read.v("B", "4"), closed.first * 10, "v_B");
    expect_near(read.a("B", "4"), closed.second * 100, "a_B");
}

TEST(Examples, AtItsDeadPointsTheSliderStandsStillExactly) {
    // a_B = −ω² a (1 + λ) outside, ω² a (1 − λ) inside; ω = 10 rad/s, a = 0.05 m, λ = 1/3.
    const Solution& outer = example("slider_crank_outer_dead_point");
    const Solution& inner = example("slider_crank_inner_dead_point");
    EXPECT_TRUE(outer.pose.exact);
    EXPECT_TRUE(inner.pose.exact);
    EXPECT_EQ(Reading{outer}.exact_v("B", "4"), Vector{});
    EXPECT_EQ(Reading{inner}.exact_v("B", "4"), Vector{});
    EXPECT_EQ(Reading{outer}.exact_a("B", "4"), (Vector{Exact::ratio(-20, 3), 0}));
    EXPECT_EQ(Reading{inner}.exact_a("B", "4"), (Vector{Exact::ratio(10, 3), 0}));
    EXPECT_EQ(Reading{outer}.exact_omega("3"), Exact::ratio(-10, 3)) << "−λ ω";
    EXPECT_EQ(Reading{inner}.exact_omega("3"), Exact::ratio(10, 3)) << "λ ω";
}

TEST(Examples, AFoldedParallelogramHasTwoBranches) {
    const Solution& solution = example("change_point_parallelogram");
    EXPECT_FALSE(solution.unsolved.empty()) << "the driver alone does not choose";
    ASSERT_TRUE(solution.instant_motion);
    ASSERT_EQ(solution.instant_motion->branches.size(), 2u);
    std::vector<Exact> ratios;
    for (const Branch& branch : solution.instant_motion->branches) ratios.push_back(branch.exact.at(3));
    std::sort(ratios.begin(), ratios.end());
    EXPECT_EQ(ratios, (std::vector<Exact>{Exact::ratio(-7, 3), 1}));
}

TEST(Examples, ASliderCannotDriveAtItsDeadPoint) {
    const Solution& solution = example("slider_driven_dead_point");
    ASSERT_FALSE(solution.unsolved.empty());
    for (const Unsolved& unsolved : solution.unsolved) {
        EXPECT_GT(english(unsolved.what).size(), 5u);
        EXPECT_GT(english(unsolved.why).size(), 10u) << english(unsolved.what);
    }
    const Reading read{solution};
    EXPECT_FALSE(solution.bodies.at(at_index(read.body("2"))).omega) << "no crank turns on an impossible drive";
    EXPECT_EQ(read.centre("2", "3").place(), read.place("A")) << "what could be found is there";
}

TEST(Examples, InstantaneousMotionsHaveTheirCentres) {
    const auto mm = [](int x, int y) { return Vector{Exact::ratio(x, 1000), Exact::ratio(y, 1000)}; };
    // v_A = 0.4, v_B = 0.2 upwards, 60 mm apart: as 2 to 1 from the centre, beyond B.
    const Solution& same = example("act_of_motion_parallel_same_sense");
    EXPECT_EQ(Reading{same}.centre("1", "2").place(), mm(120, 0));
    EXPECT_EQ(Reading{same}.exact_omega("2"), Exact::ratio(-10, 3));
    // 0.2 down and 0.25 up, 90 mm apart: as 4 to 5, between them.
    const Solution& opposite = example("act_of_motion_parallel_opposite");
    EXPECT_EQ(Reading{opposite}.centre("1", "2").place(), mm(40, 0));
    EXPECT_EQ(Reading{opposite}.exact_omega("2"), Exact(5));
    const Solution& translation = example("act_of_motion_translation");
    EXPECT_TRUE(Reading{translation}.centre("1", "2").at_infinity());
    EXPECT_EQ(Reading{translation}.exact_omega("2"), Exact(0));
    EXPECT_EQ(Reading{translation}.exact_v("D", "2"), (Vector{Exact::ratio(3, 10), Exact::ratio(3, 20)}));
    // v = ω ∧ CP for every point.
    const Solution& general = example("act_of_motion_general");
    const Reading read{general};
    for (const char* point : {"A", "B", "D", "E"})
        EXPECT_EQ(read.exact_v(point, "2"),
                  read.exact_omega("2") * quarter_turn(read.place(point) - read.centre("1", "2").place()));
    // ω = (0.4 − 0.1)/0.1; on AB a_B is a_A − ω²·AB = 0.5 − 0.9, at 120° its height is 0.4 tan 60°.
    const Solution& accelerations = example("act_of_motion_accelerations");
    EXPECT_EQ(Reading{accelerations}.exact_omega("2"), Exact(3));
    EXPECT_EQ(Reading{accelerations}.exact_a("B", "2").x, Exact::ratio(-2, 5));
    expect_near(Reading{accelerations}.alpha("2"), (0.4 * std::sqrt(3.0) + 0.3) / 0.1, "alpha");
}

TEST(Examples, VelocitiesThatNoRigidBodyHasAreRefused) {
    const Solution& solution = example("act_of_motion_projections_differ");
    ASSERT_FALSE(solution.unsolved.empty());
    const std::string why = english(solution.unsolved.front().why);
    EXPECT_NE(why.find("0.100 m/s"), std::string::npos) << why;
    EXPECT_NE(why.find("0.300 m/s"), std::string::npos) << why;
    EXPECT_FALSE(solution.bodies.at(1).omega);
}

/// A lever that pivots in `pivot` and is driven by A in its slot: what A's motion gives it.
struct SlottedLever {
    double omega, alpha;
    Complex v_rel, a_rel, coriolis;
};
SlottedLever slotted_lever(Complex pivot, Complex A, Complex v, Complex a) {
    const double r = std::abs(A - pivot);
    const Complex u = (A - pivot) / r;
    const double omega = along(v, i * u) / r;
    const double slide = along(v, u);
    return {omega, (along(a, i * u) - 2 * omega * slide) / r, slide * u, (along(a, u) + omega * omega * r) * u,
            2.0 * i * omega * slide * u};
}
void expect_slotted_lever(const Reading& read, const SlottedLever& closed, const char* lever, const char* joint) {
    expect_near(read.omega(lever), closed.omega, "omega of the lever");
    expect_near(read.alpha(lever), closed.alpha, "alpha of the lever");
    const Sliding& slide = read.sliding(joint);
    expect_near(complex(slide.velocity.value()), closed.v_rel, "sliding velocity");
    expect_near(complex(slide.acceleration.value()), closed.a_rel, "sliding acceleration");
    expect_near(complex(slide.coriolis.value()), closed.coriolis, "Coriolis");
    EXPECT_GT(std::abs(closed.coriolis), 0.01);
    // The point of body 3 and the point of the lever under it are two: a = a_transport + a_rel + a_Coriolis, exactly.
    EXPECT_EQ(read.exact_v(joint, "3"), read.exact_v(joint, lever) + *slide.velocity);
    EXPECT_EQ(read.exact_a(joint, "3"), read.exact_a(joint, lever) + *slide.acceleration + *slide.coriolis);
}
/// The ram D on a horizontal guide, hung on C by a link.
void expect_ram(const Reading& read, Complex v_C, Complex a_C) {
    const Complex w = read.at("D") - read.at("C");
    const double v = v_C.real() + w.imag() * v_C.imag() / w.real();
    const double a = a_C.real() + (w.imag() * a_C.imag() - std::norm(v - v_C)) / w.real();
    expect_near(read.v("C", "5"), v_C, "v_C");
    expect_near(read.a("C", "5"), a_C, "a_C");
    expect_near(read.v("D", "6"), v, "v_D");
    expect_near(read.a("D", "6"), a, "a_D");
}

TEST(Examples, InvertedSliderCrankFollowsItsClosedForm) {
    const Solution& solution = example("inverted_slider_crank");
    const Reading read{solution};
    const Complex A = 0.04 * std::polar(1.0, 60 * degree);
    expect_slotted_lever(read, slotted_lever(0.15, A, 6.0 * i * A, -36.0 * A), "4", "D");
    EXPECT_EQ(read.exact_omega("3"), read.exact_omega("4")) << "a sleeve lets no relative rotation";
    EXPECT_EQ(read.exact_alpha("3"), read.exact_alpha("4"));
}

TEST(Examples, QuickReturnFollowsItsClosedForm) {
    const Solution& solution = example("quick_return");
    const Reading read{solution};
    const Complex A = 0.06 * std::polar(1.0, 30 * degree), O4(0, -0.15);
    const SlottedLever lever = slotted_lever(O4, A, 5.0 * i * A, -25.0 * A);
    expect_slotted_lever(read, lever, "4", "A");
    const Complex C = 0.32 * (A - O4) / std::abs(A - O4);
    expect_ram(read, i * lever.omega * C, (i * lever.alpha - lever.omega * lever.omega) * C);
}

TEST(Examples, WhitworthFollowsItsClosedForm) {
    const Solution& solution = example("whitworth");
    const Reading read{solution};
    const Complex A = 0.1 * std::polar(1.0, 45 * degree), O4(0, -0.04);
    const SlottedLever lever = slotted_lever(O4, A, -4.0 * i * A, -16.0 * A);
    expect_slotted_lever(read, lever, "4", "A");
    const Complex C = -0.06 * (A - O4) / std::abs(A - O4);
    expect_ram(read, i * lever.omega * C, (i * lever.alpha - lever.omega * lever.omega) * C);
}

TEST(Examples, ScotchYokeIsHarmonic) {
    const Solution& solution = example("scotch_yoke");
    const Reading read{solution};
    const double a = 0.05, omega = 8, angle = 60 * degree;
    expect_near(read.at("F"), a * std::cos(angle), "x");
    expect_near(read.v("B", "4"), -a * omega * std::sin(angle), "v");
    expect_near(read.a("B", "4"), -a * omega * omega * std::cos(angle), "a");
    EXPECT_EQ(read.exact_omega("3"), Exact(0));
    EXPECT_EQ(read.exact_omega("4"), Exact(0));
    EXPECT_EQ(read.exact_alpha("4"), Exact(0));
}

TEST(Examples, ParallelCrankIsParallelExactly) {
    const Solution& solution = example("parallel_crank");
    const Reading read{solution};
    EXPECT_TRUE(solution.pose.exact);
    EXPECT_EQ(read.place("B"), (Vector{Exact::ratio(3, 20), Exact::ratio(1, 25)}));
    EXPECT_EQ(read.exact_omega("3"), Exact(0));
    EXPECT_EQ(read.exact_alpha("3"), Exact(0));
    EXPECT_EQ(read.exact_omega("4"), Exact(5));
    EXPECT_EQ(read.exact_alpha("4"), Exact(2));
    const ProjectivePoint& p13 = read.centre("1", "3");
    EXPECT_TRUE(p13.at_infinity());
    EXPECT_EQ(4 * p13.x, 3 * p13.y);
    const ProjectivePoint& p24 = read.centre("2", "4");
    EXPECT_TRUE(p24.at_infinity());
    EXPECT_EQ(p24.y, Exact(0));
    const Vector v{Exact::ratio(-1, 5), Exact::ratio(3, 20)};
    for (const char* point : {"A", "B", "C"}) EXPECT_EQ(read.exact_v(point, "3"), v) << point;
}

TEST(Examples, ScaraComposesItsMotionInBothFrames) {
    const Solution& solution = example("scara");
    const Reading read{solution};
    const double alpha_1 = 1.2, alpha_2 = 0.5, beta_1 = 0.8, beta_2 = -1;
    const Complex OA = 0.3 * std::polar(1.0, 30 * degree), AB = 0.25 * std::polar(1.0, 75 * degree), OB = OA + AB;
    expect_near(read.at("B"), OB, "B");
    const double sum_1 = alpha_1 + beta_1, sum_2 = alpha_2 + beta_2;
    const Complex v_B = i * alpha_1 * OB + i * beta_1 * AB;
    const Complex a_B = (i * alpha_2 - alpha_1 * alpha_1) * OA + (i * sum_2 - sum_1 * sum_1) * AB;
    expect_near(read.omega("3"), sum_1, "omega 3");
    expect_near(read.alpha("3"), sum_2, "alpha 3");
    expect_near(read.v("B", "3"), v_B, "v_B = α̇ ∧ OB + β̇ ∧ AB");
    expect_near(read.a("B", "3"), a_B, "a_B");

    ASSERT_EQ(solution.relative_motion.size(), 2U);
    const RelativeMotion& translating = solution.relative_motion[0];
    ASSERT_EQ(translating.query.translating_with, read.point("A"));
    expect_near(complex(translating.velocity.value()), v_B, "v_B");
    expect_near(complex(translating.transport_velocity.value()), i * alpha_1 * OA, "v_tr = v_A");
    expect_near(complex(translating.relative_velocity.value()), i * sum_1 * AB, "v_rel");
    expect_near(complex(translating.acceleration.value()), a_B, "a_B");
    expect_near(complex(translating.transport_acceleration.value()), (i * alpha_2 - alpha_1 * alpha_1) * OA,
                "a_tr = a_A");
    expect_near(complex(translating.relative_acceleration.value()), (i * sum_2 - sum_1 * sum_1) * AB, "a_rel");
    EXPECT_TRUE(translating.coriolis.value_or(Vector{}).is_zero()) << "a translating frame has no Coriolis term";

    const RelativeMotion& rotating = solution.relative_motion[1];
    ASSERT_EQ(rotating.query.observer, read.body("2"));
    ASSERT_EQ(rotating.query.translating_with, none);
    const Complex v_rel = i * beta_1 * AB;
    expect_near(complex(rotating.transport_velocity.value()), i * alpha_1 * OB, "v_tr");
    expect_near(complex(rotating.relative_velocity.value()), v_rel, "v_rel");
    expect_near(complex(rotating.transport_acceleration.value()), (i * alpha_2 - alpha_1 * alpha_1) * OB, "a_tr");
    expect_near(complex(rotating.relative_acceleration.value()), (i * beta_2 - beta_1 * beta_1) * AB, "a_rel");
    expect_near(complex(rotating.coriolis.value()), 2.0 * i * alpha_1 * v_rel, "2 α̇ ∧ v_rel");
    EXPECT_EQ(*rotating.transport_velocity + *rotating.relative_velocity, *rotating.velocity);
    EXPECT_EQ(*rotating.transport_acceleration + *rotating.relative_acceleration + *rotating.coriolis,
              *rotating.acceleration);
}

TEST(Examples, WattSixBarHasFifteenCentres) {
    const Solution& solution = example("watt_six_bar");
    const Reading read{solution};
    ASSERT_EQ(solution.centres.size(), 15U);
    // Every absolute centre carries its body: v_P = ω ∧ P₁ₖP.
    for (const auto& [body, point] : {std::pair{"3", "B"}, {"5", "D"}, {"5", "E"}, {"4", "C"}, {"6", "D"}}) {
        const ProjectivePoint& centre = read.centre("1", body);
        ASSERT_FALSE(centre.at_infinity());
        expect_near(read.v(point, body), i * read.omega(body) * (read.at(point) - complex(centre.place())), point);
    }
}

TEST(Examples, ExamOf2001MovesAsTheNotesSay) {
    const Solution& solution = example("exam_2001");
    const Reading read{solution};
    EXPECT_EQ(read.exact_omega("4"), Exact(0)) << "v_B and v_C are parallel";
    EXPECT_EQ(read.exact_omega("2"), Exact(0));
    EXPECT_EQ(read.exact_v("B", "4"), read.exact_v("C", "4"));
    EXPECT_EQ(read.exact_v("B", "4"), read.exact_v("A", "4")) << "the transport velocity at A";
    EXPECT_EQ(read.exact_v("B", "3").y, Exact(0));
    // Printed to three figures, read off a drawing: 1 %. Then what this geometry gives.
    const auto both = [](double found, double notes, double geometry, const char* what) {
        EXPECT_NEAR(found, notes, 0.01 * std::abs(notes)) << what << " of the notes";
        EXPECT_NEAR(found, geometry, 5e-7 * std::max(1.0, std::abs(geometry))) << what;
    };
    both(std::abs(read.v("A", "1")), 0.318, 0.318, "v_A");
    both(-read.v("B", "3").real(), 0.55, 0.550792, "v_B, towards −x");
    both(std::abs(complex(read.sliding("D").velocity.value())), 0.64, 0.636, "sliding");
    both(read.omega("3"), 3.67, 3.671948, "omega 3");
    both(read.a("A", "1").real(), 0.318, 0.318, "a_A");
    both(read.omega("3") * read.omega("3") * 0.15, 2.02, 2.022480, "normal acceleration of B");
    both(read.alpha("4"), -3.12, -3.113812, "alpha 4");
    both(read.alpha("3"), 2.00, 2.000, "alpha 3");
    both(read.a("C", "5").real(), -1.46, -1.467679, "a_C");
    EXPECT_EQ(read.exact_a("C", "5"), read.exact_a("M", "5")) << "the slider translates";
}

TEST(Examples, ExamOf2001IsDrawnInTheOrderOfTheNotes) {
    // ω₄ from two parallel directions, then the polygon at A: in velocities and in accelerations.
    const Solution& solution = example("exam_2001");
    const auto first = [&solution](Key sentence) {
        for (std::size_t s = 0; s < solution.protocol.statements.size(); ++s)
            if (solution.protocol.statements[s].message.sentence == sentence) return static_cast<int>(s);
        return -1;
    };
    const auto image_of_a = [&solution](Topic section) {
        for (std::size_t s = 0; s < solution.protocol.statements.size(); ++s) {
            const Statement& statement = solution.protocol.statements[s];
            if (statement.section != section || !statement.equation) continue;
            for (const auto& side : statement.equation->sides)
                for (const Term& term : side)
                    if (name_of(term.symbol).find("AA*") != std::string::npos) return static_cast<int>(s);
        }
        return -1;
    };
    EXPECT_GE(first(lang::sentences::omega_from_parallels), 0);
    EXPECT_LT(first(lang::sentences::omega_from_parallels), image_of_a(Topic::velocity));
    EXPECT_LT(first(lang::sentences::omega_from_parallels), first(lang::sentences::alpha_from_parallels));
    EXPECT_LT(first(lang::sentences::alpha_from_parallels), image_of_a(Topic::acceleration));
}

TEST(Examples, PeaucelliersPointMovesAlongItsLineExactly) {
    const Solution& solution = example("peaucellier");
    const Reading read{solution};
    ASSERT_TRUE(solution.pose.exact);
    const Vector OP = read.place("P") - read.place("O"), OR = read.place("R") - read.place("O");
    const Vector OQ = read.place("Q") - read.place("O");
    EXPECT_EQ(cross(OP, OR), Exact(0)) << "O, P, R are on one line";
    EXPECT_EQ(squared_length(OP - OQ), squared_length(OQ)) << "the crank is as long as the frame";
    EXPECT_EQ(dot(read.exact_v("R", "7"), OQ), Exact(0)) << "v_R ⟂ OQ";
    EXPECT_EQ(dot(read.exact_a("R", "7"), OQ), Exact(0)) << "a_R ⟂ OQ";
    // With θ the crank's angle at Q, the ray OP has θ/2 and R the height x_R tan(θ/2) over O.
    const double half = std::atan2(OP.y.to_double(), OP.x.to_double()), x = OR.x.to_double(), rate = 2.0 / 2,
                 growth = 1.0 / 2;
    const double secant = 1 / (std::cos(half) * std::cos(half));
    expect_near(read.v("R", "7"), i * x * secant * rate, "v_R");
    expect_near(read.a("R", "7"), i * x * secant * (growth + 2 * std::tan(half) * rate * rate), "a_R");
    EXPECT_TRUE(read.centre("6", "7").at_infinity()) << "opposite sides of a rhombus translate against each other";
}

TEST(Examples, OldhamsDiscTurnsAsTheShaftsAndItsMiddleCirclesTwiceAsFast) {
    const Solution& solution = example("oldham_coupling");
    const Reading read{solution};
    for (const char* body : {"3", "4"}) {
        EXPECT_EQ(read.exact_omega(body), Exact(10)) << body;
        EXPECT_EQ(read.exact_alpha(body), Exact(0)) << body;
    }
    const Vector middle = Exact::ratio(1, 2) * (read.place("O2") + read.place("O4"));
    const Vector radius = read.place("M") - middle;
    EXPECT_EQ(4 * squared_length(radius), squared_length(read.place("O4") - read.place("O2"))) << "Thales";
    EXPECT_EQ(read.exact_v("M", "3"), 20 * quarter_turn(radius));
    EXPECT_EQ(read.exact_a("M", "3"), -400 * radius);
}

TEST(Examples, ScissorLiftTradesForceForPathExactly) {
    const Solution& solution = example("scissor_lift");
    const Reading read{solution};
    EXPECT_EQ(read.exact_omega("4"), Exact(0)) << "the platform stays level";
    EXPECT_EQ(read.exact_omega("2"), -read.exact_omega("3"));
    const Vector& v = read.exact_v("G", "4");
    EXPECT_EQ(v.x, Exact(0));
    // Arm of length l at θ from the horizontal: height l sin θ, so v = l cos θ ω.
    EXPECT_EQ(v.y, Exact::ratio(8, 5) * read.exact_omega("2"));
    EXPECT_NEAR(solution.efforts.front().value->to_double() * 0.05, 3000 * v.y.to_double(), 1e-9);
}

TEST(Examples, RadialEngineHasThreeSliderCranks) {
    const Solution& solution = example("radial_engine");
    const Reading read{solution};
    const double omega = -1500 * 2 * 180 * degree / 60;
    // The master's piston is a centred slider-crank, its guide at 90°: the crank stands at 40° − 90° from it.
    const SliderCrank closed = slider_crank(0.06, 0.17, 0, -50 * degree);
    expect_near(read.at("B"), i * closed.c, "B");
    expect_near(read.v("B", "4"), i * closed.first * omega, "v_B");
    expect_near(read.a("B", "4"), i * closed.second * omega * omega, "a_B");
    for (const auto& [piston, pin, degrees] : {std::tuple{"6", "E", 210}, {"8", "F", 330}}) {
        const Complex guide = std::polar(1.0, degrees * degree);
        expect_near(along(read.v(pin, piston), i * guide), 0, pin, 1);
        expect_near(along(read.a(pin, piston), i * guide), 0, pin, 1000);
    }
}

TEST(Examples, SliderOnAMovingGuideComposesThreeMotions) {
    const Solution& solution = example("slider_on_moving_guide");
    const Reading read{solution};
    const Complex u = std::polar(1.0, 50 * degree), AP = 0.09 * u;
    expect_near(read.v("P", "4"), 0.4 + 3.0 * i * AP + 0.2 * u, "v_P");
    expect_near(read.a("P", "4"), -1.0 + (2.0 * i - 9.0) * AP + 0.5 * u + 2 * 3.0 * i * 0.2 * u, "a_P");
    expect_near(complex(read.sliding("P").coriolis.value()), 1.2 * i * u, "Coriolis");
    ASSERT_EQ(solution.relative_motion.size(), 1U);
    EXPECT_EQ(*solution.relative_motion[0].relative_velocity, *read.sliding("P").velocity);
    EXPECT_EQ(*solution.relative_motion[0].coriolis, *read.sliding("P").coriolis);
}

TEST(Examples, FiveBarMovesWithBothItsCranks) {
    const Solution& solution = example("five_bar");
    const Reading read{solution};
    // v_B from its projections on the two couplers, a_B likewise with the normal parts.
    const Complex p = read.at("B") - read.at("A"), q = read.at("B") - read.at("C");
    const Complex A = read.at("A"), C = read.at("C") - read.at("O5");
    const auto from = [&](double on_p, double on_q) {
        const double determinant = p.real() * q.imag() - p.imag() * q.real();
        return Complex(on_p * q.imag() - on_q * p.imag(), on_q * p.real() - on_p * q.real()) / determinant;
    };
    const auto dot_of = [](Complex a, Complex b) { return (a * std::conj(b)).real(); };
    const Complex v_A = 3.0 * i * A, v_C = -2.0 * i * C;
    const Complex v_B = from(dot_of(v_A, p), dot_of(v_C, q));
    expect_near(read.v("B", "3"), v_B, "v_B");
    const Complex a_A = -9.0 * A, a_C = (4.0 * i - 4.0) * C;
    expect_near(read.a("B", "3"), from(dot_of(a_A, p) - std::norm(v_B - v_A), dot_of(a_C, q) - std::norm(v_B - v_C)),
                "a_B");
    for (const InstantCentre& centre : solution.centres) {
        if (centre.first == read.body("1") && centre.second == read.body("3")) {
            EXPECT_TRUE(centre.depends_on_drivers) << "another ratio of the cranks has another centre";
        }
    }
}

TEST(Examples, EllipticTrammelDrawsItsEllipseExactly) {
    // x_A = 0.12, y_B = 0.09, ẋ_A = 0.3: ẏ_B = −x_A ẋ_A / y_B = −0.4, ÿ_B = −(ẋ_A² + ẏ_B²) / y_B = −25/9; P a third of
    // the way.
    const Solution& solution = example("elliptic_trammel");
    const Reading read{solution};
    EXPECT_TRUE(solution.pose.exact);
    EXPECT_EQ(read.place("B"), (Vector{0, Exact::ratio(9, 100)}));
    EXPECT_EQ(read.exact_v("B", "4"), (Vector{0, Exact::ratio(-2, 5)}));
    EXPECT_EQ(read.exact_a("B", "4"), (Vector{0, Exact::ratio(-25, 9)}));
    EXPECT_EQ(read.exact_v("P", "3"), (Vector{Exact::ratio(1, 5), Exact::ratio(-2, 15)}));
    EXPECT_EQ(read.exact_a("P", "3"), (Vector{0, Exact::ratio(-25, 27)}));
    const Vector& P = read.place("P");
    const Vector& v = read.exact_v("P", "3");
    EXPECT_EQ(square(10 * P.x) + square(20 * P.y), Exact(1)) << "P is on the ellipse";
    EXPECT_EQ(100 * P.x * v.x + 400 * P.y * v.y, Exact(0)) << "and moves along it";
    const Vector& M = read.place("M");
    EXPECT_EQ(dot(M, read.exact_v("M", "3")), Exact(0)) << "M moves on a circle";
    EXPECT_EQ(read.centre("1", "3").place(), (Vector{Exact::ratio(3, 25), Exact::ratio(9, 100)}));
}

TEST(Examples, WheelsRollAndGearsMesh) {
    {
        const Solution& solution = example("disc_on_line");
        const Reading read{solution};
        expect_near(read.v("C", "2"), 0.6, "v_C = ω r");
        expect_near(read.a("C", "2"), -0.8, "a_C = ω̇ r");
        expect_near(read.a("P", "2"), 9 * 0.2 * i, "a_P = ω² r");
        expect_near(read.v("A", "2"), -3.0 * i * (read.at("A") - read.at("P")), "v_A = ω · PA");
    }
    {
        const Solution& solution = example("disc_in_ring");
        const Reading read{solution};
        const Complex inwards = -std::polar(1.0, -60 * degree);
        expect_near(read.a("P", "2"), 16 * 0.3 * 0.1 / 0.2 * inwards, "a_P = ω² r₁r₂/(r₁ − r₂)");
        expect_near(read.a("C", "2"), 0.16 / 0.2 * inwards, "a_C = v²/(r₁ − r₂)");
    }
    {
        const Solution& solution = example("board_on_rollers");
        const Reading read{solution};
        for (const char* roller : {"2", "3"}) EXPECT_EQ(read.exact_omega(roller), Exact(-2));
        EXPECT_EQ(2 * read.exact_v("C", "2"), read.exact_v("G", "4"));
        EXPECT_EQ(2 * read.exact_a("D", "3"), read.exact_a("G", "4"));
    }
    {
        const Solution& solution = example("rack_and_pinion");
        const Reading read{solution};
        EXPECT_EQ(read.exact_v("G", "3"), (Vector{Exact::ratio(6, 25), 0}));
        EXPECT_EQ(read.exact_a("G", "3"), (Vector{Exact::ratio(-2, 5), 0}));
    }
    {
        const Solution& solution = example("planetary_train");
        const Reading read{solution};
        expect_near(read.omega("4"), 3, "ω₄ = ω₂ r₂/(r₂ + r₁)");
        expect_near(read.omega("3"), -7.5, "ω₃ = −ω₄ (r₁ − r₃)/r₃");
        for (const char* body : {"2", "3", "4"}) expect_near(read.alpha(body), 0, body, 100);
    }
    {
        const Solution& solution = example("geneva_wheel");
        const Reading read{solution};
        const double omega = -60 * 12 * degree / 2, r = 0.05, d = 0.070710678118654752, theta = 20 * degree;
        const double square = r * r + d * d - 2 * r * d * std::cos(theta);
        expect_near(read.omega("3"), -omega * r * (d * std::cos(theta) - r) / square, "ω₃");
        expect_near(read.alpha("3"), omega * omega * r * d * (d * d - r * r) * std::sin(theta) / (square * square),
                    "ω̇₃");
    }
}

TEST(Examples, ACouplerCurveHasItsCurvature) {
    // By complex numbers, derivatives to 40 digits (mm).
    const Solution& solution = example("coupler_curve");
    const Reading read{solution};
    int bodies = 0, points = 0;
    for (const Curvature& found : solution.curvature) {
        if (found.body != read.body("3")) continue;
        ++bodies;
        const Complex pole{24.0422967481174e-3, 41.6424794983874e-3}, j{92.77785413084e-3, 124.226682900265e-3},
            k{106.346741343906e-3, 107.188610493988e-3}, centre{-4.59553518914483e-3, 34.1795996190784e-3};
        expect_near(complex(found.pole->place()), pole, "P");
        expect_near(complex(*found.inflection_pole), j, "J");
        expect_near(complex(*found.acceleration_pole), k, "K");
        expect_near(length(*found.inflection_pole - found.pole->place()), 107.446393612053e-3, "δ");
        for (const PathCentre& path : found.points) {
            if (path.label != "C") continue;
            ++points;
            expect_near(complex(path.centre->place()), centre, "C₀");
            expect_near(length(path.centre->place() - read.place("C")), 15.1669118135684e-3, "ρ");
        }
    }
    EXPECT_GT(bodies, 0);
    EXPECT_GT(points, 0);
}

TEST(Examples, CamFollowersMoveByTheirClosedForms) {
    // s(θ) = e sin θ + √(l² − (e cos θ − x)²) over the cam's centre at rest; for the flat face the root is r.
    const double e = 0.02, theta = 40 * degree, omega = 10;
    const double sine = e * std::sin(theta), cosine = e * std::cos(theta);
    for (const auto& [name, rod, beside] : {std::tuple("cam_flat_follower", 0.0, 0.0),
                                            {"cam_roller_follower", 0.055, 0.0},
                                            {"cam_knife_edge", 0.04, 0.01}}) {
        const Solution& solution = example(name);
        const Reading read{solution};
        double first = cosine, second = -sine;
        if (rod > 0) {
            const double across = cosine - beside, root = std::sqrt(rod * rod - across * across);
            const double slope = across * sine / root;  // d√/dθ
            first += slope;
            second += (across * cosine - sine * sine - slope * slope) / root;
        }
        expect_near(read.v("H", "3"), omega * first * i, name);
        expect_near(read.a("H", "3"), omega * omega * second * i, name);
    }
}

}  // namespace
}  // namespace kinegraph::examples_test
