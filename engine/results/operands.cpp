#include "engine/results/operands.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/mechanism/problem.hpp"
#include "engine/results/result_names.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph {
namespace {

/// The load alone, if one force or couple acts and has a magnitude of its own.
std::optional<Measured> only_load(const Mechanism& mechanism) {
    const bool weighs = mechanism.gravity || mechanism.inertia_forces;
    if (mechanism.loads.size() != 1 || (weighs && !mechanism.masses.empty())) return std::nullopt;
    const Load& load = mechanism.loads.front();
    if (const auto* couple = std::get_if<CoupleLoad>(&load))
        return Measured{.value = couple->value, .dimension = dimension_of(QuantityKind::moment)};
    const auto* force = std::get_if<ForceLoad>(&load);
    if (force == nullptr) return std::nullopt;
    if (force->magnitude)
        return Measured{.value = abs(force->magnitude->first), .dimension = dimension_of(QuantityKind::force)};
    const double size = std::sqrt(dot(*force->value, *force->value).to_double());
    return Measured{.value = Exact::from_double(size), .dimension = dimension_of(QuantityKind::force)};
}

/// The shortest that reads back as the same double, without an exponent.
std::string decimal_of(double value) {
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
    return {digits.data(), end.ptr};
}

std::string in_si(const Exact& value, QuantityKind kind) {
    return decimal_of(value.to_double()) + " " + std::string(default_unit(kind).symbol);
}
std::string rate_of(const std::string& letter, const std::string& subject) {
    return "'" + letter + " " + subject + "'";
}

/// The bodies that pins at a point join, the given one among them.
std::vector<BodyIndex> pinned_with(BodyIndex body, PointIndex point, const Mechanism& mechanism) {
    std::vector<BodyIndex> all{body};
    const auto is_in = [&](BodyIndex each) { return std::find(all.begin(), all.end(), each) != all.end(); };
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Joint& joint : mechanism.joints)
            if (joint.point == point && joint.pair().holds_point() && !joint.pair().touches() && joint.connects(all[i]))
                for (const BodyIndex each : joint.bodies)
                    if (!is_in(each)) all.push_back(each);
    std::sort(all.begin(), all.end());
    return all;
}
/// "'v G'", "'v A on 3'" where other bodies carry the centre apart; none: it is at rest.
std::optional<std::string> velocity_of_centre(const Mass& mass, const Mechanism& mechanism) {
    const std::vector<BodyIndex> pinned = pinned_with(mass.body, mass.centre, mechanism);
    if (pinned.front() == frame) return std::nullopt;
    const auto is_carried = [&](BodyIndex body) {
        const auto& listed = mechanism.body(body).points;
        return std::find(listed.begin(), listed.end(), mass.centre) != listed.end() ||
               std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                           [&](const Joint& joint) { return joint.point == mass.centre && joint.connects(body); });
    };
    std::string name = mechanism.point(mass.centre).name;
    for (const BodyIndex body : mechanism.moving_bodies())
        if (is_carried(body) && std::find(pinned.begin(), pinned.end(), body) == pinned.end())
            return rate_of("v", name + " on " + mechanism.body(pinned.front()).name);
    return rate_of("v", name);
}
/// Twice the kinetic energy. Empty: nothing that has a mass can move.
std::string twice_kinetic_energy(const Mechanism& mechanism) {
    std::string sum;
    const auto add = [&](const Exact& inert, QuantityKind kind, const std::string& rate) {
        if (!inert.is_zero())
            sum += (sum.empty() ? "" : " + ") + ("(" + in_si(inert, kind) + ") * " + rate) + " * " + rate;
    };
    for (const Mass& each : mechanism.masses) {
        if (const auto rate = velocity_of_centre(each, mechanism)) add(each.mass, QuantityKind::mass, *rate);
        add(each.inertia, QuantityKind::inertia, rate_of("omega", mechanism.body(each.body).name));
    }
    return sum;
}
/// The only driver's rate. None: there are several, or it is that of a point.
std::optional<std::string> rate_of_driver(const Mechanism& mechanism) {
    if (mechanism.drivers.size() != 1) return std::nullopt;
    if (const auto* slide = std::get_if<SlideDriver>(&mechanism.drivers.front()))
        return rate_of("v", mechanism.joint(slide->joint).name);
    const auto* spin = std::get_if<SpinDriver>(&mechanism.drivers.front());
    if (spin == nullptr) return std::nullopt;
    const std::string own = rate_of("omega", mechanism.body(spin->body).name);
    if (spin->relative_to == frame) return own;
    return "(" + own + " - " + rate_of("omega", mechanism.body(spin->relative_to).name) + ")";
}

/// A name for an expression of what constructions find. Does nothing where a name in it contains a quote.
void define(const Key& called, const std::string& name, const std::string& text, const Mechanism& mechanism,
            std::vector<ResultExpression>& all) {
    auto read = ResultExpression::read(name + " = " + text, constructed_results(mechanism));
    if (!read) return;
    read->call(called);
    all.push_back(*std::move(read));
}
void add_mechanical_advantage(const Mechanism& mechanism, std::vector<ResultExpression>& all) {
    const auto load = only_load(mechanism);
    if (!load || load->value.is_zero() || mechanism.efforts.size() != 1) return;
    const std::string effort = std::visit([](const auto& each) { return each.name; }, mechanism.efforts.front());
    define(lang::sheet::mechanical_advantage, "mechanical advantage",
           "(" + in_si(load->value, *kind_of(load->dimension)) + ") / 'effort " + effort + "'", mechanism, all);
}
void add_energies(const Mechanism& mechanism, std::vector<ResultExpression>& all) {
    const std::string twice = twice_kinetic_energy(mechanism);
    if (twice.empty()) return;
    define(lang::sheet::kinetic_energy, "kinetic energy", "(" + twice + ") / 2", mechanism, all);
    const auto rate = rate_of_driver(mechanism);
    if (!rate) return;
    const std::string reduced = "(" + twice + ") / " + *rate + "^2";
    if (std::holds_alternative<SpinDriver>(mechanism.drivers.front()))
        define(lang::sheet::reduced_inertia, "reduced inertia", reduced, mechanism, all);
    else
        define(lang::sheet::reduced_mass, "reduced mass", reduced, mechanism, all);
}

}  // namespace

std::vector<ResultExpression> defined_results(const Mechanism& mechanism) {
    std::vector<ResultExpression> all;
    add_mechanical_advantage(mechanism, all);
    add_energies(mechanism, all);
    return all;
}

std::vector<Column> parameter_columns(const Mechanism& mechanism) {
    std::vector<Column> columns;
    for (const NamedParameter& each : mechanism.parameters) {
        Column column{
            Column::Kind::parameter, {}, each.name, kind_of(each.dimension).value_or(QuantityKind::dimensionless)};
        column.dimension = each.dimension;
        columns.push_back(std::move(column));
    }
    return columns;
}

std::vector<Column> operands_of_expressions(const Mechanism& mechanism, int driver) {
    std::vector<Column> known;
    if (!stands_for_joints(mechanism)) {
        known = possible_results(mechanism, driver);
        known.push_back(transmission_column());
    }
    for (Column& each : parameter_columns(mechanism)) known.push_back(std::move(each));
    return known;
}

std::vector<Column> operands_in(std::span<const std::string> texts, const std::vector<Column>& operands) {
    std::vector<Column> known = operands, found;
    for (const std::string& text : texts) {
        const auto is_it = [&](const Column& each) { return each.name == text; };
        if (const auto named = std::find_if(known.begin(), known.end(), is_it); named != known.end()) {
            found.push_back(*named);
        } else if (const auto read = ResultExpression::read(text, known)) {
            found.insert(found.end(), read->parts().begin(), read->parts().end());
            known.push_back(read->column());
        }
    }
    return found;
}

}  // namespace kinegraph
