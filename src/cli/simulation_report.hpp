#pragma once
/// \file
/// What a simulation saw, in words, as JSON and as tables.

#include <string>

#include "simulation_answer.hpp"

namespace signorini::cli {

using answers::SimulationAnswer;

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const SimulationAnswer& answer, const BarSimulation& simulation);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(SimulationAnswer answer, const BarSimulation& simulation);

/// All contacts: start, end [s], impulse [N s], peak force [N], of two stops which, and the largest
/// mean force over the resolution [N]. \throws FileError.
void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The path of the tip: time [s], displacement [m]. \throws FileError.
void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar);

}  // namespace signorini::cli
