// "effort": what balances the loads, a couple, a force or an actuator in a joint.
#pragma once

#include <string>
#include <unordered_set>

#include "engine/reading/joints_section.hpp"

namespace kinegraph {

class EffortsSection {
public:
    EffortsSection(FormReader& file, Mechanism& mechanism, JointsSection& joints)
        : file_(file), mechanism_(mechanism), joints_(joints) {}

    void read_effort(JsonValue value);

private:
    using Kind = FormReader::Kind;

    /// A name and where it stands.
    struct Named {
        std::string text{};
        JsonValue at{};
    };
    Named effort_name(JsonValue given, const Words& wanted);
    Named read_couple_effort(JsonValue value);
    Named read_actuator(JsonValue value);
    Named read_force_effort(JsonValue value);

    FormReader& file_;
    Mechanism& mechanism_;
    JointsSection& joints_;
    std::unordered_set<std::string> effort_names_;
};

}  // namespace kinegraph
