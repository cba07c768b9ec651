// Sentences that name the lines of a construction by their numbers: "draw the lines ① ⟂ AB and ② ⟂ O4B".
#pragma once

#include <functional>
#include <string>

#include "render/text/words.hpp"

namespace kinegraph::render {

/// What stands before the name of a line in a sentence: its number and a blank, or nothing.
using BeforeLine = std::function<std::string(const LineReason&)>;
/// As say(); what stands before it does not part from the line's name.
RichText say(const Message& message, Language language, const BeforeLine& before_line);

}  // namespace kinegraph::render
