// Contacts that can only push, and the force with which they do in a row.
#pragma once

#include <vector>

#include "constructions/positions/givens_here.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

/// One of them, with the columns of its force.
struct PushingContact {
    JointIndex joint;
    std::size_t x = 0, y = 0;
    bool is_on_first = true;  ///< the force is that on the joint's first body

    /// The force with which it pushes, N; negative: it would have to pull.
    double push(const std::vector<double>& row, const GivensHere& givens, const Places& places) const {
        return push(row, givens.push(joint, places));
    }
    /// The sense in which it pushes its first body, as drawn, of any length.
    VectorOf<double> sense(const Mechanism& mechanism, const Pose& pose) const;
    double push(const std::vector<double>& row, const VectorOf<double>& sense) const;
};
/// Those whose force has columns.
std::vector<PushingContact> pushing_contacts(const Mechanism& mechanism, const std::vector<Column>& columns);
/// Gears whose force has columns. With the common tangent as its sense, push() is what the teeth transmit: where it
/// changes its sign, their other flanks push.
std::vector<PushingContact> meshing_teeth(const Mechanism& mechanism, const std::vector<Column>& columns);

}  // namespace kinegraph
