// sweep FILE --over r: see sweep_parameter.hpp.
#include "app/commands/sweep_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "app/commands/outputs.hpp"
#include "app/commands/row_file.hpp"
#include "app/commands/sweep_drawing.hpp"
#include "app/library/driver_choice.hpp"
#include "constructions/positions/named_results.hpp"
#include "constructions/solving/solve.hpp"
#include "constructions/verdicts/largest_difference.hpp"
#include "engine/file/spelling.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/results/result_names.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/sheet/cycle_sheet.hpp"

namespace kinegraph::app {
namespace {

/// The value in SI, but angles in degrees, as formulas use them.
double si_of(const Measured& value) {
    return value.value.to_double() * std::pow(std::numbers::pi / 180, value.dimension.angle);
}

tl::expected<Measured, Words> value_of(const std::string& option, const std::string& text) {
    if (text.empty()) return tl::unexpected(Words("--over wants --from and --to", "--over vuole --from e --to"));
    auto read = is_formula(text) ? tl::expected<Measured, Words>(tl::unexpected(Words(
                                       "a value is wanted here, no formula", "qui serve un valore, non una formula")))
                                 : read_measured(text, {});
    if (read) return *std::move(read);
    return tl::unexpected(option + std::string(": ") + read.error());
}

/// The values of the parameter, as settings. The last one does not exceed `to`.
tl::expected<Variation, Words> values_of(const SweepRequest& request) {
    constexpr int most = 1'000'000;
    const auto from = value_of("--from", request.from), to = value_of("--to", request.to);
    if (!from) return tl::unexpected(from.error());
    if (!to) return tl::unexpected(to.error());
    std::optional<Measured> step;
    if (!request.step.empty()) {
        auto read = value_of("--step", request.step.front());
        if (!read) return tl::unexpected(read.error());
        step = *std::move(read);
    }
    for (const Measured* other : {&*to, step ? &*step : &*to})
        if (other->is_bare != from->is_bare || !(other->dimension == from->dimension))
            return tl::unexpected(Words("--from is {0}, and --to or --step is {1}",
                                        "--from è {0}, e --to o --step è {1}", described(*from), described(*other)));
    const Exact way = to->value - from->value;
    if (way.is_zero())
        return tl::unexpected(Words("--from and --to are the same; solve --set gives one value",
                                    "--from e --to sono uguali; solve --set dà un valore solo"));
    if (!step && (request.steps < 1 || request.steps > most))
        return tl::unexpected(Words("--steps: 1 to {0}", "--steps: da 1 a {0}", std::to_string(most)));
    const Exact each = step ? step->value : way / Exact::ratio(request.steps, 1);
    const Exact count = each.is_zero() ? Exact(-1) : way / each;
    if (count.sign() < 0)
        return tl::unexpected(Words("--step {0} does not lead from --from to --to",
                                    "--step {0} non porta da --from a --to", request.step.front()));
    if (count > Exact(most))
        return tl::unexpected(Words("--step: more than {0} values; take a larger step",
                                    "--step: più di {0} valori; prendere un passo più grande", std::to_string(most)));
    Variation values;
    values.parameter = request.over;
    values.count =
        static_cast<std::uint64_t>(mpz_class(count.rational().get_num() / count.rational().get_den()).get_ui()) + 1;
    Exact unit = 1;
    if (!from->is_bare) {
        values.unit = read_quantity(request.from, QuantityKind::dimensionless)->unit->symbol;
        unit = read_measured("1 " + values.unit, {})->value;
    }
    values.from = from->value / unit;
    values.step = each / unit;
    return values;
}

class ParameterSweep {
public:
    ParameterSweep(const SweepRequest& request, std::string text, Mechanism own, Variation values,
                   std::optional<double> drawn)
        : request_(request), text_(std::move(text)), own_(std::move(own)), values_(std::move(values)), drawn_(drawn) {}

    Status run(const std::vector<Target>& targets) {
        Progress progress(static_cast<long>(values_.count));
        std::vector<std::vector<double>> rows;
        for (std::uint64_t i = 0; i < values_.count; ++i) {
            progress.at(static_cast<long>(i));
            if (auto row = row_of(values_.value(i)))
                rows.push_back(*std::move(row));
            else
                left_out_.push_back(values_.value(i));
        }
        if (rows.empty()) return say(spoken(request_.file), fault_, language());
        const auto plots = plots_of(request_.plots, columns_);
        if (!plots) {
            say(spoken(request_.file), plots.error(), language());
            return Status::bad_input;
        }
        std::vector<Output> outputs;
        for (const Target& target : targets) {
            if (target.is_drawn()) continue;
            if (const auto failure = write_rows(target, rows, outputs)) return fail_to_write(*failure, language());
        }
        const bool draws =
            std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
        if (draws) {
            if (const auto status = draw(targets, std::move(rows), *plots, outputs)) return *status;
        } else if (!request_.plots.empty()) {
            remarks_.push_back(in({"--plot adds to the drawing, and none is asked for",
                                   "--plot aggiunge al disegno, e nessuno è richiesto"},
                                  language()));
        }
        if (names_clash(outputs, request_.file, language())) return Status::bad_input;
        if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language());
        return report();
    }

private:
    Language language() const { return request_.sheet.language; }
    double si(std::uint64_t i) const { return si_of(*read_measured(values_.value(i), {})); }

    std::optional<NotWritten> write_rows(const Target& target, const std::vector<std::vector<double>>& rows,
                                         std::vector<Output>& outputs) const {
        auto growing = Growing::open(target.path);
        if (!growing) return growing.error();
        RowFile file(*std::move(growing), target.format);
        file.head(columns_, "\"parameter\": " + in_json(request_.over) + ",\n  \"from\": " + decimal_of(si(0)) +
                                ",\n  \"to\": " + decimal_of(si(values_.count - 1)));
        for (const auto& row : rows) file.row(row);
        const LargestDifference::Found off = difference_.found(columns_, size_);
        file.tail("\"largest difference\": " +
                  (off.column < 0 ? std::string("null")
                                  : "{\"column\": " + in_json(columns_[at_index(off.column)].name) + ", \"value\": " +
                                        decimal_of(off.coordinate) + ", \"share\": " + decimal_of(off.share) + "}"));
        if (file.failure()) return file.failure();
        outputs.push_back(file.finish());
        return std::nullopt;
    }

    /// The unit of the first value, with its factor to SI.
    Unit told_unit() const {
        if (values_.unit.empty()) return {"", 1};
        const KnownUnit* known = unit_spelt(values_.unit);
        return {known->symbol == "deg" ? "°" : std::string(known->symbol), known->si};
    }
    /// Adds the sheets; a status after an error was reported.
    std::optional<Status> draw(const std::vector<Target>& targets, std::vector<std::vector<double>> rows,
                               const std::vector<std::vector<std::size_t>>& plots, std::vector<Output>& outputs) {
        Mechanism plain = own_;
        plain.find = {};
        plain.find.stated = plain.find.velocity = true;
        const auto drawn = solve(std::move(plain));
        if (!drawn) return say(spoken(request_.file), drawn.error(), language());
        const auto theme = theme_of(request_.theme, request_.file, language());
        if (!theme) return theme.error();
        const auto press =
            OutputWriter::open(targets, language(), request_.live_text ? Lettering::live : Lettering::outlines);
        if (!press) return press.error();
        CycleTable table;
        table.driver = request_.over;
        table.turns = false;
        table.travel.from = si(0);
        table.travel.to = si(values_.count - 1);
        table.columns = columns_;
        table.rows = std::move(rows);
        for (const std::string& each : left_out_) table.left_out.push_back(si_of(*read_measured(each, {})));
        table.parameter = CycleTable::Parameter{told_unit(), drawn_};
        render::SheetOptions options = request_.sheet;
        options.theme = *theme;
        const auto pages = render::lay_out_cycle(*drawn, table, plots, {}, options, press->fonts());
        for (const Target& target : targets)
            if (target.is_drawn()) press->print(pages, target, request_.dpi, outputs, remarks_);
        press->remark_missing(remarks_);
        return std::nullopt;
    }

    /// The column of an input force may contain the value by virtual work if there are no reactions.
    static bool is_effort_by_work(const Quantity& held, const Quantity& column) {
        return held.kind == Quantity::Kind::virtual_effort && column.kind == Quantity::Kind::effort &&
               held.given == column.given;
    }
    /// Compares the row of a value with the check.
    void hold_against_check(const Solution& solution, const std::vector<double>& row) {
        size_ = std::max(size_, solution.pose.size.to_double());
        for (std::size_t i = 1; i < columns_.size(); ++i) {
            const Column& column = columns_[i];
            if (column.kind == Column::Kind::result)
                for (const CheckRow& each : solution.checks)
                    if (each.quantity == column.quantity || is_effort_by_work(each.quantity, column.quantity))
                        difference_.hold(i, column, row[i], each.numeric, row[0]);
            if (column.kind == Column::Kind::named && solution.problem)
                for (const ProblemValue& each : solution.problem->values)
                    if (each.name.en == column.name && each.numeric)
                        difference_.hold(i, column, row[i], *each.numeric, row[0]);
        }
    }

    /// The results for one value; empty if there are none.
    std::optional<std::vector<double>> row_of(const std::string& value) {
        const auto note = [&](Errors errors) {
            if (fault_.empty()) fault_ = std::move(errors);
            return std::nullopt;
        };
        std::vector<Setting> set = request_.set;
        std::erase_if(set, [&](const Setting& each) { return each.name == request_.over; });
        set.push_back({request_.over, value});
        auto mechanism = read_mechanism(text_, bare_name(request_.file), set);
        if (!mechanism) return note(mechanism.error());
        auto solution = solve(*std::move(mechanism));
        if (!solution) return note(solution.error());
        if (!solution->unsolved.empty())
            return note({{ErrorCode::no_unique_answer,
                          {},
                          {"no value has a unique answer", "nessun valore ha una risposta unica"}}});
        std::vector<NamedResult> results = named_results(*solution);
        std::erase_if(results, [](const NamedResult& each) { return is_modulus(each.column); });
        if (columns_.empty()) choose_columns(results);
        std::vector<double> row{si_of(*read_measured(value, {}))};
        for (std::size_t i = 1; i < columns_.size(); ++i) {
            const auto found = std::find_if(results.begin(), results.end(), [&](const NamedResult& each) {
                return each.column.name == columns_[i].name;
            });
            if (found == results.end()) return std::nullopt;
            row.push_back(columns_[i].kind == Column::Kind::angle && !last_.empty() ? beside(found->value, last_[i])
                                                                                    : found->value);
        }
        last_ = row;
        hold_against_check(*solution, row);
        return row;
    }
    void choose_columns(const std::vector<NamedResult>& results) {
        columns_.push_back({Column::Kind::named, {}, request_.over, QuantityKind::dimensionless});
        for (const NamedResult& each : results) columns_.push_back(each.column);
    }
    /// The same angle, within half a turn of the one before.
    static double beside(double angle, double before) {
        constexpr double turn = 2 * std::numbers::pi;
        return angle + turn * std::round((before - angle) / turn);
    }

    void line(const Words& words) const { say(spoken(request_.file), words, language()); }
    Status report() const {
        for (const std::string& remark : remarks_) line(render::word("a remark", language()) + ": " + remark);
        if (left_out_.size() == 1)
            line({"1 row is left out, where the file gives no unique answer: {0} = {1}",
                  "1 riga è omessa, dove il file non dà una risposta unica: {0} = {1}", request_.over,
                  left_out_.front()});
        if (left_out_.size() > 1)
            line({"{0} rows are left out, where the file gives no unique answer: {1} = {2} … {3}",
                  "{0} righe sono omesse, dove il file non dà una risposta unica: {1} = {2} … {3}",
                  std::to_string(left_out_.size()), request_.over, left_out_.front(), left_out_.back()});
        report_difference();
        return left_out_.empty() ? Status::done : Status::unsolved;
    }
    void report_difference() const {
        const LargestDifference::Found off = difference_.found(columns_, size_);
        if (off.column < 0) return;
        const Unit unit = told_unit();
        std::array<char, 32> share{}, value{};
        std::snprintf(share.data(), share.size(), "%.1e", off.share);
        std::snprintf(value.data(), value.size(), "%.6g", off.coordinate / unit.si.to_double());
        const bool is_close = unit.symbol.empty() || unit.symbol == "°";
        line({"largest difference from the numeric check: {0} of the largest of its kind ({1} at {2})",
              "massimo scarto dalla verifica numerica: {0} della grandezza maggiore del suo genere ({1} a {2})",
              decimal(share.data()), columns_[at_index(off.column)].name,
              request_.over + std::string(" = ") + decimal(value.data()) +
                  (std::string(is_close ? "" : " ") + unit.symbol)});
    }

    const SweepRequest& request_;
    std::string text_;
    Mechanism own_;  ///< with the values of the file
    Variation values_;
    std::optional<double> drawn_;  ///< the parameter's value in the file, SI; empty: a formula gives it
    LargestDifference difference_;
    double size_ = 0;  ///< of the largest drawing, m
    std::vector<std::string> remarks_;
    std::vector<Column> columns_;
    std::vector<double> last_;
    std::vector<std::string> left_out_;
    Errors fault_;  ///< of the first value that fails
};

/// Why the parameter cannot have these values; empty if it can, or if a formula gives it.
Words of_another_kind(const Variation& values, JsonValue parameter) {
    if (is_formula(parameter.text())) return {};
    const auto own = read_measured(parameter.text(), {}), given = read_measured(values.value(0), {});
    if (own->is_bare == given->is_bare && own->dimension == given->dimension) return {};
    return {"--from is {0}; the parameter {1} is {2}", "--from è {0}; il parametro {1} è {2}", described(*given),
            values.parameter, described(*own)};
}

/// Why a parameter cannot be swept; empty if it can.
Words meaningless_sweep(const SweepRequest& request, JsonValue parameters) {
    if (!request.drivers.empty() || request.branch != 0 || !request.traces.empty() || !request.centrodes.empty() ||
        request.poses != 0)
        return {
            "--over moves no driver: --driver, --branch, --trace, --centrodes and --poses do not go with it",
            "--over non muove nessun movente: --driver, --branch, --trace, --centrodes e --poses non vanno con esso"};
    if (request.step.size() > 1) return {"--step is given twice", "--step è dato due volte"};
    std::vector<std::string_view> names;
    if (parameters && parameters.is_object())
        for (const JsonValue each : parameters) names.push_back(each.key());
    if (std::find(names.begin(), names.end(), request.over) != names.end()) return {};
    return {"--over {0}: the file has no parameter named {0}{1}", "--over {0}: il file non ha un parametro {0}{1}",
            quoted(request.over), did_you_mean(Speller().nearest(request.over, names))};
}

/// The parameter's own value, SI: that of --set, else of the file; empty if a formula gives it.
std::optional<double> drawn_value(const SweepRequest& request, const JsonSource& source) {
    std::string text(source.root()["parameters"][request.over].text());
    for (const Setting& each : request.set)
        if (each.name == request.over) text = each.value;
    if (is_formula(text)) return std::nullopt;
    const auto own = read_measured(text, {});
    return own ? std::optional(si_of(*own)) : std::nullopt;
}

}  // namespace

Status sweep_parameter(const SweepRequest& request) {
    const Language language = request.sheet.language;
    constexpr std::array formats{Format::csv, Format::json, Format::svg, Format::png, Format::pdf, Format::tex};
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    auto text = read_whole(request.file, {"mechanism file", "file di meccanismo"});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return Status::bad_input;
    }
    // Faults of the file itself are reported first.
    auto own = read_mechanism(*text, bare_name(request.file), request.set);
    if (!own) return say(spoken(request.file), own.error(), language);
    const bool draws =
        std::any_of(targets->begin(), targets->end(), [](const Target& target) { return target.is_drawn(); });
    if (draws && stands_for_joints(*own)) {
        say(spoken(request.file),
            Words("plots are of a mechanism; of this problem ask for CSV or JSON",
                  "i diagrammi sono di un meccanismo; di questo problema chiedere CSV o JSON"),
            language);
        return Status::bad_input;
    }
    const auto source = JsonSource::read(*text);
    if (const Words why = meaningless_sweep(request, source->root()["parameters"]); !why.empty())
        return refuse(why, language);
    auto values = values_of(request);
    if (!values) return refuse(values.error(), language);
    if (const Words why = of_another_kind(*values, source->root()["parameters"][request.over]); !why.empty())
        return refuse(why, language);
    return ParameterSweep(request, *std::move(text), *std::move(own), *std::move(values), drawn_value(request, *source))
        .run(*targets);
}

}  // namespace kinegraph::app
