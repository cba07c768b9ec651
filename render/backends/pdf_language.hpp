// PDF properties that cairo does not offer: the language of a tagged PDF, and the display of its title. Handles only
// the PDF syntax needed for that.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph::render {

/// The document with a new catalog appended (an incremental update) that sets /Lang, /Marked (for its tags) and
/// /DisplayDocTitle. `pdf` must have a cross-reference table, as cairo 1.16 writes it; a PDF with a cross-reference
/// stream is returned unchanged.
std::string with_language(std::string pdf, std::string_view language);

}  // namespace kinegraph::render
