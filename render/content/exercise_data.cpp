// The data of the file, sentence by sentence; one function for each kind of data. Part of exercise_text.hpp.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "engine/mechanism/compound_units.hpp"
#include "engine/mechanism/exercise.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/data.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/exercise_phrases.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::render {
namespace {

const Unit per_second_squared{"rad/s²", 1};

class GivenData : ExercisePhrases {
public:
    explicit GivenData(const DrawingContext& context) : ExercisePhrases(context) {}

    std::vector<RichText> data() && {
        add_coordinates();
        for (const NamedPoint& point : mechanism_.points) add_point(point);
        for (const Body& body : mechanism_.bodies)
            if (body.circle)
                say(lang::data::wheel,
                    {plain_words(body.name), amount(body.circle->radius, units_.length), name(body.circle->centre)});
        add_common_points(lang::data::hinges, &PlanePair::is_hinge);
        add_common_points(lang::data::clamps, &PlanePair::is_clamp);
        for (const Joint& joint : mechanism_.joints) add_joint(joint);
        for (const Driver& driver : mechanism_.drivers) std::visit([&](const auto& each) { add_driver(each); }, driver);
        if (mechanism_.motion) add_motion(*mechanism_.motion);
        for (const Mass& mass : mechanism_.masses)
            say(lang::data::mass, {plain_words(mechanism_.body(mass.body).name), amount(mass.mass, units_.mass),
                                   name(mass.centre), amount(mass.inertia, units_.inertia)});
        if (mechanism_.gravity) say(lang::data::gravity, {vector(*mechanism_.gravity, units_.acceleration)});
        if (!mechanism_.masses.empty())
            say(mechanism_.inertia_forces ? lang::data::inertia : lang::data::no_inertia, {});
        for (const Load& load : mechanism_.loads) std::visit([&](const auto& each) { add_load(each); }, load);
        add_parameters();
        return std::move(rows_);
    }

private:
    /// Those that what is asked for names: nothing else on the page says what they are.
    void add_parameters() {
        std::set<std::string> said;
        for (const Column& column : asked_columns(mechanism_)) {
            const auto expression = expression_called(column.name, mechanism_);
            if (!expression) continue;
            for (const Column& part : expression->parts()) {
                const auto is_it = [&](const NamedParameter& each) { return each.name == part.name; };
                const auto& all = mechanism_.parameters;
                const auto given = std::find_if(all.begin(), all.end(), is_it);
                if (part.kind != Column::Kind::parameter || given == all.end() || !said.insert(part.name).second)
                    continue;
                say(lang::data::given_vector, {typeset(part, mechanism_, language()),
                                               amount(Exact::from_double(given->value), unit_of(part, mechanism_))});
            }
        }
    }

    void add_coordinates() {
        RichText list;
        for (const PointIndex index : indices_of(mechanism_.points)) {
            const auto* at = std::get_if<Coordinates>(&mechanism_.point(index).placement);
            if (at == nullptr) continue;
            if (!list.empty()) append(list, one_piece(", "));
            append(list, name(index));
            append(list, one_piece(" "));
            append(list, pair((at->at.x / units_.length.si).to_double(), (at->at.y / units_.length.si).to_double()));
        }
        if (!list.empty()) say(lang::data::coordinates, {one_piece(units_.length.symbol), list});
    }

    void add_point(const NamedPoint& point) {
        const PointIndex index(&point - mechanism_.points.data());
        if (const auto* polar = std::get_if<Polar>(&point.placement)) {
            const RichText distance = amount(polar->distance, units_.length), turn = angle(polar->angle);
            if (polar->relative_to)
                say(lang::data::polar_relative, {name(polar->from), name(index), distance, turn,
                                                 name(polar->relative_to->from), name(polar->relative_to->to)});
            else
                say(lang::data::polar, {name(polar->from), name(index), distance, turn});
        } else if (const auto* on = std::get_if<Along>(&point.placement)) {
            const RichText share = on->is_ratio ? ratio(on->amount) : amount(on->amount, units_.length);
            say(on->is_ratio ? lang::data::ratio : lang::data::along,
                {name(on->from), name(index), name(on->to), share});
        } else if (const auto* meet = std::get_if<Meet>(&point.placement)) {
            say(lang::data::meet,
                {name(index), curve(meet->first, index), curve(meet->second, index), which_of(*meet)});
        }
    }

    /// Which of two intersections is meant.
    RichText which_of(const Meet& meet) const {
        using Side = Meet::Side;
        if (meet.near) return filled(lang::data::nearer, {vector(*meet.near, units_.length)});
        const auto *first = std::get_if<CircleCurve>(&meet.first), *second = std::get_if<CircleCurve>(&meet.second);
        if (meet.side == Side::either) return {};
        if (first != nullptr && second != nullptr)
            return filled(meet.side == Side::left ? lang::data::on_the_left : lang::data::on_the_right,
                          {place(first->centre), place(second->centre)});
        return filled(meet.side == Side::ahead || meet.side == Side::right ? lang::data::ahead : lang::data::behind,
                      {});
    }

    RichText curve(const Curve& curve, PointIndex point) const {
        if (const auto* circle = std::get_if<CircleCurve>(&curve)) {
            const bool named = std::holds_alternative<PointIndex>(circle->centre);
            return filled(named ? lang::data::radius : lang::data::radius_of_place,
                          {place(circle->centre), name(point), amount(circle->radius, units_.length)});
        }
        const auto& line = std::get<LineCurve>(curve);
        switch (line.by) {
            case LineCurve::By::angle: return filled(lang::data::line_angle, {place(line.through), angle(line.angle)});
            case LineCurve::By::to: return filled(lang::data::line_to, {place(line.through), name(line.to)});
            case LineCurve::By::parallel:
                return filled(lang::data::line_parallel, {place(line.through), direction(line.bearing)});
            case LineCurve::By::perpendicular: break;
        }
        return filled(lang::data::line_perpendicular, {place(line.through), direction(line.bearing)});
    }

    /// Hinges or clamps: "O_2 (frame, 2), A (2, 3)".
    void add_common_points(Key key, bool (PlanePair::*is_such)() const) {
        RichText list;
        for (const Joint& joint : mechanism_.joints) {
            if (!(joint.pair().*is_such)()) continue;
            if (!list.empty()) append(list, one_piece(", "));
            append(list, name(joint.point));
            std::string bodies;
            for (const BodyIndex body : joint.bodies) bodies += (bodies.empty() ? " (" : ", ") + listed(body);
            append(list, one_piece(bodies + ")"));
        }
        if (!list.empty()) say(key, {list});
    }

    void add_joint(const Joint& joint) {
        const PlanePair& pair = joint.pair();
        if (pair.touches()) add_contact(joint);
        if (pair.is_sleeve())
            say(lang::data::guide,
                {name(joint.point), subject(joint.bodies[0]), owner(joint.bodies[1]), course(*joint.along)});
        if (pair.is_slot())
            say(joint.arc != none ? lang::data::curved_slot : lang::data::slot,
                {name(joint.point), owner(joint.bodies[0]), owner(joint.bodies[1]),
                 joint.arc != none ? name(joint.arc) : course(*joint.along)});
        if (joint.pressure_angle) say(lang::data::pressure_angle, {name(joint.point), angle(*joint.pressure_angle)});
        if (joint.pushes)
            say(lang::data::pushes, {name(joint.point), subject(joint.bodies[0]), way(Bearing{*joint.pushes})});
    }

    /// The direction of sliding on a support of the frame; otherwise the profiles of the two bodies.
    void add_contact(const Joint& joint) {
        if (const Bearing* along = support_of(joint))
            return say(lang::data::support, {name(joint.point), subject(joint.other_than(frame)), course(*along)});
        RichText shapes;
        const auto add_shape = [&](const RichText& shape) {
            if (!shapes.empty()) append(shapes, word(lang::notation::semicolon, language()));
            append(shapes, shape);
        };
        if (joint.tangent) add_shape(filled(lang::data::tangent, {way(*joint.tangent)}));
        for (const auto& [body, profile] : joint.profiles) add_shape(shape_of(body, profile));
        if (joint.pair().meshes() && joint.arm != frame) add_shape(filled(lang::data::arm, {subject(joint.arm)}));
        const PlanePair& pair = joint.pair();
        say(pair.meshes()  ? lang::data::meshes
            : pair.rolls() ? lang::data::rolls
                           : lang::data::slides,
            {name(joint.point), subject(joint.bodies[0]), subject(joint.bodies[1]), shapes});
    }

    /// The direction in which a body supported by the frame may slide; null if the joint is no such support.
    static const Bearing* support_of(const Joint& joint) {
        if (!joint.pair().slides() || !joint.connects(frame)) return nullptr;
        if (joint.tangent && joint.profiles.empty()) return &*joint.tangent;
        const auto shown = [&](BodyIndex body) -> const Profile* {
            const auto found = joint.profiles.find(body);
            return found == joint.profiles.end() ? nullptr : &found->second;
        };
        const Profile *own = shown(joint.other_than(frame)), *ground = shown(frame);
        const bool is_point = own == nullptr || std::holds_alternative<TipProfile>(*own);
        const auto* line = ground == nullptr ? nullptr : std::get_if<LineProfile>(ground);
        return is_point && line != nullptr ? &line->along : nullptr;
    }

    RichText shape_of(BodyIndex body, const Profile& profile) const {
        if (const auto* line = std::get_if<LineProfile>(&profile))
            return filled(lang::data::straight, {subject(body), way(line->along)});
        if (const auto* circle = std::get_if<CircleProfile>(&profile))
            return filled(lang::data::round, {subject(body), name(circle->centre)});
        return filled(lang::data::tip, {subject(body)});
    }

    void add_driver(const SpinDriver& spin) {
        const std::string& body = mechanism_.body(spin.body).name;
        const std::string about = spin.relative_to == frame ? body : body + mechanism_.body(spin.relative_to).name;
        say(spin.relative_to == frame ? lang::data::spin : lang::data::spin_relative,
            {plain_words(body),
             equation(letter(Symbol::Letter::omega, about), amount(spin.omega, units_.angular_velocity)),
             equation(letter(Symbol::Letter::alpha, about), amount(spin.alpha, per_second_squared)),
             plain_words(mechanism_.body(spin.relative_to).name)});
    }

    void add_driver(const SlideDriver& slide) {
        const Joint& joint = mechanism_.joint(slide.joint);
        const RichText speed = scalar(name_of_sliding(solution_, slide.joint, false)),
                       acceleration = scalar(name_of_sliding(solution_, slide.joint, true));
        say(lang::data::slide,
            {name(joint.point), subject(joint.bodies[0]),
             called(joint.bodies[1], lang::sheet::relative_to_the_frame, lang::sheet::relative_to_the_body),
             equation(speed, amount(slide.speed, units_.velocity)),
             equation(acceleration, amount(slide.acceleration, units_.acceleration)), positive_sense(slide.joint)});
    }

    /// The driver gives the component along the line; the velocity is a result.
    void add_driver(const PointDriver& point) {
        const auto given = [&](Symbol::Letter of, const Exact& si, const Unit& unit) {
            return equation(scalar(along_drive(of, point, mechanism_)), amount(si, unit));
        };
        say(lang::data::driven_point, {name(point.at), given(Symbol::Letter::v, point.speed, units_.velocity),
                                       given(Symbol::Letter::a, point.acceleration, units_.acceleration),
                                       way(point.along), plain_words(mechanism_.body(point.body).name)});
    }

    void add_motion(const InstantaneousMotion& motion) {
        for (const bool second : {false, true})
            for (const GivenMotion& given : second ? motion.accelerations : motion.velocities) {
                const RichText symbol = typeset(
                    Symbol{second ? Symbol::Letter::a : Symbol::Letter::v, mechanism_.point(given.point).name, ""},
                    language());
                if (const auto* value = std::get_if<Vector>(&given.value))
                    say(lang::data::given_vector,
                        {symbol, vector(*value, second ? units_.acceleration : units_.velocity)});
                else
                    say(lang::data::given_line, {symbol, bearing(std::get<Bearing>(given.value))});
            }
    }

    void add_load(const ForceLoad& force) {
        const RichText symbol = symbol_of_force(force.name, Symbol::Letter::F);
        if (force.pin != none) return add_pin_load(force);
        const std::string* bar = name_of_bar(solution_, force.body);
        const RichText body =
            bar != nullptr ? one_piece(*bar, Face::italic) : plain_words(mechanism_.body(force.body).name);
        if (force.value)
            say(bar != nullptr ? lang::data::force_on_bar : lang::data::force,
                {symbol, body, name(force.at), vector(*force.value, units_.force)});
        else
            say(bar != nullptr ? lang::data::force_on_bar_along : lang::data::force_along,
                {symbol, body, name(force.at), amount(force.magnitude->first, units_.force),
                 bearing(force.magnitude->second)});
    }

    void add_pin_load(const ForceLoad& force) {
        const RichText symbol = symbol_of_force(force.name, Symbol::Letter::F);
        if (force.value)
            say(lang::data::pin_load, {symbol, name(force.at), vector(*force.value, units_.force)});
        else
            say(lang::data::pin_load_along, {symbol, name(force.at), amount(force.magnitude->first, units_.force),
                                             bearing(force.magnitude->second)});
    }

    void add_load(const DistributedLoad& load) {
        const Unit unit = unit_of_force_per_length(units_);
        if (load.intensity[0] == load.intensity[1])
            return say(lang::data::evenly_distributed,
                       {plain_words(load.name), plain_words(mechanism_.body(load.body).name), name(load.from),
                        name(load.to), amount(load.intensity[0], unit), bearing(load.along)});
        say(lang::data::distributed,
            {plain_words(load.name), plain_words(mechanism_.body(load.body).name), name(load.from), name(load.to),
             amount(load.intensity[0], unit), amount(load.intensity[1], unit), bearing(load.along)});
    }

    void add_load(const TorsionLoad& torsion) {
        say(lang::data::torsion,
            {symbol_of_force(torsion.name, Symbol::Letter::M), plain_words(mechanism_.body(torsion.bodies[0]).name),
             plain_words(mechanism_.body(torsion.bodies[1]).name), name(torsion.at),
             amount(torsion.stiffness, unit_of_torsional_stiffness(units_)),
             angle(Angle{torsion.turned / pi() * 180, true})});
    }

    void add_load(const CoupleLoad& couple) {
        say(lang::data::couple, {symbol_of_force(couple.name, Symbol::Letter::M),
                                 plain_words(mechanism_.body(couple.body).name), amount(couple.value, units_.moment)});
    }

    void add_load(const SpringLoad& spring) {
        const RichText symbol = symbol_of_force(spring.name, Symbol::Letter::F),
                       first = called(spring.bodies[0], lang::common::frame, lang::data::bare_body),
                       second = called(spring.bodies[1], lang::common::frame, lang::data::bare_body);
        if (spring.elastic)
            return say(lang::data::elastic_spring, {symbol, name(spring.between[0]), name(spring.between[1]),
                                                    amount(spring.elastic->stiffness, unit_of_force_per_length(units_)),
                                                    amount(spring.elastic->free_length, units_.length), first, second});
        if (spring.magnitude.sign() < 0)
            return say(lang::data::gas_spring, {symbol,
                                                name(spring.between[0]),
                                                name(spring.between[1]),
                                                amount(-spring.magnitude, units_.force),
                                                {},
                                                first,
                                                second});
        say(lang::data::spring, {symbol,
                                 name(spring.between[0]),
                                 name(spring.between[1]),
                                 amount(spring.magnitude, units_.force),
                                 {},
                                 first,
                                 second});
    }
};

}  // namespace

std::vector<RichText> data_of(const DrawingContext& context) { return GivenData(context).data(); }

}  // namespace kinegraph::render
