// The program without MPI.

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "ranks.hpp"

namespace signorini::cli {

void handOverToMpi(char** arguments)
{
    if (!Ranks::areLaunched()) {
        return;
    }
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string other = self.parent_path() / "signorini-mpi";
    if (!error && access(other.c_str(), X_OK) == 0) {
        execv(other.c_str(), arguments);
    }
}

Ranks::Ranks()
{
    throw BackendUnavailable(
        "mpirun: the program signorini-mpi is not installed beside signorini; run one process "
        "with --threads, or build with -DSIGNORINI_WITH_MPI=ON");
}

Ranks::~Ranks() = default;

std::unique_ptr<BatchSource> Ranks::share(const AtlasRange&, std::int64_t, Cancel, std::int64_t)
{
    return nullptr;
}

bool Ranks::serve(std::int64_t, const Cancel&)
{
    return false;
}

DealRows Ranks::dealt(std::string, const RowOf&, std::int64_t)
{
    return {};
}

bool Ranks::serveRows(const std::function<RowOf(const std::string&)>&, std::int64_t)
{
    return false;
}

}  // namespace signorini::cli
