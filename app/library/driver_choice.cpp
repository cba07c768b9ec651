#include "app/library/driver_choice.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/file/spelling.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/drivers.hpp"

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

Words cam_stays(const Mechanism& mechanism) {
    return {
        "this is one position of the cam of {0}, with its circle of curvature in place of the profile, so it cannot "
        "be moved; kinegraph cam {0} computes other positions",
        "questa è una posizione della camma di {0}, con il cerchio osculatore al posto del profilo, quindi non si "
        "può muovere; kinegraph cam {0} calcola le altre posizioni",
        mechanism.cam_file};
}

tl::expected<int, Words> driver_named(const Mechanism& mechanism, const std::string& name, const std::string& dashes) {
    if (mechanism.drivers.empty())
        return tl::unexpected(
            Words("nothing drives this mechanism, so it has one position only; give it \"drivers\"",
                  "nulla comanda questo meccanismo, che ha quindi una sola posizione; dargli \"drivers\""));
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
    return tl::unexpected(Words("{0}driver {1}: no driver is called so{2}; there are {3}",
                                "{0}driver {1}: nessun movente si chiama così{2}; ci sono {3}", dashes, name,
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
        return tl::unexpected(Words("{0} is {1}; {2} is wanted here", "{0} è {1}; qui serve {2}", quoted(text),
                                    with_article(written->unit->kind), with_article(kind)));
    return written->in_si();
}
tl::expected<Exact, Words> coordinate_of(const Mechanism& mechanism, int driver, const std::string& text) {
    const bool turning = turns(mechanism, driver);
    return quantity_of(text, turning ? QuantityKind::angle : QuantityKind::length,
                       (turning ? mechanism.units.angle : mechanism.units.length).si);
}
tl::expected<Exact, Words> time_of(const std::string& text) { return quantity_of(text, QuantityKind::time, 1); }

Words time_text(double time) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), time, std::chars_format::general, 6);
    return decimal(std::string(text.data(), end.ptr) + " s");
}

Words coordinate_text(const Mechanism& mechanism, int driver, double coordinate, double grain) {
    const bool turning = turns(mechanism, driver);
    const Unit& unit = turning ? mechanism.units.angle : mechanism.units.length;
    constexpr int digits = 7;  // limits are computed to nine digits
    std::array<char, 32> text{};
    double value = coordinate / unit.si.to_double();
    value = std::round(value / grain) * grain;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return decimal(std::string(text.data(), end.ptr) +
                   (unit.symbol == "deg" || unit.symbol == "°" ? "°" : " " + unit.symbol));
}

Words out_of_reach(const Words& wanted, const std::string& driver, const Words& limit) {
    return {"{0} is out of reach: driver {1} stops at {2}", "{0} è fuori portata: il movente {1} si ferma a {2}",
            wanted, driver, limit};
}

Words decimal(std::string text) {
    std::string italian = text;
    std::replace(italian.begin(), italian.end(), '.', ',');
    return {std::move(text), std::move(italian)};
}

}  // namespace kinegraph::app
