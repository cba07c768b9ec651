// Bodies that nothing holds, or not enough: all that is given on them as one force or couple, what of it does work, and
// their polygon with its gap.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "constructions/statics/free_bodies/way.hpp"

namespace kinegraph::statics {

class LooseResultants {
public:
    LooseResultants(ForceModel& model, Board& board, const Mechanism& mechanism, ForcePolygons& polygons, Way& way,
                    ForceResults& results)
        : model_(model), board_(board), mechanism_(mechanism), polygons_(polygons), way_(way), results_(results) {}

    /// Floating, and what is given on them does not balance.
    const std::set<MemberIndex>& unbalanced() const { return unbalanced_; }

    /// All that is given on a group as one force along a line, one couple, or nothing.
    void resultant(const Loose& loose);

private:
    /// What is given does on the one freedom that the joints leave: its moment about the centre, or its part along the
    /// guide.
    void find_residual(const Loose& loose, Force force, const std::vector<const Load*>& loads, Resultant& result);
    /// The arm of the resultant about the place that its body is free to turn about.
    void turn_by_resultant(const Resultant& result, PlaceOnDrawing centre, Force force);
    template <class Handle>
    std::optional<Handle> unless_zero(const std::optional<Handle>& value) {
        return value && !board_.is_zero(*value) ? value : std::nullopt;
    }
    static Symbol resultant_symbol(bool is_force);
    void say_resultant(Resultant& result, const std::optional<Force>& force, const std::optional<ScalarHandle>& couple);
    /// What acts on each, and the polygon with its gap: on one body among its forces, else of all together.
    void cut_unbalanced(const Group& group, const std::vector<const Load*>& loads, Resultant& result,
                        const std::optional<Force>& force, const std::optional<ScalarHandle>& couple);
    /// On its line, at the foot of the perpendicular from where the first load acts.
    AppliedForce applied_resultant(const Load& first, StatementIndex statement, const std::optional<Force>& force,
                                   const std::optional<ScalarHandle>& couple);
    void draw_open_polygon(int polygon, const Group& group, const std::vector<Side>& sides,
                           const std::optional<Force>& force);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    ForcePolygons& polygons_;
    Way& way_;
    ForceResults& results_;
    std::set<MemberIndex> unbalanced_;
};

}  // namespace kinegraph::statics
