#include "engine/file/file_kind.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/file/units.hpp"
#include "lang/keys/files.hpp"

namespace kinegraph {
namespace {

struct StatedBy {
    std::string_view key;
    FileKind kind;
};
constexpr std::array stated_by{
    StatedBy{"cam", FileKind::cam},
    StatedBy{"points", FileKind::mechanism},
    StatedBy{"bodies", FileKind::mechanism},
    StatedBy{"joints", FileKind::mechanism},
    StatedBy{"motion", FileKind::mechanism},
    StatedBy{"hertz", FileKind::mechanism},
    StatedBy{"reye", FileKind::mechanism},
    StatedBy{"impact", FileKind::mechanism},
    StatedBy{"positions", FileKind::mechanism},
};

/// The first member that shows the file's kind.
JsonValue first_of(JsonValue root, FileKind kind) {
    for (const JsonValue member : root)
        if (std::any_of(stated_by.begin(), stated_by.end(),
                        [&](const StatedBy& each) { return each.kind == kind && each.key == member.key(); }))
            return member;
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
