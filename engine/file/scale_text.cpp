#include "engine/file/scale_text.hpp"
#include "lang/keys/units.hpp"

namespace kinegraph {

Words scale_example(QuantityKind kind) {
    const std::string by_unit = "\"1 mm = 0.1 " + std::string(default_unit(kind).symbol) + "\"";
    if (kind == QuantityKind::length) return {lang::units::such_as_1_5, by_unit};
    return {lang::units::such_as, by_unit};
}

tl::expected<Exact, Words> read_scale(std::string_view text, QuantityKind kind) {
    const auto trimmed = [](std::string_view part) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        return part;
    };
    const auto refuse = [&](const Words& reason) {
        return tl::make_unexpected(
            Words(lang::units::is_no_scale_of_this_figure, quoted(text), reason, scale_example(kind)));
    };
    const Exact millimetres_in_metre(1000);
    Exact paper;
    Exact drawn;
    std::size_t at = text.find(':');
    if (at != std::string_view::npos) {
        if (kind != QuantityKind::length) return refuse({lang::units::a_ratio_of_lengths});
        const auto left = read_decimal(trimmed(text.substr(0, at)));
        if (!left) return refuse(left.error());
        const auto right = read_decimal(trimmed(text.substr(at + 1)));
        if (!right) return refuse(right.error());
        paper = *left;
        drawn = *right;
    } else {
        std::size_t size = 1;
        at = text.find('=');
        if (at == std::string_view::npos) {
            constexpr std::string_view corresponds = "≙";
            at = text.find(corresponds);
            size = corresponds.size();
        }
        if (at == std::string_view::npos) return refuse({lang::units::it_has_neither_nor});
        const auto left = read_quantity(trimmed(text.substr(0, at)), QuantityKind::length);
        if (!left) return refuse(left.error());
        const auto right = read_quantity(trimmed(text.substr(at + size)), kind);
        if (!right) return refuse(right.error());
        if (left->unit->kind != QuantityKind::length) return refuse({lang::units::on_the_left_stands_a_length});
        if (right->unit->kind != kind) {
            return refuse({lang::units::is_and_is_wanted, quoted(trimmed(text.substr(at + size))),
                           with_article(right->unit->kind), with_article(kind)});
        }
        paper = left->in_si();
        drawn = right->in_si();
    }
    if (paper.sign() <= 0 || drawn.sign() <= 0) return refuse({lang::units::both_sides_must_be_greater});
    Exact scale = drawn / (paper * millimetres_in_metre);
    if (!is_within_range(scale) || !is_within_range(paper) || !is_within_range(drawn))
        return refuse({lang::units::it_is_outside_1e_60_1e60});
    return scale;
}

}  // namespace kinegraph
