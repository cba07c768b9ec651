// Pages of contacts at joints with materials: each contact is laid out as a problem after the sheet of the mechanism.
// Also gives its figures by name. Computes nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_options.hpp"
#include "render/page/figure.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// Pages, and the number of their numbered figures.
struct BoundPages {
    std::vector<Page> pages;
    int figures = 0;
};
using LayOutProblem = std::vector<Page> (*)(const Solution&, const SheetOptions&, const Fonts&);

/// The pages of the mechanism, then those of its contacts. Numbers of pages and figures continue.
std::vector<Page> with_contacts(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                LayOutProblem contact, const std::function<BoundPages(const SheetOptions&)>& mechanism);

struct ContactFigure {
    std::string name;  ///< "contact-P", "pressure-P", "stresses-P" for joint P
    JointIndex joint = none;
};
std::vector<ContactFigure> contact_figures(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
std::optional<Figure> contact_figure(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                     const std::string& name, Spot room);

/// The tables of results of the contacts as plain text; empty if there are none.
std::string contact_tables(const Solution& solution, Language language);

}  // namespace kinegraph::render
