// Properties on random schedules, shrunk to the smallest counterexample by RapidCheck.

#include <rapidcheck.h>

#include <Eigen/Dense>

#include "catch.hpp"
#include "equations.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

struct Sizes {
    std::int64_t cells, contact, free;
};

Sizes anySizes(std::int64_t maxCells)
{
    const auto cells = *rc::gen::inRange<std::int64_t>(1, maxCells + 1);
    return {cells, *rc::gen::inRange<std::int64_t>(1, 3 * cells + 1),
            *rc::gen::inRange<std::int64_t>(1, 12 * cells + 1)};
}

Schedule anySchedule(std::int64_t maxCells)
{
    const Sizes s = anySizes(maxCells);
    return test::onePhase(s.cells, s.contact, s.free);
}

/// Half of the time a schedule of the main branch, which always has motions.
Schedule oftenFeasible(std::int64_t maxCells)
{
    const Sizes s = anySizes(maxCells);
    if (s.cells > 1 && *rc::gen::arbitrary<bool>()) {
        const std::int64_t contact = 1 + s.contact % (s.cells - 1);
        return test::onePhase(s.cells, contact, 4 * s.cells - 2 * contact);
    }
    return test::onePhase(s.cells, s.contact, s.free);
}

bool close(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

}  // namespace

TEST_CASE("property: the kernel dimension equals the rank computation")
{
    CHECK(rc::check([] {
        const Schedule schedule = anySchedule(12);
        const Eigen::Index size = 2 * schedule.cells;
        const Eigen::MatrixXd matrix =
            Eigen::MatrixXd(periodMap(schedule)) - Eigen::MatrixXd::Identity(size, size);
        RC_ASSERT(onePhaseSet(schedule).kernelDimension ==
                  size - Eigen::FullPivLU<Eigen::MatrixXd>(matrix).rank());
    }));
}

TEST_CASE("property: every motion drawn from a set passes the residuals and the march")
{
    CHECK(rc::check([] {
        const Schedule schedule = oftenFeasible(60);
        const OnePhaseSet r = onePhaseSet(schedule);
        RC_PRE(!r.reason);
        std::mt19937_64 generator(*rc::gen::arbitrary<std::uint64_t>());
        const State state = motionOf(r, drawAmplitudes(r.set, generator));
        const Verification v = verify(state, schedule);
        RC_ASSERT(v.residuals.worst() < 1e-12);
        const EnergyRange range = energyRange(r);
        RC_ASSERT(energyRatio(state) >= range.least * (1 - 1e-12));
        RC_ASSERT(energyRatio(state) <= range.most * (1 + 1e-12));
    }));
}

TEST_CASE("property: energy is conserved by every step")
{
    CHECK(rc::check([] {
        const Schedule schedule = anySchedule(40);
        const State start = test::randomState(schedule.cells, *rc::gen::arbitrary<unsigned>());
        test::UniformWaves line(start);
        line.contact(schedule.phases[0].contact);
        RC_ASSERT(close(energyRatio(line.state()), energyRatio(start), 1e-14));
        line.free(schedule.phases[0].free);
        RC_ASSERT(close(energyRatio(line.state()), energyRatio(start), 1e-14));
    }));
}

TEST_CASE("property: every schedule is either a verified motion or a verified proof")
{
    CHECK(rc::check([] {
        const PeriodicResult result = findPeriodic(oftenFeasible(200));
        RC_ASSERT(result.status != Status::undecided);
        RC_ASSERT((result.status == Status::none) == isProof(result));
        if (result.status == Status::found) {
            RC_ASSERT(result.motion->residuals.worst() < 1e-12);
        }
    }));
}

TEST_CASE("property: scaling L, c, EA, g scales the answer")
{
    CHECK(rc::check([] {
        const Schedule schedule = oftenFeasible(30);
        const auto factor = [] { return std::pow(10.0, *rc::gen::inRange(-5, 6)); };
        const double l = factor();
        const double c = factor();
        const double ea = factor();
        const double g = factor();
        const PeriodicResult unit = findPeriodic(schedule);
        const PeriodicResult scaled = findPeriodic(
            schedule,
            {.scene = Bar{.length = l, .waveSpeed = c, .axialStiffness = ea, .gap = 1e-3 * g}});
        RC_ASSERT(scaled.status == unit.status);
        RC_ASSERT(scaled.motion.has_value() == unit.motion.has_value());
        if (!unit.motion) {
            return;
        }
        RC_ASSERT(scaled.motion->state == unit.motion->state);
        RC_ASSERT(scaled.motion->energyRatio == unit.motion->energyRatio);
        RC_ASSERT(close(scaled.period / unit.period, l / c, 1e-12));
        RC_ASSERT(close(scaled.motion->energy * l / (ea * g * g * unit.scene.bar.axialStiffness),
                        unit.motion->energy, 1e-12));
    }));
}

TEST_CASE("property: refining the grid keeps the verdict on motions and E_min")
{
    CHECK(rc::check([] {
        const Schedule coarse = oftenFeasible(20);
        const auto factor = *rc::gen::inRange<std::int64_t>(1, 6);
        const Schedule fine =
            test::onePhase(coarse.cells * factor, coarse.phases[0].contact * factor,
                           coarse.phases[0].free * factor);
        const OnePhaseSet a = onePhaseSet(coarse);
        const OnePhaseSet b = onePhaseSet(fine);
        RC_ASSERT(a.reason == b.reason);
        if (!a.reason && a.contact == Contact::pressing) {
            RC_ASSERT(close(energyRange(b).least, energyRange(a).least, 1e-12));
        }
    }));
}
