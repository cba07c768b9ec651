#include "engine/mechanism/drivers.hpp"

namespace kinegraph {

Rates rates_of(const Driver& driver) {
    return std::visit(
        [](const auto& given) -> Rates {
            if constexpr (requires { given.omega; }) {
                return {given.omega, given.alpha};
            } else {
                return {given.speed, given.acceleration};
            }
        },
        driver);
}

Driver with_rates(Driver driver, const Rates& rates) {
    std::visit(
        [&](auto& given) {
            if constexpr (requires { given.omega; }) {
                given.omega = rates.first;
                given.alpha = rates.second;
            } else {
                given.speed = rates.first;
                given.acceleration = rates.second;
            }
        },
        driver);
    return driver;
}

const std::string& where_of(const Driver& driver) {
    return std::visit([](const auto& given) -> const std::string& { return given.where; }, driver);
}

const Law* law_of(const Driver& driver) {
    return std::visit([](const auto& given) { return given.law ? &*given.law : nullptr; }, driver);
}

tl::expected<Rates, std::pair<double, double>> rates_at(const Law& law, double coordinate) {
    const double drawn = law.at(law.drawn.to_double()).s;
    const auto time = law.when(drawn + coordinate);
    if (!time) {
        const auto [least, most] = law.range();
        return tl::unexpected(std::pair(least - drawn, most - drawn));
    }
    const LawState state = law.at(*time);
    return Rates{Exact::from_double(state.first), Exact::from_double(state.second)};
}

bool turns(const Driver& driver) { return std::holds_alternative<SpinDriver>(driver); }

}  // namespace kinegraph
