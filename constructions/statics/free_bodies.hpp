// Free bodies: for each body of a finished run its forces and closed force polygon, and the polygons joined at their
// common forces (Cremona), so that the external forces close. Gives the reason if forces are not determined.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces.hpp"
#include "constructions/statics/unsupported_bodies.hpp"

namespace kinegraph::statics {

/// A point of concurrency used for a member, with its letter.
struct NamedMeet {
    std::string name;
    PlaceOnDrawing place;
    StatementIndex statement = none;  ///< the first that names it
    StatementIndex used = none;       ///< the one that uses it for the member
};
using NamedMeets = std::map<MemberIndex, std::vector<NamedMeet>>;

/// `one_by_one`: includes each free body and its polygon; else the joint forces only.
ForceResults cut_free(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                      const Run& run, const NamedMeets& meets, const std::vector<Unsupported>& loose,
                      bool one_by_one = true);

/// Notes the first sentence that uses the line of a load: where it leads to a point of concurrency. Call it after the
/// values are evaluated.
void note_first_use_of_lines(std::vector<FreeBody>& bodies, const Pose& pose);

}  // namespace kinegraph::statics
