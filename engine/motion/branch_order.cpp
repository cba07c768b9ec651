#include "engine/motion/branch_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace kinegraph {
namespace {

/// Ranks one branch. Doubles suffice: motions that agree to nine digits are alike.
class BranchRanking {
public:
    BranchRanking(const Mechanism& mechanism, const Pose& pose, const std::vector<OriginVelocity>& velocities)
        : mechanism_(mechanism), pose_(pose), velocities_(velocities) {
        collect_turnings();
        collect_velocities();
    }

    BranchRank rank() const {
        double all = 0;
        for (const auto& [name, omega] : turnings_) all += omega * omega;
        for (const auto& [name, v] : moving_) all += dot(v, v);
        BranchRank rank;
        if (!(all > 0)) return rank;
        if (!mechanism_.drivers.empty()) {
            const double rate = rate_of_first_driver();
            constexpr double rests = 1e-18;
            rank.motion = rate * rate > rests * all ? all / (rate * rate) : std::numeric_limits<double>::infinity();
        }
        const auto add_products = [&](const auto& list, const auto& product) {
            for (std::size_t a = 0; a < list.size(); ++a)
                for (std::size_t b = a; b < list.size(); ++b)
                    rank.products.push_back(product(list[a].second, list[b].second) / all);
        };
        add_products(turnings_, [](double a, double b) { return a * b; });
        add_products(moving_, [](const auto& a, const auto& b) { return dot(a, b); });
        add_products(moving_, [](const auto& a, const auto& b) { return cross(a, b); });
        return rank;
    }

private:
    using Rough = VectorOf<double>;

    static Rough rough(const Vector& vector) { return {vector.x.to_double(), vector.y.to_double()}; }
    Rough place(PointIndex point) const {
        return (1 / pose_.size.to_double()) * rough(pose_.at(point) - pose_.points.front());
    }
    double omega(BodyIndex body) const { return velocities_[at_index(body)].omega.to_double(); }
    Rough velocity(BodyIndex body, PointIndex point) const {
        return rough(velocities_[at_index(body)].v) + omega(body) * quarter_turn(place(point));
    }

    /// The root mean square distance of the joints' points from their centre: in contrast to the drawing's size it does
    /// not depend on the axes.
    double size() const {
        Rough middle{};
        const double share = 1.0 / static_cast<double>(mechanism_.joints.size());
        for (const Joint& joint : mechanism_.joints) middle = middle + share * place(joint.point);
        double sum = 0;
        for (const Joint& joint : mechanism_.joints) sum += share * squared_length(place(joint.point) - middle);
        constexpr double coincident = 1e-18;
        return sum > coincident ? std::sqrt(sum) : 1;
    }
    void collect_turnings() {
        const double length = size();
        for (const BodyIndex body : mechanism_.moving_bodies())
            turnings_.emplace_back(mechanism_.body(body).name, length * omega(body));
        std::sort(turnings_.begin(), turnings_.end(),
                  [](const auto& a, const auto& b) { return name_comes_before(a.first, b.first); });
    }
    void collect_velocities() {
        for (const Joint& joint : mechanism_.joints)
            for (const BodyIndex body : joint.bodies)
                if (body != frame)
                    moving_.emplace_back(std::pair(mechanism_.point(joint.point).name, mechanism_.body(body).name),
                                         velocity(body, joint.point));
        std::sort(moving_.begin(), moving_.end(), [](const auto& a, const auto& b) {
            if (a.first.first != b.first.first) return name_comes_before(a.first.first, b.first.first);
            return name_comes_before(a.first.second, b.first.second);
        });
    }

    double rate_of_first_driver() const {
        const Driver& driver = mechanism_.drivers.front();
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) return omega(spin->body) - omega(spin->relative_to);
        if (const auto* slide = std::get_if<SlideDriver>(&driver)) {
            const Joint& joint = mechanism_.joint(slide->joint);
            const Rough sliding = velocity(joint.bodies[0], joint.point) - velocity(joint.bodies[1], joint.point);
            return dot(rough(pose_.guide_units[at_index(slide->joint)]), sliding);
        }
        const auto& point = std::get<PointDriver>(driver);
        return dot(rough(pose_.driver_units.front()), velocity(point.body, point.at));
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    const std::vector<OriginVelocity>& velocities_;
    std::vector<std::pair<std::string, double>> turnings_;                       ///< ω times size, bodies by name
    std::vector<std::pair<std::pair<std::string, std::string>, Rough>> moving_;  ///< by names of point and body
};

}  // namespace

BranchRank rank_of_branch(const Mechanism& mechanism, const Pose& pose, const std::vector<OriginVelocity>& velocities) {
    return BranchRanking(mechanism, pose, velocities).rank();
}

bool comes_before(const BranchRank& rank, const BranchRank& other) {
    constexpr double alike = 1e-9;
    const double apart = alike * std::min(rank.motion, other.motion);
    if (rank.motion < other.motion - apart) return true;
    if (other.motion < rank.motion - apart) return false;
    for (std::size_t i = 0; i < std::min(rank.products.size(), other.products.size()); ++i)
        if (std::abs(rank.products[i] - other.products[i]) > alike) return rank.products[i] > other.products[i];
    return false;
}

bool name_comes_before(const std::string& name, const std::string& other) {
    return name.size() != other.size() ? name.size() < other.size() : name < other;
}

}  // namespace kinegraph
