// The module signorini._core: the library's calls and answers, for the package around it.

#include <pybind11/pybind11.h>

#include "atlas.hpp"
#include "continuum.hpp"
#include "find.hpp"
#include "forced.hpp"
#include "lists.hpp"
#include "motion.hpp"
#include "palette.hpp"
#include "scene.hpp"
#include "signorini/config.hpp"
#include "signorini/control.hpp"
#include "simulate.hpp"
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
        }
    });
}

/// One truth of colours.
py::dict colours()
{
    const auto list = [](const auto& colours) {
        py::list names;
        for (const char* colour : colours) {
            names.append(colour);
        }
        return names;
    };
    py::dict dict;
    dict["ink"] = palette::ink;
    dict["strain"] = palette::strain;
    dict["velocity"] = palette::velocity;
    dict["contact"] = palette::contact;
    dict["faint"] = palette::faint;
    dict["grid"] = palette::grid;
    dict["sequence"] = list(palette::sequence);
    dict["on_paper"] = palette::onPaper;
    dict["diverging"] = list(palette::diverging);
    dict["fading"] = list(palette::fading);
    return dict;
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

}  // namespace

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The compiled part of signorini.";
    py::options options;
    options.disable_function_signatures();
    module.attr("__version__") = SIGNORINI_VERSION;
    module.def("palette", &colours);
    module.def("backends", &versionsOfBackends);
    addErrors(module);
    addScene(module);
    addMotion(module);
    addFind(module);
    addLists(module);
    addPolytopes(module);
    addModeMotions(module);
    addContinuum(module);
    addAtlas(module);
    addForced(module);
    addResponse(module);
    addSimulate(module);
}

}  // namespace signorini::python
