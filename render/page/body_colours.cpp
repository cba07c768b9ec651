#include "render/page/body_colours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph::render {
namespace {

constexpr double of_letters = 4.5, of_lines = 3;  // WCAG 2.1: the contrast of type, of parts of a drawing

/// Relative luminance, WCAG 2.1.
double luminance(Colour colour) {
    const auto linear = [](std::uint8_t part) {
        const double share = part / 255.0;
        return share <= 0.04045 ? share / 12.92 : nearest::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast(Colour a, Colour b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

/// So much of `other` in the colour.
Colour mixed(Colour colour, Colour other, double share) {
    const auto part = [&](std::uint8_t own, std::uint8_t there) {
        return static_cast<std::uint8_t>(std::lround(own + share * (there - own)));
    };
    return {part(colour.red, other.red), part(colour.green, other.green), part(colour.blue, other.blue)};
}

/// The colour, with as much of `text` in it as it needs to stand out from each ground.
template <class IsSeen>
Colour moved_to(Colour text, Colour colour, const IsSeen& is_seen) {
    constexpr int parts = 20;
    for (int i = 0; i < parts; ++i)
        if (const Colour each = mixed(colour, text, static_cast<double>(i) / parts); is_seen(each)) return each;
    return text;
}

BodyColour look_of(Colour given, const Theme& theme, std::vector<double> dashes) {
    constexpr double paper_in_tint = 0.84;
    constexpr Colour white{0xFF, 0xFF, 0xFF};
    // On white a line is drawn as given, however pale.
    const double wanted = std::min(of_lines, contrast(given, white));
    const Colour line = moved_to(theme.text, given, [&](Colour each) { return contrast(each, theme.paper) >= wanted; });
    const Colour tint = mixed(line, theme.paper, paper_in_tint);
    const Colour letter = moved_to(theme.text, line, [&](Colour each) {
        return contrast(each, theme.paper) >= of_letters && contrast(each, tint) >= of_letters;
    });
    return {line, tint, letter, std::move(dashes)};
}

}  // namespace

Colour colour_of_number(std::uint32_t number) {
    return {static_cast<std::uint8_t>(number >> 16U), static_cast<std::uint8_t>(number >> 8U & 0xFFU),
            static_cast<std::uint8_t>(number & 0xFFU)};
}

Theme with_colours_of(Theme theme, const Mechanism& mechanism) {
    const auto& bodies = mechanism.bodies;
    const bool is_coloured = std::any_of(bodies.begin(), bodies.end(), [](const Body& each) { return each.colour; });
    if (theme.in_one_ink || !is_coloured) return theme;
    std::vector<BodyColour> looks;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        const BodyColour& look = theme.body(BodyIndex(i));
        looks.push_back(bodies[i].colour ? look_of(colour_of_number(*bodies[i].colour), theme, look.dashes) : look);
    }
    theme.bodies = std::move(looks);
    return theme;
}

}  // namespace kinegraph::render
