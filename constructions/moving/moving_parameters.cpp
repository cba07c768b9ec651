// A file read with another value draws another position of another mechanism. To compare the numbers, each body's
// coordinates are turned back to the orientation that it had first. So the length of a bar is one number, and the
// driver's coordinate has the same meaning.
#include "constructions/moving/moving_parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "constructions/moving/moving_rules.hpp"
#include "engine/board/program.hpp"
#include "engine/file/json_source.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/drivers.hpp"
#include "engine/motion/positions.hpp"
#include "engine/number/functions.hpp"
#include "engine/number/geometry.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

/// Further parameters are left out: each parameter, and each pair, costs several readings of the file.
constexpr std::size_t most_parameters = 8;
/// Required accuracy of a polynomial, relative to the number or to 1 (lengths are in units of the drawing's size).
constexpr double exactly_enough = 1e-11;

// --- lengths

std::string name_of_length(const Mechanism& mechanism, PointIndex from, PointIndex to) {
    const std::string& a = mechanism.point(from).name;
    const std::string& b = mechanism.point(to).name;
    return a + (a.size() > 3 || b.size() > 3 ? "–" : "") + b;
}

/// "45 mm" as its number and unit; none for a formula.
std::optional<WrittenParameter> written(const std::string& name, std::string_view text) {
    WrittenParameter parameter{name, 0, {}};
    const char* const end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, parameter.number);
    if (fault != std::errc{}) return std::nullopt;
    std::string_view unit(rest, static_cast<std::size_t>(end - rest));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    if (!unit.empty() && unit_spelt(unit) == nullptr) return std::nullopt;
    parameter.unit = unit;
    return parameter;
}

/// The hinges of a body; none if it has any other joint.
std::optional<std::vector<PointIndex>> hinges_of(const Mechanism& mechanism, const Pose& pose, BodyIndex body) {
    std::vector<PointIndex> hinges;
    for (const Joint& joint : mechanism.joints) {
        if (!joint.connects(body)) continue;
        if (!joint.pair().is_hinge()) return std::nullopt;
        const auto same = [&](PointIndex other) { return pose.at(other) == pose.at(joint.point); };
        if (std::none_of(hinges.begin(), hinges.end(), same)) hinges.push_back(joint.point);
    }
    return hinges;
}

/// A distributed load is per unit length, so another length would be another load.
bool has_distributed_load(const Mechanism& mechanism, BodyIndex body) {
    return std::any_of(mechanism.loads.begin(), mechanism.loads.end(), [&](const Load& load) {
        const auto* distributed = std::get_if<DistributedLoad>(&load);
        return distributed != nullptr && distributed->body == body;
    });
}

// --- numbers

Spot turned_by(const Spot& a, double angle) {
    const double c = nearest::cos(angle), s = nearest::sin(angle);
    return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// All numbers of a mechanism that may depend on a parameter, with their names; and those that must not.
struct Numbers {
    std::vector<MovingEffect> names;
    std::vector<double> values, fixed;
    std::vector<double> lengths;  ///< by setting of Moving, for lengths; else 0

    void add(MovingEffect::List list, int plan, std::size_t item, int part, double value) {
        names.push_back({list, plan, static_cast<int>(item), part, {}});
        values.push_back(value);
    }
    void add(MovingEffect::List list, std::size_t item, int part, const Spot& value) {
        add(list, -1, item, part, value.x);
        add(list, -1, item, part + 1, value.y);
    }
    bool is_like(const Numbers& other) const { return values.size() == other.values.size() && fixed == other.fixed; }
};

class NumbersReader {
public:
    using List = MovingEffect::List;

    NumbersReader(const Moving& moving, const Mechanism& mechanism, const Pose& pose)
        : moving_(moving), mechanism_(mechanism), pose_(pose), drawn_(directions(mechanism, pose)) {}

    /// None if the file cannot be drawn with these values, or describes another mechanism.
    std::optional<Numbers> read(const Mechanism& mechanism, const Pose& pose) {
        if (mechanism.bodies.size() != mechanism_.bodies.size() ||
            mechanism.points.size() != mechanism_.points.size() ||
            mechanism.drivers.size() != mechanism_.drivers.size() ||
            mechanism.joints.size() != mechanism_.joints.size())
            return std::nullopt;
        const auto positions = Positions::of(mechanism, pose, Course{moving_.courses.front().driver});
        if (!positions || positions->rows().size() != moving_.rows.size() || positions->frozen() != moving_.frozen)
            return std::nullopt;
        numbers_ = {};
        share_ = positions->size() / moving_.unit;
        measure_turns(mechanism, pose, *positions);
        for (std::size_t r = 0; r < moving_.rows.size(); ++r)
            if (!read_row(r, positions->rows()[r])) return std::nullopt;
        read_bodies(positions->bodies());
        read_points(positions->point_rules());
        read_joints(positions->joint_rules());
        if (!read_givens(mechanism, pose)) return std::nullopt;
        read_settings(mechanism, pose);
        read_laws(mechanism);
        return numbers_;
    }

private:
    /// For a body with two places: from its first point to the next.
    static std::vector<std::optional<double>> directions(const Mechanism& mechanism, const Pose& pose) {
        std::vector<std::optional<double>> all(mechanism.bodies.size());
        for (std::size_t b = 1; b < all.size(); ++b) {
            const std::vector<PointIndex>& points = mechanism.bodies[b].points;
            for (std::size_t i = 1; i < points.size() && !all[b]; ++i) {
                const Spot along = to_double(pose.at(points[i]) - pose.at(points[0]));
                if (along.x != 0 || along.y != 0) all[b] = nearest::atan2(along.y, along.x);
            }
        }
        return all;
    }
    /// Rotation of each body relative to its first orientation. For a body without two places: from the direction of
    /// its guide, or that of a body without relative rotation.
    void measure_turns(const Mechanism& mechanism, const Pose& pose, const Positions& positions) {
        const auto now = directions(mechanism, pose);
        std::vector<bool> known(now.size(), false);
        turns_.assign(now.size(), 0);
        known[0] = true;
        const auto take = [&](std::size_t body, double turn) {
            turns_[body] = std::remainder(turn, 2 * nearest::acos(-1.0));
            known[body] = true;
        };
        for (std::size_t b = 1; b < now.size(); ++b)
            if (now[b] && drawn_[b]) take(b, *now[b] - *drawn_[b]);
        for (std::size_t k = 0; k < moving_.joints.size(); ++k) {
            const BodyIndex body = moving_.joints[k].turns_with;
            if (body == none || known[at_index(body)]) continue;
            const Spot &first = moving_.joints[k].guide, &guide = positions.joint_rules()[k].guide;
            if (first.x != 0 || first.y != 0)
                take(at_index(body), nearest::atan2(cross(first, guide), dot(first, guide)));
        }
        for (std::size_t pass = 0; pass < now.size(); ++pass) {
            for (const auto& row : moving_.rows) {
                if (row.kind != ClosureRowOf<double>::Kind::turns || row.driver >= 0) continue;
                const std::size_t i = at_index(row.i), j = at_index(row.j);
                if (known[i] && !known[j]) take(j, turns_[i]);
                if (known[j] && !known[i]) take(i, turns_[j]);
            }
        }
    }
    double turn(BodyIndex body) const { return body == none ? 0 : turns_[at_index(body)]; }
    /// A place or length of a body, in the first orientation and unit.
    Spot of(BodyIndex body, const Spot& local) const { return turned_by(share_ * local, -turn(body)); }
    static Spot as_long_as(const Spot& first, const Spot& now) {
        const double size = nearest::hypot(now.x, now.y);
        return size == 0 ? now : (nearest::hypot(first.x, first.y) / size) * now;
    }

    bool read_row(std::size_t r, const ClosureRowOf<double>& row) {
        using Kind = ClosureRowOf<double>::Kind;
        const ClosureRowOf<double>& first = moving_.rows[r];
        if (row.kind != first.kind || row.i != first.i || row.j != first.j || row.driver != first.driver) return false;
        const double against = turn(row.i) - turn(row.j);
        Spot p = of(row.i, row.p), q = of(row.j, row.q), along = row.along;
        double offset = share_ * row.offset;
        if (row.kind == Kind::turns) {
            numbers_.add(List::row, -1, r, 6, row.driver >= 0 ? 0 : std::remainder(against, 2 * nearest::acos(-1.0)));
            return true;
        }
        if (row.kind == Kind::on_line) {
            // The place of Q along the line is arbitrary, and so is P's on a body without relative rotation; a driver's
            // zero stays at its first place.
            along = turned_by(along, -turn(row.j));
            offset += dot(along, q - first.q) - share_ * row.lever * against;
            q = first.q;
            if (turn_together(row.i, row.j) && against == 0) {
                offset -= dot(along, p - first.p);
                p = first.p;
            }
            if (row.driver >= 0) offset = first.offset;
        } else if (row.kind == Kind::rolls_round) {
            along = turned_by(along, -(row.share_i * turn(row.i) + row.share_j * turn(row.j)));
        }
        numbers_.add(List::row, r, 0, p);
        numbers_.add(List::row, r, 2, q);
        numbers_.add(List::row, r, 4, along);
        numbers_.add(List::row, -1, r, 6, offset);
        numbers_.add(List::row, -1, r, 7, share_ * row.lever);
        numbers_.add(List::row, -1, r, 8, row.share_i);
        numbers_.add(List::row, -1, r, 9, row.share_j);
        return true;
    }
    bool turn_together(BodyIndex i, BodyIndex j) const {
        return std::any_of(moving_.rows.begin(), moving_.rows.end(), [&](const ClosureRowOf<double>& row) {
            return row.kind == ClosureRowOf<double>::Kind::turns && row.driver < 0 &&
                   ((row.i == i && row.j == j) || (row.i == j && row.j == i));
        });
    }
    /// For a freely moving body it is only the initial value of Newton's method.
    void read_bodies(const std::vector<Closure::Body>& bodies) {
        for (std::size_t b = 0; b < bodies.size(); ++b)
            if (bodies[b].x < 0) numbers_.add(List::body, b, 0, share_ * to_double(bodies[b].reference));
    }
    void read_points(const std::vector<Positions::PointRule>& points) {
        for (std::size_t p = 0; p < points.size(); ++p)
            if (points[p].carrier.body != none)
                numbers_.add(List::point, p, 0, of(points[p].carrier.body, points[p].local));
    }
    void read_joints(const std::vector<Positions::JointRule>& joints) {
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const Positions::JointRule &joint = joints[k], &first = moving_.joints[k];
            const bool slides = first.turns_with != none && !first.touches;
            for (std::size_t side = 0; side < 2; ++side) {
                // Sliding is measured from the first position.
                if (slides && (side == 1 || turn_together(first.bodies[0], first.bodies[1]))) continue;
                numbers_.add(List::local, k, static_cast<int>(2 * side), of(joint.bodies[side], joint.locals[side]));
                numbers_.add(List::reach, -1, k, static_cast<int>(side), share_ * joint.reaches[side]);
            }
            const double back = -turn(first.turns_with);
            numbers_.add(List::guide, k, 0, as_long_as(first.guide, turned_by(joint.guide, back)));
            numbers_.add(List::tangent, k, 0, as_long_as(first.tangent, turned_by(joint.tangent, back)));
            for (const double each : {joint.pressure.x, joint.pressure.y}) numbers_.fixed.push_back(each);
        }
    }
    /// Givens that are the same in every position; for others the constants of their rule.
    bool read_givens(const Mechanism& mechanism, const Pose& pose) {
        const MovingRules rules(mechanism, pose);
        for (std::size_t p = 0; p < moving_.plans.size(); ++p) {
            const MovingPlan& plan = moving_.plans[p];
            const int in = static_cast<int>(p);
            std::size_t next = 0;
            for (std::size_t g = 0; g < plan.program.givens.size(); ++g) {
                const Given& given = plan.program.givens[g];
                const auto rule = rules.of(given, static_cast<int>(g));
                const bool is_moving = next < plan.moving.size() && plan.moving[next].given == static_cast<int>(g);
                if (rule.has_value() != is_moving || (rule && rule->rule != plan.moving[next].rule)) return false;
                if (rule) {
                    numbers_.add(List::given_factor, in, next, 0, rule->factor);
                    numbers_.add(List::given_offset, in, next, 0,
                                 rule->offset - (rule->rule == MovingGiven::Rule::torsion
                                                     ? turn(rule->bodies[0]) - turn(rule->bodies[1])
                                                     : 0));
                    ++next;
                } else {
                    read_constant(in, g, to_double(given_value(given, mechanism, pose)));
                }
            }
        }
        return true;
    }
    void read_constant(int plan, std::size_t given, const ValueOf<double>& value) {
        const auto add = [&](std::initializer_list<double> parts) {
            int part = 0;
            for (const double each : parts) numbers_.add(List::given, plan, given, part++, each);
        };
        if (const auto* point = std::get_if<PointOf<double>>(&value)) add({point->x, point->y, point->w});
        if (const auto* line = std::get_if<LineOf<double>>(&value)) add({line->a, line->b, line->c});
        if (const auto* vector = std::get_if<VectorOf<double>>(&value)) add({vector->x, vector->y});
        if (const auto* scalar = std::get_if<double>(&value)) add({*scalar});
    }
    void read_settings(const Mechanism& mechanism, const Pose& pose) {
        const MovingRules rules(mechanism, pose);
        for (std::size_t i = 0; i < rules.settings().size(); ++i)
            numbers_.add(List::setting, -1, i, 0, rules.settings()[i].value);
        for (const MovingSetting& each : moving_.settings) {
            const bool is_length = each.kind == MovingSetting::Kind::bar || each.kind == MovingSetting::Kind::ground;
            const Spot apart = is_length ? to_double(pose.at(each.ends[1]) - pose.at(each.ends[0])) : Spot{0, 0};
            numbers_.lengths.push_back(nearest::hypot(apart.x, apart.y) / moving_.unit);
        }
    }
    /// They are stored in the samples of a travel, and must not change.
    void read_laws(const Mechanism& mechanism) {
        for (const Driver& driver : mechanism.drivers) {
            const Law* law = law_of(driver);
            if (law == nullptr) continue;
            for (int i = 0; i <= 8; ++i) {
                const LawState state = law->at(law->drawn.to_double() + i / 8.0);
                for (const double each : {state.s, state.first, state.second}) numbers_.fixed.push_back(each);
            }
        }
    }

    const Moving& moving_;
    const Mechanism& mechanism_;
    const Pose& pose_;
    std::vector<std::optional<double>> drawn_;  ///< directions, by body
    std::vector<double> turns_;                 ///< by body, rad
    double share_ = 1;                          ///< this unit divided by that of `moving_`
    Numbers numbers_;
};

/// Rounded to twelve digits: further digits contain rounding errors of sines, which differ between machines.
double to_twelve_digits(double value) {
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::scientific, 11).ptr;
    double rounded = 0;
    std::from_chars(digits.data(), end, rounded);
    return rounded;
}

// --- polynomials

/// A matrix of size one or two.
struct Small {
    std::size_t rows = 1, columns = 1;
    std::array<double, 4> of{};
    double& at(std::size_t i, std::size_t j) { return of[2 * i + j]; }
    double at(std::size_t i, std::size_t j) const { return of[2 * i + j]; }
};
Small product(const Small& a, const Small& b) {
    Small c{a.rows, b.columns};
    for (std::size_t i = 0; i < a.rows; ++i)
        for (std::size_t j = 0; j < b.columns; ++j)
            for (std::size_t k = 0; k < a.columns; ++k) c.at(i, j) += a.at(i, k) * b.at(k, j);
    return c;
}
Small transposed(const Small& a) {
    Small b{a.columns, a.rows};
    for (std::size_t i = 0; i < a.rows; ++i)
        for (std::size_t j = 0; j < a.columns; ++j) b.at(j, i) = a.at(i, j);
    return b;
}
Small inverse(const Small& a) {
    if (a.rows == 1) return {1, 1, {1 / a.at(0, 0)}};
    const double det = a.at(0, 0) * a.at(1, 1) - a.at(0, 1) * a.at(1, 0);
    return {2, 2, {a.at(1, 1) / det, -a.at(0, 1) / det, -a.at(1, 0) / det, a.at(0, 0) / det}};
}

/// number = base + Σ slopes · Δ + Σ products · Δ Δ, with Δ as in MovingEffect.
class Fit {
public:
    Fit(Moving& moving, const Mechanism& mechanism, const Pose& pose, const Rereading& rereading)
        : moving_(moving), rereading_(rereading), reader_(moving, mechanism, pose) {
        if (auto base = reader_.read(mechanism, pose)) base_ = *std::move(base);
    }

    void add_all() {
        using Why = Moving::Fixed::Why;
        for (const WrittenParameter& parameter : rereading_.parameters) {
            std::optional<Why> why;
            if (base_.values.empty())
                why = Why::otherwise;
            else if (parameter.number == 0)
                why = Why::zero;
            else if (taken_.size() >= most_parameters)
                why = Why::many;
            else
                why = try_parameter(parameter);
            if (why) moving_.fixed.push_back({*why, parameter.name});
        }
        if (taken_.empty()) return;
        drop_lengths();
        write();
    }

private:
    struct Taken {
        WrittenParameter parameter;
        double step = 0;
        double radians = 0;

        std::size_t count() const { return radians == 0 ? 1 : 2; }  // number of Δ
        /// Δ if the value in the file is increased by `more`.
        std::array<double, 2> deltas(double more) const {
            if (radians == 0) return {more, 0};
            const double now = (parameter.number + more) * radians, then = parameter.number * radians;
            return {nearest::cos(now) - nearest::cos(then), nearest::sin(now) - nearest::sin(then)};
        }
        double largest() const {  // largest Δ of a step
            const auto all = deltas(step);
            return std::max(std::abs(all[0]), std::abs(all[1]));
        }
        /// Values at which the file is read, as many as Δ; and the Δ at these, one row each.
        std::array<double, 2> steps() const { return {step, -step}; }
        Small at_steps() const {
            Small all{count(), count()};
            for (std::size_t k = 0; k < count(); ++k)
                for (std::size_t a = 0; a < count(); ++a) all.at(k, a) = deltas(steps()[k])[a];
            return all;
        }
    };
    using Differences = std::vector<std::pair<std::size_t, double>>;  // index of the parameter, increase
    using Delta = std::size_t;                                        // 2 · index of the parameter, + 1 for the sine

    /// None if these values give another mechanism.
    std::optional<Numbers> numbers(const std::vector<Taken>& all, const Differences& differences) {
        std::vector<Setting> set;
        for (const auto& [index, by] : differences) {
            const WrittenParameter& parameter = all[index].parameter;
            std::array<char, 32> digits{};
            const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), parameter.number + by).ptr;
            set.push_back({parameter.name,
                           std::string(digits.data(), end) + (parameter.unit.empty() ? "" : " " + parameter.unit)});
        }
        const auto mechanism = rereading_.read(set);
        if (!mechanism) return std::nullopt;
        const auto pose = draw_pose(*mechanism);
        if (!pose) return std::nullopt;
        auto found = reader_.read(*mechanism, *pose);
        if (!found || !found->is_like(base_)) return std::nullopt;
        return found;
    }

    static double radians_of(const WrittenParameter& parameter) {
        const KnownUnit* unit = parameter.unit.empty() ? nullptr : unit_spelt(parameter.unit);
        return unit != nullptr && unit->kind == QuantityKind::angle ? unit->si.to_double() : 0;
    }
    /// Adds the parameter if all dependent numbers are polynomials in its Δ, also together with earlier parameters;
    /// else returns the reason.
    std::optional<Moving::Fixed::Why> try_parameter(const WrittenParameter& parameter) {
        const double radians = radians_of(parameter), whole = radians == 0 ? std::abs(parameter.number) : 2.5 / radians;
        for (const double share : {0.125, 0.015625}) {
            std::vector<Taken> all = taken_;
            all.push_back({parameter, share * whole, radians});
            const auto slopes_before = slopes_;
            const auto products_before = products_;
            const std::size_t own = taken_.size();
            if (fit(all, own) && holds(all, own)) {
                if (moves(own)) {
                    taken_ = std::move(all);
                    return std::nullopt;
                }
                slopes_ = slopes_before;
                products_ = products_before;
                return Moving::Fixed::Why::nothing;
            }
            slopes_ = slopes_before;
            products_ = products_before;
        }
        return Moving::Fixed::Why::otherwise;
    }
    bool moves(std::size_t own) const {
        const auto is_there = [](double slope) { return slope != 0; };
        return std::any_of(slopes_.begin(), slopes_.end(), [&](const auto& each) {
            return each.first / 2 == own && std::any_of(each.second.begin(), each.second.end(), is_there);
        });
    }
    bool fit(const std::vector<Taken>& all, std::size_t own) {
        const double step = all[own].step;
        const auto more = numbers(all, {{own, step}}), less = numbers(all, {{own, -step}});
        if (!more || !less) return false;
        std::vector<bool> differ;
        for (std::size_t i = 0; i < base_.lengths.size(); ++i)
            differ.push_back(std::abs(more->lengths[i] - base_.lengths[i]) > exactly_enough);
        lengths_by_[own] = std::move(differ);
        if (all[own].radians == 0)
            fit_polynomial(own, step, *more, *less);
        else
            fit_angle(all[own], own, *more, *less);
        for (std::size_t other = 0; other < own; ++other)
            if (!fit_together(all, other, own)) return false;
        return true;
    }
    void fit_polynomial(std::size_t own, double step, const Numbers& more, const Numbers& less) {
        std::vector<double>&slope = slopes_[2 * own], &square = products_[{2 * own, 2 * own}];
        slope.clear();
        square.clear();
        for (std::size_t i = 0; i < base_.values.size(); ++i) {
            const double up = more.values[i] - base_.values[i], down = base_.values[i] - less.values[i];
            slope.push_back(without_noise((up + down) / (2 * step), step, i));
            square.push_back(without_noise((up - down) / (2 * step * step), step * step, i));
        }
    }
    void fit_angle(const Taken& taken, std::size_t own, const Numbers& more, const Numbers& less) {
        const Small solved = inverse(taken.at_steps());
        for (std::size_t a = 0; a < 2; ++a) slopes_[2 * own + a].clear();
        for (std::size_t i = 0; i < base_.values.size(); ++i) {
            const Small by =
                product(solved, {2, 1, {more.values[i] - base_.values[i], 0, less.values[i] - base_.values[i], 0}});
            for (std::size_t a = 0; a < 2; ++a)
                slopes_[2 * own + a].push_back(without_noise(by.at(a, 0), taken.largest(), i));
        }
    }
    /// Fits the products of both parameters' Δ, beyond their separate effects.
    bool fit_together(const std::vector<Taken>& all, std::size_t other, std::size_t own) {
        const Taken &first = all[other], &second = all[own];
        std::vector<Small> beyond(base_.values.size(), Small{first.count(), second.count()});
        for (std::size_t k = 0; k < first.count(); ++k)
            for (std::size_t l = 0; l < second.count(); ++l) {
                const Differences at{{other, first.steps()[k]}, {own, second.steps()[l]}};
                const auto both = numbers(all, at);
                if (!both) return false;
                const std::vector<double> alone = values(all, at);
                for (std::size_t i = 0; i < alone.size(); ++i) beyond[i].at(k, l) = both->values[i] - alone[i];
            }
        const Small before = inverse(first.at_steps()), after = transposed(inverse(second.at_steps()));
        const double size = first.largest() * second.largest();
        for (std::size_t a = 0; a < first.count(); ++a)
            for (std::size_t b = 0; b < second.count(); ++b) {
                std::vector<double>& found = products_[{2 * other + a, 2 * own + b}];
                found.clear();
                for (std::size_t i = 0; i < beyond.size(); ++i)
                    found.push_back(without_noise(product(product(before, beyond[i]), after).at(a, b), size, i));
            }
        return true;
    }
    double without_noise(double slope, double by, std::size_t i) const {
        return std::abs(slope * by) < 1e-13 * std::max(std::abs(base_.values[i]), 1.0) ? 0 : to_twelve_digits(slope);
    }
    /// Evaluates the fitted polynomials.
    std::vector<double> values(const std::vector<Taken>& all, const Differences& differences) const {
        std::map<Delta, double> deltas;
        for (const auto& [index, more] : differences)
            for (std::size_t a = 0; a < all[index].count(); ++a) deltas[2 * index + a] = all[index].deltas(more)[a];
        std::vector<double> found = base_.values;
        const auto add = [&](const std::vector<double>& slopes, double by) {
            for (std::size_t i = 0; i < found.size(); ++i) found[i] += slopes[i] * by;
        };
        for (const auto& [a, by_a] : deltas) {
            add(slopes_.at(a), by_a);
            for (const auto& [b, by_b] : deltas)
                if (const auto known = products_.find({a, b}); known != products_.end())
                    add(known->second, by_a * by_b);
        }
        return found;
    }
    /// Tests at values not used for the fit: in each direction, and together with all other parameters.
    bool holds(const std::vector<Taken>& all, std::size_t own) {
        Differences together;
        for (std::size_t i = 0; i <= own; ++i) together.emplace_back(i, (i % 2 == 0 ? 0.7 : -0.6) * all[i].step);
        for (const Differences& at :
             {Differences{{own, 1.5 * all[own].step}}, Differences{{own, -1.2 * all[own].step}}, together}) {
            const auto found = numbers(all, at);
            if (!found) return false;
            const std::vector<double> expected = values(all, at);
            for (std::size_t i = 0; i < expected.size(); ++i)
                if (!(std::abs(found->values[i] - expected[i]) <=
                      exactly_enough * std::max(std::abs(expected[i]), 1.0)))
                    return false;
        }
        return true;
    }

    /// A length that depends on a parameter cannot be changed directly.
    void drop_lengths() {
        std::vector<MovingSetting> kept;
        for (std::size_t i = 0; i < moving_.settings.size(); ++i) {
            const auto hangs = [&](std::size_t own) { return lengths_by_.at(own)[i]; };
            bool is_free = true;
            for (std::size_t own = 0; own < taken_.size(); ++own) is_free = is_free && !hangs(own);
            if (is_free) kept.push_back(std::move(moving_.settings[i]));
        }
        moving_.settings = std::move(kept);
    }
    void write() {
        const std::size_t first = moving_.settings.size();
        const auto index_of = [&](Delta delta) { return static_cast<int>(2 * first + delta); };
        for (const Taken& each : taken_) {
            MovingSetting setting;
            setting.kind = MovingSetting::Kind::parameter;
            setting.name = each.parameter.name;
            setting.value = each.parameter.number;
            setting.written_unit = each.parameter.unit;
            setting.radians = each.radians;
            moving_.settings.push_back(std::move(setting));
        }
        for (std::size_t i = 0; i < base_.names.size(); ++i) {
            MovingEffect effect = base_.names[i];
            for (const auto& [delta, slopes] : slopes_)
                if (slopes[i] != 0) effect.terms.push_back({index_of(delta), -1, slopes[i]});
            for (const auto& [pair, product] : products_)
                if (product[i] != 0) effect.terms.push_back({index_of(pair.first), index_of(pair.second), product[i]});
            if (!effect.terms.empty()) moving_.effects.push_back(std::move(effect));
        }
    }

    Moving& moving_;
    const Rereading& rereading_;
    NumbersReader reader_;
    Numbers base_;
    std::vector<Taken> taken_;
    std::map<Delta, std::vector<double>> slopes_;                      ///< by number
    std::map<std::pair<Delta, Delta>, std::vector<double>> products_;  ///< of two parameters, or of one squared
    std::map<std::size_t, std::vector<bool>> lengths_by_;              ///< by parameter, by setting
};

}  // namespace

std::vector<MovingSetting> lengths_of(const Mechanism& mechanism, const Pose& pose) {
    std::vector<MovingSetting> lengths;
    const auto add = [&](MovingSetting::Kind kind, BodyIndex body, PointIndex from, PointIndex to) {
        MovingSetting length;
        length.kind = kind;
        length.of = body.number();
        length.name = name_of_length(mechanism, from, to);
        length.unit = QuantityKind::length;
        length.ends = {from, to};
        const Spot along = to_double(pose.at(to) - pose.at(from));
        length.value = nearest::hypot(along.x, along.y);
        lengths.push_back(std::move(length));
    };
    const auto carriers = carriers_of(mechanism);
    if (!carriers) return lengths;
    for (const BodyIndex body : mechanism.moving_bodies()) {
        const auto hinges = hinges_of(mechanism, pose, body);
        if (!hinges || hinges->size() != 2 || mechanism.body(body).circle || has_distributed_load(mechanism, body))
            continue;
        bool is_bar = true;
        for (std::size_t i = 0; i < carriers->size(); ++i)
            if ((*carriers)[i].body == body)
                is_bar = is_bar && collinear(pose.at((*hinges)[0]), pose.at((*hinges)[1]),
                                             pose.at(PointIndex(static_cast<int>(i))));
        if (is_bar) add(MovingSetting::Kind::bar, body, (*hinges)[0], (*hinges)[1]);
    }
    const auto ground = hinges_of(mechanism, pose, frame);
    if (ground && ground->size() == 2) add(MovingSetting::Kind::ground, frame, (*ground)[0], (*ground)[1]);
    return lengths;
}

namespace {
std::vector<std::array<std::string, 2>> written_rates(const JsonValue& drivers) {
    std::vector<std::array<std::string, 2>> rates;
    if (!drivers || !drivers.is_array()) return rates;
    for (const JsonValue driver : drivers) {
        std::array<std::string, 2>& units = rates.emplace_back();
        if (!driver.is_object()) continue;
        for (const auto& [key, place] : {std::pair{"omega", 0U}, {"speed", 0U}, {"alpha", 1U}, {"acceleration", 1U}}) {
            const JsonValue value = driver[key];
            const auto found = value ? written(key, value.text()) : std::nullopt;
            if (found && unit_spelt(found->unit) != nullptr) units[place] = found->unit;
        }
    }
    return rates;
}
}  // namespace

Rereading rereading_of(std::string text, std::string source, std::vector<Setting> set) {
    Rereading rereading;
    const auto file = JsonSource::read(text);
    if (file) rereading.rates = written_rates(file->root()["drivers"]);
    const JsonValue parameters = file ? file->root()["parameters"] : JsonValue{};
    if (!parameters || !parameters.is_object()) return rereading;
    for (const JsonValue each : parameters) {
        const std::string name(each.key());
        const auto own =
            std::find_if(set.begin(), set.end(), [&](const Setting& setting) { return setting.name == name; });
        if (const auto found = written(name, own != set.end() ? std::string_view(own->value) : each.text()))
            rereading.parameters.push_back(*found);
    }
    rereading.read = [text = std::move(text), source = std::move(source),
                      set = std::move(set)](std::span<const Setting> others) {
        std::vector<Setting> all = set;
        for (const Setting& other : others) {
            std::erase_if(all, [&](const Setting& each) { return each.name == other.name; });
            all.push_back(other);
        }
        return read_mechanism(text, source, all);
    };
    return rereading;
}

void add_parameters(Moving& moving, const Mechanism& mechanism, const Pose& pose, const Rereading& rereading) {
    if (!rereading.parameters.empty()) Fit(moving, mechanism, pose, rereading).add_all();
}

}  // namespace kinegraph
