#include "signorini/continuum.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include "catch.hpp"
#include "continuum_support.hpp"
#include "energy_section.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/demands.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::onePhase;
using signorini::test::paper;
using signorini::test::requirePoints;

namespace {

/// The motion with equal amplitudes on classes first .. first + count - 1.
State blockMotion(const Schedule& schedule, std::size_t first, std::size_t count)
{
    const OnePhaseSet whole = onePhaseSet(schedule);
    std::vector<double> z(static_cast<std::size_t>(whole.set.count), 0.0);
    for (std::size_t j = first; j < first + count; ++j) {
        z[j] = whole.set.sum / static_cast<double>(count);
    }
    return motionOf(whole, z);
}

/// A motion of the paper's case at 400 E_1 with the given dominant amplitude.
State spikeMotion(std::size_t apex)
{
    const OnePhaseSet whole = onePhaseSet(paper);
    const double rho = 400.0 / 600.0;
    const double top = 0.5 * (1.0 + std::sqrt(2.0 * rho - 1.0));
    std::vector<double> z(150, 0.0);
    z[apex] = top * whole.set.sum;
    z[apex + 1] = (1.0 - top) * whole.set.sum;
    return motionOf(whole, z);
}

double beyond(double value, double direction)
{
    return std::nextafter(value, direction);
}

}  // namespace

TEST_CASE("continuum: the paper's case, a path between the ends of the bar at 20 E_1")
{
    const trace::Path path{blockMotion(paper, 0, 30), blockMotion(paper, 120, 30)};
    const Continuum curve = traceContinuum(paper, 20.0, {.trace = path});
    requirePoints(curve, 201, 1e-12);
    CHECK(curve.connected == true);
    CHECK(amplitude({curve.points.front().state.a - path.from.a,
                     curve.points.front().state.b - path.from.b}) < 1e-12);
    CHECK(amplitude({curve.points.back().state.a - path.to.a,
                     curve.points.back().state.b - path.to.b}) < 1e-12);
    const double step = curve.points.back().lambda / 200.0;
    for (std::size_t k = 1; k < curve.points.size(); ++k) {
        const State& last = curve.points[k - 1].state;
        const State& next = curve.points[k].state;
        CHECK(curve.points[k].lambda - curve.points[k - 1].lambda == Approx(step));
        CHECK(std::sqrt(energyRatio({next.a - last.a, next.b - last.b})) <= 1.05 * step);
    }
}

TEST_CASE("continuum: at 400 E_1 the motions of the paper's case fall into 150 components")
{
    const State spike = spikeMotion(3);
    const Continuum apart =
        traceContinuum(paper, 400.0, {.trace = trace::Path{spike, spikeMotion(70)}});
    CHECK(apart.status == Status::none);
    CHECK(apart.connected == false);
    CHECK(apart.components == 150);
    CHECK(apart.points.empty());
    CHECK_THAT(apart.detail,
               containsText("different components") && containsText("4.") && containsText("71."));

    CHECK(traceContinuum(paper, 400.0, {.trace = trace::Path{spike, spike}}).connected == true);

    const Continuum whole = traceContinuum(paper, 400.0);
    requirePoints(whole, 201, 1e-12);
    CHECK(whole.connected == false);
    CHECK(whole.orbits == 201);
    CHECK_THAT(whole.detail, containsText("cannot be cut"));
}

TEST_CASE("continuum: connectivity is decided exactly at rho = 1/2")
{
    const OnePhaseSet whole = onePhaseSet(paper);
    CHECK(connectivityOf(whole, 300.0).components == 1);
    CHECK(connectivityOf(whole, beyond(300.0, 1e9)).components == 150);
    CHECK(connectivityOf(whole, beyond(300.0, 0.0)).components == 1);
    const OnePhaseSet pair = onePhaseSet(onePhase(4, 2, 12));
    REQUIRE(pair.set.count == 2);
    const EnergyRange range = energyRange(pair);
    CHECK(connectivityOf(pair, range.least).components == 1);
    CHECK(connectivityOf(pair, beyond(range.least, 1e9)).components == 2);
    CHECK(connectivityOf(pair, range.most).components == 2);
    ContinuumOptions options;
    options.trace = trace::RandomPath{1};
    for (const double energy : {300.0, beyond(300.0, 0.0)}) {
        requirePoints(traceContinuum(paper, energy, options), 201, 1e-11);
    }
}

TEST_CASE("continuum: both ends of the range, and beyond them by more than the tolerance")
{
    for (const Schedule& schedule :
         {paper, onePhase(8, 5, 23), onePhase(9, 3, 20), onePhase(7, 3, 23), onePhase(12, 6, 36)}) {
        const EnergyRange range = energyRange(onePhaseSet(schedule));
        INFO(describe(schedule) << " " << range.least << " " << range.most);
        const auto statusAt = [&schedule](double energy) {
            const Status found = traceContinuum(schedule, energy).status;
            FindOptions options;
            options.energyRatio = energy;
            CHECK(findPeriodic(schedule, options).status == found);
            return found;
        };
        CHECK(statusAt(range.least) == Status::found);
        CHECK(statusAt(range.most) == Status::found);
        CHECK(statusAt(range.least * (1.0 - 1e-6)) == Status::none);
        CHECK(statusAt(range.most * (1.0 + 1e-6)) == Status::none);
        if (range.least < range.most) {
            CHECK(statusAt(beyond(range.least, 1e9)) == Status::found);
            CHECK(statusAt(beyond(range.most, 0.0)) == Status::found);
        }
    }
    const Continuum least = traceContinuum(paper, 4.0);
    CHECK(least.points.size() == 1);
    CHECK(least.dimension == 0);
    CHECK_THAT(traceContinuum(paper, 3.999).detail, containsText("[4, 600]"));
}

TEST_CASE("continuum: random members are joined, the same way for the same seed")
{
    ContinuumOptions options;
    options.points = 50;
    options.trace = trace::RandomPath{11};
    const Continuum first = traceContinuum(paper, 20.0, options);
    requirePoints(first, 50, 1e-12);
    CHECK(traceContinuum(paper, 20.0, options).points.back().state == first.points.back().state);
    options.trace = trace::RandomPath{12};
    CHECK_FALSE(traceContinuum(paper, 20.0, options).points.back().state ==
                first.points.back().state);
}

TEST_CASE("continuum: samples are motions of the energy and repeat with the seed")
{
    const std::vector<State> motions = sampleMotions(paper, 20.0, 25, 9);
    REQUIRE(motions.size() == 25);
    for (const State& motion : motions) {
        CHECK(energyRatio(motion) == Approx(20.0).epsilon(1e-12));
        CHECK(verify(motion, paper).residuals.worst() < 1e-12);
    }
    CHECK(sampleMotions(paper, 20.0, 25, 9) == motions);
    CHECK(sampleMotions(paper, 20.0, 25, 10) != motions);
    CHECK(sampleMotions(paper, 3.0, 5).empty());
    CHECK(sampleMotions(onePhase(2, 2, 4), 3.0, 5).empty());
    CHECK_THROWS_AS(sampleMotions(paper, -1.0, 5), std::invalid_argument);
}

TEST_CASE("continuum: grazing motions of one sign are a curve of the simplex in their box")
{
    const Schedule grazing = onePhase(9, 3, 33);
    const OnePhaseSet whole = onePhaseSet(grazing);
    REQUIRE(whole.set.kind == SetKind::box);
    const EnergyRange range = energyRange(whole);
    const Continuum curve = traceContinuum(grazing, 2.0 * range.least);
    requirePoints(curve, 201, 1e-12);
    CHECK(curve.solver == "closed-form");
    CHECK(curve.connected == true);
    CHECK(curve.components == 1);
    CHECK(curve.orbits == 201);
    CHECK_THAT(curve.detail, containsText("feels no force"));
}

TEST_CASE("continuum: a member between the points is the curve's own, elsewhere the nearest point")
{
    const Continuum curve = traceContinuum(paper, 20.0, {.points = 5});
    const Member member = memberAt(curve, 0.137);
    CHECK(member.isExact);
    CHECK(member.point.lambda == 0.137);
    CHECK(energyRatio(member.point.state) == Approx(20.0).epsilon(1e-12));
    CHECK(verify(member.point.state, paper).residuals.worst() < 1e-12);
    // 0.05 L/c of force, then nothing for 0.137, then 0.05 again: cells 15 and 56.1 to 71.1.
    const std::vector<double> p = arrivals(member.point.state, paper);
    CHECK(p[14] > 0.0);
    CHECK(p[15] == 0.0);
    CHECK(p[55] == 0.0);
    CHECK(p[57] > 0.0);
    CHECK(p[70] > 0.0);
    CHECK(p[72] == 0.0);
    // The same as the point of a finer curve there.
    const Continuum finer = traceContinuum(paper, 20.0, {.points = 401});
    CHECK(memberAt(curve, finer.points[137].lambda).point.state == finer.points[137].state);
    CHECK_THROWS_WITH(memberAt(curve, 0.41), containsText("member = 0.41"));
    CHECK_THROWS_WITH(memberAt(Continuum(), 0.0), containsText("no points"));

    const Continuum path =
        traceContinuum(paper, 20.0, {.points = 5, .trace = trace::RandomPath{2}});
    const Member nearest =
        memberAt(path, 0.9 * path.points[3].lambda + 0.1 * path.points[4].lambda);
    CHECK_FALSE(nearest.isExact);
    CHECK(nearest.point.state == path.points[3].state);
    CHECK(memberAt(path, path.points[4].lambda).isExact);
}

TEST_CASE("continuum: a cancelled trace keeps its points")
{
    std::atomic<bool> stop = false;
    ContinuumOptions options;
    options.points = 1'000'000;
    options.cancel = [&stop] { return stop.load(); };
    std::thread interrupter([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop = true;
    });
    const Continuum curve = traceContinuum(paper, 20.0, options);
    interrupter.join();
    CHECK(curve.status == Status::undecided);
    CHECK(!curve.points.empty());
    CHECK(curve.points.size() < 1'000'000);
    CHECK_THAT(curve.detail, containsText("interrupted after"));
}

TEST_CASE("continuum: schedules without motion and energies out of range are none, with a reason")
{
    const Continuum none = traceContinuum(onePhase(2, 2, 4), 5.0);
    CHECK(none.status == Status::none);
    CHECK(none.reason == Reason::gap);
    const Continuum low = traceContinuum(paper, 3.0);
    CHECK(low.status == Status::none);
    CHECK(low.reason == Reason::constraints);
    CHECK_THAT(low.detail, containsText("[4, 600]"));
}

TEST_CASE("continuum: wrong use is named")
{
    CHECK_THROWS_WITH(traceContinuum(paper, -1.0), containsText("energyRatio = -1"));
    ContinuumOptions options;
    options.points = 1;
    CHECK_THROWS_WITH(traceContinuum(paper, 20.0, options), containsText("points = 1"));
    options = {};
    const auto refusesEnd = [](const State& to, const char* text) {
        CHECK_THROWS_WITH(
            traceContinuum(paper, 20.0, {.trace = trace::Path{blockMotion(paper, 0, 30), to}}),
            containsText(text));
    };
    refusesEnd(blockMotion(paper, 0, 20), "to = a motion with");
    refusesEnd(test::randomState(300), "to = a state with");
    refusesEnd(test::randomState(3), "to = a state with");
    CHECK_THROWS_WITH(
        traceContinuum(paper, 20.0,
                       {.trace = trace::Walk{blockMotion(paper, 0, 30), test::randomState(3)}}),
        containsText("direction = a malformed state"));
    options = {};
    options.solver = "closed-form";
    options.trace = trace::RandomPath{};
    CHECK_THROWS_WITH(traceContinuum({12, {{2, 38}, {4, 40}}}, 12.0, options),
                      containsText("solver closed-form"));
    options.trace = trace::SplitPulse{};
    options.solver = "glpk-simplex";
    CHECK_THROWS_WITH(traceContinuum(paper, 20.0, options), containsText("solver = glpk-simplex"));
    options.solver = "oracle";
    CHECK_THROWS_WITH(traceContinuum(paper, 20.0, options), containsText("solver = oracle"));
    options = {};
    options.resolution = 0.0;
    CHECK_THROWS_WITH(traceContinuum(paper, 20.0, options), containsText("resolution = 0"));
}

TEST_CASE("continuum: programs trace what the geometry traces")
{
    for (const char* solver : {"ipopt", "nlopt-slsqp", "nlopt-auglag"}) {
        if (!findBackend(solver).available()) {
            continue;
        }
        INFO(solver);
        const Schedule schedule = onePhase(12, 6, 36);
        const double energy = 2.0 * energyRange(onePhaseSet(schedule)).least;
        ContinuumOptions options;
        options.points = 21;
        options.solver = solver;
        options.trace = trace::Path{blockMotion(schedule, 0, 3), blockMotion(schedule, 2, 3)};
        const Continuum curve = traceContinuum(schedule, energy, options);
        requirePoints(curve, curve.points.size(), 1e-6);
        CHECK(curve.points.size() >= 21);
        CHECK(curve.connected == true);
        CHECK(curve.resolution <= 0.05);
        CHECK(curve.points.back().lambda > 0.0);
    }
}

TEST_CASE("continuum: two phases and strain limits are traced by programs, each point verified",
          "[ipopt]")
{
    ContinuumOptions options;
    options.points = 15;
    const Schedule two{12, {{2, 38}, {4, 40}}};
    for (const char* solver : {"ipopt", "nlopt-slsqp", "nlopt-auglag"}) {
        if (!findBackend(solver).available()) {
            continue;
        }
        options.solver = solver;
        const Continuum phases = traceContinuum(two, 10.8, options);
        requirePoints(phases, phases.points.size(), 1e-7);
        CHECK(phases.points.size() >= 15);
        CHECK(phases.solver == solver);
        CHECK(phases.points.back().lambda > 0.0);
        CHECK(phases.resolution <= 0.05);
    }
    options.solver = "auto";
    options.strainLimit = 0.012;
    const Continuum limited = traceContinuum(paper, 8.0, options);
    requirePoints(limited, limited.points.size(), 1e-7);
    for (const ContinuumPoint& point : limited.points) {
        CHECK(point.peakStrain <= 0.012 * (1.0 + 1e-6));
    }
    CHECK(limited.points.back().lambda > 0.0);
    CHECK_FALSE(limited.connected.has_value());
}

TEST_CASE("continuum: from a motion in a direction, sliding along faces")
{
    const State from = blockMotion(paper, 0, 30);
    const Continuum curve = traceContinuum(
        paper, 20.0, {.trace = trace::Walk{from, sampleMotions(paper, 20.0, 1).front()}});
    INFO(curve.detail);
    REQUIRE(curve.points.size() >= 2);
    requirePoints(curve, curve.points.size(), 1e-11);
    CHECK(curve.parameter == Parameter::arcLength);
    CHECK((curve.points.front().state.a - from.a).lpNorm<Eigen::Infinity>() < 1e-12);
    CHECK((curve.points.back().state.a - from.a).lpNorm<Eigen::Infinity>() > 0.5);
}

TEST_CASE("continuum: members spread over the set instead of a curve")
{
    const Continuum members = traceContinuum(paper, 20.0, {.points = 20, .trace = trace::Sample{}});
    requirePoints(members, 20, 1e-11);
    CHECK(members.parameter == Parameter::number);
    CHECK(members.points[3].lambda == 4.0);
    const Continuum again = traceContinuum(paper, 20.0, {.points = 20, .trace = trace::Sample{}});
    CHECK(again.points[7].state == members.points[7].state);
    const Continuum others = traceContinuum(paper, 20.0, {.points = 20, .trace = trace::Sample{5}});
    CHECK(!(others.points[7].state == members.points[7].state));
    // Grazing motions of both signs are sampled too.
    const Schedule grazing = onePhase(20, 1, 79);
    requirePoints(traceContinuum(grazing, 5.0, {.points = 10, .trace = trace::Sample{}}), 10,
                  1e-11);

    CHECK_THROWS_AS(traceContinuum(paper, 20.0, {.trace = trace::Sample{}, .solver = "ipopt"}),
                    std::invalid_argument);
}
