#include "render/live/html/html.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "render/live/live_page.hpp"
#include "render/text/bound_blank.hpp"

namespace kinegraph::render {
namespace {

/// A line without comments, which include the types for the type checker. `in_comment`: whether a comment continues
/// from the line before; updated.
std::string without_comments_of_line(std::string_view line, bool& in_comment) {
    std::string out;
    while (!line.empty()) {
        const std::size_t mark = line.find(in_comment ? "*/" : "/*");
        if (!in_comment) out += line.substr(0, mark);
        if (mark == std::string_view::npos) break;
        line.remove_prefix(mark + 2);
        if (in_comment) line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        in_comment = !in_comment;
    }
    return out;
}

/// Whether the line has a slash that is not a division: a regular expression or a comment.
bool has_slash_of_its_own(const std::string& line) {
    for (std::size_t at = line.find('/'); at != std::string::npos; at = line.find('/', at + 1))
        if (at == 0 || at + 1 == line.size() || line[at - 1] != ' ' || line[at + 1] != ' ') return true;
    return false;
}
/// Removes the blanks of a script line that are next to punctuation; two signs such as + + stay apart. Strings in
/// single quotes are kept. A line with other strings, regular expressions or comments is not changed.
std::string without_blanks(const std::string& line) {
    if (line.find_first_of("\\\"`") != std::string::npos || std::count(line.begin(), line.end(), '\'') % 2 != 0 ||
        has_slash_of_its_own(line))
        return line;
    const auto is_of = [](std::string_view signs, char c) { return signs.find(c) != std::string_view::npos; };
    const auto parts = [&](char c, char other) {
        return is_of(",=;?:<>*&|{}()[]/", c) || (is_of("+-", c) && !is_of("+-", other));
    };
    std::string out;
    bool in_string = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        in_string = in_string != (line[i] == '\'');
        const bool is_idle = !in_string && line[i] == ' ' && i > 0 && i + 1 < line.size() &&
                             (parts(line[i - 1], line[i + 1]) || parts(line[i + 1], line[i - 1]));
        if (!is_idle) out += line[i];
    }
    return out;
}

/// Removes blanks next to punctuation from a line of the style sheet. Blanks between words separate selectors and stay.
std::string without_blanks_of_style(std::string line) {
    for (const std::string_view idle : {"{ ", "; ", ": ", ", ", " {", " }"}) {
        const std::string sign(idle.front() == ' ' ? idle.substr(1) : idle.substr(0, 1));
        for (std::size_t at = line.find(idle); at != std::string::npos; at = line.find(idle, at))
            line.replace(at, idle.size(), sign);
    }
    return line;
}

std::string in_face(const std::string& text, Face face) {
    if (text.empty()) return {};
    const bool italic = face == Face::italic || face == Face::bold_italic,
               bold = face == Face::bold || face == Face::bold_italic;
    return (bold ? "<b>" : "") + std::string(italic ? "<i>" : "") + escaped(text) + (italic ? "</i>" : "") +
           (bold ? "</b>" : "");
}

/// Replaces each colour of the drawing by the colour with the same role in the dark theme.
std::string dark_rules(const Theme& light, const Theme& dark, const std::string& scope) {
    std::map<std::pair<std::string, std::string>, std::string> rules;  // by attribute and colour: the new colour
    const auto pair = [&](const char* attribute, Colour from, Colour to) {
        rules.try_emplace({attribute, hex(from)}, hex(to));
    };
    for (const char* attribute : {"stroke", "fill"}) {
        pair(attribute, light.text, dark.text);
        pair(attribute, light.paper, dark.paper);
        pair(attribute, light.secondary, dark.secondary);
        pair(attribute, light.skeleton, dark.skeleton);
        pair(attribute, light.faint, dark.faint);
        pair(attribute, light.accent, dark.accent);
        for (std::size_t i = 0; i < std::min(light.bodies.size(), dark.bodies.size()); ++i) {
            pair(attribute, light.bodies[i].line, dark.bodies[i].line);
            pair(attribute, light.bodies[i].letter, dark.bodies[i].letter);
            pair(attribute, light.bodies[i].tint, dark.bodies[i].tint);
        }
    }
    std::string css;
    for (const auto& [from, to] : rules)
        css += scope + " svg [" + from.first + "=\"" + from.second + "\"]{" + from.first + ":" + to + "}";
    return css;
}
std::string variables(const Theme& theme) {
    return "--paper:" + hex(theme.paper) + ";--text:" + hex(theme.text) + ";--secondary:" + hex(theme.secondary) +
           ";--faint:" + hex(theme.faint) + ";--accent:" + hex(theme.accent);
}
}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default:
                if (c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20) out += c;
        }
    }
    return out;
}

std::string without_comments(std::string_view source, bool is_script) {
    std::string out;
    bool in_comment = false;
    for (std::size_t at = 0; at < source.size();) {
        const std::size_t end = std::min(source.find('\n', at), source.size());
        std::string_view line = source.substr(at, end - at);
        at = end + 1;
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!in_comment && line.starts_with("//")) continue;
        std::string kept = without_comments_of_line(line, in_comment);
        if (const std::size_t aside = kept.find("  // "); is_script && aside != std::string::npos) kept.resize(aside);
        if (kept.empty()) continue;
        out += is_script ? without_blanks(kept) : without_blanks_of_style(std::move(kept));
        // No string continues on the next line, so that a line break after these signs can be omitted.
        if (std::string_view("{(,;").find(out.back()) == std::string_view::npos) out += '\n';
    }
    return out;
}

std::string without_layout(std::string_view source) {
    source.remove_prefix(source.find("-->\n") + 4);
    std::string out;
    for (std::size_t at = 0; at < source.size();) {
        const std::size_t end = std::min(source.find('\n', at), source.size());
        const std::size_t first = std::min(source.find_first_not_of(' ', at), end);
        out += source.substr(first, end - first);
        at = end + 1;
    }
    return out;
}

std::string html(const RichText& text) {
    std::string out;
    for (const Piece& piece : as_set(text)) {
        // Combining dots follow their letter.
        const std::string dots = piece.dots == 0 ? "" : piece.dots == 1 ? "\u0307" : "\u0308";
        out += in_face(unbound(piece.text) + dots, piece.face);
        if (!piece.sub.empty()) out += "<sub>" + in_face(piece.sub, piece.sub_face) + "</sub>";
        if (!piece.sup.empty()) out += "<sup>" + in_face(piece.sup, piece.sup_face) + "</sup>";
    }
    return out;
}

std::string element(const std::string& tag, const std::string& attributes, const std::string& content) {
    return "<" + tag + (attributes.empty() ? "" : " " + attributes) + ">" + content + "</" + tag + ">\n";
}

std::string hex(Colour c) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned each : {c.red, c.green, c.blue}) {
        text += digits[each >> 4U];
        text += digits[each & 15U];
    }
    return text;
}

std::string style_of(const Theme& theme, const std::optional<Theme>& dark) {
    std::string css = ":root{" + variables(theme) + "}";
    if (dark) {
        const std::string on_dark = variables(*dark) + ";color-scheme:dark";
        css += "@media screen{:root[data-theme=dark]{" + on_dark + "}" +
               dark_rules(theme, *dark, ":root[data-theme=dark]") + "}";
        css += "@media screen and (prefers-color-scheme:dark){:root:not([data-theme]){" + on_dark + "}" +
               dark_rules(theme, *dark, ":root:not([data-theme])") + "}";
    }
    return css + without_comments(live_style, false);
}

std::string document(const std::string& title, Language language, const std::string& style, const std::string& script,
                     const std::string& data, bool served, const std::string& body) {
    std::string page = "<!DOCTYPE html>\n<html lang=\"" + code_of(language) + "\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-" +
            sha256_base64(script) + "'; style-src 'sha256-" + sha256_base64(style) + "'; " +
            (served ? "connect-src 'self'; " : "") + "base-uri 'none'; form-action 'none'\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    page += element("title", "", escaped(title));
    page += element("style", "", style);
    page += "</head>\n<body>\n" + body;
    page += "<p id=\"announcement\" class=\"unseen\" aria-live=\"polite\"></p>\n";
    page += element("script", "type=\"application/json\" id=\"data\"", data);
    page += element("script", "", script);
    return page + "</body>\n</html>\n";
}

}  // namespace kinegraph::render
