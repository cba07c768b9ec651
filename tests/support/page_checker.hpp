// Finds faults of a finished page: labels on strokes and on each other, figures on text and on figures, marks beyond
// the frame. Reads only the display list of the page or its pixels, independently of the code that places labels.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

struct Fault {
    enum class Kind {
        label_on_label,
        label_on_mechanism,  ///< a link, a joint, a symbol
        label_on_vector,
        label_on_construction,  ///< any other stroke of a figure
        leader_on_label,
        figure_on_text,  ///< a stroke or a label on a caption, an equation, a table, the title block or another
                         ///< figure's label
        text_on_text,    ///< neither of them in a figure
        outside,         ///< beyond the sheet's frame
    } kind;
    std::string figure, label, other;
};

/// Every fault of the page, in drawing order. A label is the box of its glyphs' ink, turned with it (and the circle
/// round a number); a stroke has the width of its pen.
std::vector<Fault> faults_of(const Page& page, const Fonts& fonts);

/// The number of pixels inked both by letters (labels, captions, tables) and by strokes of a mechanism or a vector,
/// each drawn without the other at `dpi`. Inked means covered by more than half, so such a pixel is an overlap whatever
/// the antialiasing.
std::size_t pixels_in_common(const Page& page, const Fonts& fonts, double dpi);

/// "velocity: a_B on label c", for messages.
std::string said(const Fault& fault);

}  // namespace kinegraph::render
