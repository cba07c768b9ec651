// A scissor lift of any number of stages, as a mechanism file.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace kinegraph::tests {

/// Stages of 400 mm by 300 mm; two loads of 500 N on top, an input force at the sliding foot.
inline nlohmann::json scissor(int stages) {
    using Json = nlohmann::json;
    Json points, bodies, joints = Json::array();
    const auto name = [](char letter, int number) { return letter + std::to_string(number); };
    for (int i = 0; i <= stages; ++i) {
        points[name('L', i)] = {0, 300 * i};
        points[name('R', i)] = {400, 300 * i};
    }
    for (int i = 0; i < stages; ++i) {
        points[name('M', i)] = {200, 150 + 300 * i};
        bodies[name('a', i)] = {name('L', i), name('M', i), name('R', i + 1)};
        bodies[name('b', i)] = {name('R', i), name('M', i), name('L', i + 1)};
        joints.push_back({{"revolute", name('M', i)}, {"bodies", {name('a', i), name('b', i)}}});
        if (i == 0) continue;
        joints.push_back({{"revolute", name('L', i)}, {"bodies", {name('b', i - 1), name('a', i)}}});
        joints.push_back({{"revolute", name('R', i)}, {"bodies", {name('a', i - 1), name('b', i)}}});
    }
    joints.push_back({{"revolute", "L0"}, {"bodies", {"0", "a0"}}});
    joints.push_back({{"pin-slot", "R0"}, {"bodies", {"b0", "0"}}, {"along", 0}});
    const auto load = [&](const char* of, const std::string& body, const std::string& at) {
        return Json{{"force", of}, {"body", body}, {"at", at}, {"value", {0, -500}}};
    };
    return {
        {"kinegraph", 1},
        {"units", {{"length", "mm"}}},
        {"points", points},
        {"bodies", bodies},
        {"joints", joints},
        {"loads",
         {load("W1", name('b', stages - 1), name('L', stages)), load("W2", name('a', stages - 1), name('R', stages))}},
        {"effort", {{"force", "P"}, {"body", "b0"}, {"at", "R0"}, {"along", 180}}},
        {"find", {"forces"}}};
}

}  // namespace kinegraph::tests
