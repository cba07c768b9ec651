// Which figure a statement of the solution is read on, and what of it the statement speaks.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/text/language.hpp"

namespace kinegraph::render {

struct ShownStatement {
    StatementIndex statement;
    std::string figure;  ///< name among the wanted figures, or "mechanism"
};

class StatementFigures {
public:
    /// Both are kept by reference.
    StatementFigures(const Solution& solution, const WantedFigures& wanted) : solution_(solution), wanted_(wanted) {}

    std::vector<ShownStatement> all() const;
    /// "-load-3"; empty: all loads.
    std::string load_at(StatementIndex statement) const;
    /// Its bars are not cut free one by one.
    bool is_truss() const { return solution_.truss && solution_.free_bodies.empty(); }

private:
    const Statement& statement(StatementIndex index) const { return statements()[at_index(index)]; }
    const std::vector<Statement>& statements() const { return solution_.protocol.statements; }
    bool is_wanted(const std::string& name) const;
    /// Statements section by section, as each section is opened: a sliding told after the centres stands with its
    /// polygon. What is found a second time comes after the section that has found it.
    std::vector<StatementIndex> in_order() const;
    /// Under all loads, or under those that act alone.
    std::string figure_of_forces(StatementIndex statement) const;
    /// `polygon`: in which it draws; −1: in none.
    std::string figure_of_truss(StatementIndex statement, int polygon) const;
    static bool completes_a_polygon(const Solution& solution, StatementIndex statement);
    bool is_plane_of_motion(int polygon) const;
    std::string first_polygon_of(Topic section) const;

    const Solution& solution_;
    const WantedFigures& wanted_;
};

/// What statements name, as `data-name` has it and as the figures write it.
std::set<std::string> names_cited(const Solution& solution, const std::vector<StatementIndex>& indices,
                                  Language language);
/// Ids of the groups of the mechanism's bodies that the statements name, or else of the joints.
std::set<std::string> groups_spoken_of(const Solution& solution, const std::vector<StatementIndex>& indices);

}  // namespace kinegraph::render
