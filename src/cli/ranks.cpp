#include "ranks.hpp"

#include <cstdlib>

namespace signorini::cli {

bool Ranks::areLaunched()
{
    // Open MPI; MPICH and its relatives; Slurm's and other launchers' PMIx.
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"}) {
        if (std::getenv(variable) != nullptr) {
            return true;
        }
    }
    return false;
}

}  // namespace signorini::cli
