// The parser: recursive descent. After a fault it stands at the text's end, so that every rule returns.
#include "engine/file/formula_syntax.hpp"

#include <algorithm>
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
    Syntax node(Kind kind, std::size_t from, std::vector<Syntax> parts = {}) const {
        const std::size_t end = text_.substr(0, at_).find_last_not_of(" \t") + 1;
        return {.kind = kind, .at = from, .text = text_.substr(from, end - from), .parts = std::move(parts)};
    }
    /// A fault here, behind what was read.
    template <class... Read>
    Syntax fault(Fault which, Read... read) {
        if (which == Fault::unexpected || which == Fault::behind_value) {
            if (rest().empty()) which = Fault::ends;
            if (rest().starts_with("−") || rest().starts_with("–")) which = Fault::foreign_minus;
            if (rest().starts_with("·") || rest().starts_with("×")) which = Fault::foreign_times;
        }
        Syntax found{.kind = Kind::fault, .fault = which, .at = at_, .text = rest()};
        (found.parts.push_back(std::move(read)), ...);
        at_ = text_.size();
        return found;
    }

    /// A sum or a product: operands joined by two signs.
    Syntax joined(Kind kind, char sign, char inverse, Syntax (SyntaxReader::*next)()) {
        skip();
        const std::size_t from = at_;
        std::vector<Syntax> parts;
        parts.push_back((this->*next)());
        for (;;) {
            const bool is_inverse = takes(inverse);
            if (!is_inverse && !takes(sign)) break;
            parts.push_back((this->*next)());
            parts.back().is_inverse = is_inverse;
        }
        return parts.size() == 1 ? std::move(parts.front()) : node(kind, from, std::move(parts));
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
        if (!negative) return read;
        std::vector<Syntax> parts;
        parts.push_back(std::move(read));
        return node(Kind::negative, from, std::move(parts));
    }
    Syntax power() {
        skip();
        const std::size_t from = at_;
        std::vector<Syntax> parts;
        parts.push_back(operand());
        if (!takes('^')) return std::move(parts.front());
        parts.push_back(++depth_ > deepest_syntax ? fault(Fault::nested_powers) : factor());
        --depth_;
        return node(Kind::power, from, std::move(parts));
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
        const std::size_t from = at_ - 1;
        std::vector<Syntax> parts;
        parts.push_back(sum());
        if (!takes('|')) parts.push_back(fault(Fault::bar_open));
        Syntax length = node(Kind::function, from, std::move(parts));
        length.text = "abs";
        return length;
    }
    Syntax quoted_name() {
        const std::size_t from = at_;
        const std::size_t end = text_.find('\'', from);
        if (end == std::string_view::npos) return fault(Fault::quote_open);
        at_ = end;
        Syntax read = node(Kind::name, from);
        ++at_;
        return read;
    }
    Syntax name(std::size_t length) {
        Syntax read = node(Kind::name, at_);
        read.text = text_.substr(at_, length);
        at_ += length;
        if (!takes('(')) return read;
        read.kind = Kind::function;
        do read.parts.push_back(sum());
        while (takes(','));
        if (!takes(')')) read.parts.push_back(fault(Fault::bracket_open));
        return read;
    }
    Syntax number() {
        const std::size_t from = at_;
        at_ += number_length(rest());
        Syntax read = node(Kind::number, from);
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
    int depth_ = 0;
};

}  // namespace

Syntax read_syntax(std::string_view text, const Grammar& grammar) { return SyntaxReader(text, grammar).whole(); }

const Syntax* first_fault(const Syntax& of) {
    for (const Syntax& part : of.parts)
        if (const Syntax* const found = first_fault(part)) return found;
    return of.kind == Syntax::Kind::fault ? &of : nullptr;
}

Words words_of(const Syntax& fault, SyntaxOf text) {
    namespace say = lang::expressions;
    const bool of_formula = text == SyntaxOf::formula;
    switch (fault.fault) {
        case Syntax::Fault::ends:
            return of_formula ? say::the_formula_ends_where_a_number : say::the_expression_ends_where_a_number;
        case Syntax::Fault::foreign_minus: return of_formula ? say::a_minus_is_written_in_a : say::a_minus_is_written;
        case Syntax::Fault::foreign_times:
        case Syntax::Fault::behind_number:
        case Syntax::Fault::behind_value:
            return {of_formula ? say::a_product_is_written_in_a : say::a_product_is_written, quoted(fault.text)};
        case Syntax::Fault::bracket_open: return say::a_bracket_is_not_closed;
        case Syntax::Fault::bar_open: return say::a_bar_is_not_closed;
        case Syntax::Fault::quote_open: return say::a_quotation_mark_is_not_closed;
        case Syntax::Fault::nested_powers:
            if (of_formula) return say::too_many_powers_upon_each_other;
            [[fallthrough]];
        case Syntax::Fault::nested_brackets:
            return {of_formula ? say::a_formula_with_more_than_brackets : say::an_expression_with_more_than_brackets,
                    std::to_string(deepest_syntax)};
        case Syntax::Fault::too_long:
            return {of_formula ? say::a_formula_of_more_than_characters : say::an_expression_of_more_than_characters,
                    std::to_string(longest_text(text))};
        case Syntax::Fault::unexpected:
        case Syntax::Fault::none: break;
    }
    return {say::is_not_understood_here_brackets_numbers, quoted(fault.text)};
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
