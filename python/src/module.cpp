// The module signorini._core: the library's calls and answers, for the package around it.

#include <algorithm>
#include <array>

#include "calls.hpp"
#include "options.hpp"
#include "palette.hpp"
#include "signorini/config.hpp"
#include "solver.hpp"

namespace signorini::python {

namespace {

void addErrors(py::module_& module)
{
    static py::exception<BackendUnavailable> missing(module, "BackendUnavailable",
                                                     PyExc_RuntimeError);
    py::register_exception_translator([](std::exception_ptr trouble) {
        try {
            std::rethrow_exception(trouble);
        } catch (const BackendUnavailable& error) {
            missing(error.what());
        } catch (const FileError& error) {
            PyErr_SetString(PyExc_OSError, error.what());
        } catch (const std::invalid_argument& error) {
            const py::object words = py::module_::import("signorini._blame").attr("in_python");
            PyErr_SetObject(PyExc_ValueError, words(error.what()).ptr());
        }
    });
}

/// One truth of colours.
py::dict colours()
{
    using namespace py::literals;
    return py::dict("ink"_a = palette::ink, "strain"_a = palette::strain,
                    "velocity"_a = palette::velocity, "contact"_a = palette::contact,
                    "faint"_a = palette::faint, "grid"_a = palette::grid,
                    "sequence"_a = palette::sequence, "on_paper"_a = palette::onPaper,
                    "diverging"_a = palette::diverging, "fading"_a = palette::fading);
}

/// Name to version, None where this build does without.
py::dict versionsOfBackends()
{
    py::dict versions;
    for (const Backend& backend : backends()) {
        versions[py::str(backend.name.data(), backend.name.size())] =
            backend.available() ? py::object(py::str(backend.version())) : py::none();
    }
    return versions;
}

/// What the options of a command mean, by their names as Python has them.
py::dict meaningsOf(const std::string& command)
{
    py::dict meanings;
    for (const Option& option : options()) {
        const std::string name = nameOf(option.name);
        const std::string commands = fmt::format(", {},", commandsOf(option.of));
        if (commands.find(fmt::format(", {},", command)) != std::string::npos &&
            !meanings.contains(name.c_str())) {
            meanings[name.c_str()] = option.meaning();
        }
    }
    return meanings;
}

}  // namespace

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The compiled part of signorini.";
    py::options options;
    options.disable_function_signatures();
    module.attr("__version__") = SIGNORINI_VERSION;
    module.def("palette", &colours);
    module.def("backends", &versionsOfBackends);
    module.def("options", &meaningsOf);
    module.def("argument", &nameOf);
    module.def("numbers", &numbersOf);
    module.def("quantity",
               [](const std::string& name, const std::string& text, const std::string& unit) {
                   return quantityOf(name, text, unit.empty() ? unitOfOption(name) : unit);
               });
    addErrors(module);
    addScene(module);
    addMotion(module);
    addFind(module);
    addModes(module);
    addAtlas(module);
    addForced(module);
    addSimulate(module);
    addSweep(module);
}

}  // namespace signorini::python
