// Equilibria: what all equilibria of bodies that hang together have alike, where equilibrium does not determine
// everything. The equations are eliminated on the board, so every verdict is recorded and what is found is exact. It
// knows bonds and wrenches, no sentence.
//
// An equation, or any combination of them, is a virtual motion of the bodies (principle of virtual work): what stands
// in it under an unknown is the power of that unknown, and beside the unknowns stands the power of all that is known.
// After elimination (Gauss, Jordan) an unknown, or a component of a force, that stands alone in a combination is the
// same in every equilibrium, and that combination is the motion by which virtual work gives it. Where none stands and a
// power is left over, there is no equilibrium.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

class Equilibria {
public:
    /// Nothing: it vanishes.
    using Cell = std::optional<ScalarHandle>;
    /// What the known forces on a member leave: components along x and y, and the moment about the origin of motions.
    using Gap = std::array<ScalarHandle, 3>;
    /// How the members move, and the power of what is known in it.
    struct Motion {
        /// Each place moves by (x, y) + turn · z ∧ (place − origin).
        struct Twist {
            Cell x, y, turn;
        };
        std::map<MemberIndex, Twist> members;  ///< that move
        Cell power;
    };
    /// Of a bond's force on its first member that every equilibrium has alike.
    struct Component {
        Force force;  ///< nothing of it where `vanishes`
        bool vanishes = false;
        DirectionHandle direction;  ///< along which it is counted
        Motion motion;              ///< in which it alone of the unknowns does work
    };
    struct Couple {
        Cell couple;  ///< on the first member
        Motion motion;
    };
    struct Alike {
        std::vector<Component>
            components;            ///< of a hinge or clamp both, of x and y, one, or none; of a line or guide its force
        bool whole_force = false;  ///< they are the force
        std::optional<Couple> couple;
        bool all = false;  ///< the reaction is determined
    };

    /// Of members that hang together by bonds that `run` does not know. `origin`: about which `gap` takes its moments.
    Equilibria(const ForceModel& model, Board& board, const Run& run, Group group, PlaceOnDrawing origin,
               const std::function<Gap(MemberIndex)>& gap);

    /// Whether what is known allows an equilibrium at all.
    bool exist() const { return exist_; }
    /// The motions that every constraint and effort allow.
    const std::vector<Motion>& free_motions() const { return free_; }
    Alike of(int bond);

    /// The place about which a member turns; nothing: it translates.
    std::optional<PlaceOnDrawing> centre(const Motion::Twist& twist);
    /// Whether all that move, move as one body.
    bool moves_as_one(const Motion& motion);

    /// More equations are not eliminated: nobody redoes that by hand.
    static constexpr std::size_t most_members = 24;

private:
    struct Column {
        int bond;
        std::optional<Force> unit;  ///< on the first member; nothing: a couple
    };
    struct Row {
        std::vector<Cell> work;    ///< by column
        std::vector<Cell> motion;  ///< by equation
        Cell power;
        int pivot = -1;
    };

    void add_columns(int bond);
    void write(const Column& column, std::size_t index);
    void write_end(const Column& column, std::size_t index, MemberIndex member, bool reversed);
    void eliminate();
    std::optional<std::size_t> pivot_row(std::size_t column);
    Cell minus_times(const Cell& from, const Cell& factor, const Cell& what);
    Cell times(const Cell& factor, const Cell& what);
    void divide(Row& row, ScalarHandle by);
    void subtract(Row& row, const Row& other, ScalarHandle factor);
    Motion motion_of(const Row& row) const;
    /// The same force found by as few moving members as may be: free motions do no work, so any of them may be taken
    /// away.
    Motion simplest(Row row);
    std::size_t moving(const Row& row) const;
    /// The row in which a column is the pivot; none: the column is free.
    const Row* row_of(std::size_t column) const;
    /// By free column: how the unknown of a column changes with it.
    std::vector<Cell> change_of(std::size_t column);
    static bool vanishes(const std::vector<Cell>& cells);
    /// c_0 · row of the first + c_1 · row of the second.
    Row combined(const Cell& c_0, std::size_t first, const Cell& c_1, std::size_t second);
    std::optional<Component> component(std::size_t first, std::size_t second);
    Component along_unit(std::size_t column);

    const ForceModel& model_;
    Board& board_;
    Group group_;
    PlaceOnDrawing origin_;
    std::map<MemberIndex, std::size_t> first_row_;
    std::vector<Column> columns_;
    std::vector<Row> rows_;
    std::vector<std::size_t> free_columns_;
    std::vector<Motion> free_;
    bool exist_ = true;
};

/// Members other than the frame that hang together by bonds that are not known, each group once.
std::vector<Group> groups_in_question(const ForceModel& model, const Run& run);

}  // namespace kinegraph::statics
