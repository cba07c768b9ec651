// Points and directions of the file as objects of GeoGebra. What the file places by compass and ruler is placed by
// them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/board/program.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "lang/words.hpp"
#include "render/geogebra/construction.hpp"

namespace kinegraph::render {

class GeoGebraPlacing {
public:
    GeoGebraPlacing(GeoGebraConstruction& construction, const Mechanism& mechanism, const Pose& pose,
                    GeoGebraLook look_of_points);

    /// The label of a point, placed on the first call.
    std::string point(PointIndex point);
    /// The label of a given of the record: a vector or a number.
    std::string given(const Given& given);
    /// The first thing that has no command, in one line.
    const std::optional<Words>& fault() const { return fault_; }

private:
    std::string number(double value) { return construction_.free_number(construction_.label("k"), value); }
    std::string vector(const std::string& text);
    std::string constant(const Vector& value);
    std::string direction(const Bearing& bearing);
    std::string direction(const Angle& angle);
    std::string between(PointIndex from, PointIndex to);
    std::string quarter_turn_of(const std::string& direction);
    std::string unit(const std::string& direction);
    std::string place(const Place& place);
    std::string placed(const NamedPoint& named, const std::string& label, const Vector& at);
    std::string polar(const Polar& polar, const std::string& label);
    std::string along(const Along& along, const std::string& label);
    std::string meet(const Meet& meet, const std::string& label, const Vector& at);
    struct Drawn {
        std::string label, direction;  ///< of a line; a circle has none
    };
    Drawn curve(const Curve& curve);
    std::string normal(const Joint& joint);
    std::string tangent(const Joint& joint);

    GeoGebraConstruction& construction_;
    const Mechanism& mechanism_;
    const Pose& pose_;
    GeoGebraLook look_;
    std::vector<std::string> points_;  ///< by PointIndex; empty: not yet placed
    std::optional<Words> fault_;
};

}  // namespace kinegraph::render
