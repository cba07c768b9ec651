// What all equilibria of a group of connected bodies have in common, if equilibrium does not determine all forces. The
// equations are eliminated on the board, so every decision is recorded and results are exact.
//
// Each equation, and each linear combination of them, is a virtual motion of the bodies (principle of virtual work).
// The coefficient of an unknown is its power in that motion; the right-hand side is the power of the known forces.
// After Gauss–Jordan elimination, an unknown (or a component of a force) that is alone in a combination has the same
// value in every equilibrium, and that combination is the virtual motion that gives it. If a combination has no unknown
// but non-zero power, there is no equilibrium.
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
    /// None: the value is zero.
    using Cell = std::optional<ScalarHandle>;
    /// Resultant of the known forces on a member: components along x and y, and the moment about the origin of motions.
    using Gap = std::array<ScalarHandle, 3>;
    /// A virtual motion of the members, and the power of the known forces in it.
    struct Motion {
        /// A place moves by (x, y) + turn · z ∧ (place − origin).
        struct Twist {
            Cell x, y, turn;
        };
        std::map<MemberIndex, Twist> members;  ///< only those that move
        Cell power;
    };
    /// A component of a bond's force on its first member that is the same in every equilibrium.
    struct Component {
        Force force;  ///< not set if `vanishes`
        bool vanishes = false;
        DirectionHandle direction;  ///< direction of the component
        Motion motion;              ///< in which no other unknown does work
    };
    struct Couple {
        Cell couple;  ///< on the first member
        Motion motion;
    };
    struct Alike {
        std::vector<Component> components;  ///< hinge or clamp: both of x and y, one, or none; line or guide: its force
        bool whole_force = false;           ///< the components are the whole force
        std::optional<Couple> couple;
        bool all = false;  ///< the reaction is determined
    };

    /// For members connected by bonds that are unknown in `run`. `origin`: moments of `gap` are about it.
    Equilibria(const ForceModel& model, Board& board, const Run& run, Group group, PlaceOnDrawing origin,
               const std::function<Gap(MemberIndex)>& gap);

    /// Whether the known forces allow an equilibrium.
    bool exist() const { return exist_; }
    /// The motions that all constraints and input forces allow.
    const std::vector<Motion>& free_motions() const { return free_; }
    Alike of(int bond);
    /// The force of a hinge that equilibrium determines: its component along a direction, then the one across it. The
    /// first is known in the second's motion and may do work there. Precondition: `of(bond).all`, of a hinge.
    Alike of(int bond, DirectionHandle first);

    /// The place about which a member turns; none if it translates.
    std::optional<PlaceOnDrawing> centre(const Motion::Twist& twist);
    /// The direction in which a member translates. Precondition: it does not turn, and it moves.
    DirectionHandle direction(const Motion::Twist& twist);
    /// Whether all moving members move as one rigid body.
    bool moves_as_one(const Motion& motion);

    /// Whether the virtual motion of each equation is followed. Above `most_followed` members it is not, and motions
    /// are empty: nobody would draw it, and the motions, which fill in, would cost most.
    bool follows_motions() const { return group_.size() <= most_followed; }
    std::size_t equations() const { return rows_.size(); }
    static constexpr std::size_t most_followed = 24;

private:
    /// (x, y) as a vector of the drawing.
    VectorOn<drawing> shift(const Motion::Twist& twist);

    struct Column {
        int bond;
        std::optional<Force> unit;  ///< on the first member; none for a couple
    };
    struct Row {
        std::vector<Cell> work;    ///< by column
        std::vector<Cell> motion;  ///< by equation; empty if motions are not followed
        Cell power;
        int pivot = -1;
    };

    void add_columns(int bond);
    void write(const Column& column, std::size_t index);
    void write_end(const Column& column, std::size_t index, MemberIndex member, bool reversed);
    void eliminate();
    void eliminate_in_turn();
    void eliminate_sparse();
    /// The column with the fewest entries in rows without a pivot; none if all are empty or have been pivots.
    std::optional<std::size_t> sparsest_column(const std::vector<bool>& is_pivot) const;
    /// Subtracts the row's multiple that clears the column.
    void clear(Row& row, const Row& pivot, std::size_t column);
    std::optional<std::size_t> pivot_row(std::size_t column);
    Cell minus_times(const Cell& from, const Cell& factor, const Cell& what);
    Cell times(const Cell& factor, const Cell& what);
    void divide(Row& row, ScalarHandle by);
    void subtract(Row& row, const Row& other, ScalarHandle factor);
    Motion motion_of(const Row& row) const;
    /// The motion for the same force with as few moving members as possible: free motions do no work, so they may be
    /// subtracted.
    /// `known`: of a force that is known by then, so that its work does not matter.
    Motion simplest(Row row, const Row* known = nullptr);
    std::size_t moving(const Row& row) const;
    /// The row in which a column is the pivot; null if the column is free.
    const Row* row_of(std::size_t column) const;
    /// By free column: derivative of a column's unknown.
    std::vector<Cell> change_of(std::size_t column);
    static bool vanishes(const std::vector<Cell>& cells);
    /// c_0 · row of the first + c_1 · row of the second.
    Row combined(const Cell& c_0, std::size_t first, const Cell& c_1, std::size_t second);
    std::optional<Component> component(std::size_t first, std::size_t second);
    /// c · F of the force with these two columns, from the combination of their rows.
    Component component(const Cell& c_0, std::size_t first, const Cell& c_1, std::size_t second, const Row& sum,
                        Motion motion);
    /// The columns of a bond's force, and of its couple.
    std::pair<std::vector<std::size_t>, std::optional<std::size_t>> columns_of(int bond) const;
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

/// Connected components of the members other than the frame, over unknown bonds.
std::vector<Group> groups_in_question(const ForceModel& model, const Run& run);

}  // namespace kinegraph::statics
