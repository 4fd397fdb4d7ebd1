#pragma once
/// \file
/// A Program in the words of Ipopt.

#include <IpTNLP.hpp>
#include <functional>

#include "program.hpp"

namespace signorini::ipopt {

/// Constraints are the equalities, the inequalities and the energy equality, in this order. First
/// and second derivatives are exact; the Hessian is diagonal.
class ProgramNlp final : public Ipopt::TNLP {
public:
    using Index = Ipopt::Index;
    using Number = Ipopt::Number;

    /// \param program is referred to. \param start has a value for each variable.
    /// \param goOn is asked after each iteration.
    ProgramNlp(const Program& program, Eigen::VectorXd start, std::function<bool()> goOn);

    /// The last point; empty before the end of the search.
    [[nodiscard]] const Eigen::VectorXd& point() const { return point_; }

    bool get_nlp_info(Index& n, Index& m, Index& jacobianEntries, Index& hessianEntries,
                      IndexStyleEnum& style) override;
    bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* gLower,
                         Number* gUpper) override;
    bool get_starting_point(Index n, bool initX, Number* x, bool initZ, Number* zLower,
                            Number* zUpper, Index m, bool initLambda, Number* lambda) override;
    bool eval_f(Index n, const Number* x, bool isNew, Number& value) override;
    bool eval_grad_f(Index n, const Number* x, bool isNew, Number* gradient) override;
    bool eval_g(Index n, const Number* x, bool isNew, Index m, Number* g) override;
    bool eval_jac_g(Index n, const Number* x, bool isNew, Index m, Index entries, Index* rows,
                    Index* columns, Number* values) override;
    bool eval_h(Index n, const Number* x, bool isNew, Number objectiveFactor, Index m,
                const Number* lambda, bool isNewLambda, Index entries, Index* rows, Index* columns,
                Number* values) override;
    void finalize_solution(Ipopt::SolverReturn status, Index n, const Number* x,
                           const Number* zLower, const Number* zUpper, Index m, const Number* g,
                           const Number* lambda, Number value, const Ipopt::IpoptData* data,
                           Ipopt::IpoptCalculatedQuantities* quantities) override;
    bool intermediate_callback(Ipopt::AlgorithmMode mode, Index iteration, Number objective,
                               Number primal, Number dual, Number mu, Number step,
                               Number regularization, Number alphaDual, Number alphaPrimal,
                               Index trials, const Ipopt::IpoptData* data,
                               Ipopt::IpoptCalculatedQuantities* quantities) override;

private:
    const Program& program_;
    Eigen::VectorXd start_;
    std::function<bool()> goOn_;
    Eigen::VectorXd point_;
};

}  // namespace signorini::ipopt
