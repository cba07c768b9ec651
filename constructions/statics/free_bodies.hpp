// Free bodies: what a finished run says of each body cut free, its closed force polygon, and the polygons laid side by
// side on their common forces (Cremona), so that the external forces close. Says why, where something is not
// determined.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces.hpp"
#include "constructions/statics/loose_bodies.hpp"

namespace kinegraph::statics {

/// Points of concurrency by the member on which they were used, with the letters they got.
struct NamedMeet {
    std::string name;
    PlaceOnDrawing place;
    StatementIndex statement = none;  ///< that names it first
    StatementIndex used = none;       ///< that needs it on the member
};
using NamedMeets = std::map<MemberIndex, std::vector<NamedMeet>>;

/// `one_by_one`: with each body cut free, and their polygons; else the forces at joints alone.
ForceResults cut_free(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                      const Run& run, const NamedMeets& meets, const std::vector<Loose>& loose, bool one_by_one = true);

/// The line of a load is first needed where it leads to a point of concurrency. Asked once the values are read.
void note_first_use_of_lines(std::vector<FreeBody>& bodies, const Pose& pose);

}  // namespace kinegraph::statics
