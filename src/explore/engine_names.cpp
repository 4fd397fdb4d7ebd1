#include "engine_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "faults.hpp"
#include "solver.hpp"

namespace signorini {

namespace {

/// Words for solvers that have another name in the table of back ends.
constexpr std::array engines{
    std::pair<std::string_view, std::string_view>{"geometric", "closed-form"},
    std::pair<std::string_view, std::string_view>{"nlopt", "nlopt-auglag"},
};

}  // namespace

std::string solverOfEngine(std::string_view engine, std::string_view argument)
{
    for (const auto& [word, solver] : engines) {
        if (engine == word) {
            return std::string(solver);
        }
    }
    const auto table = backends();
    if (engine != "auto" && std::none_of(table.begin(), table.end(), [&](const Backend& backend) {
            return backend.name == engine;
        })) {
        throwFault(argument, engine.empty() ? "''" : engine,
                   "auto|geometric|ipopt|nlopt, or a back end");
    }
    return std::string(engine);
}

std::string engineOf(const std::string& solver)
{
    for (const auto& [word, of] : engines) {
        if (of == solver) {
            return std::string(word);
        }
    }
    return solver;
}

}  // namespace signorini
