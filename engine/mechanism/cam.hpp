// Cam: the disc cam that gives a follower a law of motion, and the same cam in one position as a mechanism file. The
// cam turns about the origin; places are in the frame, in m, unless stated otherwise. Closed forms only; the mechanism
// file is solved elsewhere.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mechanism/law_breaks.hpp"
#include "engine/mechanism/law_curve.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/number/geometry.hpp"

namespace kinegraph {

struct Follower {
    enum class Moves { translating, oscillating } moves = Moves::translating;  ///< upwards (+y), or about `pivot`
    enum class Face { roller, flat, knife_edge } face = Face::roller;
    Exact radius;         ///< of the roller
    Exact offset;         ///< translating: x of its line; oscillating flat face: distance from the pivot to the face
    Vector pivot;         ///< oscillating
    Exact arm;            ///< oscillating: from the pivot to the roller's centre, or to the edge
    bool on_left = true;  ///< oscillating: the contact lies on the left of the line from the cam's centre to the pivot
};

/// A disc cam. The law gives the follower's rise (m, or rad, away from the cam) over the cam's rotation (rad, in the
/// cam's sense of rotation).
struct Cam {
    std::string source;
    Words title;
    Units units;
    Exact omega;        ///< counter-clockwise positive; not zero
    Exact base_circle;  ///< radius of the working profile at the beginning of the law
    Follower follower;
    Law law;  ///< over a whole turn, returning to its start, and never negative
};

/// Reads `{"kinegraph": 1, "cam": {…}}` as docs/file_problems.md says. Errors: every fault at once.
Result<Cam> read_cam(std::string_view text, std::string source);

/// The cam and its follower after a given rotation since the beginning of the law.
struct CamState {
    double turn = 0;             ///< rotation of the cam in its own sense, rad, not negative
    LawState rise;               ///< of the follower, m or rad; derivatives with respect to the rotation
    VectorOf<double> trace;      ///< the roller's centre, the edge; of a flat face the contact
    VectorOf<double> contact;    ///< on the working profile
    VectorOf<double> outward;    ///< unit normal of the cam at the contact
    double pitch_curvature = 0;  ///< of the pitch curve, 1/m; positive: convex. Of a flat face that of the profile
    double curvature = 0;        ///< of the working profile
    double pressure_angle = 0;   ///< between the normal and the velocity of the driven point, rad; signed
    VectorOf<double> on_cam(const VectorOf<double>& place,
                            double sense) const;  ///< in the cam's own frame, as drawn at turn 0
};

/// The closed forms of one cam, in doubles.
class CamGeometry {
public:
    /// Errors: a follower that cannot touch the cam with this base circle, offset, arm and pivot.
    static Result<CamGeometry> of(const Cam& cam);
    /// Sources: pitch curve and envelope by its parallel at the roller's radius; flat faces by the support function of
    /// the profile (E. A. Dijksman, Motion Geometry of Mechanisms; Norton, Cam Design, ch. 7).
    CamState at(double turn) const;
    /// The same for one side of a jump of the law, or for any other state of it.
    CamState at(double turn, const LawState& rise) const;
    /// 1: the cam turns counter-clockwise, −1: clockwise.
    double sense() const { return sense_; }
    /// 1 where an oscillating follower rises counter-clockwise, else −1.
    double rises() const { return rises_; }

private:
    CamState of_trace(double turn, const LawState& rise) const;
    CamState of_face(double turn, const LawState& rise) const;

    const Cam* cam_ = nullptr;
    LawCurve law_;
    double sense_ = 1, base_ = 0, roller_ = 0, offset_ = 0, arm_ = 0, height_ = 0, rises_ = 1;
    /// Seen from the pivot, at the beginning of the law: the angle of the follower's arm, or of its face's outward
    /// normal.
    double first_angle_ = 0;
    VectorOf<double> pivot_;
};

/// The mechanism file of one position: cam and follower with the cam's centre of curvature at the contact, the cam
/// driven.
std::string mechanism_file_of(const Cam& cam, const CamGeometry& geometry, double turn);

/// Where the speed of the follower jumps: the acceleration is infinite there, and the pitch curve has a corner.
struct CamCorner {
    CamState before, after;
    /// Whether material is cut away: at a convex corner the parallel at the roller's radius crosses itself, or the
    /// envelope of a flat face turns back, so that another position cuts away what one leaves. Otherwise an arc of the
    /// roller's radius, or a flat, joins both contacts.
    bool is_cut = false;
};

/// Design values of a cam, over its whole turn.
struct CamSummary {
    double most_pressure = 0, most_pressure_at = 0;     ///< the largest |pressure angle|, rad, and where it occurs
    std::optional<double> least_convex, least_concave;  ///< radii of curvature of the working profile, m
    double least_convex_at = 0, least_concave_at = 0;
    /// Intervals of rotation in which another position of the follower cuts away the contact (undercutting): the law is
    /// lost there. In order; an interval across the law's beginning goes from a larger to a smaller value.
    std::vector<std::array<double, 2>> undercuts;
    std::vector<CamCorner> corners;
    std::optional<std::array<double, 2>> face;  ///< flat face: how far the contact moves to each side, m
};
CamSummary summary_of(const Cam& cam, const CamGeometry& geometry);

/// The closed working profile in the cam's own frame: `positions` points and, at corners that are not sharp, the
/// roller's arc.
std::vector<VectorOf<double>> working_profile(const Cam& cam, const CamGeometry& geometry, int positions);

}  // namespace kinegraph
