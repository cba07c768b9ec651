// Where equilibrium does not determine everything: in which order what every equilibrium has alike is told, and by
// which sentence, one force after the other by moments, components or virtual work. What is alike, Equilibria says.
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

    /// What every equilibrium has alike, one after the other by virtual work; after each the rules go on from there. At
    /// last the components of what stays open.
    Run in_every_equilibrium(const std::vector<Load>& loads, Run run);

private:
    Equilibria equilibria(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Efforts first, then what has fewest unknowns.
    std::vector<int> in_question(const Group& group, const Run& run) const;
    bool settle_alike(const std::vector<Load>& loads, Run& run);
    /// The body of a bond that is cut free to speak of it.
    Group cut_at(int b) const;
    /// Of a determined reaction: each component, then the couple.
    void settle_by_work(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// On the bond's first member; nothing: it vanishes.
    std::optional<Force> said_components(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    std::optional<ScalarHandle> said_couple(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// x and y, else n and t: of a direction, and of that across it.
    std::pair<std::string, std::string> axes(DirectionHandle along);
    Symbol component_symbol(Symbol symbol, DirectionHandle along);
    /// Of a reaction that stays open.
    void note_alike(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// By moments or components of one body (or of several as one) where they move as one, else by the works.
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
