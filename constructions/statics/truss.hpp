// Trusses drawn: bars that carry nothing by rule, the cuts of the file, pin after pin, and a cut where no pin leads on;
// then the forces at the joints, and the plan. Owns the order of these; each rule has a file of its own in
// constructions/truss/. Which forces the frame exerts it is told, or finds at the pins.
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
    /// `whole`: with the reactions that the truss cut free whole gave.
    TrussDrawing(ForceModel& model, Board& board, const Mechanism& mechanism, const TrussStructure& truss,
                 const Run& whole);
    TrussDrawing(const TrussDrawing&) = delete;
    TrussDrawing& operator=(const TrussDrawing&) = delete;

    /// All bars; false where pins and cuts do not lead to the end, or what is given is not in equilibrium.
    bool resolve();
    /// The bars of a run that was resolved in another way: a bar pulls with what acts on its end at the other side of
    /// the pull, the joints' forces there and its loads.
    void read_off(const Run& run);
    /// The forces at the joints.
    Run run(Run from);
    /// What was found; what a cut of the file's did not find.
    Truss finish();
    const std::vector<Unsolved>& unsolved() const { return cuts_.unsolved(); }
    bool has_plan() const { return plan_.exists(); }

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
