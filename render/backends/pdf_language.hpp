// What cairo has no call for: the language of a tagged PDF, and that its title is to be shown. Knows of PDF as much as
// that takes.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph::render {

/// The same document, its catalog written anew behind it (an incremental update), with /Lang, /Marked (its tags
/// count) and /DisplayDocTitle. `pdf` has a
/// cross-reference table, as cairo 1.16 writes it; one with a stream in its place comes back as it is.
std::string with_language(std::string pdf, std::string_view language);

}  // namespace kinegraph::render
