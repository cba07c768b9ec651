// Languages, options by name, and faults as Python's exceptions.
#include <algorithm>
#include <array>
#include <string_view>

#include "python/module/bindings.hpp"

namespace kinegraph::python {
namespace {

template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

/// The value of a name; raises ValueError with those there are.
template <class Value, std::size_t count>
Value chosen(std::string_view what, std::string_view name, const std::array<Named<Value>, count>& all) {
    std::string known;
    for (const Named<Value>& each : all) {
        if (each.name == name) return each.value;
        known += (known.empty() ? "" : ", ") + std::string(each.name);
    }
    throw py::value_error(std::string(what) + " \"" + std::string(name) + "\": there are " + known);
}

using Options = DrawingOptions;
constexpr std::array papers{Named<Options::Paper>{"A4", Options::Paper::a4},
                            Named<Options::Paper>{"A3", Options::Paper::a3},
                            Named<Options::Paper>{"letter", Options::Paper::letter}};
constexpr std::array orientations{Named<Options::Orientation>{"landscape", Options::Orientation::landscape},
                                  Named<Options::Orientation>{"portrait", Options::Orientation::portrait}};
constexpr std::array dimensions{Named<Options::Dimensions>{"auto", Options::Dimensions::automatic},
                                Named<Options::Dimensions>{"on", Options::Dimensions::on},
                                Named<Options::Dimensions>{"off", Options::Dimensions::off}};
constexpr std::array details{Named<Options::Detail>{"full", Options::Detail::full},
                             Named<Options::Detail>{"brief", Options::Detail::brief}};
constexpr std::array sheets{Named<Options::Sheet>{"solution", Options::Sheet::solution},
                            Named<Options::Sheet>{"question", Options::Sheet::question},
                            Named<Options::Sheet>{"answers", Options::Sheet::answers}};
constexpr std::array letterings{Named<Lettering>{"outlines", Lettering::outlines},
                                Named<Lettering>{"live", Lettering::live},
                                Named<Lettering>{"office", Lettering::office}};
constexpr std::array text_forms{Named<TextForm>{"plain", TextForm::plain},
                                Named<TextForm>{"markdown", TextForm::markdown},
                                Named<TextForm>{"latex", TextForm::latex}, Named<TextForm>{"json", TextForm::json},
                                Named<TextForm>{"formulas", TextForm::formulas}};
constexpr std::array fault_kinds{
    Named<Diagnostic::Kind>{"bad input", Diagnostic::Kind::bad_input},
    Named<Diagnostic::Kind>{"cannot meet", Diagnostic::Kind::cannot_meet},
    Named<Diagnostic::Kind>{"no unique answer", Diagnostic::Kind::no_unique_answer},
    Named<Diagnostic::Kind>{"output", Diagnostic::Kind::output},
};

/// A text by the codes of the languages.
py::dict by_code(const Text& text) {
    py::dict all;
    for (const Language language : languages) all[py::str(code_of(language))] = py::str(text.in(language));
    return all;
}

py::list as_python(const Diagnostics& faults) {
    py::list all;
    for (const Diagnostic& each : faults) {
        const auto* const kind = std::find_if(fault_kinds.begin(), fault_kinds.end(),
                                              [&](const auto& named) { return named.value == each.kind; });
        all.append(py::make_tuple(std::string(kind->name), each.place, by_code(each.text), by_code(each.fault),
                                  by_code(each.remedy)));
    }
    return all;
}

}  // namespace

Language language_of(const std::string& code) {
    const Language language = language_named(code);
    if (language != Language::en || code == code_of(Language::en)) return language;
    std::string known;
    for (const Language each : languages) known += (known.empty() ? "" : ", ") + code_of(each);
    throw py::value_error("language \"" + code + "\": there are " + known);
}

std::vector<std::string> in(const std::vector<Text>& texts, const std::string& code) {
    const Language language = language_of(code);
    std::vector<std::string> all;
    for (const Text& each : texts) all.push_back(each.in(language));
    return all;
}

Lettering lettering_of(const std::string& name) { return chosen("text", name, letterings); }
TextForm text_form_of(const std::string& name) { return chosen("form", name, text_forms); }

DrawingOptions drawing_options(const py::dict& by_name) {
    DrawingOptions options;
    for (const auto& [key, value] : by_name) {
        const auto name = key.cast<std::string>();
        const auto text = [&value = value] { return value.cast<std::string>(); };
        const auto flag = [&value = value] { return value.cast<bool>(); };
        if (name == "lang")
            options.language = language_of(text());
        else if (name == "paper")
            options.paper = chosen(name, text(), papers);
        else if (name == "orientation")
            options.orientation = chosen(name, text(), orientations);
        else if (name == "dimensions")
            options.dimensions = chosen(name, text(), dimensions);
        else if (name == "detail")
            options.detail = chosen(name, text(), details);
        else if (name == "sheet")
            options.sheet = chosen(name, text(), sheets);
        else if (name == "steps")
            options.steps = flag();
        else if (name == "slides")
            options.slides = flag();
        else if (name == "grid")
            options.grid = flag();
        else if (name == "lever")
            options.lever = flag();
        else if (name == "figure")
            options.figure = text();
        else if (name == "author")
            options.author = text();
        else if (name == "date")
            options.date = text();
        else if (name == "theme")
            options.theme = text();
        else if (name == "theme_file")
            options.theme_file = text();
        else
            throw py::type_error("no option of a drawing is named \"" + name + "\"");
    }
    return options;
}

std::vector<ParameterValue> settings_of(const std::vector<std::pair<std::string, std::string>>& pairs) {
    std::vector<ParameterValue> all;
    for (const auto& [name, value] : pairs) all.push_back({name, value});
    return all;
}

void define_texts(py::module_& module) {
    module.attr("__version__") = std::string(version());
    std::vector<std::string> codes;
    for (const Language each : languages) codes.push_back(code_of(each));
    module.attr("languages") = py::tuple(py::cast(codes));
    module.def("theme_names", &theme_names);
    module.def("schema", [] { return std::string(mechanism_schema()); });
    module.def("pair_catalogue", [](const std::string& form, const std::string& lang) {
        return pair_catalogue(text_form_of(form), language_of(lang));
    });
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(std::move(thrown));
        } catch (const Faults& faults) {
            const py::object type = py::module_::import("kinegraph._errors").attr("Error");
            PyErr_SetObject(type.ptr(), type(as_python(faults.all())).ptr());
        }
    });
}

}  // namespace kinegraph::python
