// Cells of CSV files.
#pragma once

#include <string>
#include <string_view>

namespace kinegraph::app {

/// A cell, quoted if necessary.
inline std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
}

/// A cell with text from a user: if a spreadsheet would read it as a formula, an apostrophe is put before it, as OWASP
/// advises.
inline std::string csv_cell_of_text(const std::string& text) {
    const bool looks_like_a_formula =
        !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
    return csv_cell(looks_like_a_formula ? "'" + text : text);
}

}  // namespace kinegraph::app
