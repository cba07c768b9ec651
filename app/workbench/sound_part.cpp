// Removes faulty members and reads again, until what is left has no fault.
#include "app/workbench/sound_part.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace kinegraph::app {
namespace {

using Json = nlohmann::ordered_json;

/// Levels of nesting that the reader of files accepts. What is deeper is left out: copying recurses.
constexpr int deepest = 64;

/// The first two steps of a pointer, "/points/B" of "/points/B/meet/0": the member that is removed as a whole.
std::string member_of(const std::string& pointer) {
    const std::size_t second = pointer.find('/', 1);
    return pointer.substr(0, second == std::string::npos ? second : pointer.find('/', second + 1));
}

/// Removes what the pointer names. An element of an array becomes null until all are removed, so that the numbers of
/// the others stay. False if there is nothing to remove.
bool remove_from(Json& file, const std::string& pointer) {
    if (pointer.size() < 2 || pointer[0] != '/') return false;
    const Json::json_pointer place(pointer);
    if (!file.contains(place)) return false;
    Json& parent = file[place.parent_pointer()];
    if (parent.is_object()) return parent.erase(place.back()) > 0;
    file[place] = nullptr;
    return true;
}

/// A file whose list elements keep their places: an element that was removed is left out of the text, and its number is
/// kept for the pointers of the others.
class Remainder {
public:
    explicit Remainder(Json file) : file_(std::move(file)) {}

    /// False where no fault names something that can be removed.
    bool remove(const Diagnostics& faults) {
        bool removed = false;
        for (const Diagnostic& fault : faults) {
            const std::string place = original(member_of(fault.place));
            removed = remove_from(file_, place) || removed;
        }
        return removed;
    }
    std::string text() const {
        Json whole = Json::object();
        for (const auto& [key, value] : file_.items()) {
            if (!value.is_array()) {
                whole[key] = value;
                continue;
            }
            Json kept = Json::array();
            std::copy_if(value.begin(), value.end(), std::back_inserter(kept),
                         [](const Json& each) { return !each.is_null(); });
            whole[key] = std::move(kept);
        }
        return whole.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    /// The pointer in the original file of a pointer in text().
    std::string original(const std::string& pointer) const {
        const std::size_t second = pointer.find('/', 1);
        if (second == std::string::npos) return pointer;
        const std::string key = pointer.substr(1, second - 1);
        if (!file_.contains(key) || !file_[key].is_array()) return pointer;
        const std::size_t wanted = std::strtoul(pointer.c_str() + second + 1, nullptr, 10);
        std::size_t number = 0, index = 0;
        for (const Json& each : file_[key]) {
            if (!each.is_null() && number++ == wanted) break;
            ++index;
        }
        const std::size_t third = pointer.find('/', second + 1);
        return "/" + key + "/" + std::to_string(index) + (third == std::string::npos ? "" : pointer.substr(third));
    }

private:
    Json file_;
};

}  // namespace

std::optional<DrawnPosition> sound_position(std::string_view text, const std::string& name, Diagnostics faults) {
    Json parsed = Json::parse(
        text, [](int depth, auto, const Json&) { return depth <= deepest; }, false);
    if (!parsed.is_object()) return std::nullopt;
    // What a mechanism must have, and one that was just begun may not have yet.
    for (const char* key : {"points", "bodies"}) parsed.emplace(key, Json::object());
    parsed.emplace("joints", Json::array());
    Remainder remainder(std::move(parsed));
    // Each round removes something, so that this ends; a chain of points, each placed by the one before, takes longest.
    for (bool first = true; remainder.remove(faults) || first; first = false) {
        const auto file = MechanismFile::parse(remainder.text(), name);
        if (!file) {
            faults = file.error();
            continue;
        }
        auto placed = file->drawn_position();
        if (placed) {
            for (DrawnPosition::Direction& each : placed->directions) each.place = remainder.original(each.place);
            return *std::move(placed);
        }
        faults = placed.error();
    }
    return std::nullopt;
}

}  // namespace kinegraph::app
