#include "nlopt/search.hpp"

#include <limits>
#include <utility>

namespace signorini::nlopt {

namespace {

using Input = Eigen::Map<const Eigen::VectorXd>;
using Output = Eigen::Map<Eigen::VectorXd>;

}  // namespace

Search::Search(const FreeProgram& freed, Eigen::VectorXd start, const SolverOptions& options,
               nlopt_opt optimizer)
    : freed_(freed),
      program_(freed.condensed.program),
      start_(std::move(start)),
      options_(options),
      optimizer_(optimizer),
      hasObjective_(hasObjective(program_))
{
}

void Search::rethrow() const
{
    if (exception_) {
        std::rethrow_exception(exception_);
    }
}

template <typename Evaluate>
double Search::guarded(Evaluate evaluate)
{
    try {
        if (isRequested(options_.cancel)) {
            nlopt_force_stop(optimizer_);
        }
        return evaluate();
    } catch (...) {
        exception_ = std::current_exception();
        nlopt_force_stop(optimizer_);
        return std::numeric_limits<double>::infinity();
    }
}

double Search::objective(unsigned, const double* u, double* gradient, void* self)
{
    auto& search = *static_cast<Search*>(self);
    return search.guarded([&] { return search.evaluateObjective(u, gradient); });
}

void Search::rows(unsigned, double* values, unsigned, const double* u, double* gradient, void* self)
{
    auto& search = *static_cast<Search*>(self);
    search.guarded([&] {
        search.evaluateRows(u, values, gradient);
        return 0.0;
    });
}

double Search::energy(unsigned, const double* u, double* gradient, void* self)
{
    auto& search = *static_cast<Search*>(self);
    return search.guarded([&] { return search.evaluateEnergy(u, gradient); });
}

Eigen::VectorXd Search::point(const double* u) const
{
    return freed_.origin + freed_.directions * Input(u, freed_.size());
}

void Search::writeGradient(const Eigen::VectorXd& inX, double* gradient) const
{
    if (gradient != nullptr) {
        Output(gradient, freed_.size()) = freed_.directions.transpose() * inX;
    }
}

double Search::evaluateObjective(const double* u, double* gradient)
{
    ++evaluations_;
    if (!hasObjective_) {
        const Eigen::VectorXd step = Input(u, freed_.size()) - start_;
        if (gradient != nullptr) {
            Output(gradient, freed_.size()) = step;
        }
        return 0.5 * step.squaredNorm();
    }
    const Eigen::VectorXd x = point(u);
    Eigen::VectorXd slope = program_.linear;
    if (program_.quadratic.size() > 0) {
        slope += program_.quadratic.cwiseProduct(x);
    }
    writeGradient(slope, gradient);
    return signorini::objective(program_, x);
}

void Search::evaluateRows(const double* u, double* values, double* gradient) const
{
    Output(values, freed_.rhs.size()) = freed_.rows * Input(u, freed_.size()) - freed_.rhs;
    if (gradient != nullptr) {
        using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Eigen::Map<Dense>(gradient, freed_.rows.rows(), freed_.rows.cols()) = freed_.rows;
    }
}

double Search::evaluateEnergy(const double* u, double* gradient) const
{
    const EnergyEquality& energy = *program_.energy;
    const Eigen::VectorXd x = point(u);
    writeGradient(2.0 / energy.value * energy.weights.cwiseProduct(x), gradient);
    return energy.weights.dot(x.cwiseAbs2()) / energy.value - 1.0;
}

}  // namespace signorini::nlopt
