#include "render/sheet/sheet_limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/pages.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

namespace {

double largest_coordinate(const Vector& v) { return std::max(std::abs(v.x.to_double()), std::abs(v.y.to_double())); }

/// Whether the points lie so far from the origin, or one of them so far away, that the doubles of a drawing do not tell
/// the points of a body apart. Of the bodies' sizes the middle one counts.
bool is_far_from_origin(const Solution& solution) {
    double reach = 0;
    for (const Vector& at : solution.pose.points) reach = std::max(reach, largest_coordinate(at));
    // Between these shares of the reach, two points are one that is given twice, by numbers of sixteen digits.
    const double exact = 1e-20 * reach, rounded = 1e-12 * reach;
    std::vector<double> sizes;
    for (const Body& body : solution.mechanism.bodies) {
        double size = 0;
        for (const PointIndex point : body.points)
            size = std::max(size, largest_coordinate(solution.pose.at(point) - solution.pose.at(body.points.front())));
        if (size > 0 && (size < exact || size > rounded)) sizes.push_back(size);
    }
    if (sizes.empty()) return false;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return reach > most_sizes_from_origin * *middle;
}

}  // namespace

bool is_planned_twice(const Solution& solution) {
    const std::size_t loads = solution.mechanism.loads.size();
    return solution.protocol.statements.size() + loads <= most_compared && loads <= most_compared_loads &&
           solution.protocol.polygons.size() <= most_compared_polygons;
}

std::optional<Words> beyond_doubles(const Solution& solution) {
    if (is_far_from_origin(solution)) return Words(lang::pages::points_far_from_the_origin);
    return std::nullopt;
}

std::optional<Words> beyond_paper(const Page& page) {
    if (!can_be_written(page.marks)) return Words(lang::pages::a_figure_goes_beyond_its_page);
    return std::nullopt;
}

std::optional<Words> beyond_sheet(const Solution& solution) {
    const std::size_t sentences = solution.protocol.statements.size(), polygons = solution.protocol.polygons.size();
    if (sentences > most_sentences)
        return Words(lang::pages::a_sheet_of_this_solution, std::to_string(sentences), std::to_string(most_sentences));
    if (polygons > most_polygons)
        return Words(lang::pages::a_sheet_of_this_solution_would_have, std::to_string(polygons),
                     std::to_string(most_polygons));
    if (const std::size_t freedoms = solution.displacements ? solution.displacements->freedoms.size() : 0;
        freedoms > most_displacements)
        return Words(lang::pages::a_sheet_of_this_solution_would_show, std::to_string(freedoms),
                     std::to_string(most_displacements));
    if (const std::size_t bodies = solution.mechanism.bodies.size(); bodies > most_drawn_bodies)
        return Words(lang::pages::a_drawing_of_many_bodies, std::to_string(bodies), std::to_string(most_drawn_bodies));
    return std::nullopt;
}

std::optional<Words> beyond_steps(const Solution& solution) {
    if (auto beyond = beyond_sheet(solution)) return beyond;
    if (const std::size_t pages = solution.protocol.statements.size(); pages > most_steps)
        return Words(lang::pages::steps_of_many_pages, std::to_string(pages), std::to_string(most_steps));
    return std::nullopt;
}

}  // namespace kinegraph::render
