#include "engine/motion/closure.hpp"
#include "lang/keys/positions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kinegraph {
namespace {

using Row = Closure::Row;

/// Of length about 1, in exactly the same direction: rows of similar size have comparable pivots.
Vector about_unit(const Vector& direction) { return Exact::from_double(1 / length(direction)) * direction; }

class Writer {
public:
    Writer(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism), pose_(pose) {
        closure_.bits = pose.bits;
        closure_.unit = Exact::power_of_two(std::ilogb(pose.size.to_double()));
        choose_origin();
        closure_.bodies.resize(mechanism.bodies.size());
    }

    Result<Closure> write() {
        choose_references();
        for (const Joint& joint : mechanism_.joints) write(joint);
        for (const Driver& driver : mechanism_.drivers) {
            const std::size_t first = closure_.rows.size();
            std::visit([&](const auto& given) { drive(given); }, driver);
            for (std::size_t i = first; i < closure_.rows.size(); ++i)
                closure_.rows[i].driver = static_cast<int>(&driver - mechanism_.drivers.data());
        }
        if (!errors_.empty()) return tl::unexpected(std::move(errors_));
        return std::move(closure_);
    }

private:
    void choose_origin() {
        constexpr int far = 1 << 10;  // sizes of the drawing; doubles have ten bits less there
        for (const Joint& joint : mechanism_.joints) {
            const Vector& place = pose_.at(joint.point);
            if (abs(place.x) + abs(place.y) > far * pose_.size) closure_.origin = place;
            return;
        }
    }
    Vector at(PointIndex point) const { return closure_.seen(pose_.at(point)); }
    Vector from_reference(BodyIndex body, const Vector& place) const {
        return place - closure_.bodies[at_index(body)].reference;
    }

    /// A hinge on the frame fixes a body's reference: its place is known, and the rows of the hinge are not needed.
    /// Other bodies have their reference at a hinge if there is one, so that a free rotation about it is a single
    /// column.
    void choose_references() {
        std::vector<bool> chosen(closure_.bodies.size(), false), held(closure_.bodies.size(), false);
        held_by_.assign(closure_.bodies.size(), nullptr);
        for (const bool on_frame : {true, false}) {
            for (const Joint& joint : mechanism_.joints) {
                if (!joint.pair().is_hinge() || joint.connects(frame) != on_frame) continue;
                for (const BodyIndex body : joint.bodies) {
                    if (body == frame || chosen[at_index(body)]) continue;
                    closure_.bodies[at_index(body)].reference = at(joint.point);
                    chosen[at_index(body)] = true;
                    if (on_frame) held_by_[at_index(body)] = &joint;
                }
            }
        }
        for (std::size_t i = 1; i < closure_.bodies.size(); ++i) {
            Closure::Body& body = closure_.bodies[i];
            const Body& given = mechanism_.bodies[i];
            if (!chosen[i] && given.circle)
                body.reference = at(given.circle->centre);
            else if (!chosen[i] && !given.points.empty())
                body.reference = at(given.points.front());
            if (held_by_[i] == nullptr) {
                body.x = closure_.columns;
                closure_.columns += 2;
            }
            body.turn = closure_.columns++;
        }
    }

    Row row(Row::Kind kind, BodyIndex i, const Vector& p, BodyIndex j, const Vector& q) const {
        Row made;
        made.kind = kind;
        made.i = i;
        made.j = j;
        made.p = from_reference(i, p);
        made.q = from_reference(j, q);
        return made;
    }
    void together(BodyIndex i, BodyIndex j, const Vector& place) {
        for (const Vector& axis : {Vector{1, 0}, Vector{0, 1}}) {
            closure_.rows.push_back(row(Row::Kind::together, i, place, j, place));
            closure_.rows.back().along = axis;
        }
    }
    void equal_turns(BodyIndex i, BodyIndex j) { closure_.rows.push_back(row(Row::Kind::turns, i, {}, j, {})); }
    /// P of i keeps its coordinate across the direction `along` of j, except for rolling.
    void on_line(BodyIndex i, const Vector& p, BodyIndex j, const Vector& q, const Vector& along,
                 const Exact& lever = {}) {
        Row made = row(Row::Kind::on_line, i, p, j, q);
        made.along = along;
        made.offset = dot(along, p - q);
        made.lever = lever;
        closure_.rows.push_back(std::move(made));
    }
    void at_distance(BodyIndex i, const Vector& p, BodyIndex j, const Vector& q) {
        Row made = row(Row::Kind::at_distance, i, p, j, q);
        made.offset = square_root(squared_length(p - q), 2 * pose_.bits).value;
        closure_.rows.push_back(std::move(made));
    }

    void write(const Joint& joint) {
        const PlanePair& pair = joint.pair();
        const BodyIndex i = joint.bodies[0];
        const Vector place = at(joint.point);
        if (pair.has_common_point()) {
            // Every body relative to the frame, if the joint includes it: that row is not written.
            const BodyIndex base = joint.connects(frame) ? frame : i;
            for (const BodyIndex body : joint.bodies) {
                if (body == base) continue;
                if (held_by_[at_index(body)] != &joint) together(base, body, place);
                if (pair.holds_rotation) equal_turns(base, body);
            }
            return;
        }
        const BodyIndex j = joint.bodies[1];
        if (pair.has_guide()) {
            if (joint.arc != none) return at_distance(i, place, j, at(joint.arc));
            on_line(i, place, j, place, about_unit(pose_.normals[at_index(mechanism_.index_of(joint))]));
            if (pair.holds_rotation) equal_turns(i, j);
            return;
        }
        touch(joint);
    }

    void touch(const Joint& joint) {
        const auto sides = sides_of(mechanism_, pose_, joint);
        if (!sides) {
            errors_.push_back(
                {ErrorCode::bad_input, joint.where, {lang::positions::without_the_profiles_of_both_bodies}});
            return;
        }
        const PlanePair& pair = joint.pair();
        const Vector tangent = unit_along(pose_.tangents[at_index(mechanism_.index_of(joint))], pose_.bits);
        const Vector normal = quarter_turn(tangent);
        const Vector place = at(joint.point);
        const auto centre = [&](std::size_t side) {
            const ContactSide& of = (*sides)[side];
            return of.centre == none ? place : at(of.centre);
        };
        const auto reach = [&](std::size_t side) -> Exact { return (*sides)[side].reach / closure_.unit; };
        if ((*sides)[0].straight || (*sides)[1].straight) {
            // The centre of one body, C = P + x n with n = z×t, moves along the other's line by −x t per radian of
            // rolling.
            const std::size_t round = (*sides)[0].straight ? 1 : 0;
            const BodyIndex i = joint.bodies[round], j = joint.bodies[1 - round];
            if (pair.holds_normal) on_line(i, centre(round), j, place, normal);
            if (pair.holds_tangent) on_line(i, centre(round), j, place, tangent, -reach(round));
            return;
        }
        const Vector apart = centre(0) - centre(1);
        if (apart.is_zero() || std::abs(apart.x.to_double()) + std::abs(apart.y.to_double()) < 1e-9) {
            errors_.push_back(
                {ErrorCode::bad_input, joint.where, {lang::positions::the_centres_of_curvature_coincide}});
            return;
        }
        if (pair.holds_normal) at_distance(joint.bodies[0], centre(0), joint.bodies[1], centre(1));
        if (!pair.holds_tangent) return;
        // v_i(P) = v_j(P) along the tangent: (x_i − x_j) φ̇ = x_i ω_i − x_j ω_j, φ the direction of the centres' line.
        Row made = row(Row::Kind::rolls_round, joint.bodies[0], centre(0), joint.bodies[1], centre(1));
        made.along = about_unit(apart);
        const Exact between = reach(0) - reach(1);
        made.share_i = reach(0) / between;
        made.share_j = -reach(1) / between;
        closure_.rows.push_back(std::move(made));
    }

    void drive(const SpinDriver& driver) { equal_turns(driver.body, driver.relative_to); }
    void drive(const SlideDriver& driver) {
        const Joint& joint = mechanism_.joint(driver.joint);
        on_line(joint.bodies[0], at(joint.point), joint.bodies[1], at(joint.point),
                pose_.guide_units[at_index(driver.joint)]);
    }
    void drive(const PointDriver& driver) {
        const auto index = static_cast<std::size_t>(
            std::find_if(mechanism_.drivers.begin(), mechanism_.drivers.end(),
                         [&](const Driver& each) { return std::get_if<PointDriver>(&each) == &driver; }) -
            mechanism_.drivers.begin());
        on_line(driver.body, at(driver.at), frame, at(driver.at), pose_.driver_units[index]);
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    Closure closure_;
    std::vector<const Joint*> held_by_;  ///< by body: the hinge on the frame that fixes its reference
    Errors errors_;
};

/// Whether hinges and clamps connect the bodies at a point.
bool are_pinned(const Mechanism& mechanism, PointIndex point, BodyIndex a, BodyIndex b) {
    std::vector<BodyIndex> group{a};
    for (std::size_t k = 0; k < group.size(); ++k) {
        for (const Joint& joint : mechanism.joints) {
            if (!joint.pair().has_common_point() || joint.point != point || !joint.connects(group[k])) continue;
            for (const BodyIndex body : joint.bodies)
                if (std::find(group.begin(), group.end(), body) == group.end()) group.push_back(body);
        }
    }
    return std::find(group.begin(), group.end(), b) != group.end();
}

}  // namespace

Result<Closure> closure_of(const Mechanism& mechanism, const Pose& pose) { return Writer(mechanism, pose).write(); }

std::optional<std::array<ContactSide, 2>> sides_of(const Mechanism& mechanism, const Pose& pose, const Joint& joint) {
    const Vector normal = quarter_turn(unit_along(pose.tangents[at_index(mechanism.index_of(joint))], pose.bits));
    std::array<ContactSide, 2> sides;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto profile = joint.profiles.find(joint.bodies[i]);
        if (profile == joint.profiles.end()) return std::nullopt;
        sides[i].straight = std::holds_alternative<LineProfile>(profile->second);
        const auto* circle = std::get_if<CircleProfile>(&profile->second);
        if (circle == nullptr) continue;
        sides[i].centre = circle->centre;
        sides[i].reach = dot(normal, pose.at(circle->centre) - pose.at(joint.point));
    }
    if (sides[0].straight && sides[1].straight) return std::nullopt;
    return sides;
}

namespace {

/// Calls `claim(point, body)` for the places of masses, loads, efforts and driven points, each with the body that
/// carries it.
template <class Claim>
void claim_by_what_acts(const Mechanism& mechanism, const Claim& claim) {
    for (const Mass& mass : mechanism.masses) claim(mass.centre, mass.body);
    for (const Load& load : mechanism.loads) {
        if (const auto* force = std::get_if<ForceLoad>(&load); force != nullptr && force->body != none)
            claim(force->at, force->body);
        if (const auto* distributed = std::get_if<DistributedLoad>(&load))
            for (const PointIndex end : {distributed->from, distributed->to}) claim(end, distributed->body);
        if (const auto* spring = std::get_if<SpringLoad>(&load))
            for (std::size_t i = 0; i < 2; ++i) claim(spring->between[i], spring->bodies[i]);
    }
    for (const Effort& effort : mechanism.efforts)
        if (const auto* force = std::get_if<ForceEffort>(&effort)) claim(force->at, force->body);
    for (const Driver& driver : mechanism.drivers)
        if (const auto* point = std::get_if<PointDriver>(&driver)) claim(point->at, point->body);
}

}  // namespace

Result<std::vector<Carrier>> carriers_of(const Mechanism& mechanism) {
    std::vector<Carrier> carriers(mechanism.points.size());
    Errors errors;
    const auto claim = [&](PointIndex point, BodyIndex body, bool needed) {
        Carrier& carrier = carriers[at_index(point)];
        if (carrier.body == none && carrier.contact == none) {
            carrier.body = body;
        } else if (needed && carrier.body != none && !are_pinned(mechanism, point, carrier.body, body)) {
            const auto name = [&](BodyIndex each) { return mechanism.body(each).name; };
            errors.push_back({ErrorCode::bad_input,
                              mechanism.point(point).where,
                              {lang::positions::body_and_body_both_need, name(carrier.body), name(body)}});
        }
    };
    for (const Joint& joint : mechanism.joints) {
        if (joint.pair().has_common_point()) claim(joint.point, joint.bodies[0], true);
        if (joint.pair().is_slot()) claim(joint.point, joint.bodies[0], true);
        if (joint.arc != none) claim(joint.arc, joint.bodies[1], true);
    }
    // The bodies of a sleeve have no relative rotation: a point of either will do.
    for (const Joint& joint : mechanism.joints) {
        if (!joint.pair().is_sleeve()) continue;
        const BodyIndex known = carriers[at_index(joint.point)].body;
        const bool second = known != none && are_pinned(mechanism, joint.point, known, joint.bodies[1]);
        claim(joint.point, joint.bodies[second ? 1 : 0], true);
    }
    for (const Joint& joint : mechanism.joints)
        for (const auto& [body, profile] : joint.profiles) {
            if (const auto* circle = std::get_if<CircleProfile>(&profile)) claim(circle->centre, body, true);
            if (std::holds_alternative<TipProfile>(profile)) claim(joint.point, body, true);
        }
    for (const Joint& joint : mechanism.joints) {
        Carrier& carrier = carriers[at_index(joint.point)];
        if (joint.pair().touches() && carrier.body == none && carrier.contact == none)
            carrier.contact = mechanism.index_of(joint);
    }
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body)
        for (const PointIndex point : mechanism.bodies[body].points) claim(point, BodyIndex(body), false);
    claim_by_what_acts(mechanism, [&](PointIndex point, BodyIndex body) { claim(point, body, false); });
    for (const Body& body : mechanism.bodies)
        if (body.circle) claim(body.circle->centre, BodyIndex(&body - mechanism.bodies.data()), false);
    for (Carrier& carrier : carriers)
        if (carrier.body == none && carrier.contact == none) carrier.body = frame;
    if (!errors.empty()) return tl::unexpected(std::move(errors));
    return carriers;
}

}  // namespace kinegraph
