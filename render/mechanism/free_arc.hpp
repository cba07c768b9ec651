// Free arcs: where the arc of an ω or α of a body stands. The arc moves rather than its name, whose leader would be
// harder to follow.
#pragma once

#include "render/mechanism/free_paper.hpp"

namespace kinegraph::render::drawing {

/// ω or α of a body about a point.
struct Turning {
    BodyIndex body = none;
    Spot pivot;
    bool counter_clockwise = true;
    RichText text;
    StatementIndex statement = none;  ///< that finds it; none: it is given, of what drives
};

// Prices in units of a leader's, which is 6 in label_prices.hpp.
constexpr double without_name = 6;      // the name needs a leader
constexpr double read_at_another = 12;  // it would give another body its sense

constexpr double clear_of_arc = 1.5;  // between an arrow and its name, mm

/// The box of a name, at the origin.
InkBox box_of_name(const Sketch& sketch, const RichText& text);

/// An arc and a place where its name covers nothing, if there is one; the price of the arc alone.
struct PlacedArc {
    Arc arc;
    std::optional<InkBox> name;
    double price = 0;
};
PlacedArc free_arc(const Sketch& sketch, const FreePaper& paper, const Turning& turning);

}  // namespace kinegraph::render::drawing
