// JSON text put together from its parts: numbers, vectors, objects. Used by the results file and by the kinds of
// problems for their part of it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/number/exact.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph::json {

/// Keys in order, with values that are already JSON text.
using Members = std::vector<std::pair<std::string, std::string>>;

std::string quoted(std::string_view text);

/// JSON has no infinities: a value outside the range of doubles is null. −0 is 0.
void append_number(std::string& json, double value);
std::string number(double value);
std::string number(const Exact& value);

std::string pair(std::string_view x, std::string_view y);
std::string pair(const Vector& v);

std::string fraction(const Exact& value);
std::string fractions(const Vector& v);

void append_member(std::string& json, std::string_view key, std::string_view value);
std::string object(const Members& members);
/// An object or array with one entry a line, as a member of the file's object: `append(json, entry)` writes one.
template <class Entries, class Append>
std::string lines(char open, const Entries& entries, char close, const Append& append) {
    if (entries.empty()) return {open, close};
    std::string json(1, open);
    for (const auto& entry : entries) {
        json += json.size() == 1 ? "\n    " : ",\n    ";
        append(json, entry);
    }
    return (json += "\n  ") += close;
}
std::string lines(char open, const std::vector<std::string>& entries, char close);
std::string object_of_lines(const Members& members);

/// All values of a problem that have a name in the file.
Members values_of(const ProblemSolution& found);

}  // namespace kinegraph::json
