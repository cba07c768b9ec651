// sweep FILE: the results in a sequence of positions, as rows that are written while they are computed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/commands/row_file.hpp"
#include "app/commands/sweep_centrodes.hpp"
#include "app/commands/sweep_drawing.hpp"
#include "app/commands/sweep_parameter.hpp"
#include "app/library/driver_choice.hpp"
#include "constructions/positions/cycle.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/sheet/cycle_sheet.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

/// The members of the JSON before its columns. `along`: the drivers that follow, each with its rate relative to the
/// driver.
std::string begun(const std::string& driver, const std::vector<std::pair<std::string, double>>& along,
                  const Travel& travel) {
    const auto limit = [](bool is_one, double at) { return is_one ? decimal_of(at) : std::string("null"); };
    std::string text = "\"driver\": " + in_json(driver);
    for (const auto& [name, per] : along)
        text += (&name == &along.front().first ? ",\n  \"along\": {" : ", ") + in_json(name) + ": " + decimal_of(per);
    text += (along.empty() ? ",\n  \"from\": " : "},\n  \"from\": ") + decimal_of(travel.from) +
            ",\n  \"to\": " + decimal_of(travel.to) + ",\n  \"limits\": [" +
            limit(travel.starts_at_limit, travel.from) + ", " + limit(travel.ends_at_limit, travel.to) +
            "],\n  \"change points\": [";
    for (std::size_t i = 0; i < travel.change_points.size(); ++i)
        text += (i > 0 ? ", " : "") + decimal_of(travel.change_points[i]);
    return text + "]";
}
/// The members after its rows. `centrodes`: JSON; empty: not requested.
std::string ended(const Cycle& cycle, const std::string& centrodes) {
    const Cycle::Difference off = cycle.difference();
    std::string text = "\"largest difference\": ";
    if (off.column < 0)
        text += "null";
    else
        text += "{\"column\": " + in_json(cycle.columns()[static_cast<std::size_t>(off.column)].name) +
                ", \"turn\": " + decimal_of(off.coordinate) + ", \"share\": " + decimal_of(off.share) + "}";
    return centrodes.empty() ? text : text + ",\n  \"centrodes\": " + centrodes;
}

/// The range and drivers of a sweep, checked against the mechanism.
struct AskedCourse {
    Course course;
    std::optional<Exact> from, to;  ///< coordinates, or times where the driver has a law
};

/// Adds the drivers that follow the first, each with its --step.
std::optional<Words> add_along(const SweepRequest& request, const Mechanism& mechanism, AskedCourse& asked) {
    const std::size_t more = request.drivers.empty() ? 0 : request.drivers.size() - 1;
    if (more != request.step.size())
        return Words(
            "--step is of a driver that goes along: each --driver after the first has one, in the same order ({0} and "
            "{1} "
            "are given; the number of steps is --steps)",
            "--step è di un movente che accompagna: ogni --driver dopo il primo ne ha uno, nello stesso ordine (ne "
            "sono "
            "dati {0} e {1}; il numero dei passi è --steps)",
            std::to_string(more), std::to_string(request.step.size()));
    if (more == 0) return std::nullopt;
    if (law_of(mechanism, asked.course.driver) != nullptr)
        return Words("--step: driver {0} has a law, and moves in steps of time",
                     "--step: il movente {0} ha una legge, e si muove a "
                     "passi di tempo",
                     name_of_driver(mechanism, asked.course.driver));
    const bool has_way = asked.to || turns(mechanism, asked.course.driver);
    if (!has_way)
        return Words("--step counts the steps of driver {0}; say how far it goes with --to",
                     "--step conta i passi del movente {0}; dire fin dove va con --to",
                     name_of_driver(mechanism, asked.course.driver));
    const Exact from = asked.from.value_or(0);
    const Exact way = asked.to ? *asked.to - from : 2 * pi();
    for (std::size_t i = 0; i < more; ++i) {
        const auto driver = driver_named(mechanism, request.drivers[i + 1]);
        if (!driver) return driver.error();
        const auto is_taken = [&](const Course::Along& each) { return each.driver == *driver; };
        if (*driver == asked.course.driver ||
            std::any_of(asked.course.along.begin(), asked.course.along.end(), is_taken))
            return Words("--driver {0} is given twice", "--driver {0} è dato due volte", request.drivers[i + 1]);
        const auto step = coordinate_of(mechanism, *driver, request.step[i]);
        if (!step) return std::string("--step ") + step.error();
        asked.course.along.push_back({*driver, *step * Exact::from_double(static_cast<double>(request.steps)) / way});
    }
    return std::nullopt;
}

tl::expected<AskedCourse, Words> asked_of(const SweepRequest& request, const Mechanism& mechanism) {
    AskedCourse asked;
    const auto driver = driver_named(mechanism, request.drivers.empty() ? "" : request.drivers.front());
    if (!driver) return tl::unexpected(driver.error());
    asked.course = course_of(*driver, request.branch);
    const bool has_law = law_of(mechanism, *driver) != nullptr;
    for (const auto& [text, option, value] :
         {std::tuple(&request.from, "--from ", &asked.from), std::tuple(&request.to, "--to ", &asked.to)}) {
        if (text->empty()) continue;
        const auto read = has_law ? time_of(*text) : coordinate_of(mechanism, *driver, *text);
        if (!read) return tl::unexpected(std::string(option) + read.error());
        *value = *read;
    }
    if (asked.from && asked.to && *asked.from == *asked.to)
        return tl::unexpected(Words("--from and --to are the same position; solve --at gives one",
                                    "--from e --to sono la stessa posizione; solve --at ne dà una"));
    if (request.steps < 2)
        return tl::unexpected(Words("--steps: at least 2 are needed", "--steps: ne occorrono almeno 2"));
    if (const auto wrong = add_along(request, mechanism, asked)) return tl::unexpected(*wrong);
    return asked;
}

/// Accumulates the mean and the extremes of an input force or couple over the rows.
class EffortSums {
public:
    /// The means are over column `over`: the driver's coordinate, or the time.
    EffortSums(const std::vector<Column>& columns, std::size_t over) : over_(over) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i].quantity.kind == Quantity::Kind::effort) sums_.push_back({i});
    }
    void take(std::span<const double> row) {
        for (Sum& sum : sums_) {
            const double value = row[sum.column];
            if (sum.rows > 0) {
                sum.integral += (value + sum.last) / 2 * (row[over_] - sum.last_at);
                sum.way += row[over_] - sum.last_at;
            }
            if (sum.rows == 0 || value < sum.least) sum.least = value, sum.least_at = row[over_];
            if (sum.rows == 0 || value > sum.most) sum.most = value, sum.most_at = row[over_];
            sum.last = value;
            sum.last_at = row[over_];
            ++sum.rows;
        }
    }
    /// A line each.
    template <class Place>
    std::vector<Words> told(const Cycle& cycle, const Mechanism& mechanism, Place place) const {
        std::vector<Words> lines;
        for (const Sum& sum : sums_) {
            if (sum.rows < 2) continue;
            const Column& column = cycle.columns()[sum.column];
            const Unit& unit = column.unit == QuantityKind::moment ? mechanism.units.moment : mechanism.units.force;
            const auto text = [&](double value) {
                std::array<char, 32> digits{};
                std::snprintf(digits.data(), digits.size(), "%.6g ", value / unit.si.to_double());
                return decimal(digits.data()) + unit.symbol;
            };
            const double rounding = 1e-9 * std::max(std::abs(sum.least), std::abs(sum.most)),
                         mean = sum.integral / sum.way;
            lines.emplace_back("{0}: mean {1}, least {2} at {3}, greatest {4} at {5}",
                               "{0}: media {1}, minimo {2} a {3}, massimo {4} a {5}", column.name,
                               text(std::abs(mean) < rounding ? 0 : mean), text(sum.least), place(sum.least_at),
                               text(sum.most), place(sum.most_at));
        }
        return lines;
    }

private:
    struct Sum {
        std::size_t column = 0;
        double integral = 0, way = 0, last = 0, last_at = 0, least = 0, most = 0, least_at = 0, most_at = 0;
        long rows = 0;
    };
    std::size_t over_;
    std::vector<Sum> sums_;
};

/// The messages at the end of a sweep.
class Report {
public:
    Report(const SweepRequest& request, const Mechanism& mechanism, const Course& course, const Travel& travel)
        : request_(request),
          mechanism_(mechanism),
          course_(course),
          driver_(course.driver),
          has_law_(travel.times.has_value()) {}

    void line(const Words& words) const { say(spoken(request_.file), words, request_.sheet.language); }
    void on_travel(const Travel& travel, const std::optional<Positions::BranchTaken>& branch) const {
        if (travel.starts_at_limit || travel.ends_at_limit)
            line({"driver {0} goes from {1} to {2}, {3}", "il movente {0} va da {1} a {2}, {3}",
                  name_of_driver(mechanism_, driver_), coordinate_text(mechanism_, driver_, travel.from),
                  coordinate_text(mechanism_, driver_, travel.to),
                  travel.starts_at_limit ? Words("its limits", "i suoi limiti") : Words("its limit", "il suo limite")});
        if (branch)
            line({"a change point is drawn: of its {0} branches number {1} is taken; --branch takes another",
                  "è disegnato un punto di biforcazione: dei suoi {0} rami si prende il numero {1}; --branch ne prende "
                  "un altro",
                  std::to_string(branch->of), std::to_string(branch->index + 1)});
        for (const double each : travel.change_points)
            if (!branch || each != 0)
                line({"a change point at {0}: the branch is a choice there; the one is taken that goes on smoothly",
                      "un punto di biforcazione a {0}: lì il ramo è una scelta; si prende quello che prosegue senza "
                      "salti",
                      coordinate_text(mechanism_, driver_, each, 1e-6)});
        if (travel.times)
            line({"driver {0} follows its law, from {1} to {2}", "il movente {0} segue la sua legge, da {1} a {2}",
                  name_of_driver(mechanism_, driver_), time_text(travel.times->first),
                  time_text(travel.times->second)});
        if (mechanism_.drivers.size() > 1 + course_.along.size())
            line({"the other drivers rest where they are drawn, with the rates of the file",
                  "gli altri moventi restano dove sono disegnati, con le velocità e accelerazioni del file"});
    }
    /// Reports the difference from the check, unless it is rounding.
    void on_difference(const Cycle& cycle) const {
        const Cycle::Difference off = cycle.difference();
        if (off.column < 0) return;
        std::array<char, 32> share{};
        std::snprintf(share.data(), share.size(), "%.1e", off.share);
        line({"largest difference from the numeric check: {0} of the largest of its kind ({1} at {2})",
              "massimo scarto dalla verifica numerica: {0} della grandezza maggiore del suo genere ({1} a {2})",
              decimal(share.data()), cycle.columns()[static_cast<std::size_t>(off.column)].name,
              coordinate_text(mechanism_, driver_, off.coordinate)});
    }
    void on_rows_left_out(long count, double first, double last) const {
        if (count == 1)
            line({"1 row is left out, where the mechanism gives no unique answer: {0}",
                  "1 riga è omessa, dove il meccanismo non dà una risposta unica: {0}", text(first)});
        if (count > 1)
            line({"{0} rows are left out, where the mechanism gives no unique answer; the first is {1}, the last {2}",
                  "{0} righe sono omesse, dove il meccanismo non dà una risposta unica; la prima è {1}, l’ultima {2}",
                  std::to_string(count), text(first), text(last)});
    }

    /// The position of a row: a coordinate, or a time.
    Words text(double at) const { return has_law_ ? time_text(at) : coordinate_text(mechanism_, driver_, at); }

private:
    const SweepRequest& request_;
    const Mechanism& mechanism_;
    const Course& course_;
    int driver_;
    bool has_law_;
};

/// The drawing of a run: its options, checked against the columns before the first row.
struct Drawing {
    std::vector<std::vector<std::size_t>> plots;
    std::vector<Trace> traces;
    CycleTable table;
    long stride = 1;  ///< keep only every stride-th row: more cannot be seen in a plot

    void keep(long i, double at, const std::optional<std::span<const double>>& row) {
        if (!row)
            table.left_out.push_back(at);
        else if (i % stride == 0)
            table.rows.emplace_back(row->begin(), row->end());
    }
};

class Sweep {
public:
    Sweep(const SweepRequest& request, const Mechanism& mechanism, Cycle cycle, Course course, Travel travel)
        : request_(request),
          mechanism_(mechanism),
          cycle_(std::move(cycle)),
          course_(std::move(course)),
          driver_(course_.driver),
          travel_(std::move(travel)) {}

    Status run(const std::vector<Target>& targets) {
        missing_ = cycle_.begin(travel_);
        const bool draws =
            std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
        if (const auto wrong = prepare_drawing(draws)) {
            say(spoken(request_.file), *wrong, language());
            return Status::bad_input;
        }
        if (const auto wrong = trace_all_centrodes()) {
            say(spoken(request_.file), *wrong, language());
            return Status::bad_input;
        }
        const auto theme = theme_of(request_.theme, request_.file, language());
        if (!theme) return theme.error();
        std::vector<RowFile> files;
        for (const Target& target : targets) {
            if (target.is_drawn()) continue;
            auto file = Growing::open(target.path);
            if (!file) return fail_to_write(file.error(), language());
            files.emplace_back(*std::move(file), target.format);
            files.back().head(cycle_.columns(), begun(name_of_driver(mechanism_, driver_), along(), travel_));
        }
        EffortSums efforts(cycle_.columns(), travel_.times ? 1 : 0);
        const auto fails = [&]() -> std::optional<NotWritten> {
            for (const RowFile& file : files)
                if (file.failure()) return file.failure();
            return std::nullopt;
        };
        if (!write_rows(files, efforts, draws, fails)) return fail_to_write(*fails(), language());
        const std::string centrodes = centrodes_.empty() ? "" : json_of(centrodes_, mechanism_);
        for (RowFile& file : files) file.tail(ended(cycle_, centrodes));
        if (const auto failure = fails()) return fail_to_write(*failure, language());
        std::vector<Output> outputs;
        for (RowFile& file : files) outputs.push_back(file.finish());
        if (draws)
            if (const auto status = draw(targets, *theme, outputs)) return *status;
        if (names_clash(outputs, request_.file, language())) return Status::bad_input;
        if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language());
        return report(efforts);
    }

private:
    Language language() const { return request_.sheet.language; }
    std::vector<std::pair<std::string, double>> along() const {
        std::vector<std::pair<std::string, double>> all;
        for (const Course::Along& each : course_.along)
            all.emplace_back(name_of_driver(mechanism_, each.driver), each.per.to_double());
        return all;
    }

    std::optional<Words> prepare_drawing(bool draws) {
        auto traces = traces_of(request_.traces, mechanism_);
        if (!traces) return traces.error();
        auto plots = plots_of(request_.plots, cycle_.columns());
        if (!plots) return plots.error();
        if (!draws && !(request_.plots.empty() && request_.traces.empty() && request_.poses == 0))
            remarks_.push_back(in({"--plot, --trace and --poses add to the drawing, and none is asked for",
                                   "--plot, --trace e --poses aggiungono al disegno, e nessuno è richiesto"},
                                  language()));
        drawing_.plots = *std::move(plots);
        drawing_.traces = *std::move(traces);
        drawing_.table.driver = name_of_driver(mechanism_, driver_);
        drawing_.table.turns = turns(mechanism_, driver_);
        drawing_.table.travel = travel_;
        drawing_.table.columns = cycle_.columns();
        constexpr long most_drawn = 3600;
        drawing_.stride = (request_.steps + most_drawn - 1) / most_drawn;
        return std::nullopt;
    }

    std::optional<Words> trace_all_centrodes() {
        const auto pairs = centrode_pairs_of(request_.centrodes, mechanism_);
        if (!pairs) return pairs.error();
        if (pairs->empty()) return std::nullopt;
        const auto pose = draw_pose(mechanism_);
        for (const auto& [first, second] : *pairs) {
            auto traced = trace_centrodes(mechanism_, *pose, driver_, travel_, first, second);
            const std::string names = mechanism_.body(first).name + "," + mechanism_.body(second).name;
            if (!traced || traced->branches.empty())
                remarks_.push_back(
                    in({"--centrodes {0}: the two bodies never turn against each other, or it is not determined how: "
                        "there are no centrodes",
                        "--centrodes {0}: i due corpi non ruotano mai l’uno rispetto all’altro, o non è determinato "
                        "come: non ci sono polari",
                        names},
                       language()));
            if (traced) centrodes_.push_back(*std::move(traced));
        }
        return std::nullopt;
    }

    /// False: a file could not be written.
    template <class Fails>
    bool write_rows(std::vector<RowFile>& files, EffortSums& efforts, bool draws, Fails fails) {
        Progress progress(request_.steps);
        for (long i = 0; i <= request_.steps; ++i) {
            progress.at(i);
            const double share = static_cast<double>(i) / static_cast<double>(request_.steps);
            const double at = travel_.at(share);
            // At a limit position the rates of the driver are not defined.
            if ((i == 0 && travel_.starts_at_limit) || (i == request_.steps && travel_.ends_at_limit)) {
                if (draws)
                    drawing_.table.limits.push_back(
                        cycle_.at_limit(at, (i == 0 ? 1 : -1) * (travel_.to - travel_.from)));
                continue;
            }
            const auto row = cycle_.row(at);
            if (draws) drawing_.keep(i, at, row);
            if (row) {
                efforts.take(*row);
                for (RowFile& file : files) file.row(*row);
            } else {
                if (left_out_++ == 0) first_left_out_ = at;
                last_left_out_ = at;
            }
            if (fails()) return false;
        }
        return true;
    }

    /// Adds the sheets; a status after an error was reported.
    std::optional<Status> draw(const std::vector<Target>& targets, const render::Theme& theme,
                               std::vector<Output>& outputs) {
        Mechanism plain = mechanism_;
        plain.find = {};
        plain.find.stated = plain.find.velocity = true;
        auto drawn = solve(std::move(plain));
        if (!drawn) return say(spoken(request_.file), drawn.error(), language());
        drawing_.table.transmission = transmission_of(mechanism_, cycle_.positions(), driver_, travel_);
        const auto press =
            OutputWriter::open(targets, language(), request_.live_text ? Lettering::live : Lettering::outlines);
        if (!press) return press.error();
        render::SheetOptions options = request_.sheet;
        options.theme = theme;
        std::vector<render::Way> ways =
            ways_of(mechanism_, cycle_.positions(), travel_, request_.poses, drawing_.traces);
        for (const Centrodes& each : centrodes_) add_ways(each, mechanism_, ways);
        const auto pages = render::lay_out_cycle(*drawn, drawing_.table, drawing_.plots, ways, options, press->fonts());
        for (const Target& target : targets)
            if (target.is_drawn()) press->print(pages, target, request_.dpi, outputs, remarks_);
        press->remark_missing(remarks_);
        return std::nullopt;
    }

    Status report(const EffortSums& efforts) const {
        const Report report(request_, mechanism_, course_, travel_);
        const auto tell_of = [&](const char* kind, const std::string& line) {
            report.line(render::word(kind, language()) + ": " + line);
        };
        for (const std::string& remark : remarks_) tell_of("a remark", remark);
        report.on_travel(travel_, cycle_.positions().branch());
        for (const Words& line : efforts.told(cycle_, mechanism_, [&](double at) { return report.text(at); }))
            report.line(line);
        report.on_rows_left_out(left_out_, first_left_out_, last_left_out_);
        report.on_difference(cycle_);
        const auto tell = [&](const Message& message) { return render::tell(message, language()); };
        for (const Unsolved& unsolved : missing_)
            tell_of("one unsolved", tell(unsolved.what) + ": " + tell(unsolved.why));
        return left_out_ == 0 && missing_.empty() ? Status::done : Status::unsolved;
    }

    const SweepRequest& request_;
    const Mechanism& mechanism_;
    Cycle cycle_;
    Course course_;
    int driver_;
    Travel travel_;
    Drawing drawing_;
    std::vector<Centrodes> centrodes_;
    std::vector<Unsolved> missing_;
    std::vector<std::string> remarks_;
    long left_out_ = 0;
    double first_left_out_ = 0, last_left_out_ = 0;
};

/// The range of the travel, or why it is impossible.
tl::expected<Travel, Words> travel_asked(const Positions& positions, const Mechanism& mechanism,
                                         const AskedCourse& asked) {
    const int driver = asked.course.driver;
    const auto in_doubles = [](const std::optional<Exact>& value) {
        return value ? std::optional(value->to_double()) : std::nullopt;
    };
    const std::optional<double> from = in_doubles(asked.from), to = in_doubles(asked.to);
    const Law* law = law_of(mechanism, driver);
    const auto travel = law != nullptr ? travel_of_law(positions, *law, from, to)
                                       : travel_of(positions, turns(mechanism, driver), from, to);
    if (travel) return *travel;
    const TravelFault& fault = travel.error();
    const std::string name = name_of_driver(mechanism, driver);
    if (!fault.limit)
        return tl::unexpected(Words("driver {0} has no limit; give --from and --to",
                                    "il movente {0} non ha limiti; dare --from e --to", name));
    return tl::unexpected(out_of_reach(coordinate_text(mechanism, driver, fault.wanted), name,
                                       coordinate_text(mechanism, driver, *fault.limit)));
}

}  // namespace

Status sweep_command(const SweepRequest& request) {
    const Words name = spoken(request.file);
    const Language language = request.sheet.language;
    const auto wrong = [&](const Words& why) {
        say(name, why, language);
        return Status::bad_input;
    };
    if (!request.over.empty()) return sweep_parameter(request);
    constexpr std::array formats{Format::csv, Format::json, Format::svg, Format::png, Format::pdf, Format::tex};
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    const auto mechanism = mechanism_of(request.file, language, request.set);
    if (!mechanism) return mechanism.error();
    if (stands_for_joints(*mechanism)) return wrong(no_mechanism("sweep"));
    const auto asked = asked_of(request, *mechanism);
    if (!asked) return wrong(asked.error());
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(name, pose.error(), language);
    auto cycle = Cycle::of(*mechanism, *pose, asked->course);
    if (!cycle) return say(name, cycle.error(), language);
    const auto travel = travel_asked(cycle->positions(), *mechanism, *asked);
    if (!travel) return wrong(travel.error());
    return Sweep(request, *mechanism, *std::move(cycle), asked->course, *travel).run(*targets);
}

}  // namespace kinegraph::app
