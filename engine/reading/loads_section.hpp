// "masses" and "loads": forces, couples, springs, distributed loads, and forces on the pin of a hinge.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_set>

#include "engine/reading/joints_section.hpp"

namespace kinegraph {

class LoadsSection {
public:
    LoadsSection(FormReader& file, Mechanism& mechanism, JointsSection& joints)
        : file_(file), mechanism_(mechanism), joints_(joints) {}

    void read_masses(JsonValue masses);
    void read_load(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// Results and figures go by it.
    std::string name_of_load(JsonValue value, const Words& wanted);
    void read_force(JsonValue value);
    /// On the pin of a hinge, which is then a node of its own.
    void read_pin_load(JsonValue value);
    /// Components, or magnitude and direction, or a pressure on an area and a direction.
    void read_size(const Members& form, ForceLoad& force);
    std::optional<Exact> pressure_on_area(const Members& form);
    void read_spring(JsonValue value);
    void read_ends(const Members& form, SpringLoad& spring);
    /// Of a spring.
    std::array<BodyIndex, 2> two_bodies(JsonValue bodies);
    /// FORMAT "Forces": an elastic spring, straight or of torsion.
    void read_elastic(JsonValue value);
    void read_distributed(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
    JointsSection& joints_;
    std::unordered_set<std::string> load_names_;
};

}  // namespace kinegraph
