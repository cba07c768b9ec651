// Near places: which of the places that belong to a drawing (centres, points of concurrency) it takes in. The others
// leave it with an arrow and their distance, so that they do not shrink what is drawn.
#pragma once

#include <algorithm>
#include <vector>

#include "render/ink/spot.hpp"

namespace kinegraph::render::drawing {

/// The mechanism keeps two thirds of its longer side.
constexpr double growth_for_places = 1.5;

/// The box with the places, nearest first, that leave its longer side at `most` or less.
inline Box with_near_places(const Box& own, std::vector<Spot> places, double most) {
    const auto away = [&own](Spot place) {
        return std::max({own.min.x - place.x, place.x - own.max.x, own.min.y - place.y, place.y - own.max.y, 0.0});
    };
    std::stable_sort(places.begin(), places.end(), [&](Spot a, Spot b) { return away(a) < away(b); });
    Box all = own;
    for (const Spot place : places) {
        Box wider = all;
        wider.include(place);
        if (std::max(wider.width(), wider.height()) <= std::max(most, std::max(all.width(), all.height()))) all = wider;
    }
    return all;
}

}  // namespace kinegraph::render::drawing
