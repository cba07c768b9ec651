// Label prices: the distances (mm) and prices shared by the files that place labels. A constant that one file alone
// needs stands in that file.
#pragma once

namespace kinegraph::render::lettering {

constexpr double ink_margin = 0.45;  ///< clear paper round every letter, mm
constexpr double label_gap = 0.8;    ///< between two labels, mm
constexpr double letter_gap = 2.2;   ///< between two symbols in a row, which would read as a product, mm
constexpr double line_gap = 3.2;     ///< between two labels side by side on one line, which would read as one text, mm

constexpr double covers_stroke = 50;  ///< outweighs every preference
constexpr double covers_label = 400;
constexpr double one_line_price = 1.6;  ///< for two labels that read as one
constexpr double leader_price = 6;
constexpr double crossing_price = 2.5;  ///< per stroke that a leader crosses
constexpr double far_price = 0.9;       ///< per mm beyond the nearest place

}  // namespace kinegraph::render::lettering
