// Output of the recipes of motion: sentences, vectors and lines. How much is drawn depends on who draws: the solution,
// a trial, or a nested trial.
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "constructions/kinematics/chains.hpp"
#include "constructions/kinematics/polygon_pen.hpp"

namespace kinegraph::recipes {

inline std::size_t at(auto index) { return at_index(index); }

class RecipePen {
public:
    /// For whom is drawn: the solution itself, one of the two trials of an assumption, or a nested trial, which leaves
    /// no mark.
    enum class Hand { solution, first_trial, second_trial, silent };

    RecipePen(Chains& chains, Board& board) : chains_(chains), board_(board) {}

    Hand hand() const { return hand_; }
    void take(Hand hand) { hand_ = hand; }

    BodyName body(BodyIndex index) const { return {chains_.structure().body_name(index)}; }
    template <Plane plane>
    Symbol spin_of(BodyIndex index) const {
        return spin_symbol<plane>(chains_.structure().body_name(index));
    }
    template <Plane plane>
    Symbol image(NodeIndex index) const {
        return image_symbol<plane>(chains_.node(index).label);
    }
    template <Plane plane>
    StatementIndex begin(Key sentence, std::vector<Argument> arguments, std::string source) {
        if (hand_ != Hand::solution) return none;
        return state<plane>(board_, sentence, std::move(arguments), std::move(source));
    }
    /// A sentence whose result is the ω or α of a body.
    template <Plane plane>
    StatementIndex begin_spin(BodyIndex found, Key sentence, std::vector<Argument> arguments, std::string source) {
        const StatementIndex statement = begin<plane>(sentence, std::move(arguments), std::move(source));
        if (found != none) said(statement).finds = {spin_quantity<plane>(found)};
        return statement;
    }
    /// The sentence begun, to complete it. In a trial returns a dummy, which is not shown.
    Statement& said(StatementIndex statement) { return statement == none ? unsaid_ : board_.statement(statement); }
    int trial() const { return hand_ == Hand::first_trial ? 1 : hand_ == Hand::second_trial ? 2 : 0; }
    template <Plane plane>
    PolygonPen<plane> pen(const Track<plane>& track) {
        return {board_, track.polygon, trial()};
    }
    template <Plane plane>
    void draw_vector(const Track<plane>& track, Symbol symbol, const Seen& seen, PointOn<plane> tail,
                     PointOn<plane> tip, BodyIndex body_of, DrawnVector::Role role) {
        if (hand_ == Hand::solution) relative_[is_velocity<plane> ? 0 : 1].insert({seen.of.place, seen.to.place});
        if (hand_ != Hand::silent) pen(track).vector(std::move(symbol), seen, tail, tip, body_of, role);
    }
    /// Whether the velocity, the acceleration or a part of it of one place relative to another is drawn.
    template <Plane plane>
    bool is_drawn(NodeIndex of, NodeIndex to) {
        return relative_[is_velocity<plane> ? 0 : 1].contains({chains_.place(of).element, chains_.place(to).element});
    }
    template <Plane plane>
    bool drawn_between(NodeIndex one, NodeIndex other) {
        return is_drawn<plane>(one, other) || is_drawn<plane>(other, one);
    }
    /// A place with zero velocity at this instant: the contact with a body at rest on which its own body rolls.
    void remember_still(NodeIndex place) { still_.insert(place); }
    bool stands_still(NodeIndex place) const { return still_.contains(place); }
    template <Plane plane>
    void draw_line(const Track<plane>& track, LineOn<plane> line, LineReason reason, std::vector<ElementIndex> points) {
        if (hand_ != Hand::silent) pen(track).line(line, std::move(reason), std::move(points));
    }
    template <Plane plane>
    void set_tip(Track<plane>& track, NodeIndex index, PointOn<plane> tip, bool draw_absolute) {
        track.tips.resize(chains_.structure().nodes().size());
        track.tips[at(index)] = tip;
        // Places of the frame used only as intermediate steps would crowd the pole.
        const bool only_a_step =
            chains_.at_rest(index) && !chains_.node(index).carried && !chains_.node(index).of_interest;
        if (hand_ == Hand::silent || only_a_step) return;
        pen(track).image(image<plane>(index), tip, chains_.colour_of(index));
        if (draw_absolute) {
            draw_vector(track, chains_.absolute<plane>(index), chains_.seen(index), board_.pole<plane>(), tip,
                        chains_.colour_of(index), DrawnVector::Role::absolute);
        }
    }
    /// Name of a joint for readers: its point, which the drawing shows; else its own name.
    PointName place_of(const Joint& joint) const {
        return {joint.point != none ? chains_.mechanism().points[at(joint.point)].name : joint.name};
    }
    template <Plane plane>
    void remember_tangential(Track<plane>& track, const Locus& locus, const Chain<plane>& drawn, PointOn<plane> met) {
        if (locus.kind == Locus::Kind::rotation && locus.carries.empty())
            track.tangential[{locus.base, locus.node}] = board_.vector(drawn.end, met);
    }
    template <Plane plane>
    void draw_chain(const Track<plane>& track, const Chain<plane>& drawn, PointOn<plane> met, BodyIndex colour) {
        PointOn<plane> here = drawn.start;
        for (const Link<plane>& link : drawn.known) {
            const PointOn<plane> next = chains_.set_off(drawn, link, here);
            const bool backwards = chains_.is_backwards(drawn.inverse, link.shift);
            draw_vector(track, link.term.symbol, link.seen, backwards ? next : here, backwards ? here : next,
                        link.term.body == none ? colour : link.term.body, link.role);
            here = next;
        }
        const BodyIndex sought_colour = drawn.sought.body == none ? colour : drawn.sought.body;
        if (drawn.inverse) {
            draw_vector(track, drawn.sought.symbol, drawn.seen, met, drawn.end, sought_colour, drawn.role);
        } else {
            draw_vector(track, drawn.sought.symbol, drawn.seen, drawn.end, met, sought_colour, drawn.role);
        }
    }

private:
    Chains& chains_;
    Board& board_;
    Hand hand_ = Hand::solution;
    Statement unsaid_;
    std::set<NodeIndex> still_;
    std::array<std::set<std::pair<ElementIndex, ElementIndex>>, 2>
        relative_;  ///< pairs of places with a drawn relative velocity [0] or acceleration [1]
};

}  // namespace kinegraph::recipes
