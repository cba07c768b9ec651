// Figures of the catalogue of pairs: each pair as it is drawn, with the motions it allows and beside it the reactions
// it transmits; closure, links by their number of pairs, chains, and multiple hinges with their binary schemes.
// Symbols, not to scale.
#pragma once

#include "engine/mechanism/pair_catalogue.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Half of the width each: the two bodies with the motions of the one (dashed arrows), and that body alone with the
/// components of what the other does to it. A room of 56 × 36 mm holds any of them. Kind "pair".
Figure plane_pair_figure(const DrawingContext& context, JointKind kind);
/// In axonometry, z upright: the bodies with the motions left, and the components transmitted on a tripod of axes; a
/// couple has two heads. 74 × 46 mm.
Figure space_pair_figure(const DrawingContext& context, const SpacePair& pair);

/// Form closure: a roller in a slot that holds it on both sides. Force closure: a spring presses it on one side. 50 ×
/// 34 mm.
enum class Closure { form, force };
Figure closure_figure(const DrawingContext& context, Closure closure);
/// A link with so many pairs, 2 to 4. 30 × 26 mm.
Figure link_figure(const DrawingContext& context, int pairs);
enum class ChainDrawn { open, closed, mixed };
Figure chain_figure(const DrawingContext& context, ChainDrawn chain);
/// Three bodies on one pin, or, with a scheme, on the binary pins that stand for it. 34 × 30 mm.
Figure triple_hinge_figure(const DrawingContext& context, const BinaryScheme* scheme);
/// Up to four bodies as dots, a line for each binary hinge: a tree. 24 × 24 mm.
Figure scheme_figure(const DrawingContext& context, const BinaryScheme& scheme);

}  // namespace kinegraph::render
