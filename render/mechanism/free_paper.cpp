// Free paper: bodies, ground, pins, arrows and centres are solid ink; construction lines are thin.
#include "render/mechanism/free_paper.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>

#include "render/page/label_bodies.hpp"

namespace kinegraph::render::drawing {

namespace {

constexpr double clear_of_ink = 0.9;  // between an arrow and other ink, mm
constexpr double about_name = 0.6;    // round a name: a little more than where names are placed
constexpr double half_arrow = 1.0;    // half the width of an arrow's head, mm
constexpr double beside_all = 60;     // arrows and names that are drawn later stand this near, mm

struct Layer {
    std::vector<Mark> Layers::*marks;
    bool is_thin = false;
};
constexpr std::array<Layer, FreePaper::layers> all_layers{{{&Layers::ground},
                                                           {&Layers::bodies},
                                                           {&Layers::pins},
                                                           {&Layers::arrows},
                                                           {&Layers::centres},
                                                           {&Layers::dimensions},
                                                           {&Layers::construction, true},
                                                           {&Layers::over_bodies, true}}};

Box extent_of(const Sketch& sketch) {
    Box box = sketch.mechanism_box();
    for (const Layer& layer : all_layers)
        if (!(sketch.*layer.marks).empty()) box.include(box_of(sketch.*layer.marks));
    return box;
}

/// The labels of a figure are placed in the same room: see LabelSetting::spare.
Box room_of_names(const Sketch& sketch, const Box& drawn) {
    if (!sketch.space) return grown(drawn, beside_all);
    const Box own = sketch.with_more_on_one_side(drawn, sketch.labels, *sketch.space);
    const Spot spare{std::max(0.0, sketch.space->x - own.width()) / 2,
                     std::max(0.0, sketch.space->y - own.height()) / 2};
    return {own.min - spare, own.max + spare};
}

}  // namespace

std::array<Spot, pieces_of_arc + 1> spots_along(const Arc& arc) {
    const Spot turn = polar_spot((arc.to - arc.from) / static_cast<double>(pieces_of_arc));
    Spot arm = arc.radius * polar_spot(arc.from);
    std::array<Spot, pieces_of_arc + 1> spots;
    for (Spot& spot : spots) {
        spot = arc.centre + arm;
        arm = {turn.x * arm.x - turn.y * arm.y, turn.y * arm.x + turn.x * arm.y};
    }
    return spots;
}

FreePaper& paper_of(Sketch& sketch) {
    if (!sketch.paper)
        sketch.paper = std::make_shared<FreePaper>(grown(sketch.mechanism_box(), beside_all + sketch.size() / 2),
                                                   sketch.strokes_of_bodies());
    sketch.paper->take_what_is_new(sketch);
    return *sketch.paper;
}

void FreePaper::take_what_is_new(const Sketch& sketch) {
    for (std::size_t i = 0; i < layers; ++i) {
        const std::vector<Mark>& marks = sketch.*all_layers[i].marks;
        for (; taken_[i] < marks.size(); ++taken_[i])
            if (const auto* path = std::get_if<Path>(&marks[taken_[i]]))
                (all_layers[i].is_thin ? thin_ : solid_).ink(*path);
            else if (const auto* text = std::get_if<TextMark>(&marks[taken_[i]]))
                if (const auto ink = ink_of(*text, sketch.context.fonts)) solid_.fill(*ink);
    }
    drawn_ = extent_of(sketch);
    room_ = room_of_names(sketch, drawn_);
    if (reserved_) drawn_.include(*reserved_);
}

double FreePaper::price_of_pieces(const auto& along, double enough) const {
    // A third of an arrow on solid ink is as bad as a leader: see label_prices.hpp. Along a thin line it is not much.
    constexpr double on_solid_ink = 16, on_thin_lines = 1.5;
    const double share = 1.0 / static_cast<double>(along.size() - 1);
    // A piece that is no longer than wide has an upright box, which is tested faster.
    const auto about = [](Spot d, Spot middle) -> InkBox {
        if (dot(d, d) <= 4 * clear_of_ink * clear_of_ink) return {middle, {clear_of_ink, clear_of_ink}};
        return {middle, {length(d) / 2, clear_of_ink}, unit(d)};
    };
    double price = 0;
    for (std::size_t i = 0; i + 1 < along.size() && price < enough; ++i) {
        const Spot d = along[i + 1] - along[i];
        const InkBox box = about(d, 0.5 * (along[i] + along[i + 1]));
        price += share * (solid_.touches(box) ? on_solid_ink : thin_.touches(box) ? on_thin_lines : 0);
    }
    return price;
}

double FreePaper::price_of(const std::array<Spot, pieces_of_arc + 1>& along, double enough) const {
    return price_of_pieces(along, enough);
}
double FreePaper::price_of(const Bar& bar, double enough) const {
    return price_of_pieces(std::array{bar.from, middle(bar), bar.to}, enough);
}

bool FreePaper::has_room_for(const InkBox& name) const {
    const Spot reach = name.reach();
    return contains(room_, name.centre - reach) && contains(room_, name.centre + reach) &&
           !solid_.touches(name.grown(about_name)) && !thin_.touches(name.grown(about_name));
}

bool FreePaper::seems_of_another(const std::array<Spot, 3>& along, const std::vector<BodyIndex>& own,
                                 double factor) const {
    constexpr double seen_apart = 1;  // distances that differ by less look the same, mm
    double to_own = 1e300, to_other = 1e300;
    for (const BodyStroke& stroke : strokes_) {
        double& least = std::find(own.begin(), own.end(), stroke.body) == own.end() ? to_other : to_own;
        for (const Spot spot : along) least = std::min(least, distance_to_segment(spot, stroke.from, stroke.to));
    }
    return to_other < to_own / factor + (factor > 1 ? 0 : seen_apart);
}

bool FreePaper::is_cut_off(Spot place, Spot arrow, const std::vector<BodyIndex>& own) const {
    return std::any_of(strokes_.begin(), strokes_.end(), [&](const BodyStroke& stroke) {
        return std::find(own.begin(), own.end(), stroke.body) == own.end() &&
               lettering::cross_each_other(place, arrow, stroke);
    });
}

double FreePaper::beyond_all(const InkBox& name) const {
    const Spot low = name.centre - name.reach(), high = name.centre + name.reach();
    return std::max({0.0, drawn_.min.x - low.x, high.x - drawn_.max.x}) +
           std::max({0.0, drawn_.min.y - low.y, high.y - drawn_.max.y});
}

std::optional<InkBox> FreePaper::room_about(Spot spot, const InkBox& name) const {
    constexpr double off = 1.2;  // mm
    for (const auto side :
         std::initializer_list<Spot>{{1, -0.7}, {-1, -0.7}, {1, 0.7}, {-1, 0.7}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}) {
        const Spot to{side.x * (name.half.x + off), side.y * (name.half.y + off)};
        const InkBox there{spot + to, name.half, name.axis};
        if (has_room_for(there)) return there;
    }
    return std::nullopt;
}

void FreePaper::take(const Arc& arc) {
    const auto spots = spots_along(arc);
    for (std::size_t i = 0; i + 1 < spots.size(); ++i) take(Bar{spots[i], spots[i + 1]});
}
void FreePaper::take(const Bar& bar) { solid_.stroke(bar.from, bar.to, half_arrow); }
void FreePaper::take(const InkBox& name) {
    solid_.fill(name);
    const Box box{name.centre - name.reach(), name.centre + name.reach()};
    if (reserved_)
        reserved_->include(box);
    else
        reserved_ = box;
    drawn_.include(box);
}

}  // namespace kinegraph::render::drawing
