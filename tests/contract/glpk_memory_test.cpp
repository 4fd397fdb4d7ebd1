// GLPK out of memory: an exception where GLPK by itself ends the process.

#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/config.hpp"
#include "solver.hpp"

#if SIGNORINI_HAS_GLPK

#include <glpk.h>

#include <new>
#include <thread>

using namespace signorini;

namespace {

/// The paper's rows on N cells.
Program paperProgram(std::int64_t cells)
{
    return formulate({cells, {{cells / 2, 3 * cells}}}, Formulation::state).program;
}

/// Runs `action` in a thread, which has an environment of GLPK of its own.
template <typename Action>
void inThread(Action action)
{
    std::thread(action).join();
}

}  // namespace

TEST_CASE("glpk: out of memory is std::bad_alloc, and the next call works")
{
    const Program large = paperProgram(3000);
    const Program small = paperProgram(12);
    for (const char* name : {"glpk-simplex", "glpk-interior", "glpk-exact"}) {
        INFO(name);
        bool isThrown = false;
        SolverStatus after = SolverStatus::notRun;
        inThread([&] {
            const auto solver = makeSolver(name);
            glp_mem_limit(1);
            try {
                (void)solver->solve(large);
            } catch (const std::bad_alloc&) {
                isThrown = true;
            }
            after = solver->solve(small).status;
            glp_free_env();
        });
        CHECK(isThrown);
        CHECK(after == SolverStatus::optimal);
    }
}

TEST_CASE("glpk: the caller's own problems outlive a call that ran out of memory")
{
    const Program large = paperProgram(3000);
    bool isThrown = false;
    double cost = 0.0;
    inThread([&] {
        glp_prob* own = glp_create_prob();
        glp_add_cols(own, 2);
        glp_set_obj_coef(own, 2, 7.0);
        glp_mem_limit(1);
        try {
            (void)makeSolver("glpk-simplex")->solve(large);
        } catch (const std::bad_alloc&) {
            isThrown = true;
        }
        cost = glp_get_obj_coef(own, 2);
        glp_delete_prob(own);
        glp_free_env();
    });
    CHECK(isThrown);
    CHECK(cost == 7.0);
}

#endif
