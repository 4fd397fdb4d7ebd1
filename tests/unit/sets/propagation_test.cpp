// The echo, which is all that moves a uniform bar.

#include "arrivals.hpp"
#include "catch.hpp"
#include "echo.hpp"
#include "equations.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

void walk(Echo& echo, std::int64_t count, bool isContact)
{
    forEachPiece(echo, count, isContact, [](const Arrivals&) {});
}

void walk(Echo& echo, const Schedule& schedule)
{
    for (const Phase& phase : schedule.phases) {
        walk(echo, phase.contact, true);
        walk(echo, phase.free, false);
    }
}

/// Where it has come to: all that arrives next.
State stateOf(Echo echo, std::int64_t cells)
{
    std::vector<double> p;
    forEachPiece(echo, 2 * cells, true, [&p](const Arrivals& next) {
        for (std::int64_t k = 0; k < next.count(); ++k) {
            p.push_back(next.at(k));
        }
    });
    return stateOfWaves(cells, [&p](std::int64_t m) { return p[static_cast<std::size_t>(m)]; });
}

}  // namespace

TEST_CASE("propagation: a contact step and a free step are the boundary conditions (17)-(19)")
{
    const State before = test::randomState(4);
    const bool inContact = GENERATE(true, false);
    Echo echo(before);
    CHECK(echo.ahead(1).at(0) == before.a[3]);
    echo.advance(1, inContact);
    const State after = stateOf(echo, 4);
    for (Eigen::Index i = 1; i < 4; ++i) {
        CHECK(after.a[i] == before.a[i - 1]);
        CHECK(after.b[i - 1] == before.b[i]);
    }
    CHECK(after.a[0] == -before.b[0]);
    CHECK(after.b[3] == (inContact ? -before.a[3] : before.a[3]));
}

TEST_CASE("propagation: many steps at once equal steps one by one, at any length")
{
    const std::int64_t count = GENERATE(0, 1, 5, 6, 7, 11, 12, 13, 23, 24, 25, 100);
    const State start = test::randomState(3);
    Echo jump(start);
    Echo single(start);
    for (const auto& [times, isContact] :
         {std::pair{std::int64_t{2}, true}, {count, false}, {count, true}}) {
        walk(jump, times, isContact);
        for (std::int64_t k = 0; k < times; ++k) {
            single.advance(1, isContact);
        }
    }
    CHECK(stateOf(jump, 3) == stateOf(single, 3));
    CHECK(jump.distance() == single.distance());
}

TEST_CASE("propagation: one period is W of (30)")
{
    for (const Schedule& schedule :
         {test::onePhase(1, 1, 2), test::onePhase(3, 2, 9), test::onePhase(4, 11, 30),
          Schedule{5, {{1, 1}, {1, 13}, {4, 7}}}}) {
        const State start = test::randomState(schedule.cells);
        Echo echo(start);
        walk(echo, schedule);
        CHECK(test::stacked(stateOf(echo, schedule.cells)) ==
              periodMap(schedule) * test::stacked(start));
    }
}

TEST_CASE("propagation: energy is conserved exactly in sum")
{
    const State start = test::randomState(6);
    Echo echo(start);
    walk(echo, {6, {{5, 17}}});
    CHECK(energyRatio(stateOf(echo, 6)) == Approx(energyRatio(start)).epsilon(1e-15));
}

TEST_CASE("propagation: 10^6 periods bring a periodic state back bit for bit")
{
    const Schedule schedule = test::onePhase(8, 5, 23);
    const OnePhaseSet whole = onePhaseSet(schedule);
    std::mt19937_64 generator(7);
    const State start = motionOf(whole, drawAmplitudes(whole.set, generator));
    Echo echo(start);
    for (int period = 0; period < 1'000'000; ++period) {
        walk(echo, schedule);
    }
    CHECK(stateOf(echo, 8) == start);
    CHECK(echo.distance() == 0.0);
}

TEST_CASE("propagation: malformed states are refused")
{
    CHECK_THROWS_AS(Echo(State{}), std::invalid_argument);
    const State uneven{Eigen::VectorXd(2), Eigen::VectorXd(3)};
    CHECK_THROWS_AS(Echo(uneven), std::invalid_argument);
}
