// The one table of back ends. Adding one is four edits: see solvers/README.md.

#include <array>

#include "signorini/config.hpp"
#include "signorini/solver.hpp"
#if SIGNORINI_HAS_GLPK
#include "glpk/glpk_solver.hpp"
#endif

namespace signorini {

namespace {

using Version = std::string (*)();
using Make = std::unique_ptr<Solver> (*)();

std::string ownVersion()
{
    return SIGNORINI_VERSION;
}

#if SIGNORINI_HAS_GLPK
constexpr Version glpkVersion = glpk::version;
constexpr Make glpkSimplex = glpk::makeSimplex;
#else
constexpr Version glpkVersion = nullptr;
constexpr Make glpkSimplex = nullptr;
#endif

}  // namespace

std::span<const Backend> backends()
{
    static const std::array table{
        Backend{.name = "closed-form",
                .library = "",
                .option = "",
                .version = ownVersion,
                .make = nullptr,
                .purpose = "exact solution set of a schedule, least and most energy"},
        Backend{.name = "glpk-simplex",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .version = glpkVersion,
                .make = glpkSimplex,
                .purpose = "linear programs by the primal simplex method with presolve"},
    };
    return table;
}

}  // namespace signorini
