// Labels: draws every label of a figure or lists it in a key below, and removes leaders. Owns the marks of a placed
// label; label_search chooses the place, label_ground and label_places compute its price. Independent of mechanics.
#include "render/page/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/number/functions.hpp"
#include "render/page/label_ground.hpp"
#include "render/page/label_key.hpp"
#include "render/page/label_places.hpp"
#include "render/page/label_prices.hpp"
#include "render/page/label_search.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

using lettering::Candidate;
using lettering::Ground;
using lettering::LabelSearch;

namespace {

constexpr double wide_key = 90;  // width of a key's lines under a narrow figure, mm
constexpr double above_key = 2.5;

}  // namespace

double room_of_names(const Figure& figure, const Fonts& fonts) {
    constexpr double air = 2 * lettering::label_gap;
    double sum = 0;
    for (std::size_t i = 0; i < std::min(figure.labels.size(), most_names); ++i) {
        const LabelRequest& request = figure.labels[i];
        const ShapedLine shaped = fonts.shape(request.text, request.size);
        sum += (shaped.width + air) * (shaped.ascent + shaped.descent + air);
    }
    return sum;
}

namespace {

/// Whether the figure's own group, which contains all others, is closed.
bool is_closed(const Figure& figure) {
    const auto begun = std::count_if(figure.marks.begin(), figure.marks.end(),
                                     [](const Mark& mark) { return std::holds_alternative<GroupBegin>(mark); });
    const auto ended = std::count_if(figure.marks.begin(), figure.marks.end(),
                                     [](const Mark& mark) { return std::holds_alternative<GroupEnd>(mark); });
    return figure.marks.size() >= 2 && std::holds_alternative<GroupBegin>(figure.marks.front()) &&
           std::holds_alternative<GroupEnd>(figure.marks.back()) && begun == ended;
}

constexpr double leader_dot = 0.38;  // its radius, mm

/// The leader ends on a named line, or at the edge of a point's symbol.
void draw_leader(std::vector<Mark>& marks, const Candidate& place, Colour colour) {
    const Spot from = place.leader_from;
    marks.emplace_back(line(from, place.leader_to, {0.18, colour, {}, false}));
    marks.emplace_back(disc(from, leader_dot, colour));
}

/// The circle round a number. On the tint of another body it is filled with the paper colour.
Path balloon_of(const LabelRequest& request, Spot centre, const Ground& ground) {
    Pen pen{0.35, request.colour, going_round(request.dashes, 2 * std::numbers::pi * request.balloon), false};
    const auto tint = request.ground ? ground.tint_at(centre) : std::nullopt;
    if (tint && tint->colour != request.ground->own)
        return ring(centre, request.balloon, request.ground->paper, std::move(pen));
    return circle(centre, request.balloon, std::move(pen));
}

void set_label(Figure& figure, const LabelRequest& request, const Candidate& place, ShapedLine shaped,
               const Ground& ground, Colour leaders) {
    const std::size_t own = figure.marks.size();
    if (place.leader) draw_leader(figure.marks, place, leaders), ++figure.leaders;
    const Spot centre = place.box.centre;
    if (request.balloon > 0) figure.marks.emplace_back(balloon_of(request, centre, ground));
    const std::size_t first = figure.marks.size();
    const Spot origin{centre.x - shaped.width / 2, centre.y + (shaped.ascent - shaped.descent) / 2};
    set_text(figure.marks, std::move(shaped), origin, request.colour, "label");
    for (std::size_t k = first; k < figure.marks.size(); ++k) {
        auto& text = std::get<TextMark>(figure.marks[k]);
        text.pivot = centre;
        text.angle = nearest::atan2(place.box.axis.y, place.box.axis.x);
        text.names = request.names;
        text.detail = request.detail;
        text.holds = request.holds;
        if (k > first) text.cls = "text";  // one aria-label per label
        if (k == first) text.in_file = request.in_file;
    }
    belong(figure.marks, own, request.statement);
    const Spot reach = place.box.reach();
    figure.box.min = {std::min(figure.box.min.x, centre.x - reach.x), std::min(figure.box.min.y, centre.y - reach.y)};
    figure.box.max = {std::max(figure.box.max.x, centre.x + reach.x), std::max(figure.box.max.y, centre.y + reach.y)};
}

void set_key(Figure& figure, const LabelKey& key, double measure) {
    const Spot at{figure.box.min.x, figure.box.max.y + above_key};
    const LabelKey::Lines lines = key.lines(at, measure);
    figure.marks.insert(figure.marks.end(), lines.marks.begin(), lines.marks.end());
    figure.box.max = {std::max(figure.box.max.x, at.x + lines.width), at.y + lines.height};
    figure.has_key = true;
}

}  // namespace

void drop_leader(std::vector<Mark>& marks, Colour leaders) {
    if (marks.size() < 2) return;
    const auto* dot = std::get_if<Path>(&marks.back());
    const auto* stroke = std::get_if<Path>(&marks[marks.size() - 2]);
    if (!dot || !dot->filled || dot->stroked || dot->fill != leaders) return;
    if (!stroke || !stroke->stroked || stroke->segments.size() != 2 || stroke->pen.colour != leaders) return;
    marks.resize(marks.size() - 2);
}

bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling) {
    return place_labels(figure, fonts, room, labelling, Theme{}.secondary);
}
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling, Colour leaders) {
    if (figure.labels.empty()) return true;
    const Ground ground(figure.marks, fonts);
    const bool boxed = figure.box.width() > 0 && figure.box.height() > 0;
    if (!boxed) figure.box = box_of(figure.marks);
    const double measure = std::max(figure.box.width(), room ? std::min(room->x, wide_key) : wide_key);
    const std::size_t names = std::min(figure.labels.size(), most_names);
    std::vector<LabelRequest> requests(figure.labels.begin(),
                                       figure.labels.begin() + static_cast<std::ptrdiff_t>(names));
    LabelKey key(fonts);
    std::optional<LabelSearch> search;
    // Removing labels may free places for others. A number without a place is dropped for good.
    for (;;) {
        std::optional<Spot> left = room;
        if (left && !key.empty())
            left->y = std::max(left->y - above_key - key.lines({}, measure).height, figure.box.height());
        search.emplace(requests, figure.box, fonts, ground, figure.strokes, left, labelling == Labelling::strict);
        if (!search->place(labelling == Labelling::if_it_fits ? left : std::nullopt, key.empty())) return false;
        if (labelling == Labelling::if_all_free && search->is_crowded()) return false;
        const std::vector<std::size_t> placeless = search->placeless();
        if (placeless.empty()) break;
        key.take(requests, placeless);
    }
    // Inside the figure's group, if that is closed already.
    const bool closed = is_closed(figure);
    if (closed) figure.marks.pop_back();
    const lettering::Bodies bodies(requests, figure.strokes);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const Candidate& place = search->chosen(i);
        if (!place.leader) continue;
        const Spot from = place.leader_from, to = place.leader_to;
        const BodyIndex body = requests[i].balloon > 0 ? none : requests[i].body;
        figure.leader_lines.push_back({from, to, body, bodies.led_astray(i, from, to) > 0});
    }
    for (std::size_t i = 0; i < requests.size(); ++i)
        set_label(figure, requests[i], search->chosen(i), search->take_shaped(i), ground, leaders);
    if (!key.empty()) set_key(figure, key, measure);
    if (closed) figure.marks.emplace_back(GroupEnd{});
    for (std::size_t i = names; i < figure.labels.size(); ++i)
        figure.unnamed.push_back(std::move(figure.labels[i].text));
    figure.labels.clear();
    figure.strokes.clear();
    return true;
}

}  // namespace kinegraph::render
