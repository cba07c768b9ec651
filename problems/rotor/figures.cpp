#include "problems/rotor/rotor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lang/keys/rotor.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/problem_figure.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

/// Common parts of all figures of a rotor.
class RotorPen {
public:
    RotorPen(const DrawingContext& context, Spot room)
        : context_(context),
          theme_(context.theme),
          problem_(problem_of<RotorProblem>(context)),
          found_(solution_of<RotorSolution>(context)),
          units_(context.solution.mechanism.units),
          room_(room) {}

protected:
    const BodyColour& colour(std::size_t mass) const { return theme_.body(BodyIndex(mass + 1)); }
    Pen thin(const std::vector<double>& kind = {}) const { return {theme_.thin, theme_.secondary, kind, false}; }
    void add(Path path) { figure_.marks.emplace_back(std::move(path)); }
    void name(RichText text, Spot at, Colour ink, std::optional<Spot> toward = std::nullopt, double clearance = 1.6) {
        figure_.labels.push_back({.text = std::move(text),
                                  .size = theme_.label,
                                  .colour = ink,
                                  .anchor = at,
                                  .toward = toward,
                                  .clearance = clearance});
    }
    static std::string braced(const std::string& letter, const std::string& index) {
        return "{" + letter + "_" + index + "}";
    }
    /// A mass on paper: a disc, so large that it is seen.
    void draw_mass(Spot at, Colour tint, Colour edge) {
        constexpr double radius = 1.7;  // mm
        add(ring(at, radius, tint, {theme_.outline, edge, {}, false}));
    }
    /// Radius of a correction, where it has one; found or given.
    std::optional<double> radius_of(std::size_t correction) const {
        const RotorCorrection& given = problem_.corrections[correction];
        if (given.radius) return given.radius->to_double();
        return found_.corrections[correction].radius;
    }
    bool shows(std::size_t correction, RotorShown shown) const {
        return shown == RotorShown::found && !found_.corrections[correction].vanishes;
    }
    /// Unit vector of a correction.
    VectorOf<double> way_of(std::size_t correction) const {
        return unit_vector(to_double(found_.balance.closing[correction]));
    }
    double largest_radius(RotorShown shown) const {
        double largest = 0;
        for (const RotorMass& each : problem_.masses) largest = std::max(largest, each.radius.to_double());
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i)
            if (shows(i, shown)) largest = std::max(largest, radius_of(i).value_or(0));
        return largest;
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const RotorProblem& problem_;
    const RotorSolution& found_;
    const Units& units_;
    Spot room_;
    Figure figure_;
};

class EndView : RotorPen {
public:
    EndView(const DrawingContext& context, RotorShown shown, Spot room) : RotorPen(context, room), shown_(shown) {}

    Figure draw() {
        const Box extent = extent_of_masses();
        constexpr double beside = 30, above = 18;  // mm, of axes and names
        scale_ = choose_scale(extent.width(), extent.height(), std::max(room_.x - beside, 20.0),
                              std::max(room_.y - above, 20.0), std::nullopt);
        figure_ = begun("rotor", "end-view",
                        shown_ == RotorShown::given || found_.is_balanced_already()
                            ? Words(lang::rotor::end_view)
                            : Words(lang::rotor::end_view_with_corrections),
                        scale_, "m", context_.language);
        draw_axes({(1 / scale_) * extent.min, (1 / scale_) * extent.max});
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i)
            if (shows(i, shown_)) draw_correction(i);
        for (std::size_t i = 0; i < problem_.masses.size(); ++i) draw_rotating(i);
        constexpr double hub = 1.2;  // mm
        add(ring({0, 0}, hub, theme_.paper, {2 * theme_.outline, theme_.text, {}, false}));
        return finished(std::move(figure_), context_, room_);
    }

private:
    Box extent_of_masses() const {
        Box extent;
        for (std::size_t i = 0; i < problem_.masses.size(); ++i) extent.include(place_of_mass(i, 1));
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i)
            if (shows(i, shown_)) extent.include(place_of_correction(i, 1));
        return extent;
    }
    Spot place_of_mass(std::size_t i, double scale) const {
        return spot_of(problem_.masses[i].radius * found_.unbalances[i].direction, scale);
    }
    /// Without a radius it is drawn as far out as the masses.
    Spot place_of_correction(std::size_t i, double scale) const {
        return spot_of(radius_of(i).value_or(largest_radius(RotorShown::given)) * way_of(i), scale);
    }
    void draw_axes(const Box& box) {
        constexpr double beyond = 4, head = 4;  // mm
        const double right = std::max(box.max.x, 0.0) + beyond, up = std::min(box.min.y, 0.0) - beyond;
        add(line({std::min(box.min.x, 0.0) - beyond, 0}, {right, 0}, thin(dash_dot())));
        add(line({0, std::max(box.max.y, 0.0) + beyond}, {0, up}, thin(dash_dot())));
        draw_arrow(figure_.marks, {right, 0}, {right + head, 0}, theme_.thin, theme_.secondary);
        draw_arrow(figure_.marks, {0, up}, {0, up - head}, theme_.thin, theme_.secondary);
        name(formula("{x}"), {right + head, 0}, theme_.secondary);
        name(formula("{y}"), {0, up - head}, theme_.secondary);
    }
    void draw_rotating(std::size_t i) {
        const RotorMass& mass = problem_.masses[i];
        const Spot at = place_of_mass(i, scale_);
        const BodyColour& ink = colour(i);
        add(line({0, 0}, at, {theme_.outline, ink.line, {}, false}));
        draw_mass(at, ink.tint, ink.line);
        name(formula(braced("m", mass.name)), at, ink.letter, std::nullopt, 2.4);
    }
    void draw_correction(std::size_t i) {
        const RotorCorrection& given = problem_.corrections[i];
        const std::string letter = problem_.name_of(given);
        const Spot at = place_of_correction(i, scale_);
        const Pen pen{theme_.outline, theme_.text, dashes(), false};
        if (radius_of(i)) {
            add(line({0, 0}, at, pen));
            draw_mass(at, theme_.text, theme_.text);
            name(formula(braced("m", letter)), at, theme_.text, std::nullopt, 2.4);
        } else {
            draw_arrow(figure_.marks, {0, 0}, at, theme_.outline, theme_.text, dashes());
            name(vector_formula(braced("U", letter)), at, theme_.text);
        }
    }

    RotorShown shown_;
    double scale_ = 1;
};

/// z to the right; y upwards.
class SideView : RotorPen {
public:
    SideView(const DrawingContext& context, RotorShown shown, Spot room) : RotorPen(context, room), shown_(shown) {
        least_ = most_ = problem_.planes.front().z;
        for (const RotorPlane& each : problem_.planes) {
            least_ = std::min(least_, each.z);
            most_ = std::max(most_, each.z);
        }
    }

    Figure draw() {
        const double long_way = (most_ - least_).to_double(), largest = largest_radius(shown_);
        constexpr double beside = 22, above = 14;  // mm, of names
        if (shown_ == RotorShown::found) measure_arms();
        // More of them would leave no room for the rest; the table has them.
        if (first_arm_ + between_arms_ * static_cast<double>(arms_.size()) > 0.6 * room_.y) arms_.clear();
        const double below = arms_.empty() ? 0 : first_arm_ + between_arms_ * static_cast<double>(arms_.size() - 1);
        scale_ = choose_scale(long_way, 2 * largest, std::max(room_.x - beside, 20.0),
                              std::max(room_.y - above - below, 12.0), std::nullopt);
        figure_ = begun("rotor", "side-view",
                        arms_.empty() ? Words(lang::rotor::side_view) : Words(lang::rotor::side_view_with_arms), scale_,
                        "m", context_.language);
        half_ = std::max(largest / scale_ + 3, 7.0);
        draw_shaft();
        draw_planes();
        draw_arms();
        for (std::size_t i = 0; i < problem_.corrections.size(); ++i)
            if (shows(i, shown_)) draw_correction(i);
        for (std::size_t i = 0; i < problem_.masses.size(); ++i) draw_rotating(i);
        return finished(std::move(figure_), context_, room_);
    }

private:
    double across(const Exact& z) const { return (z - least_).to_double() / scale_; }

    void draw_shaft() {
        const double end = across(most_) + 5;
        add(line({-5, 0}, {end, 0}, {theme_.link, theme_.skeleton, {}, true}));
        add(line({-8, 0}, {end + 3, 0}, thin(dash_dot())));
        draw_arrow(figure_.marks, {end + 3, 0}, {end + 7, 0}, theme_.thin, theme_.secondary);
        name(formula("{z}"), {end + 7, 0}, theme_.secondary);
        if (!problem_.bearings) return;
        for (const std::size_t plane : *problem_.bearings)
            draw_pivot_on_frame(figure_.marks, {across(problem_.planes[plane].z), 0}, {0, 1}, theme_.text, theme_);
    }
    bool is_corrected(std::size_t plane) const {
        return std::any_of(problem_.corrections.begin(), problem_.corrections.end(),
                           [&](const RotorCorrection& each) { return each.plane == plane; });
    }
    bool is_bearing(std::size_t plane) const {
        return problem_.bearings &&
               std::find(problem_.bearings->begin(), problem_.bearings->end(), plane) != problem_.bearings->end();
    }
    void draw_planes() {
        for (std::size_t i = 0; i < problem_.planes.size(); ++i) {
            const double x = across(problem_.planes[i].z);
            const bool corrected = is_corrected(i);
            const Pen pen = corrected ? Pen{theme_.outline, theme_.text, dashes(), false} : thin();
            if (!is_bearing(i) || corrected) add(line({x, half_}, {x, -half_}, pen));
            name(one_piece(problem_.planes[i].name, Face::italic), {x, is_bearing(i) && !corrected ? -1.3 : -half_},
                 corrected ? theme_.text : theme_.secondary, std::nullopt, 1.2);
        }
    }
    /// From the reference plane to every other place with a mass, the nearest first; masses in one plane share an arm.
    void measure_arms() {
        const auto measure = [&](const std::optional<std::size_t>& plane, const std::string& index) {
            const Exact z = problem_.z_of(plane);
            if (z == reference()) return;
            const auto same = std::find_if(arms_.begin(), arms_.end(), [&](const Arm& each) { return each.z == z; });
            if (same == arms_.end()) arms_.push_back({z, braced("l", index)});
        };
        for (const RotorMass& each : problem_.masses) measure(each.plane, each.name);
        if (problem_.is_dynamic()) measure(problem_.corrections[1].plane, problem_.name_of(problem_.corrections[1]));
        std::stable_sort(arms_.begin(), arms_.end(),
                         [&](const Arm& a, const Arm& b) { return abs(a.z - reference()) < abs(b.z - reference()); });
    }
    void draw_arms() {
        if (arms_.empty()) return;
        constexpr double bearing = 9, beyond = 1.2;  // mm
        const double from = across(reference());
        double below = (problem_.bearings ? std::max(half_, bearing) : half_) + first_arm_ - between_arms_;
        for (const Arm& arm : arms_) {
            below += between_arms_;
            const double to = across(arm.z), middle = 0.5 * (from + to);
            add(line({to, half_ + 1}, {to, below + beyond}, thin()));
            draw_arrow(figure_.marks, {middle, below}, {from, below}, theme_.thin, theme_.text);
            draw_arrow(figure_.marks, {middle, below}, {to, below}, theme_.thin, theme_.text);
            name(formula(arm.words), {middle, below}, theme_.text, Spot{to, below}, 1);
        }
        add(line({from, half_ + 1}, {from, below + beyond}, thin()));
    }
    Exact reference() const { return problem_.z_of(problem_.corrections.front().plane); }
    void draw_at(double x, double height, const std::string& words, Colour line_ink, Colour tint, Colour letter,
                 const std::vector<double>& kind) {
        const Spot at{x, -height / scale_};
        add(line({x, 0}, at, {theme_.outline, line_ink, kind, false}));
        draw_mass(at, tint, line_ink);
        name(formula(words), at, letter, std::nullopt, 2.2);
    }
    void draw_rotating(std::size_t i) {
        const RotorMass& mass = problem_.masses[i];
        draw_at(across(problem_.z_of(mass.plane)), (mass.radius * found_.unbalances[i].direction.y).to_double(),
                braced("m", mass.name), colour(i).line, colour(i).tint, colour(i).letter, {});
    }
    void draw_correction(std::size_t i) {
        const auto radius = radius_of(i);
        if (!radius) return;
        const RotorCorrection& given = problem_.corrections[i];
        draw_at(across(problem_.z_of(given.plane)), *radius * way_of(i).y, braced("m", problem_.name_of(given)),
                theme_.text, theme_.text, theme_.text, dashes());
    }

    struct Arm {
        Exact z;
        std::string words;
    };
    static constexpr double first_arm_ = 6, between_arms_ = 5;  ///< mm below the planes

    RotorShown shown_;
    Exact least_, most_;
    std::vector<Arm> arms_;  ///< those drawn
    double scale_ = 1, half_ = 0;
};

/// A closed polygon of unbalances or couples.
class RotorPolygonFigure : RotorPen {
public:
    RotorPolygonFigure(const DrawingContext& context, RotorFigure which, Spot room)
        : RotorPen(context, room), which_(which) {
        is_of_couples_ = which == RotorFigure::couples || which == RotorFigure::couples_left ||
                         which == RotorFigure::bearing_couples;
        is_of_bearings_ = which == RotorFigure::bearing_couples || which == RotorFigure::bearing_forces;
    }

    Figure draw() {
        const Unit unit = is_of_couples_ ? unit_of_couple(units_) : unit_of_unbalance(units_);
        const double si = unit.si.to_double();
        Box extent;
        for (const RotorPolygon::Side& each : polygon().sides) extent.include(spot_of(place(each.tip), si));
        constexpr double beside = 22, above = 12;  // mm, of names
        const double needed = std::max(extent.width() / std::max(room_.x - beside, 20.0),
                                       extent.height() / std::max(room_.y - above, 15.0));
        scale_ = needed > 0 ? si * scales_between(needed, 2 * needed).front() : si;
        figure_ =
            begun("unbalances", id_of(which_), caption(), scale_, is_of_couples_ ? "kg m²" : "kg m", context_.language);
        figure_.scale = scale_ / si;
        figure_.unit = unit.symbol;
        draw_sides();
        if (which_ == RotorFigure::couples_left && !found_.couple_left->is_zero()) draw_couple_left();
        add(disc({0, 0}, 0.7, theme_.text));
        return finished(std::move(figure_), context_, room_);
    }

private:
    const RotorPolygon& polygon() const {
        const RotorBalance& balance = is_of_bearings_ ? *found_.held : found_.balance;
        return which_ == RotorFigure::couples_left ? found_.couples_left
               : is_of_couples_                    ? balance.couples
                                                   : balance.forces;
    }
    Words caption() const {
        switch (which_) {
            case RotorFigure::couples: return {lang::rotor::couple_polygon};
            case RotorFigure::forces: return {lang::sheet::force_polygon};
            case RotorFigure::couples_left: return {lang::rotor::couple_polygon_left};
            case RotorFigure::bearing_couples: return {lang::rotor::couple_polygon_of_bearings};
            case RotorFigure::bearing_forces: break;
        }
        return {lang::rotor::force_polygon_of_bearings};
    }
    Vector place(ElementIndex point) const { return found_.record.point(point).place(); }

    /// Where all sides lie on one line they would cover each other.
    bool is_flat() const {
        Vector along;
        for (const RotorPolygon::Side& each : polygon().sides) {
            const Vector side = place(each.tip) - place(each.tail);
            if (along.is_zero()) along = side;
            if (std::abs(cross(along, side).to_double()) > 1e-9 * length(along) * length(side)) return false;
        }
        return true;
    }
    void draw_sides() {
        const bool flat = is_flat();
        Spot aside;
        for (const RotorPolygon::Side& each : polygon().sides) {
            const Spot tail = spot_of(place(each.tail), scale_), tip = spot_of(place(each.tip), scale_);
            constexpr double shortest_side = 0.3, apart = 4;  // mm
            if (length(tip - tail) < shortest_side) continue;
            if (flat && length(aside) > 0) add(line(tail, tail + aside, thin()));
            draw_side(each, tail + aside, tip + aside);
            if (flat) aside = aside + apart * turned(unit(spot_of(place(polygon().sides.front().tip), 1)));
        }
    }
    void draw_side(const RotorPolygon::Side& side, Spot tail, Spot tip) {
        const BodyColour ink = side.mass ? colour(*side.mass) : BodyColour{theme_.text, theme_.paper, theme_.text, {}};
        draw_vector(index_of(side), is_of_bearings_ && !side.mass, tail, tip,
                    length(place(side.tip) - place(side.tail)), ink);
    }
    std::string index_of(const RotorPolygon::Side& side) const {
        if (side.mass) return problem_.masses[*side.mass].name;
        if (is_of_bearings_) return problem_.planes[problem_.bearings->at(side.balancing)].name;
        return problem_.name_of(problem_.corrections[side.balancing]);
    }
    /// `held`: of a bearing.
    void draw_vector(const std::string& index, bool held, Spot tail, Spot tip, double value, const BodyColour& ink) {
        const std::string data_name = std::string(held ? "R" : "U") + (is_of_couples_ ? "l_" : "_") + index;
        figure_.marks.emplace_back(GroupBegin{"vector",
                                              id_in(figure_, legal_id(data_name)),
                                              data_name,
                                              {{"data-name", data_name},
                                               {"data-value", shortest(value)},
                                               {"data-unit", is_of_couples_ ? "kg m²" : "kg m"}},
                                              none});
        draw_arrow(figure_.marks, tail, tip, theme_.vector, ink.line);
        figure_.marks.emplace_back(Axis{tail, tip});
        figure_.marks.emplace_back(GroupEnd{});
        // The bearings hold forces, and the polygons are those of forces over ω².
        RichText words = vector_formula(braced(held ? "R" : "U", index));
        if (is_of_couples_) append(words, formula(braced("l", index)));
        if (held) append(words, formula("/{ω^2}"));
        name(std::move(words), 0.5 * (tail + tip), ink.letter, tip);
    }
    /// What no mass in the correction plane can close: from the pole to the last tip.
    void draw_couple_left() {
        const Spot tip = spot_of(*found_.couple_left, scale_);
        draw_arrow(figure_.marks, {0, 0}, tip, theme_.vector, theme_.text, dashes());
        name(vector_formula("{C}"), 0.5 * tip, theme_.text, tip);
    }

    RotorFigure which_;
    bool is_of_couples_ = false, is_of_bearings_ = false;
    double scale_ = 1;
};

}  // namespace

Figure rotor_end_view(const DrawingContext& context, RotorShown shown, double room_x, double room_y) {
    return EndView(context, shown, {room_x, room_y}).draw();
}
Figure rotor_side_view(const DrawingContext& context, RotorShown shown, double room_x, double room_y) {
    return SideView(context, shown, {room_x, room_y}).draw();
}
bool has_side_view(const RotorProblem& problem) {
    return std::any_of(problem.planes.begin(), problem.planes.end(),
                       [&](const RotorPlane& each) { return each.z != problem.planes.front().z; });
}
const char* id_of(RotorFigure figure) {
    switch (figure) {
        case RotorFigure::couples: return "couple-polygon";
        case RotorFigure::forces: return "force-polygon";
        case RotorFigure::couples_left: return "couples-left";
        case RotorFigure::bearing_couples: return "bearing-couples";
        case RotorFigure::bearing_forces: break;
    }
    return "bearing-forces";
}
Figure rotor_polygon(const DrawingContext& context, RotorFigure which, double room_x, double room_y) {
    return RotorPolygonFigure(context, which, {room_x, room_y}).draw();
}

}  // namespace kinegraph::render
