// Pages of contact at joints: what follows a mechanism's sheet where joints have materials, each contact as a problem
// of its own, and its figures by name. Computes nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/content/sheet_options.hpp"
#include "render/page/figure.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// Pages, and how many of their figures have a number.
struct BoundPages {
    std::vector<Page> pages;
    int figures = 0;
};
using LayOutProblem = std::vector<Page> (*)(const Solution&, const SheetOptions&, const Fonts&);

/// The mechanism's own pages, laid out for as many as follow, and those of its contacts; pages and figures are numbered
/// on.
std::vector<Page> with_contacts(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                LayOutProblem contact, const std::function<BoundPages(const SheetOptions&)>& mechanism);

/// "contact-P", "pressure-P", "stresses-P" of the joint P.
std::vector<std::string> contact_figure_names(const Solution& solution, const SheetOptions& options,
                                              const Fonts& fonts);
std::optional<Figure> contact_figure(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                     const std::string& name, Spot room);

/// Their tables as plain text; empty where there are none.
std::string contact_tables(const Solution& solution, Language language);

}  // namespace kinegraph::render
