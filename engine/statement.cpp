// Plain names of symbols: the ASCII form that ids, tables and results share. Knows no typography.
#include "engine/statement.hpp"

#include <string_view>

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

std::string lower_case(std::string_view name) {
    std::string out;
    for (const char c : name) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

std::string_view stem(Symbol::Letter letter) {
    switch (letter) {
        case Symbol::Letter::point:
        case Symbol::Letter::image:
        case Symbol::Letter::length:
        case Symbol::Letter::body:
            return "";
        case Symbol::Letter::pole:
            return "o";
        case Symbol::Letter::v:
            return "v";
        case Symbol::Letter::a:
            return "a";
        case Symbol::Letter::omega:
            return "omega";
        case Symbol::Letter::alpha:
            return "alpha";
        case Symbol::Letter::centre:
            return "P";
        case Symbol::Letter::F:
            return "F";
        case Symbol::Letter::M:
            return "M";
        case Symbol::Letter::speed:
            return "s";
    }
    KG_ASSERT(false, "a symbol has a letter");
}

}  // namespace

std::string name_of(const Symbol& symbol) {
    if (symbol.letter == Symbol::Letter::image) return lower_case(symbol.about) + symbol.term;
    std::string name(stem(symbol.letter));
    // What the file calls F_gas, or M, keeps its name.
    const bool own_name = (symbol.letter == Symbol::Letter::F || symbol.letter == Symbol::Letter::M) &&
                          (symbol.about == name || symbol.about.starts_with(name + "_"));
    if (own_name) name.clear();
    if (!symbol.about.empty()) name += (name.empty() ? "" : "_") + symbol.about;
    // That a centre lies at infinity is a property of where it is, not of its name.
    if (!symbol.term.empty() && symbol.term != "∞") name += (name.empty() ? "" : "_") + symbol.term;
    return name;
}

}  // namespace kinegraph
