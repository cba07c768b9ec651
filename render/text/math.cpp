#include "render/text/math.hpp"

#include <algorithm>
#include <array>

#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

struct Greek {
    std::string_view name, unicode, latex;
};
constexpr auto greek =
    std::to_array<Greek>({{"alpha", "α", "\\alpha"}, {"beta", "β", "\\beta"},     {"gamma", "γ", "\\gamma"},
                          {"delta", "δ", "\\delta"}, {"phi", "φ", "\\varphi"},    {"epsilon", "ε", "\\varepsilon"},
                          {"eta", "η", "\\eta"},     {"kappa", "κ", "\\kappa"},   {"mu", "μ", "\\mu"},
                          {"nu", "ν", "\\nu"},       {"chi", "χ", "\\chi"},       {"rho", "ρ", "\\rho"},
                          {"tau", "τ", "\\tau"},     {"zeta", "ζ", "\\zeta"},     {"xi", "ξ", "\\xi"},
                          {"sigma", "σ", "\\sigma"}, {"lambda", "λ", "\\lambda"}, {"Lambda", "Λ", "\\Lambda"},
                          {"omega", "ω", "\\omega"}, {"theta", "θ", "\\theta"},   {"Delta", "Δ", "\\Delta"}});

const Greek* greek_named(std::string_view name) {
    const auto* const found =
        std::find_if(greek.begin(), greek.end(), [&](const Greek& each) { return each.name == name; });
    return found == greek.end() ? nullptr : &*found;
}

/// Escapes the characters of any name for LaTeX text.
std::string escaped(const std::string& text) {
    constexpr auto special = std::to_array<std::pair<char, std::string_view>>({{'\\', "\\textbackslash{}"},
                                                                               {'^', "\\textasciicircum{}"},
                                                                               {'~', "\\textasciitilde{}"},
                                                                               {'{', "\\{"},
                                                                               {'}', "\\}"},
                                                                               {'_', "\\_"},
                                                                               {'%', "\\%"},
                                                                               {'$', "\\$"},
                                                                               {'#', "\\#"},
                                                                               {'&', "\\&"}});
    std::string safe;
    for (const char c : text) {
        const auto* const found =
            std::find_if(special.begin(), special.end(), [&](const auto& each) { return each.first == c; });
        if (found == special.end())
            safe += c;
        else
            safe += found->second;
    }
    return safe;
}

/// The first entry that the text begins with.
template <class Table>
auto begun_with(std::string_view text, const Table& table) {
    const auto* const found =
        std::find_if(table.begin(), table.end(), [&](const auto& each) { return text.starts_with(each.first); });
    return found == table.end() ? nullptr : found;
}

/// A number, a unit or words in LaTeX's math mode.
std::string latex_of_upright(std::string_view text) {
    using Spelling = std::pair<std::string_view, std::string_view>;
    constexpr auto known = std::to_array<Spelling>({{"−", "-"},
                                                    {"°", "^{\\circ}"},
                                                    {"∂", "\\partial "},
                                                    {"×", "\\times "},
                                                    {"·", "\\cdot "},
                                                    {"–", "\\text{--}"},
                                                    {"′", "'"},
                                                    {"″", "''"},
                                                    {"µ", "\\mu "}});
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::string words, exponent, out;
    const auto flush = [&] {
        if (!words.empty()) out += "\\text{" + escaped(words) + "}";
        if (!exponent.empty()) out += "^{" + exponent + "}";
        words.clear();
        exponent.clear();
    };
    while (!text.empty()) {
        if (const auto* const up = begun_with(text, raised_characters)) {
            const std::string before = std::exchange(exponent, {});
            flush();
            exponent = before + (up->second == "−" ? "-" : std::string(up->second));
            text.remove_prefix(up->first.size());
            continue;
        }
        if (!exponent.empty()) flush();
        if (const auto* const sign = begun_with(text, known)) {
            flush();
            out += sign->second;
            text.remove_prefix(sign->first.size());
        } else if (words.empty() && is_digit(text.front())) {
            std::size_t end = 0;
            while (end < text.size() && (is_digit(text[end]) || text[end] == '.' || text[end] == ',')) {
                out += text[end] == ',' ? "{,}" : std::string(1, text[end]);
                ++end;
            }
            text.remove_prefix(end);
        } else {
            words += text.front();
            text.remove_prefix(1);
        }
    }
    flush();
    return out;
}

/// Upright, except for Greek letters.
std::string latex_of_sub(std::string_view text) {
    std::string out, words;
    const auto flush = [&] {
        if (!words.empty()) out += "\\text{" + escaped(words) + "}";
        words.clear();
    };
    while (!text.empty()) {
        const auto* const found =
            std::find_if(greek.begin(), greek.end(), [&](const Greek& each) { return text.starts_with(each.unicode); });
        if (found != greek.end()) {
            flush();
            out += std::string(found->latex) + " ";
            text.remove_prefix(found->unicode.size());
        } else {
            words += text.front();
            text.remove_prefix(1);
        }
    }
    flush();
    return out;
}

}  // namespace

std::string unicode_letter(std::string_view name) {
    const Greek* const found = greek_named(name);
    return std::string(found == nullptr ? name : found->unicode);
}

std::string letter_spelt(std::string_view unicode) {
    const auto* const found =
        std::find_if(greek.begin(), greek.end(), [&](const Greek& each) { return each.unicode == unicode; });
    return std::string(found == greek.end() ? unicode : found->name);
}

Formula Formula::letter(std::string_view name, const std::string& sub, int dots) {
    Formula made;
    made.kind = Kind::text;
    Piece piece;
    piece.text = unicode_letter(name);
    piece.face = name == "Lambda" || name == "Delta" ? Face::regular : Face::italic;
    piece.sub = sub;
    piece.sub_face = Face::regular;
    piece.dots = dots;
    made.text = {piece};
    const Greek* const found = greek_named(name);
    made.as_latex = found != nullptr   ? std::string(found->latex)
                    : name.size() == 1 ? std::string(name)
                                       : "\\textit{" + escaped(std::string(name)) + "}";
    if (dots == 1) made.as_latex = "\\dot{" + made.as_latex + "}";
    if (dots == 2) made.as_latex = "\\ddot{" + made.as_latex + "}";
    if (!sub.empty()) made.as_latex += "_{" + latex_of_sub(sub) + "}";
    made.as_latex += " ";
    // Combining dots above.
    constexpr std::array<const char*, 3> accents{"", "\u0307", "\u0308"};
    made.as_plain = piece.text + accents.at(static_cast<std::size_t>(dots)) + (sub.empty() ? "" : "_" + sub);
    return made;
}

Formula Formula::primed(std::string_view name, const std::string& sub, int primes) {
    constexpr std::array<const char*, 3> marks{"", "′", "″"};
    const std::string mark = marks.at(static_cast<std::size_t>(primes));
    Formula made = letter(name, sub);
    made.text.front().text += mark;
    made.as_latex.pop_back();
    made.as_latex += std::string(static_cast<std::size_t>(primes), '\'') + " ";
    made.as_plain = made.text.front().text + (sub.empty() ? "" : "_" + sub);
    return made;
}

Formula Formula::upright(const std::string& text) {
    Formula made;
    made.kind = Kind::text;
    made.text = with_powers(text);
    made.as_latex = latex_of_upright(text);
    made.as_plain = text;
    return made;
}

Formula Formula::function(const std::string& name) {
    Formula made = upright(name);
    // A thin space, as before a factor.
    made.text.front().text += "\u200A";
    // LaTeX has no command for the Spanish sen.
    made.as_latex =
        name == "sin" || name == "cos" || name == "tan" ? "\\" + name + " " : "\\operatorname{" + name + "} ";
    made.as_plain = name + " ";
    return made;
}

Formula Formula::sign(const std::string& text) {
    Formula made;
    made.kind = Kind::sign;
    made.text = one_piece("\u2009" + text + "\u2009");
    made.as_latex = text == "−" ? " - " : text == "±" ? " \\pm " : text == "→" ? " \\to " : " " + text + " ";
    made.as_plain = " " + text + " ";
    return made;
}

Formula Formula::fraction(Formula above, Formula below) {
    Formula made;
    made.kind = Kind::fraction;
    made.parts = {std::move(above), std::move(below)};
    return made;
}
Formula Formula::root(Formula of) {
    Formula made;
    made.kind = Kind::root;
    made.parts = {std::move(of)};
    return made;
}
Formula Formula::power(Formula base, Formula exponent) {
    Formula made;
    made.kind = Kind::power;
    made.parts = {std::move(base), std::move(exponent)};
    return made;
}
Formula Formula::fenced(Formula inside) {
    Formula made;
    made.kind = Kind::fence;
    made.parts = {std::move(inside)};
    return made;
}
Formula Formula::matrix(std::vector<Formula> entries, std::size_t columns, const char* between) {
    Formula made;
    made.kind = Kind::matrix;
    made.parts = std::move(entries);
    made.columns = columns;
    made.as_plain = between;
    return made;
}

Formula& Formula::operator+=(Formula more) {
    if (kind != Kind::row) {
        Formula own = std::move(*this);
        *this = Formula();
        parts.push_back(std::move(own));
    }
    if (more.kind == Kind::row)
        parts.insert(parts.end(), std::make_move_iterator(more.parts.begin()),
                     std::make_move_iterator(more.parts.end()));
    else
        parts.push_back(std::move(more));
    return *this;
}

bool Formula::stands_close() const {
    const bool is_between = as_plain.starts_with(' ') && as_plain.ends_with(' ');
    return kind == Kind::text && !is_between && (as_plain.starts_with(' ') || as_plain.starts_with(','));
}

bool Formula::is_differential() const {
    if (kind == Kind::power) return parts[0].is_differential();
    return kind == Kind::text && (as_plain == "d" || as_plain == "∂") && text.front().face == Face::regular;
}

std::string Formula::plain() const {
    const auto inner = [](const Formula& part) {
        const std::string own = part.plain();
        const bool alone = part.kind != Kind::row || part.parts.size() < 2 || part.parts.front().is_differential();
        return alone ? own : "(" + own + ")";
    };
    switch (kind) {
        case Kind::row: {
            std::string all;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const std::string own = parts[i].plain();
                const bool close = i == 0 || parts[i].kind == Kind::sign || parts[i - 1].kind == Kind::sign ||
                                   all.ends_with(' ') || own.starts_with(' ') || own.starts_with(',') ||
                                   parts[i - 1].is_differential();
                all += (close ? "" : " ") + own;
            }
            return all;
        }
        case Kind::text:
        case Kind::sign: return as_plain;
        case Kind::fraction: return inner(parts[0]) + "/" + inner(parts[1]);
        case Kind::root: return "√(" + parts[0].plain() + ")";
        case Kind::power:
            return inner(parts[0]) + "^" +
                   (parts[1].kind == Kind::row ? "{" + parts[1].plain() + "}" : parts[1].plain());
        case Kind::fence: return "(" + parts[0].plain() + ")";
        case Kind::matrix: {
            const std::string between_rows = "; ";
            const bool has_own_brackets = columns > 1 && as_plain == between_rows;
            std::string all = has_own_brackets ? "[[" : "[";
            for (std::size_t i = 0; i < parts.size(); ++i) {
                if (i > 0)
                    all += i % columns > 0 ? as_plain : has_own_brackets ? "]" + between_rows + "[" : between_rows;
                all += parts[i].plain();
            }
            return all + (has_own_brackets ? "]]" : "]");
        }
    }
    return {};
}

std::string Formula::latex() const {
    switch (kind) {
        case Kind::row: {
            std::string all;
            for (const Formula& part : parts) all += part.latex();
            return all;
        }
        case Kind::text:
        case Kind::sign: return as_latex;
        case Kind::fraction: return "\\frac{" + parts[0].latex() + "}{" + parts[1].latex() + "}";
        case Kind::root: return "\\sqrt{" + parts[0].latex() + "}";
        case Kind::power: return "{" + parts[0].latex() + "}^{" + parts[1].latex() + "}";
        case Kind::fence: return "\\left(" + parts[0].latex() + "\\right)";
        case Kind::matrix: {
            std::string all = "\\left[\\begin{array}{" + std::string(columns, 'c') + "}";
            for (std::size_t i = 0; i < parts.size(); ++i)
                all += (i == 0 ? "" : i % columns == 0 ? " \\\\ " : " & ") + parts[i].latex();
            return all + "\\end{array}\\right]";
        }
    }
    return {};
}

}  // namespace kinegraph::render
