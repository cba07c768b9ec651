// The parser: recursive descent. After a fault it stands at the text's end, so that every rule returns.
#include "engine/file/formula_syntax.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

constexpr int deepest_syntax = 100;
/// Of a formula, so that its tree is of some megabytes at most.
constexpr std::size_t longest_text(SyntaxOf text) { return text == SyntaxOf::formula ? 100'000 : 1000; }

/// Length in bytes of the UTF-8 letter here that may be part of a name; 0: none.
std::size_t letter_at(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(i < text.size() ? text[i] : 0); };
    if (byte(at) < 0x80) return std::isalpha(byte(at)) != 0 || byte(at) == '_' ? 1 : 0;
    // Latin with accents, Greek, Cyrillic; `°`, `²`, `·`, `µ` and the signs below À are no letters.
    return byte(at) >= 0xC3 && byte(at) <= 0xD4 && (byte(at + 1) & 0xC0U) == 0x80 ? 2 : 0;
}
bool digit_at(std::string_view text, std::size_t at) { return at < text.size() && is_digit(text[at]); }

/// "°", "²", "·".
bool is_sign(std::string_view text) { return !text.empty() && static_cast<unsigned char>(text.front()) >= 0x80; }

class SyntaxReader {
    using Kind = Syntax::Kind;
    using Fault = Syntax::Fault;

public:
    SyntaxReader(std::string_view text, const Grammar& grammar) : text_(text), grammar_(grammar) {}

    Syntax whole() {
        if (text_.size() > longest_text(grammar_.text)) return fault(Fault::too_long);
        Syntax tree = sum();
        skip();
        if (rest().empty()) return tree;
        const bool is_value = letter_at(rest(), 0) > 0 || digit_at(rest(), 0) || is_sign(rest()) ||
                              rest().starts_with('(') || (grammar_.has_quoted_names && rest().starts_with('\''));
        return fault(is_value ? Fault::behind_value : Fault::unexpected, std::move(tree));
    }

private:
    std::string_view rest() const { return text_.substr(at_); }
    void skip() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }
    /// Skips the character; false where the next one is different.
    bool takes(char c) {
        skip();
        if (!rest().starts_with(c)) return false;
        ++at_;
        return true;
    }
    /// What stands from there to here.
    std::string_view since(std::size_t from) const {
        return text_.substr(from, text_.substr(0, at_).find_last_not_of(" \t") + 1 - from);
    }
    template <class... Parts>
    static Syntax node(Kind kind, std::size_t from, std::string_view text, Parts... parts) {
        Syntax made{.kind = kind, .at = from, .text = text};
        (made.parts.push_back(std::move(parts)), ...);
        return made;
    }
    /// A fault here, behind what was read.
    template <class... Read>
    Syntax fault(Fault which, Read... read) {
        if (which == Fault::unexpected || which == Fault::behind_value) {
            if (rest().empty()) which = Fault::ends;
            if (rest().starts_with("−") || rest().starts_with("–")) which = Fault::foreign_minus;
            if (rest().starts_with("·") || rest().starts_with("×")) which = Fault::foreign_times;
        }
        Syntax found = node(Kind::fault, at_, rest(), std::move(read)...);
        found.fault = which;
        at_ = text_.size();
        return found;
    }

    /// A sum or a product: operands joined by two signs.
    Syntax joined(Kind kind, char sign, char inverse, Syntax (SyntaxReader::*next)()) {
        skip();
        Syntax all = node(kind, at_, {});
        all.parts.push_back((this->*next)());
        for (;;) {
            const bool is_inverse = takes(inverse);
            if (!is_inverse && !takes(sign)) break;
            all.parts.push_back((this->*next)());
            all.parts.back().is_inverse = is_inverse;
        }
        if (all.parts.size() == 1) return std::move(all.parts.front());
        all.text = since(all.at);
        return all;
    }
    Syntax sum() {
        if (++depth_ > deepest_syntax) return fault(Fault::nested_brackets);
        Syntax read = joined(Kind::sum, '+', '-', &SyntaxReader::product);
        --depth_;
        return read;
    }
    Syntax product() { return joined(Kind::product, '*', '/', &SyntaxReader::factor); }
    Syntax factor() {
        skip();
        const std::size_t from = at_;
        bool negative = false;
        for (bool minus = false; (minus = takes('-')) || takes('+');) negative = negative != minus;
        Syntax read = power();
        return negative ? node(Kind::negative, from, since(from), std::move(read)) : std::move(read);
    }
    Syntax power() {
        skip();
        const std::size_t from = at_;
        Syntax base = operand();
        if (!takes('^')) return base;
        Syntax exponent = ++depth_ > deepest_syntax ? fault(Fault::nested_powers) : factor();
        --depth_;
        return node(Kind::power, from, since(from), std::move(base), std::move(exponent));
    }
    Syntax operand() {
        if (takes('(')) {
            Syntax inner = sum();
            if (takes(')')) return inner;
            return fault(Fault::bracket_open, std::move(inner));
        }
        if (grammar_.has_bars && takes('|')) return bars();
        if (grammar_.has_quoted_names && takes('\'')) return quoted_name();
        if (const std::size_t length = grammar_.name_length(rest()); length > 0) return name(length);
        if (digit_at(text_, at_) || rest().starts_with('.')) return number();
        return fault(Fault::unexpected);
    }
    Syntax bars() {
        Syntax length = node(Kind::function, at_ - 1, "abs");
        length.parts.push_back(sum());
        if (!takes('|')) length.parts.push_back(fault(Fault::bar_open));
        return length;
    }
    Syntax quoted_name() {
        // A quote that neither ends the text nor stands before a sign belongs to the name: 'v B''.
        const auto closes = [&](std::size_t quote) {
            const std::size_t next = text_.find_first_not_of(" \t", quote + 1);
            return next == std::string_view::npos ||
                   std::string_view("+-*/^)|,=").find(text_[next]) != std::string_view::npos;
        };
        const std::size_t from = at_;
        std::size_t end = text_.find('\'', from);
        while (end != std::string_view::npos && !closes(end)) end = text_.find('\'', end + 1);
        if (end == std::string_view::npos) return fault(Fault::quote_open);
        at_ = end + 1;
        return node(Kind::name, from, text_.substr(from, end - from));
    }
    Syntax name(std::size_t length) {
        Syntax read = node(Kind::name, at_, rest().substr(0, length));
        at_ += length;
        if (!takes('(')) return read;
        read.kind = Kind::function;
        do read.parts.push_back(sum());
        while (takes(','));
        if (!takes(')')) read.parts.push_back(fault(Fault::bracket_open));
        return read;
    }
    Syntax number() {
        Syntax read = node(Kind::number, at_, rest().substr(0, number_length(rest())));
        at_ += read.text.size();
        const std::size_t unit = std::min(text_.find_first_not_of(' ', at_), text_.size());
        if (const std::size_t length = unit_length(text_.substr(unit), grammar_); length > 0) {
            read.unit_text = text_.substr(unit, length);
            read.unit = unit_spelt(read.unit_text);
            at_ = unit + length;
            return read;
        }
        skip();
        if (grammar_.name_length(rest()) == 0) return read;
        return fault(Fault::behind_number, std::move(read));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    const Grammar& grammar_;
    int depth_ = -1;  ///< of brackets and powers; the sum that is the whole text makes it 0
};

}  // namespace

Syntax read_syntax(std::string_view text, const Grammar& grammar) { return SyntaxReader(text, grammar).whole(); }

const Syntax* first_fault(const Syntax& of) {
    for (const Syntax& part : of.parts)
        if (const Syntax* const found = first_fault(part)) return found;
    return of.kind == Syntax::Kind::fault ? &of : nullptr;
}

Words words_of(const Syntax& fault, SyntaxOf text) {
    using namespace lang::expressions;
    // In the order of the faults; {0}: the limit, or the text from there on.
    static constexpr std::array<std::array<Key, 2>, 13> messages{{
        {is_not_understood_here_brackets_numbers, is_not_understood_here_brackets_numbers},
        {the_formula_ends_where_a_number, the_expression_ends_where_a_number},
        {a_minus_is_written_in_a, a_minus_is_written},
        {a_product_is_written_in_a, a_product_is_written},
        {is_not_understood_here_brackets_numbers, is_not_understood_here_brackets_numbers},
        {a_product_is_written_in_a, a_product_is_written},
        {a_product_is_written_in_a, a_product_is_written},
        {a_bracket_is_not_closed, a_bracket_is_not_closed},
        {a_bar_is_not_closed, a_bar_is_not_closed},
        {a_quotation_mark_is_not_closed, a_quotation_mark_is_not_closed},
        {a_formula_with_more_than_brackets, an_expression_with_more_than_brackets},
        {too_many_powers_upon_each_other, an_expression_with_more_than_brackets},
        {a_formula_of_more_than_characters, an_expression_of_more_than_characters},
    }};
    const bool nests = fault.fault == Syntax::Fault::nested_brackets || fault.fault == Syntax::Fault::nested_powers;
    const std::string place = nests                                    ? std::to_string(deepest_syntax)
                              : fault.fault == Syntax::Fault::too_long ? std::to_string(longest_text(text))
                                                                       : quoted(fault.text);
    return {messages.at(static_cast<std::size_t>(fault.fault)).at(static_cast<std::size_t>(text)), place};
}

std::size_t word_length(std::string_view text) {
    std::size_t at = letter_at(text, 0);
    for (std::size_t more = at; more > 0; at += more) more = digit_at(text, at) ? 1 : letter_at(text, at);
    return at;
}

std::size_t unit_length(std::string_view text, const Grammar& grammar) {
    if (letter_at(text, 0) == 0 && !is_sign(text)) return 0;
    constexpr std::size_t longest_unit = 16;
    const std::size_t shortest = std::max<std::size_t>(grammar.name_length(text), 1);
    for (std::size_t length = std::min(longest_unit, text.size()); length >= shortest; --length) {
        const std::string_view spelt = text.substr(0, length);
        const bool is_cut = letter_at(spelt, length - 1) > 0 && (letter_at(text, length) > 0 || digit_at(text, length));
        if (is_cut || spelt.find('*') != std::string_view::npos || spelt.ends_with(' ')) continue;
        if (unit_spelt(spelt) != nullptr && (!grammar.is_unit || grammar.is_unit(spelt))) return length;
    }
    return 0;
}

}  // namespace kinegraph
