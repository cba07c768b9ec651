// Solves and draws a truss: zero-force bars, the cuts requested by the file, pin after pin, then a cut if no pin can be
// solved; then the forces at the joints, and the plan. Decides the order of these; each rule has its own file in
// constructions/statics/truss/. The reactions are given, or found at the pins.
#pragma once

#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/truss/cuts.hpp"
#include "constructions/statics/truss/known_truss.hpp"
#include "constructions/statics/truss/pin_by_pin.hpp"
#include "constructions/statics/truss_plan.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph::statics {

class TrussDrawing {
public:
    /// `whole`: contains the reactions found for the truss as one free body.
    TrussDrawing(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss,
                 const Run& whole);
    TrussDrawing(const TrussDrawing&) = delete;
    TrussDrawing& operator=(const TrussDrawing&) = delete;

    /// Finds all bars; false if pins and cuts do not give all of them, or the given forces are not in equilibrium.
    bool resolve();
    /// Takes the bars from a run that was solved by other rules: the pull of a bar is opposite to the sum of the forces
    /// and loads on its other end.
    void read_off(const Run& run);
    /// The forces at the joints.
    Run run(Run from);
    /// The result; includes cuts requested by the file that could not be made.
    Truss finish();
    const std::vector<Unsolved>& unsolved() const { return cuts_.unsolved(); }
    bool has_plan() const { return plan_.exists(); }
    /// A remark.
    Message why_no_plan() const;

private:
    void open_plan();
    bool settle_joints(int pin, Run& run);
    std::vector<OuterForce> outer_forces() const;

    ForceModel& model_;
    Board& board_;
    const TrussStructure& truss_;
    KnownTruss known_;
    TrussPlan plan_;
    PinByPin pins_;
    Cuts cuts_;
    StatementIndex opening_ = none;  ///< of the plan
};

}  // namespace kinegraph::statics
