// Cuts by Ritter's method of moments (Elementare Theorie und Berechnung eiserner Dach- und Brücken-Constructionen,
// 1863): a cut through three bars divides the truss, and each bar has an equation without the other two.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/truss/known_truss.hpp"

namespace kinegraph::statics {

class Cuts {
public:
    explicit Cuts(KnownTruss& truss)
        : truss_(truss), board_(truss.board()), done_(truss.mechanism().find.cuts.size(), false) {}

    /// Makes the cuts requested by the file, for a side with known reactions. `at_last`: those that cannot be made go
    /// to `unsolved`; otherwise they are tried again later.
    void make_those_of_file(bool at_last);
    /// If no pin can be solved: cuts three unknown bars that divide the truss; other cut bars must be known. False if
    /// there are none.
    bool make_any();
    const std::vector<Unsolved>& unsolved() const { return unsolved_; }

private:
    /// An equation that contains only one of the three bars.
    struct Equation {
        std::optional<PlaceOnDrawing> pivot;  ///< none: forces perpendicular to the parallel bars
        ScalarHandle moment, lever;
    };
    bool make(const std::vector<int>& bars, const std::vector<int>& side, bool asked);
    void tell(const std::vector<int>& bars, const std::vector<int>& side, std::size_t sought, const Equation& equation,
              bool asked);
    bool reactions_known(const std::vector<int>& side) const;
    Wrench known_on(const std::vector<int>& side, const std::vector<int>& bars);
    std::optional<Equation> equation_for(const std::vector<int>& bars, std::size_t sought, const Wrench& known);
    std::string name_of_meet(PlaceOnDrawing meet);

    KnownTruss& truss_;
    Board& board_;
    std::vector<bool> done_;  ///< by Find::cuts
    std::vector<std::pair<std::string, PlaceOnDrawing>> meets_;
    std::vector<Unsolved> unsolved_;
};

}  // namespace kinegraph::statics
