// Implementation of live_data.hpp.
#include "render/live/live_data.hpp"

#include <array>
#include <cmath>
#include <set>

#include "engine/file/json_writer.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "lang/keys/live.hpp"
#include "lang/keys/notation.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/page/figure.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

std::string_view name_of(MovingGiven::Rule rule) {
    static constexpr std::array<std::string_view, 13> names{
        "place",  "guide",   "guide_unit", "normal",       "other_normal", "tangent", "between",
        "spring", "torsion", "rate",       "acceleration", "setting",      "turned"};
    return names[static_cast<std::size_t>(rule)];
}
std::string_view name_of(Moving::Fixed::Why why) {
    static constexpr std::array<std::string_view, 4> names{"otherwise", "nothing", "zero", "many"};
    return names[static_cast<std::size_t>(why)];
}
std::string_view name_of(Column::Kind kind) {
    static constexpr std::array<std::string_view, 9> names{"turn", "time",   "angle", "place_x", "place_y",
                                                           "slid", "result", "along", "named"};
    return names[static_cast<std::size_t>(kind)];
}

std::string id_of_centre(const Solution& solution, const InstantCentre& centre) {
    const Mechanism& m = solution.mechanism;
    return legal_id("centre-" + m.body(centre.first).name + "." + m.body(centre.second).name);
}

/// An initial value for Newton's method: seven digits are enough.
double rough(double value) {
    constexpr double digits = 1e7, large = 1e9;
    return std::abs(value) > large ? value : std::round(value * digits) / digits;
}

class MovingWriter {
public:
    MovingWriter(const Moving& moving, const Solution& solution, JsonWriter& json)
        : moving_(moving), solution_(solution), json_(json) {}

    void write() {
        json_.key("moving").open('{').member("size", moving_.size).member("unit", moving_.unit);
        write_closure();
        json_.member("directions", moving_.directions);
        json_.list("settings", moving_.settings, [&](const MovingSetting& each) {
            const Unit unit = unit_of(each);
            json_.open('{').member("name", each.name).member("unit", unit.symbol);
            json_.member("size", unit.si.to_double()).member("value", each.value);
            if (each.kind == MovingSetting::Kind::bar) json_.member("bar", each.of);
            if (each.unit == QuantityKind::length) json_.member("ends", each.ends);
            if (each.kind == MovingSetting::Kind::parameter) json_.member("parameter", true);
            if (each.direction) json_.member("direction", *each.direction).member("given", each.of);
            if (each.radians != 0) json_.member("radians", each.radians);
            json_.close();
        });
        json_.list("effects", moving_.effects, [&](const MovingEffect& each) { write(each); });
        json_.list("fixed", moving_.fixed,
                   [&](const Moving::Fixed& each) { json_.open('[').values(name_of(each.why), each.name).close(); });
        json_.list("columns", moving_.columns, [&](const Column& each) { write(each); });
        for (const MovingPlan::Binding& each : moving_.plans.front().held) drawn_.insert(each.name);
        json_.list("plans", moving_.plans, [&](const MovingPlan& each) { write(each); });
        json_.list("courses", moving_.courses, [&](const MovingCourse& each) { write(each); });
        json_.close();
    }

private:
    void write_closure() {
        json_.list("rows", moving_.rows, [&](const ClosureRowOf<double>& row) {
            json_.open('[').values(static_cast<int>(row.kind), row.i, row.j, row.p.x, row.p.y, row.q.x, row.q.y,
                                   row.along.x, row.along.y);
            json_.values(row.offset, row.lever, row.share_i, row.share_j, row.driver).close();
        });
        json_.list("bodies", moving_.bodies, [&](const Closure::Body& body) {
            json_.open('[')
                .values(body.reference.x.to_double(), body.reference.y.to_double(), body.x, body.turn)
                .close();
        });
        json_.member("frozen", moving_.frozen);
        json_.list("points", moving_.points, [&](const Positions::PointRule& point) {
            json_.open('[').values(point.carrier.body, point.local.x, point.local.y, point.carrier.contact).close();
        });
        json_.list("joints", moving_.joints, [&](const Positions::JointRule& joint) { write(joint); });
    }
    void write(const Positions::JointRule& joint) {
        json_.open('{').member("turnsWith", joint.turns_with).member("bodies", joint.bodies);
        json_.member("guide", joint.guide).member("tangent", joint.tangent).member("pressure", joint.pressure);
        json_.member("locals", joint.locals).member("reaches", joint.reaches).member("straight", joint.is_straight);
        json_.member("circle", joint.first_circle).member("point", joint.point);
        json_.member("arc", joint.is_arc).member("touches", joint.touches).member("meshes", joint.meshes).close();
    }
    void write(const Column& column) {
        const Quantity& q = column.quantity;
        const Unit unit = unit_of_column(column, solution_.mechanism.units);
        json_.open('{').member("name", column.name).member("kind", name_of(column.kind)).member("unit", unit.symbol);
        json_.member("symbol", plain(typeset(column, solution_.mechanism, Language::en)));
        json_.member("size", unit.si.to_double()).member("body", q.body).member("point", q.point);
        json_.member("joint", q.joint).key("component");
        json_.value(q.component == Quantity::Component::y   ? "y"
                    : q.component == Quantity::Component::x ? "x"
                                                            : "whole")
            .close();
    }
    Unit unit_of(const MovingSetting& setting) const {
        if (setting.kind == MovingSetting::Kind::parameter) return {setting.written_unit, 1};
        if (const KnownUnit* written = unit_spelt(setting.written_unit))
            return {std::string(written->symbol), written->si};
        if (setting.unit == QuantityKind::angular_acceleration) return {"rad/s²", 1};
        return suitable_unit(setting.value, setting.unit, solution_.mechanism.units);
    }
    /// The path to the number within the data, and its terms.
    void write(const MovingEffect& effect) {
        using List = MovingEffect::List;
        const int item = effect.item, part = effect.part;
        const auto way = [&](const auto&... steps) { json_.open('[').open('[').values(steps...).close(); };
        const std::string rows = "rows", bodies = "bodies", points = "points", joints = "joints", plans = "plans";
        switch (effect.list) {
            case List::row: way(rows, item, first_of_row + part); break;
            case List::body: way(bodies, item, part); break;
            case List::point: way(points, item, 1 + part); break;
            case List::local: way(joints, item, "locals", part / 2, part % 2); break;
            case List::reach: way(joints, item, "reaches", part); break;
            case List::guide: way(joints, item, "guide", part); break;
            case List::tangent: way(joints, item, "tangent", part); break;
            case List::setting: way("settings", item, "value"); break;
            case List::given: way(plans, effect.plan, "givens", item, part); break;
            case List::given_factor: way(plans, effect.plan, "moving", item, "factor"); break;
            case List::given_offset: way(plans, effect.plan, "moving", item, "offset"); break;
        }
        for (const MovingEffect::Term& term : effect.terms) json_.values(term.first, term.second, term.by);
        json_.close();
    }
    void write(const MovingPlan& plan) {
        json_.open('{');
        json_.list("givens", plan.givens, [&](const ValueOf<double>& given) {
            json_.open('[');
            std::visit([&](const auto& value) { write(value); }, given);
            json_.close();
        });
        json_.list("strokes", plan.program.strokes, [&](const Stroke& stroke) {
            json_.values(static_cast<int>(stroke.verb), static_cast<int>(stroke.plane), stroke.inputs[0],
                         stroke.inputs[1], stroke.given);
        });
        json_.list("guards", plan.program.guards, [&](const Guard& guard) {
            json_.values(static_cast<int>(guard.question), static_cast<int>(guard.how), guard.inputs[0],
                         guard.inputs[1], guard.verdict, guard.before);
        });
        json_.member("doubtfulBits", plan.program.doubtful_bits);
        json_.list("moving", plan.moving, [&](const MovingGiven& given) { write(given); });
        json_.list("sources", plan.sources, [&](const MovingPlan::Source& source) {
            json_.value(source.known ? source.element.number() : -2);  // -1: no element
        });
        json_.list("vectors", plan.vectors, [&](const MovingPlan::Vector& vector) {
            if (!vector.vanishes)
                json_.open('[').values(legal_id(vector.figure), vector.name, vector.tail, vector.tip).close();
        });
        json_.list("spots", plan.spots, [&](const MovingPlan::Spot& spot) {
            json_.open('[').values(legal_id(spot.figure), spot.name, spot.point).close();
        });
        json_.list("lines", plan.lines, [&](const MovingPlan::Line& line) {
            json_.open('[').values(legal_id(line.figure), line.name, line.statement, line.line);
            for (const ElementIndex point : line.points) json_.values(point);
            json_.close();
        });
        json_.list("held", plan.held, [&](const MovingPlan::Binding& held) {
            json_.open('[').values(held.name, held.place, held.vector, held.couple);
            const bool is_new = !held.figure.empty() && !drawn_.contains(held.name);
            if (held.given >= 0 || is_new) json_.value(held.given);
            if (is_new) json_.value(legal_id(held.figure)).value(held.symbol);
            json_.close();
        });
        json_.close();
    }
    void write(const PointOf<double>& point) { json_.values(point.x, point.y, point.w); }
    void write(const LineOf<double>& line) { json_.values(line.a, line.b, line.c); }
    void write(const VectorOf<double>& vector) { json_.values(vector.x, vector.y); }
    void write(double scalar) { json_.value(scalar); }
    void write(const MovingGiven& given) {
        json_.open('{').member("rule", name_of(given.rule)).member("given", given.given).member("index", given.index);
        json_.member("ends", given.ends);
        json_.member("bodies", given.bodies);
        json_.member("factor", given.factor).member("offset", given.offset).close();
    }
    void write(const MovingCourse& course) {
        json_.open('{').member("driver", course.driver).member("name", course.name).member("turns", course.turns);
        json_.member("rate", course.rate).member("from", course.travel.at(0)).member("to", course.travel.at(1));
        json_.member("startsAtLimit", course.travel.starts_at_limit).member("endsAtLimit", course.travel.ends_at_limit);
        json_.member("changePoints", course.travel.change_points);
        json_.member("byLaw", course.by_law);
        json_.member("shares", course.shares);
        json_.list("samples", course.samples, [&](const MovingCourse::Sample& sample) {
            json_.open('{').member("at", sample.at).member("plan", sample.plan);
            // For most drivers the coordinate is the position itself, and has no separate rate.
            if (course.by_law) {
                json_.member("coordinate", sample.coordinate);
                json_.member("rate", sample.rate).member("acceleration", sample.acceleration);
            }
            if (!sample.values.empty()) json_.member("values", sample.values);
            json_.list("q", sample.q, [&](double each) { json_.value(rough(each)); }).close();
        });
        json_.close();
    }

    static constexpr int first_of_row = 3;  ///< after kind and bodies

    const Moving& moving_;
    const Solution& solution_;
    std::set<std::string> drawn_;  ///< names that the drawn position has
    JsonWriter& json_;
};

}  // namespace

Unit unit_of_column(const Column& column, const Units& units) {
    if (column.unit == QuantityKind::angular_acceleration) return {"rad/s²", 1};
    return suitable_unit(1, column.unit, units);
}

void write_moving(const Moving& moving, const Solution& solution, JsonWriter& json) {
    MovingWriter(moving, solution, json).write();
}

void write_names(const Solution& solution, JsonWriter& json) {
    const Mechanism& m = solution.mechanism;
    const auto label = [](Symbol::Letter letter, const std::string& name) {
        return plain(typeset(Symbol{letter, name, ""}, Language::en));
    };
    json.key("names").open('{');
    json.list("bodies", m.bodies, [&](const Body& body) {
        json.open('{').member("id", legal_id(body.name)).member("label", body.name).close();
    });
    json.list("joints", m.joints, [&](const Joint& joint) {
        const bool guided = joint.pair().has_guide() && joint.arc == none;
        json.open('{').member("id", legal_id(joint.name)).member("point", joint.point);
        json.member("turnsWith", guided ? joint.bodies[1].number() : -1);
        json.key("bodies").open('[').values(joint.bodies[0], joint.bodies[1]).close().close();
    });
    json.list("points", m.points, [&](const NamedPoint& point) {
        json.open('{').member("label", label(Symbol::Letter::point, point.name)).close();
    });
    json.key("centres").open('{');
    for (const InstantCentre& centre : solution.centres)
        if (centre.at.element() != none)
            json.key(id_of_centre(solution, centre))
                .value(kinegraph::name_of(centre_symbol(m, centre.first, centre.second, false)));
    json.close();
    // Of the units of figures those that are not SI.
    json.key("units").open('{');
    for (const Unit* unit : {&m.units.velocity, &m.units.acceleration, &m.units.force})
        if (unit->si != Exact(1)) json.key(unit->symbol).value(unit->si.to_double());
    json.close().close();
}

void write_figure(const AloneFigure& figure, const Solution& solution, JsonWriter& json) {
    json.open('{').member("name", figure.name);
    const InPage in_page = figure.id ? row_of(figure.id->kind).in_page : InPage{};
    json.member("layer", std::string(in_page.layer));
    const auto flag = [&](const char* name, bool is_set) {
        if (is_set) json.member(name, true);
    };
    flag("isMechanism", in_page.is_mechanism);
    flag("isStacked", in_page.is_stacked && figure.id->part == all_loads);
    flag("isHeld", in_page.marks == InPage::Marks::always_said);
    flag("mayBeHeld", in_page.marks == InPage::Marks::if_said);
    flag("hasNoTasks", in_page.tasks == InPage::Tasks::none);
    flag("findsForces", in_page.tasks == InPage::Tasks::forces);
    flag("isLever", in_page.is_lever);
    flag("isOfOne", in_page.is_of_one);
    flag("mayRest", in_page.may_rest);
    if (!in_page.vectors_like.empty()) json.member("vectorsLike", std::string(in_page.vectors_like));
    if (figure.id) {
        if (const auto body = free_body_in(solution, *figure.id))
            json.member("freeBody", *body == none ? "" : legal_id(solution.mechanism.body(*body).name));
        if (const std::string prefix = prefix_of_load(solution, *figure.id); !prefix.empty())
            json.member("prefix", prefix);
    }
    json.key("origin").open('[').values(figure.origin.x, figure.origin.y).close();
    if (figure.places > 0) json.member("places", figure.places);
    if (figure.loaded != none && figure.by_load) {
        json.key("loaded").open('{').member("joint", figure.loaded).member("power", *figure.by_load);
        json.close();
    }
    json.key("labels").open('[');
    for (const Mark& mark : figure.page.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (text == nullptr || text->cls != "label") continue;
        json.open('[');
        for (const std::string& name : text->names) json.value(name);
        json.close();
    }
    json.close().close();
}

std::vector<Language> languages_of_page(Language asked) {
    return {asked, asked == Language::en ? Language::it : Language::en};
}

void write_words(Language asked, JsonWriter& json) {
    json.key("words").open('{');
    std::vector<Language> all = languages_of_page(asked);
    std::sort(all.begin(), all.end());
    for (const Language language : all) {
        json.key(code_of(language)).open('{');
        for (std::size_t i = 0; i < lang::live_section.size(); ++i)
            json.key(lang::live_section.name(i)).value(lang::live_section.text(i, language));
        json.member("decimal_mark", word(lang::notation::decimal_mark, language)).close();
    }
    json.close();
}

}  // namespace kinegraph::render
