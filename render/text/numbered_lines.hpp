// Sentences that refer to the lines of a construction by their numbers: "draw the lines ① ⟂ AB and ② ⟂ O4B".
#pragma once

#include <functional>
#include <string>

#include "render/text/words.hpp"

namespace kinegraph::render {

/// The prefix of a line's name in a sentence: its number and a space, or an empty string.
using BeforeLine = std::function<std::string(const LineReason&)>;
/// As say(), with prefixes; no line break separates a prefix from its name.
RichText say(const Message& message, Language language, const BeforeLine& before_line);

}  // namespace kinegraph::render
