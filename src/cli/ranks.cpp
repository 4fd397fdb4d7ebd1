#include "ranks.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace signorini::cli {

bool Ranks::areLaunched()
{
    // Open MPI; MPICH and its relatives; Slurm's and other launchers' PMIx.
    constexpr std::array variables{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
    return std::any_of(variables.begin(), variables.end(), [](const char* variable) {
        return std::getenv(variable) != nullptr;  // NOLINT(concurrency-mt-unsafe): no setenv here
    });
}

}  // namespace signorini::cli
