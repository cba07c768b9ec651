// Ways to draw a dimension: each of a length, a radius, an angle with its lines, its text's place and how far it lies
// from what is wished. Owns the shapes; whether they are in the way is told in dimension_room.hpp.
#pragma once

#include <vector>

#include "render/mechanism/dimension_data.hpp"
#include "render/mechanism/dimension_room.hpp"

namespace kinegraph::render::drawing {

/// Trials draw with what this refers to, and with the datum that they are of: both outlive them. `width`: of the text.
class DimensionTrials {
public:
    DimensionTrials(const Sketch& sketch, bool sought_far) : sketch_(sketch), sought_far_(sought_far) {}

    /// None where there is no room for the text.
    std::vector<DimensionTrial> of(const DimensionedLength& datum, double width) const;
    std::vector<DimensionTrial> of(const DimensionedRadius& datum, double width) const;
    std::vector<DimensionTrial> of(const DimensionedAngle& datum, double width) const;
    /// With its text on a shelf to which a leader goes, where all else stands.
    std::vector<DimensionTrial> led_out_of(const DimensionedAngle& datum, double width) const;

private:
    /// A level of a dimension line across the run, and what it costs to be so far from the mechanism.
    struct Level {
        double at, side, reach;
    };
    /// A trial of a length with its dimension line: arrows and text between its ends.
    DimensionTrial between_ends(DimensionTrial trial, const Bar& run) const;
    /// The same of a short one: arrows from outside, the text on the line that goes on beyond its second end.
    DimensionTrial outside_of_end(DimensionTrial trial, const Bar& run, double width) const;
    void put_text(DimensionTrial& trial, Spot middle, Spot along) const;
    /// Beyond both ends; of ends that lie far from each other across the run also between them, near the one or the
    /// other.
    std::vector<Level> levels_of(double rise) const;
    static double leader_angle(double step);
    /// From outside onto the rim, the figure beyond on a shelf.
    DimensionTrial from_outside(const DimensionedRadius& datum, double angle, double length, double width,
                                double price) const;
    /// From the centre to the rim, the text along it.
    DimensionTrial from_centre(const DimensionedRadius& datum, double angle, double price) const;
    /// A trial of a narrow angle with its arc, which begins before the line that it is counted from, and its text
    /// there.
    DimensionTrial beside_base(DimensionTrial trial, const DimensionedAngle& datum, double radius, double width) const;
    /// A trial of an angle with its arc, its text on a shelf to which a leader goes from the arc: where the lines that
    /// it is between leave no room for letters.
    DimensionTrial led_out(DimensionTrial trial, const DimensionedAngle& datum, double radius, double share,
                           double reach, double width) const;
    /// The arc of an angle and the line that it is counted from; no text yet.
    DimensionTrial arc_of(const DimensionedAngle& datum, double radius) const;
    Pen thin() const { return {sketch_.theme.thin, sketch_.theme.text, {}, false}; }

    const Sketch& sketch_;
    bool sought_far_;
};

}  // namespace kinegraph::render::drawing
