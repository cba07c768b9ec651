// Pages of figures: splits are tried by what they promise, drawn, and chosen anew with what the lettering turned out to take.
#include "render/sheet/figure_pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "render/figures/caption.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/beside.hpp"
#include "render/sheet/page_split.hpp"

namespace kinegraph::render {
namespace {

constexpr double least_run = 16;           // of free height worth a text column
constexpr double hope_is_short_by = 0.05;  // of what a figure may be worth more than was hoped
constexpr int most_splits = 12;            // tried for one page
constexpr double overflow_price = 10;      // of a figure that its cell cannot hold: more than any size is worth

class FigurePlacer {
public:
    FigurePlacer(const DrawingContext& context, const SheetFormat& format, WantedFigures& figures)
        : context_(context), format_(format), wanted_(figures) {}

    FigurePages place(double text_area) {
        wanted_.force_scale.reset();
        place_from(0, text_area);
        constexpr int most_rounds = 5;
        for (int round = 0; round < most_rounds && !of_one_force_scale(); ++round) {
            take_back_forces();
            place_from(wanted_.first_of_forces, text_area);
        }
        return std::move(result_);
    }

private:
    /// Triangles and closed polygon have one scale: the smaller drawing's. Where they have not, the next round takes that.
    bool of_one_force_scale() {
        double least = 1e300, most = 0;
        for (std::size_t i = 0; i < wanted_.list.size(); ++i)
            if (wanted_.list[i].to_force_scale) {
                least = std::min(least, result_.drawn[i].scale);
                most = std::max(most, result_.drawn[i].scale);
            }
        if (most <= least * (1 + 1e-9)) return true;
        wanted_.force_scale = most;
        for (Wanted& wanted : wanted_.list)
            if (wanted.to_force_scale)
                wanted.drawn.erase(std::remove_if(wanted.drawn.begin(), wanted.drawn.end(),
                                                  [&](const Wanted::Drawn& each) { return each.figure.scale < most; }),
                                   wanted.drawn.end());
        return false;
    }
    void take_back_forces() {
        const std::size_t first = wanted_.first_of_forces;
        result_.drawn.erase(result_.drawn.begin() + static_cast<std::ptrdiff_t>(first), result_.drawn.end());
        result_.sheets.erase(result_.sheets.begin() + static_cast<std::ptrdiff_t>(result_.force_page), result_.sheets.end());
        result_.unplaced.erase(result_.unplaced.lower_bound(first), result_.unplaced.end());
    }

    /// All figures from one on that begins a page.
    void place_from(std::size_t first, double text_area) {
        while (first < wanted_.list.size()) {
            std::size_t together = 1;  // up to where a new page is wanted
            while (first + together < wanted_.list.size() && !wanted_.list[first + together].starts_page) ++together;
            std::size_t most = first > 0 ? std::max<std::size_t>(most_on_first_page(format_), 4) : most_on_first_page(format_);
            if (wanted_.list[first].fills) most = format_.large ? 6 : 4;
            if (first == wanted_.first_of_forces) result_.force_page = result_.sheets.size();
            // Evenly over the pages they take; lone blocks and pins text_area but half the room.
            double load = 0;
            for (std::size_t i = 0; i < together; ++i) load += wanted_.list[first + i].weight < 1 ? 0.5 : 1;
            const auto pages_taken = static_cast<std::size_t>(std::ceil(load / static_cast<double>(most)));
            const std::size_t count =
                wanted_.list[first].fills ? (together + pages_taken - 1) / pages_taken : std::min(most, together);
            std::vector<Box> areas;
            if (text_area > 0 && first == 0) {
                const double strip = text_area / format_.content.width() + 4;
                if (strip < 0.6 * format_.content.height())
                    areas.push_back(rectangle(format_.content.min.x, format_.content.min.y, format_.content.max.x,
                                              std::min(format_.content.max.y - strip, format_.block.min.y - 4)));
                for (int k = 1; k < format_.columns; ++k) {
                    const double side = k * (format_.measure + gap);
                    if (side * format_.content.height() >= text_area)
                        areas.push_back(rectangle(format_.content.min.x, format_.content.min.y, format_.content.max.x - side,
                                                  format_.content.max.y));
                }
            }
            if (areas.empty()) areas.push_back(format_.content);
            if (first == wanted_.first_of_forces && !wanted_.force_scale) wanted_.force_scale = common_scale(first, count, areas);
            Outcome chosen = best_page(first, count, areas);
            // A scale that the file asks for, and a crowded polygon, may want a page with fewer figures on it.
            for (std::size_t fewer = count - 1; (chosen.missed || chosen.cramped) && fewer > 0; --fewer) {
                Outcome outcome = best_page(first, fewer, {format_.content});
                if (!outcome.missed && !outcome.cramped) chosen = std::move(outcome);
            }
            for (Figure& figure : chosen.drawn) result_.drawn.push_back(std::move(figure));
            result_.unplaced = std::move(chosen.unplaced);
            find_runs(chosen.sheet, chosen.cells, first);
            result_.sheets.push_back(std::move(chosen.sheet));
            first += chosen.cells.size();
        }
    }

    /// The scale at which triangles and closed polygon together are worth most; none where the file asks for one, or there is
    /// nothing to share it.
    std::optional<double> common_scale(std::size_t first, std::size_t count, const std::vector<Box>& areas) {
        std::vector<std::size_t> sharing;
        double scale = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Wanted& wanted = wanted_.list[first + i];
            if (!wanted.to_force_scale) continue;
            if (wanted.asked) return std::nullopt;
            sharing.push_back(i);
            scale = std::max(scale, choose_scale(wanted.extent_x / wanted.items, wanted.extent_y, format_.content.width(),
                                                 format_.content.height(), std::nullopt));
        }
        if (sharing.size() < 2) return std::nullopt;
        constexpr int steps = 8;
        constexpr double all_but = 0.2;  // of the worth at that scale: what is missing is air
        std::optional<double> found;
        double most = -1e300;
        for (int step = 0; step < steps; ++step, scale = next_scale(scale)) {
            wanted_.force_scale = scale;
            const Split split = best_of(areas, first, count);
            const bool holds = std::all_of(sharing.begin(), sharing.end(), [&](std::size_t i) {
                const Wanted& wanted = wanted_.list[first + i];
                return worth(wanted, split.cells[i], scale) >= worth_at(wanted, scale) - all_but;
            });
            if (holds && split.value > most) {
                most = split.value;
                found = scale;
            }
        }
        wanted_.force_scale.reset();
        return found;
    }

    Split best_of(const std::vector<Box>& areas, std::size_t first, std::size_t count) const {
        Split best;
        for (const Box& each : areas)
            if (Split split = best_split(wanted_, first, count, each, format_); split.value > best.value + 1e-9)
                best = std::move(split);
        return best;
    }

    enum class Filled { within, beyond, not_at_all };

    /// A page with `count` figures from `first` on.
    struct Outcome {
        double value = -1e300;
        bool missed = false;   // a figure is not at the scale that the file asks for, or larger than its cell
        bool cramped = false;  // a polygon is too small to be read
        bool smaller = false;  // a figure came out smaller than was hoped
        bool of_use = true;    // … and none so small that it was not drawn
        Sheet sheet;
        std::vector<Figure> drawn;  // of this page
        std::set<std::size_t> unplaced;
        std::vector<Box> cells;
    };

    /// What lettering takes is known once it is drawn: where a figure came out smaller than hoped for, the split is chosen anew
    /// with that knowledge.
    Outcome best_page(std::size_t first, std::size_t count, const std::vector<Box>& areas) {
        Outcome chosen;
        std::vector<std::vector<Box>> tried;
        for (int round = 0; round < most_splits; ++round) {
            const Split best = best_of(areas, first, count);
            if (best.value <= chosen.value + 1e-9) break;  // even as hoped for it would be no better
            const bool again =
                std::any_of(tried.begin(), tried.end(), [&](const std::vector<Box>& cells) { return cells == best.cells; });
            if (again) break;  // nothing more is learned
            tried.push_back(best.cells);
            Outcome outcome = fill(best, first, chosen.value);
            const bool smaller = outcome.smaller;
            if (outcome.of_use && outcome.value > chosen.value + 1e-9) chosen = std::move(outcome);
            if (!smaller) break;
        }
        return chosen;
    }

    /// The figures of a split in its cells, drawn as long as the page may come to be worth more than `least`. Leaves what was
    /// drawn before as it is.
    Outcome fill(const Split& split, std::size_t first, double least) {
        const std::set<std::size_t> unplaced_before = result_.unplaced;
        const auto drawn_before = static_cast<std::ptrdiff_t>(result_.drawn.size());
        Outcome outcome;
        outcome.value = 0;
        outcome.cells = split.cells;
        double hoped = split.value;  // of those that are not drawn yet
        for (std::size_t i = 0; i < split.cells.size() && outcome.of_use; ++i) {
            Wanted& wanted = wanted_.list[first + i];
            const double hoped_here = worth(wanted, split.cells[i], wanted_.force_scale);
            hoped -= hoped_here;
            const double needed = least - outcome.value - hoped - hope_is_short_by * static_cast<double>(split.cells.size() - i);
            const Filled filled = fill_cell(outcome.sheet, wanted, first + i, split.cells[i],
                                            needed < -0.5 * overflow_price ? any_scale : coarsest_worth(wanted, needed));
            outcome.of_use = filled != Filled::not_at_all;
            const double size = outcome.of_use ? worth_as_drawn(outcome, first + i, split.cells[i], filled) : -overflow_price;
            outcome.value += size;
            if (outcome.of_use && (wanted.empty || size >= hoped_here - 0.05)) continue;
            outcome.smaller = true;
            enlarge_rim(wanted);
        }
        outcome.drawn.assign(std::make_move_iterator(result_.drawn.begin() + drawn_before),
                             std::make_move_iterator(result_.drawn.end()));
        result_.drawn.erase(result_.drawn.begin() + drawn_before, result_.drawn.end());
        outcome.unplaced = std::exchange(result_.unplaced, unplaced_before);
        return outcome;
    }

    /// What the figure drawn last is worth in its cell; what is wrong with it is written down.
    double worth_as_drawn(Outcome& outcome, std::size_t index, const Box& cell, Filled filled) const {
        constexpr double miss_price = 3;
        const Wanted& wanted = wanted_.list[index];
        const Figure& figure = result_.drawn.back();
        const bool held = filled == Filled::within, missed = misses(wanted, figure) || !held;
        outcome.missed = outcome.missed || missed;
        outcome.cramped = outcome.cramped || (wanted.is_fitted() && is_cramped(wanted, figure));
        double size = 0;
        if (wanted.fills)
            size = worth(wanted, cell, wanted_.force_scale);
        else if (!wanted.empty)
            size = worth_at(wanted, figure.scale) - (missed ? miss_price : 0);
        if (!held) size -= overflow_price;
        if (result_.unplaced.contains(index)) size -= with_steps_price;
        if (figure.lacks_details) size -= details_price;
        return size;
    }

    /// Too small to be read, the whole or some of its vectors.
    static bool is_cramped(const Wanted& wanted, const Figure& figure) {
        constexpr double least = 20;
        return figure.lacks_details || size_at(wanted, figure.scale) < least;
    }

    /// What a drawing told of its room is known; of the others it is guessed that their letters take more.
    static void enlarge_rim(Wanted& wanted) {
        if (wanted.is_fitted()) return;
        wanted.rim_x += 8;
        wanted.rim_y += 8;
    }

    /// How the cell holds the figure; not at all where it would have to be drawn coarser than `coarsest`.
    Filled fill_cell(Sheet& sheet, Wanted& wanted, std::size_t index, const Box& cell, double coarsest) {
        const int number = static_cast<int>(result_.drawn.size()) + 1;
        Box room = rectangle(cell.min.x, cell.min.y + caption_height(wanted, cell.width()), cell.max.x, cell.max.y);
        Figure figure = wanted.drawn_into(room.width(), room.height(), coarsest);
        if (figure.scale > coarsest) return Filled::not_at_all;
        // Captions of a row of figures share a baseline; a long one takes what it needs.
        std::vector<Mark> caption;
        room.min.y = std::max(room.min.y, cell.min.y + set_caption(caption, context_, figure, number, cell.min, cell.width()));
        if (figure.box.height() > room.height()) {
            figure = wanted.drawn_into(room.width(), room.height(), coarsest);
            if (figure.scale > coarsest) return Filled::not_at_all;
        }
        if (wanted.has_equations) {
            if (!set_beside(sheet.marks, figure, wanted.equations, room)) {
                wanted.no_corner.push_back({room.width(), room.height()});
                if (!apart(sheet, figure, wanted, room)) {
                    result_.unplaced.insert(index);
                    centre(figure, room);
                }
            }
        } else {
            centre(figure, room);
        }
        std::size_t details = 0;
        for (const Figure& before : result_.drawn) details += before.details.size();
        letter_details_on(figure, context_, details);
        set_caption(sheet.marks, context_, figure, number, cell.min, cell.width());
        sheet.marks.insert(sheet.marks.end(), figure.marks.begin(), figure.marks.end());
        if (figure.kind == "mechanism" && !sheet.scale_of_mechanism) sheet.scale_of_mechanism = figure.scale;
        constexpr double grace = 0.01;
        const bool held = figure.box.width() <= room.width() + grace && figure.box.height() <= room.height() + grace;
        result_.drawn.push_back(std::move(figure));
        return held ? Filled::within : Filled::beyond;
    }

    /// The room divided between equations and figure, whichever way leaves the figure larger.
    bool apart(Sheet& sheet, Figure& figure, Wanted& wanted, const Box& room) const {
        const auto division = best_division(wanted, room, figure.scale);
        if (!division) return false;
        const Box& left = division->figure_room;
        Figure smaller = wanted.drawn_into(left.width(), left.height(), division->scale);
        if (smaller.scale > division->scale || smaller.box.width() > left.width() || smaller.box.height() > left.height())
            return false;
        figure = std::move(smaller);
        centre(figure, left);
        set(sheet.marks, wanted.equations[division->arrangement], division->corner);
        return true;
    }

    /// Free runs of a page on which figures stand.
    void find_runs(Sheet& sheet, const std::vector<Box>& cells, std::size_t first) const {
        Occupancy occupancy(format_.width, format_.height);
        occupancy.block(covered(sheet.marks));
        occupancy.block(rectangle(format_.block.min.x - clear, format_.block.min.y - clear, format_.block.max.x + clear,
                                  format_.block.max.y + clear));
        // What stands in a line with something is preferred: cells, then the columns of the page.
        std::vector<double> lefts;
        for (const Box& cell : cells) lefts.push_back(cell.min.x);
        lefts.push_back(format_.content.max.x - format_.measure);
        for (const Box& cell : cells) {
            lefts.push_back(cell.max.x - format_.measure);
            lefts.push_back(cell.max.x + gap);
        }
        for (int k = 0; k < format_.columns; ++k) lefts.push_back(format_.content.min.x + k * (format_.measure + gap));
        for (;;) {
            Box best = rectangle(0, 0, 0, 0);
            for (const double left : lefts) {
                if (left < format_.content.min.x - 0.01 || left + format_.measure > format_.content.max.x + 0.01) continue;
                const auto [top, bottom] = occupancy.longest_run(left - clear, left + format_.measure + clear,
                                                                 format_.content.min.y, format_.content.max.y);
                if (bottom - top > best.height() + 6) best = rectangle(left, top, left + format_.measure, bottom);
            }
            if (best.height() < least_run) break;
            Run run{best};
            const Spot middle = 0.5 * (best.min + best.max);
            for (std::size_t i = 0; i < cells.size(); ++i) {
                if (middle.x < cells[i].min.x || middle.x > cells[i].max.x || middle.y < cells[i].min.y ||
                    middle.y > cells[i].max.y)
                    continue;
                run.home = static_cast<int>(first + i);
                run.under_caption = best.min.y < cells[i].min.y + 18;
            }
            sheet.runs.push_back(run);
            occupancy.block(best);
        }
        std::sort(sheet.runs.begin(), sheet.runs.end(), [](const Run& a, const Run& b) {
            return a.box.min.x < b.box.min.x || (a.box.min.x == b.box.min.x && a.box.min.y < b.box.min.y);
        });
    }

    const DrawingContext& context_;
    const SheetFormat& format_;
    WantedFigures& wanted_;
    FigurePages result_;
};

}  // namespace

std::size_t most_on_first_page(const SheetFormat& format) { return format.large ? 5 : 3; }

bool misses(const Wanted& wanted, const Figure& figure) {
    return wanted.asked && !wanted.empty && !wanted.fills && std::abs(figure.scale - *wanted.asked) > 1e-9 * figure.scale;
}

FigurePages place_figures(const DrawingContext& context, const SheetFormat& format, WantedFigures& figures, double text_area) {
    return FigurePlacer(context, format, figures).place(text_area);
}

}  // namespace kinegraph::render
