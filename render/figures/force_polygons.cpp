// Force polygons: those of the bodies in rows, and the closed polygon of the external forces. Owns their sides, scales and
// places; takes every force from the Solution, computes no statics.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/assert.hpp"
#include "render/figures/mechanism_sketch.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {
namespace {

using namespace drawing;

constexpr double label_reach = 7;  // what labels may add beyond the strokes on each side

void append(std::vector<Mark>& to, const std::vector<Mark>& more) { to.insert(to.end(), more.begin(), more.end()); }

class ForcePolygon {
public:
    ForcePolygon(const DrawingContext& context, int polygon)
        : context_(context),
          protocol_(context.solution.protocol),
          polygon_(protocol_.polygons[at_index(polygon)]),
          unit_(context.solution.mechanism.units.force) {
        Vector longest;
        Exact square;
        for (const int v : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[at_index(v)];
            for (const int corner : {vector.tail, vector.tip}) place(corner);
            const Vector value = protocol_.value_of(vector);
            values_.push_back(kinegraph::length(in_unit(value)));
            if (Exact own = dot(value, value); longest.is_zero() || square < own) {
                longest = value;
                square = std::move(own);
            }
        }
        along_ = paper_direction(longest);
        // So thin that its sides would lie on each other.
        constexpr double thin = 0.035;
        Box box, turned_box;
        const Spot start =
            polygon_.vectors.empty() ? Spot{} : places_.at(protocol_.vectors[at_index(polygon_.vectors.front())].tail);
        for (const auto& [corner, at] : places_) {
            const Spot off = at - start, seen{dot(along_, off), cross(along_, off)};
            box = {{std::min(box.min.x, off.x), std::min(box.min.y, off.y)},
                   {std::max(box.max.x, off.x), std::max(box.max.y, off.y)}};
            turned_box = {{std::min(turned_box.min.x, seen.x), std::min(turned_box.min.y, seen.y)},
                          {std::max(turned_box.max.x, seen.x), std::max(turned_box.max.y, seen.y)}};
        }
        flat_ = turned_box.height() < thin * turned_box.width();
        width_ = box.width();
        height_ = box.height();
        for (const kinegraph::Face& face : polygon_.faces)
            for (const int corner : face.corners) place(corner);
    }

    double width() const { return width_; }
    double height() const { return height_; }
    /// All forces have one direction: drawn side by side.
    bool flat() const { return flat_; }
    BodyIndex body() const { return polygon_.faces.empty() ? -1 : polygon_.faces.front().body; }

    Figure empty_at(double scale) const {
        Figure figure;
        figure.kind = polygon_.kind == Polygon::Kind::joined_forces ? "closure" : "forces";
        figure.id = legal_id(polygon_.id);
        figure.caption = one_piece(word(figure.kind == "closure" ? "closed force polygon" : "force polygon", context_.language));
        figure.scale = scale;
        figure.unit = unit_.symbol;
        figure.marks.emplace_back(
            GroupBegin{"figure",
                       figure.id,
                       plain(figure.caption),
                       {{"data-figure", figure.kind}, {"data-scale", shortest(scale)}, {"data-unit", unit_.symbol}}});
        return figure;
    }
    PolygonParts parts_of(const Figure& figure) const {
        PolygonParts parts;
        parts.opposites_share_label = true;
        const double largest = std::max(width_, height_);
        std::vector<std::vector<Interval>> columns;
        std::set<std::string> names;
        for (std::size_t i = 0; i < polygon_.vectors.size(); ++i) {
            const DrawnVector& vector = protocol_.vectors[at_index(polygon_.vectors[i])];
            PolygonVector side;
            side.value = values_[i];
            if (!(side.value > largest * 1e-12)) continue;
            const std::string base = name_of(vector.symbol);
            side.name = base;
            for (int n = 2; !names.insert(side.name).second; ++n) side.name = base + "-" + std::to_string(n);
            side.tail = spot(figure, vector.tail);
            side.tip = spot(figure, vector.tip);
            const Spot aside = displaced(columns, side.tail, side.tip);
            if (length(aside) > 0) {
                for (const Spot end : {side.tail, side.tip}) {
                    PolygonLine thin;
                    thin.from = end;
                    thin.to = end + aside;
                    thin.pen = {context_.theme.thin, context_.theme.secondary, {}, false};
                    parts.lines.push_back(std::move(thin));
                }
                side.tail = side.tail + aside, side.tip = side.tip + aside;
            }
            side.text = typeset(vector.symbol, context_.language);
            side.colour = context_.theme.colour_of(vector.body);
            // An inner side met again (a two-force body lies between): one stroke, both names.
            side.internal = vector.role == DrawnVector::Role::internal && figure.kind == "closure";
            parts.vectors.push_back(std::move(side));
        }
        return parts;
    }
    Figure with_parts(Figure figure, const PolygonParts& parts, const std::vector<Detail>& details) const {
        if (!flat_)
            for (const kinegraph::Face& face : polygon_.faces) {
                std::vector<Spot> corners;
                for (const int corner : face.corners) corners.push_back(spot(figure, corner));
                if (face.body > 0 && corners.size() > 2)
                    figure.marks.emplace_back(tinted(filled(corners, context_.theme.body(face.body).tint)));
            }
        draw_parts(figure, context_, parts, details);
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    Vector in_unit(const Vector& si_value) const {
        return unit_.si == Exact(1) ? si_value : Vector{si_value.x / unit_.si, si_value.y / unit_.si};
    }
    /// Each corner is turned to doubles once: the rationals are long.
    void place(int corner) {
        const auto [found, fresh] = places_.try_emplace(corner);
        if (fresh) found->second = paper_spot(in_unit(protocol_.point(corner).place()));
    }
    Spot spot(const Figure& figure, int corner) const {
        const Spot at = places_.at(corner);
        return {at.x / figure.scale, at.y / figure.scale};
    }

    /// Sides of one direction would lie on each other: each goes into the first column beside that is free there.
    Spot displaced(std::vector<std::vector<Interval>>& columns, Spot tail, Spot tip) const {
        if (!flat_) return {0, 0};
        constexpr double pitch = 3.4;
        const double a = dot(tail, along_), b = dot(tip, along_);
        const Interval taken{std::min(a, b), std::max(a, b)};
        std::size_t column = 0;
        for (; column < columns.size(); ++column)
            if (std::none_of(columns[column].begin(), columns[column].end(),
                             [&](const Interval& i) { return i.from < taken.to - 0.05 && i.to > taken.from + 0.05; }))
                break;
        if (column == columns.size()) columns.emplace_back();
        columns[column].push_back(taken);
        return (pitch * static_cast<double>(column)) * turned(along_);
    }

    const DrawingContext& context_;
    const Protocol& protocol_;
    const Polygon& polygon_;
    const Unit& unit_;
    std::map<int, Spot> places_;  // of corners, in the unit of force, y downwards
    std::vector<double> values_;  // of the polygon's vectors
    Spot along_;                  // the longest
    bool flat_ = true;
    double width_ = 0, height_ = 0;
};

void set_scale_bar(const DrawingContext& context, Figure& figure, double target, Spot at) {
    std::vector<Mark> bar;
    draw_scale_bar(bar, context.fonts, context.theme, {0, 0}, target, figure.scale, 1, figure.unit, context.language);
    const Box size = box_of(bar);
    render::move(bar, at.x - size.min.x, at.y - size.min.y);
    append(figure.marks, bar);
    figure.box = box_of(figure.marks);
}

std::vector<int> shown_polygons(const Solution& solution) {
    std::vector<int> all, several;
    for (const FreeBody& body : solution.free_bodies) {
        if (body.polygon < 0) continue;
        all.push_back(body.polygon);
        // Two equal and opposite forces make no polygon: the steps say so.
        if (solution.protocol.polygons[at_index(body.polygon)].vectors.size() > 2) several.push_back(body.polygon);
    }
    return several.empty() ? all : several;
}

/// Polygons in rows, each with its body's name above and its table below.
class Rows {
public:
    Rows(const DrawingContext& context, bool with_tables) : context_(context) {
        for (const int polygon : shown_polygons(context.solution)) {
            Item item{polygon, ForcePolygon(context, polygon), {}, nullptr};
            for (const FreeBody& body : context.solution.free_bodies)
                if (body.polygon == polygon) {
                    item.body = &body;
                    if (with_tables && !item.drawing.flat()) item.table = force_equation_block(context, body, false);
                }
            items_.push_back(std::move(item));
        }
    }
    bool empty() const { return items_.empty(); }
    bool has_tables() const {
        return std::any_of(items_.begin(), items_.end(), [](const Item& item) { return item.table.width > 0; });
    }
    Rows without_tables() const {
        Rows plain = *this;
        for (Item& item : plain.items_) item.table = {};
        return plain;
    }
    double least_scale(double room_x, double room_y) const {
        double most = 0;
        for (const Item& item : items_) {
            most = std::max({most, item.drawing.width() / room_x, item.drawing.height() / room_y});
        }
        return most > 0 ? choose_scale(most, 0, 1, 1, std::nullopt) : 1;
    }

    /// At this scale, with details as long as these fit; nothing where it does not fit; `force`: whatever it takes.
    std::optional<Figure> at(double scale, double room_x, double room_y, bool force) const {
        if (auto detailed = at(scale, room_x, room_y, false, true)) return detailed;
        return at(scale, room_x, room_y, force, false);
    }

private:
    std::optional<Figure> at(double scale, double room_x, double room_y, bool force, bool with_details) const {
        constexpr double between = 6, head = 6, bar = 9;
        const Block names = has_tables() ? force_row_names(context_) : Block{};
        const double indent = names.width > 0 ? names.width + 2 : 0;
        room_x -= indent;
        std::vector<Figure> figures;
        std::vector<PolygonParts> parts;
        std::vector<std::vector<Detail>> details;
        std::size_t letters = 0;
        std::vector<Spot> sizes;
        for (const Item& item : items_) {
            const Figure empty = item.drawing.empty_at(scale);
            parts.push_back(item.drawing.parts_of(empty));
            details.push_back(with_details ? details_of(parts.back(), scale, 1, letters) : std::vector<Detail>{});
            figures.push_back(item.drawing.with_parts(empty, parts.back(), details.back()));
            sizes.push_back(size_of(item, figures.back(), 0.4 * label_reach, head));
        }
        if (with_details && letters == 0) return std::nullopt;
        if (!force && height_of(arranged(sizes, room_x, between), sizes, between) + bar > room_y) return std::nullopt;
        if (!force && std::any_of(sizes.begin(), sizes.end(), [&](Spot s) { return s.x > room_x; })) return std::nullopt;
        for (std::size_t i = 0; i < figures.size(); ++i) {
            if (!place_labels(figures[i], context_.fonts, std::nullopt, with_details ? Labelling::if_all_free : Labelling::free))
                return std::nullopt;
            figures[i].marks.emplace_back(GroupEnd{});
            if (!set_details(figures[i], context_, parts[i], details[i], {room_x, room_y - head - bar}, letters))
                return std::nullopt;
            sizes[i] = size_of(items_[i], figures[i], 0, head);
        }
        const auto rows = arranged(sizes, room_x, between);
        const double height = height_of(rows, sizes, between);
        const bool fits =
            height + bar <= room_y && std::all_of(sizes.begin(), sizes.end(), [&](Spot s) { return s.x <= room_x; });
        if (!fits && !force) return std::nullopt;

        Figure all;
        all.kind = "forces";
        all.id = "forces";
        all.scale = scale;
        all.unit = context_.solution.mechanism.units.force.symbol;
        const bool triangles = std::all_of(items_.begin(), items_.end(), [&](const Item& item) {
            return context_.solution.protocol.polygons[at_index(item.polygon)].vectors.size() == 3 && !item.drawing.flat();
        });
        const std::string key = items_.size() == 1 ? (triangles ? "force triangle" : "force polygon")
                                                   : (triangles ? "force triangles" : "force polygons");
        all.caption = one_piece(word(key, context_.language));
        double y = 0;
        for (const std::vector<std::size_t>& row : rows) {
            double tallest = 0, used = 0;
            for (const std::size_t i : row) {
                tallest = std::max(tallest, figures[i].box.height());
                used += sizes[i].x;
            }
            double x = indent;
            bool named = names.width <= 0;
            const double spread = row.size() < 2
                                      ? between
                                      : std::clamp((room_x - used) / static_cast<double>(row.size() - 1), between, 3 * between);
            for (const std::size_t i : row) {
                Figure& figure = figures[i];
                const std::string& name = body_name(*items_[i].body);
                const std::string words = items_[i].body->body >= 0 ? word("body", context_.language) + " " + name
                                                                    : word("pin", context_.language) + " " + name;
                const std::size_t first = all.marks.size();
                set_text(all.marks, context_.fonts.shape(one_piece(capital(words), Face::bold), context_.theme.body_text),
                         {x, y + 3.2}, context_.theme.colour_of(items_[i].body->body).letter, "text");
                figure.move(x - figure.box.min.x + 0.5 * (sizes[i].x - figure.box.width()),
                            y + head - figure.box.min.y + 0.5 * (tallest - figure.box.height()));
                append(all.marks, figure.marks);
                belong(all.marks, first, items_[i].body->statement);
                std::vector<Mark> table = items_[i].table.marks;
                const double left = x + 0.5 * (sizes[i].x - items_[i].table.width);
                render::move(table, left, y + head + tallest + 2.5);
                append(all.marks, table);
                if (!table.empty() && !named) {
                    // What the rows are stands before the first of them.
                    std::vector<Mark> row_names = names.marks;
                    render::move(row_names, left - indent, y + head + tallest + 2.5);
                    append(all.marks, row_names);
                    named = all.has_table = true;
                }
                x += sizes[i].x + spread;
            }
            double below = 0;
            for (const std::size_t i : row) below = std::max(below, items_[i].table.height);
            y += head + tallest + (below > 0 ? below + 2.5 : 0) + between;
        }
        all.box = box_of(all.marks);
        set_scale_bar(context_, all, 24, {all.box.min.x, all.box.max.y + 3});
        return all;
    }

    struct Item {
        int polygon = -1;
        ForcePolygon drawing;
        Block table;
        const FreeBody* body = nullptr;
    };

    static std::string capital(std::string words) {
        if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
        return words;
    }
    const std::string& body_name(const FreeBody& body) const {
        const Mechanism& m = context_.solution.mechanism;
        return body.body >= 0 ? m.bodies[at_index(body.body)].name : m.points[at_index(body.pin)].name;
    }
    static Spot size_of(const Item& item, const Figure& figure, double reach, double head) {
        return {std::max({figure.box.width() + 2 * reach, item.table.width, 16.0}), head + figure.box.height() + 2 * reach};
    }
    static std::vector<std::vector<std::size_t>> arranged(const std::vector<Spot>& sizes, double room, double between) {
        std::vector<std::vector<std::size_t>> rows;
        double x = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            if (rows.empty() || x + between + sizes[i].x > room) {
                rows.emplace_back();
                x = -between;
            }
            rows.back().push_back(i);
            x += between + sizes[i].x;
        }
        return rows;
    }
    double height_of(const std::vector<std::vector<std::size_t>>& rows, const std::vector<Spot>& sizes, double between) const {
        double sum = -between;
        for (const auto& row : rows) {
            double tallest = 0, table = 0;
            for (const std::size_t i : row) {
                tallest = std::max(tallest, sizes[i].y);
                if (items_[i].table.height > 0) table = std::max(table, items_[i].table.height + 2.5);
            }
            sum += tallest + table + between;
        }
        return sum;
    }

    const DrawingContext& context_;
    std::vector<Item> items_;
};

}  // namespace

bool has_force_polygons(const Solution& solution) { return !shown_polygons(solution).empty(); }
bool has_force_polygon(const Solution& solution, const FreeBody& body) {
    const std::vector<int> shown = shown_polygons(solution);
    return body.polygon >= 0 && std::find(shown.begin(), shown.end(), body.polygon) != shown.end();
}
int force_polygon_count(const Solution& solution) { return static_cast<int>(shown_polygons(solution).size()); }

std::vector<int> closed_polygons(const Solution& solution) {
    std::vector<int> found;
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
        if (solution.protocol.polygons[p].kind == Polygon::Kind::joined_forces && solution.protocol.polygons[p].faces.size() > 1)
            found.push_back(static_cast<int>(p));
    return found;
}

Box extent_of_forces(const Solution& solution, int polygon) {
    const auto of = [&](int p) {
        const Polygon& each = solution.protocol.polygons[at_index(p)];
        Box box;
        bool first = true;
        for (const int v : each.vectors)
            for (const int corner : {solution.protocol.vectors[at_index(v)].tail, solution.protocol.vectors[at_index(v)].tip}) {
                const double si = solution.mechanism.units.force.si.to_double();
                const Vector at = solution.protocol.point(corner).place();
                const Spot spot{at.x.to_double() / si, at.y.to_double() / si};
                if (first) box = {spot, spot};
                first = false;
                box.min = {std::min(box.min.x, spot.x), std::min(box.min.y, spot.y)};
                box.max = {std::max(box.max.x, spot.x), std::max(box.max.y, spot.y)};
            }
        return box;
    };
    if (polygon >= 0) return of(polygon);
    // All of them beside each other.
    Box all;
    for (const int p : shown_polygons(solution)) {
        const Box box = of(p);
        all.max = {all.max.x + box.width(), std::max(all.max.y, box.height())};
    }
    return all;
}

Figure force_polygons_figure(const DrawingContext& context, double room_x, double room_y, std::optional<double> least, bool fixed,
                             bool tables) {
    const Rows with_tables(context, tables), plain_rows = with_tables.without_tables();
    KG_ASSERT(!plain_rows.empty(), "there are force polygons to draw");
    if (fixed && least) {
        if (auto figure = with_tables.at(*least, room_x, room_y, false)) return std::move(*figure);
        if (auto figure = plain_rows.at(*least, room_x, room_y, false)) return std::move(*figure);
    }
    double scale = std::max(plain_rows.least_scale(room_x, room_y), fixed ? 0.0 : least.value_or(0));
    constexpr int most_tries = 14;
    for (int tries = 0;; ++tries, scale = next_scale(scale)) {
        // A table is worth one step of the scale.
        auto figure = plain_rows.at(scale, room_x, room_y, tries == most_tries);
        if (!figure) continue;
        if (!with_tables.has_tables()) return std::move(*figure);
        if (auto better = with_tables.at(scale, room_x, room_y, false)) return std::move(*better);
        // Smaller for the tables' sake only where it stays well readable, and nothing else has to follow.
        const Box extent = extent_of_forces(context.solution, -1);
        const double smaller = next_scale(scale);
        if (!least && extent.height() / smaller > 35)
            if (auto better = with_tables.at(smaller, room_x, room_y, false)) return std::move(*better);
        return std::move(*figure);
    }
}

Figure closed_polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                             std::optional<double> least, bool fixed) {
    const ForcePolygon drawing(context, polygon);
    const auto fits = [&](const Figure& figure) { return figure.box.width() <= room_x && figure.box.height() <= room_y; };
    const auto finish = [&](double scale) {
        const Figure empty = drawing.empty_at(scale);
        const PolygonParts parts = drawing.parts_of(empty);
        const auto close = [&](Figure& figure) {
            set_scale_bar(context, figure, 24, {figure.box.min.x, figure.box.max.y + 3});
            figure.marks.emplace_back(GroupEnd{});
            figure.caption = one_piece(word("closed force polygon", context.language));
        };
        const Spot room{room_x, room_y - 8};
        std::size_t letters = 0;
        if (const std::vector<Detail> details = details_of(parts, scale, 1, letters); !details.empty()) {
            Figure figure = drawing.with_parts(empty, parts, details);
            if (place_labels(figure, context.fonts, room, Labelling::if_all_free)) {
                close(figure);
                if (set_details(figure, context, parts, details, {room_x, room_y}, letters) && fits(figure)) return figure;
            }
        }
        Figure figure = drawing.with_parts(empty, parts, {});
        place_labels(figure, context.fonts, room);
        close(figure);
        return figure;
    };
    if (fixed && least) {
        Figure figure = finish(*least);
        if (fits(figure)) return figure;
    }
    double scale = choose_scale(drawing.width(), drawing.height(), room_x, room_y, std::nullopt);
    if (!fixed && least) scale = std::max(scale, *least);
    constexpr int most_tries = 14;
    for (int tries = 0;; ++tries, scale = next_scale(scale)) {
        const double reach = 0.5 * label_reach;
        if (tries < most_tries && (drawing.width() / scale + reach > room_x || drawing.height() / scale + 8 > room_y)) continue;
        Figure figure = finish(scale);
        if (tries == most_tries || fits(figure)) return figure;
    }
}

}  // namespace kinegraph::render
