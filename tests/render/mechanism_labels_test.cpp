// Labels and arcs of the mechanism figure, over all examples in rooms of several sizes: a body's number and the arc of
// its ω are nearer to it than to another body, and a leader passes no point that has another name and crosses no body
// but its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/mechanism/layout.hpp"
#include "render/scene/drawing_context.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace mechanism_labels_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::render::drawing;
using tests::example;
using tests::example_names;
using tests::fonts;

/// A label as it is drawn: its number's circle and its leader, from what it names, precede its letters.
struct Placed {
    std::string words;
    std::optional<Spot> number;
    std::optional<Bar> leader;
};

std::optional<Bar> straight(const Path& path) {
    if (path.segments.size() != 2 || !path.stroked) return std::nullopt;
    const auto* from = std::get_if<MoveTo>(path.segments.data());
    const auto* to = std::get_if<LineTo>(&path.segments[1]);
    return from && to ? std::optional(Bar{from->to, to->to}) : std::nullopt;
}
const ArcTo* round_of(const Path& path) {
    return path.segments.size() == 3 ? std::get_if<ArcTo>(&path.segments[1]) : nullptr;
}

/// Without its layers only labels, the scale bar and the key are left.
std::vector<Placed> labels_of(const Figure& figure) {
    std::vector<Placed> labels;
    Placed next;
    std::optional<Bar> line;
    int depth = 0;
    for (const Mark& mark : figure.marks) {
        if (std::holds_alternative<GroupBegin>(mark)) ++depth;
        if (std::holds_alternative<GroupEnd>(mark)) --depth;
        if (const auto* path = std::get_if<Path>(&mark); path && depth == 1) {
            constexpr double largest_dot = 0.5;
            const ArcTo* round = round_of(*path);
            if (round && round->radius < largest_dot) next.leader = line;
            if (round && round->radius >= largest_dot) next.number = round->centre;
            line = straight(*path);
        } else if (const auto* text = std::get_if<TextMark>(&mark); text && depth == 1) {
            next.words = text->words;
            if (text->cls == "label") labels.push_back(next);
            next = {};
        } else {
            next = {};
            line.reset();
        }
    }
    return labels;
}

bool cross_each_other(const Bar& a, const Bar& b) {
    const auto side = [](Spot p, Spot q, Spot r) { return cross(q - p, r - p); };
    return side(a.from, a.to, b.from) * side(a.from, a.to, b.to) < 0 &&
           side(b.from, b.to, a.from) * side(b.from, b.to, a.to) < 0;
}

/// What stands wrongly in a figure, of how many labels.
struct Faults {
    int numbers = 0, at_another_body = 0;
    int leaders = 0, past_a_point = 0, over_a_body = 0, far_away = 0;
    std::string said;
};

class Judge {
public:
    Judge(const Figure& figure, const Layout& layout, Faults& faults) : layout_(layout), faults_(faults) {
        for (const BodyStroke& stroke : layout.strokes_of_bodies())
            strokes_.push_back({stroke.body, stroke.from + figure.origin, stroke.to + figure.origin});
        for (const Joint& joint : layout.mechanism.joints) pins_.push_back(layout.spot(joint) + figure.origin);
    }

    void judge(const Placed& label) {
        const BodyIndex own = body_named(label.words);
        if (label.number && own != none && !label.leader) {
            ++faults_.numbers;
            judge_number(label, own);
        }
        if (!label.leader) return;
        ++faults_.leaders;
        const Bar leader = *label.leader;
        constexpr double short_leader = 16;  // mm
        if (length(leader.to - leader.from) > short_leader) ++faults_.far_away;
        for (const Spot pin : pins_)
            if (length(pin - leader.from) > own_point && drawing::distance(pin, leader) < 1) {
                ++faults_.past_a_point;
                faults_.said += label.words + " past a point\n";
                break;
            }
        for (const BodyIndex body : layout_.mechanism.moving_bodies()) {
            if (body == own || begins_at(leader.from, body) || !crosses(leader, body)) continue;
            ++faults_.over_a_body;
            faults_.said += label.words + " over body " + layout_.mechanism.body(body).name + "\n";
            break;
        }
    }

private:
    /// The body whose number, ω or α it is.
    BodyIndex body_named(const std::string& words) const {
        for (const BodyIndex body : layout_.mechanism.moving_bodies()) {
            const std::string& name = layout_.mechanism.body(body).name;
            if (words == name || words.starts_with("ω_" + name + " ") || words.starts_with("α_" + name + " "))
                return body;
        }
        return none;
    }
    bool begins_at(Spot at, BodyIndex body) const {
        return std::any_of(strokes_.begin(), strokes_.end(), [&](const BodyStroke& stroke) {
            return stroke.body == body && drawing::distance(at, {stroke.from, stroke.to}) < own_point;
        });
    }
    bool crosses(const Bar& leader, BodyIndex body) const {
        return std::any_of(strokes_.begin(), strokes_.end(), [&](const BodyStroke& stroke) {
            return stroke.body == body && cross_each_other(leader, {stroke.from, stroke.to});
        });
    }
    void judge_number(const Placed& label, BodyIndex own) {
        double near = 1e300, other = 1e300;
        for (const BodyStroke& stroke : strokes_) {
            double& least = stroke.body == own ? near : other;
            least = std::min(least, drawing::distance(*label.number, {stroke.from, stroke.to}));
        }
        constexpr double looks_nearer = 0.5;  // mm
        if (near < other + looks_nearer) return;
        ++faults_.at_another_body;
        faults_.said += label.words + " nearer to another body\n";
    }

    static constexpr double own_point = 2.6;  // from the middle of a pin to where its leader begins, mm
    const Layout& layout_;
    Faults& faults_;
    std::vector<BodyStroke> strokes_;
    std::vector<Spot> pins_;
};

TEST(MechanismLabels, AreNotReadAsThoseOfOtherBodiesAndPoints) {
    const Theme theme;
    Faults faults;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion || solution.mechanism.drivers.empty()) continue;
        const DrawingContext context{solution, theme, fonts()};
        const Subject subject(solution);
        for (const Spot room : {Spot{90, 80}, Spot{130, 100}, Spot{200, 150}}) {
            Figure figure = mechanism_figure(context, room.x, room.y, !solution.centres.empty());
            if (Figure more = mechanism_with_found_turnings(context, figure, room, !solution.centres.empty());
                !more.marks.empty())
                figure = std::move(more);
            const Layout layout(subject, theme, figure.places);
            Judge judge(figure, layout, faults);
            const std::size_t before = faults.said.size();
            for (const Placed& label : labels_of(figure)) judge.judge(label);
            if (faults.said.size() > before) faults.said += "  in " + name + ", " + std::to_string(room.x) + "\n";
        }
    }
    ASSERT_GT(faults.numbers, 500);
    ASSERT_GT(faults.leaders, 200);
    // Where bodies lie on each other or fill the figure, a place that is right in every way may not exist.
    EXPECT_LE(faults.at_another_body, faults.numbers / 30) << faults.said;
    EXPECT_LE(faults.past_a_point, faults.leaders / 100) << faults.said;
    EXPECT_LE(faults.over_a_body, faults.leaders / 10) << faults.said;
    EXPECT_LE(faults.far_away, faults.leaders / 10) << faults.said;
}

/// The arcs of ω and α: the curved strokes of the layer of arrows, each in the colour of its body.
std::vector<std::pair<Arc, Colour>> arcs_of(const Figure& figure) {
    std::vector<std::pair<Arc, Colour>> arcs;
    int depth = 0, within = 0;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            ++depth;
            if (std::string_view(group->cls) == "arrows") within = depth;
        }
        if (std::holds_alternative<GroupEnd>(mark) && depth-- == within) within = 0;
        const auto* path = std::get_if<Path>(&mark);
        if (within == 0 || path == nullptr || !path->stroked || path->segments.size() != 2) continue;
        if (const auto* round = std::get_if<ArcTo>(&path->segments[1]))
            arcs.push_back({{round->centre, round->radius, round->from, round->to}, path->pen.colour});
    }
    return arcs;
}

/// Whether an arc is as near to another body as to its own, or crosses another; about a fixed pin of its own it may
/// come nearer to others, but not beyond them.
bool may_be_of_another(const Arc& arc, BodyIndex body, const Layout& layout, Spot origin) {
    const std::array spots{arc.at(arc.from), arc.at(0.5 * (arc.from + arc.to)), arc.at(arc.to)};
    const bool about_its_pin =
        std::any_of(layout.mechanism.joints.begin(), layout.mechanism.joints.end(), [&](const Joint& joint) {
            return is_fixed_pin(joint) && joint.connects(body) && length(layout.spot(joint) + origin - arc.centre) < 1;
        });
    double near = 1e300, other = 1e300;
    for (const BodyStroke& stroke : layout.strokes_of_bodies()) {
        const Bar bar{stroke.from + origin, stroke.to + origin};
        double& least = stroke.body == body ? near : other;
        for (const Spot spot : spots) least = std::min(least, drawing::distance(spot, bar));
        if (stroke.body == body) continue;
        if (cross_each_other({spots[0], spots[2]}, bar)) return true;
        if (about_its_pin && cross_each_other({arc.centre, spots[1]}, bar)) return true;
    }
    return !about_its_pin && other < near + 0.5;
}

TEST(MechanismArcs, StandAtTheirOwnBodyAndMostRatesAreShown) {
    const Theme theme;
    int arcs = 0, doubtful = 0, rates = 0, shown = 0;
    std::string said;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.instantaneous_motion || solution.mechanism.drivers.empty()) continue;
        const DrawingContext context{solution, theme, fonts()};
        Figure figure = mechanism_figure(context, 150, 110, !solution.centres.empty());
        if (Figure more = mechanism_with_found_turnings(context, figure, {150, 110}, !solution.centres.empty());
            !more.marks.empty())
            figure = std::move(more);
        const Subject subject(solution);
        const Layout layout(subject, theme, figure.places);
        for (const auto& [arc, colour] : arcs_of(figure)) {
            BodyIndex own = none;
            for (const BodyIndex body : layout.mechanism.moving_bodies())
                if (theme.colour_of(body).letter == colour) own = body;
            ASSERT_NE(own, none);
            ++arcs;
            if (!may_be_of_another(arc, own, layout, figure.origin)) continue;
            ++doubtful;
            said += layout.mechanism.body(own).name + " in " + name + "\n";
        }
        for (const Placed& label : labels_of(figure)) shown += label.words.starts_with("ω_") ? 1 : 0;
        for (const BodyMotion& motion : solution.bodies) rates += motion.omega && !motion.omega->is_zero() ? 1 : 0;
    }
    ASSERT_GT(arcs, 120);
    // Where links lie on each other, no arc is clearly nearer to its own.
    EXPECT_LE(doubtful, arcs / 30) << said;
    EXPECT_GE(5 * shown, 4 * rates) << shown << " of " << rates;
}

TEST(MechanismLabels, GiveNoRateToADriverAtADeadPoint) {
    const Theme theme;
    for (const char* const name : {"dead_point_rounded", "slider_driven_dead_point"}) {
        const Solution& solution = example(name);
        ASSERT_FALSE(solution.mobility.idle_drivers.empty());
        const Figure figure = mechanism_figure({solution, theme, fonts()}, 200, 150, true);
        for (const Placed& label : labels_of(figure)) EXPECT_FALSE(label.words.ends_with("/s")) << label.words;
    }
}

}  // namespace
}  // namespace mechanism_labels_test
