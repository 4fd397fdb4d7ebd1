#include "glpk/glpk_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "glpk/glpk.hpp"

namespace signorini::glpk {

namespace {

/// Limits built into GLPK, said in our words.
constexpr Eigen::Index maxRowsOrColumns = 100'000'000;
constexpr Eigen::Index maxEntries = 500'000'000;

void refuseOversized(const Program& program)
{
    const Eigen::Index rows = program.equalities.rows() + program.inequalities.rows() + 1;
    const Eigen::Index entries = program.equalities.nonZeros() + program.inequalities.nonZeros();
    if (std::max(rows, program.linear.size()) > maxRowsOrColumns || entries > maxEntries) {
        throw std::invalid_argument(
            "GLPK accepts at most 10^8 rows, 10^8 variables and 5 10^8 entries");
    }
}

void setBounds(glp_prob* problem, int column, double lower, double upper)
{
    const bool hasLower = std::isfinite(lower);
    const bool hasUpper = std::isfinite(upper);
    const int type = hasLower && hasUpper ? (lower == upper ? GLP_FX : GLP_DB)
                     : hasLower           ? GLP_LO
                     : hasUpper           ? GLP_UP
                                          : GLP_FR;
    glp_set_col_bnds(problem, column, type, hasLower ? lower : 0.0, hasUpper ? upper : 0.0);
}

/// GLPK's sparse rows count from 1; entry 0 of the arrays is unused.
void addRows(Problem& problem, const SparseRows& rows, const Eigen::VectorXd& rhs, int type)
{
    const int count = static_cast<int>(rows.rows());
    if (count == 0) {
        return;
    }
    int first = 0;
    problem.run([&first, count](glp_prob* p) { first = glp_add_rows(p, count); });
    std::vector<int> columns;
    std::vector<double> values;
    for (int row = 0; row < count; ++row) {
        columns.resize(1);
        values.resize(1);
        for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
            if (entry.value() != 0.0) {
                columns.push_back(static_cast<int>(entry.col()) + 1);
                values.push_back(entry.value());
            }
        }
        const auto entries = static_cast<int>(columns.size()) - 1;
        problem.run([place = first + row, entries, c = columns.data(),
                     v = values.data()](glp_prob* p) { glp_set_mat_row(p, place, entries, c, v); });
        glp_set_row_bnds(problem.get(), first + row, type, rhs[row], rhs[row]);
    }
}

void addUnboundedRow(Problem& problem)
{
    problem.run([](glp_prob* p) {
        const int row = glp_add_rows(p, 1);
        const std::array<int, 2> columns{0, 1};
        const std::array<double, 2> values{0.0, 1.0};
        glp_set_mat_row(p, row, 1, columns.data(), values.data());
        glp_set_row_bnds(p, row, GLP_FR, 0.0, 0.0);
    });
}

}  // namespace

std::string version()
{
    return glp_version();
}

void fill(Problem& problem, const Program& program)
{
    refuseOversized(program);
    glp_set_obj_dir(problem.get(), GLP_MIN);
    const int variables = static_cast<int>(program.variables());
    problem.run([variables](glp_prob* p) { glp_add_cols(p, variables); });
    for (int i = 0; i < variables; ++i) {
        setBounds(problem.get(), i + 1, program.lower[i], program.upper[i]);
        glp_set_obj_coef(problem.get(), i + 1, program.linear[i]);
    }
    addRows(problem, program.equalities, program.equalityRhs, GLP_FX);
    addRows(problem, program.inequalities, program.inequalityRhs, GLP_UP);
    addUnboundedRow(problem);
}

void readPoint(glp_prob* problem, const Program& program, double (*value)(glp_prob*, int),
               double (*dual)(glp_prob*, int), SolverResult& result)
{
    const auto read = [problem](auto accessor, Eigen::Index first, Eigen::Index count) {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(
            count, [&](Eigen::Index i) { return accessor(problem, static_cast<int>(first + i)); }));
    };
    const Eigen::Index equalities = program.equalities.rows();
    result.x = read(value, 1, program.variables());
    result.equalityDuals = read(dual, 1, equalities);
    result.inequalityDuals = read(dual, 1 + equalities, program.inequalities.rows());
}

}  // namespace signorini::glpk
