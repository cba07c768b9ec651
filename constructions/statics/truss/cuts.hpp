// Cuts by Ritter's method of moments (Elementare Theorie und Berechnung eiserner Dach- und Brücken-Constructionen,
// 1863): three bars part the truss, and an equation for each holds it alone.
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

    /// The cuts that the file asks for, of a side whose reactions are known. `at_last`: those that cannot be made are
    /// told in `unsolved`; otherwise they wait.
    void make_those_of_file(bool at_last);
    /// Where no pin leads on: three unknown bars that part the truss, other bars cut being known. False: there are
    /// none.
    bool make_any();
    const std::vector<Unsolved>& unsolved() const { return unsolved_; }

private:
    /// That holds one of the three bars alone.
    struct Equation {
        std::optional<PlaceOnDrawing> pivot;  ///< nothing: across the parallel ones
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
