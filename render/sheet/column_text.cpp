// Column text: a heading never parts from the lines below it, no line stands alone in a column, and a table that goes on has its
// head again.
#include "render/sheet/column_text.hpp"

#include <algorithm>

#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double passage_gap = 3.5, grace = 1e-6;
constexpr double two_lines = 7.5;  // mm; rows lower than this do not stand alone in a column

bool is_wider(const Passage& passage, double measure) {
    constexpr double ink = 0.2;
    return (!passage.heading.marks.empty() && box_of(passage.heading.marks).max.x > measure + ink) ||
           std::any_of(passage.rows.begin(), passage.rows.end(), [&](const Block& row) { return row.width > measure + ink; });
}

/// How many rows from one on stay together: no line is parted from what it belongs to, the first ones from their heading, the
/// last ones from each other.
std::size_t end_of_group(const std::vector<Block>& rows, std::size_t first) {
    std::size_t end = first + 1;
    double height = rows[first].height;
    while (first == 0 && end < rows.size() && height < two_lines) height += rows[end++].height;
    double left = 0;
    for (std::size_t i = end; i < rows.size() && left < two_lines; ++i) left += rows[i].height;
    return left < two_lines ? rows.size() : end;
}

}  // namespace

ColumnText::ColumnText(std::vector<Passage> passages, double measure, double scale)
    : passages_(std::move(passages)), measure_(measure) {
    const auto reduce = [scale](Block& block) { block = scaled(std::move(block), scale); };
    for (Passage& passage : passages_) {
        if (scale != 1) {
            reduce(passage.heading);
            reduce(passage.head);
            std::for_each(passage.rows.begin(), passage.rows.end(), reduce);
        }
        too_wide_ = too_wide_ || is_wider(passage, measure_);
    }
}

bool ColumnText::flow(const std::vector<TextColumn>& columns, double height,
                      const std::function<void(const Block&, std::size_t column, double y)>& place) const {
    std::size_t column = 0;
    double y = 0;
    const auto room = [&] { return height - columns[column].lift - columns[column].top + grace; };
    const auto put = [&](const Block& block) {
        if (place && !block.marks.empty()) place(block, column, columns[column].top + y);
        y += block.height;
    };
    for (const Passage& passage : passages_)
        for (std::size_t i = 0, end = 0; i < passage.rows.size(); i = end) {
            const bool first = i == 0;
            end = end_of_group(passage.rows, i);
            double own = 0;
            for (std::size_t k = i; k < end; ++k) own += passage.rows[k].height;
            const double above = first ? passage.heading.height + passage.head.height : 0;
            const double before = first && y > 0 ? passage_gap : 0;
            const bool turns = y + before + above + own > room();
            if (turns) {
                const double anew = passage.head.height + (first ? passage.heading.height : 0) + own;
                do {
                    if (++column == columns.size()) return false;
                } while (anew > room());
            }
            y = turns ? 0 : y + before;
            if (first) put(passage.heading);
            if (first || turns) put(passage.head);
            for (std::size_t k = i; k < end; ++k) put(passage.rows[k]);
        }
    return true;
}

double ColumnText::whole_height() const {
    if (whole_ >= 0) return whole_;
    whole_ = 0;
    for (const Passage& passage : passages_) {
        whole_ += (whole_ > 0 ? passage_gap : 0) + passage.heading.height + passage.head.height;
        for (const Block& row : passage.rows) whole_ += row.height;
    }
    return whole_;
}

double ColumnText::height(const std::vector<TextColumn>& columns) const {
    double taken = 0, first = 1e300;
    for (const TextColumn& each : columns) taken += each.top + each.lift, first = std::min(first, each.top + each.lift);
    double least = std::max(first, (whole_height() + taken) / static_cast<double>(columns.size()) - taken);
    double most = columns.size() == 1 ? whole_height() + taken : 1.2 * least + 1;
    while (!fits(columns, most)) least = most, most *= 1.2;
    constexpr double fine = 0.5;
    while (columns.size() > 1 && most - least > fine) {
        const double middle = 0.5 * (least + most);
        (fits(columns, middle) ? most : least) = middle;
    }
    return most;
}

double ColumnText::height(int columns) const {
    const auto index = static_cast<std::size_t>(columns);
    if (heights_.size() <= index) heights_.resize(index + 1, -1);
    double& known = heights_[index];
    if (known < 0) known = height(std::vector<TextColumn>(index));
    return known;
}

void ColumnText::set(std::vector<Mark>& marks, Spot at, const std::vector<TextColumn>& columns) const {
    flow(columns, height(columns), [&](const Block& block, std::size_t column, double y) {
        render::set(marks, block, {at.x + columns[column].x, at.y + y});
    });
}

void ColumnText::set(std::vector<Mark>& marks, Spot at, int columns, double between) const {
    std::vector<TextColumn> all;
    for (int i = 0; i < columns; ++i) all.push_back({i * (measure_ + between), 0, 0});
    set(marks, at, all);
}

}  // namespace kinegraph::render
