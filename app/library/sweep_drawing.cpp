#include "app/library/sweep_drawing.hpp"

#include <algorithm>
#include <optional>

#include "constructions/positions/drawn_motion.hpp"
#include "engine/file/spelling.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph::app {
namespace {

/// "a, b" → "a" and "b"; a comma within brackets parts the arguments of a function, and one between single quotes
/// belongs to a name.
std::vector<std::string> parted(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    bool is_quoted = false;
    char before = ',';  // the last sign that is no blank
    for (const char c : text) {
        // Elsewhere an apostrophe is part of a name: A'.
        if (c == '\'') is_quoted = !is_quoted && std::string_view("+-*/^(|,=").find(before) != std::string_view::npos;
        if (c != ' ') before = c;
        depth += is_quoted ? 0 : c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth <= 0 && !is_quoted)
            parts.emplace_back();
        else if (c != ' ' || !parts.back().empty())
            parts.back() += c;
    }
    for (std::string& part : parts)
        while (part.ends_with(' ')) part.pop_back();
    return parts;
}

/// The default plots.
std::vector<std::vector<std::size_t>> usual_plots(const std::vector<Column>& columns) {
    std::vector<std::vector<std::size_t>> plots;
    std::optional<Quantity> subject;
    for (const Column& column : columns)
        if (column.kind == Column::Kind::slid) subject = column.quantity;
    if (!subject)
        for (const Column& column : columns)
            if (column.kind == Column::Kind::angle) subject = column.quantity;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].quantity.kind == Quantity::Kind::effort) plots.push_back({i});
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Quantity& q = columns[i].quantity;
        if (!subject || q.kind == Quantity::Kind::unnamed) continue;
        const bool slides =
            subject->joint != none && q.joint == subject->joint && result_kind(q).subject == ResultKind::Subject::joint;
        const bool turns = subject->joint == none && q.body == subject->body && result_kind(q).turns();
        if (slides || turns) plots.push_back({i});
    }
    return plots;
}

/// Places that a body covers as drawn: its points, and four on its circle.
std::vector<VectorOf<double>> places_covered(const Body& body, const Pose& pose) {
    const auto rough = [&](PointIndex point) {
        return VectorOf<double>{pose.at(point).x.to_double(), pose.at(point).y.to_double()};
    };
    std::vector<VectorOf<double>> places;
    for (const PointIndex point : body.points) places.push_back(rough(point));
    if (!body.circle) return places;
    const VectorOf<double> centre = rough(body.circle->centre);
    const double radius = body.circle->radius.to_double();
    for (const VectorOf<double>& side : {VectorOf<double>{radius, 0}, {0, radius}})
        for (const int sense : {1, -1}) places.push_back(centre + static_cast<double>(sense) * side);
    return places;
}

}  // namespace

ColumnsOnRequest columns_on_request(const SweepOptions& options, const Mechanism& mechanism,
                                    const std::vector<Column>& operands) {
    std::vector<std::string> texts = parted(options.columns);
    for (const std::string& plot : options.plots)
        for (std::string& text : parted(plot)) texts.push_back(std::move(text));
    const std::vector<Column> named = operands_in(texts, operands);
    const auto is_named = [&](const Column& column) {
        return std::any_of(named.begin(), named.end(), [&](const Column& each) { return each.name == column.name; });
    };
    const auto is_component_of_named = [&](const Column& column) {
        return std::any_of(named.begin(), named.end(), [&](const Column& each) { return each.name == column.vector; });
    };
    ColumnsOnRequest found;
    for (const Column& column : operands) {
        const ResultKind& kind = result_kind(column.quantity);
        if (kind.on_request && is_named(column)) found.columns.push_back(column);
        if (kind.subject == ResultKind::Subject::action && !is_modulus(column) &&
            (is_named(column) || is_component_of_named(column)))
            found.columns.push_back(column);
    }
    for (ResultExpression& each : defined_results(mechanism))
        if (is_named(each.column())) {
            found.columns_of_defined.push_back(each.column());
            found.defined.push_back(std::move(each));
        }
    found.has_least_transmission_angle = is_named(transmission_column());
    return found;
}

tl::expected<std::vector<std::size_t>, Words> columns_named(const std::string& names,
                                                            const std::vector<Column>& columns,
                                                            const std::vector<Column>& operands, const AddColumn& add,
                                                            const std::string& option) {
    std::vector<std::size_t> found;
    for (const std::string& text : parted(names)) {
        const auto is_it = [&](const Column& each) { return each.name == text || each.expression == text; };
        const auto column = std::find_if(columns.begin(), columns.end(), is_it);
        if (column != columns.end()) {
            found.push_back(static_cast<std::size_t>(column - columns.begin()));
            continue;
        }
        std::vector<Column> known = columns;
        for (const Column& each : operands)
            if (each.kind == Column::Kind::parameter) known.push_back(each);
        const auto expression = ResultExpression::read(text, known);
        if (expression) {
            found.push_back(add(*expression));
            continue;
        }
        if (is_expression(text))
            return tl::unexpected(Words(lang::sweeps::option_says, option, quoted(text), expression.error()));
        std::vector<std::string_view> names_known;
        std::string list;
        for (const Column& each : columns) list += (list.empty() ? "" : ", ") + each.name;
        for (const std::vector<Column>* some : {&columns, &operands})
            for (const Column& each : *some)
                if (some == &columns || result_kind(each.quantity).on_request) names_known.emplace_back(each.name);
        Speller speller;
        return tl::unexpected(Words(lang::sweeps::there_is_no_quantity, quoted(text),
                                    did_you_mean(speller.nearest(text, names_known)), option, list));
    }
    return found;
}

tl::expected<std::vector<std::vector<std::size_t>>, Words> plots_of(const std::vector<std::string>& asked,
                                                                    const std::vector<Column>& columns,
                                                                    const std::vector<Column>& operands,
                                                                    const AddColumn& add, const std::string& dashes) {
    if (asked.empty()) return usual_plots(columns);
    std::vector<std::vector<std::size_t>> plots;
    for (const std::string& text : asked) {
        const auto plot = columns_named(text, columns, operands, add, dashes + "plot");
        if (!plot) return tl::unexpected(plot.error());
        const auto is_of_other_unit = [&](std::size_t each) {
            const Column &first = columns[plot->front()], &other = columns[each];
            return other.unit != first.unit || other.si_unit != first.si_unit;
        };
        if (std::any_of(plot->begin(), plot->end(), is_of_other_unit))
            return tl::unexpected(Words(lang::sweeps::plot_quantities_of_different_units_need, quoted(text), dashes));
        constexpr std::size_t most = 4;
        if (plot->size() > most)
            return tl::unexpected(Words(lang::sweeps::plot_at_most_four_quantities, quoted(text), dashes));
        plots.push_back(*plot);
    }
    return plots;
}

tl::expected<std::vector<Trace>, Words> traces_of(const std::vector<std::string>& asked, const Mechanism& mechanism,
                                                  const std::string& dashes) {
    const auto nearest = [](const std::string& name, const auto& list) {
        std::vector<std::string> names;
        for (const auto& each : list) names.push_back(each.name);
        Speller speller;
        return did_you_mean(speller.nearest(name, names));
    };
    std::vector<Trace> traces;
    for (const std::string& text : asked) {
        const std::vector<std::string> parts = parted(text);
        Trace trace;
        trace.name = text;
        const auto point = mechanism.point_named(parts[0]);
        if (!point)
            return tl::unexpected(Words(lang::sweeps::trace_no_point_is_named, quoted(parts[0]),
                                        nearest(parts[0], mechanism.points), dashes));
        trace.point = *point;
        if (parts.size() > 2 || (parts.size() == 2 && !parts[1].starts_with("on ")))
            return tl::unexpected(Words(lang::sweeps::trace_is_not_p_or_p, quoted(text), dashes));
        if (parts.size() == 2) {
            const std::string name = parts[1].substr(3);
            const auto body = mechanism.body_named(name);
            if (!body)
                return tl::unexpected(
                    Words(lang::sweeps::trace_no_body_is_named, quoted(name), nearest(name, mechanism.bodies), dashes));
            trace.on = *body;
        }
        traces.push_back(std::move(trace));
    }
    return traces;
}

std::vector<render::Way> ways_of(const Mechanism& mechanism, const Pose& pose, const Positions& positions,
                                 const Travel& travel, int poses, const std::vector<Trace>& traces) {
    std::vector<render::Way> ways;
    for (OtherPosition& other : other_positions(positions, travel, poses)) {
        render::Way way;
        way.kind = render::Way::Kind::position;
        for (const BodyIndex body : mechanism.moving_bodies())
            for (const VectorOf<double>& place : places_covered(mechanism.body(body), pose))
                way.places.push_back(other.bodies[at_index(body)](place));
        way.bodies = std::move(other.bodies);
        ways.push_back(std::move(way));
    }
    std::vector<TracedPoint> points;
    for (const Trace& trace : traces) points.push_back({trace.point, trace.on});
    auto paths = paths_of(positions, travel, points);
    for (std::size_t k = 0; k < traces.size(); ++k)
        for (PathPlaces& places : paths[k]) ways.push_back({traces[k].name, true, std::move(places)});
    return ways;
}

}  // namespace kinegraph::app
