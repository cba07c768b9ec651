#include "constructions/verdicts/worked_arithmetic/of_motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/geometry.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::worked_arithmetic {

using Role = DrawnVector::Role;

void OfMotion::add_slidings() {
    auto velocity = solution_.sliding.begin(), acceleration = velocity;
    for (const StatementIndex statement : indices_of(protocol_.statements)) {
        Message& said = telling_.message(statement);
        if (said.sentence == lang::sentences::slide_velocity_on_rest) ++velocity;
        if (said.sentence == lang::sentences::slide_velocity)
            slides(statement, (velocity++)->velocity, units_.velocity);
        const bool on_rest = said.sentence == lang::sentences::slide_acceleration_on_rest;
        if (!on_rest && said.sentence != lang::sentences::slide_acceleration) continue;
        while (!acceleration->acceleration) ++acceleration;
        const Sliding& sliding = *acceleration++;
        if (on_rest) continue;
        const double coriolis = length(*sliding.coriolis);
        if (magnitudes_.is_noise({.kind = Quantity::Kind::sliding_coriolis, .joint = sliding.joint}, coriolis)) {
            said.sentence = lang::sentences::slide_acceleration_without_coriolis;
        } else {
            Symbol symbol = std::get<Symbol>(said.arguments[0]);
            symbol.term = "cor";
            const double omega = std::abs(
                telling_.spin(solution_.mechanism.joints[at_index(sliding.joint)].bodies[1], Symbol::Letter::omega));
            const double speed = length(*sliding.velocity);
            telling_.tell(statement, symbol, {{2}, {omega}, {in(speed, units_.acceleration)}}, std::nullopt,
                          in(coriolis, units_.acceleration), units_.acceleration);
        }
        slides(statement, sliding.acceleration, units_.acceleration);
    }
}

void OfMotion::slides(StatementIndex statement, const Recorded<Vector>& found, const Unit& unit) {
    telling_.tell(statement, std::get<Symbol>(telling_.message(statement).arguments[0]), {}, std::nullopt,
                  in(length(*found), unit), unit);
}

void OfMotion::drawn(const DrawnVector& vector) {
    const Message& said = telling_.message(vector.statement);
    if (said.sentence == lang::sentences::auxiliary_point) tell_place(vector);
    const bool alike = said.sentence == lang::sentences::translating_velocity ||
                       said.sentence == lang::sentences::translating_acceleration;
    // A crank with uniform rotation has only its normal part, which is given.
    const bool uniform = said.sentence == lang::sentences::crank_acceleration && said.arguments.size() == 5;
    if (alike || (vector.role == Role::absolute && uniform)) return;
    const Unit& unit = unit_of(vector);
    const double si = protocol_.modulus_of(vector), value = in(si, unit);
    if (magnitudes_.is_noise(vector.quantity, si))
        return telling_.tell(vector.statement, vector.symbol, {}, std::nullopt, 0, unit);
    const bool known = is_known(vector);
    Factors factors = known ? factors_of(vector, si) : Factors{};
    std::optional<double> divisor;
    if (const std::optional<double> sliding = known ? speed_in_slot(vector) : std::nullopt) {
        factors = {{in(*sliding, units_.velocity), true}};
        divisor = in(lever_of(vector), units_.velocity) *
                  (units_.acceleration.si.to_double() / units_.velocity.si.to_double());
    }
    // A known term of an equation needs no value unless there is arithmetic.
    if (known && factors.empty() && protocol_.statements[at_index(vector.statement)].equation) return;
    if (said.sentence == lang::sentences::crank_velocity && !factors.empty())
        telling_.tell_given_turning(vector.statement, std::get<Symbol>(said.arguments[4]),
                                    telling_.spin(vector.body, Symbol::Letter::omega));
    telling_.tell(vector.statement, vector.symbol, std::move(factors), divisor, value, unit);
    if (vector.role == Role::coriolis) tell_direction(vector);
}

/// The place of an auxiliary point, which has no name in the file; in the file's length unit.
void OfMotion::tell_place(const DrawnVector& of_auxiliary) {
    std::vector<Argument>& arguments = telling_.message(of_auxiliary.statement).arguments;
    constexpr std::size_t point_body_and_lines = 4;
    const std::optional<Vector> place = auxiliary_named(std::get<Symbol>(arguments[0]).about);
    if (arguments.size() != point_body_and_lines || !place) return;
    for (const Exact& coordinate : {place->x, place->y})
        arguments.emplace_back(Amount{in(coordinate.to_double(), units_.length), units_.length.symbol});
}

/// The place of an auxiliary point, found from the vector drawn for it.
std::optional<Vector> OfMotion::auxiliary_named(const std::string& name) const {
    for (const DrawnVector& vector : protocol_.vectors) {
        if (vector.statement == none) continue;
        const Message& said = protocol_.statements[at_index(vector.statement)].message;
        if (said.sentence != lang::sentences::auxiliary_point || std::get<Symbol>(said.arguments[0]).about != name)
            continue;
        if (vector.seen.of.place == none) continue;
        if (const ProjectivePoint& point = protocol_.point(vector.seen.of.place); !point.at_infinity())
            return point.place();
    }
    return std::nullopt;
}

void OfMotion::tell_direction(const DrawnVector& coriolis) {
    Working& told = telling_.message(coriolis.statement).worked_arithmetic.back();
    const BodyIndex turning = coriolis.seen.to.body;
    if (told.of != coriolis.symbol || told.factors.empty() || turning == none) return;
    const bool observed = protocol_.polygons[at_index(coriolis.polygon)].kind == Polygon::Kind::relative_motion;
    const Symbol omega{Symbol::Letter::omega, solution_.mechanism.bodies[at_index(turning)].name, ""};
    told.turned = {velocity_of_coriolis(coriolis.symbol, observed), omega};
}

/// Whether its length was given, and not measured.
bool OfMotion::is_known(const DrawnVector& vector) const {
    const std::optional<Equation>& equation = protocol_.statements[at_index(vector.statement)].equation;
    if (!equation) return true;
    for (const std::vector<Term>& side : equation->sides)
        for (const Term& term : side)
            if (term.symbol == vector.symbol) return term.magnitude_known;
    return false;
}

Factors OfMotion::factors_of(const DrawnVector& vector, double si) {
    const Unit& unit = unit_of(vector);
    const auto turning = [&](BodyIndex body) { return std::abs(telling_.spin(body, Symbol::Letter::omega)); };
    switch (vector.role) {
        case Role::absolute:
            // The crank of the sentence: from its pivot with its ω.
            if (telling_.message(vector.statement).sentence == lang::sentences::crank_velocity &&
                turning(vector.body) > 0)
                return {{turning(vector.body)}, {in(si / turning(vector.body), unit)}};
            return {};
        case Role::normal: return {{turning(vector.body), true}, {in(lever_of(vector), unit)}};
        case Role::tangential:
            // Here α follows from the vector.
            if (telling_.message(vector.statement).sentence == lang::sentences::alpha_from_pair) return {};
            return {{std::abs(
                        telling_.spin(vector.body, protocol_.polygons[at_index(vector.polygon)].plane == Plane::velocity
                                                       ? Symbol::Letter::omega
                                                       : Symbol::Letter::alpha))},
                    {in(lever_of(vector), unit)}};
        case Role::coriolis: {
            const double omega = turning(vector.seen.to.body);
            return omega > 0 ? Factors{{2}, {omega}, {in(si / (2 * omega), unit)}} : Factors{};
        }
        default: return {};
    }
}

/// Of a normal term of a slide: the relative velocity of the same two places, of which it is v²/ρ.
std::optional<double> OfMotion::speed_in_slot(const DrawnVector& normal) const {
    if (normal.role != Role::normal || normal.seen.about == none) return std::nullopt;
    for (const DrawnVector& vector : protocol_.vectors)
        if (vector.role == Role::sliding && protocol_.polygons[at_index(vector.polygon)].plane == Plane::velocity &&
            vector.seen.of.place == normal.seen.of.place && vector.seen.of.body == normal.seen.of.body &&
            vector.seen.to.body == normal.seen.to.body)
            return protocol_.modulus_of(vector);
    return std::nullopt;
}

double OfMotion::lever_of(const DrawnVector& vector) const {
    if (vector.seen.about == none || vector.seen.of.place == none) return 0;
    const ProjectivePoint &from = protocol_.point(vector.seen.about), &to = protocol_.point(vector.seen.of.place);
    return from.at_infinity() || to.at_infinity() ? 0 : distance(from.place(), to.place());
}

const Unit& OfMotion::unit_of(const DrawnVector& vector) const {
    return protocol_.polygons[at_index(vector.polygon)].plane == Plane::velocity ? units_.velocity
                                                                                 : units_.acceleration;
}

void OfMotion::turning_found(StatementIndex statement, const Quantity& quantity, Symbol::Letter letter) {
    const Message& said = telling_.message(statement);
    const bool omega = letter == Symbol::Letter::omega;
    const double value = telling_.spin(quantity.body, letter);
    const Symbol of{letter, solution_.mechanism.bodies[at_index(quantity.body)].name, ""};
    static const Unit per_second_squared{"rad/s²", 1};
    const auto tell = [&](Factors factors, std::optional<double> divisor, double result) {
        if (omega)
            telling_.tell_turning(statement, of, std::move(factors), divisor, result);
        else
            telling_.tell(statement, of, std::move(factors), divisor, result, per_second_squared);
    };
    if (said.sentence == lang::sentences::omega_by_fixed_guide ||
        said.sentence == lang::sentences::alpha_by_fixed_guide)
        return;
    if (magnitudes_.is_noise(quantity, value)) return tell({}, std::nullopt, 0);
    Factors factors;
    std::optional<double> divisor;
    const bool from_pair =
        said.sentence == lang::sentences::omega_from_pair || said.sentence == lang::sentences::alpha_from_pair;
    const bool from_parallels = said.sentence == lang::sentences::omega_from_parallels ||
                                said.sentence == lang::sentences::alpha_from_parallels;
    if (from_pair || from_parallels)
        if (const auto lever = segment_length(std::get<Segment>(said.arguments[from_pair ? 2 : 1]))) {
            const Unit& linear = omega ? units_.velocity : units_.acceleration;
            factors = {{in(value * *lever, linear)}};
            divisor = in(*lever, linear);
        }
    tell(std::move(factors), divisor, value);
}

/// For places with names in the file; a star distinguishes bodies, not places.
std::optional<double> OfMotion::segment_length(const Segment& segment) const {
    const auto place = [&](std::string name) -> std::optional<Vector> {
        while (name.ends_with('*')) name.pop_back();
        const auto point = solution_.mechanism.point_named(name);
        return point ? std::optional(solution_.pose.at(*point)) : auxiliary_named(name);
    };
    const auto from = place(segment.from), to = place(segment.to);
    return from && to ? std::optional(distance(*from, *to)) : std::nullopt;
}

void OfMotion::carried_over(const SecondWay& way) {
    for (const StatementIndex statement : indices_of(protocol_.statements)) {
        const Message& said = telling_.message(statement);
        if (said.sentence != lang::sentences::second_way || !way.omega) continue;
        const Symbol of = std::get<Symbol>(said.arguments[0]);
        if (of.about != solution_.mechanism.bodies[at_index(way.body)].name) continue;
        const BodyIndex driver = *solution_.mechanism.body_named(std::get<Symbol>(said.arguments[4]).about);
        const auto from = centre_of(frame, driver), own = centre_of(frame, way.body),
                   common = centre_of(driver, way.body);
        if (!from || !own || !common) return;
        const double value = way.omega->to_double(), far = in(distance(*own, *common), units_.length);
        double near = in(distance(*from, *common), units_.length);
        if (is_between(*from, *common, *own)) near = -near;  // between the pivots: opposite senses
        telling_.tell_turning(statement, of, {{telling_.spin(driver, Symbol::Letter::omega)}, {near}}, far, value);
        return;
    }
}

std::optional<Vector> OfMotion::centre_of(BodyIndex first, BodyIndex second) const {
    for (const InstantCentre& centre : solution_.centres)
        if (centre.first == std::min(first, second) && centre.second == std::max(first, second) && centre.at &&
            !centre.at->at_infinity())
            return centre.at->place();
    return std::nullopt;
}

void OfMotion::of_curvature(const Curvature& curvature) {
    if (!curvature.inflection_pole) return;
    const Unit& unit = units_.length;
    const Vector pole = curvature.pole->place();
    telling_.tell(curvature.inflection_statement,
                  {Symbol::Letter::diameter, solution_.mechanism.bodies[at_index(curvature.body)].name, ""}, {},
                  std::nullopt, in(distance(pole, *curvature.inflection_pole), unit), unit);
    for (const PathCentre& path : curvature.points) {
        if (path.is_pin || !path.centre || path.centre->at_infinity()) continue;
        const Vector& at = solution_.pose.at(path.point);
        telling_.tell(path.statement, {Symbol::Letter::radius, path.label, ""}, {{in(distance(pole, at), unit), true}},
                      in(distance(at, path.foot->place()), unit), in(distance(at, path.centre->place()), unit), unit);
    }
}

}  // namespace kinegraph::worked_arithmetic
