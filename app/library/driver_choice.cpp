#include "app/library/driver_choice.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/library/limits.hpp"
#include "engine/file/spelling.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/positions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/library.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph::app {

std::string name_of_driver(const Mechanism& mechanism, int driver) {
    const Driver& given = mechanism.drivers[at_index(driver)];
    if (const auto* spin = std::get_if<SpinDriver>(&given)) return mechanism.body(spin->body).name;
    if (const auto* slide = std::get_if<SlideDriver>(&given)) return mechanism.joint(slide->joint).name;
    return mechanism.point(std::get<PointDriver>(given).at).name;
}

bool turns(const Mechanism& mechanism, int driver) { return kinegraph::turns(mechanism.drivers[at_index(driver)]); }
const Law* law_of(const Mechanism& mechanism, int driver) {
    return kinegraph::law_of(mechanism.drivers[at_index(driver)]);
}

Words cam_stays(const Mechanism& mechanism) { return {lang::library::this_is_one_position, mechanism.cam_file}; }

tl::expected<int, Words> driver_named(const Mechanism& mechanism, const std::string& name, const std::string& dashes) {
    if (mechanism.drivers.empty()) return tl::unexpected(Words(lang::library::nothing_drives_this_mechanism));
    if (!mechanism.cam_file.empty()) return tl::unexpected(cam_stays(mechanism));
    if (name.empty()) return 0;
    std::vector<std::string> known;
    std::string list;
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
        known.push_back(name_of_driver(mechanism, static_cast<int>(i)));
        if (known.back() == name) return static_cast<int>(i);
        list += (list.empty() ? "" : ", ") + known.back();
    }
    Speller speller;
    return tl::unexpected(Words(lang::library::driver_no_driver_is_called, dashes, name,
                                did_you_mean(speller.nearest(name, known)), list));
}

Course course_of(int driver, int branch) {
    Course course{driver};
    if (branch > 0) course.branch = static_cast<std::size_t>(branch) - 1;
    return course;
}

tl::expected<Exact, Words> quantity_of(const std::string& text, QuantityKind kind, const Exact& unit) {
    if (const auto number = read_decimal(text)) return *number * unit;
    const auto written = read_quantity(text, kind);
    if (!written) return tl::unexpected(written.error());
    if (written->unit->kind != kind)
        return tl::unexpected(
            Words(lang::common::is_but_is_wanted, quoted(text), with_article(written->unit->kind), with_article(kind)));
    return written->in_si();
}
tl::expected<Exact, Words> coordinate_of(const Mechanism& mechanism, int driver, const std::string& text) {
    const bool turning = turns(mechanism, driver);
    auto coordinate = quantity_of(text, turning ? QuantityKind::angle : QuantityKind::length,
                                  (turning ? mechanism.units.angle : mechanism.units.length).si);
    // A mechanism is moved there step by step, so that it stays on its branch.
    if (turning && coordinate && std::abs(coordinate->to_double()) > most_turns * 2 * std::numbers::pi)
        return tl::unexpected(
            Words(lang::library::is_more_than_turns_away, quoted(text), std::to_string(static_cast<int>(most_turns))));
    return coordinate;
}
tl::expected<Exact, Words> time_of(const std::string& text) { return quantity_of(text, QuantityKind::time, 1); }

Words time_text(double time) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), time, std::chars_format::general, 6);
    return decimal_words(std::string(text.data(), end.ptr) + " s");
}

Words coordinate_text(const Mechanism& mechanism, int driver, double coordinate, double grain) {
    const bool turning = turns(mechanism, driver);
    const Unit& unit = turning ? mechanism.units.angle : mechanism.units.length;
    constexpr int digits = 7;  // limits are computed to nine digits
    std::array<char, 32> text{};
    double value = coordinate / unit.si.to_double();
    value = std::round(value / grain) * grain;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return decimal_words(std::string(text.data(), end.ptr) +
                         (unit.symbol == "deg" || unit.symbol == "°" ? "°" : " " + unit.symbol));
}

Words out_of_reach(const Words& wanted, const std::string& driver, const Words& limit) {
    return {lang::library::is_out_of_reach_driver_stops, wanted, driver, limit};
}
Words too_far(const Words& wanted, const std::string& driver) {
    return {lang::sweeps::too_far_to_be_moved, wanted, driver, std::to_string(Positions::most_turns),
            std::to_string(Positions::most_sizes)};
}

}  // namespace kinegraph::app
