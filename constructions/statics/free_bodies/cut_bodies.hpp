// Free-body diagrams: the forces on each body, their lines, and the closed polygon; also the external forces on bodies
// that were balanced as one.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "constructions/statics/free_bodies/determinacy.hpp"

namespace kinegraph::statics {

class CutBodies {
public:
    CutBodies(ForceModel& model, Board& board, ForcePolygons& polygons, IntermediateConstructions& constructions,
              const UnderLoads& under, bool one_by_one, ForceResults& results)
        : model_(model),
          board_(board),
          polygons_(polygons),
          constructions_(constructions),
          under_(under),
          one_by_one_(one_by_one),
          results_(results) {}

    /// For each body with all forces known, except those that are `unbalanced`.
    void draw_bodies(const Run& run, const std::set<MemberIndex>& unbalanced);
    /// Whether all forces on a member are known.
    bool is_whole(MemberIndex member, const Run& run) const;
    /// For bodies balanced as one: the external forces, known ones first.
    void cut_together(const Run& run);

private:
    /// A free body under construction, and the sides of its polygon.
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
    /// Whether known forces were added to an unknown one, which gives the polygon a diagonal.
    static bool has_diagonal(const TakenTogether& taken, const Run& run);
    /// The strings by which the group was balanced; null if it was balanced otherwise.
    static const Funicular* funicular_of(const TakenTogether& taken, const Run& run);
    void draw_together(const TakenTogether& taken, std::vector<std::pair<MemberIndex, Side>> sides,
                       const Funicular* funicular, const Run& run);

    ForceModel& model_;
    Board& board_;
    ForcePolygons& polygons_;
    IntermediateConstructions& constructions_;
    const UnderLoads& under_;
    bool one_by_one_;
    ForceResults& results_;
};

}  // namespace kinegraph::statics
