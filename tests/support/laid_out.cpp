#include "tests/support/laid_out.hpp"

#include <map>
#include <utility>

#include "render/sheet/sheet.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::tests {

render::SheetOptions options_of(const Look& look) {
    render::SheetOptions options;
    options.language = look.language;
    options.paper = look.paper;
    options.orientation = look.orientation;
    options.detail = look.detail;
    options.theme = render::built_in_theme(look.theme).value();
    return options;
}

const std::vector<render::Page>& laid_out(const std::string& name, const Look& look) {
    static std::map<std::pair<std::string, Look>, std::vector<render::Page>> known;
    const auto [found, is_new] = known.try_emplace({name, look});
    if (is_new) found->second = render::lay_out(example(name), options_of(look), fonts());
    return found->second;
}

}  // namespace kinegraph::tests
