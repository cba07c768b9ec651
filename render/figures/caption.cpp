// Captions and scales in words.
#include "render/figures/caption.hpp"

#include <cmath>

#include "engine/number/functions.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

/// The decimal of seven digits that equals the scale except for rounding in the last bits; else the scale itself.
double without_last_bits(double value) {
    const double power = nearest::pow(10.0, 6 - std::floor(nearest::log10(value)));
    const double round = std::round(value * power) / power;
    return std::abs(round - value) < 1e-12 * value ? round : value;
}
std::string shortest_scale(double value, Language language) {
    const std::string text = shortest(without_last_bits(value), language);
    // A scale derived from a file, such as 14 mm = 16.28 MN, may have no finite decimal.
    constexpr std::size_t longest = 11;  // 1.25 × 10⁻⁴
    return character_count(text) > longest ? number(value, 5, language) : text;
}

}  // namespace

std::string ratio_words(double scale, Language language) {
    const double ratio = without_last_bits(scale * 1000);
    return ratio >= 1 ? "1 : " + shortest(std::round(ratio * 1e9) / 1e9, language)
                      : shortest(std::round(1e9 / ratio) / 1e9, language) + " : 1";
}

RichText scale_words(const DrawingContext& context, const Figure& figure) {
    const Units& units = context.solution.mechanism.units;
    const std::string after = word(lang::notation::semicolon, context.language) + " ";
    const auto scale_of = [&](double scale, const std::string& unit) {
        return with_unit("1", "mm") + " ≙ " + with_unit(shortest_scale(scale, context.language), unit);
    };
    std::string text;
    if (figure.unit == "m") {
        text = ratio_words(figure.scale, context.language);
        // In feet or inches the ratio alone is a plain number.
        constexpr std::size_t plain = 7;
        const double in_unit = figure.scale / units.length.si.to_double();
        if (units.length.symbol != "mm" && character_count(shortest_scale(in_unit, context.language)) < plain)
            text += after + scale_of(in_unit, units.length.symbol);
    } else {
        text = scale_of(figure.scale, figure.unit);
    }
    if (!figure.further_scale.empty()) text += after + figure.further_scale;
    return with_powers(text);
}

namespace {

constexpr double before_scale = 5;  // mm

RichText words_of_caption(const DrawingContext& context, const Figure& figure, int number) {
    RichText text = one_piece(word(lang::sheet::figure, context.language) + " " + std::to_string(number), Face::bold);
    append(text, one_piece("   "));
    append(text, figure.caption);
    return text;
}
ShapedLine shaped_scale(const DrawingContext& context, const Figure& figure) {
    return figure.has_scale ? context.fonts.shape(scale_words(context, figure), context.theme.body_text) : ShapedLine{};
}

}  // namespace

double caption_width(const DrawingContext& context, const Figure& figure, int number) {
    const RichText text = words_of_caption(context, figure, number);
    return context.fonts.shape(text, context.theme.label).width + before_scale + shaped_scale(context, figure).width;
}

double caption_width_without_scale(const DrawingContext& context, const Figure& figure, int number) {
    return context.fonts.width(words_of_caption(context, figure, number), context.theme.label);
}

double set_caption(std::vector<Mark>& marks, const DrawingContext& context, const Figure& figure, int number, Spot at,
                   double width) {
    const Theme& theme = context.theme;
    const RichText text = words_of_caption(context, figure, number);
    ShapedLine caption = context.fonts.shape(text, theme.label);
    ShapedLine scale = shaped_scale(context, figure);
    if (caption.width + before_scale + scale.width <= width) {
        const double scale_at = at.x + caption.width + before_scale;
        set_text(marks, std::move(caption), {at.x, at.y + 3.8}, theme.text, "text");
        set_text(marks, std::move(scale), {scale_at, at.y + 3.8}, theme.secondary, "text");
        return 7;
    }
    double baseline = at.y + 3.8;
    for (ShapedLine& each : context.fonts.wrap(text, theme.label, width)) {
        set_text(marks, std::move(each), {at.x, baseline}, theme.text, "text");
        baseline += 4.7;
    }
    if (scale.width > 0)
        for (ShapedLine& each : context.fonts.wrap(scale_words(context, figure), theme.body_text, width)) {
            set_text(marks, std::move(each), {at.x, baseline}, theme.secondary, "text");
            baseline += 4.4;
        }
    return baseline - 3.8 - at.y + 2;
}

}  // namespace kinegraph::render
