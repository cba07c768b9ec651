#include "constructions/verdicts/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "engine/board/replay.hpp"
#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/number/geometry.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

constexpr double nearly = 1e-3;

/// A direction of the drawing in terms of the file: the join of two points, or a joint's guide or normal; perhaps
/// turned.
struct NamedDirection {
    LineReason reason;
    PointIndex from, to;  ///< of a join
    bool is_turned = false;
};

/// Coincidences that were tested and are nearly true.
class NearMisses {
public:
    explicit NearMisses(const Solution& solution)
        : mechanism_(solution.mechanism),
          protocol_(solution.protocol),
          program_(protocol_.program),
          pose_(solution.pose) {}

    std::vector<Message> told() {
        for (const Guard& guard : program_.guards) {
            if (guard.verdict != 0) continue;
            if (guard.question == Guard::Question::parallel) look_at_directions(guard.inputs[0], guard.inputs[1]);
            if (guard.question == Guard::Question::coincide) look_at_points(guard.inputs[0], guard.inputs[1]);
        }
        return std::move(messages_);
    }

private:
    const Stroke& stroke(ElementIndex element) const { return program_.strokes[at_index(element)]; }
    const Given* given(ElementIndex element) const {
        const int index = stroke(element).given;
        return index < 0 ? nullptr : &program_.givens[at_index(index)];
    }
    PointIndex given_point(ElementIndex element) const {
        const Given* found = given(element);
        return found != nullptr && found->kind == Given::Kind::place ? PointIndex(found->index) : PointIndex(none);
    }
    const std::string& name(PointIndex point) const { return mechanism_.points[at_index(point)].name; }

    std::optional<NamedDirection> direction(ElementIndex element) const {
        const Stroke& made = stroke(element);
        const ElementIndex a = made.inputs[0], b = made.inputs[1];
        switch (made.verb) {
            case Verb::perpendicular:
            case Verb::turn: {
                auto found = direction(a);
                if (found) found->is_turned = !found->is_turned;
                return found;
            }
            case Verb::negate:
            case Verb::direction_of_line: return direction(a);
            case Verb::through: return direction(b);
            case Verb::join:
            case Verb::vector_between: return between(given_point(a), given_point(b));
            case Verb::given_vector: return of_joint(*given(element));
            default: return std::nullopt;
        }
    }
    std::optional<NamedDirection> between(PointIndex from, PointIndex to) const {
        if (from == none || to == none) return std::nullopt;
        return NamedDirection{{LineReason::Kind::parallel_to_segment, name(from), name(to)}, from, to, false};
    }
    std::optional<NamedDirection> of_joint(const Given& given) const {
        using Kind = Given::Kind;
        if (given.kind != Kind::guide && given.kind != Kind::guide_unit && given.kind != Kind::normal)
            return std::nullopt;
        const bool guide = given.kind != Kind::normal;
        return NamedDirection{{guide ? LineReason::Kind::parallel_to_guide : LineReason::Kind::parallel_to_normal,
                               mechanism_.joints[at_index(given.index)].name, ""},
                              none,
                              none,
                              false};
    }

    /// Several elements of the record may be the same two lines.
    bool is_new(const LineReason& one, const LineReason& other) {
        const std::pair pair(one, other);
        const bool is_told = std::find(parallels_said_.begin(), parallels_said_.end(), pair) != parallels_said_.end();
        if (!is_told) parallels_said_.push_back(pair);
        return !is_told;
    }

    Amount length_said(double metres) const {
        const Unit& unit = mechanism_.units.length;
        return {metres / unit.si.to_double(), unit.symbol};
    }

    void look_at_directions(ElementIndex first, ElementIndex second) {
        const Vector d = direction_in(Memory{protocol_}, first), e = direction_in(Memory{protocol_}, second);
        if (are_clearly_apart(d, e)) return;
        auto one = direction(first), other = direction(second);
        if (!one || !other) return;
        const double sine = std::abs(cross(d, e).to_double()) / (kinegraph::length(d) * kinegraph::length(e));
        if (!(sine < nearly)) return;
        if (one->is_turned == other->is_turned && share_a_point(*one, *other)) return tell_of_line(*one, *other);
        if (one->is_turned != other->is_turned)
            for (NamedDirection* each : {&*one, &*other})
                if (each->is_turned && !turn(each->reason)) return;
        if (!is_new(one->reason, other->reason)) return;
        messages_.push_back({lang::sentences::nearly_parallel,
                             {one->reason, other->reason, Amount{nearest::asin(sine) * 180 / std::numbers::pi, "°"}}});
    }
    /// Most are; doubles decide with a wide margin for rounding.
    static bool are_clearly_apart(const Vector& d, const Vector& e) {
        const VectorOf<double> first{d.x.to_double(), d.y.to_double()}, second{e.x.to_double(), e.y.to_double()};
        return std::abs(cross(first, second)) >
               2 * nearly * nearest::hypot(first.x, first.y) * nearest::hypot(second.x, second.y);
    }
    static bool share_a_point(const NamedDirection& one, const NamedDirection& other) {
        if (one.from == none || other.from == none) return false;
        return one.from == other.from || one.from == other.to || one.to == other.from || one.to == other.to;
    }
    static bool turn(LineReason& reason) {
        using Kind = LineReason::Kind;
        if (reason.kind == Kind::parallel_to_segment) return reason.kind = Kind::perpendicular_to_segment, true;
        if (reason.kind == Kind::parallel_to_guide) return reason.kind = Kind::perpendicular_to_guide, true;
        return false;
    }
    /// Of three nearly collinear points: the one between the others, else the one nearest to the line of the others.
    void tell_of_line(const NamedDirection& one, const NamedDirection& other) {
        std::set<PointIndex> three{one.from, one.to, other.from, other.to};
        if (three.size() != 3) return;
        std::array<PointIndex, 3> points{};
        std::copy(three.begin(), three.end(), points.begin());
        const auto apart = [&](std::size_t i, std::size_t j) {
            return distance(pose_.at(points[i]), pose_.at(points[j]));
        };
        std::size_t middle = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (apart((i + 1) % 3, (i + 2) % 3) > apart((middle + 1) % 3, (middle + 2) % 3)) middle = i;
        const PointIndex p = points[middle], from = points[(middle + 1) % 3], to = points[(middle + 2) % 3];
        const ProjectiveLine line = finite_join(point_at(pose_.at(from)), point_at(pose_.at(to)));
        const double off = distance(pose_.at(p), line);
        if (!lines_said_.insert({p, from}).second) return;
        messages_.push_back(
            {lang::sentences::nearly_on_line, {PointName{name(p)}, Segment{name(from), name(to)}, length_said(off)}});
    }

    void look_at_points(ElementIndex first, ElementIndex second) {
        const PointIndex p = given_point(first), q = given_point(second);
        if (p == none || q == none) return;
        const double apart = distance(pose_.at(p), pose_.at(q));
        if (!(apart < nearly * pose_.size.to_double()) || !said_.insert({first, second}).second) return;
        messages_.push_back(
            {lang::sentences::nearly_coincident, {PointName{name(p)}, PointName{name(q)}, length_said(apart)}});
    }

    /// For direction_in().
    struct Memory {
        using Number [[maybe_unused]] = Exact;
        const Protocol& protocol;
        const ProjectiveLine& line(ElementIndex i) const { return protocol.line(i); }
        const Vector& vector(ElementIndex i) const { return protocol.vector(i); }
        bool is_line(ElementIndex i) const {
            return std::holds_alternative<ProjectiveLine>(protocol.values[at_index(i)]);
        }
    };

    const Mechanism& mechanism_;
    const Protocol& protocol_;
    const Program& program_;
    const Pose& pose_;
    std::set<std::pair<ElementIndex, ElementIndex>> said_;
    std::set<std::pair<PointIndex, PointIndex>> lines_said_;
    std::vector<std::pair<LineReason, LineReason>> parallels_said_;
    std::vector<Message> messages_;
};

/// Sensitivity of angular velocities to moving a given point, by replaying in doubles the part of the record that leads
/// to them.
class Sensitivity {
public:
    explicit Sensitivity(const Solution& solution)
        : solution_(solution),
          turning_(bodies_that_turn(solution)),
          part_(part_that_leads_to(turning_, solution)),
          givens_(givens_of(part_.program, solution.mechanism, solution.pose)),
          replay_(part_.program, givens_, solution.pose.size.to_double()) {}

    /// The worst of all bodies and points, if it is ill-conditioned.
    std::optional<Message> worst() {
        if (turning_.empty() || replay_.run()) return std::nullopt;
        std::vector<double> before;
        for (const BodyIndex body : turning_) before.push_back(omega_of(body));
        const double size = solution_.pose.size.to_double();
        Change worst;
        for (std::size_t given = 0; given < givens_.size(); ++given) {
            const Given& moving = part_.program.givens[given];
            if (moving.kind != Given::Kind::place) continue;
            for (const int axis : {0, 1}) {
                auto moved = std::get<PointOf<double>>(to_double(givens_[given]));
                // Far above the rounding error of doubles, and small enough to neglect curvature.
                const double step = 1e-7 * size;
                (axis == 0 ? moved.x : moved.y) += step;
                replay_.give(static_cast<int>(given), moved);
                const bool holds = !replay_.run();
                for (std::size_t i = 0; i < turning_.size() && holds; ++i) {
                    const double share = std::abs(omega_of(turning_[i]) / before[i] - 1) * size / step;
                    if (std::isfinite(share) && share > worst.share)
                        worst = {share, turning_[i], PointIndex(moving.index)};
                }
            }
            replay_.give(static_cast<int>(given), to_double(givens_[given]));
        }
        constexpr double a_tenth = 0.1, move = 1e-4;
        if (!(worst.share * move >= a_tenth)) return std::nullopt;
        // Six digits are printed: with data of more digits the change is not seen in any of them.
        constexpr double least_seen = 5e-7;
        const double digit = last_digit(worst.point, move * size);
        if (worst.share * digit / size < least_seen) return std::nullopt;
        return said(worst, digit);
    }

private:
    struct Change {
        double share = 0;  ///< relative, for a move by the drawing's size
        BodyIndex body;
        PointIndex point;
    };
    static std::vector<BodyIndex> bodies_that_turn(const Solution& solution) {
        std::vector<BodyIndex> turning;
        for (const BodyIndex body : indices<BodyIndex>(solution.bodies.size(), frame.next())) {
            const auto& omega = solution.bodies[at_index(body)].omega;
            if (omega && omega.element() != none && !omega->is_zero()) turning.push_back(body);
        }
        return turning;
    }
    static Cut part_that_leads_to(const std::vector<BodyIndex>& turning, const Solution& solution) {
        std::vector<ElementIndex> wanted;
        std::size_t settled = 0;
        for (const BodyIndex body : turning) {
            wanted.push_back(solution.bodies[at_index(body)].omega.element());
            settled = std::max(settled, at_index(wanted.back()) + 1);
        }
        return cut(solution.protocol.program, wanted, static_cast<int>(settled));
    }
    double omega_of(BodyIndex body) const {
        return replay_.scalar(part_.element[at_index(solution_.bodies[at_index(body)].omega.element())]);
    }
    /// The precision stated in the file, else one unit of the point's last written digit, at most `most` (m).
    double last_digit(PointIndex point, double most) const {
        const Pose& pose = solution_.pose;
        if (!pose.precision.is_zero()) return pose.precision.to_double();
        const auto* given = std::get_if<Coordinates>(&solution_.mechanism.points[at_index(point)].placement);
        if (given == nullptr) return most;
        Exact digit = solution_.mechanism.units.length.si;
        const auto is_written_to = [&](const Exact& value) { return (value / digit).rational().get_den() == 1; };
        constexpr int digits = 20;
        for (int i = 0; i < digits && !(is_written_to(given->at.x) && is_written_to(given->at.y)); ++i) digit /= 10;
        return std::min(most, digit.to_double());
    }
    Message said(const Change& worst, double move) const {
        const Mechanism& mechanism = solution_.mechanism;
        const Unit& unit = mechanism.units.length;
        constexpr int percent = 100;
        return {
            lang::sentences::is_ill_conditioned,
            {Symbol{Symbol::Letter::omega, mechanism.bodies[at_index(worst.body)].name, ""},
             Amount{percent * worst.share * move / solution_.pose.size.to_double(), "%"},
             PointName{mechanism.points[at_index(worst.point)].name}, Amount{move / unit.si.to_double(), unit.symbol}}};
    }

    const Solution& solution_;
    std::vector<BodyIndex> turning_;
    Cut part_;
    std::vector<Value> givens_;
    Replay replay_;
};

}  // namespace

std::vector<Message> remarks_on_ill_conditioning(const Solution& solution) {
    std::vector<Message> remarks;
    for (const JointIndex joint : nearly_redundant_joints(solution.mechanism, solution.pose, solution.mobility))
        remarks.push_back(
            {lang::sentences::nearly_repeated, {PointName{solution.mechanism.joints[at_index(joint)].name}}});
    for (Message& remark : NearMisses(solution).told()) remarks.push_back(std::move(remark));
    if (auto remark = Sensitivity(solution).worst()) remarks.push_back(*std::move(remark));
    return remarks;
}

}  // namespace kinegraph
