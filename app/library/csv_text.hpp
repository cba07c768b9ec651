// Lines of CSV files.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace kinegraph {

class CsvLine {
public:
    /// Adds a cell, quoted if necessary.
    CsvLine& operator<<(std::string_view text) {
        if (!std::exchange(is_first_, false)) text_ += ',';
        if (text.find_first_of(",;\"\r\n") == std::string::npos) {
            text_ += text;
            return *this;
        }
        text_ += '"';
        for (const char c : text) {
            if (c == '"') text_ += '"';
            text_ += c;
        }
        text_ += '"';
        return *this;
    }
    /// Adds a cell with text from a user: if a spreadsheet would read it as a formula, an apostrophe is put before it,
    /// as OWASP advises.
    CsvLine& text_of_others(const std::string& text) {
        const bool looks_like_a_formula =
            !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
        return *this << (looks_like_a_formula ? "'" + text : text);
    }
    /// The line with its line feed.
    std::string text() && { return std::move(text_) + "\n"; }

private:
    std::string text_;
    bool is_first_ = true;
};

}  // namespace kinegraph
