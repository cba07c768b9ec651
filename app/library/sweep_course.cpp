#include "app/library/sweep_course.hpp"

#include <algorithm>
#include <tuple>

#include "app/library/driver_choice.hpp"
#include "constructions/positions/cycle.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph::app {
namespace {

/// Adds the drivers that move with the first one, each with its step.
std::optional<Words> add_along(const SweepOptions& options, const Mechanism& mechanism, AskedCourse& asked) {
    if (options.along.empty()) return std::nullopt;
    const std::string& dashes = options.dashes;
    const int first = asked.course.driver;
    if (law_of(mechanism, first) != nullptr)
        return Words(lang::sweeps::step_driver_has_a_law, dashes, name_of_driver(mechanism, first));
    if (!asked.to && !turns(mechanism, first))
        return Words(lang::sweeps::step_counts_the_steps_of_driver, dashes, name_of_driver(mechanism, first));
    const Exact from = asked.from.value_or(0);
    const Exact way = asked.to ? *asked.to - from : 2 * pi();
    for (const DriverAlong& each : options.along) {
        const auto driver = driver_named(mechanism, each.driver, dashes);
        if (!driver) return driver.error();
        const auto is_taken = [&](const Course::Along& other) { return other.driver == *driver; };
        if (*driver == first || std::any_of(asked.course.along.begin(), asked.course.along.end(), is_taken))
            return Words(lang::sweeps::driver_is_given_twice, dashes, each.driver);
        const auto step = coordinate_of(mechanism, *driver, each.step);
        if (!step) return dashes + "step " + step.error();
        asked.course.along.push_back({*driver, *step * Exact::from_double(static_cast<double>(options.steps)) / way});
    }
    return std::nullopt;
}

}  // namespace

tl::expected<AskedCourse, Words> course_asked(const SweepOptions& options, const Mechanism& mechanism) {
    const std::string& dashes = options.dashes;
    AskedCourse asked;
    const auto driver = driver_named(mechanism, options.driver, dashes);
    if (!driver) return tl::unexpected(driver.error());
    asked.course = course_of(*driver, options.branch);
    const bool has_law = law_of(mechanism, *driver) != nullptr;
    for (const auto& [text, option, value] :
         {std::tuple(&options.from, "from ", &asked.from), std::tuple(&options.to, "to ", &asked.to)}) {
        if (text->empty()) continue;
        const auto read = has_law ? time_of(*text) : coordinate_of(mechanism, *driver, *text);
        if (!read) return tl::unexpected(dashes + option + read.error());
        *value = *read;
    }
    if (asked.from && asked.to && *asked.from == *asked.to)
        return tl::unexpected(Words(lang::sweeps::from_and_to_are_the_same_position, dashes));
    if (options.steps < 2) return tl::unexpected(Words(lang::common::at_least_2_steps, dashes));
    if (const auto wrong = add_along(options, mechanism, asked)) return tl::unexpected(*wrong);
    return asked;
}

tl::expected<Travel, Words> travel_asked(const Positions& positions, const Mechanism& mechanism,
                                         const AskedCourse& asked, const std::string& dashes) {
    const int driver = asked.course.driver;
    const auto in_doubles = [](const std::optional<Exact>& value) {
        return value ? std::optional(value->to_double()) : std::nullopt;
    };
    const std::optional<double> from = in_doubles(asked.from), to = in_doubles(asked.to);
    const Law* law = law_of(mechanism, driver);
    const auto travel = law != nullptr ? travel_of_law(positions, *law, from, to)
                                       : travel_of(positions, turns(mechanism, driver), from, to);
    if (travel) return *travel;
    const TravelFault& fault = travel.error();
    const std::string name = name_of_driver(mechanism, driver);
    if (fault.is_too_far) return tl::unexpected(too_far(coordinate_text(mechanism, driver, fault.wanted), name));
    if (!fault.limit) return tl::unexpected(Words(lang::sweeps::driver_has_no_limit_give, name, dashes));
    return tl::unexpected(out_of_reach(coordinate_text(mechanism, driver, fault.wanted), name,
                                       coordinate_text(mechanism, driver, *fault.limit)));
}

}  // namespace kinegraph::app
