// The catalogue of pairs: a card for each pair in the plane and in space, then closure, links, chains and multiple
// hinges, in rows on pages. The facts are those of `kinegraph pairs`.
#pragma once

#include <vector>

#include "render/page/page.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// Uses paper, orientation, language and theme of `options`.
std::vector<Page> lay_out_catalogue(const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
