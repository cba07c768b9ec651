// Bodies cut free: of each its forces, their lines, and its closed polygon; and of bodies that were balanced as one
// what acts on them from outside.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "constructions/statics/free_bodies/verdict.hpp"

namespace kinegraph::statics {

class CutBodies {
public:
    CutBodies(ForceModel& model, Board& board, ForcePolygons& polygons, Way& way, const UnderLoads& under,
              bool one_by_one, ForceResults& results)
        : model_(model),
          board_(board),
          polygons_(polygons),
          way_(way),
          under_(under),
          one_by_one_(one_by_one),
          results_(results) {}

    /// Each of which all is known, but those that are `unbalanced`.
    void draw_bodies(const Run& run, const std::set<MemberIndex>& unbalanced);
    /// All that acts on it is known.
    bool is_whole(MemberIndex member, const Run& run) const;
    /// Of bodies that were balanced as one: what acts on them from outside, first what was known.
    void cut_together(const Run& run);

private:
    /// A body on the way to be cut free, and the sides of its polygon.
    struct CutBody {
        FreeBody body;
        std::vector<Side> sides;
    };
    void free_body(MemberIndex member, const Run& run);
    /// `force` is that of a bond, or of a load (-1).
    void apply(CutBody& cut, AppliedForce applied, const std::optional<Force>& force, int bond);
    void apply_reaction(CutBody& cut, MemberIndex member, int b, const Reaction& reaction);
    /// The reaction without its values, at the bond's place.
    AppliedForce applied_reaction(const Bond& bond, const Reaction& reaction, bool reversed) const;
    /// What is known and a force that is sought were added.
    static bool has_diagonal(const Balanced& balanced, const Run& run);
    /// By which the group was balanced; null: otherwise.
    static const Strings* strings_of(const Balanced& balanced, const Run& run);
    void draw_together(const Balanced& balanced, std::vector<std::pair<MemberIndex, Side>> sides,
                       const Strings* strings, const Run& run);

    ForceModel& model_;
    Board& board_;
    ForcePolygons& polygons_;
    Way& way_;
    const UnderLoads& under_;
    bool one_by_one_;
    ForceResults& results_;
};

}  // namespace kinegraph::statics
