#pragma once
/// \file
/// What a simulation saw, in words, as JSON and as tables.

#include <span>
#include <string>
#include <vector>

#include "simulation_answer.hpp"

namespace signorini::cli {

using answers::SimulationAnswer;

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const SimulationAnswer& answer, const BarSimulation& simulation);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(SimulationAnswer answer, const BarSimulation& simulation);

/// All contacts: start, end [s], impulse [N s], peak force [N], of two stops which, and the largest
/// mean force over the resolution [N], then speed of approach [m/s] and energy that the stop turned
/// over [J]. \throws FileError.
void writeEvents(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The impacts at one contact.
struct Impacts {
    std::string contact;
    std::vector<double> impulse = {};  ///< [N s]
    std::vector<double> speed = {};    ///< [m/s], of approach
    std::vector<double> energy = {};   ///< [J], turned over; empty: not known
};

/// How many there were in so many seconds, and how their numbers are spread: a row for each
/// statistic and each part of a histogram. \throws FileError.
void writeStatistics(const std::string& path, std::span<const Impacts> all, double duration);
void writeStatistics(const std::string& path, const BarSimulation& simulation, const Bar& bar);

/// The path of the tip: time [s], displacement [m]. \throws FileError.
void writeTip(const std::string& path, const BarSimulation& simulation, const Bar& bar);

}  // namespace signorini::cli
