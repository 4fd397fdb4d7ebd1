#pragma once
/// \file
/// --motion FILE.csv|.vtk|.pvd: u, v, s over one period.

#include <cstdint>
#include <functional>
#include <string>

#include "files.hpp"

namespace signorini::cli {

/// Where a motion goes.
class MotionFile {
public:
    explicit MotionFile(const Given& given);

    [[nodiscard]] OutputOption option() const { return {"--motion", path_}; }
    /// The folder of a time series, an output like the file; without a name if there is none.
    [[nodiscard]] OutputOption folderOption() const;
    [[nodiscard]] bool isWanted() const { return !path_.empty(); }

    /// The samples with at most so many instants.
    using Sampling = std::function<MotionSamples(std::int64_t mostInstants)>;

    /// Writes the file, and for .pvd the folder beside it, if it was asked for. The last of the
    /// outputs: see `Outputs::stageFolder`.
    void write(Outputs& outputs, const Sampling& sampled) const;

private:
    std::string path_;
};

}  // namespace signorini::cli
