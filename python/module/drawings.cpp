// Drawings and their bytes.
#include "python/module/bindings.hpp"

namespace kinegraph::python {

void define_drawings(py::module_& module) {
    py::class_<Drawing>(module, "Drawing")
        .def_property_readonly("pages", &Drawing::pages)
        .def("svg",
             [](const Drawing& drawing, const std::string& text) {
                 const Lettering lettering = lettering_of(text);
                 return unlocked([&] { return drawing.svg(lettering); });
             })
        .def("png", [](const Drawing& drawing, std::size_t page,
                       double dpi) { return py::bytes(given(unlocked([&] { return drawing.png(page, dpi); }))); })
        .def("pdf",
             [](const Drawing& drawing, const std::string& text) {
                 const Lettering lettering = lettering_of(text);
                 return py::bytes(given(unlocked([&] { return drawing.pdf(lettering); })));
             })
        .def("tex", [](const Drawing& drawing) { return unlocked([&] { return drawing.tex(); }); })
        .def("beamer", [](const Drawing& drawing) { return unlocked([&] { return drawing.beamer(); }); })
        .def("dxf", [](const Drawing& drawing) { return unlocked([&] { return drawing.dxf(); }); })
        .def("sentences", &Drawing::sentences)
        .def("remarks", [](const Drawing& drawing, const std::string& lang) { return in(drawing.remarks(), lang); });
    module.def("joined", [](const std::vector<Drawing>& drawings) { return given(joined(drawings)); });
    module.def("draw_pair_catalogue", [](const py::dict& options) {
        const DrawingOptions wanted = drawing_options(options);
        return given(unlocked([&] { return draw_pair_catalogue(wanted); }));
    });
}

}  // namespace kinegraph::python
