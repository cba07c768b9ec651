// Rows of numbers as CSV or JSON, written while they are computed. Knows no mechanics.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/file/json_writer.hpp"
#include "engine/sentences/column.hpp"
#include "kinegraph/motion.hpp"

namespace kinegraph::app {

/// One text of rows. Its functions return false if the reader wants no more.
class RowText {
public:
    explicit RowText(const RowsText& to) : to_(to) {}

    /// `before`: writes the members of the JSON before the columns.
    void head(const std::vector<Column>& columns, const std::function<void(JsonWriter&)>& before);
    /// An empty cell is nothing in CSV, null in JSON.
    bool row(std::span<const double> values, const std::vector<bool>& empty);
    /// `after`: writes the members of the JSON after the rows.
    bool tail(const std::function<void(JsonWriter&)>& after);

private:
    bool is_json() const { return to_.form == RowsText::Form::json; }
    bool pass_on();

    RowsText to_;
    JsonWriter json_;
    std::string csv_;
};

}  // namespace kinegraph::app
