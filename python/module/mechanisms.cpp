// Mechanism files and their solutions.
#include "python/module/bindings.hpp"

namespace kinegraph::python {
namespace {

using Texts = std::vector<std::string>;

void define_files(py::module_& module) {
    py::class_<MechanismFile>(module, "MechanismFile")
        .def_static("parse",
                    [](const std::string& text, const std::string& name,
                       const std::vector<std::pair<std::string, std::string>>& set) {
                        const auto settings = settings_of(set);
                        return given(unlocked([&] { return MechanismFile::parse(text, name, settings); }));
                    })
        .def("title",
             [](const MechanismFile& file, const std::string& lang) { return file.title().in(language_of(lang)); })
        .def_property_readonly("has_joints", &MechanismFile::has_joints)
        .def_property_readonly("has_equations", &MechanismFile::has_equations)
        .def("counts",
             [](const MechanismFile& file) {
                 const MechanismFile::Counts counts = file.counts();
                 return py::make_tuple(counts.bodies, counts.joints, counts.drivers);
             })
        .def("check", [](const MechanismFile& file,
                         const std::string& lang) { return in(given(unlocked([&] { return file.check(); })), lang); })
        .def("solve",
             [](const MechanismFile& file, bool equations, bool virtual_work, bool sentences) {
                 return given(unlocked([&] { return file.solve({equations, virtual_work, sentences}); }));
             })
        .def("solve_at",
             [](const MechanismFile& file, const Texts& at, const std::string& driver, int branch, bool equations,
                bool virtual_work) {
                 const PositionsWanted wanted{at, driver, branch};
                 return given(unlocked([&] { return file.solve_at(wanted, {equations, virtual_work, true}); }));
             })
        .def("pairs", [](const MechanismFile& file, const std::string& form,
                         const std::string& lang) { return given(file.pairs(text_form_of(form), language_of(lang))); })
        .def("equations", [](const MechanismFile& file, const std::string& form, const std::string& lang) {
            const TextForm wanted = text_form_of(form);
            const Language language = language_of(lang);
            return given(unlocked([&] { return file.equations(wanted, language); }));
        });
}

void define_values(py::module_& module) {
    py::class_<ResultValue>(module, "ResultValue")
        .def_readonly("name", &ResultValue::name)
        .def_readonly("value", &ResultValue::value)
        .def_readonly("in_file_unit", &ResultValue::in_file_unit)
        .def_readonly("unit", &ResultValue::unit)
        .def_property_readonly("exact", [](const ResultValue& value) -> py::object {
            if (!value.exact) return py::none();
            return py::str(value.exact->text());
        });
    py::class_<CheckedValue>(module, "CheckedValue")
        .def_readonly("name", &CheckedValue::name)
        .def_readonly("graphical", &CheckedValue::graphical)
        .def_readonly("numeric", &CheckedValue::numeric)
        .def_readonly("difference", &CheckedValue::difference);
}

void define_drawing_of(py::class_<Solved>& solved) {
    solved
        .def("figure_names",
             [](const Solved& solution, const py::dict& options) {
                 const DrawingOptions wanted = drawing_options(options);
                 return given(unlocked([&] { return figure_names(solution, wanted); }));
             })
        .def("draw",
             [](const Solved& solution, const py::dict& options) {
                 const DrawingOptions wanted = drawing_options(options);
                 return given(unlocked([&] { return draw(solution, wanted); }));
             })
        .def("live_page", [](const Solved& solution, const py::dict& options) {
            const DrawingOptions wanted = drawing_options(options);
            return given(unlocked([&] { return live_page(solution, wanted); })).html;
        });
}

}  // namespace

void define_mechanisms(py::module_& module) {
    define_values(module);
    py::class_<Solved> solved(module, "Solved");
    solved
        .def("title",
             [](const Solved& solution, const std::string& lang) { return solution.title().in(language_of(lang)); })
        .def("subject",
             [](const Solved& solution, const std::string& lang) { return solution.subject().in(language_of(lang)); })
        .def("values", [](const Solved& solution) { return unlocked([&] { return solution.values(); }); })
        .def("evaluate", [](const Solved& solution, const std::string& text) { return given(solution.evaluate(text)); })
        .def("vector", [](const Solved& solution, const std::string& name) { return solution.vector(name); })
        .def("statements",
             [](const Solved& solution, const std::string& lang) { return in(solution.statements(), lang); })
        .def("unsolved",
             [](const Solved& solution, const std::string& lang) {
                 const Language language = language_of(lang);
                 std::vector<std::pair<std::string, std::string>> all;
                 for (const Solved::Missing& each : solution.unsolved())
                     all.emplace_back(each.what.in(language), each.reason.in(language));
                 return all;
             })
        .def("remarks", [](const Solved& solution, const std::string& lang) { return in(solution.remarks(), lang); })
        .def("checks", &Solved::checks)
        .def("json", [](const Solved& solution, bool exact) { return unlocked([&] { return solution.json(exact); }); })
        .def("table",
             [](const Solved& solution, const std::string& lang) { return solution.table(language_of(lang)); });
    define_drawing_of(solved);
    define_files(module);
    module.def("draw_all", [](const std::vector<Solved>& solutions, const py::dict& options) {
        const DrawingOptions wanted = drawing_options(options);
        return given(unlocked([&] { return draw(solutions, wanted); }));
    });
}

}  // namespace kinegraph::python
