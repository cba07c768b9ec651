// The printable key of many exercises: a table with a row for each, on as many pages as it needs. Knows no mechanics.
#pragma once

#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

struct KeyTable {
    std::string title;
    struct Column {
        std::string name, unit;
        bool is_text = false;  ///< set from the left; numbers stand on the right
        RichText symbol = {};  ///< in place of the name, where there is one
    };
    std::vector<Column> columns;                 ///< the first tells the rows apart, and is repeated on every page
    std::vector<std::vector<std::string>> rows;  ///< a cell for each column
};

/// Of `options` the paper, its orientation, the language, the theme, author and date. Columns that find no place beside
/// the others go to pages of their own.
std::vector<Page> lay_out_key(const KeyTable& table, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
