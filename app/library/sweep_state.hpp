// State of a sweep: what its two kinds have in common, over a driver (driver_sweep.cpp) and over a parameter
// (parameter_sweep.cpp).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/library/state.hpp"
#include "app/library/sweep_drawing.hpp"
#include "constructions/verdicts/largest_difference.hpp"
#include "engine/file/json_writer.hpp"
#include "engine/sentences/column.hpp"
#include "kinegraph/motion.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/sheet/film_frames.hpp"

namespace kinegraph {

struct Sweep::State {
    /// A row, and by column whether its cell is empty: the quantity grows without limit there.
    using See = std::function<bool(std::span<const double>, const std::vector<bool>& empty)>;
    using Progress = std::function<void(long done, long all)>;

    explicit State(Mechanism own) : mechanism(std::move(own)) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    virtual ~State() = default;

    /// Computes the rows anew, or gives again those it has; keeps in `table` those that a plot can show.
    virtual Expected<void> each_row(const See& see, const Progress& progress) = 0;
    /// Writes the members of the JSON before its columns, and after the largest difference.
    virtual void write_before(JsonWriter& json) const = 0;
    virtual void write_after(JsonWriter& json) const = 0;
    /// Completes the table for its drawing. Returns the paths.
    virtual std::vector<render::Way> finish_table() = 0;
    /// Why the rows or what is drawn of them took too much work, with a remedy; none if they did not.
    virtual std::optional<Words> beyond_work() const { return std::nullopt; }
    /// At most `count` positions at even steps, each solved for its motion; none over a parameter.
    virtual std::vector<render::FilmFrame> film_frames(int count) const = 0;
    /// All of Sweep::summary() but the largest difference.
    virtual std::vector<Words> summary() const = 0;
    virtual LargestDifference::Found difference() const = 0;
    virtual Words coordinate_text(double coordinate) const = 0;

    /// Which columns the rows show: the driver's coordinate (and time) with those of `--columns`, or the first `own`
    /// but for those on request.
    tl::expected<void, Words> choose_shown(const std::string& names, std::size_t own,
                                           const std::vector<Column>& operands, const app::AddColumn& add,
                                           const std::string& dashes);

    /// The members "poles" and "separations" of the JSON.
    void write_poles_and_separations(JsonWriter& json) const;

    Mechanism mechanism;
    CycleTable table;
    std::vector<std::size_t> shown;               ///< columns of the rows
    std::vector<std::vector<std::size_t>> plots;  ///< columns of each
    std::vector<Words> remarks;
    std::vector<Unsolved> unsolved;
    bool has_rows = false;  ///< whether the table has those of the whole range
};

/// Errors: see Sweep::of.
Expected<std::unique_ptr<Sweep::State>> sweep_of_driver(const Mechanism& mechanism, const SweepOptions& options);
Expected<std::unique_ptr<Sweep::State>> sweep_of_parameter(const MechanismFile::State& file,
                                                           const SweepOptions& options);

}  // namespace kinegraph
