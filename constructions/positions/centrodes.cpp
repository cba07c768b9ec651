#include "constructions/positions/centrodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constructions/positions/cycle.hpp"
#include "engine/number/functions.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {
namespace {

using Spot = Centrodes::Spot;
using Kind = Quantity::Kind;

double size_of(const Spot& v) { return nearest::hypot(v.x, v.y); }

/// The moving driver has unit rate, since the centrodes do not depend on it; the others rest.
Mechanism at_unit_rate(Mechanism mechanism, int driver) {
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
        const Exact rate = static_cast<int>(i) == driver ? 1 : 0;
        std::visit(
            [&](auto& given) {
                if constexpr (requires { given.omega; }) {
                    given.omega = rate;
                    given.alpha = 0;
                } else {
                    given.speed = rate;
                    given.acceleration = 0;
                }
            },
            mechanism.drivers[i]);
    }
    mechanism.find = {};
    mechanism.find.stated = mechanism.find.velocity = true;
    return mechanism;
}

/// Columns of a row that give the motion of a body: its ω, and place and velocity of one of its points.
struct BodyColumns {
    bool rests = false;
    std::size_t omega = 0, x = 0, y = 0, vx = 0, vy = 0;
};

std::optional<BodyColumns> columns_of(const std::vector<Column>& columns, const Mechanism& mechanism, BodyIndex body) {
    BodyColumns found;
    if (body == frame) {
        found.rests = true;
        return found;
    }
    const auto& points = mechanism.body(body).points;
    const auto index_of = [&](Column::Kind kind, const Quantity& quantity) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i].kind == kind && columns[i].quantity == quantity) return i;
        return std::nullopt;
    };
    const auto omega = index_of(Column::Kind::result, omega_of(body));
    if (!omega) return std::nullopt;
    found.omega = *omega;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Quantity& q = columns[i].quantity;
        if (columns[i].kind != Column::Kind::place_x) continue;
        const auto of_same_point = std::count_if(columns.begin(), columns.end(), [&](const Column& other) {
            return other.kind == Column::Kind::place_x && other.quantity.point == q.point;
        });
        // The column of a pin is named after the first of its bodies.
        const bool carried = std::find(points.begin(), points.end(), q.point) != points.end();
        if (q.body != body && (!carried || of_same_point > 1)) continue;
        const auto vx = index_of(Column::Kind::result, q.along(Quantity::Component::x)),
                   vy = index_of(Column::Kind::result, q.along(Quantity::Component::y));
        if (!vx || !vy) continue;
        found.x = i;
        found.y = i + 1;
        found.vx = *vx;
        found.vy = *vy;
        return found;
    }
    return std::nullopt;
}

/// One position: the pole in homogeneous form, P = A + z∧(v_2 − v_1)(A)/ω, and its images on both bodies if it is
/// finite.
struct Sample {
    double s = 0, omega = 0;
    bool known = false, finite = false;  ///< finite: within Centrodes::cut_at
    Spot fixed, moving;
};

class Tracer {
public:
    Tracer(const Mechanism& mechanism, const Pose& pose, Cycle cycle, const Travel& travel, BodyIndex first,
           BodyIndex second)
        : cycle_(std::move(cycle)), travel_(travel), size_(pose.size.to_double()) {
        found_.first = first;
        found_.second = second;
        cycle_.begin(travel, false);
        first_ = columns_of(cycle_.columns(), mechanism, first);
        second_ = columns_of(cycle_.columns(), mechanism, second);
        for (const Vector& point : pose.points) middle_ = middle_ + Spot{point.x.to_double(), point.y.to_double()};
        middle_ = (1.0 / static_cast<double>(std::max<std::size_t>(pose.points.size(), 1))) * middle_;
    }

    Centrodes trace() {
        if (!first_ || !second_) return std::move(found_);
        std::vector<Sample> coarse;
        constexpr int steps = 180;
        const double low = std::min(travel_.from, travel_.to), high = std::max(travel_.from, travel_.to);
        for (int i = 0; i <= steps; ++i) {
            const double s = low + (high - low) * inner(i, steps);
            coarse.push_back(at(s));
            // A change point has no row, and doubles lose digits next to it.
            constexpr double beside = 1e-4;
            if (!coarse.back().known) coarse.back() = at(s + (i == steps ? -beside : beside) * (high - low));
        }
        // The travel is split at places without relative rotation.
        for (std::size_t i = 0; i + 1 < coarse.size(); ++i) walk(coarse[i], coarse[i + 1]);
        finish_branch(false);
        return std::move(found_);
    }

private:
    /// A limit is approached, not reached.
    double inner(int i, int steps) const {
        constexpr double short_of = 1e-7;
        const double share = static_cast<double>(i) / steps;
        const bool forwards = travel_.from < travel_.to;
        const bool low_is_limit = forwards ? travel_.starts_at_limit : travel_.ends_at_limit,
                   high_is_limit = forwards ? travel_.ends_at_limit : travel_.starts_at_limit;
        return std::clamp(share, low_is_limit ? short_of : 0.0, high_is_limit ? 1 - short_of : 1.0);
    }

    Sample at(double s) {
        Sample sample{.s = s, .fixed = {}, .moving = {}};
        const auto row = cycle_.row(s);
        if (!row) return sample;
        const auto omega = [&](const BodyColumns& c) { return c.rests ? 0.0 : (*row)[c.omega]; };
        sample.known = true;
        sample.omega = omega(*second_) - omega(*first_);
        const BodyColumns& base = second_->rests ? *first_ : *second_;
        const Spot place{(*row)[base.x], (*row)[base.y]};
        const auto velocity = [&](const BodyColumns& c) {
            if (c.rests) return Spot{0, 0};
            const Spot arm = place - Spot{(*row)[c.x], (*row)[c.y]};
            return Spot{(*row)[c.vx], (*row)[c.vy]} + (*row)[c.omega] * quarter_turn(arm);
        };
        const Spot relative = velocity(*second_) - velocity(*first_);
        const Spot aside = quarter_turn(relative);
        // A difference of two equal rates within rounding is zero.
        constexpr double rounding = 1e-10;
        if (std::abs(sample.omega) * size_ <= rounding * size_of(relative)) sample.omega = 0;
        sample.finite =
            std::abs(sample.omega) * Centrodes::cut_at * size_ > size_of(aside + sample.omega * (place - middle_));
        if (!sample.finite) return sample;
        const Spot origin = cycle_.positions().origin(), pole = place + (1 / sample.omega) * aside - origin;
        sample.fixed = cycle_.positions().seen_from(found_.first, pole) + origin;
        sample.moving = cycle_.positions().seen_from(found_.second, pole) + origin;
        return sample;
    }

    /// From one sample to the next; refines between them as needed.
    void walk(const Sample& a, const Sample& b) {
        if (!a.known || !b.known) {
            finish_branch(false);
            return;
        }
        if ((a.omega < 0) != (b.omega < 0) && a.omega != 0 && b.omega != 0) {
            const double zero = zero_between(a, b);
            if (pass_standstill(a, zero, b)) return;
            if (a.finite) leave(a, zero);
            finish_branch(true);
            found_.infinities.push_back(zero);
            if (b.finite) enter(zero, b);
            return;
        }
        if (a.finite && b.finite) {
            add(a);
            refine(a, b, 0);
            return;
        }
        // Leaves or enters the drawn range without a change of the sense of rotation.
        if (a.finite) leave(a, b.s);
        if (a.finite) finish_branch(true);
        if (a.finite && b.omega == 0) found_.infinities.push_back(b.s);
        if (b.finite) enter(a.s, b);
    }
    /// If all motion stops and reverses (a rocker at the end of its stroke) the pole is continuous.
    bool pass_standstill(const Sample& a, double zero, const Sample& b) {
        constexpr double beside = 1e-4, near = 0.01;  // relative to the step; relative to the drawing's size
        const Sample left = at(zero - beside * (b.s - a.s)), right = at(zero + beside * (b.s - a.s));
        if (!a.finite || !b.finite || !left.finite || !right.finite) return false;
        if (size_of(right.fixed - left.fixed) > near * size_) return false;
        add(a);
        refine(a, left, 0);
        refine(right, b, 0);
        return true;
    }
    double zero_between(const Sample& a, const Sample& b) {
        double low = a.s, high = b.s;
        for (int i = 0; i < 60 && high - low > 1e-14 * std::max(1.0, std::abs(low)); ++i) {
            const double middle = (low + high) / 2;
            const Sample here = at(middle);
            if (!here.known || here.omega == 0) return middle;
            ((here.omega < 0) == (a.omega < 0) ? low : high) = middle;
        }
        return (low + high) / 2;
    }
    /// The last finite sample from `inside` towards `end`, which is not finite.
    Sample edge(Sample inside, double end) {
        double outside = end;
        for (int i = 0; i < 40; ++i) {
            const Sample here = at((inside.s + outside) / 2);
            if (here.finite)
                inside = here;
            else
                outside = here.s;
        }
        return inside;
    }
    void leave(const Sample& a, double end) {
        add(a);
        const Sample last = edge(a, end);
        if (last.s > a.s) refine(a, last, 0);
    }
    void enter(double start, const Sample& b) {
        const Sample first = edge(b, start);
        branch_.comes_from_infinity = true;
        add(first);
        if (first.s < b.s) refine(first, b, 0);
    }

    /// Bisects until a chord is short and the middle is on it, on both bodies.
    void refine(const Sample& a, const Sample& b, int depth) {
        constexpr int deepest = 24;
        constexpr double flat = 1e-4, longest = 0.04;  // relative to the drawing's size, or to the distance from it
        const Sample middle = at((a.s + b.s) / 2);
        if (!middle.finite || depth == deepest) return add(b);
        const auto is_smooth = [&](const Spot& from, const Spot& by, const Spot& to) {
            const double unit = std::max(size_, 0.3 * size_of(by - middle_));
            return size_of(by - 0.5 * (from + to)) < flat * unit && size_of(to - from) < longest * unit;
        };
        if (is_smooth(a.fixed, middle.fixed, b.fixed) && is_smooth(a.moving, middle.moving, b.moving)) {
            add(middle);
            return add(b);
        }
        refine(a, middle, depth + 1);
        refine(middle, b, depth + 1);
    }
    void add(const Sample& sample) {
        if (!branch_.coordinates.empty() && !(sample.s > branch_.coordinates.back())) return;
        branch_.coordinates.push_back(sample.s);
        branch_.fixed.push_back(sample.fixed);
        branch_.moving.push_back(sample.moving);
    }
    void finish_branch(bool at_infinity) {
        if (branch_.coordinates.size() > 1) {
            branch_.goes_to_infinity = at_infinity;
            found_.branches.push_back(std::move(branch_));
        }
        branch_ = {};
    }

    Cycle cycle_;
    const Travel& travel_;
    double size_;
    Spot middle_;
    std::optional<BodyColumns> first_, second_;
    Centrodes::Branch branch_;
    Centrodes found_;
};

}  // namespace

Result<Centrodes> trace_centrodes(const Mechanism& mechanism, const Pose& pose, int driver, const Travel& travel,
                                  BodyIndex first, BodyIndex second) {
    const Mechanism driven = at_unit_rate(mechanism, driver);
    auto cycle = Cycle::of(driven, pose, driver);
    if (!cycle) return tl::unexpected(std::move(cycle.error()));
    return Tracer(driven, pose, *std::move(cycle), travel, first, second).trace();
}

}  // namespace kinegraph
