// Row files: see row_file.hpp.
#include "app/commands/row_file.hpp"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdio>

namespace kinegraph::app {
namespace {

std::string in_quotes(const std::string& name, const char* quote) {
    std::string text = "\"";
    for (const char c : name) {
        if (c == '"') text += quote;
        if (c == '\\' && *quote == '\\') text += '\\';
        text += c;
    }
    return text + '"';
}

}  // namespace

std::string decimal_of(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value);
    return {digits.data(), end.ptr};
}

std::string in_json(const std::string& name) { return in_quotes(name, "\\"); }

void RowFile::head(const std::vector<Column>& columns, const std::string& before) {
    const bool is_json = format_ == Format::json;
    if (is_json) text_ = "{\n  " + before + ",\n  \"columns\": [";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i > 0) text_ += is_json ? ", " : ",";
        const bool plain = !is_json && columns[i].name.find('"') == std::string::npos;
        text_ += plain ? columns[i].name : is_json ? in_json(columns[i].name) : in_quotes(columns[i].name, "\"");
    }
    text_ += is_json ? "],\n  \"rows\": [" : "\n";
}

void RowFile::row(std::span<const double> values) {
    const bool is_json = format_ == Format::json;
    if (is_json) text_ += rows_++ == 0 ? "\n    [" : ",\n    [";
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text_ += is_json ? ", " : ",";
        text_ += decimal_of(values[i]);
    }
    text_ += is_json ? "]" : "\n";
    constexpr std::size_t at_a_time = 1 << 16;
    if (text_.size() > at_a_time) flush();
}

void RowFile::tail(const std::string& after) {
    if (format_ == Format::json) {
        text_ += rows_ == 0 ? "]" : "\n  ]";
        text_ += after.empty() ? "\n}\n" : ",\n  " + after + "\n}\n";
    }
    flush();
}

void RowFile::flush() {
    if (!failure_) failure_ = file_.add(text_);
    text_.clear();
}

Progress::Progress(long all) : all_(all), shows_(::isatty(STDERR_FILENO) != 0) {}
Progress::~Progress() {
    if (shown_) std::fputs("\r     \r", stderr);
}
void Progress::at(long done) {
    constexpr long seldom = 16;  // a position may need a new plan, which takes milliseconds
    if (!shows_ || done % seldom != 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(200);
    shown_ = true;
    std::fprintf(stderr, "\r%3ld %%", 100 * done / all_);
}

}  // namespace kinegraph::app
