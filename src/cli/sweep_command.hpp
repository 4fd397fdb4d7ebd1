#pragma once
/// \file
/// signorini sweep

#include <optional>
#include <string>

#include "arguments.hpp"
#include "force_options.hpp"
#include "sweep_answer.hpp"

namespace signorini::cli {

/// One call.
struct SweepCommand {
    CommonOptions common;
    ForceOptions force;
    FrequencyOption frequency;
    Swept over = Swept::frequency;
    std::string from;
    std::string to;
    std::optional<double> fromHertz;
    std::optional<double> toHertz;
    std::int64_t points = 101;
    std::int64_t periods = 1000;
    bool goesUp = false;
    bool goesDown = false;
    bool startsAtRest = false;
    std::optional<double> resolution;   ///< [s]
    std::optional<double> yieldStress;  ///< [Pa]
    std::string csvFile;
    std::string figureFile;
    std::string bifurcationFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end it, and the values that
    /// were done are reported. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    /// What is asked, in units of the bar. \throws std::invalid_argument on options that are
    /// missing or do not go together.
    [[nodiscard]] SweepRange range(const Scene& scene, const Bar& bar) const;
    /// One end of the range, likewise.
    [[nodiscard]] double end(const char* option, const std::string& text,
                             const std::optional<double>& hertz, double otherwise,
                             const Bar& bar) const;
};

}  // namespace signorini::cli
