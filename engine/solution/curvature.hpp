// What was found of the curvature of paths: the motion of one body to second order. Values in SI units, each with the
// element of the record that holds it.
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/number/geometry.hpp"
#include "engine/number/recorded.hpp"

namespace kinegraph {

/// The centre of curvature of the path of a body's point.
struct PathCentre {
    PointIndex point = none;
    std::string label;  ///< of the point
    std::string name;   ///< of the centre: not a name of the file's points
    Recorded<ProjectivePoint>
        centre;  ///< at infinity where the path is straight to the second order; none where the point rests
    Recorded<ProjectivePoint>
        foot;             ///< of the inflection pole on the ray: there the path is straight; none in a translation
    bool is_pin = false;  ///< its path is known from a body that shares it: nothing new is found there
    StatementIndex statement = none;
};
/// A straight line carried by a body (guide, slot, profile): the centre of curvature of its envelope.
struct EnvelopeCentre {
    JointIndex joint = none;
    std::string name;          ///< of the centre
    Recorded<Vector> touches;  ///< the point of the line that touches its envelope: the pole's foot
    Recorded<Vector> centre;
    StatementIndex statement = none;
};
/// The geometry of one body's motion to second order in this position: the motion of its pole, and the curvature of the
/// paths of its points (docs/notation.md).
struct Curvature {
    BodyIndex body = none;
    enum class Kind {
        general,      ///< the pole moves: there are a pole tangent and an inflection circle
        turning,      ///< the pole is at rest, so all points move on circles about it
        translation,  ///< the pole lies at infinity
        rest
    } kind = Kind::general;
    /// A point whose path has a known centre of curvature; its ray passes through the pole.
    struct Ray {
        PointIndex point = none;
        std::string from, to;  ///< names; `to` is empty where the centre lies at infinity
        Recorded<Vector> at;
        Recorded<ProjectivePoint> centre;
    };
    std::vector<Ray> rays;                 ///< two, where Bobillier's construction gave the pole tangent
    Recorded<ProjectivePoint> axis_point;  ///< where the line of the points meets that of the centres
    Recorded<ProjectivePoint> pole;
    Recorded<Vector> tangent;          ///< of the pole: a direction
    Recorded<Vector> inflection_pole;  ///< the other end of the inflection circle's diameter through the pole, m
    Recorded<Vector> inflection_centre;
    Recorded<Vector> tangential_pole;  ///< the same for Bresse's second circle; none where α = 0: it is the pole normal
    Recorded<Vector> acceleration_pole;
    std::string inflection_name, tangential_name,
        acceleration_name;  ///< "J", "H", "K", or with a number: not a name of the file's points
    StatementIndex pole_statement = none, tangent_statement = none, inflection_statement = none,
                   bresse_statement = none;
    std::vector<PathCentre> points;
    std::vector<EnvelopeCentre> envelopes;
};

}  // namespace kinegraph
