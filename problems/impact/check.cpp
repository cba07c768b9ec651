#include "problems/impact/impact.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph {
namespace {

using Pair = VectorOf<double>;

Pair in_doubles(const Vector& v) { return {v.x.to_double(), v.y.to_double()}; }

struct Moving {
    bool fixed = false, hinged = false;
    double mass = 0, inertia = 0;  ///< about the centre; 0: does not rotate
    Pair centre, pivot, velocity, reaction;
    double omega = 0;

    Pair velocity_at(const Pair& place) const { return velocity + omega * quarter_turn(place - centre); }
    /// Newton's and Euler's laws for an impulse at a place; the reaction of a hinge keeps the hinge at rest.
    void push(const Pair& impulse, const Pair& place) {
        if (fixed) return;
        if (!hinged) {
            velocity = velocity + (1 / mass) * impulse;
            if (inertia > 0) omega += cross(place - centre, impulse) / inertia;
            return;
        }
        const Pair arm = centre - pivot;
        const double change = cross(place - pivot, impulse) / (inertia + mass * squared_length(arm));
        const Pair gained = change * quarter_turn(arm);
        omega += change;
        velocity = velocity + gained;
        reaction = reaction + (mass * gained - impulse);
    }
    double energy() const { return fixed ? 0 : 0.5 * (mass * squared_length(velocity) + inertia * omega * omega); }
};

class Stepper {
public:
    Stepper(const ImpactProblem& problem, const Vector& at, const Vector& normal, const Pose& pose)
        : friction_(problem.friction.to_double()) {
        place_ = in_doubles(at);
        normal_ = in_doubles(normal);
        normal_ = (1 / std::sqrt(squared_length(normal_))) * normal_;
        for (std::size_t i = 0; i < 2; ++i) bodies_.at(i) = moving(problem.bodies.at(i), pose);
        const double before = bodies_[0].energy() + bodies_[1].energy();
        run(problem.restitution.to_double());
        found_.energy_lost = before - bodies_[0].energy() - bodies_[1].energy();
        for (std::size_t i = 0; i < 2; ++i) {
            const Moving& body = bodies_.at(i);
            found_.bodies.at(i) = {{body.velocity.x, body.velocity.y}, {body.reaction.x, body.reaction.y}, body.omega};
        }
        found_.impulse = {total_.x, total_.y};
    }
    const ImpactCheck& found() const { return found_; }

private:
    Moving moving(const ImpactBody& given, const Pose& pose) const {
        const auto place_of = [&](const Place& place) {
            if (const auto* point = std::get_if<PointIndex>(&place)) return in_doubles(pose.at(*point));
            return in_doubles(std::get<Vector>(place));
        };
        Moving body;
        body.fixed = given.fixed;
        body.centre = given.centre ? place_of(*given.centre) : place_;
        if (given.fixed) return body;
        body.mass = given.mass.to_double();
        body.inertia = given.inertia ? given.inertia->to_double() : 0;
        body.omega = given.omega.to_double();
        if (given.velocity) body.velocity = in_doubles(*given.velocity);
        if (given.pivot) {
            body.hinged = true;
            body.pivot = place_of(*given.pivot);
            body.velocity = body.omega * quarter_turn(body.centre - body.pivot);
        }
        return body;
    }
    Pair relative() const { return bodies_[0].velocity_at(place_) - bodies_[1].velocity_at(place_); }
    double approach() const { return dot(relative(), normal_); }
    double slip() const { return dot(relative(), quarter_turn(normal_)); }
    void push(double along, double across) {
        const Pair impulse = along * normal_ + across * quarter_turn(normal_);
        bodies_[0].push(impulse, place_);
        bodies_[1].push(-impulse, place_);
        total_ = total_ + impulse;
    }

    /// A step of the normal impulse with its friction: the impulse that stops the slip, or the friction limit if that
    /// is smaller.
    void step(double along) {
        push(along, 0);
        const double without = slip();
        const auto kept = bodies_;
        const Pair total = total_;
        const double trial = along > 0 ? along : 1;
        push(0, trial);
        const double yielding = (slip() - without) / trial;
        bodies_ = kept;
        total_ = total;
        const double most = friction_ * along;
        if (yielding > 0)
            push(0, std::clamp(-without / yielding, -most, most));
        else if (without != 0)
            push(0, without > 0 ? -most : most);
    }

    /// The same, split where the slip would reverse within the step: it slides up to there.
    void advance(double along) {
        const auto kept = bodies_;
        const Pair total = total_;
        const double before = slip();
        const double against = before > 0 ? -friction_ : friction_;
        push(along, before == 0 ? 0 : against * along);
        const double after = slip();
        bodies_ = kept;
        total_ = total;
        if (before * after >= 0) {
            step(along);
            return;
        }
        const double part = along * before / (before - after);
        push(part, against * part);
        step(along - part);
    }

    void run(double restitution) {
        // The scale of the impulse: the effect of a unit impulse on the approach.
        const auto kept = bodies_;
        const double before = approach();
        push(1e-9 * scale(), 0);
        const double yielding = (approach() - before) / (1e-9 * scale());
        bodies_ = kept;
        total_ = {};
        constexpr int steps = 4000;
        constexpr long most = 100L * steps;
        const double size = -before / yielding / steps;
        if (!std::isfinite(size)) {
            total_ = {size, size};
            return;
        }
        // Bodies that jam stop approaching and slipping at once, and would then stay at rest under any impulse.
        const double stopped = 1e-12 * before;
        double sum = 0;
        for (long i = 0; i < most && approach() < stopped; ++i) {
            const auto back = bodies_;
            const Pair total = total_;
            double rest = size;
            advance(rest);
            if (approach() >= stopped) {
                // The compression ended within this step.
                double none = 0;
                for (int halving = 0; halving < 60; ++halving) {
                    const double half = 0.5 * (none + rest);
                    bodies_ = back;
                    total_ = total;
                    advance(half);
                    (approach() < stopped ? none : rest) = half;
                }
                bodies_ = back;
                total_ = total;
                advance(rest);
            }
            sum += rest;
        }
        const double all = restitution * sum;
        for (int i = 0; i < steps && all > 0; ++i) advance(all / steps);
    }
    double scale() const {
        double sum = 0;
        for (const Moving& body : bodies_) sum += body.mass * std::sqrt(squared_length(body.velocity)) + body.mass;
        return sum;
    }

    double friction_;
    Pair place_, normal_, total_;
    std::array<Moving, 2> bodies_;
    ImpactCheck found_;
};

}  // namespace

ImpactCheck check_impact(const ImpactProblem& problem, const Vector& at, const Vector& normal, const Pose& pose) {
    return Stepper(problem, at, normal, pose).found();
}

}  // namespace kinegraph
