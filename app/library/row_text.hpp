// Rows of numbers as CSV or JSON, written while they are computed. Knows no mechanics.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "kinegraph/motion.hpp"

namespace kinegraph::app {

/// The shortest decimal that reads back as the same double; never "-0".
std::string decimal_of(double value);
/// "[1, 2.5]"
std::string json_list(const std::vector<double>& values);

/// One text of rows. Its functions return false if the reader wants no more.
class RowText {
public:
    explicit RowText(const RowsText& to) : to_(to) {}

    /// `before`: JSON members to write before the columns, without braces and without a last comma.
    void head(const std::vector<Column>& columns, const std::string& before);
    /// An empty cell is nothing in CSV, null in JSON.
    bool row(std::span<const double> values, const std::vector<bool>& empty);
    /// `after`: JSON members to write after the rows.
    bool tail(const std::string& after);

private:
    bool is_json() const { return to_.form == RowsText::Form::json; }
    bool pass_on();

    RowsText to_;
    std::string text_;
    bool is_first_ = true;
};

}  // namespace kinegraph::app
