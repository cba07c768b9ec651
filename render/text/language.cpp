// Languages: see language.hpp.
#include "render/text/language.hpp"
#include "lang/keys/notation.hpp"

#include <algorithm>
#include <array>

namespace kinegraph::render {
namespace {

Notation notation_of(Language language) {
    const auto text = [language](Key key) { return key.in(language); };
    return {text(lang::notation::code),
            text(lang::notation::decimal_mark).front(),
            text(lang::notation::between_numbers),
            text(lang::notation::cross_product),
            text(lang::notation::sine),
            text(lang::notation::alpha),
            std::stoi(text(lang::notation::dots_of_alpha)),
            text(lang::notation::centre),
            text(lang::notation::work),
            text(lang::notation::transport),
            text(lang::notation::relative),
            text(lang::notation::coriolis)};
}

}  // namespace

std::string Notation::term(const std::string& own) const {
    const std::size_t end = std::min(own.find(','), own.size());
    const std::string part = own.substr(0, end);
    const std::string& written = part == "tr" ? transport : part == "rel" ? relative : part == "cor" ? coriolis : part;
    return written + own.substr(end);
}

const Notation& notation(Language language) {
    static const auto all = [] {
        std::array<Notation, languages.size()> made;
        std::transform(languages.begin(), languages.end(), made.begin(), notation_of);
        return made;
    }();
    return all.at(static_cast<std::size_t>(language));
}

}  // namespace kinegraph::render
