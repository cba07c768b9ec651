// Classes of sentences, for shortening a solution. Produces no text and computes nothing.
#pragma once

#include <optional>
#include <vector>

#include "engine/board/protocol.hpp"

namespace kinegraph::render {

/// Whether it only states that a centre lies at a pair.
bool names_a_pair(Key sentence);
/// The heading of a topic's steps.
Key steps_heading(Topic topic);
/// Whether the list of centres contains the same information.
bool told_by_list(Key sentence);

/// Whether two sentences differ only in the subjects that one sentence can list: points of a body that moves alike.
bool may_be_told_together(const Message& first, const Message& second);
/// The sentence that says the same of all subjects, with the arithmetic of each. At least two messages, each of which
/// may be told together with the first.
Message told_together(const std::vector<const Message*>& messages);
/// The motion that a sentence about centres uses, so that it stands after it: velocity or acceleration; none if it
/// stands with its own topic.
std::optional<Topic> follows(Key sentence);

/// Whether a statement only follows from another (images, equal rotations), so that a brief solution omits it. False if
/// it introduces a name that another statement uses.
bool is_incidental(const std::vector<Statement>& statements, std::size_t which);

}  // namespace kinegraph::render
