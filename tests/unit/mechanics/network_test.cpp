#include "network.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"
#include "random_network.hpp"
#include "rational.hpp"
#include "stepped_bar.hpp"
#include "stepped_waves.hpp"

using namespace signorini;
using signorini::test::NetworkGenerator;

namespace {

/// sum of Z_k w_k^2.
template <typename Number>
Number energyOf(const Network& network, const std::vector<Number>& waves)
{
    Number sum(0);
    std::size_t next = 0;
    const auto add = [&](double impedance) {
        sum += asNumber<Number>(impedance) * waves[next] * waves[next];
        ++next;
    };
    for (const CellRow& row : network.rows) {
        for (std::int64_t k = 0; k < 2 * row.cells; ++k) {
            add(row.impedance);
        }
    }
    for (const Stub& stub : network.stubs) {
        add(stub.impedance);
    }
    return sum;
}

std::vector<Rational> randomWaves(NetworkGenerator& draw, std::size_t count)
{
    std::vector<Rational> waves;
    for (std::size_t k = 0; k < count; ++k) {
        waves.emplace_back(draw.whole(-9, 9));
    }
    return waves;
}

Rational product(const std::vector<Rational>& x, const std::vector<Rational>& y)
{
    Rational sum(0);
    for (std::size_t k = 0; k < x.size(); ++k) {
        sum += x[k] * y[k];
    }
    return sum;
}

/// Of matrix - 1, by elimination with the largest pivot.
std::size_t kernelOfDifference(std::vector<std::vector<double>> matrix)
{
    const std::size_t size = matrix.size();
    for (std::size_t k = 0; k < size; ++k) {
        matrix[k][k] -= 1.0;
    }
    std::size_t rank = 0;
    std::vector<bool> isUsed(size, false);
    while (rank < size) {
        double largest = 1e-9;
        std::size_t row = size;
        std::size_t column = size;
        for (std::size_t i = rank; i < size; ++i) {
            for (std::size_t j = 0; j < size; ++j) {
                if (!isUsed[j] && std::abs(matrix[i][j]) > largest) {
                    largest = std::abs(matrix[i][j]);
                    row = i;
                    column = j;
                }
            }
        }
        if (row == size) {
            break;
        }
        std::swap(matrix[rank], matrix[row]);
        for (std::size_t i = rank + 1; i < size; ++i) {
            const double factor = matrix[i][column] / matrix[rank][column];
            for (std::size_t j = 0; j < size && factor != 0.0; ++j) {
                matrix[i][j] -= factor * matrix[rank][j];
            }
        }
        isUsed[column] = true;
        ++rank;
    }
    return size - rank;
}

}  // namespace

TEST_CASE("network: today's scenes take the steps of the stepped bar")
{
    const Scene scene(Bar{}, 2e-3,
                      {{.cells = 3},
                       {.cells = 2, .impedance = 1.3, .speed = 2.0, .dashpot = 0.2},
                       {.cells = 4, .impedance = 0.5}});
    const Damping damping{0.1};
    const Network network = networkOf(scene, 9, damping);
    CHECK(network.contacts[0] == NetworkContact{ContactKind::stopRight, 3, 9.0});
    CHECK(network.contacts[1] == NetworkContact{ContactKind::stopLeft, 3, 18.0});
    CHECK(network.scales.displacement == Approx(1e-3 / 9.0));
    CHECK(network.scales.time * (3.0 + 2.0 * 2.0 + 4.0) == Approx(1.0));

    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    State state{Eigen::VectorXd(9), Eigen::VectorXd(9)};
    for (Eigen::Index k = 0; k < 9; ++k) {
        state.a[k] = value(generator);
        state.b[k] = value(generator);
    }
    std::vector<double> waves;
    for (const auto& [first, cells] : {std::pair{0, 3}, std::pair{3, 2}, std::pair{5, 4}}) {
        waves.insert(waves.end(), state.a.begin() + first, state.a.begin() + first + cells);
        waves.insert(waves.end(), state.b.begin() + first, state.b.begin() + first + cells);
    }
    test::SteppedWaves bar(steppedBar(scene.segments), state);
    NetworkWaves<double> line(network, waves);
    const NetworkLaw<double> open(network, 0);
    const NetworkLaw<double> held(network, 1);
    const double eta = damping.eta();
    for (int step = 0; step < 60; ++step) {
        const bool isHeld = generator() % 2 == 0;
        const double force = value(generator);
        const double base = value(generator);
        const double arriving = bar.arriving();
        CHECK(line.arriving()[4] == Approx(arriving).margin(1e-13));
        if (isHeld) {
            CHECK(held.push(0).at(line.arriving(), force, base) ==
                  Approx(2.0 * 0.5 * arriving + force).margin(1e-13));
            bar.step({.reflected = -1.0, .baseVelocity = base});
        } else {
            CHECK(open.velocity(3).at(line.arriving(), force, base) ==
                  Approx((2.0 * 0.5 * arriving + force) / (0.5 + eta)).margin(1e-13));
            bar.step({.reflected = (0.5 - eta) / (0.5 + eta),
                      .pulled = force / (0.5 + eta),
                      .baseVelocity = base});
        }
        line.step(isHeld ? held : open, force, base);
    }
}

TEST_CASE("network: without dashpots every closed set keeps the energy, exactly")
{
    NetworkGenerator draw(1);
    for (int sample = 0; sample < 200; ++sample) {
        const Network network = draw.network({});
        REQUIRE_NOTHROW(validate(network));
        const std::vector<Rational> start = randomWaves(draw, network.waves());
        NetworkWaves<Rational> waves(network, start);
        CHECK(waves.waves() == start);
        for (int step = 0; step < 5; ++step) {
            waves.step(NetworkLaw<Rational>(network, draw.closedSet(network)));
        }
        CHECK(energyOf(network, waves.waves()) == energyOf(network, start));
    }
}

TEST_CASE("network: a step back is the transpose of a step")
{
    NetworkGenerator draw(2);
    for (int sample = 0; sample < 200; ++sample) {
        const Network network = draw.network({.hasDashpots = true});
        std::vector<NetworkLaw<Rational>> laws;
        for (int step = 0; step < 6; ++step) {
            laws.emplace_back(network, draw.closedSet(network));
        }
        const std::vector<Rational> x = randomWaves(draw, network.waves());
        const std::vector<Rational> y = randomWaves(draw, network.waves());
        NetworkWaves<Rational> forward(network, x);
        for (const NetworkLaw<Rational>& law : laws) {
            forward.step(law);
        }
        NetworkWaves<Rational> back(network, y);
        for (auto law = laws.rbegin(); law != laws.rend(); ++law) {
            back.stepBack(*law);
        }
        CHECK(product(forward.waves(), y) == product(x, back.waves()));
    }
}

TEST_CASE("network: pushes balance what the waves, forces and dashpots of each node leave over")
{
    NetworkGenerator draw(3);
    for (int sample = 0; sample < 300; ++sample) {
        const Network network = draw.network({.hasDashpots = true, .hasForces = true});
        const ContactSet closed = draw.closedSet(network);
        const NetworkLaw<Rational> law(network, closed);
        const std::vector<Rational> arriving = randomWaves(draw, network.channels());
        std::vector<Rational> entering(network.channels());
        const Rational force(draw.whole(-9, 9));
        const Rational base(draw.whole(-9, 9));
        law.scatter(arriving, entering, force, base);
        for (std::size_t node = 0; node < network.nodes.size(); ++node) {
            const Rational v = law.velocity(node).at(arriving, force, base);
            const NetworkNode& here = network.nodes[node];
            if (here.isClamped) {
                CHECK(v == (here.isShaken ? base : Rational(0)));
            }
            // F = Z(l - r): the branches pull with Z (w - leaving).
            Rational balance =
                asNumber<Rational>(here.force) - asNumber<Rational>(here.dashpot) * v;
            balance += here.isDriven ? force : Rational(0);
            for (std::size_t k = 0; k < network.channels(); ++k) {
                if (network.nodeOf(k) == node) {
                    const Rational leaving = network.sign(k) * entering[network.entered(k)];
                    CHECK(leaving + arriving[k] == v);
                    balance += asNumber<Rational>(network.impedanceOf(k)) * (arriving[k] - leaving);
                }
            }
            for (std::size_t j = 0; j < network.contacts.size(); ++j) {
                if ((closed >> j & 1U) == 0) {
                    continue;
                }
                const NetworkContact& contact = network.contacts[j];
                const Rational push = law.push(j).at(arriving, force, base);
                if (contact.node == node) {
                    balance -= contact.kind == ContactKind::stopLeft ? -push : push;
                } else if (contact.kind == ContactKind::gap && contact.node + 1 == node) {
                    balance += push;
                }
            }
            CHECK((here.isClamped || balance == 0));
        }
    }
}

TEST_CASE("network: the parity of ker(W - 1) is that of stubs, steps, bars, clamps and contacts")
{
    NetworkGenerator draw(4);
    for (int sample = 0; sample < 1000; ++sample) {
        const Network network = draw.network({.mostCells = 3, .mostBars = 3});
        const std::size_t size = network.waves();
        const std::int64_t steps = draw.whole(1, 12);
        std::vector<NetworkWaves<double>> columns;
        for (std::size_t k = 0; k < size; ++k) {
            std::vector<double> unit(size, 0.0);
            unit[k] = 1.0;
            columns.emplace_back(network, unit);
        }
        std::int64_t parity = static_cast<std::int64_t>(network.stubs.size());
        for (const NetworkBar& bar : network.bars) {
            parity += steps * (1 - bar.clamps + bar.masses);
        }
        for (std::int64_t step = 0; step < steps; ++step) {
            const ContactSet closed = draw.closedSet(network);
            for (std::size_t j = 0; j < network.contacts.size(); ++j) {
                parity += (closed >> j & 1U) != 0 ? 1 : 0;
            }
            const NetworkLaw<double> law(network, closed);
            for (NetworkWaves<double>& column : columns) {
                column.step(law);
            }
        }
        std::vector<std::vector<double>> matrix;
        for (const NetworkWaves<double>& column : columns) {
            matrix.push_back(column.waves());
        }
        CHECK((static_cast<std::int64_t>(kernelOfDifference(matrix)) - parity) % 2 == 0);
    }
}

TEST_CASE("network: two stops in one cluster, a contact at a clamp and holes are refused")
{
    Network network = networkOf(Scene{}, 3);
    network.contacts[0].node = 0;
    CHECK_THROWS_WITH(validate(network), Catch::Contains("no clamp"));
    network = networkOf(Scene(Bar{}, 1e-3), 3);
    network.nodes[1].bar = 1;
    CHECK_THROWS_WITH(validate(network), Catch::Contains("without holes"));
    network = networkOf(Scene{}, 3);
    network.rows[0].impedance = std::nan("");
    CHECK_THROWS_WITH(validate(network), Catch::Contains("impedance = nan"));

    // stop | gap | stop
    Network two;
    two.nodes = {{.isClamped = true}, {}, {.bar = 1}, {.isClamped = true, .bar = 1}};
    two.rows = {{2, 1.0, 1.0, 0, 1}, {2, 1.0, 1.0, 2, 3}};
    two.bars = {{0, 1, 1}, {2, 3, 1}};
    two.contacts = {{ContactKind::stopRight, 1, 1.0},
                    {ContactKind::gap, 1, 1.0},
                    {ContactKind::stopRight, 2, 1.0}};
    CHECK_NOTHROW(validate(two));
    CHECK_NOTHROW(NetworkLaw<double>(two, 0b011));
    CHECK_THROWS_WITH(NetworkLaw<double>(two, 0b111), Catch::Contains("closed contacts = 0x7"));
}
