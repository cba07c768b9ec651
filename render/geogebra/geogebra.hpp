// A solved mechanism as a file of GeoGebra: its points placed as in the file, then the record of its motion, stroke by
// stroke, as commands that stay alive. Owns which command a stroke is; knows nothing of sheets.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "lang/words.hpp"
#include "render/page/theme.hpp"
#include "render/text/language.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// geogebra.xml: the position, the velocity and acceleration polygons, and the instant centres. SI units. Forces are
/// left out. Error: what GeoGebra's commands cannot say, in one line.
tl::expected<std::string, Words> geogebra_xml(const Solution& solution, const Theme& theme, Language language);

}  // namespace kinegraph::render
