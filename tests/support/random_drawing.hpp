// Builds a random mechanism file: each call adds a point, body, joint or driver; then the text is written. Shared by
// the generators of random mechanisms. Does not check whether the mechanism is determined.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/random_mechanism.hpp"

namespace kinegraph {

/// A point or vector of the drawing, mm, in doubles: accurate enough to avoid degenerate cases.
struct Spot {
    double x = 0, y = 0;
};
inline Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
inline Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
inline Spot operator*(double s, Spot a) { return {s * a.x, s * a.y}; }
inline double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
inline double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
double length(Spot a);
/// The sine of the angle between two lines: 0 if they are parallel.
double sine(Spot a, Spot b);

extern const double least_sine;  ///< sine of 6°, a margin over the promised 5° because compass points are rounded
inline constexpr double least_distance = 8;  ///< mm, between two points

struct Guide {
    std::string text;
    Spot along;
};

/// The file being built. All lengths in mm.
class RandomDrawing {
public:
    /// The frame is body "1", index 0. `by_compass`: points are sometimes constructed from others.
    RandomDrawing(Random& random, bool by_compass);

    // --- points ---
    const Spot& at(int point) const { return points_[static_cast<std::size_t>(point)].spot; }
    const std::string& name(int point) const { return points_[static_cast<std::size_t>(point)].name; }
    bool is_free(Spot spot) const;
    /// A random place, in tenths of a millimetre.
    Spot anywhere();
    int given(Spot spot);
    /// Adds a point at a random place: by coordinates, or constructed from existing points.
    std::optional<int> place();
    /// Adds a point by its coordinates, away from the others.
    std::optional<int> given_anywhere();
    /// Adds a point on the line of two points, exactly at a ratio (tenths) of the way from the first to the second.
    std::optional<int> on_line(int from, int to, double ratio);
    /// Adds the pin between two arms from `a` and `c`; the angle between the arms stays away from 0° and 180°.
    std::optional<int> pin_between(int a, int c);
    int any_point() { return random_.whole(0, static_cast<int>(points_.size()) - 1); }

    // --- bodies ---
    int body_count() const { return static_cast<int>(bodies_.size()); }
    int add_body(std::vector<int> points);
    std::vector<int>& points_of(int body) { return bodies_[static_cast<std::size_t>(body)].points; }
    /// One of a body's points, sometimes a new one.
    std::optional<int> point_on(int body);
    void further_point(int body);
    std::string body_name(int body) const { return bodies_[static_cast<std::size_t>(body)].name; }

    // --- joints ---
    /// A hinge of j to i; sometimes on an existing pin of i, as one hinge of several bodies.
    void revolute(int point, int i, int j);
    void weld(int point, int i, int j);
    // A slide of i on j; returns the name of the joint.
    std::string prismatic(int point, int i, int j, const Guide& guide);
    std::string pin_slot(int point, int i, int j, const Guide& guide);
    std::string pin_in_arc(int point, int i, int j, int centre);
    Guide any_guide();
    /// Rolling without slip and sliding contact at a point: circles with centres `centre_i` of i and `centre_j` of j,
    /// or a straight profile of j if there is no `centre_j`.
    void rolling(int point, int i, int j, int centre_i, std::optional<int> centre_j);
    void contact(int point, int i, int j, int centre_i, std::optional<int> centre_j);
    /// A gear pair on an arm, with these centres and this pitch point; a gear and a rack if there is no `centre_j`.
    void gear(int point, int i, int j, int centre_i, std::optional<int> centre_j, int arm);
    /// The tangent of a circle at a point, exact for coordinates in tenths.
    Guide tangent(int point, int centre) const;

    // --- drivers ---
    /// A decimal of few digits, not zero.
    std::string speed(double most);
    void spin(int body, int relative_to);
    void drive_slide(const std::string& joint);
    void drive_point(int body, int point, const Guide& along);
    int driver_count() const { return static_cast<int>(drivers_.size()); }

    // --- input forces and couples ---
    void balance_by_couple(int body, int from);
    void balance_by_force(int body, int point, const Guide& along);
    void balance_in_slide(const std::string& joint);

    std::string text() const;

private:
    std::string unused_name();
    int add(Spot spot, std::string placement);
    std::string body_pair(int i, int j) const;
    std::string slide(const char* kind, int point, int i, int j, const std::string& along);
    void higher_pair(const char* kind, int point, int i, int j, int centre_i, std::optional<int> centre_j,
                     const std::string& more = "");
    void balance(const char* kind, const std::string& where);
    std::string joint_text(std::size_t index) const;

    struct Hinge {
        int point = -1;
        std::vector<int> bodies;
        std::size_t joint = 0;  ///< index of the joint
    };
    struct Point {
        std::string name;
        Spot spot;
        std::string placement;
    };
    struct Body {
        std::string name;
        std::vector<int> points;
    };
    Random& random_;
    bool by_compass_;
    std::vector<Point> points_;
    std::vector<Body> bodies_;
    std::vector<std::string> joints_, drivers_, efforts_;
    std::vector<Hinge> hinges_;
    int slides_ = 0;
};

}  // namespace kinegraph
