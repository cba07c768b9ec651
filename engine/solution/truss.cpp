#include "engine/solution/truss.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "engine/number/geometry.hpp"

namespace kinegraph {
namespace {

/// Recognises a truss in a mechanism; stops at the first property that excludes it.
class TrussReader {
public:
    explicit TrussReader(const Mechanism& mechanism) : mechanism_(mechanism), ends_(mechanism.bodies.size()) {}

    std::optional<TrussStructure> read() {
        if (!has_nothing_else() || !read_joints() || !read_bars() || !bears_at_pins() || !is_determinate())
            return std::nullopt;
        name_bars();
        return std::move(truss_);
    }

private:
    bool has_nothing_else() const {
        const bool weightless = mechanism_.masses.empty() || !mechanism_.gravity;
        return mechanism_.drivers.empty() && mechanism_.efforts.empty() && !mechanism_.motion && !mechanism_.problem &&
               !mechanism_.contacts && !mechanism_.inertia_forces && weightless;
    }

    /// Hinges, and on the frame supports with a reaction along one line; a guide is a support where a roller slides in
    /// it.
    bool read_joints() {
        for (const Joint& joint : mechanism_.joints) {
            const bool is_hinge = joint.pair().is_hinge();
            const bool is_support = joint.connects(frame) && joint.bodies.size() == 2 && joint.pair().holds_normal &&
                                    !joint.pair().holds_tangent;
            if (!is_hinge && !is_support) return false;
            if (joint.pair().holds_rotation) rollers_.insert(joint.other_than(frame));
            if (is_hinge)
                for (const BodyIndex body : joint.bodies)
                    if (body != frame) ends_[at_index(body)].insert(joint.point);
        }
        std::set<PointIndex> points;
        for (const auto& ends : ends_) points.insert(ends.begin(), ends.end());
        for (const PointIndex point : points) {
            pin_at_.emplace(point, static_cast<int>(truss_.pins.size()));
            truss_.pins.push_back({point, {}, {}, {}});
        }
        return true;
    }
    bool read_bars() {
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            const auto& ends = ends_[at_index(body)];
            if (rollers_.count(body) > 0) {
                if (!is_roller(body)) return false;
                continue;
            }
            if (ends.size() != 2 || mechanism_.body(body).circle) return false;
            const int bar = static_cast<int>(truss_.bars.size());
            truss_.bars.push_back({body, {pin_at_.at(*ends.begin()), pin_at_.at(*std::next(ends.begin()))}, {}});
            for (const int pin : truss_.bars.back().pins) truss_.pins[at_index(pin)].bars.push_back(bar);
        }
        constexpr std::size_t least = 3;
        if (truss_.bars.size() < least) return false;
        for (const Joint& joint : mechanism_.joints) {
            if (!joint.connects(frame)) continue;
            const auto pin = pin_at_.find(joint.point);
            if (pin == pin_at_.end()) return false;
            if (!joint.pair().is_hinge() && ends_[at_index(joint.other_than(frame))].count(joint.point) == 0)
                return false;
            auto& held = truss_.pins[at_index(pin->second)];
            (joint.pair().is_hinge() ? held.hinges : held.supports).push_back(mechanism_.index_of(joint));
        }
        return true;
    }

    /// A body hinged to the bars at one point, where its only guide constrains it.
    bool is_roller(BodyIndex body) const {
        const auto& ends = ends_[at_index(body)];
        const auto holds = [&](const Joint& joint) { return joint.connects(body) && !joint.pair().is_hinge(); };
        const auto guide = std::find_if(mechanism_.joints.begin(), mechanism_.joints.end(), holds);
        return ends.size() == 1 && guide->point == *ends.begin() &&
               std::count_if(mechanism_.joints.begin(), mechanism_.joints.end(), holds) == 1 &&
               std::none_of(mechanism_.joints.begin(), mechanism_.joints.end(), [&](const Joint& joint) {
                   return joint.connects(body) && joint.pair().is_hinge() && joint.connects(frame);
               });
    }

    bool bears_at_pins() const {
        const auto at_end = [&](BodyIndex body, PointIndex point) {
            return body == none || body == frame || ends_[at_index(body)].count(point) > 0;
        };
        return std::all_of(mechanism_.loads.begin(), mechanism_.loads.end(), [&](const Load& load) {
            if (const auto* force = std::get_if<ForceLoad>(&load)) return at_end(force->body, force->at);
            if (const auto* spring = std::get_if<SpringLoad>(&load))
                return at_end(spring->bodies[0], spring->between[0]) && at_end(spring->bodies[1], spring->between[1]);
            return false;
        });
    }

    /// As many unknowns as equations; and at each pin exactly the joints that connect its bodies, so that the force at
    /// each is determined too.
    bool is_determinate() const {
        std::size_t unknown = truss_.bars.size();
        for (const TrussStructure::Pin& pin : truss_.pins) {
            if (!pin.hinges.empty() && !pin.supports.empty()) return false;
            unknown += (pin.hinges.empty() ? 0 : 2) + pin.supports.size();
            std::set<BodyIndex> bodies;
            std::size_t links = 0;
            for (const Joint& joint : mechanism_.joints) {
                if (joint.point != pin.point) continue;
                if (!joint.pair().is_hinge()) continue;  // a constraint along a line does not repeat a hinge
                bodies.insert(joint.bodies.begin(), joint.bodies.end());
                links += joint.bodies.size() - 1;
            }
            if (links + 1 != bodies.size()) return false;
        }
        return unknown == 2 * truss_.pins.size();
    }

    void name_bars() {
        const auto name = [&](const TrussStructure::Bar& bar, const char* between) {
            return truss_.name_of(mechanism_, bar.pins[0]) + between + truss_.name_of(mechanism_, bar.pins[1]);
        };
        std::map<std::string, int> count;
        for (const TrussStructure::Bar& bar : truss_.bars) ++count[name(bar, "")];
        for (TrussStructure::Bar& bar : truss_.bars) bar.name = name(bar, count[name(bar, "")] > 1 ? "-" : "");
    }

    const Mechanism& mechanism_;
    std::vector<std::set<PointIndex>> ends_;  ///< by body
    std::set<BodyIndex> rollers_;             ///< bodies in a guide on the frame
    std::map<PointIndex, int> pin_at_;
    TrussStructure truss_;
};

}  // namespace

std::optional<TrussStructure> truss_of(const Mechanism& mechanism) { return TrussReader(mechanism).read(); }

int TrussStructure::bar_named(const Mechanism& mechanism, std::string_view name) const {
    const auto found = std::find_if(bars.begin(), bars.end(), [&](const Bar& bar) {
        const std::string &first = name_of(mechanism, bar.pins[0]), &second = name_of(mechanism, bar.pins[1]);
        return name == bar.name || name == second + first || name == second + "-" + first;
    });
    return found == bars.end() ? -1 : static_cast<int>(found - bars.begin());
}

std::vector<std::vector<int>> sides_of_cut(const TrussStructure& truss, const std::vector<int>& bars,
                                           const std::vector<int>& passed) {
    const auto among = [](const std::vector<int>& some, int bar) {
        return std::find(some.begin(), some.end(), bar) != some.end();
    };
    std::vector<int> part(truss.pins.size(), -1);
    std::vector<std::vector<int>> parts;
    for (std::size_t first = 0; first < truss.pins.size(); ++first) {
        if (part[first] >= 0) continue;
        const int number = static_cast<int>(parts.size());
        std::vector<int> pins{static_cast<int>(first)};
        part[first] = number;
        for (std::size_t next = 0; next < pins.size(); ++next)
            for (const int bar : truss.pins[at_index(pins[next])].bars) {
                if (among(bars, bar) || among(passed, bar)) continue;
                const int other = truss.other_end(bar, pins[next]);
                if (part[at_index(other)] >= 0) continue;
                part[at_index(other)] = number;
                pins.push_back(other);
            }
        std::sort(pins.begin(), pins.end());
        parts.push_back(std::move(pins));
    }
    std::vector<std::vector<int>> sides;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const bool all_leave = std::all_of(bars.begin(), bars.end(), [&](int bar) {
            const auto& ends = truss.bars[at_index(bar)].pins;
            return (part[at_index(ends[0])] == static_cast<int>(p)) != (part[at_index(ends[1])] == static_cast<int>(p));
        });
        if (all_leave) sides.push_back(parts[p]);
    }
    const auto reactions = [&](const std::vector<int>& side) {
        return std::accumulate(side.begin(), side.end(), std::size_t{0}, [&](std::size_t sum, int pin) {
            const TrussStructure::Pin& held = truss.pins[at_index(pin)];
            return sum + 2 * held.hinges.size() + held.supports.size();
        });
    };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const auto& a, const auto& b) { return reactions(a) < reactions(b); });
    return sides;
}

namespace {

std::array<Vector, 2> ends_of(const TrussStructure& truss, int bar, const std::vector<Vector>& places) {
    const auto& pins = truss.bars[at_index(bar)].pins;
    return {places[at_index(truss.pins[at_index(pins[0])].point)],
            places[at_index(truss.pins[at_index(pins[1])].point)]};
}

}  // namespace

Truss::CutNumbers Truss::numbers_of(const Cut& cut, const std::vector<Vector>& places) const {
    const auto [first, second] = ends_of(structure, cut.found, places);
    const Vector along = second - first;
    if (cut.pivot) return {cut.moment->to_double(), distance(*cut.pivot, finite_line_through(point_at(first), along))};
    const int other = *std::find_if(cut.bars.begin(), cut.bars.end(), [&](int bar) { return bar != cut.found; });
    const auto [from, to] = ends_of(structure, other, places);
    const Vector parallel = to - from;
    return {cut.moment->to_double() / length(parallel),
            std::abs(cross(parallel, along).to_double()) / (length(parallel) * length(along))};
}

double Truss::tension(std::size_t bar, const std::vector<Vector>& places) const {
    const Vector& force = *bars[bar].force;
    const auto& ends = structure.bars[bar].pins;
    const Vector along = places[at_index(structure.pins[at_index(ends[1])].point)] -
                         places[at_index(structure.pins[at_index(ends[0])].point)];
    const double size = length(force);
    return dot(force, along).sign() < 0 ? -size : size;
}

}  // namespace kinegraph
