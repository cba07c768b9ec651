// All instant centres of relative rotation. Primary centres come from the pairs. Then the theorem of Aronhold (1872)
// and Kennedy (1886), that the three centres of three bodies lie on a line, is applied until no more follow. The
// remaining ones come from the velocities.
//
// A centre at infinity is a translation and is used like any other. If two of three centres coincide, there is no line
// and the third centre coincides with them. If both lines are at infinity, only this is known.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/space_diagram.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/solution/motion.hpp"

namespace kinegraph {

class InstantCentres {
public:
    /// `rest`: of this position. The centre of two bodies at rest against each other is everywhere, whatever else is
    /// requested and in whatever order the file gives the bodies; the theorem holds for bodies that move.
    InstantCentres(Structure& structure, Board& board, RelativeRest rest);

    /// Primary centres and Kennedy's theorem; uses geometry only, no velocities.
    void draw();
    /// Whether Kennedy's theorem gave all.
    bool are_found() const;
    /// The centres that Kennedy's theorem does not give, from velocities; of bodies that only begin to move against
    /// each other, from accelerations. `freedoms`: of the mechanism; with more than one, a centre found this way is
    /// valid for this ratio of the drivers only.
    void complete(const Motion& motion, int freedoms);
    /// Angular velocities again, by instant centres: ω_b = ω_d · P_1d P_db / P_1b P_db, for a body d driven against the
    /// frame.
    void second_way(const Motion& motion, BodyIndex driven_body, std::vector<SecondWay>& results);

    std::vector<InstantCentre> results() const;

private:
    struct Pair {
        InstantCentre centre;
        std::optional<PointOn<Plane::drawing>> point;
        std::vector<std::pair<LineOn<Plane::drawing>, PointIndex>> normals;
    };
    /// A line on which the centre of a pair lies.
    struct Line {
        BodyIndex by = none;  ///< the third body (Kennedy), or none
        int normal = -1;      ///< if none: index of the pair's normal
    };
    std::size_t index(BodyIndex i, BodyIndex j) const;
    Pair& pair(BodyIndex i, BodyIndex j) { return pairs_[index(i, j)]; }
    bool solved(const Pair& pair) const { return pair.point.has_value() || pair.centre.everywhere; }
    Symbol symbol(BodyIndex i, BodyIndex j);
    StatementIndex say(Key sentence, std::vector<Argument> arguments);
    void settle(Pair& pair, PointOn<Plane::drawing> point, InstantCentre::How how);
    void primary(JointIndex joint);
    void primary(JointIndex joint, BodyIndex i, BodyIndex j);
    LineOn<Plane::drawing> line_of(BodyIndex i, BodyIndex j, const Line& line);
    std::optional<std::pair<Line, Line>> lines_that_meet(BodyIndex i, BodyIndex j);
    bool kennedy(BodyIndex i, BodyIndex j);
    void mark_rest();
    Names names_of_group(BodyIndex first) const;
    bool by_rigidity(BodyIndex i, BodyIndex j);
    bool by_rest(BodyIndex i, BodyIndex j);
    bool by_relative_rest(BodyIndex i, BodyIndex j, bool InstantCentre::*rests);
    bool by_coincidence(BodyIndex i, BodyIndex j);
    std::vector<BodyIndex> intermediates(BodyIndex i, BodyIndex j);
    LineOn<Plane::drawing> line_over(BodyIndex i, BodyIndex k, BodyIndex j);
    /// A place where a relative velocity may be drawn; `point` none: not a point of the file.
    struct Place {
        PointOn<Plane::drawing> at;
        std::string name;
        PointIndex point = none;
    };
    using TwoPlaces = std::pair<Place, Place>;
    std::vector<Place> places_of(BodyIndex first, BodyIndex second);
    /// From the velocities; of bodies at rest against each other, from their accelerations.
    void from_motion(Pair& pair, const Motion& motion);
    template <Plane plane>
    bool by_relative_motion(Pair& pair, const Motion& motion);
    Message told_from_velocities(Pair& pair, PointOn<Plane::drawing> found, const TwoPlaces& places,
                                 const Track<Plane::velocity>& track);
    Message told_by_normals(Pair& pair, Key sentence, const TwoPlaces& places);
    Symbol omega_of(BodyIndex body) const;
    std::pair<NodeIndex, Symbol> velocity_of_node(BodyIndex body, const Track<Plane::velocity>& track);
    bool at_relative_rest(const Pair& pair, const Motion& motion);

    Structure& structure_;
    Board& board_;
    RelativeRest rest_;
    SpaceDiagram diagram_;
    int count_ = 0;  ///< bodies
    std::vector<Pair> pairs_;
    int order_ = 0;
};

}  // namespace kinegraph
