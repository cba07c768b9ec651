// The drawing of a sweep: the columns to plot, the paths and positions drawn with the mechanism.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/motion/positions.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::app {

/// The columns of each plot: those requested or, by default, displacement, speed and acceleration of the slider (else
/// of the last body that turns) and the input forces and couples. Error, one line: no such column (with the nearest
/// name), too many, or several units in one plot.
tl::expected<std::vector<std::vector<std::size_t>>, Words> plots_of(const std::vector<std::string>& asked,
                                                                    const std::vector<Column>& columns,
                                                                    const std::string& dashes);

/// The path of a point.
struct Trace {
    PointIndex point;
    BodyIndex on = frame;
    std::string name;
};
/// Error, one line: an unknown name, with the nearest one.
tl::expected<std::vector<Trace>, Words> traces_of(const std::vector<std::string>& asked, const Mechanism& mechanism,
                                                  const std::string& dashes);

/// `poses` positions distributed over the travel, and the paths.
std::vector<render::Way> ways_of(const Mechanism& mechanism, Positions positions, const Travel& travel, int poses,
                                 const std::vector<Trace>& traces);

}  // namespace kinegraph::app
