// Sentences by kind: which of a solution the list of centres says as well. Says nothing in words and computes nothing.
#pragma once

#include <vector>

#include "engine/board/board.hpp"

namespace kinegraph::render {

/// It only names the pair that a centre lies at.
bool names_a_pair(Sentence sentence);
/// The list of centres says it as well.
bool told_by_list(Sentence sentence);

/// Whether a sentence only carries on what another has decided (images, equal turnings), so that a brief solution does
/// without it; not one that gives a name which another uses.
bool is_incidental(const std::vector<Statement>& statements, std::size_t which);

}  // namespace kinegraph::render
