// Spelling: describes faulty values of a file, and suggests the known name nearest to a misspelt one.
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

#include "engine/file/json_source.hpp"
#include "engine/file/units.hpp"

namespace kinegraph {

/// "the number 3", "an array of 2".
Words described(JsonValue value);
bool is_whole_number(JsonValue value);
bool is_true(JsonValue value);
/// "a", "b" and "c".
Words listed(std::span<const std::string_view> words);
/// The C0, DEL and C1 characters, at any place of well-formed UTF-8; a tab or line break only where `also_blank`.
bool has_control_character(std::string_view text, bool also_blank);

/// The colour "#RRGGBB" as 0xRRGGBB; nothing where the text is no colour.
std::optional<std::uint32_t> colour_of_text(std::string_view text);

/// Finds the name nearest to a misspelt one, with a bound on the total work.
class Speller {
public:
    template <class Names>
    std::optional<std::string> nearest(std::string_view word, const Names& names) {
        constexpr std::size_t longest = 64;
        constexpr int most = 2;
        if (word.size() > longest) return std::nullopt;
        const std::string letters = letters_of(word);
        using Rank = std::tuple<std::size_t, bool, std::size_t, std::uint64_t, std::ptrdiff_t>;
        std::optional<std::pair<Rank, std::string_view>> best;
        for (const std::string_view name : names) {
            if (budget_ == 0) break;
            --budget_;
            if (name.size() > longest) continue;
            // Names that differ only in spelling come first: "v_B" is nearer to "v B" than to "v_C". Then come names
            // with the same letters in another order.
            const std::string other = letters_of(name);
            const std::size_t said = edit_distance(letters, other, most);
            const std::size_t length = std::max(word.size(), name.size());
            if (said > std::clamp<std::size_t>(length / 2, 1, most)) continue;
            const bool other_letters = !std::is_permutation(letters.begin(), letters.end(), other.begin(), other.end());
            // Two slips that begin at the first letter are another word: "nodes" is no "bodies".
            if (said > 1 && other_letters && letters.substr(0, 1) != other.substr(0, 1)) continue;
            if (said == 1 && is_another(letters, other)) continue;
            const auto prefix = std::mismatch(word.begin(), word.end(), name.begin(), name.end()).first - word.begin();
            const Rank rank{said, other_letters, edit_distance(word, name, most), numbers_apart(letters, other),
                            -prefix};
            if (!best || rank < best->first) best = {rank, name};
        }
        if (!best) return std::nullopt;
        return std::string(best->second);
    }

private:
    /// Without blanks and underscores, in lower case.
    static std::string letters_of(std::string_view name) {
        std::string letters;
        for (const char c : name)
            if (c != ' ' && c != '_') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return letters;
    }
    /// Of two names that differ by one letter more: whether they are no slip of each other. A letter more of a number,
    /// or of a name of two letters, is a slip only where it stands twice: "33" may be 3, but "12" is not 2.
    static bool is_another(std::string_view longer, std::string_view shorter) {
        if (longer.size() < shorter.size()) std::swap(longer, shorter);
        if (longer.size() != shorter.size() + 1) return false;
        constexpr auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        const auto at = static_cast<std::size_t>(std::mismatch(shorter.begin(), shorter.end(), longer.begin()).first -
                                                 shorter.begin());
        const bool in_number = is_digit(longer[at]) &&
                               ((at > 0 && is_digit(longer[at - 1])) || (at < shorter.size() && is_digit(shorter[at])));
        const bool twice = at > 0 && longer[at] == longer[at - 1];
        return (in_number || longer.size() == 2) && !twice;
    }
    /// Among names that differ only in the number at their end, the nearer number is more likely: 5 is 4 rather than 1.
    static std::uint64_t numbers_apart(std::string_view a, std::string_view b) {
        constexpr std::size_t longest = 18;
        constexpr std::uint64_t far = UINT64_MAX;
        const auto digits_from = [](std::string_view text) { return text.find_last_not_of("0123456789") + 1; };
        const auto value = [](std::string_view digits) {
            std::int64_t sum = 0;
            for (const char c : digits) sum = sum * 10 + (c - '0');
            return sum;
        };
        const std::string_view x = a.substr(digits_from(a)), y = b.substr(digits_from(b));
        const bool are_numbers = !x.empty() && !y.empty() && std::max(x.size(), y.size()) <= longest;
        if (!are_numbers || a.substr(0, digits_from(a)) != b.substr(0, digits_from(b))) return far;
        const std::int64_t apart = value(x) - value(y);
        return static_cast<std::uint64_t>(apart < 0 ? -apart : apart);
    }
    long budget_ = 200'000;
};

/// " (did you mean "4"?)", or nothing.
Words did_you_mean(const std::optional<std::string>& name);

}  // namespace kinegraph
