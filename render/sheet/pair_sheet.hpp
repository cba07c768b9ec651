// The catalogue of pairs drawn: a card for each pair of the plane and in space, then closure, links, chains and
// multiple hinges, in rows on as many pages as they take. Takes figures as they come; facts are those of `kinegraph
// pairs`.
#pragma once

#include <vector>

#include "render/page/page.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// Paper, orientation, language and theme are the options'.
std::vector<Page> lay_out_catalogue(const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
