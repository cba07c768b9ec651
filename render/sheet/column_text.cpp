// Column text: a heading never parts from the row below it, and a table that goes on has its head again.
#include "render/sheet/column_text.hpp"

#include <algorithm>

namespace kinegraph::render {
namespace {

constexpr double passage_gap = 4.5, grace = 1e-6;

}  // namespace

ColumnText::ColumnText(std::vector<Passage> passages, double measure, double scale)
    : passages_(std::move(passages)), measure_(measure) {
    const auto reduce = [scale](Block& block) { block = scaled(std::move(block), scale); };
    if (scale == 1) return;
    for (Passage& passage : passages_) {
        reduce(passage.heading);
        reduce(passage.head);
        std::for_each(passage.rows.begin(), passage.rows.end(), reduce);
    }
}

bool ColumnText::is_too_wide() const {
    constexpr double ink = 0.2;
    return std::any_of(passages_.begin(), passages_.end(), [&](const Passage& passage) {
        return std::any_of(passage.rows.begin(), passage.rows.end(),
                           [&](const Block& row) { return row.width > measure_ + ink; });
    });
}

bool ColumnText::flow(int columns, double height, const std::function<void(const Block&, int column, double y)>& place) const {
    int column = 0;
    double y = 0;
    const auto put = [&](const Block& block) {
        if (place && !block.marks.empty()) place(block, column, y);
        y += block.height;
    };
    for (const Passage& passage : passages_)
        for (std::size_t i = 0; i < passage.rows.size(); ++i) {
            const bool first = i == 0;
            const double own = passage.rows[i].height, above = first ? passage.heading.height + passage.head.height : 0;
            const double before = first && y > 0 ? passage_gap : 0;
            const bool turns = y + before + above + own > height + grace;
            if (turns && (++column == columns || passage.head.height + above + own > height + grace)) return false;
            y = turns ? 0 : y + before;
            if (first) put(passage.heading);
            if (first || turns) put(passage.head);
            put(passage.rows[i]);
        }
    return true;
}

double ColumnText::height(int columns) const {
    const auto index = static_cast<std::size_t>(columns);
    if (heights_.size() <= index) heights_.resize(index + 1, -1);
    double& known = heights_[index];
    if (known >= 0) return known;
    double whole = 0;
    for (const Passage& passage : passages_) {
        whole += (whole > 0 ? passage_gap : 0) + passage.heading.height + passage.head.height;
        for (const Block& row : passage.rows) whole += row.height;
    }
    double least = whole / columns, most = columns == 1 ? whole : 1.2 * least + 1;
    while (!flow(columns, most, {})) least = most, most *= 1.2;
    constexpr double fine = 0.5;
    while (columns > 1 && most - least > fine) {
        const double middle = 0.5 * (least + most);
        (flow(columns, middle, {}) ? most : least) = middle;
    }
    return known = most;
}

void ColumnText::set(std::vector<Mark>& marks, Spot at, int columns, double between) const {
    flow(columns, height(columns), [&](const Block& block, int column, double y) {
        render::set(marks, block, {at.x + column * (measure_ + between), at.y + y});
    });
}

}  // namespace kinegraph::render
