// Candidates for drawing a dimension of a length, a radius or an angle: lines, position of the text, and the price of
// deviating from the preferred place. Obstacles are priced in dimension_room.hpp.
#pragma once

#include <vector>

#include "render/mechanism/dimension_data.hpp"
#include "render/mechanism/dimension_room.hpp"

namespace kinegraph::render::drawing {

/// The candidates refer to this object's arguments and to their datum; both must outlive them. `width`: of the text,
/// mm.
class DimensionTrials {
public:
    DimensionTrials(const Sketch& sketch, bool sought_far) : sketch_(sketch), sought_far_(sought_far) {}

    /// Empty if there is no room for the text.
    std::vector<DimensionTrial> of(const DimensionedLength& datum, double width) const;
    std::vector<DimensionTrial> of(const DimensionedRadius& datum, double width) const;
    std::vector<DimensionTrial> of(const DimensionedAngle& datum, double width) const;
    /// Candidates with the text alone, along the measured segment, for a length without any other place.
    std::vector<DimensionTrial> beside(const DimensionedLength& datum, double width) const;
    /// Candidates with the text on a shelf at the end of a leader, for an angle without any other place.
    std::vector<DimensionTrial> led_out_of(const DimensionedAngle& datum, double width) const;

private:
    /// A distance of the dimension line from the measured segment, and its price.
    struct Level {
        double at, side, reach;
    };
    /// Completes a candidate for a length: arrows and text between its ends.
    DimensionTrial between_ends(DimensionTrial trial, const Bar& run) const;
    /// The same for a short length: arrows from outside, the text beyond its second end.
    DimensionTrial outside_of_end(DimensionTrial trial, const Bar& run, double width) const;
    void put_text(DimensionTrial& trial, Spot middle, Spot along) const;
    /// Distances beyond both ends. If the ends are far apart across the direction of the dimension, also distances
    /// between them, near either end.
    std::vector<Level> levels_of(double rise) const;
    static double leader_angle(double step);
    /// A leader from outside to the rim, with the number on a shelf beyond.
    DimensionTrial from_outside(const DimensionedRadius& datum, double angle, double length, double width,
                                double price) const;
    /// From the centre to the rim, the text along the line.
    DimensionTrial from_centre(const DimensionedRadius& datum, double angle, double price) const;
    /// Completes a candidate for a narrow angle: the arc begins before the base line, and the text stands there.
    DimensionTrial beside_base(DimensionTrial trial, const DimensionedAngle& datum, double radius, double width) const;
    /// Completes a candidate for an angle whose sides leave no room for the text: a leader from the arc to a shelf with
    /// the text.
    DimensionTrial led_out(DimensionTrial trial, const DimensionedAngle& datum, double radius, double share,
                           double reach, double width) const;
    /// The arc of an angle and its base line, without text.
    DimensionTrial arc_of(const DimensionedAngle& datum, double radius) const;
    Pen thin() const { return {sketch_.theme.thin, sketch_.theme.text, {}, false}; }

    const Sketch& sketch_;
    bool sought_far_;
};

}  // namespace kinegraph::render::drawing
