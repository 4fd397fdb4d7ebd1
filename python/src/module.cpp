// The module signorini._core: the library's calls and answers, for the package around it.

#include <pybind11/pybind11.h>

#include <cctype>
#include <stdexcept>
#include <string>

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

/// The library's words with its names as Python has them: "maxOrder = 0 ..." is of max_order.
std::string inPython(const std::string& words)
{
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::size_t end = words.find_first_of(" \n,;:.()", k);
        const bool isName = end != std::string::npos && words.compare(end, 3, " = ") == 0;
        const bool isHump = k > 0 && std::islower(static_cast<unsigned char>(words[k - 1])) != 0 &&
                            std::isupper(static_cast<unsigned char>(words[k])) != 0;
        if (isName && isHump) {
            text += '_';
            text += static_cast<char>(std::tolower(static_cast<unsigned char>(words[k])));
        } else {
            text += words[k];
        }
    }
    return text;
}

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
            PyErr_SetString(PyExc_ValueError, inPython(error.what()).c_str());
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
    addSweep(module);
}

}  // namespace signorini::python
