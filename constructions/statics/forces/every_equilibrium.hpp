// Statically indeterminate structures: in which order, and by which sentences, the values that all equilibria share are
// given: one force after the other by moments, components or virtual work, or in a large group all by elimination.
// Class Equilibria computes them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/equilibria.hpp"
#include "constructions/statics/forces/rules.hpp"

namespace kinegraph::statics {

class EveryEquilibrium {
public:
    EveryEquilibrium(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said, Rules& rules,
                     PlaceOnDrawing origin)
        : model_(model),
          board_(board),
          known_(known),
          said_(said),
          rules_(rules),
          settled_(model, board, said),
          origin_(origin) {}

    /// Adds the values that all equilibria share, one after the other by virtual work; after each, applies the rules
    /// again. Finally adds the determined components of reactions that stay open.
    Run in_every_equilibrium(const std::vector<Load>& loads, Run run);

private:
    Equilibria equilibria(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Input forces first, then the groups with fewest unknowns.
    std::vector<int> in_question(const Group& group, const Run& run) const;
    /// All that is determined in a group whose virtual motions are not followed, in one sentence.
    void by_elimination(const Group& group, Equilibria& all, Run& run);
    bool settle_alike(const std::vector<Load>& loads, Run& run);
    /// The free body used to explain a bond.
    Group cut_at(int b) const;
    /// For a determined reaction: each component, then the couple.
    void settle_by_work(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// On the bond's first member; none if it vanishes.
    std::optional<Force> said_components(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    std::optional<ScalarHandle> said_couple(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// Names x and y, or n and t if the direction is oblique; for the direction and its perpendicular.
    std::pair<std::string, std::string> axes(DirectionHandle along);
    Symbol component_symbol(Symbol symbol, DirectionHandle along);
    /// Notes the determined part of a reaction that stays open.
    void note_alike(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// By components: along the line of the force sought, or in the direction of the translation.
    void say_translation(const Group& moved, const Symbol& symbol, std::optional<DirectionHandle> along,
                         DirectionHandle way);
    /// By moments or components of one body (or of several as one) if they move as one, else by virtual work.
    void say_work(int b, Symbol symbol, std::optional<DirectionHandle> along, const Equilibria::Motion& motion,
                  Equilibria& all, Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Rules& rules_;
    Settling settled_;
    PlaceOnDrawing origin_;
};

}  // namespace kinegraph::statics
