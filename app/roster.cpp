// Rosters: see roster.hpp.
#include "app/roster.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kinegraph::app {
namespace {

/// How long the character at the beginning is; 0: it is none of UTF-8.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80   ? 1
                               : byte(0) < 0xC2 ? 0
                               : byte(0) < 0xE0 ? 2
                               : byte(0) < 0xF0 ? 3
                               : byte(0) < 0xF5 ? 4
                                                : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

std::string trimmed(std::string text) {
    const auto blank = [](char c) { return c == ' '; };
    text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
    text.erase(std::find_if_not(text.rbegin(), text.rend(), blank).base(), text.end());
    return text;
}

std::string in_small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

bool is_heading(const std::vector<std::string>& fields) {
    constexpr std::array<std::string_view, 20> headings{"name",        "surname", "first name", "last name", "given name",
                                                        "family name", "student", "student id", "id",        "email",
                                                        "e-mail",      "number",  "nome",       "cognome",   "studente",
                                                        "matricola",   "numero",  "posta",      "full name", "nominativo"};
    return std::any_of(fields.begin(), fields.end(), [&](const std::string& field) {
        return std::find(headings.begin(), headings.end(), in_small_letters(field)) != headings.end();
    });
}

/// The fields of one line; nothing where a quote is not closed.
std::optional<std::vector<std::string>> fields_of(std::string_view line) {
    std::vector<std::string> fields{""};
    bool in_quotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (in_quotes && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += '"';
            ++i;
        } else if (c == '"' && (in_quotes || trimmed(fields.back()).empty())) {
            in_quotes = !in_quotes;
        } else if (!in_quotes && (c == ',' || c == ';' || c == '\t')) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    if (in_quotes) return std::nullopt;
    for (std::string& field : fields) field = trimmed(std::move(field));
    return fields;
}

/// Why a line cannot be names; empty where it can.
Words unreadable(std::string_view line) {
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t length = character_length(line.substr(i));
        if (length == 0) return {"this is no UTF-8; save it as such", "non è UTF-8; salvarlo come tale"};
        const auto code = static_cast<unsigned char>(line[i]);
        if ((code < 0x20 && code != '\t') || code == 0x7F)
            return {"a control character can be no name", "un carattere di controllo non può essere un nome"};
        i += length;
    }
    return {};
}

}  // namespace

tl::expected<std::vector<std::string>, Words> read_roster(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<std::string> names;
    bool is_first = true;
    for (std::size_t number = 1, from = 0; from < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string_view line = text.substr(from, end - from);
        from = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        const auto at_line = [&](const Words& why) {
            return tl::unexpected(Words("line {0}: {1}", "riga {0}: {1}", std::to_string(number), why));
        };
        if (const Words why = unreadable(line); !why.empty()) return at_line(why);
        const auto fields = fields_of(line);
        if (!fields) return at_line({"a quote is not closed", "le virgolette non sono chiuse"});
        std::string name;
        for (const std::string& field : *fields)
            if (!field.empty()) name += (name.empty() ? "" : " ") + field;
        if (name.empty()) continue;
        if (!is_first || !is_heading(*fields)) names.push_back(std::move(name));
        is_first = false;
    }
    if (names.empty()) return tl::unexpected(Words("there is no name in it", "non contiene nessun nome"));
    return names;
}

}  // namespace kinegraph::app
