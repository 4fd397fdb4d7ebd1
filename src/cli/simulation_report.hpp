#pragma once
/// \file
/// What a simulation saw, in words, as JSON and as tables.

#include <optional>
#include <string>

#include "signorini/bar.hpp"
#include "signorini/settling.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// The outcome of one call.
struct SimulationAnswer {
    Scene scene;
    Damping damping;
    std::optional<double> amplitude;  ///< [N] or [m], of an excitation
    Excitation excitation;
    double frequencyRatio = 0.0;  ///< of the excitation, omega/omega_1
    double phase = 0.0;           ///< [rad]
    std::int64_t cells = 0;
    double resolution = 0.0;  ///< [L/c], SimulationOptions::resolution
    Settling settling;
    bool isComplete = true;

    /// Period of the excitation [L/c]; 0 without.
    [[nodiscard]] double period() const
    {
        return static_cast<double>(excitation.steps()) / excitation.stepsPerCrossing;
    }
};

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const SimulationAnswer& answer, const BarSimulation& simulation);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const SimulationAnswer& answer, const BarSimulation& simulation);

/// All contacts: start, end [s], impulse [N s], peak force [N], of two stops which, and the largest
/// mean force over the resolution [N]. \throws FileError.
void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The path of the tip: time [s], displacement [m]. \throws FileError.
void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar);

}  // namespace signorini::cli
