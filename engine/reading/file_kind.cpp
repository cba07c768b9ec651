#include "engine/reading/file_kind.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/file/units.hpp"
#include "engine/solution/problem_kind.hpp"
#include "lang/keys/files.hpp"

namespace kinegraph {
namespace {

bool shows(std::string_view key, FileKind kind) {
    constexpr std::array<std::string_view, 4> of_mechanism{"points", "bodies", "joints", "motion"};
    if (kind == FileKind::cam) return key == "cam";
    const auto problems = problem_kinds();
    return std::find(of_mechanism.begin(), of_mechanism.end(), key) != of_mechanism.end() ||
           std::any_of(problems.begin(), problems.end(), [&](const ProblemKind* each) { return each->key == key; });
}

/// The first member that shows the file's kind.
JsonValue first_of(JsonValue root, FileKind kind) {
    for (const JsonValue member : root)
        if (shows(member.key(), kind)) return member;
    return {};
}

}  // namespace

std::optional<std::pair<JsonValue, Words>> fault_of_kind(JsonValue root, FileKind wanted) {
    if (first_of(root, wanted)) return std::nullopt;
    const bool wants_cam = wanted == FileKind::cam;
    const JsonValue other = first_of(root, wants_cam ? FileKind::mechanism : FileKind::cam);
    if (!other) return std::nullopt;
    const std::string key = quoted(other.key());
    if (wants_cam) return std::pair{other, Words(lang::files::no_cam_stands_in_this_file, key)};
    return std::pair{other, Words(lang::files::no_mechanism_stands_in_this_file)};
}

}  // namespace kinegraph
