#pragma once
/// \file
/// What NLopt calls back.

#include <nlopt.h>

#include <cstdint>
#include <exception>

#include "nlopt/free_program.hpp"

namespace signorini::nlopt {

/// Objective, rows and energy at u. An exception must not cross the library, and its text would be
/// lost: it is kept here, the search is stopped, and `rethrow` throws it afterwards. Refers to what
/// it was made from.
class Search {
public:
    Search(const FreeProgram& freed, Eigen::VectorXd start, const SolverOptions& options,
           nlopt_opt optimizer);

    [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

    void rethrow() const;

    static double objective(unsigned, const double* u, double* gradient, void* self);
    static void rows(unsigned, double* values, unsigned, const double* u, double* gradient,
                     void* self);
    static double energy(unsigned, const double* u, double* gradient, void* self);

private:
    template <typename Evaluate>
    double guarded(Evaluate evaluate);

    [[nodiscard]] Eigen::VectorXd point(const double* u) const;
    void writeGradient(const Eigen::VectorXd& inX, double* gradient) const;
    double evaluateObjective(const double* u, double* gradient);
    void evaluateRows(const double* u, double* values, double* gradient) const;
    double evaluateEnergy(const double* u, double* gradient) const;

    const FreeProgram& freed_;
    const Program& program_;
    Eigen::VectorXd start_;
    const SolverOptions& options_;
    nlopt_opt optimizer_;
    bool hasObjective_;
    std::int64_t evaluations_ = 0;
    std::exception_ptr exception_;
};

}  // namespace signorini::nlopt
