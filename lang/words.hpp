// Words: a text that can be said in every language. The texts are in lang/en.txt, lang/it.txt …, one file a language;
// cmake/languages.cmake makes a header of keys from each section of lang/en.txt (lang/keys/SECTION.hpp) and refuses a
// language that lacks one. A text is looked up and filled only when it is said.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>

namespace kinegraph {
namespace lang {

/// The texts of one section, in every language, in the order of lang/en.txt. A language is read when it is first said.
class Section {
public:
    /// `sources`: the section's lines, `key = text`, as they stand in the files, in the order of Language.
    explicit constexpr Section(const std::array<std::string_view, languages.size()>& sources) : sources_(sources) {}
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;
    ~Section() = default;

    const std::string& text(std::size_t index, Language language) const;
    const std::string& name(std::size_t index) const;
    /// The text of a name in a section whose names are the language's own; none: nullptr.
    const std::string* find(std::string_view name, Language language) const;
    std::size_t size() const { return read(Language::en).names.size(); }

private:
    struct Texts {
        std::vector<std::string> names, texts;
    };
    const Texts& read(Language language) const;

    std::array<std::string_view, languages.size()> sources_;
    mutable std::array<std::once_flag, languages.size()> once_;
    mutable std::array<std::unique_ptr<const Texts>, languages.size()> texts_;  // none until it is read
};

/// All sections, in the order of lang/en.txt.
std::span<const Section* const> all_sections();

}  // namespace lang

/// The name of a text in the files of the languages: lang::SECTION::NAME.
struct Key {
    const lang::Section* section = nullptr;
    std::size_t index = 0;

    /// The text as its file has it, with its places {0} … still empty.
    const std::string& in(Language language) const { return section->text(index, language); }
    const std::string& name() const { return section->name(index); }
    friend constexpr bool operator==(const Key&, const Key&) = default;
};

/// A title, a label, a sentence or a message.
class Words {
public:
    Words() = default;
    /// The same in all languages: a name, a number, a quotation from the file. Not for literals: these have keys.
    Words(std::string every) : text_(std::move(every)) {}    // NOLINT(google-explicit-constructor)
    Words(std::string_view every) : text_(every) {}          // NOLINT(google-explicit-constructor)
    Words(Key key) : form_(Form::text_of_key), key_(key) {}  // NOLINT(google-explicit-constructor)
    /// A text already said in every language.
    Words(const Text& text);  // NOLINT(google-explicit-constructor)
    /// A text with its places {0} … {9} filled by the arguments, each in the text's language.
    template <class... Arguments>
    Words(Key key, const Arguments&... arguments)
        : form_(Form::text_of_key), key_(key), parts_(std::vector<Words>{Words(arguments)...}) {}
    Words(Key key, std::vector<Words> arguments) : form_(Form::text_of_key), key_(key), parts_(std::move(arguments)) {}

    bool empty() const;
    std::string in(Language language) const;
    /// A message of a fault, whose remedy stands behind the semicolon of its text, or of a text at its end.
    struct InTwo {
        std::string fault, remedy;
    };
    InTwo in_two(Language language) const;
    /// In every language.
    operator Text() const;  // NOLINT(google-explicit-constructor)
    Words& operator+=(const Words& more);
    friend Words operator+(Words first, const Words& second) { return first += second; }
    /// Whether they say the same in every language.
    friend bool operator==(const Words&, const Words&);

private:
    friend Words formula_words(std::string pattern, std::vector<Words> arguments);
    InTwo pattern_in_two(std::string_view pattern, Language language) const;

    enum class Form {
        in_a_row,     ///< text_, then the parts
        text_of_key,  ///< the text of the key, filled with the parts
        pattern,      ///< text_, filled with the parts
        by_language   ///< the part of the language
    };
    Form form_ = Form::in_a_row;
    Key key_;
    std::string text_;
    std::vector<Words> parts_;
};

/// A library's English message. The section has its fragments, each in every language; they are replaced in the
/// section's order, other text stays.
Words library_message(const std::string& english, const lang::Section& fragments);

/// A number, perhaps with its unit, with a decimal point: it becomes the decimal mark of each language.
Words decimal_words(const std::string& text);

/// A pattern of letters and numbers, the same in all languages: "{E_1} = {0}".
Words formula_words(std::string pattern, std::vector<Words> arguments = {});

/// The text in one language.
inline std::string in(const Words& words, Language language) { return words.in(language); }
/// The text in English: outputs for programs are English, whatever the language of the sheet.
inline std::string in_english(const Words& words) { return words.in(Language::en); }
}  // namespace kinegraph
