// sweep FILE: the results in one position after another, as rows that are written while they are found.
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/commands.hpp"
#include "app/driver_choice.hpp"
#include "app/outputs.hpp"
#include "constructions/cycle.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

void append(std::string& text, double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value);
    text.append(digits.data(), end.ptr);
}

std::string in_quotes(const std::string& name, const char* quote) {
    std::string text = "\"";
    for (const char c : name) {
        if (c == '"') text += quote;
        if (c == '\\' && *quote == '\\') text += '\\';
        text += c;
    }
    return text + '"';
}

/// The rows of a cycle in the form of a file.
class RowFile {
public:
    RowFile(Growing file, Format format) : file_(std::move(file)), format_(format) {}

    void head(const std::vector<Column>& columns, const std::string& driver, const Travel& travel) {
        if (format_ == Format::json) {
            text_ = "{\n  \"driver\": " + in_quotes(driver, "\\") + ",\n  \"from\": ";
            append(text_, travel.from);
            text_ += ",\n  \"to\": ";
            append(text_, travel.to);
            text_ += ",\n  \"limits\": [" + limit(travel.starts_at_limit, travel.from) + ", " +
                     limit(travel.ends_at_limit, travel.to) + "],\n  \"change points\": [";
            for (std::size_t i = 0; i < travel.change_points.size(); ++i) {
                if (i > 0) text_ += ", ";
                append(text_, travel.change_points[i]);
            }
            text_ += "],\n  \"columns\": [";
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (i > 0) text_ += format_ == Format::json ? ", " : ",";
            const bool plain = format_ == Format::csv && columns[i].name.find('"') == std::string::npos;
            text_ += plain ? columns[i].name : in_quotes(columns[i].name, format_ == Format::json ? "\\" : "\"");
        }
        text_ += format_ == Format::json ? "],\n  \"rows\": [" : "\n";
    }
    void row(std::span<const double> values) {
        if (format_ == Format::json) text_ += rows_++ == 0 ? "\n    [" : ",\n    [";
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0) text_ += format_ == Format::json ? ", " : ",";
            append(text_, values[i]);
        }
        text_ += format_ == Format::json ? "]" : "\n";
        constexpr std::size_t at_a_time = 1 << 16;
        if (text_.size() > at_a_time) flush();
    }
    void tail(const Cycle& cycle) {
        if (format_ == Format::json) {
            text_ += rows_ == 0 ? "],\n  \"largest difference\": " : "\n  ],\n  \"largest difference\": ";
            const Cycle::Difference off = cycle.difference();
            if (off.column < 0) {
                text_ += "null";
            } else {
                text_ += "{\"column\": " + in_quotes(cycle.columns()[static_cast<std::size_t>(off.column)].name, "\\") +
                         ", \"turn\": ";
                append(text_, off.coordinate);
                text_ += ", \"share\": ";
                append(text_, off.share);
                text_ += "}";
            }
            text_ += "\n}\n";
        }
        flush();
    }
    bool is_whole() const { return why_.empty(); }
    const std::string& why() const { return why_; }
    Output finish() { return std::move(file_).finish(); }

private:
    static std::string limit(bool is_one, double at) {
        std::string text;
        if (is_one) append(text, at);
        return is_one ? text : "null";
    }
    void flush() {
        if (why_.empty() && !file_.add(text_)) why_ = std::strerror(errno);
        text_.clear();
    }

    Growing file_;
    Format format_;
    std::string text_, why_;
    long rows_ = 0;
};

/// On a terminal, once it takes over a second.
class Progress {
public:
    explicit Progress(long all) : all_(all), shows_(::isatty(STDERR_FILENO) != 0) {}
    ~Progress() {
        if (shown_) std::fputs("\r     \r", stderr);
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void at(long done) {
        constexpr long seldom = 512;
        if (!shows_ || done % seldom != 0) return;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_) return;
        next_ = now + std::chrono::milliseconds(200);
        shown_ = true;
        std::fprintf(stderr, "\r%3ld %%", 100 * done / all_);
    }

private:
    long all_;
    bool shows_, shown_ = false;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

/// What a sweep is asked for, read against the mechanism.
struct Asked {
    int driver = 0;
    std::optional<double> from, to;
};
tl::expected<Asked, std::string> asked_of(const SweepRequest& request, const Mechanism& mechanism) {
    Asked asked;
    const auto driver = driver_named(mechanism, request.driver);
    if (!driver) return tl::unexpected(driver.error());
    asked.driver = *driver;
    for (const auto& [text, option, value] :
         {std::tuple(&request.from, "--from ", &asked.from), std::tuple(&request.to, "--to ", &asked.to)}) {
        if (text->empty()) continue;
        const auto read = coordinate_of(mechanism, *driver, *text);
        if (!read) return tl::unexpected(option + read.error());
        *value = read->to_double();
    }
    if (asked.from && asked.to && *asked.from == *asked.to)
        return tl::unexpected(std::string("--from and --to are the same position; solve --at gives one"));
    if (request.steps < 2) return tl::unexpected(std::string("--steps: at least 2 are needed"));
    return asked;
}

/// Sums over the rows of an effort: its mean and extremes.
class EffortSums {
public:
    explicit EffortSums(const std::vector<Column>& columns) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i].quantity.kind == Quantity::Kind::effort) sums_.push_back({i});
    }
    void take(std::span<const double> row) {
        for (Sum& sum : sums_) {
            const double value = row[sum.column];
            if (sum.rows > 0) {
                sum.integral += (value + sum.last) / 2 * (row[0] - sum.last_turn);
                sum.way += row[0] - sum.last_turn;
            }
            if (sum.rows == 0 || value < sum.least) sum.least = value, sum.least_at = row[0];
            if (sum.rows == 0 || value > sum.most) sum.most = value, sum.most_at = row[0];
            sum.last = value;
            sum.last_turn = row[0];
            ++sum.rows;
        }
    }
    void say_all(const std::string& name, const Cycle& cycle, const Mechanism& mechanism, int driver) const {
        for (const Sum& sum : sums_) {
            if (sum.rows < 2) continue;
            const Column& column = cycle.columns()[sum.column];
            const Unit& unit = column.unit == QuantityKind::moment ? mechanism.units.moment : mechanism.units.force;
            const auto told = [&](double value) {
                std::array<char, 32> text{};
                std::snprintf(text.data(), text.size(), "%.6g ", value / unit.si.to_double());
                return text.data() + unit.symbol;
            };
            say(name, column.name + ": mean " + told(sum.integral / sum.way) + ", least " + told(sum.least) + " at " +
                          coordinate_text(mechanism, driver, sum.least_at) + ", greatest " + told(sum.most) + " at " +
                          coordinate_text(mechanism, driver, sum.most_at));
        }
    }

private:
    struct Sum {
        std::size_t column = 0;
        double integral = 0, way = 0, last = 0, last_turn = 0, least = 0, most = 0, least_at = 0, most_at = 0;
        long rows = 0;
    };
    std::vector<Sum> sums_;
};

/// What is said of a sweep when it is done.
class Report {
public:
    Report(const std::string& name, const Mechanism& mechanism, int driver)
        : name_(name), mechanism_(mechanism), driver_(driver) {}

    void on_travel(const Travel& travel) const {
        if (travel.starts_at_limit || travel.ends_at_limit)
            say(name_, "driver " + name_of_driver(mechanism_, driver_) + " goes from " + text(travel.from) + " to " +
                           text(travel.to) + (travel.starts_at_limit ? ", its limits" : ", its limit"));
        for (const double each : travel.change_points)
            say(name_, "a change point at " + coordinate_text(mechanism_, driver_, each, 1e-6) +
                           ": the branch is a choice there; the one is taken that goes on smoothly");
        if (mechanism_.drivers.size() > 1) say(name_, "the other drivers rest where they are drawn, with the rates of the file");
    }
    /// True: differences as rounding leaves them.
    void on_difference(const Cycle& cycle) const {
        const Cycle::Difference off = cycle.difference();
        if (off.column < 0) return;
        std::array<char, 32> share{};
        std::snprintf(share.data(), share.size(), "%.1e", off.share);
        say(name_, std::string("largest difference from the numeric check: ") + share.data() + " of the largest of its kind (" +
                       cycle.columns()[static_cast<std::size_t>(off.column)].name + " at " + text(off.coordinate) + ")");
    }
    void on_rows_left_out(long count, double first, double last) const {
        if (count == 0) return;
        say(name_, std::to_string(count) + (count == 1 ? " row is" : " rows are") +
                       " left out, where the mechanism gives no unique answer: " + text(first) +
                       (count > 1 ? " … " + text(last) : std::string()));
    }

private:
    std::string text(double coordinate) const { return coordinate_text(mechanism_, driver_, coordinate); }
    const std::string& name_;
    const Mechanism& mechanism_;
    int driver_;
};

Status cannot_write(const NotWritten& failure) {
    say(failure.path == "-" ? "standard output" : failure.path, "cannot be written: " + failure.why);
    return Status::output;
}

/// The rows, found one by one and written to all files at once.
Status swept(const SweepRequest& request, const std::string& name, const Mechanism& mechanism, Cycle cycle, int driver,
             const Travel& travel, const std::vector<Target>& targets) {
    const std::vector<Unsolved> missing = cycle.begin(travel);
    std::vector<RowFile> files;
    for (const Target& target : targets) {
        auto file = Growing::open(target.path);
        if (!file) return cannot_write(file.error());
        files.emplace_back(*std::move(file), target.format);
        files.back().head(cycle.columns(), name_of_driver(mechanism, driver), travel);
    }
    EffortSums efforts(cycle.columns());
    Progress progress(request.steps);
    long left_out = 0;
    double first_left_out = 0, last_left_out = 0;
    for (long i = 0; i <= request.steps; ++i) {
        progress.at(i);
        // At a limit the driver has no velocity to give.
        if ((i == 0 && travel.starts_at_limit) || (i == request.steps && travel.ends_at_limit)) continue;
        const double share = static_cast<double>(i) / static_cast<double>(request.steps);
        const double coordinate = i == request.steps ? travel.to : travel.from + share * (travel.to - travel.from);
        const auto row = cycle.row(coordinate);
        if (row) {
            efforts.take(*row);
            for (RowFile& file : files) file.row(*row);
        } else {
            if (left_out++ == 0) first_left_out = coordinate;
            last_left_out = coordinate;
        }
        for (const RowFile& file : files)
            if (!file.is_whole()) return cannot_write({targets[static_cast<std::size_t>(&file - files.data())].path, file.why()});
    }
    std::vector<Output> outputs;
    for (RowFile& file : files) {
        file.tail(cycle);
        if (!file.is_whole()) return cannot_write({targets[static_cast<std::size_t>(&file - files.data())].path, file.why()});
    }
    for (RowFile& file : files) outputs.push_back(file.finish());
    if (const auto failure = write_all(outputs)) return cannot_write(*failure);
    const Report report(name, mechanism, driver);
    report.on_travel(travel);
    efforts.say_all(name, cycle, mechanism, driver);
    report.on_rows_left_out(left_out, first_left_out, last_left_out);
    report.on_difference(cycle);
    for (const Unsolved& unsolved : missing)
        say(name, render::word("one unsolved", render::Language::en) + ": " + render::tell(unsolved.what, render::Language::en) +
                      ": " + render::tell(unsolved.why, render::Language::en));
    return left_out == 0 && missing.empty() ? Status::done : Status::unsolved;
}

}  // namespace

Status sweep_command(const SweepRequest& request) {
    const std::string name = spoken(request.file);
    const auto wrong = [](const std::string& subject, const std::string& why) {
        say(subject, why);
        return Status::bad_input;
    };
    constexpr std::array formats{Format::csv, Format::json};
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return wrong("kinegraph", targets.error());
    if (targets->empty()) targets->push_back({"-", Format::csv});
    const auto text = read_whole(request.file, "mechanism file");
    if (!text) return wrong(name, text.error());
    const auto mechanism = read_mechanism(*text, bare_name(request.file));
    if (!mechanism) return say(name, mechanism.error());
    const auto asked = asked_of(request, *mechanism);
    if (!asked) return wrong(name, asked.error());
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(name, pose.error());
    auto cycle = Cycle::of(*mechanism, *pose, asked->driver);
    if (!cycle) return say(name, cycle.error());
    const auto travel = travel_of(cycle->positions(), turns(*mechanism, asked->driver), asked->from, asked->to);
    if (!travel) {
        const TravelFault& fault = travel.error();
        const auto at = [&](double coordinate) { return coordinate_text(*mechanism, asked->driver, coordinate); };
        return wrong(name, fault.limit
                               ? at(fault.wanted) + " is out of reach: driver " + name_of_driver(*mechanism, asked->driver) +
                                     " stops at " + at(*fault.limit)
                               : "driver " + name_of_driver(*mechanism, asked->driver) + " has no limit; give --from and --to");
    }
    return swept(request, name, *mechanism, *std::move(cycle), asked->driver, *travel, *targets);
}

}  // namespace kinegraph::app
