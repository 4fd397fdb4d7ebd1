#include "solver.hpp"

#include <algorithm>
#include <vector>

#include "catch.hpp"

using namespace signorini;

namespace {

/// Claims whatever it is told to: the interface must not believe it.
class Liar final : public Solver {
public:
    explicit Liar(Eigen::VectorXd x) : Solver({.name = "liar"}), x_(std::move(x)) {}

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

TEST_CASE("solver: who is chosen for a program stands in the table, the first in the build")
{
    const auto namesFor = [](const Capabilities& needs) {
        std::vector<std::string_view> names;
        for (const Backend* row : candidates(needs)) {
            CHECK(covers(row->can, needs));
            names.push_back(row->name);
        }
        return names;
    };
    using Names = std::vector<std::string_view>;
    CHECK(namesFor({}) == Names{"glpk-simplex", "ipopt"});
    CHECK(namesFor({.duals = true}) == Names{"glpk-simplex"});
    CHECK(namesFor({.cancel = true}) == Names{"glpk-simplex", "ipopt"});
    CHECK(namesFor({.quadraticObjective = true}) == Names{"ipopt", "nlopt-slsqp"});
    CHECK(namesFor({.energyEquality = true}) == Names{"ipopt", "nlopt-auglag"});
    CHECK(namesFor({.quadraticObjective = true, .energyEquality = true}) ==
          Names{"ipopt", "nlopt-auglag"});
    CHECK(namesFor({.quadraticObjective = true, .duals = true}).empty());

    for (const Capabilities& needs :
         {Capabilities{}, Capabilities{.quadraticObjective = true},
          Capabilities{.energyEquality = true}, Capabilities{.duals = true}}) {
        const auto rows = candidates(needs);
        const auto first = std::find_if(rows.begin(), rows.end(),
                                        [](const Backend* row) { return row->available(); });
        if (first == rows.end()) {
            CHECK(preferred(needs) == nullptr);
            CHECK_THROWS_AS(choose(needs), BackendUnavailable);
            CHECK_THROWS_WITH(choose(needs), containsText(std::string(rows.front()->name)));
        } else {
            CHECK(preferred(needs) == *first);
            CHECK(&choose(needs) == *first);
        }
    }
    CHECK_THROWS_WITH(choose({.energyEquality = true, .duals = true}),
                      containsText("no solver can"));
}

TEST_CASE("solver: what a program needs is read off it")
{
    Program program = nonNegative();
    CHECK(needsOf(program) == Capabilities{});
    program.quadratic = Eigen::Vector2d(0, 0);
    CHECK(needsOf(program) == Capabilities{});
    program.quadratic = Eigen::Vector2d(0, 1);
    CHECK(needsOf(program) == Capabilities{.quadraticObjective = true});
    program.energy = EnergyEquality{Eigen::Vector2d(1, 1), 1.0};
    CHECK(needsOf(program) == Capabilities{.quadraticObjective = true, .energyEquality = true});
}

TEST_CASE("solver: before the call a result says that nothing was run")
{
    CHECK(SolverResult{}.status == SolverStatus::notRun);
    CHECK(name(SolverResult{}.status) == "not run");
}
