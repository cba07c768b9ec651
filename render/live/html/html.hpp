// Pieces of a page in HTML: escaped and typeset text, elements, the script and the style sheet as they are sent, the
// file around them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/page/theme.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// Text for HTML, without control characters.
std::string escaped(std::string_view text);
std::string html(const RichText& text);
std::string element(const std::string& tag, const std::string& attributes, const std::string& content);

/// The script or style sheet without comments and indentation, as it is sent. Requires that comments are whole lines,
/// follow two blanks, or are between /* and */, and that no string contains these.
std::string without_comments(std::string_view source, bool is_script);
/// A part of the page without the comment above it and the line breaks and indentation of its file.
std::string without_layout(std::string_view source);

/// "#0080ff"
std::string hex(Colour c);
/// The style sheet with paper and ink of the chosen theme, otherwise by the colour scheme of the system.
std::string style_of(const Theme& theme, const std::optional<Theme>& dark);
/// The whole file around `body`. Only a served page may connect, and only to its own server.
std::string document(const std::string& title, Language language, const std::string& style, const std::string& script,
                     const std::string& data, bool served, const std::string& body);

}  // namespace kinegraph::render
