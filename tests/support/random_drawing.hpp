// A mechanism file being drawn at random: places, bodies, joints, drivers, each added by a call; the text at the end.
// What the generators of random mechanisms share. Knows nothing of what makes a mechanism determined.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/random_mechanism.hpp"

namespace kinegraph {

/// A place or an arrow of the drawing, mm, in doubles: good enough to keep away from degenerate draws.
struct Spot {
    double x = 0, y = 0;
};
inline Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
inline Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
inline Spot operator*(double s, Spot a) { return {s * a.x, s * a.y}; }
inline double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
inline double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
double length(Spot a);
/// Sine of the angle between two lines: 0 where they are parallel.
double sine(Spot a, Spot b);

extern const double least_sine;  ///< of 6°: a little more than the promised 5°, compass places are rounded
inline constexpr double least_distance = 8;  ///< mm, between two places

struct Guide {
    std::string text;
    Spot along;
};

/// The file being written. All lengths in mm.
class Drawing {
public:
    /// The frame is body "1", index 0. `by_compass`: places are now and then constructed from others.
    Drawing(Random& random, bool by_compass);

    // --- places
    // ------------------------------------------------------------------------------------------------------------
    const Spot& at(int point) const { return points_[static_cast<std::size_t>(point)].spot; }
    const std::string& name(int point) const { return points_[static_cast<std::size_t>(point)].name; }
    bool is_free(Spot spot) const;
    /// A place of the drawing, in tenths of a millimetre.
    Spot anywhere();
    int given(Spot spot);
    /// A further place somewhere: by coordinates, or from points already there.
    std::optional<int> place();
    /// A free place by its coordinates.
    std::optional<int> given_anywhere();
    /// On the line of two places, at a ratio (tenths) of the way from the first to the second: exactly.
    std::optional<int> on_line(int from, int to, double ratio);
    /// The pin between two arms from `a` and `c`: the angle between the arms away from 0° and 180°.
    std::optional<int> pin_between(int a, int c);
    int any_point() { return random_.whole(0, static_cast<int>(points_.size()) - 1); }

    // --- bodies
    // ------------------------------------------------------------------------------------------------------------
    int body_count() const { return static_cast<int>(bodies_.size()); }
    int add_body(std::vector<int> points);
    std::vector<int>& points_of(int body) { return bodies_[static_cast<std::size_t>(body)].points; }
    /// One of a body's points, now and then a new one.
    std::optional<int> point_on(int body);
    void further_point(int body);
    std::string body_name(int body) const { return bodies_[static_cast<std::size_t>(body)].name; }

    // --- joints
    // ------------------------------------------------------------------------------------------------------------
    /// j hinged to i; now and then on the pin that holds i there already, as one hinge of several bodies.
    void revolute(int point, int i, int j);
    void weld(int point, int i, int j);
    // i slides on j; the joint's name is returned.
    std::string prismatic(int point, int i, int j, const Guide& guide);
    std::string pin_slot(int point, int i, int j, const Guide& guide);
    std::string pin_in_arc(int point, int i, int j, int centre);
    Guide any_guide();
    /// Rolling without slip and sliding contact at a place: circles about `centre_i` of i and `centre_j` of j, or a
    /// straight profile of j where `centre_j` is none.
    void rolling(int point, int i, int j, int centre_i, std::optional<int> centre_j);
    void contact(int point, int i, int j, int centre_i, std::optional<int> centre_j);
    /// Gears with these centres that the arm carries, or a gear and a rack, with the pitch point at a place.
    void gear(int point, int i, int j, int centre_i, std::optional<int> centre_j, int arm);
    /// The tangent of a circle at a place: exactly, of places in tenths.
    Guide tangent(int point, int centre) const;

    // --- drivers
    // -----------------------------------------------------------------------------------------------------------
    /// A decimal of few digits, not zero.
    std::string speed(double most);
    void spin(int body, int relative_to);
    void drive_slide(const std::string& joint);
    void drive_point(int body, int point, const Guide& along);
    int driver_count() const { return static_cast<int>(drivers_.size()); }

    // --- efforts
    // -----------------------------------------------------------------------------------------------------------
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
        std::size_t joint = 0;  ///< its place among the joints
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
