// Reads the course of a sweep: which drivers move, and how far.
#pragma once

#include <optional>

#include <tl/expected.hpp>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"
#include "kinegraph/motion.hpp"
#include "lang/words.hpp"

namespace kinegraph::app {

/// The drivers and the range of a sweep, checked against the mechanism.
struct AskedCourse {
    Course course;
    std::optional<Exact> from, to;  ///< coordinates, or times where the driver has a law
};
/// Error, one line: an unknown driver, an invalid quantity, an empty range, or a driver along that has no step.
tl::expected<AskedCourse, Words> course_asked(const SweepOptions& options, const Mechanism& mechanism);

/// Error, one line: out of reach, or a driver without limits.
tl::expected<Travel, Words> travel_asked(const Positions& positions, const Mechanism& mechanism,
                                         const AskedCourse& asked, const std::string& dashes);

}  // namespace kinegraph::app
