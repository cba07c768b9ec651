// Cells of CSV, as they are written.
#pragma once

#include <string>

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

}  // namespace kinegraph::app
