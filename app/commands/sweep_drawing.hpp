// The drawing of a sweep: which columns are plotted, which paths and positions stand behind the mechanism.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/commands/commands.hpp"
#include "engine/motion/positions.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::app {

/// Lists of columns: those asked for, or displacement, speed and acceleration of what slides (else of the last body
/// that turns) and the efforts. Error, one line: no such column (with the nearest name), too many, or several units in
/// one plot.
tl::expected<std::vector<std::vector<std::size_t>>, Words> plots_of(const std::vector<std::string>& asked,
                                                                    const std::vector<Column>& columns);

/// A path to be traced.
struct Trace {
    PointIndex point;
    BodyIndex on = frame;
    std::string name;
};
/// Error, one line: a name that is none, with the nearest.
tl::expected<std::vector<Trace>, Words> traces_of(const std::vector<std::string>& asked, const Mechanism& mechanism);

/// `poses` positions spread over the travel, and the traces.
std::vector<render::Way> ways_of(const Mechanism& mechanism, Positions positions, const Travel& travel, int poses,
                                 const std::vector<Trace>& traces);

}  // namespace kinegraph::app
