#include "constructions/forces.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "constructions/equilibria.hpp"
#include "constructions/force_model.hpp"
#include "constructions/free_bodies.hpp"
#include "constructions/loose_bodies.hpp"
#include "constructions/trial_size.hpp"
#include "constructions/truss.hpp"
#include "engine/assert.hpp"

namespace kinegraph {
namespace statics {
namespace {

/// The rules, and the runs in which they are applied.
class Rules {
public:
    /// `adrift`: members of which nothing is found, since what is given on them is not in equilibrium. `redundant`: equilibrium
    /// does not determine everything.
    Rules(ForceModel& model, Board& board, const Mechanism& mechanism, std::set<MemberIndex> adrift, bool redundant)
        : model_(model),
          board_(board),
          mechanism_(mechanism),
          origin_(board.place(PointIndex(0))),
          adrift_(std::move(adrift)),
          redundant_(redundant),
          wholes_(mechanism.efforts.empty() ? model.hung_on_frame() : std::vector<Group>{}) {}

    Run run() {
        Run result = solve(model_.loads());
        for (std::size_t round = 0; round < mechanism_.joints.size() && model_.turn_teeth(result); ++round)
            result = solve(model_.loads());
        gather_components(result);
        return result;
    }
    const NamedMeets& meets() const { return meets_; }

    /// What the structure, cut free whole, gives of its reactions. `hung`: two-force bars by which it hangs on the frame, and
    /// rollers; `bars`: the names of the bars among these.
    Run whole(const Group& hung, std::map<MemberIndex, std::string> bars) {
        of_truss_ = true;
        bar_names_ = std::move(bars);
        Run run = fresh();
        const Board::Mark before = board_.mark();
        for (const MemberIndex member : hung) lines({member}, model_.loads(), run, false);
        bool any = false;
        for (const Group& group : wholes_)
            while (magnitudes(group, model_.loads(), run) || lines(group, model_.loads(), run, false)) any = true;
        if (any) return run;
        board_.rewind(before);
        return fresh();
    }

private:
    // --- one run ------------------------------------------------------------------------------------------------------------
    enum class Shape { pin, guide, line, couple, clamp };

    Shape shape(int b, const Run& run) const {
        const Bond& bond = model_.bonds()[at(b)];
        const Reaction& reaction = run.reactions[at(b)];
        if (bond.kind == Bond::Kind::couple || reaction.only_couple) return Shape::couple;
        if (reaction.action) return Shape::line;
        if (bond.kind == Bond::Kind::pin) return Shape::pin;
        if (bond.kind == Bond::Kind::guide) return Shape::guide;
        return Shape::clamp;
    }

    Run fresh() {
        Run run;
        run.reactions.resize(model_.joint_bonds());
        for (std::size_t b = 0; b < model_.joint_bonds(); ++b) {
            if (model_.bonds()[b].kind == Bond::Kind::line)
                run.reactions[b].action = model_.action(model_.bonds()[b].place, model_.bonds()[b].direction);
            run.reactions[b].known = adrift_.count(model_.bonds()[b].first) > 0 || adrift_.count(model_.bonds()[b].second) > 0;
        }
        fit(run);
        return run;
    }

    /// Components added since the run began: open where their hinge is, else nothing more.
    void fit(Run& run) {
        for (std::size_t b = run.reactions.size(); b < model_.bonds().size(); b += 2) {
            Reaction& hinge = run.reactions[at(model_.bonds()[b].part_of)];
            Reaction parts[2];
            for (std::size_t i = 0; i < 2; ++i) {
                parts[i].known = hinge.known;
                if (!hinge.known) parts[i].action = model_.action(model_.bonds()[b + i].place, model_.bonds()[b + i].direction);
            }
            hinge.known = true;
            for (Reaction& part : parts) run.reactions.push_back(part);
        }
    }

    std::vector<Group> groups(const Run& run) const {
        // A whole of which a part was resolved already is no short cut.
        const auto is_begun = [&](const Group& group) {
            const std::vector<int> outer = model_.outer_bonds(group);
            return std::any_of(outer.begin(), outer.end(), [&](int b) { return run.reactions[at(b)].known; });
        };
        std::vector<Group> result;
        for (const Group& whole : wholes_)
            if (!is_begun(whole)) result.push_back(whole);
        for (const MemberIndex member : model_.moving_members()) result.push_back({member});
        for (const Group& whole : wholes_)
            if (is_begun(whole)) result.push_back(whole);
        // Bodies that slide in one another, taken together; then any two that touch.
        for (const bool only_guides : {true, false}) {
            for (const Bond& bond : model_.bonds()) {
                if (bond.first == member_of(frame) || bond.second == member_of(frame) || bond.effort >= 0) continue;
                if (only_guides != (bond.kind == Bond::Kind::guide)) continue;
                result.push_back({std::min(bond.first, bond.second), std::max(bond.first, bond.second)});
            }
        }
        return result;
    }

    bool all_known(const Run& run) const {
        return std::all_of(run.reactions.begin(), run.reactions.end(), [](const Reaction& r) { return r.known; });
    }

    /// The rules, until no more follows.
    void advance(const std::vector<Load>& loads, Run& run) {
        fit(run);
        std::vector<Group> all;
        // A rule that does not apply leaves no stroke.
        const auto leads_on = [&](auto rule) {
            if (trials_ > 0 && attempts_left_-- <= 0) return false;
            const Board::Mark before = board_.mark();
            const bool applied = rule();
            if (!applied) board_.rewind(before);
            return applied;
        };
        const auto any = [&](auto rule) { return std::any_of(all.begin(), all.end(), rule); };
        const auto direct = [&](const auto& group) {
            return leads_on([&] {
                       if (is_whole(group)) say_of(group, Sentence::structure_whole, {});
                       return magnitudes(group, loads, run);
                   }) ||
                   leads_on([&] { return lines(group, loads, run, false); });
        };
        const auto beside_couples = [&](const auto& group) { return leads_on([&] { return lines(group, loads, run, true); }); };
        const auto past_pins = [&](const auto& group) { return leads_on([&] { return through_pin(group, loads, run); }); };
        const auto alongside = [&](const auto& group) { return leads_on([&] { return parallel_to_all(group, loads, run); }); };
        do {
            all = groups(run);
        } while (!all_known(run) && (any(direct) || any(alongside) || any(beside_couples) || any(past_pins)));
        run.complete = all_known(run);
    }

    std::vector<int> unknown_of(const Group& group, const Run& run) const {
        std::vector<int> unknown;
        for (const int b : model_.outer_bonds(group)) {
            if (!run.reactions[at(b)].known) unknown.push_back(b);
        }
        return unknown;
    }

    /// Unknown bonds by what is known of them.
    struct Unknowns {
        std::vector<int> pins, guides, fixed, couples, clamps;
    };
    Unknowns sorted(const std::vector<int>& unknown, const Run& run) const {
        Unknowns result;
        for (const int b : unknown) {
            switch (shape(b, run)) {
                case Shape::pin:
                    result.pins.push_back(b);
                    break;
                case Shape::guide:
                    result.guides.push_back(b);
                    break;
                case Shape::line:
                    result.fixed.push_back(b);
                    break;
                case Shape::couple:
                    result.couples.push_back(b);
                    break;
                case Shape::clamp:
                    result.clamps.push_back(b);
                    break;
            }
        }
        return result;
    }

    void say(Sentence sentence, std::vector<Argument> arguments, const char* source = "", const Group& group = {}) {
        if (trials_ == 0) {  // the strokes of a trial belong to the sentence that opens it
            Statement statement;
            statement.message = {sentence, std::move(arguments)};
            statement.section = Topic::forces;
            statement.source = source;
            for (const MemberIndex member : group)
                if (!model_.is_pin(member)) statement.bodies.push_back(model_.body_of(member));
            statement_ = board_.state(std::move(statement));
        }
        remember_meets();
    }
    /// A sentence of a body, or of several taken together: they are its first argument.
    void say_of(const Group& group, Sentence sentence, std::vector<Argument> arguments, const char* source = "") {
        std::string names;
        constexpr std::ptrdiff_t most_names = 4;
        const auto bodies = std::count_if(group.begin(), group.end(), [&](MemberIndex each) { return !model_.is_pin(each); });
        if (bodies > most_names)
            names = model_.member_name(group.front()) + " … " + model_.member_name(last_body_of(group));
        else
            for (const MemberIndex member : group)
                if (!model_.is_pin(member) || bodies < 2)  // "2 + 3", but "2+C" of a body with its pin: that is no other body
                    names += (names.empty() ? "" : bodies < 2 ? "+" : " + ") + model_.member_name(member);
        const auto bar = group.size() == 1 ? bar_names_.find(group.front()) : bar_names_.end();
        if (bar != bar_names_.end())
            arguments.insert(arguments.begin(), BodyName{bar->second, true});
        else
            arguments.insert(arguments.begin(), BodyName{names, of_truss_ && is_whole(group)});
        say(sentence, std::move(arguments), source, group);
    }
    /// Pins come after the bodies.
    MemberIndex last_body_of(const Group& group) const {
        const auto last = std::find_if(group.rbegin(), group.rend(), [&](MemberIndex member) { return !model_.is_pin(member); });
        return last == group.rend() ? group.back() : *last;
    }
    /// What the sentence said last finds of a bond, or says of it.
    void found_line(int b, Run& run) const {
        Reaction& reaction = run.reactions[at(b)];
        if (reaction.line_statement == none) reaction.line_statement = statement_;
    }
    void found(int b, const Group& group, Run& run) {
        found_line(b, run);
        Reaction& reaction = run.reactions[at(b)];
        reaction.known = true;
        reaction.force_statement = statement_;
        if (trials_ == 0) board_.statement(statement_).finds.push_back(quantity_on(b, group));
    }
    /// The action of a bond on a group.
    Quantity quantity_on(int b, const Group& group) const {
        const Bond& bond = model_.bonds()[at(b)];
        if (bond.effort >= 0) return {.kind = Quantity::Kind::effort, .given = bond.effort};
        const bool on_first = in(group, bond.first);
        return {.kind = Quantity::Kind::force,
                .body = model_.body_of(on_first ? bond.first : bond.second),
                .other = model_.body_of(on_first ? bond.second : bond.first),
                .joint = bond.joint};
    }
    PointName place_name(int b) const {
        const Bond& bond = model_.bonds()[at(b)];
        if (bond.joint != none) return {mechanism_.points[at(mechanism_.joints[at(bond.joint)].point)].name};
        return {bond.symbol.about};
    }
    /// The force of a bond as it acts on a group.
    Symbol symbol_on(int b, const Group& group) const {
        const Bond& bond = model_.bonds()[at(b)];
        return marked(in(group, bond.first) ? bond.symbol : bond.reverse, mark_);
    }

    // --- lines of action ------------------------------------------------------------------------------------------------------
    /// `beside_couples`: bodies that carry a couple too; tried when nothing else is left.
    bool lines(const Group& group, const std::vector<Load>& loads, Run& run, bool beside_couples) {
        const std::vector<int> unknown = unknown_of(group, run);
        const auto [pins, guides, fixed, couples, clamps] = sorted(unknown, run);
        if (!clamps.empty()) return false;
        const std::size_t forces = pins.size() + guides.size() + fixed.size();
        if ((pins.empty() && guides.empty()) || couples.empty() == beside_couples) return false;
        if (forces < 2 || forces > 3 || couples.size() > 1) return false;
        if (forces == 3 && (fixed.size() != 2 || !couples.empty())) return false;
        if (forces == 2 && fixed.size() == 2) return false;
        if (!model_.known_on(group, loads, run).vanishes()) return false;
        if (forces == 3) return concurrent(group, fixed, pins, guides, run);
        if (!couples.empty()) return parallel_to_other(group, pins, guides, fixed, run);
        return two_forces(group, pins, guides, fixed, run);
    }

    void settle_line(int b, const Action& found, Run& run) {
        found_line(b, run);
        Reaction& reaction = run.reactions[at(b)];
        reaction.action = found;
        reaction.deduced = true;
    }

    void vanish(int b, const Group& group, Run& run) {
        if (model_.bonds()[at(b)].kind == Bond::Kind::guide) {
            found_line(b, run);
            run.reactions[at(b)].only_couple = true;
        } else {
            found(b, group, run);
        }
    }

    /// Two forces only: equal, opposite, on one line.
    bool two_forces(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                    const std::vector<int>& fixed, Run& run) {
        const auto join_direction = [&](PlaceOnDrawing p, PlaceOnDrawing q) { return board_.direction(board_.vector(p, q)); };
        if (pins.size() == 2) {
            const Bond &one = model_.bonds()[at(pins[0])], &two = model_.bonds()[at(pins[1])];
            if (board_.coincide(one.place, two.place)) return false;
            say_of(group, group.size() > 1 ? Sentence::two_force_group : Sentence::two_force_body,
                   {place_name(pins[0]), place_name(pins[1])});
            const Action found = model_.action(one.place, join_direction(one.place, two.place));
            settle_line(pins[0], found, run);
            settle_line(pins[1], found, run);
            return true;
        }
        if (pins.size() == 1 && guides.size() == 1) {
            say_of(group, Sentence::two_force_guide, {place_name(pins[0]), place_name(guides[0])});
            const Action found = model_.action(model_.bonds()[at(pins[0])].place, model_.bonds()[at(guides[0])].direction);
            settle_line(pins[0], found, run);
            settle_line(guides[0], found, run);
            return true;
        }
        if (pins.size() == 1 && fixed.size() == 1) {
            const Action given = *run.reactions[at(fixed[0])].action;
            if (board_.on_line(model_.bonds()[at(pins[0])].place, given.line)) {
                say_of(group, Sentence::two_force_body, {place_name(pins[0]), place_name(fixed[0])});
                settle_line(pins[0], given, run);
                found_line(fixed[0], run);
            } else {
                say_of(group, Sentence::zero_forces, {});
                vanish(pins[0], group, run);
                vanish(fixed[0], group, run);
            }
            return true;
        }
        if (guides.size() == 2) {
            if (board_.parallel(model_.bonds()[at(guides[0])].direction, model_.bonds()[at(guides[1])].direction)) return false;
            say_of(group, Sentence::zero_forces, {});
            vanish(guides[0], group, run);
            vanish(guides[1], group, run);
            return true;
        }
        // A guide and a line: the guide's reaction can take any place.
        const Action given = *run.reactions[at(fixed[0])].action;
        if (board_.parallel(model_.bonds()[at(guides[0])].direction, given.direction)) {
            say_of(group, Sentence::two_force_guide, {place_name(fixed[0]), place_name(guides[0])});
            settle_line(guides[0], given, run);
            found_line(fixed[0], run);
        } else {
            say_of(group, Sentence::zero_forces, {});
            vanish(guides[0], group, run);
            vanish(fixed[0], group, run);
        }
        return true;
    }

    /// Two forces and a couple: the forces are equal and opposite, so parallel.
    bool parallel_to_other(const Group& group, const std::vector<int>& pins, const std::vector<int>& guides,
                           const std::vector<int>& fixed, Run& run) {
        if (pins.size() != 1) return false;
        const DirectionHandle direction =
            fixed.empty() ? model_.bonds()[at(guides[0])].direction : run.reactions[at(fixed[0])].action->direction;
        say_of(group, Sentence::two_forces_and_couple, {place_name(pins[0])});
        settle_line(pins[0], model_.action(model_.bonds()[at(pins[0])].place, direction), run);
        return true;
    }

    /// Three forces, two lines known: the third passes through their meet.
    bool concurrent(const Group& group, const std::vector<int>& fixed, const std::vector<int>& pins,
                    const std::vector<int>& guides, Run& run) {
        const Action one = *run.reactions[at(fixed[0])].action, two = *run.reactions[at(fixed[1])].action;
        const auto met = board_.meet(one.line, two.line);
        if (!met) return false;
        const int third = pins.empty() ? guides[0] : pins[0];
        const Bond& bond = model_.bonds()[at(third)];
        const bool parallel = board_.is_at_infinity(*met);
        std::optional<Action> found;
        if (!pins.empty()) {
            if (parallel) {
                found = model_.action(bond.place, one.direction);
            } else {
                if (board_.coincide(*met, bond.place)) return false;
                found = model_.action(bond.place, board_.direction(board_.vector(*met, bond.place)));
            }
        } else {
            if (parallel) return false;
            found = model_.action(*met, bond.direction);
        }
        if (parallel) {
            say_of(group, Sentence::three_parallel_lines, {symbol_on(third, group)});
        } else {
            say_of(group, Sentence::three_force_line,
                   {PointName{meet_name(group, *met)}, symbol_on(third, group), place_name(third)}, "Culmann");
        }
        settle_line(third, *found, run);
        return true;
    }

    /// All other forces on a body are parallel, known or not: across them nothing balances a force at its pin.
    bool parallel_to_all(const Group& group, const std::vector<Load>& loads, Run& run) {
        const auto [pins, guides, fixed, couples, clamps] = sorted(unknown_of(group, run), run);
        if (pins.size() != 1 || !clamps.empty() || guides.size() + fixed.size() < 2) return false;
        const DirectionHandle along =
            fixed.empty() ? model_.bonds()[at(guides[0])].direction : run.reactions[at(fixed[0])].action->direction;
        const auto is_along = [&](DirectionHandle direction) { return board_.parallel(along, direction); };
        if (!std::all_of(fixed.begin(), fixed.end(), [&](int b) { return is_along(run.reactions[at(b)].action->direction); }) ||
            !std::all_of(guides.begin(), guides.end(), [&](int b) { return is_along(model_.bonds()[at(b)].direction); }))
            return false;
        const Wrench known = model_.known_on(group, loads, run);
        if (known.force && !is_along(board_.direction(*known.force))) return false;
        say_of(group, Sentence::three_parallel_lines, {symbol_on(pins[0], group)});
        settle_line(pins[0], model_.action(model_.bonds()[at(pins[0])].place, along), run);
        return true;
    }

    /// What is known on a body passes its pin: moments about that leave none to the guide, so its reaction passes there too.
    bool through_pin(const Group& group, const std::vector<Load>& loads, Run& run) {
        const auto [pins, guides, fixed, couples, clamps] = sorted(unknown_of(group, run), run);
        if (pins.size() != 1 || guides.size() != 1 || !fixed.empty() || !couples.empty() || !clamps.empty()) return false;
        const Wrench known = model_.known_on(group, loads, run);
        const PlaceOnDrawing pin = model_.bonds()[at(pins[0])].place;
        if (!known.force || !board_.on_line(pin, model_.line_of(known))) return false;
        say_of(group, Sentence::through_pin, {place_name(pins[0]), symbol_on(guides[0], group)});
        settle_line(guides[0], model_.action(pin, model_.bonds()[at(guides[0])].direction), run);
        return true;
    }

    // --- what is added up, and its arms --------------------------------------------------------------------------------------
    /// A force or couple that is known on a group.
    struct Actor {
        Symbol symbol;
        std::optional<Force> force;
        PlaceOnDrawing place;
        int bond = -1;
    };
    std::vector<Actor> actors_on(const Group& group, const std::vector<Load>& loads, const Run& run) {
        std::vector<Actor> actors;
        for (const Load& load : loads)
            if (in(group, load.member) && !model_.is_inner(load, group))
                actors.push_back({load.symbol, load.force, load.place, -1});
        for (const int b : model_.outer_bonds(group)) {
            const Bond& bond = model_.bonds()[at(b)];
            const Reaction& reaction = run.reactions[at(b)];
            if (!reaction.known || (!reaction.force && !reaction.couple)) continue;
            const MemberIndex member = in(group, bond.first) ? bond.first : bond.second;
            const Wrench wrench = model_.wrench_of(bond, reaction, member);
            Symbol symbol = symbol_on(b, group);
            if (!wrench.force && bond.effort < 0) symbol.letter = Symbol::Letter::M;
            actors.push_back({std::move(symbol), wrench.force, wrench.place, b});
        }
        return actors;
    }
    std::string names_of(const Group& group) const {
        if (is_whole(group) && wholes_.size() == 1) return "";  // all that is given
        std::string names;
        for (const MemberIndex member : group)
            if (!model_.is_pin(member) || group.size() == 1) names += (names.empty() ? "" : ",") + model_.member_name(member);
        return names;
    }
    /// Several known forces are one first: its line is what meets the others.
    void say_resultant(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run) {
        const std::size_t most = is_whole(group) ? 12 : 6;
        if (trials_ > 0 || !known.force) return;
        const std::vector<Actor> actors = actors_on(group, loads, run);
        if (actors.size() < 2 || actors.size() > most) return;
        Added added{group, {}, *known.force, known.place, {}, none};
        added.symbol = marked({Symbol::Letter::F, "R" + names_of(group), {}}, mark_);
        Symbols symbols;
        for (const Actor& actor : actors) {
            symbols.push_back(actor.symbol);
            if (actor.bond >= 0) added.bonds.push_back(actor.bond);
        }
        say_of(group, Sentence::known_resultant, {std::move(symbols), added.symbol});
        added.statement = statement_;
        run.added.push_back(std::move(added));
    }
    /// What the known force and the first of three lines make together acts along Culmann's line.
    void note_culmann(const Group& group, int one, const std::string& names, Force force, PlaceOnDrawing met,
                      const std::vector<Load>& loads, Run& run) {
        if (trials_ > 0 || board_.is_zero(force)) return;
        Added added{group, marked({Symbol::Letter::F, names, {}}, mark_), force, met, {one}, statement_};
        for (const Actor& actor : actors_on(group, loads, run))
            if (actor.bond >= 0) added.bonds.push_back(actor.bond);
        run.added.push_back(std::move(added));
    }
    /// Of the one known force, or of the resultant that was said.
    Symbol symbol_of_known(const Group& group, const std::vector<Load>& loads, const Run& run) {
        const std::vector<Actor> actors = actors_on(group, loads, run);
        return actors.size() == 1 ? actors.front().symbol : marked({Symbol::Letter::F, "R" + names_of(group), {}}, mark_);
    }
    void note_lever(const Group& group, PlaceOnDrawing about, Force force, PlaceOnDrawing place, Run& run) {
        if (trials_ > 0 || group.size() > 1 || model_.is_pin(group.front())) return;
        run.levers.push_back({group.front(), about, force, place, statement_, false});
    }

    // --- magnitudes
    // -------------------------------------------------------------------------------------------------------------
    void settle(int b, Force force_on_group, PlaceOnDrawing place, const Group& group, Run& run) {
        const Bond& bond = model_.bonds()[at(b)];
        found(b, group, run);
        if (board_.is_zero(force_on_group)) return;
        Reaction& reaction = run.reactions[at(b)];
        reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
        if (!reaction.action) reaction.action = model_.action(place, board_.direction(*reaction.force));
        if (bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp) {
            const ScalarHandle couple = board_.moment(board_.vector(bond.place, place), *reaction.force);
            if (!board_.is_zero(couple)) reaction.couple = couple;
        }
    }

    /// A guide or a clamp takes force and couple: its real line is moved aside by their arm.
    void settle_with_couple(int b, Force force_on_group, ScalarHandle couple_on_group, const Group& group, Run& run) {
        const Bond& bond = model_.bonds()[at(b)];
        settle_couple(b, couple_on_group, group, run);
        if (board_.is_zero(force_on_group)) return;
        Reaction& reaction = run.reactions[at(b)];
        reaction.force = in(group, bond.first) ? force_on_group : board_.negate(force_on_group);
        const PlaceOnDrawing place =
            reaction.couple ? board_.carry(bond.place, board_.arm(*reaction.couple, *reaction.force)) : bond.place;
        if (!reaction.action) reaction.action = model_.action(place, board_.direction(*reaction.force));
    }

    void settle_couple(int b, ScalarHandle couple_on_group, const Group& group, Run& run) {
        found(b, group, run);
        if (board_.is_zero(couple_on_group)) return;
        run.reactions[at(b)].couple = in(group, model_.bonds()[at(b)].first) ? couple_on_group : board_.opposite(couple_on_group);
    }

    bool is_whole(const Group& group) const { return std::find(wholes_.begin(), wholes_.end(), group) != wholes_.end(); }

    void note(const Group& group, Run& run) {
        if (is_whole(group)) return;  // its bodies are resolved later
        for (const MemberIndex member : group) {
            const bool there =
                std::any_of(run.order.begin(), run.order.end(), [&](const Resolved& r) { return r.member == member; });
            if (!there) run.order.push_back({member});
        }
    }

    /// The letter of a point of concurrency; the sentence said next finds it.
    std::string meet_name(const Group& group, PlaceOnDrawing place) {
        auto known = std::find_if(named_meets_.begin(), named_meets_.end(),
                                  [&](const NamedMeet& meet) { return board_.coincide(meet.place, place); });
        if (known == named_meets_.end()) known = named_meets_.insert(known, {free_letter(), place});
        unsaid_meets_.emplace_back(group, known - named_meets_.begin());
        return known->name;
    }
    std::string free_letter() const {
        static const char* const letters[] = {"H", "K", "L", "Q", "R", "T", "U", "V", "W", "Y", "Z"};
        for (int round = 0;; ++round) {
            for (const char* letter : letters) {
                std::string candidate = letter + (round == 0 ? std::string() : std::to_string(round));
                if (mechanism_.point_named(candidate)) continue;
                if (std::none_of(named_meets_.begin(), named_meets_.end(),
                                 [&](const NamedMeet& meet) { return meet.name == candidate; }))
                    return candidate;
            }
        }
    }
    void remember_meets() {
        for (const auto& [group, index] : unsaid_meets_) {
            NamedMeet& meet = named_meets_[static_cast<std::size_t>(index)];
            if (meet.statement == none) meet.statement = statement_;
            meet.used = statement_;
            for (const MemberIndex member : group) meets_[member].push_back(meet);
        }
        unsaid_meets_.clear();
    }

    bool magnitudes(const Group& group, const std::vector<Load>& loads, Run& run) {
        const std::vector<int> unknown = unknown_of(group, run);
        if (unknown.empty()) return false;
        const auto [pins, guides, fixed, couples, clamps] = sorted(unknown, run);
        const std::size_t count = 2 * (pins.size() + guides.size()) + fixed.size() + couples.size() + 3 * clamps.size();
        if (count > 3 || couples.size() > 1) return false;
        const Wrench known = model_.known_on(group, loads, run);
        bool done = false;
        if (unknown.size() == 1) {
            done = single(group, unknown[0], known, loads, run);
        } else if (pins.size() == 1 && couples.size() == 1) {
            done = force_and_couple(group, pins[0], couples[0], known, loads, run);
        } else if (pins.size() == 1 && fixed.size() == 1) {
            done = line_and_pin(group, fixed[0], pins[0], known, loads, run);
        } else if (guides.size() == 1 && fixed.size() == 1) {
            done = line_and_guide(group, fixed[0], guides[0], known, loads, run);
        } else if (fixed.size() == 2) {
            done = two_lines(group, fixed[0], fixed[1], couples.empty() ? -1 : couples[0], known, loads, run);
        } else if (fixed.size() == 1 && couples.size() == 1) {
            done = force_and_couple(group, fixed[0], couples[0], known, loads, run);
        } else if (fixed.size() == 3) {
            done = three_lines(group, fixed, known, loads, run);
        }
        if (done) note(group, run);
        if (done && group.size() > 1 && trials_ == 0) run.balanced.push_back({group, unknown, statement_});
        return done;
    }

    Force opposite(const Wrench& known) { return board_.negate(*known.force); }

    /// The part of −F that a line or a guide can give: all of it where the loads allow equilibrium; what is missing shows as a
    /// gap.
    Force opposite_along(const Wrench& known, DirectionHandle direction) {
        const Force unit = board_.scale<Plane::force>(board_.number(1), direction);
        return board_.scale<Plane::force>(board_.ratio(opposite(known), unit), direction);
    }

    /// What is left balances the rest.
    bool single(const Group& group, int b, const Wrench& known, const std::vector<Load>& loads, Run& run) {
        const Shape of = shape(b, run);
        Symbol symbol = symbol_on(b, group);
        if (known.vanishes() && of == Shape::couple) symbol.letter = Symbol::Letter::M;
        say_of(group, known.vanishes() ? Sentence::no_force : Sentence::single_reaction, {symbol});
        if (of == Shape::couple) {
            note_couple_of_two(group, known, loads, run);
            settle_couple(b, board_.opposite(model_.moment(known, model_.bonds()[at(b)].place)), group, run);
            return true;
        }
        const bool takes_couple =
            model_.bonds()[at(b)].kind == Bond::Kind::guide || model_.bonds()[at(b)].kind == Bond::Kind::clamp;
        if (of == Shape::line) {
            const Action line = *run.reactions[at(b)].action;
            if (known.force) {
                settle(b, opposite_along(known, line.direction), line.place, group, run);
            } else {
                found(b, group, run);
            }
        } else if (takes_couple) {
            const ScalarHandle couple = board_.opposite(model_.moment(known, model_.bonds()[at(b)].place));
            if (known.force) {
                const Force force = of == Shape::guide ? opposite_along(known, model_.bonds()[at(b)].direction) : opposite(known);
                settle_with_couple(b, force, couple, group, run);
            } else {
                settle_couple(b, couple, group, run);
            }
        } else if (known.force) {
            settle(b, opposite(known), model_.bonds()[at(b)].place, group, run);
        } else {
            found(b, group, run);
        }
        return true;
    }

    /// A couple of two forces has their distance for its arm.
    void note_couple_of_two(const Group& group, const Wrench& known, const std::vector<Load>& loads, Run& run) {
        if (!known.couple || trials_ > 0) return;
        const std::vector<Actor> actors = actors_on(group, loads, run);
        if (actors.size() == 2 && actors[0].force && actors[1].force)
            note_lever(group, actors[0].place, *actors[1].force, actors[1].place, run);
    }

    /// A place on a bond's line, or its own.
    PlaceOnDrawing place_of(int b, const Run& run) const {
        const Reaction& reaction = run.reactions[at(b)];
        return reaction.action ? reaction.action->place : model_.bonds()[at(b)].place;
    }

    /// A force through a point and a couple: the force is the rest turned round, the couple their arm times it.
    bool force_and_couple(const Group& group, int force, int couple, const Wrench& known, const std::vector<Load>& loads,
                          Run& run) {
        const PlaceOnDrawing place = place_of(force, run);
        say_resultant(group, known, loads, run);
        say_of(group, Sentence::force_and_couple, {symbol_on(force, group), symbol_on(couple, group)});
        const ScalarHandle balancing = board_.opposite(model_.moment(known, place));
        if (known.force && !board_.is_zero(balancing)) note_lever(group, place, *known.force, known.place, run);
        if (known.force) {
            const auto& line = run.reactions[at(force)].action;
            settle(force, line ? opposite_along(known, line->direction) : opposite(known), place, group, run);
        } else {
            found(force, group, run);
        }
        settle_couple(couple, balancing, group, run);
        return true;
    }

    /// s·d of a force along a line, so that its moment about a place balances the known one (Ritter).
    std::optional<Force> by_moments(const Action& line, PlaceOnDrawing about, const Wrench& known) {
        const ScalarHandle lever = board_.moment(board_.vector(about, line.place), line.direction);
        if (board_.is_zero(lever)) return std::nullopt;
        const ScalarHandle size = board_.quotient(board_.opposite(model_.moment(known, about)), lever);
        return board_.scale<Plane::force>(size, line.direction);
    }

    /// Closes F + X + Y = 0 with X along d, Y along e, not parallel: the force triangle.
    std::pair<Force, Force> triangle(const Wrench& known, DirectionHandle d, DirectionHandle e) {
        const auto start = board_.pole<Plane::force>();
        const auto end = known.force ? board_.carry(start, *known.force) : start;
        const auto corner = board_.meet(board_.through(end, d), board_.through(start, e));
        KG_ASSERT(corner && !board_.is_at_infinity(*corner), "the sides of a force triangle are not parallel");
        return {board_.vector(end, *corner), board_.vector(*corner, start)};
    }

    // --- the funicular polygon -----------------------------------------------------------------------------------------------
    /// Known forces along the line on which they are told: as far as that is a choice, from the place to the line.
    void sort_along(std::vector<Actor>& actors, PlaceOnDrawing from, PlaceOnDrawing to) {
        const auto axis = board_.vector(from, to);
        std::stable_sort(actors.begin(), actors.end(), [&](const Actor& a, const Actor& b) {
            return board_.choose_along(axis, board_.vector(a.place, b.place)) > 0;
        });
    }
    /// Forces along a line and at a place off it that balance known ones: pole, rays and strings. Nothing: nobody draws it (in a
    /// trial, of a pin, of a couple, of very many forces, so deep that it leaves the sheet), or a string would not meet its line.
    std::optional<Strings> strings(const Group& group, std::vector<Actor> actors, Force sum, const Action& line,
                                   PlaceOnDrawing place) {
        const bool several = group.size() > 1;
        const std::size_t most = several ? 12 : 6;
        const bool drawn = trials_ == 0 && (several || !model_.is_pin(group.front()));
        if (!drawn || actors.empty() || actors.size() > most) return std::nullopt;
        if (!std::all_of(actors.begin(), actors.end(), [](const Actor& actor) { return actor.force.has_value(); }))
            return std::nullopt;
        sort_along(actors, place, line.place);
        Strings found;
        found.group = group;
        found.corners = {board_.pole<Plane::force>()};
        for (const Actor& actor : actors) {
            found.known.push_back(actor.symbol);
            found.corners.push_back(board_.carry(found.corners.back(), *actor.force));
        }
        // The first whose strings stay beside the structure, or not far from it.
        for (const Exact& deepest : {Exact(1), Exact(3) / 2})
            for (const auto pole : poles(found.corners, sum, several)) {
                const Board::Mark before = board_.mark();
                found.pole = pole;
                if (draw_strings(found, actors, line, place) && !(several && is_deep(found.vertices, actors, line, deepest)))
                    return found;
                board_.rewind(before);
            }
        return std::nullopt;
    }
    /// Through the place and from known line to known line; false: a string does not meet its line.
    bool draw_strings(Strings& found, const std::vector<Actor>& actors, const Action& line, PlaceOnDrawing place) {
        found.vertices = {place};
        found.resultant.reset();
        std::optional<LineOn<drawing>> outer;
        for (std::size_t i = 0; i <= actors.size(); ++i) {
            const auto ray = board_.direction(board_.vector(found.pole, found.corners[i]));
            const LineOn<drawing> string = board_.through(found.vertices.back(), ray);
            const LineOn<drawing> next =
                i < actors.size() ? board_.through(actors[i].place, board_.direction(*actors[i].force)) : line.line;
            if (board_.parallel(string, next)) return false;
            if (!outer) outer = string;
            if (i == actors.size() && i > 1 && !board_.parallel(*outer, string)) found.resultant = board_.meet(*outer, string);
            found.vertices.push_back(*board_.meet(string, next));
        }
        if (board_.coincide(found.vertices.back(), found.vertices.front())) return false;
        const auto closing = board_.direction(board_.vector(found.vertices.back(), found.vertices.front()));
        const auto dividing =
            board_.meet(board_.through(found.corners.back(), line.direction), board_.through(found.pole, closing));
        KG_ASSERT(dividing && !board_.is_at_infinity(*dividing), "the closing line joins a place to a line that misses it");
        found.dividing = *dividing;
        return true;
    }
    /// Beside the middle of the sum. Of several bodies also farther along it: the strings then run aslant to it, where its own
    /// perpendicular would not lead to the lines.
    std::vector<PointOn<Plane::force>> poles(const std::vector<PointOn<Plane::force>>& corners, Force sum, bool several) {
        const auto distance = several ? pole_distance(corners, sum) : Exact(1);
        if (!distance) return {};
        const Force away =
            *distance == Exact(1) ? board_.turn(sum) : board_.scale<Plane::force>(board_.number(*distance), board_.turn(sum));
        std::vector<PointOn<Plane::force>> found;
        for (const Exact& share : {Exact(1) / 2, Exact(3) / 2, Exact(-1) / 2}) {
            const Force along = board_.scale<Plane::force>(board_.number(share), sum);
            found.push_back(board_.carry(board_.carry(corners.front(), along), away));
            if (!several) break;
        }
        return found;
    }
    /// Times the sum of the forces. As far from them as they are long: strings between parallel forces are then a quarter as deep
    /// as they are wide, at most. Nothing: the sum is small beside what is added.
    std::optional<Exact> pole_distance(const std::vector<PointOn<Plane::force>>& corners, Force sum) {
        for (const int times : {1, 2, 4}) {
            const Force reach = board_.scale<Plane::force>(board_.number(Exact(5) / 4 * Exact(times)), sum);
            const bool near = std::all_of(corners.begin() + 1, corners.end(), [&](PointOn<Plane::force> corner) {
                return !board_.choose_longer(board_.vector(corners.front(), corner), reach);
            });
            if (near) return Exact(times);
        }
        return std::nullopt;
    }
    /// Whether a string ends farther from where its force acts than so many times what the structure reaches.
    bool is_deep(const std::vector<PlaceOnDrawing>& vertices, const std::vector<Actor>& actors, const Action& line,
                 const Exact& times) {
        auto reach = board_.vector(vertices.front(), line.place);
        for (const Actor& actor : actors)
            if (const auto away = board_.vector(vertices.front(), actor.place); board_.choose_longer(away, reach)) reach = away;
        reach = board_.scale<drawing>(board_.number(times), reach);
        for (std::size_t i = 0; i < vertices.size() - 1; ++i) {
            const PlaceOnDrawing acts_at = i < actors.size() ? actors[i].place : line.place;
            if (board_.choose_longer(board_.vector(acts_at, vertices[i + 1]), reach)) return true;
        }
        return false;
    }
    /// Both reactions, and the strings of the sentence said last.
    std::pair<Force, Force> by_strings(Strings found, int line, int pin, Force sum, const Group& group, Run& run) {
        found.statement = statement_;
        found.first = symbol_on(line, group);
        found.second = symbol_on(pin, group);
        if (found.resultant)
            run.added.push_back(
                {group, marked({Symbol::Letter::F, "R" + names_of(group), {}}, mark_), sum, *found.resultant, {}, statement_});
        const Force first = board_.vector(found.corners.back(), found.dividing);
        const Force second = board_.vector(found.dividing, found.corners.front());
        run.strings.push_back(std::move(found));
        return {first, second};
    }
    /// So far away that nobody draws to it; from a whole, farther than it reaches.
    bool is_far(const Group& group, PlaceOnDrawing met, PlaceOnDrawing place, PlaceOnDrawing one, PlaceOnDrawing two) {
        const int times = is_whole(group) ? 1 : 12;
        std::vector<PlaceOnDrawing> near{one, two};
        if (is_whole(group))
            for (const int b : model_.outer_bonds(group)) near.push_back(model_.bonds()[at(b)].place);
        const auto away = board_.vector(place, met);
        return std::all_of(near.begin(), near.end(), [&](PlaceOnDrawing each) {
            return board_.choose_longer(away, board_.scale<drawing>(board_.number(times), board_.vector(place, each)));
        });
    }

    bool line_and_pin(const Group& group, int line, int pin, const Wrench& known, const std::vector<Load>& loads, Run& run) {
        const Action given = *run.reactions[at(line)].action;
        const PlaceOnDrawing place = model_.bonds()[at(pin)].place;
        if (board_.on_line(place, given.line)) return false;  // the moment about the pin says nothing of it
        if (known.vanishes()) {
            say_of(group, Sentence::zero_forces, {});
            found(line, group, run);
            found(pin, group, run);
            return true;
        }
        if (known.force && !board_.parallel(board_.direction(*known.force), given.direction)) {
            const auto met = board_.meet(model_.line_of(known), given.line);
            if (board_.coincide(*met, place)) return false;
            const bool far = is_far(group, *met, place, known.place, given.place);
            if (several_by_strings(group, line, pin, known, far, loads, run)) return true;
            say_resultant(group, known, loads, run);
            if (far)
                if (auto found = strings(group, {{symbol_of_known(group, loads, run), known.force, known.place, -1}},
                                         *known.force, given, place)) {
                    say_of(group, Sentence::funicular_far, {symbol_on(line, group), symbol_on(pin, group)}, "Culmann");
                    const auto [along, at_pin] = by_strings(*std::move(found), line, pin, *known.force, group, run);
                    settle(line, along, given.place, group, run);
                    settle(pin, at_pin, place, group, run);
                    return true;
                }
            const std::string letter = meet_name(group, *met);
            say_of(group, Sentence::triangle_at, {PointName{letter}, symbol_on(line, group), symbol_on(pin, group)}, "Culmann");
            const DirectionHandle through_meet = board_.direction(board_.vector(place, *met));
            const auto [along, at_pin] = triangle(known, given.direction, through_meet);
            settle_line(pin, model_.action(place, through_meet), run);
            settle(line, along, given.place, group, run);
            settle(pin, at_pin, place, group, run);
            return true;
        }
        if (known.force)
            if (auto found = strings(group, actors_on(group, loads, run), *known.force, given, place)) {
                say_of(group, Sentence::funicular_parallel, {symbol_on(line, group), symbol_on(pin, group)}, "Culmann");
                const auto [first, second] = by_strings(*std::move(found), line, pin, *known.force, group, run);
                settle(line, first, given.place, group, run);
                settle(pin, second, place, group, run);
                return true;
            }
        const auto along = by_moments(given, place, known);
        if (!along) return false;
        say_of(group, Sentence::parallel_forces, {symbol_on(line, group), symbol_on(pin, group)}, "Ritter");
        settle(line, *along, given.place, group, run);
        settle(pin, board_.negate(known.force ? board_.add(*known.force, *along) : *along), place, group, run);
        return true;
    }

    /// More than two forces on a structure, of several directions, or two whose sum meets the line `far` away: one funicular
    /// polygon adds them and parts the sum.
    bool several_by_strings(const Group& group, int line, int pin, const Wrench& known, bool far, const std::vector<Load>& loads,
                            Run& run) {
        if (!is_whole(group)) return false;
        const std::vector<Actor> actors = actors_on(group, loads, run);
        if (actors.size() < (far ? 2U : 3U)) return false;
        const Action given = *run.reactions[at(line)].action;
        const PlaceOnDrawing place = model_.bonds()[at(pin)].place;
        auto found = strings(group, actors, *known.force, given, place);
        if (!found) return false;
        say_of(group, Sentence::funicular_several, {symbol_on(line, group), symbol_on(pin, group), found->known}, "Culmann");
        const auto [along, at_pin] = by_strings(*std::move(found), line, pin, *known.force, group, run);
        settle(line, along, given.place, group, run);
        settle(pin, at_pin, place, group, run);
        return true;
    }

    /// No triangle closes with a force that is nothing.
    bool is_along(const Wrench& known, const Action& line) {
        return known.force && board_.parallel(board_.direction(*known.force), line.direction);
    }
    /// `couple_too`: the pair transmits a couple, and it vanishes.
    void say_no_force_along(const Group& group, int nothing, int all, bool couple_too) {
        std::vector<Argument> arguments{symbol_on(nothing, group), symbol_on(all, group)};
        if (couple_too) {
            Symbol couple = symbol_on(nothing, group);
            couple.letter = Symbol::Letter::M;
            arguments.emplace_back(std::move(couple));
        }
        say_of(group, Sentence::no_force_along, std::move(arguments));
    }

    /// Where the resultant of several known forces, which is said, meets a line; nothing: of one there is nothing to be added.
    std::optional<PlaceOnDrawing> meet_of_resultant(const Group& group, const Action& line, const Wrench& known,
                                                    const std::vector<Load>& loads, Run& run) {
        if (trials_ > 0 || !known.force || actors_on(group, loads, run).size() < 2) return std::nullopt;
        say_resultant(group, known, loads, run);
        return board_.meet(model_.line_of(known), line.line);
    }
    /// A guide takes its force at any place: directions give the triangle, the guide's couple the rest.
    bool line_and_guide(const Group& group, int line, int guide, const Wrench& known, const std::vector<Load>& loads, Run& run) {
        const Action given = *run.reactions[at(line)].action;
        const DirectionHandle normal = model_.bonds()[at(guide)].direction;
        if (board_.parallel(given.direction, normal)) return false;
        if (is_along(known, given)) {
            say_no_force_along(group, guide, line, board_.is_zero(model_.moment(known, given.place)));
        } else if (const auto met = meet_of_resultant(group, given, known, loads, run)) {
            const std::string letter = meet_name(group, *met);
            say_of(group, Sentence::triangle_at, {PointName{letter}, symbol_on(line, group), symbol_on(guide, group)});
        } else {
            say_of(group, Sentence::triangle, {symbol_on(line, group), symbol_on(guide, group)});
        }
        const auto [along, across] = triangle(known, given.direction, normal);
        settle(line, along, given.place, group, run);
        Wrench rest = known;
        if (run.reactions[at(line)].force) rest = model_.sum(known, wrench_at(along, given.place));
        settle_guide(guide, across, rest, group, run);
        return true;
    }

    static Wrench wrench_at(Force force, PlaceOnDrawing place) {
        Wrench wrench;
        wrench.force = force;
        wrench.place = place;
        return wrench;
    }

    /// A guide's reaction balances what is left, force and couple.
    void settle_guide(int guide, Force across, const Wrench& rest, const Group& group, Run& run) {
        settle_with_couple(guide, across, board_.opposite(model_.moment(rest, model_.bonds()[at(guide)].place)), group, run);
    }

    bool two_lines(const Group& group, int one, int two, int couple, const Wrench& known, const std::vector<Load>& loads,
                   Run& run) {
        const Action first = *run.reactions[at(one)].action, second = *run.reactions[at(two)].action;
        if (!board_.parallel(first.direction, second.direction)) {
            if (is_along(known, first))
                say_no_force_along(group, two, one, false);
            else if (is_along(known, second))
                say_no_force_along(group, one, two, false);
            else
                say_of(group, Sentence::triangle, {symbol_on(one, group), symbol_on(two, group)});
            const auto [x, y] = triangle(known, first.direction, second.direction);
            settle(one, x, first.place, group, run);
            settle(two, y, second.place, group, run);
            if (couple >= 0) {
                Wrench rest = model_.sum(model_.sum(known, nonzero(x, first.place)), nonzero(y, second.place));
                settle_couple(couple, board_.opposite(model_.moment(rest, first.place)), group, run);
            }
            return true;
        }
        if (couple >= 0) return false;
        if (is_along(known, first) && !board_.on_line(second.place, first.line))
            if (auto found = strings(group, actors_on(group, loads, run), *known.force, first, second.place)) {
                say_of(group, Sentence::funicular_parallel, {symbol_on(one, group), symbol_on(two, group)}, "Culmann");
                const auto [x, y] = by_strings(*std::move(found), one, two, *known.force, group, run);
                settle(one, x, first.place, group, run);
                settle(two, y, second.place, group, run);
                return true;
            }
        const auto x = by_moments(first, second.place, known);
        if (!x) return false;
        say_of(group, Sentence::parallel_forces, {symbol_on(one, group), symbol_on(two, group)}, "Ritter");
        settle(one, *x, first.place, group, run);
        Wrench rest;
        rest.force = known.force ? board_.add(*known.force, *x) : *x;
        settle(two, opposite_along(rest, second.direction), second.place, group, run);
        return true;
    }

    Wrench nonzero(Force force, PlaceOnDrawing place) { return board_.is_zero(force) ? Wrench{} : wrench_at(force, place); }

    /// Culmann: three lines that neither meet in one point nor are all parallel. The line through the meet of two pairs carries
    /// the sum of each pair.
    bool three_lines(const Group& group, const std::vector<int>& fixed, const Wrench& known, const std::vector<Load>& loads,
                     Run& run) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int one = fixed[i], two = fixed[(i + 1) % 3], three = fixed[(i + 2) % 3];
            const Action a = *run.reactions[at(one)].action, b = *run.reactions[at(two)].action,
                         c = *run.reactions[at(three)].action;
            if (board_.parallel(b.direction, c.direction)) continue;
            const PlaceOnDrawing pivot = *board_.meet(b.line, c.line);
            if (board_.on_line(pivot, a.line)) return false;  // concurrent: only a force through that point is held
            const auto [first, rest] = known_and_one(group, known, one, two, three, pivot, loads, run);
            settle(one, first, a.place, group, run);
            const auto [x, y] = triangle(rest, b.direction, c.direction);
            settle(two, x, b.place, group, run);
            settle(three, y, c.place, group, run);
            return true;
        }
        return false;
    }

    /// The force of the first of three lines, and what it makes with the known one: along Culmann's line where the two meet, by
    /// moments about the pivot of the other two where they are parallel, or a couple.
    std::pair<Force, Wrench> known_and_one(const Group& group, const Wrench& known, int one, int two, int three,
                                           PlaceOnDrawing pivot, const std::vector<Load>& loads, Run& run) {
        const Action a = *run.reactions[at(one)].action;
        Wrench rest;
        rest.place = pivot;
        if (known.force && !board_.parallel(board_.direction(*known.force), a.direction)) {
            const PlaceOnDrawing met = *board_.meet(model_.line_of(known), a.line);
            if (!board_.coincide(met, pivot)) {
                say_resultant(group, known, loads, run);
                const std::string one_meet = meet_name(group, met), other_meet = meet_name(group, pivot);
                say_of(group, Sentence::culmann_line,
                       {PointName{one_meet}, PointName{other_meet}, symbol_on(one, group), symbol_on(two, group),
                        symbol_on(three, group)},
                       "Culmann");
                const auto [first, pair] = triangle(known, a.direction, board_.direction(board_.vector(met, pivot)));
                if (!board_.is_zero(pair)) rest.force = board_.negate(pair);
                if (rest.force) note_culmann(group, one, one_meet + other_meet, *rest.force, met, loads, run);
                return {first, rest};
            }
        }
        const auto first = by_moments(a, pivot, known);
        KG_ASSERT(first, "a line that does not pass the pivot has a lever about it");
        say_of(group, Sentence::culmann,
               {PointName{meet_name(group, pivot)}, symbol_on(one, group), symbol_on(two, group), symbol_on(three, group)},
               "Ritter");
        rest.force = known.force ? board_.add(*known.force, *first) : *first;
        if (board_.is_zero(*rest.force)) rest.force.reset();
        return {*first, rest};
    }

    // --- superposition and trials --------------------------------------------------------------------------------------------
    Run solve(const std::vector<Load>& loads) {
        Run direct = fresh();
        advance(loads, direct);
        if (direct.complete) return direct;
        if (redundant_) return in_every_equilibrium(loads, std::move(direct));
        // Several loaded bodies: one after the other.
        Group loaded;
        for (const Load& load : loads) {
            if (!in(loaded, load.member)) loaded.push_back(load.member);
        }
        if (loaded.size() < 2) {
            Run run = direct;
            close_by_trial(loads, run, 0);
            return run.complete ? run : direct;
        }
        std::vector<PartRun> parts;
        for (const MemberIndex member : loaded) {
            std::vector<Load> own;
            std::copy_if(loads.begin(), loads.end(), std::back_inserter(own),
                         [&](const Load& load) { return load.member == member; });
            mark_ = model_.member_name(member);
            say(Sentence::superposition, {BodyName{mark_}});
            PartRun part{member, own, fresh(), statement_, none};
            advance(own, part.run);
            if (!part.run.complete) close_by_trial(own, part.run, 0);
            mark_.clear();
            if (!part.run.complete) return direct;  // what the rules found without trials holds whatever the rest is
            if (!parts.empty()) parts.back().end = part.first;
            parts.push_back(std::move(part));
        }
        say(Sentence::superposition_sum, {});
        parts.back().end = statement_;
        return add_up(std::move(parts));
    }

    Run add_up(std::vector<PartRun> parts) {
        Run total = fresh();
        fit(total);
        for (Reaction& reaction : total.reactions) {
            reaction = {};
            reaction.known = true;
        }
        for (PartRun& part : parts) {
            fit(part.run);
            add_to(total, part.run, std::nullopt);
        }
        total.complete = true;
        found_in_parts(total);
        total.parts = std::move(parts);
        total.summed = statement_;
        return total;
    }
    /// The sentence said last gives all at once.
    void found_in_parts(Run& run) const {
        run.in_parts = true;
        for (Reaction& reaction : run.reactions) reaction.line_statement = reaction.force_statement = statement_;
    }

    /// a + s·b, bond by bond.
    Run combine(Run a, ScalarHandle share_a, Run b, ScalarHandle share_b) {
        fit(a);
        fit(b);
        Run total = a;
        for (Reaction& reaction : total.reactions) {
            if (reaction.force) reaction.force = board_.scale<Plane::force>(share_a, *reaction.force);
            if (reaction.force && board_.is_zero(*reaction.force)) reaction.force.reset();
            if (reaction.couple) reaction.couple = board_.product(share_a, *reaction.couple);
        }
        add_to(total, b, share_b);
        found_in_parts(total);
        return total;
    }

    void add_to(Run& total, const Run& b, std::optional<ScalarHandle> factor) {
        for (std::size_t i = 0; i < b.reactions.size(); ++i) {
            Reaction& sum_of = total.reactions[i];
            sum_of.known = true;
            const Reaction& more = b.reactions[i];
            if (more.force) {
                const Force scaled = factor ? board_.scale<Plane::force>(*factor, *more.force) : *more.force;
                sum_of.force = sum_of.force ? board_.add(*sum_of.force, scaled) : scaled;
                if (board_.is_zero(*sum_of.force)) sum_of.force.reset();
            }
            if (more.couple) {
                const ScalarHandle scaled = factor ? board_.product(*factor, *more.couple) : *more.couple;
                sum_of.couple = sum_of.couple ? board_.sum(*sum_of.couple, scaled) : scaled;
                if (board_.is_zero(*sum_of.couple)) sum_of.couple.reset();
            }
            sum_of.action.reset();
            sum_of.deduced = false;
        }
        for (const Resolved& resolved : b.order) note({resolved.member}, total);
    }

    /// The last rule. One unknown gets two trial values; each is drawn; what does not close
    /// then tells in which proportion they must be added, for everything is linear. Several unknowns nest.
    void close_by_trial(const std::vector<Load>& loads, Run& run, int depth) {
        constexpr int deepest = 8;
        if (depth > deepest) return;
        int tried = -1, hinge = -1;
        for (std::size_t b = 0; b < model_.bonds().size() && tried < 0; ++b) {
            if (run.reactions[b].known) continue;
            const Shape of = shape(static_cast<int>(b), run);
            if (of == Shape::line || of == Shape::couple) tried = static_cast<int>(b);
            if (of == Shape::pin && hinge < 0) hinge = static_cast<int>(b);
        }
        if (tried >= 0) {
            try_value(loads, run, tried, depth);
        } else if (hinge >= 0) {
            model_.add_components(hinge);
            fit(run);
            close_by_trial(loads, run, depth);
        }
    }

    /// A force along the bond's own line, or its couple.
    bool try_value(const std::vector<Load>& loads, Run& run, int b, int depth) {
        say(Sentence::trial, {marked(model_.bonds()[at(b)].symbol, mark_)}, "");
        Run first = run, second = run;
        // Primes, others at each depth: trial values that cancelled each other would look like a body without forces.
        static constexpr int sizes[][2] = {{2, 3}, {5, 7}, {11, 13}, {17, 19}, {23, 29}, {31, 37}, {41, 43}, {47, 53}, {59, 61}};
        const std::optional<Force> largest = largest_of(loads);
        give(first, b, sizes[depth][0], largest);
        give(second, b, sizes[depth][1], largest);
        ++trials_;
        for (Run* trial : {&first, &second}) {
            advance(loads, *trial);
            if (!trial->complete) close_by_trial(loads, *trial, depth + 1);
        }
        --trials_;
        if (!first.complete || !second.complete) return false;
        const auto [gap, change] = clearest_gap(loads, first, second);
        if (!change) return false;
        const ScalarHandle share = board_.quotient(gap, *change);
        run = combine(first, board_.difference(board_.number(1), share), second, share);
        run.complete = true;
        return true;
    }

    /// Of what does not close in the first trial that which changes most to the second: components before moments.
    std::pair<ScalarHandle, std::optional<ScalarHandle>> clearest_gap(const std::vector<Load>& loads, const Run& first,
                                                                      const Run& second) {
        ScalarHandle gap;
        std::optional<ScalarHandle> largest;
        for (const auto& components : {std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{2}}) {
            for (const MemberIndex member : model_.moving_members()) {
                const auto gap_1 = gaps(member, loads, first), gap_2 = gaps(member, loads, second);
                for (const std::size_t c : components) {
                    const ScalarHandle change = board_.difference(gap_1[c], gap_2[c]);
                    if (board_.is_zero(change)) continue;
                    if (largest && !board_.choose_longer(as_force(change), as_force(*largest))) continue;
                    gap = gap_1[c];
                    largest = change;
                }
            }
            if (largest) break;
        }
        return {gap, largest};
    }

    /// A couple as long as a force of so many newtons, to be compared with forces.
    Force as_force(ScalarHandle couple) { return board_.scale<Plane::force>(couple, board_.own_direction({1, 0})); }

    std::optional<Force> largest_of(const std::vector<Load>& loads) {
        std::optional<Force> largest;
        for (const Load& load : loads) {
            const Force size = load.force ? *load.force : as_force(*load.couple);
            if (!largest || board_.choose_longer(size, *largest)) largest = size;
        }
        return largest;
    }

    /// Declares a bond known, of a trial size along its line or as a couple; of the order of the largest load.
    void give(Run& run, int b, int size, const std::optional<Force>& largest) {
        Reaction& reaction = run.reactions[at(b)];
        const Bond& bond = model_.bonds()[at(b)];
        reaction.known = true;
        const bool is_couple = shape(b, run) == Shape::couple;
        const auto times = [&](const Exact& power) {
            const ScalarHandle number = board_.number(size * power);
            return is_couple ? as_force(number) : board_.scale<Plane::force>(number, reaction.action->direction);
        };
        const Exact power = largest ? power_of_ten_reaching(board_, *largest, times) : Exact(1);
        if (is_couple) {
            reaction.couple = board_.number(size * power);
            return;
        }
        reaction.force = times(power);
        if (bond.kind != Bond::Kind::guide) return;
        const ScalarHandle turning = board_.moment(board_.vector(bond.place, reaction.action->place), *reaction.force);
        if (!board_.is_zero(turning)) reaction.couple = turning;
    }

    /// What does not close at a member: components along x and y, and the moment about one fixed place.
    std::array<ScalarHandle, 3> gaps(MemberIndex member, const std::vector<Load>& loads, const Run& run) {
        return model_.gap(member, loads, run, origin_);
    }

    // --- redundant structures ------------------------------------------------------------------------------------------------
    /// What every equilibrium has alike, one after the other by virtual work; after each the rules go on from there. At last the
    /// components of what stays open.
    Run in_every_equilibrium(const std::vector<Load>& loads, Run run) {
        while (!run.complete && settle_alike(loads, run)) advance(loads, run);
        for (const Group& group : groups_in_question(model_, run)) {
            if (group.size() > Equilibria::most_members) {
                run.beyond_members = Equilibria::most_members;
                continue;
            }
            Equilibria all = equilibria(group, loads, run);
            if (!all.exist()) continue;
            run.redundant.insert(run.redundant.end(), group.begin(), group.end());
            for (const int b : in_question(group, run)) note_alike(b, all.of(b), all, run);
        }
        return run;
    }
    Equilibria equilibria(const Group& group, const std::vector<Load>& loads, const Run& run) {
        return {model_, board_, run, group, origin_, [&](MemberIndex member) { return gaps(member, loads, run); }};
    }
    /// Efforts first, then what has fewest unknowns.
    std::vector<int> in_question(const Group& group, const Run& run) const {
        std::set<int> bonds;
        for (const MemberIndex member : group)
            for (const int b : model_.bonds_of(member))
                if (!run.reactions[at(b)].known) bonds.insert(b);
        std::vector<int> sorted(bonds.begin(), bonds.end());
        const auto rank = [&](int b) {
            const Bond& bond = model_.bonds()[at(b)];
            const bool one = bond.kind == Bond::Kind::line || bond.kind == Bond::Kind::couple;
            return bond.effort >= 0 ? 0 : one ? 1 : bond.kind == Bond::Kind::clamp ? 3 : 2;
        };
        std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return rank(a) < rank(b); });
        return sorted;
    }
    bool settle_alike(const std::vector<Load>& loads, Run& run) {
        for (const Group& group : groups_in_question(model_, run)) {
            if (group.size() > Equilibria::most_members) continue;
            Equilibria all = equilibria(group, loads, run);
            if (!all.exist()) continue;
            for (const int b : in_question(group, run)) {
                const Equilibria::Alike alike = all.of(b);
                if (!alike.all) continue;
                settle_by_work(b, alike, all, run);
                return true;
            }
        }
        return false;
    }
    /// The body of a bond that is cut free to speak of it.
    Group cut_at(int b) const {
        const Bond& bond = model_.bonds()[at(b)];
        return {bond.first == member_of(frame) ? bond.second : bond.first};
    }
    /// Of a determined reaction: each component, then the couple.
    void settle_by_work(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
        const Group on = cut_at(b);
        const Bond& bond = model_.bonds()[at(b)];
        const bool reversed = !in(on, bond.first);
        std::optional<Force> force = said_components(b, alike, all, run);
        std::optional<ScalarHandle> couple = said_couple(b, alike, all, run);
        if (force && reversed) force = board_.negate(*force);
        if (couple && reversed) couple = board_.opposite(*couple);
        if (force && couple) return settle_with_couple(b, *force, *couple, on, run);
        if (force) return settle(b, *force, place_of(b, run), on, run);
        if (couple) return settle_couple(b, *couple, on, run);
        found(b, on, run);
    }
    /// On the bond's first member; nothing: it vanishes.
    std::optional<Force> said_components(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
        std::optional<Force> force;
        const bool apart = alike.components.size() > 1 || !alike.whole_force;  // else the symbol says it all
        for (const Equilibria::Component& each : alike.components) {
            // That a force has nothing across the line of its body is said with the line.
            if (each.vanishes && apart && run.reactions[at(b)].deduced) continue;
            Symbol symbol = symbol_on(b, cut_at(b));
            if (apart) symbol = component_symbol(symbol, each.direction);
            say_work(b, std::move(symbol), each.direction, each.motion, all, run);
            if (!each.vanishes) run.released.back().force = each.force;
            if (!each.vanishes) force = force ? board_.add(*force, each.force) : each.force;
        }
        return force;
    }
    std::optional<ScalarHandle> said_couple(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
        if (!alike.couple) return std::nullopt;
        Symbol symbol = symbol_on(b, cut_at(b));
        symbol.letter = Symbol::Letter::M;
        say_work(b, std::move(symbol), std::nullopt, alike.couple->motion, all, run);
        run.released.back().couple = alike.couple->couple;
        if (alike.couple->couple && !in(cut_at(b), model_.bonds()[at(b)].first))
            run.released.back().couple = board_.opposite(*alike.couple->couple);  // as the symbol counts it
        return alike.couple->couple;
    }
    /// x and y, else n and t: of a direction, and of that across it.
    std::pair<std::string, std::string> axes(DirectionHandle along) {
        if (board_.parallel(along, board_.own_direction({1, 0}))) return {"x", "y"};
        if (board_.parallel(along, board_.own_direction({0, 1}))) return {"y", "x"};
        return {"n", "t"};
    }
    Symbol component_symbol(Symbol symbol, DirectionHandle along) {
        symbol.term += (symbol.term.empty() ? "" : ",") + axes(along).first;
        return symbol;
    }
    /// Of a reaction that stays open.
    void note_alike(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run) {
        if (alike.components.empty() && !alike.couple) return;
        const std::optional<Force> force = said_components(b, alike, all, run);
        Reaction& reaction = run.reactions[at(b)];
        if (!alike.components.empty()) {
            reaction.alike = alike.whole_force ? Reaction::Alike::force : Reaction::Alike::component;
            reaction.force = force;
            reaction.along = alike.components.front().direction;
            std::tie(reaction.axis, reaction.across) = axes(*reaction.along);
        }
        reaction.couple = said_couple(b, alike, all, run);
        reaction.couple_alike = alike.couple.has_value();
        const bool said = !run.released.empty() && run.released.back().bond == b;
        reaction.force_statement = said ? statement_ : reaction.line_statement;
    }

    /// By moments or components of one body (or of several as one) where they move as one, else by the works.
    void say_work(int b, Symbol symbol, std::optional<DirectionHandle> along, const Equilibria::Motion& motion, Equilibria& all,
                  Run& run) {
        Released released;
        released.bond = b;
        released.sought = symbol;
        released.along = along;
        const bool of_bodies = std::any_of(motion.members.begin(), motion.members.end(),
                                           [&](const auto& each) { return !model_.is_pin(each.first); });
        Group moved;
        Names turning, centres, translating;
        for (const auto& [member, twist] : motion.members) {
            if (of_bodies && model_.is_pin(member)) continue;
            moved.push_back(member);
            Released::Turning each{member, twist.turn, all.centre(twist), {}};
            if (each.centre) each.name = name_at(moved, *each.centre);
            (each.centre ? turning : translating).push_back(model_.member_name(member));
            if (each.centre) centres.push_back(each.name);
            released.members.push_back(std::move(each));
        }
        // One centre is named once.
        if (std::adjacent_find(centres.begin(), centres.end(), std::not_equal_to<>()) == centres.end())
            centres.resize(std::min<std::size_t>(centres.size(), 1));
        const bool as_one = of_bodies ? all.moves_as_one(motion) : moved.size() == 1;
        if (as_one && !centres.empty()) {
            say_of(moved, Sentence::moments_alone, {PointName{centres.front()}, symbol}, "Ritter");
        } else if (as_one) {
            say_of(moved, Sentence::components_alone, {symbol});
        } else {
            say(Sentence::virtual_work_alone, {symbol, turning, centres, translating}, "", moved);
        }
        released.statement = statement_;
        if (!run.reactions[at(b)].known && run.reactions[at(b)].line_statement == none)
            run.reactions[at(b)].line_statement = statement_;
        run.released.push_back(std::move(released));
    }
    /// Of a point of the file, or a letter of its own.
    std::string name_at(const Group& group, PlaceOnDrawing place) {
        for (const PointIndex point : indices_of(mechanism_.points))
            if (board_.coincide(board_.place(point), place)) return mechanism_.point(point).name;
        return meet_name(group, place);
    }

    /// The components of a hinge that was tried by them are its force again.
    void gather_components(Run& run) {
        for (PartRun& part : run.parts) gather(part.run);
        gather(run);
        model_.drop_components();
    }
    void gather(Run& run) {
        fit(run);
        for (std::size_t b = model_.joint_bonds(); b < model_.bonds().size(); ++b) {
            Reaction& hinge = run.reactions[at(model_.bonds()[b].part_of)];
            Reaction& part = run.reactions[b];
            if (!part.known) hinge.known = false;
            if (part.force) hinge.force = hinge.force ? board_.add(*hinge.force, *part.force) : *part.force;
            if (hinge.force && board_.is_zero(*hinge.force)) hinge.force.reset();
            part.force.reset();
        }
        run.reactions.resize(model_.joint_bonds());
    }

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    PlaceOnDrawing origin_;  ///< about which gaps are measured
    std::set<MemberIndex> adrift_;
    bool redundant_;
    std::vector<Group> wholes_;     ///< structures hung on the frame, which no effort moves: cut free whole first
    long attempts_left_ = 500'000;  ///< of rules in trials: nobody draws on a system that large
    int trials_ = 0;                ///< trials under way, one in the other
    bool of_truss_ = false;         ///< what is cut free whole is a truss
    std::map<MemberIndex, std::string> bar_names_;
    std::string mark_;                                            ///< of the member whose loads act alone just now
    StatementIndex statement_ = none;                             ///< said last
    NamedMeets meets_;                                            ///< by member
    std::vector<NamedMeet> named_meets_;                          ///< all, each with its letter
    std::vector<std::pair<Group, std::ptrdiff_t>> unsaid_meets_;  ///< of groups; indices in named_meets_
};

/// Bars by which a truss hangs on the frame, alone at an unloaded hinge; and rollers, on which two forces only act.
Group hung_bars(const ForceModel& model, Board& board, const TrussStructure& truss) {
    Group hung;
    for (const TrussStructure::Pin& pin : truss.pins) {
        if (pin.hinges.empty() || pin.bars.size() != 1) continue;
        const ElementIndex here = board.place(pin.point).element;
        const bool loaded =
            std::any_of(model.loads().begin(), model.loads().end(), [&](const Load& load) { return load.place.element == here; });
        if (!loaded) hung.push_back(member_of(truss.bars[at(pin.bars.front())].body));
    }
    for (const Bond& bond : model.bonds())
        if (bond.kind == Bond::Kind::guide) hung.push_back(bond.first == member_of(frame) ? bond.second : bond.first);
    return hung;
}

/// All that is given on a truss as one force, and where the lines of the reactions meet it.
std::optional<Truss::Whole> whole_of(ForceModel& model, const NamedMeets& meets, const Run& run) {
    Group all;
    for (const MemberIndex member : model.moving_members()) all.push_back(member);
    Run loads_alone;
    loads_alone.reactions.resize(run.reactions.size());
    const Wrench given = model.known_on(all, model.loads(), loads_alone);
    Truss::Whole whole;
    for (const Reaction& reaction : run.reactions)
        if (reaction.known) whole.statement = std::max(whole.statement, reaction.force_statement);
    if (whole.statement == none || !given.force) return std::nullopt;
    whole.force = Recorded<Vector>::at(given.force->element);
    whole.through = Recorded<Vector>::at(given.place.element);
    for (const auto& [member, named] : meets)
        for (const NamedMeet& meet : named) {
            const bool listed =
                std::any_of(whole.meets.begin(), whole.meets.end(), [&](const auto& each) { return each.name == meet.name; });
            if (!listed) whole.meets.push_back({meet.name, Recorded<Vector>::at(meet.place.element), meet.statement});
        }
    return whole;
}

/// The whole first, then pin by pin; where that does not lead to the end, body by body.
/// Equilibrium does not determine everything.
bool is_redundant(const Mechanism& mechanism, const Mobility& mobility) {
    return mobility.repeated() > 0 || static_cast<int>(mechanism.efforts.size()) > mobility.effective;
}

ForceResults draw_truss(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility,
                        const TrussStructure& truss) {
    const Board::Mark before = board.mark();
    Statement opening;
    opening.section = Topic::forces;
    opening.message = {Sentence::truss_whole,
                       {Count{static_cast<int>(truss.bars.size())}, Count{static_cast<int>(truss.pins.size())}}};
    board.state(std::move(opening));
    Rules rules(model, board, mechanism, {}, false);
    std::map<MemberIndex, std::string> names;
    for (const TrussStructure::Bar& bar : truss.bars) names.emplace(member_of(bar.body), bar.name);
    const Run whole = rules.whole(hung_bars(model, board, truss), std::move(names));
    TrussDrawing drawing(model, board, mechanism, truss, whole);
    if (drawing.resolve()) {
        const Run run = drawing.run(whole);
        ForceResults results = cut_free(model, board, mechanism, mobility, run, rules.meets(), {}, false);
        results.truss = drawing.finish(run);
        results.truss->whole = whole_of(model, rules.meets(), whole);
        for (const Unsolved& missing : drawing.unsolved()) results.unsolved.push_back(missing);
        if (!drawing.has_plan())
            results.remarks.push_back({Sentence::truss_without_plan, {Count{static_cast<int>(truss.bars.size())}}});
        return results;
    }
    board.rewind(before);
    Rules one_by_one(model, board, mechanism, {}, is_redundant(mechanism, mobility));
    const Run run = one_by_one.run();
    ForceResults results = cut_free(model, board, mechanism, mobility, run, one_by_one.meets(), {});
    if (!run.complete || !results.unsolved.empty()) return results;
    TrussDrawing bars(model, board, mechanism, truss, run);
    bars.read_off(run);
    results.truss = bars.finish(run);
    results.remarks.push_back({Sentence::truss_without_order, {Count{static_cast<int>(truss.bars.size())}}});
    return results;
}

}  // namespace
}  // namespace statics

ForceResults draw_forces(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility) {
    const Mechanism& mechanism = structure.mechanism();
    if (mechanism.points.empty()) return {};
    statics::ForceModel model(structure, board, motion);
    if (!model.missing().empty()) {
        ForceResults results;
        results.unsolved = model.missing();
        return results;
    }
    const std::vector<statics::Loose> loose = statics::loose_bodies(model, board, mechanism, mobility);
    std::set<statics::MemberIndex> adrift;
    for (const statics::Loose& each : loose)
        if (!each.balanced) adrift.insert(each.group.begin(), each.group.end());
    if (const auto truss = truss_of(mechanism)) return statics::draw_truss(model, board, mechanism, mobility, *truss);
    statics::Rules rules(model, board, mechanism, std::move(adrift), statics::is_redundant(mechanism, mobility));
    const statics::Run run = rules.run();
    return statics::cut_free(model, board, mechanism, mobility, run, rules.meets(), loose);
}

}  // namespace kinegraph
