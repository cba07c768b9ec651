#include "render/sheet/statement_figures.hpp"

#include <algorithm>
#include <map>
#include <variant>

#include "lang/keys/sentences.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/sentences.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

std::vector<ShownStatement> StatementFigures::all() const {
    std::vector<ShownStatement> all;
    std::map<StatementIndex, int> polygon_of;
    const auto note = [&](StatementIndex statement, int polygon) {
        if (statement != none && polygon >= 0) polygon_of.emplace(statement, polygon);
    };
    for (const DrawnVector& vector : solution_.protocol.vectors) note(vector.statement, vector.polygon);
    for (const DrawnLine& line : solution_.protocol.lines) note(line.statement, line.polygon);
    std::map<Topic, std::optional<FigureId>> last_in;  // the last figure, by section
    for (const StatementIndex i : in_order()) {
        const Statement& statement = this->statement(i);
        std::optional<FigureId> figure;
        const auto found = polygon_of.find(i);
        if (is_truss() && statement.section == Topic::forces)
            figure = figure_of_truss(i, found == polygon_of.end() ? -1 : found->second);
        else if (statement.section == Topic::forces)
            figure = figure_of_forces(i);
        else if (statement.section == Topic::curvature)
            figure = figure_of_curvature(statement.bodies.front());
        else if (found != polygon_of.end() && is_plane_of_motion(found->second))
            figure = motion_polygon(solution_, found->second);
        else if (statement.section == Topic::centres || statement.message.sentence == lang::sentences::second_way)
            figure = {FigureKind::centres};
        else
            figure = last_in[statement.section];
        if (!figure) figure = first_polygon_of(statement.section);
        if (!figure || !wanted_.named(*figure)) figure = {FigureKind::mechanism};
        if (statement.message.sentence != lang::sentences::second_way) last_in[statement.section] = figure;
        all.push_back({i, *figure});
    }
    return all;
}

FigureId StatementFigures::figure_of_curvature(BodyIndex body) const {
    const std::vector<Curvature>& all = solution_.curvature;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Curvature& each) { return each.body == body; });
    return {FigureKind::curvature, static_cast<int>(found - all.begin())};
}

std::vector<StatementIndex> StatementFigures::in_order() const {
    std::vector<Topic> sections;
    for (const Statement& statement : statements())
        if (std::find(sections.begin(), sections.end(), statement.section) == sections.end())
            sections.push_back(statement.section);
    const auto section_of = [&](const Statement& statement) {
        const Topic after = follows(statement.message.sentence).value_or(statement.section);
        return std::find(sections.begin(), sections.end(), after) != sections.end() ? after : statement.section;
    };
    std::vector<StatementIndex> order;
    for (const Topic section : sections)
        for (const bool again : {false, true})
            for (const StatementIndex i : indices_of(statements()))
                if (section_of(statement(i)) == section &&
                    (statement(i).message.sentence == lang::sentences::second_way) == again)
                    order.push_back(i);
    return order;
}

FigureId StatementFigures::figure_of_forces(StatementIndex statement) const {
    const LoadCase loads(solution_, part_of(solution_, statement));
    const FigureId sums{FigureKind::partial_sums}, parts{FigureKind::joined_parts},
        forces{FigureKind::forces, -1, loads.part()};
    if (solution_.superposition && solution_.superposition->statement == statement)
        return wanted_.joins_parts() ? parts : wanted_.named(sums) ? sums : forces;
    const bool completes = completes_a_polygon(loads, statement);
    if (completes && loads.is_alone() && wanted_.joins_parts()) return parts;
    if (wanted_.named(forces) && completes) return forces;
    return {FigureKind::lines_of_action, -1, loads.part()};
}

FigureId StatementFigures::figure_of_truss(StatementIndex statement, int polygon) const {
    const std::vector<TakenTogether>& groups = solution_.taken_together;
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (groups[i].statement == statement) return {FigureKind::forces_together, static_cast<int>(i)};
    return {polygon >= 0 && polygon == solution_.truss->polygon ? FigureKind::force_plan : FigureKind::truss};
}

bool StatementFigures::completes_a_polygon(const LoadCase& loads, StatementIndex statement) {
    const auto closes = [&](const auto& each) { return each.statement == statement; };
    return std::any_of(loads.bodies().begin(), loads.bodies().end(),
                       [&](const FreeBody& body) { return has_force_polygon(loads, body) && closes(body); }) ||
           std::any_of(loads.together().begin(), loads.together().end(), closes);
}

bool StatementFigures::is_plane_of_motion(int polygon) const {
    return solution_.protocol.polygons[static_cast<std::size_t>(polygon)].plane != Plane::force;
}

std::optional<FigureId> StatementFigures::first_polygon_of(Topic section) const {
    const std::vector<Polygon>& polygons = solution_.protocol.polygons;
    for (std::size_t i = 0; i < polygons.size(); ++i)
        if (polygons[i].plane == (section == Topic::acceleration ? Plane::acceleration : Plane::velocity))
            return motion_polygon(solution_, static_cast<int>(i));
    return std::nullopt;
}

std::set<std::string> names_cited(const Solution& solution, const std::vector<StatementIndex>& indices,
                                  Language language) {
    std::set<std::string> names;
    for (const StatementIndex index : indices)
        for (const Argument& argument : solution.protocol.statements[at_index(index)].message.arguments)
            if (const auto* symbol = std::get_if<Symbol>(&argument)) {
                names.insert(name_of(*symbol));
                names.insert(plain(typeset(*symbol, language)));
            }
    return names;
}

std::set<GroupId> groups_spoken_of(const Solution& solution, const std::vector<StatementIndex>& indices) {
    std::set<GroupId> links, joints;
    const Mechanism& mechanism = solution.mechanism;
    for (const StatementIndex index : indices) {
        const Statement& statement = solution.protocol.statements[at_index(index)];
        for (const BodyIndex body : statement.bodies)
            links.insert(GroupId({}, element_of("link", mechanism.bodies[at_index(body)].name)));
        for (const Argument& argument : statement.message.arguments) {
            if (const auto* body = std::get_if<BodyName>(&argument))
                links.insert(GroupId({}, element_of("link", body->name)));
            const auto* symbol = std::get_if<Symbol>(&argument);
            if (symbol && (symbol->letter == Symbol::Letter::omega || symbol->letter == Symbol::Letter::alpha))
                links.insert(GroupId({}, element_of("link", symbol->about)));
            const auto* point = std::get_if<PointName>(&argument);
            for (const Joint& joint : mechanism.joints)
                if (point && mechanism.points[at_index(joint.point)].name == point->name)
                    joints.insert(GroupId({}, element_of("joint", joint.name)));
        }
    }
    return links.empty() ? joints : links;
}

}  // namespace kinegraph::render
