// The centrodes of a sweep: the pairs of bodies requested, the JSON data, the lines of the drawing.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "constructions/positions/centrodes.hpp"
#include "engine/file/json_writer.hpp"
#include "lang/words.hpp"
#include "render/figures/plot_figure.hpp"

namespace kinegraph::app {

/// Reads pairs of bodies. Error, one line: unknown body (with the nearest name), not a pair, twice the same body.
tl::expected<std::vector<std::pair<BodyIndex, BodyIndex>>, Words> centrode_pairs_of(
    const std::vector<std::string>& asked, const Mechanism& mechanism, const std::string& dashes);
/// Writes the member "centrodes" of the JSON.
void write_centrodes(const std::vector<Centrodes>& centrodes, const Mechanism& mechanism, JsonWriter& json);
/// Adds the fixed and the moving centrode, piece by piece, and the pole in the position of the file.
void add_ways(const Centrodes& centrodes, const Mechanism& mechanism, std::vector<render::Way>& ways);

}  // namespace kinegraph::app
