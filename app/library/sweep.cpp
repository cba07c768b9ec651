// Sweep: the public interface of both kinds of sweeps, their texts and drawings.
#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/row_text.hpp"
#include "app/library/sweep_state.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/sweeps.hpp"
#include "render/sheet/cycle_sheet.hpp"
#include "render/sheet/sheet_limits.hpp"

namespace kinegraph {
namespace {

void write_difference(const Sweep::State& sweep, JsonWriter& json) {
    const LargestDifference::Found off = sweep.difference();
    json.key("largest difference");
    if (off.column < 0) {
        json.value(std::nullopt);
        return;
    }
    json.open('{').member("column", sweep.table.columns[at_index(off.column)].name);
    json.member(sweep.table.parameter ? "value" : "turn", off.coordinate).member("share", off.share).close();
}

/// Gives on the shown cells of rows.
Sweep::State::See of_shown_columns(const Sweep::State& sweep, const Sweep::State::See& see) {
    return [&sweep, see](std::span<const double> row, const std::vector<bool>& empty) {
        std::vector<double> cells;
        std::vector<bool> empty_cells;
        for (const std::size_t i : sweep.shown) {
            cells.push_back(row[i]);
            empty_cells.push_back(empty[i]);
        }
        return see(cells, empty_cells);
    };
}
std::vector<Column> shown_columns(const Sweep::State& sweep) {
    std::vector<Column> columns;
    for (const std::size_t i : sweep.shown) columns.push_back(sweep.table.columns[i]);
    return columns;
}

/// The paths of the points, with the table completed for its drawing.
Expected<std::vector<render::Way>> finished(Sweep::State& state) {
    auto ways = state.finish_table();
    if (const auto beyond = state.beyond_work()) return refused(Diagnostic::Kind::bad_input, *beyond);
    return ways;
}

}  // namespace

tl::expected<void, Words> Sweep::State::choose_shown(const std::string& names, std::size_t own,
                                                     const std::vector<Column>& operands, const app::AddColumn& add,
                                                     const std::string& dashes) {
    shown.clear();
    if (names.empty()) {
        for (std::size_t i = 0; i < own; ++i)
            if (!result_kind(table.columns[i].quantity).on_request) shown.push_back(i);
        return {};
    }
    for (std::size_t i = 0; i <= table.over(); ++i) shown.push_back(i);
    const auto chosen = app::columns_named(names, table.columns, operands, add, dashes + "columns");
    if (!chosen) return tl::unexpected(chosen.error());
    for (const std::size_t i : *chosen)
        if (std::find(shown.begin(), shown.end(), i) == shown.end()) shown.push_back(i);
    return {};
}

void Sweep::State::write_poles_and_separations(JsonWriter& json) const {
    json.key("poles").open('[', JsonWriter::Entries::on_lines);
    for (std::size_t i = 0; i < table.followed.columns.size(); ++i)
        for (const double at : table.followed.columns[i].poles)
            json.open('{').member("column", table.columns[i].name).member("at", at).close();
    json.close().key("separations").open('[', JsonWriter::Entries::on_lines);
    for (const Separation& each : table.followed.separations)
        json.open('{')
            .member("joint", mechanism.joint(each.joint).name)
            .member("from", each.from)
            .member("to", each.to)
            .close();
    json.close();
}

Sweep::Sweep(State* state) : state_(state) {}
Sweep::Sweep(Sweep&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
Sweep& Sweep::operator=(Sweep&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}
Sweep::~Sweep() { delete state_; }

Expected<Sweep> Sweep::of(const MechanismFile& file, const SweepOptions& options) {
    if (options.over.empty() && !file.has_joints())
        return refused(Diagnostic::Kind::bad_input, {lang::sweeps::the_file_states_a_problem});
    auto state = options.over.empty() ? sweep_of_driver(file.state().mechanism, options)
                                      : sweep_of_parameter(file.state(), options);
    if (!state) return tl::unexpected(state.error());
    return Sweep(state->release());
}

std::vector<SweepColumn> Sweep::columns() const {
    std::vector<SweepColumn> all;
    for (const Column& each : shown_columns(*state_))
        all.push_back({each.name, !each.si_unit.empty() ? each.si_unit
                                  : each.unit == QuantityKind::dimensionless
                                      ? std::string()
                                      : std::string(default_unit(each.unit).symbol)});
    return all;
}
std::vector<SweepPole> Sweep::poles() const {
    std::vector<SweepPole> all;
    const std::vector<FollowedColumn>& columns = state_->table.followed.columns;
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (const double at : columns[i].poles) all.push_back({state_->table.columns[i].name, at});
    return all;
}
std::vector<SweepSeparation> Sweep::separations() const {
    std::vector<SweepSeparation> all;
    for (const Separation& each : state_->table.followed.separations)
        all.push_back({state_->mechanism.joint(each.joint).name, each.from, each.to});
    return all;
}
std::vector<double> Sweep::change_points() const { return state_->table.travel.change_points; }
std::array<std::optional<double>, 2> Sweep::limits() const {
    const Travel& travel = state_->table.travel;
    return {travel.starts_at_limit ? std::optional(travel.from) : std::nullopt,
            travel.ends_at_limit ? std::optional(travel.to) : std::nullopt};
}

Expected<void> Sweep::for_each_row(const std::function<bool(const SweepRow& row)>& see,
                                   const std::function<void(long done, long all)>& progress) {
    const auto give = [&](std::span<const double> row, const std::vector<bool>& empty) {
        SweepRow given(row.begin(), row.end());
        for (std::size_t i = 0; i < given.size(); ++i)
            if (empty[i]) given[i].reset();
        return see(given);
    };
    return state_->each_row(of_shown_columns(*state_, give), progress);
}

Expected<void> Sweep::write(const std::vector<RowsText>& texts,
                            const std::function<void(long done, long all)>& progress) {
    std::vector<app::RowText> written;
    // Not before the first row: a parameter's sweep finds its columns by then.
    const auto begin = [&] {
        for (const RowsText& each : texts)
            written.emplace_back(each).head(shown_columns(*state_),
                                            [&](JsonWriter& json) { state_->write_before(json); });
    };
    bool goes_on = true;
    const auto see = [&](std::span<const double> row, const std::vector<bool>& empty) {
        if (written.empty()) begin();
        for (app::RowText& text : written) goes_on = text.row(row, empty) && goes_on;
        return goes_on;
    };
    if (auto computed = state_->each_row(of_shown_columns(*state_, see), progress); !computed || !goes_on)
        return computed;
    if (written.empty()) begin();
    for (app::RowText& text : written)
        text.tail([&](JsonWriter& json) {
            write_difference(*state_, json);
            state_->write_after(json);
        });
    return {};
}

Expected<std::vector<SweepRow>> Sweep::rows() {
    std::vector<SweepRow> all;
    const auto keep = [&](const SweepRow& row) {
        all.push_back(row);
        return true;
    };
    return for_each_row(keep).map([&] { return std::move(all); });
}

std::vector<Text> Sweep::remarks() const { return texts_of(state_->remarks); }
std::vector<Text> Sweep::summary() const {
    std::vector<Words> lines = state_->summary();
    if (const LargestDifference::Found off = state_->difference(); off.column >= 0) {
        std::array<char, 32> share{};
        std::snprintf(share.data(), share.size(), "%.1e", off.share);
        lines.emplace_back(lang::sweeps::largest_difference_from_the_numeric_check, decimal_words(share.data()),
                           state_->table.columns[at_index(off.column)].name, state_->coordinate_text(off.coordinate));
    }
    return texts_of(lines);
}
std::vector<Solved::Missing> Sweep::unsolved() const { return missing_of(state_->unsolved); }
bool Sweep::is_complete() const { return state_->unsolved.empty() && state_->table.left_out.empty(); }
double Sweep::largest_difference() const { return state_->difference().share; }

Expected<Drawing> draw(Sweep& sweep, const DrawingOptions& options) {
    Sweep::State& state = sweep.state();
    if (stands_for_joints(state.mechanism))
        return refused(Diagnostic::Kind::bad_input, {lang::sweeps::a_problem_in_place_of_joints});
    if (!state.has_rows)
        if (const auto computed = sweep.write({}); !computed) return tl::unexpected(computed.error());
    return drawing_of(options,
                      [&](const render::SheetOptions& sheet, const render::Fonts& fonts,
                          std::vector<Text>&) -> Expected<std::vector<render::Page>> {
                          Mechanism plain = state.mechanism;
                          plain.find = {};
                          plain.find.stated = plain.find.velocity = true;
                          const auto drawn = solve(std::move(plain));
                          if (!drawn) return tl::unexpected(diagnostics_of(drawn.error()));
                          if (auto far = why_points_not_drawn(*drawn)) return tl::unexpected(*std::move(far));
                          const auto ways = finished(state);
                          if (!ways) return tl::unexpected(ways.error());
                          return render::lay_out_cycle(*drawn, state.table, state.plots, *ways,
                                                       with_colours_of(sheet, state.mechanism), fonts);
                      });
}

Expected<Drawing> draw_frames(Sweep& sweep, int frames, const DrawingOptions& options) {
    Sweep::State& state = sweep.state();
    constexpr int least = 2, most = 720;
    if (frames < least || frames > most)
        return refused(Diagnostic::Kind::bad_input,
                       Words(lang::sweeps::a_film_has_frames, std::to_string(least), std::to_string(most)));
    if (state.table.parameter || stands_for_joints(state.mechanism))
        return refused(Diagnostic::Kind::bad_input, {lang::sweeps::a_film_shows_a_driver});
    if (!state.has_rows)
        if (const auto computed = sweep.write({}); !computed) return tl::unexpected(computed.error());
    DrawingOptions slides = options;
    slides.slides = true;
    return drawing_of(slides,
                      [&](const render::SheetOptions& sheet, const render::Fonts& fonts,
                          std::vector<Text>&) -> Expected<std::vector<render::Page>> {
                          const auto ways = finished(state);
                          if (!ways) return tl::unexpected(ways.error());
                          const std::vector<render::FilmFrame> positions = state.film_frames(frames);
                          if (positions.empty())
                              return refused(Diagnostic::Kind::no_unique_answer, {lang::sweeps::a_film_shows_a_driver});
                          return render::lay_out_film(positions, state.table, state.plots, *ways,
                                                      with_colours_of(sheet, state.mechanism), fonts);
                      });
}

}  // namespace kinegraph
