#pragma once
/// \file
/// signorini simulate

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "force_options.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// One call.
struct SimulateCommand {
    CommonOptions common;
    ForceOptions force;
    FrequencyOption frequency;
    double phase = 0.0;          ///< [rad]
    std::optional<double> time;  ///< [s]
    std::optional<std::int64_t> periods;
    std::optional<double> resolution;  ///< [s]
    bool fromRest = false;
    std::string fromFile;
    std::string eventsFile;
    std::string tipFile;
    std::string figureFile;
    std::vector<double> speeds;  ///< [m/s], one for each bar
    std::string stateFile;
    std::string forceFile;
    std::optional<std::pair<double, double>> forceRange;  ///< [N], least and most
    std::string statisticsFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end it, and what was simulated
    /// is reported. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

    /// \throws std::invalid_argument on options that do not go together.
    void requireWhole() const;

    /// The force of --force-file in units of so many newtons: its mean in each of so many steps of
    /// so many seconds, one more than are begun.
    [[nodiscard]] std::vector<double> forceHistory(double step, double newtons, double steps) const;

private:
    /// Is it a question for the simulation of a network?
    [[nodiscard]] bool isOfNetwork() const
    {
        return common.hasScene() || forceRange || common.gravity != 0.0 || !speeds.empty() || !stateFile.empty();
    }
    /// The start, `base` [g] the place of the base then.
    [[nodiscard]] Waves start(const Scene& scene, double base) const;
    /// How many stretches of time are asked for, in units of which a crossing takes `crossing`.
    [[nodiscard]] double stretches(double stretch, double crossing, const Bar& bar) const;
    [[nodiscard]] Excitation excitation(const Bar& bar, double cells) const;
};

}  // namespace signorini::cli
