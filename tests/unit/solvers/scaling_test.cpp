// A scaled program says the same as the one it was made of, to the last bit.

#include "scaling.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

using namespace signorini;

namespace {

bool isPowerOfTwo(double value)
{
    int exponent = 0;
    return std::frexp(value, &exponent) == 0.5;
}

/// Rows, bounds and costs as of a bar in metres and newtons: sizes far apart.
Program drawProgram(std::mt19937_64& generator)
{
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-40, 40);
    Program program = emptyProgram(4);
    const auto fill = [&](auto& rows, Eigen::VectorXd& rhs, Eigen::Index count) {
        rows.resize(count, 4);
        rhs.resize(count);
        for (Eigen::Index row = 0; row < count; ++row) {
            const double size = std::ldexp(1.0, exponent(generator));
            for (Eigen::Index column = 0; column < 4; ++column) {
                rows.insert(row, column) = size * number(generator);
            }
            rhs[row] = size * 1e-6 * number(generator);
        }
        rows.makeCompressed();
    };
    fill(program.equalities, program.equalityRhs, 2);
    fill(program.inequalities, program.inequalityRhs, 3);
    for (Eigen::Index k = 0; k < 4; ++k) {
        program.linear[k] = 1e9 * number(generator);
    }
    program.lower.setConstant(-1e-3);
    return program;
}

/// A program that is scaled, how, and what becomes of it.
struct Scaled {
    explicit Scaled(std::mt19937_64& generator) : program(drawProgram(generator))
    {
        const auto found = scalingOf(program);
        REQUIRE(found);
        scaling = *found;
        copy = scaled(program, scaling);
    }

    Program program;
    Scaling scaling;
    Program copy;
};

}  // namespace

TEST_CASE("scaling: all factors are powers of two, and the largest entry of each row is about 1")
{
    std::mt19937_64 generator(1);
    for (int trial = 0; trial < 100; ++trial) {
        const auto [program, scaling, copy] = Scaled(generator);
        REQUIRE(isPowerOfTwo(scaling.unit));
        REQUIRE(isPowerOfTwo(scaling.objective));
        for (const auto* factors : {&scaling.equalities, &scaling.inequalities}) {
            for (const double factor : *factors) {
                REQUIRE(isPowerOfTwo(factor));
            }
        }
        for (Eigen::Index row = 0; row < 3; ++row) {
            const double largest =
                Eigen::RowVectorXd(copy.inequalities.row(row)).cwiseAbs().maxCoeff();
            REQUIRE(largest >= 1.0);
            REQUIRE(largest < 2.0);
        }
    }
}

TEST_CASE("scaling: values of rows, bounds and objective are those of the point in the new unit")
{
    std::mt19937_64 generator(2);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        const auto [program, scaling, copy] = Scaled(generator);
        const Eigen::VectorXd inside =
            Eigen::VectorXd::NullaryExpr(4, [&] { return number(generator); });
        const Eigen::VectorXd x = scaling.unit * inside;
        REQUIRE(copy.equalities * inside - copy.equalityRhs ==
                scaling.equalities.cwiseProduct(program.equalities * x - program.equalityRhs));
        REQUIRE(
            copy.inequalities * inside - copy.inequalityRhs ==
            scaling.inequalities.cwiseProduct(program.inequalities * x - program.inequalityRhs));
        REQUIRE(copy.lower * scaling.unit == program.lower);
        REQUIRE(objective(copy, inside) == scaling.objective * objective(program, x));
    }
}

TEST_CASE("scaling: multipliers of the copy, turned back, have the reduced costs of the program")
{
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        const auto [program, scaling, copy] = Scaled(generator);
        SolverResult result;
        const auto draw = [&](Eigen::Index size) {
            return Eigen::VectorXd::NullaryExpr(size, [&] { return number(generator); }).eval();
        };
        result.x = draw(4);
        result.equalityDuals = draw(2);
        result.inequalityDuals = draw(3);
        const Eigen::VectorXd costs = copy.linear -
                                      copy.equalities.transpose() * result.equalityDuals -
                                      copy.inequalities.transpose() * result.inequalityDuals;
        unscale(scaling, result);
        const Eigen::VectorXd back = program.linear -
                                     program.equalities.transpose() * result.equalityDuals -
                                     program.inequalities.transpose() * result.inequalityDuals;
        REQUIRE(costs == scaling.objective * scaling.unit * back);
    }
}

TEST_CASE("scaling: a program of modest numbers stays as it is")
{
    Program program = emptyProgram(2);
    program.linear << 1.0, -3.0;
    CHECK_FALSE(scalingOf(program));
}
