#include "backend_choice.hpp"

namespace signorini {

void requireBackend(std::string_view solver)
{
    if (solver != automaticChoice && !findBackend(solver).available()) {
        (void)makeSolver(solver);  // throws, and says how to get it
    }
}

std::string backendFor(const Program& program, const std::string& solver)
{
    return solver != automaticChoice ? solver : std::string(choose(needsOf(program)).name);
}

std::unique_ptr<Solver> simplexWithDuals()
{
    const Backend* simplex = preferred({.duals = true});
    return simplex != nullptr ? makeSolver(*simplex) : nullptr;
}

}  // namespace signorini
