// "drivers": what drives a body, a joint or a point, and how fast; by rates or by a law of motion in time.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

#include "engine/reading/joints_section.hpp"
#include "engine/reading/law_reader.hpp"

namespace kinegraph {

class DriversSection {
public:
    DriversSection(FormReader& file, Mechanism& mechanism, LawReader& laws, JointsSection& joints)
        : file_(file), mechanism_(mechanism), laws_(laws), joints_(joints) {}

    void read_driver(JsonValue value);

private:
    using Kind = FormReader::Kind;

    void read_slide_driver(JsonValue value);
    void read_point_driver(JsonValue value);
    void read_spin_driver(JsonValue value);
    /// {"body": 2, "speed": 150}: a body turns.
    void turn_instead(const Members& form);
    /// FORMAT "Laws of motion": of a driver; `rates` are the keys that it stands for.
    std::optional<Law> law(const Members& form, std::initializer_list<std::string_view> rates);
    /// A driver, with the rates of its law.
    void add(Driver driver);

    FormReader& file_;
    Mechanism& mechanism_;
    LawReader& laws_;
    JointsSection& joints_;
};

}  // namespace kinegraph
