// Page plan: rows of bands by dynamic programming over their heights, pages by dynamic programming over the rows.
#include "render/sheet/page_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "engine/index.hpp"
#include "render/sheet/title_block.hpp"

namespace kinegraph::render {
namespace {

constexpr double step = 3;       // mm: heights are multiples of it
constexpr int least_height = 5;  // steps, of a band
constexpr int gap_steps = 3;     // at least row_gap
static_assert(gap_steps * step >= row_gap);
constexpr std::size_t most_cells = 3, most_in_a_cell = 2, most_in_a_row = 4, most_on_a_page = 8;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double impossible = BandLayout::impossible, possible = 0.5 * impossible;
constexpr double above_block = 4;

/// All ways to share `of` columns among so many bands, each at least one.
void shares(int of, std::size_t bands, std::vector<int>& now, std::vector<std::vector<int>>& all) {
    if (bands == 1) {
        all.push_back(now);
        all.back().push_back(of);
        return;
    }
    for (int k = 1; k < of; ++k) {
        now.push_back(k);
        shares(of - k, bands - 1, now, all);
        now.pop_back();
    }
}

class Planner {
public:
    Planner(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands, const SheetFormat& format)
        : layouts_(layouts),
          bands_(bands),
          format_(format),
          taken_by_block_(content_of(format, true).max.y - format.block.min.y + above_block) {
        for (std::size_t cells = 1; cells <= most_cells; ++cells)
            for (const int of : {format.columns, format.columns + 1}) {
                if (cells == 1 && of != format.columns) continue;
                std::vector<int> now;
                std::vector<std::vector<int>> all;
                shares(of, cells, now, all);
                for (const std::vector<int>& each : all) splits_[cells].push_back({of, each});
            }
        for (int count = 1; count <= static_cast<int>(most_in_a_row); ++count)
            for (std::size_t cells = 1; cells <= most_cells && static_cast<int>(cells) <= count; ++cells) {
                std::vector<int> now;
                std::vector<std::vector<int>> all;
                shares(count, cells, now, all);
                for (const std::vector<int>& each : all)
                    if (*std::max_element(each.begin(), each.end()) <= static_cast<int>(most_in_a_cell) &&
                        (cells > 1 || count == 1))
                        fillings_[static_cast<std::size_t>(count)].push_back(each);
            }
    }

    std::vector<PlannedPage> pages(std::size_t& lost) {
        const std::size_t n = bands_.size();
        struct Rest {
            int pages = 1 << 20;
            double worth = impossible;
            std::size_t end = 0;
        };
        std::vector<Rest> rest(n + 1);
        rest[n] = {0, 0, n};
        for (std::size_t first = n; first-- > 0;) {
            const std::vector<double> worth = page_worth(first);
            for (std::size_t k = 0; k < worth.size(); ++k) {
                const Rest& after = rest[first + k + 1];
                if (worth[k] < possible || after.worth < possible) continue;
                const Rest found{after.pages + 1, after.worth + worth[k], first + k + 1};
                if (found.pages < rest[first].pages || (found.pages == rest[first].pages && found.worth > rest[first].worth))
                    rest[first] = found;
            }
            if (rest[first].worth < possible) {
                lost = first;
                return {};
            }
        }
        std::vector<PlannedPage> pages;
        for (std::size_t first = 0; first < n; first = rest[first].end) pages.push_back(page(first, rest[first].end));
        return pages;
    }

private:
    struct Split {
        int of;
        std::vector<int> columns;
    };
    /// How the bands of a row are dealt out to its cells.
    using Filling = std::vector<int>;
    struct Row {
        double worth = impossible;
        const Split* split = nullptr;
        const Filling* filling = nullptr;
    };
    /// The best of the rows that end with a band, by the height they take.
    struct State {
        double worth = impossible;
        std::size_t count = 0;  // of bands in the last row
        int height = 0;         // of the last row
    };
    using Table = std::vector<std::vector<State>>;  // by bands, by height

    int steps_of(bool first_page) const { return static_cast<int>(content_of(format_, first_page).height() / step); }
    double left_of(const Split& split, std::size_t i) const {
        double x = format_.content.min.x;
        for (std::size_t k = 0; k < i; ++k) x += format_.span(split.columns[k], split.of) + gap;
        return x;
    }
    /// What the title block takes of a cell of the lowest row of the first page.
    Notch notch_of(const Split& split, std::size_t i) const {
        const double left = left_of(split, i), free = format_.block.min.x - above_block - left;
        return free >= format_.span(split.columns[i], split.of) ? Notch{} : Notch{free, taken_by_block_};
    }

    WorthByHeight& curve(std::size_t band, Width width, const Notch& notch) {
        return layouts_[band].worth(width, notch, step, std::max(steps_of(true), steps_of(false)));
    }
    /// Of one band, or of two one under the other, with the height of the upper one then.
    std::pair<double, int> cell(std::size_t first, int count, Width width, int height, const Notch& notch) {
        if (count == 1) return {curve(first, width, notch).at(height), height};
        const auto [found, fresh] = cells_.try_emplace(std::tuple(first, width, height, notch.left, notch.high), impossible, 0);
        std::pair<double, int>& best = found->second;
        if (!fresh) return best;
        WorthByHeight &over = curve(first, width, {}), &under = curve(first + 1, width, notch);
        for (int upper = least_height; upper + gap_steps + least_height <= height; ++upper) {
            const double below = under.at(height - upper - gap_steps);
            if (below < possible) break;
            const double above = over.at(upper);
            if (above > possible && above + below > best.first) best = {above + below, upper};
        }
        return best;
    }
    /// Cells side by side; `at_block`: the lowest row of the first page.
    const Row& row(std::size_t first, std::size_t count, int height, bool at_block) {
        const auto [found, fresh] = rows_.try_emplace(std::tuple(first, count, height, at_block));
        Row& best = found->second;
        if (!fresh) return best;
        for (const Filling& filling : fillings_[count])
            for (const Split& split : splits_[filling.size()]) {
                double sum = 0;
                std::size_t band = first;
                for (std::size_t i = 0; i < filling.size() && sum > possible; ++i) {
                    const Notch notch = at_block ? notch_of(split, i) : Notch{};
                    const double worth = cell(band, filling[i], {split.columns[i], split.of}, height, notch).first;
                    sum = worth < possible ? impossible : sum + worth;
                    band += static_cast<std::size_t>(filling[i]);
                }
                if (sum > best.worth) best = {sum, &split, &filling};
            }
        return best;
    }

    /// All rows from a band on; the lowest of the first page apart.
    std::pair<Table, std::vector<State>> tables(std::size_t first) {
        const bool first_page = first == 0;
        const int whole = steps_of(first_page);
        const int block = static_cast<int>(std::ceil(taken_by_block_ / step));
        const std::size_t most = std::min(most_on_a_page, bands_.size() - first);
        Table table(most + 1, std::vector<State>(static_cast<std::size_t>(whole) + 1));
        std::vector<State> ends(most + 1);
        table[0][0].worth = 0;
        for (std::size_t b = 0; b < most; ++b) {
            for (std::size_t count = 1; count <= most_in_a_row && b + count <= most; ++count) {
                if (mechanisms(first, first + b + count) > 1) continue;
                for (int used = 0; used <= whole; ++used) {
                    const double before = table[b][static_cast<std::size_t>(used)].worth;
                    if (before < possible) continue;
                    const int top = used > 0 ? used + gap_steps : 0;
                    const auto offer = [](State& state, State other) {
                        if (other.worth > state.worth + 1e-9) state = other;
                    };
                    // The last row takes what is left.
                    if (top < whole)
                        offer(ends[b + count],
                              {before + row(first + b, count, whole - top, first_page).worth, count, whole - top});
                    for (int height = least_height; top + height <= whole - (first_page ? block : 0); ++height)
                        offer(table[b + count][at_index(top + height)],
                              {before + row(first + b, count, height, false).worth, count, height});
                }
            }
        }
        return {std::move(table), std::move(ends)};
    }
    std::size_t mechanisms(std::size_t first, std::size_t end) const {
        std::size_t count = 0;
        for (std::size_t b = first; b < end; ++b) count += bands_[b].draws_mechanism ? 1 : 0;
        return count;
    }
    std::vector<double> page_worth(std::size_t first) {
        std::vector<double> worth;
        for (const State& state : tables(first).second) worth.push_back(state.worth);
        worth.erase(worth.begin());
        return worth;
    }

    PlannedPage page(std::size_t first, std::size_t end) {
        auto [table, ends] = tables(first);
        const Box content = content_of(format_, first == 0);
        PlannedPage rows;
        State state = ends[end - first];
        int bottom = steps_of(first == 0);
        bool last = true;
        for (std::size_t b = end - first; b > 0;) {
            b -= state.count;
            const int top = bottom - state.height;
            rows.push_back(placed(first + b, state, content.min.y + top * step, last && first == 0));
            bottom = top - (b > 0 ? gap_steps : 0);
            if (b > 0) state = table[b][static_cast<std::size_t>(bottom)];
            last = false;
        }
        std::reverse(rows.begin(), rows.end());
        return rows;
    }
    PlannedRow placed(std::size_t first, const State& state, double top, bool at_block) {
        const Row& best = row(first, state.count, state.height, at_block);
        PlannedRow cells;
        std::size_t band = first;
        for (std::size_t i = 0; i < best.filling->size(); ++i) {
            const Width width{best.split->columns[i], best.split->of};
            const Notch notch = at_block ? notch_of(*best.split, i) : Notch{};
            const double left = left_of(*best.split, i), right = left + format_.span(width.columns, width.of);
            const int count = (*best.filling)[i];
            int height = cell(band, count, width, state.height, notch).second;
            double y = top;
            PlannedCell& bands = cells.emplace_back();
            for (int k = 0; k < count; ++k) {
                if (k > 0) y += (height + gap_steps) * step, height = state.height - height - gap_steps;
                bands.push_back({band++, width, rectangle(left, y, right, y + height * step), k + 1 == count ? notch : Notch{}});
            }
        }
        return cells;
    }

    const std::vector<BandLayouts>& layouts_;
    const std::vector<Band>& bands_;
    const SheetFormat& format_;
    double taken_by_block_;
    std::array<std::vector<Split>, most_cells + 1> splits_;         // by the number of cells
    std::array<std::vector<Filling>, most_in_a_row + 1> fillings_;  // by the number of bands
    std::map<std::tuple<std::size_t, Width, int, double, double>, std::pair<double, int>> cells_;
    std::map<std::tuple<std::size_t, std::size_t, int, bool>, Row> rows_;
};

}  // namespace

Box content_of(const SheetFormat& format, bool first_page) {
    Box box = format.content;
    if (!first_page) box.max.y = format.inner.max.y - strip_height - 3;
    return box;
}

std::vector<PlannedPage> plan_pages(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands,
                                    const SheetFormat& format, std::size_t& lost) {
    return Planner(layouts, bands, format).pages(lost);
}

}  // namespace kinegraph::render
