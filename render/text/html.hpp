// Rich text as XHTML that is well-formed XML as well, for learning platforms. Knows no page and no quantity.
#pragma once

#include <string>
#include <string_view>

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// Text of XML, in an element or in an attribute's quotes. What is no UTF-8, or no character of XML, is U+FFFD. Braces,
/// too, go as character references: platforms read what stands in them.
std::string xml_text(std::string_view text);

/// Faces as <i> and <b>, scripts as <sub> and <sup>, dots over a letter as combining characters; a line break is <br/>.
std::string to_html(const RichText& text);

}  // namespace kinegraph::render
