// Force polygons: those of the bodies in rows, and the closed polygon of the external forces. Owns their sides, scales
// and positions; all forces come from the Solution.
#include <algorithm>
#include <cmath>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/polygon_scene.hpp"
#include "render/tables/force_tables.hpp"

namespace kinegraph::render {
namespace {

using namespace drawing;

constexpr double label_reach = 7;  // space for labels beyond the strokes, on each side
/// Least size of the longest polygon, mm. If labels have no space beside it, the room must be wider.
constexpr double least_force_polygon = 8;

void append(std::vector<Mark>& to, const std::vector<Mark>& more) { to.insert(to.end(), more.begin(), more.end()); }

/// The bodies taken together are the whole truss then.
bool is_truss_whole(const Solution& solution) { return solution.truss && solution.free_bodies.empty(); }

class ForcePolygon {
public:
    ForcePolygon(const DrawingContext& context, const LoadCase& loads, int polygon)
        : context_(context),
          polygon_(polygon),
          scene_(polygon_scene(context.solution, polygon)),
          along_{scene_.along.x, -scene_.along.y} {
        for (const FreeBody& body : loads.bodies())
            if (body.polygon == polygon) sums_ = body.sums, funicular_ = body.funicular;
        for (const TakenTogether& together : loads.together())
            if (together.polygon == polygon) sums_ = together.sums, funicular_ = together.funicular;
        add_sums_of_parts();
        // ratio of width to length below which sides would overlap
        constexpr double thin = 0.035;
        if (scene_.vectors.empty()) return;
        const Spot start = spot(1, scene_.vectors.front().tail);
        Box turned_box;
        for (const SceneVector& vector : scene_.vectors)
            for (const Place corner : {vector.tail, vector.tip}) {
                const Spot off = spot(1, corner) - start, seen{dot(along_, off), cross(along_, off)};
                turned_box = {{std::min(turned_box.min.x, seen.x), std::min(turned_box.min.y, seen.y)},
                              {std::max(turned_box.max.x, seen.x), std::max(turned_box.max.y, seen.y)}};
            }
        flat_ = turned_box.height() < thin * turned_box.width();
    }

    double width() const { return scene_.width(); }
    double height() const { return scene_.height(); }
    /// All forces have one direction; they are drawn side by side.
    bool flat() const { return flat_; }

    /// Not closed: its last side is the resultant.
    bool is_open() const {
        return std::any_of(context_.solution.resultants.begin(), context_.solution.resultants.end(),
                           [&](const Resultant& each) { return each.polygon == polygon_ && !each.force->is_zero(); });
    }

    Figure empty_at(double scale) const {
        const bool joined = scene_.kind == PolygonScene::Kind::closure;
        Figure figure = begun(context_, {joined ? FigureKind::closed_polygon : FigureKind::forces});
        figure.id = legal_id(scene_.id);
        if (!joined || is_open()) figure.caption = one_piece(word(lang::sheet::force_polygon, context_.language));
        figure.scale = scale;
        figure.unit = scene_.unit.symbol;
        open_group(figure);
        return figure;
    }
    PolygonParts parts_of(const Figure& figure) const {
        PolygonParts parts;
        parts.opposites_share_label = true;
        std::vector<std::vector<Interval>> columns;
        for (const SceneVector& each : scene_.vectors) {
            PolygonVector side;
            side.value = each.value;
            side.name = each.name;
            side.tail = spot(figure.scale, each.tail);
            side.tip = spot(figure.scale, each.tip);
            set_in_column(parts, columns, side);
            side.text = typeset(each.symbol, context_.language);
            side.colour = context_.theme.colour_of(is_truss_whole(context_.solution) ? BodyIndex(none) : each.body);
            // A repeated inner side (of a two-force body) is a single stroke with both names.
            side.internal = each.falls_out;
            side.is_thin = each.is_part;  // not the whole force
            side.is_resultant = is_open() && &each == &scene_.vectors.back();
            if (side.is_resultant) side.colour = context_.theme.colour_of(none);
            side.statement = each.statement;
            parts.vectors.push_back(std::move(side));
        }
        add_diagonals(figure.scale, parts, columns);
        set_side_by_side(parts);
        if (funicular_) add_rays(figure.scale, parts);
        return parts;
    }
    Figure with_parts(Figure figure, const PolygonParts& parts, const std::vector<Detail>& details) const {
        if (!flat_)
            for (const SceneFace& face : scene_.faces) {
                std::vector<Spot> corners;
                for (const Place corner : face.corners) corners.push_back(spot(figure.scale, corner));
                if (face.body > frame && corners.size() > 2)
                    figure.marks.emplace_back(tinted(filled(corners, context_.theme.body(face.body).tint)));
            }
        draw_parts(figure, context_, parts, details);
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    /// The sums that the own loads of a body needed are diagonals of the polygon that joins its parts, too.
    void add_sums_of_parts() {
        if (!context_.solution.superposition) return;
        for (const Superposition::Joined& joined : context_.solution.superposition->joined)
            if (joined.polygon == polygon_)
                for (const Superposition::Part& part : context_.solution.superposition->parts)
                    for (const FreeBody& body : part.bodies)
                        if (body.body == joined.body && body.pin == joined.pin && part.body == joined.body)
                            sums_.insert(sums_.end(), body.sums.begin(), body.sums.end());
    }

    static Spot spot(double scale, Place p) { return {p.x / scale, -p.y / scale}; }

    /// A partial sum is a diagonal from the first corner.
    void add_diagonals(double scale, PolygonParts& parts, std::vector<std::vector<Interval>>& columns) const {
        const double near = 1e-9 * scene_.size();
        for (const AppliedForce& sum : sums_) {
            const Exact& si = scene_.unit.si;
            const Place tip{(sum.force.x / si).to_double(), (sum.force.y / si).to_double()};
            const Place start = scene_.vectors.front().tail;
            const auto ends = [&](const SceneVector& side) {
                return nearest::hypot(side.tip.x - start.x - tip.x, side.tip.y - start.y - tip.y) <= near;
            };
            // A sum of one force is that force; the last corner equals the first.
            const auto end = std::find_if(scene_.vectors.begin(), scene_.vectors.end(), ends);
            if (end == scene_.vectors.begin() || end == scene_.vectors.end()) continue;
            PolygonVector diagonal;
            diagonal.value = nearest::hypot(tip.x, tip.y);
            diagonal.name = name_of(sum.symbol);
            diagonal.tail = spot(scale, start);
            diagonal.tip = spot(scale, end->tip);
            diagonal.text = typeset(sum.symbol, context_.language);
            diagonal.colour = context_.theme.colour_of(none);
            diagonal.is_resultant = true;
            diagonal.statement = end->statement;
            set_in_column(parts, columns, diagonal);
            parts.vectors.push_back(std::move(diagonal));
        }
    }

    /// Rays from the pole to the corners of the known forces, with the numbers of the strings; the last one is
    /// that of the closing line.
    void add_rays(double scale, PolygonParts& parts) const {
        const Exact& si = scene_.unit.si;
        const auto at = [&](const Vector& place) {
            return spot(scale, {(place.x / si).to_double(), (place.y / si).to_double()});
        };
        const Spot pole = at(*funicular_->pole);
        const auto ray = [&](const Vector& to, const std::string& number) {
            PolygonLine line;
            line.from = pole;
            line.to = at(to);
            line.pen = {context_.theme.thin, context_.theme.text, {}, false};
            line.mark = one_piece(number);
            line.mark_at = 0.5 * (line.from + line.to);
            line.mark_toward = line.from;
            line.statement = funicular_->statement;
            parts.lines.push_back(std::move(line));
        };
        for (std::size_t i = 0; i < funicular_->corners.size(); ++i)
            ray(*funicular_->corners[i], std::to_string(i + 1));
        ray(*funicular_->dividing, std::to_string(funicular_->corners.size() + 1));
        PolygonImage image;
        image.at = pole;
        image.name = "pole";
        // The first letter that no point of the file has.
        for (const char* letter : {"O", "Ω", "S", "P"}) {
            image.text = one_piece(letter, Face::italic);
            if (!context_.solution.mechanism.point_named(letter)) break;
        }
        image.statement = funicular_->statement;
        parts.images.push_back(std::move(image));
    }

    /// Moves a side of a flat polygon aside, with thin lines from its true ends.
    void set_in_column(PolygonParts& parts, std::vector<std::vector<Interval>>& columns, PolygonVector& side) const {
        // A resultant is no side: between it and the sides of an inner column their names have room.
        constexpr double room_of_name = 9;
        const Spot clear = side.is_resultant && columns.size() > 1 ? room_of_name * turned(along_) : Spot{0, 0};
        Spot aside = displaced(columns, side.tail, side.tip);
        if (length(aside) > 0) aside = aside + clear;
        if (!(length(aside) > 0)) return;
        for (Spot* const end : {&side.tail, &side.tip}) {
            PolygonLine thin;
            thin.from = *end;
            thin.to = *end + aside;
            thin.pen = {context_.theme.thin, context_.theme.secondary, {}, false};
            parts.lines.push_back(std::move(thin));
            *end = *end + aside;
        }
    }
    /// Parallel sides would overlap: each is moved to the first free column.
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
    int polygon_;
    PolygonScene scene_;
    Spot along_;  // unit vector of the longest side
    bool flat_ = true;
    std::vector<AppliedForce> sums_;
    std::optional<FreeBody::Funicular> funicular_;
};

void set_scale_bar(const DrawingContext& context, Figure& figure, double target, Spot at) {
    std::vector<Mark> bar;
    draw_scale_bar(bar, context.fonts, context.theme, {0, 0}, target, figure.scale, 1, figure.unit, context.language);
    const Box size = box_of(bar);
    render::move(bar, at.x - size.min.x, at.y - size.min.y);
    append(figure.marks, bar);
    figure.box = box_of(figure.marks);
}

std::vector<int> shown_polygons(const LoadCase& loads) {
    std::vector<int> all, several;
    for (const FreeBody& body : loads.bodies()) {
        if (body.polygon < 0) continue;
        all.push_back(body.polygon);
        // Two equal and opposite forces have no polygon; the steps say so.
        if (loads.solution().protocol.polygons[at_index(body.polygon)].vectors.size() > 2)
            several.push_back(body.polygon);
    }
    std::vector<int>& shown = several.empty() ? all : several;
    for (const TakenTogether& together : loads.together()) shown.push_back(together.polygon);
    return shown;
}
std::vector<int> polygons_of_sums(const Solution& solution) {
    std::vector<int> polygons;
    if (solution.superposition)
        for (const Superposition::Sum& sum : solution.superposition->sums) polygons.push_back(sum.polygon);
    return polygons;
}
std::vector<int> polygons_of_parts(const Solution& solution) {
    std::vector<int> polygons;
    if (solution.superposition)
        for (const Superposition::Joined& joined : solution.superposition->joined) polygons.push_back(joined.polygon);
    return polygons;
}
Box extent_of_polygons(const LoadCase& loads, const std::vector<int>& polygons) {
    Box all;
    for (const int p : polygons) {
        const PolygonScene scene = polygon_scene(loads.solution(), p);
        all.max = {all.max.x + scene.width(), std::max(all.max.y, scene.height())};
        // The pole of the rays is as far to the side as the forces are long.
        const auto has_rays = [p](const auto& each) { return each.polygon == p && each.funicular; };
        if (std::any_of(loads.bodies().begin(), loads.bodies().end(), has_rays) ||
            std::any_of(loads.together().begin(), loads.together().end(), has_rays))
            all.max.x += std::max(scene.width(), scene.height());
    }
    return all;
}

/// Polygons in rows, each with the name of its body above and its table below.
class Rows {
public:
    Rows(const DrawingContext& context, const LoadCase& loads, const std::vector<int>& polygons, bool with_tables,
         FigureId id)
        : context_(context), id_(id) {
        for (const int polygon : polygons) {
            Item item{polygon, ForcePolygon(context, loads, polygon), {}, {}, none, none};
            name(item, loads, with_tables);
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
    double tallest() const {
        double height = 0;
        for (const Item& item : items_) height = std::max(height, item.drawing.height());
        return height;
    }
    double largest() const {
        double size = 0;
        for (const Item& item : items_) size = std::max({size, item.drawing.width(), item.drawing.height()});
        return size;
    }
    double least_scale(double room_x, double room_y) const {
        double most = 0;
        for (const Item& item : items_) {
            most = std::max({most, item.drawing.width() / room_x, item.drawing.height() / room_y});
        }
        return most > 0 ? choose_scale(most, 0, 1, 1, std::nullopt) : 1;
    }

    /// The figure at a scale, with details if they fit. Empty if it does not fit; `force`: returns it in any case.
    std::optional<Figure> at(double scale, double room_x, double room_y, bool force) const {
        if (auto detailed = at(scale, room_x, room_y, false, true)) return detailed;
        return at(scale, room_x, room_y, force, false);
    }

private:
    struct Item {
        int polygon = -1;
        ForcePolygon drawing;
        Block table;
        RichText title;
        BodyIndex body = none;  ///< for the colour of the title
        StatementIndex statement = none;
    };
    /// Named by a body or a pin, by bodies taken together, or by the force whose parts are added.
    void name(Item& item, const LoadCase& loads, bool with_tables) const {
        const Solution& solution = context_.solution;
        const auto titled = [&](Key what, const std::string& name) {
            return one_piece(capital(word(what, context_.language) + " " + name), Face::bold);
        };
        for (const FreeBody& body : loads.bodies()) {
            if (body.polygon != item.polygon) continue;
            item.title = titled(body.body != none ? lang::sheet::body : lang::sheet::pin, body_name(body));
            item.body = body.body;
            item.statement = body.statement;
            if (with_tables && !item.drawing.flat()) item.table = force_equation_block(context_, loads, body, false);
        }
        for (const TakenTogether& together : loads.together())
            if (together.polygon == item.polygon) {
                item.title = is_truss_whole(solution)
                                 ? one_piece(capital(word(lang::sheet::truss_whole, context_.language)), Face::bold)
                                 : titled(lang::sheet::bodies_together, names_of(solution.mechanism, together));
                item.statement = together.statement;
            }
        if (!solution.superposition) return;
        for (const Superposition::Sum& sum : solution.superposition->sums)
            if (sum.polygon == item.polygon) {
                item.title = typeset(sum.symbol, context_.language);
                item.body = sum.body;
                item.statement = solution.superposition->statement;
            }
        for (const Superposition::Joined& joined : solution.superposition->joined)
            if (joined.polygon == item.polygon) {
                const Mechanism& m = solution.mechanism;
                item.title = joined.body != none ? titled(lang::sheet::body, m.body(joined.body).name)
                                                 : titled(lang::sheet::pin, m.point(joined.pin).name);
                item.body = joined.body;
                for (const Superposition::Part& part : solution.superposition->parts)
                    for (const FreeBody& body : part.bodies)
                        if (body.body == joined.body && body.pin == joined.pin && item.statement == none)
                            item.statement = body.statement;  // the first load that draws a part of it
            }
    }

    static constexpr double between = 6, head = 6, bar = 9, above_table = 2.5;

    /// A polygon drawn at a scale, and its size with name and table.
    struct Cell {
        Figure figure;
        PolygonParts parts;
        std::vector<Detail> details;
        Spot size;
    };
    using Row = std::vector<std::size_t>;  // of items

    std::optional<Figure> at(double scale, double room_x, double room_y, bool force, bool with_details) const {
        const Block names = has_tables() ? force_row_names(context_) : Block{};
        const Spot room{room_x - indent_of(names), room_y};
        std::size_t letters = 0;
        std::vector<Cell> cells;
        for (const Item& item : items_) cells.push_back(cell_of(item, scale, with_details, letters));
        if (with_details && letters == 0) return std::nullopt;
        if (!force && !fit_into(room, cells)) return std::nullopt;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (!finish(cells[i], items_[i], room, with_details, letters)) return std::nullopt;
        if (!force && !fit_into(room, cells)) return std::nullopt;
        return set_out(cells, names, room.x, scale);
    }
    static double indent_of(const Block& names) { return names.width > 0 ? names.width + 2 : 0; }

    static Cell cell_of(const Item& item, double scale, bool with_details, std::size_t& letters) {
        Cell cell;
        const Figure empty = item.drawing.empty_at(scale);
        cell.parts = item.drawing.parts_of(empty);
        if (with_details) cell.details = details_of(cell.parts, scale, 1, letters);
        cell.figure = item.drawing.with_parts(empty, cell.parts, cell.details);
        cell.size = size_of(item, cell.figure, 0.4 * label_reach);
        return cell;
    }
    /// Places labels and draws details. False if the details have no free position.
    bool finish(Cell& cell, const Item& item, Spot room, bool with_details, std::size_t& letters) const {
        const Labelling labelling = with_details ? Labelling::if_all_free : Labelling::free;
        if (!place_labels(cell.figure, context_.fonts, std::nullopt, labelling, context_.theme.secondary)) return false;
        cell.figure.marks.emplace_back(GroupEnd{});
        if (!set_details(cell.figure, context_, cell.parts, cell.details, {room.x, room.y - head - bar}, letters))
            return false;
        cell.size = size_of(item, cell.figure, 0);
        return true;
    }
    bool fit_into(Spot room, const std::vector<Cell>& cells) const {
        return height_of(arranged(cells, room.x), cells) + bar <= room.y &&
               std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) { return cell.size.x <= room.x; });
    }

    Figure set_out(std::vector<Cell>& cells, const Block& names, double room, double scale) const {
        Figure all = begun(context_, id_);
        for (const Item& item : items_) all.polygons.push_back(item.polygon);
        all.scale = scale;
        all.unit = context_.solution.mechanism.units.force.symbol;
        if (!row_of(id_.kind).caption) all.caption = one_piece(word(caption(), context_.language));
        double y = 0;
        for (const Row& row : arranged(cells, room)) y = set_row(all, row, cells, names, y);
        all.box = box_of(all.marks);
        set_scale_bar(context_, all, 24, {all.box.min.x, all.box.max.y + 3});
        return all;
    }
    Key caption() const {
        const bool triangles = std::all_of(items_.begin(), items_.end(), [&](const Item& item) {
            return context_.solution.protocol.polygons[at_index(item.polygon)].vectors.size() == 3 &&
                   !item.drawing.flat() && !item.drawing.is_open();
        });
        if (items_.size() == 1) return triangles ? lang::sheet::force_triangle : lang::sheet::force_polygon;
        return triangles ? lang::sheet::force_triangles : lang::sheet::force_polygons;
    }
    /// Returns the top of the next row.
    double set_row(Figure& all, const Row& row, std::vector<Cell>& cells, const Block& names, double y) const {
        double tallest = 0, below = 0;
        StatementIndex first = none;  // of those with a table
        for (const std::size_t i : row) {
            tallest = std::max(tallest, cells[i].figure.box.height());
            below = std::max(below, items_[i].table.height);
            if (!items_[i].table.marks.empty())
                first = first == none ? items_[i].statement : std::min(first, items_[i].statement);
        }
        double x = indent_of(names);
        bool named = names.width <= 0;
        for (const std::size_t i : row) {
            set_cell(all, items_[i], cells[i], {x, y}, tallest);
            if (const Block& table = items_[i].table; !table.marks.empty()) {
                const Spot at{x + 0.5 * (cells[i].size.x - table.width), y + head + tallest + above_table};
                set_table(all, table, at, items_[i].statement);
                // The names of the rows stand before the first table, and are there with the earliest.
                if (!named) set_table(all, names, {at.x - indent_of(names), at.y}, first);
                named = all.has_table = true;
            }
            x += cells[i].size.x + between;
        }
        return y + head + tallest + (below > 0 ? below + above_table : 0) + between;
    }
    /// Places the name, and the polygon in the middle of its cell and row.
    void set_cell(Figure& all, const Item& item, Cell& cell, Spot at, double tallest) const {
        Figure& figure = cell.figure;
        const std::size_t first = all.marks.size();
        set_text(all.marks, context_.fonts.shape(item.title, context_.theme.body_text), {at.x, at.y + 3.2},
                 context_.theme.colour_of(item.body).letter, "text");
        figure.move(at.x - figure.box.min.x + 0.5 * (cell.size.x - figure.box.width()),
                    at.y + head - figure.box.min.y + 0.5 * (tallest - figure.box.height()));
        append(all.marks, figure.marks);
        all.axes.insert(all.axes.end(), figure.axes.begin(), figure.axes.end());
        all.details.insert(all.details.end(), figure.details.begin(), figure.details.end());
        belong(all.marks, first, item.statement);
    }
    static void set_table(Figure& all, const Block& table, Spot at, StatementIndex statement) {
        std::vector<Mark> marks = table.marks;
        render::move(marks, at.x, at.y);
        belong(marks, 0, statement);
        append(all.marks, marks);
    }

    static std::string capital(std::string words) {
        if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
        return words;
    }
    const std::string& body_name(const FreeBody& body) const {
        const Mechanism& m = context_.solution.mechanism;
        return body.body != none ? m.body(body.body).name : m.point(body.pin).name;
    }
    static Spot size_of(const Item& item, const Figure& figure, double reach) {
        return {std::max({figure.box.width() + 2 * reach, item.table.width, 16.0}),
                head + figure.box.height() + 2 * reach};
    }
    static std::vector<Row> arranged(const std::vector<Cell>& cells, double room) {
        std::vector<Row> rows;
        double x = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const double width = cells[i].size.x;
            if (rows.empty() || x + between + width > room) {
                rows.emplace_back();
                x = -between;
            }
            rows.back().push_back(i);
            x += between + width;
        }
        return rows;
    }
    double height_of(const std::vector<Row>& rows, const std::vector<Cell>& cells) const {
        double sum = -between;
        for (const Row& row : rows) {
            double tallest = 0, table = 0;
            for (const std::size_t i : row) {
                tallest = std::max(tallest, cells[i].size.y);
                if (items_[i].table.height > 0) table = std::max(table, items_[i].table.height + above_table);
            }
            sum += tallest + table + between;
        }
        return sum;
    }

    const DrawingContext& context_;
    FigureId id_;
    std::vector<Item> items_;
};

/// The rows at the finest scale that fits into the room.
Figure fitted_rows(const Rows& with_tables, Spot room, const ScaleWish& wish) {
    const Rows plain_rows = with_tables.without_tables();
    KG_ASSERT(!plain_rows.empty(), "there are force polygons to draw");
    const auto fitting = [&](const Rows& rows, double scale) { return rows.at(scale, room.x, room.y, false); };
    const FitPolicy policy{.room = std::nullopt,
                           .first = std::max(plain_rows.least_scale(room.x, room.y), wish.finest),
                           .asked = wish.asked,
                           .exactly = wish.exactly,
                           .most_trials = 14,
                           .extent = plain_rows.largest(),
                           .least_shown = least_force_polygon};
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
        if (trial.asked) {
            auto figure = fitting(with_tables, trial.scale);
            return figure ? std::move(figure) : fitting(plain_rows, trial.scale);
        }
        // Without tables the scale may be one step finer.
        auto figure = plain_rows.at(trial.scale, room.x, room.y, trial.last);
        if (!figure || !with_tables.has_tables()) return figure;
        if (auto better = fitting(with_tables, trial.scale)) return better;
        // A coarser scale for the tables is accepted only if the polygons remain readable and no other figure has to
        // use it.
        const double smaller = next_scale(trial.scale);
        if (!(wish.finest > 0) && plain_rows.tallest() / smaller > 35)
            if (auto better = fitting(with_tables, smaller)) return better;
        return figure;
    });
}

}  // namespace

bool has_force_polygons(const LoadCase& loads) { return !shown_polygons(loads).empty(); }
bool has_force_polygon(const LoadCase& loads, const FreeBody& body) {
    const std::vector<int> shown = shown_polygons(loads);
    return body.polygon >= 0 && std::find(shown.begin(), shown.end(), body.polygon) != shown.end();
}

Figure force_polygons_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish,
                             bool tables, int only, int part) {
    const LoadCase loads(context.solution, part);
    const std::vector<int> polygons = only >= 0 ? std::vector<int>{only} : shown_polygons(loads);
    return fitted_rows(Rows(context, loads, polygons, tables, {FigureKind::forces, -1, part}), {room_x, room_y}, wish);
}

Figure partial_sums_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    return fitted_rows(
        Rows(context, context.solution, polygons_of_sums(context.solution), false, {FigureKind::partial_sums}),
        {room_x, room_y}, wish);
}

Figure joined_parts_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish,
                           int only) {
    const bool is_single = only >= 0;
    const std::vector<int> polygons = is_single ? std::vector<int>{only} : polygons_of_parts(context.solution);
    const FigureId id =
        is_single ? FigureId{FigureKind::joined_parts_of_body, only} : FigureId{FigureKind::joined_parts};
    return fitted_rows(Rows(context, context.solution, polygons, false, id), {room_x, room_y}, wish);
}

Figure closed_polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                             const ScaleWish& wish) {
    const ForcePolygon drawing(context, context.solution, polygon);
    const auto fits = [&](const Figure& figure) {
        return figure.box.width() <= room_x && figure.box.height() <= room_y;
    };
    const auto finish = [&](double scale) {
        const Figure empty = drawing.empty_at(scale);
        const PolygonParts parts = drawing.parts_of(empty);
        const auto close = [&](Figure& figure) {
            set_scale_bar(context, figure, 24, {figure.box.min.x, figure.box.max.y + 3});
            figure.marks.emplace_back(GroupEnd{});
            figure.caption = empty.caption;
        };
        const Spot room{room_x, room_y - 8};
        std::size_t letters = 0;
        if (const std::vector<Detail> details = details_of(parts, scale, 1, letters); !details.empty()) {
            Figure figure = drawing.with_parts(empty, parts, details);
            if (place_labels(figure, context.fonts, room, Labelling::if_all_free, context.theme.secondary)) {
                close(figure);
                if (set_details(figure, context, parts, details, {room_x, room_y}, letters) && fits(figure))
                    return figure;
            }
        }
        Figure figure = drawing.with_parts(empty, parts, {});
        place_labels(figure, context.fonts, room, Labelling::free, context.theme.secondary);
        close(figure);
        return figure;
    };
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = first_scale({drawing.width(), drawing.height()}, {room_x, room_y}, wish.finest),
                           .asked = wish.asked,
                           .exactly = wish.exactly,
                           .most_trials = 14,
                           .extent = std::max(drawing.width(), drawing.height()),
                           .least_shown = least_force_polygon};
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
        const double width = drawing.width() / trial.scale + 0.5 * label_reach,
                     height = drawing.height() / trial.scale + 8;
        if (!trial.last && !trial.asked && (width > room_x || height > room_y)) return std::nullopt;
        return finish(trial.scale);
    });
}

namespace {

/// Two equal and opposite forces have no polygon; the steps say so.
bool has_several_forces(const LoadCase& loads) {
    const auto has_three = [&](const FreeBody& body) {
        return body.polygon >= 0 && loads.solution().protocol.polygons[at_index(body.polygon)].vectors.size() > 2;
    };
    return !loads.together().empty() || std::any_of(loads.bodies().begin(), loads.bodies().end(), has_three);
}
std::vector<int> rows_of_polygons(const Shown& /*any*/, const LoadCase& loads) {
    return once(loads.is_alone() ? has_several_forces(loads) : !loads.bodies().empty() && has_force_polygons(loads));
}
void measure_rows(const Shown& shown, FigureId id, SizeWanted& size) {
    const LoadCase loads(shown.solution(), id.part);
    size.take(extent_of_polygons(loads, shown_polygons(loads)));
    size.may_be_larger = id.part != all_loads;
}
Figure draw_rows(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return force_polygons_figure(shown.context, room.x, room.y, wish, true, -1, id.part);
}

/// The pole of the rays is as far to the side as the forces are long.
void measure_single(const Solution& solution, int polygon, bool has_rays, SizeWanted& size) {
    const PolygonScene scene = polygon_scene(solution, polygon);
    size.extent_x = scene.width();
    size.extent_y = scene.height();
    size.subject = scene.longest;
    if (has_rays) size.extent_x += size.extent();
}
std::vector<int> polygons_of_bodies(const Shown& /*any*/, const LoadCase& loads) {
    std::vector<int> found;
    for (std::size_t i = 0; i < loads.bodies().size(); ++i)
        if (has_force_polygon(loads, loads.bodies()[i])) found.push_back(static_cast<int>(i));
    return found;
}
const FreeBody& body_of(const Shown& shown, FigureId id) { return shown.solution().free_bodies[at_index(id.of)]; }
void measure_polygon_of_body(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_single(shown.solution(), body_of(shown, id).polygon, body_of(shown, id).funicular.has_value(), size);
}
Figure draw_polygon_of_body(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return force_polygons_figure(shown.context, room.x, room.y, wish, false, body_of(shown, id).polygon);
}
std::vector<int> groups_of_bodies(const Shown& shown, const LoadCase& loads) {
    std::vector<int> found;
    if (has_forces(shown.solution()))
        for (std::size_t i = 0; i < loads.together().size(); ++i) found.push_back(static_cast<int>(i));
    return found;
}
const TakenTogether& group_of(const Shown& shown, FigureId id) {
    return shown.solution().taken_together[at_index(id.of)];
}
void measure_polygon_of_group(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_single(shown.solution(), group_of(shown, id).polygon, group_of(shown, id).funicular.has_value(), size);
}
Figure draw_polygon_of_group(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return force_polygons_figure(shown.context, room.x, room.y, wish, false, group_of(shown, id).polygon);
}

std::vector<int> has_partial_sums(const Shown& shown, const LoadCase& loads) {
    return once(!loads.bodies().empty() && !polygons_of_sums(shown.solution()).empty());
}
void measure_partial_sums(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    size.take(extent_of_polygons(shown.solution(), polygons_of_sums(shown.solution())));
}
Figure draw_partial_sums(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return partial_sums_figure(shown.context, room.x, room.y, wish);
}

std::vector<int> has_joined_parts(const Shown& shown, const LoadCase& loads) {
    return once(!loads.bodies().empty() && !polygons_of_parts(shown.solution()).empty());
}
void measure_joined_parts(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    size.take(extent_of_polygons(shown.solution(), polygons_of_parts(shown.solution())));
}
Figure draw_joined_parts(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return joined_parts_figure(shown.context, room.x, room.y, wish, id.of);
}
std::vector<int> joined_parts_of_bodies(const Shown& shown, const LoadCase& loads) {
    return loads.bodies().empty() ? std::vector<int>{} : polygons_of_parts(shown.solution());
}

std::vector<int> joined_polygons(const Shown& shown, const LoadCase& loads) {
    return loads.bodies().empty() ? std::vector<int>{} : closed_polygons(shown.solution());
}
void measure_joined_polygon(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_single(shown.solution(), id.of, false, size);
}
Figure draw_joined_polygon(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return closed_polygon_figure(shown.context, id.of, room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions forces_functions{rows_of_polygons, measure_rows, draw_rows};
constinit const FigureFunctions forces_of_body_functions{polygons_of_bodies, measure_polygon_of_body,
                                                         draw_polygon_of_body};
constinit const FigureFunctions forces_together_functions{groups_of_bodies, measure_polygon_of_group,
                                                          draw_polygon_of_group};
constinit const FigureFunctions partial_sums_functions{has_partial_sums, measure_partial_sums, draw_partial_sums};
constinit const FigureFunctions joined_parts_functions{has_joined_parts, measure_joined_parts, draw_joined_parts};
constinit const FigureFunctions joined_parts_of_body_functions{joined_parts_of_bodies, measure_joined_polygon,
                                                               draw_joined_parts};
constinit const FigureFunctions closed_polygon_functions{joined_polygons, measure_joined_polygon, draw_joined_polygon};

}  // namespace kinegraph::render
