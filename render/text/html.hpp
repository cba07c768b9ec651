// Rich text as XHTML that is also well-formed XML, for learning platforms. Independent of pages and quantities.
#pragma once

#include <string>
#include <string_view>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// Escapes text for an XML element or a quoted attribute. Invalid UTF-8 and characters that XML forbids become U+FFFD.
/// Braces become character references, because platforms interpret them.
std::string xml_text(std::string_view text);

/// Faces become <i> and <b>, scripts <sub> and <sup>, dots over a letter combining characters, a line break <br/>.
std::string to_html(const RichText& text);

}  // namespace kinegraph::render
