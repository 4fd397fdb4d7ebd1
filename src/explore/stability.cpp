#include <algorithm>
#include <limits>

#include "disturbed.hpp"
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

/// A bar and what moves it.
class DisturbedBar final : public Disturbed {
public:
    DisturbedBar(const State& state, const Damping& damping, const Excitation& excitation,
                 const Stops& stops, double period, const StabilityOptions& options)
        : state_(state),
          damping_(damping),
          excitation_(excitation),
          period_(period),
          options_(options),
          settings_{
              .mergeBelow = damping.ratio > 0.0 ? std::optional(options.mergeBelow) : std::nullopt,
              .recordsTip = false,
              .stops = stops,
              .segments = isUniform(options.segments) ? std::vector<Segment>{} : options.segments}
    {
    }

    [[nodiscard]] Course follow(double size, std::mt19937_64& generator,
                                std::int64_t periods) const override
    {
        const Waves start = size > 0.0 ? besides(size, generator) : wavesOf(state_);
        BarSimulation simulation(start, damping_, excitation_, settings_);
        Course course{stretching(start, state_.cells()), {}, 0, true};
        course.isWhole = goOn(simulation, period_, periods, options_.cancel);
        course.end = stretching(simulation.waves(), state_.cells());
        course.contacts = static_cast<std::int64_t>(simulation.contacts().size());
        return course;
    }

    /// Largest of displacements along the bar.
    [[nodiscard]] double distance(const Eigen::VectorXd& one,
                                  const Eigen::VectorXd& other) const override
    {
        return (one - other).cwiseAbs().maxCoeff();
    }

private:
    /// The motion's waves, each times 1 + a number in [-size, size].
    [[nodiscard]] Waves besides(double size, std::mt19937_64& generator) const
    {
        Waves waves = wavesOf(state_);
        std::uniform_real_distribution<double> part(-size, size);
        for (auto* wave : {&waves.a, &waves.b}) {
            for (Piece& piece : *wave) {
                piece.value *= 1.0 + part(generator);
            }
        }
        // The tip must not stand inside a stop: by as much as it does, all cells give way evenly.
        const std::int64_t cells = state_.cells();
        const Stops& stops = settings_.stops;
        const double tip = excitation_.baseDisplacement(0) + stretching(waves, cells)[cells];
        const double least =
            stops.left ? -stops.left->value() : -std::numeric_limits<double>::infinity();
        const double inside = tip - std::clamp<double>(tip, least, stops.right);
        if (inside != 0.0) {
            for (Piece& piece : waves.a) {
                piece.value += inside;
            }
        }
        return waves;
    }

    const State& state_;
    const Damping& damping_;
    const Excitation& excitation_;
    double period_;  ///< [steps]
    const StabilityOptions& options_;
    SimulationOptions settings_;
};

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

}  // namespace

std::string_view name(Stability stability)
{
    return nameIn(stabilityNames, stability);
}

StabilityResult stabilityOf(const Disturbed& motion, bool isPeriodic,
                            const StabilityOptions& options)
{
    validate(options);
    std::mt19937_64 generator(options.seed);
    const Disturbed::Course itself =
        motion.follow(0.0, generator, isPeriodic ? 1 : options.periods);
    const Eigen::VectorXd& compared = isPeriodic ? itself.start : itself.end;
    bool isWhole = itself.isWhole;
    StabilityResult result;
    result.drift = motion.distance(itself.end, itself.start);
    result.contacts = itself.contacts * (isPeriodic ? options.periods : 1);
    for (const double size : options.sizes) {
        for (std::int64_t draw = 0; draw < options.draws; ++draw) {
            const Disturbed::Course course = motion.follow(size, generator, options.periods);
            isWhole = course.isWhole && isWhole;
            result.trials.push_back({size, motion.distance(course.start, itself.start),
                                     motion.distance(course.end, compared)});
        }
    }
    if (!isRequested(options.cancel)) {
        result.stability = verdictOf(result.trials, isWhole);
    }
    return result;
}

StabilityResult stabilityOf(const ForcedMotion& motion, const StabilityOptions& options)
{
    const DisturbedBar bar(motion.state, motion.damping, motion.excitation, motion.schedule.stops,
                           static_cast<double>(motion.excitation.steps()), options);
    return stabilityOf(bar, motion.damping.ratio == 0.0 || motion.excitation.steps() > 0, options);
}

StabilityResult stabilityOf(const State& state, const Schedule& schedule, const Damping& damping,
                            const StabilityOptions& options)
{
    validate(schedule);
    validate(damping);
    requireCells(state, schedule.cells);
    const Excitation none{.stepsPerCrossing = static_cast<double>(schedule.cells)};
    const DisturbedBar bar(state, damping, none, schedule.stops,
                           static_cast<double>(steps(schedule)), options);
    return stabilityOf(bar, damping.ratio == 0.0, options);
}

}  // namespace signorini
