#include "render/geogebra/construction.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "render/backends/markup.hpp"
#include "render/text/utf8.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

const char* type_name(GeoGebraType type) {
    switch (type) {
        case GeoGebraType::point: return "point";
        case GeoGebraType::line: return "line";
        case GeoGebraType::vector: return "vector";
        case GeoGebraType::number: return "numeric";
        case GeoGebraType::segment: return "segment";
        case GeoGebraType::polygon: return "polygon";
        case GeoGebraType::circle: return "conic";
        case GeoGebraType::text: return "text";
    }
    return "";
}

void empty_element(Markup& xml, std::string_view name,
                   const std::vector<std::pair<std::string_view, std::string>>& attributes) {
    xml.begin(name);
    for (const auto& [key, value] : attributes) xml.attribute(key, value);
    xml.end();
}

const char* truth(bool value) { return value ? "true" : "false"; }

void write_look(Markup& xml, const GeoGebraLook& look, GeoGebraType type) {
    const bool is_text = type == GeoGebraType::text;
    empty_element(xml, "show", {{"object", truth(look.is_shown)}, {"label", truth(!look.caption.empty() && !is_text)}});
    empty_element(xml, "objColor",
                  {{"r", std::to_string(look.colour.red)},
                   {"g", std::to_string(look.colour.green)},
                   {"b", std::to_string(look.colour.blue)},
                   {"alpha", type == GeoGebraType::polygon ? "0.1" : "0"}});
    empty_element(xml, "layer", {{"val", "0"}});
    constexpr const char* caption_mode = "3";
    empty_element(xml, "labelMode", {{"val", look.caption.empty() ? "0" : caption_mode}});
    if (!look.caption.empty()) empty_element(xml, "caption", {{"val", look.caption}});
    if (type == GeoGebraType::point) {
        empty_element(xml, "pointSize", {{"val", "4"}});
    } else if (!is_text && type != GeoGebraType::number) {
        constexpr const char *full = "0", *dashes = "15";
        empty_element(
            xml, "lineStyle",
            {{"thickness", look.is_dashed ? "2" : "5"}, {"type", look.is_dashed ? dashes : full}, {"typeHidden", "1"}});
    }
}

}  // namespace

std::string GeoGebraConstruction::number(double value) {
    std::string text = shortest(value);
    std::replace(text.begin(), text.end(), 'e', 'E');
    return text;
}

std::string GeoGebraConstruction::label(std::string_view stem, std::string_view index) {
    std::string below;
    for (const char letter : index)
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0) below += letter;
    std::string name = std::string(stem) + (below.empty() ? "" : "_{" + below + "}");
    for (int next = 2; !labels_.insert(name).second; ++next)
        name = std::string(stem) + "_{" + below + (below.empty() ? "" : "n") + std::to_string(next) + "}";
    return name;
}
std::string GeoGebraConstruction::label(std::string_view stem) {
    return label(stem, std::to_string(labels_.size() + 1));
}

std::string GeoGebraConstruction::add(Object object) {
    objects_.push_back(std::move(object));
    return objects_.back().label;
}
std::string GeoGebraConstruction::free_point(std::string label, double x, double y, GeoGebraLook look) {
    Object object{GeoGebraType::point, std::move(label), {}, '(' + number(x) + ", " + number(y) + ')', {},
                  std::move(look)};
    object.x = x;
    object.y = y;
    object.is_free = true;
    return add(std::move(object));
}
std::string GeoGebraConstruction::free_number(std::string label, double value) {
    Object object{GeoGebraType::number, std::move(label), {}, number(value), {}, {}};
    object.x = value;
    object.is_free = true;
    return add(std::move(object));
}
std::string GeoGebraConstruction::command(std::string_view name, const std::vector<std::string>& inputs,
                                          GeoGebraType type, std::string label, GeoGebraLook look) {
    return add({type, std::move(label), std::string(name), {}, inputs, std::move(look)});
}
std::string GeoGebraConstruction::expression(std::string text, GeoGebraType type, std::string label,
                                             GeoGebraLook look) {
    return add({type, std::move(label), {}, std::move(text), {}, std::move(look)});
}
void GeoGebraConstruction::text(std::string_view words, double x, double y) {
    std::string quoted = well_formed(words);
    std::replace(quoted.begin(), quoted.end(), '"', '\'');
    Object object{GeoGebraType::text, label("text"), {}, '"' + quoted + '"', {}, {}};
    object.look.is_shown = true;
    object.x = x;
    object.y = y;
    add(std::move(object));
}
void GeoGebraConstruction::pause() {
    if (!objects_.empty()) objects_.back().pauses = true;
}

void GeoGebraConstruction::write(Markup& xml, const Object& each) {
    if (!each.command.empty()) {
        xml.begin("command");
        xml.attribute("name", each.command);
        std::vector<std::pair<std::string, std::string>> inputs;
        xml.begin("input");
        for (std::size_t i = 0; i < each.inputs.size(); ++i) {
            inputs.emplace_back("a" + std::to_string(i), each.inputs[i]);
            xml.attribute(inputs.back().first, inputs.back().second);
        }
        xml.end();
        empty_element(xml, "output", {{"a0", each.label}});
        xml.end();
    } else {
        xml.begin("expression");
        xml.attribute("label", each.label);
        xml.attribute("exp", each.text);
        if (each.type == GeoGebraType::point || each.type == GeoGebraType::vector)
            xml.attribute("type", type_name(each.type));
        xml.end();
    }
    xml.begin("element");
    xml.attribute("type", type_name(each.type));
    xml.attribute("label", each.label);
    write_look(xml, each.look, each.type);
    if (each.is_free && each.type == GeoGebraType::point)
        empty_element(xml, "coords", {{"x", number(each.x)}, {"y", number(each.y)}, {"z", "1"}});
    if (each.type == GeoGebraType::number && each.is_free) empty_element(xml, "value", {{"val", number(each.x)}});
    if (each.type == GeoGebraType::text)
        empty_element(xml, "startPoint", {{"x", number(each.x)}, {"y", number(each.y)}, {"z", "1"}});
    if (each.pauses) empty_element(xml, "breakpoint", {{"val", "true"}});
    xml.end();
}

std::string GeoGebraConstruction::xml(const View& view) const {
    constexpr double width = 1200, height = 720;
    const double scale = std::min(width / (view.right - view.left), height / (view.high - view.low));
    Markup xml;
    xml.begin("geogebra");
    for (const auto& [key, value] : {std::pair("format", "5.0"), std::pair("version", "5.2.0.0"),
                                     std::pair("app", "classic"), std::pair("platform", "w")})
        xml.attribute(key, value);
    xml.begin("euclidianView");
    empty_element(xml, "size", {{"width", number(width)}, {"height", number(height)}});
    empty_element(xml, "coordSystem",
                  {{"xZero", number(-view.left * scale)},
                   {"yZero", number(view.high * scale)},
                   {"scale", number(scale)},
                   {"yscale", number(scale)}});
    empty_element(xml, "evSettings", {{"axes", "false"}, {"grid", "false"}});
    xml.end();
    xml.begin("kernel");
    empty_element(xml, "continuous", {{"val", "false"}});
    empty_element(xml, "significantfigures", {{"val", "5"}});
    empty_element(xml, "angleUnit", {{"val", "degree"}});
    xml.end();
    xml.begin("construction");
    xml.attribute("title", well_formed(title_));
    xml.attribute("author", well_formed(author_));
    xml.attribute("date", "");
    for (const Object& each : objects_) write(xml, each);
    xml.end();
    xml.end();
    return std::string(xml.text());
}

}  // namespace kinegraph::render
