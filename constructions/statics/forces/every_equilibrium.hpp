// In which order, and by which sentences, values are given that equilibrium determines where no order of bodies leads
// on: one force after the other by moments, components or virtual work, or in a large group all by elimination. In a
// statically indeterminate structure these are the values that all equilibria share. Class Equilibria computes them.
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
    /// Where there is one equilibrium: one force after the other, each time the one whose equations move the fewest
    /// bodies; after each, applies the rules again. Leaves large groups alone.
    Run one_by_one(const std::vector<Load>& loads, Run run);

private:
    Equilibria equilibria(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Input forces first, then the groups with fewest unknowns.
    std::vector<int> in_question(const Group& group, const Run& run) const;
    /// All that is determined in a group whose virtual motions are not followed, in one sentence.
    void by_elimination(const Group& group, Equilibria& all, Run& run);
    bool settle_alike(const std::vector<Load>& loads, Run& run);
    bool settle_shortest(const std::vector<Load>& loads, Run& run);
    /// Ways to take the force of a bond apart: as it is, and for a hinge, its part across the join with another hinge
    /// of its bodies, about which the moments give it.
    std::vector<std::optional<DirectionHandle>> ways_of(int b, const Group& group, const Run& run);
    Equilibria::Alike taken_apart(int b, const std::optional<DirectionHandle>& way, Equilibria& all);
    /// How long the equations are that give a force: by the bodies that they move, more if these move apart.
    std::size_t price_of(const Equilibria::Alike& alike, Equilibria& all) const;
    /// The free body used to explain a bond.
    Group cut_at(int b) const;
    /// For a determined reaction: each component, then the couple.
    void settle_by_work(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    /// On the bond's first member; none if it vanishes.
    std::optional<Force> said_components(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    std::optional<ScalarHandle> said_couple(int b, const Equilibria::Alike& alike, Equilibria& all, Run& run);
    Group acting_on(int b, const Equilibria::Motion& motion) const;
    std::string axis_of(const Equilibria::Alike& alike, bool is_second);
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

    /// Sentences of what all equilibria share, or of the only one.
    struct Told {
        Key moments, components, translation, virtual_work;
    };
    const Told& told() const;
    /// Known reactions on the bodies of a motion, which do work in it.
    std::vector<VirtualMotion::Known> known_on(const Group& moved, const Run& run) const;

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Rules& rules_;
    Settling settled_;
    PlaceOnDrawing origin_;
    bool is_only_ = false;  ///< there is one equilibrium
};

}  // namespace kinegraph::statics
