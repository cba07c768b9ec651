// Maps each statement of the solution to the figure that shows it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/text/language.hpp"

namespace kinegraph::render {

struct ShownStatement {
    StatementIndex statement;
    FigureId figure;  ///< of WantedFigures, or the mechanism
};

class StatementFigures {
public:
    /// Both are kept by reference.
    StatementFigures(const Solution& solution, const WantedFigures& wanted) : solution_(solution), wanted_(wanted) {}

    std::vector<ShownStatement> all() const;
    /// Whether it is a truss whose bars are not cut free one by one.
    bool is_truss() const { return solution_.truss && solution_.free_bodies.empty(); }

private:
    const Statement& statement(StatementIndex index) const { return statements()[at_index(index)]; }
    const std::vector<Statement>& statements() const { return solution_.protocol.statements; }
    /// Statements by section, in the order in which sections begin: a sliding found after the centres stands with its
    /// polygon. A second derivation of a result follows the section of the first.
    std::vector<StatementIndex> in_order() const;
    /// For all loads or for those that act alone.
    FigureId figure_of_forces(StatementIndex statement) const;
    /// `polygon`: the polygon in which it draws; −1: none.
    FigureId figure_of_truss(StatementIndex statement, int polygon) const;
    static bool completes_a_polygon(const LoadCase& loads, StatementIndex statement);
    bool is_plane_of_motion(int polygon) const;
    FigureId figure_of_curvature(BodyIndex body) const;
    std::optional<FigureId> first_polygon_of(Topic section) const;

    const Solution& solution_;
    const WantedFigures& wanted_;
};

/// The names in statements, as in `data-name` and as in the figures.
std::set<std::string> names_cited(const Solution& solution, const std::vector<StatementIndex>& indices,
                                  Language language);
/// The groups of the bodies that the statements name; if there are none, of the joints.
std::set<GroupId> groups_spoken_of(const Solution& solution, const std::vector<StatementIndex>& indices);

}  // namespace kinegraph::render
