#pragma once
/// \file
/// signorini simulate

#include <optional>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "given.hpp"
#include "simulation_answer.hpp"

namespace signorini::cli {

/// One call.
struct SimulateCommand {
    const Given& given;
    CommonOptions common;
    ForceOptions force;
    FrequencyOption frequency;
    std::optional<double> time;  ///< [s]
    std::optional<std::int64_t> periods;
    std::vector<double> speeds;                           ///< [m/s], one for each bar
    std::optional<std::pair<double, double>> forceRange;  ///< [N], least and most

    explicit SimulateCommand(const Given& words);

    [[nodiscard]] ExitStatus run() const;

    /// The force of --force-file in units of so many newtons: its mean in each of so many steps of
    /// so many seconds, one more than are begun.
    [[nodiscard]] std::vector<double> forceHistory(double step, double newtons, double steps) const;

private:
    /// Is it a question for the simulation of a network?
    [[nodiscard]] bool isOfNetwork() const
    {
        return (common.hasScene() && !isDampedBar()) || forceRange || !speeds.empty();
    }
    /// One bar in words, with --damping, which several do not take.
    [[nodiscard]] bool isDampedBar() const
    {
        return force.ratio && !common.sceneText.empty() && barOf(common.assembly());
    }
    /// The start, `base` [g] the place of the base then.
    [[nodiscard]] Waves start(const Scene& scene, double base) const;
    [[nodiscard]] Excitation excitation(std::optional<answers::Drive>& drive, const Bar& bar,
                                        double cells) const;
};

/// Any bars with any contacts, event by event: a call with --scene, --velocity or --gravity.
[[nodiscard]] ExitStatus simulateScene(const SimulateCommand& command);

/// What a force of --force-range, whatever it does between its ends, can make of the bars.
[[nodiscard]] ExitStatus reportReach(const SimulateCommand& command);

}  // namespace signorini::cli
