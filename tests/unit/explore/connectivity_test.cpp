/// Which motions can be joined, decided by traceContinuum: pairs that cannot and pairs that can.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include "catch.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/continuum.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::onePhase;

namespace {

struct Pair {
    std::string name;
    Schedule schedule;
    double energy = 0.0;
    State from;
    State to;
};

std::vector<std::string> solvers()
{
    std::vector<std::string> all{"auto"};
    for (const char* backend : {"ipopt", "nlopt-auglag"}) {
        if (findBackend(backend).available()) {
            all.emplace_back(backend);
        }
    }
    return all;
}

/// A motion of one phase from shares of the sum.
State motionWith(const OnePhaseSet& whole, std::vector<double> shares)
{
    for (double& value : shares) {
        value *= whole.set.sum;
    }
    return motionOf(whole, shares);
}

double energyAt(const OnePhaseSet& whole, double ratio)
{
    return ratio * static_cast<double>(whole.set.count) * energyRange(whole).least;
}

double distance(const State& first, const State& second)
{
    return std::sqrt(energyRatio({first.a - second.a, first.b - second.b}));
}

/// One share x at `apex`, the rest evenly elsewhere: sum of squares rho, x being the larger root.
std::vector<double> spike(std::size_t count, std::size_t apex, double rho)
{
    const auto d = static_cast<double>(count);
    const double top = (1.0 + std::sqrt((d - 1.0) * (d * rho - 1.0))) / d;
    std::vector<double> shares(count, (1.0 - top) / (d - 1.0));
    shares[apex] = top;
    return shares;
}

Pair spikes(const Schedule& schedule, double rho, std::size_t first, std::size_t last)
{
    const OnePhaseSet whole = onePhaseSet(schedule);
    const auto count = static_cast<std::size_t>(whole.set.count);
    return {describe(schedule), schedule, energyAt(whole, rho),
            motionWith(whole, spike(count, first, rho)),
            motionWith(whole, spike(count, last, rho))};
}

/// (1, 12)(3, 12), N = 4: p = +-2 on one class and z >= 0 of sum 2 on three; docs/theory.md, 10.
Pair ofExample(double energy, std::size_t first, std::size_t last)
{
    const Schedule schedule{4, {{1, 12}, {3, 12}}};
    const double rho = (energy - 4.0) / 4.0;  // E/E_1 = 4 + sum z^2
    const auto motion = [&](std::size_t apex) {
        const std::vector<double> shares = spike(3, apex, rho);
        // Signs of section 10 in blocks 0 and 1: + - and - -.
        std::vector<double> p{2.0};
        for (const double share : shares) {
            p.push_back(-2.0 * share);
        }
        p.push_back(-2.0);
        for (const double share : shares) {
            p.push_back(-2.0 * share);
        }
        State state{Eigen::VectorXd(4), Eigen::VectorXd(4)};
        for (Eigen::Index i = 0; i < 4; ++i) {
            state.a[i] = p[static_cast<std::size_t>(3 - i)];
            state.b[i] = -p[static_cast<std::size_t>(4 + i)];
        }
        return state;
    };
    return {describe(schedule), schedule, energy, motion(first), motion(last)};
}

/// Members of a grazing set, given as shares of S; the energy is that of the first.
Pair inBox(const Schedule& schedule, const std::vector<double>& from, const std::vector<double>& to)
{
    const OnePhaseSet whole = onePhaseSet(schedule);
    REQUIRE(whole.contact == Contact::grazing);
    REQUIRE(whole.set.kind == SetKind::box);
    const State first = motionWith(whole, from);
    return {"box of " + describe(schedule), schedule, energyRatio(first), first,
            motionWith(whole, to)};
}

const Schedule boxOfTwo = onePhase(6, 2, 30);
const Schedule boxOfThree = onePhase(6, 1, 31);

std::vector<Pair> impossiblePairs()
{
    std::vector<Pair> pairs;
    pairs.push_back(spikes(onePhase(2, 2, 6), 0.65, 0, 1));
    pairs.push_back(spikes(onePhase(2, 2, 6), 0.5001, 0, 1));
    pairs.push_back(spikes(onePhase(2, 2, 6), 1.0, 0, 1));
    pairs.push_back(spikes(onePhase(4, 2, 12), 0.7, 1, 0));
    pairs.push_back(spikes(onePhase(20, 10, 60), 0.811, 0, 9));
    pairs.push_back(spikes(onePhase(20, 10, 60), 0.5005, 3, 4));
    pairs.push_back(spikes(onePhase(20, 10, 60), 1.0, 3, 4));
    pairs.push_back(spikes(onePhase(12, 6, 36), 0.6, 5, 2));
    pairs.push_back(ofExample(8.0, 0, 1));
    pairs.push_back(ofExample(8.0, 0, 2));
    pairs.push_back(ofExample(7.0, 0, 2));
    pairs.push_back(ofExample(6.5, 1, 2));
    pairs.push_back(inBox(boxOfTwo, {0.7, 0.3}, {0.3, 0.7}));
    pairs.push_back(inBox(boxOfTwo, {1.0, 0.0}, {0.0, 1.0}));
    // Around (0, 1, 0) the square of partial sums is cut off at rho > 1/2.
    const double near = (4.0 - std::sqrt(10.0)) / 12.0;
    const double far = 1.0 - 2.0 * near;
    pairs.push_back(inBox(boxOfThree, {near, far, near}, {far, near, near}));
    pairs.push_back(inBox(boxOfThree, {near, near, far}, {near, far, near}));
    return pairs;
}

std::vector<Pair> possiblePairs()
{
    std::vector<Pair> pairs;
    pairs.push_back(spikes(onePhase(12, 6, 36), 0.45, 1, 4));
    pairs.push_back(spikes(onePhase(20, 10, 60), 0.2, 0, 9));
    pairs.push_back(ofExample(5.7, 0, 2));
    pairs.push_back(ofExample(5.9, 1, 2));
    pairs.push_back(inBox(boxOfThree, {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}));
    return pairs;
}

Continuum join(const Pair& pair, const std::string& solver, double strainLimit)
{
    return traceContinuum(pair.schedule, pair.energy,
                          {.points = 21,
                           .trace = trace::Path{pair.from, pair.to},
                           .solver = solver,
                           .strainLimit = strainLimit});
}

}  // namespace

TEST_CASE("continuum: motions that no curve joins are not joined, whatever the solver")
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const Pair& pair : impossiblePairs()) {
        for (const std::string& solver : solvers()) {
            for (const double limit : {infinity, 100.0}) {
                INFO(pair.name << ", E = " << pair.energy << ", " << solver << ", " << limit);
                const Continuum answer = join(pair, solver, limit);
                CHECK(answer.status == Status::none);
                CHECK(answer.connected == false);
                CHECK(answer.components > 1);
                CHECK(answer.points.empty());
                CHECK_THAT(answer.detail, containsText("different components"));
            }
        }
    }
}

TEST_CASE("continuum: motions that a curve joins are joined, whatever the solver")
{
    for (const Pair& pair : possiblePairs()) {
        for (const std::string& solver : solvers()) {
            INFO(pair.name << ", E = " << pair.energy << ", " << solver);
            const Continuum answer = join(pair, solver, 100.0);
            CHECK(answer.connected == true);
            CHECK(answer.components == 1);
            if (solver == "auto") {
                CHECK(answer.status == Status::found);
                CHECK(answer.points.size() == 21);
            }
        }
    }
}

TEST_CASE("continuum: a limit that parts motions parts them for programs, too, once resolved")
{
    if (preferred({.energyEquality = true}) == nullptr) {
        return;  // this build has no program that holds an energy
    }
    // Shares <= 0.8 of three: vertices (0.8, 0.2, 0) and so on, of rho = 0.68; at (0.8, 0.1, 0.1)
    // rho = 0.66. So (0.8, x, 0.2 - x) and its mirror image are apart where rho > 0.66.
    const Schedule schedule = onePhase(6, 3, 18);
    const OnePhaseSet whole = onePhaseSet(schedule);
    REQUIRE(whole.set.count == 3);
    const double limit = 2.0 * 0.8 * whole.set.sum * 1e-3;
    const auto answer = [&](double rho, double resolution, const std::string& solver,
                            const std::vector<double>& shares) {
        return traceContinuum(
            schedule, energyAt(whole, rho),
            {.points = 21,
             .trace = trace::Path{motionWith(whole, shares),
                                  motionWith(whole, {shares[0], shares[2], shares[1]})},
             .solver = solver,
             .strainLimit = limit,
             .resolution = resolution});
    };
    for (const std::string& solver : solvers()) {
        INFO(solver);
        for (const auto& [rho, resolution] :
             {std::pair{0.67, 0.05}, std::pair{0.661, 0.05}, std::pair{0.6601, 0.005}}) {
            INFO(rho << " at " << resolution);
            const double x = 0.1 + 0.5 * std::sqrt(2.0 * (rho - 0.64) - 0.04);
            const Continuum apart = answer(rho, resolution, solver, {0.8, x, 0.2 - x});
            CHECK(apart.status == Status::undecided);
            CHECK_FALSE(apart.connected.has_value());
            CHECK_THAT(apart.detail, containsText("the trace broke"));
        }
        const double top = 0.5 + 0.5 * std::sqrt(2.0 * 0.655 - 1.0);
        const Continuum joined = answer(0.655, 0.05, solver, {top, 1.0 - top, 0.0});
        INFO(joined.detail);
        CHECK(joined.status == Status::found);
        CHECK(joined.connected == true);
        CHECK(joined.resolution <= 0.05);
        for (const ContinuumPoint& point : joined.points) {
            CHECK(point.peakStrain <= limit * (1.0 + 1e-6));
        }
    }
}

TEST_CASE("continuum: finitely many motions are listed, each once")
{
    const auto list = [](const Schedule& schedule, double energy, double limit) {
        return traceContinuum(schedule, energy, {.strainLimit = limit});
    };
    constexpr double none = std::numeric_limits<double>::infinity();
    const Continuum two = list(onePhase(2, 2, 6), 2.6, none);
    CHECK(two.status == Status::found);
    CHECK(two.connected == false);
    CHECK(two.components == 2);
    CHECK(two.parameter == Parameter::number);
    REQUIRE(two.points.size() == 2);
    CHECK(distance(two.points[0].state, two.points[1].state) > 0.5);

    const Continuum three = list({4, {{1, 12}, {3, 12}}}, 8.0, none);
    CHECK(three.status == Status::found);
    CHECK(three.components == 3);
    CHECK(three.points.size() == 3);
    CHECK(three.connected == false);
    const Continuum one = list({4, {{1, 12}, {3, 12}}}, 16.0 / 3.0, none);
    CHECK(one.components == 1);
    CHECK(one.connected == true);
    CHECK(one.points.size() == 1);

    // Both motions reach the same strain: a limit below it leaves none.
    const double strain = two.points[0].peakStrain;
    CHECK(list(onePhase(2, 2, 6), 2.6, 1.01 * strain).points.size() == 2);
    const Continuum excluded = list(onePhase(2, 2, 6), 2.6, 0.99 * strain);
    CHECK(excluded.status == Status::none);
    CHECK(excluded.reason == Reason::constraints);
}

TEST_CASE("continuum: walks in a direction stay in the set, from anywhere to their end")
{
    int walks = 0;
    for (const std::int64_t cells : {4, 10, 20, 300}) {
        const Schedule schedule = onePhase(cells, cells / 2, 3 * cells);
        const OnePhaseSet whole = onePhaseSet(schedule);
        REQUIRE(whole.set.count == cells / 2);
        for (const double rho : {0.2, 0.5, 0.8}) {
            if (rho * static_cast<double>(cells) < 2.0 - 1e-12) {
                continue;
            }
            const double energy = energyAt(whole, rho);
            const std::vector<State> members = sampleMotions(schedule, energy, 101, 7);
            for (std::size_t k = 0; k + 1 < members.size(); ++k, ++walks) {
                INFO("d = " << cells / 2 << ", rho = " << rho << ", walk " << k);
                const Continuum walk = traceContinuum(
                    schedule, energy,
                    {.points = 21, .trace = trace::Walk{members[k], members[k + 1]}});
                INFO(walk.detail);
                REQUIRE(walk.status == Status::found);
                for (const ContinuumPoint& point : walk.points) {
                    REQUIRE(point.energyRatio == Approx(energy).epsilon(1e-9));
                    REQUIRE(verify(point.state, schedule).residuals.worst() < 1e-9);
                }
            }
        }
    }
    CHECK(walks >= 1000);
}

TEST_CASE("continuum: both members of a pair are drawn, evenly")
{
    for (const Schedule& schedule : {boxOfTwo, onePhase(2, 2, 6)}) {
        const EnergyRange range = energyRange(onePhaseSet(schedule));
        const double energy = 1.3 * range.least;
        const auto count = [](const std::vector<State>& members) {
            return std::count_if(members.begin(), members.end(), [&members](const State& member) {
                return distance(member, members.front()) < 1e-9;
            });
        };
        const auto drawn = count(sampleMotions(schedule, energy, 400));
        CHECK(drawn > 150);
        CHECK(drawn < 250);
        std::vector<State> firsts;
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            firsts.push_back(sampleMotions(schedule, energy, 1, seed).front());
        }
        CHECK(count(firsts) > 65);
        CHECK(count(firsts) < 135);
        const Continuum members =
            traceContinuum(schedule, energy, {.points = 100, .trace = trace::Sample{3}});
        REQUIRE(members.points.size() == 100);
        std::vector<State> states;
        for (const ContinuumPoint& point : members.points) {
            states.push_back(point.state);
        }
        CHECK(count(states) > 25);
        CHECK(count(states) < 75);
    }
}
