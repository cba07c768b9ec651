#include "render/mechanism/dimension_trials.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph::render::drawing {

namespace {

constexpr double text_gap = 1.0;
constexpr double arrow_outside = 6.0, head_room = 3.2;  // for a length too short for arrows between its ends

double readable(double angle) {
    double a = std::remainder(angle, pi_number);      // in ±90°
    if (a >= 0.5 * pi_number - 1e-6) a -= pi_number;  // vertical text reads from the right
    return a;
}

}  // namespace

DimensionTrial DimensionTrials::between_ends(DimensionTrial trial, const Bar& run) const {
    const Spot a = run.from, b = run.to;
    trial.draw = [this, a, b](std::vector<Mark>& marks) {
        draw_arrow(marks, 0.5 * (a + b), b, sketch_.theme.thin, sketch_.theme.text);
        draw_arrow(marks, 0.5 * (a + b), a, sketch_.theme.thin, sketch_.theme.text);
    };
    trial.strokes = {run};
    put_text(trial, 0.5 * (a + b), b - a);
    return trial;
}

DimensionTrial DimensionTrials::outside_of_end(DimensionTrial trial, const Bar& run, double width) const {
    const Spot along = unit(run.to - run.from);
    const Spot a = run.from, b = run.to, before = a - arrow_outside * along;
    const Spot shelf = b + head_room * along, beyond = shelf + (width + 0.8) * along;
    trial.draw = [this, a, b, before, beyond](std::vector<Mark>& marks) {
        draw_arrow(marks, before, a, sketch_.theme.thin, sketch_.theme.text);
        draw_arrow(marks, beyond, b, sketch_.theme.thin, sketch_.theme.text);
        marks.emplace_back(line(a, b, thin()));
    };
    trial.strokes = {{before, beyond}};
    put_text(trial, 0.5 * (shelf + beyond), along);
    trial.price += 0.1;
    return trial;
}

void DimensionTrials::put_text(DimensionTrial& trial, Spot middle, Spot along) const {
    trial.text_angle = readable(angle_of(along));
    trial.text_at = middle + text_gap * Spot{nearest::sin(trial.text_angle), -nearest::cos(trial.text_angle)};
}

std::vector<DimensionTrials::Level> DimensionTrials::levels_of(double rise) const {
    const double near = std::min(0.0, rise), far = std::max(0.0, rise);
    std::vector<Level> levels;
    for (const double reach : {8.5, 12.0, 15.5, 19.0, 23.0, 27.0, 32.0, 38.0}) {
        if (reach > 19 && !sought_far_) break;
        levels.push_back({far + reach, 1, reach});
        levels.push_back({near - reach, -1, reach});
    }
    if (sought_far_)
        for (const double reach : {3.0, 6.0, 8.5, 12.0, 15.5, 19.0}) {
            if (far - near < reach + 12) break;
            levels.push_back({far - reach, -1, reach + 5});
            levels.push_back({near + reach, 1, reach + 5});
        }
    return levels;
}

std::vector<DimensionTrial> DimensionTrials::of(const DimensionedLength& datum, double width) const {
    const Spot along = datum.along, across = turned(along);
    const double run = dot(datum.to - datum.from, along), rise = dot(datum.to - datum.from, across);
    const bool has_text_between = run >= std::max(width + 3, 9.0);
    if (!has_text_between && !(sought_far_ && run > 1)) return {};
    std::vector<DimensionTrial> trials;
    for (const Level& level : levels_of(rise)) {
        DimensionTrial trial;
        const Spot a = datum.from + level.at * across, b = a + run * along;
        const double clear = sketch_.measures.pin_radius + 0.7;
        for (const auto& [point, foot] : {std::pair{datum.from, a}, std::pair{datum.to, b}}) {
            const Spot out = unit(foot - point);
            if (length(foot - point) > clear) trial.extensions.push_back({point + clear * out, foot + 1.4 * out});
        }
        // Prefer near places, and places outside the mechanism.
        const bool inside = dot(0.5 * (a + b) - sketch_.mechanism_box().middle(), level.side * across) < 0;
        trial.price = 0.06 * level.reach + (inside ? 0.35 : 0);
        if (has_text_between) {
            trials.push_back(between_ends(trial, {a, b}));
        } else {
            trials.push_back(outside_of_end(trial, {a, b}, width));
            trials.push_back(outside_of_end(trial, {b, a}, width));
        }
    }
    return trials;
}

std::vector<DimensionTrial> DimensionTrials::beside(const DimensionedLength& datum, double width) const {
    constexpr double beyond_text = 2;  // mm of the segment at both ends of the text
    constexpr double height = 3;       // of the text, mm
    const Spot run = datum.to - datum.from;
    const bool measures_its_segment = std::abs(cross(unit(run), datum.along)) < 1e-6;
    if (!sought_far_ || !measures_its_segment || length(run) < width + 2 * beyond_text) return {};
    const double angle = readable(angle_of(run));
    const Spot up{nearest::sin(angle), -nearest::cos(angle)};
    const double off = 0.5 * sketch_.theme.link;
    std::vector<DimensionTrial> trials;
    for (const double share : {0.5, 0.35, 0.65, 0.25, 0.75}) {
        if (std::min(share, 1 - share) * length(run) < 0.5 * width + beyond_text) continue;
        for (const double away : {1.0, 2.5, 4.0})
            for (const bool above : {true, false}) {
                DimensionTrial trial;
                trial.draw = [](std::vector<Mark>&) {};
                trial.text_angle = angle;
                trial.text_at = datum.from + share * run + (above ? off + away : -off - away - height) * up;
                trial.price = 0.06 * away + 0.2 * std::abs(share - 0.5);
                trials.push_back(std::move(trial));
            }
    }
    return trials;
}

double DimensionTrials::leader_angle(double step) { return -pi_number / 4 + pi_number / 6 * step + 0.05; }

DimensionTrial DimensionTrials::from_outside(const DimensionedRadius& datum, double angle, double length, double width,
                                             double price) const {
    const Spot out = polar_spot(angle);
    const Spot rim = datum.centre + datum.radius * out, knee = rim + length * out;
    const Spot shelf{out.x >= 0 ? 1.0 : -1.0, 0};
    const Spot end = knee + (width + 0.8) * shelf;
    DimensionTrial trial;
    trial.draw = [this, knee, rim, end](std::vector<Mark>& marks) {
        draw_arrow(marks, knee, rim, sketch_.theme.thin, sketch_.theme.text);
        marks.emplace_back(line(knee, end, thin()));
    };
    trial.strokes = {{rim + 1.6 * out, knee}, {knee, end}};
    trial.text_at = 0.5 * (knee + end) + Spot{0, -text_gap};
    trial.price = price;
    return trial;
}

DimensionTrial DimensionTrials::from_centre(const DimensionedRadius& datum, double angle, double price) const {
    const Spot out = polar_spot(angle);
    const Spot rim = datum.centre + datum.radius * out, foot = datum.centre + (sketch_.measures.pin_radius + 0.7) * out;
    DimensionTrial trial;
    trial.draw = [this, foot, rim](std::vector<Mark>& marks) {
        draw_arrow(marks, foot, rim, sketch_.theme.thin, sketch_.theme.text);
    };
    trial.strokes = {{foot, rim - 1.6 * out}};
    put_text(trial, 0.5 * (foot + rim), out);
    trial.price = price;
    return trial;
}

std::vector<DimensionTrial> DimensionTrials::of(const DimensionedRadius& datum, double width) const {
    if (datum.radius < (sought_far_ ? 2 : 5)) return {};
    std::vector<DimensionTrial> trials;
    for (int i = 0; i < 12; ++i) trials.push_back(from_outside(datum, leader_angle(i), 6.5, width, 0.02 * i));
    // In a large circle the text has room along the radius; so it has in one that is as large as the figure.
    const bool is_large = datum.radius > width + 8;
    for (int i = 0; i < 12 && is_large && !sought_far_; ++i)
        trials.push_back(from_centre(datum, leader_angle(i), 0.6 + 0.02 * i));
    if (sought_far_)
        for (const double half : {0.0, 0.5})
            for (int i = 0; i < 12; ++i) {
                for (const double length : {6.5, 11.0, 16.0, 22.0})
                    trials.push_back(
                        from_outside(datum, leader_angle(i + half), length, width, 0.02 * i + 0.06 * length));
                if (is_large) trials.push_back(from_centre(datum, leader_angle(i + half), 0.6 + 0.02 * i));
            }
    return trials;
}

DimensionTrial DimensionTrials::beside_base(DimensionTrial trial, const DimensionedAngle& datum, double radius,
                                            double width) const {
    const double turn = datum.sweep > 0 ? 1 : -1;
    const auto at = [&](double angle) { return datum.vertex + radius * polar_spot(datum.from + angle); };
    const Spot tangent = turned(polar_spot(datum.from));
    const double half = std::abs(tangent.x) * width / 2 + std::abs(tangent.y) * DimensionRoom::cap_height / 2;
    const double begin = -turn * 4 / radius, middle = begin - turn * (half + 1) / radius;
    trial.draw = [this, &datum, radius, begin](std::vector<Mark>& marks) {
        draw_arc_arrow(marks, datum.vertex, radius, datum.from + begin, datum.from + datum.sweep, sketch_.theme.thin,
                       sketch_.theme.text);
    };
    trial.strokes.push_back({at(begin), at(0)});
    trial.text_at = at(middle) + Spot{0, DimensionRoom::cap_height / 2};
    trial.price = 0.05 * radius + 0.6;
    return trial;
}

DimensionTrial DimensionTrials::led_out(DimensionTrial trial, const DimensionedAngle& datum, double radius,
                                        double share, double reach, double width) const {
    const Spot out = polar_spot(datum.from + share * datum.sweep), shelf{out.x >= 0 ? 1.0 : -1.0, 0};
    const Spot foot = datum.vertex + radius * out, knee = foot + reach * out, end = knee + (width + 0.8) * shelf;
    trial.draw = [this, arc = trial.draw, knee, end](std::vector<Mark>& marks) {
        arc(marks);
        marks.emplace_back(line(knee, end, thin()));
    };
    trial.extensions.push_back({foot, knee});  // priced like an extension line
    trial.strokes.push_back({knee, end});
    trial.text_at = 0.5 * (knee + end) + Spot{0, -text_gap};
    trial.price = 0.05 * radius + 0.06 * reach + std::abs(share - 0.5) + 0.8;
    return trial;
}

DimensionTrial DimensionTrials::arc_of(const DimensionedAngle& datum, double radius) const {
    DimensionTrial trial;
    trial.draw = [this, &datum, radius](std::vector<Mark>& marks) {
        draw_arc_arrow(marks, datum.vertex, radius, datum.from, datum.from + datum.sweep, sketch_.theme.thin,
                       sketch_.theme.text);
    };
    const int parts = 6;
    const double turn = datum.sweep > 0 ? 1 : -1;
    // The arc should end visibly at the link, so it stops slightly before it.
    const double shy = std::min(0.3, 2.4 / radius) * turn;
    for (int i = 0; i < parts; ++i)
        trial.strokes.push_back(
            {datum.vertex + radius * polar_spot(datum.from + (datum.sweep - shy) * i / parts),
             datum.vertex + radius * polar_spot(datum.from + (datum.sweep - shy) * (i + 1) / parts)});
    const Spot base = polar_spot(datum.from);
    trial.extensions = {
        {datum.vertex + (sketch_.measures.pin_radius + 0.7) * base, datum.vertex + (radius + 2.5) * base}};
    return trial;
}

std::vector<DimensionTrial> DimensionTrials::of(const DimensionedAngle& datum, double width) const {
    std::vector<DimensionTrial> trials;
    for (const double radius : {9.0, 12.0, 15.0, 18.5, 22.0, 26.0, 31.0}) {
        const double arc = std::abs(datum.sweep) * radius;
        if (arc < (sought_far_ ? 2.2 : 4) || (radius > 22 && !sought_far_)) continue;
        const DimensionTrial trial = arc_of(datum, radius);
        for (const double share : {0.5, 0.35, 0.65}) {
            if (arc < 4) break;
            DimensionTrial one = trial;
            const double middle = datum.from + share * datum.sweep;
            const Spot out = polar_spot(middle);
            const Spot reach{std::abs(out.x) * width / 2, std::abs(out.y) * DimensionRoom::cap_height / 2};
            one.text_at =
                datum.vertex + (radius + 1.0 + reach.x + reach.y) * out + Spot{0, DimensionRoom::cap_height / 2};
            one.price = 0.05 * radius + std::abs(share - 0.5);
            trials.push_back(std::move(one));
        }
        if (sought_far_) trials.push_back(beside_base(trial, datum, radius, width));
    }
    return trials;
}

std::vector<DimensionTrial> DimensionTrials::led_out_of(const DimensionedAngle& datum, double width) const {
    std::vector<DimensionTrial> trials;
    for (const double radius : {6.0, 7.5, 9.0, 12.0, 15.0}) {
        if (std::abs(datum.sweep) * radius < 2.2) continue;
        const DimensionTrial arc = arc_of(datum, radius);
        for (const double share : {0.5, 0.35, 0.65})
            for (const double reach : {7.0, 9.5, 12.0, 15.0, 18.0, 21.5, 25.0, 30.0, 36.0})
                trials.push_back(led_out(arc, datum, radius, share, reach, width));
    }
    return trials;
}

}  // namespace kinegraph::render::drawing
