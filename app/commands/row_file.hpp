// Row files: rows of numbers written while they are found, as CSV or JSON, and how far they have come. Knows no
// mechanics.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/outputs.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph::app {

/// The shortest decimal of a double; no minus before zero.
std::string decimal_of(double value);
/// In the quotes of JSON.
std::string in_json(const std::string& name);

/// The rows of a sweep in the form of a file.
class RowFile {
public:
    RowFile(Growing file, Format format) : file_(std::move(file)), format_(format) {}

    /// `before`: members of the JSON that come before the columns, without braces and without a last comma.
    void head(const std::vector<Column>& columns, const std::string& before);
    void row(std::span<const double> values);
    /// `after`: members of the JSON that come after the rows; may be empty.
    void tail(const std::string& after);
    /// What could not be written, if it could not.
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

/// On a terminal, once it takes over a second.
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
