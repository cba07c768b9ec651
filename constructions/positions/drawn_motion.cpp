#include "constructions/positions/drawn_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kinegraph {
namespace {

/// Positions along a travel, its limits included.
class Travelling {
public:
    Travelling(const Positions& positions, const Travel& travel) : positions_(positions), travel_(travel) {}

    double coordinate(double share) const { return travel_.from + share * (travel_.to - travel_.from); }
    double size() const { return positions_.size(); }
    /// Null if the position cannot be reached. `share`: of the travel, from 0 to 1.
    const Positions* at(double share) {
        if (share == 0 && travel_.starts_at_limit) return limit(travel_.from, travel_.to - travel_.from);
        if (share == 1 && travel_.ends_at_limit) return limit(travel_.to, travel_.from - travel_.to);
        // A place as near to a limit as this cannot be distinguished from it.
        constexpr double nearest = 1e-7;
        const double inner =
            std::clamp(share, travel_.starts_at_limit ? nearest : 0.0, travel_.ends_at_limit ? 1 - nearest : 1.0);
        return positions_.move_to(coordinate(inner)) ? &positions_ : nullptr;
    }
    /// Whether the mechanism is in the same position at both ends.
    bool returns() {
        if (travel_.starts_at_limit || travel_.ends_at_limit) return false;
        Places first, last;
        for (const auto& [share, places] : {std::pair(0.0, &first), std::pair(1.0, &last)}) {
            const Positions* here = at(share);
            if (here == nullptr) return false;
            here->read(*places);
        }
        constexpr double same = 1e-6;
        for (std::size_t i = 0; i < first.points.size(); ++i)
            if (squared_length(first.points[i] - last.points[i]) > same * same * size() * size()) return false;
        return true;
    }

private:
    const Positions* limit(double at, double inward) {
        at_limit_ = positions_.at_limit(at, inward);
        return at_limit_ ? &*at_limit_ : nullptr;
    }

    Positions positions_;
    const Travel& travel_;
    std::optional<Positions> at_limit_;
};

/// Follows several points together.
class PathsPen {
public:
    PathsPen(const Positions& positions, const Travel& travel, const std::vector<TracedPoint>& traced)
        : travelling_(positions, travel), traced_(traced), paths_(traced.size()) {}

    std::vector<std::vector<PathPlaces>> run() && {
        constexpr int steps = 360;
        Sample last = at(0);
        begin(last);
        for (int i = 1; i <= steps; ++i) {
            const Sample next = at(static_cast<double>(i) / steps);
            if (last.places.empty() || next.places.empty())
                begin(next);
            else
                go_on(last, next, 0);
            last = next;
        }
        for (auto& pieces : paths_) {
            std::erase_if(pieces, [](const PathPlaces& piece) { return piece.size() < 2; });
            for (PathPlaces& piece : pieces)
                for (VectorOf<double>& place : piece) place = place + read_.origin;
        }
        return std::move(paths_);
    }

private:
    struct Sample {
        double share = 0;
        PathPlaces places;  ///< by traced point; empty: not reached
    };

    Sample at(double share) {
        Sample sample{share, {}};
        const Positions* here = travelling_.at(share);
        if (here == nullptr) return sample;
        here->read(read_);
        for (const TracedPoint& each : traced_)
            sample.places.push_back(here->seen_from(each.on, read_.points[at_index(each.point)]));
        return sample;
    }
    void begin(const Sample& sample) {
        if (sample.places.empty()) return;
        for (std::size_t k = 0; k < paths_.size(); ++k) paths_[k].push_back({sample.places[k]});
    }
    /// To the next sample, by halves until every chord is short and on its path.
    void go_on(const Sample& from, const Sample& to, int depth) {
        constexpr int deepest = 24;
        const Sample middle = depth < deepest ? at((from.share + to.share) / 2) : Sample{};
        if (!middle.places.empty() && !is_smooth(from, middle, to)) {
            go_on(from, middle, depth + 1);
            go_on(middle, to, depth + 1);
            return;
        }
        for (std::size_t k = 0; k < paths_.size(); ++k) paths_[k].back().push_back(to.places[k]);
    }
    bool is_smooth(const Sample& from, const Sample& middle, const Sample& to) const {
        constexpr double flat = 1e-4, longest = 0.02;  // shares of the drawing's size
        const double size = travelling_.size();
        for (std::size_t k = 0; k < paths_.size(); ++k) {
            const VectorOf<double> chord = to.places[k] - from.places[k], by = middle.places[k] - from.places[k];
            const double width = std::sqrt(squared_length(chord));
            if (width > longest * size) return false;
            // A path that turns back between two samples lies beyond the chord's ends.
            const double along = width > 0 ? std::clamp(dot(chord, by) / (width * width), 0.0, 1.0) : 0;
            if (squared_length(by - along * chord) > flat * flat * size * size) return false;
        }
        return true;
    }

    Travelling travelling_;
    const std::vector<TracedPoint>& traced_;
    std::vector<std::vector<PathPlaces>> paths_;
    Places read_;
};

}  // namespace

std::vector<OtherPosition> other_positions(const Positions& positions, const Travel& travel, int count) {
    Travelling travelling(positions, travel);
    const int steps = travelling.returns() ? count : std::max(count - 1, 1);
    std::vector<OtherPosition> found;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / steps;
        const Positions* here = travelling.at(share);
        if (here == nullptr) continue;
        OtherPosition& other = found.emplace_back(OtherPosition{travelling.coordinate(share), share, {}});
        for (std::size_t body = 0; body < here->bodies().size(); ++body)
            other.bodies.push_back(here->motion(BodyIndex(body)));
    }
    return found;
}

std::vector<std::vector<PathPlaces>> paths_of(const Positions& positions, const Travel& travel,
                                              const std::vector<TracedPoint>& traced) {
    if (traced.empty()) return {};
    return PathsPen(positions, travel, traced).run();
}

}  // namespace kinegraph
