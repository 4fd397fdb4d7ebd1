#include "signorini/lumped_set.hpp"

#include <Eigen/Dense>
#include <random>

#include "catch.hpp"
#include "equations.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

TEST_CASE("class types: for one phase they are the live block of the set")
{
    test::forAllSchedules(7, 3, [](const Schedule& schedule) {
        const OnePhaseSet r = onePhaseSet(schedule);
        const ClassTypes classes = classTypes(schedule);
        INFO(describe(schedule));
        REQUIRE(classes.kernelDimension == r.kernelDimension);
        for (const ClassType& type : classes.types) {
            if (type.kind == TypeKind::dead) {
                continue;
            }
            REQUIRE(type.first == r.firstLive);
            REQUIRE(type.count == r.kernelDimension);
            REQUIRE(type.signs == r.signs);
            REQUIRE((type.kind == TypeKind::blocked) == (r.reason == Reason::contactSign));
            if (type.kind != TypeKind::blocked) {
                REQUIRE(type.windowSum == r.windowSum);
            }
        }
    });
}

TEST_CASE("class types: with several phases their classes add up to the kernel of W - 1")
{
    std::mt19937_64 generator(4);
    for (int trial = 0; trial < 300; ++trial) {
        const Schedule schedule = test::randomSchedule(generator, 7, 4);
        const ClassTypes classes = classTypes(schedule);
        const Eigen::Index size = 2 * schedule.cells;
        const Eigen::MatrixXd matrix =
            Eigen::MatrixXd(periodMap(schedule)) - Eigen::MatrixXd::Identity(size, size);
        INFO(describe(schedule));
        REQUIRE(classes.kernelDimension == size - Eigen::FullPivLU<Eigen::MatrixXd>(matrix).rank());
        REQUIRE(classes.types.size() <= 2 * schedule.phases.size());
        std::int64_t next = 0;
        for (const ClassType& type : classes.types) {
            REQUIRE(type.first == next);
            next += type.count;
        }
        REQUIRE(next == classes.classes);
    }
}

TEST_CASE("class types: blocks cover the period in order, and flights end where phases do")
{
    const Schedule schedule{4, {{1, 12}, {3, 12}}};
    const ClassTypes classes = classTypes(schedule);
    std::int64_t step = 0;
    int ends = 0;
    for (const Block& block : blocksOf(classes)) {
        const ClassType& type = classes.types[block.type];
        CHECK(block.alpha * classes.classes + type.first == step);
        const bool held = step < 1 || (step >= 13 && step < 16);
        CHECK(block.isContact == held);
        CHECK(block.phase == (step < 13 ? 0U : 1U));
        step += type.count;
        ends += block.endsPhase ? 1 : 0;
        CHECK(block.endsPhase == (step == 13 || step == 28));
    }
    CHECK(step == 28);
    CHECK(ends == 2);
}
