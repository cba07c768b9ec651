// A solution as a file of GeoGebra: an archive of its construction.
#include "render/geogebra/geogebra.hpp"

#include "app/library/state.hpp"
#include "lang/keys/library.hpp"
#include "render/backends/archive.hpp"

namespace kinegraph {

Expected<std::string> geogebra_xml(const Solved& solved, const DrawingOptions& options) {
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    if (!solved.state().source) return refused(Diagnostic::Kind::bad_input, {lang::library::geogebra_takes_the_drawn});
    const Solution& solution = solved.state().solution;
    auto xml = render::geogebra_xml(solution, with_colours_of(*sheet, solution.mechanism).theme, options.language);
    if (!xml) return refused(Diagnostic::Kind::bad_input, xml.error());
    return *std::move(xml);
}

Expected<GeoGebraFile> geogebra_file(const Solved& solved, const DrawingOptions& options) {
    const auto xml = geogebra_xml(solved, options);
    if (!xml) return tl::unexpected(xml.error());
    auto archive = render::packed({{"geogebra.xml", *xml}});
    if (!archive) return refused(Diagnostic::Kind::output, archive.error());
    GeoGebraFile file{*std::move(archive), {}};
    const Solution& solution = solved.state().solution;
    if (!solution.free_bodies.empty() || !solution.efforts.empty())
        file.remarks.push_back(text_of(Words(lang::library::geogebra_gets_no_forces)));
    return file;
}

}  // namespace kinegraph
