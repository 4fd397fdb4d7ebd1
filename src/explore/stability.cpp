#include <algorithm>
#include <cmath>
#include <random>

#include "faults.hpp"
#include "names.hpp"
#include "signorini/response.hpp"

namespace signorini {

namespace {

constexpr auto stabilityNames = std::to_array<Named<Stability>>({
    {Stability::attracts, "attracts"},
    {Stability::repels, "repels"},
    {Stability::unclear, "unclear"},
});

constexpr double diesOut = 0.1;
constexpr double grows = 10.0;
constexpr std::int64_t mostEvents = 20'000'000;  // of one disturbance, less than a second

void validate(const StabilityOptions& options)
{
    Faults faults;
    faults.requireWhole("periods", options.periods, 1'000'000);
    faults.requireWhole("draws", options.draws, 1'000);
    if (options.sizes.empty()) {
        faults.add("sizes", "none", "at least one");
    }
    for (const double size : options.sizes) {
        if (!(size > 0.0 && size < 1.0)) {
            faults.add("sizes", size, "numbers > 0, < 1");
        }
    }
    faults.throwIfAny();
}

/// The motion's waves, each times 1 + a number in [-size, size].
Waves besides(const ForcedMotion& motion, double size, std::mt19937_64& generator)
{
    Waves waves = wavesOf(motion.state);
    std::uniform_real_distribution<double> part(-size, size);
    for (auto* wave : {&waves.a, &waves.b}) {
        for (Piece& piece : *wave) {
            piece.value *= 1.0 + part(generator);
        }
    }
    // The tip must not stand inside the wall: by as much as it does, all cells give way evenly.
    const std::int64_t cells = motion.state.cells();
    const double tip = motion.excitation.baseDisplacement(0) + stretching(waves, cells)[cells];
    if (tip > 1.0) {
        for (Piece& piece : waves.a) {
            piece.value += tip - 1.0;
        }
    }
    return waves;
}

/// Largest distance of the displacements along the bar.
double distance(const Eigen::VectorXd& one, const Eigen::VectorXd& other)
{
    return (one - other).cwiseAbs().maxCoeff();
}

}  // namespace

std::string_view name(Stability stability)
{
    return nameIn(stabilityNames, stability);
}

StabilityResult stabilityOf(const ForcedMotion& motion, const StabilityOptions& options)
{
    validate(options);
    const std::int64_t cells = motion.state.cells();
    const Eigen::VectorXd still = stretching(wavesOf(motion.state), cells);
    const auto period = static_cast<double>(motion.excitation.steps());
    StabilityResult result;
    bool isShort = false;
    std::mt19937_64 generator(options.seed);
    for (const double size : options.sizes) {
        for (std::int64_t draw = 0; draw < options.draws; ++draw) {
            const Waves start = besides(motion, size, generator);
            StabilityTrial trial{size, distance(stretching(start, cells), still), 0.0};
            BarSimulation simulation(start, motion.damping, motion.excitation,
                                     {.mergeBelow = options.mergeBelow, .recordsTip = false});
            const auto goesOn = [&] {
                return simulation.events() < mostEvents && !isRequested(options.cancel);
            };
            for (std::int64_t k = 0; k < options.periods && goesOn(); ++k) {
                simulation.advance(period);
            }
            isShort = isShort || !goesOn();
            trial.end = distance(stretching(simulation.waves(), cells), still);
            result.trials.push_back(trial);
        }
    }
    const auto& trials = result.trials;
    if (isRequested(options.cancel)) {
        return result;
    }
    if (std::any_of(trials.begin(), trials.end(),
                    [](const StabilityTrial& trial) { return trial.end > grows * trial.start; })) {
        result.stability = Stability::repels;
    } else if (!isShort &&
               std::all_of(trials.begin(), trials.end(), [](const StabilityTrial& trial) {
                   return trial.end < diesOut * trial.start;
               })) {
        result.stability = Stability::attracts;
    }
    return result;
}

}  // namespace signorini
