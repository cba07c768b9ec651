// Row files: writes rows of numbers as CSV or JSON while they are computed, and shows the progress. Knows no mechanics.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/outputs.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph::app {

/// The shortest decimal that reads back as the same double; never "-0".
std::string decimal_of(double value);
/// The text as a JSON string, with quotes.
std::string in_json(const std::string& name);

/// The rows of a sweep in the form of a file.
class RowFile {
public:
    RowFile(Growing file, Format format) : file_(std::move(file)), format_(format) {}

    /// `before`: JSON members to write before the columns, without braces and without a last comma.
    void head(const std::vector<Column>& columns, const std::string& before);
    void row(std::span<const double> values);
    /// `after`: JSON members to write after the rows; may be empty.
    void tail(const std::string& after);
    /// The write error, if there was one.
    const std::optional<NotWritten>& failure() const { return failure_; }
    Output finish() { return std::move(file_).finish(); }

private:
    void flush();

    Growing file_;
    Format format_;
    std::string text_;
    std::optional<NotWritten> failure_;
    long rows_ = 0;
};

/// Progress on a terminal, shown if the run takes over a second.
class Progress {
public:
    explicit Progress(long all);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void at(long done);

private:
    long all_;
    bool shows_, shown_ = false;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

}  // namespace kinegraph::app
