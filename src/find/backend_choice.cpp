#include "backend_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace signorini {

namespace {

using Preference = std::array<std::string_view, 2>;
constexpr Preference forEnergy{"ipopt", "nlopt-auglag"};
constexpr Preference forSquares{"ipopt", "nlopt-slsqp"};
constexpr Preference forLines{"glpk-simplex", "ipopt"};
constexpr std::string_view withDuals = "glpk-simplex";

bool isAvailable(std::string_view solver)
{
    return findBackend(solver).available();
}

bool hasAny(const Preference& solvers)
{
    return std::any_of(solvers.begin(), solvers.end(), isAvailable);
}

}  // namespace

void requireBackend(std::string_view solver)
{
    if (solver != automaticChoice && !isAvailable(solver)) {
        (void)makeSolver(solver);  // throws, and says how to get it
    }
}

bool canMinimiseSquares()
{
    return hasAny(forSquares);
}

bool canHoldEnergy()
{
    return hasAny(forEnergy);
}

std::string backendFor(const Program& program, const std::string& solver)
{
    if (solver != automaticChoice) {
        return solver;
    }
    const Preference& suited = program.energy                 ? forEnergy
                               : program.quadratic.size() > 0 ? forSquares
                                                              : forLines;
    const auto* first = std::find_if(suited.begin(), suited.end(), isAvailable);
    if (first == suited.end()) {
        throw BackendUnavailable(
            fmt::format("this request needs one of the solvers {}: none is in this build",
                        fmt::join(suited, ", ")));
    }
    return std::string(*first);
}

std::unique_ptr<Solver> simplexWithDuals()
{
    return isAvailable(withDuals) ? makeSolver(withDuals) : nullptr;
}

}  // namespace signorini
