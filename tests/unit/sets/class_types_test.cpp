#include "signorini/lumped_set.hpp"

#include <Eigen/Dense>
#include <array>
#include <random>
#include <vector>

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

TEST_CASE("class types: the classes of a type meet contact together, as often as it says")
{
    std::mt19937_64 generator(5);
    for (int trial = 0; trial < 500; ++trial) {
        const Schedule schedule = test::randomSchedule(generator, 7, 4);
        const ClassTypes classes = classTypes(schedule);
        INFO(describe(schedule));
        std::vector<std::int64_t> contacts(static_cast<std::size_t>(classes.classes));
        std::int64_t step = 0;
        for (const Phase& phase : classes.schedule.phases) {
            for (std::int64_t k = 0; k < phase.contact; ++k, ++step) {
                ++contacts[static_cast<std::size_t>(step % classes.classes)];
            }
            step += phase.free;
        }
        REQUIRE(step == classes.members * classes.classes);
        for (const ClassType& type : classes.types) {
            for (std::int64_t j = type.first; j < type.first + type.count; ++j) {
                REQUIRE(type.contactMembers == contacts[static_cast<std::size_t>(j)]);
            }
        }
    }
}

TEST_CASE("class types: the gap is the reason exactly if no amplitude brings the tip to the wall")
{
    std::mt19937_64 generator(6);
    std::array<int, 2> unmoved{};  // types that leave the tip where it is, by the sign of the gap
    int grazing = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Schedule schedule = test::randomSchedule(generator, 8, 3);
        schedule.stops.right = trial % 2 == 0 ? 1 : -1;
        const ClassTypes classes = classTypes(schedule);
        bool canReach = false;
        bool isLive = false;
        bool rests = false;
        bool grazes = false;
        for (const ClassType& type : classes.types) {
            if (!type.isLive()) {
                continue;
            }
            std::vector<double> z(static_cast<std::size_t>(classes.classes));
            z[static_cast<std::size_t>(type.first)] = 1.0;
            // u(L, 0)/g = (sum b - sum a)/N: the row of the gap is the paper's own.
            const State state = motionOf(classes, z);
            const double reached = (state.b.sum() - state.a.sum()) * schedule.stops.right;
            isLive = true;
            rests = rests || reached == 0.0;
            grazes = grazes || type.kind == TypeKind::grazing;
            canReach = canReach || reached > 0.0 ||
                       (type.kind == TypeKind::grazing && reached != 0.0);  // of either sign
        }
        if (!isLive || (canReach && !lumpedSetOf(classes).absence)) {
            continue;
        }
        INFO(describe(schedule) << " gap " << schedule.stops.right);
        REQUIRE(absenceReason(classes) == (canReach ? Reason::penetration : Reason::gap));
        unmoved[static_cast<std::size_t>(trial % 2)] += rests && !canReach ? 1 : 0;
        grazing += grazes ? 1 : 0;
    }
    CHECK(unmoved[0] > 5);
    CHECK(unmoved[1] > 5);
    CHECK(grazing > 5);
}
