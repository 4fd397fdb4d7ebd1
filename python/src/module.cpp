// The module signorini._core: the library's calls and answers, for the package around it.

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string>

#include "arrays.hpp"
#include "calls.hpp"
#include "motion.hpp"
#include "options.hpp"
#include "palette.hpp"
#include "scene.hpp"
#include "signorini/config.hpp"
#include "signorini/control.hpp"
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
    for (const auto& [name, inWords] :
         {std::pair{"waveSpeed", "wave_speed"}, std::pair{"axialStiffness", "axial_stiffness"}}) {
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
            text.replace(at, std::string_view(name).size(), inWords);
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

/// What the program's options of a question mean, by their names as Python has them.
py::dict optionsOf(const std::string& question)
{
    namespace asks = answers::asks;
    static const std::map<std::string, unsigned> questions{{"find", asks::find},
                                                           {"schedule", asks::schedule},
                                                           {"continuum", asks::continuum},
                                                           {"families", asks::families},
                                                           {"modes", asks::modes},
                                                           {"mode", asks::mode},
                                                           {"atlas", asks::atlas},
                                                           {"response", asks::response},
                                                           {"sweep", asks::sweep},
                                                           {"simulation", asks::simulation},
                                                           {"figure", 0}};
    py::dict meanings;
    for (const answers::Option& option : answers::options()) {
        std::string name(option.name.substr(2));
        std::replace(name.begin(), name.end(), '-', '_');
        if ((option.of & questions.at(question)) != 0 && !meanings.contains(name.c_str())) {
            const bool hasUnit =
                option.unit != "-" && option.sentence.find('[') == std::string::npos;
            meanings[name.c_str()] =
                fmt::format("{}{}{}.", option.sentence,
                            option.takes == answers::Takes::choice ? ": " + option.type : "",
                            hasUnit ? fmt::format(" [{}]", option.unit) : std::string());
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
    module.def("options", &optionsOf);
    module.def("quantity",
               [](const std::string& name, const std::string& text, const std::string& unit) {
                   return quantityOf(name, text, unit.empty() ? unitOfOption(name) : unit);
               });
    addErrors(module);
    addScene(module);
    addMotion(module);
    addFind(module);
    addLists(module);
    addPolytopes(module);
    addContinuum(module);
    addAtlas(module);
    addForced(module);
    addSimulate(module);
    addSceneFind(module);
    addSceneSimulation(module);
    addSweep(module);
}

}  // namespace signorini::python
