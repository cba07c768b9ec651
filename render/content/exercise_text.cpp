// Exercise text: see exercise_text.hpp. One function for each kind of data.
#include "render/content/exercise_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/mechanism/compound_units.hpp"
#include "engine/mechanism/exercise.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/sliding.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/scene/bars.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

const Unit per_second_squared{"rad/s²", 1};

class ExerciseText {
public:
    explicit ExerciseText(const DrawingContext& context)
        : context_(context),
          solution_(context.solution),
          mechanism_(context.solution.mechanism),
          units_(mechanism_.units) {}

    std::vector<RichText> data() && {
        add_coordinates();
        for (const NamedPoint& point : mechanism_.points) add_point(point);
        for (const Body& body : mechanism_.bodies)
            if (body.circle)
                say("data wheel",
                    {plain_words(body.name), amount(body.circle->radius, units_.length), name(body.circle->centre)});
        add_common_points("data hinges", &PlanePair::is_hinge);
        add_common_points("data clamps", &PlanePair::is_clamp);
        for (const Joint& joint : mechanism_.joints) add_joint(joint);
        for (const Driver& driver : mechanism_.drivers) std::visit([&](const auto& each) { add_driver(each); }, driver);
        if (mechanism_.motion) add_motion(*mechanism_.motion);
        for (const Mass& mass : mechanism_.masses)
            say("data mass", {plain_words(mechanism_.body(mass.body).name), amount(mass.mass, units_.mass),
                              name(mass.centre), amount(mass.inertia, units_.inertia)});
        if (mechanism_.gravity) say("data gravity", {vector(*mechanism_.gravity, units_.acceleration)});
        if (!mechanism_.masses.empty()) say(mechanism_.inertia_forces ? "data inertia" : "data no inertia", {});
        for (const Load& load : mechanism_.loads) std::visit([&](const auto& each) { add_load(each); }, load);
        return std::move(rows_);
    }

    /// What the signs of asked results mean.
    std::vector<RichText> signs() && {
        bool bars = false;
        for (const Column& column : asked_columns(mechanism_)) {
            const Quantity& q = column.quantity;
            bars = bars || q.kind == Quantity::Kind::bar;
            if (column.kind == Column::Kind::along) say("sense of sliding", sliding(q.joint, symbol_asked(column)));
            if (q.kind == Quantity::Kind::effort) add_sense(mechanism_.efforts[at_index(q.given)]);
        }
        if (asked_of(mechanism_).empty())
            for (const Effort& effort : mechanism_.efforts) add_sense(effort);
        if (bars || (solution_.truss && asked_of(mechanism_).empty())) say("sense of bars", {});
        return std::move(rows_);
    }

    std::vector<RichText> sought(const std::vector<AskedValue>& found) && {
        if (!asked_of(mechanism_).empty()) {
            add_asked(found);
            return std::move(rows_);
        }
        const Find& find = mechanism_.find;
        const bool all = !find.stated, motion = has_motion(solution_) || !has_forces(solution_);
        if (find.instant_centres || (all && motion && !solution_.centres.empty())) say("sought centres", {});
        if (find.velocity || (all && has_plane(Plane::velocity))) say("sought velocity", {});
        if (find.acceleration || (all && has_plane(Plane::acceleration))) say("sought acceleration", {});
        for (const RelativeMotionQuery& query : find.relative_motion) {
            if (query.translating_with != none)
                say("sought translating", {name(query.point), name(query.translating_with)});
            else
                say(query.solves ? "sought through" : "sought relative",
                    {name(query.point), plain_words(mechanism_.body(query.observer).name)});
        }
        if (find.curvature) say("sought curvature", {});
        if (find.equations) say("sought equations", {});
        if (find.virtual_work && !find.forces) {
            say("sought work", {});
            for (const Effort& effort : mechanism_.efforts)
                std::visit([&](const auto& each) { add_effort(each); }, effort);
        }
        if (find.forces || (all && has_forces(solution_))) {
            say("sought forces", {});
            if (solution_.truss) say("sought bars", {});
            for (const CutQuery& cut : find.cuts) say("sought cut", {plain_words(names_of(cut))});
            for (const Effort& effort : mechanism_.efforts)
                std::visit([&](const auto& each) { add_effort(each); }, effort);
        }
        return std::move(rows_);
    }

    AskedText asked(const Column& column) && {
        AskedText text;
        if (column.kind != Column::Kind::named) text.symbol = symbol_asked(column);
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

    RichText filled(const char* key, const std::vector<RichText>& parts) const { return word(key, parts, language()); }

private:
    Language language() const { return context_.language; }
    bool has_plane(Plane plane) const {
        return std::any_of(solution_.protocol.polygons.begin(), solution_.protocol.polygons.end(),
                           [&](const Polygon& polygon) { return polygon.plane == plane; });
    }

    // --- pieces
    // ---------------------------------------------------------------------------------------------------------------

    static RichText plain_words(const std::string& words) { return one_piece(words); }
    std::string names_of(const CutQuery& cut) const {
        std::string names;
        for (const BodyIndex body : cut.bars)
            for (const TrussStructure::Bar& bar :
                 solution_.truss ? solution_.truss->structure.bars : std::vector<TrussStructure::Bar>{})
                if (bar.body == body) names += (names.empty() ? "" : ", ") + bar.name;
        return names;
    }
    RichText name(PointIndex point) const {
        return typeset(Symbol{Symbol::Letter::point, mechanism_.point(point).name, ""}, language());
    }
    RichText number_of(double value) const { return with_powers(drawing::given_number(value, language())); }
    /// A short fraction as such, where its decimals go on and on: 1/3.
    RichText ratio(const Exact& value) const {
        constexpr int longest = 30;
        for (int below = 3; below <= longest; ++below) {
            int rest = below;
            while (rest % 2 == 0) rest /= 2;
            while (rest % 5 == 0) rest /= 5;
            const double above = value.to_double() * below;
            const bool is_lowest = std::gcd(std::lround(above), static_cast<long>(below)) == 1;
            if (rest == 1 || !is_lowest || std::abs(above) > 100 || !(value == Exact::ratio(std::lround(above), below)))
                continue;
            return one_piece((above < 0 ? "−" : "") + std::to_string(std::lround(std::abs(above))) + "/" +
                             std::to_string(below));
        }
        return number_of(value.to_double());
    }
    RichText amount(const Exact& si, const Unit& unit) const { return given_amount(si, unit, language()); }
    RichText angle(const Angle& angle) const {
        RichText text = number_of(angle.value.to_double());
        append(text, angle.in_degrees ? "°" : " rad");
        return text;
    }
    RichText pair(double x, double y) const {
        RichText text = one_piece("(");
        append(text, number_of(x));
        append(text, notation(language()).between_numbers);
        append(text, number_of(y));
        append(text, ")");
        return text;
    }
    RichText vector(const Vector& si, const Unit& unit) const {
        RichText text = pair((si.x / unit.si).to_double(), (si.y / unit.si).to_double());
        append(text, with_powers(" " + unit.symbol));
        return text;
    }
    RichText join(PointIndex from, PointIndex to) const {
        RichText text = name(from);
        append(text, name(to));
        return text;
    }
    RichText bearing(const Bearing& bearing) const {
        if (const auto* as_angle = std::get_if<Angle>(&bearing.form)) return angle(*as_angle);
        if (const auto* between = std::get_if<Bearing::Between>(&bearing.form)) return join(between->from, between->to);
        const auto& along = std::get<Vector>(bearing.form);
        return pair(along.x.to_double(), along.y.to_double());
    }
    RichText place(const kinegraph::Place& place) const {
        if (const auto* point = std::get_if<PointIndex>(&place)) return name(*point);
        return vector(std::get<Vector>(place), units_.length);
    }
    void say(const char* key, const std::vector<RichText>& parts) { rows_.push_back(filled(key, parts)); }
    static RichText equation(RichText left, const RichText& right) {
        append(left, one_piece(" = "));
        append(left, right);
        return left;
    }

    // --- data
    // -----------------------------------------------------------------------------------------------------------------

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
        if (!list.empty()) say("data coordinates", {one_piece(units_.length.symbol), list});
    }
    void add_point(const NamedPoint& point) {
        const PointIndex index(&point - mechanism_.points.data());
        if (const auto* polar = std::get_if<Polar>(&point.placement)) {
            const RichText distance = amount(polar->distance, units_.length), turn = angle(polar->angle);
            if (polar->relative_to)
                say("data polar relative", {name(polar->from), name(index), distance, turn,
                                            name(polar->relative_to->from), name(polar->relative_to->to)});
            else
                say("data polar", {name(polar->from), name(index), distance, turn});
        } else if (const auto* on = std::get_if<Along>(&point.placement)) {
            const RichText share = on->is_ratio ? ratio(on->amount) : amount(on->amount, units_.length);
            say(on->is_ratio ? "data ratio" : "data along", {name(on->from), name(index), name(on->to), share});
        } else if (const auto* meet = std::get_if<Meet>(&point.placement)) {
            say("data meet", {name(index), curve(meet->first, index), curve(meet->second, index), which_of(*meet)});
        }
    }
    /// Of two meets the one that is meant.
    RichText which_of(const Meet& meet) const {
        using Side = Meet::Side;
        if (meet.near) return filled("data nearer", {vector(*meet.near, units_.length)});
        const auto *first = std::get_if<CircleCurve>(&meet.first), *second = std::get_if<CircleCurve>(&meet.second);
        if (meet.side == Side::either) return {};
        if (first != nullptr && second != nullptr)
            return filled(meet.side == Side::left ? "data on the left" : "data on the right",
                          {place(first->centre), place(second->centre)});
        return filled(meet.side == Side::ahead || meet.side == Side::right ? "data ahead" : "data behind", {});
    }
    RichText curve(const Curve& curve, PointIndex point) const {
        if (const auto* circle = std::get_if<CircleCurve>(&curve)) {
            const bool named = std::holds_alternative<PointIndex>(circle->centre);
            return filled(named ? "data radius" : "data radius of place",
                          {place(circle->centre), name(point), amount(circle->radius, units_.length)});
        }
        const auto& line = std::get<LineCurve>(curve);
        switch (line.by) {
            case LineCurve::By::angle: return filled("data line angle", {place(line.through), angle(line.angle)});
            case LineCurve::By::to: return filled("data line to", {place(line.through), name(line.to)});
            case LineCurve::By::parallel:
                return filled("data line parallel", {place(line.through), direction(line.bearing)});
            case LineCurve::By::perpendicular: break;
        }
        return filled("data line perpendicular", {place(line.through), direction(line.bearing)});
    }
    /// A bearing where its bare numbers would be taken for a place.
    RichText direction(const Bearing& of) const {
        return std::holds_alternative<Bearing::Between>(of.form) ? bearing(of)
                                                                 : filled("data the direction", {bearing(of)});
    }

    // --- joints
    // ---------------------------------------------------------------------------------------------------------------

    /// In a list of the bodies of a hinge.
    std::string listed(BodyIndex body) const {
        if (const std::string* bar = name_of_bar(solution_, body)) return *bar;
        return body == frame ? word("frame", language()) : mechanism_.body(body).name;
    }
    /// "body 2", "bar AB", "the frame"; "of body 2", "of bar AB", "of the frame".
    RichText subject(BodyIndex body) const {
        if (const std::string* bar = name_of_bar(solution_, body))
            return filled("data the bar", {one_piece(*bar, Face::italic)});
        return called(body, "data the frame", "data the body");
    }
    RichText owner(BodyIndex body) const {
        if (const std::string* bar = name_of_bar(solution_, body))
            return filled("data of the bar", {one_piece(*bar, Face::italic)});
        return called(body, "data of the frame", "data of the body");
    }
    RichText called(BodyIndex body, const char* as_frame, const char* as_body) const {
        return body == frame ? filled(as_frame, {}) : filled(as_body, {plain_words(mechanism_.body(body).name)});
    }
    /// Hinges or clamps: "O_2 (frame, 2), A (2, 3)".
    void add_common_points(const char* key, bool (PlanePair::*is_such)() const) {
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
            say("data guide",
                {name(joint.point), subject(joint.bodies[0]), owner(joint.bodies[1]), course(*joint.along)});
        if (pair.is_slot())
            say(joint.arc != none ? "data curved slot" : "data slot",
                {name(joint.point), owner(joint.bodies[0]), owner(joint.bodies[1]),
                 joint.arc != none ? name(joint.arc) : course(*joint.along)});
        if (joint.pressure_angle) say("data pressure angle", {name(joint.point), angle(*joint.pressure_angle)});
        if (joint.pushes)
            say("data pushes", {name(joint.point), subject(joint.bodies[0]), way(Bearing{*joint.pushes})});
    }
    /// A bearing, components told from a place by their words.
    RichText way(const Bearing& of) const {
        return std::holds_alternative<Vector>(of.form) ? direction(of) : bearing(of);
    }
    /// "along AB", "along 0°".
    RichText course(const Bearing& of) const {
        return filled(std::holds_alternative<Angle>(of.form) ? "along an angle" : "along a line", {way(of)});
    }
    /// Of a support of the frame, along which it slides; else what the bodies show each other.
    void add_contact(const Joint& joint) {
        if (const Bearing* along = support_of(joint))
            return say("data support", {name(joint.point), subject(joint.other_than(frame)), course(*along)});
        RichText shapes;
        const auto add_shape = [&](const RichText& shape) {
            if (!shapes.empty()) append(shapes, one_piece("; "));
            append(shapes, shape);
        };
        if (joint.tangent) add_shape(filled("data tangent", {way(*joint.tangent)}));
        for (const auto& [body, profile] : joint.profiles) add_shape(shape_of(body, profile));
        if (joint.pair().meshes() && joint.arm != frame) add_shape(filled("data arm", {subject(joint.arm)}));
        const PlanePair& pair = joint.pair();
        say(pair.meshes()  ? "data meshes"
            : pair.rolls() ? "data rolls"
                           : "data slides",
            {name(joint.point), subject(joint.bodies[0]), subject(joint.bodies[1]), shapes});
    }
    /// The direction in which a body that rests on the frame may slide there; null: it is no such support.
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
            return filled("data straight", {subject(body), way(line->along)});
        if (const auto* circle = std::get_if<CircleProfile>(&profile))
            return filled("data round", {subject(body), name(circle->centre)});
        return filled("data tip", {subject(body)});
    }

    RichText letter(Symbol::Letter letter, const std::string& about, const std::string& term = "") const {
        RichText text = typeset(Symbol{letter, about, term}, language());
        for (Piece& piece : text)
            if (piece.face == Face::bold_italic) piece.face = Face::italic;
        return text;
    }
    void add_driver(const SpinDriver& spin) {
        const std::string& body = mechanism_.body(spin.body).name;
        const std::string about = spin.relative_to == frame ? body : body + mechanism_.body(spin.relative_to).name;
        say(spin.relative_to == frame ? "data spin" : "data spin relative",
            {plain_words(body),
             equation(letter(Symbol::Letter::omega, about), amount(spin.omega, units_.angular_velocity)),
             equation(letter(Symbol::Letter::alpha, about), amount(spin.alpha, per_second_squared)),
             plain_words(mechanism_.body(spin.relative_to).name)});
    }
    RichText scalar(const Symbol& of) const { return letter(of.letter, of.about, of.term); }
    void add_driver(const SlideDriver& slide) {
        const Joint& joint = mechanism_.joint(slide.joint);
        const RichText speed = scalar(name_of_sliding(solution_, slide.joint, false)),
                       acceleration = scalar(name_of_sliding(solution_, slide.joint, true));
        say("data slide",
            {name(joint.point), subject(joint.bodies[0]),
             called(joint.bodies[1], "relative to the frame", "relative to the body"),
             equation(speed, amount(slide.speed, units_.velocity)),
             equation(acceleration, amount(slide.acceleration, units_.acceleration)), positive_sense(slide.joint)});
    }
    /// What drives is the component along the line, not the velocity: that is found.
    void add_driver(const PointDriver& point) {
        const auto given = [&](Symbol::Letter of, const Exact& si, const Unit& unit) {
            return equation(scalar(along_drive(of, point, mechanism_)), amount(si, unit));
        };
        say("data driven point", {name(point.at), given(Symbol::Letter::v, point.speed, units_.velocity),
                                  given(Symbol::Letter::a, point.acceleration, units_.acceleration), way(point.along),
                                  plain_words(mechanism_.body(point.body).name)});
    }
    void add_motion(const ActOfMotion& motion) {
        for (const bool second : {false, true})
            for (const GivenMotion& given : second ? motion.accelerations : motion.velocities) {
                const RichText symbol = typeset(
                    Symbol{second ? Symbol::Letter::a : Symbol::Letter::v, mechanism_.point(given.point).name, ""},
                    language());
                if (const auto* value = std::get_if<Vector>(&given.value))
                    say("data given vector", {symbol, vector(*value, second ? units_.acceleration : units_.velocity)});
                else
                    say("data given line", {symbol, bearing(std::get<Bearing>(given.value))});
            }
    }
    RichText symbol_of_force(const std::string& given, Symbol::Letter letter) const {
        return typeset(Symbol{letter, given, ""}, language());
    }
    void add_load(const ForceLoad& force) {
        const RichText symbol = symbol_of_force(force.name, Symbol::Letter::F);
        if (force.pin != none) return add_pin_load(force);
        const std::string* bar = name_of_bar(solution_, force.body);
        const RichText body =
            bar != nullptr ? one_piece(*bar, Face::italic) : plain_words(mechanism_.body(force.body).name);
        if (force.value)
            say(bar != nullptr ? "data force on bar" : "data force",
                {symbol, body, name(force.at), vector(*force.value, units_.force)});
        else
            say(bar != nullptr ? "data force on bar along" : "data force along",
                {symbol, body, name(force.at), amount(force.magnitude->first, units_.force),
                 bearing(force.magnitude->second)});
    }
    void add_pin_load(const ForceLoad& force) {
        const RichText symbol = symbol_of_force(force.name, Symbol::Letter::F);
        if (force.value)
            say("data pin load", {symbol, name(force.at), vector(*force.value, units_.force)});
        else
            say("data pin load along", {symbol, name(force.at), amount(force.magnitude->first, units_.force),
                                        bearing(force.magnitude->second)});
    }
    void add_load(const DistributedLoad& load) {
        const Unit unit = unit_of_force_per_length(units_);
        if (load.intensity[0] == load.intensity[1])
            return say("data evenly distributed",
                       {plain_words(load.name), plain_words(mechanism_.body(load.body).name), name(load.from),
                        name(load.to), amount(load.intensity[0], unit), bearing(load.along)});
        say("data distributed",
            {plain_words(load.name), plain_words(mechanism_.body(load.body).name), name(load.from), name(load.to),
             amount(load.intensity[0], unit), amount(load.intensity[1], unit), bearing(load.along)});
    }
    void add_load(const TorsionLoad& torsion) {
        say("data torsion",
            {symbol_of_force(torsion.name, Symbol::Letter::M), plain_words(mechanism_.body(torsion.bodies[0]).name),
             plain_words(mechanism_.body(torsion.bodies[1]).name), name(torsion.at),
             amount(torsion.stiffness, unit_of_torsional_stiffness(units_)),
             angle(Angle{torsion.turned / pi() * 180, true})});
    }
    void add_load(const CoupleLoad& couple) {
        say("data couple", {symbol_of_force(couple.name, Symbol::Letter::M),
                            plain_words(mechanism_.body(couple.body).name), amount(couple.value, units_.moment)});
    }
    void add_load(const SpringLoad& spring) {
        const RichText symbol = symbol_of_force(spring.name, Symbol::Letter::F),
                       first = called(spring.bodies[0], "frame", "data bare body"),
                       second = called(spring.bodies[1], "frame", "data bare body");
        if (spring.elastic)
            return say("data elastic spring", {symbol, name(spring.between[0]), name(spring.between[1]),
                                               amount(spring.elastic->stiffness, unit_of_force_per_length(units_)),
                                               amount(spring.elastic->free_length, units_.length), first, second});
        if (spring.magnitude.sign() < 0)
            return say("data gas spring", {symbol,
                                           name(spring.between[0]),
                                           name(spring.between[1]),
                                           amount(-spring.magnitude, units_.force),
                                           {},
                                           first,
                                           second});
        say("data spring", {symbol,
                            name(spring.between[0]),
                            name(spring.between[1]),
                            amount(spring.magnitude, units_.force),
                            {},
                            first,
                            second});
    }

    // --- what is asked for by name
    // --------------------------------------------------------------------------------------------

    /// Of `found` what only the results tell: at which joint the transmission angle is least.
    void add_asked(const std::vector<AskedValue>& found) {
        for (const Column& column : asked_columns(mechanism_)) {
            const auto is_it = [&](const AskedValue& each) {
                return column.kind == Column::Kind::named && each.column.name == column.name;
            };
            const auto told = std::find_if(found.begin(), found.end(), is_it);
            rows_.push_back(ExerciseText(context_).asked(told == found.end() ? column : told->column).words);
        }
    }
    AskedText asked_of_problem(const Column& column) const {
        AskedText text;
        for (const ProblemValue& each : solution_.problem->values) {
            if (each.name.en != column.name) continue;
            text.symbol = symbol_of(each.symbol);
            const Words& spoken = each.spoken.empty() ? each.name : each.spoken;
            text.words = one_piece(in(spoken, language()));
        }
        return text;
    }
    /// As the solution calls it, where it has the whole of it; its length in italics.
    RichText symbol_asked(const Column& column) const {
        const Quantity& q = column.quantity;
        if (column.kind == Column::Kind::along)
            return scalar(name_of_sliding(solution_, q.joint, q.kind == Quantity::Kind::sliding_acceleration));
        if (q.kind == Quantity::Kind::bar) return letter(Symbol::Letter::F, bar(q.body));
        const bool acts = q.kind == Quantity::Kind::force || q.kind == Quantity::Kind::couple;
        if (acts && q.component == Quantity::Component::whole) return scalar(symbol_of_action(q, mechanism_));
        return typeset(column, mechanism_, language());
    }
    /// Of a truss: by its pins.
    std::string bar(BodyIndex body) const {
        if (solution_.truss)
            for (const TrussStructure::Bar& each : solution_.truss->structure.bars)
                if (each.body == body) return each.name;
        return mechanism_.body(body).name;
    }
    std::vector<RichText> sliding(JointIndex index, const RichText& symbol) const {
        const Joint& joint = mechanism_.joint(index);
        return {symbol, owner(joint.bodies[0]),
                called(joint.bodies[1], "relative to the frame", "relative to the body"), name(joint.point),
                positive_sense(index)};
    }
    /// Between points that the file names, else by its angle in the drawn position.
    RichText positive_sense(JointIndex index) const {
        const Joint& joint = mechanism_.joint(index);
        if (joint.along && std::holds_alternative<Bearing::Between>(joint.along->form))
            return positive_sense(*joint.along);
        const VectorOf<double> way = direction_of_sliding(solution_.pose, index);
        const double degrees = std::round(std::atan2(way.y, way.x) * 1800 / std::numbers::pi) / 10;
        RichText angle = number_of(degrees == 0 ? 0 : degrees);
        append(angle, "°");
        return filled("positive along", {angle});
    }
    RichText positive_sense(const Bearing& of) const {
        if (const auto* between = std::get_if<Bearing::Between>(&of.form))
            return filled("positive from", {name(between->from), name(between->to)});
        return filled("positive along", {way(of)});
    }
    void say_asked(const Column& column, const RichText& symbol) {
        const Quantity& q = column.quantity;
        switch (column.kind) {
            case Column::Kind::angle: return say_asked_angle(q.body, symbol);
            case Column::Kind::place_x:
            case Column::Kind::place_y: return say("asked place", {symbol, carried(column)});
            case Column::Kind::along:
                return say(q.kind == Quantity::Kind::sliding_velocity ? "asked sliding velocity"
                                                                      : "asked sliding acceleration",
                           sliding(q.joint, symbol));
            case Column::Kind::result: return say_asked_result(column, symbol);
            case Column::Kind::turn:
            case Column::Kind::time:
            case Column::Kind::slid:
            case Column::Kind::named: break;
        }
        if (column.name != transmission_angle_name) return say("asked by name", {symbol, plain_words(column.name)});
        if (q.joint == none) return say("asked transmission", {symbol});
        say("asked transmission at",
            {symbol, name(mechanism_.joint(q.joint).point), plain_words(mechanism_.body(q.other).name),
             plain_words(mechanism_.body(q.body).name)});
    }
    void say_asked_angle(BodyIndex index, const RichText& symbol) {
        const Body& body = mechanism_.body(index);
        if (const auto line = line_of(body, solution_.pose))
            return say("asked angle of line", {symbol, plain_words(body.name), name((*line)[0]), name((*line)[1])});
        say("asked angle", {symbol, plain_words(body.name)});
    }
    void say_asked_result(const Column& column, const RichText& symbol) {
        const Quantity& q = column.quantity;
        const bool whole = q.component == Quantity::Component::whole;
        switch (q.kind) {
            case Quantity::Kind::omega: return say("asked omega", {symbol, plain_words(mechanism_.body(q.body).name)});
            case Quantity::Kind::alpha: return say("asked alpha", {symbol, plain_words(mechanism_.body(q.body).name)});
            case Quantity::Kind::velocity:
                return say(whole ? "asked velocity" : "asked part of velocity", {symbol, carried(column)});
            case Quantity::Kind::acceleration:
                return say(whole ? "asked acceleration" : "asked part of acceleration", {symbol, carried(column)});
            case Quantity::Kind::force:
                return say(q.other == none ? (whole ? "asked force of pin" : "asked part of force of pin")
                                           : (whole ? "asked force" : "asked part of force"),
                           action(q, symbol));
            case Quantity::Kind::couple:
                return say(q.other == none ? "asked couple of pin" : "asked couple", action(q, symbol));
            case Quantity::Kind::effort:
                return std::visit([&](const auto& effort) { add_effort(effort); },
                                  mechanism_.efforts[at_index(q.given)]);
            case Quantity::Kind::bar:
                return say(name_of_bar(solution_, q.body) != nullptr ? "asked bar" : "asked numbered bar",
                           {symbol, plain_words(bar(q.body)), plain_words(mechanism_.body(q.body).name)});
            default: return say("asked by name", {symbol, plain_words(column.name)});
        }
    }
    /// A point, and where several bodies carry it apart, of which.
    RichText carried(const Column& column) const {
        const Quantity& q = column.quantity;
        const bool apart = column.name.ends_with(" on " + mechanism_.body(q.body).name);
        if (!apart) return name(q.point);
        return filled("asked point of body", {name(q.point), plain_words(mechanism_.body(q.body).name)});
    }
    std::vector<RichText> action(const Quantity& q, const RichText& symbol) const {
        const RichText other = q.other == none ? RichText() : plain_words(mechanism_.body(q.other).name);
        return {symbol, other, plain_words(mechanism_.body(q.body).name), name(mechanism_.joint(q.joint).point)};
    }

    void add_effort(const CoupleEffort& effort) {
        const RichText symbol = symbol_of_force(effort.name, Symbol::Letter::M);
        const RichText on = plain_words(mechanism_.body(effort.body).name);
        if (effort.from == frame) return say("sought couple", {symbol, on});
        say("sought couple between", {symbol, on, plain_words(mechanism_.body(effort.from).name)});
    }
    void add_effort(const ForceEffort& effort) {
        say("sought force",
            {symbol_of_force(effort.name, Symbol::Letter::F), plain_words(mechanism_.body(effort.body).name),
             name(effort.at), positive_sense(effort.along)});
    }
    void add_effort(const ActuatorEffort& effort) {
        const Joint& joint = mechanism_.joint(effort.joint);
        say("sought actuator", {symbol_of_force(effort.name, Symbol::Letter::F), name(joint.point),
                                subject_of_action(joint.bodies[0], "on"), subject_of_action(joint.bodies[1], "from"),
                                positive_sense(effort.joint)});
    }
    /// Of an effort that is a force, or a couple between two bodies: those from the frame have their sense in common
    /// with all that turns.
    void add_sense(const Effort& effort) {
        if (const auto* couple = std::get_if<CoupleEffort>(&effort); couple != nullptr && couple->from != frame)
            say("sense of couple between",
                {symbol_of_force(couple->name, Symbol::Letter::M), subject_of_action(couple->body, "on"),
                 subject_of_action(couple->from, "from")});
        if (const auto* force = std::get_if<ForceEffort>(&effort))
            say("sense of effort", {symbol_of_force(force->name, Symbol::Letter::F),
                                    subject_of_action(force->body, "on"), positive_sense(force->along)});
        if (const auto* actuator = std::get_if<ActuatorEffort>(&effort))
            say("sense of effort", {symbol_of_force(actuator->name, Symbol::Letter::F),
                                    subject_of_action(mechanism_.joint(actuator->joint).bodies[0], "on"),
                                    positive_sense(actuator->joint)});
    }
    /// "on body 3", "from the frame".
    RichText subject_of_action(BodyIndex body, std::string_view preposition) const {
        return preposition == "on" ? called(body, "on the frame", "on the body")
                                   : called(body, "from the frame", "from the body");
    }

    const DrawingContext& context_;
    const Solution& solution_;
    const Mechanism& mechanism_;
    const Units& units_;
    std::vector<RichText> rows_;
};

}  // namespace

RichText given_amount(const Exact& si, const Unit& unit, Language language) {
    return with_powers(drawing::given_number((si / unit.si).to_double(), language) + " " + unit.symbol);
}

std::vector<RichText> data_of(const DrawingContext& context) { return ExerciseText(context).data(); }
std::vector<RichText> sought_of(const DrawingContext& context, const std::vector<AskedValue>& found) {
    return ExerciseText(context).sought(found);
}
std::vector<RichText> signs_of(const DrawingContext& context) { return ExerciseText(context).signs(); }
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
AskedText asked_text(const DrawingContext& context, const Column& column) {
    return ExerciseText(context).asked(column);
}

std::string heading_of(Topic section, Language language) {
    switch (section) {
        case Topic::centres: return word("instant centres", language);
        case Topic::velocity: return word("velocities", language);
        case Topic::acceleration: return word("accelerations", language);
        case Topic::relative_motion: return word("relative motion", language);
        case Topic::curvature: return word("curvature", language);
        case Topic::forces:
        case Topic::unnamed: break;
    }
    return word("forces", language);
}

bool is_drawn_for_sought(const Mechanism& mechanism, const Figure& figure) {
    const std::vector<Column> columns = asked_columns(mechanism);
    if (columns.empty() || figure.kind == "mechanism" || figure.kind == "truss") return true;
    using Kind = Quantity::Kind;
    const bool inertia = mechanism.inertia_forces && !mechanism.masses.empty();
    const auto needs = [&](const Column& column) {
        const Kind kind = column.quantity.kind;
        const bool is_result = column.kind == Column::Kind::result || column.kind == Column::Kind::along;
        const bool forces =
            is_result && (kind == Kind::force || kind == Kind::couple || kind == Kind::effort || kind == Kind::bar);
        const bool accelerations =
            is_result && (kind == Kind::alpha || kind == Kind::acceleration || kind == Kind::sliding_acceleration);
        const bool velocities =
            is_result && (kind == Kind::omega || kind == Kind::velocity || kind == Kind::sliding_velocity);
        // Accelerations begin with ω²r, forces of inertia with accelerations.
        if (figure.kind == "velocity") return velocities || accelerations || (forces && inertia);
        if (figure.kind == "acceleration") return accelerations || (forces && inertia);
        return (figure.kind == "forces" || figure.kind == "closure" || figure.kind == "displacements") && forces;
    };
    return std::any_of(columns.begin(), columns.end(), needs);
}

namespace {

bool shows_forces(const Figure& figure) { return figure.kind == "forces" || figure.kind == "closure"; }

}  // namespace

RichText name_of_scale(const DrawingContext& context, const Figure& figure, const std::vector<Figure>& figures) {
    if (figure.kind == "mechanism") return one_piece(word("mechanism", context.language));
    const bool alike = std::all_of(figures.begin(), figures.end(), [&](const Figure& other) {
        return !shows_forces(other) || !other.has_scale ||
               plain(scale_words(context, other)) == plain(scale_words(context, figure));
    });
    return shows_forces(figure) && alike ? one_piece(word("sought forces scale", context.language)) : figure.caption;
}

namespace {

/// Units for each mm; 0: it is not drawn.
double scale_of_detail(const Figure& figure, const DetailOn& detail) {
    for (const Mark& mark : figure.marks) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (group == nullptr || group->cls != "figure" || group->id != detail.id) continue;
        double scale = 0;
        if (const std::string* text = group->attribute("data-scale"))
            std::from_chars(text->data(), text->data() + text->size(), scale);
        return scale;
    }
    return 0;
}

/// Of the vectors that are read in a detail of the figure: "Velocity polygon, detail for v_D: 1 mm ≙ 0.002 m/s".
void add_scales_of_details(const DrawingContext& context, const Figure& figure, const std::vector<Answer>& sought,
                           const RichText& name, std::vector<RichText>& rows) {
    for (const DetailOn& detail : figure.details) {
        RichText row = name;
        append(row, one_piece(", " + word("scale of detail", context.language) + " "));
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
        own.kind = "detail";
        own.unit = figure.unit;
        own.scale = scale_of_detail(figure, detail);
        if (named.empty() || !(own.scale > 0)) continue;
        append(row, one_piece(": "));
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
        if (!figure.has_scale || figure.kind == "body" || !is_drawn_for_sought(context.solution.mechanism, figure))
            continue;
        // Of the mechanism the first: the question shows no other.
        if (figure.kind == "mechanism" && std::exchange(mechanism, true)) continue;
        const RichText name = name_of_scale(context, figure, figures);
        RichText row = name;
        append(row, one_piece(": "));
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
    return ExerciseText(context).filled("reading says nothing", {names});
}

}  // namespace kinegraph::render
