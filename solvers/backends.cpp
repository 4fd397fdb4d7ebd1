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
using Make = std::unique_ptr<Solver> (*)();

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
                .purpose = "linear programs by the primal simplex method"},
        Backend{.name = "glpk-interior",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .version = glpkVersion,
                .make = glpkInterior,
                .purpose = "linear programs by an interior-point method"},
        Backend{.name = "glpk-exact",
                .library = "GLPK",
                .option = "SIGNORINI_WITH_GLPK",
                .version = glpkVersion,
                .make = glpkExact,
                .purpose = "linear programs by the simplex method in rational numbers"},
        Backend{.name = "ipopt",
                .library = "Ipopt",
                .option = "SIGNORINI_WITH_IPOPT",
                .version = ipoptVersion,
                .make = ipoptMake,
                .purpose = "convex quadratic programs and a given energy, interior point"},
        Backend{.name = "nlopt-slsqp",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .version = nloptVersion,
                .make = nloptSlsqp,
                .purpose = "the same for medium sizes, sequential least squares"},
        Backend{.name = "nlopt-auglag",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .version = nloptVersion,
                .make = nloptAuglag,
                .purpose = "the same for medium sizes, augmented Lagrangian"},
        Backend{.name = "nlopt-cobyla",
                .library = "NLopt",
                .option = "SIGNORINI_WITH_NLOPT",
                .version = nloptVersion,
                .make = nloptCobyla,
                .purpose = "the same for small sizes, without derivatives"},
    };
    return table;
}

}  // namespace signorini
