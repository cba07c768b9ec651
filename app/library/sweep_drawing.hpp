// The drawing of a sweep: the columns to plot, the paths and positions drawn with the mechanism.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/motion/positions.hpp"
#include "engine/results/result_expression.hpp"
#include "kinegraph/motion.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::app {

/// Gives an expression of the columns a column; its index.
using AddColumn = std::function<std::size_t(const ResultExpression& expression)>;

/// The results of which a sweep has columns only where its options name them, themselves or in an expression.
struct ColumnsOnRequest {
    std::vector<Column> columns;
    std::vector<ResultExpression> defined;  ///< those defined by other results
    std::vector<Column> columns_of_defined;
    bool has_least_transmission_angle = false;
};
/// `operands`: those of operands_of_expressions().
ColumnsOnRequest columns_on_request(const SweepOptions& options, const Mechanism& mechanism,
                                    const std::vector<Column>& operands);

/// The columns with these names, "v B,omega 4 / omega 2", in their order; an expression of columns that are there, and
/// of parameters among the operands, gets its own (engine/results/result_expression.hpp). `option`: its name in
/// messages. Error, one line: no such column (with the nearest name), an expression that cannot be read.
tl::expected<std::vector<std::size_t>, Words> columns_named(const std::string& names,
                                                            const std::vector<Column>& columns,
                                                            const std::vector<Column>& operands, const AddColumn& add,
                                                            const std::string& option);

/// The columns of each plot: those requested or, by default, displacement, speed and acceleration of the slider (else
/// of the last body that turns) and the input forces and couples. Error, one line: no such column (with the nearest
/// name), too many, or several units in one plot.
tl::expected<std::vector<std::vector<std::size_t>>, Words> plots_of(const std::vector<std::string>& asked,
                                                                    const std::vector<Column>& columns,
                                                                    const std::vector<Column>& operands,
                                                                    const AddColumn& add, const std::string& dashes);

/// The path of a point.
struct Trace {
    PointIndex point;
    BodyIndex on = frame;
    std::string name;
};
/// Error, one line: an unknown name, with the nearest one.
tl::expected<std::vector<Trace>, Words> traces_of(const std::vector<std::string>& asked, const Mechanism& mechanism,
                                                  const std::string& dashes);

/// `poses` positions at even steps of the travel, and the paths.
std::vector<render::Way> ways_of(const Mechanism& mechanism, const Pose& pose, const Positions& positions,
                                 const Travel& travel, int poses, const std::vector<Trace>& traces);

}  // namespace kinegraph::app
