// Candidate places of an arc, by preference, and the price of what an arc and its name would meet there.
#include "render/mechanism/free_arc.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/page/label_boxes.hpp"

namespace kinegraph::render::drawing {

namespace {

// Preferences. An arc says which body turns by beginning or ending at a stroke of it; about a fixed pin a small one
// does so all round, too.
constexpr double per_millimetre = 0.12;  // between stroke and arc, beyond the nearest place
constexpr double per_radius = 0.1;       // per mm off the radius that suits the length of the stroke
constexpr double per_stroke = 0.2;       // at another stroke of the body than that to its first corner
constexpr double behind_of_driver = 3;
constexpr double behind = 0.1;       // ends at the stroke instead of beginning there
constexpr double elsewhere = 0.5;    // about another point than the pivot
constexpr double about_a_wheel = 1;  // outside of a wheel instead of at its pivot
constexpr double past_another = 4;   // with another body between it and its stroke, whose arc it seems to be
constexpr double per_growth = 0.6;   // per mm by which its name makes the figure larger: a leader is better than 10 mm
constexpr double farthest_arc = 9,
                 at_a_pin = 40;  // from the stroke, mm: along the arc, and where it is about a fixed pin

constexpr double longest = 11, widest = 1.05;  // of an arc: mm and radians
constexpr double gap_to_stroke = 2.6;          // mm
constexpr double step_round = 0.5;             // radians

/// A stroke of the body that leaves the pivot. The arc touches it, and its length limits the radius.
struct Arm {
    Spot along{1, 0};
    double reach = 12;  // mm
};
/// That towards the body's first corner, then the others.
std::vector<Arm> arms_of(const Layout& layout, BodyIndex body, Spot pivot) {
    std::vector<Arm> arms;
    const auto is_new = [&](Spot along) {
        constexpr double nearly = 0.95;
        return std::none_of(arms.begin(), arms.end(), [&](const Arm& arm) { return dot(arm.along, along) > nearly; });
    };
    for (const PointIndex corner : layout.subject.corners[at_index(body)])
        if (const Spot out = layout.spot(corner) - pivot; length(out) > 1 && is_new(unit(out)))
            arms.push_back({unit(out), length(out)});
    if (const auto& wheel = layout.mechanism.body(body).circle; wheel && arms.empty())
        arms.push_back({{1, 0}, wheel->radius.to_double() / layout.scale()});
    if (arms.empty()) arms.emplace_back();
    return arms;
}

/// A place of an arc, with what it costs by itself.
struct ArcPlace {
    Arc arc;
    double price;
    std::optional<Arc> to_stroke{};  ///< the way from its stroke, if it stands off
};

/// On paper y points down, so counter-clockwise is the negative sense.
double sense_of(const Turning& turning) { return turning.counter_clockwise ? -1 : 1; }
double width_of_arc(double radius) { return std::min(widest, longest / radius); }

/// At one stroke, with one radius: beginning at the stroke or further round, up to a distance; of what is found also
/// ending there. What drives has its arc rather ahead of its body, where this turns to.
void add_places(std::vector<ArcPlace>& places, const Turning& turning, const Arm& arm, double radius, double most,
                double price) {
    const double turn = sense_of(turning), by = turn * width_of_arc(radius), gap = gap_to_stroke / radius;
    const double stroke = angle_of(arm.along);
    for (double on = 0; on * radius <= most && std::abs(by) + gap + on < 2 * pi_number - gap; on += step_round) {
        const double away = turn * (gap + on), own = price + per_millimetre * on * radius;
        const auto way = [&](double sense) {
            const double near = stroke + sense * turn * gap;
            return on > 0 ? std::optional(Arc{turning.pivot, radius, near, stroke + sense * away}) : std::nullopt;
        };
        places.push_back({{turning.pivot, radius, stroke + away, stroke + away + by}, own, way(1)});
        places.push_back({{turning.pivot, radius, stroke - away - by, stroke - away},
                          own + (turning.statement != none ? behind : behind_of_driver),
                          way(-1)});
    }
}

/// A body without a fixed pin seems to turn about any of its points: about others of its longest stroke, too.
void add_places_along(std::vector<ArcPlace>& places, const Layout& layout, Turning turning) {
    const std::vector<Bar>& strokes = layout.shape(turning.body).strokes;
    if (strokes.empty()) return;
    const Bar& stroke = longest_of(strokes);
    for (const double share : {0.5, 0.25, 0.75}) {
        turning.pivot = stroke.from + share * (stroke.to - stroke.from);
        if (coincide(turning.pivot, layout.shape(turning.body).middle)) continue;
        for (const Spot end : {stroke.from, stroke.to})
            for (const double radius : {8.0, 6.0})
                add_places(places, turning, {unit(end - turning.pivot), length(end - turning.pivot)}, radius,
                           farthest_arc, elsewhere + (radius < 8 ? per_radius : 0));
    }
}

/// Outside of a wheel of the body, where it is too full within; the wheel may turn about a point beside its centre.
void add_places_about_wheels(std::vector<ArcPlace>& places, const Layout& layout, const Turning& turning) {
    constexpr int round = 12;
    constexpr double off = 3;
    for (const Rim& rim : layout.shape(turning.body).rims) {
        if (rim.form == Rim::Form::arc || rim.hollow) continue;
        const double radius = rim.radius + off + (rim.form == Rim::Form::gear ? layout.module() : 0);
        const double by = sense_of(turning) * width_of_arc(radius);
        for (int i = 0; i < round; ++i) {
            const double from = 2 * pi_number * i / round;
            places.push_back({{rim.centre, radius, from, from + by}, about_a_wheel});
        }
    }
}

/// All, the preferred ones first.
std::vector<ArcPlace> places_of(const Layout& layout, const Turning& turning) {
    std::vector<ArcPlace> places;
    const bool is_about_pin = std::any_of(
        layout.mechanism.joints.begin(), layout.mechanism.joints.end(),
        [&](const Joint& joint) { return joint.pair().has_pin() && coincide(layout.spot(joint), turning.pivot); });
    double of_arm = 0;
    for (const Arm& arm : arms_of(layout, turning.body, turning.pivot)) {
        const double suits = std::clamp(0.4 * arm.reach, 8.0, 14.0), small = std::clamp(0.25 * arm.reach, 6.0, 8.0);
        for (const double radius : {suits, small, 11.0, std::clamp(arm.reach, 8.0, 19.0)})
            add_places(places, turning, arm, radius,
                       is_about_pin && of_arm == 0 && radius <= 11 ? at_a_pin : farthest_arc,
                       of_arm + per_radius * std::abs(radius - suits));
        of_arm += per_stroke;
    }
    if (!is_about_pin) add_places_along(places, layout, turning);
    add_places_about_wheels(places, layout, turning);
    std::stable_sort(places.begin(), places.end(),
                     [](const ArcPlace& a, const ArcPlace& b) { return a.price < b.price; });
    return places;
}

/// Whether a name keeps clear of its own arc.
bool is_clear(const auto& arc, const InkBox& name) {
    return std::none_of(arc.begin(), arc.end(),
                        [&](Spot spot) { return lettering::distance_to_box(spot, name) < 0.8 * clear_of_arc; });
}

using Along = decltype(spots_along({}));
constexpr std::size_t middle_of_arc = pieces_of_arc / 2;
static_assert(2 * middle_of_arc == pieces_of_arc);

/// A free place of the name about the middle of its arc: outside, then obliquely, then inside.
std::optional<InkBox> room_for(const FreePaper& paper, const Arc& arc, const Along& along, InkBox name, double off) {
    static const std::array turns{polar_spot(0),
                                  polar_spot(0.5),
                                  polar_spot(-0.5),
                                  polar_spot(1),
                                  polar_spot(-1),
                                  polar_spot(pi_number),
                                  polar_spot(pi_number - 0.5),
                                  polar_spot(pi_number + 0.5)};
    const Spot middle = along[middle_of_arc], outward = (1 / arc.radius) * (middle - arc.centre);
    for (const Spot turn : turns) {
        const Spot u{outward.x * turn.x - outward.y * turn.y, outward.x * turn.y + outward.y * turn.x};
        const double to_side = 1 / std::max(std::abs(u.x), std::abs(u.y));
        name.centre = middle + off * u + to_side * Spot{u.x * name.half.x, u.y * name.half.y};
        if (is_clear(along, name) && paper.has_room_for(name)) return name;
    }
    return std::nullopt;
}

/// Whether an arc would be read as the turning of another body: that is as near or crossed, or the arc stands about a
/// pin of others. One about the body's own fixed pin is read by that, too, unless another body stands between or is
/// twice as near.
bool seems_of_another(const Layout& layout, const FreePaper& paper, BodyIndex body, const Arc& arc,
                      const Along& along) {
    constexpr double about = 0.4;  // of its radius: a pin nearer to its centre seems to be that
    bool about_any = false, about_own = false, about_fixed = false;
    for (const Joint& joint : layout.mechanism.joints) {
        if (!joint.pair().has_pin() || length(layout.spot(joint) - arc.centre) >= about * arc.radius) continue;
        about_any = true;
        about_own = about_own || joint.connects(body);
        about_fixed = about_fixed || (joint.connects(body) && is_fixed_pin(joint));
    }
    const std::array spots{along.front(), along[middle_of_arc], along.back()};
    return (about_any && !about_own) || paper.is_cut_off(spots.front(), spots.back(), {body}) ||
           (about_fixed && paper.is_cut_off(arc.centre, spots[1], {body})) ||
           paper.seems_of_another(spots, {body}, about_fixed ? 2 : 1);
}

/// Of a name that stands away from its arc, as near as it can; a leader that crosses another body leads astray.
double price_of_leader(const FreePaper& paper, BodyIndex body, const Arc& arc, const Along& along, const InkBox& name,
                       double enough) {
    constexpr double nearest = 6, step = 5, farthest_off = 21, per_length = 0.3, over_a_body = 6;
    double price = without_name;
    for (double off = nearest; off < farthest_off && price < enough; off += step, price += per_length * step)
        if (const auto room = room_for(paper, arc, along, name, off))
            return price + (paper.is_cut_off(along[middle_of_arc], room->centre, {body}) ? over_a_body : 0);
    return price + over_a_body / 3;  // farther off it may have to cross one
}

}  // namespace

InkBox box_of_name(const Sketch& sketch, const RichText& text) {
    const ShapedLine shaped = sketch.context.fonts.shape(text, sketch.theme.label);
    return {{}, {0.5 * shaped.width, 0.5 * (shaped.ascent + shaped.descent)}};
}

PlacedArc free_arc(const Sketch& sketch, const FreePaper& paper, const Turning& turning) {
    const InkBox name = box_of_name(sketch, turning.text);
    Cheapest<PlacedArc> best;
    for (const ArcPlace& place : places_of(sketch, turning)) {
        if (place.price >= best.price) break;
        const Along along = spots_along(place.arc);
        double price = place.price + paper.price_of(along, best.price - place.price);
        if (price >= best.price) continue;
        if (place.to_stroke && paper.price_of(*place.to_stroke, past_another) > 0) price += past_another;
        if (price >= best.price) continue;
        if (seems_of_another(sketch, paper, turning.body, place.arc, along)) price += read_at_another;
        if (price >= best.price) continue;
        const auto room = room_for(paper, place.arc, along, name, clear_of_arc);
        const double of_name = room ? std::min(per_growth * paper.beyond_all(*room), without_name)
                                    : price_of_leader(paper, turning.body, place.arc, along, name, best.price - price);
        best.offer(price + of_name, {place.arc, room, price});
    }
    return best.choice;
}

}  // namespace kinegraph::render::drawing
