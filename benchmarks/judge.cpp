#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/amplitude_set.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"

namespace signorini::bench {

namespace {

/// How far a state is from the complete set of motions of a one-phase schedule, relative: outside
/// the set in amplitudes, or away from every state with such amplitudes.
double distanceToSet(const Schedule& schedule, const State& state)
{
    const OnePhaseSet exact = onePhaseSet(schedule);
    const std::vector<double> z = amplitudesOf(exact, state);
    const ClassTypes classes = classTypes(schedule);
    std::vector<double> all(static_cast<std::size_t>(classes.classes), 0.0);
    std::copy(z.begin(), z.end(), all.begin() + exact.firstLive);
    const State nearest = motionOf(classes, all);
    const double size = std::max(amplitude(state), std::numeric_limits<double>::min());
    const double away = std::max((state.a - nearest.a).lpNorm<Eigen::Infinity>(),
                                 (state.b - nearest.b).lpNorm<Eigen::Infinity>()) /
                        size;
    return std::max(distanceOutside(exact.set, z), away);
}

double worseOf(double x, double y)
{
    return std::isnan(x) || std::isnan(y) ? std::numeric_limits<double>::infinity()
                                          : std::max(x, y);
}

}  // namespace

void judgeFound(const Problem& problem, const State& state, double tolerance, Record& record)
{
    record.claim = "found";
    const Residuals residuals =
        verify(state, problem.schedule, std::max(tolerance, 1e-12)).residuals;
    auto& figures = record.figures;
    figures["periodicity"] = residuals.periodicity;
    figures["gap"] = residuals.gap;
    figures["pressure"] = residuals.pressure;
    figures["penetration"] = residuals.penetration;
    figures["march"] = residuals.march;
    figures["energy_ratio"] = energyRatio(state);
    double error = worseOf(residuals.worst(), violation(problem.demands, state, problem.schedule));
    if (!problem.exists) {
        figures["error"] = error;
        record.outcome = "wrong";
        return;
    }
    if (problem.schedule.phases.size() == 1 && !problem.schedule.stops.left) {
        figures["set_distance"] = distanceToSet(problem.schedule, state);
        error = worseOf(error, figures["set_distance"]);
    }
    if (problem.leastEnergy || problem.demands.energyRatio) {
        const double wanted =
            problem.leastEnergy ? *problem.leastEnergy : *problem.demands.energyRatio;
        figures["energy_error"] = std::abs(energyRatio(state) / wanted - 1.0);
        error = worseOf(error, figures["energy_error"]);
    }
    figures["error"] = error;
    record.outcome = error <= allowance * tolerance ? "right"
                     : error < wrongFrom            ? "inaccurate"
                                                    : "wrong";
}

void judgeNone(const Problem& problem, Record& record)
{
    record.claim = "none";
    record.outcome = problem.exists ? "wrong" : "right";
}

}  // namespace signorini::bench
