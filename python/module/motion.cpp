// Sweeps and cams.
#include <limits>
#include <optional>

#include "python/module/bindings.hpp"

namespace kinegraph::python {
namespace {

/// Doubles as bytes, of which NumPy makes an array. (pybind11's own arrays import NumPy within the initialization of a
/// static variable: two threads that make their first array wait for each other.)
py::bytes bytes_of(const std::vector<double>& values) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes of doubles
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

/// All rows, one after the other, NaN where a quantity grows without limit.
py::bytes rows_of(Sweep& sweep) {
    const std::vector<double> cells = unlocked([&] {
        std::vector<double> all;
        given(sweep.for_each_row([&](const SweepRow& row) {
            for (const std::optional<double>& cell : row)
                all.push_back(cell.value_or(std::numeric_limits<double>::quiet_NaN()));
            return true;
        }));
        return all;
    });
    return bytes_of(cells);
}

/// The rows as the text of a file.
std::string text_of(Sweep& sweep, RowsText::Form form) {
    std::string text;
    given(unlocked([&] {
        return sweep.write({{form, [&](std::string_view piece) {
                                 text += piece;
                                 return true;
                             }}});
    }));
    return text;
}

SweepOptions sweep_options(const py::dict& by_name) {
    SweepOptions options;
    for (const auto& [key, value] : by_name) {
        const auto name = key.cast<std::string>();
        const auto text = [&value = value] { return value.cast<std::string>(); };
        const auto texts = [&value = value] { return value.cast<std::vector<std::string>>(); };
        if (name == "driver")
            options.driver = text();
        else if (name == "along")
            for (const auto& [driver, step] : value.cast<std::vector<std::pair<std::string, std::string>>>())
                options.along.push_back({driver, step});
        else if (name == "branch")
            options.branch = value.cast<int>();
        else if (name == "over")
            options.over = text();
        else if (name == "start")
            options.from = text();
        else if (name == "stop")
            options.to = text();
        else if (name == "step")
            options.step = text();
        else if (name == "steps")
            options.steps = value.cast<long>();
        else if (name == "plots")
            options.plots = texts();
        else if (name == "columns")
            options.columns = text();
        else if (name == "traces")
            options.traces = texts();
        else if (name == "centrodes")
            options.centrodes = texts();
        else if (name == "poses")
            options.poses = value.cast<int>();
        else
            throw py::type_error("no option of a sweep is named \"" + name + "\"");
    }
    return options;
}

void define_sweeps(py::module_& module) {
    py::class_<Sweep>(module, "Sweep")
        .def_static("of",
                    [](const MechanismFile& file, const py::dict& options) {
                        const SweepOptions wanted = sweep_options(options);
                        return given(unlocked([&] { return Sweep::of(file, wanted); }));
                    })
        .def("columns",
             [](const Sweep& sweep) {
                 std::vector<std::pair<std::string, std::string>> all;
                 for (const SweepColumn& each : sweep.columns()) all.emplace_back(each.name, each.unit);
                 return all;
             })
        .def("rows", &rows_of)
        .def("csv", [](Sweep& sweep) { return text_of(sweep, RowsText::Form::csv); })
        .def("json", [](Sweep& sweep) { return text_of(sweep, RowsText::Form::json); })
        .def("limits", &Sweep::limits)
        .def("change_points", &Sweep::change_points)
        .def("poles",
             [](const Sweep& sweep) {
                 std::vector<std::pair<std::string, double>> all;
                 for (const SweepPole& each : sweep.poles()) all.emplace_back(each.column, each.at);
                 return all;
             })
        .def("separations",
             [](const Sweep& sweep) {
                 std::vector<std::tuple<std::string, double, double>> all;
                 for (const SweepSeparation& each : sweep.separations())
                     all.emplace_back(each.joint, each.from, each.to);
                 return all;
             })
        .def("remarks", [](const Sweep& sweep, const std::string& lang) { return in(sweep.remarks(), lang); })
        .def("summary", [](const Sweep& sweep, const std::string& lang) { return in(sweep.summary(), lang); })
        .def("largest_difference", &Sweep::largest_difference)
        .def("draw", [](Sweep& sweep, const py::dict& options) {
            const DrawingOptions wanted = drawing_options(options);
            return given(unlocked([&] { return draw(sweep, wanted); }));
        });
}

void define_cams(py::module_& module) {
    py::class_<CamPosition>(module, "CamPosition")
        .def_readonly("turn", &CamPosition::turn)
        .def_readonly("rise", &CamPosition::rise)
        .def_readonly("contact", &CamPosition::contact)
        .def_readonly("pressure_angle", &CamPosition::pressure_angle)
        .def_readonly("curvature", &CamPosition::curvature);
    py::class_<CamFile>(module, "CamFile")
        .def_static("parse",
                    [](const std::string& text, const std::string& name) { return given(CamFile::parse(text, name)); })
        .def("at", &CamFile::at)
        .def("profile",
             [](const CamFile& cam, int positions) {
                 std::vector<double> all;
                 for (const auto& [x, y] : cam.profile(positions)) all.insert(all.end(), {x, y});
                 return bytes_of(all);
             })
        .def("mechanism_at", &CamFile::mechanism_at);
    py::class_<CamCycle>(module, "CamCycle")
        .def_static("of",
                    [](const CamFile& cam, const std::string& at, long steps) {
                        const CamOptions options{at, steps, {}};
                        return given(unlocked([&] { return CamCycle::of(cam, options); }));
                    })
        .def("csv", &CamCycle::csv)
        .def("facts", [](const CamCycle& cycle, const std::string& lang) { return in(cycle.facts(), lang); })
        .def("remarks", [](const CamCycle& cycle, const std::string& lang) { return in(cycle.remarks(), lang); })
        .def("keeps_law", &CamCycle::keeps_law)
        .def("draw", [](const CamCycle& cycle, const py::dict& options) {
            const DrawingOptions wanted = drawing_options(options);
            return given(unlocked([&] { return draw(cycle, wanted); }));
        });
}

}  // namespace

void define_motion(py::module_& module) {
    define_sweeps(module);
    define_cams(module);
}

}  // namespace kinegraph::python
