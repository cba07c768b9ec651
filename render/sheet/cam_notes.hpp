// Text on the sheet of a cam: its data, and the captions of its plots. Draws nothing.
#pragma once

#include <vector>

#include "engine/mechanism/cam.hpp"
#include "engine/sentences/column.hpp"
#include "render/text/rich_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

struct CamNotes {
    double drawn = 0;                ///< rotation of the cam in the drawn position, rad
    std::vector<RichText> data;      ///< one paragraph each
    std::vector<RichText> captions;  ///< of the plots, one for each column but the first
};

/// `table`: of the cam's cycle; `drawn`: its mechanism in one position.
CamNotes notes_of(const Cam& cam, const CamGeometry& geometry, double drawn_at, const CycleTable& table,
                  const Mechanism& drawn, Language language);

}  // namespace kinegraph::render
