#include "signorini/demands.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "formulation.hpp"
#include "propagation.hpp"

namespace signorini {

namespace {

/// Squares of distances to a target must be finite.
constexpr double largestTarget = 1e100;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Triplet = Eigen::Triplet<double>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The step in which a value of the initial state reaches the tip, and its sign there.
std::pair<std::int64_t, double> arrivalOf(const FixedValue& fixed, std::int64_t cells)
{
    return fixed.wave == Wave::a ? std::pair{cells - fixed.cell, 1.0}
                                 : std::pair{cells + fixed.cell - 1, -1.0};
}

/// p_m for any m >= 0, m < n + 2N.
const DelayTerm& termAt(const Formulated& f, std::int64_t m)
{
    return f.delay[static_cast<std::size_t>(m % static_cast<std::int64_t>(f.delay.size()))];
}

/// p_0 .. p_{2N-1} of a state.
Eigen::VectorXd arrivals(const State& state)
{
    Eigen::VectorXd p(2 * state.cells());
    p << state.a.reverse(), -state.b;
    return p;
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

void appendRows(SparseRows& matrix, Eigen::VectorXd& rhs, const std::vector<Triplet>& entries,
                const std::vector<double>& values)
{
    const Eigen::Index before = matrix.rows();
    std::vector<Triplet> all;
    all.reserve(static_cast<std::size_t>(matrix.nonZeros()) + entries.size());
    for (Eigen::Index row = 0; row < before; ++row) {
        for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry) {
            all.emplace_back(static_cast<int>(row), static_cast<int>(entry.col()), entry.value());
        }
    }
    for (const Triplet& entry : entries) {
        all.emplace_back(static_cast<int>(before) + entry.row(), entry.col(), entry.value());
    }
    const auto added = static_cast<Eigen::Index>(values.size());
    SparseRows larger(before + added, matrix.cols());
    larger.setFromTriplets(all.begin(), all.end());
    matrix.swap(larger);
    rhs.conservativeResize(before + added);
    rhs.tail(added) = Eigen::Map<const Eigen::VectorXd>(values.data(), added);
}

/// Rows factor * x = value.
void addFixedValues(Formulated& f, const std::vector<FixedValue>& fixed)
{
    std::vector<Triplet> entries;
    std::vector<double> values;
    for (const FixedValue& value : fixed) {
        const auto [step, sign] = arrivalOf(value, f.schedule.cells);
        const DelayTerm& term = termAt(f, step);
        const auto row = static_cast<int>(values.size());
        entries.emplace_back(row, static_cast<int>(term.column), term.factor);
        values.push_back(sign * value.value);
    }
    if (!values.empty()) {
        appendRows(f.program.equalities, f.program.equalityRhs, entries, values);
    }
}

/// One more unknown, the largest p_m, and the rows that make it so.
void minimisePeak(Formulated& f)
{
    Program& program = f.program;
    const Eigen::Index peak = program.variables();
    program.equalities.conservativeResize(program.equalities.rows(), peak + 1);
    program.inequalities.conservativeResize(program.inequalities.rows(), peak + 1);
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
    std::vector<Triplet> entries;
    std::vector<double> values;
    for (const auto& [column, factor] : terms) {
        const auto row = static_cast<int>(values.size());
        entries.emplace_back(row, static_cast<int>(column), factor);
        entries.emplace_back(row, static_cast<int>(peak), -1.0);
        values.push_back(0.0);
    }
    appendRows(program.inequalities, program.inequalityRhs, entries, values);
}

void maximiseImpulse(Formulated& f)
{
    std::int64_t step = 0;
    for (const Phase& phase : f.schedule.phases) {
        for (std::int64_t k = 0; k < phase.contact; ++k) {
            const DelayTerm& term = termAt(f, step + k);
            f.program.linear[term.column] -=
                2.0 * term.factor / static_cast<double>(f.schedule.cells);
        }
        step += phase.contact + phase.free;
    }
}

/// (2/N) sum over the state of (x - target)^2, without its constant.
void minimiseDistance(Formulated& f, const State& target)
{
    f.program.quadratic = 2.0 * energyWeights(f);
    const Eigen::VectorXd wanted = arrivals(target);
    const double scale = 2.0 / static_cast<double>(f.schedule.cells);
    for (Eigen::Index m = 0; m < wanted.size(); ++m) {
        const DelayTerm& term = termAt(f, m);
        f.program.linear[term.column] -= 2.0 * scale * term.factor * wanted[m];
    }
}

}  // namespace

std::string_view name(Objective objective)
{
    switch (objective) {
        case Objective::automatic:
            return "auto";
        case Objective::any:
            return "any";
        case Objective::minEnergy:
            return "min-energy";
        case Objective::maxEnergy:
            return "max-energy";
        case Objective::minPeakStrain:
            return "min-peak-strain";
        case Objective::maxImpulse:
            return "max-impulse";
        case Objective::nearest:
            return "nearest";
    }
    throw std::logic_error("unnamed Objective");
}

bool Demands::areLimits() const
{
    return std::isfinite(strainLimit) || std::isfinite(tipFloor) || !fixed.empty() ||
           energyRatio.has_value();
}

void validate(const Demands& demands, const Schedule& schedule)
{
    Faults faults;
    if (!(demands.strainLimit > 0.0)) {
        faults.add("strainLimit", demands.strainLimit, "> 0");
    }
    if (!(demands.tipFloor < 1.0)) {
        faults.add("tipFloor", demands.tipFloor, "below the wall: < 1 [g]");
    }
    if (demands.energyRatio &&
        !(std::isfinite(*demands.energyRatio) && *demands.energyRatio > 0.0)) {
        faults.add("energyRatio", *demands.energyRatio, "finite and > 0");
    }
    for (const FixedValue& fixed : demands.fixed) {
        if (fixed.cell < 1 || fixed.cell > schedule.cells) {
            faults.add("cell of a fixed value", fixed.cell, fmt::format("1..{}", schedule.cells));
        }
        if (!std::isfinite(fixed.value)) {
            faults.add("fixed value", fixed.value, "finite numbers");
        }
    }
    const bool wantsTarget = demands.objective == Objective::nearest;
    if (wantsTarget != demands.target.has_value()) {
        faults.add("target", demands.target ? "given" : "missing",
                   "a state with objective nearest, and only then");
    } else if (demands.target) {
        const State& target = *demands.target;
        if (target.a.size() != schedule.cells || target.b.size() != schedule.cells) {
            faults.add("cells of the target", target.a.size(), fmt::format("{}", schedule.cells));
        } else if (!target.a.allFinite() || !target.b.allFinite()) {
            faults.add("target", "NaN or infinity", "finite numbers");
        } else if (amplitude(target) > largestTarget) {
            faults.add("amplitude of the target", amplitude(target),
                       fmt::format("at most {}", largestTarget));
        }
    }
    if (demands.energyRatio && demands.objective != Objective::automatic &&
        demands.objective != Objective::any) {
        faults.add("objective", name(demands.objective), "auto|any when an energy is held");
    }
    faults.throwIfAny();
}

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
    const double depth = 0.5 * static_cast<double>(schedule.cells) * (1.0 - demands.tipFloor);
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
    const double scale = 2.0 / static_cast<double>(formulated.schedule.cells);
    for (std::int64_t m = 0; m < 2 * formulated.schedule.cells; ++m) {
        const DelayTerm& term = termAt(formulated, m);
        weights[term.column] += scale * term.factor * term.factor;
    }
    return weights;
}

Extremes extremesOf(const State& state, const Schedule& schedule)
{
    Schedule walked = schedule;
    fold(walked);
    DelayLine line(state);
    const auto cells = static_cast<double>(state.cells());
    double highest = -infinity;
    double impulse = 0.0;
    CompensatedSum prefix;
    double deepest = 0.0;
    for (const Phase& phase : walked.phases) {
        for (std::int64_t step = 0; step < phase.contact; ++step) {
            highest = std::max(highest, line.incoming());
            impulse += 2.0 * line.incoming() / cells;
            line.contactStep();
        }
        for (std::int64_t step = 0; step < phase.free; ++step) {
            highest = std::max(highest, line.incoming());
            prefix.add(line.incoming());
            deepest = std::min(deepest, prefix.value());
            line.freeStep();
        }
    }
    return {
        .peakStrain = 2.0 * highest, .lowestTip = 1.0 + 2.0 * deepest / cells, .impulse = impulse};
}

double violation(const Demands& demands, const State& state, const Schedule& schedule)
{
    if (!demands.areLimits()) {
        return 0.0;
    }
    const Extremes seen = extremesOf(state, schedule);
    double worst = 0.0;
    if (std::isfinite(demands.strainLimit)) {
        worst = std::max(worst, seen.peakStrain / demands.strainLimit - 1.0);
    }
    if (std::isfinite(demands.tipFloor)) {
        worst = std::max(worst, demands.tipFloor - seen.lowestTip);
    }
    for (const FixedValue& fixed : demands.fixed) {
        const Eigen::VectorXd& wave = fixed.wave == Wave::a ? state.a : state.b;
        const double size = std::max(1.0, std::abs(fixed.value));
        worst = std::max(worst, std::abs(wave[fixed.cell - 1] - fixed.value) / size);
    }
    if (demands.energyRatio) {
        worst = std::max(worst, std::abs(energyRatio(state) / *demands.energyRatio - 1.0));
    }
    return worst;
}

}  // namespace signorini
