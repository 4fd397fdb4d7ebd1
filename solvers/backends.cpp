// The one table of back ends. Adding one is four edits: see solvers/README.md.

#include <array>

#include "signorini/config.hpp"
#include "solver.hpp"
#if SIGNORINI_HAS_GLPK
#include "glpk/glpk.hpp"
#endif
#if SIGNORINI_HAS_IPOPT
#include "ipopt/ipopt.hpp"
#endif
#if SIGNORINI_HAS_NLOPT
#include "nlopt/nlopt.hpp"
#endif

namespace signorini {

namespace {

using Version = std::string (*)();
using Make = std::unique_ptr<Solver> (*)(const Backend&);

std::string ownVersion()
{
    return SIGNORINI_VERSION;
}

#if SIGNORINI_HAS_GLPK
constexpr Version glpkVersion = glpk::version;
constexpr Make glpkSimplex = glpk::makeSimplex;
constexpr Make glpkInterior = glpk::makeInterior;
constexpr Make glpkExact = glpk::makeExact;
#else
constexpr Version glpkVersion = nullptr;
constexpr Make glpkSimplex = nullptr;
constexpr Make glpkInterior = nullptr;
constexpr Make glpkExact = nullptr;
#endif

#if SIGNORINI_HAS_IPOPT
constexpr Version ipoptVersion = ipopt::version;
constexpr Make ipoptMake = ipopt::makeIpopt;
#else
constexpr Version ipoptVersion = nullptr;
constexpr Make ipoptMake = nullptr;
#endif

#if SIGNORINI_HAS_NLOPT
constexpr Version nloptVersion = nlopt::version;
constexpr Make nloptSlsqp = nlopt::makeSlsqp;
constexpr Make nloptAuglag = nlopt::makeAuglag;
constexpr Make nloptCobyla = nlopt::makeCobyla;
#else
constexpr Version nloptVersion = nullptr;
constexpr Make nloptSlsqp = nullptr;
constexpr Make nloptAuglag = nullptr;
constexpr Make nloptCobyla = nullptr;
#endif

constexpr Capabilities simplex{.detectsInfeasibility = true,
                               .duals = true,
                               .iterationLimit = true,
                               .timeLimit = true,
                               .cancel = true};
constexpr Capabilities interior{.duals = true, .cancel = true};
constexpr Capabilities local{.quadraticObjective = true,
                             .energyEquality = true,
                             .iterationLimit = true,
                             .timeLimit = true,
                             .start = true,
                             .cancel = true};

}  // namespace

std::span<const Backend> backends()
{
    // What is chosen where nobody names a solver is looked for from the top down.
    static constexpr std::array table{
        Backend{.name = "closed-form",
                .purpose = "exact solution set of a schedule, least and most energy",
                .version = ownVersion},
        Backend{.name = "glpk-simplex",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .purpose = "linear programs by the primal simplex method",
                .can = simplex,
                .chosenFor = {.linear = true},
                .version = glpkVersion,
                .make = glpkSimplex},
        Backend{.name = "glpk-interior",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .purpose = "linear programs by an interior-point method",
                .can = interior,
                .version = glpkVersion,
                .make = glpkInterior},
        Backend{.name = "glpk-exact",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .purpose = "linear programs by the simplex method in rational numbers",
                .can = simplex,
                .version = glpkVersion,
                .make = glpkExact},
        Backend{.name = "ipopt",
                .library = "Ipopt",
                .option = "SIGNORINI_WITH_IPOPT",
                .purpose = "convex quadratic programs and a given energy, interior point",
                .can = local,
                .chosenFor = {.linear = true, .quadratic = true, .heldEnergy = true},
                .version = ipoptVersion,
                .make = ipoptMake},
        Backend{.name = "nlopt-slsqp",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .purpose = "the same for medium sizes, sequential least squares",
                .can = local,
                .mostUnknowns = 400,
                .chosenFor = {.quadratic = true},
                .version = nloptVersion,
                .make = nloptSlsqp},
        Backend{.name = "nlopt-auglag",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .purpose = "the same for medium sizes, augmented Lagrangian",
                .can = local,
                .mostUnknowns = 400,
                .chosenFor = {.heldEnergy = true},
                .version = nloptVersion,
                .make = nloptAuglag},
        Backend{.name = "nlopt-cobyla",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .purpose = "the same for small sizes, without derivatives",
                .can = local,
                .mostUnknowns = 40,
                .version = nloptVersion,
                .make = nloptCobyla},
    };
    return table;
}

}  // namespace signorini
