#include "constructions/moving/moving.hpp"

#include <string>
#include <utility>

#include "engine/solution/bindings.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

class BindingReader {
public:
    explicit BindingReader(const Solution& solution) : solution_(solution) {}

    std::vector<MovingPlan::Binding> read() {
        read_bodies("", solution_.free_bodies, solution_.taken_together);
        if (solution_.superposition)
            for (const Superposition::Part& part : solution_.superposition->parts)
                read_bodies(part.body != none ? solution_.mechanism.body(part.body).name
                                              : solution_.mechanism.point(part.pin).name,
                            part.bodies, part.together);
        for (const JointForce& pair : solution_.forces) {
            add(pair_binding(pair), none, pair.force.element());
            add(couple_of(pair_binding(pair)), none, none, pair.couple.element());
        }
        for (const Curvature& found : solution_.curvature) read(found);
        if (solution_.virtual_work)
            for (const VirtualWork::Entry& entry : solution_.virtual_work->entries)
                add(work_binding(entry), entry.elements.velocity, entry.elements.force, entry.elements.couple);
        for (std::size_t i = 0; i < solution_.relative_motion.size(); ++i) read(i, solution_.relative_motion[i]);
        if (solution_.truss) read(*solution_.truss);
        if (solution_.instantaneous_motion) read(*solution_.instantaneous_motion);
        return std::move(held_);
    }

private:
    void add(std::string name, ElementIndex place, ElementIndex vector = none, ElementIndex couple = none) {
        if (place != none || vector != none || couple != none)
            held_.push_back({std::move(name), place, vector, couple, -1, {}, {}});
    }
    void add(const std::string& held, const AppliedForce& applied) {
        if (applied.elements.force != none) add(held, applied.elements.at, applied.elements.force);
        if (applied.elements.couple != none) add(couple_of(held), applied.elements.at, none, applied.elements.couple);
    }
    void read_bodies(const std::string& load, const std::vector<FreeBody>& bodies,
                     const std::vector<TakenTogether>& together) {
        for (const FreeBody& body : bodies) read_body(load, body);
        for (std::size_t i = 0; i < together.size(); ++i) {
            for (const AppliedForce& sum : together[i].sums) add(sum_binding(load, i, sum), sum);
            if (together[i].funicular) read_strings(load, *together[i].funicular);
        }
    }
    void read_body(const std::string& load, const FreeBody& body) {
        for (const AppliedForce& each : body.forces) {
            const std::size_t first = held_.size();
            add(force_binding(load, body, each), each);
            if (held_.size() == first || each.elements.force == none) continue;
            MovingPlan::Binding& force = held_[first];
            if (each.kind == Quantity::Kind::load &&
                !std::holds_alternative<SpringLoad>(solution_.mechanism.loads[at_index(each.given)]))
                force.given = each.given;
            if (!load.empty()) continue;
            force.figure = figure_of(body);
            force.symbol = name_of(each.symbol);
        }
        for (const AppliedForce& sum : body.sums) add(sum_binding(load, body, sum), sum);
        for (const FreeBody::Meet& meet : body.meets) add(meet_binding(load, meet.name), meet.element);
        for (std::size_t i = 0; i < body.arms.size(); ++i) {
            add(arm_binding(load, body, i, false), body.arms[i].elements.about);
            add(arm_binding(load, body, i, true), body.arms[i].elements.foot);
        }
        if (body.funicular) read_strings(load, *body.funicular);
    }
    std::string figure_of(const FreeBody& body) const {
        return body.body != none ? "body-" + solution_.mechanism.body(body.body).name
                                 : "pin-" + solution_.mechanism.point(body.pin).name;
    }
    void read_strings(const std::string& load, const FreeBody::Funicular& funicular) {
        const std::size_t count = funicular.vertices.size();
        for (std::size_t i = 0; i < count; ++i)
            add(string_binding(load, funicular, i), funicular.vertices[i].element());
        add(string_binding(load, funicular, count), funicular.resultant.element());
    }
    void read(const Curvature& found) {
        const auto place = [&](const std::string& what, ElementIndex element) {
            add(curvature_binding(found.body, what), element);
        };
        place("pole", found.pole.element());
        place("axis", found.axis_point.element());
        place("inflection", found.inflection_pole.element());
        place("tangential", found.tangential_pole.element());
        place("acceleration", found.acceleration_pole.element());
        for (std::size_t i = 0; i < found.rays.size(); ++i) {
            place("ray " + std::to_string(i), found.rays[i].at.element());
            place("ray centre " + std::to_string(i), found.rays[i].centre.element());
        }
        for (const PathCentre& path : found.points) place("of " + path.label, path.centre.element());
        for (const EnvelopeCentre& envelope : found.envelopes) {
            const std::string joint = std::to_string(envelope.joint.number());
            place("touches " + joint, envelope.touches.element());
            place("envelope " + joint, envelope.centre.element());
        }
    }
    void read(std::size_t index, const RelativeMotion& motion) {
        if (!motion.apart) return;
        const auto vector = [&](const std::string& what, const Recorded<Vector>& found) {
            add(relative_binding(index, what), none, found.element());
        };
        vector("v", motion.relative_velocity);
        vector("v along", motion.apart->velocity_along);
        vector("v across", motion.apart->velocity_across);
        vector("a", motion.relative_acceleration);
        vector("a along", motion.apart->acceleration_along);
        vector("a across", motion.apart->acceleration_across);
        vector("cor", motion.coriolis);
    }
    void read(const Truss& truss) {
        for (std::size_t bar = 0; bar < truss.bars.size(); ++bar)
            add(bar_binding(truss, bar), none, truss.bars[bar].force.element());
        for (const Truss::External& external : truss.externals) {
            const std::size_t first = held_.size();
            add(external_binding(external), none, external.force.element());
            if (held_.size() > first && external.joint == none) held_[first].given = external.given;
        }
        if (!truss.whole) return;
        add(whole_binding(), truss.whole->through.element(), truss.whole->force.element());
        for (const Truss::Whole::Meet& meet : truss.whole->meets)
            add(meet_binding("", meet.name), meet.place.element());
    }
    void read(const InstantaneousMotionFigure& motion) {
        const auto& given = solution_.mechanism.motion->velocities;
        for (const PointMotion& point : solution_.points) {
            if (point.point == none || point.velocity.element() == none) continue;
            add(velocity_binding(point.point), none, point.velocity.element());
            for (std::size_t i = 0; i < given.size(); ++i)
                if (given[i].point == point.point) held_.back().given = static_cast<int>(i);
        }
        for (const InstantCentre& centre : solution_.centres)
            if (centre.first == frame && centre.second == motion.body)
                add(instantaneous_binding("centre"), centre.at.element());
        add(instantaneous_binding("omega"), none, none, solution_.bodies[at_index(motion.body)].omega.element());
        add(instantaneous_binding("acceleration"), motion.acceleration_centre.element());
        if (!motion.differing) return;
        add(instantaneous_binding("first"), none, motion.differing->of_first.element());
        add(instantaneous_binding("second"), none, motion.differing->of_second.element());
    }

    const Solution& solution_;
    std::vector<MovingPlan::Binding> held_;
};

}  // namespace

std::vector<MovingPlan::Binding> bindings_of(const Solution& solution) { return BindingReader(solution).read(); }

}  // namespace kinegraph
