// Spelling: how faults of a file describe what stands there, and which known name a misspelt one may mean. Knows no form.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "engine/json_source.hpp"
#include "engine/units.hpp"

namespace kinegraph {

/// "the number 3", "an array of 2".
Words described(JsonValue value);
bool is_whole_number(JsonValue value);
bool is_true(JsonValue value);
/// "a", "b" and "c".
Words listed(std::span<const std::string_view> words);
/// The C0, DEL and C1 characters, at any place of well-formed UTF-8; a tab or line break only where `also_blank`.
bool has_control_character(std::string_view text, bool also_blank);

/// Finds the name nearest to a misspelt one, as long as the work for all of them stays small.
class Speller {
public:
    template <class Names>
    std::optional<std::string> nearest(std::string_view word, const Names& names) {
        constexpr std::size_t longest = 64;
        constexpr int most = 2;
        if (word.size() > longest) return std::nullopt;
        using Rank = std::tuple<std::size_t, std::uint64_t, std::ptrdiff_t>;
        std::optional<std::pair<Rank, std::string_view>> best;
        for (const std::string_view name : names) {
            if (budget_ == 0) break;
            --budget_;
            if (name.size() > longest) continue;
            const std::size_t distance = edit_distance(word, name, most);
            const std::size_t length = std::max(word.size(), name.size());
            if (distance > std::clamp<std::size_t>(length / 2, 1, most)) continue;
            const auto prefix = std::mismatch(word.begin(), word.end(), name.begin(), name.end()).first - word.begin();
            const Rank rank{distance, numbers_apart(word, name), -prefix};
            if (!best || rank < best->first) best = {rank, name};
        }
        if (!best) return std::nullopt;
        return std::string(best->second);
    }

private:
    /// Between two numbers the nearer is the likelier: 5 is 4 rather than 1.
    static std::uint64_t numbers_apart(std::string_view a, std::string_view b) {
        const auto value = [](std::string_view text) -> std::optional<std::int64_t> {
            constexpr std::size_t longest = 18;
            if (text.empty() || text.size() > longest) return std::nullopt;
            std::int64_t sum = 0;
            for (const char c : text) {
                if (c < '0' || c > '9') return std::nullopt;
                sum = sum * 10 + (c - '0');
            }
            return sum;
        };
        const auto x = value(a);
        const auto y = value(b);
        if (!x || !y) return 0;
        return static_cast<std::uint64_t>(*x > *y ? *x - *y : *y - *x);
    }
    long budget_ = 200'000;
};

/// " (did you mean "4"?)", or nothing.
Words did_you_mean(const std::optional<std::string>& name);

}  // namespace kinegraph
