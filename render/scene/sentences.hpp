// Sentences: what those of a solution are about, for sheets, steps and figures alike. Reads their kind and their arguments; says
// nothing in words and computes nothing.
#pragma once

#include "engine/solution.hpp"

namespace kinegraph::render {

/// It only names the pair that a centre lies at.
bool names_a_pair(Sentence sentence);
/// The list of centres says it as well.
bool told_by_list(Sentence sentence);
/// The ω or α that a sentence ends with; none: it finds no turning.
const Symbol* turning_found(const Message& message);
/// By it two forces, or two and a couple, take their line.
bool joins_two_forces(Sentence sentence);
/// It finds points of concurrency.
bool finds_a_meet(Sentence sentence);
/// It closes the polygon of a body's forces.
bool closes_a_polygon(Sentence sentence);
/// Whether the sentence speaks of this body, alone or among others that are taken together.
bool speaks_of(const Solution& solution, const Message& message, const FreeBody& body);

}  // namespace kinegraph::render
