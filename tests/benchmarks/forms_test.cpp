// The forms that benchmarks compare describe the same set of motions as the library's own.

#include "forms.hpp"

#include "catch.hpp"
#include "program.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "solver.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::bench;

namespace {

const std::vector<std::string_view> allForms{"sd", "sd-redundant", "paper", "sy", "dy", "ky", "kd"};

/// The unknowns of a form that describe a motion: those of p, then prefix sums, one per free step,
/// where the form has them.
Eigen::VectorXd pointOf(const Formulated& formulated, const State& state)
{
    Eigen::VectorXd x = Eigen::VectorXd::Zero(formulated.program.variables());
    Eigen::Index chained = x.size();
    for (const Phase& phase : formulated.schedule.phases) {
        chained -= phase.free;
    }
    test::UniformWaves line(state);
    std::size_t m = 0;
    const auto read = [&] {
        const double p = line.arriving();
        const DelayTerm& term = formulated.delay[m++];
        if (term.factor != 0.0) {
            x[term.column] = p / term.factor;
        }
        return p;
    };
    const bool hasPrefixes = formulated.program.upper.tail(1)[0] == 0.0;
    for (const Phase& phase : formulated.schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact; ++step) {
            read();
            line.contact();
        }
        double prefix = 0.0;
        for (std::int64_t step = 0; step < phase.free; ++step) {
            prefix += read();
            line.free();
            if (hasPrefixes) {
                x[chained++] = prefix;
            }
        }
    }
    return x;
}

}  // namespace

TEST_CASE("forms: every motion of a set fulfils every form, and is read back from it")
{
    std::mt19937_64 generator(1);
    int motions = 0;
    for (int draw = 0; draw < 300; ++draw) {
        const Schedule schedule = test::randomSchedule(generator, 6, 3);
        const LumpedSet set = lumpedSet(schedule);
        if (set.absence) {
            continue;
        }
        const LumpedShape shape = shapeOf(set);
        const State state = drawMotion(set, shape, generator);
        ++motions;
        for (const std::string_view form : allForms) {
            const Formulated formulated = poseForm(schedule, {.objective = Objective::any}, form);
            const Eigen::VectorXd x = pointOf(formulated, state);
            INFO(form << " " << describe(schedule));
            CHECK(violation(formulated.program, x) < 1e-9);
            const State back = stateOf(formulated, x);
            CHECK((back.a - state.a).norm() + (back.b - state.b).norm() < 1e-12 * amplitude(state));
            const State mirrored{-state.a, -state.b};
            CHECK(violation(formulated.program, pointOf(formulated, mirrored)) > 0.1);
        }
    }
    CHECK(motions > 20);
}

TEST_CASE("forms: solvers give every form the verdict of the closed form", "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    int found = 0;
    test::forAllSchedules(3, 2, [&](const Schedule& schedule) {
        const bool exists = !onePhaseSet(schedule).reason;
        found += exists ? 1 : 0;
        for (const std::string_view form : allForms) {
            for (const bool isUnfolded : {false, true}) {
                if (isUnfolded && form[0] == 'k') {
                    continue;
                }
                const Formulated formulated = poseForm(schedule, {.objective = Objective::any},
                                                       form, {.longPhases = isUnfolded});
                const SolverResult result = solver->solve(formulated.program);
                INFO(form << " " << describe(schedule) << " " << result.detail);
                REQUIRE((result.status == SolverStatus::optimal) == exists);
                if (exists) {
                    REQUIRE(
                        verify(stateOf(formulated, result.x), schedule, 1e-6).residuals.worst() <
                        1e-6);
                }
            }
        }
    });
    CHECK(found > 10);
}

TEST_CASE("forms: a strain limit as rows decides as a limit on single waves does", "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    const Schedule schedule{6, {{3, 18}}};
    const double least =
        extremesOf(leastEnergyMotion(onePhaseSet(schedule)), schedule).peakCompression;
    for (const std::string_view form : {"sd", "sy", "dy", "ky", "kd"}) {
        for (const double share : {0.99, 1.01}) {
            const Demands demands{.objective = Objective::any, .strainLimit = share * least};
            const Formulated formulated = poseForm(schedule, demands, form, {.strainRows = true});
            INFO(form << " " << share);
            CHECK((solver->solve(formulated.program).status == SolverStatus::optimal) ==
                  (share > 1.0));
        }
    }
}

TEST_CASE("forms: what a form does not know is refused")
{
    const Schedule schedule{6, {{3, 18}}};
    CHECK_THROWS_AS(poseForm(schedule, {}, "no such form"), std::invalid_argument);
    CHECK_THROWS_AS(poseForm(schedule, {.objective = Objective::minPeakStrain}, "sy"),
                    std::invalid_argument);
}
