// The centrodes of a sweep: which bodies' are asked for, as data of the JSON and as lines of the drawing.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "constructions/positions/centrodes.hpp"
#include "engine/file/words.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::app {

/// Pairs of bodies. Error, one line: a name that is none, with the nearest; no pair; twice one body.
tl::expected<std::vector<std::pair<BodyIndex, BodyIndex>>, Words> centrode_pairs_of(
    const std::vector<std::string>& asked, const Mechanism& mechanism);
/// The member "centrodes" of the JSON, without its key.
std::string json_of(const std::vector<Centrodes>& centrodes, const Mechanism& mechanism);
/// Fixed and moving, piece by piece, and the pole in which they touch as drawn.
void add_ways(const Centrodes& centrodes, const Mechanism& mechanism, std::vector<render::Way>& ways);

}  // namespace kinegraph::app
