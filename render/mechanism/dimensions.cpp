// Dimensions of the given data on the mechanism (ISO 129): lengths, radii and angles as the file states them, each
// where it is in nobody's way. Owns which data are dimensioned and where; measures nothing, all values are those of the
// file.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string_view>

#include "render/mechanism/sketch.hpp"
#include "render/page/ink_map.hpp"
#include "render/page/label_boxes.hpp"

namespace kinegraph::render::drawing {

namespace {

/// The layers that dimensions keep off, those of a sketch or those of a figure made of it.
struct DrawnLayers {
    std::span<const Mark> construction, ground, bodies, pins, arrows, centres;
};

/// Where a mark ends, or the group that it begins.
std::size_t end_of_mark(std::span<const Mark> marks, std::size_t first) {
    std::size_t end = first + 1;
    for (int depth = std::holds_alternative<GroupBegin>(marks[first]) ? 1 : 0; depth > 0; ++end)
        depth += std::holds_alternative<GroupBegin>(marks[end]) ? 1
                 : std::holds_alternative<GroupEnd>(marks[end]) ? -1
                                                                : 0;
    return end;
}
/// Of a closed figure, where its labels begin.
std::size_t end_of_layers(std::span<const Mark> marks) {
    constexpr std::array<std::string_view, 8> layers{"tint",   "construction", "ground",  "links",
                                                     "joints", "arrows",       "centres", "dimensions"};
    const auto is_layer = [&](const Mark& mark) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        return group != nullptr && std::find(layers.begin(), layers.end(), group->cls) != layers.end();
    };
    std::size_t end = 1;
    while (end < marks.size() && is_layer(marks[end])) end = end_of_mark(marks, end);
    return end;
}

class DimensionsDrawing {
public:
    /// Before there are names. `room`: for all that is drawn.
    DimensionsDrawing(Sketch& sketch, Spot room, const DimensionWish& wish)
        : sketch_(sketch), room_(room - for_names), wish_(wish), box_(sketch.mechanism_box()) {
        const DrawnLayers layers{sketch.construction, sketch.ground, sketch.bodies,
                                 sketch.pins,         sketch.arrows, sketch.centres};
        keep_off(layers);
        for (const std::span<const Mark> layer :
             {layers.ground, layers.bodies, layers.pins, layers.arrows, layers.construction})
            if (!layer.empty()) box_.include(box_of(layer));
        gather();
        gather_offsets();
    }
    /// Beside all that a finished figure of the sketch has, its names and its scale bar among it.
    DimensionsDrawing(Sketch& sketch, const Figure& figure, Spot room, const DimensionWish& wish)
        : sketch_(sketch), room_(room), wish_(wish), box_(figure.box), origin_(figure.origin) {
        box_ = {box_.min - origin_, box_.max - origin_};
        keep_off_all_of(figure);
        gather();
        gather_offsets();
    }

    void draw() {
        const auto [all, most] = std::pair(wish_.all, wish_.most);
        if (!all && lengths_.size() + angles_.size() + radii_.size() > 2 * most) return;
        std::size_t count = 0;
        // Angles and radii have fewer places than lengths; shorter lengths stand within longer ones.
        if (wish_.sought_far) {
            std::stable_sort(lengths_.begin(), lengths_.end(),
                             [](const Length& a, const Length& b) { return a.value < b.value; });
            std::vector<const AngleOf*> crowded;
            for (const AngleOf& angle : angles_) {
                const bool stands = count < most && draw(angle, all);
                count += stands ? 1 : 0;
                if (!stands) crowded.push_back(&angle);
            }
            for (const Radius& radius : radii_) count += count < most ? draw(radius, all) : 0;
            for (const Length& length : lengths_) count += count < most ? draw(length, all) : 0;
            for (const AngleOf* angle : crowded) count += count < most ? draw_led_out(*angle, all) : 0;
            return;
        }
        for (const Length& length : lengths_) count += all || count < most ? draw(length, all) : 0;
        for (const Radius& radius : radii_) count += all || count < most ? draw(radius, all) : 0;
        for (const AngleOf& angle : angles_) count += all || count < most ? draw(angle, all) : 0;
    }

private:
    struct Length {
        Spot from, to;
        Spot along;  // unit: of the dimension line
        double value;
        std::string name;
    };
    struct Radius {
        Spot centre;
        double radius, value;
        std::string name;
    };
    struct AngleOf {
        Spot vertex;
        double from, sweep;  // radians clockwise on paper
        std::string text, name;
    };
    /// What a try would draw. Most are priced and never drawn.
    struct Trial {
        std::function<void(std::vector<Mark>&)> draw;
        std::vector<Bar> strokes;
        std::vector<Bar> extensions;
        Spot text_at;
        double text_angle = 0;
        double price = 0;
    };

    double price_of_letters() const { return wish_.sought_far ? 12 : 4; }  ///< nothing may run over them
    static constexpr Spot for_names{10, 18};  ///< they need a rim, the scale bar its place below

    Pen thin() const { return {sketch_.theme.thin, sketch_.theme.text, {}, false}; }

    /// What a dimension should keep off, with the box round it, which tells of most that they are far away.
    struct Obstacle {
        Bar bar;
        Box box = box_round(bar);
    };
    static Box box_round(const Bar& bar) {
        return {{std::min(bar.from.x, bar.to.x), std::min(bar.from.y, bar.to.y)},
                {std::max(bar.from.x, bar.to.x), std::max(bar.from.y, bar.to.y)}};
    }

    /// A mark in the way: links, pins, ground and arrows always, construction lines for the figures.
    void keep_off(const DrawnLayers& layers) {
        const bool through_ground = wish_.all || wish_.sought_far;
        for (const std::span<const Mark> layer : {layers.bodies, layers.pins, layers.arrows, layers.centres})
            add(layer, heavy_);
        // What leads from a point of the frame to its dimension may pass through the ground there where all data are
        // wanted.
        crossed_ = heavy_;
        add(layers.ground, heavy_);
        if (!through_ground) crossed_ = heavy_;
        add(layers.construction, light_);
    }
    /// Its layers; names with their leaders, scale bar and all that stands in no layer are taken.
    void keep_off_all_of(const Figure& figure) {
        DrawnLayers layers;
        const std::span<const Mark> marks = figure.marks;
        for (std::size_t first = 1, end = 1; first < marks.size(); first = end) {
            end = end_of_mark(marks, first);
            const std::span<const Mark> own = marks.subspan(first, end - first);
            const auto* group = std::get_if<GroupBegin>(&marks[first]);
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
    /// Leaders and bars; of the number of a link the whole circle.
    void keep_off_beside_layers(std::span<const Mark> marks) {
        add(marks, taken_);
        for (const Mark& mark : marks)
            if (const auto* path = std::get_if<Path>(&mark))
                for (const Segment& segment : path->segments)
                    if (const auto* arc = std::get_if<ArcTo>(&segment))
                        letters_.push_back({arc->centre - origin_, {arc->radius, arc->radius}});
    }
    static std::span<const Mark>* layer_of(DrawnLayers& layers, std::string_view role) {
        if (role == "construction" && layers.construction.empty()) return &layers.construction;
        if (role == "ground") return &layers.ground;
        if (role == "links") return &layers.bodies;
        if (role == "joints") return &layers.pins;
        if (role == "arrows") return &layers.arrows;
        if (role == "centres") return &layers.centres;
        return nullptr;
    }
    void add(std::span<const Mark> marks, std::vector<Obstacle>& to) const {
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

    // ---- which data ----

    std::string name_of(PointIndex point) const { return sketch_.mechanism.point(point).name; }

    void add_length(PointIndex from, PointIndex to, double value) {
        const Spot a = sketch_.spot(from), b = sketch_.spot(to);
        if (length(b - a) < 1 || !sketch_.subject.shows(to)) return;
        add_length({a, b, unit(b - a), value, name_of(from) + "." + name_of(to)});
    }
    void add_length(Length added) {
        for (const Length& known : lengths_) {
            const bool same = coincide(known.from, added.from) && coincide(known.to, added.to);
            const bool turned_about = coincide(known.from, added.to) && coincide(known.to, added.from);
            if (same || turned_about) return;
        }
        lengths_.push_back(std::move(added));
    }

    void add_angle(PointIndex vertex, PointIndex to, const Angle& angle, std::optional<Spot> reference) {
        if (!sketch_.subject.shows(vertex) || !sketch_.subject.shows(to)) return;
        const Spot base = reference.value_or(Spot{1, 0});
        const double value = angle.value.to_double();
        const double sweep = -(angle.in_degrees ? value * pi_number / 180 : value);
        if (std::abs(sweep) < 0.12 || std::abs(sweep) > 3.5) return;
        const std::string figure = given_number(value, sketch_.context.language);
        angles_.push_back({sketch_.spot(vertex), angle_of(base), sweep, figure + (angle.in_degrees ? "°" : " rad"),
                           name_of(vertex) + "." + name_of(to)});
    }

    /// Of a line on which a point lies, from the place that the line goes through; behind that place the angle is
    /// another, and that a line stands upright or lies is seen.
    void add_angle_of(const LineCurve& line, PointIndex point) {
        const auto* through = std::get_if<PointIndex>(&line.through);
        if (through == nullptr || line.by != LineCurve::By::angle) return;
        const Spot along = paper_direction(direction_of(Bearing{line.angle}, sketch_.subject.solution.pose));
        constexpr double seen_upright = 1e-6;
        if (std::min(std::abs(along.x), std::abs(along.y)) < seen_upright) return;
        if (dot(along, sketch_.spot(point) - sketch_.spot(*through)) > 1)
            add_angle(*through, point, line.angle, std::nullopt);
    }

    void gather() {
        for (const PointIndex point : indices_of(sketch_.mechanism.points)) {
            if (!sketch_.subject.shows(point)) continue;
            const Placement& placement = sketch_.mechanism.point(point).placement;
            if (const auto* polar = std::get_if<Polar>(&placement)) {
                add_length(polar->from, point, polar->distance.to_double());
                if (!polar->relative_to)
                    add_angle(polar->from, point, polar->angle, std::nullopt);
                else if (polar->relative_to->from == polar->from)
                    add_angle(polar->from, point, polar->angle,
                              unit(sketch_.spot(polar->relative_to->to) - sketch_.spot(polar->from)));
            } else if (const auto* on = std::get_if<Along>(&placement)) {
                if (!on->is_ratio) add_length(on->from, point, std::abs(on->amount.to_double()));
            } else if (const auto* meet = std::get_if<Meet>(&placement)) {
                for (const Curve* curve : {&meet->first, &meet->second}) {
                    if (const auto* circle = std::get_if<CircleCurve>(curve))
                        if (const auto* centre = std::get_if<PointIndex>(&circle->centre))
                            add_length(*centre, point, circle->radius.to_double());
                    if (const auto* line = std::get_if<LineCurve>(curve)) add_angle_of(*line, point);
                }
            }
        }
        gather_coordinates();
        for (const Body& body : sketch_.mechanism.bodies)
            if (body.circle)
                radii_.push_back({sketch_.spot(body.circle->centre), body.circle->radius.to_double() / sketch_.scale(),
                                  body.circle->radius.to_double(), body.name});
    }

    /// Fixed pins given by coordinates: how far each stands from the first, across and up.
    void gather_coordinates() {
        std::vector<PointIndex> fixed;
        for (const Joint& joint : sketch_.mechanism.joints)
            if (is_fixed_pin(joint) &&
                std::holds_alternative<Coordinates>(sketch_.mechanism.point(joint.point).placement) &&
                std::find(fixed.begin(), fixed.end(), joint.point) == fixed.end())
                fixed.push_back(joint.point);
        for (std::size_t i = 1; i < fixed.size(); ++i) {
            const Spot a = sketch_.spot(fixed[0]), b = sketch_.spot(fixed[i]);
            const Vector& first = std::get<Coordinates>(sketch_.mechanism.point(fixed[0]).placement).at;
            const Vector& other = std::get<Coordinates>(sketch_.mechanism.point(fixed[i]).placement).at;
            const std::string name = name_of(fixed[0]) + "." + name_of(fixed[i]);
            if (const double across = (other.x - first.x).to_double(); across != 0)
                add_length({a, b, {b.x > a.x ? 1.0 : -1.0, 0}, std::abs(across), name});
            if (const double up = (other.y - first.y).to_double(); up != 0 && other.x != first.x)
                lengths_.push_back({a, b, {0, b.y > a.y ? 1.0 : -1.0}, std::abs(up), name});
            else if (up != 0)
                add_length({a, b, unit(b - a), std::abs(up), name});
        }
    }

    /// Guides of the frame that run along an axis, by how far they pass beside the first fixed pin.
    void gather_offsets() {
        const Mechanism& mechanism = sketch_.mechanism;
        const auto pin = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
            return is_fixed_pin(joint) && std::holds_alternative<Coordinates>(mechanism.point(joint.point).placement);
        });
        if (pin == mechanism.joints.end()) return;
        const Vector& origin = std::get<Coordinates>(mechanism.point(pin->point).placement).at;
        for (const Joint& joint : mechanism.joints) {
            if (!is_slide(joint) || joint.bodies[1] != frame) continue;
            const Vector& guide = sketch_.subject.solution.pose.guides[at_index(mechanism.index_of(joint))];
            if (guide.x.is_zero() == guide.y.is_zero()) continue;
            const bool lying = guide.y.is_zero();
            const std::optional<Vector> given = given_on_guide(joint, lying);
            if (!given) continue;
            const Exact offset = lying ? given->y - origin.y : given->x - origin.x;
            if (offset.is_zero()) continue;
            // The guide's axis is met beside the block and its walls, on the pin's side.
            const Spot a = sketch_.spot(*pin), block = sketch_.spot(joint);
            const double beyond = sketch_.measures.slider_half + sketch_.measures.wall_beyond + 3;
            const Spot aside = lying ? Spot{a.x - block.x, 0} : Spot{0, a.y - block.y};
            const Spot b = block + std::min(beyond, length(aside)) * unit(aside);
            const Spot along = lying ? Spot{0, b.y > a.y ? 1.0 : -1.0} : Spot{b.x > a.x ? 1.0 : -1.0, 0};
            add_length({a, b, along, std::abs(offset.to_double()),
                        name_of(pin->point) + "." + name_of(joint.point) + ".offset"});
        }
    }
    /// A place on a guide that the file gives by its coordinates.
    std::optional<Vector> given_on_guide(const Joint& joint, bool lying) const {
        const Placement& placement = sketch_.mechanism.point(joint.point).placement;
        if (const auto* at = std::get_if<Coordinates>(&placement)) return at->at;
        const auto* meet = std::get_if<Meet>(&placement);
        if (meet == nullptr) return std::nullopt;
        const Vector& here = sketch_.subject.solution.pose.at(joint.point);
        for (const Curve* curve : {&meet->first, &meet->second}) {
            const auto* line = std::get_if<LineCurve>(curve);
            if (line == nullptr) continue;
            std::optional<Vector> place;
            if (const auto* bare = std::get_if<Vector>(&line->through)) place = *bare;
            if (const auto* point = std::get_if<PointIndex>(&line->through))
                if (const auto* at = std::get_if<Coordinates>(&sketch_.mechanism.point(*point).placement))
                    place = at->at;
            if (place && (lying ? place->y - here.y : place->x - here.x).is_zero()) return place;
        }
        return std::nullopt;
    }

    // ---- where ----

    /// Signed gap between a bar and obstacles: how many are nearer than `gap`.
    static int count_near(const Bar& bar, const std::vector<Obstacle>& obstacles, double gap,
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
            // What stands at the measured points themselves is no obstacle.
            const bool own = std::any_of(except.begin(), except.end(), [&](Spot spot) {
                return length(other.from - spot) < 3.5 && length(other.to - spot) < 3.5;
            });
            if (!own) ++count;
        }
        return count;
    }
    int count_letters_near(const Bar& bar) const {
        constexpr double near = 0.9;  // a little more than two labels keep
        const InkBox own{middle(bar), {length(bar) / 2, 0}, length(bar) > 0 ? unit(bar.to - bar.from) : Spot{1, 0}};
        return static_cast<int>(std::count_if(letters_.begin(), letters_.end(), [&](const InkBox& letters) {
            return lettering::gap_between(own, letters, near) < near;
        }));
    }
    static bool crosses(const Bar& a, const Bar& b) {
        const Spot u = a.to - a.from, v = b.to - b.from;
        const double turn = cross(u, v);
        if (std::abs(turn) < 1e-12) return false;
        const double t = cross(b.from - a.from, v) / turn, w = cross(b.from - a.from, u) / turn;
        return t >= 0 && t <= 1 && w >= 0 && w <= 1;
    }

    /// Text on its baseline's middle, read from below or from the right.
    struct Text {
        ShapedLine shaped;
        double size;
        double width() const { return shaped.width; }
    };
    Text text_of(const std::string& words) const {
        const double size = sketch_.theme.small;
        return {sketch_.context.fonts.shape(with_powers(words), size), size};
    }
    static double readable(double angle) {
        double a = std::remainder(angle, pi_number);      // within ±90°
        if (a >= 0.5 * pi_number - 1e-6) a -= pi_number;  // upright ones are read from the right
        return a;
    }
    static constexpr std::array<Spot, 2> nowhere{{{1e9, 1e9}, {1e9, 1e9}}};
    static constexpr double cap_height = 2.1, text_gap = 1.0, air_at_edge = 0.5;
    static constexpr double leaves_its_paper = 1000;
    static constexpr double arrow_outside = 6.0, head_room = 3.2;  // of a run too short for arrows between its ends

    /// The text's outline as bars about its middle.
    static std::array<Bar, 3> frame_of(Spot baseline_middle, double angle, double width) {
        const Spot along = polar_spot(angle), up = -1.0 * turned(along);
        const Spot left = baseline_middle - (width / 2) * along, right = baseline_middle + (width / 2) * along;
        return {Bar{left, right}, Bar{left + (cap_height / 2) * up, right + (cap_height / 2) * up},
                Bar{left + cap_height * up, right + cap_height * up}};
    }

    /// The box grown by what a trial draws.
    static Box with(Box box, const Trial& trial, double width) {
        const auto take = [&](const Bar& bar) {
            box.include(bar.from);
            box.include(bar.to);
        };
        for (const Bar& stroke : trial.strokes) take(stroke);
        for (const Bar& bar : frame_of(trial.text_at, trial.text_angle, width)) take(bar);
        return box;
    }
    /// What each thing costs that is nearer than a distance.
    struct Rate {
        double price, distance;
    };
    double toll(const Bar& bar, Rate heavy, Rate light, Rate taken, const std::array<Spot, 2>& ends) const {
        return toll(bar, heavy_, heavy, light, taken, ends);
    }
    double toll(const Bar& bar, const std::vector<Obstacle>& heavy_bars, Rate heavy, Rate light, Rate taken,
                const std::array<Spot, 2>& ends) const {
        return price_of_letters() * count_letters_near(bar) +
               heavy.price * count_near(bar, heavy_bars, heavy.distance, ends) +
               light.price * count_near(bar, light_, light.distance, ends) +
               taken.price * count_near(bar, taken_, taken.distance, nowhere);
    }
    /// Nothing is taken off a price: from `enough` on it is no longer added to.
    double price_of(const Trial& trial, const Text& text, const std::array<Spot, 2>& ends, double enough) const {
        double price = trial.price;
        const double on_text = price_of_letters();
        for (const Bar& stroke : trial.strokes)
            if (price < enough)
                price += toll(stroke, {3, 1.2}, {0.6, 0.3}, {3, 1.0}, ends) +
                         on_text * count_near(stroke, words_, 0.4, nowhere) +
                         1.2 * count_near(stroke, led_, 0.4, nowhere);
        for (const Bar& extension : trial.extensions)
            if (price < enough)
                price += toll(extension, crossed_, {1.5, 0.4}, {0.3, 0.2}, {1.5, 0.4}, ends) +
                         on_text * count_near(extension, words_, 0.4, nowhere) +
                         0.6 * count_near(extension, led_, 0.2, ends);
        for (const Bar& bar : frame_of(trial.text_at, trial.text_angle, text.width()))
            if (price < enough)
                price += toll(bar, {on_text, 1.5}, {on_text, 0.6}, {on_text, 0.9}, nowhere) +
                         on_text * count_near(bar, led_, 0.6, nowhere);
        if (price >= enough) return price;
        if (wish_.within) return price + (stays_within(trial, text) ? 0 : leaves_its_paper);
        const Box box = with(box_, trial, text.width());
        if (box.width() > std::max(room_.x, box_.width()) || box.height() > std::max(room_.y, box_.height()))
            price += 10;
        return price;
    }

    bool stays_within(const Trial& trial, const Text& text) const {
        Box box = grown(box_of_frame(trial, text.width()), air_at_edge);
        for (const std::vector<Bar>* bars : {&trial.strokes, &trial.extensions})
            for (const Bar& bar : *bars) box.include(bar.from), box.include(bar.to);
        return contains(*wish_.within, box.min) && contains(*wish_.within, box.max);
    }
    static Box box_of_frame(const Trial& trial, double width) {
        const std::array<Bar, 3> frame = frame_of(trial.text_at, trial.text_angle, width);
        Box box{frame[0].from, frame[0].from};
        for (const Bar& bar : frame) box.include(bar.from), box.include(bar.to);
        return box;
    }

    /// The same whether it is drawn before there are names or after.
    std::string id_of(const std::string& name) {
        std::string id = legal_id("dimension-" + name);
        while (!ids_.insert(id).second) id += "_";
        return id;
    }

    /// What a dimension is drawn as, and how much in the way it may stand.
    struct Drawn {
        std::string name, id;  // no id: that of the sketch for its name
        double free_enough;
    };
    Drawn drawn_as(std::string name) {
        std::string id = wish_.sought_far ? id_of(name) : "";
        return {std::move(name), std::move(id), wish_.sought_far ? 10 : 2.2};
    }
    /// The one id of an angle, however often it is tried.
    Drawn drawn_as(const AngleOf& datum) {
        const auto [known, is_new] = drawn_angles_.try_emplace(&datum);
        if (is_new) known->second = drawn_as("angle." + datum.name);
        return known->second;
    }

    /// Draws the best of the trials where it is free enough.
    bool draw_best(std::vector<Trial>& trials, const Text& text, const std::array<Spot, 2>& ends, Drawn as,
                   const std::string& title, bool all) {
        std::string& group = as.id;
        if (wish_.left_out.contains(group)) return false;
        const double free_enough = as.free_enough;
        Trial* best = nullptr;
        // What costs more than this is not drawn.
        double least = all ? 1e300 : free_enough + 1;
        for (Trial& trial : trials)
            if (const double price = price_of(trial, text, ends, least); price < least - 1e-9) {
                least = price;
                best = &trial;
            }
        if (!best || (!all && least > free_enough)) return false;
        if (group.empty()) group = sketch_.id("dimension", as.name);
        std::vector<Mark>& marks = sketch_.dimensions;
        marks.emplace_back(GroupBegin{"dimension", std::move(group), title, {}});
        for (const Bar& extension : best->extensions) marks.emplace_back(line(extension.from, extension.to, thin()));
        best->draw(marks);
        const std::size_t before = marks.size();
        set_text(marks, text.shaped, best->text_at - Spot{text.width() / 2, 0}, sketch_.theme.text, "label");
        for (std::size_t i = before; i < marks.size(); ++i)
            if (auto* set = std::get_if<TextMark>(&marks[i])) {
                set->angle = angle_of(polar_spot(best->text_angle));
                set->pivot = best->text_at;
            }
        marks.emplace_back(GroupEnd{});
        for (const Bar& bar : best->strokes) taken_.push_back({bar});
        for (const Bar& bar : best->extensions) (wish_.sought_far ? led_ : taken_).push_back({bar});
        for (const Bar& bar : frame_of(best->text_at, best->text_angle, text.width())) {
            taken_.push_back({bar});
            if (wish_.sought_far) words_.push_back({bar});
        }
        box_ = with(box_, *best, text.width());
        return true;
    }

    std::string with_unit(double metres) const {
        const Unit& unit_of_length = sketch_.mechanism.units.length;
        return given_number(metres / unit_of_length.si.to_double(), sketch_.context.language) + " " +
               unit_of_length.symbol;
    }

    /// A trial of a length with its dimension line: arrows and text between its ends.
    Trial between_ends(Trial trial, const Bar& run) const {
        const Spot a = run.from, b = run.to;
        trial.draw = [this, a, b](std::vector<Mark>& marks) {
            draw_arrow(marks, 0.5 * (a + b), b, sketch_.theme.thin, sketch_.theme.text);
            draw_arrow(marks, 0.5 * (a + b), a, sketch_.theme.thin, sketch_.theme.text);
        };
        trial.strokes = {run};
        put_text(trial, 0.5 * (a + b), b - a);
        return trial;
    }
    /// The same of a short one: arrows from outside, the text on the line that goes on beyond its second end.
    Trial outside_of_end(Trial trial, const Bar& run, double width) const {
        const Spot along = unit(run.to - run.from);
        const Spot a = run.from, b = run.to, before = a - arrow_outside * along;
        const Spot shelf = b + head_room * along, beyond = shelf + (width + 0.8) * along;
        trial.draw = [this, a, b, before, beyond](std::vector<Mark>& marks) {
            draw_arrow(marks, before, a, sketch_.theme.thin, sketch_.theme.text);
            draw_arrow(marks, beyond, b, sketch_.theme.thin, sketch_.theme.text);
            marks.emplace_back(line(a, b, thin()));
        };
        trial.strokes = {{before, beyond}};
        put_text(trial, 0.5 * (shelf + beyond), along);
        trial.price += 0.1;
        return trial;
    }
    void put_text(Trial& trial, Spot middle, Spot along) const {
        trial.text_angle = readable(angle_of(along));
        trial.text_at = middle + text_gap * Spot{std::sin(trial.text_angle), -std::cos(trial.text_angle)};
    }

    /// A level of a dimension line across the run, and what it costs to be so far from the mechanism.
    struct Level {
        double at, side, reach;
    };
    /// Beyond both ends; of ends that lie far from each other across the run also between them, near the one or the
    /// other.
    std::vector<Level> levels_of(double rise) const {
        const double near = std::min(0.0, rise), far = std::max(0.0, rise);
        std::vector<Level> levels;
        for (const double reach : {8.5, 12.0, 15.5, 19.0, 23.0, 27.0, 32.0, 38.0}) {
            if (reach > 19 && !wish_.sought_far) break;
            levels.push_back({far + reach, 1, reach});
            levels.push_back({near - reach, -1, reach});
        }
        if (wish_.sought_far)
            for (const double reach : {3.0, 6.0, 8.5, 12.0, 15.5, 19.0}) {
                if (far - near < reach + 12) break;
                levels.push_back({far - reach, -1, reach + 5});
                levels.push_back({near + reach, 1, reach + 5});
            }
        return levels;
    }

    bool draw(const Length& datum, bool all) {
        const std::string words = with_unit(datum.value);
        const Text text = text_of(words);
        const Spot along = datum.along, across = turned(along);
        const double run = dot(datum.to - datum.from, along), rise = dot(datum.to - datum.from, across);
        const bool has_text_between = run >= std::max(text.width() + 3, 9.0);
        if (!has_text_between && !(wish_.sought_far && run > 1)) return false;
        std::vector<Trial> trials;
        for (const Level& level : levels_of(rise)) {
            Trial trial;
            const Spot a = datum.from + level.at * across, b = a + run * along;
            const double clear = sketch_.measures.pin_radius + 0.7;
            for (const auto& [point, foot] : {std::pair{datum.from, a}, std::pair{datum.to, b}}) {
                const Spot out = unit(foot - point);
                if (length(foot - point) > clear) trial.extensions.push_back({point + clear * out, foot + 1.4 * out});
            }
            // Nearer is better, outside of the mechanism, too.
            const bool inside = dot(0.5 * (a + b) - sketch_.mechanism_box().middle(), level.side * across) < 0;
            trial.price = 0.06 * level.reach + (inside ? 0.35 : 0);
            if (has_text_between) {
                trials.push_back(between_ends(trial, {a, b}));
            } else {
                trials.push_back(outside_of_end(trial, {a, b}, text.width()));
                trials.push_back(outside_of_end(trial, {b, a}, text.width()));
            }
        }
        return draw_best(trials, text, {datum.from, datum.to}, drawn_as(datum.name), words, all);
    }

    static double leader_angle(double step) { return -pi_number / 4 + pi_number / 6 * step + 0.05; }
    /// From outside onto the rim, the figure beyond on a shelf.
    Trial from_outside(const Radius& datum, double angle, double length, double width, double price) const {
        const Spot out = polar_spot(angle);
        const Spot rim = datum.centre + datum.radius * out, knee = rim + length * out;
        const Spot shelf{out.x >= 0 ? 1.0 : -1.0, 0};
        const Spot end = knee + (width + 0.8) * shelf;
        Trial trial;
        trial.draw = [this, knee, rim, end](std::vector<Mark>& marks) {
            draw_arrow(marks, knee, rim, sketch_.theme.thin, sketch_.theme.text);
            marks.emplace_back(line(knee, end, thin()));
        };
        trial.strokes = {{rim + 1.6 * out, knee}, {knee, end}};
        trial.text_at = 0.5 * (knee + end) + Spot{0, -text_gap};
        trial.price = price;
        return trial;
    }
    /// From the centre to the rim, the text along it.
    Trial from_centre(const Radius& datum, double angle, double price) const {
        const Spot out = polar_spot(angle);
        const Spot rim = datum.centre + datum.radius * out,
                   foot = datum.centre + (sketch_.measures.pin_radius + 0.7) * out;
        Trial trial;
        trial.draw = [this, foot, rim](std::vector<Mark>& marks) {
            draw_arrow(marks, foot, rim, sketch_.theme.thin, sketch_.theme.text);
        };
        trial.strokes = {{foot, rim - 1.6 * out}};
        put_text(trial, 0.5 * (foot + rim), out);
        trial.price = price;
        return trial;
    }

    bool draw(const Radius& datum, bool all) {
        const std::string words = "R " + with_unit(datum.value);
        const Text text = text_of(words);
        if (datum.radius < (wish_.sought_far ? 2 : 5)) return false;
        std::vector<Trial> trials;
        for (int i = 0; i < 12; ++i)
            trials.push_back(from_outside(datum, leader_angle(i), 6.5, text.width(), 0.02 * i));
        if (wish_.sought_far)
            for (const double half : {0.0, 0.5})
                for (int i = 0; i < 12; ++i) {
                    for (const double length : {6.5, 11.0, 16.0, 22.0})
                        trials.push_back(from_outside(datum, leader_angle(i + half), length, text.width(),
                                                      0.02 * i + 0.06 * length));
                    if (datum.radius > text.width() + 8)
                        trials.push_back(from_centre(datum, leader_angle(i + half), 0.6 + 0.02 * i));
                }
        return draw_best(trials, text, {datum.centre, datum.centre}, drawn_as(datum.name), words, all);
    }

    /// A trial of a narrow angle with its arc, which begins before the line that it is counted from, and its text
    /// there.
    Trial beside_base(Trial trial, const AngleOf& datum, double radius, double width) const {
        const double turn = datum.sweep > 0 ? 1 : -1;
        const auto at = [&](double angle) { return datum.vertex + radius * polar_spot(datum.from + angle); };
        const Spot tangent = turned(polar_spot(datum.from));
        const double half = std::abs(tangent.x) * width / 2 + std::abs(tangent.y) * cap_height / 2;
        const double begin = -turn * 4 / radius, middle = begin - turn * (half + 1) / radius;
        trial.draw = [this, &datum, radius, begin](std::vector<Mark>& marks) {
            draw_arc_arrow(marks, datum.vertex, radius, datum.from + begin, datum.from + datum.sweep,
                           sketch_.theme.thin, sketch_.theme.text);
        };
        trial.strokes.push_back({at(begin), at(0)});
        trial.text_at = at(middle) + Spot{0, cap_height / 2};
        trial.price = 0.05 * radius + 0.6;
        return trial;
    }

    /// A trial of an angle with its arc, its text on a shelf to which a leader goes from the arc: where the lines that
    /// it is between leave no room for letters.
    Trial led_out(Trial trial, const AngleOf& datum, double radius, double share, double reach, double width) const {
        const Spot out = polar_spot(datum.from + share * datum.sweep), shelf{out.x >= 0 ? 1.0 : -1.0, 0};
        const Spot foot = datum.vertex + radius * out, knee = foot + reach * out, end = knee + (width + 0.8) * shelf;
        trial.draw = [this, arc = trial.draw, knee, end](std::vector<Mark>& marks) {
            arc(marks);
            marks.emplace_back(line(knee, end, thin()));
        };
        trial.extensions.push_back({foot, knee});  // as little in the way as these are
        trial.strokes.push_back({knee, end});
        trial.text_at = 0.5 * (knee + end) + Spot{0, -text_gap};
        trial.price = 0.05 * radius + 0.06 * reach + std::abs(share - 0.5) + 0.8;
        return trial;
    }

    /// The arc of an angle and the line that it is counted from; no text yet.
    Trial arc_of(const AngleOf& datum, double radius) const {
        Trial trial;
        trial.draw = [this, &datum, radius](std::vector<Mark>& marks) {
            draw_arc_arrow(marks, datum.vertex, radius, datum.from, datum.from + datum.sweep, sketch_.theme.thin,
                           sketch_.theme.text);
        };
        const int parts = 6;
        const double turn = datum.sweep > 0 ? 1 : -1;
        // Where arc and link meet is meant: it ends a little before.
        const double shy = std::min(0.3, 2.4 / radius) * turn;
        for (int i = 0; i < parts; ++i)
            trial.strokes.push_back(
                {datum.vertex + radius * polar_spot(datum.from + (datum.sweep - shy) * i / parts),
                 datum.vertex + radius * polar_spot(datum.from + (datum.sweep - shy) * (i + 1) / parts)});
        const Spot base = polar_spot(datum.from);
        trial.extensions = {
            {datum.vertex + (sketch_.measures.pin_radius + 0.7) * base, datum.vertex + (radius + 2.5) * base}};
        return trial;
    }

    bool draw(const AngleOf& datum, bool all) {
        const Text text = text_of(datum.text);
        std::vector<Trial> trials;
        for (const double radius : {9.0, 12.0, 15.0, 18.5, 22.0, 26.0, 31.0}) {
            const double arc = std::abs(datum.sweep) * radius;
            if (arc < (wish_.sought_far ? 2.2 : 4) || (radius > 22 && !wish_.sought_far)) continue;
            const Trial trial = arc_of(datum, radius);
            for (const double share : {0.5, 0.35, 0.65}) {
                if (arc < 4) break;
                Trial one = trial;
                const double middle = datum.from + share * datum.sweep;
                const Spot out = polar_spot(middle);
                const Spot reach{std::abs(out.x) * text.width() / 2, std::abs(out.y) * cap_height / 2};
                one.text_at = datum.vertex + (radius + 1.0 + reach.x + reach.y) * out + Spot{0, cap_height / 2};
                one.price = 0.05 * radius + std::abs(share - 0.5);
                trials.push_back(std::move(one));
            }
            if (wish_.sought_far) trials.push_back(beside_base(trial, datum, radius, text.width()));
        }
        return draw_best(trials, text, {datum.vertex, datum.vertex}, drawn_as(datum), datum.text, all);
    }
    /// Where all else stands.
    bool draw_led_out(const AngleOf& datum, bool all) {
        const Text text = text_of(datum.text);
        std::vector<Trial> trials;
        for (const double radius : {6.0, 7.5, 9.0, 12.0, 15.0}) {
            if (std::abs(datum.sweep) * radius < 2.2) continue;
            const Trial arc = arc_of(datum, radius);
            for (const double share : {0.5, 0.35, 0.65})
                for (const double reach : {7.0, 9.5, 12.0, 15.0, 18.0, 21.5, 25.0, 30.0, 36.0})
                    trials.push_back(led_out(arc, datum, radius, share, reach, text.width()));
        }
        Drawn as = drawn_as(datum);
        as.free_enough =
            18;  // a leader may cross what letters may not, and a link it crosses counts by each of its strokes
        return draw_best(trials, text, {datum.vertex, datum.vertex}, std::move(as), datum.text, all);
    }

    Sketch& sketch_;
    Spot room_;
    const DimensionWish& wish_;
    Box box_;        // of all that is drawn
    Spot origin_{};  // where that of the sketch lies in the figure
    std::vector<Obstacle> heavy_, light_, taken_;
    std::vector<InkBox> letters_;
    std::vector<Obstacle> crossed_;  // what extension lines had better not cross
    std::vector<Length> lengths_;
    std::vector<Radius> radii_;
    std::vector<AngleOf> angles_;
    std::vector<Obstacle> words_;  // texts of dimensions that are sought far
    std::vector<Obstacle> led_;    // their extension lines, which other lines may cross
    std::set<std::string> ids_;
    std::map<const AngleOf*, Drawn> drawn_angles_;
};

struct DimensionText {
    InkBox box;
    std::string dimension;  // its group's id
};
struct DimensionPath {
    const Path* path;
    std::string dimension;
};

}  // namespace

void draw_dimensions(Sketch& sketch, Spot room, const DimensionWish& wish) {
    DimensionsDrawing(sketch, room, wish).draw();
}

void add_dimensions(Sketch& sketch, Figure& figure, Spot room, const DimensionWish& wish) {
    DimensionsDrawing(sketch, figure, room, wish).draw();
    std::vector<Mark>& drawn = sketch.dimensions;
    if (drawn.empty()) return;
    move(drawn, figure.origin.x, figure.origin.y);
    figure.box.include(box_of(drawn));
    // The last of the layers, below all letters.
    drawn.insert(drawn.begin(), GroupBegin{"dimensions", {}, {}, {}});
    drawn.emplace_back(GroupEnd{});
    figure.marks.insert(figure.marks.begin() + static_cast<std::ptrdiff_t>(end_of_layers(figure.marks)),
                        std::make_move_iterator(drawn.begin()), std::make_move_iterator(drawn.end()));
    drawn.clear();
    figure.move(-figure.box.min.x, -figure.box.min.y);
}

std::set<std::string> dimensions_of(const Figure& figure) {
    std::set<std::string> ids;
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group != nullptr && group->cls == "dimension")
            ids.insert(group->id);
    return ids;
}

std::set<std::string> covered_dimensions(const Figure& figure, const Fonts& fonts) {
    InkMap others(figure.box);
    std::vector<DimensionText> texts;
    std::vector<DimensionPath> paths;
    std::string dimension;  // that a mark belongs to, while its group is open
    int dimension_depth = 0, depth = 0;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            ++depth;
            if (dimension_depth == 0 && group->cls == "dimension") {
                dimension_depth = depth;
                dimension = group->id;
            }
        }
        if (std::holds_alternative<GroupEnd>(mark)) {
            if (dimension_depth == depth) dimension_depth = 0;
            --depth;
        }
        if (const auto* text = std::get_if<TextMark>(&mark); text && dimension_depth > 0)
            if (const auto ink = ink_of(*text, fonts)) texts.push_back({ink->grown(0.3), dimension});
        if (const auto* path = std::get_if<Path>(&mark)) {
            if (dimension_depth > 0)
                paths.push_back({path, dimension});
            else
                others.ink(*path);
        }
    }
    std::set<std::string> covered;
    for (const DimensionText& text : texts) {
        InkMap of_other_dimensions(figure.box);
        for (const DimensionPath& path : paths)
            if (path.dimension != text.dimension && !covered.contains(path.dimension))
                of_other_dimensions.ink(*path.path);
        if (others.touches(text.box) || of_other_dimensions.touches(text.box)) covered.insert(text.dimension);
    }
    return covered;
}

}  // namespace kinegraph::render::drawing
