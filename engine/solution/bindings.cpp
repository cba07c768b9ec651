#include "engine/solution/bindings.hpp"

#include <array>
#include <charconv>

namespace kinegraph {
namespace {

std::string number_of(int index) { return std::to_string(index); }
template <class Index>
std::string number_of(Index index) {
    return index == none ? "" : std::to_string(index.number());
}
std::string written(double value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}
std::string under(const std::string& load) { return load.empty() ? "" : load + "|"; }
std::string name_of(const FreeBody& body) {
    return body.body != none ? number_of(body.body) : "p" + number_of(body.pin);
}

/// What acts, as a digit.
char digit_of(Quantity::Kind kind) {
    switch (kind) {
        case Quantity::Kind::load: return '0';
        case Quantity::Kind::weight: return '1';
        case Quantity::Kind::inertia: return '2';
        case Quantity::Kind::force: return '4';
        case Quantity::Kind::effort: return '5';
        default: return '6';  // a resultant
    }
}

}  // namespace

std::string force_binding(const std::string& load, const FreeBody& body, const AppliedForce& applied) {
    return under(load) + "F" + name_of(body) + "." + digit_of(applied.kind) + "." + number_of(applied.joint) + "." +
           number_of(applied.from) + "." + number_of(applied.given);
}
std::string sum_binding(const std::string& load, const FreeBody& body, const AppliedForce& sum) {
    return under(load) + "R" + name_of(body) + "." + kinegraph::name_of(sum.symbol);
}
std::string sum_binding(const std::string& load, std::size_t of, const AppliedForce& sum) {
    return under(load) + "T" + std::to_string(of) + "." + kinegraph::name_of(sum.symbol);
}
std::string couple_of(const std::string& held) { return held + "c"; }
std::string meet_binding(const std::string& load, const std::string& name) { return under(load) + "M" + name; }
std::string arm_binding(const std::string& load, const FreeBody& body, std::size_t arm, bool is_foot) {
    return under(load) + "A" + name_of(body) + "." + std::to_string(arm) + (is_foot ? "f" : "a");
}
std::string pair_binding(const JointForce& pair) {
    return "J" + number_of(pair.joint) + "." + number_of(pair.on) + "." + number_of(pair.from);
}
std::string string_binding(const std::string& load, const FreeBody::Funicular& funicular, std::size_t vertex) {
    return under(load) + "V" + kinegraph::name_of(funicular.first) + "." + kinegraph::name_of(funicular.second) + "." +
           std::to_string(vertex);
}
std::string curvature_binding(BodyIndex body, const std::string& what) { return "C" + number_of(body) + "." + what; }
std::string work_binding(const VirtualWork::Entry& entry) {
    return "W" + number_of(entry.body) + "." + kinegraph::name_of(entry.symbol);
}
std::string point_binding(PointIndex point) { return "p" + number_of(point); }
std::string place_binding(BodyIndex body, const Vector& drawn) {
    return "b" + number_of(body) + " " + written(drawn.x.to_double()) + " " + written(drawn.y.to_double());
}
std::string tip_binding(const std::string& place, const std::string& vector, double scale) {
    return place + ">" + vector + ">" + written(scale);
}
std::string displaced_binding(PointIndex point, std::size_t freedom, double scale) {
    return "d" + number_of(point) + " " + std::to_string(freedom) + " " + written(scale);
}
std::string tangent_binding(JointIndex joint) { return "t" + number_of(joint); }
std::string guide_binding(JointIndex joint) { return "g" + number_of(joint); }
std::string relative_binding(std::size_t index, const std::string& what) {
    return "Q" + std::to_string(index) + "." + what;
}
std::string velocity_binding(PointIndex point) { return "U" + number_of(point); }
std::string instantaneous_binding(const std::string& what) { return "U" + what; }
std::string bar_binding(const Truss& truss, std::size_t bar) { return "B" + truss.structure.bars[bar].name; }
std::string external_binding(const Truss::External& external) {
    return "X" + number_of(external.pin) + "." + kinegraph::name_of(external.symbol);
}
std::string whole_binding() { return "XR"; }
std::string pole_binding() { return "o"; }
std::string foot_binding(const VirtualWork::Entry& entry) { return "/" + work_binding(entry); }

}  // namespace kinegraph
