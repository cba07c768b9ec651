// Conversion of a figure's marks into obstacles, and the price of ink and tints near a place.
#include "render/page/label_ground.hpp"

#include <cmath>
#include <utility>

#include "render/page/shapes.hpp"

namespace kinegraph::render::lettering {

namespace {

constexpr double breathing = 1.3;   // mm; nearer strokes make a place less desirable
constexpr double covers_area = 15;  // per mm² of a stroke
constexpr double crowding = 0.5;    // per mm² of ink within breathing distance
constexpr double most_crowding = 2.8;
constexpr double on_a_tint = 2;

}  // namespace

Ground::Ground(const std::vector<Mark>& marks, const Fonts& fonts) : map_(box_of(marks)) {
    for (const Mark& mark : marks) {
        if (const auto* path = std::get_if<Path>(&mark)) add(*path);
        if (const auto* axis = std::get_if<Axis>(&mark)) map_.stroke(axis->tail, axis->tip, 0.35);
        if (const auto* text = std::get_if<TextMark>(&mark)) add(*text, fonts);
    }
}

void Ground::add(const Path& path) {
    map_.ink(path);
    if (!path.filled || !path.tinted || is_dot(path)) return;
    Area area{outline_of(path), nowhere, {path.fill, path.tint_of}};
    if (area.corners.size() < 3) return;
    for (const Spot& spot : area.corners) enlarge(area.box, spot);
    areas_.push_back(std::move(area));
}

void Ground::add(const TextMark& text, const Fonts& fonts) {
    if (const auto ink = ink_of(text, fonts)) {
        map_.fill(ink->grown(label_gap - ink_margin));
        texts_.push_back(*ink);
    }
}

bool Ground::Area::holds(Spot spot) const {
    if (spot.x < box.min.x || spot.x > box.max.x || spot.y < box.min.y || spot.y > box.max.y) return false;
    bool in = false;
    const std::vector<Spot>& c = corners;
    for (std::size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
        if ((c[i].y > spot.y) != (c[j].y > spot.y) &&
            spot.x < (c[j].x - c[i].x) * (spot.y - c[i].y) / (c[j].y - c[i].y) + c[i].x)
            in = !in;
    return in;
}

std::optional<Ground::Tint> Ground::tint_at(Spot spot) const {
    // The area drawn last is the visible one.
    const auto area = std::find_if(areas_.rbegin(), areas_.rend(), [&](const Area& each) { return each.holds(spot); });
    return area == areas_.rend() ? std::nullopt : std::optional(area->tint);
}

bool Ground::covers_text(const InkBox& thread) const {
    return std::any_of(texts_.begin(), texts_.end(),
                       [&](const InkBox& text) { return gap_between(thread, text, 0.1) < 0.1; });
}

double Ground::price(const InkBox& box, bool free) const {
    double price = 0;
    for (const Area& area : areas_)
        if (area.holds(box.centre)) price += on_a_tint;
    if (free)
        return price + std::min(most_crowding, crowding * map_.inked(box.grown(breathing), most_crowding / crowding));
    return price + covers_stroke + covers_area * map_.inked(box.grown(ink_margin));
}

}  // namespace kinegraph::render::lettering
