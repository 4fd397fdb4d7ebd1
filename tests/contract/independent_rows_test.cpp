#include "common/independent_rows.hpp"

#include <Eigen/LU>
#include <random>
#include <set>

#include "catch.hpp"
#include "common/condensed.hpp"
#include "formulation.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Mostly zeros, small whole numbers otherwise, and rows that follow from earlier ones.
Eigen::MatrixXd randomMatrix(std::mt19937_64& generator)
{
    const auto draw = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(generator);
    };
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(draw(1, 9), draw(1, 9));
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        if (row > 1 && draw(0, 3) == 0) {
            matrix.row(row) =
                draw(-2, 2) * matrix.row(draw(0, static_cast<int>(row) - 1)) + matrix.row(0);
            continue;
        }
        for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
            matrix(row, column) = draw(0, 2) == 0 ? draw(-3, 3) : 0;
        }
    }
    return matrix;
}

}  // namespace

TEST_CASE("independent rows: as many as the rank, with a regular basis, on random matrices")
{
    std::mt19937_64 generator(5);
    for (int k = 0; k < 3000; ++k) {
        const Eigen::MatrixXd dense = randomMatrix(generator) / (k % 2 == 0 ? 1.0 : 64.0);
        const IndependentRows found = independentRows(dense.sparseView());
        const auto rank = static_cast<std::size_t>(Eigen::FullPivLU<Eigen::MatrixXd>(dense).rank());
        REQUIRE(found.rows.size() == rank);
        REQUIRE(found.pivots.size() == rank);
        CHECK(std::set<Eigen::Index>(found.rows.begin(), found.rows.end()).size() == rank);
        if (rank == 0) {
            continue;
        }
        const Eigen::MatrixXd basis = dense(found.rows, found.pivots);
        CHECK(Eigen::FullPivLU<Eigen::MatrixXd>(basis).isInvertible());
    }
}

TEST_CASE("independent rows: periodicity and gap have rank 2N - dim ker(W - 1) + 1")
{
    for (const Schedule& schedule :
         {test::onePhase(8, 5, 23), test::onePhase(30, 15, 90), test::onePhase(300, 150, 900)}) {
        const Program program = formulate(schedule, Formulation::state).program;
        const auto lost = static_cast<std::size_t>(onePhaseSet(schedule).kernelDimension);
        CHECK(independentRows(program.equalities).rows.size() + lost ==
              static_cast<std::size_t>(program.equalities.rows()));
    }
}

TEST_CASE("condensed: closures of several phases fix variables, and the rest is consistent")
{
    const Schedule twice{6, {{3, 18}, {3, 18}}};  // one motion of (3, 18), two periods of it
    const Program program = formulate(twice, Formulation::state).program;
    const Condensed condensed = condense(program, 1e-7);
    CHECK(condensed.program.variables() == program.variables() - 1);
    CHECK((condensed.program.lower.array() < condensed.program.upper.array()).all());
    CHECK(condensed.rows.size() == condensed.pivots.size());
    CHECK(condensed.rows.size() < static_cast<std::size_t>(program.equalities.rows()));
    CHECK_FALSE(condensed.decided);
}
