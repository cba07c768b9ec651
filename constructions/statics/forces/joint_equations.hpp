// Where no order of bodies leads on: the equilibrium equations of several bodies, solved together by elimination on the
// board, so that every value is recorded and exact.
//
// The smallest sets of bodies are taken whose equations contain no more unknowns than there are equations. They follow
// from a matching of unknowns and equations (Dulmage and Mendelsohn, 1958): the strongly connected components of its
// graph are the sets, in the order in which they can be solved. What has more unknowns than equations, or the reverse,
// is left to EveryEquilibrium.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "constructions/statics/forces/settling.hpp"
#include "constructions/statics/forces/solvable_blocks.hpp"

namespace kinegraph::statics {

class JointEquations {
public:
    JointEquations(ForceModel& model, Board& board, const KnownForces& known, ForceSentences& said)
        : model_(model), board_(board), known_(known), said_(said), settled_(model, board, said) {}

    /// Solves the smallest set of bodies that has as many equations as unknowns. False if no set can be solved; then
    /// nothing is recorded.
    bool advance(const std::vector<Load>& loads, Run& run);

private:
    using Cell = std::optional<ScalarHandle>;  ///< none: zero
    /// An unknown: a component of a bond's force, its couple, or the force in a two-force body.
    struct Unknown {
        struct End {
            MemberIndex member;
            bool reversed = false;
        };
        std::vector<int> bonds;           ///< one; of a two-force body both
        std::optional<MemberIndex> link;  ///< the two-force body, on which `unit` acts at the first of its bonds
        std::optional<Force> unit;        ///< on the first end, or on the link; none for a couple
        PlaceOnDrawing place;
        std::vector<End> ends;
    };
    /// Σ coefficient · unknown + known = 0.
    struct Equation {
        MemberIndex member;
        std::map<std::size_t, ScalarHandle> terms;  ///< by unknown
        Cell known;
    };
    struct System {
        std::vector<Unknown> unknowns;
        std::vector<Equation> equations;
    };
    struct Values {
        std::map<std::size_t, Cell> of;  ///< by unknown
        std::vector<std::size_t> order;  ///< in which they were found
    };

    System system(const std::vector<Load>& loads, const Run& run);
    void add_unknowns(int bond, System& system);
    /// A body with two unknown forces on one line, and nothing else: one unknown, and no equations.
    bool add_link(MemberIndex member, const std::vector<Load>& loads, const Run& run, std::set<int>& taken,
                  System& system);
    void add_equations(MemberIndex member, const std::vector<Load>& loads, const Run& run, System& system);
    /// The place through which most unknown forces on a member pass: their moments about it vanish.
    PlaceOnDrawing moments_about(MemberIndex member, const System& system) const;
    static std::vector<SolvableBlock> blocks(const System& system);
    /// None if the equations are dependent.
    std::optional<Values> solve(const System& system, const SolvableBlock& block);
    /// The row of the largest coefficient of an unknown.
    std::size_t pivot(const std::vector<Equation>& rows, const std::set<std::size_t>& left, std::size_t unknown);
    void subtract(Equation& row, const Equation& other, ScalarHandle factor, std::size_t unknown);
    void say(const System& system, const SolvableBlock& block, const Values& values);
    void settle(const System& system, const SolvableBlock& block, const Values& values, Run& run);

    ForceModel& model_;
    Board& board_;
    const KnownForces& known_;
    ForceSentences& said_;
    Settling settled_;
};

}  // namespace kinegraph::statics
