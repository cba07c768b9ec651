
#include <optional>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/positions.hpp"
#include "engine/motion/repositioned.hpp"
#include "lang/keys/library.hpp"
#include "lang/keys/notation.hpp"
#include "render/text/language.hpp"

namespace kinegraph::app {
namespace {

/// A requested position: the driver's coordinate, exact, and as text.
struct AskedPosition {
    Exact coordinate;
    Words text;
    std::optional<Rates> rates;  ///< of a driver with a law
};
/// For a driver with a law: its rates when it first reaches a coordinate.
tl::expected<std::optional<Rates>, Words> rates_of_law(const Mechanism& mechanism, int driver,
                                                       const Exact& coordinate) {
    const Law* law = law_of(mechanism, driver);
    if (law == nullptr) return std::nullopt;
    const auto rates = rates_at(*law, coordinate.to_double());
    if (rates) return *rates;
    const auto text = [&](double end) { return coordinate_text(mechanism, driver, end); };
    return tl::unexpected(Words(lang::library::the_law_of_driver_goes, text(coordinate.to_double()),
                                name_of_driver(mechanism, driver), text(rates.error().first),
                                text(rates.error().second)));
}
/// Reads a time of the law, zero in the position of the file; empty if the text is no time.
std::optional<AskedPosition> asked_by_time(const Law& law, const std::string& text) {
    const auto written = read_quantity(text, QuantityKind::time);
    if (!written || written->unit->kind != QuantityKind::time) return std::nullopt;
    const double drawn = law.drawn.to_double();
    const LawState here = law.at(drawn + written->in_si().to_double());
    return AskedPosition{Exact::from_double(here.s - law.at(drawn).s), time_text(written->in_si().to_double()),
                         Rates{Exact::from_double(here.first), Exact::from_double(here.second)}};
}
tl::expected<std::vector<AskedPosition>, Words> positions_asked(const PositionsWanted& wanted,
                                                                const Mechanism& mechanism, int driver) {
    constexpr std::size_t most = 720;
    const std::string& dashes = wanted.dashes;
    std::vector<AskedPosition> all;
    std::optional<Words> beyond;
    const auto add = [&](const Exact& coordinate) {
        const auto rates = rates_of_law(mechanism, driver, coordinate);
        if (rates)
            all.push_back({coordinate, coordinate_text(mechanism, driver, coordinate.to_double()), *rates});
        else if (!beyond)
            beyond = rates.error();
    };
    for (const std::string& text : wanted.at) {
        if (const Law* law = law_of(mechanism, driver)) {
            if (auto timed = asked_by_time(*law, text)) {
                all.push_back(*std::move(timed));
                continue;
            }
        }
        const bool every = text.starts_with("every ");
        const auto read = coordinate_of(mechanism, driver, every ? text.substr(6) : text);
        if (!read) return tl::unexpected(Words(dashes + "at") + lang::notation::colon + read.error());
        if (!every) {
            add(*read);
            continue;
        }
        if (!turns(mechanism, driver))
            return tl::unexpected(Words(lang::library::at_a_slide_has_no_whole, dashes, text));
        if (read->sign() <= 0 || *read * Exact(static_cast<int>(most)) < 2 * pi())
            return tl::unexpected(Words(lang::library::at_a_turn_is_divided, dashes, text, std::to_string(most)));
        for (Exact turn = 0; turn < 2 * pi(); turn += *read) add(turn);
    }
    if (beyond) return tl::unexpected(Words(dashes + "at ") + *beyond);
    if (all.size() > most)
        return tl::unexpected(Words(lang::library::at_at_most_positions, dashes, std::to_string(most)));
    return all;
}

/// Adds the position to the title of the sheet.
void name_position(Mechanism& mechanism, const std::string& driver, const Words& turn) {
    Words& title = mechanism.title;
    if (title.empty()) title = mechanism.source;
    title += Words(lang::library::name_with_value, driver, turn);
}

}  // namespace

Result<std::vector<Solution>> solved_positions(const Mechanism& mechanism, const PositionsWanted& wanted,
                                               Arithmetic arithmetic) {
    const std::string& dashes = wanted.dashes;
    const auto wrong = [&](const Words& why, ErrorCode code = ErrorCode::bad_input) {
        return tl::unexpected(Errors{{code, "", why}});
    };
    const auto driver = driver_named(mechanism, wanted.driver, dashes);
    if (!driver) return wrong(driver.error());
    const auto asked = positions_asked(wanted, mechanism, *driver);
    if (!asked) return wrong(asked.error());
    const auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(pose.error());
    auto positions = Positions::of(mechanism, *pose, course_of(*driver, wanted.branch));
    if (!positions) return tl::unexpected(positions.error());
    const Mover mover(mechanism, *pose);
    const std::string name = name_of_driver(mechanism, *driver);
    std::vector<Solution> solutions;
    for (const auto& [coordinate, text, rates] : *asked) {
        const auto put_rates = [&, &rates = rates](Mechanism& there) {
            if (rates) there.drivers[at_index(*driver)] = with_rates(there.drivers[at_index(*driver)], *rates);
        };
        if (coordinate.is_zero()) {
            Mechanism as_drawn = mechanism;
            put_rates(as_drawn);
            auto drawn = solve(std::move(as_drawn), arithmetic);
            if (!drawn) return tl::unexpected(drawn.error());
            solutions.push_back(*std::move(drawn));
        } else {
            Positions here = *positions;
            if (!here.is_near(coordinate.to_double()))
                return wrong(Words(dashes + "at") + lang::notation::colon + too_far(text, name));
            if (!here.move_to(coordinate.to_double()))
                return wrong(Words(dashes + "at") + lang::notation::colon +
                             out_of_reach(text, name, coordinate_text(mechanism, *driver, here.limit().value_or(0))));
            std::optional<Repositioned> moved =
                here.is_singular() ? mover.moved_across(here, coordinate) : mover.moved(here, coordinate);
            if (!moved) return wrong({lang::library::at_at_the_mechanism, dashes, text}, ErrorCode::no_unique_answer);
            put_rates(moved->mechanism);
            const FinerPose finer = [pose = std::move(moved->finer)] { return pose; };
            solutions.push_back(solve(std::move(moved->mechanism), std::move(moved->pose), finer, arithmetic));
        }
        name_position(solutions.back().mechanism, name, text);
    }
    return solutions;
}

}  // namespace kinegraph::app
