// Trusses pin by pin: bars that carry nothing by rule, cuts by Ritter's method of moments (1863), and pin after pin, each with
// two unknowns at most (Cremona 1872). Owns the order and the forces in the bars; which forces the frame exerts it is told, or
// finds at the pins.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "constructions/force_model.hpp"
#include "constructions/truss_plan.hpp"
#include "engine/truss.hpp"

namespace kinegraph::statics {

class TrussDrawing {
public:
    /// `whole`: with the reactions that the truss cut free whole gave.
    TrussDrawing(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss, const Run& whole);

    /// All bars; false where pins and cuts do not lead to the end, or what is given is not in equilibrium.
    bool resolve();
    /// The bars of a run that was resolved in another way.
    void read_off(const Run& run);
    /// The forces at the joints.
    Run run(Run from);
    /// What was found; what a cut of the file's did not find.
    Truss finish(const Run& run);
    const std::vector<Unsolved>& unsolved() const { return unsolved_; }
    bool has_plan() const { return plan_.exists(); }

private:
    struct Bar {
        bool known = false;
        std::optional<Force> pull;  ///< on its first pin; nothing: it carries nothing
    };
    /// What the frame exerts at a pin: by a hinge any force, else one along a line.
    struct Support {
        int pin = -1;
        std::vector<int> bonds;  ///< several: hinges of several bars on the frame
        std::optional<DirectionHandle> line;
        bool known = false;
        std::optional<Force> force;  ///< on the truss
        StatementIndex statement = none;
    };
    /// A bar or a support that is not known, with its direction at a pin.
    struct Unknown {
        int bar = -1, support = -1;
        std::optional<DirectionHandle> along;
    };

    void collect_supports(const Run& whole);
    void note_loads();
    std::vector<int> loaded_pins() const;

    // Places and directions.
    PlaceOnDrawing place(int pin) { return board_.place(truss_.pins[at(pin)].point); }
    DirectionHandle toward(int bar, int pin) {
        return board_.direction(board_.vector(place(pin), place(truss_.other_end(bar, pin))));
    }
    Action action_of(int bar) {
        return model_.action(place(truss_.bars[at(bar)].pins[0]), toward(bar, truss_.bars[at(bar)].pins[0]));
    }
    std::optional<Force> pull_on(int bar, int pin);
    Symbol symbol_of(int bar) const { return {Symbol::Letter::F, truss_.bars[at(bar)].name, {}}; }
    Symbol symbol_of(const Support& support) const;
    PointName name_of(int pin) const { return {truss_.name_of(mechanism_, pin)}; }
    Names names_of(const std::vector<int>& bars) const;

    // Sentences.
    void say(Sentence sentence, std::vector<Argument> arguments, const char* source = "");
    void settle(int bar, int pin, const std::optional<Force>& pull);
    void settle(Support& support, const std::optional<Force>& force);

    // Rules.
    bool all_known() const;
    bool idle_bars();
    bool idle_at(int pin);
    bool is_unloaded(int pin) const;
    std::vector<Unknown> unknown_at(int pin);
    std::optional<Force> known_at(int pin);
    bool resolve_pin(int pin);
    bool close_pin(int pin, const std::vector<Unknown>& unknown);
    void say_pin(int pin, const std::vector<Unknown>& unknown);
    void settle(int pin, const Unknown& unknown, const std::optional<Force>& force);
    bool check_rest();

    // Cuts.
    void cuts_of_file(bool at_last);
    bool any_cut();
    bool cut(const std::vector<int>& bars, const std::vector<int>& side, bool asked);
    bool are_known(const std::vector<int>& side) const;
    Wrench known_on(const std::vector<int>& side, const std::vector<int>& bars);
    struct Equation {
        int bar = -1;
        std::optional<PlaceOnDrawing> pivot;
        ScalarHandle moment, lever;
    };
    std::optional<Equation> equation_for(const std::vector<int>& bars, std::size_t sought, const Wrench& known);
    std::string name_of_meet(PlaceOnDrawing meet);

    bool settle_joints(int pin, Run& run);
    std::vector<OuterForce> outer_forces(const Run& run) const;

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const TrussStructure& truss_;
    TrussPlan plan_;
    std::vector<Bar> bars_;
    std::vector<Support> supports_;
    std::vector<std::vector<int>> loads_;  ///< by pin: of the model
    std::vector<bool> resolved_;           ///< by pin
    Truss found_;
    StatementIndex statement_ = none, opening_ = none;
    std::vector<bool> cut_done_;  ///< by Find::cuts
    std::vector<std::pair<std::string, PlaceOnDrawing>> meets_;
    std::vector<Unsolved> unsolved_;
    bool contradictory_ = false;
};

}  // namespace kinegraph::statics
