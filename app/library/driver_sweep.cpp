// Sweep over a driver: rows along its travel, its quantities between the rows, and what the sheet of the cycle shows
// besides.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <tuple>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/limits.hpp"
#include "app/library/sweep_centrodes.hpp"
#include "app/library/sweep_course.hpp"
#include "app/library/sweep_drawing.hpp"
#include "app/library/sweep_state.hpp"
#include "constructions/positions/cycle.hpp"
#include "constructions/positions/drawn_motion.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/results/operands.hpp"
#include "lang/keys/sheet.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph {
namespace {

class DriverSweep final : public Sweep::State {
public:
    DriverSweep(const Mechanism& own, const SweepOptions& options) : State(own), options_(options) {}

    /// Reads the options. Separate from the constructor, because the cycle refers to members of this object.
    Expected<void> prepare() {
        const auto wrong = [](const Words& why) { return refused(Diagnostic::Kind::bad_input, why); };
        if (const auto beyond = app::beyond_sweep(mechanism)) return wrong(*beyond);
        const auto asked = app::course_asked(options_, mechanism);
        if (!asked) return wrong(asked.error());
        course_ = asked->course;
        auto pose = draw_pose(mechanism);
        if (!pose) return tl::unexpected(diagnostics_of(pose.error()));
        pose_ = *std::move(pose);
        auto cycle = Cycle::of(mechanism, pose_, course_);
        if (!cycle) return tl::unexpected(diagnostics_of(cycle.error()));
        const auto travel = app::travel_asked(cycle->positions(), mechanism, *asked, options_.dashes);
        if (!travel) return wrong(travel.error());
        cycle_.emplace(*std::move(cycle));
        const std::vector<Column> operands = operands_of_expressions(mechanism, course_.driver);
        const app::ColumnsOnRequest on_request = app::columns_on_request(options_, mechanism, operands);
        unsolved = cycle_->begin(*travel, true, on_request.columns);
        if (cycle_->columns().empty())
            return refused(Diagnostic::Kind::no_unique_answer, {lang::sweeps::no_position_has_a_unique_answer});
        table.driver = name_of(course_.driver);
        table.turns = app::turns(mechanism, course_.driver);
        table.travel = *travel;
        table.columns = cycle_->columns();
        auto traces = app::traces_of(options_.traces, mechanism, options_.dashes);
        if (!traces) return wrong(traces.error());
        traces_ = *std::move(traces);
        const std::size_t own = table.columns.size();
        const auto add = [this](const ResultExpression& expression) {
            table.columns.push_back(expression.column());
            return cycle_->add(expression);
        };
        for (const ResultExpression& each : on_request.defined) add(each);
        if (const auto chosen = choose_shown(options_.columns, own, operands, add, options_.dashes); !chosen)
            return wrong(chosen.error());
        auto columns = app::plots_of(options_.plots, table.columns, operands, add, options_.dashes);
        if (!columns) return wrong(columns.error());
        plots = *std::move(columns);
        table.followed = cycle_->follow(*travel, efforts());
        // No number of rows would help.
        if (cycle_->is_spent())
            return wrong({lang::sweeps::sizes_too_different_between_rows, std::to_string(most_planned_millions)});
        const auto pairs = app::centrode_pairs_of(options_.centrodes, mechanism, options_.dashes);
        if (!pairs) return wrong(pairs.error());
        for (const auto& [first, second] : *pairs) add_centrodes(first, second);
        return {};
    }

    Expected<void> each_row(const See& see, const Progress& progress) override {
        const Travel& travel = table.travel;
        // More cannot be distinguished in a plot.
        constexpr long most_drawn = 3600;
        const long steps = options_.steps, stride = (steps + most_drawn - 1) / most_drawn;
        table.rows.clear();
        table.left_out.clear();
        has_rows = false;
        for (long i = 0; i <= steps; ++i) {
            if (progress) progress(i, steps);
            // At a limit the rates of the driver are not defined.
            if ((i == 0 && travel.starts_at_limit) || (i == steps && travel.ends_at_limit)) continue;
            const double at = travel.at(static_cast<double>(i) / static_cast<double>(steps));
            const auto row = cycle_->row(at);
            if (const auto beyond = beyond_work()) return refused(Diagnostic::Kind::bad_input, *beyond);
            if (!row) {
                table.left_out.push_back(at);
                continue;
            }
            if (i % stride == 0) table.rows.emplace_back(row->begin(), row->end());
            if (!see(*row, cycle_->empty_cells())) return {};
        }
        has_rows = true;
        return {};
    }

    void write_before(JsonWriter& json) const override {
        const Travel& travel = table.travel;
        const auto limit = [](bool is_one, double at) { return is_one ? std::optional(at) : std::nullopt; };
        json.member("driver", table.driver);
        if (!course_.along.empty()) {
            json.key("along").open('{');
            for (const Course::Along& each : course_.along) json.member(name_of(each.driver), each.per);
            json.close();
        }
        json.member("from", travel.from).member("to", travel.to).key("limits").open('[');
        json.value(limit(travel.starts_at_limit, travel.from)).value(limit(travel.ends_at_limit, travel.to)).close();
        json.member("change points", travel.change_points);
    }
    void write_after(JsonWriter& json) const override {
        write_poles_and_separations(json);
        if (const auto& flanks = cycle_->flank_changes(); !flanks.empty()) {
            json.key("flank changes").open('[', JsonWriter::Entries::on_lines);
            for (const FlankChange& each : flanks)
                json.open('{').member("joint", mechanism.joint(each.joint).name).member("at", each.at).close();
            json.close();
        }
        if (!centrodes_.empty()) app::write_centrodes(centrodes_, mechanism, json);
    }

    std::vector<render::Way> finish_table() override {
        const Travel& travel = table.travel;
        std::vector<std::size_t> whole = efforts();
        for (const auto& plot : plots) whole.insert(whole.end(), plot.begin(), plot.end());
        for (std::size_t i = 0; i < table.columns.size(); ++i)  // the table of extremes has their strokes
            if (table.columns[i].kind == Column::Kind::slid) whole.push_back(i);
        table.followed = cycle_->follow(travel, whole);
        table.limits.clear();
        if (travel.starts_at_limit) table.limits.push_back(cycle_->at_limit(travel.from, travel.to - travel.from));
        if (travel.ends_at_limit) table.limits.push_back(cycle_->at_limit(travel.to, travel.from - travel.to));
        table.transmission = transmission_of(mechanism, cycle_->positions(), course_.driver, travel);
        auto ways = app::ways_of(mechanism, pose_, cycle_->positions(), travel, options_.poses, traces_);
        for (const Centrodes& each : centrodes_) app::add_ways(each, mechanism, ways);
        return ways;
    }

    std::optional<Words> beyond_work() const override {
        if (!cycle_->is_spent()) return std::nullopt;
        return Words(lang::sweeps::sizes_too_different_for_a_sweep, std::to_string(most_planned_millions),
                     options_.dashes);
    }

    std::vector<render::FilmFrame> film_frames(int count) const override {
        Mechanism plain = mechanism;
        plain.find = {};
        plain.find.stated = plain.find.velocity = true;
        const Mover mover(plain, pose_);
        std::vector<render::FilmFrame> frames;
        for (const OtherPosition& other : other_positions(cycle_->positions(), table.travel, count)) {
            Positions here = cycle_->positions();
            if (!here.move_to(other.coordinate)) continue;
            const Exact coordinate = Exact::from_double(other.coordinate);
            std::optional<Repositioned> moved =
                here.is_singular() ? mover.moved_across(here, coordinate) : mover.moved(here, coordinate);
            if (!moved) continue;
            const FinerPose finer = [pose = std::move(moved->finer)] { return pose; };
            frames.push_back(
                {table.travel.at(other.share), solve(std::move(moved->mechanism), std::move(moved->pose), finer)});
        }
        return frames;
    }

    std::vector<Words> summary() const override {
        std::vector<Words> lines = lines_on_travel();
        for (const std::size_t i : efforts())
            lines.push_back(line_on_effort(table.columns[i], table.followed.columns[i]));
        for (const Separation& each : table.followed.separations)
            lines.emplace_back(lang::sweeps::the_contact_can_only_push, mechanism.joint(each.joint).name,
                               position_text(each.from), position_text(each.to));
        for (const FlankChange& each : cycle_->flank_changes())
            lines.emplace_back(lang::sweeps::teeth_change_flanks, mechanism.joint(each.joint).name,
                               position_text(each.at));
        if (const auto& left_out = table.left_out; left_out.size() == 1)
            lines.emplace_back(lang::sweeps::n_1_row_is_left_out, position_text(left_out.front()));
        else if (left_out.size() > 1)
            lines.emplace_back(lang::sweeps::rows_are_left_out, std::to_string(left_out.size()),
                               position_text(left_out.front()), position_text(left_out.back()));
        return lines;
    }
    LargestDifference::Found difference() const override {
        const Cycle::Difference off = cycle_->difference();
        return {off.share, off.column, off.coordinate};
    }
    Words coordinate_text(double coordinate) const override {
        return app::coordinate_text(mechanism, course_.driver, coordinate);
    }

private:
    std::string name_of(int driver) const { return app::name_of_driver(mechanism, driver); }
    /// The position of a row: a coordinate, or a time.
    Words position_text(double at) const { return table.travel.times ? app::time_text(at) : coordinate_text(at); }

    void add_centrodes(BodyIndex first, BodyIndex second) {
        auto traced = trace_centrodes(mechanism, pose_, course_.driver, table.travel, first, second);
        if (!traced || traced->branches.empty())
            remarks.emplace_back(lang::sweeps::centrodes_the_two_bodies_never_turn, options_.dashes,
                                 mechanism.body(first).name, mechanism.body(second).name);
        if (traced) centrodes_.push_back(*std::move(traced));
    }

    std::vector<std::size_t> efforts() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            if (table.columns[i].quantity.kind == Quantity::Kind::effort) found.push_back(i);
        return found;
    }
    /// Its mean and extremes, or where it grows without limit.
    Words line_on_effort(const Column& column, const FollowedColumn& followed) const {
        const Unit& unit = column.unit == QuantityKind::moment ? mechanism.units.moment : mechanism.units.force;
        const auto amount = [&](double value) {
            std::array<char, 32> digits{};
            std::snprintf(digits.data(), digits.size(), "%.6g ", value / unit.si.to_double());
            return decimal_words(digits.data()) + unit.symbol;
        };
        const auto extreme = [&](const std::optional<FollowedColumn::Extreme>& found) {
            return found ? Words(lang::sweeps::value_at, amount(found->value), position_text(found->at))
                         : Words(lang::sheet::without_limit);
        };
        const Words mean = followed.mean ? Words(amount(*followed.mean)) : Words(lang::sheet::without_limit);
        Words line(lang::sweeps::mean_least_greatest, column.name, mean, extreme(followed.least),
                   extreme(followed.greatest));
        if (followed.poles.empty()) return line;
        Words places;
        for (const double at : followed.poles) {
            if (at != followed.poles.front()) places += Words(std::string(", "));
            places += position_text(at);
        }
        return {lang::sweeps::it_grows_without_limit, line, places};
    }

    /// Whether the position is nearly singular even away from the limit, where another one is not: then the limit has
    /// lost digits.
    bool is_beside_change_point(double limit, double inward) const {
        Positions beside = cycle_->positions();
        const double away = 1e-7 * (table.turns ? 1 : beside.size());
        return !beside.move_to(limit + away * inward) || beside.is_singular();
    }
    std::vector<Words> lines_on_travel() const {
        std::vector<Words> lines;
        const Travel& travel = table.travel;
        const auto coordinate = [&](double at, double grain = 1e-9) {
            return app::coordinate_text(mechanism, course_.driver, at, grain);
        };
        if (travel.starts_at_limit || travel.ends_at_limit)
            lines.emplace_back(
                lang::sweeps::driver_goes, table.driver, coordinate(travel.from), coordinate(travel.to),
                travel.starts_at_limit ? Words(lang::sweeps::its_limits) : Words(lang::sweeps::its_limit));
        for (const auto& [is_limit, is_far, at, inward] :
             {std::tuple(travel.starts_at_limit, travel.starts_far, travel.from, 1.0),
              std::tuple(travel.ends_at_limit, travel.ends_far, travel.to, -1.0)})
            if (is_far)
                lines.emplace_back(lang::sweeps::limit_where_a_place_goes_to_infinity, coordinate(at));
            else if (is_limit && is_beside_change_point(at, travel.to > travel.from ? inward : -inward))
                lines.emplace_back(lang::sweeps::limit_beside_a_change_point, coordinate(at));
        const auto& branch = cycle_->positions().branch();
        if (branch)
            lines.emplace_back(lang::sweeps::a_change_point_is_drawn, std::to_string(branch->of),
                               std::to_string(branch->index + 1), options_.dashes);
        for (const double each : travel.change_points)
            if (!branch || each != 0)
                lines.emplace_back(lang::sweeps::a_change_point_at_the_branch, coordinate(each, 1e-6));
        if (travel.times)
            lines.emplace_back(lang::sweeps::driver_follows_its_law, table.driver, app::time_text(travel.times->first),
                               app::time_text(travel.times->second));
        if (mechanism.drivers.size() > 1 + course_.along.size())
            lines.emplace_back(lang::sweeps::the_other_drivers_rest_where_they);
        return lines;
    }

    SweepOptions options_;
    Course course_;
    Pose pose_;
    std::optional<Cycle> cycle_;  ///< refers to the mechanism and the pose
    std::vector<app::Trace> traces_;
    std::vector<Centrodes> centrodes_;
};

}  // namespace

Expected<std::unique_ptr<Sweep::State>> sweep_of_driver(const Mechanism& mechanism, const SweepOptions& options) {
    auto sweep = std::make_unique<DriverSweep>(mechanism, options);
    if (const auto ready = sweep->prepare(); !ready) return tl::unexpected(ready.error());
    return sweep;
}

}  // namespace kinegraph
