#include "constructions/positions/pushing_contacts.hpp"

#include <cmath>

namespace kinegraph {

double PushingContact::push(const std::vector<double>& row, const VectorOf<double>& sense) const {
    const VectorOf<double> force{row[x], row[y]};
    const double along = dot(force, sense) / std::sqrt(squared_length(sense));
    return is_on_first ? along : -along;
}

VectorOf<double> PushingContact::sense(const Mechanism& mechanism, const Pose& pose) const {
    const Vector& normal = pose.normals[at_index(joint)];
    const auto& pushes = mechanism.joint(joint).pushes;
    const double sign = pushes && dot(*pushes, normal).sign() < 0 ? -1 : 1;
    return {sign * normal.x.to_double(), sign * normal.y.to_double()};
}

namespace {

template <class IsOne>
std::vector<PushingContact> contacts_with_columns(const Mechanism& mechanism, const std::vector<Column>& columns,
                                                  IsOne is_one) {
    using Component = Quantity::Component;
    std::vector<PushingContact> found;
    const auto is_force = [&](std::size_t column, JointIndex joint, Component component) {
        const Quantity& of = columns[column].quantity;
        return of.kind == Quantity::Kind::force && of.joint == joint && of.component == component;
    };
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const JointIndex joint(k);
        for (std::size_t i = 0; i + 1 < columns.size() && is_one(mechanism.joints[k]); ++i) {
            if (!is_force(i, joint, Component::x) || !is_force(i + 1, joint, Component::y)) continue;
            found.push_back({joint, i, i + 1, columns[i].quantity.body == mechanism.joints[k].bodies[0]});
            break;
        }
    }
    return found;
}

}  // namespace

std::vector<PushingContact> pushing_contacts(const Mechanism& mechanism, const std::vector<Column>& columns) {
    return contacts_with_columns(mechanism, columns, [](const Joint& joint) { return joint.pushes.has_value(); });
}

std::vector<PushingContact> meshing_teeth(const Mechanism& mechanism, const std::vector<Column>& columns) {
    return contacts_with_columns(mechanism, columns, [](const Joint& joint) { return joint.pair().meshes(); });
}

}  // namespace kinegraph
