#include "constructions/moving/moving_bindings.hpp"

#include <string>
#include <utility>

#include "engine/solution/bindings.hpp"

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
        return std::move(held_);
    }

private:
    void add(std::string name, ElementIndex place, ElementIndex vector = none, ElementIndex couple = none) {
        if (place != none || vector != none || couple != none)
            held_.push_back({std::move(name), place, vector, couple});
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
        for (const AppliedForce& each : body.forces) add(force_binding(load, body, each), each);
        for (const AppliedForce& sum : body.sums) add(sum_binding(load, body, sum), sum);
        for (const FreeBody::Meet& meet : body.meets) add(meet_binding(load, meet.name), meet.element);
        for (std::size_t i = 0; i < body.arms.size(); ++i) {
            add(arm_binding(load, body, i, false), body.arms[i].elements.about);
            add(arm_binding(load, body, i, true), body.arms[i].elements.foot);
        }
        if (body.funicular) read_strings(load, *body.funicular);
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

    const Solution& solution_;
    std::vector<MovingPlan::Binding> held_;
};

}  // namespace

std::vector<MovingPlan::Binding> bindings_of(const Solution& solution) { return BindingReader(solution).read(); }

}  // namespace kinegraph
