// Label lines: the lines that labels name, distances from them, and where a leader ends on one. Independent of places
// and prices.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/label_boxes.hpp"

namespace kinegraph::render::lettering {

/// Whether the label stands beside a line that it might be taken from: a vector, or a bar of a mechanism.
inline bool names_a_line(const LabelRequest& request) {
    return request.toward && !request.along && request.balloon <= 0;
}
/// Quick test by the bounding box: whether the line that a request's label names is farther away than `distance`.
bool is_beyond(const LabelRequest& request, Spot spot, double distance);
/// Distance from the line that a request's label names (its anchor is the middle of the line).
double distance_to_line(const LabelRequest& request, Spot spot);
/// … of a box, as long as the two do not meet.
double distance_to_line(const LabelRequest& request, const InkBox& box);
/// Whether both lines are parts of one.
bool lie_on_one_line(const LabelRequest& a, const LabelRequest& b);

/// Where leaders may end: on a point they name, or anywhere on a vector where no other vector is near.
class LeaderEnds {
public:
    explicit LeaderEnds(const std::vector<LabelRequest>& requests) : requests_(requests), ends_(requests.size()) {}
    /// The end of the leader of a label that stands in the box: the nearest one, rather across the vector than along
    /// it.
    Spot nearest(std::size_t label, const InkBox& box) const;

private:
    const std::vector<Spot>& ends_of(std::size_t label) const;

    const std::vector<LabelRequest>& requests_;
    mutable std::vector<std::vector<Spot>> ends_;  // of each label that has been asked for: most never have a leader
};

}  // namespace kinegraph::render::lettering
