// Implementation of live_data.hpp.
#include "render/live/live_data.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "engine/file/json_text.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "lang/keys/live.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/page/figure.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

/// A writer for JSON in one pass; it inserts the commas.
class Json {
public:
    Json& open(char bracket) {
        separate();
        out_ += bracket;
        is_first_ = true;
        return *this;
    }
    Json& close(char bracket) {
        out_ += bracket;
        is_first_ = false;
        return *this;
    }
    Json& key(std::string_view name) {
        text(name);
        out_ += ':';
        is_first_ = true;
        return *this;
    }
    Json& text(std::string_view words) {
        separate();
        for (const char c : json_text(words))
            if (c == '<')
                out_ += "\\u003c";  // so that neither "</script>" nor "<!--" appears
            else
                out_ += c;
        return *this;
    }
    Json& number(double value) {
        separate();
        out_ += std::isfinite(value) ? shortest(value) : "null";
        return *this;
    }
    Json& number(int value) {
        separate();
        out_ += std::to_string(value);
        return *this;
    }
    /// An initial value for Newton's method: seven digits are enough.
    Json& rough(double value) {
        if (std::abs(value) > 1e9) return number(value);
        return number(std::round(value * 1e7) / 1e7);
    }
    Json& truth(bool value) {
        separate();
        out_ += value ? "true" : "false";
        return *this;
    }
    /// Writes the values in a row.
    template <class... Values>
    Json& all(const Values&... values) {
        (one(values), ...);
        return *this;
    }
    template <class List, class Each>
    Json& list(std::string_view name, const List& list, Each each) {
        key(name).open('[');
        for (const auto& item : list) each(item);
        return close(']');
    }
    std::string take() { return std::move(out_); }

private:
    void separate() {
        if (!is_first_) out_ += ',';
        is_first_ = false;
    }
    void one(double value) { number(value); }
    void one(int value) { number(value); }
    void one(bool value) { truth(value); }
    void one(const std::string& words) { text(words); }
    void one(const VectorOf<double>& v) { number(v.x).number(v.y); }
    template <class Of>
    void one(ListIndex<Of> index) {
        number(index.number());
    }

    std::string out_;
    bool is_first_ = true;
};

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

class MovingWriter {
public:
    explicit MovingWriter(const Moving& moving, const Solution& solution) : moving_(moving), solution_(solution) {}

    std::string write() {
        json_.open('{').key("size").number(moving_.size).key("unit").number(moving_.unit);
        write_closure();
        json_.list("directions", moving_.directions, [&](double each) { json_.number(each); });
        json_.list("settings", moving_.settings, [&](const MovingSetting& each) {
            const Unit unit = unit_of(each);
            json_.open('{').key("name").text(each.name).key("unit").text(unit.symbol);
            json_.key("size").number(unit.si.to_double()).key("value").number(each.value);
            if (each.kind == MovingSetting::Kind::bar) json_.key("bar").number(each.of);
            if (each.unit == QuantityKind::length)
                json_.key("ends").open('[').all(each.ends[0], each.ends[1]).close(']');
            if (each.kind == MovingSetting::Kind::parameter) json_.key("parameter").truth(true);
            if (each.direction) json_.key("direction").number(*each.direction).key("given").number(each.of);
            if (each.radians != 0) json_.key("radians").number(each.radians);
            json_.close('}');
        });
        json_.list("effects", moving_.effects, [&](const MovingEffect& each) { write(each); });
        json_.list("fixed", moving_.fixed, [&](const Moving::Fixed& each) {
            json_.open('[').all(std::string(name_of(each.why)), each.name).close(']');
        });
        json_.list("columns", moving_.columns, [&](const Column& each) { write(each); });
        for (const MovingPlan::Binding& each : moving_.plans.front().held) drawn_.insert(each.name);
        json_.list("plans", moving_.plans, [&](const MovingPlan& each) { write(each); });
        json_.list("courses", moving_.courses, [&](const MovingCourse& each) { write(each); });
        return json_.close('}').take();
    }

private:
    void write_closure() {
        json_.list("rows", moving_.rows, [&](const ClosureRowOf<double>& row) {
            json_.open('[').all(static_cast<int>(row.kind), row.i, row.j, row.p, row.q, row.along, row.offset,
                                row.lever, row.share_i, row.share_j, row.driver);
            json_.close(']');
        });
        json_.list("bodies", moving_.bodies, [&](const Closure::Body& body) {
            json_.open('[')
                .all(body.reference.x.to_double(), body.reference.y.to_double(), body.x, body.turn)
                .close(']');
        });
        json_.list("frozen", moving_.frozen, [&](bool each) { json_.truth(each); });
        json_.list("points", moving_.points, [&](const Positions::PointRule& point) {
            json_.open('[').all(point.carrier.body, point.local, point.carrier.contact).close(']');
        });
        json_.list("joints", moving_.joints, [&](const Positions::JointRule& joint) { write(joint); });
    }
    void write(const Positions::JointRule& joint) {
        const auto spot = [&](const char* name, const VectorOf<double>& at) {
            json_.key(name).open('[').all(at).close(']');
        };
        json_.open('{').key("turnsWith").all(joint.turns_with).key("bodies").open('[');
        json_.all(joint.bodies[0], joint.bodies[1]).close(']');
        spot("guide", joint.guide);
        spot("tangent", joint.tangent);
        spot("pressure", joint.pressure);
        json_.key("locals").open('[');
        for (const VectorOf<double>& local : joint.locals) json_.open('[').all(local).close(']');
        json_.close(']').key("reaches").open('[').all(joint.reaches[0], joint.reaches[1]).close(']');
        json_.key("straight").open('[').all(joint.is_straight[0], joint.is_straight[1]).close(']');
        json_.key("circle").number(joint.first_circle).key("point").all(joint.point);
        json_.key("arc")
            .truth(joint.is_arc)
            .key("touches")
            .truth(joint.touches)
            .key("meshes")
            .truth(joint.meshes)
            .close('}');
    }
    void write(const Column& column) {
        const Quantity& q = column.quantity;
        const Unit unit = unit_of_column(column, solution_.mechanism.units);
        json_.open('{')
            .key("name")
            .text(column.name)
            .key("kind")
            .text(name_of(column.kind))
            .key("unit")
            .text(unit.symbol);
        json_.key("symbol").text(plain(typeset(column, solution_.mechanism, Language::en)));
        json_.key("size").number(unit.si.to_double()).key("body").all(q.body).key("point").all(q.point);
        json_.key("joint").all(q.joint).key("component");
        json_.text(q.component == Quantity::Component::y   ? "y"
                   : q.component == Quantity::Component::x ? "x"
                                                           : "whole")
            .close('}');
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
        const auto way = [&](const auto&... steps) { json_.open('[').open('[').all(steps...).close(']'); };
        const std::string rows = "rows", bodies = "bodies", points = "points", joints = "joints", plans = "plans";
        switch (effect.list) {
            case List::row: way(rows, item, first_of_row + part); break;
            case List::body: way(bodies, item, part); break;
            case List::point: way(points, item, 1 + part); break;
            case List::local: way(joints, item, std::string("locals"), part / 2, part % 2); break;
            case List::reach: way(joints, item, std::string("reaches"), part); break;
            case List::guide: way(joints, item, std::string("guide"), part); break;
            case List::tangent: way(joints, item, std::string("tangent"), part); break;
            case List::setting: way(std::string("settings"), item, std::string("value")); break;
            case List::given: way(plans, effect.plan, std::string("givens"), item, part); break;
            case List::given_factor: way(plans, effect.plan, std::string("moving"), item, std::string("factor")); break;
            case List::given_offset: way(plans, effect.plan, std::string("moving"), item, std::string("offset")); break;
        }
        for (const MovingEffect::Term& term : effect.terms) json_.all(term.first, term.second, term.by);
        json_.close(']');
    }
    void write(const MovingPlan& plan) {
        json_.open('{');
        json_.list("givens", plan.givens, [&](const ValueOf<double>& given) {
            json_.open('[');
            std::visit([&](const auto& value) { write(value); }, given);
            json_.close(']');
        });
        json_.list("strokes", plan.program.strokes, [&](const Stroke& stroke) {
            json_.all(static_cast<int>(stroke.verb), static_cast<int>(stroke.plane), stroke.inputs[0], stroke.inputs[1],
                      stroke.given);
        });
        json_.list("guards", plan.program.guards, [&](const Guard& guard) {
            json_.all(static_cast<int>(guard.question), static_cast<int>(guard.how), guard.inputs[0], guard.inputs[1],
                      guard.verdict, guard.before);
        });
        json_.key("doubtfulBits").number(plan.program.doubtful_bits);
        json_.list("moving", plan.moving, [&](const MovingGiven& given) { write(given); });
        json_.list("sources", plan.sources, [&](const MovingPlan::Source& source) {
            json_.number(source.known ? source.element.number() : -2);  // -1: no element
        });
        json_.list("vectors", plan.vectors, [&](const MovingPlan::Vector& vector) {
            if (!vector.vanishes)
                json_.open('[').all(legal_id(vector.figure), vector.name, vector.tail, vector.tip).close(']');
        });
        json_.list("spots", plan.spots, [&](const MovingPlan::Spot& spot) {
            json_.open('[').all(legal_id(spot.figure), spot.name, spot.point).close(']');
        });
        json_.list("lines", plan.lines, [&](const MovingPlan::Line& line) {
            json_.open('[').all(legal_id(line.figure), line.name, line.statement, line.line);
            for (const ElementIndex point : line.points) json_.all(point);
            json_.close(']');
        });
        json_.list("held", plan.held, [&](const MovingPlan::Binding& held) {
            json_.open('[').all(held.name, held.place, held.vector, held.couple);
            const bool is_new = !held.figure.empty() && !drawn_.contains(held.name);
            if (held.given >= 0 || is_new) json_.number(held.given);
            if (is_new) json_.text(legal_id(held.figure)).text(held.symbol);
            json_.close(']');
        });
        json_.close('}');
    }
    void write(const PointOf<double>& point) { json_.all(point.x, point.y, point.w); }
    void write(const LineOf<double>& line) { json_.all(line.a, line.b, line.c); }
    void write(const VectorOf<double>& vector) { json_.all(vector); }
    void write(double scalar) { json_.number(scalar); }
    void write(const MovingGiven& given) {
        json_.open('{')
            .key("rule")
            .text(name_of(given.rule))
            .key("given")
            .number(given.given)
            .key("index")
            .number(given.index);
        json_.key("ends").open('[').all(given.ends[0], given.ends[1]).close(']');
        json_.key("bodies").open('[').all(given.bodies[0], given.bodies[1]).close(']');
        json_.key("factor").number(given.factor).key("offset").number(given.offset).close('}');
    }
    void write(const MovingCourse& course) {
        json_.open('{')
            .key("driver")
            .number(course.driver)
            .key("name")
            .text(course.name)
            .key("turns")
            .truth(course.turns);
        json_.key("rate")
            .number(course.rate)
            .key("from")
            .number(course.travel.at(0))
            .key("to")
            .number(course.travel.at(1));
        json_.key("startsAtLimit")
            .truth(course.travel.starts_at_limit)
            .key("endsAtLimit")
            .truth(course.travel.ends_at_limit);
        json_.list("changePoints", course.travel.change_points, [&](double each) { json_.number(each); });
        json_.key("byLaw").truth(course.by_law);
        json_.list("shares", course.shares, [&](double each) { json_.number(each); });
        json_.list("samples", course.samples, [&](const MovingCourse::Sample& sample) {
            json_.open('{').key("at").number(sample.at).key("plan").number(sample.plan);
            // For most drivers the coordinate is the position itself, and has no separate rate.
            if (course.by_law) {
                json_.key("coordinate").number(sample.coordinate);
                json_.key("rate").number(sample.rate).key("acceleration").number(sample.acceleration);
            }
            if (!sample.values.empty())
                json_.list("values", sample.values, [&](const std::optional<double>& each) {
                    json_.number(each.value_or(std::numeric_limits<double>::quiet_NaN()));  // written as null
                });
            json_.list("q", sample.q, [&](double each) { json_.rough(each); }).close('}');
        });
        json_.close('}');
    }

    static constexpr int first_of_row = 3;  ///< after kind and bodies

    const Moving& moving_;
    const Solution& solution_;
    std::set<std::string> drawn_;  ///< names that the drawn position has
    Json json_;
};

}  // namespace

Unit unit_of_column(const Column& column, const Units& units) {
    if (column.unit == QuantityKind::angular_acceleration) return {"rad/s²", 1};
    return suitable_unit(1, column.unit, units);
}

std::string moving_json(const Moving& moving, const Solution& solution) {
    return MovingWriter(moving, solution).write();
}

std::string names_json(const Solution& solution) {
    const Mechanism& m = solution.mechanism;
    const auto label = [](Symbol::Letter letter, const std::string& name) {
        return plain(typeset(Symbol{letter, name, ""}, Language::en));
    };
    Json json;
    json.open('{');
    json.list("bodies", m.bodies, [&](const Body& body) {
        json.open('{').key("id").text(legal_id(body.name)).key("label").text(body.name).close('}');
    });
    json.list("joints", m.joints, [&](const Joint& joint) {
        const bool guided = joint.pair().has_guide() && joint.arc == none;
        json.open('{').key("id").text(legal_id(joint.name)).key("point").all(joint.point);
        json.key("turnsWith").number(guided ? joint.bodies[1].number() : -1);
        json.key("bodies")
            .open('[')
            .number(joint.bodies[0].number())
            .number(joint.bodies[1].number())
            .close(']')
            .close('}');
    });
    json.list("points", m.points, [&](const NamedPoint& point) {
        json.open('{').key("label").text(label(Symbol::Letter::point, point.name)).close('}');
    });
    json.key("centres").open('{');
    for (const InstantCentre& centre : solution.centres)
        if (centre.at.element() != none)
            json.key(id_of_centre(solution, centre))
                .text(kinegraph::name_of(centre_symbol(m, centre.first, centre.second, false)));
    return json.close('}').close('}').take();
}

std::string figure_json(const AloneFigure& figure) {
    Json json;
    json.open('{').key("name").text(figure.name);
    json.key("origin").open('[').number(figure.origin.x).number(figure.origin.y).close(']');
    if (figure.places > 0) json.key("places").number(figure.places);
    json.key("labels").open('[');
    for (const Mark& mark : figure.page.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (text == nullptr || text->cls != "label") continue;
        json.open('[');
        for (const std::string& name : text->names) json.text(name);
        json.close(']');
    }
    return json.close(']').close('}').take();
}

std::vector<Language> languages_of_page(Language asked) {
    return {asked, asked == Language::en ? Language::it : Language::en};
}

std::string words_json(Language asked) {
    Json json;
    json.open('{');
    std::vector<Language> all = languages_of_page(asked);
    std::sort(all.begin(), all.end());
    for (const Language language : all) {
        json.key(code_of(language)).open('{');
        for (std::size_t i = 0; i < lang::live_section.size(); ++i)
            json.key(lang::live_section.name(i)).text(lang::live_section.text(i, language));
        json.close('}');
    }
    return json.close('}').take();
}

}  // namespace kinegraph::render
