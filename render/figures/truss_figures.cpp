#include "render/figures/truss_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/number/assert.hpp"
#include "engine/solution/bindings.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/strings.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/truss_table.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

constexpr double meets_seen = 1.1;  // greatest distance of an intersection from the truss, in sizes of the truss

enum class Sense { idle, tension, compression };

double tension_of(const Solution& solution, std::size_t bar) {
    return solution.truss->tension(bar, solution.pose.points);
}

Sense sense_of(const Solution& solution, std::size_t bar) {
    if (solution.truss->bars[bar].force->is_zero()) return Sense::idle;
    return tension_of(solution, bar) > 0 ? Sense::tension : Sense::compression;
}

/// Colours of the third and the first body, which differ most, also in grey. Widths differ, too, for print without
/// colour; a dashed line would mean an internal force.
Pen pen_of(const Theme& theme, Sense sense) {
    switch (sense) {
        case Sense::tension: return {theme.vector, theme.body(BodyIndex(3)).line, {}, false};
        case Sense::compression: return {2.6 * theme.vector, theme.body(BodyIndex(1)).line, {}, false};
        case Sense::idle: break;
    }
    return {theme.outline, theme.secondary, {}, false};
}
/// For the force plan, where heavy lines would cover its corners.
constexpr double in_plan = 0.6;
Pen thin_pen_of(const Theme& theme, Sense sense) {
    Pen pen = pen_of(theme, sense);
    pen.width *= in_plan;
    return pen;
}

/// What the lines of bars mean: a stroke and a word for each sense that the truss has, in a row below the figure.
class SenseKey {
public:
    /// `weight`: of the strokes, relative to those of the truss.
    SenseKey(const DrawingContext& context, double weight) : context_(context), weight_(weight) {
        for (std::size_t bar = 0; bar < context.solution.truss->bars.size(); ++bar)
            senses_.insert(sense_of(context.solution, bar));
        senses_.erase(Sense::idle);  // the bars that carry nothing are thin in any figure
    }

    double height() const { return senses_.empty() ? 0 : line_height; }
    /// Appends it to the figure, whose box is known, and extends the box.
    void set(Figure& figure) const {
        constexpr double stroke = 9, before_word = 1.5, between = 5, baseline = 4.4, raised = 1.1;
        Spot at{figure.box.min.x, figure.box.max.y + baseline};
        const std::size_t first = figure.marks.size();
        for (const Sense sense : senses_) {
            const Spot start = at - Spot{0, raised};
            Pen pen = pen_of(context_.theme, sense);
            pen.width *= weight_;
            figure.marks.emplace_back(line(start, start + Spot{stroke, 0}, pen));
            at.x += stroke + before_word;
            ShapedLine shaped = context_.fonts.shape(
                one_piece(
                    word(sense == Sense::tension ? lang::sheet::tension : lang::sheet::compression, context_.language)),
                context_.theme.small);
            const double width = shaped.width;
            set_text(figure.marks, std::move(shaped), at, context_.theme.secondary, "text");
            at.x += width + between;
        }
        if (figure.marks.size() > first) figure.box.include(box_of(std::span<const Mark>(figure.marks).subspan(first)));
    }

private:
    static constexpr double line_height = 6;

    const DrawingContext& context_;
    double weight_;
    std::set<Sense> senses_;
};

RichText letter_of(const Truss::Space& space) {
    return one_piece(space.letter, space.outside ? Face::italic : Face::regular);
}

PointIndex point_of(const Truss& truss, int pin) { return truss.structure.pins[at_index(pin)].point; }

// --- space diagram

/// The sections through a truss, without repetition, with the arms of the forces that they find.
class TrussCuts {
public:
    explicit TrussCuts(Sketch& sketch)
        : sketch_(sketch), solution_(sketch.subject.solution), truss_(*solution_.truss) {}

    void draw() {
        std::vector<std::vector<int>> drawn;
        for (const Truss::Cut& cut : truss_.cuts) {
            if (std::find(drawn.begin(), drawn.end(), cut.bars) == drawn.end()) draw_section(cut);
            drawn.push_back(cut.bars);
            draw_arm(cut);
        }
    }

private:
    Spot spot(int pin) const { return sketch_.spot(point_of(truss_, pin)); }

    /// Across the bars at their midpoints, with a short extension.
    void draw_section(const Truss::Cut& cut) {
        std::vector<Spot> middles;
        for (const int bar : cut.bars) {
            const auto& ends = truss_.structure.bars[at_index(bar)].pins;
            middles.push_back(0.5 * (spot(ends[0]) + spot(ends[1])));
        }
        // From one end to the other, in the direction of their greatest distance.
        Spot along{1, 0};
        for (const Spot a : middles)
            for (const Spot b : middles)
                if (length(b - a) > length(along)) along = b - a;
        std::sort(middles.begin(), middles.end(), [&](Spot a, Spot b) { return dot(a, along) < dot(b, along); });
        const auto past = [](Spot from, Spot to) { return to + (7 / std::max(length(to - from), 1e-6)) * (to - from); };
        middles.insert(middles.begin(), past(middles[1], middles[0]));
        middles.push_back(past(middles[middles.size() - 2], middles.back()));
        const std::size_t first = sketch_.over_bodies.size();
        sketch_.over_bodies.emplace_back(
            polyline(middles, {sketch_.theme.outline, sketch_.theme.accent, dash_dot(), false}));
        belong(sketch_.over_bodies, first, cut.statement);
    }

    /// From the intersection of the other bars, perpendicular to the bar.
    void draw_arm(const Truss::Cut& cut) {
        if (!cut.pivot) return;
        const Spot pivot = sketch_.spot(*cut.pivot);
        if (!contains(grown(sketch_.mechanism_box(), 0.5 * sketch_.size()), pivot)) return;
        const auto& ends = truss_.structure.bars[at_index(cut.found)].pins;
        const Spot from = spot(ends[0]), off = spot(ends[1]) - from;
        const Spot foot = from + (dot(pivot - from, off) / dot(off, off)) * off;
        const std::size_t first = sketch_.construction.size();
        sketch_.construction.emplace_back(line(pivot, foot, sketch_.thin()));
        belong(sketch_.construction, first, cut.statement);
        const Unit& unit = sketch_.mechanism.units.length;
        const double arm = truss_.numbers_of(cut, solution_.pose.points).arm / unit.si.to_double();
        // Parallel bars share an arm.
        const Spot across = foot - pivot;
        for (const Spot other : arms_)
            if (length(other - across) < 0.05 || length(other + across) < 0.05) return name_pivot(cut, pivot);
        arms_.push_back(across);
        RichText text = one_piece(letter_of_arms(), Face::italic);
        append(text, one_piece(" = " + number(arm, 4, sketch_.context.language) + " " + unit.symbol));
        LabelRequest& label =
            sketch_.add_label(std::move(text), sketch_.theme.secondary, 0.5 * (pivot + foot), 1, cut.statement);
        label.toward = foot;
        label.size = sketch_.theme.small;
        name_pivot(cut, pivot);
    }

    /// A letter that no space has.
    std::string letter_of_arms() const {
        for (const char* letter : {"b", "h", "r"})
            if (std::none_of(truss_.spaces.begin(), truss_.spaces.end(),
                             [&](const Truss::Space& space) { return space.letter == letter; }))
                return letter;
        return "β";
    }

    void name_pivot(const Truss::Cut& cut, Spot pivot) {
        const bool is_pin =
            std::any_of(truss_.structure.pins.begin(), truss_.structure.pins.end(),
                        [&](const auto& pin) { return length(sketch_.spot(pin.point) - pivot) < 0.05; });
        if (is_pin || std::find(named_.begin(), named_.end(), cut.pivot_name) != named_.end()) return;
        named_.push_back(cut.pivot_name);
        sketch_.centres.emplace_back(disc(pivot, 0.7, sketch_.theme.text));
        belong(sketch_.centres, sketch_.centres.size() - 1, cut.statement);
        sketch_
            .add_label(typeset(Symbol{Symbol::Letter::point, cut.pivot_name, ""}, sketch_.context.language),
                       sketch_.theme.text, pivot, 1.8, cut.statement)
            .names = {cut.pivot_name};
    }

    Sketch& sketch_;
    const Solution& solution_;
    const Truss& truss_;
    std::vector<std::string> named_;  // pivots
    std::vector<Spot> arms_;          // dimensioned
};

class SpaceDiagram {
public:
    explicit SpaceDiagram(Sketch& sketch)
        : sketch_(sketch), solution_(sketch.subject.solution), truss_(*solution_.truss) {}

    void draw() {
        draw_supports();
        for (std::size_t bar = 0; bar < truss_.bars.size(); ++bar) draw_bar(bar);
        for (const TrussStructure::Pin& pin : truss_.structure.pins)
            sketch_.pins.emplace_back(ring(sketch_.spot(pin.point), 0.8, sketch_.theme.paper, sketch_.outline()));
        for (const Truss::External& external : truss_.externals) draw_external(external);
        for (const Truss::Space& space : truss_.spaces) name_space(space);
        draw_whole();
        for (std::size_t i = 0; i < solution_.taken_together.size(); ++i) {
            const TakenTogether& together = solution_.taken_together[i];
            if (together.funicular)
                draw_strings_of(*together.funicular, together.sums, i);
            else
                for (const AppliedForce& sum : together.sums) draw_line_of_meets(sum, sum_binding("", i, sum));
        }
        TrussCuts(sketch_).draw();
    }

private:
    Spot spot(int pin) const { return sketch_.spot(point_of(truss_, pin)); }

    void draw_supports() {
        for (const Joint& joint : sketch_.mechanism.joints) {
            if (!joint.connects(frame)) continue;
            if (is_fixed_pin(joint)) draw_fixed_pin(sketch_, joint.point);
            if (!joint.pair().is_hinge()) draw_roller(joint);
        }
    }
    /// A roller, on the side away from the bars.
    void draw_roller(const Joint& joint) {
        const Spot at = sketch_.spot(joint.point);
        Spot inward{0, 0};
        for (const Spot leaving : sketch_.leaving(joint.point)) inward = inward + leaving;
        const auto& normal = solution_.pose.normals[at_index(sketch_.mechanism.index_of(joint))];
        Spot down = paper_direction(normal);
        if (joint.pushes && dot(paper_direction(*joint.pushes), down) > 0) down = -1.0 * down;
        if (!joint.pushes && dot(down, inward) > 0) down = -1.0 * down;
        const Spot across = turned(down);
        const double high = 0.62 * sketch_.measures.triangle_height, half = 0.62 * sketch_.measures.triangle_half,
                     wheel = 0.9 * sketch_.measures.shrink;
        sketch_.ground.emplace_back(polyline({at, at + high * down + half * across, at + high * down - half * across},
                                             sketch_.outline(), true));
        for (const double side : {-0.6, 0.6})
            sketch_.ground.emplace_back(
                circle(at + (high + wheel) * down + side * half * across, wheel, sketch_.outline()));
        const Spot foot = at + (high + 2 * wheel) * down;
        draw_wall(sketch_, {foot - 1.7 * half * across, foot + 1.7 * half * across}, down);
    }

    void draw_bar(std::size_t bar) {
        const TrussStructure::Bar& own = truss_.structure.bars[bar];
        const double value = tension_of(solution_, bar) / unit().si.to_double();
        sketch_.bodies.emplace_back(GroupBegin{"bar",
                                               sketch_.id("bar", own.name),
                                               own.name,
                                               {{"data-name", own.name}, {"data-value", shortest(value)}},
                                               none});
        sketch_.bodies.emplace_back(
            line(spot(own.pins[0]), spot(own.pins[1]), {sketch_.theme.outline, sketch_.theme.skeleton, {}, false}));
        const std::size_t found = sketch_.bodies.size();
        sketch_.bodies.emplace_back(
            line(spot(own.pins[0]), spot(own.pins[1]), pen_of(sketch_.theme, sense_of(solution_, bar))));
        hang(sketch_.bodies, found,
             {Holds::Form::segment,
              {point_binding(point_of(truss_, own.pins[0])), point_binding(point_of(truss_, own.pins[1])),
               bar_binding(truss_, bar)}});
        belong(sketch_.bodies, found, truss_.bars[bar].statement);
        sketch_.bodies.emplace_back(GroupEnd{});
    }

    const Unit& unit() const { return sketch_.mechanism.units.force; }

    /// How close bars are to a ray from a pin: the largest cosine of the angle.
    double crowding(int pin, Spot along) {
        double most = -1;
        for (const int bar : truss_.structure.pins[at_index(pin)].bars) {
            const Spot off = spot(truss_.structure.other_end(bar, pin)) - spot(pin);
            most = std::max(most, dot(along, off) / length(off));
        }
        for (const Spot taken : rays_[pin]) most = std::max(most, dot(along, taken) - 0.1);
        return most;
    }
    /// With its head at the pin, or with its tail if bars are in the way.
    void draw_external(const Truss::External& external) {
        constexpr double size = 14, gap = 2.2, beyond_support = 8;
        const Spot along = paper_direction(*external.force), at = spot(external.pin);
        const bool behind = crowding(external.pin, -1.0 * along) <= crowding(external.pin, along) + 0.3;
        const Spot out = behind ? -1.0 * along : along;
        rays_[external.pin].push_back(out);
        const double from = external.joint != none && behind ? gap + beyond_support : gap;
        const Spot near = at + from * out, far = at + (from + size) * out;
        sketch_.arrows.emplace_back(GroupBegin{"force",
                                               sketch_.id("force", name_of(external.symbol)),
                                               name_of(external.symbol),
                                               {{"data-name", name_of(external.symbol)}},
                                               external.statement,
                                               held_by(external)});
        draw_arrow(sketch_.arrows, behind ? far : near, behind ? near : far, sketch_.theme.outline, sketch_.theme.text);
        sketch_.arrows.emplace_back(GroupEnd{});
        LabelRequest& label = sketch_.add_label(typeset(external.symbol, sketch_.context.language), sketch_.theme.text,
                                                0.5 * (near + far), 1.2, external.statement);
        label.toward = far;
        label.names = {name_of(external.symbol)};
        label.holds = held_by(external);
    }
    Holds held_by(const Truss::External& external) const {
        return {Holds::Form::with, {point_binding(point_of(truss_, external.pin)), external_binding(external)}};
    }

    /// Inside at the centroid of its pins; outside beside its longest bar, or between the forces at a pin.
    void name_space(const Truss::Space& space) {
        Spot at{0, 0};
        if (!space.outside) {
            for (const int pin : space.pins) at = at + spot(pin);
            at = (1.0 / static_cast<double>(space.pins.size())) * at;
        } else {
            at = outside_spot(space);
        }
        LabelRequest& label = sketch_.add_label(letter_of(space), sketch_.theme.accent, at, 0.3);
        label.size = sketch_.theme.label;
        if (!space.outside) label.balloon = 2.3;
    }
    Spot outside_spot(const Truss::Space& space) const {
        constexpr double away = 6.5;
        Spot best = spot(space.pins.front());
        double longest = 0;
        for (std::size_t i = 0; i + 1 < space.pins.size(); ++i) {
            const Spot from = spot(space.pins[i]), to = spot(space.pins[i + 1]), off = to - from;
            if (length(off) <= longest) continue;
            longest = length(off);
            // Clockwise round the truss the outside is on the left. On paper y is downwards.
            best = 0.5 * (from + to) + (away / longest) * Spot{off.y, -off.x};
        }
        if (longest > 0) return best;
        Spot out{0, 0};
        for (const int bar : truss_.structure.pins[at_index(space.pins.front())].bars) {
            const Spot off = spot(truss_.structure.other_end(bar, space.pins.front())) - best;
            out = out - (1 / length(off)) * off;
        }
        return length(out) > 1e-6 ? best + (1.8 * away / length(out)) * out : best;
    }

    /// The line of the resultant of given forces, and those of the reactions, to or towards their intersection.
    void draw_whole() {
        if (!truss_.whole || truss_.whole->meets.empty()) return;
        const Truss::Whole& whole = *truss_.whole;
        const Box view = grown(sketch_.mechanism_box(), meets_seen * sketch_.size());
        for (const Truss::Whole::Meet& meet : whole.meets) {
            const Spot at = sketch_.spot(*meet.place);
            const bool near = contains(view, at);
            const std::size_t first = sketch_.construction.size();
            for (const Truss::External& external : truss_.externals) {
                if (external.joint == none) continue;
                const Spot pin = spot(external.pin), along = paper_direction(*external.force);
                if (std::abs(cross(along, at - pin)) > 0.05 + 1e-9 * length(at - pin)) continue;
                if (near) {
                    sketch_.construction.emplace_back(line(pin, at + beyond(pin, at), sketch_.axis()));
                    hang(sketch_.construction, sketch_.construction.size() - 1,
                         {Holds::Form::through,
                          {point_binding(point_of(truss_, external.pin)), meet_binding("", meet.name)}});
                } else {
                    point_to(at, external.pin, meet);
                }
            }
            if (near) {
                if (!is_of_strings(meet)) draw_line_of_whole(whole, meet, at);  // strings draw the resultant themselves
                const Holds held{Holds::Form::at, {meet_binding("", meet.name)}};
                sketch_.centres.emplace_back(ring(at, 1.0, sketch_.theme.paper, sketch_.outline()));
                belong(sketch_.centres, sketch_.centres.size() - 1, meet.statement);
                hang(sketch_.centres, sketch_.centres.size() - 1, held);
                LabelRequest& label =
                    sketch_.add_label(typeset(Symbol{Symbol::Letter::point, meet.name, ""}, sketch_.context.language),
                                      sketch_.theme.text, at, 1.8, meet.statement);
                label.names = {meet.name};
                label.holds = held;
            }
            belong(sketch_.construction, first, meet.statement);
        }
    }
    bool is_of_strings(const Truss::Whole::Meet& meet) const {
        return std::any_of(solution_.taken_together.begin(), solution_.taken_together.end(),
                           [&](const TakenTogether& together) {
                               return together.funicular && together.funicular->resultant &&
                                      *together.funicular->resultant == *meet.place;
                           });
    }
    /// Culmann's line, which joins two intersections, with the force along it.
    void draw_line_of_meets(const AppliedForce& sum, const std::string& held) {
        if (!truss_.whole) return;
        constexpr double size = 14;
        const Spot at = sketch_.spot(sum.at), along = paper_direction(sum.force);
        std::vector<Spot> on;
        for (const Truss::Whole::Meet& meet : truss_.whole->meets)
            if (const Spot spot = sketch_.spot(*meet.place);
                std::abs(cross(along, spot - at)) < 0.05 + 1e-9 * length(spot - at))
                on.push_back(spot);
        if (on.size() < 2) return;
        const Box view = grown(sketch_.mechanism_box(), meets_seen * sketch_.size());
        const std::size_t first = sketch_.construction.size();
        for (const bool turned_round : {false, true}) {
            const Spot from = turned_round ? on[1] : on[0], to = turned_round ? on[0] : on[1];
            if (!contains(view, from)) continue;
            const Spot off = (1 / length(to - from)) * (to - from);
            const double reach = contains(view, to) ? length(to - from) : 2 * size;
            sketch_.construction.emplace_back(line(from - 6.0 * off, from + reach * off, sketch_.axis()));
        }
        hang(sketch_.construction, first, along_force(held));
        const Spot tail = at + 2.0 * along;
        draw_double_arrow(sketch_.construction, tail, tail + size * along, sketch_.theme.outline, sketch_.theme.text);
        hang(sketch_.construction, first, with_force(held));
        belong(sketch_.construction, first, sum.force_statement);
        LabelRequest& label = sketch_.add_label(typeset(sum.symbol, sketch_.context.language), sketch_.theme.text,
                                                tail + 0.5 * size * along, 1.2, sum.force_statement);
        label.toward = tail + size * along;
        label.names = {name_of(sum.symbol)};
        label.holds = with_force(held);
    }
    static Holds with_force(const std::string& held) { return {Holds::Form::with, {held, held}}; }
    /// The visible part of its line of action.
    static Holds along_force(const std::string& held) { return {Holds::Form::through, {held, held}}; }
    void draw_line_of_whole(const Truss::Whole& whole, const Truss::Whole::Meet& meet, Spot at) {
        constexpr double half = 16;
        const Spot through = sketch_.spot(*whole.through), along = paper_direction(*whole.force);
        if (std::abs(cross(along, at - through)) > 0.05) return;
        const Holds held{Holds::Form::with, {meet_binding("", meet.name), whole_binding()}};
        const std::size_t first = sketch_.construction.size();
        sketch_.construction.emplace_back(line(at - half * along, at + half * along, sketch_.axis()));
        const auto loads = std::count_if(truss_.externals.begin(), truss_.externals.end(),
                                         [](const Truss::External& external) { return external.joint == none; });
        const Spot tail = at - half * along, tip = at - 2.0 * along;
        if (loads < 2)  // a single load has its own letter
            draw_arrow(sketch_.construction, tail, tip, sketch_.theme.outline, sketch_.theme.secondary);
        else
            draw_double_arrow(sketch_.construction, tail, tip, sketch_.theme.outline, sketch_.theme.text);
        hang(sketch_.construction, first, held);
        if (loads < 2) return;
        LabelRequest& label = sketch_.add_label(typeset(Symbol{Symbol::Letter::F, "R", {}}, sketch_.context.language),
                                                sketch_.theme.text, at - 0.5 * half * along, 1.2, whole.statement);
        label.toward = at;
        label.names = {"F_R"};
        label.holds = held;
    }
    /// For an intersection outside the drawing: an arrow from a pin towards it, with the distance.
    void point_to(Spot meet, int of, const Truss::Whole::Meet& named) {
        constexpr double off = 6, size = 16;
        const Spot pin = spot(of);
        const std::string from_pin = point_binding(point_of(truss_, of));
        const Holds held{Holds::Form::with, {from_pin, from_pin, meet_binding("", named.name)}};
        const double away = length(meet - pin);
        if (!std::isfinite(away)) return;  // out of the range of doubles
        const Spot along = (1 / away) * (meet - pin), tip = pin + (off + size) * along;
        draw_arrow(sketch_.construction, pin + off * along, tip, sketch_.theme.thin, sketch_.theme.secondary);
        hang(sketch_.construction, sketch_.construction.size() - 2, held);
        RichText text = typeset(Symbol{Symbol::Letter::point, named.name, ""}, sketch_.context.language);
        if (const auto from = name_of_point_at(sketch_, pin)) append(text, how_far(sketch_, *from, text, away));
        LabelRequest& label = sketch_.add_label(std::move(text), sketch_.theme.text, tip, 1.2, named.statement);
        label.names = {named.name};
        label.holds = held;
    }
    /// Over the truss, each string between the lines of two forces; the resultant at the intersection of the outer
    /// ones.
    void draw_strings_of(const FreeBody::Funicular& funicular, const std::vector<AppliedForce>& sums,
                         std::size_t group) {
        draw_strings(sketch_, funicular);
        const auto lead_to = [&](int of, Spot along, std::size_t vertex) {
            const Spot pin = spot(of), at = sketch_.spot(*funicular.vertices[vertex]);
            if (std::abs(cross(along, at - pin)) > 0.05 || length(at - pin) < 1) return;
            sketch_.construction.emplace_back(line(pin, at + beyond(pin, at), sketch_.axis()));
            belong(sketch_.construction, sketch_.construction.size() - 1, funicular.statement);
            hang(sketch_.construction, sketch_.construction.size() - 1,
                 {Holds::Form::segment,
                  {point_binding(point_of(truss_, of)), string_binding("", funicular, vertex)},
                  6});
        };
        for (const Truss::External& external : truss_.externals)
            for (std::size_t vertex = 0; vertex < funicular.vertices.size(); ++vertex)
                lead_to(external.pin, paper_direction(*external.force), vertex);
        for (const AppliedForce& sum : sums) draw_resultant(sum, sum_binding("", group, sum));
    }
    void draw_resultant(const AppliedForce& sum, const std::string& held) {
        constexpr double size = 14;
        const Spot at = sketch_.spot(sum.at), along = paper_direction(sum.force);
        if (!contains(grown(sketch_.mechanism_box(), 0.6 * sketch_.size()), at)) return;
        const std::size_t first = sketch_.construction.size();
        draw_double_arrow(sketch_.construction, at, at + size * along, sketch_.theme.outline, sketch_.theme.text);
        hang(sketch_.construction, first, with_force(held));
        belong(sketch_.construction, first, sum.force_statement);
        LabelRequest& label = sketch_.add_label(typeset(sum.symbol, sketch_.context.language), sketch_.theme.text,
                                                at + 0.5 * size * along, 1.2, sum.force_statement);
        label.toward = at + size * along;
        label.names = {name_of(sum.symbol)};
        label.holds = with_force(held);
    }
    static Spot beyond(Spot from, Spot to) {
        const Spot off = to - from;
        return length(off) > 0 ? (6 / length(off)) * off : off;
    }

    Sketch& sketch_;
    const Solution& solution_;
    const Truss& truss_;
    std::map<int, std::vector<Spot>> rays_;  // directions of the forces drawn, by pin
};

// --- force plan

class Plan {
public:
    explicit Plan(const DrawingContext& context)
        : context_(context),
          solution_(context.solution),
          truss_(*solution_.truss),
          scene_(polygon_scene(solution_, truss_.polygon)) {}

    double width() const { return scene_.width(); }
    double height() const { return scene_.height(); }

    Figure at(double scale) const {
        Figure figure = begun(context_, {FigureKind::force_plan});
        figure.scale = scale;
        figure.unit = scene_.unit.symbol;
        figure.marks.emplace_back(group_of(figure));
        draw_bars(figure);
        draw_outer(figure);
        name_corners(figure);
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    static Spot spot(double scale, Place p) { return {p.x / scale, -p.y / scale}; }
    const Polygon& polygon() const { return solution_.protocol.polygons[at_index(truss_.polygon)]; }
    Place place(ElementIndex element) const {
        const ProjectivePoint& point = solution_.protocol.point(element);
        return {(point.x / scene_.unit.si).to_double(), (point.y / scene_.unit.si).to_double()};
    }
    std::size_t bar_of(BodyIndex body) const {
        const auto& bars = truss_.structure.bars;
        const auto found = std::find_if(bars.begin(), bars.end(), [&](const auto& bar) { return bar.body == body; });
        KG_ASSERT(found != bars.end(), "a side of the plan is a bar's");
        return static_cast<std::size_t>(found - bars.begin());
    }
    static bool is_bar(const DrawnVector& vector) { return vector.quantity.kind == Quantity::Kind::bar; }

    void draw_bars(Figure& figure) const {
        for (const int v : polygon().vectors) {
            const DrawnVector& vector = solution_.protocol.vectors[at_index(v)];
            if (!is_bar(vector) || vector.vanishes) continue;
            const Spot tail = spot(figure.scale, place(vector.tail)), tip = spot(figure.scale, place(vector.tip));
            const std::size_t bar = bar_of(vector.quantity.body);
            const std::string name = name_of(vector.symbol);
            const double value = tension_of(solution_, bar) / scene_.unit.si.to_double();
            figure.marks.emplace_back(GroupBegin{"vector",
                                                 GroupId("cremona", legal_id(name)),
                                                 name,
                                                 {{"data-name", name}, {"data-value", shortest(value)}},
                                                 vector.statement});
            figure.marks.emplace_back(Axis{tail, tip});
            Path stroke = line(tail, tip, thin_pen_of(context_.theme, sense_of(solution_, bar)));
            const auto pin = [&](std::size_t end) {
                return point_binding(point_of(truss_, truss_.structure.bars[bar].pins[end]));
            };
            stroke.holds = {Holds::Form::segment, {pin(0), pin(1), bar_binding(truss_, bar)}};
            figure.marks.emplace_back(std::move(stroke));
            figure.marks.emplace_back(GroupEnd{});
            figure.axes.push_back({name, tail, tip, {}});
        }
    }
    /// Parallel external forces would overlap: each is moved to the first free column.
    void draw_outer(Figure& figure) const {
        struct Column {
            Spot along, at;
            std::vector<std::vector<Interval>> taken;
        };
        std::vector<Column> columns;
        const Spot middle =
            spot(figure.scale, {0.5 * (scene_.least.x + scene_.most.x), 0.5 * (scene_.least.y + scene_.most.y)});
        for (const int v : polygon().vectors) {
            const DrawnVector& vector = solution_.protocol.vectors[at_index(v)];
            if (is_bar(vector) || vector.vanishes) continue;
            const Spot tail = spot(figure.scale, place(vector.tail)), tip = spot(figure.scale, place(vector.tip)),
                       off = tip - tail;
            if (length(off) < 1e-6) continue;
            const Spot unit = (1 / length(off)) * off;
            auto column = std::find_if(columns.begin(), columns.end(), [&](const Column& each) {
                return std::abs(cross(each.along, unit)) < 1e-6 && std::abs(cross(each.along, tail - each.at)) < 0.05;
            });
            if (column == columns.end()) column = columns.insert(column, {unit, tail, {}});
            const double a = dot(tail - column->at, column->along), b = dot(tip - column->at, column->along);
            const Interval own{std::min(a, b), std::max(a, b)};
            std::size_t place_in = 0;
            const auto is_free = [&](const std::vector<Interval>& taken) {
                return std::none_of(taken.begin(), taken.end(), [&](const Interval& each) {
                    return each.from < own.to - 0.05 && each.to > own.from + 0.05;
                });
            };
            while (place_in < column->taken.size() && !is_free(column->taken[place_in])) ++place_in;
            if (place_in == column->taken.size()) column->taken.emplace_back();
            column->taken[place_in].push_back(own);
            constexpr double pitch = 3.6;
            Spot side = turned(column->along);
            if (dot(side, middle - column->at) > 0) side = -1.0 * side;
            draw_side(figure, vector, tail, tip, (pitch * static_cast<double>(place_in)) * side, side);
        }
    }
    void draw_side(Figure& figure, const DrawnVector& vector, Spot tail, Spot tip, Spot aside, Spot side) const {
        const std::string name = name_of(vector.symbol);
        if (length(aside) > 0)
            for (const Spot end : {tail, tip}) {
                figure.marks.emplace_back(
                    line(end, end + aside, {context_.theme.thin, context_.theme.secondary, {}, false}));
                belong(figure.marks, figure.marks.size() - 1, vector.statement);
            }
        figure.marks.emplace_back(
            GroupBegin{"vector",
                       GroupId("cremona", legal_id(name)),
                       name,
                       {{"data-name", name},
                        {"data-value", shortest(solution_.protocol.modulus_of(vector) / scene_.unit.si.to_double())}},
                       vector.statement});
        figure.marks.emplace_back(Axis{tail + aside, tip + aside});
        draw_arrow(figure.marks, tail + aside, tip + aside, context_.theme.vector, context_.theme.text);
        figure.marks.emplace_back(GroupEnd{});
        figure.axes.push_back({name, tail, tip, {}});
        LabelRequest label;
        label.text = typeset(vector.symbol, context_.language);
        label.size = context_.theme.label;
        label.colour = context_.theme.text;
        label.anchor = 0.5 * (tail + tip) + aside + 0.01 * side;
        label.toward = tip + aside;
        label.clearance = 1.2;
        label.statement = vector.statement;
        label.names = {name};
        figure.labels.push_back(std::move(label));
    }
    /// Spaces on both sides of an unloaded bar share a corner.
    void name_corners(Figure& figure) const {
        struct Corner {
            Spot at;
            RichText text;
            StatementIndex statement = none;
        };
        std::vector<Corner> corners;
        for (std::size_t s = 0; s < truss_.spaces.size(); ++s) {
            const Image& image = solution_.protocol.images[at_index(polygon().images[s])];
            const Spot at = spot(figure.scale, place(image.point));
            auto known = std::find_if(corners.begin(), corners.end(),
                                      [&](const Corner& each) { return length(each.at - at) < 0.02; });
            if (known == corners.end()) {
                corners.push_back({at, letter_of(truss_.spaces[s]), statement_of(image.point)});
                continue;
            }
            append(known->text, one_piece(", "));
            append(known->text, letter_of(truss_.spaces[s]));
        }
        for (Corner& corner : corners) {
            figure.marks.emplace_back(disc(corner.at, 0.55, context_.theme.text));
            belong(figure.marks, figure.marks.size() - 1, corner.statement);
            LabelRequest label;
            label.text = std::move(corner.text);
            label.size = context_.theme.label;
            label.colour = context_.theme.accent;
            label.anchor = corner.at;
            label.clearance = 1.2;
            label.statement = corner.statement;
            figure.labels.push_back(std::move(label));
        }
    }
    /// The first side that ends there.
    StatementIndex statement_of(ElementIndex corner) const {
        StatementIndex first = none;
        for (const int v : polygon().vectors) {
            const DrawnVector& vector = solution_.protocol.vectors[at_index(v)];
            if (vector.tail != corner && vector.tip != corner) continue;
            if (first == none || vector.statement < first) first = vector.statement;
        }
        return first;
    }

    const DrawingContext& context_;
    const Solution& solution_;
    const Truss& truss_;
    PolygonScene scene_;
};

}  // namespace

namespace {

Box extent_of_truss(const Solution& solution) {
    const Subject subject(solution);
    Box extent = subject.box;
    for (const TakenTogether& together : solution.taken_together)
        if (together.funicular) include_strings(extent, *together.funicular, grown(subject.box, 0.6 * subject.size()));
    if (solution.truss->whole)
        for (const Truss::Whole::Meet& meet : solution.truss->whole->meets)
            if (const Spot at = paper_spot(*meet.place); contains(grown(subject.box, meets_seen * subject.size()), at))
                extent.include(at);
    return extent;
}

}  // namespace

std::array<Pen, 3> pens_of_bars(const Theme& theme) {
    return {pen_of(theme, Sense::compression), pen_of(theme, Sense::idle), pen_of(theme, Sense::tension)};
}

Figure truss_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    const Subject subject(context.solution);
    const Box extent = extent_of_truss(context.solution);
    const double first = choose_scale(extent.width(), extent.height(), std::max(room_x - 30, 10.0),
                                      std::max(room_y - 40, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, "truss");
        SpaceDiagram(sketch).draw();
        name_points(sketch);
        Figure figure = sketch.finish(begun(context, {FigureKind::truss}), "m");
        if (!context.solution.truss->externals.empty())
            figure.further_scale = word(lang::sheet::arrows_not_to_scale, context.language);
        const SenseKey key(context, 1);
        sketch.close(figure, {room_x, room_y - key.height()}, trial.last, trial.scale, subject.mechanism.units.length,
                     trial.strict);
        if (!std::holds_alternative<GroupEnd>(figure.marks.back())) return figure;  // too large: nothing was placed
        figure.marks.pop_back();
        key.set(figure);
        figure.marks.emplace_back(GroupEnd{});
        return figure;
    });
}

Figure cremona_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    const Plan plan(context);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = first_scale({plan.width(), plan.height()}, {room_x, room_y}, wish.finest),
                           .asked = wish.asked,
                           .most_trials = 14};
    return fit(policy, [&](const Trial& trial) -> std::optional<Figure> {
        Figure figure = plan.at(trial.scale);
        const SenseKey key(context, in_plan);
        const double below = 8 + key.height();
        if (!trial.last && !trial.asked && (figure.box.width() > room_x || figure.box.height() > room_y - below))
            return std::nullopt;
        place_labels(figure, context.fonts, Spot{room_x, room_y - below});
        std::vector<Mark> bar;
        draw_scale_bar(bar, context.fonts, context.theme, {0, 0}, 24, figure.scale, 1, figure.unit, context.language);
        const Box size = box_of(bar);
        render::move(bar, figure.box.min.x - size.min.x, figure.box.max.y + 3 - size.min.y);
        figure.marks.insert(figure.marks.end(), bar.begin(), bar.end());
        figure.box = box_of(figure.marks);
        key.set(figure);
        figure.marks.emplace_back(GroupEnd{});
        return figure;
    });
}

namespace {

std::vector<int> has_truss(const Shown& shown, const LoadCase& /*all*/) {
    return once(shown.solution().truss != std::nullopt);
}
void measure_truss(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_mechanism(shown, id, size);
    const double bars = size.extent();
    size.take(extent_of_truss(shown.solution()));
    // The bars; strings run between their letters, too.
    constexpr double least_of_bars = 48, nothing = 1e-30;
    size.least = least_of_bars * size.extent() / std::max(bars, nothing);
    size.weight = 3;  // it leads: its polygons are read with it
}
Figure draw_truss(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return truss_figure(shown.context, room.x, room.y, wish);
}

std::vector<int> has_force_plan(const Shown& shown, const LoadCase& /*all*/) {
    return once(has_plan(shown.solution()));
}
void measure_force_plan(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    const PolygonScene scene = polygon_scene(shown.solution(), shown.solution().truss->polygon);
    size.extent_x = scene.width();
    size.extent_y = scene.height();
}
Figure draw_force_plan(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return cremona_figure(shown.context, room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions truss_functions{has_truss, measure_truss, draw_truss};
constinit const FigureFunctions force_plan_functions{has_force_plan, measure_force_plan, draw_force_plan};

}  // namespace kinegraph::render
