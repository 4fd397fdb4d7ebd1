// Finds, proves, verifies and reads numbers from motions with nothing but the core: what a browser
// or a small machine needs. Built by GCC, Clang with libc++, for 32 bits and by Emscripten.

#include <cmath>
#include <cstdio>

#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/verification.hpp"

namespace {

int failures = 0;

void expect(bool holds, const char* claim)
{
    std::printf("%s  %s\n", holds ? "ok    " : "FAILED", claim);
    failures += holds ? 0 : 1;
}

}  // namespace

int main()
{
    using namespace signorini;
    const Schedule paper{300, {{150, 900}}};
    const PeriodicResult found = findPeriodic(paper);
    expect(found.status == Status::found && found.motion->energyRatio == 4.0,
           "the paper's case: least energy 4 E_1");
    expect(verify(found.motion->state, paper).residuals.worst() < 1e-12, "its residuals vanish");

    const Motion motion(found.motion->state, paper);
    double highest = 0.0;
    for (std::int64_t m = 0; m <= motion.steps(); ++m) {
        highest = std::fmax(highest, motion.displacement(300, m));
    }
    expect(std::fabs(highest - 1.0) < 1e-12, "its tip reaches the wall and no further");

    const PeriodicResult none = findPeriodic(20, 109, 40);
    expect(none.status == Status::none && isProof(none),
           "(20, 109) on 40 cells: none, and the proof holds");

    const PeriodicResult two = findPeriodic(Schedule{4, {{1, 12}, {3, 12}}});
    expect(two.status == Status::found && std::fabs(two.motion->energyRatio - 16.0 / 3.0) < 1e-12,
           "two contacts: least energy 16/3 E_1");

    expect(findModes().size() == 29, "29 modes of order 25 below 50 E_1");

    const Continuum curve = traceContinuum(paper, 20.0);
    expect(curve.status == Status::found && curve.points.size() == 201, "a continuum at 20 E_1");
    return failures;
}
