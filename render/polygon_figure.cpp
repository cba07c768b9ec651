// Polygon figures: one polygon of the protocol to scale: pole, vectors, images of points, construction lines with their
// direction. Owns what such a figure shows; knows no method that made it, no sheet. The tip of every arrow lies exactly on its
// vertex.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/assert.hpp"
#include "render/shapes.hpp"
#include "render/tables.hpp"

namespace kinegraph::render {
namespace {

constexpr double overshoot = 12;     // of a construction line past the meet: it was found, not given
constexpr double short_of_pole = 3;  // … and before its support
constexpr double pole_radius = 0.9;
constexpr double label_reach = 7;    // what labels may add beyond the strokes on each side
constexpr double coincident = 0.02;  // mm: drawn as one

class Drawing {
public:
    Drawing(const DrawingContext& context, int polygon)
        : context_(context),
          protocol_(context.solution.protocol),
          index_(polygon),
          polygon_(protocol_.polygons[static_cast<std::size_t>(polygon)]) {
        const Units& units = context.solution.mechanism.units;
        const Unit& unit = polygon_.plane == Plane::acceleration ? units.acceleration : units.velocity;
        unit_ = unit.symbol;
        si_ = unit.si;
        si_is_one_ = si_ == Exact(1);
        measure();
    }

    bool empty() const { return !(extent_ > 0); }
    double width() const { return max_.x - min_.x; }
    double height() const { return max_.y - min_.y; }

    std::optional<double> asked() const {
        const std::string plane = polygon_.plane == Plane::acceleration ? "acceleration" : "velocity";
        std::optional<double> result;
        for (const AskedScale& scale : context_.solution.mechanism.scales)
            if (scale.figure == polygon_.id || (scale.figure == plane && !result))
                result = (scale.per_millimetre / si_).to_double();
        return result;
    }

    Figure at(double scale) const {
        Figure figure;
        figure.kind = polygon_.plane == Plane::acceleration ? "acceleration" : "velocity";
        figure.id = legal_id(polygon_.id);
        figure.caption = caption();
        figure.scale = scale;
        figure.unit = unit_;
        figure.marks.emplace_back(
            GroupBegin{"figure",
                       figure.id,
                       plain(figure.caption),
                       {{"data-figure", figure.kind}, {"data-scale", shortest(scale)}, {"data-unit", unit_}}});
        draw_trials(figure);
        draw_lines(figure);
        draw_vectors(figure);
        draw_pole(figure);
        label_images(figure);
        figure.box = box_of(figure.marks);
        draw_bar(figure);
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    struct Place {
        double x = 0, y = 0;
    };

    /// Each element is turned to doubles once: the rationals are long.
    Place place(int element) const {
        const auto [found, fresh] = places_.try_emplace(element);
        if (fresh) {
            const ProjectivePoint& at = protocol_.point(element);
            found->second = {in_unit(at.x), in_unit(at.y)};
        }
        return found->second;
    }
    /// The nearest double to a vector's exact length, in the file's unit; found once, because exact differences are dear.
    double value_of(int vector) const {
        const auto [found, fresh] = values_.try_emplace(vector);
        if (fresh) {
            const Vector exact = protocol_.value_of(protocol_.vectors[static_cast<std::size_t>(vector)]);
            found->second = kinegraph::length(si_is_one_ ? exact : Vector{exact.x / si_, exact.y / si_});
        }
        return found->second;
    }
    double in_unit(const Exact& si_value) const { return (si_is_one_ ? si_value : si_value / si_).to_double(); }
    Spot spot(const Figure& figure, Place p) const { return {p.x / figure.scale, -p.y / figure.scale}; }
    Spot spot(const Figure& figure, int element) const { return spot(figure, place(element)); }

    void measure() {
        const auto add = [&](int element) {
            if (protocol_.point(element).at_infinity()) return;
            const Place p = place(element);
            min_ = {std::min(min_.x, p.x), std::min(min_.y, p.y)};
            max_ = {std::max(max_.x, p.x), std::max(max_.y, p.y)};
        };
        for (const int v : polygon_.vectors) {
            add(protocol_.vectors[static_cast<std::size_t>(v)].tail);
            add(protocol_.vectors[static_cast<std::size_t>(v)].tip);
        }
        for (const int i : polygon_.images) add(protocol_.images[static_cast<std::size_t>(i)].point);
        extent_ = std::max(width(), height());
    }

    RichText caption() const {
        const Language language = context_.language;
        RichText text =
            one_piece(word(polygon_.plane == Plane::acceleration ? "acceleration polygon" : "velocity polygon", language));
        if (polygon_.point.empty()) return text;
        text.back().text += ": ";
        const RichText point = typeset(Symbol{Symbol::Letter::point, polygon_.point, ""}, language);
        append(text, point);
        const RichText seen =
            one_piece(" " + word(polygon_.translating ? "seen from axes translating with" : "seen from body", language) + " ");
        append(text, seen);
        const RichText observer = polygon_.translating ? typeset(Symbol{Symbol::Letter::point, polygon_.observer, ""}, language)
                                                       : one_piece(polygon_.observer);
        append(text, observer);
        return text;
    }

    BodyColour colour_of(BodyIndex body) const {
        if (body <= 0) return {context_.theme.text, context_.theme.paper, context_.theme.text};
        return context_.theme.body(body);
    }

    void draw_lines(Figure& figure) const {
        const Pen pen{context_.theme.thin, context_.theme.secondary, {}, false};
        struct Drawn {
            Spot from, to;
            std::string words;
        };
        std::vector<Drawn> drawn;
        for (const DrawnLine& each : protocol_.lines) {
            if (each.polygon != index_ || each.line < 0) continue;
            const ProjectiveLine& geometry = protocol_.line(each.line);
            if (geometry.at_infinity()) continue;
            const Vector direction = geometry.direction();
            // A direction as a double, whatever the size of its coordinates.
            const Exact largest = std::max(abs(direction.x), abs(direction.y));
            Spot along = unit({(direction.x / largest).to_double(), -(direction.y / largest).to_double()});
            std::vector<Spot> spots;
            for (const int element : each.points)
                if (!protocol_.point(element).at_infinity()) spots.push_back(spot(figure, element));
            if (spots.empty()) continue;
            const Spot support = spots.front(), meet = spots.back();
            const double reach = dot(meet - support, along);
            if (reach < 0) along = -1.0 * along;
            Drawn line_drawn{support - short_of_pole * along, meet + overshoot * along,
                             plain(typeset(each.reason, context_.language))};
            if (std::abs(reach) < coincident) line_drawn.from = support - overshoot * along;
            const bool twice = std::any_of(drawn.begin(), drawn.end(), [&](const Drawn& other) {
                return other.words == line_drawn.words && length(other.to - line_drawn.to) < coincident;
            });
            if (twice) continue;
            drawn.push_back(line_drawn);
            figure.marks.emplace_back(line(line_drawn.from, line_drawn.to, pen));
            belong(figure.marks, figure.marks.size() - 1, each.statement);
            if (each.reason.kind == LineReason::Kind::known) continue;
            LabelRequest mark;
            mark.text = typeset(each.reason, context_.language);
            mark.size = context_.theme.small;
            mark.colour = context_.theme.secondary;
            mark.anchor = meet + (0.58 * overshoot) * along;
            mark.toward = meet + overshoot * along;
            mark.clearance = 1.2;
            mark.along = true;
            mark.statement = each.statement;
            figure.labels.push_back(std::move(mark));
        }
    }

    /// What was assumed and drawn on the way: thin, broken and grey, as far as it lies near the solution; its vertices carry the
    /// number of the trial.
    void draw_trials(Figure& figure) const {
        const Trials& trials = protocol_.trials;
        const double near = 0.5 * extent_;
        const auto is_near = [&](int element) {
            if (protocol_.point(element).at_infinity()) return false;
            const Place p = place(element);
            return p.x > min_.x - near && p.x < max_.x + near && p.y > min_.y - near && p.y < max_.y + near;
        };
        const Pen pen{context_.theme.thin, context_.theme.secondary, dashes(), false};
        const auto draw = [&](int from, int to, int statement) {
            if (!is_near(from) || !is_near(to)) return;
            figure.marks.emplace_back(line(spot(figure, from), spot(figure, to), pen));
            belong(figure.marks, figure.marks.size() - 1, statement);
        };
        for (const DrawnVector& vector : trials.vectors)
            if (vector.polygon == index_) draw(vector.tail, vector.tip, vector.statement);
        for (const DrawnLine& each : trials.lines)
            if (each.polygon == index_ && each.points.size() > 1) draw(each.points.front(), each.points.back(), each.statement);
        for (const Image& image : trials.images) {
            if (image.polygon != index_ || !is_near(image.point)) continue;
            figure.marks.emplace_back(disc(spot(figure, image.point), 0.4, context_.theme.secondary));
            const int statement = protocol_.strokes[static_cast<std::size_t>(image.point)].statement;
            belong(figure.marks, figure.marks.size() - 1, statement);
            LabelRequest label;
            label.statement = statement;
            label.text = typeset(image.symbol, context_.language);
            if (!label.text.empty()) label.text.back().sup += image.trial == 1 ? "I" : "II";
            label.size = context_.theme.small;
            label.colour = context_.theme.secondary;
            label.anchor = spot(figure, image.point);
            label.clearance = 1.4;
            figure.labels.push_back(std::move(label));
        }
    }

    void draw_vectors(Figure& figure) const {
        std::set<std::string> names;
        std::set<std::tuple<int, int, std::string>> seen;
        struct Labelled {
            Spot tail, tip;
            std::size_t label;
        };
        std::vector<Labelled> labelled;
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[static_cast<std::size_t>(index)];
            const double value = value_of(index);
            if (!(value > extent_ * 1e-12)) continue;  // nothing to draw: the tables say that it is zero
            const std::string base = name_of(vector.symbol);
            if (!seen.emplace(vector.tail, vector.tip, base).second) continue;
            std::string name = base;
            for (int n = 2; !names.insert(name).second; ++n) name = base + "-" + std::to_string(n);

            const BodyColour colour = colour_of(vector.body);
            const Spot tail = spot(figure, vector.tail), tip = spot(figure, vector.tip);
            const std::size_t first = figure.marks.size();
            figure.marks.emplace_back(GroupBegin{"vector",
                                                 figure.id + "-" + legal_id(name),
                                                 name + " = " + shortest(value) + " " + unit_,
                                                 {{"data-name", name}, {"data-value", shortest(value)}}});
            figure.marks.emplace_back(Axis{tail, tip});
            // Of those that fall together the first is drawn, and their one label has its colour: a_A = a_A^n.
            const auto same = std::find_if(labelled.begin(), labelled.end(), [&](const Labelled& other) {
                return (length(other.tail - tail) < coincident && length(other.tip - tip) < coincident);
            });
            if (same == labelled.end()) draw_arrow(figure.marks, tail, tip, context_.theme.vector, colour.line, colour.dashes);
            figure.marks.emplace_back(GroupEnd{});
            belong(figure.marks, first, vector.statement);

            if (same != labelled.end()) {
                RichText& text = figure.labels[same->label].text;
                append(text, one_piece(" = "));
                const RichText more = typeset(vector.symbol, context_.language);
                append(text, more);
                continue;
            }
            labelled.push_back({tail, tip, figure.labels.size()});

            LabelRequest label;
            label.text = typeset(vector.symbol, context_.language);
            label.size = context_.theme.equation;
            label.colour = colour.letter;
            label.anchor = 0.5 * (tail + tip);
            label.toward = tip;
            label.clearance = 1.5;
            label.statement = vector.statement;
            figure.labels.push_back(std::move(label));
        }
    }

    void draw_pole(Figure& figure) const {
        figure.marks.emplace_back(
            ring({0, 0}, pole_radius, context_.theme.paper, {context_.theme.outline, context_.theme.text, {}, false}));
    }

    /// Images that fall together share a label: b ≡ c; those at the pole stand with it.
    void label_images(Figure& figure) const {
        struct Cluster {
            Spot at;
            RichText text;
            std::set<std::string> names;
            int statement = -1;
        };
        std::vector<Cluster> clusters;
        Symbol pole{Symbol::Letter::pole, polygon_.plane == Plane::acceleration ? "a" : "v", ""};
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[static_cast<std::size_t>(index)];
            if (image.symbol.letter == Symbol::Letter::pole && !image.symbol.about.empty()) pole = image.symbol;
        }
        clusters.push_back({{0, 0}, typeset(pole, context_.language), {name_of(pole)}, -1});
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[static_cast<std::size_t>(index)];
            if (image.symbol.letter == Symbol::Letter::pole || protocol_.point(image.point).at_infinity()) continue;
            const Spot at = spot(figure, image.point);
            const std::string name = name_of(image.symbol);
            const RichText text = typeset(image.symbol, context_.language);
            auto same =
                std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& c) { return length(c.at - at) < coincident; });
            if (same == clusters.end()) {
                clusters.push_back({at, text, {name}, statement_of(image)});
            } else if (same->names.insert(name).second) {
                append(same->text, one_piece(" ≡ "));
                same->text.insert(same->text.end(), text.begin(), text.end());
            }
        }
        for (const Cluster& cluster : clusters) {
            if (&cluster != &clusters.front() && !touched_by_vector(figure, cluster.at)) {
                figure.marks.emplace_back(disc(cluster.at, 0.5, context_.theme.text));
                belong(figure.marks, figure.marks.size() - 1, cluster.statement);
            }
            LabelRequest label;
            label.statement = cluster.statement;
            label.text = cluster.text;
            label.size = context_.theme.label;
            label.colour = context_.theme.text;
            label.anchor = cluster.at;
            label.clearance = 2.0;
            figure.labels.push_back(std::move(label));
        }
    }
    /// An image stands once a vector ends in it; where none does, once its point is found.
    int statement_of(const Image& image) const {
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[static_cast<std::size_t>(index)];
            if (vector.tip == image.point || vector.tail == image.point) return vector.statement;
        }
        return protocol_.strokes[static_cast<std::size_t>(image.point)].statement;
    }
    bool touched_by_vector(const Figure& figure, Spot at) const {
        return std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark& mark) {
            const auto* axis = std::get_if<Axis>(&mark);
            return axis && (length(axis->tail - at) < coincident || length(axis->tip - at) < coincident);
        });
    }

    /// The bar stands in a corner that nothing crosses, else under the figure.
    void draw_bar(Figure& figure) const {
        if (empty()) return;
        std::vector<Mark> bar;
        draw_scale_bar(bar, context_.fonts, context_.theme, {0, 0}, 24, figure.scale, 1, unit_, context_.language);
        const Box size = box_of(bar);
        const Box box = figure.box;
        const double left = box.min.x - size.min.x, right = box.max.x - size.max.x;
        const double top = box.min.y - size.min.y, bottom = box.max.y - size.max.y;
        const std::array<Spot, 4> corners{Spot{right, bottom}, Spot{left, bottom}, Spot{right, top}, Spot{left, top}};
        Spot chosen{left, box.max.y + 5 - size.min.y};
        for (const Spot corner : corners)
            if (is_free(figure, {{size.min.x + corner.x - 7, size.min.y + corner.y - 7},
                                 {size.max.x + corner.x + 7, size.max.y + corner.y + 7}})) {
                chosen = corner;
                break;
            }
        render::move(bar, chosen.x, chosen.y);
        figure.marks.insert(figure.marks.end(), bar.begin(), bar.end());
    }
    static bool is_free(const Figure& figure, const Box& box) {
        Spot pen;
        for (const Mark& mark : figure.marks) {
            const auto* path = std::get_if<Path>(&mark);
            if (!path) continue;
            for (const Segment& segment : path->segments) {
                if (const auto* m = std::get_if<MoveTo>(&segment)) pen = m->to;
                if (const auto* l = std::get_if<LineTo>(&segment)) {
                    const int pieces = std::max(1, static_cast<int>(length(l->to - pen)));
                    for (int i = 0; i <= pieces; ++i) {
                        const Spot at = pen + (static_cast<double>(i) / pieces) * (l->to - pen);
                        if (at.x > box.min.x && at.x < box.max.x && at.y > box.min.y && at.y < box.max.y) return false;
                    }
                    pen = l->to;
                }
                if (const auto* a = std::get_if<ArcTo>(&segment))
                    if (a->centre.x > box.min.x && a->centre.x < box.max.x && a->centre.y > box.min.y && a->centre.y < box.max.y)
                        return false;
            }
        }
        return true;
    }

    const DrawingContext& context_;
    const Protocol& protocol_;
    int index_;
    const Polygon& polygon_;
    std::string unit_;
    Exact si_ = 1;
    bool si_is_one_ = true;
    mutable std::map<int, Place> places_;
    mutable std::map<int, double> values_;
    Place min_, max_;  // the pole, at the origin, belongs to it
    double extent_ = 0;
};

double next_scale(double scale) { return choose_scale(scale * 1.01, 0, 1, 1, std::nullopt); }

}  // namespace

Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y) {
    KG_ASSERT(polygon >= 0 && static_cast<std::size_t>(polygon) < context.solution.protocol.polygons.size(),
              "a polygon of the protocol");
    const Drawing drawing(context, polygon);
    const auto fits = [&](const Figure& figure, double reach) {
        return figure.box.width() + 2 * reach <= room_x && figure.box.height() + 2 * reach <= room_y;
    };
    /// Whether the figure is done.
    const auto finish = [&](Figure& figure, bool whatever_it_takes) {
        if (!place_labels(figure, context.fonts, Spot{room_x, room_y},
                          whatever_it_takes ? Labelling::free : Labelling::if_it_fits))
            return false;
        figure.marks.emplace_back(GroupEnd{});
        return whatever_it_takes || fits(figure, 0);
    };
    if (drawing.empty()) {
        Figure figure = drawing.at(1);
        finish(figure, true);
        return figure;
    }
    if (const auto asked = drawing.asked()) {
        Figure figure = drawing.at(*asked);
        if (fits(figure, 0) && finish(figure, false)) return figure;
    }
    double scale = choose_scale(drawing.width(), drawing.height(), room_x, room_y, std::nullopt);
    // Where a room is too small for lettering at all, the smallest figure that still shows something is handed out.
    constexpr double least_shown = 12;
    for (;; scale = next_scale(scale)) {
        const bool last = std::max(drawing.width(), drawing.height()) / next_scale(scale) < least_shown;
        Figure figure = drawing.at(scale);
        if (!last && !fits(figure, 0.4 * label_reach)) continue;
        if (finish(figure, last)) return figure;
    }
}

}  // namespace kinegraph::render
