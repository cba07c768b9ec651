// The sheets of the examples, each laid out once in a process for all suites that use it.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"

namespace kinegraph::tests {

/// The options of a sheet that the tests of all examples vary.
struct Look {
    Language language = Language::en;
    render::Paper paper = render::Paper::a4;
    render::Orientation orientation = render::Orientation::landscape;
    render::SolutionDetail detail = render::SolutionDetail::full;
    std::string_view theme = "colour";  ///< one of render::theme_names()

    auto operator<=>(const Look&) const = default;
};

render::SheetOptions options_of(const Look& look);

/// The pages of an example's solution. They are cached, so use it for looks that several suites share.
const std::vector<render::Page>& laid_out(const std::string& example, const Look& look = {});

}  // namespace kinegraph::tests
