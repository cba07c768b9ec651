// The travel of a driver: from where to where it goes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/mechanism/law_curve.hpp"

namespace kinegraph {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace

tl::expected<Travel, TravelFault> travel_of(const Positions& positions, bool turns, std::optional<double> from,
                                            std::optional<double> to) {
    Positions tried = positions;
    Travel travel;
    const auto note_change_points = [&] {
        for (const double each : tried.change_points())
            if (std::find(travel.change_points.begin(), travel.change_points.end(), each) == travel.change_points.end())
                travel.change_points.push_back(each);
    };
    const auto out_of_reach = [&](double wanted) {
        return tl::unexpected(TravelFault{wanted, tried.limit().value_or(tried.coordinate())});
    };
    for (const std::optional<double>& end : {from, to})
        if (end && !positions.is_near(*end)) return tl::unexpected(TravelFault{*end, {}, true});
    // By default to the limits; a full turn at most if both ends are free.
    const double far = turns ? 64 * full_turn : 100 * positions.size();
    if (from) {
        if (!tried.move_to(*from)) return out_of_reach(*from);
        travel.from = *from;
    }
    if (to) {
        if (!tried.move_to(*to)) return out_of_reach(*to);
        travel.to = *to;
    } else {
        const double wanted = turns ? (from ? *from : 0) + full_turn : far;
        travel.ends_at_limit = !tried.move_to(wanted);
        if (!travel.ends_at_limit && !turns) return tl::unexpected(TravelFault{});
        travel.to = travel.ends_at_limit ? *tried.limit() : wanted;
        travel.ends_far = travel.ends_at_limit && tried.is_limit_far();
    }
    note_change_points();
    if (!from && !to && travel.ends_at_limit) {
        tried = positions;
        travel.starts_at_limit = !tried.move_to(-far);
        if (!travel.starts_at_limit) return tl::unexpected(TravelFault{});
        travel.from = *tried.limit();
        travel.starts_far = tried.is_limit_far();
        note_change_points();
    }
    std::sort(travel.change_points.begin(), travel.change_points.end());
    std::erase_if(travel.change_points, [&](double each) {
        return each < std::min(travel.from, travel.to) - 1e-9 || each > std::max(travel.from, travel.to) + 1e-9;
    });
    return travel;
}

tl::expected<Travel, TravelFault> travel_of_law(const Positions& positions, const Law& law, std::optional<double> from,
                                                std::optional<double> to) {
    const LawCurve curve(law);
    const double drawn = law.drawn.to_double(), way = curve.at(drawn).s;
    Travel travel;
    travel.times = {from.value_or(0 - drawn), to.value_or(law.length() - drawn)};
    // The extremes are at the ends of the law, or where two pieces meet.
    const auto [first, last] = std::minmax({travel.times->first + drawn, travel.times->second + drawn});
    std::vector<double> turning_points{curve.at(first).s - way, curve.at(last).s - way};
    double end = 0;
    for (const LawPiece& piece : law.pieces) {
        end += piece.over.to_double();
        if (end > first && end < last) turning_points.push_back(curve.at(end).s - way);
    }
    const auto [least, most] = std::minmax_element(turning_points.begin(), turning_points.end());
    travel.from = *least;
    travel.to = *most;
    Positions tried = positions;
    for (const double each : {travel.from, travel.to})
        if (!positions.is_near(each)) return tl::unexpected(TravelFault{each, {}, true});
    for (const double each : {travel.from, travel.to})
        if (!tried.move_to(each)) return tl::unexpected(TravelFault{each, tried.limit().value_or(tried.coordinate())});
    travel.change_points = tried.change_points();
    std::sort(travel.change_points.begin(), travel.change_points.end());
    return travel;
}

std::optional<std::pair<Positions, Travel>> own_travel(const Mechanism& mechanism, const Pose& pose) {
    if (mechanism.drivers.empty()) return std::nullopt;
    auto positions = Positions::of(mechanism, pose, Course{0});
    if (!positions) return std::nullopt;
    const Driver& driver = mechanism.drivers.front();
    const Law* law = law_of(driver);
    const auto travel = law != nullptr ? travel_of_law(*positions, *law, std::nullopt, std::nullopt)
                                       : travel_of(*positions, turns(driver), std::nullopt, std::nullopt);
    if (!travel) return std::nullopt;
    return std::pair{*std::move(positions), *travel};
}

}  // namespace kinegraph
