// Unsupported or insufficiently supported bodies: the given forces as one force or couple, the part of it that does
// work, and the polygon with its gap.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "constructions/statics/free_bodies/intermediate_constructions.hpp"

namespace kinegraph::statics {

class UnsupportedResultants {
public:
    UnsupportedResultants(ForceModel& model, Board& board, const Mechanism& mechanism, ForcePolygons& polygons,
                          IntermediateConstructions& constructions, ForceResults& results)
        : model_(model),
          board_(board),
          mechanism_(mechanism),
          polygons_(polygons),
          constructions_(constructions),
          results_(results) {}

    /// Floating members whose given forces do not balance.
    const std::set<MemberIndex>& unbalanced() const { return unbalanced_; }

    /// Reduces the given forces on a group to a force along a line, a couple, or zero.
    void resultant(const Unsupported& loose);

private:
    /// The part that works in the one freedom left by the joints: the moment about the centre, or the component along
    /// the guide.
    void find_residual(const Unsupported& loose, Force force, const std::vector<const Load*>& loads, Resultant& result);
    /// Adds the arm of the resultant about the place about which the body can turn.
    void turn_by_resultant(const Resultant& result, PlaceOnDrawing centre, Force force);
    template <class Handle>
    std::optional<Handle> unless_zero(const std::optional<Handle>& value) {
        return value && !board_.is_zero(*value) ? value : std::nullopt;
    }
    static Symbol resultant_symbol(bool is_force);
    void say_resultant(Resultant& result, const std::optional<Force>& force, const std::optional<ScalarHandle>& couple);
    /// Draws the free bodies, and the polygon with its gap: on one body among its forces, else for all together.
    void cut_unbalanced(const Group& group, const std::vector<const Load*>& loads, Resultant& result,
                        const std::optional<Force>& force, const std::optional<ScalarHandle>& couple);
    /// On its line, at the foot of the perpendicular from the point of the first load.
    AppliedForce applied_resultant(const Load& first, StatementIndex statement, const std::optional<Force>& force,
                                   const std::optional<ScalarHandle>& couple);
    void draw_open_polygon(int polygon, const Group& group, const std::vector<Side>& sides,
                           const std::optional<Force>& force);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    ForcePolygons& polygons_;
    IntermediateConstructions& constructions_;
    ForceResults& results_;
    std::set<MemberIndex> unbalanced_;
};

}  // namespace kinegraph::statics
