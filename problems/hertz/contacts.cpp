#include "problems/hertz/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/number/functions.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/contacts.hpp"

namespace kinegraph {
namespace {

double component(const Vector& v, const Vector& along) { return dot(v, along).to_double() / length(along); }

class ContactAtJoint {
public:
    ContactAtJoint(const Solution& solution, const LoadedContact& given)
        : solution_(solution), given_(given), joint_(solution.mechanism.joint(given.joint)) {}

    /// The contact, or the reason why there is none.
    tl::expected<SolvedContact, Words> solved() const {
        const auto force = std::find_if(solution_.forces.begin(), solution_.forces.end(), [&](const JointForce& each) {
            return each.joint == given_.joint && joint_.connects(each.on) && each.force;
        });
        if (force == solution_.forces.end()) return no(Words(lang::contacts::the_force_there_was_not_found));
        HertzProblem problem = shape();
        if ((problem.bodies[0].curvature(0) + problem.bodies[1].curvature(0)).sign() <= 0)
            return no(Words(lang::contacts::the_concave_radius_is_not_larger));
        const auto [pushes, load] = load_of(on_first(*force->force, force->on));
        if (!std::isfinite(load)) return no(Words(lang::contacts::the_force_there_is_no_number));
        if (load == 0) return no(Words(lang::contacts::no_force_acts_there_so_nothing));
        if (!pushes) return no(Words(lang::contacts::the_force_found_pulls_the_bodies));
        problem.force = Exact::from_double(load);
        HertzProblem checked = problem;
        checked.force = Exact::from_double(load_by_check().value_or(load));
        auto found = solve_hertz(problem, checked);
        if (!found) return no(found.error().front().message);
        return SolvedContact{given_.joint, load,
                             std::make_shared<const Problem>(Problem{&hertz_problem, std::move(problem)}),
                             std::make_shared<const ProblemSolution>(*std::move(found))};
    }

private:
    tl::unexpected<Words> no(const Words& why) const {
        return tl::unexpected(Words(lang::contacts::contact_at, joint_.name, why));
    }
    const Vector& place() const { return solution_.pose.at(joint_.point); }

    /// From the contact to the centre of a body's profile; none for a straight one.
    std::optional<Vector> centre_of(std::size_t i) const {
        const auto* circle = std::get_if<CircleProfile>(&joint_.profiles.at(joint_.bodies[i]));
        if (circle == nullptr) return std::nullopt;
        return solution_.pose.at(circle->centre) - place();
    }
    bool is_concave(std::size_t i) const {
        const auto own = centre_of(i), other = centre_of(1 - i);
        return own && other && dot(*own, *other).sign() > 0 && squared_length(*own) >= squared_length(*other);
    }
    /// All data except the force.
    HertzProblem shape() const {
        HertzProblem problem;
        for (std::size_t i = 0; i < 2; ++i) problem.bodies.at(i) = {given_.bodies.at(i)};
        problem.line = true;
        problem.length = given_.length;
        AtJoint at;
        at.joint = joint_.name;
        at.meshes = joint_.pair().meshes();
        at.pressure_angle = pressure_angle();
        for (std::size_t i = 0; i < 2; ++i) {
            const auto arm = centre_of(i);
            if (!arm) continue;
            at.pitch_radii.at(i) = length(*arm);
            const double radius = at.meshes ? length(*arm) * nearest::sin(at.pressure_angle) : length(*arm);
            HertzBody& body = problem.bodies.at(i);
            body.radii = {Exact::from_double(radius), Exact::from_double(radius)};
            body.inside = {is_concave(i), is_concave(i)};
        }
        problem.at = at;
        return problem;
    }
    double pressure_angle() const {
        if (!joint_.pressure_angle) return 0;
        const double value = joint_.pressure_angle->value.to_double();
        return joint_.pressure_angle->in_degrees ? value * std::numbers::pi / 180 : value;
    }

    /// Into the first body, along the common normal.
    Vector inwards() const {
        const std::size_t round = centre_of(0) ? 0 : 1;
        const Vector towards = *centre_of(round);
        return (round == 0) == is_concave(round) ? -towards : towards;
    }
    Vector on_first(const Vector& force, BodyIndex on) const { return on == joint_.bodies[0] ? force : -force; }
    struct Load {
        bool pushes = false;
        double size = 0;
    };
    /// From the force on the first body.
    Load load_of(const Vector& force) const {
        if (joint_.pair().meshes()) return {true, length(force)};
        const double along = component(force, inwards());
        return {along > 0, std::abs(along)};
    }
    std::optional<double> load_by_check() const {
        std::optional<double> x, y;
        for (const CheckRow& row : solution_.checks) {
            const Quantity& of = row.quantity;
            if (of.kind != Quantity::Kind::force || of.joint != given_.joint || !joint_.connects(of.body)) continue;
            if (of.component == Quantity::Component::x) x = row.numeric;
            if (of.component == Quantity::Component::y) y = row.numeric;
        }
        if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) return std::nullopt;
        return load_of({Exact::from_double(*x), Exact::from_double(*y)}).size;  // the sign has no meaning here
    }

    const Solution& solution_;
    const LoadedContact& given_;
    const Joint& joint_;
};

}  // namespace

void find_contacts(Solution& solution) {
    if (!solution.mechanism.contacts) return;
    SolvedContacts all{&hertz_problem, {}, {}};
    for (const LoadedContact& given : *solution.mechanism.contacts) {
        auto contact = ContactAtJoint(solution, given).solved();
        if (!contact) {
            all.remarks.push_back(contact.error());
            continue;
        }
        const std::string& joint = solution.mechanism.joint(given.joint).name;
        for (const HertzBody& body : contact->stated->as<HertzProblem>().bodies)
            if (body.depth && !body.radii[0].is_zero() && !body.inside[0])
                all.remarks.emplace_back(lang::contacts::at_the_depth_of_body, joint,
                                         solution.mechanism.body(body.body).name);
        for (const Words& remark : contact->found->remarks)
            all.remarks.emplace_back(lang::contacts::at_joint, joint, remark);
        all.at_joints.push_back(*std::move(contact));
    }
    solution.contacts = std::make_shared<const SolvedContacts>(std::move(all));
}

}  // namespace kinegraph
