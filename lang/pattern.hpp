// Patterns: texts of a language with places for others. The one reader of places; what is put there is elsewhere.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace kinegraph::lang {

/// "{0}", "{0 on}" or "{0|is|are}". Other braces are text: "{E_1}" is a letter.
struct Place {
    std::size_t argument = 0;
    std::size_t end = 0;                ///< index behind it
    std::string_view grammatical_case;  ///< "on"; empty: none
    bool chooses = false;
    std::string_view one, several;  ///< where it chooses by number
};

/// The place that begins at this index of a pattern; none: it is text.
inline std::optional<Place> place_at(std::string_view pattern, std::size_t at) {
    if (at + 2 >= pattern.size() || pattern[at] != '{' || pattern[at + 1] < '0' || pattern[at + 1] > '9')
        return std::nullopt;
    const std::size_t close = pattern.find('}', at);
    const char next = pattern[at + 2];
    if (close == std::string_view::npos || (next != '}' && next != ' ' && next != '|')) return std::nullopt;
    Place place{static_cast<std::size_t>(pattern[at + 1] - '0'), close + 1, {}, next == '|', {}, {}};
    const std::string_view inner = pattern.substr(at + 2, close - at - 2);
    if (next == ' ') place.grammatical_case = inner.substr(1);
    if (!place.chooses) return place;
    const std::size_t bar = inner.find('|', 1);
    place.one = inner.substr(1, bar - 1);
    place.several = bar == std::string_view::npos ? std::string_view() : inner.substr(bar + 1);
    return place;
}

/// Calls `put_text(std::string_view)` and `put_place(const Place&, std::string_view as_written)` in the pattern's
/// order.
template <class PutText, class PutPlace>
void for_each_part(std::string_view pattern, PutText put_text, PutPlace put_place) {
    std::size_t done = 0;
    for (std::size_t i = 0; i < pattern.size();) {
        const auto place = place_at(pattern, i);
        if (!place) {
            ++i;
            continue;
        }
        if (i > done) put_text(pattern.substr(done, i - done));
        put_place(*place, pattern.substr(i, place->end - i));
        done = i = place->end;
    }
    if (done < pattern.size()) put_text(pattern.substr(done));
}

}  // namespace kinegraph::lang
