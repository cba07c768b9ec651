// Rich text as XHTML: see html.hpp.
#include "render/text/html.hpp"

#include <algorithm>
#include <utility>

#include "render/text/bound_blank.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr std::string_view dot_above = "\u0307", two_dots_above = "\u0308";

bool is_of_xml(char32_t code) {
    return code == '\t' || code == '\n' ||
           (code >= 0x20 && code != 0xFFFE && code != 0xFFFF && code != replacement_character);
}

void put_in(std::string& html, const char* element, const std::string& content) {
    html += std::string("<") + element + ">" + content + "</" + element + ">";
}

std::string in_face(std::string html, Face face) {
    std::string set;
    if (face == Face::italic || face == Face::bold_italic) {
        put_in(set, "i", html);
        html = std::exchange(set, {});
    }
    if (face == Face::bold || face == Face::bold_italic) {
        put_in(set, "b", html);
        html = std::move(set);
    }
    return html;
}

std::string with_breaks(std::string_view text) {
    std::string html;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find('\n', from), text.size());
        html += (from > 0 ? "<br/>" : "") + xml_text(text.substr(from, to - from));
        from = to + 1;
    }
    return html;
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string escaped;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = at;
        const char32_t code = next_code_point(text, at);
        switch (code) {
            case '&': escaped += "&amp;"; break;
            case '<': escaped += "&lt;"; break;
            case '>': escaped += "&gt;"; break;
            case '"': escaped += "&quot;"; break;
            case '{': escaped += "&#123;"; break;
            case '}': escaped += "&#125;"; break;
            default:
                if (is_of_xml(code))
                    escaped += text.substr(from, at - from);
                else
                    escaped += "\uFFFD";
        }
    }
    return escaped;
}

std::string to_html(const RichText& text) {
    std::string html;
    for (const Piece& piece : text) {
        std::string letters = with_breaks(unbound(piece.text));
        if (piece.dots == 1) letters += dot_above;
        if (piece.dots == 2) letters += two_dots_above;
        html += in_face(std::move(letters), piece.face);
        if (!piece.sub.empty()) put_in(html, "sub", in_face(xml_text(piece.sub), piece.sub_face));
        if (!piece.sup.empty()) put_in(html, "sup", in_face(xml_text(piece.sup), piece.sup_face));
    }
    return html;
}

}  // namespace kinegraph::render
