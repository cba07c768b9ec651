// What is known of a truss during its solution: the pulls of its bars, the forces of its supports, and the sentences
// that find them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph::statics {

class KnownTruss {
public:
    struct Bar {
        bool known = false;
        std::optional<Force> pull;  ///< on its first pin; none: zero
    };
    /// The action of the frame on a pin: any force from a hinge, else a force along a line.
    struct Support {
        int pin = -1;
        std::vector<int> bonds;  ///< more than one: hinges of several bars on the frame
        std::optional<DirectionHandle> line;
        bool known = false;
        std::optional<Force> force;  ///< on the truss
        StatementIndex statement = none;
    };
    /// A state to return to if a rule fails.
    struct Mark {
        Board::Mark board;
        StatementIndex statement = none;
    };

    KnownTruss(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss);

    ForceModel& model() const { return model_; }
    Board& board() const { return board_; }
    const Mechanism& mechanism() const { return mechanism_; }
    const TrussStructure& structure() const { return truss_; }
    int pins() const { return static_cast<int>(truss_.pins.size()); }

    const std::vector<Bar>& bars() const { return bars_; }
    const Bar& bar(int bar) const { return bars_[at(bar)]; }
    const std::vector<Support>& supports() const { return supports_; }
    /// Loads of the model that act at a pin.
    const std::vector<int>& loads_at(int pin) const { return loads_[at(pin)]; }
    const Load& load(int load) const { return model_.loads()[at(load)]; }
    /// Whether neither a load nor a support acts there.
    bool is_unloaded(int pin) const;
    /// Whether all bars and supports are known.
    bool all_known() const;
    /// The force of a bar on one of its pins; none if it is zero or unknown.
    std::optional<Force> pull_on(int bar, int pin);
    /// Sum of forces at one pin; none is zero.
    std::optional<Force> sum(const std::optional<Force>& a, const std::optional<Force>& b) const;
    /// Pins with external forces.
    std::vector<int> pins_under_forces() const;

    PlaceOnDrawing place(int pin) const { return board_.place(truss_.pins[at(pin)].point); }
    DirectionHandle toward(int bar, int pin) const {
        return board_.direction(board_.vector(place(pin), place(truss_.other_end(bar, pin))));
    }
    /// The line of a bar.
    Action action_of(int bar) const {
        return model_.action(place(truss_.bars[at(bar)].pins[0]), toward(bar, truss_.bars[at(bar)].pins[0]));
    }

    Symbol symbol_of(int bar) const { return {Symbol::Letter::F, truss_.bars[at(bar)].name, {}}; }
    Symbol symbol_of(const Support& support) const;
    PointName name_of(int pin) const { return {truss_.name_of(mechanism_, pin)}; }
    PointName name_of_bar(int bar) const { return {truss_.bars[at(bar)].name}; }
    Names names_of(const std::vector<int>& bars) const;

    StatementIndex say(Key sentence, std::vector<Argument> arguments, const char* source = "");
    /// The last sentence.
    StatementIndex statement() const { return statement_; }
    Message& message() { return board_.statement(statement_).message; }
    /// Found by the last sentence. `pull` is the force on this pin; none or zero if the bar is a zero-force bar.
    void settle(int bar, int pin, const std::optional<Force>& pull);
    void settle(std::size_t support, const std::optional<Force>& force);
    /// Takes a force found by other rules, without a sentence of the truss; `pull` on the first pin.
    void take_bar(int bar, const std::optional<Force>& pull);
    /// Takes the known support forces from a run of the truss as one free body; the others stay unknown.
    void take_supports(const Run& whole);
    Mark mark() const { return {board_.mark(), statement_}; }
    void rewind(const Mark& mark);
    /// The result under construction.
    Truss& found() { return found_; }

private:
    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const TrussStructure& truss_;
    std::vector<Bar> bars_;
    std::vector<Support> supports_;
    std::vector<std::vector<int>> loads_;  ///< by pin
    Truss found_;
    StatementIndex statement_ = none;
};

/// Zero-force bars, found without drawing: sets them to zero one after another, with a sentence each. At an unloaded
/// pin: two bars not in line, the third of three of which two are in line, or a single bar. Bars already known to be
/// zero do not count.
void settle_idle_bars(KnownTruss& truss);

}  // namespace kinegraph::statics
