// MechanismFile::drawn_position: the points and directions of a file, placed but not solved.
#include <cmath>
#include <type_traits>

#include "app/library/state.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

bool has_direction(const Vector& direction) { return !direction.x.is_zero() || !direction.y.is_zero(); }

/// Collects directions in doubles, for the screen.
class PlacedDirections {
public:
    explicit PlacedDirections(const Pose& pose) : pose_(pose) {}

    void add(const std::string& place, const Vector& direction) {
        if (!has_direction(direction)) return;
        const VectorOf<double> along = to_double(direction);
        all_.push_back({place, nearest::atan2(along.y, along.x)});
    }
    void add(const Load& load) {
        std::visit(
            [&](const auto& each) {
                using Kind = std::decay_t<decltype(each)>;
                if constexpr (std::is_same_v<Kind, ForceLoad>) {
                    if (each.value) add(each.where, *each.value);
                    if (each.magnitude) add(each.where, direction_of(each.magnitude->second, pose_));
                } else if constexpr (std::is_same_v<Kind, DistributedLoad>) {
                    add(each.where, direction_of(each.along, pose_));
                }
            },
            load);
    }
    std::vector<DrawnPosition::Direction> take() { return std::move(all_); }

private:
    const Pose& pose_;
    std::vector<DrawnPosition::Direction> all_;
};

}  // namespace

Expected<DrawnPosition> MechanismFile::drawn_position() const {
    const Mechanism& mechanism = state().mechanism;
    const auto pose = draw_pose(mechanism);
    if (!pose) return tl::unexpected(diagnostics_of(pose.error()));
    DrawnPosition position;
    const Unit& unit = mechanism.units.length;
    position.length_unit = unit.symbol;
    position.metres = unit.si.to_double();
    for (std::size_t i = 0; i < mechanism.points.size(); ++i) {
        const Vector& at = pose->points[i];
        position.points.push_back(
            {mechanism.points[i].name, {(at.x / unit.si).to_double(), (at.y / unit.si).to_double()}});
    }
    PlacedDirections directions(*pose);
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
        const Vector& guide = pose->guides[i];
        directions.add(mechanism.joints[i].where, has_direction(guide) ? guide : pose->tangents[i]);
    }
    for (const Load& load : mechanism.loads) directions.add(load);
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
        const std::string& where =
            std::visit([](const auto& driver) -> const std::string& { return driver.where; }, mechanism.drivers[i]);
        directions.add(where, pose->driver_directions[i]);
    }
    position.directions = directions.take();
    return position;
}

}  // namespace kinegraph
