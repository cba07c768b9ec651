#include "render/mechanism/dimension_room.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace kinegraph::render::drawing {

namespace {

constexpr Spot room_for_names{10, 18};  // margins that names need, and room for the scale bar below
constexpr double air_at_edge = 0.5;
constexpr double leaves_its_paper = 1000;

}  // namespace

std::size_t end_of_mark(std::span<const Mark> marks, std::size_t first) {
    std::size_t end = first + 1;
    for (int depth = std::holds_alternative<GroupBegin>(marks[first]) ? 1 : 0; depth > 0; ++end)
        depth += std::holds_alternative<GroupBegin>(marks[end]) ? 1
                 : std::holds_alternative<GroupEnd>(marks[end]) ? -1
                                                                : 0;
    return end;
}

DimensionRoom::DimensionRoom(const Sketch& sketch, Spot size, const DimensionWish& wish)
    : sketch_(sketch), size_(size - room_for_names), wish_(wish), box_(sketch.mechanism_box()) {
    const DrawnLayers layers{sketch.construction, sketch.ground, sketch.bodies,
                             sketch.pins,         sketch.arrows, sketch.centres};
    keep_off(layers);
    for (const std::span<const Mark> layer :
         {layers.ground, layers.bodies, layers.pins, layers.arrows, layers.construction})
        if (!layer.empty()) box_.include(box_of(layer));
}
DimensionRoom::DimensionRoom(const Sketch& sketch, const Figure& figure, Spot size, const DimensionWish& wish)
    : sketch_(sketch), size_(size), wish_(wish), box_(figure.box), origin_(figure.origin) {
    box_ = {box_.min - origin_, box_.max - origin_};
    keep_off_all_of(figure);
}

void DimensionRoom::take(const DimensionTrial& drawn, double width) {
    for (const Bar& bar : drawn.strokes) taken_.push_back({bar});
    for (const Bar& bar : drawn.extensions) (wish_.sought_far ? led_ : taken_).push_back({bar});
    for (const Bar& bar : frame_of(drawn.text_at, drawn.text_angle, width)) {
        taken_.push_back({bar});
        if (wish_.sought_far) words_.push_back({bar});
    }
    box_ = with(box_, drawn, width);
}

void DimensionRoom::keep_off(const DrawnLayers& layers) {
    const bool through_ground = wish_.all || wish_.sought_far;
    for (const std::span<const Mark> layer : {layers.bodies, layers.pins, layers.arrows, layers.centres})
        add(layer, heavy_);
    // If all data must be shown, extension lines from a point of the frame may cross the ground symbol there.
    crossed_ = heavy_;
    add(layers.ground, heavy_);
    if (!through_ground) crossed_ = heavy_;
    add(layers.construction, light_);
}

void DimensionRoom::keep_off_all_of(const Figure& figure) {
    DrawnLayers layers;
    const std::span<const Mark> marks = figure.marks;
    for (std::size_t first = 1, end = 1; first < marks.size(); first = end) {
        end = end_of_mark(marks, first);
        const std::span<const Mark> own = marks.subspan(first, end - first);
        const auto* group = std::get_if<GroupBegin>(&marks[first]);
        if (group != nullptr && group->cls == "tint") continue;  // a dimension may stand on a tint
        if (std::span<const Mark>* layer = group ? layer_of(layers, group->cls) : nullptr)
            *layer = own;
        else
            keep_off_beside_layers(own);
    }
    keep_off(layers);
    for (const Mark& mark : marks)
        if (const auto* text = std::get_if<TextMark>(&mark))
            if (auto ink = ink_of(*text, sketch_.context.fonts)) {
                ink->centre = ink->centre - origin_;
                letters_.push_back(*ink);
            }
}

void DimensionRoom::keep_off_beside_layers(std::span<const Mark> marks) {
    add(marks, taken_);
    for (const Mark& mark : marks)
        if (const auto* path = std::get_if<Path>(&mark))
            for (const Segment& segment : path->segments)
                if (const auto* arc = std::get_if<ArcTo>(&segment))
                    letters_.push_back({arc->centre - origin_, {arc->radius, arc->radius}});
}

std::span<const Mark>* DimensionRoom::layer_of(DrawnLayers& layers, std::string_view role) {
    if (role == "construction" && layers.construction.empty()) return &layers.construction;
    if (role == "ground") return &layers.ground;
    if (role == "links") return &layers.bodies;
    if (role == "joints") return &layers.pins;
    if (role == "arrows") return &layers.arrows;
    if (role == "centres") return &layers.centres;
    return nullptr;
}

void DimensionRoom::add(std::span<const Mark> marks, std::vector<Obstacle>& to) const {
    const auto add_bar = [&](Spot from, Spot end) { to.push_back({{from - origin_, end - origin_}}); };
    for (const Mark& mark : marks) {
        const auto* path = std::get_if<Path>(&mark);
        if (!path) continue;
        Spot pen, start;
        for (const Segment& segment : path->segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) pen = start = m->to;
            if (const auto* l = std::get_if<LineTo>(&segment)) {
                add_bar(pen, l->to);
                pen = l->to;
            }
            if (const auto* a = std::get_if<ArcTo>(&segment)) {
                const int parts = std::clamp(static_cast<int>(std::abs(a->to - a->from) * a->radius / 3), 2, 24);
                for (int i = 0; i <= parts; ++i) {
                    const Spot at = a->centre + a->radius * polar_spot(a->from + (a->to - a->from) * i / parts);
                    if (i > 0) add_bar(pen, at);
                    pen = at;
                }
            }
            if (std::holds_alternative<Close>(segment)) {
                add_bar(pen, start);
                pen = start;
            }
        }
    }
}

Box DimensionRoom::box_round(const Bar& bar) {
    return {{std::min(bar.from.x, bar.to.x), std::min(bar.from.y, bar.to.y)},
            {std::max(bar.from.x, bar.to.x), std::max(bar.from.y, bar.to.y)}};
}

int DimensionRoom::count_near(const Bar& bar, const std::vector<Obstacle>& obstacles, double gap,
                              const std::array<Spot, 2>& except) {
    int count = 0;
    Box near = box_round(bar);
    near = {near.min - Spot{gap, gap}, near.max + Spot{gap, gap}};
    for (const Obstacle& each : obstacles) {
        if (near.max.x < each.box.min.x || near.min.x > each.box.max.x || near.max.y < each.box.min.y ||
            near.min.y > each.box.max.y)
            continue;
        const Bar& other = each.bar;
        const bool is_near = distance(bar.from, other) < gap || distance(bar.to, other) < gap ||
                             distance(other.from, bar) < gap || distance(other.to, bar) < gap ||
                             (crosses(bar, other) && gap > 0);
        if (!is_near) continue;
        // Strokes at the measured points themselves are no obstacles.
        const bool own = std::any_of(except.begin(), except.end(), [&](Spot spot) {
            return length(other.from - spot) < 3.5 && length(other.to - spot) < 3.5;
        });
        if (!own) ++count;
    }
    return count;
}

int DimensionRoom::count_letters_near(const Bar& bar) const {
    constexpr double near = 0.9;  // slightly more than the distance between two labels
    const InkBox own{middle(bar), {length(bar) / 2, 0}, length(bar) > 0 ? unit(bar.to - bar.from) : Spot{1, 0}};
    return static_cast<int>(std::count_if(letters_.begin(), letters_.end(), [&](const InkBox& letters) {
        return lettering::gap_between(own, letters, near) < near;
    }));
}

bool DimensionRoom::crosses(const Bar& a, const Bar& b) {
    const Spot u = a.to - a.from, v = b.to - b.from;
    const double turn = cross(u, v);
    if (std::abs(turn) < 1e-12) return false;
    const double t = cross(b.from - a.from, v) / turn, w = cross(b.from - a.from, u) / turn;
    return t >= 0 && t <= 1 && w >= 0 && w <= 1;
}

std::array<Bar, 3> DimensionRoom::frame_of(Spot baseline_middle, double angle, double width) {
    const Spot along = polar_spot(angle), up = -1.0 * turned(along);
    const Spot left = baseline_middle - (width / 2) * along, right = baseline_middle + (width / 2) * along;
    return {Bar{left, right}, Bar{left + (cap_height / 2) * up, right + (cap_height / 2) * up},
            Bar{left + cap_height * up, right + cap_height * up}};
}

Box DimensionRoom::with(Box box, const DimensionTrial& trial, double width) {
    const auto take = [&](const Bar& bar) {
        box.include(bar.from);
        box.include(bar.to);
    };
    for (const Bar& stroke : trial.strokes) take(stroke);
    for (const Bar& bar : frame_of(trial.text_at, trial.text_angle, width)) take(bar);
    return box;
}

double DimensionRoom::toll(const Bar& bar, Rate heavy, Rate light, Rate taken, const std::array<Spot, 2>& ends) const {
    return toll(bar, heavy_, heavy, light, taken, ends);
}

double DimensionRoom::toll(const Bar& bar, const std::vector<Obstacle>& heavy_bars, Rate heavy, Rate light, Rate taken,
                           const std::array<Spot, 2>& ends) const {
    return price_of_letters() * count_letters_near(bar) +
           heavy.price * count_near(bar, heavy_bars, heavy.distance, ends) +
           light.price * count_near(bar, light_, light.distance, ends) +
           taken.price * count_near(bar, taken_, taken.distance, nowhere);
}

double DimensionRoom::price_of(const DimensionTrial& trial, double width, const std::array<Spot, 2>& ends,
                               double enough) const {
    double price = trial.price;
    const double on_text = price_of_letters();
    for (const Bar& stroke : trial.strokes)
        if (price < enough)
            price += toll(stroke, {3, 1.2}, {0.6, 0.3}, {3, 1.0}, ends) +
                     on_text * count_near(stroke, words_, 0.4, nowhere) + 1.2 * count_near(stroke, led_, 0.4, nowhere);
    for (const Bar& extension : trial.extensions)
        if (price < enough)
            price += toll(extension, crossed_, {1.5, 0.4}, {0.3, 0.2}, {1.5, 0.4}, ends) +
                     on_text * count_near(extension, words_, 0.4, nowhere) +
                     0.6 * count_near(extension, led_, 0.2, ends);
    for (const Bar& bar : frame_of(trial.text_at, trial.text_angle, width))
        if (price < enough)
            price += toll(bar, {on_text, 1.5}, {on_text, 0.6}, {on_text, 0.9}, nowhere) +
                     on_text * count_near(bar, led_, 0.6, nowhere);
    if (price >= enough) return price;
    if (wish_.within) return price + (stays_within(trial, width) ? 0 : leaves_its_paper);
    const Box box = with(box_, trial, width);
    if (box.width() > std::max(size_.x, box_.width()) || box.height() > std::max(size_.y, box_.height())) price += 10;
    return price;
}

bool DimensionRoom::stays_within(const DimensionTrial& trial, double width) const {
    Box box = grown(box_of_frame(trial, width), air_at_edge);
    for (const std::vector<Bar>* bars : {&trial.strokes, &trial.extensions})
        for (const Bar& bar : *bars) box.include(bar.from), box.include(bar.to);
    return contains(*wish_.within, box.min) && contains(*wish_.within, box.max);
}

Box DimensionRoom::box_of_frame(const DimensionTrial& trial, double width) {
    const std::array<Bar, 3> frame = frame_of(trial.text_at, trial.text_angle, width);
    Box box{frame[0].from, frame[0].from};
    for (const Bar& bar : frame) box.include(bar.from), box.include(bar.to);
    return box;
}

}  // namespace kinegraph::render::drawing
