// Design values of a cam over its whole turn: pressure angle, curvature, corners, and undercutting.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mechanism/cam.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;
constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double same_turn = 1e-12;  // much finer than any piece of a law: a rotation this close to a corner has the
                                     // state after it

bool is_flat(const Cam& cam) { return cam.follower.face == Follower::Face::flat; }

/// Compares a contact with all positions of the follower: a contact inside another position is cut away.
class Undercut {
public:
    Undercut(const Cam& cam, const CamGeometry& geometry)
        : geometry_(geometry),
          roller_(cam.follower.radius.to_double()),
          is_flat_(is_flat(cam)),
          is_edge_(cam.follower.face == Follower::Face::knife_edge),
          nothing_(1e-9 * cam.base_circle.to_double()) {
        for (int i = 0; i < positions; ++i) others_.push_back(other(whole_turn * i / positions));
        largest_step_ = largest_step();
    }

    /// Decided by curvature alone: a convex pitch curve with a smaller radius than the roller, a flat face whose
    /// envelope turns back.
    bool is_tight(const CamState& state) const {
        if (is_flat_) return state.curvature <= 0 || !std::isfinite(state.curvature);
        return state.pitch_curvature * roller_ >= 1;
    }
    /// Decided by the sampled positions.
    bool is_cut(const CamState& state) const {
        if (is_edge_) return false;
        if (is_tight(state)) return true;
        const Spot contact = on_cam(state, state.contact);
        return std::any_of(others_.begin(), others_.end(),
                           [&](const Other& each) { return depth_in(each, contact) > nothing_; });
    }
    /// The boundary between rotations a (not cut, unless `cut_first`) and b (the opposite), to 1e-10 rad.
    double end_between(double a, double b, bool cut_first) const {
        while (std::abs(b - a) > 1e-10) {
            const double middle = (a + b) / 2;
            (is_cut_between_positions(middle) == cut_first ? a : b) = middle;
        }
        return (a + b) / 2;
    }

private:
    static constexpr int positions = 1440;
    /// A follower in the cam's own frame: the roller's centre, or a face X·normal = height.
    struct Other {
        Spot centre, normal;
        double height = 0;
    };

    double within_turn(double turn) const { return turn - whole_turn * std::floor(turn / whole_turn); }
    Spot on_cam(const CamState& state, const Spot& place) const { return state.on_cam(place, geometry_.sense()); }
    Other other(double turn) const {
        const CamState state = geometry_.at(within_turn(turn));
        return {on_cam(state, state.trace), on_cam(state, state.outward), dot(state.outward, state.contact)};
    }
    double depth_in(const Other& each, const Spot& contact) const {
        if (is_flat_) return dot(each.normal, contact) - each.height;
        const Spot apart = contact - each.centre;
        // Distant rollers need no square root.
        if (dot(apart, apart) > roller_ * roller_) return 0;
        return roller_ - nearest::hypot(apart.x, apart.y);
    }
    /// Searches the deepest position near each sample that is deeper than its neighbours.
    bool is_cut_between_positions(double turn) const {
        const CamState state = geometry_.at(within_turn(turn));
        if (is_tight(state)) return true;
        const Spot contact = on_cam(state, state.contact);
        const auto gap = [&](const Other& each) {
            if (is_flat_) return each.height - dot(each.normal, contact);
            const Spot apart = contact - each.centre;
            return nearest::hypot(apart.x, apart.y) - roller_;
        };
        std::vector<double> gaps;
        for (const Other& each : others_) gaps.push_back(gap(each));
        // Between two samples a follower is deeper by at most a small share of its displacement between them.
        const double near = largest_step_;
        for (int i = 0; i < positions; ++i) {
            const auto at = [&](int k) { return gaps[static_cast<std::size_t>((k + positions) % positions)]; };
            if (at(i) > near || at(i) > at(i - 1) || at(i) > at(i + 1)) continue;
            double low = whole_turn * (i - 1) / positions, high = whole_turn * (i + 1) / positions;
            for (int round = 0; round < 40; ++round) {
                const double a = low + (high - low) / 3, b = high - (high - low) / 3;
                (gap(other(a)) < gap(other(b)) ? high : low) = gap(other(a)) < gap(other(b)) ? b : a;
            }
            if (gap(other((low + high) / 2)) < -nothing_) return true;
        }
        return false;
    }
    double largest_step() const {
        double largest = 0;
        for (int i = 0; i < positions; ++i) {
            const Other &a = others_[static_cast<std::size_t>(i)],
                        &b = others_[static_cast<std::size_t>((i + 1) % positions)];
            const Spot way = b.centre - a.centre;
            largest = std::max(largest, nearest::hypot(way.x, way.y));
        }
        return largest;
    }

    const CamGeometry& geometry_;
    double roller_;
    bool is_flat_, is_edge_;
    double nothing_;  ///< m: a smaller depth of cut is rounding
    std::vector<Other> others_;
    double largest_step_ = 0;  ///< m, between neighbours of `others_`
};

std::vector<CamCorner> corners_of(const Cam& cam, const CamGeometry& geometry) {
    std::vector<CamCorner> corners;
    for (const LawBreak& each : breaks_of_cycle(cam.law)) {
        if (!each.of_speed) continue;
        CamCorner corner{geometry.at(each.at, each.before), geometry.at(each.at, each.after)};
        // The pitch curve is traversed clockwise as the rotation of a counter-clockwise cam increases: convex where its
        // normal rotates in that sense too. The contact of a flat face moves on along the face as long as the normal
        // does.
        const Spot forth = corner.after.contact - corner.before.contact;
        const double goes = is_flat(cam) ? dot(forth, quarter_turn(corner.after.outward))
                                         : cross(corner.before.outward, corner.after.outward);
        const bool turns_back = is_flat(cam) ? geometry.sense() * goes > 0 : geometry.sense() * goes < 0;
        corner.is_cut = turns_back && cam.follower.face != Follower::Face::knife_edge;
        corners.push_back(corner);
    }
    return corners;
}

struct Judged {
    double turn;
    bool is_cut;
};

/// From the sampled rotations, in order; the first and the last are one position.
std::vector<std::array<double, 2>> ranges_of(const std::vector<Judged>& judged, const Undercut& undercut) {
    std::vector<std::array<double, 2>> ranges;
    for (std::size_t i = 0; i < judged.size(); ++i) {
        if (!judged[i].is_cut) continue;
        const double from = i == 0 ? 0 : undercut.end_between(judged[i - 1].turn, judged[i].turn, false);
        while (i + 1 < judged.size() && judged[i + 1].is_cut) ++i;
        const bool is_last = i + 1 == judged.size();
        ranges.push_back(
            {from, is_last ? judged[i].turn : undercut.end_between(judged[i].turn, judged[i + 1].turn, true)});
    }
    if (ranges.size() > 1 && judged.front().is_cut && judged.back().is_cut) {
        ranges.back()[1] = ranges.front()[1];
        ranges.erase(ranges.begin());
    }
    return ranges;
}

class Summary {
public:
    Summary(const Cam& cam, const CamGeometry& geometry) : cam_(cam), geometry_(geometry), undercut_(cam, geometry) {
        found_.corners = corners_of(cam, geometry);
    }

    CamSummary of_turn() && {
        // Curvature is a closed form; comparing a position with all others takes a thousand times as long.
        constexpr int samples = 7200, every = 5;
        const double length = cam_.law.length();
        auto corner = found_.corners.begin();
        std::vector<Judged> judged;
        for (int i = 0; i <= samples; ++i) {
            const double turn = length * i / samples;
            for (; corner != found_.corners.end() && corner->after.turn <= turn + same_turn; ++corner)
                take(*corner, judged);
            take(geometry_.at(turn), i % every == 0, judged);
        }
        // The law's beginning and its end are the same corner.
        if (!found_.corners.empty() && found_.corners.front().after.turn == 0)
            judged.back().is_cut |= found_.corners.front().is_cut;
        found_.undercuts = ranges_of(judged, undercut_);
        return std::move(found_);
    }

private:
    void take(const CamCorner& corner, std::vector<Judged>& judged) {
        measure(corner.before);
        measure(corner.after);
        if (corner.is_cut) judged.push_back({corner.after.turn, true});
    }
    void take(const CamState& here, bool is_held_against_all, std::vector<Judged>& judged) {
        measure(here);
        const bool is_tight = undercut_.is_tight(here);
        if (is_tight || is_held_against_all) judged.push_back({here.turn, undercut_.is_cut(here)});
        if (!is_tight) measure_curvature(here);
    }
    void measure(const CamState& here) {
        if (std::abs(here.pressure_angle) > found_.most_pressure) {
            found_.most_pressure = std::abs(here.pressure_angle);
            found_.most_pressure_at = here.turn;
        }
        if (!is_flat(cam_)) return;
        const double along = cross(here.outward, here.contact);
        if (!found_.face) found_.face = {along, along};
        found_.face = {std::min((*found_.face)[0], along), std::max((*found_.face)[1], along)};
    }
    void measure_curvature(const CamState& here) {
        const double radius = std::abs(1 / here.curvature);
        auto& least = here.curvature > 0 ? found_.least_convex : found_.least_concave;
        if (here.curvature == 0 || (least && radius >= *least)) return;
        least = radius;
        (here.curvature > 0 ? found_.least_convex_at : found_.least_concave_at) = here.turn;
    }

    const Cam& cam_;
    const CamGeometry& geometry_;
    Undercut undercut_;
    CamSummary found_;
};

}  // namespace

CamSummary summary_of(const Cam& cam, const CamGeometry& geometry) { return Summary(cam, geometry).of_turn(); }

std::vector<VectorOf<double>> working_profile(const Cam& cam, const CamGeometry& geometry, int positions) {
    const std::vector<CamCorner> corners = corners_of(cam, geometry);
    std::vector<Spot> profile;
    const auto add = [&](const CamState& state, const Spot& place) {
        profile.push_back(state.on_cam(place, geometry.sense()));
    };
    const auto round = [&](const CamCorner& corner) {
        add(corner.before, corner.before.contact);
        constexpr double step = 2 * std::numbers::pi / 180;
        const Spot from = corner.before.outward, to = corner.after.outward;
        const double angle = nearest::atan2(cross(from, to), dot(from, to)), radius = cam.follower.radius.to_double();
        const int steps = is_flat(cam) || radius == 0 ? 0 : static_cast<int>(std::abs(angle) / step);
        for (int k = 1; k <= steps; ++k) {
            const double turned = angle * k / (steps + 1);
            add(corner.before, corner.before.trace -
                                   radius * (nearest::cos(turned) * from + nearest::sin(turned) * quarter_turn(from)));
        }
        add(corner.after, corner.after.contact);
    };
    auto corner = corners.begin();
    for (int i = 0; i <= positions; ++i) {
        const double turn = whole_turn * i / positions;
        for (; corner != corners.end() && corner->after.turn <= turn + same_turn; ++corner) round(*corner);
        const CamState state = geometry.at(turn);
        if (std::isfinite(state.curvature)) add(state, state.contact);
    }
    return profile;
}

}  // namespace kinegraph
