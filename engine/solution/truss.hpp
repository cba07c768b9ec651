// Trusses: bars pinned at both ends and loaded only at their pins, supported on the frame by hinges, by supports along
// a line and by rollers (a body hinged to the bars at the point where a guide constrains it). Owns the recognition of
// trusses, the names of bars, and the results. Computes no forces.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/number/recorded.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// Pins, bars and supports of a mechanism that is a truss. Pins and bars are counted from 0.
struct TrussStructure {
    struct Bar {
        BodyIndex body = none;
        std::array<int, 2> pins{};  ///< in the file's order of points
        std::string name;           ///< "AB": the names of its pins, in that order
    };
    struct Pin {
        PointIndex point = none;
        std::vector<int> bars;
        std::vector<JointIndex> hinges;    ///< on the frame
        std::vector<JointIndex> supports;  ///< on the frame, each with a reaction along one line
    };
    std::vector<Pin> pins;  ///< in the file's order of points
    std::vector<Bar> bars;  ///< in the file's order of bodies

    const std::string& name_of(const Mechanism& mechanism, int pin) const {
        return mechanism.point(pins[static_cast<std::size_t>(pin)].point).name;
    }
    /// "AB" and "BA" are one bar; −1: there is no such bar.
    int bar_named(const Mechanism& mechanism, std::string_view name) const;
    /// The pin of a bar that is not `pin`.
    int other_end(int bar, int pin) const {
        const auto& ends = bars[static_cast<std::size_t>(bar)].pins;
        return ends[0] == pin ? ends[1] : ends[0];
    }
};

/// The truss structure of a mechanism; empty if it is not a truss: three bars or more, as many bars and reactions as
/// twice the pins, no effort, no driver, no load except at pins.
std::optional<TrussStructure> truss_of(const Mechanism& mechanism);

/// The parts of a cut: connected pins, with one end of each cut bar. Empty where the cut does not separate the truss.
/// Of two parts the first has fewer reactions. `passed`: known bars, which may be cut too.
std::vector<std::vector<int>> sides_of_cut(const TrussStructure& truss, const std::vector<int>& bars,
                                           const std::vector<int>& passed = {});

/// Results of a truss.
struct Truss {
    TrussStructure structure;
    struct Bar {
        /// N: the force of the bar on its first pin. Tension if it points along the bar away from the pin. None for a
        /// bar without force.
        Recorded<Vector> force;
        StatementIndex statement = none;  ///< the statement that finds it
        bool idle_by_rule = false;        ///< without force, by a rule that needs no drawing
        std::optional<double> numeric;    ///< N, by the check
        int left = -1, right = -1;        ///< spaces on its left and right, seen from its first pin; −1: there is no
                                          ///< plan
    };
    std::vector<Bar> bars;  ///< by TrussStructure::bars
    /// The external actions, in the order of the plan where there is one: clockwise round the truss.
    struct External {
        int pin = -1;
        Recorded<Vector> force;   ///< N
        JointIndex joint = none;  ///< a reaction of the frame
        int given = -1;           ///< or a load: index in Mechanism::loads
        Symbol symbol;
        StatementIndex statement = none;  ///< the statement that finds it; none: it is given
        int before = -1, after = -1;      ///< spaces on either side, clockwise round the truss
    };
    std::vector<External> externals;
    /// Bow's notation: a region between bars and lines of forces; a corner of the plan.
    struct Space {
        std::string letter;  ///< outside a, b, c …; inside 1, 2, 3 …
        bool outside = false;
        std::vector<int> pins{};  ///< along its border; outside clockwise round the truss
    };
    std::vector<Space> spaces;
    int polygon = -1;  ///< index in Protocol::polygons of the plan (Cremona); −1: bars cross, or there are no forces
    /// One equation of a cut (Ritter).
    struct Cut {
        std::vector<int> bars;   ///< all that are cut
        std::vector<int> side;   ///< pins of the part considered
        int found = -1;          ///< the bar whose force it gives
        Recorded<Vector> pivot;  ///< intersection of the other two, m; none: they are parallel
        std::string pivot_name;  ///< of a pin, or a new letter
        Recorded<Exact> moment;  ///< moment of all known actions on the part about the pivot, N m; across the parallel
                                 ///< bars: N m, too
        StatementIndex statement = none;
        bool asked = false;  ///< requested by the file
    };
    std::vector<Cut> cuts;
    /// The truss cut free whole: the resultant of the given loads, and the intersections of lines of action. None where
    /// the pins gave the reactions.
    struct Whole {
        Recorded<Vector> force, through;  ///< N; m, on its line
        struct Meet {
            std::string name;
            Recorded<Vector> place;
            StatementIndex statement = none;
        };
        std::vector<Meet> meets;
        StatementIndex statement = none;  ///< after which the reactions are known
    };
    std::optional<Whole> whole;

    /// known + N arm = 0, up to signs: moment of the known actions about the pivot (N m) and the arm of the bar (m);
    /// where the other bars are parallel, the component of the known actions across them (N) and the sine of the bar's
    /// angle with them.
    struct CutNumbers {
        double known = 0, arm = 0;
    };
    CutNumbers numbers_of(const Cut& cut, const std::vector<Vector>& places) const;
    /// N of a bar, tension positive; `places` are those of the points. Where its force is known.
    double tension(std::size_t bar, const std::vector<Vector>& places) const;
};

}  // namespace kinegraph
