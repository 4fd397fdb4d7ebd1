#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "echo.hpp"
#include "faults.hpp"
#include "names.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"

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

/// What is disturbed.
struct Course {
    const State& state;
    const Damping& damping;
    const Excitation& excitation;
    const Stops& stops;
    double period;  ///< [steps]
};

/// The motion's waves, each times 1 + a number in [-size, size].
Waves besides(const Course& course, double size, std::mt19937_64& generator)
{
    Waves waves = wavesOf(course.state);
    std::uniform_real_distribution<double> part(-size, size);
    for (auto* wave : {&waves.a, &waves.b}) {
        for (Piece& piece : *wave) {
            piece.value *= 1.0 + part(generator);
        }
    }
    // The tip must not stand inside a stop: by as much as it does, all cells give way evenly.
    const std::int64_t cells = course.state.cells();
    const double tip = course.excitation.baseDisplacement(0) + stretching(waves, cells)[cells];
    const double least =
        course.stops.left ? -course.stops.left->value() : -std::numeric_limits<double>::infinity();
    const double inside = tip - std::clamp<double>(tip, least, course.stops.right);
    if (inside != 0.0) {
        for (Piece& piece : waves.a) {
            piece.value += inside;
        }
    }
    return waves;
}

/// Largest distance of the displacements along the bar.
double distance(const Eigen::VectorXd& one, const Eigen::VectorXd& other)
{
    return (one - other).cwiseAbs().maxCoeff();
}

/// Goes on for the periods asked for. \return did it, or did it take too many events?
bool wait(BarSimulation& simulation, const Course& course, const StabilityOptions& options)
{
    const auto goesOn = [&] {
        return simulation.events() < mostEvents && !isRequested(options.cancel);
    };
    for (std::int64_t k = 0; k < options.periods && goesOn(); ++k) {
        simulation.advance(course.period);
    }
    return goesOn();
}

Stability verdictOf(const std::vector<StabilityTrial>& trials, bool isWhole)
{
    if (std::any_of(trials.begin(), trials.end(),
                    [](const StabilityTrial& trial) { return trial.end > grows * trial.start; })) {
        return Stability::repels;
    }
    const bool allDie = std::all_of(trials.begin(), trials.end(), [](const StabilityTrial& trial) {
        return trial.end < diesOut * trial.start;
    });
    return isWhole && allDie ? Stability::attracts : Stability::unclear;
}

StabilityResult stabilityOf(const Course& course, const StabilityOptions& options)
{
    validate(options);
    const std::int64_t cells = course.state.cells();
    const SimulationOptions settings{
        .mergeBelow = course.damping.ratio > 0.0 ? std::optional(options.mergeBelow) : std::nullopt,
        .recordsTip = false,
        .stops = course.stops,
        .segments = isUniform(options.segments) ? std::vector<Segment>{} : options.segments};
    const Waves undisturbed = wavesOf(course.state);
    const Eigen::VectorXd still = stretching(undisturbed, cells);
    StabilityResult result;
    BarSimulation motion(undisturbed, course.damping, course.excitation, settings);
    bool isWhole = true;
    // What is periodic is compared with where it began: rounding must not lead it away.
    const bool isPeriodic = course.damping.ratio == 0.0 || course.excitation.steps() > 0;
    if (!isPeriodic) {
        isWhole = wait(motion, course, options);
    } else {
        motion.advance(course.period);
    }
    const Eigen::VectorXd later = stretching(motion.waves(), cells);
    result.drift = distance(later, still);
    result.contacts =
        static_cast<std::int64_t>(motion.contacts().size()) * (isPeriodic ? options.periods : 1);
    std::mt19937_64 generator(options.seed);
    for (const double size : options.sizes) {
        for (std::int64_t draw = 0; draw < options.draws; ++draw) {
            const Waves start = besides(course, size, generator);
            StabilityTrial trial{size, distance(stretching(start, cells), still), 0.0};
            BarSimulation simulation(start, course.damping, course.excitation, settings);
            isWhole = wait(simulation, course, options) && isWhole;
            trial.end = distance(stretching(simulation.waves(), cells), isPeriodic ? still : later);
            result.trials.push_back(trial);
        }
    }
    if (!isRequested(options.cancel)) {
        result.stability = verdictOf(result.trials, isWhole);
    }
    return result;
}

}  // namespace

std::string_view name(Stability stability)
{
    return nameIn(stabilityNames, stability);
}

StabilityResult stabilityOf(const ForcedMotion& motion, const StabilityOptions& options)
{
    return stabilityOf({motion.state, motion.damping, motion.excitation, motion.schedule.stops,
                        static_cast<double>(motion.excitation.steps())},
                       options);
}

StabilityResult stabilityOf(const State& state, const Schedule& schedule, const Damping& damping,
                            const StabilityOptions& options)
{
    validate(schedule);
    validate(damping);
    requireCells(state, schedule.cells);
    const Excitation none{.stepsPerCrossing = static_cast<double>(schedule.cells)};
    return stabilityOf({state, damping, none, schedule.stops, static_cast<double>(steps(schedule))},
                       options);
}

}  // namespace signorini
