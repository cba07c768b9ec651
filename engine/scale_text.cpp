// Scales, read exactly.
#include "engine/scale_text.hpp"

namespace kinegraph {

std::string scale_example(QuantityKind kind) {
    const std::string by_unit = "\"1 mm = 0.1 " + std::string(default_unit(kind).symbol) + "\"";
    return " such as " + (kind == QuantityKind::length ? "\"1:5\" or " + by_unit : by_unit);
}

tl::expected<Exact, std::string> read_scale(std::string_view text, QuantityKind kind) {
    const auto trimmed = [](std::string_view part) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        return part;
    };
    const auto refuse = [&](std::string reason) {
        return tl::make_unexpected(quoted(text) + " is no scale of this figure: " + std::move(reason) + "; write one" +
                                   scale_example(kind));
    };
    const Exact millimetres_in_metre(1000);
    Exact paper;
    Exact drawn;
    std::size_t at = text.find(':');
    if (at != std::string_view::npos) {
        if (kind != QuantityKind::length) return refuse("a ratio of lengths is for drawings of the mechanism");
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
        if (at == std::string_view::npos) return refuse("it has neither \":\" nor \"=\"");
        const auto left = read_quantity(trimmed(text.substr(0, at)), QuantityKind::length);
        if (!left) return refuse(left.error());
        const auto right = read_quantity(trimmed(text.substr(at + size)), kind);
        if (!right) return refuse(right.error());
        if (left->unit->kind != QuantityKind::length) return refuse("on the left stands a length on paper");
        if (right->unit->kind != kind) {
            return refuse(quoted(trimmed(text.substr(at + size))) + " is " + with_article(right->unit->kind) + ", and " +
                          with_article(kind) + " is wanted");
        }
        paper = left->in_si();
        drawn = right->in_si();
    }
    if (paper.sign() <= 0 || drawn.sign() <= 0) return refuse("both sides must be greater than zero");
    Exact scale = drawn / (paper * millimetres_in_metre);
    if (!is_within_range(scale) || !is_within_range(paper) || !is_within_range(drawn))
        return refuse("it is outside 1e-60 … 1e60");
    return scale;
}

}  // namespace kinegraph
