// What the parts of the extension module share. It stands on the public face (include/kinegraph/) alone and adds
// nothing: the package `kinegraph` around it (python/kinegraph) is what users see.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <kinegraph/kinegraph.hpp>

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace kinegraph::python {

namespace py = pybind11;

/// Faults on their way to Python, where they become kinegraph.Error.
class Faults : public std::exception {
public:
    explicit Faults(Diagnostics all) : all_(std::move(all)) {}
    const Diagnostics& all() const { return all_; }
    const char* what() const noexcept override { return "faults of a file or of its geometry"; }

private:
    Diagnostics all_;
};

/// The value; throws Faults.
template <class Value>
Value given(Expected<Value> expected) {
    if (!expected) throw Faults(std::move(expected.error()));
    if constexpr (!std::is_void_v<Value>) return *std::move(expected);
}

/// Computes without the interpreter's lock, so that other threads of Python run.
template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release release;
    return work();
}

/// The language of a code; raises ValueError for an unknown one.
Language language_of(const std::string& code);
std::vector<std::string> in(const std::vector<Text>& texts, const std::string& code);
/// Drawing options by their names in Python; raises TypeError for an unknown name, ValueError for an unknown value.
DrawingOptions drawing_options(const py::dict& by_name);
Lettering lettering_of(const std::string& name);
TextForm text_form_of(const std::string& name);
/// Parameters by name, each value as a file writes it.
std::vector<ParameterValue> settings_of(const std::vector<std::pair<std::string, std::string>>& pairs);

void define_texts(py::module_& module);
void define_drawings(py::module_& module);
void define_mechanisms(py::module_& module);
void define_motion(py::module_& module);
void define_variants(py::module_& module);

}  // namespace kinegraph::python
