// Implementation of key_sheet.hpp.
#include "render/sheet/key_sheet.hpp"

#include <algorithm>

#include "lang/keys/sheet.hpp"
#include "render/content/title_block.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

constexpr double between = 5, row_height = 5, head_height = 10.5, title_height = 9, longest_cell = 60;  // mm

/// Indices of columns that stand side by side; the first column of the table is always included.
using Group = std::vector<std::size_t>;

class KeySheet {
public:
    KeySheet(const KeyTable& table, const SheetOptions& options, const Fonts& fonts)
        : table_(table), options_(options), fonts_(fonts), format_(format_of(options.paper, options.orientation)) {
        for (std::size_t c = 0; c < table_.columns.size(); ++c) {
            double width = std::max(head(table_.columns[c]).width, small(table_.columns[c].unit).width);
            for (const auto& row : table_.rows) width = std::max(width, cell(row[c]).width);
            widths_.push_back(width);
        }
    }

    std::vector<Page> pages() const {
        const double room = format_.content.height() - title_height - head_height;
        const std::size_t on_a_page = std::max<std::size_t>(1, static_cast<std::size_t>(room / row_height));
        const std::vector<Group> groups = this->groups();
        std::vector<std::vector<Mark>> sheets;
        for (const Group& group : groups)
            for (std::size_t first = 0; first == 0 || first < table_.rows.size(); first += on_a_page)
                sheets.push_back(sheet(group, first, std::min(first + on_a_page, table_.rows.size())));
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets.size(); ++i)
            pages.push_back(framed(std::move(sheets[i]), i + 1, sheets.size()));
        return pages;
    }

private:
    ShapedLine small(const std::string& text) const { return fonts_.shape(with_powers(text), options_.theme.small); }
    ShapedLine head(const KeyTable::Column& column) const {
        return column.symbol.empty() ? small(column.name) : fonts_.shape(column.symbol, options_.theme.small);
    }
    ShapedLine cell(const std::string& text) const {
        ShapedLine line = fonts_.shape(with_powers(text), options_.theme.body_text);
        if (line.width <= longest_cell) return line;
        return shaped_with_its_end(text, options_.theme.body_text, fonts_, longest_cell);
    }

    std::vector<Group> groups() const {
        std::vector<Group> groups{{0}};
        double width = widths_[0];
        for (std::size_t c = 1; c < widths_.size(); ++c) {
            if (groups.back().size() > 1 && width + between + widths_[c] > format_.content.width()) {
                groups.push_back({0});
                width = widths_[0];
            }
            groups.back().push_back(c);
            width += between + widths_[c];
        }
        return groups;
    }

    std::vector<Mark> sheet(const Group& group, std::size_t first, std::size_t end) const {
        std::vector<Mark> marks;
        const Theme& theme = options_.theme;
        const double top = format_.content.min.y + title_height;
        double left = format_.content.min.x, whole = -between;
        for (const std::size_t c : group) whole += widths_[c] + between;
        const auto rule = [&](double y, double pen) {
            marks.emplace_back(
                line({format_.content.min.x, y}, {format_.content.min.x + whole, y}, {pen, theme.text, {}, false}));
        };
        rule(top, theme.outline);
        rule(top + head_height - 1, theme.thin);
        for (const std::size_t c : group) {
            const auto put = [&](const ShapedLine& text, double y, Colour colour) {
                const double x = table_.columns[c].is_text ? left : left + widths_[c] - text.width;
                if (text.width > 0) set_text(marks, text, {x, y}, colour, "text");
            };
            put(head(table_.columns[c]), top + 3.8, theme.text);
            put(small(table_.columns[c].unit), top + 8, theme.secondary);
            for (std::size_t r = first; r < end; ++r)
                put(cell(table_.rows[r][c]), top + head_height + row_height * static_cast<double>(r - first) + 3.4,
                    theme.text);
            left += widths_[c] + between;
        }
        rule(top + head_height + row_height * static_cast<double>(end - first), theme.outline);
        return marks;
    }

    Page framed(std::vector<Mark> marks, std::size_t index, std::size_t count) const {
        const Theme& theme = options_.theme;
        const Box& inner = format_.inner;
        Page page;
        page.width = format_.width;
        page.height = format_.height;
        page.paper = theme.paper;
        page.title = table_.title;
        page.language = code_of(options_.language);
        page.marks.emplace_back(polyline({inner.min, {inner.max.x, inner.min.y}, inner.max, {inner.min.x, inner.max.y}},
                                         {theme.outline, theme.text, {}, false}, true));
        std::string origin;
        for (const std::string& each : {options_.author, options_.date})
            if (!each.empty()) origin += each + "  ·  ";
        const ShapedLine sheet = fonts_.shape(one_piece(origin + word(lang::sheet::block_sheet, options_.language) +
                                                        " " + std::to_string(index) + "/" + std::to_string(count)),
                                              theme.small);
        const double baseline = format_.content.min.y + 4.5;
        set_text(page.marks, sheet, {format_.content.max.x - sheet.width, baseline}, theme.secondary, "text");
        set_text(page.marks,
                 shaped_within(one_piece(table_.title, Face::bold), theme.equation, fonts_,
                               format_.content.width() - sheet.width - between),
                 {format_.content.min.x, baseline}, theme.text, "text");
        page.marks.insert(page.marks.end(), std::make_move_iterator(marks.begin()),
                          std::make_move_iterator(marks.end()));
        return page;
    }

    const KeyTable& table_;
    const SheetOptions& options_;
    const Fonts& fonts_;
    SheetFormat format_;
    std::vector<double> widths_;
};

}  // namespace

std::vector<Page> lay_out_key(const KeyTable& table, const SheetOptions& options, const Fonts& fonts) {
    return KeySheet(table, options, fonts).pages();
}

}  // namespace kinegraph::render
