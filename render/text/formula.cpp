#include "render/text/formula.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/functions.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

bool is_upright(std::string_view index) {
    // Numbers and words such as max are upright; single letters are variables.
    return index.size() > 2 || std::any_of(index.begin(), index.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Piece symbol(std::string_view name) {
    Piece piece;
    piece.face = name.starts_with('!') ? Face::bold_italic : Face::italic;
    if (name.starts_with('!')) name.remove_prefix(1);
    const std::size_t power = name.find('^');
    if (power != std::string_view::npos) piece.sup = name.substr(power + 1);
    name = name.substr(0, power);
    const std::size_t index = name.find('_');
    if (index != std::string_view::npos) {
        piece.sub = name.substr(index + 1);
        piece.sub_face = is_upright(piece.sub) ? Face::regular : Face::italic;
    }
    piece.text = name.substr(0, index);
    if (piece.text.ends_with('*') && piece.text.size() > 1) {
        piece.text.pop_back();
        piece.sup = "*" + piece.sup;
    }
    return piece;
}

/// Without trailing zeros, and without the rounding noise of a division.
std::string given(double value, Language language) {
    const double power = nearest::pow(10.0, 9 - std::floor(nearest::log10(std::abs(value))));
    const double round = value == 0 ? 0 : std::round(value * power) / power;
    const std::string text = shortest(round, language);
    constexpr std::size_t longest = 9;
    return character_count(text) > longest ? number(value, 4, language) : text;
}

}  // namespace

RichText formula(std::string_view text) {
    RichText set;
    std::string plain;
    const auto flush = [&] {
        if (!plain.empty()) append(set, with_powers(plain));
        plain.clear();
    };
    for (std::size_t at = 0; at < text.size();) {
        const bool power = text.substr(at).starts_with("^{");
        const std::size_t end = power || text[at] == '{' ? text.find('}', at) : std::string_view::npos;
        if (end == std::string_view::npos) {
            plain += text[at++];
        } else if (power) {
            const std::string exponent(text.substr(at + 2, end - at - 2));
            // An exponent of the bracket or letter before it.
            Piece base;
            if (!plain.empty()) {
                base.text = plain.back();
                plain.pop_back();
                flush();
                base.sup = exponent;
                set.push_back(std::move(base));
            } else if (!set.empty()) {
                set.back().sup += exponent;
            }
            at = end + 1;
        } else {
            flush();
            set.push_back(symbol(text.substr(at + 1, end - at - 1)));
            at = end + 1;
        }
    }
    flush();
    return set;
}

RichText vector_formula(std::string_view text) {
    RichText set = formula(text);
    for (Piece& piece : set)
        if (piece.face == Face::italic) piece.face = Face::bold_italic;
    return set;
}

RichText symbol_of(const std::string& name) { return {symbol(name)}; }

Unit suitable_unit(double si, QuantityKind kind, const Units& units) {
    const double size = std::abs(si);
    switch (kind) {
        case QuantityKind::length:
            if (size > 0 && size < 1e-5 && units.length.symbol != "in" && units.length.symbol != "ft")
                return {"µm", Exact::ratio(1, 1000000)};
            return units.length;
        case QuantityKind::pressure:
            // Elastic moduli are some thousand times larger than pressures in the same problem.
            if (units.pressure.symbol == "MPa" && size >= 1e10) return {"GPa", 1000000000};
            if (units.pressure.symbol != "Pa") return units.pressure;
            if (size >= 1e9) return {"GPa", 1000000000};
            if (size >= 1e4 || size == 0) return {"MPa", 1000000};
            return units.pressure;
        case QuantityKind::angle: return {"°", pi() / 180};
        case QuantityKind::wear: return {"mm³/(N m)", Exact::ratio(1, 1000000000)};
        default: return unit_of(kind, units);
    }
}

namespace {

std::string bound_amount(double si, QuantityKind kind, const Units& units, Language language, int digits) {
    const Unit unit = suitable_unit(si, kind, units);
    const double in_unit = si / unit.si.to_double();
    const std::string value = digits == as_given ? given(in_unit, language) : number(in_unit, digits, language);
    return unit.symbol.empty() || unit.symbol == "°" ? value + unit.symbol : with_unit(value, unit.symbol);
}

}  // namespace

std::string amount(double si, QuantityKind kind, const Units& units, Language language, int digits) {
    return unbound(bound_amount(si, kind, units, language, digits));
}
Words amount(double si, QuantityKind kind, const Units& units, int digits) {
    return in_all([&](Language language) { return bound_amount(si, kind, units, language, digits); });
}
Words numeral(double value, int digits) {
    return in_all([&](Language language) {
        return digits == as_given ? given(value, language) : number(value, digits, language);
    });
}

}  // namespace kinegraph::render
