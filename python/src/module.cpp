// The module signorini._core: the library's calls and answers, for the package around it.

#include <algorithm>
#include <array>
#include <cctype>

#include "calls.hpp"
#include "options.hpp"
#include "palette.hpp"
#include "signorini/config.hpp"
#include "solver.hpp"

namespace signorini::python {

namespace {

/// The library's words with its names as Python has them: "maxOrder = 0 ..." is of max_order, and
/// --max-order too.
std::string inPython(std::string words)
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz-";
    const auto isIn = [](char letter, char first, char last) {
        return first <= letter && letter <= last;
    };
    for (std::size_t k = 0; k + 2 < words.size(); ++k) {
        const std::string_view rest = std::string_view(words).substr(k);
        if (rest.starts_with("--") && isIn(rest[2], 'a', 'z')) {
            const std::size_t end = std::min(rest.find_first_not_of(letters), rest.size());
            words.replace(k, end, nameOf(rest.substr(0, end)));
        } else if (isIn(rest[0], 'a', 'z') && isIn(rest[1], 'A', 'Z')) {
            const std::size_t end = std::min(rest.find_first_of(" \n,;:.()"), rest.size());
            if (rest.substr(end).starts_with(" = ") || rest.starts_with("eSpeed") ||
                rest.starts_with("lStiffness")) {
                const int lower = std::tolower(static_cast<unsigned char>(rest[1]));
                words.replace(k + 1, 1, {'_', static_cast<char>(lower)});
            }
        }
    }
    return words;
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

/// What the options of a command mean, by their names as Python has them.
py::dict meaningsOf(const std::string& command)
{
    py::dict meanings;
    for (const Option& option : options()) {
        std::string name(option.name.substr(2));
        std::replace(name.begin(), name.end(), '-', '_');
        const std::string commands = fmt::format(", {},", commandsOf(option.of));
        if (commands.find(fmt::format(", {},", command)) != std::string::npos &&
            !meanings.contains(name.c_str())) {
            const bool hasUnit =
                option.unit != "-" && option.sentence.find('[') == std::string::npos;
            meanings[name.c_str()] = fmt::format(
                "{}{}{}.", option.sentence, option.takes == Takes::choice ? ": " + option.type : "",
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
    module.def("options", &meaningsOf);
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
