#include "continuum_programs.hpp"

#include <cmath>

#include "faults.hpp"
#include "formulation.hpp"

namespace signorini {

namespace {

/// Motions in the unknowns of a program.
class ProgramCurve : public CurveOfMotions {
public:
    ProgramCurve(ContinuumRecord& record, const EnergySection* section, const Solver& solver,
                 const State& target)
        : record_(record),
          section_(section),
          formulated_(pose(record.result.schedule, aimedAt(record, target), Formulation::reduced)),
          weights_(energyWeights(formulated_)),
          solver_(solver)
    {
        formulated_.program.energy = EnergyEquality{weights_, record.energy()};
        settings_.tolerance = landingTolerance(record.options.tolerance);
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

    [[nodiscard]] SolverResult land(const Eigen::VectorXd& predicted) override
    {
        Program& program = formulated_.program;
        program.linear = -program.quadratic.cwiseProduct(predicted);
        settings_.start = predicted.cwiseMax(program.lower).cwiseMin(program.upper);
        return solver_.solve(program, settings_);
    }

    [[nodiscard]] double distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const override
    {
        return std::sqrt(weights_.dot((x - y).cwiseAbs2()));
    }

    [[nodiscard]] bool mayJoin(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const override
    {
        return section_ == nullptr ||
               section_->joins(stateOf(formulated_, x), stateOf(formulated_, y)) != false;
    }

    [[nodiscard]] bool keep(const Eigen::VectorXd& x) override
    {
        return record_.keepNext(stateOf(formulated_, x));
    }
    void restart() override { record_.result.points.clear(); }
    [[nodiscard]] double reached() const override { return record_.result.points.back().lambda; }
    [[nodiscard]] bool isCancelled() override { return record_.isCancelled(); }
    void stop(std::string why) override { record_.stop(std::move(why)); }
    void finish() override { record_.finish(); }
    [[nodiscard]] bool isFinished() const override
    {
        return record_.result.status == Status::found;
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

    ContinuumRecord& record_;
    const EnergySection* section_;
    Formulated formulated_;
    Eigen::VectorXd weights_;
    const Solver& solver_;
    SolverOptions settings_;
};

}  // namespace

void traceWithPrograms(ContinuumRecord& record, const EnergySection* section, const State& member,
                       const Solver& solver)
{
    const MarchOptions options{record.options.points, record.options.resolution,
                               record.options.tolerance, std::sqrt(record.energy())};
    ProgramCurve curve(record, section, solver, record.from() != nullptr ? *record.from() : member);
    SolverResult first = curve.land(curve.target());
    if (first.status != SolverStatus::optimal) {
        record.stop(fmt::format("the first point: {}", first.detail));
        return;
    }
    if (record.to() == nullptr) {
        const auto* random = std::get_if<trace::RandomPath>(&record.options.trace);
        record.result.family = "path between two members";
        joinMembers(curve, options, first.x,
                    random != nullptr ? random->seed : trace::RandomPath{}.seed);
        return;
    }
    record.result.family = "path between two given motions";
    SolverResult last = curve.land(ProgramCurve(record, section, solver, *record.to()).target());
    if (last.status != SolverStatus::optimal) {
        record.stop(fmt::format("the last point: {}", last.detail));
        return;
    }
    marchTo(curve, options, std::move(first.x), std::move(last.x));
    if (record.result.status == Status::found) {
        record.result.connected = true;
    }
}

}  // namespace signorini
