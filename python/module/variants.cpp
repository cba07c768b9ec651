// Variants of an exercise, their key and their files for learning platforms.
#include <cstdint>
#include <optional>

#include "python/module/bindings.hpp"

namespace kinegraph::python {
namespace {

/// The next variant; none if there is no other. Ctrl-C ends the search.
std::optional<ExerciseVariant> next_of(ExerciseVariants& variants, const std::string& name) {
    bool interrupted = false;
    unsigned tried = 0;
    const auto stops = [&] {
        constexpr unsigned seldom = 64;  // the interpreter's lock costs more than a rejected combination
        if (++tried % seldom != 0) return false;
        const py::gil_scoped_acquire lock;
        interrupted = PyErr_CheckSignals() != 0;
        return interrupted;
    };
    auto found = unlocked([&] { return variants.next(name, stops); });
    if (interrupted) throw py::error_already_set();
    return given(std::move(found));
}

void define_exercises(py::module_& module) {
    py::class_<ExerciseVariant>(module, "ExerciseVariant")
        .def_property_readonly("values",
                               [](const ExerciseVariant& variant) {
                                   std::vector<std::pair<std::string, std::string>> all;
                                   for (const ParameterValue& each : variant.values)
                                       all.emplace_back(each.name, each.value);
                                   return all;
                               })
        .def_readonly("solved", &ExerciseVariant::solved)
        .def_readonly("asked", &ExerciseVariant::asked)
        .def_readonly("file", &ExerciseVariant::file);
    py::class_<ExerciseVariants>(module, "ExerciseVariants")
        .def_static("parse",
                    [](const std::string& text, const std::string& name, std::uint64_t seed,
                       const std::vector<std::pair<std::string, std::string>>& set, const py::dict& options) {
                        const DrawingOptions wanted = drawing_options(options);
                        return given(ExerciseVariants::parse(text, name, seed, settings_of(set), wanted));
                    })
        .def("title", [](const ExerciseVariants& variants,
                         const std::string& lang) { return variants.title().in(language_of(lang)); })
        .def("parameters", &ExerciseVariants::parameters)
        .def("combinations", &ExerciseVariants::combinations)
        .def("looked_at", &ExerciseVariants::looked_at)
        .def("rejections",
             [](const ExerciseVariants& variants, const std::string& lang) {
                 const Language language = language_of(lang);
                 std::vector<std::pair<std::string, std::uint64_t>> all;
                 for (const auto& each : variants.rejections()) all.emplace_back(each.why.in(language), each.count);
                 return all;
             })
        .def("next", &next_of);
}

}  // namespace

void define_variants(py::module_& module) {
    define_exercises(module);
    py::class_<AnswerKey>(module, "AnswerKey")
        .def(py::init<>())
        .def("add", &AnswerKey::add)
        .def("size", &AnswerKey::size)
        .def("csv", &AnswerKey::csv)
        .def("drawing", [](const AnswerKey& key, const std::string& title, const py::dict& options) {
            const DrawingOptions wanted = drawing_options(options);
            return given(unlocked([&] { return key.drawing(title, wanted); }));
        });
    py::class_<QuestionBank>(module, "QuestionBank")
        .def(py::init([](const std::string& title, std::uint64_t seed, const py::dict& options, double dpi) {
            return QuestionBank(title, seed, drawing_options(options), dpi);
        }))
        .def(
            "add",
            [](QuestionBank& bank, const std::string& number, const std::string& name, const ExerciseVariant& variant) {
                return given(unlocked([&] { return bank.add(number, name, variant); }));
            })
        .def("moodle", &QuestionBank::moodle)
        .def("qti", [](const QuestionBank& bank) { return py::bytes(given(bank.qti())); })
        .def("csv", &QuestionBank::csv);
}

}  // namespace kinegraph::python
