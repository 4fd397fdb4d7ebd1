#include "program.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace signorini;

namespace {

/// minimise x + y^2 subject to x + y = 2, x <= 1.5, 0 <= y.
Program example()
{
    Program program = emptyProgram(2);
    program.equalities.resize(1, 2);
    program.equalities.insert(0, 0) = 1.0;
    program.equalities.insert(0, 1) = 1.0;
    program.equalityRhs = Eigen::VectorXd::Constant(1, 2.0);
    program.inequalities.resize(1, 2);
    program.inequalities.insert(0, 0) = 1.0;
    program.inequalityRhs = Eigen::VectorXd::Constant(1, 1.5);
    program.lower[1] = 0.0;
    program.linear = Eigen::Vector2d{1.0, 0.0};
    program.quadratic = Eigen::Vector2d{0.0, 2.0};
    return program;
}

}  // namespace

TEST_CASE("program: objective and violation are those of the definition")
{
    const Program program = example();
    validate(program);
    CHECK(objective(program, Eigen::Vector2d(1.5, 0.5)) == 1.75);
    CHECK(violation(program, Eigen::Vector2d(1.5, 0.5)) == 0.0);
    CHECK(violation(program, Eigen::Vector2d(2.0, 0.0)) == Approx(0.5 / 1.5));
    CHECK(violation(program, Eigen::Vector2d(1.0, 0.5)) == Approx(0.25));
    CHECK(violation(program, Eigen::Vector2d(3.0, -1.0)) == Approx(1.0));
    CHECK(std::isinf(violation(program, Eigen::Vector2d(std::nan(""), 0.0))));
    CHECK(std::isinf(violation(program, Eigen::VectorXd(3))));
}

TEST_CASE("program: an energy equality counts as a row")
{
    Program program = emptyProgram(2);
    program.energy = EnergyEquality{Eigen::Vector2d{1.0, 2.0}, 9.0};
    CHECK(violation(program, Eigen::Vector2d(1.0, 2.0)) == 0.0);
    CHECK(violation(program, Eigen::Vector2d(0.0, 0.0)) == 1.0);
}

TEST_CASE("program: malformed programs are refused, each fault by name")
{
    const auto faultOf = [](auto change, const char* text) {
        Program program = example();
        change(program);
        CHECK_THROWS_WITH(validate(program), containsText(text));
    };
    const double nan = std::nan("");
    const double inf = std::numeric_limits<double>::infinity();
    faultOf([](Program& p) { p.lower.resize(3); }, "lower");
    faultOf([](Program& p) { p.equalityRhs.resize(0); }, "equalityRhs");
    faultOf([](Program& p) { p.inequalities.resize(1, 5); }, "columns of inequalities");
    faultOf([&](Program& p) { p.linear[0] = nan; }, "linear");
    faultOf([&](Program& p) { p.equalityRhs[0] = inf; }, "equalityRhs");
    faultOf([&](Program& p) { p.equalities.coeffRef(0, 0) = nan; }, "equalities");
    faultOf([&](Program& p) { p.inequalities.coeffRef(0, 0) = nan; }, "inequalities");
    faultOf([](Program& p) { p.lower[0] = 1.0, p.upper[0] = 0.0; }, "bounds of variable 0");
    faultOf([&](Program& p) { p.lower[0] = nan; }, "bounds of variable 0");
    faultOf([](Program& p) { p.quadratic[1] = -1.0; }, "convex");
    faultOf([](Program& p) { p.energy = EnergyEquality{Eigen::Vector2d{1, -1}, 1.0}; }, "energy");
    faultOf(
        [](Program& p) {
            p.energy = EnergyEquality{Eigen::Vector2d{1, 1}, 0.0};
        },
        "energy value");
    CHECK_THROWS_WITH(validate(emptyProgram(0)), containsText("number of variables"));
}
