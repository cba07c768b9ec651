// Label search: which of its places each label of a figure takes. Owns who stands where, and settles it among the
// labels; knows no ink, and does not set what it has placed. Deterministic: all orders are those of the figure, all
// ties go to the first.
//
// Method: the least free label first, each at its cheapest place, then rounds of improvement with evictions. What still
// covers something then is moved to the nearest room that is free, with a leader.
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
    /// For labels of a figure with that box on that ground, where they have a room (width and height) of that size;
    /// strict: none may leave it. Requests and ground must outlive it.
    LabelSearch(const std::vector<LabelRequest>& requests, const Box& box, const Fonts& fonts, const Ground& ground,
                const std::optional<Spot>& room, bool strict);
    LabelSearch(const LabelSearch&) = delete;  // its places refer to it
    LabelSearch& operator=(const LabelSearch&) = delete;

    /// False where `only_within` (the width and height of a room) is given and they do not fit into it.
    bool place(const std::optional<Spot>& only_within);

    /// To be set, once.
    ShapedLine take_shaped(std::size_t label) { return letters_[label].take(); }
    const Candidate& chosen(std::size_t label) const { return chosen_[label]; }
    /// Whether some label is in the way.
    bool is_crowded() const;
    /// The labels for which no place was found: they cover something, or stand where they may not, or in each other's
    /// way. Of two that do the one goes that frees more of the others.
    std::vector<std::size_t> placeless() const;

private:
    void improve(const std::vector<std::size_t>& order);
    void repair(const std::vector<std::size_t>& order);
    std::vector<std::size_t> least_free_first() const;

    void look_around(std::size_t i);
    double price_now(std::size_t i) const;
    std::optional<Candidate> best(std::size_t i, double least);

    /// A place that would cost less if one other label were not there.
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

    LabelSetting setting_;
    std::vector<Lettered> letters_;
    std::vector<LabelPlaces> places_;
    std::vector<Candidate> chosen_;
    // Of one look at one label, kept for their memory.
    std::vector<std::size_t> around_;
    std::vector<std::pair<std::size_t, double>> met_;
    std::vector<Wish> wishes_;
};

}  // namespace kinegraph::render::lettering
