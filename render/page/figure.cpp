// Operations common to all figures: moving, ids, measured lengths. Independent of mechanics and sheets.
#include "render/page/figure.hpp"

#include <utility>

#include "render/page/shapes.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

void LabelRequest::add_name(const RichText& other) {
    append(text, one_piece(" ≡ "));
    append(text, other);
    in_file.clear();
}

Figure Figure::empty_at(double scale) {
    Figure figure;
    figure.scale = scale;
    return figure;
}

void Figure::move(double dx, double dy) {
    const auto shift = [=](Spot& spot) { render::move(spot, dx, dy); };
    render::move(marks, dx, dy);
    for (LabelRequest& label : labels) {
        shift(label.anchor);
        if (label.toward) shift(*label.toward);
    }
    for (DrawnLeader& leader : leader_lines) {
        shift(leader.from);
        shift(leader.to);
    }
    for (BodyStroke& stroke : strokes) {
        shift(stroke.from);
        shift(stroke.to);
    }
    for (DrawnAxis& axis : axes) {
        shift(axis.tail);
        shift(axis.tip);
    }
    for (DetailOn& each : details) shift(each.circle);
    shift(box.min);
    shift(box.max);
    shift(origin);
}

GroupId id_in(const Figure& figure, std::string element) {
    return GroupId(figure.id, std::move(element), figure.detail);
}

GroupBegin group_of(const Figure& figure, bool to_scale, StatementIndex statement) {
    GroupBegin group{
        "figure", id_in(figure, {}), plain(figure.caption), {{"data-figure", figure.data_figure}}, statement};
    if (!to_scale) return group;
    group.attributes.emplace_back("data-scale", shortest(figure.scale));
    group.attributes.emplace_back("data-unit", figure.unit);
    return group;
}

std::optional<Measured> measured_on(const Figure& figure, const std::string& name) {
    std::optional<Measured> longest;
    for (const DrawnAxis& axis : figure.axes) {
        const double whole = length(axis.tip - axis.tail);
        if (axis.name == name && (!longest || whole > longest->millimetres)) longest = Measured{whole, axis.detail};
    }
    return longest;
}

std::string element_of(std::string_view kind, std::string_view name) {
    return std::string(kind) + (kind.empty() ? "" : "-") + legal_id(name);
}

std::string legal_id(std::string_view name) {
    constexpr char hex[] = "0123456789ABCDEF";
    std::string id;
    for (const char c : name) {
        const bool plain_character = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                                     c == '-' || c == '.' || c == '_';
        if (plain_character) {
            id += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            id += "_x";
            id += hex[byte >> 4];
            id += hex[byte & 15];
            id += '_';
        }
    }
    return id;
}

}  // namespace kinegraph::render
