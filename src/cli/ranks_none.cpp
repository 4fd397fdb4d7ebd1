// A build without MPI: several processes that share work are refused.

#include "ranks.hpp"
#include "signorini/solver.hpp"

namespace signorini::cli {

Ranks::Ranks()
{
    throw BackendUnavailable(
        "mpirun: this build has no MPI; run one process with --threads, or build with "
        "-DSIGNORINI_WITH_MPI=ON");
}

Ranks::~Ranks() = default;

std::unique_ptr<BatchSource> Ranks::share(const AtlasRange&, std::int64_t, std::stop_token,
                                          std::int64_t)
{
    return nullptr;
}

bool Ranks::serve(std::int64_t, const std::stop_token&)
{
    return false;
}

}  // namespace signorini::cli
