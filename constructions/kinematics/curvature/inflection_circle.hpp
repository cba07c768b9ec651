// Pole, pole tangent and inflection circle of a body: by two paths whose centres of curvature are known (Bobillier,
// Euler and Savary), or by its accelerations.
#pragma once

#include "constructions/kinematics/curvature/draft.hpp"
#include "constructions/kinematics/curvature/known_paths.hpp"
#include "constructions/kinematics/curvature/simple_bodies.hpp"

namespace kinegraph::curvature {

class InflectionCircle {
public:
    InflectionCircle(CurvatureDraft& draft, KnownPaths& known, SimpleBodies& simple)
        : draft_(draft), board_(draft.board), known_(known), simple_(simple) {}

    /// From two points with known paths and different rays. False if there are none.
    bool by_known_paths(BodyIndex body);
    /// P = A + z∧v_A/ω, J = P + a_P/ω², a_P = a_A + α z∧AP − ω² AP. If a_P = 0 the body turns about P.
    void by_acceleration(BodyIndex body);

private:
    using State = CurvatureDraft::State;
    bool rays_meet(const KnownPath& a, const KnownPath& b);
    static Argument ray_of(const KnownPath& path);
    StatementIndex say_bobillier(BodyIndex body, const KnownPath& a, const KnownPath& b);
    void draw_pole_tangent(BodyIndex body, const KnownPath& a, const KnownPath& b);
    void draw_inflection_pole(BodyIndex body, const KnownPath& a, const KnownPath& b, Line normal);

    CurvatureDraft& draft_;
    Board& board_;
    KnownPaths& known_;
    SimpleBodies& simple_;
};

}  // namespace kinegraph::curvature
