#include "constructions/positions/pushing_contacts.hpp"

#include <cmath>

namespace kinegraph {

double PushingContact::push(const std::vector<double>& row, const GivensHere& givens, const Places& places) const {
    const VectorOf<double> force{row[x], row[y]}, sense = givens.push(joint, places);
    const double along = dot(force, sense) / std::sqrt(squared_length(sense));
    return is_on_first ? along : -along;
}

std::vector<PushingContact> pushing_contacts(const Mechanism& mechanism, const std::vector<Column>& columns) {
    using Component = Quantity::Component;
    std::vector<PushingContact> found;
    const auto is_force = [&](std::size_t column, JointIndex joint, Component component) {
        const Quantity& of = columns[column].quantity;
        return of.kind == Quantity::Kind::force && of.joint == joint && of.component == component;
    };
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const JointIndex joint(k);
        for (std::size_t i = 0; i + 1 < columns.size() && mechanism.joints[k].pushes; ++i) {
            if (!is_force(i, joint, Component::x) || !is_force(i + 1, joint, Component::y)) continue;
            found.push_back({joint, i, i + 1, columns[i].quantity.body == mechanism.joints[k].bodies[0]});
            break;
        }
    }
    return found;
}

}  // namespace kinegraph
