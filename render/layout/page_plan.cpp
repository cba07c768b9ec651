// Page plan: rows of bands by dynamic programming over their heights, pages by dynamic programming over the rows.
#include "render/layout/page_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/number/index.hpp"
#include "render/content/title_block.hpp"

namespace kinegraph::render {
namespace {

constexpr double step = 3;       // mm; all heights are multiples of it
constexpr int least_height = 5;  // of a band, in steps
constexpr int gap_steps = 2;     // at least row_gap
static_assert(gap_steps * step >= row_gap);
constexpr std::size_t most_cells = 4, most_in_a_cell = 3, most_in_a_row = 5, most_on_a_page = 8;
constexpr double spaced = 12;  // mm, about what rows and figures are spaced by
constexpr double impossible = BandLayout::impossible, possible = BandLayout::possible;

/// All ways to divide `of` columns among `bands` bands, each with at least one.
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

int steps_of(const SheetFormat& format, bool first_page) {
    return static_cast<int>(content_of(format, first_page).height() / step);
}
double taken_by_block(const SheetFormat& format) {
    return content_of(format, true).max.y - format.block.min.y + above_block;
}
/// The part of a cell of the lowest row of the first page that the title block covers.
Notch notch_of(const SheetFormat& format, double left, Width width) {
    const double free = format.block.min.x - above_block - left;
    return free >= format.span(width.columns, width.of) ? Notch{} : Notch{free, taken_by_block(format)};
}

class Planner {
public:
    Planner(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands, const SheetFormat& format,
            int columns_more)
        : layouts_(layouts),
          bands_(bands),
          format_(format),
          heights_(at_index(std::max(steps_of(format, true), steps_of(format, false))) + 1) {
        for (std::size_t cells = 1; cells <= most_cells; ++cells)
            for (int of = format.columns; of <= format.columns + columns_more; ++of) {
                if (cells == 1 && of > format.columns) continue;
                std::vector<int> now;
                std::vector<std::vector<int>> all;
                shares(of, cells, now, all);
                for (const std::vector<int>& each : all) {
                    Split split{of, each};
                    for (std::size_t i = 0; i < each.size(); ++i) {
                        split.stands.push_back(stand_of({each[i], of}, {}));
                        split.at_block.push_back(stand_of({each[i], of}, notch_of(split, i)));
                    }
                    splits_[cells].push_back(std::move(split));
                }
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
        curves_.resize(bands.size() * stands_.size());
        stacks_.resize(bands.size() * stands_.size() * (most_in_a_cell + 1));
        rows_.resize(bands.size() * (most_in_a_row + 1) * 2);
    }

    PagePlan plan() {
        const std::size_t n = bands_.size();
        for (std::size_t first = 0; first < n; ++first) tables_.push_back(tables(first));
        std::vector<Rest> rest(n + 1);
        rest[n].score = 0;
        for (std::size_t first = n; first-- > 0;) {
            const std::vector<State>& ends = tables_[first].second;
            for (std::size_t k = ends.size(); k-- > 1;) {
                if (ends[k].score < possible || rest[first + k].score < possible) continue;
                const double most = ends[k].score + rest[first + k].score - format_.price_of_a_page;
                if (!(most > rest[first].score)) continue;
                const double all = most - price_of_emptiness(first, first + k);
                if (all > rest[first].score) rest[first] = {all, first + k};
            }
        }
        PagePlan plan{{}, rest[0].score};
        if (rest[0].score < possible) return plan;
        for (std::size_t first = 0; first < n; first = rest[first].end)
            plan.pages.push_back(page(first, rest[first].end));
        return plan;
    }

private:
    struct Split {
        int of;
        std::vector<int> columns;
        std::vector<std::size_t> stands{},
            at_block{};  ///< of its cells, in general and in the lowest row of the first page
    };
    /// Number of bands in each cell of a row.
    using Filling = std::vector<int>;
    struct Row {
        double score = impossible;
        const Split* split = nullptr;
        const Filling* filling = nullptr;
    };
    /// The score of a band in a stand, by height.
    struct Curve {
        const WorthByHeight* score = nullptr;
        std::vector<int> changes{};  ///< heights at which the score differs from that of one step less
    };
    /// Bands one below the other, by their total height.
    struct Stack {
        WorthByHeight score{};
        std::vector<int> upper{};  ///< height of the uppermost
    };
    /// The best rows that end before a given band, for a given height of all rows.
    struct State {
        double score = impossible;
        std::size_t count = 0;  // of bands in the last row
        int height = 0;         // of the last row
    };
    using Table = std::vector<std::vector<State>>;  // by number of bands, by height used
    /// The best pages from a given band on.
    struct Rest {
        double score = impossible;
        std::size_t end = 0;  ///< end of the first of these pages
    };

    /// Penalty for white space. It is quadratic, because one very empty page is worse than two slightly empty ones; so
    /// a last page with little on it takes bands from the page before, whose figures become larger. At the end of a
    /// sheet white is less disturbing.
    double price_of_emptiness(std::size_t first, std::size_t end) {
        constexpr double price_of_an_empty_page = 40, price_of_an_empty_last_page = 20;
        constexpr double full = 0.7;  // of a page, what text and figures cover of one without a gap
        const Box content = content_of(format_, first == 0);
        double room = content.width() * content.height(), taken = 0;
        if (first == 0) room -= (content.max.x - format_.block.min.x) * (content.max.y - format_.block.min.y);
        for (const PlannedRow& row : page(first, end))
            for (const PlannedCell& cell : row)
                for (const PlacedBand& placed : cell)
                    taken += layouts_[placed.band].taken_by(
                        layouts_[placed.band].in(placed.width, placed.room.height(), placed.notch));
        const double empty = std::max(0.0, full - taken / room);
        return (end < bands_.size() ? price_of_an_empty_page : price_of_an_empty_last_page) * empty * empty;
    }
    double left_of(const Split& split, std::size_t i) const {
        double x = format_.content.min.x;
        for (std::size_t k = 0; k < i; ++k) x += format_.span(split.columns[k], split.of) + gap;
        return x;
    }
    Notch notch_of(const Split& split, std::size_t i) const {
        return kinegraph::render::notch_of(format_, left_of(split, i), {split.columns[i], split.of});
    }

    /// A possible position of a band: its width, and what the title block covers.
    struct Stand {
        Width width;
        Notch notch;
        std::size_t upright = 0;  ///< the stand of the same width without the title block
    };
    std::size_t stand_of(Width width, const Notch& notch) {
        const auto same = [&](const Stand& stand) {
            return stand.width == width && stand.notch.left == notch.left && stand.notch.high == notch.high;
        };
        const auto found = std::find_if(stands_.begin(), stands_.end(), same);
        if (found != stands_.end()) return static_cast<std::size_t>(found - stands_.begin());
        const std::size_t own = stands_.size();
        stands_.push_back({width, notch, own});
        if (notch.high > 0) {
            const std::size_t upright = stand_of(width, {});
            stands_[own].upright = upright;
        }
        return own;
    }
    const Curve& curve(std::size_t band, std::size_t stand) {
        Curve& known = curves_[band * stands_.size() + stand];
        if (known.score != nullptr) return known;
        known.score =
            &layouts_[band].score(stands_[stand].width, stands_[stand].notch, step, static_cast<int>(heights_) - 1);
        for (std::size_t height = 1; height < heights_; ++height) {
            const double before = (*known.score)[height - 1], here = (*known.score)[height];
            if (here != before) known.changes.push_back(static_cast<int>(height));
        }
        return known;
    }
    /// A band with the next ones below it.
    const Stack& stack(std::size_t first, int count, std::size_t stand) {
        Stack& known = stacks_[(first * stands_.size() + stand) * (most_in_a_cell + 1) + at_index(count)];
        if (!known.score.empty()) return known;
        known.score.assign(heights_, impossible);
        known.upper.assign(heights_, 0);
        const Curve& over = curve(first, stands_[stand].upright);
        const WorthByHeight& under = cell(first + 1, count - 1, stand);
        const auto offer = [&](int upper) {
            const double above = (*over.score)[at_index(upper)];
            if (above < possible) return;
            for (std::size_t height = at_index(upper + gap_steps + least_height); height < heights_; ++height) {
                const double sum = above + under[height - at_index(upper + gap_steps)];
                if (sum > known.score[height]) known.score[height] = sum, known.upper[height] = upper;
            }
        };
        // A higher upper band with the same score only leaves less to what is below it: try only heights at which the
        // score changes.
        offer(least_height);
        if (std::is_sorted(under.begin(), under.end())) {
            for (const int upper : over.changes)
                if (upper > least_height) offer(upper);
        } else {
            for (int upper = least_height + 1; at_index(upper) < heights_; ++upper) offer(upper);
        }
        return known;
    }
    /// The scores of bands one below the other, by height.
    const WorthByHeight& cell(std::size_t first, int count, std::size_t stand) {
        return count == 1 ? *curve(first, stand).score : stack(first, count, stand).score;
    }
    /// The best division of `count` bands into cells side by side, by height. `at_block`: in the lowest row of the
    /// first page.
    const std::vector<Row>& rows(std::size_t first, std::size_t count, bool at_block) {
        std::vector<Row>& best = rows_[(first * (most_in_a_row + 1) + count) * 2 + (at_block ? 1 : 0)];
        if (!best.empty()) return best;
        best.resize(heights_);
        struct Offer {
            const WorthByHeight* score;
            double width;
            std::size_t least = 0;  // height with the same score, in steps
        };
        std::vector<Offer> cells;
        const double page = format_.content.width() * format_.content.height();
        for (const Filling& filling : fillings_[count])
            for (const Split& split : splits_[filling.size()]) {
                cells.clear();
                std::size_t band = first;
                for (std::size_t i = 0; i < filling.size(); ++i) {
                    cells.push_back({&cell(band, filling[i], (at_block ? split.at_block : split.stands)[i]),
                                     format_.span(split.columns[i], split.of)});
                    // A cell without room even at the greatest height excludes this division.
                    if (cells.back().score->back() < possible) break;
                    band += static_cast<std::size_t>(filling[i]);
                }
                if (cells.size() < filling.size()) continue;
                for (std::size_t height = 0; height < heights_; ++height) {
                    double sum = 0;
                    for (Offer& each : cells) {
                        const double own = (*each.score)[height];
                        if (own != (*each.score)[each.least]) each.least = height;
                        const double white = static_cast<double>(height - each.least) * step - spaced;
                        sum += own - price_of_white(std::max(white, 0.0) * each.width / page);
                    }
                    if (sum > best[height].score) best[height] = {sum, &split, &filling};
                }
            }
        return best;
    }
    const Row& row(std::size_t first, std::size_t count, int height, bool at_block) {
        return rows(first, count, at_block)[at_index(height)];
    }

    /// The least height at which a row has a score. Heights between two of them are never useful.
    struct Rise {
        int height;
        double score;
    };
    std::vector<Rise> rises_of(std::size_t first, std::size_t count, int most) {
        std::vector<Rise> rises;
        for (int height = least_height; height <= most; ++height)
            if (const double score = row(first, count, height, false).score;
                score > (rises.empty() ? possible : rises.back().score))
                rises.push_back({height, score});
        return rises;
    }

    /// Table for all rows from a band on, and the best last rows of a page.
    std::pair<Table, std::vector<State>> tables(std::size_t first) {
        const bool first_page = first == 0;
        const int whole = steps_of(format_, first_page);
        const int block = static_cast<int>(std::ceil(taken_by_block(format_) / step));
        const std::size_t most = std::min(most_on_a_page, bands_.size() - first);
        Table table(most + 1, std::vector<State>(static_cast<std::size_t>(whole) + 1));
        std::vector<State> ends(most + 1);
        table[0][0].score = 0;
        for (std::size_t b = 0; b < most; ++b) {
            for (std::size_t count = 1; count <= most_in_a_row && b + count <= most; ++count) {
                const std::vector<Rise> rises = rises_of(first + b, count, whole - (first_page ? block : 0));
                for (int used = 0; used <= whole; ++used) {
                    const double before = table[b][static_cast<std::size_t>(used)].score;
                    if (before < possible) continue;
                    const int top = used > 0 ? used + gap_steps : 0;
                    const auto offer = [](State& state, State other) {
                        if (other.score > state.score + 1e-9) state = other;
                    };
                    // The last row takes the remaining height.
                    if (top < whole)
                        offer(ends[b + count],
                              {before + row(first + b, count, whole - top, first_page).score, count, whole - top});
                    for (const auto& [height, score] : rises) {
                        if (top + height > whole - (first_page ? block : 0)) break;
                        offer(table[b + count][at_index(top + height)], {before + score, count, height});
                    }
                }
            }
        }
        return {std::move(table), std::move(ends)};
    }
    PlannedPage page(std::size_t first, std::size_t end) {
        const auto& [table, ends] = tables_[first];
        const Box content = content_of(format_, first == 0);
        PlannedPage rows;
        State state = ends[end - first];
        int bottom = steps_of(format_, first == 0);
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
            const std::size_t stand = (at_block ? best.split->at_block : best.split->stands)[i];
            int rest = state.height;
            double y = top;
            PlannedCell& bands = cells.emplace_back();
            for (int k = count; k > 0; --k) {
                const int height = k == 1 ? rest : stack(band, k, stand).upper[at_index(rest)];
                bands.push_back(
                    {band++, width, rectangle(left, y, right, y + height * step), k == 1 ? notch : Notch{}});
                rest -= height + gap_steps;
                y += (height + gap_steps) * step;
            }
        }
        return cells;
    }

    const std::vector<BandLayouts>& layouts_;
    const std::vector<Band>& bands_;
    const SheetFormat& format_;
    std::array<std::vector<Split>, most_cells + 1> splits_;         // by number of cells
    std::array<std::vector<Filling>, most_in_a_row + 1> fillings_;  // by number of bands
    std::size_t heights_;                                           // number of possible heights of a row, in steps
    std::vector<Stand> stands_;
    std::vector<std::pair<Table, std::vector<State>>> tables_;  // by first band
    std::vector<Curve> curves_;                                 // by band and stand
    std::vector<Stack> stacks_;                                 // by uppermost band, stand and count
    std::vector<std::vector<Row>> rows_;                        // by first band, count and at_block; by height
};

}  // namespace

Box content_of(const SheetFormat& format, bool first_page) {
    Box box = format.content;
    if (!first_page) box.max.y = format.inner.max.y - strip_height - 3;
    return box;
}

double score_of_page(const BandLayouts& layouts, const SheetFormat& format, bool first_page) {
    const Width whole{format.columns, format.columns};
    const Notch notch = first_page ? notch_of(format, format.content.min.x, whole) : Notch{};
    return layouts.in(whole, steps_of(format, first_page) * step, notch).score;
}

PagePlan plan_pages(const std::vector<BandLayouts>& layouts, const std::vector<Band>& bands, const SheetFormat& format,
                    int columns_more) {
    return Planner(layouts, bands, format, columns_more).plan();
}

}  // namespace kinegraph::render
