// The pen of the catalogue's figures: links, pins, blocks, wheels and arrows relative to a movable origin (mm, y
// downwards). `body` is a number that selects a colour of the theme. Depends on no pair.
#pragma once

#include <string>
#include <vector>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

class PairPen {
public:
    /// `id`: of the figure; `larger`: factor of all lengths except strokes and letters.
    PairPen(const DrawingContext& context, const std::string& id, double larger = 1);

    void at(Spot origin) { origin_ = larger_ * origin; }

    // Bodies.
    void bar(Spot from, Spot to, int body);
    void block(Spot middle, Spot u, Spot w, int body);
    void panel(std::vector<Spot> spots, int body);
    /// Filled with the colour of paper: a slot, a hole.
    void paper(std::vector<Spot> spots, int body);
    void plate(std::vector<Spot> ends, int body);
    void edge(std::vector<Spot> spots, int body);
    void wheel(Spot centre, double radius, int body);
    void wheel_without_hub(Spot centre, double radius, int body);
    /// The flank of a wheel from above: the arc of a large circle, closed below.
    void cap(Spot centre, double radius, int body);
    /// Pitch circle dash-dotted, teeth as trapezia. `phase`: of the tooth towards +x, in teeth.
    void gear(Spot centre, double radius, int teeth, double phase, int body);
    void pin(Spot at, int body);
    void clamp(Spot at);
    void dot(Spot at);
    void body_dot(Spot at, int body);
    void stroke(Spot from, Spot to);
    /// The support of a pin, and ground on the side `away`.
    void pivot(Spot at);
    void ground(Spot from, Spot to, Spot away);
    void spring(Spot from, Spot to);

    // Motions, actions and names.
    void axis(Spot from, Spot to);
    void both_ways(Spot middle, Spot reach, const std::string& name);
    void turn(Spot centre, double radius, double from, double to, const std::string& name);
    /// Along a curve, for a rotation in space.
    void curved(std::vector<Spot> spots, const std::string& name);
    void force(Spot tail, Spot tip, const std::string& name, bool tied = false);
    void couple(Spot centre, double radius, double from, double to, const std::string& name);
    /// As a vector with two heads.
    void couple_along(Spot tail, Spot tip, const std::string& name, bool tied = false);
    void name(const std::string& formula, Spot at);
    void body_name(const std::string& name, Spot at, int body);

    /// The finished figure, with labels placed within a room.
    Figure figure(Spot room);

private:
    const BodyColour& colour(int body) const;
    Pen outline(int body) const;
    Spot there(Spot spot) const { return origin_ + larger_ * spot; }
    std::vector<Spot> there(std::vector<Spot> spots) const;
    void label(const std::string& formula, Spot anchor, std::optional<Spot> toward, Colour ink);
    /// The dash pattern of motions, which distinguishes them from forces without colour.
    const std::vector<double>& dashed() const;

    const DrawingContext& context_;
    const Theme& theme_;
    Figure figure_;
    double larger_;
    Spot origin_;
};

}  // namespace kinegraph::render
