#include "ipopt/program_nlp.hpp"

#include <numeric>
#include <utility>

namespace signorini::ipopt {

namespace {

using Point = Eigen::Map<const Eigen::VectorXd>;
using Output = Eigen::Map<Eigen::VectorXd>;

void writePattern(const SparseRows& matrix, Ipopt::Index firstRow, Ipopt::Index*& rows,
                  Ipopt::Index*& columns)
{
    for (Eigen::Index row = 0; row < matrix.outerSize(); ++row) {
        for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry) {
            *rows++ = firstRow + static_cast<Ipopt::Index>(row);
            *columns++ = static_cast<Ipopt::Index>(entry.col());
        }
    }
}

void writeValues(const SparseRows& matrix, Ipopt::Number*& values)
{
    for (Eigen::Index row = 0; row < matrix.outerSize(); ++row) {
        for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry) {
            *values++ = entry.value();
        }
    }
}

}  // namespace

ProgramNlp::ProgramNlp(const Program& program, Eigen::VectorXd start, std::function<bool()> goOn)
    : program_(program), start_(std::move(start)), goOn_(std::move(goOn))
{
}

bool ProgramNlp::get_nlp_info(Index& n, Index& m, Index& jacobianEntries, Index& hessianEntries,
                              IndexStyleEnum& style)
{
    const auto rows = program_.equalities.rows() + program_.inequalities.rows();
    const auto entries = program_.equalities.nonZeros() + program_.inequalities.nonZeros();
    const bool isCurved = program_.energy || program_.quadratic.size() > 0;
    n = static_cast<Index>(program_.variables());
    m = static_cast<Index>(rows) + (program_.energy ? 1 : 0);
    jacobianEntries = static_cast<Index>(entries) + (program_.energy ? n : 0);
    hessianEntries = isCurved ? n : 0;
    style = C_STYLE;
    return true;
}

bool ProgramNlp::get_bounds_info(Index n, Number* lower, Number* upper, Index, Number* gLower,
                                 Number* gUpper)
{
    constexpr Number infinity = 2e19;  // Ipopt takes anything from 1e19 on for no bound
    Output(lower, n) = program_.lower.cwiseMax(-infinity);
    Output(upper, n) = program_.upper.cwiseMin(infinity);
    const Eigen::Index p = program_.equalities.rows();
    const Eigen::Index q = program_.inequalities.rows();
    Output(gLower, p) = program_.equalityRhs;
    Output(gUpper, p) = program_.equalityRhs;
    Output(gLower + p, q).setConstant(-infinity);
    Output(gUpper + p, q) = program_.inequalityRhs;
    if (program_.energy) {
        gLower[p + q] = program_.energy->value;
        gUpper[p + q] = program_.energy->value;
    }
    return true;
}

bool ProgramNlp::get_starting_point(Index n, bool initX, Number* x, bool initZ, Number*, Number*,
                                    Index, bool initLambda, Number*)
{
    if (initX) {
        Output(x, n) = start_;
    }
    return !initZ && !initLambda;  // multipliers are Ipopt's own choice
}

bool ProgramNlp::eval_f(Index n, const Number* x, bool, Number& value)
{
    value = objective(program_, Point(x, n));
    return true;
}

bool ProgramNlp::eval_grad_f(Index n, const Number* x, bool, Number* gradient)
{
    Output(gradient, n) = program_.linear;
    if (program_.quadratic.size() > 0) {
        Output(gradient, n) += program_.quadratic.cwiseProduct(Point(x, n));
    }
    return true;
}

bool ProgramNlp::eval_g(Index n, const Number* x, bool, Index, Number* g)
{
    const Eigen::Index p = program_.equalities.rows();
    const Eigen::Index q = program_.inequalities.rows();
    Output(g, p) = program_.equalities * Point(x, n);
    Output(g + p, q) = program_.inequalities * Point(x, n);
    if (program_.energy) {
        g[p + q] = program_.energy->weights.dot(Point(x, n).cwiseAbs2());
    }
    return true;
}

bool ProgramNlp::eval_jac_g(Index n, const Number* x, bool, Index, Index, Index* rows,
                            Index* columns, Number* values)
{
    const auto p = static_cast<Index>(program_.equalities.rows());
    const auto q = static_cast<Index>(program_.inequalities.rows());
    if (values == nullptr) {
        writePattern(program_.equalities, 0, rows, columns);
        writePattern(program_.inequalities, p, rows, columns);
        for (Index i = 0; program_.energy && i < n; ++i) {
            *rows++ = p + q;
            *columns++ = i;
        }
        return true;
    }
    writeValues(program_.equalities, values);
    writeValues(program_.inequalities, values);
    if (program_.energy) {
        Output(values, n) = 2.0 * program_.energy->weights.cwiseProduct(Point(x, n));
    }
    return true;
}

bool ProgramNlp::eval_h(Index, const Number*, bool, Number objectiveFactor, Index m,
                        const Number* lambda, bool, Index entries, Index* rows, Index* columns,
                        Number* values)
{
    if (values == nullptr) {
        std::iota(rows, rows + entries, 0);
        std::iota(columns, columns + entries, 0);
        return true;
    }
    Output diagonal(values, entries);  // none for a linear program, else one per variable
    diagonal.setZero();
    if (program_.quadratic.size() > 0) {
        diagonal += objectiveFactor * program_.quadratic;
    }
    if (program_.energy) {
        diagonal += 2.0 * lambda[m - 1] * program_.energy->weights;
    }
    return true;
}

void ProgramNlp::finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*,
                                   const Number*, Index, const Number*, const Number*, Number,
                                   const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*)
{
    point_ = Point(x, n);
}

bool ProgramNlp::intermediate_callback(Ipopt::AlgorithmMode, Index, Number, Number, Number, Number,
                                       Number, Number, Number, Number, Index,
                                       const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*)
{
    return goOn_();
}

}  // namespace signorini::ipopt
