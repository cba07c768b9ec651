// Sketch: a mechanism built in code, for tests of the engine that need no file. Names replace indices; lengths in m.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph::sketch {

inline Exact decimal(const char* text) { return Exact::from_decimal(text).value(); }
inline Vector at(const char* x, const char* y) { return {decimal(x), decimal(y)}; }
inline Angle degrees(const char* text) { return {decimal(text), true}; }
inline Angle radians(const char* text) { return {decimal(text), false}; }

struct Sketch {
    Mechanism mechanism;

    Sketch() { mechanism.bodies.push_back({"1", {}, {}, {}, "/bodies/1"}); }

    PointIndex operator[](const std::string& name) const {
        for (std::size_t i = 0; i < mechanism.points.size(); ++i) {
            if (mechanism.points[i].name == name) return PointIndex(i);
        }
        ADD_FAILURE() << "no point " << name;
        return none;
    }
    BodyIndex body(const std::string& name) {
        for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
            if (mechanism.bodies[i].name == name) return BodyIndex(i);
        }
        mechanism.bodies.push_back({name, {}, {}, {}, "/bodies/" + name});
        return BodyIndex(mechanism.bodies.size() - 1);
    }
    Bearing between(const std::string& from, const std::string& to) const {
        return {Bearing::Between{(*this)[from], (*this)[to]}};
    }

    Sketch& point(const std::string& name, Placement placement) {
        mechanism.points.push_back({name, std::move(placement), "/points/" + name});
        return *this;
    }
    Sketch& point(const std::string& name, const char* x, const char* y) {
        return point(name, Coordinates{sketch::at(x, y)});
    }
    Sketch& polar(const std::string& name, const std::string& from, const char* distance, const char* angle) {
        return point(name, Polar{(*this)[from], decimal(distance), degrees(angle), {}});
    }
    CircleCurve circle(const std::string& centre, const char* radius) const {
        return {(*this)[centre], decimal(radius)};
    }
    LineCurve line(const std::string& through, const char* angle) const {
        return {(*this)[through], LineCurve::By::angle, degrees(angle), none, {}};
    }
    LineCurve line_to(const std::string& through, const std::string& to) const {
        return {(*this)[through], LineCurve::By::to, {}, (*this)[to], {}};
    }
    Sketch& meet(const std::string& name, Curve first, Curve second, Meet::Side side = Meet::Side::either) {
        return point(name, Meet{std::move(first), std::move(second), {}, side});
    }

    Joint& joint(JointKind kind, const std::string& at_point, const std::vector<std::string>& names) {
        Joint joint;
        joint.kind = kind;
        joint.name = at_point;
        joint.point = (*this)[at_point];
        for (const std::string& name : names) joint.bodies.push_back(body(name));
        joint.where = "/joints/" + std::to_string(mechanism.joints.size());
        for (const BodyIndex each : joint.bodies) {
            auto& points = mechanism.bodies[at_index(each)].points;
            points.push_back(joint.point);
        }
        mechanism.joints.push_back(std::move(joint));
        return mechanism.joints.back();
    }
    Sketch& revolute(const std::string& at_point, const std::vector<std::string>& names) {
        joint(JointKind::revolute, at_point, names);
        return *this;
    }
    Sketch& prismatic(const std::string& at_point, const std::vector<std::string>& names, const Bearing& along) {
        joint(JointKind::prismatic, at_point, names).along = along;
        return *this;
    }
    Sketch& pin_slot(const std::string& at_point, const std::vector<std::string>& names, const Bearing& along) {
        joint(JointKind::pin_slot, at_point, names).along = along;
        return *this;
    }
    Sketch& pin_arc(const std::string& at_point, const std::vector<std::string>& names, const std::string& centre) {
        joint(JointKind::pin_slot, at_point, names).arc = (*this)[centre];
        return *this;
    }
    Sketch& touching(JointKind kind, const std::string& at_point, const std::vector<std::string>& names,
                     const std::vector<Profile>& profiles) {
        Joint& added = joint(kind, at_point, names);
        for (std::size_t i = 0; i < profiles.size(); ++i) added.profiles[added.bodies[i]] = profiles[i];
        return *this;
    }
    Sketch& spin(const std::string& name, const char* omega, const char* alpha = "0",
                 const std::string& relative_to = "1") {
        mechanism.drivers.push_back(
            SpinDriver{body(name), body(relative_to), decimal(omega), decimal(alpha), "/drivers/0"});
        return *this;
    }
    Sketch& slide(int joint_index, const char* speed, const char* acceleration = "0") {
        mechanism.drivers.push_back(
            SlideDriver{JointIndex(joint_index), decimal(speed), decimal(acceleration), "/drivers/0"});
        return *this;
    }
};

inline Bearing at_angle(const char* degrees_text) { return {degrees(degrees_text)}; }

}  // namespace kinegraph::sketch
