#include "energy_floor.hpp"

#include <cmath>
#include <random>

#include "../mechanics/random_network.hpp"
#include "catch.hpp"
#include "least_norm.hpp"
#include "network_route.hpp"
#include "periodic_multipliers.hpp"
#include "rational.hpp"
#include "sanitized.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// A network at rest in parts, a schedule and multipliers of a few conditions.
struct Drawn {
    Network network;
    std::vector<ContactSpan> schedule;
    EnergyFloor floor;
};

bool isClosed(const Drawn& drawn, std::size_t contact, std::int64_t step)
{
    for (const ContactSpan& span : drawn.schedule) {
        if (step < span.steps) {
            return (span.closed >> contact & 1U) != 0;
        }
        step -= span.steps;
    }
    return false;
}

std::int64_t stepsOf(const Drawn& drawn)
{
    std::int64_t steps = 0;
    for (const ContactSpan& span : drawn.schedule) {
        steps += span.steps;
    }
    return steps;
}

Drawn randomFloor(NetworkGenerator& draw)
{
    Drawn drawn{draw.network({.mostCells = 3, .mostBars = 3, .hasDashpots = true}), {}, {}};
    for (std::int64_t k = draw.whole(2, 4); k > 0; --k) {
        drawn.schedule.push_back({draw.closedSet(drawn.network), draw.whole(1, 4)});
    }
    for (std::size_t k = 0; k < drawn.network.waves(); ++k) {
        drawn.floor.periodicity.push_back(draw.fraction() - draw.fraction());
    }
    const std::int64_t steps = stepsOf(drawn);
    for (std::size_t contact = 0; contact < drawn.network.contacts.size(); ++contact) {
        const std::int64_t step = draw.whole(0, steps - 1);
        const bool isEqual =
            isClosed(drawn, contact, step) || isClosed(drawn, contact, (step + steps - 1) % steps);
        const double size = draw.fraction();
        drawn.floor.places.push_back({contact, step, isEqual ? -size : size});
        const std::int64_t push = draw.whole(0, steps - 1);
        if (isClosed(drawn, contact, push)) {
            drawn.floor.pushes.push_back({contact, push, draw.fraction()});
        }
    }
    return drawn;
}

/// sum y (x_n - x) + sum of conditions for one state, by a march forwards in fractions.
Rational forwards(const Drawn& drawn, std::vector<Rational> x)
{
    const Network& network = drawn.network;
    const std::vector<Rational> start = x;
    NetworkWaves<Rational> waves(network, x);
    Rational sum = 0;
    std::int64_t step = 0;
    for (const ContactSpan& span : drawn.schedule) {
        const NetworkLaw<Rational> law(network, span.closed);
        for (std::int64_t left = span.steps; left > 0; --left, ++step) {
            x = waves.waves();
            const auto displacement = [&](std::size_t node) {
                const DisplacementForm form = displacementOf(network, node);
                Rational u = form.spring ? -x[network.firstWave(network.rows.size()) + *form.spring]
                                         : Rational(0);
                for (const auto& stretch : form.rows) {
                    const auto cells = static_cast<std::size_t>(network.rows[stretch.row].cells);
                    for (std::size_t k = 0; k < cells; ++k) {
                        const std::size_t right = network.firstWave(stretch.row) + k;
                        u += stretch.sign * (x[right + cells] - x[right]);
                    }
                }
                return u;
            };
            for (const ContactMultiplier& m : drawn.floor.places) {
                const NetworkContact& at = network.contacts[m.contact];
                if (m.step == step) {
                    Rational distance = Rational(at.gap);
                    distance += (at.kind == ContactKind::stopLeft ? 1 : -1) * displacement(at.node);
                    distance += at.kind == ContactKind::gap ? displacement(at.node + 1) : 0;
                    sum += Rational(m.value) * distance;
                }
            }
            for (const ContactMultiplier& m : drawn.floor.pushes) {
                if (m.step == step) {
                    sum += Rational(m.value) *
                           law.push(m.contact).at(waves.arriving(), Rational(0), Rational(0));
                }
            }
            waves.step(law);
        }
    }
    const std::vector<Rational> end = waves.waves();
    for (std::size_t k = 0; k < end.size(); ++k) {
        sum += Rational(drawn.floor.periodicity[k]) * (end[k] - start[k]);
    }
    return sum;
}

/// sum x y/Z.
Rational product(const std::vector<Rational>& x, const std::vector<Rational>& y,
                 const std::vector<Rational>& impedances)
{
    Rational sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sum += x[k] * y[k] / impedances[k];
    }
    return sum;
}

/// What is left of values at right angles to directions, exactly.
std::vector<Rational> without(std::vector<std::vector<Rational>> directions,
                              std::vector<Rational> values, const std::vector<Rational>& impedances)
{
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const std::vector<Rational> way = directions[i];
        const Rational length = product(way, way, impedances);
        const auto take = [&](std::vector<Rational>& from) {
            const Rational part =
                length > 0 ? Rational(product(way, from, impedances) / length) : Rational(0);
            for (std::size_t k = 0; k < from.size(); ++k) {
                from[k] -= part * way[k];
            }
        };
        take(values);
        std::for_each(directions.begin() + static_cast<std::ptrdiff_t>(i) + 1, directions.end(),
                      take);
    }
    return values;
}

/// delta^2/(sum eta^2/Z), from one march forwards for each wave; 0 where delta <= 0. Of eta what a
/// bar that is held more than once says of all states is left out.
double boundOf(const Drawn& drawn)
{
    const Network& network = drawn.network;
    const std::size_t size = network.waves();
    const Rational constant = forwards(drawn, std::vector<Rational>(size, 0));
    std::vector<Rational> eta;
    std::vector<Rational> impedances;
    for (std::size_t k = 0; k < size; ++k) {
        std::vector<Rational> unit(size, 0);
        unit[k] = 1;
        eta.push_back(forwards(drawn, unit) - constant);
        std::size_t channel = 0;
        while (channel + 2 < 2 * network.rows.size() && network.firstWave(channel / 2 + 1) <= k) {
            channel += 2;
        }
        const std::size_t stubs = network.firstWave(network.rows.size());
        channel = k >= stubs ? 2 * network.rows.size() + k - stubs : channel;
        impedances.push_back(asNumber<Rational>(network.impedanceOf(channel)));
    }
    std::vector<std::vector<Rational>> ties;
    for (const std::vector<double>& tie : tiesOf(network)) {
        ties.emplace_back(tie.begin(), tie.end());
    }
    eta = without(std::move(ties), std::move(eta), impedances);
    const Rational square = product(eta, eta, impedances);
    return constant < 0 && square > 0 ? static_cast<double>(Rational(constant * constant / square))
                                      : 0.0;
}

bool drifts(const Network& network)
{
    return std::any_of(network.bars.begin(), network.bars.end(),
                       [](const NetworkBar& bar) { return bar.drifts(); });
}

}  // namespace

TEST_CASE("energy floor: what multipliers prove is what marches forwards in fractions say")
{
    NetworkGenerator draw(41);
    int proved = 0;
    for (int k = 0; k < 300; ++k) {
        const Drawn drawn = randomFloor(draw);
        if (drifts(drawn.network)) {
            continue;
        }
        const double truth = boundOf(drawn);
        const double seen = provedEnergy(drawn.floor, drawn.network, drawn.schedule);
        INFO("network " << k);
        CHECK(seen <= truth);
        CHECK(seen >= truth * (1.0 - 1e-6));
        proved += seen > 0.0 ? 1 : 0;
    }
    CHECK(proved > 50);
}

TEST_CASE("energy floor: displacements of a drifting bar have to cancel")
{
    // A free bar between two walls: its distances to them say nothing alone, their sum does.
    Network network;
    network.nodes = {{}, {}};
    network.rows = {{.cells = 2, .left = 0, .right = 1}};
    network.bars = {{.firstNode = 0, .lastNode = 1}};
    network.contacts = {{ContactKind::stopLeft, 0, -1.0}, {ContactKind::stopRight, 1, -1.0}};
    const std::vector<ContactSpan> schedule{{1, 2}, {2, 2}};
    EnergyFloor floor{std::vector<double>(4 + 1, 0.0), {{0, 0, 1.0}}, {}};  // 4 waves, a bar
    CHECK(provedEnergy(floor, network, schedule) == 0.0);
    floor.places.push_back({1, 0, 1.0});
    // 2 - (r - l sums) >= 0 with 4 waves of factor 1: (2)^2/4.
    CHECK(provedEnergy(floor, network, schedule) == Approx(1.0).epsilon(1e-8));
}

TEST_CASE("energy floor: what is no condition of the schedule proves nothing")
{
    const Scene scene;
    const Network network = networkOf(scene, 4);
    const std::vector<ContactSpan> schedule = spansOf(Schedule{4, {{3, 9}}});
    const std::vector<double> none(8, 0.0);
    const auto proved = [&](const EnergyFloor& floor) {
        return provedEnergy(floor, network, schedule);
    };
    CHECK(proved({none, {{0, 0, -1.0}}, {}}) > 0.0);  // the tip is at the wall
    CHECK(proved({none, {{0, 3, -1.0}}, {}}) > 0.0);
    CHECK(proved({none, {{0, 4, -1.0}}, {}}) == 0.0);  // it is not
    CHECK(proved({none, {{0, 0, -1.0}}, {{0, 2, 1.0}}}) > 0.0);
    CHECK(proved({none, {{0, 0, -1.0}}, {{0, 2, -1.0}}}) == 0.0);  // a wall pushes
    CHECK(proved({none, {{0, 0, -1.0}}, {{0, 3, 1.0}}}) == 0.0);   // and only in contact
    CHECK(proved({none, {{1, 0, -1.0}}, {}}) == 0.0);
    CHECK(proved({none, {{0, 12, -1.0}}, {}}) == 0.0);
    CHECK(proved({none, {{0, 0, -INFINITY}}, {}}) == 0.0);
    CHECK(proved({std::vector<double>(7, 0.0), {{0, 0, -1.0}}, {}}) == 0.0);
    CHECK(proved({none, {}, {}}) == 0.0);
}

TEST_CASE("energy floor: multipliers of periodicity make the gap row the least energy of section 7")
{
    // Of two equal segments, for which the closed form knows it.
    int proved = 0;
    forAllSchedules(6, 6, [&proved](const Schedule& schedule) {
        const OnePhaseSet set = onePhaseSet(schedule);
        const std::int64_t cells = schedule.cells;
        if (cells == 1 || set.reason) {
            return;
        }
        INFO(describe(schedule));
        FindOptions options;
        options.scene.segments = {{1}, {cells - 1}};
        const auto proof = leastEnergyFloor(schedule, options);
        REQUIRE(proof);
        CHECK(proof->energyRatio <= energyRange(set).least * (1.0 + 1e-12));
        CHECK(proof->energyRatio == Approx(energyRange(set).least).epsilon(1e-8));
        ++proved;
    });
    CHECK(proved > 100);
}

TEST_CASE("energy floor: derivatives of a period that goes on for ever are those of a march")
{
    NetworkGenerator draw(43);
    const int samples = test::drawn(400);
    int whole = 0;
    for (int sample = 0; sample < samples; ++sample) {
        const Drawn drawn = randomFloor(draw);
        const NetworkBlocks blocks(drawn.network, drawn.schedule, false);
        const auto kernel = kernelOf<double>(blocks);
        const auto& rows = drawn.network.rows;
        if (!kernel || !kernel->isWhole() ||
            std::any_of(rows.begin(), rows.end(),
                        [&](const CellRow& row) { return row.cells > stepsOf(drawn); })) {
            continue;
        }
        const Eigen::VectorXd given = Eigen::Map<const Eigen::VectorXd>(
            drawn.floor.periodicity.data(), static_cast<Eigen::Index>(drawn.network.waves()));
        const Eigen::VectorXd made = periodicBackwards(blocks, *kernel, given);
        NetworkWaves<double> waves(drawn.network, {made.begin(), made.end()});
        for (auto span = drawn.schedule.rbegin(); span != drawn.schedule.rend(); ++span) {
            const NetworkLaw<double> law(drawn.network, span->closed);
            for (std::int64_t left = span->steps; left > 0; --left) {
                waves.stepBack(law);
            }
        }
        const std::vector<double> again = waves.waves();
        INFO("network " << sample);
        for (std::size_t k = 0; k < again.size(); ++k) {
            const auto at = static_cast<Eigen::Index>(k);
            CHECK(made[at] == Approx(given[at] + again[k]).margin(1e-12 * made.norm()));
        }
        ++whole;
    }
    CHECK(10 * whole > samples);
}

TEST_CASE(
    "least norm: points are nearest by the conditions of Karush, Kuhn and Tucker, and empty "
    "sets have multipliers")
{
    std::mt19937_64 generator(42);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    int found = 0;
    int empty = 0;
    for (int k = 0; k < 2000; ++k) {
        const std::int64_t unknowns = draw(1, 6);
        const std::int64_t rows = draw(1, 12);
        RowSystem system;
        system.equalities = draw(0, std::min<std::int64_t>(2, rows));
        system.rows.resize(rows, unknowns);
        system.rhs.resize(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            for (Eigen::Index j = 0; j < unknowns; ++j) {
                system.rows(i, j) = static_cast<double>(draw(-3, 3));
            }
            system.rhs[i] = static_cast<double>(draw(-4, 2));
        }
        const LeastNorm least = leastNorm(system, 1e-10, 1e8);
        INFO("system " << k);
        REQUIRE(least.end != LeastNormEnd::stopped);
        const Eigen::VectorXd& u = least.multipliers;
        REQUIRE(u.size() == rows);
        const auto below = u.tail(rows - system.equalities);
        CHECK((below.size() == 0 || below.minCoeff() >= 0.0));
        const Eigen::VectorXd sum = system.rows.transpose() * u;
        if (least.end == LeastNormEnd::empty) {
            ++empty;
            CHECK(sum.norm() <= 1e-9 * u.norm() * 10.0);
            CHECK(u.dot(system.rhs) > 1e-9 * u.norm());
            continue;
        }
        ++found;
        const Eigen::VectorXd slack = system.rows * least.z - system.rhs;
        CHECK((sum - least.z).norm() <= 1e-8 * (1.0 + least.z.norm()));
        CHECK((system.equalities == 0 || slack.head(system.equalities).cwiseAbs().maxCoeff() <=
                                             1e-8 * (1.0 + least.z.norm())));
        CHECK((below.size() == 0 ||
               slack.tail(rows - system.equalities).minCoeff() >= -1e-8 * (1.0 + least.z.norm())));
        CHECK(std::abs(u.dot(slack)) <= 1e-7 * (1.0 + u.norm() * least.z.norm()));
    }
    CHECK(found > 300);
    CHECK(empty > 300);
}
