// Classes of sentences, for shortening a solution. Produces no text and computes nothing.
#pragma once

#include <vector>

#include "engine/board/board.hpp"

namespace kinegraph::render {

/// Whether it only states that a centre lies at a pair.
bool names_a_pair(Key sentence);
/// The heading of a topic's steps.
Key steps_heading(Topic topic);
/// Whether the list of centres contains the same information.
bool told_by_list(Key sentence);

/// Whether a statement only follows from another (images, equal rotations), so that a brief solution omits it. False if
/// it introduces a name that another statement uses.
bool is_incidental(const std::vector<Statement>& statements, std::size_t which);

}  // namespace kinegraph::render
