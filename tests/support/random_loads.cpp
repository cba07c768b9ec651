#include "tests/support/random_loads.hpp"

#include <cmath>
#include <iterator>
#include <map>
#include <variant>
#include <vector>

#include "tests/support/random_mechanism.hpp"

namespace kinegraph {
namespace {

std::size_t at(auto index) { return at_index(index); }

/// Adds loads, weights, springs and input forces of every kind to the file of a random mechanism.
class Loading {
public:
    Loading(const Mechanism& mechanism, const Pose& pose, std::uint64_t seed, int efforts, bool all_kinds)
        : mechanism_(mechanism), pose_(pose), all_kinds_(all_kinds), random_(seed * 7919 + 1) {
        const int loads = random_.whole(1, 4);
        for (int i = 0; i < loads || (loads_.empty() && masses_.empty()); ++i) load(std::to_string(i));
        if (random_.chance(30)) inertia_ = true;
        for (int i = 0; i < efforts; ++i) effort("E" + std::to_string(i));
    }

    /// The file with all additions.
    std::string entered_in(std::string text) const {
        const auto list = [](const std::vector<std::string>& all) {
            std::string joined;
            for (const std::string& each : all) joined += (joined.empty() ? "" : ",\n    ") + each;
            return "[\n    " + joined + "\n  ]";
        };
        std::string more;
        if (!loads_.empty()) more += ",\n  \"loads\": " + list(loads_);
        if (!masses_.empty()) {
            more += ",\n  \"gravity\": [0, -9.81],\n  \"masses\": {";
            for (const auto& [body, mass] : masses_)
                more += (body == masses_.begin()->first ? "" : ", ") + quoted(name(body)) + ": " + mass;
            more += "}";
        }
        if (inertia_) more += ",\n  \"inertia forces\": true";
        if (!efforts_.empty()) more += ",\n  \"effort\": " + list(efforts_);
        text.insert(text.rfind("\n}"), more);
        return text;
    }

private:
    static std::string quoted(const std::string& text) { return "\"" + text + "\""; }
    const std::string& name(BodyIndex body) const { return mechanism_.bodies[at(body)].name; }
    const std::string& point_name(PointIndex point) const { return mechanism_.points[at(point)].name; }

    BodyIndex any_body() { return BodyIndex(random_.whole(1, static_cast<int>(mechanism_.bodies.size()) - 1)); }
    BodyIndex body_with_points() {
        for (;;) {
            const BodyIndex body = any_body();
            if (!mechanism_.bodies[at(body)].points.empty()) return body;
        }
    }
    PointIndex point_of(BodyIndex body) {
        const auto& points = mechanism_.bodies[at(body)].points;
        return points[at(random_.whole(0, static_cast<int>(points.size()) - 1))];
    }
    std::string decimal(double least, double most) {
        const long hundredths = std::lround(random_.real(least, most) * 100);
        const std::string digits = std::to_string(std::labs(hundredths) % 100);
        return (hundredths < 0 ? "-" : "") + std::to_string(std::labs(hundredths) / 100) +
               (digits.size() < 2 ? ".0" : ".") + digits;
    }
    /// Two components, not both zero.
    std::string components(double most) {
        for (;;) {
            const std::string x = decimal(-most, most), y = decimal(-most, most);
            if (std::stod(x) != 0 || std::stod(y) != 0) return "[" + x + ", " + y + "]";
        }
    }

    void load(const std::string& number) {
        const BodyIndex body = body_with_points();
        const PointIndex point = point_of(body);
        switch (random_.whole(0, all_kinds_ ? 8 : 4)) {
            case 0:
                loads_.push_back("{\"force\": \"P" + number + "\", \"body\": " + quoted(name(body)) +
                                 ", \"at\": " + quoted(point_name(point)) + ", \"value\": " + components(50) + "}");
                break;
            case 1:
                loads_.push_back("{\"force\": \"P" + number + "\", \"body\": " + quoted(name(body)) +
                                 ", \"at\": " + quoted(point_name(point)) + ", \"magnitude\": " + decimal(1, 50) +
                                 ", \"along\": " + decimal(-180, 180) + "}");
                break;
            case 2:
                loads_.push_back("{\"couple\": \"Q" + number + "\", \"body\": " + quoted(name(body)) +
                                 ", \"value\": " + decimal(-20, 20) + "}");
                break;
            case 3:
                masses_.insert({body, "{\"mass\": " + decimal(1, 5) + ", \"centre\": " + quoted(point_name(point)) +
                                          ", \"inertia\": " + decimal(0.01, 1) + "}"});
                break;
            case 5: elastic(number, body, point); break;
            case 6: torsion(number, body, point); break;
            case 7: distributed(number, body, point); break;
            case 8: on_pin(number); break;
            default: spring(number, body, point);
        }
    }

    void spring(const std::string& number, BodyIndex body, PointIndex point) {
        const BodyIndex other = random_.chance(20) ? frame : body_with_points();
        if (other == body || mechanism_.bodies[at(other)].points.empty()) return;
        const PointIndex end = point_of(other);
        // A spring with coincident ends has no direction and is refused; another test covers that.
        const Vector join = pose_.at(end) - pose_.at(point);
        if (squared_length(join) <= Exact::power_of_two(-40) * square(pose_.size)) return;
        loads_.push_back("{\"force\": \"S" + number + "\", \"bodies\": [" + quoted(name(body)) + ", " +
                         quoted(name(other)) + "], \"between\": [" + quoted(point_name(point)) + ", " +
                         quoted(point_name(end)) + "], \"magnitude\": " + decimal(1, 40) + "}");
    }

    void elastic(const std::string& number, BodyIndex body, PointIndex point) {
        const BodyIndex other = body_with_points();
        if (other == body) return;
        const PointIndex end = point_of(other);
        const Vector join = pose_.at(end) - pose_.at(point);
        if (squared_length(join) <= Exact::power_of_two(-40) * square(pose_.size)) return;
        loads_.push_back("{\"spring\": \"K" + number + "\", \"bodies\": [" + quoted(name(body)) + ", " +
                         quoted(name(other)) + "], \"between\": [" + quoted(point_name(point)) + ", " +
                         quoted(point_name(end)) + "], \"stiffness\": " + decimal(1, 900) +
                         ", \"free length\": " + decimal(0.01, 2) + "}");
    }
    void torsion(const std::string& number, BodyIndex body, PointIndex point) {
        const BodyIndex other = random_.chance(40) ? frame : any_body();
        if (other == body) return;
        loads_.push_back("{\"spring\": \"T" + number + "\", \"bodies\": [" + quoted(name(body)) + ", " +
                         quoted(name(other)) + "], \"at\": " + quoted(point_name(point)) +
                         ", \"stiffness\": " + decimal(1, 20) + ", \"turned\": " + decimal(-90, 90) + "}");
    }
    void distributed(const std::string& number, BodyIndex body, PointIndex point) {
        const PointIndex end = point_of(body);
        if (pose_.at(end) == pose_.at(point)) return;
        const std::string first = decimal(-60, 60);
        // Sometimes a couple: opposite forces at both ends.
        const std::string last =
            random_.chance(15) ? (first[0] == '-' ? first.substr(1) : "-" + first) : decimal(-60, 60);
        loads_.push_back("{\"distributed\": \"q" + number + "\", \"body\": " + quoted(name(body)) +
                         ", \"from\": " + quoted(point_name(point)) + ", \"to\": " + quoted(point_name(end)) +
                         ", \"intensity\": [" + first + ", " + last + "], \"along\": " + decimal(-180, 180) + "}");
    }
    void on_pin(const std::string& number) {
        std::map<std::string, int> hinges;
        for (const Joint& joint : mechanism_.joints)
            if (joint.kind == JointKind::revolute) ++hinges[joint.name];
        std::erase_if(hinges, [](const auto& each) { return each.second > 1; });
        if (hinges.empty()) return;
        const auto chosen = std::next(hinges.begin(), random_.whole(0, static_cast<int>(hinges.size()) - 1));
        loads_.push_back("{\"force\": \"N" + number + "\", \"pin\": " + quoted(chosen->first) +
                         ", \"value\": " + components(50) + "}");
    }

    void effort(const std::string& named) {
        std::vector<std::string> slides;
        for (const Joint& joint : mechanism_.joints) {
            if (joint.kind == JointKind::prismatic) slides.push_back(joint.name);
        }
        int kind = random_.whole(0, 2);
        if (kind == 2 && slides.empty()) kind = 0;
        if (kind == 0) {
            const BodyIndex body = any_body();
            const BodyIndex from = random_.chance(20) ? any_body() : frame;
            efforts_.push_back("{\"couple\": " + quoted(named) + ", \"body\": " + quoted(name(body)) +
                               (from != frame && from != body ? ", \"from\": " + quoted(name(from)) : "") + "}");
        } else if (kind == 1) {
            const BodyIndex body = body_with_points();
            efforts_.push_back("{\"force\": " + quoted(named) + ", \"body\": " + quoted(name(body)) + ", \"at\": " +
                               quoted(point_name(point_of(body))) + ", \"along\": " + components(5) + "}");
        } else {
            efforts_.push_back("{\"force\": " + quoted(named) + ", \"joint\": " +
                               quoted(slides[at(random_.whole(0, static_cast<int>(slides.size()) - 1))]) + "}");
        }
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    bool all_kinds_;
    Random random_;
    std::vector<std::string> loads_, efforts_;
    std::map<BodyIndex, std::string> masses_;
    bool inertia_ = false;
};

}  // namespace

std::string under_random_loads(const std::string& text, const Mechanism& mechanism, const Pose& pose,
                               std::uint64_t seed, int efforts, bool all_kinds) {
    return Loading(mechanism, pose, seed, efforts, all_kinds).entered_in(text);
}

}  // namespace kinegraph
