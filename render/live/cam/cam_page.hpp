// The page of a cam: its true profile turns, the follower keeps its law, the plots and the values follow. Computes no
// mechanics: every position that it shows is one of the rows it is given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/cam.hpp"
#include "engine/sentences/column.hpp"
#include "render/sheet/cam_notes.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// What the page draws, at the beginning of the law; m, the cam turns about (0, 0).
struct CamPicture {
    using Outline = std::vector<VectorOf<double>>;
    Outline profile;                             ///< the working profile, closed
    Outline pitch;                               ///< the pitch curve; empty where the follower has no roller
    Outline face;                                ///< of a flat follower; empty: none
    double base = 0;                             ///< radius of the base circle
    double roller = 0;                           ///< radius; 0: none
    VectorOf<double> trace;                      ///< the roller's centre or the edge
    std::optional<VectorOf<double>> pivot = {};  ///< of an oscillating follower
};
/// Evenly distributed rotations of the cam. `columns`: of `table` but the first, in its order, SI.
struct CamRows {
    std::vector<CamState> states;
    std::vector<std::vector<double>> columns;
};

/// `table`: the cycle with both sides of its jumps, for the plots; `drawn`: the mechanism of one position. `facts`: of
/// the whole turn, as text. The page loads nothing, as that of a mechanism (live_page.hpp).
std::string cam_page(const Words& title, const CamGeometry& geometry, const CamPicture& picture, const CamRows& rows,
                     const CycleTable& table, const CamNotes& notes, const std::vector<std::string>& facts,
                     const Mechanism& drawn, const SheetOptions& options, const std::optional<Theme>& dark);

}  // namespace kinegraph::render
