// Where the next motions are.

#include "near_schedule.hpp"

#include <cstdlib>
#include <random>

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"

using namespace signorini;

TEST_CASE("near schedule: no schedule with motions that press is nearer")
{
    std::mt19937_64 generator(20261124);
    std::uniform_int_distribution<std::int64_t> steps(1, 40);
    int count = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const std::int64_t cells = 1 + trial % 7;
        const int gapSign = trial % 5 == 0 ? -1 : 1;
        const Phase asked{steps(generator), steps(generator)};
        const auto near = nearSchedule({cells, {asked}}, gapSign);
        // Every schedule around, decided by the whole set instead of the walk that ends early.
        std::int64_t least = farthestNearSchedule + 1;
        for (std::int64_t contact = 1; contact <= asked.contact + 60; ++contact) {
            for (std::int64_t free = 1; free <= asked.free + 60; ++free) {
                const std::int64_t away =
                    std::abs(contact - asked.contact) + std::abs(free - asked.free);
                if (away == 0 || away >= least) {
                    continue;
                }
                const OnePhaseSet set =
                    onePhaseSet({cells, {{contact, free}}, Stops{.right = gapSign}});
                if (!set.reason && set.contact == Contact::pressing) {
                    least = away;
                }
            }
        }
        INFO(cells << ": " << asked.contact << ' ' << asked.free);
        REQUIRE(near.has_value() == (least <= farthestNearSchedule));
        if (near) {
            const Phase& found = near->phases.front();
            CHECK(std::abs(found.contact - asked.contact) + std::abs(found.free - asked.free) ==
                  least);
            ++count;
        }
    }
    CHECK(count > 150);
}

TEST_CASE("near schedule: of one contact only")
{
    CHECK_FALSE(nearSchedule({4, {{1, 12}, {3, 12}}}, 1));
    CHECK_FALSE(nearSchedule({4, {{1, 12, Stop::left}}}, 1));
}
