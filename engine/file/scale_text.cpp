#include "engine/file/scale_text.hpp"

namespace kinegraph {

Words scale_example(QuantityKind kind) {
    const std::string by_unit = "\"1 mm = 0.1 " + std::string(default_unit(kind).symbol) + "\"";
    if (kind == QuantityKind::length) return {" such as \"1:5\" or {0}", " come \"1:5\" o {0}", by_unit};
    return {" such as {0}", " come {0}", by_unit};
}

tl::expected<Exact, Words> read_scale(std::string_view text, QuantityKind kind) {
    const auto trimmed = [](std::string_view part) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        return part;
    };
    const auto refuse = [&](const Words& reason) {
        return tl::make_unexpected(Words("{0} is no scale of this figure: {1}; write one{2}",
                                         "{0} non è una scala per questa figura: {1}; scriverne una{2}", quoted(text),
                                         reason, scale_example(kind)));
    };
    const Exact millimetres_in_metre(1000);
    Exact paper;
    Exact drawn;
    std::size_t at = text.find(':');
    if (at != std::string_view::npos) {
        if (kind != QuantityKind::length)
            return refuse({"a ratio of lengths is for drawings of the mechanism",
                           "un rapporto di lunghezze vale per i disegni del meccanismo"});
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
        if (at == std::string_view::npos) return refuse({"it has neither \":\" nor \"=\"", "non ha né \":\" né \"=\""});
        const auto left = read_quantity(trimmed(text.substr(0, at)), QuantityKind::length);
        if (!left) return refuse(left.error());
        const auto right = read_quantity(trimmed(text.substr(at + size)), kind);
        if (!right) return refuse(right.error());
        if (left->unit->kind != QuantityKind::length)
            return refuse({"on the left stands a length on paper", "a sinistra sta una lunghezza sulla carta"});
        if (right->unit->kind != kind) {
            return refuse({"{0} is {1}, and {2} is wanted", "{0} è {1}, e serve {2}",
                           quoted(trimmed(text.substr(at + size))), with_article(right->unit->kind),
                           with_article(kind)});
        }
        paper = left->in_si();
        drawn = right->in_si();
    }
    if (paper.sign() <= 0 || drawn.sign() <= 0)
        return refuse({"both sides must be greater than zero", "i due membri devono essere maggiori di zero"});
    Exact scale = drawn / (paper * millimetres_in_metre);
    if (!is_within_range(scale) || !is_within_range(paper) || !is_within_range(drawn))
        return refuse({"it is outside 1e-60 … 1e60", "è fuori da 1e-60 … 1e60"});
    return scale;
}

}  // namespace kinegraph
