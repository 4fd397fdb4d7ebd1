#include "stepped_energy.hpp"
#include "stepped_form.hpp"

#include <limits>

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<SteppedEnergyProof> proofOf(const Schedule& schedule,
                                          const std::vector<Segment>& segments)
{
    return leastEnergyProof(blocksOf(steppedBar(segments), schedule, -infinity));
}

}  // namespace

TEST_CASE("stepped energy: for equal segments the bound is the least energy of theory.md section 7")
{
    int proved = 0;
    test::forAllSchedules(6, 6, [&proved](const Schedule& schedule) {
        const OnePhaseSet set = onePhaseSet(schedule);
        const std::int64_t cells = schedule.cells;
        if (cells == 1 || set.reason) {
            return;
        }
        INFO(describe(schedule));
        const auto proof = proofOf(schedule, {{1}, {cells - 1}});
        REQUIRE(proof);
        REQUIRE(proof->energyRatio == Approx(energyRange(set).least).epsilon(1e-14));
        ++proved;
    });
    CHECK(proved > 100);
}
