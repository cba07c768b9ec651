// Splits the page into labels, other text and segments of stroke, or into two pictures.
#include "tests/support/page_checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "render/backends/backends.hpp"
#include "render/backends/picture_difference.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

struct TurnedBox {
    Spot centre, half, axis{1, 0};
};

struct Label {
    std::string words;
    TurnedBox ink;
    double ring = 0;  // radius of the circle round a number, with its pen; what is outside the circle may enter the box
};
struct Stroke {
    Spot from, to;
    double half = 0;
    Fault::Kind role = Fault::Kind::label_on_construction;
    std::string of;
};
struct FigureParts {
    std::string id;
    std::vector<Label> labels;
    std::vector<Stroke> strokes;
    std::vector<std::pair<std::size_t, Stroke>> leaders;  // with the index of the label
    std::vector<Label> texts;  // texts within the figure that are no labels: tables, scale bars
};
struct PageParts {
    std::vector<FigureParts> figures;
    std::vector<Label> texts;  // outside all figures
};

void widen(Box& box, Spot by) {
    box.min = {std::min(box.min.x, by.x), std::min(box.min.y, by.y)};
    box.max = {std::max(box.max.x, by.x), std::max(box.max.y, by.y)};
}
constexpr Box blank{{1e300, 1e300}, {-1e300, -1e300}};

/// The box of the ink before the text is turned.
Box unturned_ink(const TextMark& text, const Fonts& fonts) {
    Box box = blank;
    for (const Glyph& glyph : text.glyphs)
        for (const Segment& segment : fonts.outline(glyph.face, glyph.index).segments) {
            const auto add = [&](Spot s) { widen(box, glyph.origin + glyph.size * Spot{s.x, -s.y}); };
            if (const auto* m = std::get_if<MoveTo>(&segment)) add(m->to);
            if (const auto* l = std::get_if<LineTo>(&segment)) add(l->to);
            if (const auto* c = std::get_if<CurveTo>(&segment)) add(c->control_1), add(c->control_2), add(c->to);
        }
    return box;
}

TurnedBox turned_about(const Box& box, Spot pivot, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Spot arm = 0.5 * (box.min + box.max) - pivot;
    return {pivot + Spot{arm.x * c - arm.y * s, arm.x * s + arm.y * c}, 0.5 * (box.max - box.min), {c, s}};
}

std::vector<Stroke> strokes_of(const Path& path) {
    std::vector<Stroke> strokes;
    const double half = path.stroked ? path.pen.width / 2 : 0;
    Spot pen, start;
    const auto to = [&](Spot spot) {
        strokes.push_back({pen, spot, half, {}, {}});
        pen = spot;
    };
    for (const Segment& segment : path.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) pen = start = m->to;
        if (const auto* l = std::get_if<LineTo>(&segment)) to(l->to);
        if (std::holds_alternative<Close>(segment)) to(start);
        if (const auto* c = std::get_if<CurveTo>(&segment)) {
            const Spot p0 = pen;
            for (int i = 1; i <= 16; ++i) {
                const double t = i / 16.0, u = 1 - t;
                to((u * u * u) * p0 + (3 * u * u * t) * c->control_1 + (3 * u * t * t) * c->control_2 +
                   (t * t * t) * c->to);
            }
        }
        if (const auto* a = std::get_if<ArcTo>(&segment))
            for (int i = 0; i <= 64; ++i) {
                const double angle = a->from + (a->to - a->from) * i / 64;
                const Spot at = a->centre + a->radius * Spot{std::cos(angle), std::sin(angle)};
                if (i == 0)
                    pen = at;
                else
                    to(at);
            }
    }
    return strokes;
}

/// True if a stroke with its round ends covers part of a box.
bool meets(const TurnedBox& box, const Stroke& stroke) {
    const auto local = [&](Spot spot) {
        return Spot{dot(spot - box.centre, box.axis), cross(box.axis, spot - box.centre)};
    };
    const Spot from = local(stroke.from), to = local(stroke.to), d = to - from;
    // A quick test, which most strokes fail: distance beyond the pen on one side.
    const Spot far = box.half + Spot{stroke.half, stroke.half};
    if (std::min(from.x, to.x) >= far.x || std::max(from.x, to.x) <= -far.x || std::min(from.y, to.y) >= far.y ||
        std::max(from.y, to.y) <= -far.y)
        return false;
    double enter = 0, leave = 1;
    const auto clip = [&](double start, double step, double limit) {
        if (step == 0) return std::abs(start) < limit;
        const double low = std::min((-limit - start) / step, (limit - start) / step);
        const double high = std::max((-limit - start) / step, (limit - start) / step);
        enter = std::max(enter, low), leave = std::min(leave, high);
        return enter < leave;
    };
    if (clip(from.x, d.x, box.half.x) && clip(from.y, d.y, box.half.y)) return true;
    const auto end_is_near = [&](Spot end) {
        return length({std::max(std::abs(end.x) - box.half.x, 0.0), std::max(std::abs(end.y) - box.half.y, 0.0)}) <
               stroke.half;
    };
    if (end_is_near(from) || end_is_near(to)) return true;
    return std::ranges::any_of(std::array{Spot{1, 1}, Spot{1, -1}, Spot{-1, 1}, Spot{-1, -1}}, [&](Spot corner) {
        return distance_to_segment({corner.x * box.half.x, corner.y * box.half.y}, from, to) < stroke.half;
    });
}

bool meets(const Label& label, const Stroke& stroke) {
    if (label.ring <= 0) return meets(label.ink, stroke);
    return distance_to_segment(label.ink.centre, stroke.from, stroke.to) < label.ring + stroke.half;
}

bool overlap(const TurnedBox& a, const TurnedBox& b) {
    const Spot d = b.centre - a.centre;
    return std::ranges::all_of(std::array{a.axis, turned(a.axis), b.axis, turned(b.axis)}, [&](Spot axis) {
        const double reach_a = std::abs(dot(axis, a.axis)) * a.half.x + std::abs(cross(axis, a.axis)) * a.half.y;
        const double reach_b = std::abs(dot(axis, b.axis)) * b.half.x + std::abs(cross(axis, b.axis)) * b.half.y;
        return std::abs(dot(axis, d)) < reach_a + reach_b - 0.01;
    });
}

/// A small overlap is allowed: slanted italic letters reach into the box of the next word.
bool deeply_overlap(TurnedBox a, TurnedBox b) {
    constexpr double lean = 0.1;
    for (TurnedBox* box : {&a, &b}) box->half = box->half - Spot{lean / 2, lean / 2};
    return overlap(a, b);
}

std::string figure_of(const GroupBegin& group) { return group.attribute("data-figure") ? group.id.text() : ""; }

/// True if a path is a thin straight line or an empty circle, and only a circle may lie between it and a label.
bool is_part_of_label(const std::vector<Mark>& marks, std::size_t k) {
    const auto& path = std::get<Path>(marks[k]);
    if (path.filled || !path.pen.dashes.empty() || path.segments.size() < 2 || k + 1 == marks.size()) return false;
    const bool is_ring = path.segments.size() == 3 && std::holds_alternative<ArcTo>(path.segments[1]);
    const bool is_leader =
        path.segments.size() == 2 && std::holds_alternative<LineTo>(path.segments[1]) && path.pen.width < 0.2;
    if (!is_ring && !is_leader) return false;
    if (const auto* text = std::get_if<TextMark>(&marks[k + 1])) return text->cls == "label";
    if (!is_leader || !std::holds_alternative<Path>(marks[k + 1]) || !is_part_of_label(marks, k + 1)) return false;
    return std::holds_alternative<ArcTo>(std::get<Path>(marks[k + 1]).segments[1]);
}

/// A light area on light paper or a dark one on dark paper: it may lie under a label.
bool is_tint(const Path& path, Colour paper) {
    const auto apart = [](std::uint8_t a, std::uint8_t b) { return std::abs(int{a} - int{b}); };
    return !path.stroked && path.filled &&
           std::max({apart(path.fill.red, paper.red), apart(path.fill.green, paper.green),
                     apart(path.fill.blue, paper.blue)}) < 0x40;
}

/// The kind and the owner of a path in a figure, from the groups that contain it.
std::pair<Fault::Kind, std::string> role_of(const std::vector<const GroupBegin*>& groups, const Path& path) {
    constexpr std::array vectors{"vector", "force", "velocity", "arrows"};
    constexpr std::array mechanism{"link", "joint", "spring", "links", "joints", "ground"};
    const auto is_one_of = [](const auto& roles, const std::string& cls) { return std::ranges::count(roles, cls) > 0; };
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
        const std::string& cls = (*group)->cls;
        const std::string of = (*group)->id.empty() ? cls : (*group)->id.text();
        if (is_one_of(vectors, cls)) return {Fault::Kind::label_on_vector, of};
        if (is_one_of(mechanism, cls)) return {Fault::Kind::label_on_mechanism, of};
    }
    if (path.stroked && path.pen.width > 0.3) return {Fault::Kind::label_on_mechanism, "a thick line"};
    return {Fault::Kind::label_on_construction, "a thin line"};
}

/// Calls `look` for the marks of a page, with the enclosing groups and whether they are in a figure.
template <class Look>
void each_mark(const Page& page, Look look) {
    std::vector<const GroupBegin*> groups;
    for (std::size_t k = 0; k < page.marks.size(); ++k) {
        const Mark& mark = page.marks[k];
        if (const auto* group = std::get_if<GroupBegin>(&mark)) groups.push_back(group);
        if (std::holds_alternative<GroupEnd>(mark)) groups.pop_back();
        const bool within = std::ranges::any_of(groups, [](const GroupBegin* g) { return !figure_of(*g).empty(); });
        look(k, mark, groups, within);
    }
}

/// Splits the page, figure by figure.
PageParts parts_of(const Page& page, const Fonts& fonts) {
    PageParts parts;
    std::vector<Box> rings;
    std::vector<Stroke> leader;
    bool in_label = false;  // the text continues the label before in another colour
    const auto add_text = [&](const TextMark& text, FigureParts* figure) {
        Box box = unturned_ink(text, fonts);
        if (box.min.x > box.max.x) return;
        if (figure && text.cls == "label") {
            for (const Box& ring : rings) widen(box, ring.min), widen(box, ring.max);
            const double ring = rings.empty() ? 0 : 0.5 * rings.front().width();
            figure->labels.push_back({text.words, turned_about(box, text.pivot, text.angle), ring});
            for (const Stroke& each : leader) figure->leaders.emplace_back(figure->labels.size() - 1, each);
            leader.clear();
            rings.clear();
            in_label = true;
            return;
        }
        const TurnedBox ink = turned_about(box, text.pivot, text.angle);
        if (figure && in_label && text.words.empty()) {
            figure->labels.push_back({figure->labels.back().words + " (continued)", ink, 0});
            return;
        }
        in_label = false;
        (figure ? figure->texts : parts.texts).push_back({text.words, ink, 0});
    };
    each_mark(page, [&](std::size_t k, const Mark& mark, const std::vector<const GroupBegin*>& groups, bool within) {
        if (const auto* group = std::get_if<GroupBegin>(&mark))
            if (const std::string id = figure_of(*group); !id.empty()) parts.figures.push_back({id, {}, {}, {}, {}});
        FigureParts* const figure = within ? &parts.figures.back() : nullptr;
        if (const auto* text = std::get_if<TextMark>(&mark)) return add_text(*text, figure);
        const auto* path = std::get_if<Path>(&mark);
        if (!path || !figure) return;
        in_label = false;
        std::vector<Stroke> strokes = strokes_of(*path);
        // A leader and the circle round a number come directly before their label.
        if (is_part_of_label(page.marks, k)) {
            if (std::holds_alternative<LineTo>(path->segments[1]))
                leader = strokes;
            else
                rings.assign(1, box_of(std::span(&mark, 1)));
            return;
        }
        // A stroke in the colour of the paper separates links that cross.
        const bool blank_stroke = path->stroked && !path->filled && path->pen.colour == page.paper;
        if (is_tint(*path, page.paper) || blank_stroke) return;
        const auto [role, of] = role_of(groups, *path);
        for (Stroke& stroke : strokes) {
            stroke.role = role;
            stroke.of = of;
            figure->strokes.push_back(std::move(stroke));
        }
    });
    return parts;
}

/// The sheet's frame is the first path of a page.
Box frame_of(const Page& page) {
    for (const Mark& mark : page.marks)
        if (std::holds_alternative<Path>(mark)) return box_of(std::span(&mark, 1));
    return {{0, 0}, {page.width, page.height}};
}

bool leaves(const Box& frame, const Box& box) {
    constexpr double grace = 0.05;
    return box.min.x < frame.min.x - grace || box.min.y < frame.min.y - grace || box.max.x > frame.max.x + grace ||
           box.max.y > frame.max.y + grace;
}

/// An empty page for ink of one colour.
Page blank_like(const Page& page) {
    Page empty;
    empty.width = page.width;
    empty.height = page.height;
    return empty;
}
constexpr Colour ink_colour{0, 0, 0}, no_ink{255, 255, 255};

/// All letters of the page, black on white.
Page letters_of(const Page& page) {
    Page letters = blank_like(page);
    for (const Mark& mark : page.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) {
            TextMark black = *text;
            black.colour = ink_colour;
            for (Path& extra : black.extras) extra.fill = extra.pen.colour = ink_colour;
            letters.marks.emplace_back(std::move(black));
        }
    return letters;
}

/// The mechanisms and the vectors of the page, black on white. White within a symbol hides what lies below it, as on
/// the page. Other white is ignored, so that a halo under a letter does not hide an overlap.
Page strokes_of(const Page& page) {
    Page strokes = blank_like(page);
    each_mark(page, [&](std::size_t k, const Mark& mark, const std::vector<const GroupBegin*>& groups, bool within) {
        const auto* path = std::get_if<Path>(&mark);
        if (!path || !within || is_part_of_label(page.marks, k)) return;
        if (role_of(groups, *path).first == Fault::Kind::label_on_construction) return;
        Path black = *path;
        Path area = *path;
        area.stroked = false;
        black.fill = is_tint(area, page.paper) ? no_ink : ink_colour;
        black.pen.colour = path->pen.colour == page.paper ? no_ink : ink_colour;
        strokes.marks.emplace_back(std::move(black));
    });
    return strokes;
}

void add_faults_within(const FigureParts& figure, std::vector<Fault>& faults) {
    for (std::size_t i = 0; i < figure.labels.size(); ++i) {
        const Label& label = figure.labels[i];
        for (std::size_t j = i + 1; j < figure.labels.size(); ++j)
            if (overlap(label.ink, figure.labels[j].ink) &&
                figure.labels[j].words.find(" (continued)") == std::string::npos)
                faults.push_back({Fault::Kind::label_on_label, figure.id, label.words, figure.labels[j].words});
        for (const Label& text : figure.texts)
            if (overlap(label.ink, text.ink))
                faults.push_back({Fault::Kind::label_on_label, figure.id, label.words, text.words});
        const Stroke* worst = nullptr;
        for (const Stroke& stroke : figure.strokes)
            if (meets(label, stroke) && (!worst || stroke.role < worst->role)) worst = &stroke;
        if (worst) faults.push_back({worst->role, figure.id, label.words, worst->of});
    }
    for (const auto& [own, leader] : figure.leaders)
        for (std::size_t i = 0; i < figure.labels.size(); ++i)
            if (i != own && meets(figure.labels[i], leader))
                faults.push_back(
                    {Fault::Kind::leader_on_label, figure.id, figure.labels[own].words, figure.labels[i].words});
}

/// Overlaps of a figure with other figures' text; each letter is reported once.
void add_faults_beyond(const FigureParts& figure, const std::vector<Label>& letters, std::vector<Fault>& faults) {
    for (const Label& text : letters) {
        const auto covered = [&](const auto& labels) {
            return std::ranges::any_of(labels, [&](const Label& label) { return overlap(label.ink, text.ink); });
        };
        if (covered(figure.labels) || covered(figure.texts) ||
            std::ranges::any_of(figure.strokes, [&](const Stroke& stroke) { return meets(text.ink, stroke); }))
            faults.push_back({Fault::Kind::figure_on_text, figure.id, "a stroke or a label", text.words});
    }
}

}  // namespace

std::vector<Fault> faults_of(const Page& page, const Fonts& fonts) {
    std::vector<Fault> faults;
    const Box frame = frame_of(page);
    std::string here;
    for (const Mark& mark : page.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark))
            if (const std::string id = figure_of(*group); !id.empty()) here = id;
        if (std::holds_alternative<GroupBegin>(mark) || std::holds_alternative<GroupEnd>(mark)) continue;
        const auto* text = std::get_if<TextMark>(&mark);
        Box box = box_of(std::span(&mark, 1));
        if (text) {
            const TurnedBox ink = turned_about(unturned_ink(*text, fonts), text->pivot, text->angle);
            const Spot reach{std::abs(ink.axis.x) * ink.half.x + std::abs(ink.axis.y) * ink.half.y,
                             std::abs(ink.axis.y) * ink.half.x + std::abs(ink.axis.x) * ink.half.y};
            box = {ink.centre - reach, ink.centre + reach};
        }
        if (leaves(frame, box))
            faults.push_back({Fault::Kind::outside, here, text ? text->words : "a stroke", "the frame"});
    }
    const PageParts parts = parts_of(page, fonts);
    for (const FigureParts& figure : parts.figures) {
        add_faults_within(figure, faults);
        add_faults_beyond(figure, parts.texts, faults);
        for (const FigureParts& other : parts.figures)
            if (&other != &figure) add_faults_beyond(figure, other.labels, faults);
    }
    for (std::size_t i = 0; i < parts.texts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.texts.size(); ++j)
            if (deeply_overlap(parts.texts[i].ink, parts.texts[j].ink))
                faults.push_back({Fault::Kind::text_on_text, "text", parts.texts[i].words, parts.texts[j].words});
    return faults;
}

std::size_t pixels_in_common(const Page& page, const Fonts& fonts, double dpi) {
    const Page drawn = strokes_of(page);
    if (drawn.marks.empty()) return 0;
    const Picture letters = to_picture(letters_of(page), fonts, dpi), strokes = to_picture(drawn, fonts, dpi);
    constexpr int half = 0x80;  // of white
    std::size_t common = 0;
    for (std::size_t i = 0; i < letters.pixels.size(); ++i)
        common += letters.pixels[i].red < half && strokes.pixels[i].red < half ? 1 : 0;
    return common;
}

std::string said(const Fault& fault) {
    static constexpr std::array words{" on the label ",
                                      " on the mechanism: ",
                                      " on the vector ",
                                      " on ",
                                      ": its leader on the label ",
                                      " on ",
                                      " on ",
                                      " leaves "};
    return fault.figure + ": " + fault.label + words[static_cast<std::size_t>(fault.kind)] + fault.other;
}

}  // namespace kinegraph::render
