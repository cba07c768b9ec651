#include "render/live/cam/cam_page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/file/json_writer.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/live.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/live/html/html.hpp"
#include "render/live/live_data.hpp"
#include "render/live/live_page.hpp"

namespace kinegraph::render {
namespace {

using Spot = VectorOf<double>;

/// To the ten thousandth of a unit: of lengths of the drawing, which is 1000 units wide, and of the components of
/// directions.
std::string rounded(double value) { return shortest(std::round(value * 1e4) / 1e4); }
/// Decimals that show the largest of some values to seven digits, as a power of ten.
double fineness(double largest) {
    double scale = 1;
    while (largest * scale < 1e6 && scale < 1e12) scale *= 10;
    return scale;
}

class CamPageWriter {
public:
    CamPageWriter(const Words& title, const CamGeometry& geometry, const CamPicture& picture, const CamRows& rows,
                  const CycleTable& table, const CamNotes& notes, const Mechanism& drawn, const SheetOptions& options)
        : title_(title),
          geometry_(geometry),
          picture_(picture),
          rows_(rows),
          table_(table),
          notes_(notes),
          drawn_(drawn),
          options_(options) {
        double reach = picture.base;  // the profile passes everywhere on its way round
        for (const Spot& place : picture.profile) reach = std::max(reach, std::sqrt(dot(place, place)));
        include({-reach, -reach});
        include({reach, reach});
        for (const double rise : {0.0, most_rise()}) {
            for (const Spot& place : picture.face) include(moved(place, rise));
            for (const double sign : {-1.0, 1.0})
                include(moved(picture.trace, rise) + Spot{sign * picture.roller, sign * picture.roller});
            if (!picture.pivot) include(moved({picture.trace.x, stem_top()}, rise));
        }
        if (picture.pivot) include(*picture.pivot);
    }

    std::string write(const std::vector<std::string>& facts, const std::optional<Theme>& dark) const {
        const std::string given = title_.in(options_.language);
        const std::string title = given.empty() ? in_words(lang::sheet::untitled) : given;
        const std::string style = style_of(options_.theme, dark) + without_comments(cam_style, false);
        std::string body = without_layout(cam_controls);
        const auto put = [&](std::string_view place, const std::string& text) {
            body.replace(body.find(place), place.size(), text);
        };
        put("{title}", escaped(title));
        put("{cam}", drawing(title));
        put("{plots}", plots());
        put("{values}", values());
        put("{data}", paragraphs(facts));
        put("{turn}", in_words(lang::live::turn));
        put("{play}", in_words(lang::live::play));
        put("{size}", std::to_string(rows_.states.size() - 1));
        return document(title, options_.language, style, without_comments(cam_script, true), data(), false, body);
    }

private:
    std::string in_words(Key key) const { return word(key, options_.language); }
    void include(const Spot& place) {
        low_ = {std::min(low_.x, place.x), std::min(low_.y, place.y)};
        high_ = {std::max(high_.x, place.x), std::max(high_.y, place.y)};
    }
    double most_rise() const {
        double most = 0;
        for (const CamState& state : rows_.states) most = std::max(most, state.rise.s);
        return most;
    }
    /// A place of the follower after a rise.
    Spot moved(const Spot& place, double rise) const {
        if (!picture_.pivot) return place + Spot{0, rise};
        const double angle = geometry_.rises() * rise;
        return *picture_.pivot + faced(Spot{nearest::cos(angle), nearest::sin(angle)}, place - *picture_.pivot);
    }
    /// Of a translating follower at the beginning of the law: where its stem leaves the roller, and its upper end,
    /// which is above the guide in every position.
    double stem_foot() const { return std::max(picture_.trace.y, picture_.base) + picture_.roller; }
    double stem_top() const { return stem_foot() + most_rise() + 0.7 * picture_.base; }

    /// Lengths in thousandths of the drawing's larger side, y downwards.
    double unit() const { return 1000 / std::max(high_.x - low_.x, high_.y - low_.y); }
    std::string at(const Spot& place) const { return rounded(unit() * place.x) + " " + rounded(-unit() * place.y); }
    std::string path(const std::string& attributes, const CamPicture::Outline& places, bool is_closed) const {
        std::string d;
        for (const Spot& place : places) d += (d.empty() ? "M" : "L") + at(place);
        return "<path " + attributes + " d=\"" + d + (is_closed ? "Z" : "") + "\"/>";
    }
    std::string circle(const std::string& attributes, const Spot& centre, double radius) const {
        return "<circle " + attributes + " cx=\"" + rounded(unit() * centre.x) + "\" cy=\"" +
               rounded(-unit() * centre.y) + "\" r=\"" + rounded(unit() * radius) + "\"/>";
    }
    /// A pin on hatched ground, of a size that does not depend on the cam's.
    std::string ground(const Spot& place) const {
        std::string hatch;
        for (const int i : {-24, -12, 0, 12, 24}) hatch += "M" + std::to_string(i) + " 38l-10 12";
        return "<g class=\"ground\" transform=\"translate(" + at(place) + ")\"><path d=\"M0 0l-20 38h40zM-32 38h64" +
               hatch + "\"/><circle r=\"10\"/></g>";
    }
    std::string drawing(const std::string& title) const {
        const double margin = 40, width = unit() * (high_.x - low_.x) + 2 * margin,
                     height = unit() * (high_.y - low_.y) + 2 * margin;
        std::string svg = "<svg class=\"drawing\" role=\"img\" aria-label=\"" + escaped(title) + "\" viewBox=\"" +
                          rounded(unit() * low_.x - margin) + " " + rounded(-unit() * high_.y - margin) + " " +
                          rounded(width) + " " + rounded(height) + "\">";
        svg += circle("class=\"thin\"", {}, picture_.base);
        svg += "<g id=\"cam\">" + path("class=\"body\"", picture_.profile, true);
        if (!picture_.pitch.empty()) svg += path("class=\"thin\"", picture_.pitch, true);
        svg += path("class=\"thin\"", {{}, {0, 0.6 * picture_.base}}, false) + "</g>";
        svg += ground({});
        if (!picture_.pivot) svg += guide();
        svg += "<g id=\"follower\">" + follower() + "</g>";
        if (picture_.pivot) svg += ground(*picture_.pivot);
        svg += "<g id=\"contact\"><path class=\"normal\"/><circle r=\"9\"/></g>";
        return svg + "</svg>";
    }
    /// Two hatched jaws beside the stem of a translating follower, which stay where they are.
    std::string guide() const {
        const double x = unit() * stem_x(), half = 0.2 * unit() * picture_.base,
                     y = -unit() * (stem_foot() + most_rise() + 0.3 * picture_.base);
        std::string jaws;
        for (const int side : {-1, 1}) {
            const std::string edge = rounded(x + side * 14), out = std::to_string(side * 14);
            jaws += "M" + edge + " " + rounded(y - half) + "V" + rounded(y + half);
            for (const double share : {-0.8, -0.4, 0.0, 0.4, 0.8})
                jaws += "M" + edge + " " + rounded(y + share * half) + "l" + out + " 12";
        }
        return "<path class=\"ground\" d=\"" + jaws + "\"/>";
    }
    double stem_x() const { return picture_.face.empty() ? picture_.trace.x : 0; }
    std::string follower() const {
        std::string out;
        const Spot middle = picture_.face.empty() ? picture_.trace : centre_of(picture_.face);
        if (picture_.pivot)
            out += path("class=\"bar\"", {*picture_.pivot, middle}, false);
        else
            out += path("class=\"bar\"", {{stem_x(), middle.y}, {stem_x(), stem_top()}}, false);
        if (!picture_.face.empty()) return out + path("class=\"body\"", picture_.face, true);
        if (picture_.roller > 0)
            return out + circle("class=\"body\"", picture_.trace, picture_.roller) + "<circle class=\"pin\" cx=\"" +
                   rounded(unit() * picture_.trace.x) + "\" cy=\"" + rounded(-unit() * picture_.trace.y) +
                   "\" r=\"8\"/>";
        return out;
    }
    static Spot centre_of(const CamPicture::Outline& outline) {
        Spot sum;
        for (const Spot& place : outline) sum = sum + place;
        return (1 / static_cast<double>(outline.size())) * sum;
    }

    Unit unit_of(std::size_t column) const { return unit_of_column(table_.columns[column], drawn_.units); }
    /// One plot a column over the turn, in the file's units; the script moves the line at the turn.
    std::string plots() const {
        std::string out;
        for (std::size_t column = 1; column < table_.columns.size(); ++column) out += plot(column);
        return out;
    }
    std::string plot(std::size_t column) const {
        constexpr double width = 360, height = 90;
        double low = 0, high = 0;
        for (const auto& row : table_.rows) {
            low = std::min(low, row[column]);
            high = std::max(high, row[column]);
        }
        const double span = high > low ? high - low : 1;
        std::string d;
        for (const auto& row : table_.rows)
            d += (d.empty() ? "M" : "L") + rounded(row[0] * 180 / std::numbers::pi) + " " +
                 rounded((high - row[column]) / span * height);
        std::string svg = "<svg class=\"plot graph\" role=\"img\" aria-label=\"" +
                          escaped(plain(notes_.captions[column - 1])) + "\" viewBox=\"-4 -6 368 102\">";
        std::string ticks;
        for (const int turn : {0, 90, 180, 270, 360}) ticks += "M" + std::to_string(turn) + " 0V" + rounded(height);
        svg += "<path class=\"grid\" d=\"" + ticks + "\"/><path class=\"axis\" d=\"M0 " +
               rounded(high / span * height) + "H" + rounded(width) + "\"/>";
        svg += "<path class=\"curve\" d=\"" + d + "\"/><path class=\"here\" d=\"M0 0V" + rounded(height) + "\"/></svg>";
        const Unit unit = unit_of(column);
        const auto amount = [&](double value) {
            return number(value / unit.si.to_double(), 4, options_.language) +
                   (unit.symbol.empty() || unit.symbol == "°" ? unit.symbol : " " + unit.symbol);
        };
        return element("figure", "",
                       svg + element("figcaption", "",
                                     html(notes_.captions[column - 1]) + " <span class=\"scale\">" +
                                         escaped(amount(low) + " … " + amount(high)) + "</span>"));
    }
    std::string values() const {
        std::string rows;
        for (std::size_t column = 1; column < table_.columns.size(); ++column)
            rows += element(
                "tr", "",
                element("th", "scope=\"row\"", html(typeset(table_.columns[column], drawn_, options_.language))) +
                    element("td", "data-column=\"" + std::to_string(column - 1) + "\"", "") +
                    element("td", "", escaped(unit_of(column).symbol)));
        return element("table", "class=\"values\"", element("tbody", "", rows));
    }
    std::string paragraphs(const std::vector<std::string>& facts) const {
        std::string out;
        for (const RichText& each : notes_.data) out += element("p", "", html(each));
        for (const std::string& each : facts) out += element("p", "", escaped(each));
        return out;
    }

    /// Rows for the script: turns in degrees, lengths of the drawing, values in the file's units.
    std::string data() const {
        constexpr double degree = std::numbers::pi / 180;
        const double rises = picture_.pivot ? -geometry_.rises() / degree : -unit();
        JsonWriter json(JsonWriter::Style::script);
        const auto pair = [&](double x, double y) { json.open('[').json(rounded(x)).json(rounded(y)).close(); };
        json.open('{');
        if (picture_.pivot) {
            json.key("pivot");
            pair(unit() * picture_.pivot->x, -unit() * picture_.pivot->y);
        }
        json.key("sense").json(rounded(-geometry_.sense()));
        json.member("comma", number(0.5, 1, options_.language) != "0.5");
        json.key("words").open('{').member("play", in_words(lang::live::play));
        json.member("pause", in_words(lang::live::pause)).close();
        json.list("turns", rows_.states, [&](const CamState& state) { json.json(rounded(state.turn / degree)); });
        json.list("rises", rows_.states, [&](const CamState& state) { json.json(rounded(rises * state.rise.s)); });
        json.list("contacts", rows_.states,
                  [&](const CamState& state) { pair(unit() * state.contact.x, -unit() * state.contact.y); });
        json.list("normals", rows_.states, [&](const CamState& state) { pair(state.outward.x, -state.outward.y); });
        json.key("columns").open('[');
        for (std::size_t column = 1; column < table_.columns.size(); ++column) write_values(column, json);
        return json.close().close().take();
    }
    /// Values of a column in its unit, as fine as their drawing shows.
    void write_values(std::size_t column, JsonWriter& json) const {
        const double unit = unit_of(column).si.to_double();
        double largest = 0;
        for (const double value : rows_.columns[column - 1]) largest = std::max(largest, std::abs(value / unit));
        const double scale = fineness(largest);
        json.open('[');
        for (const double value : rows_.columns[column - 1])
            json.json(shortest(std::round(value / unit * scale) / scale));
        json.close();
    }

    const Words& title_;
    const CamGeometry& geometry_;
    const CamPicture& picture_;
    const CamRows& rows_;
    const CycleTable& table_;
    const CamNotes& notes_;
    const Mechanism& drawn_;
    const SheetOptions& options_;
    Spot low_, high_;
};

}  // namespace

std::string cam_page(const Words& title, const CamGeometry& geometry, const CamPicture& picture, const CamRows& rows,
                     const CycleTable& table, const CamNotes& notes, const std::vector<std::string>& facts,
                     const Mechanism& drawn, const SheetOptions& options, const std::optional<Theme>& dark) {
    return CamPageWriter(title, geometry, picture, rows, table, notes, drawn, options).write(facts, dark);
}

}  // namespace kinegraph::render
