// Label prices: what the rooms of lettering agree on, measures in mm and prices that are weighed against each other.
// Decides nothing; what only one room needs stands there.
#pragma once

namespace kinegraph::render::lettering {

constexpr double ink_margin = 0.45;  ///< clear paper round every letter
constexpr double label_gap = 0.8;    ///< between two labels
constexpr double line_gap = 3.2;     ///< between two that stand side by side, as words do, and tell a value

constexpr double covers_stroke = 50;  ///< the price that no wish outweighs
constexpr double covers_label = 400;
constexpr double one_line_price = 1.6;  ///< of two labels that are read as one
constexpr double leader_price = 6;
constexpr double crossing_price = 2.5;  ///< of a leader, for each stroke it crosses
constexpr double far_price = 0.9;       ///< for each mm from the nearest place

}  // namespace kinegraph::render::lettering
