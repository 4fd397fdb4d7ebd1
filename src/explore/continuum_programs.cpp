#include "continuum_programs.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "faults.hpp"
#include "formulation.hpp"

namespace signorini {

namespace {

/// The nonlinear programs of a trace: the motion of the energy nearest to given unknowns.
class Corrector {
public:
    /// Starts at the unknowns of `target`.
    Corrector(const ContinuumRecord& record, const Solver& solver, const State& target)
        : formulated_(pose(record.result.schedule, aimedAt(record, target), Formulation::reduced)),
          weights_(energyWeights(formulated_)),
          solver_(solver)
    {
        formulated_.program.energy = EnergyEquality{weights_, record.energy()};
        settings_.tolerance = 0.01 * record.options.tolerance;
        if (solver_.capabilities().cancel) {
            settings_.cancel = record.options.cancel;
        }
    }

    /// The unknowns nearest to the target.
    [[nodiscard]] Eigen::VectorXd target() const
    {
        const Program& program = formulated_.program;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            x[i] = program.quadratic[i] > 0.0 ? -program.linear[i] / program.quadratic[i] : 0.0;
        }
        return x;
    }

    [[nodiscard]] SolverResult land(const Eigen::VectorXd& predicted)
    {
        Program& program = formulated_.program;
        program.linear = -program.quadratic.cwiseProduct(predicted);
        settings_.start = predicted.cwiseMax(program.lower).cwiseMin(program.upper);
        return solver_.solve(program, settings_);
    }

    [[nodiscard]] State stateOf(const Eigen::VectorXd& x) const
    {
        return signorini::stateOf(formulated_, x);
    }

    /// In the norm of the energy.
    [[nodiscard]] double distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const
    {
        return std::sqrt(weights_.dot((x - y).cwiseAbs2()));
    }

private:
    static Demands aimedAt(const ContinuumRecord& record, const State& target)
    {
        Demands demands = record.demands;
        demands.energyRatio.reset();
        demands.objective = Objective::nearest;
        demands.target = target;
        return demands;
    }

    Formulated formulated_;
    Eigen::VectorXd weights_;
    const Solver& solver_;
    SolverOptions settings_;
};

/// One curve from x to the end, in steps that are made shorter where the set bends or ends.
class CurveMarch {
public:
    CurveMarch(ContinuumRecord& record, Corrector& corrector, Eigen::VectorXd start,
               Eigen::VectorXd end)
        : record_(record), corrector_(corrector), x_(std::move(start)), end_(std::move(end))
    {
        // Each step is kept as two, with its middle.
        const double chord = corrector_.distance(x_, end_);
        const auto steps = 0.5 * static_cast<double>(record.options.points - 1);
        longest_ = std::min(record.options.resolution * std::sqrt(record.energy()), chord / steps);
    }

    void run()
    {
        if (!record_.keepNext(corrector_.stateOf(x_))) {
            return;
        }
        double length = longest_;
        while (!record_.isCancelled()) {
            const double rest = corrector_.distance(x_, end_);
            if (rest <= record_.options.tolerance * std::sqrt(record_.energy())) {
                record_.finish();
                return;
            }
            if (tryStep(std::min(length, rest), rest)) {
                if (!record_.keepNext(corrector_.stateOf(middle_)) ||
                    !record_.keepNext(corrector_.stateOf(x_))) {
                    return;
                }
                length = std::min(longest_, 1.5 * length);
            } else if (length *= 0.5; length < finest * longest_) {
                stopBroken(rest);
                return;
            }
        }
    }

private:
    static constexpr double finest = 1.0 / 64.0;
    /// What a step must gain on the end, of its length, so that the march ends.
    static constexpr double leastGain = 0.02;
    /// How far the middle may be from either neighbour, of their distance; for isolated motions, or
    /// neighbours across a gap as wide as their distance, it is 1.
    static constexpr double middleOff = 0.8;

    /// Predicts on the chord to the end, lands, and looks for the middle. Moves x if all is well.
    bool tryStep(double length, double rest)
    {
        Eigen::VectorXd next = end_;
        if (length < rest) {
            SolverResult landed = corrector_.land(x_ + length / rest * (end_ - x_));
            if (landed.status != SolverStatus::optimal) {
                return false;
            }
            next = std::move(landed.x);
        }
        const double step = corrector_.distance(x_, next);
        if (!(step <= longest_ * (1.0 + 1e-9)) ||
            !(corrector_.distance(next, end_) <= rest - leastGain * length)) {
            return false;
        }
        SolverResult landed = corrector_.land(0.5 * (x_ + next));
        if (landed.status != SolverStatus::optimal ||
            !(corrector_.distance(landed.x, x_) <= middleOff * step) ||
            !(corrector_.distance(landed.x, next) <= middleOff * step)) {
            return false;
        }
        middle_ = std::move(landed.x);
        x_ = std::move(next);
        return true;
    }

    void stopBroken(double rest)
    {
        if (record_.isCancelled()) {
            return;
        }
        record_.stop(fmt::format(
            "the trace broke at lambda = {:.6g}, {:.3g} before the other end: no motion of this "
            "energy within {:.3g} continues it, in units of sqrt(E/E_1) = 1",
            record_.result.points.back().lambda, rest, finest * longest_));
    }

    ContinuumRecord& record_;
    Corrector& corrector_;
    Eigen::VectorXd x_;
    Eigen::VectorXd middle_;
    Eigen::VectorXd end_;
    double longest_ = 0.0;
};

/// Without ends: the first of a few members nearest to shuffled unknowns, later to points halfway
/// there, that is not the start nor known to lie in another component.
SolverResult farEnd(const ContinuumRecord& record, const EnergySection* section,
                    Corrector& corrector, const Eigen::VectorXd& start, std::mt19937_64& generator)
{
    constexpr int attempts = 20;
    constexpr double apart = 1e-3;
    const State origin = corrector.stateOf(start);
    Eigen::VectorXd x = start;
    SolverResult landed;
    for (int k = 0; k < attempts && !isRequested(record.options.cancel); ++k) {
        std::shuffle(x.begin(), x.end(), generator);
        landed = corrector.land(k < attempts / 2 ? x : 0.5 * (x + start));
        if (landed.status == SolverStatus::optimal &&
            corrector.distance(landed.x, start) > apart * std::sqrt(record.energy()) &&
            (section == nullptr || section->joins(origin, corrector.stateOf(landed.x)) != false)) {
            break;
        }
    }
    return landed;
}

/// A far end may lie in another component than the start: then another one is tried.
void joinMembers(ContinuumRecord& record, const EnergySection* section, Corrector& corrector,
                 const Eigen::VectorXd& start)
{
    constexpr int attempts = 5;
    const auto* random = std::get_if<trace::RandomPath>(&record.options.trace);
    std::mt19937_64 generator(random != nullptr ? random->seed : trace::RandomPath{}.seed);
    for (int k = 0; k < attempts && record.result.status != Status::found; ++k) {
        SolverResult landed = farEnd(record, section, corrector, start, generator);
        if (record.isCancelled()) {
            return;
        }
        if (landed.status != SolverStatus::optimal) {
            record.stop(fmt::format("the last point: {}", landed.detail));
            continue;
        }
        record.result.points.clear();
        CurveMarch(record, corrector, start, std::move(landed.x)).run();
    }
}

}  // namespace

void traceWithPrograms(ContinuumRecord& record, const EnergySection* section, const State& member,
                       const Solver& solver)
{
    Corrector corrector(record, solver, record.from() != nullptr ? *record.from() : member);
    const SolverResult first = corrector.land(corrector.target());
    if (first.status != SolverStatus::optimal) {
        record.stop(fmt::format("the first point: {}", first.detail));
        return;
    }
    if (record.to() == nullptr) {
        record.result.family = "path between two members";
        joinMembers(record, section, corrector, first.x);
        return;
    }
    record.result.family = "path between two given motions";
    SolverResult last = corrector.land(Corrector(record, solver, *record.to()).target());
    if (last.status != SolverStatus::optimal) {
        record.stop(fmt::format("the last point: {}", last.detail));
        return;
    }
    CurveMarch(record, corrector, first.x, std::move(last.x)).run();
    if (record.result.status == Status::found) {
        record.result.connected = true;
    }
}

}  // namespace signorini
