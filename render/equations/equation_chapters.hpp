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

// ----- The list that the text of the closure equations is made of, as it grows: headings, sentences, formulas, tables
// in their order.

class EquationList {
public:
    explicit EquationList(Language language) : language_(language) {}

    void heading(const Words& words, bool is_apart = false) {
        items_.push_back({EquationItem::Kind::heading, in(words, language_), {}, {}, is_apart});
    }
    void say(const Words& words) { say_text(in(words, language_)); }
    void say_text(std::string words) { items_.push_back({EquationItem::Kind::words, std::move(words), {}, {}}); }
    void set(Formula formula) { items_.push_back({EquationItem::Kind::formula, {}, std::move(formula), {}}); }
    void table(std::vector<std::vector<Formula>> rows) {
        items_.push_back({EquationItem::Kind::table, {}, {}, std::move(rows)});
    }
    std::vector<EquationItem> taken() { return std::move(items_); }

private:
    Language language_;
    std::vector<EquationItem> items_;
};

// ----- What the equations give, beside what the polygons give of the same.

class DrawnRates {
public:
    DrawnRates(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_values();

private:
    struct Drawn {
        std::optional<double> rate, acceleration;
    };
    /// What the polygons say of a letter: turns of bodies, and slides along their guides.
    Drawn drawn(LetterIndex index) const;
    std::optional<double> direction_of_slide(LetterIndex index) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Where the driver cannot drive: letters that rest in the drawn position, and the dead points of each loop along
// the driver's travel.

class DeadPointText {
public:
    DeadPointText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), pen_(pen), list_(list) {}

    void write_dead_points();

private:
    /// Of several loops each speaks for itself alone: another may stop the driver.
    void write_dead_points_of(const Equations::Loop& loop, std::size_t index);
    Words no_dead_point(bool is_only_loop) const;
    /// They stop no driver.
    Words change_points_of(const Equations::Solved& solved, bool is_only_loop) const;
    std::string list_of(const std::vector<double>& values, LetterIndex of) const;

    const Equations& e_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- The table of the letters: what is given, driven and sought, what each is and measures.

class LettersTable {
public:
    LettersTable(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_letters();

private:
    Formula what_is(LetterIndex index) const;
    bool is_written(LetterIndex index) const;
    /// "OA" where both ends have names.
    Formula ends_of(LetterIndex length) const;
    /// "O_2", as figures have it.
    static Formula point_name(const std::string& name);
    std::string point_at(const Vector& place) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Positions: each loop with its two parts, and the closed form of its unknowns where there is one; laws of
// rolling and gears.

class PositionText {
public:
    PositionText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_positions();

private:
    /// Left = right; terms that vanish are left out.
    Formula both_sides(const Equations::Loop& loop, const std::function<Signed(const Side&)>& of) const;
    void write_law(const Equations::Law& law);
    void write_solved(const Equations::Loop& loop, std::size_t index);
    /// p e^{iσ} = …, with its numbers.
    void write_resultant(const Equations::Loop& loop, std::size_t index);
    void write_two_turns(const Equations::Loop& loop, std::size_t index);
    void write_turn_and_slide(const Equations::Loop& loop);
    /// sin β = −λ sin α + h/b, λ = a/b, where one crank and offsets are known; else all over b.
    void write_sine(const Side& first, const std::vector<Side>& known,
                    const std::function<Difference(const Side&)>& against);
    void write_turn_with_slide(const Equations::Loop& loop, std::size_t index);
    void write_turn_with_offset_slide(const Equations::Loop& loop, std::size_t index);
    /// No loop that is solved together with it: it is a block of its own.
    bool stands_alone(std::size_t index) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Velocities and accelerations: the loops derived, the Jacobian block by block with its determinant, in symbols
// and in numbers.

class RateText {
public:
    RateText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_velocities();
    void write_accelerations();

private:
    Formula derived(const Equations::Loop& loop, bool twice) const;
    /// A sum's terms with one rate more.
    static Sum times_rate(Sum sum, LetterIndex rate, int dots);
    std::size_t column_of(LetterIndex unknown) const;
    bool is_in(const Equations::Block& block, LetterIndex unknown) const;
    /// What a row's known terms make, sent to the right.
    Sum known_terms(const Equations::Block& block, std::size_t row, int dots) const;
    double length_unit() const { return mechanism_.units.length.si.to_double(); }
    bool is_of_turns(std::size_t row) const;
    double in_units(std::size_t row, LetterIndex unknown, double entry) const;
    Formula unknowns_column(const Equations::Block& block, int dots) const;
    Formula matrix(const Equations::Block& block, bool symbols) const;
    /// Without the dust that sines of right angles leave.
    double rounded(double entry) const;
    Formula right_side(const Equations::Block& block, int dots, bool symbols) const;
    /// Of a square block, by elimination in doubles.
    std::optional<double> determinant(const Equations::Block& block) const;
    bool rates_known(const Equations::Block& block, int dots) const;
    void write_block(const Equations::Block& block, int dots);
    std::size_t longest_right_side(const Equations::Block& block, int dots) const;
    /// Characters of the longest row.
    std::size_t widest_right_side(const Equations::Block& block, int dots) const;
    void write_long_right_side(const Equations::Block& block, int dots, Formula left);
    /// J = [J_1 J_2 …], a few columns each.
    void write_in_parts(const Equations::Block& block);
    void write_determinant(const Equations::Block& block);
    /// b c sin(γ − β), b cos(β − γ), s: of a dyad's two rows, up to the sign, which the number tells.
    std::optional<Formula> closed_determinant(const Equations::Block& block, double found) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Velocity ratios and their derivatives, in the units of the file; the closed form that the slider-crank has.

class RatioText {
public:
    RatioText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_ratios();
    /// Of two drivers the mixed ones too.
    void write_second_ratios();

private:
    /// d of/d by; of several drivers' coordinates ∂ of/∂ by.
    Formula derivative(LetterIndex of, LetterIndex by) const;
    Formula second_derivative(LetterIndex of, LetterIndex first, LetterIndex second) const;
    /// The index of Λ: the coordinate, and of several drivers' which of them.
    std::string index_of(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    std::string plain_sub(LetterIndex of) const { return unicode_letter(pen_.letter(of).symbol) + pen_.letter(of).sub; }
    /// What rad or m of `of` is for each of the others, in the file's unit of length.
    std::string ratio_unit(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    double ratio_in_units(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    Formula ratio_value(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    /// Of the slider-crank a e^{iα} + b e^{iβ} = c: dc/dα = −a (sin α − cos α tan β).
    std::optional<Formula> closed_ratio(LetterIndex of, LetterIndex by) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

// ----- Open chains: place, velocity and acceleration of the point they reach, and the same as an observer on the last
// body but one has them.

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
    /// A complex number of metres a second, or a second squared, as the file has them.
    Formula complex(const std::array<double, 2>& of, QuantityKind kind) const;
    /// Where the last bodies turn against each other: what an observer on the one before sees, and what he adds.
    bool write_groups(const Equations::Reach& reach);
    /// (radial + i across) z.
    static void add(std::array<double, 2>& to, const std::array<double, 2>& z, double radial, double across);
    double rate(const std::vector<LetterIndex>& letters, int dots) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
