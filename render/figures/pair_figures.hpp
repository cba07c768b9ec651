// Figures of the catalogue of pairs: each pair with the motions it allows and the reactions it transmits; closure,
// links by number of pairs, chains, and multiple hinges with their binary schemes. Symbols, not to scale.
#pragma once

#include "engine/mechanism/pair_catalogue.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Left half: the two bodies with the motions of one (dashed arrows). Right half: that body alone with the components
/// of the action of the other. A room of 56 × 36 mm is enough for any pair. Kind "pair".
Figure plane_pair_figure(const DrawingContext& context, JointKind kind);
/// In axonometry, z upwards: the bodies with the remaining motions, and the transmitted components on a tripod of axes;
/// a couple has two heads. 74 × 46 mm.
Figure space_pair_figure(const DrawingContext& context, const SpacePair& pair);

/// Form closure: a roller in a slot that guides it on both sides. Force closure: a spring presses it against one side.
/// 50 × 34 mm.
enum class Closure { form, force };
Figure closure_figure(const DrawingContext& context, Closure closure);
/// A link with 2 to 4 pairs. 30 × 26 mm.
Figure link_figure(const DrawingContext& context, int pairs);
enum class ChainDrawn { open, closed, mixed };
Figure chain_figure(const DrawingContext& context, ChainDrawn chain);
/// Three bodies on one pin, or, with a scheme, on the equivalent binary pins. 34 × 30 mm.
Figure triple_hinge_figure(const DrawingContext& context, const BinaryScheme* scheme);
/// A tree: up to four bodies as dots, binary hinges as lines. 24 × 24 mm.
Figure scheme_figure(const DrawingContext& context, const BinaryScheme& scheme);

}  // namespace kinegraph::render
