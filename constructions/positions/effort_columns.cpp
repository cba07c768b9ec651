#include "constructions/positions/effort_columns.hpp"

#include <algorithm>
#include <utility>

#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

void EffortColumns::add(const Solution& solution, std::vector<Column>& columns) {
    if (!solution.displacements) return;
    const EffortRows::Efforts found = EffortRows::of(*solution.displacements);
    for (std::size_t e = 0; e < found.size(); ++e) {
        const bool by_forces = e < solution.efforts.size() && solution.efforts[e].value;
        if (!found[e] || by_forces) continue;
        add_columns({.kind = Quantity::Kind::effort, .given = static_cast<int>(e)}, mechanism_, {}, columns);
        by_work_.push_back(e);
    }
    if (!by_work_.empty() && mechanism_.inertia_forces) find_columns_of_masses(solution, columns);
}

void EffortColumns::find_columns_of_masses(const Solution& solution, const std::vector<Column>& all) {
    const auto column = [&](const Quantity& quantity) {
        return static_cast<std::size_t>(
            std::find_if(all.begin(), all.end(), [&](const Column& each) { return each.quantity == quantity; }) -
            all.begin());
    };
    for (const Mass& mass : mechanism_.masses) {
        const auto centre = std::find_if(solution.points.begin(), solution.points.end(), [&](const PointMotion& each) {
            return each.point == mass.centre &&
                   std::find(each.bodies.begin(), each.bodies.end(), mass.body) != each.bodies.end();
        });
        MassColumns& columns = mass_columns_.emplace_back();
        columns.alpha = column(alpha_of(mass.body));
        if (centre == solution.points.end()) continue;
        columns.x = column(acceleration_of(*centre).along(Quantity::Component::x));
        columns.y = column(acceleration_of(*centre).along(Quantity::Component::y));
    }
}

bool EffortColumns::replay(const Places& places, const Positions& positions, const std::vector<double>& row) {
    if (by_work_.empty()) return true;
    const auto value_in = [&](std::size_t column) { return column < row.size() ? row[column] : 0; };
    std::vector<EffortRows::Acceleration> masses;
    for (const MassColumns& each : mass_columns_)
        masses.push_back({{value_in(each.x), value_in(each.y)}, value_in(each.alpha)});
    auto found = rows_.here(places, positions, masses);
    if (!found) return false;
    here_ = *std::move(found);
    return true;
}

bool EffortColumns::fill(std::vector<double>& row, std::size_t behind) const {
    for (std::size_t i = 0; i < by_work_.size(); ++i) {
        if (by_work_[i] >= here_.size() || !here_[by_work_[i]]) return false;
        row[row.size() - behind - by_work_.size() + i] = *here_[by_work_[i]];
    }
    return true;
}

}  // namespace kinegraph
