// Plain names of symbols: the ASCII form used by ids, tables and results.
#include "engine/sentences/statement.hpp"

#include <algorithm>
#include <string_view>

#include "engine/number/assert.hpp"
#include "lang/keys/phrases.hpp"

namespace kinegraph {

bool is_phrase(const Key& sentence) { return sentence.section == &lang::phrases_section; }

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
        case Symbol::Letter::body: return "";
        case Symbol::Letter::pole: return "o";
        case Symbol::Letter::v: return "v";
        case Symbol::Letter::a: return "a";
        case Symbol::Letter::omega: return "omega";
        case Symbol::Letter::alpha: return "alpha";
        case Symbol::Letter::centre: return "P";
        case Symbol::Letter::radius: return "rho";
        case Symbol::Letter::diameter: return "delta";
        case Symbol::Letter::error: return "epsilon";
        case Symbol::Letter::F: return "F";
        case Symbol::Letter::M: return "M";
        case Symbol::Letter::speed: return "s";
    }
    KG_ASSERT(false, "a symbol has a letter");
}

}  // namespace

Symbol velocity_of_coriolis(Symbol coriolis, bool observed) {
    coriolis.letter = Symbol::Letter::v;
    coriolis.term = observed ? "rel" + coriolis.term.substr(std::string_view("cor").size()) : "";
    return coriolis;
}

bool has_own_name(const Symbol& symbol) {
    if (symbol.letter != Symbol::Letter::F && symbol.letter != Symbol::Letter::M) return false;
    const std::string_view name = symbol.about;
    // A letter of its kind alone, or with a subscript, a number or small letters: F, F_gas, F1, Fc. A torque is often
    // written T.
    const std::string_view letters = symbol.letter == Symbol::Letter::F ? "F" : "MT";
    if (name.empty() || letters.find(name[0]) == std::string_view::npos) return false;
    if (name.size() == 1 || name[1] == '_' || name.find_first_not_of("0123456789", 1) == std::string_view::npos)
        return true;
    // Mr and Fc are M and F with short subscripts, written without underscore.
    constexpr std::size_t longest = 3;
    const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
    return name.size() <= longest && std::all_of(name.begin() + 1, name.end(), is_small);
}

JointName reader_name(const Mechanism& mechanism, const Joint& joint) {
    const auto slides_there = [&](const Joint& other) {
        return other.point == joint.point && other.pair().has_guide();
    };
    if (!joint.named) return {joint.name, false};
    if (std::count_if(mechanism.joints.begin(), mechanism.joints.end(), slides_there) > 1) return {joint.name, true};
    return {mechanism.point(joint.point).name, false};
}

namespace {

constexpr const char* at_a_new_place = "′";

}  // namespace

Symbol moved_aside(Symbol force) {
    force.term = at_a_new_place;
    return force;
}
bool is_moved_aside(const Symbol& symbol) { return symbol.term == at_a_new_place; }

Symbol where_it_acts(Symbol force) {
    if (is_moved_aside(force)) force.term.clear();
    return force;
}

std::string name_of(const Symbol& symbol) {
    if (symbol.letter == Symbol::Letter::image) return lower_case(symbol.about) + symbol.term;
    std::string name(stem(symbol.letter));
    if (has_own_name(symbol)) name.clear();
    if (!symbol.about.empty()) name += (name.empty() ? "" : "_") + symbol.about;
    if (is_moved_aside(symbol)) return name + "'";
    // That a centre lies at infinity is a property of its position, not of its name.
    if (!symbol.term.empty() && symbol.term != "∞") name += (name.empty() ? "" : "_") + symbol.term;
    return name;
}

}  // namespace kinegraph
