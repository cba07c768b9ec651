// The least transmission angle of a mechanism over its travel.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/couplers.hpp"

namespace kinegraph {

namespace {

constexpr double no_angle = std::numbers::pi;  ///< where the position is not reached

class LeastTransmission {
public:
    LeastTransmission(std::vector<Coupler> couplers, const Positions& positions, const Travel& travel)
        : couplers_(std::move(couplers)), positions_(positions), travel_(travel) {}

    std::optional<Transmission> least() {
        sample();
        std::vector<std::size_t> order(couplers_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return least_[a].least < least_[b].least; });
        std::optional<Transmission> found;
        // Between two samples an angle falls by less than this below the smaller one; couplers of a parallel linkage
        // have the same angle throughout.
        constexpr double most_below = 0.05, same = 1e-9;
        const Transmission* before = nullptr;
        for (const std::size_t coupler : order) {
            const Transmission& sampled = least_[coupler];
            if (found && sampled.least - most_below >= found->least) break;
            const bool is_known =
                before != nullptr && before->at == sampled.at && std::abs(before->least - sampled.least) < same;
            before = &sampled;
            if (is_known) continue;
            if (const Transmission refined = between_samples(coupler); !found || refined.least < found->least)
                found = refined;
        }
        return found;
    }

private:
    /// The angles of all couplers in one position.
    std::vector<double> angles(Positions& there, double coordinate) {
        if (!there.move_to(coordinate)) return std::vector<double>(couplers_.size(), no_angle);
        there.read(places_);
        std::vector<double> all;
        for (const Coupler& each : couplers_) all.push_back(transmission_angle(each, places_));
        return all;
    }
    /// As in at_limit(): by two positions near it, of a copy: from a limit no other position is reached.
    std::vector<double> angles_at_limit(double limit, double inward) {
        constexpr double near = 1e-6;
        Positions there = positions_;
        std::vector<double> far = angles(there, limit + 4 * near * inward);
        const std::vector<double> close = angles(there, limit + near * inward);
        for (std::size_t i = 0; i < far.size(); ++i)
            far[i] = std::max(far[i], close[i]) < no_angle ? std::max(2 * close[i] - far[i], 0.0) : no_angle;
        return far;
    }

    /// The smallest of the angles of each coupler at even steps.
    void sample() {
        for (const Coupler& each : couplers_) least_.push_back({each.body, each.follower, each.pin, no_angle, 0});
        const double way = travel_.to - travel_.from;
        for (int i = 0; i <= samples; ++i) {
            const double coordinate = i == samples ? travel_.to : travel_.from + i * step();
            const std::vector<double> here = i == 0 && travel_.starts_at_limit ? angles_at_limit(travel_.from, way)
                                             : i == samples && travel_.ends_at_limit ? angles_at_limit(travel_.to, -way)
                                                                                     : angles(positions_, coordinate);
            for (std::size_t k = 0; k < here.size(); ++k)
                if (here[k] < least_[k].least) least_[k].least = here[k], least_[k].at = coordinate;
        }
    }

    /// Between the neighbours of the smallest sample there is one minimum.
    Transmission between_samples(std::size_t coupler) {
        const auto angle = [&](double coordinate) -> double {
            if (!positions_.move_to(coordinate)) return no_angle;
            positions_.read(places_);
            return transmission_angle(couplers_[coupler], places_);
        };
        Transmission found = least_[coupler];
        const double low_end = std::min(travel_.from, travel_.to), high_end = std::max(travel_.from, travel_.to);
        double low = std::max(found.at - std::abs(step()), low_end),
               high = std::min(found.at + std::abs(step()), high_end);
        for (int i = 0; i < 60; ++i) {
            const double third = (high - low) / 3;
            const bool falls = angle(low + third) >= angle(high - third);
            (falls ? low : high) = falls ? low + third : high - third;
        }
        const double middle = (low + high) / 2;
        if (const double here = angle(middle); here < found.least) found.least = here, found.at = middle;
        return found;
    }
    double step() const { return (travel_.to - travel_.from) / samples; }

    static constexpr int samples = 360;
    std::vector<Coupler> couplers_;
    Positions positions_;
    Travel travel_;
    Places places_;
    std::vector<Transmission> least_;  ///< by coupler
};

}  // namespace

std::optional<Transmission> transmission_of(const Mechanism& mechanism, const Positions& positions, int driver,
                                            const Travel& travel) {
    return LeastTransmission(couplers_of(mechanism, driver), positions, travel).least();
}

}  // namespace kinegraph
