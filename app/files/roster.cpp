// Rosters: see roster.hpp.
#include "app/files/roster.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {
namespace {

/// The longest name that a title block can print.
constexpr std::size_t longest_name = 200;

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

/// The words of a field in lower case, split at all other characters ("Matr.", "E-mail", "Nome e cognome").
std::vector<std::string> words_of(const std::string& field) {
    std::vector<std::string> words;
    bool goes_on = false;
    for (const char c : in_small_letters(field)) {
        const bool is_letter = (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
        if (is_letter && !goes_on) words.emplace_back();
        if (is_letter) words.back() += c;
        goes_on = is_letter;
    }
    return words;
}

/// True if a field is a column heading: all its words are heading words, at least one of which is not a person's name.
bool is_head(const std::string& field) {
    constexpr auto heads = std::to_array<std::string_view>(
        {"name",      "names",  "surname", "student",     "students",   "id",        "email",
         "mail",      "number", "nome",    "cognome",     "cognomi",    "studente",  "studenti",
         "matricola", "matr",   "numero",  "elettronica", "nominativo", "nominativi"});
    constexpr auto beside =
        std::to_array<std::string_view>({"first", "last", "given", "family", "full", "and", "or", "of", "the", "no",
                                         "nr", "s", "n", "nomi", "e", "o", "di", "dello", "posta"});
    const std::vector<std::string> words = words_of(field);
    const auto among = [](const auto& list) {
        return [&list](const std::string& word) { return std::find(list.begin(), list.end(), word) != list.end(); };
    };
    return std::any_of(words.begin(), words.end(), among(heads)) &&
           std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return among(heads)(word) || among(beside)(word); });
}

bool is_heading(const std::vector<std::string>& fields) { return std::any_of(fields.begin(), fields.end(), is_head); }

/// The fields of one line; empty if a quote is not closed.
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

/// Why a line is not a name; empty if it is.
Words unreadable(std::string_view line) {
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t length = character_length(line.substr(i));
        if (length == 0) return {lang::command_line::this_is_no_utf_8_save};
        const auto code = static_cast<unsigned char>(line[i]);
        if ((code < 0x20 && code != '\t') || code == 0x7F) return {lang::command_line::a_control_character_can_be_no};
        i += length;
    }
    return {};
}

std::size_t characters_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The names so far, and the rules that a further line must obey.
class Names {
public:
    /// Adds a line that is not empty. Returns why it is invalid; empty if it is valid.
    Words add(std::size_t line, std::string_view text) {
        if (Words why = unreadable(text); !why.empty()) return why;
        const auto fields = fields_of(text);
        if (!fields) return {lang::command_line::a_quote_is_not_closed};
        std::string name;
        for (const std::string& field : *fields)
            if (!field.empty()) name += (name.empty() ? "" : " ") + field;
        if (name.empty()) return {};
        if (std::exchange(is_first_, false) && is_heading(*fields)) {
            wanted_ = fields->size();
            return {};
        }
        if (wanted_ > 0 && fields->size() != wanted_)
            return {lang::command_line::fields_differ_from_heading, std::to_string(fields->size()),
                    std::to_string(wanted_)};
        return take(line, std::move(name));
    }
    std::vector<std::string> all() && { return std::move(names_); }

private:
    Words take(std::size_t line, std::string name) {
        if (const std::size_t length = characters_of(name); length > longest_name)
            return {lang::command_line::a_name_of_characters_at_most, std::to_string(length),
                    std::to_string(longest_name)};
        const auto [before, is_new] = lines_.try_emplace(name, line);
        if (!is_new)
            return {lang::command_line::stands_in_line_already_take, in_quotes(name), std::to_string(before->second)};
        names_.push_back(std::move(name));
        return {};
    }
    static std::string in_quotes(const std::string& name) { return '"' + name + '"'; }

    std::vector<std::string> names_;
    std::unordered_map<std::string, std::size_t> lines_;
    std::size_t wanted_ = 0;  ///< number of fields in the heading; 0: no heading
    bool is_first_ = true;
};

}  // namespace

tl::expected<std::vector<std::string>, Words> read_roster(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    Names found;
    for (std::size_t number = 1, from = 0; from < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string_view line = text.substr(from, end - from);
        from = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (const Words why = found.add(number, line); !why.empty())
            return tl::unexpected(Words(lang::command_line::line, std::to_string(number), why));
    }
    std::vector<std::string> names = std::move(found).all();
    if (names.empty()) return tl::unexpected(Words(lang::command_line::there_is_no_name));
    return names;
}

}  // namespace kinegraph::app
