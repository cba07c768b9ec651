// The graph of the joints: the bodies as nodes on a circle, in the order in which the fewest lines cross; a line with a
// symbol for each joint. A multiple hinge, or a pin with a load, is a node of its own inside. Driven joints are filled.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/mechanism/chain.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure_table.hpp"
#include "render/page/labels.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double node_radius = 3.2;    // of a body, mm
constexpr double symbol_radius = 1.3;  // of a joint, mm

/// A joint between two nodes: bodies, or a body and the pin of a multiple hinge.
struct GraphLine {
    JointIndex joint;
    std::size_t from = 0, to = 0;
    double aside = 0;  ///< of its middle, to part it from other joints of the same bodies, mm
};

/// The order of bodies round the circle; the frame keeps its place. Crossings count more than length.
class CircularOrder {
public:
    explicit CircularOrder(const Mechanism& mechanism) : place_(mechanism.bodies.size()) {
        std::iota(place_.begin(), place_.end(), std::size_t{0});
        for (const Joint& joint : mechanism.joints)
            for (std::size_t i = 1; i < joint.bodies.size(); ++i)
                chords_.emplace_back(at_index(joint.bodies.front()), at_index(joint.bodies[i]));
        // Exchanges two bodies as long as this helps.
        for (bool better = true; better;) {
            better = false;
            for (std::size_t a = 1; a < place_.size(); ++a)
                for (std::size_t b = a + 1; b < place_.size(); ++b) better = exchange(a, b) || better;
        }
    }
    /// By body.
    const std::vector<std::size_t>& places() const { return place_; }

private:
    bool exchange(std::size_t a, std::size_t b) {
        const std::size_t before = price();
        std::swap(place_[a], place_[b]);
        if (price() < before) return true;
        std::swap(place_[a], place_[b]);
        return false;
    }
    std::size_t price() const {
        constexpr std::size_t of_crossing = 1000;
        std::size_t sum = 0;
        for (std::size_t i = 0; i < chords_.size(); ++i) {
            const auto chord = ends(chords_[i]);
            const std::size_t from = chord.first, to = chord.second;
            sum += std::min(to - from, place_.size() - (to - from));
            for (std::size_t k = 0; k < i; ++k) {
                const auto [other_from, other_to] = ends(chords_[k]);
                const auto is_inside = [&](std::size_t end) { return end > from && end < to; };
                const auto is_outside = [&](std::size_t end) { return end < from || end > to; };
                if ((is_inside(other_from) && is_outside(other_to)) || (is_outside(other_from) && is_inside(other_to)))
                    sum += of_crossing;
            }
        }
        return sum;
    }
    std::pair<std::size_t, std::size_t> ends(const std::pair<std::size_t, std::size_t>& chord) const {
        return std::minmax(place_[chord.first], place_[chord.second]);
    }

    std::vector<std::size_t> place_;
    std::vector<std::pair<std::size_t, std::size_t>> chords_;
};

class JointGraph {
public:
    explicit JointGraph(const DrawingContext& context)
        : context_(context), theme_(context.theme), mechanism_(context.solution.mechanism) {
        place_bodies();
        for (const Joint& joint : mechanism_.joints) add(joint);
        part_parallels();
        clear_pins();
    }

    Figure figure() const {
        Figure figure = begun(context_, {FigureKind::joint_graph});
        figure.unit = "mm";
        figure.has_scale = false;
        append(figure.caption,
               one_piece(word(lang::notation::semicolon, context_.language) +
                         word(lang::sheet::independent_loops, context_.language) +
                         word(lang::notation::colon, context_.language) + std::to_string(chain_of(mechanism_).loops)));
        figure.marks.emplace_back(group_of(figure, false));
        for (const GraphLine& each : lines_) draw_line(figure.marks, each);
        for (const GraphLine& each : lines_)
            if (is_body(each.to))
                draw_symbol(figure, each.joint, middle(each), unit(nodes_[each.to] - nodes_[each.from]));
        for (std::size_t i = mechanism_.bodies.size(); i < nodes_.size(); ++i)
            draw_symbol(figure, pins_[i - mechanism_.bodies.size()], nodes_[i], {1, 0});
        for (const BodyIndex body : indices_of(mechanism_.bodies)) draw_body(figure.marks, body);
        figure.marks.emplace_back(GroupEnd{});
        figure.box = box_of(figure.marks);
        return figure;
    }

private:
    bool is_body(std::size_t end) const { return end < mechanism_.bodies.size(); }
    /// The frame stands below, the others clockwise.
    void place_bodies() {
        const std::size_t count = mechanism_.bodies.size();
        constexpr double of_each = 9.5, least = 17, most = 60;
        const double radius = std::clamp(of_each * static_cast<double>(count) / 2, least, most);
        const CircularOrder order(mechanism_);
        for (const std::size_t place : order.places()) {
            const double turn =
                std::numbers::pi / 2 + 2 * std::numbers::pi * static_cast<double>(place) / static_cast<double>(count);
            nodes_.push_back({radius * nearest::cos(turn), radius * nearest::sin(turn)});
        }
    }
    void add(const Joint& joint) {
        const JointIndex index = mechanism_.index_of(joint);
        if (joint.bodies.size() == 2) {
            lines_.push_back({index, at_index(joint.bodies[0]), at_index(joint.bodies[1])});
            return;
        }
        Spot sum{0, 0};
        for (const BodyIndex body : joint.bodies) {
            lines_.push_back({index, at_index(body), nodes_.size()});
            sum = sum + nodes_[at_index(body)];
        }
        pins_.push_back(index);
        nodes_.push_back((0.9 / static_cast<double>(joint.bodies.size())) * sum);
    }
    void part_parallels() {
        constexpr double apart = 9;
        for (GraphLine& each : lines_) {
            double before = 0, all = 0;
            for (const GraphLine& other : lines_) {
                if (std::minmax(other.from, other.to) != std::minmax(each.from, each.to)) continue;
                if (&other < &each) ++before;
                ++all;
            }
            each.aside = (each.from < each.to ? 1 : -1) * apart * (before - (all - 1) / 2);
        }
    }

    /// Moves pins away from the lines of other joints.
    void clear_pins() {
        constexpr double clear = 4;
        constexpr Spot steps[]{{0, 0}, {6, 0}, {-6, 0}, {0, -6}, {0, 6}, {9, -6}, {-9, -6}, {9, 6}, {-9, 6}};
        for (std::size_t i = mechanism_.bodies.size(); i < nodes_.size(); ++i) {
            const Spot middle = nodes_[i];
            const auto is_clear = [&](Spot at) {
                return std::all_of(lines_.begin(), lines_.end(), [&](const GraphLine& each) {
                    return each.to == i || distance_to_segment(at, nodes_[each.from], nodes_[each.to]) > clear;
                });
            };
            for (const Spot step : steps)
                if (is_clear(middle + step)) {
                    nodes_[i] = middle + step;
                    break;
                }
        }
    }

    Spot across(const GraphLine& each) const {
        const Spot along = unit(nodes_[each.to] - nodes_[each.from]);
        return {-along.y, along.x};
    }
    Spot middle(const GraphLine& each) const {
        return 0.5 * (nodes_[each.from] + nodes_[each.to]) + each.aside * across(each);
    }
    /// Dashed: a pair with two freedoms.
    void draw_line(std::vector<Mark>& marks, const GraphLine& each) const {
        const Spot from = nodes_[each.from], to = nodes_[each.to];
        // A curve through the middle of the joint.
        const Spot control = (4.0 / 3) * each.aside * across(each);
        Path path;
        path.segments = {MoveTo{from},
                         CurveTo{from + (1.0 / 3) * (to - from) + control, to - (1.0 / 3) * (to - from) + control, to}};
        path.stroked = true;
        path.pen = {theme_.outline, theme_.text,
                    mechanism_.joint(each.joint).pair().freedoms() > 1 ? dashes() : std::vector<double>{}, false};
        marks.emplace_back(std::move(path));
    }

    /// "-2" of the second joint with the same name; nothing of the first.
    std::string number_of(JointIndex index) const {
        const std::string& name = mechanism_.joint(index).name;
        const auto own = mechanism_.joints.begin() + static_cast<std::ptrdiff_t>(at_index(index));
        const auto before =
            std::count_if(mechanism_.joints.begin(), own, [&](const Joint& each) { return each.name == name; });
        return before == 0 ? "" : "-" + std::to_string(before + 1);
    }

    /// A ring: the bodies turn on each other. A block: one slides along the other, or is clamped to it (crossed).
    void draw_symbol(Figure& figure, JointIndex index, Spot at, Spot along) const {
        const Joint& joint = mechanism_.joint(index);
        const PlanePair& pair = joint.pair();
        const Pen pen{theme_.outline, theme_.text, {}, false};
        const Colour fill = is_driven(index) ? theme_.text : theme_.paper;
        const Spot across{-along.y, along.x};
        std::vector<Mark>& marks = figure.marks;
        marks.emplace_back(GroupBegin{"joint", id_in(figure, legal_id(joint.name) + number_of(index)), joint.name, {}});
        if (pair.has_guide() || pair.is_clamp()) {
            constexpr double longer = 1.7;
            const std::vector<Spot> corners = corners_about(at, longer * symbol_radius * along, symbol_radius * across);
            marks.emplace_back(tinted(filled(corners, fill)));
            marks.emplace_back(polyline(corners, pen, true));
            if (pair.is_clamp())
                for (const std::size_t corner : {0U, 1U})
                    marks.emplace_back(line(corners[corner], corners[corner + 2], pen));
            if (pair.is_slot()) marks.emplace_back(ring(at, 0.6 * symbol_radius, theme_.paper, pen));
        } else if (pair.touches()) {
            // Two profiles that touch.
            for (const double side : {-1.0, 1.0})
                marks.emplace_back(ring(at + side * symbol_radius * along, symbol_radius, fill, pen));
        } else {
            marks.emplace_back(ring(at, symbol_radius, fill, pen));
        }
        marks.emplace_back(GroupEnd{});
        figure.labels.push_back({.text = typeset(Symbol{Symbol::Letter::point, joint.name, ""}, context_.language),
                                 .size = theme_.derived,
                                 .colour = theme_.text,
                                 .anchor = at,
                                 .clearance = 2 * symbol_radius + 0.4,
                                 .in_file = joint.name});
    }
    bool is_driven(JointIndex index) const {
        const Joint& joint = mechanism_.joint(index);
        return std::any_of(mechanism_.drivers.begin(), mechanism_.drivers.end(), [&](const Driver& driver) {
            if (const auto* slide = std::get_if<SlideDriver>(&driver)) return slide->joint == index;
            const auto* spin = std::get_if<SpinDriver>(&driver);
            return spin != nullptr && joint.pair().is_hinge() && joint.connects(spin->body) &&
                   joint.connects(spin->relative_to);
        });
    }

    void draw_body(std::vector<Mark>& marks, BodyIndex body) const {
        const Spot at = nodes_[at_index(body)];
        const BodyColour colour = theme_.colour_of(body);
        marks.emplace_back(ring(at, node_radius, theme_.paper, {2 * theme_.outline, colour.line, {}, false}));
        if (body == frame) draw_ground(marks, at + Spot{0, node_radius});
        const ShapedLine name = context_.fonts.shape(one_piece(mechanism_.body(body).name), theme_.label);
        Spot middle = at;
        // A long name stands outside its circle.
        if (nearest::hypot(name.width / 2, name.ascent / 2) > node_radius - 0.6) {
            const Spot out = unit(at);
            marks.emplace_back(disc(at, 0.8, colour.line));
            const double below = body == frame ? 2.4 : 0;
            middle =
                at +
                (node_radius + 1 + below + std::abs(out.x) * name.width / 2 + std::abs(out.y) * name.ascent / 2) * out;
        }
        set_text(marks, name, middle + Spot{-name.width / 2, (name.ascent - name.descent) / 2}, colour.letter, "label");
    }
    void draw_ground(std::vector<Mark>& marks, Spot at) const {
        constexpr double half = 3.5, step = 1.4, high = 1.4;
        const Pen thin{theme_.thin, theme_.text, {}, false};
        marks.emplace_back(line(at - Spot{half, 0}, at + Spot{half, 0}, {theme_.outline, theme_.text, {}, false}));
        for (double x = -half + step; x <= half + 1e-9; x += step)
            marks.emplace_back(line(at + Spot{x, 0}, at + Spot{x - high, high}, thin));
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const Mechanism& mechanism_;
    std::vector<Spot> nodes_;  // of bodies, then of pins
    std::vector<JointIndex> pins_;
    std::vector<GraphLine> lines_;
};

/// More bodies could not be told apart; a single one has no joints, and of a truss they say nothing.
std::vector<int> has_joint_graph(const Shown& shown, const LoadCase& /*all*/) {
    constexpr std::size_t fewest = 3, most = 24;
    const std::size_t bodies = shown.solution().mechanism.bodies.size();
    return once(bodies >= fewest && bodies <= most && !shown.solution().instantaneous_motion &&
                !shown.solution().truss);
}
void measure_joint_graph(const Shown& /*any*/, FigureId /*one*/, SizeWanted& size) {
    size.extent_x = size.extent_y = 60;
}
Figure draw_joint_graph(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& /*none*/) {
    Figure figure = JointGraph(shown.context).figure();
    place_labels(figure, shown.context.fonts, room, Labelling::free, shown.context.theme.secondary);
    figure.move(-figure.box.min.x, -figure.box.min.y);
    return figure;
}

}  // namespace

constinit const FigureFunctions joint_graph_functions{has_joint_graph, measure_joint_graph, draw_joint_graph};

}  // namespace kinegraph::render
