#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "echo.hpp"
#include "formulation.hpp"
#include "infinity.hpp"
#include "row_list.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// p_m for any m >= 0, m < n + 2N.
const DelayTerm& termAt(const Formulated& f, std::int64_t m)
{
    return f.delay[static_cast<std::size_t>(m % static_cast<std::int64_t>(f.delay.size()))];
}

/// p_m <= limit for all m: bounds on the unknowns.
void boundWaves(Formulated& f, double limit)
{
    for (const DelayTerm& term : f.delay) {
        double& lower = f.program.lower[term.column];
        double& upper = f.program.upper[term.column];
        if (term.factor > 0.0) {
            upper = std::min(upper, limit / term.factor);
        } else if (term.factor < 0.0) {
            lower = std::max(lower, limit / term.factor);
        }
    }
}

/// Rows factor * x = value.
void addFixedValues(Formulated& f, const std::vector<FixedValue>& fixed)
{
    RowList rows(f.program.equalities, f.program.equalityRhs);
    for (const FixedValue& value : fixed) {
        const std::int64_t unknown =
            value.cell - 1 + (value.wave == Wave::b ? f.schedule.cells : 0);
        const auto [step, sign] = unknownOf(unknown, f.schedule.cells);
        const DelayTerm& term = termAt(f, step);
        rows.add({{term.column, term.factor}}, sign * value.value);
    }
    rows.moveTo(f.program.equalities, f.program.equalityRhs, f.program.variables());
}

/// One more unknown, the largest p_m, and the rows that make it so.
void minimisePeak(Formulated& f)
{
    Program& program = f.program;
    const Eigen::Index peak = program.variables();
    program.equalities.conservativeResize(program.equalities.rows(), peak + 1);
    const auto extend = [peak](Eigen::VectorXd& values, double value) {
        values.conservativeResize(peak + 1);
        values[peak] = value;
    };
    extend(program.lower, 0.0);
    extend(program.upper, infinity);
    extend(program.linear, 2.0);
    std::set<std::pair<Eigen::Index, double>> terms;
    for (const DelayTerm& term : f.delay) {
        if (term.factor != 0.0) {
            terms.emplace(term.column, term.factor);
        }
    }
    RowList rows(program.inequalities, program.inequalityRhs);
    for (const auto& [column, factor] : terms) {
        rows.add({{column, factor}, {peak, -1.0}}, 0.0);
    }
    rows.moveTo(program.inequalities, program.inequalityRhs, peak + 1);
}

void maximiseImpulse(Formulated& f)
{
    std::int64_t step = 0;
    for (const Phase& phase : f.schedule.phases) {
        for (std::int64_t k = 0; k < phase.contact; ++k) {
            const DelayTerm& term = termAt(f, step + k);
            f.program.linear[term.column] -=
                pushSign(phase.stop) * 2.0 * term.factor / static_cast<double>(f.schedule.cells);
        }
        step += phase.contact + phase.free;
    }
}

/// (2/N) sum over the state of (x - target)^2, without its constant.
void minimiseDistance(Formulated& f, const State& target)
{
    f.program.quadratic = 2.0 * energyWeights(f);
    const Eigen::VectorXd wanted = windowOf(target);
    const double scale = energyOf(1.0, f.schedule.cells);
    for (Eigen::Index m = 0; m < wanted.size(); ++m) {
        const DelayTerm& term = termAt(f, m);
        f.program.linear[term.column] -= 2.0 * scale * term.factor * wanted[m];
    }
}

}  // namespace

Formulation cheapestFormulation(const Demands& demands)
{
    const bool needsAmplitudes = demands.objective == Objective::nearest ||
                                 demands.objective == Objective::maxEnergy ||
                                 !demands.fixed.empty() || demands.energyRatio.has_value();
    return needsAmplitudes ? Formulation::reduced : Formulation::lumped;
}

Formulated pose(const Schedule& schedule, const Demands& demands, Formulation formulation)
{
    validate(schedule);
    validate(demands, schedule);
    if (formulation == Formulation::lumped && cheapestFormulation(demands) != Formulation::lumped) {
        throw std::invalid_argument(
            "formulation = lumped: allowed state|reduced when single amplitudes matter");
    }
    const double depth =
        0.5 * static_cast<double>(schedule.cells) * (schedule.stops.right - demands.tipFloor);
    Formulated f = formulate(schedule, formulation, depth);
    if (std::isfinite(demands.strainLimit)) {
        boundWaves(f, 0.5 * demands.strainLimit);
    }
    addFixedValues(f, demands.fixed);
    if (demands.energyRatio) {
        f.program.energy = EnergyEquality{energyWeights(f), *demands.energyRatio};
    }
    switch (demands.objective) {
        case Objective::automatic:
        case Objective::any:
        case Objective::maxEnergy:
            break;
        case Objective::minEnergy:
            f.program.quadratic = 2.0 * energyWeights(f);
            break;
        case Objective::minPeakStrain:
            minimisePeak(f);
            break;
        case Objective::maxImpulse:
            maximiseImpulse(f);
            break;
        case Objective::nearest:
            minimiseDistance(f, *demands.target);
            break;
    }
    return f;
}

Eigen::VectorXd energyWeights(const Formulated& formulated)
{
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(formulated.program.variables());
    const double scale = energyOf(1.0, formulated.schedule.cells);
    for (std::int64_t m = 0; m < 2 * formulated.schedule.cells; ++m) {
        const DelayTerm& term = termAt(formulated, m);
        weights[term.column] += scale * term.factor * term.factor;
    }
    return weights;
}

}  // namespace signorini
