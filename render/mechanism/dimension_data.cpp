#include "render/mechanism/dimension_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace kinegraph::render::drawing {
namespace {

class DimensionGatherer {
public:
    explicit DimensionGatherer(const Sketch& sketch) : sketch_(sketch) {}

    DimensionData gathered() {
        gather();
        gather_offsets();
        return std::move(data_);
    }

private:
    std::string name_of(PointIndex point) const { return sketch_.mechanism.point(point).name; }

    void add_length(PointIndex from, PointIndex to, double value) {
        const Spot a = sketch_.spot(from), b = sketch_.spot(to);
        if (length(b - a) < 1 || !sketch_.subject.shows(to)) return;
        add_length({a, b, unit(b - a), value, name_of(from) + "." + name_of(to)});
    }

    void add_length(DimensionedLength added) {
        for (const DimensionedLength& known : data_.lengths) {
            const bool same = coincide(known.from, added.from) && coincide(known.to, added.to);
            const bool turned_about = coincide(known.from, added.to) && coincide(known.to, added.from);
            if (same || turned_about) return;
        }
        data_.lengths.push_back(std::move(added));
    }

    void add_angle(PointIndex vertex, PointIndex to, const Angle& angle, std::optional<Spot> reference) {
        if (!sketch_.subject.shows(vertex) || !sketch_.subject.shows(to)) return;
        const Spot base = reference.value_or(Spot{1, 0});
        const double value = angle.value.to_double();
        const double sweep = -(angle.in_degrees ? value * pi_number / 180 : value);
        if (std::abs(sweep) < 0.12 || std::abs(sweep) > 3.5) return;
        const std::string figure = given_number(value, sketch_.context.language);
        data_.angles.push_back({sketch_.spot(vertex), angle_of(base), sweep, figure + (angle.in_degrees ? "°" : " rad"),
                                name_of(vertex) + "." + name_of(to)});
    }

    /// The angle of a line that contains a point, measured where the line begins. Omitted if the point lies on the
    /// other side of that place, where the angle is different, and for horizontal and vertical lines, which need no
    /// dimension.
    void add_angle_of(const LineCurve& line, PointIndex point) {
        const auto* through = std::get_if<PointIndex>(&line.through);
        if (through == nullptr || line.by != LineCurve::By::angle) return;
        const Spot along = paper_direction(direction_of(Bearing{line.angle}, sketch_.subject.solution.pose));
        constexpr double seen_upright = 1e-6;
        if (std::min(std::abs(along.x), std::abs(along.y)) < seen_upright) return;
        if (dot(along, sketch_.spot(point) - sketch_.spot(*through)) > 1)
            add_angle(*through, point, line.angle, std::nullopt);
    }

    void gather() {
        for (const PointIndex point : indices_of(sketch_.mechanism.points)) {
            if (!sketch_.subject.shows(point)) continue;
            const Placement& placement = sketch_.mechanism.point(point).placement;
            if (const auto* polar = std::get_if<Polar>(&placement)) {
                add_length(polar->from, point, polar->distance.to_double());
                if (!polar->relative_to)
                    add_angle(polar->from, point, polar->angle, std::nullopt);
                else if (polar->relative_to->from == polar->from)
                    add_angle(polar->from, point, polar->angle,
                              unit(sketch_.spot(polar->relative_to->to) - sketch_.spot(polar->from)));
            } else if (const auto* on = std::get_if<Along>(&placement)) {
                if (!on->is_ratio) add_length(on->from, point, std::abs(on->amount.to_double()));
            } else if (const auto* meet = std::get_if<Meet>(&placement)) {
                for (const Curve* curve : {&meet->first, &meet->second}) {
                    if (const auto* circle = std::get_if<CircleCurve>(curve))
                        if (const auto* centre = std::get_if<PointIndex>(&circle->centre))
                            add_length(*centre, point, circle->radius.to_double());
                    if (const auto* line = std::get_if<LineCurve>(curve)) add_angle_of(*line, point);
                }
            }
        }
        gather_coordinates();
        for (const Body& body : sketch_.mechanism.bodies)
            if (body.circle)
                data_.radii.push_back({sketch_.spot(body.circle->centre),
                                       body.circle->radius.to_double() / sketch_.scale(),
                                       body.circle->radius.to_double(), body.name});
    }

    /// Fixed pins given by coordinates: horizontal and vertical distances from the first one.
    void gather_coordinates() {
        std::vector<PointIndex> fixed;
        for (const Joint& joint : sketch_.mechanism.joints)
            if (is_fixed_pin(joint) &&
                std::holds_alternative<Coordinates>(sketch_.mechanism.point(joint.point).placement) &&
                std::find(fixed.begin(), fixed.end(), joint.point) == fixed.end())
                fixed.push_back(joint.point);
        for (std::size_t i = 1; i < fixed.size(); ++i) {
            const Spot a = sketch_.spot(fixed[0]), b = sketch_.spot(fixed[i]);
            const Vector& first = std::get<Coordinates>(sketch_.mechanism.point(fixed[0]).placement).at;
            const Vector& other = std::get<Coordinates>(sketch_.mechanism.point(fixed[i]).placement).at;
            const std::string name = name_of(fixed[0]) + "." + name_of(fixed[i]);
            if (const double across = (other.x - first.x).to_double(); across != 0)
                add_length({a, b, {b.x > a.x ? 1.0 : -1.0, 0}, std::abs(across), name});
            if (const double up = (other.y - first.y).to_double(); up != 0 && other.x != first.x)
                data_.lengths.push_back({a, b, {0, b.y > a.y ? 1.0 : -1.0}, std::abs(up), name});
            else if (up != 0)
                add_length({a, b, unit(b - a), std::abs(up), name});
        }
    }

    /// Guides of the frame parallel to an axis: their distance from the first fixed pin.
    void gather_offsets() {
        const Mechanism& mechanism = sketch_.mechanism;
        const auto pin = std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
            return is_fixed_pin(joint) && std::holds_alternative<Coordinates>(mechanism.point(joint.point).placement);
        });
        if (pin == mechanism.joints.end()) return;
        const Vector& origin = std::get<Coordinates>(mechanism.point(pin->point).placement).at;
        for (const Joint& joint : mechanism.joints) {
            if (!is_slide(joint) || joint.bodies[1] != frame) continue;
            const Vector& guide = sketch_.subject.solution.pose.guides[at_index(mechanism.index_of(joint))];
            if (guide.x.is_zero() == guide.y.is_zero()) continue;
            const bool lying = guide.y.is_zero();
            const std::optional<Vector> given = given_on_guide(joint, lying);
            if (!given) continue;
            const Exact offset = lying ? given->y - origin.y : given->x - origin.x;
            if (offset.is_zero()) continue;
            // Measured beside the block and its walls, on the pin's side.
            const Spot a = sketch_.spot(*pin), block = sketch_.spot(joint);
            const double beyond = sketch_.measures.slider_half + sketch_.measures.wall_beyond + 3;
            const Spot aside = lying ? Spot{a.x - block.x, 0} : Spot{0, a.y - block.y};
            const Spot b = block + std::min(beyond, length(aside)) * unit(aside);
            const Spot along = lying ? Spot{0, b.y > a.y ? 1.0 : -1.0} : Spot{b.x > a.x ? 1.0 : -1.0, 0};
            add_length({a, b, along, std::abs(offset.to_double()),
                        name_of(pin->point) + "." + name_of(joint.point) + ".offset"});
        }
    }

    /// A place on a guide whose coordinates the file gives.
    std::optional<Vector> given_on_guide(const Joint& joint, bool lying) const {
        const Placement& placement = sketch_.mechanism.point(joint.point).placement;
        if (const auto* at = std::get_if<Coordinates>(&placement)) return at->at;
        const auto* meet = std::get_if<Meet>(&placement);
        if (meet == nullptr) return std::nullopt;
        const Vector& here = sketch_.subject.solution.pose.at(joint.point);
        for (const Curve* curve : {&meet->first, &meet->second}) {
            const auto* line = std::get_if<LineCurve>(curve);
            if (line == nullptr) continue;
            std::optional<Vector> place;
            if (const auto* bare = std::get_if<Vector>(&line->through)) place = *bare;
            if (const auto* point = std::get_if<PointIndex>(&line->through))
                if (const auto* at = std::get_if<Coordinates>(&sketch_.mechanism.point(*point).placement))
                    place = at->at;
            if (place && (lying ? place->y - here.y : place->x - here.x).is_zero()) return place;
        }
        return std::nullopt;
    }

    const Sketch& sketch_;
    DimensionData data_;
};

}  // namespace

DimensionData dimension_data(const Sketch& sketch) { return DimensionGatherer(sketch).gathered(); }

}  // namespace kinegraph::render::drawing
