// Sweep over a parameter: the file solved again with each value, in the position that it then draws.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/row_text.hpp"
#include "app/library/sweep_drawing.hpp"
#include "app/library/sweep_state.hpp"
#include "constructions/positions/expression_columns.hpp"
#include "constructions/positions/followed_columns.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/file/json_text.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph {
namespace {

/// The value in SI, but angles in degrees, as formulas use them.
double si_of(const Measured& value) {
    return value.value.to_double() * std::pow(std::numbers::pi / 180, value.dimension.angle);
}

/// The value of an option. `name`: its name in messages.
tl::expected<Measured, Words> value_given(const std::string& name, const std::string& text) {
    auto read = is_formula(text)
                    ? tl::expected<Measured, Words>(tl::unexpected(Words(lang::sweeps::a_value_is_wanted_here_no)))
                    : read_measured(text, {});
    if (read) return *std::move(read);
    return tl::unexpected(Words(name) + lang::notation::colon + read.error());
}

/// The values of the parameter, as settings. The last one does not exceed `to`.
tl::expected<Variation, Words> values_of(const SweepOptions& options) {
    constexpr int most = 1'000'000;
    const std::string& dashes = options.dashes;
    const auto wrong = [&](Key key, const auto&... more) { return tl::unexpected(Words(key, dashes, more...)); };
    if (options.from.empty() || options.to.empty()) return wrong(lang::sweeps::over_wants);
    const auto from = value_given(dashes + "from", options.from), to = value_given(dashes + "to", options.to);
    if (!from) return tl::unexpected(from.error());
    if (!to) return tl::unexpected(to.error());
    std::optional<Measured> step;
    if (!options.step.empty()) {
        auto read = value_given(dashes + "step", options.step);
        if (!read) return tl::unexpected(read.error());
        step = *std::move(read);
    }
    for (const Measured* other : {&*to, step ? &*step : &*to})
        if (other->is_bare != from->is_bare || !(other->dimension == from->dimension))
            return wrong(lang::sweeps::from_is_and_to_or_step, described(*from), described(*other));
    const Exact way = to->value - from->value;
    if (way.is_zero()) return wrong(lang::sweeps::from_and_to_are_the_same);
    if (!step && (options.steps < 1 || options.steps > most)) return wrong(lang::sweeps::steps_1, std::to_string(most));
    const Exact each = step ? step->value : way / Exact::ratio(options.steps, 1);
    const Exact count = each.is_zero() ? Exact(-1) : way / each;
    if (count.sign() < 0) return wrong(lang::sweeps::step_does_not_lead, options.step);
    if (count > Exact(most)) return wrong(lang::sweeps::step_more_than_values_take, std::to_string(most));
    Variation values;
    values.parameter = options.over;
    values.count =
        static_cast<std::uint64_t>(mpz_class(count.rational().get_num() / count.rational().get_den()).get_ui()) + 1;
    Exact unit = 1;
    if (!from->is_bare) {
        values.unit = read_quantity(options.from, QuantityKind::dimensionless)->unit->symbol;
        unit = read_measured("1 " + values.unit, {})->value;
    }
    values.from = from->value / unit;
    values.step = each / unit;
    return values;
}

class ParameterSweep final : public Sweep::State {
public:
    ParameterSweep(const MechanismFile::State& file, const SweepOptions& options, Variation values,
                   std::optional<double> drawn)
        : State(file.mechanism), file_{file.text, file.name, file.set}, options_(options), values_(std::move(values)) {
        table.driver = values_.parameter;
        table.turns = false;
        table.travel.from = si(0);
        table.travel.to = si(values_.count - 1);
        table.parameter = CycleTable::Parameter{shown_unit(), drawn};
    }

    Expected<void> each_row(const See& see, const Progress& progress) override {
        if (!has_rows) solve_all(progress);
        if (table.rows.empty()) return tl::unexpected(diagnostics_of(fault_));
        if (wrong_columns_) return refused(Diagnostic::Kind::bad_input, *wrong_columns_);
        const std::vector<bool> none_empty(table.columns.size());
        for (const auto& row : table.rows)
            if (!see(row, none_empty)) break;
        return {};
    }

    std::string json_before() const override {
        return "\"parameter\": " + json_text(table.driver) + ",\n  \"from\": " + app::decimal_of(table.travel.from) +
               ",\n  \"to\": " + app::decimal_of(table.travel.to);
    }
    std::string json_after() const override { return {}; }
    std::vector<render::Way> finish_table() override {
        follow_plots();
        return {};
    }

    std::vector<Words> summary() const override {
        if (left_out_.empty()) return {};
        if (left_out_.size() == 1)
            return {{lang::sweeps::n_1_row_is_left_out_where_the, table.driver, left_out_.front()}};
        return {{lang::sweeps::rows_are_left_out_where_the_file, std::to_string(left_out_.size()), table.driver,
                 left_out_.front(), left_out_.back()}};
    }
    LargestDifference::Found difference() const override { return difference_.found(table.columns, size_); }
    /// "r = 40 mm"
    Words coordinate_text(double coordinate) const override {
        const Unit& unit = table.parameter->unit;
        std::array<char, 32> value{};
        std::snprintf(value.data(), value.size(), "%.6g", coordinate / unit.si.to_double());
        const bool is_close = unit.symbol.empty() || unit.symbol == "°";
        return table.driver + std::string(" = ") + decimal_words(value.data()) +
               (std::string(is_close ? "" : " ") + unit.symbol);
    }

private:
    double si(std::uint64_t i) const { return si_of(*read_measured(values_.value(i), {})); }

    void solve_all(const Progress& progress) {
        for (std::uint64_t i = 0; i < values_.count; ++i) {
            if (progress) progress(static_cast<long>(i), static_cast<long>(values_.count));
            if (auto row = row_of(values_.value(i))) {
                table.rows.push_back(*std::move(row));
            } else {
                left_out_.push_back(values_.value(i));
                table.left_out.push_back(si(i));
            }
        }
        has_rows = true;
    }

    /// Follows what is plotted between the rows. A value costs a solution, so the rows are the only samples.
    void follow_plots() {
        std::vector<std::size_t> whole;
        for (const auto& plot : plots)
            for (const std::size_t column : plot)
                if (std::find(whole.begin(), whole.end(), column) == whole.end()) whole.push_back(column);
        const auto wanted = [&](const std::vector<double>& row) {
            FollowedCurve::Values found;
            for (const std::size_t i : whole) found.values.push_back(row[i]);
            return found;
        };
        const auto evaluate = [&](double at) -> std::optional<FollowedCurve::Values> {
            // Angles go on from those of the row beside.
            last_ = *std::min_element(table.rows.begin(), table.rows.end(), [&](const auto& a, const auto& b) {
                return std::abs(a[0] - at) < std::abs(b[0] - at);
            });
            const auto row = row_of(values_.text_of(Exact::from_double(at / table.parameter->unit.si.to_double())));
            return row ? std::optional(wanted(*row)) : std::nullopt;
        };
        std::vector<FollowedCurve> curves;
        const auto is_left_out = [&](double from, double to) {
            return std::any_of(table.left_out.begin(), table.left_out.end(),
                               [&](double each) { return (each > from && each < to) || (each < from && each > to); });
        };
        for (std::size_t first = 0, end = 0; first < table.rows.size(); first = end) {
            const auto at = [&](std::size_t i) { return table.rows[i][0]; };
            for (end = first + 1; end < table.rows.size() && !is_left_out(at(end - 1), at(end));) ++end;
            if (end - first < 3) continue;
            std::vector<FollowedCurve::Node> nodes;
            for (std::size_t i = first; i < end; ++i)
                nodes.push_back({(at(i) - at(first)) / (at(end - 1) - at(first)), wanted(table.rows[i])});
            curves.emplace_back(FollowedCurve::Stretch{at(first), at(end - 1)}, evaluate);
            curves.back().take(std::move(nodes));
        }
        if (curves.empty()) return;
        const FollowedColumns followed(std::move(curves));
        table.followed.columns.resize(table.columns.size());
        for (std::size_t i = 0; i < whole.size(); ++i) table.followed.columns[whole[i]] = followed.column(i, true);
    }

    /// The unit of the first value, with its factor to SI.
    Unit shown_unit() const {
        if (values_.unit.empty()) return {"", 1};
        const KnownUnit* known = unit_spelt(values_.unit);
        return {known->symbol == "deg" ? "°" : std::string(known->symbol), known->si};
    }

    /// The column of an input force may contain the value by virtual work if there are no reactions.
    static bool is_effort_by_work(const Quantity& held, const Quantity& column) {
        return held.kind == Quantity::Kind::virtual_effort && column.kind == Quantity::Kind::effort &&
               held.given == column.given;
    }
    /// Compares the row of a value with the check.
    void hold_against_check(const Solution& solution, const std::vector<double>& row) {
        size_ = std::max(size_, solution.pose.size.to_double());
        for (std::size_t i = 1; i < table.columns.size(); ++i) {
            const Column& column = table.columns[i];
            if (column.kind == Column::Kind::result)
                for (const CheckRow& each : solution.checks)
                    if (each.quantity == column.quantity || is_effort_by_work(each.quantity, column.quantity))
                        difference_.hold(i, column, row[i], each.numeric, row[0]);
            if (column.kind == Column::Kind::named && solution.problem)
                for (const ProblemValue& each : solution.problem->values)
                    if (in_english(each.name) == column.name && each.numeric)
                        difference_.hold(i, column, row[i], *each.numeric, row[0]);
        }
    }

    /// The results for one value; empty if there are none.
    std::optional<std::vector<double>> row_of(const std::string& value) {
        const auto note = [&](Errors errors) {
            if (fault_.empty()) fault_ = std::move(errors);
            return std::nullopt;
        };
        std::vector<Setting> set = file_.set;
        std::erase_if(set, [&](const Setting& each) { return each.name == table.driver; });
        set.push_back({table.driver, value});
        auto varied = read_mechanism(file_.text, file_.name, set);
        if (!varied) return note(varied.error());
        auto solution = solve(*std::move(varied));
        if (!solution) return note(solution.error());
        if (!solution->unsolved.empty())
            return note({{ErrorCode::no_unique_answer, {}, {lang::sweeps::no_value_has_a_unique_answer}}});
        std::vector<NamedResult> results = named_results(*solution);
        std::erase_if(results, [](const NamedResult& each) { return is_modulus(each.column); });
        if (table.columns.empty()) choose_columns(results);
        std::vector<double> row{si_of(*read_measured(value, {}))};
        for (std::size_t i = 1; i < table.columns.size() - expressions_.size(); ++i) {
            const auto found = std::find_if(results.begin(), results.end(), [&](const NamedResult& each) {
                return each.column.name == table.columns[i].name;
            });
            if (found == results.end()) return std::nullopt;
            row.push_back(table.columns[i].kind == Column::Kind::angle && !last_.empty()
                              ? beside(found->value, last_[i])
                              : found->value);
        }
        last_ = row;
        hold_against_check(*solution, row);
        row.resize(table.columns.size());
        std::vector<double> noise(row.size());
        expressions_.fill(row, noise);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (expressions_.is_undetermined(i)) return std::nullopt;
        return row;
    }
    void choose_columns(const std::vector<NamedResult>& results) {
        table.columns.push_back({Column::Kind::named, {}, table.driver, QuantityKind::dimensionless});
        for (const NamedResult& each : results) table.columns.push_back(each.column);
        const std::size_t own = table.columns.size();
        const auto add = [this](const ResultExpression& expression) {
            return expressions_.add(expression, table.columns);
        };
        if (const auto chosen = choose_shown(options_.columns, own, add, options_.dashes); !chosen)
            wrong_columns_ = chosen.error();
        auto columns = app::plots_of(options_.plots, table.columns, add, options_.dashes);
        if (columns)
            plots = *std::move(columns);
        else if (!wrong_columns_)
            wrong_columns_ = columns.error();
    }
    /// The same angle, within half a turn of the one before.
    static double beside(double angle, double before) {
        constexpr double turn = 2 * std::numbers::pi;
        return angle + turn * std::round((before - angle) / turn);
    }

    SourceFile file_;
    SweepOptions options_;
    ExpressionColumns expressions_;
    std::optional<Words> wrong_columns_;
    Variation values_;
    LargestDifference difference_;
    double size_ = 0;  ///< of the largest drawing, m
    std::vector<double> last_;
    std::vector<std::string> left_out_;
    Errors fault_;  ///< of the first value that fails
};

/// Why the parameter cannot have these values; empty if it can, or if a formula gives it.
Words of_another_kind(const Variation& values, const std::string& own_text, const std::string& dashes) {
    if (is_formula(own_text)) return {};
    const auto own = read_measured(own_text, {}), given = read_measured(values.value(0), {});
    if (own->is_bare == given->is_bare && own->dimension == given->dimension) return {};
    return {lang::sweeps::from_is_the_parameter, dashes, described(*given), values.parameter, described(*own)};
}

/// Why a parameter cannot be swept; empty if it can.
Words meaningless_sweep(const SweepOptions& options, JsonValue parameters) {
    if (!options.driver.empty() || !options.along.empty() || options.branch != 0 || !options.traces.empty() ||
        !options.centrodes.empty() || options.poses != 0)
        return {lang::sweeps::over_moves_no_driver_driver_branch, options.dashes};
    std::vector<std::string_view> names;
    if (parameters && parameters.is_object())
        for (const JsonValue each : parameters) names.push_back(each.key());
    if (std::find(names.begin(), names.end(), options.over) != names.end()) return {};
    return {lang::sweeps::over_the_file_has_no_parameter, options.dashes, quoted(options.over),
            did_you_mean(Speller().nearest(options.over, names))};
}

/// The parameter's own value, SI: that of the settings, else of the file; empty if a formula gives it.
std::optional<double> drawn_value(const MechanismFile::State& file, const std::string& name, std::string text) {
    for (const Setting& each : file.set)
        if (each.name == name) text = each.value;
    if (is_formula(text)) return std::nullopt;
    const auto own = read_measured(text, {});
    return own ? std::optional(si_of(*own)) : std::nullopt;
}

}  // namespace

Expected<std::unique_ptr<Sweep::State>> sweep_of_parameter(const MechanismFile::State& file,
                                                           const SweepOptions& options) {
    const auto source = JsonSource::read(file.text);
    const JsonValue parameters = source->root()["parameters"];
    const auto wrong = [](const Words& why) { return refused(Diagnostic::Kind::bad_input, why); };
    if (const Words why = meaningless_sweep(options, parameters); !why.empty()) return wrong(why);
    auto values = values_of(options);
    if (!values) return wrong(values.error());
    const std::string own(parameters[options.over].text());
    if (const Words why = of_another_kind(*values, own, options.dashes); !why.empty()) return wrong(why);
    return std::make_unique<ParameterSweep>(file, options, *std::move(values), drawn_value(file, options.over, own));
}

}  // namespace kinegraph
