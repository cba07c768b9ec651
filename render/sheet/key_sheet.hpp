// The printable key of many exercises: a table with one row for each, on as many pages as it needs. Depends on no
// mechanics.
#pragma once

#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

struct KeyTable {
    std::string title;
    struct Column {
        std::string name, unit;
        bool is_text = false;  ///< aligned left; numbers are aligned right
        RichText symbol = {};  ///< replaces the name if not empty
    };
    std::vector<Column> columns;                 ///< the first identifies the row, and is repeated on every page
    std::vector<std::vector<std::string>> rows;  ///< one cell for each column
};

/// Uses paper, orientation, language, theme, author and date of `options`. Columns that do not fit beside the others go
/// to pages of their own.
std::vector<Page> lay_out_key(const KeyTable& table, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
