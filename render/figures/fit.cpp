// Implementation of fit.hpp.
#include "render/figures/fit.hpp"

#include "engine/number/assert.hpp"

namespace kinegraph::render {
namespace {

bool has_room(const FitPolicy& policy, const Figure& figure) {
    return !policy.room || (figure.box.width() <= policy.room->x && figure.box.height() <= policy.room->y);
}
bool is_last(const FitPolicy& policy, const Trial& trial) {
    if (policy.extent > 0) return policy.extent / next_scale(trial.scale) < policy.least_shown;
    return trial.number == policy.most_trials;
}

}  // namespace

double first_scale(Spot extents, Spot room, double finest) {
    if (finest > 0 && extents.x <= finest * room.x && extents.y <= finest * room.y) return finest;
    return std::max(choose_scale(extents.x, extents.y, room.x, room.y, std::nullopt), finest);
}

Figure fit(const FitPolicy& policy, const std::function<std::optional<Figure>(const Trial&)>& draw) {
    if (policy.asked) {
        auto figure = draw({*policy.asked, 0, false, false, true});
        if (figure && has_room(policy, *figure)) return *std::move(figure);
    }
    double half = 0;  // half the scale at which the figure without names has room; 0: not reached yet
    Trial trial;
    for (trial.scale = policy.first;; trial.scale = next_scale(trial.scale), ++trial.number) {
        trial.last = is_last(policy, trial);
        const bool is_small = half > 0 && trial.scale > 0.99 * half;
        trial.strict = policy.strict || is_small;
        const bool as_it_comes = trial.last || is_small;
        if (policy.exactly && trial.number > 0) return Figure::empty_at(any_scale);
        auto figure = draw(trial);
        KG_ASSERT(figure || !trial.last, "the last trial has a figure");
        if (figure && (as_it_comes || has_room(policy, *figure))) return *std::move(figure);
        const bool labelled = figure && figure->labels.empty();
        if (policy.names_stay_in_room && labelled && half == 0) half = 2 * trial.scale;
    }
}

}  // namespace kinegraph::render
