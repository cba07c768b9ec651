// Column text. Rules: a heading stays with the lines below it, no line stands alone in a column, and a table repeats
// its head in the next column.
#include "render/layout/column_text.hpp"

#include <algorithm>

#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double passage_gap = 3.5, rounding_grace = 1e-6;
constexpr double two_lines = 7.5;         // mm; rows lower than this do not stand alone in a column …
constexpr std::size_t part_of_table = 5;  // … nor fewer rows of a table …
constexpr std::size_t least_under = 2;  // … nor fewer rows under a heading: a single step below a figure is overlooked
constexpr double of_one_line = 1.5;     // of the lowest row of a table: a higher one has a cell of several lines

/// End of the group of rows that begins at `first` and stays together: the first rows of a passage stay with its
/// heading, and no single line is left at the beginning or the end.
std::size_t end_of_group(const Passage& passage, double scale, std::size_t first) {
    const std::vector<SharedBlock>& rows = passage.rows;
    const auto is_enough = [&](std::size_t count, double height) {
        return passage.is_table ? count >= part_of_table : height >= two_lines;
    };
    std::size_t end = first + 1;
    double height = rows[first].height() * scale;
    while (first == 0 && end < rows.size() && (end < least_under || !is_enough(end, height)))
        height += rows[end++].height() * scale;
    double left = 0;
    std::size_t next = end;
    while (next < rows.size() && !is_enough(next - end, left)) left += rows[next++].height() * scale;
    return is_enough(next - end, left) ? end : rows.size();
}

/// The rows of a table with a cell of several lines.
int broken_rows_of(const Passage& passage) {
    if (!passage.is_table || passage.rows.empty()) return 0;
    const auto lower = [](const SharedBlock& one, const SharedBlock& other) { return one.height() < other.height(); };
    const double lowest = std::min_element(passage.rows.begin(), passage.rows.end(), lower)->height();
    return static_cast<int>(std::count_if(passage.rows.begin(), passage.rows.end(),
                                          [&](const SharedBlock& row) { return row.height() > of_one_line * lowest; }));
}

}  // namespace

bool is_wider(const Passage& passage, double scale, double measure) {
    constexpr double ink = 0.2;
    return scale * passage.heading.right() > measure + ink ||
           std::any_of(passage.rows.begin(), passage.rows.end(),
                       [&](const SharedBlock& row) { return scale * row.width() > measure + ink; });
}

ColumnText::ColumnText(std::vector<Passage> passages, double measure, double scale, bool whole_tables)
    : passages_(std::move(passages)), scale_(scale), measure_(measure) {
    for (std::size_t p = 0; p < passages_.size(); ++p) {
        const Passage& passage = passages_[p];
        too_wide_ = too_wide_ || is_wider(passage, scale_, measure_);
        broken_rows_ += broken_rows_of(passage);
        for (std::size_t first = 0, end = 0; first < passage.rows.size(); first = end) {
            const bool is_whole = whole_tables && passage.is_table && passage.rows.size() < long_table;
            end = is_whole ? passage.rows.size() : end_of_group(passage, scale_, first);
            double rows = 0;
            for (std::size_t i = first; i < end; ++i) rows += height_of(passage.rows[i]);
            const double heading = first == 0 ? height_of(passage.heading) : 0, head = height_of(passage.head);
            groups_.push_back({p, first, end, heading + (first == 0 ? head : 0) + rows, heading + head + rows});
        }
    }
}

template <class Place>
bool ColumnText::flow(const TextColumns& columns, double height, Place place) const {
    std::size_t column = 0;
    double y = 0;
    const auto room_in = [&](std::size_t c) { return height - columns[c].lift - columns[c].top + rounding_grace; };
    double room = room_in(0);
    for (const Group& group : groups_) {
        const bool first = group.first == 0;
        const double before = first && y > 0 ? passage_gap : 0;
        const bool turns = y + before + group.on > room;
        if (turns) {
            do {
                if (++column == columns.size()) return false;
                room = room_in(column);
            } while (group.anew > room);
        }
        y = turns ? 0 : y + before;
        place(group, turns, column, y);
        y += turns ? group.anew : group.on;
    }
    return true;
}

bool ColumnText::fits(const TextColumns& columns, double height) const {
    return flow(columns, height, [](const Group&, bool, std::size_t, double) {});
}

double ColumnText::whole_height() const {
    if (whole_ >= 0) return whole_;
    whole_ = 0;
    for (const Passage& passage : passages_) {
        whole_ += (whole_ > 0 ? passage_gap : 0) + height_of(passage.heading) + height_of(passage.head);
        for (const SharedBlock& row : passage.rows) whole_ += height_of(row);
    }
    return whole_;
}

double ColumnText::least_height(int columns) const {
    return whole_height() - (columns - 1) * passage_gap - columns * rounding_grace;
}

double ColumnText::height(const TextColumns& columns) const {
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

double ColumnText::height_found(std::size_t columns) const {
    if (heights_.size() <= columns) heights_.resize(columns + 1, -1);
    return heights_[columns] = height(TextColumns(columns));
}

namespace {

/// A column and what it takes: the height without additional space, and how often a passage follows another.
struct Taken {
    double height = 0;
    int gaps = 0;
};

}  // namespace

void ColumnText::set(std::vector<Mark>& marks, Spot at, const TextColumns& columns, double loose, double room) const {
    constexpr double most_air = 1.5;              // mm, below a long sentence
    constexpr double most_between_passages = 11;  // more would be a hole
    const double least = height(columns);
    std::vector<Taken> taken(columns.size());
    const auto air_under = [&](const SharedBlock& block) { return std::min(loose * height_of(block), most_air); };
    flow(columns, least, [&](const Group& group, bool turns, std::size_t column, double y) {
        const Passage& passage = passages_[group.passage];
        Taken& own = taken[column];
        if (group.first == 0 && y > 0) own.gaps += 1, own.height += passage_gap;
        const auto add = [&](const SharedBlock& block) { own.height += height_of(block) + air_under(block); };
        if (group.first == 0) add(passage.heading);
        if (group.first == 0 || turns) add(passage.head);
        for (std::size_t i = group.first; i < group.end; ++i) add(passage.rows[i]);
    });
    // What a column leaves white is divided between its passages and its end.
    const auto between = [&](std::size_t column) {
        const double left = room - columns[column].top - columns[column].lift - taken[column].height;
        return std::clamp(left / (taken[column].gaps + 1), 0.0, most_between_passages);
    };
    double air = 0;  // above a row: the sum over all rows above it in its column
    flow(columns, least, [&](const Group& group, bool turns, std::size_t column, double y) {
        const Passage& passage = passages_[group.passage];
        if (turns) air = 0;
        if (group.first == 0 && y > 0) air += between(column);
        Spot corner{at.x + columns[column].x, at.y + columns[column].top + y + air};
        const auto put = [&](const SharedBlock& block) {
            const double under = air_under(block);
            render::set(marks, scaled(block.set(), scale_), corner);
            corner.y += height_of(block) + under;
            air += under;
        };
        if (group.first == 0) put(passage.heading);
        if (group.first == 0 || turns) put(passage.head);
        for (std::size_t i = group.first; i < group.end; ++i) put(passage.rows[i]);
    });
}

void ColumnText::set(std::vector<Mark>& marks, Spot at, int columns, double between, double loose, double room) const {
    TextColumns all;
    for (int i = 0; i < columns; ++i) all.push_back({i * (measure_ + between), 0, 0});
    set(marks, at, all, loose, room);
}

}  // namespace kinegraph::render
