// Polygon figures: a polygon of motion to scale with pole, vectors, images of points, and construction lines with their
// directions. Owns the lengths of lines and their labels; depends on no protocol and no sheet. The tip of each arrow
// lies exactly on its vertex.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/number/functions.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/line_numbers.hpp"

namespace kinegraph::render {
namespace {

constexpr double past_the_meet = 12;    // of a construction line beyond the intersection that it found
constexpr double past_with_number = 5;  // … of one that has its number alone
constexpr double short_of_pole = 3;     // … and before its starting point
// mm; beside a shorter longest vector the directions in words would take as much room as the vectors. Where a step says
// which line has which number, that number is enough.
constexpr double hardly_measured = 50;
constexpr double seen_apart = 1.5;  // distance of its end from the other line of the intersection
constexpr double most_overshoot = 25;
constexpr double trial_overshoot = 4;
constexpr double least_image = 12;      // mm²; least area of the image of a link
constexpr double least_image_line = 4;  // mm; least length of the image of a link whose points are collinear
constexpr double letters_beyond = 2.8;  // least space for letters beyond the strokes, on each side

/// The corners of a polygon figure: the scale bar, and a sketch of the direction of the Coriolis term.
class CornersOfPolygon {
public:
    CornersOfPolygon(const DrawingContext& context, const PolygonScene& scene) : context_(context), scene_(scene) {}

    /// The bar stands in a corner that nothing crosses, otherwise below the figure.
    void draw_bar(Figure& figure) const {
        if (scene_.empty()) return;
        std::vector<Mark> bar;
        draw_scale_bar(bar, context_.fonts, context_.theme, {0, 0}, 24, figure.scale, 1, figure.unit,
                       context_.language);
        const Box size = box_of(bar);
        const Box box = figure.box;
        const double left = box.min.x - size.min.x, right = box.max.x - size.max.x;
        const double top = box.min.y - size.min.y, bottom = box.max.y - size.max.y;
        constexpr double clear = 4;  // mm about it, for a row of letters
        const std::array<Spot, 4> corners{Spot{right, bottom}, Spot{left, bottom}, Spot{right, top}, Spot{left, top}};
        Spot chosen{left, box.max.y + 5 - size.min.y};
        for (const Spot corner : corners)
            if (is_free(figure, {{size.min.x + corner.x - clear, size.min.y + corner.y - clear},
                                 {size.max.x + corner.x + clear, size.max.y + corner.y + clear}})) {
                chosen = corner;
                break;
            }
        render::move(bar, chosen.x, chosen.y);
        figure.marks.insert(figure.marks.end(), bar.begin(), bar.end());
    }

    /// In a free corner: v_rel, and v_rel turned by a quarter turn with ω, which is the direction of the Coriolis term.
    void draw_coriolis(Figure& figure, const SceneCoriolis& shown) const {
        constexpr double arm = 11, turn = 5.5, reach = 7;  // mm; `reach`: of the letters
        const Spot along{shown.along.x, -shown.along.y};
        const Spot across = (shown.counter_clockwise ? -1.0 : 1.0) * Spot{-along.y, along.x};
        const Box size = box_round({Spot{}, arm * along, arm * across});
        const Box& box = figure.box;
        std::optional<Spot> origin;
        for (const double y : {box.max.y - size.max.y, box.min.y - size.min.y})
            for (const double x : {box.max.x - size.max.x, box.min.x - size.min.x})
                if (!origin && is_free(figure, {{size.min.x + x - reach, size.min.y + y - reach},
                                                {size.max.x + x + reach, size.max.y + y + reach}}))
                    origin = Spot{x, y};
        if (!origin) return;
        const Theme& theme = context_.theme;
        const BodyColour colour = theme.colour_of(shown.body), guide = theme.colour_of(shown.guide);
        const std::size_t first = figure.marks.size();
        draw_arrow(figure.marks, *origin, *origin + arm * along, theme.outline, colour.line);
        draw_arrow(figure.marks, *origin, *origin + arm * across, theme.outline, colour.line);
        const double from = nearest::atan2(along.y, along.x);
        draw_arc_arrow(figure.marks, *origin, turn, from,
                       from + (shown.counter_clockwise ? -0.5 : 0.5) * std::numbers::pi, theme.thin, guide.letter);
        belong(figure.marks, first, shown.statement);
        const auto name = [&](const Symbol& symbol, Spot at, Colour ink) {
            LabelRequest& label = figure.labels.emplace_back();
            label.text = typeset(symbol, context_.language);
            label.size = theme.small;
            label.colour = ink;
            label.anchor = *origin + at;
            label.clearance = 1.2;
            label.statement = shown.statement;
        };
        name(shown.velocity, 0.8 * arm * along, colour.letter);
        name(shown.coriolis, 0.8 * arm * across, colour.letter);
        name(shown.omega, (turn / std::sqrt(2.0)) * (along + across), guide.letter);
    }

private:
    static Box box_round(const std::vector<Spot>& spots) {
        Box box{spots.front(), spots.front()};
        for (const Spot spot : spots) box.include(spot);
        return box;
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
                    if (a->centre.x > box.min.x && a->centre.x < box.max.x && a->centre.y > box.min.y &&
                        a->centre.y < box.max.y)
                        return false;
            }
        }
        return true;
    }

    const DrawingContext& context_;
    const PolygonScene& scene_;
};

class PolygonDrawing {
public:
    /// `has_steps`: see ScaleWish.
    PolygonDrawing(const DrawingContext& context, const PolygonScene& scene, bool has_steps)
        : context_(context), scene_(scene), numbers_(scene), has_steps_(has_steps) {}
    bool empty() const { return scene_.empty(); }
    double width() const { return scene_.width(); }
    double height() const { return scene_.height(); }

    /// Strokes and label requests at a scale, with an open group.
    Figure at(double scale) const {
        const Figure empty = empty_at(scale);
        return with_parts(empty, parts_of(empty), {});
    }
    Figure empty_at(double scale) const {
        Figure figure =
            begun(context_, {is_acceleration() ? FigureKind::acceleration_polygon : FigureKind::velocity_polygon});
        figure.id = legal_id(scene_.id);
        add_motion(figure.caption);
        figure.scale = scale;
        figure.has_scale = !scene_.vectors.empty();
        figure.unit = scene_.unit.symbol;
        open_group(figure);
        return figure;
    }
    PolygonParts parts_of(const Figure& figure) const {
        PolygonParts parts;
        add_vectors(parts, figure);
        set_side_by_side(parts);
        add_trials(parts, figure);
        add_lines(parts, figure);
        add_images(parts, figure);
        return parts;
    }
    Figure with_parts(Figure figure, const PolygonParts& parts, const std::vector<Detail>& details) const {
        draw_images_of_bodies(figure);
        draw_parts(figure, context_, parts, details);
        figure.box = box_of(figure.marks);
        const CornersOfPolygon corners(context_, scene_);
        corners.draw_bar(figure);
        if (!scene_.coriolis.empty()) corners.draw_coriolis(figure, scene_.coriolis.front());
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    bool is_acceleration() const { return scene_.kind == PolygonScene::Kind::acceleration; }
    static Spot spot(const Figure& figure, Place p) { return {p.x / figure.scale, -p.y / figure.scale}; }

    /// Of which point it is, and as seen from where.
    void add_motion(RichText& text) const {
        const Language language = context_.language;
        if (scene_.point.empty()) return;
        text.back().text += word(lang::notation::colon, language);
        append(text, typeset(Symbol{Symbol::Letter::point, scene_.point, ""}, language));
        append(text,
               " " +
                   word(scene_.translating ? lang::sheet::seen_from_axes_translating_with : lang::sheet::seen_from_body,
                        language) +
                   " ");
        append(text, scene_.translating ? typeset(Symbol{Symbol::Letter::point, scene_.observer, ""}, language)
                                        : one_piece(scene_.observer));
    }

    /// The image is similar to the body: a tint, with an edge where there is no vector. If the points are collinear,
    /// the image is a line that they divide in the same ratio.
    void draw_images_of_bodies(Figure& figure) const {
        for (const SceneFace& face : scene_.faces) {
            std::vector<Spot> corners;
            for (const Place corner : face.corners) corners.push_back(spot(figure, corner));
            const BodyColour colour = context_.theme.colour_of(face.body);
            const Pen edge{context_.theme.thin, colour.line, {}, false};
            const std::size_t first = figure.marks.size();
            if (const auto line = line_of(corners)) {
                if (!is_covered(figure, *line)) figure.marks.emplace_back(polyline(*line, edge));
            } else {
                corners = hull_of(std::move(corners));
                if (area_of(corners) < least_image) continue;
                figure.marks.emplace_back(tinted(filled(corners, colour.tint)));
                figure.marks.emplace_back(polyline(corners, edge, true));
            }
            belong(figure.marks, first, face.statement);
        }
    }
    static double area_of(const std::vector<Spot>& corners) {
        double area = 0;
        for (std::size_t i = 2; i < corners.size(); ++i)
            area += 0.5 * std::abs(cross(corners[i - 1] - corners[0], corners[i] - corners[0]));
        return area;
    }
    /// For three or more distinct collinear corners the outermost two; otherwise empty.
    static std::optional<std::vector<Spot>> line_of(const std::vector<Spot>& corners) {
        Spot from, to;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (length(corners[i] - corners[j]) > length(to - from)) from = corners[j], to = corners[i];
        const double span = length(to - from);
        if (span < least_image_line) return std::nullopt;
        bool has_between = false;
        for (const Spot corner : corners) {
            if (std::abs(cross(unit(to - from), corner - from)) > coincident) return std::nullopt;
            has_between = has_between || (length(corner - from) > coincident && length(corner - to) > coincident);
        }
        return has_between ? std::optional(std::vector{from, to}) : std::nullopt;
    }
    bool is_covered(const Figure& figure, const std::vector<Spot>& line) const {
        return std::any_of(scene_.vectors.begin(), scene_.vectors.end(), [&](const SceneVector& vector) {
            const Spot tail = spot(figure, vector.tail), tip = spot(figure, vector.tip);
            const auto joins = [&](Spot from, Spot to) {
                return length(line.front() - from) < coincident && length(line.back() - to) < coincident;
            };
            return joins(tail, tip) || joins(tip, tail);
        });
    }

    /// Whether the statement names the line, and so its number.
    bool is_said(StatementIndex statement, const LineReason& reason) const {
        const Protocol& protocol = context_.solution.protocol;
        if (statement == none) return false;
        const std::vector<Argument>& said = protocol.statements[at_index(statement)].message.arguments;
        return std::any_of(said.begin(), said.end(), [&](const Argument& each) {
            const auto* line = std::get_if<LineReason>(&each);
            return line != nullptr && *line == reason;
        });
    }
    bool is_in_short(const Figure& figure) const {
        return has_steps_ && scene_.longest < hardly_measured * figure.scale;
    }

    struct Ray {
        Spot meet, along;
        double past;
    };
    void add_lines(PolygonParts& parts, const Figure& figure) const {
        const std::size_t first = parts.lines.size();
        std::vector<const LineReason*> reasons;
        std::vector<Ray> rays;
        const auto said = [&](const LineReason& reason) { return plain(typeset(reason, context_.language)); };
        for (const SceneLine& each : scene_.lines) {
            Spot along{each.along.x, -each.along.y};
            const Spot support = spot(figure, each.support), meet = spot(figure, each.meet);
            const double reach = dot(meet - support, along);
            if (reach < 0) along = -1.0 * along;
            PolygonLine drawn;
            const std::string number = numbers_.of(each.statement, each.reason);
            const bool has_number_alone =
                is_in_short(figure) && !number.empty() && is_said(each.statement, each.reason);
            const double past = has_number_alone ? past_with_number : past_the_meet;
            drawn.from = support - short_of_pole * along;
            drawn.to = meet + past * along;
            if (std::abs(reach) < coincident) drawn.from = support - past * along;
            bool twice = false;
            for (std::size_t i = 0; i < reasons.size(); ++i)
                twice = twice || (length(parts.lines[first + i].to - drawn.to) < coincident &&
                                  said(*reasons[i]) == said(each.reason));
            if (twice) continue;
            reasons.push_back(&each.reason);
            drawn.pen = {context_.theme.thin, context_.theme.secondary, {}, false};
            drawn.statement = each.statement;
            if (each.reason.kind != LineReason::Kind::known) {
                if (!number.empty())
                    drawn.mark = one_piece(has_number_alone ? number : numbers_.before(each.statement, each.reason));
                if (!has_number_alone) append(drawn.mark, typeset(each.reason, context_.language));
                drawn.mark_at = meet + (0.58 * past) * along;
                drawn.mark_toward = meet + past * along;
                drawn.mark_along = !has_number_alone;
            }
            add_corner(parts, each.statement, support, along, std::abs(reach));
            parts.lines.push_back(std::move(drawn));
            rays.push_back({meet, along, past});
        }
        run_on_until_apart(parts, first, rays);
    }
    /// Lines that meet at a small angle are extended until they are visibly apart.
    static void run_on_until_apart(PolygonParts& parts, std::size_t first, const std::vector<Ray>& rays) {
        for (std::size_t i = 0; i < rays.size(); ++i)
            for (const Ray& other : rays) {
                const double sine = std::abs(cross(rays[i].along, other.along));
                if (length(rays[i].meet - other.meet) > coincident || rays[i].past * sine > seen_apart || sine < 1e-9)
                    continue;
                parts.lines[first + i].to = rays[i].meet + std::min(seen_apart / sine, most_overshoot) * rays[i].along;
            }
    }

    /// Adds a right angle if a line is ⟂ to a known vector through its tip, such as a^t to a^n, or through its tail,
    /// such as a^rel to a Coriolis term that is drawn last.
    static void add_corner(PolygonParts& parts, StatementIndex statement, Spot support, Spot along, double reach) {
        for (const PolygonVector& vector : parts.vectors) {
            if (!vector.has_right_angles) continue;
            const bool at_tip = length(vector.tip - support) < coincident;
            if (!at_tip && length(vector.tail - support) >= coincident) continue;
            const Spot leg = at_tip ? vector.tail - vector.tip : vector.tip - vector.tail;
            if (std::abs(dot(unit(leg), along)) > 1e-9) continue;
            parts.corners.push_back({support, unit(leg), along, std::min(length(leg), reach), statement});
            return;
        }
    }

    /// Trial assumptions of the construction are very thin, dashed and grey; vertices that a sentence names have the
    /// number of the trial.
    void add_trials(PolygonParts& parts, const Figure& figure) const {
        const std::size_t first = parts.lines.size();
        for (const SceneTrial& each : scene_.trials) {
            const Spot start = spot(figure, each.from), end = spot(figure, each.to);
            PolygonLine drawn = trial_line(start, end, each.is_line ? trial_overshoot : 0, each.statement);
            // Where both trials come out alike, their strokes would be one doubled dashed line.
            const bool is_double =
                std::any_of(parts.lines.begin() + static_cast<std::ptrdiff_t>(first), parts.lines.end(),
                            [&](const PolygonLine& other) {
                                return length(other.from - drawn.from) < alike && length(other.to - drawn.to) < alike;
                            });
            if (!is_double) parts.lines.push_back(std::move(drawn));
        }
        for (const SceneMiss& each : scene_.misses) add_miss(parts, figure, each);
    }
    static constexpr double alike = 0.6, lighter = 0.75;  // mm; … than lines of the construction
    PolygonLine trial_line(Spot from, Spot to, double beyond, StatementIndex statement) const {
        PolygonLine drawn;
        drawn.from = from;
        drawn.to = length(to - from) > coincident ? to + beyond * unit(to - from) : to;
        drawn.pen = {lighter * context_.theme.thin, context_.theme.secondary, dashes(), false};
        drawn.statement = statement;
        return drawn;
    }
    /// The line that a trial misses, dashed, and the distance, solid.
    void add_miss(PolygonParts& parts, const Figure& figure, const SceneMiss& miss) const {
        const Spot through = spot(figure, miss.through), foot = spot(figure, miss.foot), tip = spot(figure, miss.tip);
        if (length(tip - foot) < coincident) return;
        parts.lines.push_back(trial_line(through, foot, trial_overshoot, miss.statement));
        PolygonLine error;
        error.from = foot;
        error.to = tip;
        error.pen = {context_.theme.thin, context_.theme.text, {}, false};
        error.mark = typeset(miss.symbol, context_.language);
        error.mark_at = 0.5 * (foot + tip);
        error.mark_toward = tip;
        error.mark_along = false;
        error.statement = miss.statement;
        parts.lines.push_back(std::move(error));
    }

    void add_vectors(PolygonParts& parts, const Figure& figure) const {
        for (const SceneVector& each : scene_.vectors) {
            PolygonVector drawn;
            drawn.tail = spot(figure, each.tail);
            drawn.tip = spot(figure, each.tip);
            drawn.value = each.value;
            drawn.name = each.name;
            drawn.text = typeset(each.symbol, context_.language);
            drawn.colour = context_.theme.colour_of(each.body);
            drawn.has_right_angles = each.has_right_angles;
            drawn.statement = each.statement;
            parts.vectors.push_back(std::move(drawn));
        }
    }

    void add_images(PolygonParts& parts, const Figure& figure) const {
        for (const SceneImage& each : scene_.images) {
            PolygonImage drawn;
            drawn.kind = each.kind;
            drawn.at = spot(figure, each.at);
            if (each.is_named) drawn.text = typeset(each.symbol, context_.language);
            if (each.kind != SceneImage::Kind::trial)
                drawn.name = name_of(each.symbol);
            else if (!drawn.text.empty())
                drawn.text.back().sup += each.trial == 1 ? "I" : "II";
            drawn.statement = each.statement;
            parts.images.push_back(std::move(drawn));
        }
    }

    const DrawingContext& context_;
    const PolygonScene& scene_;
    LineNumbers numbers_;
    bool has_steps_;
};

// If a room is too small for labels, the last trial is the smallest figure that still shows something: at least this
// size (mm), and at most `most_steps` steps coarser than the scale at which the strokes have room, because letters do
// not shrink.
constexpr double least_polygon = 12;
constexpr int most_steps = 2;
// If names need more than this fraction of the room, they hardly ever find positions: the room is refused if that is
// allowed.
constexpr double crowded = 0.25;
// … and above this fraction only the smallest figure is drawn, with any positions of the names.
constexpr double hopeless = 0.4;
// With more names there is no space for details.
constexpr std::size_t most_names_with_details = 48;
// mm; a polygon is not made smaller than this for the sake of details.
constexpr double least_with_details = 60;

/// Fits the drawing into a room, with labels, and with details if they have positions.
class Fitting {
public:
    Fitting(const PolygonDrawing& drawing, const DrawingContext& context, Spot room, const ScaleWish& wish)
        : drawing_(drawing), context_(context), room_(room), wish_(wish) {}

    Figure fitted() const {
        if (drawing_.empty()) {
            Figure figure = drawing_.at(1);
            finish(figure, true);
            return figure;
        }
        const FitPolicy policy{.room = room_,
                               .first = first(),
                               .asked = wish_.asked,
                               .exactly = wish_.exactly,
                               .extent = extent(),
                               .least_shown = std::max(least_polygon, smallest_readable_lettering())};
        const double names = room_of_names(strokes_at(policy.first), context_.fonts) / (room_.x * room_.y);
        const bool may_have_details =
            names <= crowded && strokes_at(policy.first).labels.size() <= most_names_with_details;
        return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
            if (trial.asked) return as_asked(trial.scale);
            if (names > hopeless) return trial.last ? std::optional(as_it_comes(trial.scale)) : std::nullopt;
            return tried(trial, may_have_details);
        });
    }

private:
    /// The drawing at a scale before labels are placed, with an open group.
    struct Strokes {
        Figure empty;
        PolygonParts parts;
        Figure figure;
    };
    struct Attempt {
        const Strokes& strokes;
        std::size_t letters = 0;
        std::vector<Detail> details{};
    };
    Attempt attempt(double scale) const {
        Attempt made{strokes(scale)};
        made.details = details_of(made.strokes.parts, scale, 1, made.letters);
        return made;
    }
    /// Cached, because the size of strokes, the size of names and the labelling all use it.
    const Strokes& strokes(double scale) const {
        const auto [found, fresh] = strokes_.try_emplace(scale);
        Strokes& made = found->second;
        if (fresh) {
            made.empty = drawing_.empty_at(scale);
            made.parts = drawing_.parts_of(made.empty);
            made.figure = drawing_.with_parts(made.empty, made.parts, {});
        }
        return made;
    }
    const Figure& strokes_at(double scale) const { return strokes(scale).figure; }
    double first() const { return first_scale({drawing_.width(), drawing_.height()}, room_, wish_.finest); }
    double extent() const { return std::max(drawing_.width(), drawing_.height()); }
    /// The size at `most_steps` steps beyond the scale at which the strokes have room, mm.
    double smallest_readable_lettering() const {
        double scale = first();
        while (extent() / scale > least_polygon && !fits(strokes_at(scale), letters_beyond)) scale = next_scale(scale);
        for (int step = 0; step < most_steps; ++step) scale = next_scale(scale);
        constexpr double a_little_less = 0.999;
        return a_little_less * extent() / scale;
    }
    /// `reach`: added on each side.
    bool fits(const Figure& figure, double reach = 0) const {
        return figure.box.width() + 2 * reach <= room_.x && figure.box.height() + 2 * reach <= room_.y;
    }
    /// Places the labels and closes the group. False if they have no positions.
    bool finish(Figure& figure, bool whatever_it_takes) const {
        const Labelling labelling = whatever_it_takes ? Labelling::free : Labelling::if_it_fits;
        if (!place_labels(figure, context_.fonts, room_, labelling, context_.theme.secondary)) return false;
        figure.marks.emplace_back(GroupEnd{});
        return true;
    }
    /// With details. Empty if it needs none, or if they or the labels have no positions.
    std::optional<Figure> detailed(const Attempt& made) const {
        if (made.details.empty()) return std::nullopt;
        const PolygonParts& parts = made.strokes.parts;
        Figure figure = drawing_.with_parts(made.strokes.empty, parts, made.details);
        // Placing labels is the slowest part.
        if (!may_hold_details(figure, context_, made.details, room_)) return std::nullopt;
        if (!place_labels(figure, context_.fonts, room_, Labelling::if_all_free, context_.theme.secondary) ||
            !fits(figure))
            return std::nullopt;
        figure.marks.emplace_back(GroupEnd{});
        std::size_t letters = made.letters;
        if (!set_details(figure, context_, parts, made.details, room_, letters) || !fits(figure)) return std::nullopt;
        return figure;
    }
    std::optional<Figure> as_asked(double scale) const {
        const Attempt made = attempt(scale);
        if (auto with_details = detailed(made)) return with_details;
        Figure figure = made.strokes.figure;
        if (!fits(figure) || !finish(figure, false)) return std::nullopt;
        return figure;
    }
    Figure as_it_comes(double scale) const {
        const Attempt made = attempt(scale);
        Figure figure = made.strokes.figure;
        finish(figure, true);
        figure.lacks_details = !made.details.empty();
        return figure;
    }
    /// `may_have_details`: false if there are too many names beside them.
    std::optional<Figure> tried(const Trial& trial, bool may_have_details) const {
        if (!trial.last && !fits(strokes_at(trial.scale), letters_beyond)) return std::nullopt;
        const Attempt made = attempt(trial.scale);
        if (may_have_details)
            if (auto with_details = detailed(made)) return with_details;
        Figure figure = made.strokes.figure;
        if (!finish(figure, trial.last) || (!trial.last && !fits(figure))) return std::nullopt;
        figure.lacks_details = !made.details.empty();
        if (!figure.lacks_details || !may_have_details) return figure;
        // One step coarser with details is better than without.
        const double smaller = next_scale(trial.scale);
        if (!(wish_.finest > 0) && extent() / smaller > least_with_details)
            if (auto with_details = detailed(attempt(smaller))) return with_details;
        return figure;
    }

    const PolygonDrawing& drawing_;
    const DrawingContext& context_;
    Spot room_;
    ScaleWish wish_;
    mutable std::map<double, Strokes> strokes_;  // by scale
};

}  // namespace

Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y, const ScaleWish& wish) {
    return polygon_figure(context, polygon_scene(context.solution, polygon), room_x, room_y, wish);
}

Figure polygon_figure(const DrawingContext& context, const PolygonScene& scene, double room_x, double room_y,
                      const ScaleWish& wish) {
    return Fitting(PolygonDrawing(context, scene, wish.has_steps), context, {room_x, room_y}, wish).fitted();
}

namespace {

template <Plane plane>
std::vector<int> polygons_in(const Shown& shown, const LoadCase& /*all*/) {
    const std::vector<Polygon>& polygons = shown.solution().protocol.polygons;
    std::vector<int> found;
    for (std::size_t i = 0; i < polygons.size(); ++i)
        if (polygons[i].plane == plane) found.push_back(static_cast<int>(i));
    return found;
}
void measure_polygon(const Shown& shown, FigureId id, SizeWanted& size) {
    const PolygonScene& scene = shown.scene(id.of);
    size.extent_x = scene.width();
    size.extent_y = scene.height();
    size.subject = scene.longest;
    // In a knot the leaders of names cross one another.
    constexpr double most_of_them = 64;  // mm; more would cost a page
    if (const double apart = apart_of_knot(scene.vectors.size()); apart > 0)
        size.least = std::max(size.least, std::min(apart, most_of_them));
    // A reading of half a tenth of a millimetre is within a fifth of a percent of the longest.
    constexpr double least_of_longest = 26;  // mm
    if (scene.longest > 0) size.least = std::max(size.least, least_of_longest * scene.size() / scene.longest);
    size.empty = scene.empty();
    size.has_corner = !size.empty;
    constexpr double enough_of_lengths =
        80;  // mm; a hundredth is read off it, and it leaves the room to what has angles
    size.is_straight = scene.is_straight();
    if (size.is_straight) size.enough = std::min(size.enough, enough_of_lengths);
}
Figure draw_polygon(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    ScaleWish own = wish;
    own.has_steps = wish.has_steps && !shown.is_brief;
    return polygon_figure(shown.context, shown.scene(id.of), room.x, room.y, own);
}

}  // namespace

constinit const FigureFunctions velocity_polygon_functions{polygons_in<Plane::velocity>, measure_polygon, draw_polygon};
constinit const FigureFunctions acceleration_polygon_functions{polygons_in<Plane::acceleration>, measure_polygon,
                                                               draw_polygon};

}  // namespace kinegraph::render
