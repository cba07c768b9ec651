// How the faults are found: the figures of the page are taken apart into labels and segments of stroke.
#include "tests/page_checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "render/shapes.hpp"

namespace kinegraph::render {
namespace {

struct TurnedBox {
    Spot centre, half, axis{1, 0};
};

struct Label {
    std::string words;
    TurnedBox ink;
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
    std::vector<std::pair<std::size_t, Stroke>> leaders;  // of the label with this number
};

void widen(Box& box, Spot by) {
    box.min = {std::min(box.min.x, by.x), std::min(box.min.y, by.y)};
    box.max = {std::max(box.max.x, by.x), std::max(box.max.y, by.y)};
}
constexpr Box blank{{1e300, 1e300}, {-1e300, -1e300}};

/// The box of the ink as if the text were not turned.
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
                to((u * u * u) * p0 + (3 * u * u * t) * c->control_1 + (3 * u * t * t) * c->control_2 + (t * t * t) * c->to);
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

/// Whether a segment comes nearer than `half` to a box (a chord of the box grown by that much).
bool meets(const TurnedBox& box, const Stroke& stroke) {
    const auto local = [&](Spot spot) { return Spot{dot(spot - box.centre, box.axis), cross(box.axis, spot - box.centre)}; };
    const Spot from = local(stroke.from), d = local(stroke.to) - from;
    double enter = 0, leave = 1;
    const auto clip = [&](double start, double step, double limit) {
        if (step == 0) return std::abs(start) < limit;
        const double low = std::min((-limit - start) / step, (limit - start) / step);
        const double high = std::max((-limit - start) / step, (limit - start) / step);
        enter = std::max(enter, low), leave = std::min(leave, high);
        return enter < leave;
    };
    return clip(from.x, d.x, box.half.x + stroke.half) && clip(from.y, d.y, box.half.y + stroke.half);
}

bool overlap(const TurnedBox& a, const TurnedBox& b) {
    const Spot d = b.centre - a.centre;
    return std::ranges::all_of(std::array{a.axis, turned(a.axis), b.axis, turned(b.axis)}, [&](Spot axis) {
        const double reach_a = std::abs(dot(axis, a.axis)) * a.half.x + std::abs(cross(axis, a.axis)) * a.half.y;
        const double reach_b = std::abs(dot(axis, b.axis)) * b.half.x + std::abs(cross(axis, b.axis)) * b.half.y;
        return std::abs(dot(axis, d)) < reach_a + reach_b - 0.01;
    });
}

std::string figure_of(const GroupBegin& group) {
    for (const auto& attribute : group.attributes)
        if (attribute.first == "data-figure") return group.id;
    return {};
}

/// Whether a path is a thin straight line or an empty circle with nothing but a ring between it and a label.
bool is_part_of_label(const std::vector<Mark>& marks, std::size_t k) {
    const auto& path = std::get<Path>(marks[k]);
    if (path.filled || !path.pen.dashes.empty() || path.segments.size() < 2 || k + 1 == marks.size()) return false;
    const bool is_ring = path.segments.size() == 3 && std::holds_alternative<ArcTo>(path.segments[1]);
    const bool is_leader = path.segments.size() == 2 && std::holds_alternative<LineTo>(path.segments[1]) && path.pen.width < 0.2;
    if (!is_ring && !is_leader) return false;
    if (const auto* text = std::get_if<TextMark>(&marks[k + 1])) return text->cls == "label";
    if (!is_leader || !std::holds_alternative<Path>(marks[k + 1]) || !is_part_of_label(marks, k + 1)) return false;
    return std::holds_alternative<ArcTo>(std::get<Path>(marks[k + 1]).segments[1]);
}

/// Takes the page apart, figure by figure.
std::vector<FigureParts> parts_of(const Page& page, const Fonts& fonts) {
    std::vector<FigureParts> figures;
    std::vector<const GroupBegin*> groups;
    std::vector<Box> rings;
    std::vector<Stroke> leader;
    bool in_label = false;  // further colours of the label before
    for (std::size_t k = 0; k < page.marks.size(); ++k) {
        const Mark& mark = page.marks[k];
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            groups.push_back(group);
            if (const std::string id = figure_of(*group); !id.empty()) figures.push_back({id, {}, {}, {}});
        }
        if (std::holds_alternative<GroupEnd>(mark)) groups.pop_back();
        const bool within = std::ranges::any_of(groups, [](const GroupBegin* g) { return !figure_of(*g).empty(); });
        if (!within) continue;
        FigureParts& figure = figures.back();
        if (const auto* text = std::get_if<TextMark>(&mark)) {
            if (text->cls == "label") {
                Box box = unturned_ink(*text, fonts);
                for (const Box& ring : rings) widen(box, ring.min), widen(box, ring.max);
                figure.labels.push_back({text->words, turned_about(box, text->pivot, text->angle)});
                for (const Stroke& each : leader) figure.leaders.emplace_back(figure.labels.size() - 1, each);
                leader.clear();
                rings.clear();
                in_label = true;
            } else if (in_label && text->words.empty()) {
                const TurnedBox more = turned_about(unturned_ink(*text, fonts), text->pivot, text->angle);
                figure.labels.push_back({figure.labels.back().words + " (continued)", more});
            } else {
                in_label = false;
            }
            continue;
        }
        const auto* path = std::get_if<Path>(&mark);
        if (!path) continue;
        in_label = false;
        std::vector<Stroke> strokes = strokes_of(*path);
        // A leader and the ring round a number stand directly before their label.
        if (is_part_of_label(page.marks, k)) {
            if (std::holds_alternative<LineTo>(path->segments[1]))
                leader = strokes;
            else
                rings.assign(1, box_of({mark}));
            continue;
        }
        if (!path->stroked && path->filled && std::min({path->fill.red, path->fill.green, path->fill.blue}) >= 0xC0)
            continue;  // a tint may carry a label
        Fault::Kind role = Fault::Kind::label_on_construction;
        std::string of = "a thin line";
        for (const GroupBegin* group : groups) {
            if (group->cls == "vector" || group->cls == "force") role = Fault::Kind::label_on_vector, of = group->id;
            if (group->cls == "link" || group->cls == "joint") role = Fault::Kind::label_on_mechanism, of = group->id;
        }
        if (role == Fault::Kind::label_on_construction && path->stroked && path->pen.width > 0.3) {
            role = Fault::Kind::label_on_mechanism;
            of = "a thick line";
        }
        for (Stroke& stroke : strokes) {
            stroke.role = role;
            stroke.of = of;
            figure.strokes.push_back(std::move(stroke));
        }
    }
    return figures;
}

/// The sheet's frame: the first path of a page.
Box frame_of(const Page& page) {
    for (const Mark& mark : page.marks)
        if (std::holds_alternative<Path>(mark)) return box_of({mark});
    return {{0, 0}, {page.width, page.height}};
}

bool leaves(const Box& frame, const Box& box) {
    constexpr double grace = 0.05;
    return box.min.x < frame.min.x - grace || box.min.y < frame.min.y - grace || box.max.x > frame.max.x + grace ||
           box.max.y > frame.max.y + grace;
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
        Box box = box_of({mark});
        if (text) {
            const TurnedBox ink = turned_about(unturned_ink(*text, fonts), text->pivot, text->angle);
            const Spot reach{std::abs(ink.axis.x) * ink.half.x + std::abs(ink.axis.y) * ink.half.y,
                             std::abs(ink.axis.y) * ink.half.x + std::abs(ink.axis.x) * ink.half.y};
            box = {ink.centre - reach, ink.centre + reach};
        }
        if (leaves(frame, box)) faults.push_back({Fault::Kind::outside, here, text ? text->words : "a stroke", "the frame"});
    }
    for (const FigureParts& figure : parts_of(page, fonts)) {
        for (std::size_t i = 0; i < figure.labels.size(); ++i) {
            const Label& label = figure.labels[i];
            for (std::size_t j = i + 1; j < figure.labels.size(); ++j)
                if (overlap(label.ink, figure.labels[j].ink) && figure.labels[j].words.find(" (continued)") == std::string::npos)
                    faults.push_back({Fault::Kind::label_on_label, figure.id, label.words, figure.labels[j].words});
            const Stroke* worst = nullptr;
            for (const Stroke& stroke : figure.strokes)
                if (meets(label.ink, stroke) && (!worst || stroke.role < worst->role)) worst = &stroke;
            if (worst) faults.push_back({worst->role, figure.id, label.words, worst->of});
        }
        for (const auto& [own, leader] : figure.leaders)
            for (std::size_t i = 0; i < figure.labels.size(); ++i)
                if (i != own && meets(figure.labels[i].ink, leader))
                    faults.push_back({Fault::Kind::leader_on_label, figure.id, figure.labels[own].words, figure.labels[i].words});
    }
    return faults;
}

std::string said(const Fault& fault) {
    static constexpr std::array words{" on the label ", " on the mechanism: ",        " on the vector ",
                                      " on ",           ": its leader on the label ", " leaves "};
    return fault.figure + ": " + fault.label + words[static_cast<std::size_t>(fault.kind)] + fault.other;
}

}  // namespace kinegraph::render
