// The extension module kinegraph._core.
#include "python/module/bindings.hpp"

PYBIND11_MODULE(_core, module) {
    module.doc() = "The library of Kinegraph as it is; users import kinegraph.";
    kinegraph::python::define_texts(module);
    kinegraph::python::define_drawings(module);
    kinegraph::python::define_mechanisms(module);
    kinegraph::python::define_motion(module);
    kinegraph::python::define_variants(module);
}
