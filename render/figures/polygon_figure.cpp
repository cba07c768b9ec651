// Polygon figures: one polygon of the protocol to scale: pole, vectors, images of points, construction lines with their
// direction. Owns what such a figure shows; knows no method that made it, no sheet. The tip of every arrow lies exactly on its
// vertex.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/assert.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double overshoot = 12;     // of a construction line past the meet: it was found, not given
constexpr double short_of_pole = 3;  // … and before its support
constexpr double seen_apart = 1.5;   // where it ends, from the other line of the meet, …
constexpr double most_overshoot = 25;
constexpr double trial_overshoot = 4;
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

    /// Strokes and label requests at a scale, the group still open.
    Figure at(double scale) const {
        const Figure empty = empty_at(scale);
        return with_parts(empty, parts_of(empty), {});
    }
    Figure empty_at(double scale) const {
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
        return figure;
    }
    PolygonParts parts_of(const Figure& figure) const {
        PolygonParts parts;
        add_vectors(parts, figure);
        add_trials(parts, figure);
        add_lines(parts, figure);
        add_images(parts, figure);
        return parts;
    }
    Figure with_parts(Figure figure, const PolygonParts& parts, const std::vector<Detail>& details) const {
        draw_parts(figure, context_, parts, details);
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
    /// A finite line's direction on paper, whatever the size of its coordinates.
    Spot direction_of(int line) const {
        const auto [found, fresh] = directions_.try_emplace(line);
        if (fresh) {
            const Vector direction = protocol_.line(line).direction();
            const Exact largest = std::max(abs(direction.x), abs(direction.y));
            found->second = unit({(direction.x / largest).to_double(), -(direction.y / largest).to_double()});
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
        text.insert(text.end(), point.begin(), point.end());
        const RichText seen =
            one_piece(" " + word(polygon_.translating ? "seen from axes translating with" : "seen from body", language) + " ");
        text.insert(text.end(), seen.begin(), seen.end());
        const RichText observer = polygon_.translating ? typeset(Symbol{Symbol::Letter::point, polygon_.observer, ""}, language)
                                                       : one_piece(polygon_.observer);
        text.insert(text.end(), observer.begin(), observer.end());
        return text;
    }

    BodyColour colour_of(BodyIndex body) const {
        if (body <= 0) return {context_.theme.text, context_.theme.paper, context_.theme.text};
        return context_.theme.body(body);
    }

    void add_lines(PolygonParts& parts, const Figure& figure) const {
        const Pen pen{context_.theme.thin, context_.theme.secondary, {}, false};
        const std::size_t first = parts.lines.size();
        std::vector<std::string> words;
        std::vector<Ray> rays;
        for (const DrawnLine& each : protocol_.lines) {
            if (each.polygon != index_ || each.line < 0) continue;
            if (protocol_.line(each.line).at_infinity()) continue;
            Spot along = direction_of(each.line);
            std::vector<Spot> spots;
            for (const int element : each.points)
                if (!protocol_.point(element).at_infinity()) spots.push_back(spot(figure, element));
            if (spots.empty()) continue;
            const Spot support = spots.front(), meet = spots.back();
            const double reach = dot(meet - support, along);
            if (reach < 0) along = -1.0 * along;
            PolygonLine drawn;
            drawn.from = support - short_of_pole * along;
            drawn.to = meet + overshoot * along;
            if (std::abs(reach) < coincident) drawn.from = support - overshoot * along;
            const RichText reason = typeset(each.reason, context_.language);
            const std::string said = plain(reason);
            bool twice = false;
            for (std::size_t i = 0; i < words.size(); ++i)
                twice = twice || (words[i] == said && length(parts.lines[first + i].to - drawn.to) < coincident);
            if (twice) continue;
            words.push_back(said);
            drawn.pen = pen;
            drawn.statement = each.statement;
            if (each.reason.kind != LineReason::Kind::known) {
                drawn.mark = reason;
                drawn.mark_at = meet + (0.58 * overshoot) * along;
                drawn.mark_toward = meet + overshoot * along;
            }
            add_corner(parts, each, support, along, std::abs(reach));
            parts.lines.push_back(std::move(drawn));
            rays.push_back({meet, along});
        }
        // Lines that meet at a small angle run on until they are seen to part.
        for (std::size_t i = 0; i < rays.size(); ++i)
            for (std::size_t j = 0; j < rays.size(); ++j) {
                const double sine = std::abs(cross(rays[i].along, rays[j].along));
                if (length(rays[i].meet - rays[j].meet) > coincident || overshoot * sine > seen_apart || sine < 1e-9) continue;
                parts.lines[first + i].to = rays[i].meet + std::min(seen_apart / sine, most_overshoot) * rays[i].along;
            }
    }
    struct Ray {
        Spot meet, along;
    };

    /// A line that is drawn ⟂ to a known vector through its tip, as a^t to a^n, or through its tail, as a^rel to a Coriolis term
    /// that is set off last.
    void add_corner(PolygonParts& parts, const DrawnLine& drawn, Spot support, Spot along, double reach) const {
        for (const PolygonVector& vector : parts.vectors) {
            if (!vector.has_right_angles) continue;
            const bool at_tip = length(vector.tip - support) < coincident;
            if (!at_tip && length(vector.tail - support) >= coincident) continue;
            const Spot leg = at_tip ? vector.tail - vector.tip : vector.tip - vector.tail;
            if (std::abs(dot(unit(leg), along)) > 1e-9) continue;
            parts.corners.push_back({support, unit(leg), along, std::min(length(leg), reach), drawn.statement});
            return;
        }
    }

    /// What was assumed and drawn on the way: thin, broken and grey, as far as it lies near the solution; its vertices carry the
    /// number of the trial.
    void add_trials(PolygonParts& parts, const Figure& figure) const {
        const Trials& trials = protocol_.trials;
        const double near = 0.5 * extent_;
        const auto is_near = [&](int element) {
            if (protocol_.point(element).at_infinity()) return false;
            const Place p = place(element);
            return p.x > min_.x - near && p.x < max_.x + near && p.y > min_.y - near && p.y < max_.y + near;
        };
        const Pen pen{context_.theme.thin, context_.theme.secondary, dashes(), false};
        const auto add = [&](int from, int to, double beyond, int statement) {
            if (!is_near(from) || !is_near(to)) return;
            const Spot start = spot(figure, from), end = spot(figure, to);
            PolygonLine drawn;
            drawn.from = start;
            drawn.to = length(end - start) > coincident ? end + beyond * unit(end - start) : end;
            drawn.pen = pen;
            drawn.statement = statement;
            parts.lines.push_back(std::move(drawn));
        };
        for (const DrawnVector& vector : trials.vectors)
            if (vector.polygon == index_) add(vector.tail, vector.tip, 0, vector.statement);
        for (const DrawnLine& each : trials.lines)
            if (each.polygon == index_ && each.points.size() > 1)
                add(each.points.front(), each.points.back(), trial_overshoot, each.statement);
        for (const Image& image : trials.images) {
            if (image.polygon != index_ || !is_near(image.point)) continue;
            PolygonImage trial;
            trial.kind = PolygonImage::Kind::trial;
            trial.at = spot(figure, image.point);
            trial.text = typeset(image.symbol, context_.language);
            if (!trial.text.empty()) trial.text.back().sup += image.trial == 1 ? "I" : "II";
            trial.statement = image.statement;
            parts.images.push_back(std::move(trial));
        }
    }

    void add_vectors(PolygonParts& parts, const Figure& figure) const {
        std::set<std::string> names;
        std::set<std::tuple<int, int, std::string>> seen;
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[static_cast<std::size_t>(index)];
            const double value = value_of(index);
            if (!(value > extent_ * 1e-12)) continue;  // nothing to draw: the tables say that it is zero
            const std::string base = name_of(vector.symbol);
            if (!seen.emplace(vector.tail, vector.tip, base).second) continue;
            PolygonVector drawn;
            drawn.name = base;
            for (int n = 2; !names.insert(drawn.name).second; ++n) drawn.name = base + "-" + std::to_string(n);
            drawn.tail = spot(figure, vector.tail);
            drawn.tip = spot(figure, vector.tip);
            drawn.value = value;
            drawn.text = typeset(vector.symbol, context_.language);
            drawn.colour = colour_of(vector.body);
            drawn.has_right_angles = vector.role == DrawnVector::Role::normal || vector.role == DrawnVector::Role::coriolis;
            drawn.statement = vector.statement;
            parts.vectors.push_back(std::move(drawn));
        }
    }

    void add_images(PolygonParts& parts, const Figure& figure) const {
        PolygonImage pole;
        pole.kind = PolygonImage::Kind::pole;
        Symbol symbol{Symbol::Letter::pole, polygon_.plane == Plane::acceleration ? "a" : "v", ""};
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[static_cast<std::size_t>(index)];
            if (image.symbol.letter == Symbol::Letter::pole && !image.symbol.about.empty()) symbol = image.symbol;
        }
        pole.text = typeset(symbol, context_.language);
        pole.name = name_of(symbol);
        parts.images.push_back(std::move(pole));
        for (const int index : polygon_.images) {
            const Image& image = protocol_.images[static_cast<std::size_t>(index)];
            if (image.symbol.letter == Symbol::Letter::pole || protocol_.point(image.point).at_infinity()) continue;
            PolygonImage drawn;
            drawn.at = spot(figure, image.point);
            drawn.name = name_of(image.symbol);
            drawn.text = typeset(image.symbol, context_.language);
            drawn.statement = statement_of(image);
            parts.images.push_back(std::move(drawn));
        }
    }
    /// An image stands once a vector ends in it; where none does, once its point is found.
    int statement_of(const Image& image) const {
        for (const int index : polygon_.vectors) {
            const DrawnVector& vector = protocol_.vectors[static_cast<std::size_t>(index)];
            if (vector.tip == image.point || vector.tail == image.point) return vector.statement;
        }
        return image.statement;
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
    mutable std::map<int, Spot> directions_;
    Place min_, max_;  // the pole, at the origin, belongs to it
    double extent_ = 0;
};

}  // namespace

Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y, double coarsest) {
    KG_ASSERT(polygon >= 0 && static_cast<std::size_t>(polygon) < context.solution.protocol.polygons.size(),
              "a polygon of the protocol");
    const Drawing drawing(context, polygon);
    const Spot room{room_x, room_y};
    const auto fits = [&](const Figure& figure, double reach) {
        return figure.box.width() + 2 * reach <= room_x && figure.box.height() + 2 * reach <= room_y;
    };
    /// Whether the figure is done.
    const auto finish = [&](Figure& figure, bool whatever_it_takes) {
        if (!place_labels(figure, context.fonts, room, whatever_it_takes ? Labelling::free : Labelling::if_it_fits)) return false;
        figure.marks.emplace_back(GroupEnd{});
        return true;
    };
    struct Attempt {
        Figure empty;
        PolygonParts parts;
        std::size_t letters = 0;
        std::vector<Detail> details;
    };
    const auto attempt = [&](double scale) {
        Attempt made;
        made.empty = drawing.empty_at(scale);
        made.parts = drawing.parts_of(made.empty);
        made.details = details_of(made.parts, scale, 1, made.letters);
        return made;
    };
    // With its details; nothing where it wants none, or they have no room or leave the letters none.
    const auto detailed = [&](const Attempt& made) -> std::optional<Figure> {
        if (made.details.empty()) return std::nullopt;
        Figure figure = drawing.with_parts(made.empty, made.parts, made.details);
        if (!place_labels(figure, context.fonts, room, Labelling::if_all_free) || !fits(figure, 0)) return std::nullopt;
        figure.marks.emplace_back(GroupEnd{});
        std::size_t letters = made.letters;
        if (!set_details(figure, context, made.parts, made.details, room, letters) || !fits(figure, 0)) return std::nullopt;
        return figure;
    };
    if (drawing.empty()) {
        Figure figure = drawing.at(1);
        finish(figure, true);
        return figure;
    }
    // Where a room is too small for lettering at all, the smallest figure that still shows something is handed out.
    constexpr double least_shown = 12;
    // Names that would take more of the room than this hardly ever find places: not worth trying where another room may do.
    constexpr double crowded = 0.17;
    // A polygon smaller than this is worth more than details beside it.
    constexpr double least_with_details = 60;
    const FitPolicy policy{.room = room,
                           .first = choose_scale(drawing.width(), drawing.height(), room_x, room_y, std::nullopt),
                           .asked = drawing.asked(),
                           .coarsest = coarsest,
                           .extent = std::max(drawing.width(), drawing.height()),
                           .least_shown = least_shown};
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
        if (trial.number == 0 && !trial.asked && coarsest < any_scale &&
            room_of_names(drawing.at(trial.scale), context.fonts) > crowded * room_x * room_y)
            return Figure::empty_at(any_scale);
        const Attempt made = attempt(trial.scale);
        Figure figure = drawing.with_parts(made.empty, made.parts, {});
        if (!trial.last && !trial.asked && !fits(figure, 0.4 * label_reach)) return std::nullopt;
        if (auto with_details = detailed(made)) return with_details;
        if (trial.asked && !fits(figure, 0)) return std::nullopt;
        if (!finish(figure, trial.last) || (!trial.last && !fits(figure, 0))) return std::nullopt;
        if (trial.asked || made.details.empty()) return figure;
        // One step smaller with its details is better than without.
        if (const double smaller = next_scale(trial.scale); policy.extent / smaller > least_with_details && smaller <= coarsest)
            if (auto with_details = detailed(attempt(smaller))) return with_details;
        figure.lacks_details = true;
        return figure;
    });
}

}  // namespace kinegraph::render
