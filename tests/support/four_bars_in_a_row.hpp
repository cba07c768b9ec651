// Any number of four-bars in a row: crowded sheets and large files for tests and benchmarks.
#pragma once

#include <string>

namespace kinegraph::tests {

/// Small pseudo-random numbers, the same on every machine.
inline int jitter(int i, int most) { return i * 7919 % 104729 % (2 * most + 1) - most; }
inline std::string at(int x, int y) { return "[" + std::to_string(x) + ", " + std::to_string(y) + "]"; }

/// A crank, then link and rocker `dyads` times, each rocker's far pin carrying the next link: 2 + 2·dyads bodies. Every
/// point is a decimal of few digits; `by_compass`: the pins are found by compass (irrational, exact to 2⁻¹⁰⁰).
inline std::string four_bars_in_a_row(int dyads, const std::string& find = {}, bool by_compass = false) {
    const auto quoted = [](const std::string& text) { return "\"" + text + "\""; };
    const auto number = [](int value) { return std::to_string(value); };
    std::string points = "\"O0\": [0, 0], \"C0\": [30, 40]";
    std::string bodies = "\"2\": [\"O0\", \"C0\"]";
    std::string joints = "{\"revolute\": \"O0\", \"bodies\": [1, 2]}";
    int carrier = 2;
    for (int i = 1; i <= dyads; ++i) {
        const std::string before = "C" + number(i - 1), ground = "O" + number(i), pin = "B" + number(i),
                          next = "C" + number(i);
        const int link = 2 * i + 1, rocker = 2 * i + 2;
        const std::string place = by_compass ? "{\"meet\": [{\"circle\": " + quoted(before) +
                                                   ", \"radius\": 95}, {\"circle\": " + quoted(ground) +
                                                   ", \"radius\": 80}], \"side\": \"left\"}"
                                             : at(120 * i + 10 + jitter(i + 50, 10), 80 + jitter(i + 100, 10));
        points += ",\n" + quoted(ground) + ": " + at(120 * i, jitter(i, 10)) + ", " + quoted(pin) + ": " + place +
                  ", " + quoted(next) + ": " + at(120 * i + 40 + jitter(i + 150, 10), 50 + jitter(i + 200, 10));
        bodies += ",\n" + quoted(number(link)) + ": [" + quoted(before) + ", " + quoted(pin) + "], " +
                  quoted(number(rocker)) + ": [" + quoted(ground) + ", " + quoted(pin) + ", " + quoted(next) + "]";
        joints += ",\n{\"revolute\": " + quoted(before) + ", \"bodies\": " + at(carrier, link) +
                  "}, {\"revolute\": " + quoted(pin) + ", \"bodies\": " + at(link, rocker) +
                  "}, {\"revolute\": " + quoted(ground) + ", \"bodies\": " + at(1, rocker) + "}";
        carrier = rocker;
    }
    return "{\"kinegraph\": 1, \"units\": {\"length\": \"mm\"}, \"frame\": 1,\n\"points\": {" + points +
           "},\n\"bodies\": {" + bodies + "},\n\"joints\": [" + joints +
           "],\n\"drivers\": [{\"body\": 2, \"omega\": 5, \"alpha\": -2}]" +
           (find.empty() ? "" : ",\n\"find\": " + find) + "}";
}

}  // namespace kinegraph::tests
