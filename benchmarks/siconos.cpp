#include "siconos.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "signorini/output.hpp"
#include "solver.hpp"

namespace signorini::bench {

namespace {

/// The initial state at nodes, as other codes want it.
void writeNodes(const std::filesystem::path& path, const State& state)
{
    const Eigen::VectorXd u = displacement(state);
    const Eigen::VectorXd v = velocity(state);
    const Eigen::Index last = u.size() - 1;
    TextFile file(path.string());
    file.write("x,displacement,velocity\n0,0,0\n");
    for (Eigen::Index i = 0; i <= last; ++i) {
        const double nodal = i < last ? 0.5 * (v[i] + v[i + 1]) : v[i];
        file.write(fmt::format(
            "{},{},{}\n", static_cast<double>(i + 1) / static_cast<double>(last + 1), u[i], nodal));
    }
    file.close();
}

/// Which Python has Siconos; Debian's own is not always the first in the path.
std::string pythonWithSiconos()
{
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        if (std::system(fmt::format("{} -c 'import siconos.kernel'", python).c_str()) == 0) {
            return python;
        }
    }
    throw BackendUnavailable("no python3 here imports siconos: install python3-siconos");
}

}  // namespace

TimeSteps runSiconos(const SiconosRun& run)
{
    const std::string python = pythonWithSiconos();
    const std::filesystem::path input =
        temporaryDirectory() / fmt::format("signorini-bench-{}.csv", getpid());
    writeNodes(input, run.state);
    const std::string command =
        fmt::format("{} '{}/siconos_bar.py' '{}' {} {} {} {} {} {} {}", python, SIGNORINI_RIVALS,
                    input.string(), run.elements, run.steps, run.period, run.periods, run.dashpot,
                    run.amplitude, run.phase);
    TimeSteps result;
    {
        const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
        std::string line(200, '\0');
        while (pipe && std::fgets(line.data(), static_cast<int>(line.size()), pipe.get())) {
            std::istringstream words(line);
            Sample sample{};
            if (line.starts_with("seconds ")) {
                words.ignore(8);
                words >> result.seconds;
            } else if (words >> sample.time >> sample.tip >> sample.energy) {
                result.samples.push_back(sample);
            }
        }
    }
    std::filesystem::remove(input);
    if (result.samples.size() !=
        static_cast<std::size_t>(run.steps) * static_cast<std::size_t>(run.periods)) {
        throw std::runtime_error("Siconos ended before the last step");
    }
    return result;
}

}  // namespace signorini::bench
