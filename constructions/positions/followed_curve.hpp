// FollowedCurve: several numbers as functions of one coordinate, over a stretch on which they are smooth except at
// poles. It is sampled as finely as the functions need, whatever rows a user asked for; zeros, poles and extremes are
// then found by evaluating the functions there, never from a straight line.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace kinegraph {

class FollowedCurve {
public:
    /// The functions at a coordinate. What is smaller than a grain is not told from zero: no structure is sought in it.
    struct Values {
        std::vector<double> values;
        std::vector<double> grains = {};  ///< by function; empty: all zero
        double grain(std::size_t i) const { return i < grains.size() ? grains[i] : 0; }
    };
    /// Noise of the arithmetic is zero. None if the functions are not determined there.
    using Evaluate = std::function<std::optional<Values>(double)>;
    /// From `from` to `to`, either way. Near a limit the functions vary as the root of the distance from it, so the
    /// parameter t, from 0 to 1, is such a root there.
    struct Stretch {
        double from = 0, to = 0;
        bool starts_at_limit = false, ends_at_limit = false;
        double at(double t) const;
        double slope(double t) const;          ///< derivative of the coordinate
        double parameter(double place) const;  ///< t of a coordinate
    };
    struct Node {
        double t = 0;
        Values at;
    };
    /// Where a function vanishes or grows without limit, with its signs on both sides.
    struct Crossing {
        double t = 0;
        bool is_pole = false;
        bool is_as_root = false;  ///< a pole that grows as 1/√, at a limit: the integral is finite
        int before = 0, after = 0;
    };
    struct Extreme {
        double t = 0, value = 0;
    };

    FollowedCurve(Stretch stretch, Evaluate evaluate) : stretch_(stretch), evaluate_(std::move(evaluate)) {}

    /// Samples at equal steps of t, and then between them until all functions are resolved.
    void sample(int intervals);
    /// Takes samples that were made elsewhere, in order.
    void take(std::vector<Node> nodes) { nodes_ = std::move(nodes); }

    const std::vector<Node>& nodes() const { return nodes_; }
    double at(double t) const { return stretch_.at(t); }
    std::optional<double> value(std::size_t i, double t) const;

    /// Zeros and poles of function `i`, in order. A stretch of zeros is none. With `poles_only` zeros may be missing.
    std::vector<Crossing> crossings(std::size_t i, bool poles_only) const;
    /// Poles at the limits alone.
    std::vector<Crossing> poles_at_limits(std::size_t i) const;
    /// The largest of `sign` times the function; the ends of the stretch count. None without samples.
    std::optional<Extreme> largest(std::size_t i, int sign) const;
    /// Integrals over the coordinate: of the function, and of its size.
    struct Integrals {
        double value = 0, size = 0;
    };
    Integrals integrals(std::size_t i) const;

private:
    using Function = std::function<std::optional<double>(double)>;
    struct Bracket {
        double a = 0, fa = 0, b = 0, fb = 0;
    };
    double integral(const std::vector<double>& g) const;
    std::optional<Node> node(double t) const;
    void refine(const Node& b, const Node* beyond, int depth);
    bool is_resolved(const Node& middle, const Node& b, const Node* beyond) const;
    /// The value at a sample; within its grain it is zero.
    double y(std::size_t k, std::size_t i) const {
        const double value = nodes_[k].at.values[i];
        return std::abs(value) <= nodes_[k].at.grain(i) ? 0 : value;
    }

    bool is_plain_zero(std::size_t i, std::size_t a, std::size_t b) const;
    bool grows_towards(std::size_t i, double pole, double reach) const;
    std::optional<Crossing> crossing_in(std::size_t i, Bracket bracket) const;
    void add_touching(std::size_t i, std::vector<Crossing>& found) const;
    void add_at_ends(std::size_t i, std::vector<Crossing>& found) const;
    std::optional<Extreme> stationary(const Function& f, std::size_t node, int sign) const;

    Stretch stretch_;
    Evaluate evaluate_;
    std::vector<double> usual_;  ///< by function: the median of its absolute values
    std::vector<Node> nodes_;
    /// What was evaluated between the samples: functions with a common pole ask for the same places.
    mutable std::map<double, std::optional<Values>> known_;
    int left_ = 0;  ///< samples that may still be added between the first ones
};

}  // namespace kinegraph
