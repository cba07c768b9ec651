// The sheet: figures, equations, tables and steps on pages, nothing overlapping, nothing cut. Owns the arrangement and the title
// block; knows no mechanics, and takes every figure as it comes: it is moved, never scaled.
//
// Method: the figures of a page get cells, chosen among all splits into columns and rows by the size of what they would hold;
// equations go into the free corner beside their polygon; text flows into the free runs that are left, then into the columns of
// further pages.
#include "render/sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "engine/assert.hpp"
#include "render/force_tables.hpp"
#include "render/shapes.hpp"
#include "render/tables.hpp"

namespace kinegraph::render {
namespace {

constexpr double frame_left = 20, frame_other = 10;  // ISO 5457: the binding edge
constexpr double gap = 7;                            // between cells and between columns
constexpr double clear = 3.5;                        // round everything that text is set beside
constexpr double section_gap = 5.5;
constexpr double least_run = 16;        // of free height worth a text column
constexpr double one_page_share = 0.5;  // of the page that text may take where all is to stand on one

struct Format {
    double width, height, block_width, block_height, padding;
    int columns;
    const char* name;
};
Format format_of(Paper paper) {
    switch (paper) {
        case Paper::a4:
            return {297, 210, 112, 18, 6, 3, "A4"};
        case Paper::a3:
            return {420, 297, 190, 22, 7, 4, "A3"};
        case Paper::letter:
            return {279.4, 215.9, 112, 18, 6, 3, "letter"};
    }
    KG_ASSERT(false, "a paper has a format");
}

Box rectangle(double left, double top, double right, double bottom) { return {{left, top}, {right, bottom}}; }

void append(RichText& to, const RichText& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Where a page is inked, to a millimetre; asked for free rectangles.
class Occupancy {
public:
    Occupancy(double width, double height)
        : columns_(static_cast<int>(std::ceil(width))),
          rows_(static_cast<int>(std::ceil(height))),
          cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

    void block(const Box& box) {
        const int left = std::clamp(static_cast<int>(std::floor(box.min.x)), 0, columns_);
        const int right = std::clamp(static_cast<int>(std::ceil(box.max.x)), 0, columns_);
        const int top = std::clamp(static_cast<int>(std::floor(box.min.y)), 0, rows_);
        const int bottom = std::clamp(static_cast<int>(std::ceil(box.max.y)), 0, rows_);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) cells_[index(x, y)] = 1;
    }
    void block(const std::vector<Spot>& spots) {
        for (const Spot spot : spots) {
            const int x = static_cast<int>(spot.x), y = static_cast<int>(spot.y);
            if (x >= 0 && y >= 0 && x < columns_ && y < rows_) cells_[index(x, y)] = 1;
        }
    }
    /// The longest free run of rows over [left, right], `clear` kept on all sides, within [top, bottom].
    std::pair<double, double> longest_run(double left, double right, double top, double bottom) const {
        const int from = std::clamp(static_cast<int>(std::floor(left)), 0, columns_);
        const int to = std::clamp(static_cast<int>(std::ceil(right)), 0, columns_);
        std::pair<double, double> best{0, 0};
        int start = static_cast<int>(std::ceil(top));
        const int end = static_cast<int>(std::floor(bottom));
        const auto close = [&](int y, bool at_edge) {
            const double run_top = start + (start == static_cast<int>(std::ceil(top)) ? 0 : clear);
            const double run_bottom = y - (at_edge ? 0 : clear);
            if (run_bottom - run_top > best.second - best.first) best = {run_top, run_bottom};
        };
        for (int y = start; y < end; ++y) {
            const auto row = cells_.begin() + static_cast<std::ptrdiff_t>(index(0, y));
            if (std::find(row + from, row + to, 1) == row + to) continue;
            close(y, false);
            start = y + 1;
        }
        close(end, true);
        return best;
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    int columns_, rows_;
    std::vector<char> cells_;
};

/// Places that marks cover, about one each millimetre; text and filled areas as their boxes.
std::vector<Spot> covered(const std::vector<Mark>& marks) {
    std::vector<Spot> spots;
    const auto fill = [&](const Box& box) {
        for (double y = box.min.y; y < box.max.y + 0.9; y += 0.9)
            for (double x = box.min.x; x < box.max.x + 0.9; x += 0.9)
                spots.push_back({std::min(x, box.max.x), std::min(y, box.max.y)});
    };
    const auto stroke = [&](Spot from, Spot to) {
        const int pieces = std::max(1, static_cast<int>(std::ceil(length(to - from) / 0.9)));
        for (int i = 0; i <= pieces; ++i) spots.push_back(from + (static_cast<double>(i) / pieces) * (to - from));
    };
    for (const Mark& mark : marks) {
        if (const auto* path = std::get_if<Path>(&mark)) {
            if (path->filled) {
                fill(box_of({mark}));
                continue;
            }
            Spot pen, start;
            for (const Segment& segment : path->segments) {
                if (const auto* m = std::get_if<MoveTo>(&segment)) {
                    pen = start = m->to;
                } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                    stroke(pen, l->to);
                    pen = l->to;
                } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                    stroke(pen, c->control_1);
                    stroke(c->control_1, c->control_2);
                    stroke(c->control_2, c->to);
                    pen = c->to;
                } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                    const double sweep = a->to - a->from;
                    const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) * a->radius / 0.9)));
                    for (int i = 0; i <= pieces; ++i) {
                        const double angle = a->from + sweep * i / pieces;
                        pen = a->centre + a->radius * Spot{std::cos(angle), std::sin(angle)};
                        spots.push_back(pen);
                    }
                } else {
                    stroke(pen, start);
                }
            }
        } else if (std::holds_alternative<TextMark>(mark)) {
            fill(box_of({mark}));
        }
    }
    return spots;
}

bool is_free(const std::vector<Spot>& spots, Spot moved, const Box& box, double margin) {
    const Box wide = rectangle(box.min.x - margin - moved.x, box.min.y - margin - moved.y, box.max.x + margin - moved.x,
                               box.max.y + margin - moved.y);
    return std::none_of(spots.begin(), spots.end(),
                        [&](Spot s) { return s.x > wide.min.x && s.x < wide.max.x && s.y > wide.min.y && s.y < wide.max.y; });
}

/// A drawing that wants a cell: what it measures and who draws it.
struct Wanted {
    double extent_x = 1, extent_y = 1;  // in the units of its scale
    double rim_x = 20, rim_y = 14;      // what lettering takes, mm
    std::optional<double> asked;
    std::function<Figure(double, double)> draw;
    std::vector<Block> equations;
    bool empty = false;  // all its vectors are zero: a pole and names
    double weight = 1;   // against the other figures of the page
    bool starts_page = false;
    bool to_force_scale = false;  // one scale for all of these
    bool fills = false;           // drawn to fill its room; its scale is that of its vectors
    int items = 1;                // several drawings side by side or in rows
    double caption_width = 60;
    struct Drawn {
        double room_x, room_y;
        Figure figure;
    };
    std::vector<Drawn> drawn;

    /// Drawn once for all rooms between the one it was drawn for and what it takes: the scale is the largest that fits.
    Figure drawn_into(double room_x, double room_y) {
        for (const Drawn& each : drawn)
            if ((each.room_x == room_x && each.room_y == room_y) ||
                (each.room_x >= room_x && each.room_y >= room_y && each.figure.box.width() <= room_x &&
                 each.figure.box.height() <= room_y))
                return each.figure;
        drawn.push_back({room_x, room_y, draw(room_x, room_y)});
        return drawn.back().figure;
    }
};

/// A column that text may flow into.
struct Run {
    Box box;
    double used = 0;
    int home = -1;  // the figure in whose cell it lies
    bool under_caption = false;
    double left() const { return box.height() - used; }
};

/// What stands together: a heading and what is below it; split only where it is longer than any column.
struct Section {
    std::vector<Block> rows;
    int home = -1;           // the figure it explains; −1: none
    bool continued = false;  // its first rows stand already: the rest comes after them
    bool of_forces = false;  // not before the pages of forces
    double height() const {
        double sum = 0;
        for (const Block& row : rows) sum += row.height;
        return sum;
    }
};

struct Sheet {
    std::vector<Mark> marks;
    std::vector<Run> runs;
};

class Layout {
public:
    Layout(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : options_(options), context_{solution, options.theme, fonts, options.language}, format_(format_of(options.paper)) {
        inner_ = rectangle(frame_left, frame_other, format_.width - frame_other, format_.height - frame_other);
        content_ = rectangle(inner_.min.x + format_.padding, inner_.min.y + format_.padding - 1, inner_.max.x - format_.padding,
                             inner_.max.y - format_.padding + 1);
        block_ = rectangle(inner_.max.x - format_.block_width, inner_.max.y - format_.block_height, inner_.max.x, inner_.max.y);
        measure_ = (content_.width() - (format_.columns - 1) * gap) / format_.columns;
    }

    std::vector<Page> pages() {
        collect_figures();
        // All on one page where it can be: the figures leave as little room as the text needs.
        const double share = estimated_text() / (content_.width() * content_.height());
        bool done = false;
        if (on_first_page() <= at_most() && !is_mixed() && share < one_page_share)
            for (const bool equations : {true, false}) {
                force_equations_ = equations;
                for (const double spare : {0.4, 0.5, 0.6, 0.75, 1.0, 0.0}) {
                    if (spare == 0 && !has_forces()) continue;
                    attempt(spare);
                    if ((done = sheets_.size() == figure_pages_)) break;
                }
                if (done || !has_forces()) break;
            }
        if (!done) {
            force_equations_ = false;
            attempt(0);
            // Equations with the steps are not worth a page.
            const std::size_t without = sheets_.size();
            if (has_forces()) {
                force_equations_ = true;
                set_text_anew();
                if (sheets_.size() > without) {
                    force_equations_ = false;
                    set_text_anew();
                }
            }
        }
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets_.size(); ++i) pages.push_back(finish(sheets_[i], i + 1, sheets_.size()));
        return pages;
    }

private:
    const Solution& solution() const { return context_.solution; }
    Language language() const { return context_.language; }
    ShapedLine shape(const RichText& text, double size) const { return context_.fonts.shape(text, size); }

    // --- what there is to draw -----------------------------------------------------------------------------------------------

    bool has_forces() const { return !solution().free_bodies.empty(); }
    bool has_motion() const {
        return !solution().centres.empty() ||
               std::any_of(solution().protocol.polygons.begin(), solution().protocol.polygons.end(),
                           [](const Polygon& p) { return p.plane == Plane::velocity || p.plane == Plane::acceleration; });
    }
    /// Motion and forces: each on pages of its own.
    bool is_mixed() const { return has_forces() && has_motion(); }
    std::size_t on_first_page() const {
        for (std::size_t i = 1; i < wanted_.size(); ++i)
            if (wanted_[i].starts_page) return i;
        return wanted_.size();
    }

    void collect_figures() {
        if (has_motion() || !has_forces()) collect_motion();
        if (has_forces()) collect_forces();
    }

    void collect_forces() {
        const Solution& s = solution();
        const double si = s.mechanism.units.force.si.to_double();
        first_of_forces_ = wanted_.size();
        Wanted mechanism;
        double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
        const auto reach = [&](const Vector& at) {
            const double x = at.x.to_double(), y = at.y.to_double();
            left = std::min(left, x), right = std::max(right, x), low = std::min(low, y), high = std::max(high, y);
        };
        for (const Vector& at : s.pose.points) reach(at);
        mechanism.extent_x = std::max(right - left, 1e-30);
        mechanism.extent_y = std::max(high - low, 1e-30);
        mechanism.asked = asked("mechanism", 1);
        mechanism.rim_x = 34;
        mechanism.rim_y = 40;
        mechanism.caption_width = 95;
        mechanism.weight = 1.7;
        mechanism.starts_page = true;
        mechanism.draw = [this](double x, double y) {
            Figure figure = mechanism_with_forces(context_, x, y);
            if (!asked("mechanism", 1) || (figure.box.width() <= x && figure.box.height() <= y)) return figure;
            return mechanism_with_forces(unscaled(), x, y);
        };
        wanted_.push_back(std::move(mechanism));
        const auto add = [&](int polygon, const std::string& name, auto draw) {
            Wanted wanted;
            const Box extent = extent_of_forces(s, polygon);
            wanted.extent_x = std::max(extent.width(), 1e-30);
            wanted.extent_y = std::max(extent.height(), 1e-30);
            wanted.asked = asked(name, si);
            for (const char* other : {"forces", "closure"})
                if (!wanted.asked) wanted.asked = asked(other, si);
            wanted.to_force_scale = true;
            const std::optional<double> scale = wanted.asked;
            wanted.draw = [this, draw, scale](double x, double y) {
                const bool fixed = scale && !force_scale_;
                return draw(x, y, fixed ? scale : force_scale_, fixed);
            };
            wanted_.push_back(std::move(wanted));
        };
        if (has_force_polygons(s)) {
            add(-1, "forces", [this](double x, double y, std::optional<double> scale, bool fixed) {
                return force_polygons_figure(context_, x, y, scale, fixed);
            });
            wanted_.back().items = force_polygon_count(s);
            wanted_.back().rim_x = 14;
            wanted_.back().rim_y = 16;
        }
        for (const int p : closed_polygons(s))
            add(p, "closure", [this, p](double x, double y, std::optional<double> scale, bool fixed) {
                return closed_polygon_figure(context_, p, x, y, scale, fixed);
            });
        bool first = true;
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < s.free_bodies.size(); ++i) order.push_back(i);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const auto rank = [&](std::size_t i) { return s.free_bodies[i].body < 0 ? 1 << 20 : s.free_bodies[i].body; };
            return rank(a) < rank(b);
        });
        for (const std::size_t i : order) {
            Wanted body;
            const Box box = extent_of_free_body(s, i);
            body.extent_x = std::max(box.width(), 0.3 * box.height());
            body.extent_y = std::max(box.height(), 0.3 * box.width());
            if (!(body.extent_x > 0)) body.extent_x = body.extent_y = 1;
            body.rim_x = body.rim_y = 38;
            body.fills = true;
            body.weight = box.width() + box.height() > 0 ? 1 : 0.4;
            body.starts_page = first;
            body.draw = [this, i](double x, double y) { return free_body_figure(context_, i, x, y); };
            first = false;
            wanted_.push_back(std::move(body));
        }
        if (options_.joukowsky && no_lever(s) == NoLever::none) {
            Wanted lever;
            lever_table_ = joukowsky_block(context_, measure_);
            const Box extent = extent_of_lever(s);
            lever.extent_x = std::max(extent.width(), 1e-30);
            lever.extent_y = std::max(extent.height(), 1e-30);
            lever.rim_x = 40;  // forces on either side
            lever.rim_y = 40 + 0.6 * lever_table_.height;
            lever.weight = 1.3;
            lever.draw = [this](double x, double y) { return lever_with_table(x, y); };
            lever_ = wanted_.size();
            wanted_.push_back(std::move(lever));
        }
    }

    /// The table in a corner that the lever leaves free, beside it or above it, whichever leaves the figure largest; the lever
    /// alone where none of these has room.
    Figure lever_with_table(double room_x, double room_y) const {
        const Box room = rectangle(0, 0, room_x, room_y);
        const auto fits = [](const Figure& figure, const Box& box) {
            return figure.box.width() <= box.width() && figure.box.height() <= box.height();
        };
        Figure alone = joukowsky_figure(context_, room_x, room_y);
        const Block block = joukowsky_block(context_, std::min(room_x, measure_));
        std::optional<Figure> best;
        Sheet table;
        {
            Figure figure = alone;
            if (beside(table, figure, {block, block}, room)) best = std::move(figure);
        }
        for (const bool above : {true, false}) {
            Box left = room;
            (above ? left.min.y : left.min.x) += above ? block.height + 6 : block.width + 8;
            if (left.width() < 30 || left.height() < 30 || block.width > room_x || block.height > room_y) continue;
            Figure figure = joukowsky_figure(context_, left.width(), left.height());
            if (!fits(figure, left) || (best && best->scale <= figure.scale)) continue;
            centre(figure, left);
            best = std::move(figure);
            table.marks.clear();
            set(table, block, {0, 0});
        }
        if (!best || best->scale > 6 * alone.scale) return alone;
        best->marks.insert(best->marks.end(), table.marks.begin(), table.marks.end());
        best->box = box_of(best->marks);
        return *best;
    }
    bool lever_has_table() const {
        const std::string sum = word("sum", language());
        return lever_ && std::any_of(drawn_[*lever_].marks.begin(), drawn_[*lever_].marks.end(), [&](const Mark& mark) {
                   const auto* text = std::get_if<TextMark>(&mark);
                   return text && text->words == sum;
               });
    }

    const DrawingContext& unscaled() {
        if (!unscaled_) {
            unscaled_ = solution();
            unscaled_->mechanism.scales.clear();
            unscaled_context_.emplace(DrawingContext{*unscaled_, context_.theme, context_.fonts, context_.language});
        }
        return *unscaled_context_;
    }

    void collect_motion() {
        const Solution& s = solution();
        Wanted mechanism;
        double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
        const auto reach = [&](const Vector& at) {
            const double x = at.x.to_double(), y = at.y.to_double();
            left = std::min(left, x), right = std::max(right, x), low = std::min(low, y), high = std::max(high, y);
        };
        for (const Vector& at : s.pose.points) reach(at);
        const double near = 0.6 * std::max({right - left, high - low, 1e-30});
        const Box body = rectangle(left - near, low - near, right + near, high + near);
        for (const InstantCentre& centre : s.centres) {
            if (!centre.at || centre.at->at_infinity()) continue;
            const Vector at = centre.at->place();
            const double x = at.x.to_double(), y = at.y.to_double();
            if (x > body.min.x && x < body.max.x && y > body.min.y && y < body.max.y) reach(at);
        }
        mechanism.extent_x = std::max(right - left, 1e-30);
        mechanism.extent_y = std::max(high - low, 1e-30);
        mechanism.asked = asked("mechanism", 1);
        mechanism.rim_x = 22;
        mechanism.rim_y = 26;
        mechanism.caption_width = 95;
        // Its symbols and letters do not shrink with it: drawn small, it is crowded.
        mechanism.weight = 1.7;
        mechanism.draw = [this](double x, double y) {
            Figure figure = mechanism_figure(context_, x, y, !solution().centres.empty());
            if (!wanted_.front().asked || (figure.box.width() <= x && figure.box.height() <= y)) return figure;
            // The scale that the file asks for is too large for the paper: ours, then.
            return mechanism_figure(unscaled(), x, y, !solution().centres.empty());
        };
        wanted_.push_back(std::move(mechanism));

        const Protocol& protocol = s.protocol;
        std::map<int, int> polygon_of;  // by statement
        for (const DrawnVector& vector : protocol.vectors) polygon_of.emplace(vector.statement, vector.polygon);
        for (const DrawnLine& drawn : protocol.lines)
            if (drawn.polygon >= 0) polygon_of.emplace(drawn.statement, drawn.polygon);
        for (std::size_t p = 0; p < protocol.polygons.size(); ++p) {
            const Polygon& polygon = protocol.polygons[p];
            const bool acceleration = polygon.plane == Plane::acceleration;
            if (polygon.plane == Plane::force) continue;
            const Unit& unit = acceleration ? s.mechanism.units.acceleration : s.mechanism.units.velocity;
            Wanted wanted;
            const double si = unit.si.to_double();
            double min_x = 0, max_x = 0, min_y = 0, max_y = 0;
            const auto add = [&](int element) {
                if (protocol.point(element).at_infinity()) return;
                const ProjectivePoint& at = protocol.point(element);
                const double x = at.x.to_double() / si, y = at.y.to_double() / si;
                min_x = std::min(min_x, x), max_x = std::max(max_x, x), min_y = std::min(min_y, y), max_y = std::max(max_y, y);
            };
            for (const int v : polygon.vectors) {
                add(protocol.vectors[static_cast<std::size_t>(v)].tail);
                add(protocol.vectors[static_cast<std::size_t>(v)].tip);
            }
            wanted.empty = !(std::max(max_x - min_x, max_y - min_y) > 0);
            wanted.extent_x = std::max(max_x - min_x, 1e-30);
            wanted.extent_y = std::max(max_y - min_y, 1e-30);
            wanted.asked = asked(polygon.id, si);
            if (!wanted.asked) wanted.asked = asked(acceleration ? "acceleration" : "velocity", si);
            wanted.draw = [this, p](double x, double y) { return polygon_figure(context_, static_cast<int>(p), x, y); };
            for (std::size_t i = 0; i < protocol.statements.size(); ++i) {
                const auto& equation = protocol.statements[i].equation;
                const auto found = polygon_of.find(static_cast<int>(i));
                if (!equation || found == polygon_of.end() || found->second != static_cast<int>(p)) continue;
                wanted.equations.push_back(equation_block(context_, *equation, 1.25 * measure_));
                equation_polygon_[i] = wanted_.size();
            }
            wanted_.push_back(std::move(wanted));
        }
    }

    std::optional<double> asked(const std::string& figure, double si) const {
        for (const AskedScale& scale : solution().mechanism.scales)
            if (scale.figure == figure) return scale.per_millimetre.to_double() / si;
        return std::nullopt;
    }

    // --- cells ---------------------------------------------------------------------------------------------------------------

    /// How a page is split: columns of cells (or rows, transposed), and what is kept free for text.
    struct Split {
        std::vector<Box> cells;
        double value = -1e300;
    };

    static void compositions(int n, int parts_left, std::vector<int>& now, std::vector<std::vector<int>>& all) {
        if (n == 0) {
            all.push_back(now);
            return;
        }
        if (parts_left == 0) return;
        for (int k = 1; k <= n; ++k) {
            now.push_back(k);
            compositions(n - k, parts_left - 1, now, all);
            now.pop_back();
        }
    }
    /// Shares of a length among n, a few of them.
    static std::vector<std::vector<double>> shares(std::size_t n) {
        if (n == 1) return {{1}};
        if (n == 2) return {{0.5, 0.5}, {0.56, 0.44}, {0.44, 0.56}, {0.62, 0.38}, {0.38, 0.62}, {0.68, 0.32}, {0.32, 0.68}};
        if (n == 3)
            return {{0.34, 0.33, 0.33}, {0.4, 0.3, 0.3},    {0.3, 0.4, 0.3},   {0.3, 0.3, 0.4},
                    {0.46, 0.27, 0.27}, {0.27, 0.46, 0.27}, {0.27, 0.27, 0.46}};
        return {std::vector<double>(n, 1.0 / static_cast<double>(n))};
    }

    /// What a figure of this size (mm) is worth: in steps of the scale, and small ones hardly anything.
    static double use_of(double size) { return std::log(size) - 40 / size; }
    /// How large a figure would be drawn in a cell, and what that is worth.
    double worth(const Wanted& wanted, const Box& cell) const {
        if (wanted.empty) return cell.width() > 60 && cell.height() > 30 ? 0 : -6;
        const double width = cell.width(), height = cell.height() - 8;
        if (wanted.fills) {
            const double room_x = width - wanted.rim_x, room_y = height - wanted.rim_y;
            if (room_x < 5 || room_y < 5) return -6;
            const double enlarged = std::min(room_x / wanted.extent_x, room_y / wanted.extent_y);
            return wanted.weight * use_of(std::max(12.0, std::max(wanted.extent_x, wanted.extent_y) * enlarged));
        }
        if (wanted.items > 1) {
            // In rows, each with names above and tables below.
            double best = -6;
            for (int rows = 1; rows <= wanted.items; ++rows) {
                const int across = (wanted.items + rows - 1) / rows;
                const double room_x = width - wanted.rim_x - 12 * (across - 1), room_y = height - wanted.rim_y - 14 * rows;
                if (room_x < 12 || room_y < 12) continue;
                const double extent_x = wanted.extent_x / rows, extent_y = wanted.extent_y * rows;
                double scale = choose_scale(extent_x, extent_y, room_x, room_y, std::nullopt);
                if (wanted.asked && !force_scale_) scale = std::max(scale, *wanted.asked);
                scale = std::max(scale, force_scale_.value_or(0));
                const double air = std::log(std::max(extent_x / room_x, extent_y / room_y) / scale);
                best = std::max(best, wanted.weight * use_of(std::max(wanted.extent_x, wanted.extent_y) / scale) + 0.04 * air);
            }
            return best;
        }
        const auto drawn = [&](double w, double h) -> double {
            const double room_x = w - wanted.rim_x, room_y = h - wanted.rim_y;
            if (room_x < 12 || room_y < 12) return -6;
            double scale = choose_scale(wanted.extent_x, wanted.extent_y, room_x, room_y, std::nullopt);
            double penalty = 0;
            if (wanted.asked) {
                if (*wanted.asked < std::max(wanted.extent_x / room_x, wanted.extent_y / room_y)) penalty = 3;
                scale = *wanted.asked;
            }
            if (wanted.to_force_scale && force_scale_) scale = std::max(scale, *force_scale_);
            // The step of the scale first, then the air that it leaves.
            const double air = std::log(std::max(wanted.extent_x / room_x, wanted.extent_y / room_y) / scale);
            return wanted.weight * use_of(std::max(wanted.extent_x, wanted.extent_y) / scale) + 0.04 * air - penalty;
        };
        if (wanted.equations.empty()) return drawn(width, height);
        double stack_width = 0, stack_height = 0;
        for (const Block& block : wanted.equations) {
            stack_width = std::max(stack_width, block.width);
            stack_height += block.height + 4;
        }
        // A corner of a polygon is often free: counted as half.
        return std::max({drawn(width - stack_width - 4, height), drawn(width, height - stack_height),
                         drawn(width - 0.5 * stack_width, height - 0.25 * stack_height) - 0.1});
    }

    void cut_at_block(Box& cell) const {
        if (cell.max.y > block_.min.y - 4 && cell.max.x > block_.min.x - 4) cell.max.y = block_.min.y - 4;
    }

    std::vector<Split> splits(std::size_t first, std::size_t count, const Box& area) const {
        std::vector<std::vector<int>> all;
        std::vector<int> now;
        compositions(static_cast<int>(count), 3, now, all);
        std::vector<Split> result;
        for (const bool transposed : {false, true})
            for (const auto& composition : all) {
                if (transposed && (composition.size() == 1 || composition.size() == count)) continue;  // met already
                for (const auto& outer : shares(composition.size())) {
                    // Every part its own best inner shares.
                    Split split;
                    split.value = 0;
                    std::size_t index = first;
                    const double whole = transposed ? area.height() : area.width();
                    double at = transposed ? area.min.y : area.min.x;
                    for (std::size_t part = 0; part < composition.size(); ++part) {
                        const double extent = outer[part] * (whole - gap * static_cast<double>(composition.size() - 1));
                        const auto parts = static_cast<std::size_t>(composition[part]);
                        std::vector<Box> best_cells;
                        double best = -1e300;
                        for (const auto& inner : shares(parts)) {
                            const double across =
                                (transposed ? area.width() : area.height()) - gap * static_cast<double>(parts - 1);
                            double along = transposed ? area.min.x : area.min.y;
                            double value = 0;
                            std::vector<Box> cells;
                            for (std::size_t k = 0; k < parts; ++k) {
                                const double size = inner[k] * across;
                                Box cell = transposed ? rectangle(along, at, along + size, at + extent)
                                                      : rectangle(at, along, at + extent, along + size);
                                cut_at_block(cell);
                                value += worth(wanted_[index + k], cell);
                                cells.push_back(cell);
                                along += size + gap;
                            }
                            if (value > best + 1e-9) best = value, best_cells = cells;
                        }
                        split.value += best;
                        split.cells.insert(split.cells.end(), best_cells.begin(), best_cells.end());
                        at += extent + gap;
                        index += parts;
                    }
                    result.push_back(std::move(split));
                }
            }
        return result;
    }

    std::size_t at_most() const { return options_.paper == Paper::a3 ? 5 : 3; }

    /// Everything placed, a strip of `spare` times the estimate of the text kept from the figures of the first page.
    void attempt(double spare) {
        force_scale_.reset();
        for (int round = 0;; ++round) {
            sheets_.clear();
            drawn_.clear();
            sections_.clear();
            unplaced_.clear();
            figures_ = 0;
            place_figures(spare);
            // Triangles and closed polygon have one scale: the smaller drawing's.
            double least = 1e300, most = 0;
            for (std::size_t i = 0; i < wanted_.size(); ++i)
                if (wanted_[i].to_force_scale) {
                    least = std::min(least, drawn_[i].scale);
                    most = std::max(most, drawn_[i].scale);
                }
            if (most <= least * (1 + 1e-9) || round == 5) break;
            force_scale_ = most;
            for (Wanted& wanted : wanted_)
                if (wanted.to_force_scale) wanted.drawn.clear();
        }
        placed_ = sheets_;
        numbered_ = figures_;
        write_sections();
        flow();
    }
    /// The same figures where they are, the text once more.
    void set_text_anew() {
        sheets_ = placed_;
        figures_ = numbered_;
        sections_.clear();
        write_sections();
        flow();
    }

    void place_figures(double spare) {
        for (std::size_t first = 0; first < wanted_.size();) {
            std::size_t together = 1;  // up to where a new page is wanted
            while (first + together < wanted_.size() && !wanted_[first + together].starts_page) ++together;
            std::size_t most = first > 0 ? std::max<std::size_t>(at_most(), 4) : at_most();
            if (wanted_[first].fills) most = options_.paper == Paper::a3 ? 6 : 4;
            if (first == first_of_forces_) force_page_ = sheets_.size();
            // Evenly over the pages they take; lone blocks and pins need but half the room.
            double load = 0;
            for (std::size_t i = 0; i < together; ++i) load += wanted_[first + i].weight < 1 ? 0.5 : 1;
            const auto pages_taken = static_cast<std::size_t>(std::ceil(load / static_cast<double>(most)));
            const std::size_t count =
                wanted_[first].fills ? (together + pages_taken - 1) / pages_taken : std::min(most, together);
            std::vector<Box> areas;
            if (spare > 0 && first == 0) {
                const double need = spare * estimated_text();
                const double strip = need / content_.width() + 4;
                if (strip < 0.6 * content_.height())
                    areas.push_back(rectangle(content_.min.x, content_.min.y, content_.max.x,
                                              std::min(content_.max.y - strip, block_.min.y - 4)));
                for (int k = 1; k < format_.columns; ++k) {
                    const double side = k * (measure_ + gap);
                    if (side * content_.height() >= need)
                        areas.push_back(rectangle(content_.min.x, content_.min.y, content_.max.x - side, content_.max.y));
                }
            }
            if (areas.empty()) areas.push_back(content_);
            Outcome chosen = best_page(first, count, areas);
            // A scale that the file asks for may want a page with fewer figures on it.
            for (std::size_t fewer = count - 1; chosen.missed && fewer > 0; --fewer) {
                Outcome outcome = best_page(first, fewer, {content_});
                if (!outcome.missed) chosen = std::move(outcome);
            }
            drawn_ = std::move(chosen.drawn);
            unplaced_ = std::move(chosen.unplaced);
            figures_ = static_cast<int>(drawn_.size());
            find_runs(chosen.sheet, chosen.cells, first);
            sheets_.push_back(std::move(chosen.sheet));
            first += chosen.cells.size();
        }
        figure_pages_ = sheets_.size();
    }

    /// A page with `count` figures from `first` on, and all that was drawn up to it.
    struct Outcome {
        double value = -1e300;
        bool missed = false;  // a figure is not at the scale that the file asks for
        Sheet sheet;
        std::vector<Figure> drawn;
        std::set<std::size_t> unplaced;
        std::vector<Box> cells;
    };

    bool misses(const Wanted& wanted, const Figure& figure) const {
        return wanted.asked && !wanted.empty && !wanted.fills && std::abs(figure.scale - *wanted.asked) > 1e-9 * figure.scale;
    }

    /// What lettering takes is known once it is drawn: where a figure came out smaller than hoped for, the split is chosen anew
    /// with that knowledge. Leaves what was drawn before as it is.
    Outcome best_page(std::size_t first, std::size_t count, const std::vector<Box>& areas) {
        Outcome chosen;
        const std::set<std::size_t> unplaced_before = unplaced_;
        const std::vector<Figure> drawn_before = drawn_;
        const int numbers = figures_;
        for (int round = 0; round < 4; ++round) {
            Split best;
            for (const Box& each : areas)
                for (Split& split : splits(first, count, each))
                    if (split.value > best.value + 1e-9) best = std::move(split);
            if (best.value <= chosen.value + 1e-9) break;  // even as hoped for it would be no better
            Outcome outcome;
            outcome.value = 0;
            bool smaller = false;
            for (std::size_t i = 0; i < count; ++i) {
                Wanted& wanted = wanted_[first + i];
                fill_cell(outcome.sheet, wanted, first + i, best.cells[i]);
                const bool missed = misses(wanted, drawn_.back());
                outcome.missed = outcome.missed || missed;
                double size = 0;
                if (wanted.fills)
                    size = worth(wanted, best.cells[i]);
                else if (!wanted.empty)
                    size = wanted.weight * use_of(std::max(wanted.extent_x, wanted.extent_y) / drawn_.back().scale) -
                           (missed ? 3 : 0);
                outcome.value += size;
                if (!wanted.empty && size < worth(wanted, best.cells[i]) - 0.05) {
                    smaller = true;
                    wanted.rim_x += 8;
                    wanted.rim_y += 8;
                }
            }
            outcome.drawn = std::move(drawn_);
            outcome.unplaced = std::move(unplaced_);
            outcome.cells = best.cells;
            drawn_ = drawn_before;
            unplaced_ = unplaced_before;
            figures_ = numbers;
            if (outcome.value > chosen.value + 1e-9) chosen = std::move(outcome);
            if (!smaller) break;
        }
        return chosen;
    }

    /// mm² that the text will take, roughly: enough to choose whether it shares a page with the figures.
    double estimated_text() const {
        const Solution& s = solution();
        double rows = 8;
        for (const Polygon& polygon : s.protocol.polygons) rows += static_cast<double>(polygon.vectors.size());
        rows += 2.0 * static_cast<double>(s.bodies.size());
        double lines = 12;
        for (const Statement& statement : s.protocol.statements)
            if (!told_by_list(statement)) lines += 2.2;
        const double heights = rows * 4.4 + lines * 4.1 + static_cast<double>(s.centres.size() + s.bodies.size()) * 4.7 +
                               4.1 * static_cast<double>(s.remarks.size() + s.unsolved.size()) * 2 + 5 * section_gap;
        double figures = 0;
        if (has_circle()) figures += 0.85 * measure_;
        if (has_velocities()) figures += 0.85 * measure_;
        return (heights + figures) * (measure_ + gap);
    }

    RichText scale_words(const Figure& figure) const {
        const Units& units = solution().mechanism.units;
        std::string text;
        if (figure.unit == "m") {
            const double ratio = figure.scale * 1000;
            text = ratio >= 1 ? "1 : " + shortest(std::round(ratio * 1e9) / 1e9, language())
                              : shortest(std::round(1e9 / ratio) / 1e9, language()) + " : 1";
            if (units.length.symbol != "mm")
                text += ";  1 mm ≙ " + shortest_scale(figure.scale / units.length.si.to_double()) + " " + units.length.symbol;
        } else {
            text = "1 mm ≙ " + shortest_scale(figure.scale) + " " + figure.unit;
        }
        if (!figure.further_scale.empty()) text += ";  " + figure.further_scale;
        return with_powers(text);
    }
    /// A scale is a short decimal up to the last bits of a division.
    std::string shortest_scale(double value) const {
        const double power = std::pow(10.0, 6 - std::floor(std::log10(value)));
        const double round = std::round(value * power) / power;
        const std::string text = shortest(std::abs(round - value) < 1e-12 * value ? round : value, language());
        // A scale of the file's own, 14 mm = 16.28 MN, may have no end.
        return text.size() > 9 ? number(value, 5, language()) : text;
    }

    double caption_height(const Wanted& wanted, double width) const { return wanted.caption_width > width ? 11 : 7; }

    /// A diagram has no scale, nor has a polygon of which all vectors are zero.
    static bool has_scale(const Figure& figure) {
        if (figure.kind == "centres" || figure.unit.empty()) return false;
        return (figure.kind != "velocity" && figure.kind != "acceleration") ||
               std::any_of(figure.marks.begin(), figure.marks.end(),
                           [](const Mark& mark) { return std::holds_alternative<Axis>(mark); });
    }

    /// "Fig. 1  Mechanism and instant centres  1 : 5" on one line, or two where the cell is narrow.
    double set_caption(std::vector<Mark>& marks, const Figure& figure, Spot at, double width) {
        const Theme& theme = options_.theme;
        RichText text = one_piece(word("figure", language()) + " " + std::to_string(++figures_), Face::bold);
        append(text, one_piece("   "));
        append(text, figure.caption);
        const ShapedLine caption = shape(text, theme.label);
        const ShapedLine scale = has_scale(figure) ? shape(scale_words(figure), theme.body_text) : ShapedLine{};
        if (caption.width + 5 + scale.width <= width) {
            set_text(marks, caption, {at.x, at.y + 3.8}, theme.text, "text");
            set_text(marks, scale, {at.x + caption.width + 5, at.y + 3.8}, theme.secondary, "text");
            return 7;
        }
        double baseline = at.y + 3.8;
        for (const ShapedLine& each : context_.fonts.wrap(text, theme.label, width)) {
            set_text(marks, each, {at.x, baseline}, theme.text, "text");
            baseline += 4.7;
        }
        if (scale.width > 0) {
            set_text(marks, scale, {at.x, baseline}, theme.secondary, "text");
            baseline += 4.4;
        }
        return baseline - 3.8 - at.y + 2;
    }

    /// Equations one under the other, or side by side.
    static Block arranged(const std::vector<Block>& blocks, bool in_a_row) {
        Block all;
        for (const Block& block : blocks) {
            std::vector<Mark> marks = block.marks;
            if (in_a_row) {
                if (all.width > 0) all.width += 7;
                render::move(marks, all.width, 0);
                all.width += block.width;
                all.height = std::max(all.height, block.height);
            } else {
                if (all.height > 0) all.height += 5;
                render::move(marks, 0, all.height);
                all.height += block.height;
                all.width = std::max(all.width, block.width);
            }
            all.marks.insert(all.marks.end(), marks.begin(), marks.end());
        }
        return all;
    }

    void fill_cell(Sheet& sheet, Wanted& wanted, std::size_t index, const Box& cell) {
        Box room = rectangle(cell.min.x, cell.min.y + caption_height(wanted, cell.width()), cell.max.x, cell.max.y);
        Figure figure = wanted.drawn_into(room.width(), room.height());
        // Captions of a row of figures share a baseline; a long one takes what it needs.
        std::vector<Mark> caption;
        room.min.y = std::max(room.min.y, cell.min.y + set_caption(caption, figure, cell.min, cell.width()));
        if (figure.box.height() > room.height()) figure = wanted.drawn_into(room.width(), room.height());
        if (!wanted.equations.empty()) {
            const std::array<Block, 2> blocks{arranged(wanted.equations, false), arranged(wanted.equations, true)};
            if (!beside(sheet, figure, blocks, room) && !apart(sheet, figure, wanted, blocks, room)) {
                unplaced_.insert(index);
                centre(figure, room);
            }
        } else {
            centre(figure, room);
        }
        --figures_;
        set_caption(sheet.marks, figure, cell.min, cell.width());
        sheet.marks.insert(sheet.marks.end(), figure.marks.begin(), figure.marks.end());
        drawn_.push_back(std::move(figure));
    }

    /// In the middle across, under its caption: what is left stays in one piece.
    static void centre(Figure& figure, const Box& room) { align(figure, room, 0.5, 0.0); }
    static void align(Figure& figure, const Box& room, double across, double down) {
        figure.move(room.min.x - figure.box.min.x + across * (room.width() - figure.box.width()),
                    room.min.y - figure.box.min.y + down * (room.height() - figure.box.height()));
    }

    /// The equations in a corner that the figure leaves free, the figure as large as without them.
    bool beside(Sheet& sheet, Figure& figure, const std::array<Block, 2>& blocks, const Box& room) const {
        const std::vector<Spot> spots = covered(figure.marks);
        const double spare_x = room.width() - figure.box.width(), spare_y = room.height() - figure.box.height();
        if (spare_x < 0 || spare_y < 0) return false;
        for (const Block& block : blocks) {
            if (block.width > room.width() || block.height > room.height()) continue;
            const double right = room.max.x - block.width, bottom = room.max.y - block.height;
            const Spot top_left = room.min, top_right{right, room.min.y}, bottom_left{room.min.x, bottom},
                       bottom_right{right, bottom};
            // The figure stays in the middle and under its caption as far as the equations let it.
            struct Try {
                Spot corner;
                double across, down;
            };
            for (const Try& each :
                 {Try{top_left, 0.5, 0}, Try{top_right, 0.5, 0}, Try{top_left, 0.75, 0}, Try{top_right, 0.25, 0},
                  Try{top_left, 1, 0}, Try{top_right, 0, 0}, Try{bottom_right, 0.5, 0}, Try{bottom_left, 0.5, 0},
                  Try{bottom_right, 0, 0}, Try{bottom_left, 1, 0}, Try{top_left, 0.5, 0.5}, Try{top_right, 0.5, 0.5},
                  Try{top_left, 1, 0.5}, Try{top_right, 0, 0.5}, Try{top_left, 0.5, 1}, Try{top_right, 0.5, 1},
                  Try{top_left, 1, 1}, Try{top_right, 0, 1}}) {
                const Spot moved{room.min.x - figure.box.min.x + each.across * spare_x,
                                 room.min.y - figure.box.min.y + each.down * spare_y};
                const Box box =
                    rectangle(each.corner.x, each.corner.y, each.corner.x + block.width, each.corner.y + block.height);
                if (!is_free(spots, moved, box, clear)) continue;
                figure.move(moved.x, moved.y);
                set(sheet, block, each.corner);
                return true;
            }
        }
        return false;
    }

    /// The room divided between equations and figure, whichever way leaves the figure larger.
    bool apart(Sheet& sheet, Figure& figure, Wanted& wanted, const std::array<Block, 2>& blocks, const Box& room) const {
        struct Way {
            Box figure_room;
            Spot corner;
            const Block* block;
        };
        std::vector<Way> ways;
        for (const Block& block : blocks) {
            if (room.width() - block.width > 45)
                ways.push_back({rectangle(room.min.x, room.min.y, room.max.x - block.width - 5, room.max.y),
                                {room.max.x - block.width, room.min.y + 2},
                                &block});
            if (block.width <= room.width() && room.height() - block.height > 40)
                ways.push_back({rectangle(room.min.x, room.min.y + block.height + 4, room.max.x, room.max.y), room.min, &block});
        }
        const Way* best = nullptr;
        double scale = 1e300;
        for (const Way& way : ways) {
            const double x = way.figure_room.width() - wanted.rim_x, y = way.figure_room.height() - wanted.rim_y;
            if (x < 12 || y < 12) continue;
            const double would_be = choose_scale(wanted.extent_x, wanted.extent_y, x, y, std::nullopt);
            if (would_be < scale) scale = would_be, best = &way;
        }
        // A polygon three steps smaller is no fair price: then the equations stand with the steps.
        if (!best || scale > 3 * figure.scale) return false;
        Figure smaller = wanted.drawn_into(best->figure_room.width(), best->figure_room.height());
        if (smaller.scale > 3 * figure.scale || smaller.box.width() > best->figure_room.width() ||
            smaller.box.height() > best->figure_room.height())
            return false;
        figure = std::move(smaller);
        centre(figure, best->figure_room);
        set(sheet, *best->block, best->corner);
        return true;
    }

    static void set(Sheet& sheet, const Block& block, Spot at) {
        std::vector<Mark> marks = block.marks;
        render::move(marks, at.x, at.y);
        sheet.marks.insert(sheet.marks.end(), marks.begin(), marks.end());
    }

    /// Free runs of a page on which figures stand.
    void find_runs(Sheet& sheet, const std::vector<Box>& cells, std::size_t first) const {
        Occupancy occupancy(format_.width, format_.height);
        occupancy.block(covered(sheet.marks));
        occupancy.block(rectangle(block_.min.x - clear, block_.min.y - clear, block_.max.x + clear, block_.max.y + clear));
        // What stands in a line with something is preferred: cells, then the columns of the page.
        std::vector<double> lefts;
        for (const Box& cell : cells) lefts.push_back(cell.min.x);
        lefts.push_back(content_.max.x - measure_);
        for (const Box& cell : cells) {
            lefts.push_back(cell.max.x - measure_);
            lefts.push_back(cell.max.x + gap);
        }
        for (int k = 0; k < format_.columns; ++k) lefts.push_back(content_.min.x + k * (measure_ + gap));
        for (;;) {
            Box best = rectangle(0, 0, 0, 0);
            for (const double left : lefts) {
                if (left < content_.min.x - 0.01 || left + measure_ > content_.max.x + 0.01) continue;
                const auto [top, bottom] =
                    occupancy.longest_run(left - clear, left + measure_ + clear, content_.min.y, content_.max.y);
                if (bottom - top > best.height() + 6) best = rectangle(left, top, left + measure_, bottom);
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

    // --- text ----------------------------------------------------------------------------------------------------------------

    Block heading(const std::string& text, const RichText& note = {}) const {
        Block block;
        const ShapedLine shaped = shape(one_piece(text, Face::bold), options_.theme.label);
        set_text(block.marks, shaped, {0, 3.6}, options_.theme.text, "text");
        if (!note.empty()) {
            const ShapedLine small = shape(note, options_.theme.small);
            if (shaped.width + 4 + small.width <= measure_)
                set_text(block.marks, small, {shaped.width + 4, 3.6}, options_.theme.secondary, "text");
        }
        block.width = measure_;
        block.height = 6.2;
        return block;
    }
    Block paragraph(const RichText& text, double indent = 0, const std::string& number_text = {}) const {
        Block block;
        double baseline = 3.2;
        if (!number_text.empty())
            set_text(block.marks, shape(one_piece(number_text), options_.theme.body_text), {0, baseline},
                     options_.theme.secondary, "text");
        for (const ShapedLine& each : context_.fonts.wrap(text, options_.theme.body_text, measure_ - indent)) {
            set_text(block.marks, each, {indent, baseline}, options_.theme.text, "text");
            baseline += 4.1;
        }
        block.width = measure_;
        block.height = baseline - 3.2 + 0.7;
        return block;
    }

    /// Sentences that the list of centres says as well.
    static bool told_by_list(const Statement& statement) {
        switch (statement.message.sentence) {
            case Sentence::primary_revolute:
            case Sentence::primary_prismatic:
            case Sentence::primary_rolling:
            case Sentence::primary_gear:
            case Sentence::primary_weld:
            case Sentence::primary_line:
            case Sentence::kennedy:
            case Sentence::kennedy_line:
            case Sentence::kennedy_two_normals:
                return true;
            default:
                return false;
        }
    }

    bool has_circle() const { return solution().mechanism.bodies.size() >= 3 && !solution().centres.empty(); }
    bool has_velocities() const {
        return std::any_of(solution().points.begin(), solution().points.end(),
                           [](const PointMotion& m) { return m.point >= 0 && m.velocity && !m.velocity->is_zero(); });
    }

    void write_sections() {
        const Solution& s = solution();
        const auto add = [&](Section section) {
            if (!section.rows.empty()) sections_.push_back(std::move(section));
        };

        std::vector<ResultRow> rows = result_rows(context_, drawn_);
        for (ResultRow& row : force_rows(context_, drawn_)) rows.push_back(std::move(row));
        if (!rows.empty()) {
            const double longest = content_.height() - format_.block_height - 8;
            const auto fit = static_cast<std::size_t>(std::max(8.0, (longest - 14) / 4.5));
            for (std::size_t from = 0; from < rows.size();) {
                std::size_t to = std::min(rows.size(), from + fit);
                // A table is divided between groups where it can.
                if (to < rows.size())
                    for (std::size_t k = to; k > from + 4; --k)
                        if (rows[k].group != rows[k - 1].group) {
                            to = k;
                            break;
                        }
                const std::vector<ResultRow> part(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                                  rows.begin() + static_cast<std::ptrdiff_t>(to));
                Section table;
                table.rows.push_back(results_block(context_, part, measure_, true));
                add(std::move(table));
                from = to;
            }
        }

        if (!s.unsolved.empty()) {
            Section section;
            section.rows.push_back(heading(word("unsolved", language())));
            for (const Unsolved& each : s.unsolved) section.rows.push_back(paragraph(with_powers(each.what + ": " + each.why)));
            add(std::move(section));
        }

        int step = 0;
        std::vector<std::string> order{"velocity", "acceleration", "relative motion", "centres"};
        // An angular velocity found a second time belongs to the velocities.
        const auto section_of = [](const Statement& statement) -> std::string {
            return statement.message.sentence == Sentence::second_way ? "velocity" : statement.section;
        };
        for (const Statement& statement : s.protocol.statements)
            if (std::find(order.begin(), order.end(), section_of(statement)) == order.end())
                order.push_back(section_of(statement));
        for (const std::string& name : order) {
            Section section;
            std::set<BodyIndex> told;
            if (name == "centres") section.home = 0;
            if (name == "forces") {
                section.home = static_cast<int>(first_of_forces_);
                section.of_forces = true;
            }
            for (std::size_t p = 0; p < s.protocol.polygons.size() && section.home < 0; ++p) {
                const Polygon& polygon = s.protocol.polygons[p];
                if (polygon.plane == Plane::force) continue;
                if (polygon.point.empty() ? name == (polygon.plane == Plane::acceleration ? "acceleration" : "velocity")
                                          : name == "relative motion")
                    section.home = static_cast<int>(p) + 1;
            }
            for (std::size_t i = 0; i < s.protocol.statements.size(); ++i) {
                const Statement& statement = s.protocol.statements[i];
                if (section_of(statement) != name || told_by_list(statement)) continue;
                if (section.rows.empty())
                    section.rows.push_back(heading(word(
                        std::find(order.begin(), order.begin() + 4, name) != order.begin() + 4 || (name == "forces" && is_mixed())
                            ? "steps " + name
                            : "steps",
                        language())));
                section.rows.push_back(paragraph(say(statement.message, language()), 6, std::to_string(++step)));
                if (name == "forces") add_force_equation(section, statement.message, told);
                const auto placed = equation_polygon_.find(i);
                if (statement.equation && (placed == equation_polygon_.end() || unplaced_.contains(placed->second))) {
                    Block block = equation_block(context_, *statement.equation, measure_ - 6);
                    render::move(block.marks, 6, 0.5);
                    block.height += 2.5;
                    section.rows.push_back(std::move(block));
                }
            }
            add(std::move(section));
        }

        {
            Section section;
            section.home = 0;
            section.rows = body_lines(context_, measure_);
            if (!section.rows.empty()) section.rows.insert(section.rows.begin(), heading(word("bodies", language())));
            add(std::move(section));
        }
        if (has_forces()) {
            Section section;
            section.of_forces = true;
            section.rows = reaction_lines(context_, measure_);
            section.rows.insert(section.rows.begin(), heading(word("forces", language())));
            add(std::move(section));
        }
        if (lever_ && !lever_has_table()) {
            Section section;
            section.home = static_cast<int>(*lever_);
            section.of_forces = true;
            section.rows = {heading(word("lever", language())), lever_table_};
            add(std::move(section));
        }
        if (!s.centres.empty()) {
            Section section;
            section.home = 0;
            section.rows = centre_lines(context_, measure_);
            section.rows.insert(section.rows.begin(),
                                heading(word("instant centres", language()), one_piece(s.mechanism.units.length.symbol)));
            add(std::move(section));
        }
        {
            Section section;
            section.rows.push_back(heading(word("mobility", language())));
            section.rows.push_back(paragraph(mobility_words()));
            section.rows.push_back(paragraph(axes_words()));
            if (s.protocol.polygons.empty() && s.mechanism.drivers.empty() && !s.mechanism.motion)
                section.rows.push_back(paragraph(one_piece(word("nothing driven", language()))));
            add(std::move(section));
        }
        std::vector<RichText> refused;
        for (std::size_t i = 0; i < wanted_.size() && i < drawn_.size(); ++i)
            if (misses(wanted_[i], drawn_[i])) {
                RichText text = drawn_[i].caption;
                append(text, one_piece(": " + word("scale refused", language())));
                refused.push_back(std::move(text));
            }
        if (!s.remarks.empty() || !refused.empty()) {
            Section section;
            section.rows.push_back(heading(word("remarks", language())));
            for (const RichText& each : refused) section.rows.push_back(paragraph(each));
            for (const std::string& each : s.remarks) section.rows.push_back(paragraph(with_powers(each)));
            add(std::move(section));
        }
    }

    /// What is known of a body's forces stands with the step that closes its polygon, unless the figure has it.
    void add_force_equation(Section& section, const Message& message, std::set<BodyIndex>& told) const {
        if (!force_equations_) return;
        if (message.sentence != Sentence::triangle && message.sentence != Sentence::triangle_at &&
            message.sentence != Sentence::single_reaction && message.sentence != Sentence::culmann &&
            message.sentence != Sentence::culmann_line)
            return;
        const auto* name = message.arguments.empty() ? nullptr : std::get_if<BodyName>(&message.arguments.front());
        const auto index = name ? solution().mechanism.body_named(name->name) : std::nullopt;
        if (!index || !told.insert(*index).second) return;
        const std::string heading_word = word("magnitude", language());
        for (const Figure& figure : drawn_)
            if (figure.kind == "forces")
                for (const Mark& mark : figure.marks)
                    if (const auto* text = std::get_if<TextMark>(&mark); text && text->words == heading_word) return;
        for (const FreeBody& body : solution().free_bodies) {
            if (body.body != *index) continue;
            Block block = force_equation_block(context_, body, true);
            if (block.width == 0 || block.width > measure_ - 6) continue;
            render::move(block.marks, 6, 0.5);
            block.height += 2.5;
            section.rows.push_back(std::move(block));
        }
    }

    RichText mobility_words() const {
        const Mobility& m = solution().mobility;
        const auto n = [](int value) { return std::to_string(value); };
        RichText text;
        const auto italic = [&](const char* letter, const char* sub = "") {
            Piece piece = one_piece(letter, Face::italic).front();
            piece.sub = sub;
            piece.sub_face = Face::regular;
            text.push_back(piece);
        };
        italic("n");
        append(text, one_piece(" = 3("));
        italic("m");
        append(text, one_piece(" − 1) − 2"));
        italic("c", "1");
        append(text, one_piece(" − "));
        italic("c", "2");
        if (m.welds > 0) {
            append(text, one_piece(" − 3"));
            italic("w");
        }
        const auto signed_number = [&](int value) { return (value < 0 ? "−" : "") + n(std::abs(value)); };
        append(text, one_piece(" = 3·" + n(m.bodies - 1) + " − 2·" + n(m.class_1) + " − " + n(m.class_2) +
                               (m.welds > 0 ? " − 3·" + n(m.welds) : "") + " = " + signed_number(m.gruebler) + " " +
                               word("by Grübler", language())));
        if (m.effective != m.gruebler) append(text, one_piece("; " + n(m.effective) + " " + word("effective", language())));
        append(text, one_piece("."));
        return text;
    }
    RichText axes_words() const {
        RichText text;
        const std::string words = word(has_forces() && !has_motion() ? "axes forces" : "axes", language());
        std::string plain_part;
        for (std::size_t i = 0; i < words.size();) {
            const std::string_view rest = std::string_view(words).substr(i);
            const bool omega = rest.starts_with("ω"), alpha = rest.starts_with("α");
            if (omega || alpha) {
                append(text, one_piece(plain_part));
                plain_part.clear();
                append(text, typeset(Symbol{omega ? Symbol::Letter::omega : Symbol::Letter::alpha, "", ""}, language()));
                i += 2;
            } else {
                plain_part += words[i++];
            }
        }
        append(text, one_piece(plain_part));
        return text;
    }

    // --- flow ----------------------------------------------------------------------------------------------------------------

    Box column(int k) const {
        const double left = content_.min.x + k * (measure_ + gap);
        const double bottom = left + measure_ > block_.min.x - 2 ? block_.min.y - 4 : content_.max.y;
        return rectangle(left, content_.min.y, left + measure_, bottom);
    }

    /// A figure of the text pages: its room is kept in the flow and drawn at the end.
    struct Late {
        std::function<Figure(double, double)> draw;
        double width = 0, height = 0;
    };

    static bool pack(const std::vector<double>& heights, std::vector<Run>& runs,
                     std::vector<std::pair<std::size_t, double>>* where) {
        for (const double height : heights) {
            bool placed = false;
            for (std::size_t r = 0; r < runs.size() && !placed; ++r) {
                const double before = runs[r].used > 0 ? section_gap : 0;
                if (runs[r].left() < before + height) continue;
                if (where) where->emplace_back(r, runs[r].used + before);
                runs[r].used += before + height;
                placed = true;
            }
            if (!placed) return false;
        }
        return true;
    }

    Block figure_block(const Late& late, double width, double height) {
        Block block;
        Figure figure = late.draw(width, height - 7);
        const double caption = set_caption(block.marks, figure, {0, 0}, width);
        figure.move(-figure.box.min.x + std::max(0.0, 0.5 * (width - figure.box.width())), caption - figure.box.min.y);
        block.marks.insert(block.marks.end(), figure.marks.begin(), figure.marks.end());
        block.width = width;
        block.height = caption + figure.box.height();
        return block;
    }

    void flow() {
        std::vector<Late> late;
        if (has_velocities())
            late.push_back({[this](double x, double y) { return velocities_on_mechanism(context_, x, y); }, 0, 0});
        if (has_circle()) late.push_back({[this](double x, double y) { return circle_diagram(context_, x, y); }, 0, 0});

        // What the pages with figures take.
        std::vector<Section> rest;
        // First what explains a figure beside that figure, then the others wherever there is room.
        for (Section& section : sections_)
            if (section.home >= 0) place_section(section, true);
        for (Section& section : sections_)
            if (!section.rows.empty() && !place_section(section)) rest.push_back(std::move(section));
        std::vector<Late> late_rest;
        for (Late& each : late)
            if (!rest.empty() || !place_late(each)) late_rest.push_back(std::move(each));
        if (rest.empty() && late_rest.empty()) return;

        // A page of columns: the late figures as large as the text lets them.
        std::vector<double> heights;
        for (const Section& section : rest) heights.push_back(section.height());
        double wide = 0, small = 0;
        for (const double w : {130.0, 115.0, 100.0, 88.0, 76.0, 66.0, 0.0}) {
            bool found = false;
            for (const double c : {80.0, 68.0, 58.0}) {
                std::vector<Run> runs = text_runs(late_rest.size() > 1 ? w : 0, late_rest.empty() ? 0 : c, late_rest.size());
                if (pack(heights, runs, nullptr)) {
                    wide = late_rest.size() > 1 ? w : 0;
                    small = late_rest.empty() ? 0 : c;
                    found = true;
                    break;
                }
            }
            if (found) break;
        }
        sheets_.emplace_back();
        if (small > 0) {
            double wide_drawn = 0, small_drawn = 0;
            std::size_t next = 0;
            if (wide > 0) {
                const Block block = figure_block(late_rest[next++], 2 * measure_ + gap, wide);
                set(sheets_.back(), block, column(0).min);
                wide_drawn = block.height;
            }
            for (; next < late_rest.size(); ++next) {
                const Box place = column(format_.columns - 1 - (late_rest.size() > 1 && wide == 0 && next == 0 ? 1 : 0));
                const Block block = figure_block(late_rest[next], measure_, small);
                set(sheets_.back(), block, place.min);
                small_drawn = std::max(small_drawn, block.height);
            }
            sheets_.back().runs = text_runs(wide_drawn, small_drawn, late_rest.size());
        } else {
            sheets_.back().runs = text_runs(0, 0, 0);
        }
        for (Section& section : rest)
            while (!section.rows.empty())
                if (!place_section(section)) split_section(section);
        if (small <= 0) place_last(late_rest);
    }

    /// Figures after the text, as large as the last page has columns to spare for them.
    void place_last(const std::vector<Late>& figures) {
        if (figures.empty()) return;
        int free = 0;
        std::vector<Run>& runs = sheets_.back().runs;
        while (free < static_cast<int>(runs.size()) && runs[runs.size() - 1 - static_cast<std::size_t>(free)].used == 0) ++free;
        if (free < 2) {
            std::vector<Late> left;
            for (const Late& each : figures)
                if (!place_late(each)) left.push_back(each);
            if (left.empty()) return;
            sheets_.emplace_back();
            sheets_.back().runs = text_runs(0, 0, 0);
            place_last(left);
            return;
        }
        // The mechanism over two columns, the circle in the third or below.
        const int first = format_.columns - free;
        Box place = column(first);
        const bool third = free > 2 && figures.size() > 1;
        const double bottom = std::min(column(first + 1).max.y, place.max.y);
        const double height = bottom - place.min.y - (figures.size() > 1 && !third ? 68 : 0);
        const Block block = figure_block(figures.front(), 2 * measure_ + gap, std::min(height, 150.0));
        set(sheets_.back(), block, place.min);
        if (figures.size() < 2) return;
        place = third ? column(first + 2) : rectangle(place.min.x, place.min.y + block.height + gap, place.max.x, bottom);
        set(sheets_.back(), figure_block(figures.back(), measure_, std::min(place.height(), 85.0)), place.min);
    }

    /// Columns of a text page below its figures.
    std::vector<Run> text_runs(double wide, double small, std::size_t figures) const {
        std::vector<Run> runs;
        for (int k = 0; k < format_.columns; ++k) {
            Run run{column(k)};
            const bool last = k == format_.columns - 1;
            if (wide > 0 && k < 2) run.box.min.y += wide + section_gap;
            if (small > 0 && (last || (wide == 0 && figures > 1 && k == format_.columns - 2)))
                run.box.min.y += small + section_gap;
            runs.push_back(run);
        }
        return runs;
    }

    /// Whether a section may stand in a run: under a caption only what explains that figure.
    static bool may_stand(const Section& section, const Run& run) { return run.home == section.home || !run.under_caption; }

    bool place_section(Section& section, bool only_at_home = false) {
        const double height = section.height();
        for (const bool at_home : {true, false}) {
            if (at_home ? section.home < 0 : only_at_home) continue;
            for (Sheet& sheet : sheets_)
                for (Run& run : sheet.runs) {
                    if (section.of_forces && &sheet < sheets_.data() + force_page_) break;
                    if (section.continued && (&sheet != &sheets_.back() || run.used > 0)) continue;
                    if (at_home ? run.home != section.home : !may_stand(section, run)) continue;
                    const double before = run.used > 0 ? section_gap : 0;
                    if (run.left() < before + height) continue;
                    run.used += before;
                    for (const Block& row : section.rows) {
                        set(sheet, row, {run.box.min.x, run.box.min.y + run.used});
                        run.used += row.height;
                    }
                    section.rows.clear();
                    return true;
                }
        }
        return false;
    }

    /// A section longer than what is left anywhere: its first rows into the roomiest run, the rest goes on.
    void split_section(Section& section) {
        // From left to right, so that the rows are read in order.
        Run* best = nullptr;
        Sheet* on = &sheets_.back();
        for (Run& run : on->runs)
            if (!best && run.left() >= 30 + section_gap) best = &run;
        for (Run& run : on->runs)
            if (!best || (best->left() < 30 && run.left() > best->left())) best = &run;
        const double first = section.rows.front().height + (section.rows.size() > 1 ? section.rows[1].height : 0);
        const double before = best && best->used > 0 ? section_gap : 0;
        // Not worth a split: a new page, unless this one is new already.
        const bool fresh = best && best->used == 0;
        if (!best || best->left() < before + std::max(first, fresh ? 0.0 : 30.0)) {
            KG_ASSERT(!fresh || first > best->left(), "a fresh column takes at least a row");
            if (!fresh) {
                sheets_.emplace_back();
                sheets_.back().runs = text_runs(0, 0, 0);
                return;
            }
        }
        best->used += before;
        std::size_t count = 0;
        while (count < section.rows.size() && (count == 0 || best->left() >= section.rows[count].height)) {
            set(*on, section.rows[count], {best->box.min.x, best->box.min.y + best->used});
            best->used += section.rows[count].height;
            ++count;
        }
        section.rows.erase(section.rows.begin(), section.rows.begin() + static_cast<std::ptrdiff_t>(count));
        section.continued = true;
    }

    bool place_late(const Late& late) {
        for (Sheet& sheet : sheets_)
            for (Run& run : sheet.runs) {
                const double before = run.used > 0 ? section_gap : 0;
                const double room = std::min(run.left() - before, 0.95 * measure_);
                if (room < 58 || run.under_caption) continue;
                const Block block = figure_block(late, measure_, room);
                set(sheet, block, {run.box.min.x, run.box.min.y + run.used + before});
                run.used += before + block.height;
                return true;
            }
        return false;
    }

    // --- the page ------------------------------------------------------------------------------------------------------------

    Page finish(const Sheet& sheet, std::size_t index, std::size_t count) const {
        const Theme& theme = options_.theme;
        Page page;
        page.width = format_.width;
        page.height = format_.height;
        page.paper = theme.paper;
        page.title = title();
        page.language = language() == Language::it ? "it" : "en";
        const Pen pen{theme.outline, theme.text, {}, false};
        page.marks.emplace_back(
            polyline({inner_.min, {inner_.max.x, inner_.min.y}, inner_.max, {inner_.min.x, inner_.max.y}}, pen, true));
        draw_block(page.marks, index, count);
        page.marks.insert(page.marks.end(), sheet.marks.begin(), sheet.marks.end());
        // A point's label says its name as the file has it, however it is set.
        std::map<std::string, std::string> names;
        for (const NamedPoint& point : solution().mechanism.points)
            names.emplace(plain(typeset(Symbol{Symbol::Letter::point, point.name, ""}, language())), point.name);
        for (Mark& mark : page.marks)
            if (auto* text = std::get_if<TextMark>(&mark); text && text->cls == "label")
                if (const auto found = names.find(text->words); found != names.end()) text->words = found->second;
        return page;
    }

    std::string title() const {
        const std::string& given = in(solution().mechanism.title, language());
        return given.empty() ? word("untitled", language()) : given;
    }

    void draw_block(std::vector<Mark>& marks, std::size_t index, std::size_t count) const {
        const Theme& theme = options_.theme;
        const Pen edge{theme.outline, theme.text, {}, false}, inner_pen{theme.thin, theme.text, {}, false};
        const double cells_width = options_.paper == Paper::a3 ? 25 : 17.5, cells_left = block_.max.x - 3 * cells_width;
        const double half = block_.min.y + format_.block_height / 2;
        marks.emplace_back(line({block_.min.x, block_.min.y}, {block_.max.x, block_.min.y}, edge));
        marks.emplace_back(line({block_.min.x, block_.min.y}, {block_.min.x, block_.max.y}, edge));
        marks.emplace_back(line({cells_left, block_.min.y}, {cells_left, block_.max.y}, inner_pen));
        marks.emplace_back(line({cells_left + cells_width, block_.min.y}, {cells_left + cells_width, block_.max.y}, inner_pen));
        marks.emplace_back(
            line({cells_left + 2 * cells_width, block_.min.y}, {cells_left + 2 * cells_width, block_.max.y}, inner_pen));
        marks.emplace_back(line({cells_left, half}, {block_.max.x, half}, inner_pen));

        const Units& units = solution().mechanism.units;
        std::string units_text = units.length.symbol + (has_motion() || !has_forces() ? ", s" : "");
        if (has_forces()) units_text += ", " + units.force.symbol;
        std::string scale = "–";
        for (const Figure& figure : drawn_)
            if (figure.kind == "mechanism") {
                const double ratio = figure.scale * 1000;
                scale = ratio >= 1 ? "1 : " + shortest(std::round(ratio * 1e9) / 1e9, language())
                                   : shortest(std::round(1e9 / ratio) / 1e9, language()) + " : 1";
            }
        std::string file = solution().mechanism.source;
        if (const std::size_t slash = file.find_last_of('/'); slash != std::string::npos) file = file.substr(slash + 1);
        const std::array<std::pair<std::string, std::string>, 6> cells{
            std::pair{word("block scale", language()), scale},
            {word("block size", language()), format_.name},
            {word("block sheet", language()), std::to_string(index) + "/" + std::to_string(count)},
            {word("block units", language()), units_text},
            {word("block readings", language()), fixed(0.1, 1, language()) + " mm"},
            {word("block bodies", language()), std::to_string(solution().mechanism.bodies.size())}};
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const double x = cells_left + static_cast<double>(i % 3) * cells_width + 1.6;
            const double top = i < 3 ? block_.min.y : half;
            const double height = format_.block_height / 2;
            set_text(marks, shape(one_piece(cells[i].first), theme.block), {x, top + 0.34 * height}, theme.secondary, "text");
            double size = options_.paper == Paper::a3 ? theme.derived : theme.body_text;
            ShapedLine value = shape(one_piece(cells[i].second), size);
            while (value.width > cells_width - 3 && size > 4) value = shape(one_piece(cells[i].second), size -= 0.5);
            set_text(marks, value, {x, top + 0.82 * height}, theme.text, "text");
        }

        const double left = block_.min.x + 3.5, width = cells_left - left - 2;
        double size = options_.paper == Paper::a3 ? theme.title : 13;
        std::vector<ShapedLine> lines = context_.fonts.wrap(one_piece(title(), Face::bold), size, width);
        const auto too_wide = [&] {
            return lines.size() > 2 ||
                   std::any_of(lines.begin(), lines.end(), [&](const ShapedLine& l) { return l.width > width; });
        };
        while (too_wide() && size > 4) lines = context_.fonts.wrap(one_piece(title(), Face::bold), size -= 0.5, width);
        const double lead = millimetres(size) * 1.15;
        double baseline = block_.min.y + (lines.size() > 1 ? 1.5 : 2.8) + millimetres(size) * 0.72;
        for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 2); ++i) {
            set_text(marks, lines[i], {left, baseline}, theme.text, "text");
            baseline += lead;
        }
        const bool acceleration = std::any_of(solution().protocol.polygons.begin(), solution().protocol.polygons.end(),
                                              [](const Polygon& p) { return p.plane == Plane::acceleration; });
        const std::string subtitle = word(is_mixed()                             ? "subtitle mixed"
                                          : has_forces()                         ? "subtitle forces"
                                          : solution().protocol.polygons.empty() ? "subtitle pose"
                                          : acceleration                         ? "subtitle acceleration"
                                                                                 : "subtitle velocity",
                                          language());
        const auto small_print = [&](const std::string& words, double at) {
            double print = options_.paper == Paper::a3 ? theme.body_text : 7.5;
            ShapedLine shaped = shape(one_piece(words), print);
            while (shaped.width > width && print > 3) shaped = shape(one_piece(words), print -= 0.5);
            set_text(marks, shaped, {left, at}, theme.secondary, "text");
        };
        if (lines.size() == 1) small_print(subtitle, block_.max.y - (file.empty() ? 3.2 : 5.4));
        if (!file.empty()) small_print(file, block_.max.y - 2.0);
    }

    const SheetOptions& options_;
    DrawingContext context_;
    Format format_;
    Box inner_, content_, block_;
    double measure_ = 80;

    std::optional<double> force_scale_;  // common to triangles and closed polygon, once one could not be drawn larger
    bool force_equations_ = true;        // with the steps, where the figure has no room for them
    std::size_t force_page_ = 0;         // where they begin
    std::size_t first_of_forces_ = 0;    // index into wanted_
    std::optional<std::size_t> lever_;   // index into wanted_
    Block lever_table_;
    std::size_t figure_pages_ = 0;
    std::optional<DrawingContext> unscaled_context_;
    std::optional<Solution> unscaled_;  // the same without the file's scales, made when one of them does not fit
    std::vector<Wanted> wanted_;
    std::map<std::size_t, std::size_t> equation_polygon_;  // statement → index into wanted_
    std::set<std::size_t> unplaced_;                       // figures whose equations stand with the steps
    std::vector<Figure> drawn_;
    std::vector<Section> sections_;
    std::vector<Sheet> sheets_, placed_;  // placed_: with figures only
    int numbered_ = 0;
    int figures_ = 0;
};

}  // namespace

std::vector<Page> lay_out(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return Layout(solution, options, fonts).pages();
}

}  // namespace kinegraph::render
