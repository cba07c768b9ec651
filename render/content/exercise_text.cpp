// The results to find, their signs, and the figures that an exercise shows. Part of exercise_text.hpp.
#include "render/content/exercise_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/mechanism/compound_units.hpp"
#include "engine/mechanism/exercise.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/exercise_phrases.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/expression_symbol.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

class SoughtText : ExercisePhrases {
public:
    explicit SoughtText(const DrawingContext& context) : ExercisePhrases(context) {}

    /// The positive senses of the results to find.
    std::vector<RichText> signs() && {
        bool bars = false;
        for (const Column& column : asked_columns(mechanism_)) {
            const Quantity& q = column.quantity;
            bars = bars || q.kind == Quantity::Kind::bar;
            if (column.kind == Column::Kind::along)
                say(lang::sheet::sense_of_sliding, sliding(q.joint, symbol_asked(column)));
            if (q.kind == Quantity::Kind::effort) add_sense(mechanism_.efforts[at_index(q.given)]);
        }
        if (asked_of(mechanism_).empty())
            for (const Effort& effort : mechanism_.efforts) add_sense(effort);
        if (bars || (solution_.truss && asked_of(mechanism_).empty())) say(lang::sheet::sense_of_bars, {});
        return std::move(rows_);
    }

    std::vector<RichText> sought(const std::vector<RequestedResult>& found) && {
        if (!asked_of(mechanism_).empty()) {
            add_asked(found);
            return std::move(rows_);
        }
        const Find& find = mechanism_.find;
        const bool all = !find.stated, motion = has_motion(solution_) || !has_forces(solution_);
        if (find.instant_centres || (all && motion && !solution_.centres.empty())) say(lang::sheet::sought_centres, {});
        if (find.velocity || (all && has_plane(Plane::velocity))) say(lang::sheet::sought_velocity, {});
        if (find.acceleration || (all && has_plane(Plane::acceleration))) say(lang::sheet::sought_acceleration, {});
        for (const RelativeMotionQuery& query : find.relative_motion) {
            if (query.translating_with != none)
                say(lang::sheet::sought_translating, {name(query.point), name(query.translating_with)});
            else
                say(query.solves ? lang::sheet::sought_through : lang::sheet::sought_relative,
                    {name(query.point), plain_words(mechanism_.body(query.observer).name)});
        }
        if (find.curvature) say(lang::sheet::sought_curvature, {});
        if (find.equations) say(lang::sheet::sought_equations, {});
        if (find.virtual_work && !find.forces) {
            say(lang::sheet::sought_work, {});
            for (const Effort& effort : mechanism_.efforts)
                std::visit([&](const auto& each) { add_effort(each); }, effort);
        }
        if (find.forces || (all && has_forces(solution_))) {
            say(lang::sheet::sought_forces, {});
            if (solution_.truss) say(lang::sheet::sought_bars, {});
            for (const CutQuery& cut : find.cuts) say(lang::sheet::sought_cut, {plain_words(names_of(cut))});
            for (const Effort& effort : mechanism_.efforts)
                std::visit([&](const auto& each) { add_effort(each); }, effort);
        }
        return std::move(rows_);
    }

    AskedText asked(const Column& column) && {
        AskedText text;
        if (column.kind != Column::Kind::named || expression_called(column.name, mechanism_))
            text.symbol = symbol_asked(column);
        if (column.name == transmission_angle_name) {
            text.symbol = one_piece("γ", Face::italic);
            text.symbol.back().sub = "min";
            text.symbol.back().sub_face = Face::regular;
        } else if (column.kind == Column::Kind::named && solution_.problem) {
            return asked_of_problem(column);
        }
        say_asked(column, text.symbol);
        text.words = std::move(rows_.back());
        return text;
    }

private:
    bool has_plane(Plane plane) const {
        return std::any_of(solution_.protocol.polygons.begin(), solution_.protocol.polygons.end(),
                           [&](const Polygon& polygon) { return polygon.plane == plane; });
    }

    std::string names_of(const CutQuery& cut) const {
        std::string names;
        for (const BodyIndex body : cut.bars)
            for (const TrussStructure::Bar& bar :
                 solution_.truss ? solution_.truss->structure.bars : std::vector<TrussStructure::Bar>{})
                if (bar.body == body) names += (names.empty() ? "" : ", ") + bar.name;
        return names;
    }

    /// Adds what only the results show: the joint with the least transmission angle.
    void add_asked(const std::vector<RequestedResult>& found) {
        for (const Column& column : asked_columns(mechanism_)) {
            const auto is_it = [&](const RequestedResult& each) {
                return column.kind == Column::Kind::named && each.column.name == column.name;
            };
            const auto told = std::find_if(found.begin(), found.end(), is_it);
            rows_.push_back(SoughtText(context_).asked(told == found.end() ? column : told->column).words);
        }
    }

    AskedText asked_of_problem(const Column& column) const {
        AskedText text;
        for (const ProblemValue& each : solution_.problem->values) {
            if (each.key != column.name) continue;
            text.symbol = symbol_of(each.symbol);
            text.words = one_piece(in(each.name, language()));
        }
        // An expression of such values.
        if (text.words.empty()) text.symbol = text.words = plain_words(column.name);
        return text;
    }

    /// The symbol in the solution if the result is a vector of it; for its length in italics.
    RichText symbol_asked(const Column& column) const {
        const Quantity& q = column.quantity;
        if (column.kind == Column::Kind::along)
            return scalar(name_of_sliding(solution_, q.joint, q.kind == Quantity::Kind::sliding_acceleration));
        if (q.kind == Quantity::Kind::bar) return letter(Symbol::Letter::F, bar(q.body));
        const bool acts = q.kind == Quantity::Kind::force || q.kind == Quantity::Kind::couple;
        if (acts && q.component == Quantity::Component::whole) return scalar(symbol_of_action(q, mechanism_));
        if (const auto expression = expression_called(column.name, mechanism_))
            return symbol_of(*expression, mechanism_, language());
        return typeset(column, mechanism_, language());
    }

    std::vector<RichText> sliding(JointIndex index, const RichText& symbol) const {
        const Joint& joint = mechanism_.joint(index);
        return {symbol, owner(joint.bodies[0]),
                called(joint.bodies[1], lang::sheet::relative_to_the_frame, lang::sheet::relative_to_the_body),
                name(joint.point), positive_sense(index)};
    }

    void say_asked(const Column& column, const RichText& symbol) {
        const Quantity& q = column.quantity;
        switch (column.kind) {
            case Column::Kind::angle: return say_asked_angle(q.body, symbol);
            case Column::Kind::place_x:
            case Column::Kind::place_y: return say(lang::sheet::asked_place, {symbol, carried(column)});
            case Column::Kind::along:
                return say(q.kind == Quantity::Kind::sliding_velocity ? lang::sheet::asked_sliding_velocity
                                                                      : lang::sheet::asked_sliding_acceleration,
                           sliding(q.joint, symbol));
            case Column::Kind::result: return say_asked_result(column, symbol);
            case Column::Kind::turn:
            case Column::Kind::time:
            case Column::Kind::slid:
            case Column::Kind::parameter:
            case Column::Kind::named: break;
        }
        if (const auto expression = expression_called(column.name, mechanism_))
            return say(lang::sheet::asked_by_name, {symbol, equation_of(*expression, mechanism_, language())});
        if (column.name != transmission_angle_name)
            return say(lang::sheet::asked_by_name, {symbol, plain_words(column.name)});
        if (q.joint == none) return say(lang::sheet::asked_transmission, {symbol});
        say(lang::sheet::asked_transmission_at,
            {symbol, name(mechanism_.joint(q.joint).point), plain_words(mechanism_.body(q.other).name),
             plain_words(mechanism_.body(q.body).name)});
    }

    void say_asked_angle(BodyIndex index, const RichText& symbol) {
        const Body& body = mechanism_.body(index);
        if (const auto line = line_of(body, solution_.pose))
            return say(lang::sheet::asked_angle_of_line,
                       {symbol, plain_words(body.name), name((*line)[0]), name((*line)[1])});
        say(lang::sheet::asked_angle, {symbol, plain_words(body.name)});
    }

    void say_asked_result(const Column& column, const RichText& symbol) {
        const Quantity& q = column.quantity;
        const ResultKind& kind = result_kind(q);
        const bool whole = q.component == Quantity::Component::whole;
        if (kind.turns())
            return say(kind.is_velocity() ? lang::sheet::asked_omega : lang::sheet::asked_alpha,
                       {symbol, plain_words(mechanism_.body(q.body).name)});
        switch (q.kind) {
            case Quantity::Kind::velocity:
                return say(whole ? lang::sheet::asked_velocity : lang::sheet::asked_part_of_velocity,
                           {symbol, carried(column)});
            case Quantity::Kind::acceleration:
                return say(whole ? lang::sheet::asked_acceleration : lang::sheet::asked_part_of_acceleration,
                           {symbol, carried(column)});
            case Quantity::Kind::force:
                return say(q.other == none
                               ? (whole ? lang::sheet::asked_force_of_pin : lang::sheet::asked_part_of_force_of_pin)
                               : (whole ? lang::sheet::asked_force : lang::sheet::asked_part_of_force),
                           action(q, symbol));
            case Quantity::Kind::couple:
                return say(q.other == none ? lang::sheet::asked_couple_of_pin : lang::sheet::asked_couple,
                           action(q, symbol));
            case Quantity::Kind::effort:
                return std::visit([&](const auto& effort) { add_effort(effort); },
                                  mechanism_.efforts[at_index(q.given)]);
            case Quantity::Kind::bar:
                return say(name_of_bar(solution_, q.body) != nullptr ? lang::sheet::asked_bar
                                                                     : lang::sheet::asked_numbered_bar,
                           {symbol, plain_words(bar(q.body)), plain_words(mechanism_.body(q.body).name)});
            default: break;
        }
        if (kind.asked) return say(*kind.asked, on_request(q, symbol));
        say(lang::sheet::asked_by_name, {symbol, plain_words(column.name)});
    }

    /// The places of a result's own sentence: its symbol, what it is of, and for a coupler what it drives.
    std::vector<RichText> on_request(const Quantity& q, const RichText& symbol) const {
        const auto body_named = [&](BodyIndex index) { return plain_words(mechanism_.body(index).name); };
        switch (result_kind(q).subject) {
            case ResultKind::Subject::two_bodies:
                return {symbol, typeset(centre_symbol(mechanism_, q.body, q.other, false), language())};
            case ResultKind::Subject::coupler:
                return {symbol, name(mechanism_.joint(q.joint).point), body_named(q.other), body_named(q.body)};
            case ResultKind::Subject::body: return {symbol, body_named(q.body)};
            case ResultKind::Subject::path: return {symbol, name(q.point), body_named(q.body)};
            case ResultKind::Subject::component: return action(q, symbol);
            case ResultKind::Subject::mass: return {symbol, body_named(mechanism_.masses[at_index(q.given)].body)};
            case ResultKind::Subject::load: {
                const Quantity load{.kind = Quantity::Kind::load, .given = q.given};
                return {symbol, acting(
                                    load, [](const auto& each) { return each.name; }, mechanism_.loads)};
            }
            default: {
                const Quantity effort{.kind = Quantity::Kind::effort, .given = q.given};
                return {symbol, acting(
                                    effort, [](const auto& each) { return each.name; }, mechanism_.efforts)};
            }
        }
    }
    /// The symbol of a load or an effort.
    template <class NameOf, class Given>
    RichText acting(const Quantity& q, NameOf name_of_given, const std::vector<Given>& all) const {
        const bool is_couple = unit_kind_of(q, mechanism_) == QuantityKind::moment;
        return symbol_of_force(std::visit(name_of_given, all[at_index(q.given)]),
                               is_couple ? Symbol::Letter::M : Symbol::Letter::F);
    }

    /// A point, with the body if several bodies carry it separately.
    RichText carried(const Column& column) const {
        const Quantity& q = column.quantity;
        if (!column.names_carrier) return name(q.point);
        return filled(lang::sheet::asked_point_of_body, {name(q.point), plain_words(mechanism_.body(q.body).name)});
    }

    std::vector<RichText> action(const Quantity& q, const RichText& symbol) const {
        const RichText other = q.other == none ? RichText() : plain_words(mechanism_.body(q.other).name);
        return {symbol, other, plain_words(mechanism_.body(q.body).name), name(mechanism_.joint(q.joint).point)};
    }

    void add_effort(const CoupleEffort& effort) {
        const RichText symbol = symbol_of_force(effort.name, Symbol::Letter::M);
        const RichText on = plain_words(mechanism_.body(effort.body).name);
        if (effort.from == frame) return say(lang::sheet::sought_couple, {symbol, on});
        say(lang::sheet::sought_couple_between, {symbol, on, plain_words(mechanism_.body(effort.from).name)});
    }

    void add_effort(const ForceEffort& effort) {
        say(lang::sheet::sought_force,
            {symbol_of_force(effort.name, Symbol::Letter::F), plain_words(mechanism_.body(effort.body).name),
             name(effort.at), positive_sense(effort.along)});
    }

    void add_effort(const ActuatorEffort& effort) {
        const Joint& joint = mechanism_.joint(effort.joint);
        say(lang::sheet::sought_actuator,
            {symbol_of_force(effort.name, Symbol::Letter::F), name(joint.point), acting_on(joint.bodies[0]),
             acting_from(joint.bodies[1]), positive_sense(effort.joint)});
    }

    /// Adds the positive sense of an input force or of an input couple between two bodies. A couple from the frame
    /// follows the common sense of rotation.
    void add_sense(const Effort& effort) {
        if (const auto* couple = std::get_if<CoupleEffort>(&effort); couple != nullptr && couple->from != frame)
            say(lang::sheet::sense_of_couple_between,
                {symbol_of_force(couple->name, Symbol::Letter::M), acting_on(couple->body), acting_from(couple->from)});
        if (const auto* force = std::get_if<ForceEffort>(&effort))
            say(lang::sheet::sense_of_effort, {symbol_of_force(force->name, Symbol::Letter::F), acting_on(force->body),
                                               positive_sense(force->along)});
        if (const auto* actuator = std::get_if<ActuatorEffort>(&effort))
            say(lang::sheet::sense_of_effort,
                {symbol_of_force(actuator->name, Symbol::Letter::F),
                 acting_on(mechanism_.joint(actuator->joint).bodies[0]), positive_sense(actuator->joint)});
    }
};

}  // namespace

RichText given_amount(const Exact& si, const Unit& unit, Language language) {
    return with_powers(with_unit(drawing::given_number((si / unit.si).to_double(), language), unit.symbol));
}

std::vector<RichText> sought_of(const DrawingContext& context, const std::vector<RequestedResult>& found) {
    return SoughtText(context).sought(found);
}
std::vector<RichText> signs_of(const DrawingContext& context) { return SoughtText(context).signs(); }
bool has_turning_sense(const Mechanism& mechanism) {
    const std::vector<Column> columns = asked_columns(mechanism);
    const Find& find = mechanism.find;
    if (columns.empty()) return !find.stated || find.velocity || find.acceleration || find.forces || find.virtual_work;
    return std::any_of(columns.begin(), columns.end(), [](const Column& column) {
        const QuantityKind kind = column.unit;
        return column.kind != Column::Kind::named &&
               (kind == QuantityKind::angle || kind == QuantityKind::angular_velocity ||
                kind == QuantityKind::angular_acceleration || kind == QuantityKind::moment);
    });
}
Key turning_senses(const Solution& solution) {
    return has_motion(solution) || stands_for_joints(solution.mechanism) ? lang::sheet::quiz_signs
                                                                         : lang::sheet::quiz_signs_at_rest;
}
AskedText asked_text(const DrawingContext& context, const Column& column) { return SoughtText(context).asked(column); }

std::string heading_of(Topic section, Language language) {
    switch (section) {
        case Topic::centres: return word(lang::sheet::instant_centres, language);
        case Topic::velocity: return word(lang::common::velocities, language);
        case Topic::acceleration: return word(lang::common::accelerations, language);
        case Topic::relative_motion: return word(lang::sheet::relative_motion, language);
        case Topic::curvature: return word(lang::sheet::curvature, language);
        case Topic::forces:
        case Topic::unnamed: break;
    }
    return word(lang::sheet::forces, language);
}

bool is_drawn_for_sought(const Mechanism& mechanism, const Figure& figure) {
    const std::vector<Column> columns = asked_columns(mechanism);
    using Needed = FigureTraits::Needed;
    const Needed needed = figure.traits.needed;
    if (columns.empty() || needed == Needed::always) return true;
    const bool inertia = mechanism.inertia_forces && !mechanism.masses.empty();
    const auto needs = [&](const auto& self, const Column& column) -> bool {
        if (const auto expression = expression_called(column.name, mechanism))
            return std::any_of(expression->parts().begin(), expression->parts().end(),
                               [&](const Column& part) { return self(self, part); });
        const ResultKind& kind = result_kind(column.quantity);
        const bool is_result = column.kind == Column::Kind::result || column.kind == Column::Kind::along;
        const bool forces = is_result && kind.is_of_forces();
        const bool accelerations = is_result && kind.is_acceleration(), velocities = is_result && kind.is_velocity();
        // Accelerations need ω²r, and inertia forces need accelerations.
        if (needed == Needed::velocities) return velocities || accelerations || (forces && inertia);
        if (needed == Needed::accelerations) return accelerations || (forces && inertia);
        return needed == Needed::forces && forces;
    };
    return std::any_of(columns.begin(), columns.end(), [&](const Column& column) { return needs(needs, column); });
}

namespace {

bool shows_forces(const Figure& figure) { return figure.traits.measured == QuantityKind::force; }
bool shows_lengths(const Figure& figure) { return figure.traits.measured == QuantityKind::length; }

}  // namespace

RichText name_of_scale(const DrawingContext& context, const Figure& figure, const std::vector<Figure>& figures) {
    if (shows_lengths(figure)) return one_piece(word(lang::sheet::mechanism, context.language));
    const bool alike = std::all_of(figures.begin(), figures.end(), [&](const Figure& other) {
        return !shows_forces(other) || !other.has_scale ||
               plain(scale_words(context, other)) == plain(scale_words(context, figure));
    });
    return shows_forces(figure) && alike ? one_piece(word(lang::sheet::sought_forces_scale, context.language))
                                         : figure.caption;
}

namespace {

/// Adds the scales of details in which results are read: "Velocity polygon, detail for v_D: 1 mm ≙ 0.002 m/s".
void add_scales_of_details(const DrawingContext& context, const Figure& figure, const std::vector<Answer>& sought,
                           const RichText& name, std::vector<RichText>& rows) {
    for (const DetailOn& detail : figure.details) {
        RichText row = name;
        append(row, one_piece(", " + word(lang::sheet::scale_of_detail, context.language) + " "));
        std::vector<std::string> named;
        for (const Answer& each : sought) {
            if (each.detail != detail.letter || !each.read_off) continue;
            const std::string vector = name_of(*each.read_off);
            if (std::find(named.begin(), named.end(), vector) != named.end()) continue;
            if (!named.empty()) append(row, one_piece(", "));
            append(row, typeset(*each.read_off, context.language));
            named.push_back(vector);
        }
        Figure own;
        own.unit = figure.unit;
        own.scale = detail.scale;
        if (named.empty() || !(own.scale > 0)) continue;
        append(row, word(lang::notation::colon, context.language));
        append(row, scale_words(context, own));
        rows.push_back(std::move(row));
    }
}

}  // namespace

std::vector<RichText> scales_of(const DrawingContext& context, const std::vector<Figure>& figures,
                                const std::vector<Answer>& sought) {
    std::vector<RichText> rows;
    std::vector<std::string> said;
    bool mechanism = false;
    for (const Figure& figure : figures) {
        if (!figure.has_scale || !figure.traits.lists_scale || !is_drawn_for_sought(context.solution.mechanism, figure))
            continue;
        // The question shows only the first mechanism figure.
        if (shows_lengths(figure) && std::exchange(mechanism, true)) continue;
        const RichText name = name_of_scale(context, figure, figures);
        RichText row = name;
        append(row, word(lang::notation::colon, context.language));
        append(row, scale_words(context, figure));
        if (std::find(said.begin(), said.end(), plain(row)) == said.end()) {
            said.push_back(plain(row));
            rows.push_back(std::move(row));
        }
        add_scales_of_details(context, figure, sought, name, rows);
    }
    return rows;
}

std::optional<RichText> remark_on_unreadable(const DrawingContext& context, const std::vector<Answer>& answers) {
    RichText names;
    for (const Answer& each : unreadable(answers)) {
        if (!names.empty()) append(names, one_piece(", "));
        append(names, each.words.empty() ? typeset(each.symbol, context.language) : each.words);
    }
    if (names.empty()) return std::nullopt;
    return word(lang::sheet::reading_says_nothing, {names}, context.language);
}

}  // namespace kinegraph::render
