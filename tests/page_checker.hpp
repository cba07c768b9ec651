// What a finished page shows wrongly: labels on strokes and on each other, marks beyond the frame. Reads only the page's display
// list, never the opinion of who placed the labels.
#pragma once

#include <string>
#include <vector>

#include "render/page.hpp"
#include "render/text.hpp"

namespace kinegraph::render {

struct Fault {
    enum class Kind {
        label_on_label,
        label_on_mechanism,  ///< a link, a joint, a symbol
        label_on_vector,
        label_on_construction,  ///< any other stroke of a figure
        leader_on_label,
        outside,  ///< of the sheet's frame
    } kind;
    std::string figure, label, other;
};

/// Every fault of the page, in drawing order. A label is the box of its glyphs' ink, turned with it (and the ring round a
/// number); a stroke is as wide as its pen.
std::vector<Fault> faults_of(const Page& page, const Fonts& fonts);

/// "velocity: a_B on label c", for messages.
std::string said(const Fault& fault);

}  // namespace kinegraph::render
