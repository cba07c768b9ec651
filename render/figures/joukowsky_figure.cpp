// Joukowsky's lever: the velocities of the points of application turned by a quarter turn, the forces at their tips,
// the arms from the pole. Forces, velocities and powers come from the Solution.
//
// Method: z∧v is v turned counter-clockwise, so that the moment of F at the tip of z∧v about the pole is −F·v. The
// powers of all external forces on a mechanism with ideal pairs have the sum zero, and therefore the moments, too (N.
// E. Joukowsky, the lever).
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/number/assert.hpp"
#include "engine/solution/bindings.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/drawn_by.hpp"

namespace kinegraph::render {
namespace {

constexpr double longest_force = 25;   // mm
constexpr double least_velocity = 12;  // mm; of the longest velocity
constexpr double label_rim = 3;        // initial estimate of the space for labels beyond the strokes, on each side
constexpr double past_the_foot = 5;    // of a line of action beyond the foot of the arm
constexpr double least_arm = 0.2;      // mm; a shorter arm coincides with the pole
constexpr double corner_size = 1.7;    // of the mark of a right angle

const VirtualWork& work_of(const Solution& solution) {
    KG_ASSERT(solution.virtual_work, "the lever wants the powers");
    return *solution.virtual_work;
}

/// A force at the tip of its turned velocity; y downwards, in the units of the file.
struct Placed {
    const VirtualWork::Entry* entry;
    Spot turned_velocity, force;
    double value;
    StatementIndex statement;  // from which the force is known; none: it is given
    StatementIndex motion;     // that draws the velocity of its point of application
};

using Form = Holds::Form;

class Lever {
public:
    explicit Lever(const DrawingContext& context)
        : context_(context),
          velocity_(context.solution.mechanism.units.velocity),
          force_(context.solution.mechanism.units.force) {
        double most = 0;
        for (const VirtualWork::Entry& entry : work_of(context.solution).entries) {
            if (entry.force.is_zero()) continue;
            const Spot v = in(entry.velocity, velocity_), f = in(entry.force, force_);
            placed_.push_back({&entry,
                               {v.y, -v.x},
                               f,
                               kinegraph::length(entry.force) / force_.si.to_double(),
                               statement_of_force(context.solution, entry.quantity),
                               statement_of_velocity(entry)});
            most = std::max(most, placed_.back().value);
        }
        force_scale_ = choose_scale(most, 0, longest_force, 1, std::nullopt);
        for (const Placed& each : placed_) {
            min_ = {std::min(min_.x, each.turned_velocity.x), std::min(min_.y, each.turned_velocity.y)};
            max_ = {std::max(max_.x, each.turned_velocity.x), std::max(max_.y, each.turned_velocity.y)};
        }
    }
    double width() const { return max_.x - min_.x; }
    double height() const { return max_.y - min_.y; }

    Figure at(double scale) const {
        Figure figure = begun(context_, {FigureKind::lever});
        figure.further_scale = "1 mm ≙ " + shortest(force_scale_, context_.language) + " " + force_.symbol;
        figure.scale = scale;
        figure.unit = velocity_.symbol;
        GroupBegin group = group_of(figure);
        group.title += ", " + figure.further_scale;
        figure.marks.emplace_back(std::move(group));
        const std::vector<Arrow> arrows = arrows_at(scale);
        draw_rays(figure);
        draw_arms(figure, arrows);
        draw_forces(figure, arrows);
        figure.marks.emplace_back(
            ring({0, 0}, pole_radius, context_.theme.paper, {context_.theme.outline, context_.theme.text, {}, false}));
        hang(figure.marks, figure.marks.size() - 1, {Form::at, {pole_binding()}});
        label_tips(figure);
        figure.box = box_of(figure.marks);
        draw_bars(figure);
        return figure;
    }

private:
    struct Arrow {
        Spot tail, tip;
    };

    /// The named point of application of a force; none if it has no name.
    PointIndex point_of(const VirtualWork::Entry& entry) const {
        for (const PointIndex p : context_.solution.mechanism.bodies[at_index(entry.body)].points)
            if ((context_.solution.pose.at(p) - entry.at).is_zero()) return p;
        return none;
    }
    StatementIndex statement_of_velocity(const VirtualWork::Entry& entry) const {
        const PointIndex point = point_of(entry);
        return point == none ? none
                             : statement_of_motion(context_.solution, Quantity::Kind::velocity, entry.body, point);
    }

    static Spot in(const Vector& v, const Unit& unit) {
        return {(v.x / unit.si).to_double(), -(v.y / unit.si).to_double()};
    }
    static Spot tip_of(const Placed& each, double scale) { return (1 / scale) * each.turned_velocity; }

    /// Each arrow begins or ends at its point, or is moved along its line past others there.
    std::vector<Arrow> arrows_at(double scale) const {
        std::vector<Arrow> arrows;
        for (const Placed& each : placed_) {
            const Spot at = tip_of(each, scale), whole = (1 / force_scale_) * each.force;
            Arrow best{at, at + whole};
            double least = 1e300;
            for (int k = 0; k < 6; ++k) {
                // 0: pulls; 1: pushes; then at increasing distances.
                const int steps_off = k / 2;
                const double gap = 2.5 * steps_off;
                const Spot along = unit(whole);
                const Spot tail = k % 2 == 0 ? at + gap * along : at - gap * along - whole;
                const Arrow tried{tail, tail + whole};
                double price = 0.3 * k;
                for (const Arrow& other : arrows) price += 8 * shared(tried, other);
                for (const Placed& other : placed_) price += 3 * shared(tried, {{0, 0}, tip_of(other, scale)});
                if (price < least - 1e-9) least = price, best = tried;
            }
            arrows.push_back(best);
        }
        return arrows;
    }
    /// The fraction of an arrow that nearly coincides with another stroke.
    static double shared(const Arrow& arrow, const Arrow& other) {
        constexpr int pieces = 16;
        const Spot way = other.tip - other.tail;
        const double square = dot(way, way);
        int met = 0;
        for (int i = 0; i <= pieces; ++i) {
            const Spot at = arrow.tail + (static_cast<double>(i) / pieces) * (arrow.tip - arrow.tail);
            const double t = square > 0 ? std::clamp(dot(at - other.tail, way) / square, 0.0, 1.0) : 0;
            if (length(at - other.tail - t * way) < 1.4) ++met;
        }
        return static_cast<double>(met) / (pieces + 1);
    }

    void draw_arms(Figure& figure, const std::vector<Arrow>& arrows) const {
        const Theme& theme = context_.theme;
        const Pen action{theme.thin, theme.secondary, dash_dot(), false},
            arm{theme.outline, theme.text, dashes(), false}, corner{theme.thin, theme.text, {}, false};
        std::vector<std::pair<Spot, Spot>> done;  // foot and direction
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const Spot along = unit(placed_[i].force), tail = arrows[i].tail, tip = arrows[i].tip;
            const Spot foot = tail - dot(tail, along) * along;
            // The line of action to the foot of the arm, and the point of the force on it.
            const Spot at = tip_of(placed_[i], figure.scale);
            const double from = dot(tail, along), to = dot(tip, along), place = dot(at, along);
            const double low = std::min({0.0, place, from}), high = std::max({0.0, place, to});
            const auto on_line = [&](double t) { return foot + t * along; };
            const std::string force = work_binding(*placed_[i].entry), held = foot_binding(*placed_[i].entry);
            const std::size_t first = figure.marks.size();
            if (low < from)
                figure.marks.emplace_back(line(on_line(low - (low == 0 ? past_the_foot : 0)), on_line(from), action));
            if (high > to)
                figure.marks.emplace_back(line(on_line(to), on_line(high + (high == 0 ? past_the_foot : 0)), action));
            hang(figure.marks, first, {Form::line, {force, "", held}, past_the_foot});
            if (length(foot) < least_arm) continue;
            if (std::any_of(done.begin(), done.end(),
                            [&](const auto& other) { return length(other.first - foot) < coincident; }))
                continue;
            done.emplace_back(foot, along);
            figure.marks.emplace_back(line({0, 0}, foot, arm));
            hang(figure.marks, figure.marks.size() - 1, {Form::segment, {pole_binding(), held}});
            if (length(foot) < 1.6 * corner_size) continue;
            // In the corner away from the arrow, if possible.
            const Spot back = -corner_size * unit(foot),
                       aside = (0.5 * (from + to) > 0 ? -corner_size : corner_size) * along;
            figure.marks.emplace_back(polyline({foot + back, foot + back + aside, foot + aside}, corner));
            hang(figure.marks, figure.marks.size() - 1, {Form::with, {held, pole_binding(), held}});
        }
    }

    void draw_rays(Figure& figure) const {
        const Pen pen{context_.theme.thin, context_.theme.secondary, {}, false};
        std::vector<Spot> done;
        std::vector<std::string> tips;
        for (const Placed& each : placed_) {
            const Spot tip = tip_of(each, figure.scale);
            if (length(tip) < coincident) continue;
            if (std::any_of(done.begin(), done.end(), [&](Spot other) { return length(other - tip) < coincident; }))
                continue;
            done.push_back(tip);
            tips.push_back(work_binding(*each.entry));
            figure.marks.emplace_back(
                GroupBegin{"ray", {}, "", {}, each.motion, {Form::segment, {pole_binding(), tips.back()}}});
            figure.marks.emplace_back(Axis{{0, 0}, tip});
            figure.marks.emplace_back(line({0, 0}, tip, pen));
            figure.marks.emplace_back(GroupEnd{});
        }
        for (std::size_t i = 0; i < done.size(); ++i) {
            figure.marks.emplace_back(disc(done[i], 0.6, context_.theme.text));
            hang(figure.marks, figure.marks.size() - 1, {Form::at, {tips[i]}});
        }
    }

    void draw_forces(Figure& figure, const std::vector<Arrow>& arrows) const {
        std::set<std::string> names;
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            const VirtualWork::Entry& entry = *placed_[i].entry;
            const std::string base = name_of(entry.symbol);
            std::string name = base;
            for (int n = 2; !names.insert(name).second; ++n) name = base + "-" + std::to_string(n);
            const BodyColour colour = context_.theme.colour_of(entry.body);
            const Holds holds{Form::arrow, {work_binding(entry), work_binding(entry)}};
            figure.marks.emplace_back(GroupBegin{"force",
                                                 id_in(figure, legal_id(name)),
                                                 name + " = " + shortest(placed_[i].value) + " " + force_.symbol,
                                                 {{"data-name", name},
                                                  {"data-value", shortest(placed_[i].value)},
                                                  {"data-scale", shortest(force_scale_)},
                                                  {"data-unit", force_.symbol}},
                                                 placed_[i].statement,
                                                 holds});
            figure.marks.emplace_back(Axis{arrows[i].tail, arrows[i].tip});
            draw_arrow(figure.marks, arrows[i].tail, arrows[i].tip, context_.theme.vector, colour.line);
            figure.marks.emplace_back(GroupEnd{});
            LabelRequest label;
            label.text = typeset(entry.symbol, context_.language);
            label.size = context_.theme.equation;
            label.colour = colour.letter;
            label.anchor = 0.5 * (arrows[i].tail + arrows[i].tip);
            label.toward = arrows[i].tip;
            label.clearance = 1.5;
            label.statement = placed_[i].statement;
            label.holds = holds;
            figure.labels.push_back(std::move(label));
        }
    }

    /// The images of the points of application with their names; the pole first.
    void label_tips(Figure& figure) const {
        struct Cluster {
            Spot at;
            RichText text;
            std::set<std::string> names;
            std::string place;  // binding
        };
        const Symbol pole{Symbol::Letter::pole, "v", ""};
        std::vector<Cluster> clusters{{{0, 0}, typeset(pole, context_.language), {name_of(pole)}, pole_binding()}};
        for (const Placed& each : placed_) {
            const PointIndex point = point_of(*each.entry);
            if (point == none) continue;
            const Symbol image{Symbol::Letter::image, context_.solution.mechanism.points[at_index(point)].name, ""};
            const Spot at = tip_of(each, figure.scale);
            const auto same = std::find_if(clusters.begin(), clusters.end(),
                                           [&](const Cluster& c) { return length(c.at - at) < coincident; });
            const RichText text = typeset(image, context_.language);
            if (same == clusters.end()) {
                clusters.push_back({at, text, {name_of(image)}, work_binding(*each.entry)});
            } else if (same->names.insert(name_of(image)).second) {
                append(same->text, one_piece(" ≡ "));
                append(same->text, text);
            }
        }
        for (Cluster& cluster : clusters) {
            LabelRequest label;
            label.text = std::move(cluster.text);
            label.size = context_.theme.label;
            label.colour = context_.theme.text;
            label.anchor = cluster.at;
            label.clearance = 2.0;
            label.holds = {Form::at, {cluster.place}};
            figure.labels.push_back(std::move(label));
        }
    }

    /// Both scale bars side by side below the figure.
    void draw_bars(Figure& figure) const {
        const Language language = context_.language;
        std::vector<Mark> bars, second;
        draw_scale_bar(bars, context_.fonts, context_.theme, {0, 0}, 22, figure.scale, 1, velocity_.symbol, language);
        draw_scale_bar(second, context_.fonts, context_.theme, {0, 0}, 22, force_scale_, 1, force_.symbol, language);
        render::move(second, box_of(bars).max.x + 8 - box_of(second).min.x, 0);
        bars.insert(bars.end(), second.begin(), second.end());
        const Box size = box_of(bars);
        const double middle = 0.5 * (figure.box.min.x + figure.box.max.x);
        render::move(bars, middle - 0.5 * (size.min.x + size.max.x), figure.box.max.y + 6 - size.min.y);
        figure.marks.insert(figure.marks.end(), bars.begin(), bars.end());
        figure.box = box_of(figure.marks);
    }

    const DrawingContext& context_;
    const Unit &velocity_, &force_;
    std::vector<Placed> placed_;
    double force_scale_ = 1;
    Spot min_, max_;  // of the turned velocities, relative to the pole
};

}  // namespace

NoLever no_lever(const Solution& solution) {
    if (solution.free_bodies.empty()) return NoLever::no_forces;
    if (!solution.virtual_work) return NoLever::no_velocities;
    const auto& entries = solution.virtual_work->entries;
    const bool any = std::any_of(entries.begin(), entries.end(), [](const VirtualWork::Entry& entry) {
        return !entry.force.is_zero() && !entry.velocity.is_zero();
    });
    return any ? NoLever::drawn : NoLever::nothing_moves;
}

Figure joukowsky_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    KG_ASSERT(no_lever(context.solution) == NoLever::drawn, "a lever needs a force that moves");
    const Lever lever(context);
    const Spot room{room_x, room_y};
    const FitPolicy policy{.room = room,
                           .first = first_scale({lever.width(), lever.height()}, room, wish.finest),
                           .exactly = wish.exactly,
                           .extent = std::max(lever.width(), lever.height()),
                           .least_shown = least_velocity};
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
        Figure figure = lever.at(trial.scale);
        const bool has_room =
            figure.box.width() + 2 * label_rim <= room_x && figure.box.height() + 2 * label_rim <= room_y;
        if (!trial.last && !has_room) return std::nullopt;
        if (!place_labels(figure, context.fonts, room, trial.last ? Labelling::free : Labelling::if_it_fits,
                          context.theme.secondary))
            return std::nullopt;
        figure.marks.emplace_back(GroupEnd{});
        return figure;
    });
}

namespace {

/// Whether an input force or couple was found by virtual work, for which the lever is the construction.
bool found_by_works(const Solution& solution) {
    return std::any_of(
        solution.virtual_motions.begin(), solution.virtual_motions.end(), [&](const VirtualMotion& motion) {
            const Statement& said = solution.protocol.statements[at_index(motion.statement)];
            return (said.message.sentence == lang::sentences::virtual_work_alone ||
                    said.message.sentence == lang::sentences::virtual_work_gives) &&
                   std::any_of(said.finds.begin(), said.finds.end(),
                               [](const Quantity& found) { return found.kind == Quantity::Kind::effort; });
        });
}
std::vector<int> has_lever(const Shown& shown, const LoadCase& /*all*/) {
    return once((shown.has_lever || found_by_works(shown.solution())) && no_lever(shown.solution()) == NoLever::drawn);
}
/// The turned velocities with the pole, in the unit of velocity of the file.
void measure_lever(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    const Lever lever(shown.context);
    size.extent_x = lever.width();
    size.extent_y = lever.height();
}
Figure draw_lever(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return joukowsky_figure(shown.context, room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions lever_functions{has_lever, measure_lever, draw_lever};

}  // namespace kinegraph::render
