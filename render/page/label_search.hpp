// Label search: chooses a place for each label of a figure. Owns the assignment of places; independent of the ink, and
// does not draw the labels. Deterministic: every order is that of the figure, and ties go to the first.
//
// Method: greedy, the label with the fewest free places first, each at its cheapest place; then rounds of improvement
// with evictions. A label that still covers something moves to the nearest free fallback place, with a leader.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/label_boxes.hpp"
#include "render/page/label_ground.hpp"
#include "render/page/label_places.hpp"

namespace kinegraph::render::lettering {

class LabelSearch {
public:
    /// `box`: of the figure. `room`: available width and height. `strict`: no label may leave the room. Requests,
    /// strokes and ground must outlive this object.
    LabelSearch(const std::vector<LabelRequest>& requests, const Box& box, const Fonts& fonts, const Ground& ground,
                const std::vector<BodyStroke>& strokes, const std::optional<Spot>& room, bool strict);
    LabelSearch(const LabelSearch&) = delete;  // the places refer to members
    LabelSearch& operator=(const LabelSearch&) = delete;

    /// Places all labels. False if `only_within` (width and height of a room, mm) is given and they do not fit into it.
    /// `first`: the labels without a place are named elsewhere, and the others placed once more. Then a hopeless crowd
    /// is left as it first stands, since most of the time would go into what is placed anew.
    bool place(const std::optional<Spot>& only_within, bool first);

    /// Moves the shaped text out. Call once per label.
    ShapedLine take_shaped(std::size_t label) { return letters_[label].take(); }
    const Candidate& chosen(std::size_t label) const { return chosen_[label]; }
    /// Whether some label is in the way.
    bool is_crowded() const;
    /// Labels without an acceptable place: they cover something, leave the room or overlap another label. Of two that
    /// overlap, the one whose removal frees more of the others is listed.
    std::vector<std::size_t> placeless() const;

private:
    void improve(const std::vector<std::size_t>& order);
    void repair(const std::vector<std::size_t>& order);
    std::vector<std::size_t> least_free_first() const;

    void look_around(std::size_t i);
    double price_now(std::size_t i) const;
    std::optional<Candidate> best(std::size_t i, double least);

    /// A place that would cost less without one particular other label.
    struct Wish {
        std::size_t other;
        std::size_t place;
        double price;
    };
    void find_wishes(std::size_t i, double now);
    void wish_for(std::size_t i, std::size_t place, double now);
    bool evict(std::size_t i, int& looks_left);

    bool fits(Spot room) const;
    bool leaves_the_room(const Candidate& candidate) const;
    bool is_in_the_way(std::size_t i) const;
    bool is_hopeless() const;

    LabelSetting setting_;
    std::vector<Lettered> letters_;
    std::vector<LabelPlaces> places_;
    std::vector<Candidate> chosen_;
    // Scratch buffers, members only to reuse their memory.
    std::vector<std::size_t> around_;
    std::vector<std::pair<std::size_t, double>> met_;
    std::vector<Wish> wishes_;
};

}  // namespace kinegraph::render::lettering
