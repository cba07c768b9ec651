// Label bodies: what the labels of a mechanism must not be taken for. The number of a body stands nearer to its body
// than to another; a leader crosses no body but its own, and ends nearer to no point that has another name.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/label_boxes.hpp"

namespace kinegraph::render::lettering {

/// Whether a segment crosses a stroke; touching an end is no crossing.
bool cross_each_other(Spot from, Spot to, const BodyStroke& stroke);

class Bodies {
public:
    Bodies(const std::vector<LabelRequest>& requests, const std::vector<BodyStroke>& strokes)
        : requests_(requests), strokes_(strokes) {}

    /// Price of the number of a body at a place that is nearer to another body.
    double near_another(const LabelRequest& request, const InkBox& box) const;
    /// Price of the leader of a label: for each body that it crosses and each named point that it passes.
    double led_astray(std::size_t label, Spot from, Spot to) const;

private:
    const std::vector<LabelRequest>& requests_;
    const std::vector<BodyStroke>& strokes_;
};

}  // namespace kinegraph::render::lettering
