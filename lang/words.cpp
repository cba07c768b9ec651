#include "lang/words.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/units.hpp"
#include "lang/pattern.hpp"

namespace kinegraph {
namespace lang {
namespace {

constexpr std::string_view blanks = " ";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// A text as it is said: "\n" is a line break, "\~" a no-break space, and the quotes are gone that keep a blank at its
/// begin or end.
std::string unescaped(std::string text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    for (std::size_t at = text.find('\\'); at != std::string::npos && at + 1 < text.size();
         at = text.find('\\', at + 1)) {
        if (text[at + 1] == 'n') text.replace(at, 2, "\n");
        if (text[at + 1] == '~') text.replace(at, 2, "\u00A0");
    }
    return text;
}

}  // namespace

const Section::Texts& Section::read(Language language) const {
    const auto place = static_cast<std::size_t>(language);
    std::call_once(once_.at(place), [&] {
        Texts into;
        std::string_view rest = sources_.at(place);
        std::string text;
        const auto finish = [&] {
            if (into.names.size() > into.texts.size()) into.texts.push_back(unescaped(std::exchange(text, {})));
        };
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view line = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (line.empty() || line.front() == '#') continue;
            if (line.front() == ' ') {  // goes on
                text += " " + std::string(trimmed(line));
                continue;
            }
            finish();
            const std::size_t equals = std::min(line.find('='), line.size());
            into.names.emplace_back(trimmed(line.substr(0, equals)));
            text = trimmed(line.substr(std::min(equals + 1, line.size())));
        }
        finish();
        texts_.at(place) = std::make_unique<const Texts>(std::move(into));
    });
    return *texts_.at(place);
}
const std::string& Section::text(std::size_t index, Language language) const { return read(language).texts.at(index); }
const std::string& Section::name(std::size_t index) const { return read(Language::en).names.at(index); }

const std::string* Section::find(std::string_view name, Language language) const {
    const Texts& all = read(language);
    const auto found = std::find(all.names.begin(), all.names.end(), name);
    return found == all.names.end() ? nullptr : &all.texts[static_cast<std::size_t>(found - all.names.begin())];
}

}  // namespace lang

std::string code_of(Language language) { return lang::notation::code.in(language); }
Language language_named(std::string_view code) {
    const auto same_letter = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    for (const Language language : languages) {
        const std::string& own = lang::notation::code.in(language);
        if (std::equal(own.begin(), own.end(), code.begin(), code.end(), same_letter)) return language;
    }
    return Language::en;
}

namespace {

/// `pattern` with the arguments in the places {0} to {9}.
std::string filled(std::string_view pattern, const std::vector<Words>& arguments, Language language) {
    std::string text;
    lang::for_each_part(
        pattern, [&](std::string_view part) { text += part; },
        [&](const lang::Place& place, std::string_view as_written) {
            const bool is_plain = place.grammatical_case.empty() && !place.chooses;
            if (is_plain && place.argument < arguments.size())
                text += arguments[place.argument].in(language);
            else
                text += as_written;
        });
    return text;
}

}  // namespace

Words::Words(const Text& text) : form_(Form::by_language) {
    if (std::all_of(text.by_language.begin(), text.by_language.end(),
                    [&](const std::string& each) { return each == text.by_language.front(); })) {
        form_ = Form::in_a_row;
        text_ = text.by_language.front();
        return;
    }
    for (const std::string& each : text.by_language) parts_.emplace_back(each);
}

bool Words::empty() const {
    switch (form_) {
        case Form::text_of_key:
        case Form::by_language: return false;
        case Form::pattern: return text_.empty();
        case Form::in_a_row:
            return text_.empty() && std::all_of(parts_.begin(), parts_.end(), [](const Words& w) { return w.empty(); });
    }
    return true;
}

std::string Words::in(Language language) const {
    switch (form_) {
        case Form::text_of_key: return filled(key_.in(language), parts_, language);
        case Form::by_language: return parts_.at(static_cast<std::size_t>(language)).in(language);
        case Form::pattern: return filled(text_, parts_, language);
        case Form::in_a_row: break;
    }
    std::string text = text_;
    for (const Words& part : parts_) text += part.in(language);
    return text;
}

namespace {

/// Whether a text only proposes another spelling.
bool is_proposal(const Key& key) { return key == lang::common::did_you_mean || key == lang::units::did_you_mean; }

/// Without blanks, no-break spaces and the brackets of a proposal at its ends.
std::string bare_half(std::string_view text) {
    constexpr std::string_view no_break = "\u00A0";
    while (text.ends_with(no_break) || text.ends_with(' '))
        text.remove_suffix(text.ends_with(' ') ? 1 : no_break.size());
    while (text.starts_with(no_break) || text.starts_with(' '))
        text.remove_prefix(text.starts_with(' ') ? 1 : no_break.size());
    if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
    return std::string(text);
}

}  // namespace

Words::InTwo Words::pattern_in_two(std::string_view pattern, Language language) const {
    if (const std::size_t semicolon = pattern.find(';'); semicolon != std::string_view::npos) {
        InTwo two = pattern_in_two(pattern.substr(0, semicolon), language);
        two.fault = bare_half(two.fault);
        if (!two.remedy.empty()) two.remedy += lang::notation::semicolon.in(language);
        two.remedy += bare_half(filled(pattern.substr(semicolon + 1), parts_, language));
        return two;
    }
    // A text at the end may have the remedy: {"no point is named {0}{1}", " (did you mean {0}?)"}.
    constexpr std::size_t place = 3;
    const std::size_t last = pattern.size() < place ? 0 : pattern.size() - place;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (pattern.substr(last) != "{" + std::to_string(i) + "}") continue;
        InTwo two = parts_[i].in_two(language);
        two.fault = filled(pattern.substr(0, last), parts_, language) + two.fault;
        return two;
    }
    return {filled(pattern, parts_, language), {}};
}

Words::InTwo Words::in_two(Language language) const {
    switch (form_) {
        case Form::text_of_key:
            if (is_proposal(key_)) return {{}, bare_half(in(language))};
            return pattern_in_two(key_.in(language), language);
        case Form::by_language: return parts_.at(static_cast<std::size_t>(language)).in_two(language);
        case Form::pattern: return pattern_in_two(text_, language);
        case Form::in_a_row: break;
    }
    InTwo two{text_, {}};
    for (const Words& part : parts_) {
        if (!two.remedy.empty()) {
            two.remedy += part.in(language);
            continue;
        }
        const InTwo more = part.in_two(language);
        two.fault += more.fault;
        two.remedy = more.remedy;
    }
    return two;
}

Words::operator Text() const {
    Text text;
    for (const Language language : languages) text.by_language.at(static_cast<std::size_t>(language)) = in(language);
    return text;
}

Words& Words::operator+=(const Words& more) {
    if (more.empty()) return *this;
    if (empty()) return *this = more;
    if (form_ != Form::in_a_row) {
        Words first = std::move(*this);
        *this = {};
        parts_.push_back(std::move(first));
    }
    if (more.form_ == Form::in_a_row && more.parts_.empty() && parts_.empty())
        text_ += more.text_;
    else
        parts_.push_back(more);
    return *this;
}
bool operator==(const Words& one, const Words& other) {
    return std::all_of(languages.begin(), languages.end(),
                       [&](Language language) { return one.in(language) == other.in(language); });
}

Words decimal_words(const std::string& text) {
    Text all;
    for (const Language language : languages) {
        std::string& said = all.by_language.at(static_cast<std::size_t>(language));
        said = text;
        std::replace(said.begin(), said.end(), '.', lang::notation::decimal_mark.in(language).front());
    }
    return all;
}

Words formula_words(std::string pattern, std::vector<Words> arguments) {
    Words words(std::move(pattern));
    words.form_ = Words::Form::pattern;
    words.parts_ = std::move(arguments);
    return words;
}

Words library_message(const std::string& english, const lang::Section& fragments) {
    Text text;
    for (const Language language : languages) {
        std::string& said = text.by_language.at(static_cast<std::size_t>(language));
        said = english;
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            const std::string &from = fragments.text(i, Language::en), &to = fragments.text(i, language);
            if (from.empty()) throw std::logic_error("a fragment of a message has no text");
            for (std::size_t at = said.find(from); at != std::string::npos; at = said.find(from, at + to.size()))
                said.replace(at, from.size(), to);
        }
    }
    return text;
}

}  // namespace kinegraph
