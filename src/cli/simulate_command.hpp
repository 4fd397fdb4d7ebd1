#pragma once
/// \file
/// signorini simulate

#include <optional>
#include <string>

#include "arguments.hpp"
#include "force_options.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// One call.
struct SimulateCommand {
    CommonOptions common;
    ForceOptions force;
    std::optional<double> frequencyRatio;  ///< of the excitation, ω/ω₁
    double phase = 0.0;                    ///< [rad]
    std::optional<double> time;            ///< [s]
    std::optional<std::int64_t> periods;
    bool fromRest = false;
    std::string fromFile;
    std::string eventsFile;
    std::string tipFile;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end it, and what was simulated
    /// is reported. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    void requireWhole() const;
    [[nodiscard]] Waves start(const Scene& scene) const;
    /// How many stretches of time are asked for, in units of which a crossing takes `crossing`.
    [[nodiscard]] double stretches(double stretch, double crossing, const Bar& bar) const;
    [[nodiscard]] Excitation excitation(const Bar& bar, double cells) const;
};

}  // namespace signorini::cli
