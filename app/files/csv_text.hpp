// Cells of CSV, as they are written.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph::app {

/// In quotes where it must be.
inline std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

/// A text of someone else's: what a spreadsheet would take for a formula has an apostrophe before it, as OWASP advises.
inline std::string csv_cell_of_text(const std::string& text) {
    const bool looks_like_a_formula =
        !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
    return csv_cell(looks_like_a_formula ? "'" + text : text);
}

}  // namespace kinegraph::app
