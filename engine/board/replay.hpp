// Replay: a program evaluated in doubles, repeatedly, with other givens. It is built once from a program that is cut to
// the wanted elements; a run allocates nothing. Used for sweeps, plots and interactive pages.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/board/program.hpp"

namespace kinegraph {

class Replay {
public:
    /// `size` of the drawing, m: the reference for coincidences in the drawing. Starts with these givens.
    Replay(const Program& program, const std::vector<Value>& givens, double size);

    /// Another value for a given (index in Program::givens), of the same kind.
    void give(int given, const ValueOf<double>& value);
    /// Evaluates every stroke. Returns the index of the first guard that flipped (in Program::guards); later strokes
    /// are not evaluated. Givens that are not finite, or a division that a guard should have excluded, give values that
    /// are not finite.
    std::optional<int> run();

    PointOf<double> point(ElementIndex element) const { return memory_.point(element); }
    VectorOf<double> vector(ElementIndex element) const { return memory_.vector(element); }
    double scalar(ElementIndex element) const { return memory_.scalar(element); }
    std::size_t strokes() const {
        return steps_.size();
    }  ///< strokes carried out by a run; givens and poles do not
       ///< count

private:
    /// Elements stored in a row, three numbers each.
    struct Memory {
        using Number = double;
        struct Cell {
            double x = 0, y = 0, w = 0;
        };
        std::vector<Cell> cells;
        std::vector<char> lines;  ///< whether an element is a line

        const Cell& cell(ElementIndex i) const { return cells[at_index(i)]; }
        PointOf<double> point(ElementIndex i) const { return {cell(i).x, cell(i).y, cell(i).w}; }
        LineOf<double> line(ElementIndex i) const { return {cell(i).x, cell(i).y, cell(i).w}; }
        VectorOf<double> vector(ElementIndex i) const { return {cell(i).x, cell(i).y}; }
        double scalar(ElementIndex i) const { return cell(i).x; }
        bool is_line(ElementIndex i) const { return lines[at_index(i)] != 0; }
        void put(ElementIndex i, const PointOf<double>& p) { cells[at_index(i)] = {p.x, p.y, p.w}; }
        void put(ElementIndex i, const LineOf<double>& l) { cells[at_index(i)] = {l.a, l.b, l.c}; }
        void put(ElementIndex i, const VectorOf<double>& v) { cells[at_index(i)] = {v.x, v.y, 0}; }
        void put(ElementIndex i, double s) { cells[at_index(i)] = {s, 0, 0}; }
    };
    /// Which reference magnitude an element contributes to.
    enum class Noted : std::uint8_t { nothing, vector, scalar };

    /// A stroke that a run carries out. Givens and poles are not.
    struct Step {
        Stroke stroke;
        ElementIndex element = none;
        Noted noted = Noted::nothing;
    };
    void note(const Step& step);
    void carry_out_until(std::size_t end);
    bool holds(const Guard& guard) const;

    std::vector<Stroke> strokes_;  ///< all, by element
    std::vector<Step> steps_;      ///< in the order of a run
    std::vector<Step> noted_givens_;
    std::vector<Guard> guards_;  ///< `before` counts steps_
    std::vector<ElementIndex> element_of_given_;
    int doubtful_bits_ = 0;
    Memory memory_;
    Largest<double> at_start_, largest_;
    std::size_t next_ = 0;  ///< the next of steps_
};

}  // namespace kinegraph
