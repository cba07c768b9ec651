// The chapters of the closure equations: letters, positions, rates, ratios, dead points, reaches.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_pen.hpp"
#include "render/equations/equation_text.hpp"

namespace kinegraph::render::closure {

// ----- The text of the closure equations under construction: a list of headings, sentences, formulas and tables.

class EquationList {
public:
    explicit EquationList(Language language) : in_language_(language) {}

    void heading(const Words& words, bool is_apart = false) {
        items_.push_back({EquationItem::Kind::heading, in(words, in_language_), {}, {}, is_apart});
    }
    void say(const Words& words) { say_text(in(words, in_language_)); }
    /// A sentence that stays with the formula or the table after it.
    void announce(const Words& words) {
        say(words);
        items_.back().announces = true;
    }
    void say_text(std::string words) { items_.push_back({EquationItem::Kind::words, std::move(words), {}, {}}); }
    void set(Formula formula) { items_.push_back({EquationItem::Kind::formula, {}, std::move(formula), {}}); }
    void table(std::vector<std::vector<Formula>> rows) {
        items_.push_back({EquationItem::Kind::table, {}, {}, std::move(rows)});
    }
    std::vector<EquationItem> taken() { return std::move(items_); }

private:
    Language in_language_;
    std::vector<EquationItem> items_;
};

// ----- Results of the equations beside those of the polygons.

class DrawnRates {
public:
    DrawnRates(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_values();

private:
    struct Drawn {
        std::optional<double> rate, acceleration;
    };
    /// The value of a letter from the polygons: rotations of bodies, and slides along their guides.
    Drawn drawn(LetterIndex index) const;
    std::optional<double> direction_of_slide(LetterIndex index) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Positions in which the driver cannot move the mechanism: letters that are at rest in the drawn position, and
// the dead points of each loop along the driver's travel.

class DeadPointText {
public:
    DeadPointText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), pen_(pen), list_(list) {}

    void write_dead_points();

private:
    /// With several loops, each is considered alone: another loop may stop the driver first.
    void write_dead_points_of(const Equations::Loop& loop, std::size_t index);
    Words no_dead_point(bool is_only_loop) const;
    /// Change points; they do not stop the driver.
    Words change_points_of(const Equations::Solved& solved, bool is_only_loop) const;
    std::string list_of(const std::vector<double>& values, LetterIndex of) const;

    const Equations& e_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- The table of letters: given, driven or sought, with their meaning and value.

class LettersTable {
public:
    LettersTable(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_letters();

private:
    Formula what_is(LetterIndex index) const;
    bool is_written(LetterIndex index) const;
    /// "OA" if both ends have names.
    Formula ends_of(LetterIndex length) const;
    /// "O_2", as in the figures.
    static Formula point_name(const std::string& name);
    std::string point_at(const Vector& place) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Positions: the two components of each loop, the closed form of its unknowns if there is one, and the equations
// of rolling and gears.

class PositionText {
public:
    PositionText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_positions();

private:
    /// Left = right, without terms that vanish.
    Formula both_sides(const Equations::Loop& loop, const std::function<Signed(const Side&)>& of) const;
    void write_law(const Equations::Law& law);
    void write_solved(const Equations::Loop& loop, std::size_t index);
    /// p e^{iσ} = …, with numbers.
    void write_resultant(const Equations::Loop& loop, std::size_t index);
    void write_two_turns(const Equations::Loop& loop, std::size_t index);
    void write_turn_and_slide(const Equations::Loop& loop);
    /// sin β = −λ sin α + h/b with λ = a/b, for one known crank and offsets; otherwise the whole right side is divided
    /// by b.
    void write_sine(const Side& first, const std::vector<Side>& known,
                    const std::function<Difference(const Side&)>& against);
    void write_turn_with_slide(const Equations::Loop& loop, std::size_t index);
    void write_turn_with_offset_slide(const Equations::Loop& loop, std::size_t index);
    /// Whether no other loop is solved together with it, so that it is a block of its own.
    bool stands_alone(std::size_t index) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Velocities and accelerations: derivatives of the loops, and the Jacobian block by block with its determinant,
// in symbols and in numbers.

class RateText {
public:
    RateText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_velocities();
    void write_accelerations();

private:
    Formula derived(const Equations::Loop& loop, bool twice) const;
    /// Multiplies every term of a sum by a rate.
    static Sum times_rate(Sum sum, LetterIndex rate, int dots);
    std::size_t column_of(LetterIndex unknown) const;
    bool is_in(const Equations::Block& block, LetterIndex unknown) const;
    /// The known terms of a row, moved to the right side.
    Sum known_terms(const Equations::Block& block, std::size_t row, int dots) const;
    double length_unit() const { return mechanism_.units.length.si.to_double(); }
    bool is_of_turns(std::size_t row) const;
    double in_units(std::size_t row, LetterIndex unknown, double entry) const;
    Formula unknowns_column(const Equations::Block& block, int dots) const;
    Formula matrix(const Equations::Block& block, bool symbols) const;
    const char* between_entries() const;
    /// The entry without the rounding noise of sines of right angles.
    double rounded(double entry) const;
    Formula right_side(const Equations::Block& block, int dots, bool symbols) const;
    /// Determinant of a square block, by Gaussian elimination in doubles; empty if the block is not square.
    std::optional<double> determinant(const Equations::Block& block) const;
    bool rates_known(const Equations::Block& block, int dots) const;
    void write_block(const Equations::Block& block, int dots);
    std::size_t longest_right_side(const Equations::Block& block, int dots) const;
    /// Length of the longest right side, in characters.
    std::size_t widest_right_side(const Equations::Block& block, int dots) const;
    void write_long_right_side(const Equations::Block& block, int dots, Formula left);
    /// J = [J_1 J_2 …], a few columns at a time.
    void write_in_parts(const Equations::Block& block);
    void write_determinant(const Equations::Block& block);
    /// b c sin(γ − β), b cos(β − γ), s: the determinant of a dyad's two rows up to its sign, which follows from the
    /// number.
    std::optional<Formula> closed_determinant(const Equations::Block& block, double found) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Velocity ratios and their derivatives, in the units of the file, and the closed form for a slider-crank.

class RatioText {
public:
    RatioText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_ratios();
    /// With two drivers, also the mixed derivatives.
    void write_second_ratios();

private:
    /// d of/d by; with several drivers ∂ of/∂ by.
    Formula derivative(LetterIndex of, LetterIndex by) const;
    Formula second_derivative(LetterIndex of, LetterIndex first, LetterIndex second) const;
    /// The subscript of Λ: the coordinate, and with several drivers also the driver.
    std::string index_of(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    std::string plain_sub(LetterIndex of) const { return unicode_letter(pen_.letter(of).symbol) + pen_.letter(of).sub; }
    /// Unit of `of` divided by the units of the others, with the file's unit of length.
    std::string ratio_unit(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    double ratio_in_units(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    Formula ratio_value(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    /// Slider-crank, a e^{iα} + b e^{iβ} = c: dc/dα = −a (sin α − cos α tan β).
    std::optional<Formula> closed_ratio(LetterIndex of, LetterIndex by) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Open chains: position, velocity and acceleration of the end point, and the same as seen by an observer on the
// last body but one.

class ReachText {
public:
    ReachText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_reaches();

private:
    struct Group {
        std::vector<Signed> terms{};
        std::array<double, 2> value{0, 0};
        void add(Signed term) { terms.push_back(std::move(term)); }
    };
    /// A complex number in m/s or m/s², converted to the units of the file.
    Formula complex(const std::array<double, 2>& of, QuantityKind kind) const;
    /// If the last two bodies rotate relative to each other: the motion seen by an observer on the previous body, and
    /// the terms to add.
    bool write_groups(const Equations::Reach& reach);
    /// Adds (radial + i across) z.
    static void add(std::array<double, 2>& to, const std::array<double, 2>& z, double radial, double across);
    double rate(const std::vector<LetterIndex>& letters, int dots) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
