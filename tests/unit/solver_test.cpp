#include "solver.hpp"

#include "catch.hpp"

using namespace signorini;

namespace {

/// Claims whatever it is told to: the interface must not believe it.
class Liar final : public Solver {
public:
    explicit Liar(Eigen::VectorXd x) : x_(std::move(x)) {}
    std::string_view name() const override { return "liar"; }
    Capabilities capabilities() const override { return {}; }

private:
    SolverResult run(const Program&, const SolverOptions&) const override
    {
        SolverResult result;
        result.status = SolverStatus::optimal;
        result.detail = "trust me";
        result.x = x_;
        return result;
    }
    Eigen::VectorXd x_;
};

Program nonNegative()
{
    Program program = emptyProgram(2);
    program.lower.setZero();
    return program;
}

}  // namespace

TEST_CASE("solver: a claim is recomputed, and a false one becomes failed")
{
    CHECK(Liar(Eigen::Vector2d(1, 1)).solve(nonNegative()).status == SolverStatus::optimal);
    const SolverResult lie = Liar(Eigen::Vector2d(1, -1)).solve(nonNegative());
    CHECK(lie.status == SolverStatus::failed);
    CHECK(lie.violation == 1.0);
    CHECK_THAT(lie.detail, containsText("violates"));
    CHECK(Liar(Eigen::VectorXd(5)).solve(nonNegative()).status == SolverStatus::failed);
    CHECK(Liar(Eigen::Vector2d(1, std::nan(""))).solve(nonNegative()).status ==
          SolverStatus::failed);
}

TEST_CASE("solver: options that a back end cannot honour are refused by name")
{
    const Liar solver(Eigen::Vector2d(1, 1));
    const auto refuses = [&](const SolverOptions& options, const char* text) {
        CHECK_THROWS_WITH(solver.solve(nonNegative(), options), containsText(text));
    };
    refuses({.iterationLimit = 3}, "iterationLimit");
    refuses({.timeLimit = 3.0}, "timeLimit");
    refuses({.start = Eigen::VectorXd::Zero(2)}, "start");
    refuses({.cancel = [] { return false; }}, "cancel");
    refuses({.tolerance = 0.0}, "tolerance = 0");
    refuses({.timeLimit = -1.0}, "timeLimit = -1");
    refuses({.start = Eigen::VectorXd::Zero(3)}, "size of start");
    Program quadratic = nonNegative();
    quadratic.quadratic = Eigen::Vector2d(1, 1);
    CHECK_THROWS_WITH(solver.solve(quadratic), containsText("quadratic objective"));
}

TEST_CASE("solver: the table knows its rows, and unknown names are refused with the known ones")
{
    CHECK(findBackend("closed-form").available());
    CHECK_THROWS_WITH(findBackend("oracle"),
                      containsText("solver = oracle") && containsText("glpk-simplex"));
    CHECK_THROWS_AS(makeSolver("closed-form"), std::invalid_argument);
    for (const Backend& backend : backends()) {
        INFO(backend.name);
        if (!backend.available()) {
            CHECK_THROWS_AS(makeSolver(backend.name), BackendUnavailable);
        } else if (backend.make != nullptr) {
            CHECK(makeSolver(backend.name)->name() == backend.name);
            CHECK_FALSE(backend.version().empty());
        }
    }
}

TEST_CASE("solver: before the call a result says that nothing was run")
{
    CHECK(SolverResult{}.status == SolverStatus::notRun);
    CHECK(name(SolverResult{}.status) == "not run");
}
