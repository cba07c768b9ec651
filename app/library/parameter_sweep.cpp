// Sweep over a parameter: the file solved again with each value, in the position that it then draws.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/limits.hpp"
#include "app/library/row_curves.hpp"
#include "app/library/sweep_drawing.hpp"
#include "app/library/sweep_state.hpp"
#include "constructions/positions/cycle.hpp"
#include "constructions/positions/expression_columns.hpp"
#include "constructions/positions/followed_columns.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/positions/pushing_contacts.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph {
namespace {

/// The value in SI, but angles in degrees, as formulas use them.
double si_of(const Measured& value) {
    return value.value.to_double() * nearest::pow(std::numbers::pi / 180, value.dimension.angle);
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

/// The unit of the first value, with its factor to SI.
Unit shown_unit(const Variation& values) {
    if (values.unit.empty()) return {"", 1};
    const KnownUnit* known = unit_spelt(values.unit);
    return {known->symbol == "deg" ? "°" : std::string(known->symbol), known->si};
}

/// The same angle, within half a turn of the one before.
double angle_beside(double angle, double before) {
    constexpr double turn = 2 * std::numbers::pi;
    return angle + turn * std::round((before - angle) / turn);
}

/// The column of an input force may contain the value by virtual work if there are no reactions.
bool is_effort_by_work(const Quantity& held, const Quantity& column) {
    return held.kind == Quantity::Kind::virtual_effort && column.kind == Quantity::Kind::effort &&
           held.given == column.given;
}

bool is_result(const Column& column) {
    return column.kind == Column::Kind::result || column.kind == Column::Kind::along;
}
/// Forces, efforts, and expressions (the last columns), which may divide by what vanishes.
std::vector<std::size_t> columns_with_poles(const std::vector<Column>& columns, std::size_t expressions) {
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < columns.size(); ++i)
        if (i + expressions >= columns.size() ||
            (is_result(columns[i]) && result_kind(columns[i].quantity).is_of_forces()))
            found.push_back(i);
    return found;
}

std::vector<std::string> names_of(const std::vector<ResultExpression>& expressions) {
    std::vector<std::string> names;
    for (const ResultExpression& each : expressions) names.push_back(each.column().name);
    return names;
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
        table.parameter = CycleTable::Parameter{shown_unit(values_), drawn};
    }

    Expected<void> each_row(const See& see, const Progress& progress) override {
        if (!has_rows) solve_all(progress);
        if (const auto beyond = beyond_work()) return refused(Diagnostic::Kind::bad_input, *beyond);
        if (table.rows.empty()) return tl::unexpected(diagnostics_of(fault_));
        if (wrong_columns_) return refused(Diagnostic::Kind::bad_input, *wrong_columns_);
        const std::vector<bool> none_empty(table.columns.size());
        for (const auto& row : table.rows) {
            const auto on_pole = empty_.find(row[0]), lacking = lacking_rows_.find(row[0]);
            const std::vector<bool>& empty = on_pole != empty_.end()          ? on_pole->second
                                             : lacking != lacking_rows_.end() ? lacking->second
                                                                              : none_empty;
            if (!see(row, empty)) break;
        }
        return {};
    }

    void write_before(JsonWriter& json) const override {
        json.member("parameter", table.driver).member("from", table.travel.from).member("to", table.travel.to);
    }
    void write_after(JsonWriter& json) const override { write_poles_and_separations(json); }
    std::vector<render::FilmFrame> film_frames(int /*count*/) const override { return {}; }
    std::vector<render::Way> finish_table() override {
        std::vector<std::size_t> plotted;
        for (const auto& plot : plots)
            for (const std::size_t column : plot)
                if (std::find(plotted.begin(), plotted.end(), column) == plotted.end()) plotted.push_back(column);
        if (const auto followed = curves_of(plotted)) {
            table.followed.columns.resize(table.columns.size());
            for (std::size_t i = 0; i < plotted.size(); ++i)
                table.followed.columns[plotted[i]] = followed->column(i, true);
        }
        return {};
    }

    std::optional<Words> beyond_work() const override {
        if (of_first_ * values_.count > app::most_work_of_values)
            return Words(lang::sweeps::over_takes_too_much, options_.dashes, std::to_string(values_.count),
                         std::to_string(app::most_work_of_values / of_first_));
        if (spent_ <= app::most_work_of_values) return std::nullopt;
        return Words(lang::sweeps::over_takes_too_much_between, options_.dashes);
    }
    std::vector<Words> summary() const override {
        std::vector<Words> lines;
        for (std::size_t i = 0; i < table.followed.columns.size(); ++i) {
            if (table.columns[i].quantity.kind != Quantity::Kind::effort || table.followed.columns[i].poles.empty())
                continue;
            Words places;
            for (const double at : table.followed.columns[i].poles) {
                if (!places.empty()) places += Words(std::string(", "));
                places += coordinate_text(at);
            }
            lines.emplace_back(lang::sweeps::effort_grows_without_limit, table.columns[i].name, places);
        }
        for (const Separation& each : table.followed.separations)
            lines.emplace_back(lang::sweeps::the_contact_can_only_push, mechanism.joint(each.joint).name,
                               coordinate_text(each.from), coordinate_text(each.to));
        if (left_out_.size() == 1)
            lines.emplace_back(lang::sweeps::n_1_row_is_left_out_where_the, table.driver, left_out_.front());
        else if (left_out_.size() > 1)
            lines.emplace_back(lang::sweeps::rows_are_left_out_where_the_file, std::to_string(left_out_.size()),
                               table.driver, left_out_.front(), left_out_.back());
        return lines;
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
        for (std::uint64_t i = 0; i < values_.count && !beyond_work(); ++i) {
            if (progress) progress(static_cast<long>(i), static_cast<long>(values_.count));
            is_checked_ = true;
            auto row = row_of(values_.value(i));
            is_checked_ = false;
            if (row) {
                pushes_.emplace(row->front(), here_pushing_);
                if (std::find(here_lacking_.begin(), here_lacking_.end(), true) != here_lacking_.end())
                    lacking_rows_.emplace(row->front(), here_lacking_);
                table.rows.push_back(*std::move(row));
            } else {
                left_out_.push_back(values_.value(i));
                table.left_out.push_back(si(i));
            }
        }
        has_rows = true;
        if (table.rows.empty() || beyond_work()) return;
        find_gaps();
        find_ends();
        find_poles_and_separations();
        put_rows_on_poles();
    }

    // --- between the rows; a value costs a solution, so the rows are the only samples

    std::string text_at(double at) const {
        return values_.text_of(Exact::from_double(at / table.parameter->unit.si.to_double()));
    }
    /// The row of any value of the parameter, SI.
    std::optional<std::vector<double>> row_at(double at) {
        stand_beside(at);
        return row_of(text_at(at));
    }
    /// Angles go on from those of the nearest row.
    void stand_beside(double at) {
        last_ = *std::min_element(table.rows.begin(), table.rows.end(), [&](const auto& a, const auto& b) {
            return std::abs(a[0] - at) < std::abs(b[0] - at);
        });
    }
    /// A value that is left out alone, with answers close to it on both sides, may be a pole; others are gaps.
    void find_gaps() {
        const double step = (table.travel.to - table.travel.from) / static_cast<double>(values_.count - 1);
        for (const double each : table.left_out) {
            constexpr double close = 1e-3;
            const bool is_first = std::abs(each - table.travel.from) < std::abs(step) / 2,
                       is_last = std::abs(each - table.travel.to) < std::abs(step) / 2;
            if (is_first || is_last || !row_at(each - close * step) || !row_at(each + close * step))
                gaps_.push_back(each);
        }
    }
    /// Where the file ceases to have an answer, results may grow without limit, as at the limit of a driver.
    void find_ends() {
        constexpr std::size_t most = 16;
        std::vector<double> rows;
        for (const auto& row : table.rows) rows.push_back(row[0]);
        ends_ = app::ends_of_answers(
            rows, gaps_, [this](double at) { return solved_with(text_at(at), true).has_value(); }, most);
    }
    void find_poles_and_separations() {
        std::vector<std::size_t> columns = columns_with_poles(table.columns, expressions_.size());
        const std::size_t everywhere = columns.size();
        for (std::size_t i = 1; !ends_.empty() && i < table.columns.size(); ++i)
            if (is_result(table.columns[i]) && !is_on_request(table.columns[i]) &&
                std::find(columns.begin(), columns.end(), i) == columns.end())
                columns.push_back(i);
        const auto followed = curves_of(columns);
        if (!followed) return;
        table.followed.columns.resize(table.columns.size());
        for (std::size_t i = 0; i < columns.size(); ++i)
            table.followed.columns[columns[i]] = i < everywhere ? followed->column(i, false) : followed->at_limits(i);
        for (std::size_t i = 0; i < contacts_.size(); ++i)
            for (const auto& [from, to] : followed->negative(columns.size() + i))
                table.followed.separations.push_back({contacts_[i].joint, from, to});
    }
    /// The columns, and behind them the forces with which contacts push; none where there are too few rows.
    std::optional<FollowedColumns> curves_of(const std::vector<std::size_t>& columns) {
        const auto wanted = [&](const std::vector<double>& row, const std::vector<double>& pushing) {
            FollowedCurve::Values found;
            for (const std::size_t i : columns) found.values.push_back(row[i]);
            found.values.insert(found.values.end(), pushing.begin(), pushing.end());
            return found;
        };
        const auto lacks = [&](const std::vector<bool>& lacking) {
            return std::any_of(columns.begin(), columns.end(), [&](std::size_t i) { return lacking[i]; });
        };
        const auto evaluate = [this, wanted, lacks](double at) -> std::optional<FollowedCurve::Values> {
            const auto row = row_at(at);
            return row && !lacks(here_lacking_) ? std::optional(wanted(*row, here_pushing_)) : std::nullopt;
        };
        std::vector<app::SampledRow> samples;
        for (const auto& row : table.rows)
            if (empty_.count(row[0]) == 0 && (lacking_rows_.count(row[0]) == 0 || !lacks(lacking_rows_.at(row[0]))))
                samples.push_back({row[0], wanted(row, pushes_.at(row[0]))});
        auto curves = app::curves_through(samples, gaps_, ends_, evaluate);
        if (curves.empty()) return std::nullopt;
        return FollowedColumns(std::move(curves));
    }
    /// A row that has no answer because some columns have a pole there: their cells are empty. Forces without a pole
    /// are interpolated from four values beside it; the rest is what the file gives there.
    void put_rows_on_poles() {
        const double travel = table.travel.to - table.travel.from;
        std::vector<std::vector<double>> found;
        for (std::size_t k = left_out_.size(); k-- > 0;) {
            const double at = table.left_out[k];
            std::vector<bool> empty(table.columns.size());
            for (std::size_t i = 0; i < table.followed.columns.size(); ++i)
                empty[i] = table.followed.columns[i].is_pole(at, travel);
            if (std::find(empty.begin(), empty.end(), true) == empty.end()) continue;
            std::vector<bool> missing(empty.size());
            stand_beside(at);
            auto row = row_of(left_out_[k], &missing);
            const auto beside = row ? interpolated(at, 1e-4 * travel) : std::nullopt;
            if (!beside) continue;
            for (std::size_t i = 0; i < row->size(); ++i) {
                if (empty[i] || missing[i]) (*row)[i] = empty[i] ? 0 : (*beside)[i];
            }
            empty_.emplace(row->front(), std::move(empty));
            found.push_back(*std::move(row));
            left_out_.erase(left_out_.begin() + static_cast<std::ptrdiff_t>(k));
            table.left_out.erase(table.left_out.begin() + static_cast<std::ptrdiff_t>(k));
        }
        for (auto& row : found) table.rows.push_back(std::move(row));
        std::sort(table.rows.begin(), table.rows.end(),
                  [&](const auto& a, const auto& b) { return travel > 0 ? a[0] < b[0] : a[0] > b[0]; });
    }
    std::optional<std::vector<double>> interpolated(double at, double step) {
        std::vector<double> sum(table.columns.size());
        for (const auto& [steps, share] : {std::pair(-2, -1), {-1, 4}, {1, 4}, {2, -1}}) {
            const auto row = row_at(at + steps * step);
            if (!row) return std::nullopt;
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * (*row)[i] / 6;
        }
        return sum;
    }

    /// Compares the row of a value with the check.
    void hold_against_check(const Solution& solution, const std::vector<double>& row,
                            const std::vector<bool>& lacking) {
        size_ = std::max(size_, solution.pose.size.to_double());
        for (std::size_t i = 1; i < table.columns.size(); ++i) {
            const Column& column = table.columns[i];
            if (i < lacking.size() && lacking[i]) continue;
            if (column.kind == Column::Kind::result)
                for (const CheckRow& each : solution.checks)
                    if (each.quantity == column.quantity || is_effort_by_work(each.quantity, column.quantity))
                        difference_.hold(i, column, row[i], each.numeric, row[0]);
            if (column.kind == Column::Kind::named && solution.problem)
                for (const ProblemValue& each : solution.problem->values)
                    if (each.key == column.name && each.numeric)
                        difference_.hold(i, column, row[i], *each.numeric, row[0]);
        }
    }

    /// The solution with one value; of `whole` ones everything is found.
    std::optional<Solution> solved_with(const std::string& value, bool whole) {
        const auto note = [&](Errors errors) {
            if (fault_.empty()) fault_ = std::move(errors);
            return std::nullopt;
        };
        std::vector<Setting> set = file_.set;
        std::erase_if(set, [&](const Setting& each) { return each.name == table.driver; });
        set.push_back({table.driver, value});
        if (beyond_work()) return std::nullopt;
        const std::size_t before = spent_;
        spent_ += app::work_of(file_.text.size(), mechanism);
        auto varied = read_mechanism(file_.text, file_.name, set);
        if (!varied) return note(varied.error());
        for (const Column& each : on_request_.columns)
            varied->find.curvature = varied->find.curvature || result_kind(each.quantity).is_of_curvature();
        auto solution = solve(*std::move(varied));
        if (!solution) return note(solution.error());
        spent_ += app::work_of(solution->protocol);
        if (of_first_ == 0) of_first_ = spent_ - before;
        if (!solution->unsolved.empty() && whole)
            return note({{ErrorCode::no_unique_answer, {}, {lang::sweeps::no_value_has_a_unique_answer}}});
        return *std::move(solution);
    }
    /// The results for one value; empty if there are none. With `missing`, by column whether it has no result, a part
    /// of them will do.
    std::optional<std::vector<double>> row_of(const std::string& value, std::vector<bool>* missing = nullptr) {
        const auto solution = solved_with(value, missing == nullptr);
        if (!solution) return std::nullopt;
        std::vector<NamedResult> results = named_results(*solution);
        std::erase_if(results, [](const NamedResult& each) { return is_modulus(each.column); });
        if (on_request_.has_least_transmission_angle)
            if (auto least = least_transmission_angle(*solution)) results.push_back(*std::move(least));
        if (table.columns.empty()) choose_columns(results);
        std::vector<double> row{si_of(*read_measured(value, {}))};
        std::vector<bool> lacking(table.columns.size());
        for (std::size_t i = 1; i < table.columns.size() - expressions_.size(); ++i) {
            const auto found = std::find_if(results.begin(), results.end(), [&](const NamedResult& each) {
                return each.column.name == table.columns[i].name;
            });
            if (found == results.end() && missing == nullptr && !is_on_request(table.columns[i])) return std::nullopt;
            if (found == results.end() && missing == nullptr) {
                lacking[i] = true;
                row.push_back(0);
                continue;
            }
            if (found == results.end()) {
                (*missing)[i] = true;
                row.push_back(0);
                continue;
            }
            row.push_back(table.columns[i].kind == Column::Kind::angle && !last_.empty()
                              ? angle_beside(found->value, last_[i])
                              : found->value);
        }
        if (missing == nullptr) {
            last_ = row;
            if (is_checked_) hold_against_check(*solution, row, lacking);
            here_pushing_.clear();
            for (const PushingContact& each : contacts_)
                here_pushing_.push_back(each.push(row, each.sense(solution->mechanism, solution->pose)));
        }
        row.resize(table.columns.size());
        std::vector<double> noise(row.size());
        lacking.resize(row.size());
        expressions_.fill(row, noise, lacking, solution->mechanism.parameters);
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (expressions_.is_undetermined(i) && missing == nullptr) {
                if (!expressions_.lacks_part(i, lacking)) return std::nullopt;
                lacking[i] = true;
            }
            if (missing != nullptr && (expressions_.is_undetermined(i) || expressions_.lacks_part(i, *missing)))
                (*missing)[i] = true;
        }
        here_lacking_ = missing == nullptr ? lacking : std::vector<bool>(row.size());
        return row;
    }
    void choose_columns(const std::vector<NamedResult>& results) {
        table.columns.push_back({Column::Kind::named, {}, table.driver, QuantityKind::dimensionless});
        for (const NamedResult& each : results)
            if (!is_on_request(each.column)) table.columns.push_back(each.column);
        const std::size_t usual = table.columns.size();
        for (const Column& each : on_request_.columns)
            if (is_on_request(each)) table.columns.push_back(each);
        table.columns.insert(table.columns.end(), on_request_.columns_of_defined.begin(),
                             on_request_.columns_of_defined.end());
        if (on_request_.has_least_transmission_angle) table.columns.push_back(transmission_column());
        contacts_ = pushing_contacts(mechanism, table.columns);
        const auto add = [this](const ResultExpression& expression) {
            return expressions_.add(expression, table.columns, mechanism.parameters);
        };
        if (const auto chosen = choose_shown(options_.columns, usual, operands_, add, options_.dashes); !chosen)
            wrong_columns_ = chosen.error();
        auto columns = app::plots_of(options_.plots, table.columns, operands_, add, options_.dashes);
        if (columns)
            plots = *std::move(columns);
        else if (!wrong_columns_)
            wrong_columns_ = columns.error();
    }
    /// Whether the rows have it only where it is asked for, and stay without it where it has no value.
    bool is_on_request(const Column& column) const {
        return result_kind(column.quantity).on_request || column.name == transmission_angle_name ||
               std::find(defined_.begin(), defined_.end(), column.name) != defined_.end();
    }

    SourceFile file_;
    SweepOptions options_;
    std::vector<std::string> defined_ = names_of(defined_results(mechanism));
    std::vector<Column> operands_ = operands_of_expressions(mechanism);
    app::ColumnsOnRequest on_request_ = app::columns_on_request(options_, mechanism, operands_);
    std::vector<bool> here_lacking_;  ///< by column: the last row has no value
    ExpressionColumns expressions_;
    std::optional<Words> wrong_columns_;
    Variation values_;
    LargestDifference difference_;
    double size_ = 0;           ///< of the largest drawing, m
    std::size_t spent_ = 0;     ///< work of all solutions, between the rows too
    std::size_t of_first_ = 0;  ///< that of the first one
    std::vector<double> last_;
    std::vector<std::string> left_out_;
    std::vector<double> gaps_;                   ///< left out, and no poles
    std::vector<app::AnswersEnd> ends_;          ///< between rows and gaps
    bool is_checked_ = false;                    ///< what is solved now is a row, not between rows
    std::map<double, std::vector<bool>> empty_;  ///< of rows on poles, by value: the columns without one
    std::map<double, std::vector<bool>>
        lacking_rows_;  ///< by its value, a row where results on request lack: by column
    std::vector<PushingContact> contacts_;
    std::vector<double> here_pushing_;              ///< their forces at the value solved last, N
    std::map<double, std::vector<double>> pushes_;  ///< the same of each row, by value
    Errors fault_;                                  ///< of the first value that fails
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
    if (const auto beyond = app::beyond_solving(file.mechanism)) return tl::unexpected(diagnostics_of({*beyond}));
    auto values = values_of(options);
    if (!values) return wrong(values.error());
    const std::string own(parameters[options.over].text());
    if (const Words why = of_another_kind(*values, own, options.dashes); !why.empty()) return wrong(why);
    return std::make_unique<ParameterSweep>(file, options, *std::move(values), drawn_value(file, options.over, own));
}

}  // namespace kinegraph
