// Intermediate constructions of a body's forces: sums, arms, strings, points where lines meet; and the order of the
// sides of its polygon that follows from them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "constructions/statics/free_bodies.hpp"
#include "constructions/statics/free_bodies/force_polygons.hpp"

namespace kinegraph::statics {

/// Which loads act: all, or those of one member only.
struct UnderLoads {
    const std::vector<Load>* loads;
    std::string mark{};                       ///< name of the loaded member; empty: all loads act
    StatementIndex first = none, end = none;  ///< range of its sentences

    std::string suffix() const { return mark.empty() ? "" : "-load-" + mark; }
};

inline Recorded<Vector> recorded(const std::optional<Force>& force) {
    return force ? Recorded<Vector>::at(force->element) : Recorded<Vector>::zero();
}
inline Recorded<Exact> recorded(const std::optional<ScalarHandle>& couple) {
    return couple ? Recorded<Exact>::at(couple->element) : Recorded<Exact>::zero();
}

class IntermediateConstructions {
public:
    IntermediateConstructions(ForceModel& model, Board& board, const Mechanism& mechanism, const NamedMeets& meets,
                              const UnderLoads& under)
        : model_(model), board_(board), mechanism_(mechanism), meets_(meets), under_(under) {}

    /// Adds sums, arms and strings of a member; returns the sums that determine the order of its polygon.
    std::vector<const Sum*> add_to(MemberIndex member, const Run& run, FreeBody& body);
    /// The points of concurrency used for a member.
    void list_meets(MemberIndex member, FreeBody& body) const;
    FreeBody::Arm arm_about(PlaceOnDrawing about, Force force, PlaceOnDrawing place, StatementIndex statement,
                            bool is_sought);
    /// A point of the file at this place; empty if there is none.
    std::string point_at(PlaceOnDrawing place);
    static AppliedForce applied_sum(const Sum& sum);
    static FreeBody::Funicular funicular(const Funicular& drawn);
    /// Rank by the first sum of which it is part.
    static std::ptrdiff_t rank_in(const std::vector<const Sum*>& leading, const Side& side);
    static std::ptrdiff_t rank_in(const FreeBody::Funicular& funicular, const Symbol& symbol);
    /// Orders sides as they were added, so that the sums are diagonals from the polygon's first corner.
    void put_in_order(std::vector<Side>& sides, const std::vector<const Sum*>& leading);
    /// Order of the corners of the rays: known forces, the force of the line, that of the place.
    static void put_in_order(std::vector<Side>& sides, const FreeBody::Funicular& funicular);
    FreeBody empty_body(MemberIndex member) const;
    static AppliedForce applied_load(const Load& load);

private:
    /// Sorts counter-clockwise by direction, starting with the first: the polygon is convex, and neighbouring polygons
    /// lie on opposite sides of common forces.
    void sort_round(std::vector<Side>& sides);
    bool bears_load(MemberIndex member) const;
    void add_arm(const Arm& arm, FreeBody& body);

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const NamedMeets& meets_;
    const UnderLoads& under_;
};

}  // namespace kinegraph::statics
