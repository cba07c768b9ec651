// Shapes: lines, discs, arrows, text, the scale bar, and bounding boxes.
#include "render/page/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "render/page/scale.hpp"

namespace kinegraph::render {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

/// std::round without a function call, in the range where doubles represent integers exactly.
double rounded(double value) {
    if (!(std::abs(value) < 4e15)) return std::round(value);
    const auto whole = static_cast<double>(static_cast<std::int64_t>(value));
    const double rest = value - whole;
    return whole + (rest >= 0.5 ? 1 : rest <= -0.5 ? -1 : 0);
}

double snapped(double value) {
    const double result = rounded(value * 1e8) / 1e8;
    return result == 0 ? 0 : result;  // no −0 in the output
}

struct Shift {
    double dx, dy;
    void operator()(Spot& spot) const { spot = {snapped(spot.x + dx), snapped(spot.y + dy)}; }
    void operator()(Path& path) const {
        for (Segment& segment : path.segments)
            std::visit(Overloaded{[&](MoveTo& s) { (*this)(s.to); }, [&](LineTo& s) { (*this)(s.to); },
                                  [&](CurveTo& s) {
                                      (*this)(s.control_1);
                                      (*this)(s.control_2);
                                      (*this)(s.to);
                                  },
                                  [&](ArcTo& s) { (*this)(s.centre); }, [](Close&) {}},
                       segment);
    }
    void operator()(Mark& mark) const {
        std::visit(Overloaded{[&](Path& path) { (*this)(path); },
                              [&](Axis& axis) {
                                  (*this)(axis.tail);
                                  (*this)(axis.tip);
                              },
                              [&](TextMark& text) {
                                  for (Glyph& glyph : text.glyphs) (*this)(glyph.origin);
                                  (*this)(text.pivot);
                                  for (Path& extra : text.extras) (*this)(extra);
                              },
                              [](GroupBegin&) {}, [](GroupEnd&) {}},
                   mark);
    }
};

struct Bounds {
    Box box{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
            {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};
    void add(Spot spot, double margin = 0) {
        box.min = {std::min(box.min.x, spot.x - margin), std::min(box.min.y, spot.y - margin)};
        box.max = {std::max(box.max.x, spot.x + margin), std::max(box.max.y, spot.y + margin)};
    }
    void add(const Path& path) {
        const double margin = path.stroked ? path.pen.width / 2 : 0;
        for (const Segment& segment : path.segments)
            std::visit(
                Overloaded{[&](const MoveTo& s) { add(s.to, margin); }, [&](const LineTo& s) { add(s.to, margin); },
                           [&](const CurveTo& s) {
                               add(s.control_1, margin);
                               add(s.control_2, margin);
                               add(s.to, margin);
                           },
                           [&](const ArcTo& s) { add(s, margin); }, [](const Close&) {}},
                segment);
    }
    void add(const ArcTo& arc, double margin) {
        const auto add_on = [&](Spot on) { add(arc.centre + arc.radius * on, margin); };
        if (arc.from == 0 && arc.to == whole_turn) {
            static const std::vector<Spot> whole = outermost_of_a_turn();
            for (const Spot on : whole) add_on(on);
        } else {
            look_round(arc.from, arc.to, add_on);
        }
    }
    /// Extreme points of an arc of radius 1: in steps of 0.1 rad, only the points next to its ends and to its axis
    /// crossings matter.
    template <class See>
    static void look_round(double from, double to, See see) {
        const double sweep = to - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / 0.1)));
        const auto look_at = [&](int i) {
            const double angle = from + sweep * i / steps;
            see(Spot{nearest::cos(angle), nearest::sin(angle)});
        };
        look_at(0);
        look_at(steps);
        constexpr double quarter = std::numbers::pi / 2;
        const double low = std::min(from, to), high = std::max(from, to);
        for (double k = std::ceil(low / quarter); k * quarter < high; ++k) {
            const int before = std::clamp(static_cast<int>((k * quarter - from) / sweep * steps), 0, steps - 1);
            look_at(before);
            look_at(before + 1);
        }
    }
    /// Most arcs are full circles, of pins and dots.
    static constexpr double whole_turn = 2 * std::numbers::pi;
    static std::vector<Spot> outermost_of_a_turn() {
        std::vector<Spot> all;
        look_round(0, whole_turn, [&](Spot on) { all.push_back(on); });
        return all;
    }
    static constexpr double letter_wide = 0.62;  ///< width of a letter's em box
    void add(const TextMark& text) {
        if (text.angle == 0) return add_upright(text);
        const double c = nearest::cos(text.angle), s = nearest::sin(text.angle);
        for (const Glyph& glyph : text.glyphs)
            // For the edge of a figure the em box is accurate enough; labels use the true ink.
            for (const Spot corner : {Spot{0, -letter_over}, Spot{letter_wide, -letter_over}, Spot{0, letter_under},
                                      Spot{letter_wide, letter_under}}) {
                const Spot at = glyph.origin + glyph.size * corner - text.pivot;
                add(text.pivot + Spot{at.x * c - at.y * s, at.x * s + at.y * c});
            }
    }
    /// The same for text that is not turned: two corners suffice.
    void add_upright(const TextMark& text) {
        for (const Glyph& glyph : text.glyphs)
            for (const Spot corner : {Spot{0, -letter_over}, Spot{letter_wide, letter_under}})
                add(text.pivot + (glyph.origin + glyph.size * corner - text.pivot));
    }
};

/// The largest coordinate or radius; infinite if one is no number.
struct Farthest {
    double away = 0;
    void add(double value) {
        const double size = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::abs(value);
        away = std::max(away, size);
    }
    void add(Spot spot) {
        add(spot.x);
        add(spot.y);
    }
    void add(const Path& path) {
        for (const Segment& segment : path.segments)
            std::visit(Overloaded{[&](const MoveTo& s) { add(s.to); }, [&](const LineTo& s) { add(s.to); },
                                  [&](const CurveTo& s) {
                                      add(s.control_1);
                                      add(s.control_2);
                                      add(s.to);
                                  },
                                  [&](const ArcTo& s) {
                                      add(s.centre);
                                      add(s.radius);
                                      add(s.from);
                                      add(s.to);
                                  },
                                  [](const Close&) {}},
                       segment);
    }
    void add(const TextMark& text) {
        for (const Glyph& glyph : text.glyphs) {
            add(glyph.origin);
            add(glyph.size);
        }
        add(text.pivot);
        add(text.angle);
        for (const Path& extra : text.extras) add(extra);
    }
};

struct Head {
    double length, width;
};
Head head_for(double width) {
    if (width >= 0.6) return {4.6, 1.7};
    if (width >= 0.3) return {3.6, 1.2};
    return {3.0, 1.0};
}

constexpr double notch = 0.18;  // as a fraction of the head's length

void draw_head(std::vector<Mark>& marks, Spot tip, Spot along, Head head, Colour colour) {
    const Spot across = (head.width / 2) * turned(along), back = tip - head.length * along;
    marks.emplace_back(filled({tip, back + across, tip - (head.length * (1 - notch)) * along, back - across}, colour));
}

}  // namespace

const std::vector<double>& dash_dot() {
    static const std::vector<double> pattern{5, 0.9, 0.6, 0.9};
    return pattern;
}
const std::vector<double>& dashes() {
    static const std::vector<double> pattern{2, 1};
    return pattern;
}

std::vector<double> going_round(std::vector<double> dashes, double length) {
    double period = 0;
    for (const double dash : dashes) period += dash;
    if (!(period > 0) || !(length > 0)) return dashes;
    const double stretch = length / (std::max(1.0, std::round(length / period)) * period);
    for (double& dash : dashes) dash *= stretch;
    return dashes;
}

Path line(Spot from, Spot to, Pen pen) {
    Path path;
    path.segments = {MoveTo{from}, LineTo{to}};
    path.stroked = true;
    path.pen = std::move(pen);
    return path;
}

Path polyline(const std::vector<Spot>& spots, Pen pen, bool closed) {
    Path path;
    for (std::size_t i = 0; i < spots.size(); ++i)
        path.segments.push_back(i == 0 ? Segment{MoveTo{spots[i]}} : Segment{LineTo{spots[i]}});
    if (closed) path.segments.emplace_back(Close{});
    path.stroked = true;
    path.pen = std::move(pen);
    return path;
}

std::vector<Spot> hull_of(std::vector<Spot> spots) {
    std::sort(spots.begin(), spots.end(), [](Spot a, Spot b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    if (spots.size() < 3) return spots;
    std::vector<Spot> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Spot spot : spots) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], spot - hull.back()) <= 1e-9)
                hull.pop_back();
            hull.push_back(spot);
        }
        hull.pop_back();
        std::reverse(spots.begin(), spots.end());
    }
    return hull;
}

Path filled(const std::vector<Spot>& spots, Colour fill) {
    Path path = polyline(spots, {}, true);
    path.stroked = false;
    path.filled = true;
    path.fill = fill;
    return path;
}

Path panel(const std::vector<Spot>& spots, Colour tint, Pen pen) {
    Path path = polyline(spots, std::move(pen), true);
    path.filled = path.tinted = true;
    path.fill = tint;
    return path;
}

std::vector<Spot> corners_about(Spot middle, Spot u, Spot w) {
    return {middle + u + w, middle + u - w, middle - u - w, middle - u + w};
}

Path arc(Spot centre, double radius, double from, double to, Pen pen) {
    Path path;
    path.segments = {MoveTo{centre + radius * polar_spot(from)}, ArcTo{centre, radius, from, to}};
    path.stroked = true;
    path.pen = std::move(pen);
    return path;
}

Path circle(Spot centre, double radius, Pen pen) {
    Path path;
    path.segments = {MoveTo{{centre.x + radius, centre.y}}, ArcTo{centre, radius, 0, 2 * std::numbers::pi}, Close{}};
    path.stroked = true;
    path.pen = std::move(pen);
    return path;
}

Path disc(Spot centre, double radius, Colour fill) {
    Path path = circle(centre, radius, {});
    path.stroked = false;
    path.filled = true;
    path.fill = fill;
    return path;
}

Path tinted(Path path) {
    path.tinted = true;
    return path;
}

Path ring(Spot centre, double radius, Colour tint, Pen pen) {
    Path path = circle(centre, radius, std::move(pen));
    path.filled = path.tinted = true;
    path.fill = tint;
    return path;
}

void draw_line_kind(std::vector<Mark>& marks, std::size_t first, double least, const BodyColour& body,
                    const Theme& theme) {
    if (body.dashes.empty()) return;
    std::vector<Path> heavy;
    for (std::size_t i = first; i < marks.size(); ++i)
        if (const auto* path = std::get_if<Path>(&marks[i]);
            path && path->stroked && path->pen.width >= least && path->pen.colour == body.line)
            heavy.push_back(*path);
    for (const bool ground : {true, false}) {
        for (Path path : heavy) {
            path.filled = false;
            path.pen.width -= 2 * std::min(theme.outline, 0.25 * path.pen.width);
            path.pen.round_ends = ground;
            path.pen.colour = ground ? body.tint : body.line;
            if (!ground) path.pen.dashes = body.dashes;
            marks.emplace_back(std::move(path));
        }
    }
}

void draw_arc_arrow(std::vector<Mark>& marks, Spot centre, double radius, double from, double to, double width,
                    Colour colour) {
    const Head head{3.2, 1.15};
    const double turn = to > from ? 1 : -1;
    // The head is a straight chord: it leaves the arc where its back lies on the arc, so that the tip is on the arc as
    // well.
    const double chord = 2 * nearest::asin(std::min(1.0, head.length / (2 * radius)));
    const auto on_arc = [&](double angle) { return centre + radius * Spot{nearest::cos(angle), nearest::sin(angle)}; };
    const double back = to - turn * std::min(chord, std::abs(to - from));
    Path shaft;
    const double shaft_end = back + turn * chord * (notch + 0.07);
    shaft.segments = {MoveTo{on_arc(from)}, ArcTo{centre, radius, from, shaft_end}};
    shaft.stroked = true;
    shaft.pen = {width, colour, {}, false};
    marks.emplace_back(std::move(shaft));
    draw_head(marks, on_arc(to), unit(on_arc(to) - on_arc(back)), head, colour);
}

void set_text(std::vector<Mark>& marks, ShapedLine shaped, Spot origin, Colour colour, const std::string& cls) {
    bool first = true;
    for (ShapedLine::Part& part : shaped.parts) {
        auto& text = std::get<TextMark>(marks.emplace_back(std::in_place_type<TextMark>));
        text.glyphs = std::move(part.glyphs);
        text.extras = std::move(part.extras);
        text.colour = part.coloured ? part.colour : colour;
        if (first) text.words = std::move(shaped.words), text.text = std::move(shaped.text);
        text.cls = cls;
        text.pivot = origin;
        const Shift shift{origin.x, origin.y};
        for (Glyph& glyph : text.glyphs) shift(glyph.origin);
        for (Path& extra : text.extras) {
            shift(extra);
            (extra.filled ? extra.fill : extra.pen.colour) =
                text.colour;  // the dot of a derivative has its letter's ink
        }
        first = false;
    }
}

void draw_scale_bar(std::vector<Mark>& marks, const Fonts& fonts, const Theme& theme, Spot origin, double target,
                    double scale, double unit_in_si, const std::string& unit_symbol, Language language) {
    KG_ASSERT(scale > 0 && unit_in_si > 0, "a scale bar needs a scale");
    constexpr double height = 1.1;
    // The longest 1-2-5 length of the printed unit that fits. 2.5 is left out: half of it is not a round number.
    const double most = target * scale / unit_in_si;
    int exponent = static_cast<int>(std::floor(nearest::log10(most)));
    double value = decimal(1, exponent);
    for (const double step : {2.0, 5.0, 10.0})
        if (decimal(step, exponent) <= most * (1 + 1e-12)) value = decimal(step, exponent);
    const double width = value * unit_in_si / scale;
    const auto rectangle = [&](double from, double to) {
        return std::vector<Spot>{{origin.x + from, origin.y},
                                 {origin.x + to, origin.y},
                                 {origin.x + to, origin.y + height},
                                 {origin.x + from, origin.y + height}};
    };
    marks.emplace_back(filled(rectangle(0, width / 2), theme.text));
    marks.emplace_back(polyline(rectangle(0, width), {theme.thin, theme.text, {}, false}, true));
    ShapedLine zero = fonts.shape(one_piece("0"), theme.body_text);
    const std::string number_text = number(value, 1, language);
    const double digits = fonts.width(with_powers(number_text), theme.body_text);
    const double baseline = origin.y - 1.3, half = zero.width / 2;
    // On a short bar a long number stands further to the right.
    constexpr double apart = 1.2;
    const double number_at = std::max(width - digits / 2, half + apart);
    set_text(marks, std::move(zero), {origin.x - half, baseline}, theme.text, "text");
    set_text(marks, fonts.shape(with_powers(number_text + " " + unit_symbol), theme.body_text),
             {origin.x + number_at, baseline}, theme.text, "text");
}

Box box_of(std::span<const Mark> marks) {
    Bounds bounds;
    for (const Mark& mark : marks)
        std::visit(Overloaded{[&](const Path& path) { bounds.add(path); },
                              [&](const Axis& axis) {
                                  bounds.add(axis.tail);
                                  bounds.add(axis.tip);
                              },
                              [&](const TextMark& text) { bounds.add(text); }, [](const GroupBegin&) {},
                              [](const GroupEnd&) {}},
                   mark);
    if (bounds.box.min.x > bounds.box.max.x) return {};
    return bounds.box;
}

void belong(std::vector<Mark>& marks, std::size_t first, StatementIndex statement) {
    const auto take = [&](StatementIndex& own) {
        if (own == none) own = statement;
    };
    for (std::size_t i = first; i < marks.size(); ++i)
        std::visit(Overloaded{[&](Path& path) { take(path.statement); }, [&](TextMark& text) { take(text.statement); },
                              [&](GroupBegin& group) { take(group.statement); }, [](Axis&) {}, [](GroupEnd&) {}},
                   marks[i]);
}

void hang(std::vector<Mark>& marks, std::size_t first, const Holds& holds) {
    for (std::size_t i = first; i < marks.size(); ++i)
        if (auto* path = std::get_if<Path>(&marks[i]); path != nullptr && path->holds.form == Holds::Form::nothing)
            path->holds = holds;
}

bool can_be_written(std::span<const Mark> marks) {
    Farthest farthest;
    for (const Mark& mark : marks)
        std::visit(Overloaded{[&](const auto& drawn) { farthest.add(drawn); },
                              [&](const Axis& axis) {
                                  farthest.add(axis.tail);
                                  farthest.add(axis.tip);
                              },
                              [](const GroupBegin&) {}, [](const GroupEnd&) {}},
                   mark);
    return farthest.away <= farthest_mark;
}

void move(Spot& spot, double dx, double dy) { Shift{dx, dy}(spot); }

void move(std::span<Mark> marks, double dx, double dy) {
    for (Mark& mark : marks) Shift{dx, dy}(mark);
}

namespace {

void draw_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, Pen pen, int heads) {
    const double whole = length(tip - tail);
    if (!(whole > 0)) return;
    Head head = head_for(pen.width);
    // A short vector keeps at least two fifths of its shaft. The shaft gets thinner with the head, or it would be
    // visible beside the tip.
    constexpr double step = 1.15;  // from one head to the next, relative to its length: they touch at 1 − notch
    const double shrink = std::min(1.0, 0.6 * whole / (head.length * (1 + step * (heads - 1))));
    head = {head.length * shrink, head.width * std::max(shrink, 0.35)};
    pen.width = std::min(pen.width, 0.5 * head.width);
    const Spot along = unit(tip - tail);
    marks.emplace_back(line(tail, tip - (head.length * (1 - notch - 0.1)) * along, pen));
    for (int i = 0; i < heads; ++i) draw_head(marks, tip - (i * step * head.length) * along, along, head, pen.colour);
}

}  // namespace

void draw_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour,
                const std::vector<double>& dashes) {
    draw_arrow(marks, tail, tip, {width, colour, dashes, false}, 1);
}
void draw_double_arrow(std::vector<Mark>& marks, Spot tail, Spot tip, double width, Colour colour) {
    draw_arrow(marks, tail, tip, {width, colour, {}, false}, 2);
}

}  // namespace kinegraph::render
