// Sets of one dimension: the motions of one energy are one or two, wherever the contact phases that
// repeat each other, boxes or several sums hide it. cddlib lists the two ends.

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "scene_vertices.hpp"
#include "signorini/continuum.hpp"
#include "signorini/lumped_set.hpp"

using namespace signorini;
using test::verticesOf;
using test::Waves2N;

namespace {

/// (2/N) sum p^2.
double energyOf(const Waves2N& waves)
{
    double sum = 0.0;
    for (const double p : waves) {
        sum += p * p;
    }
    return 4.0 * sum / static_cast<double>(waves.size());
}

Waves2N between(const Waves2N& from, const Waves2N& to, double t)
{
    Waves2N point = from;
    for (std::size_t k = 0; k < point.size(); ++k) {
        point[k] += t * (to[k] - from[k]);
    }
    return point;
}

/// Where the segment has the energy, by bisection from its least point to either end.
std::vector<Waves2N> motionsOn(const Waves2N& from, const Waves2N& to, double energy)
{
    const auto at = [&](double t) { return energyOf(between(from, to, t)); };
    const double bend = 2.0 * (at(0.0) + at(1.0) - 2.0 * at(0.5));
    const double least = std::clamp(0.5 - 0.5 * (at(1.0) - at(0.0)) / bend, 0.0, 1.0);
    std::vector<Waves2N> motions;
    for (const double end : {0.0, 1.0}) {
        if (end == least || at(end) < energy * (1.0 - 1e-12)) {
            continue;
        }
        double inside = least;
        double outside = end;
        for (int k = 0; k < 80; ++k) {
            const double middle = 0.5 * (inside + outside);
            (at(middle) < energy ? inside : outside) = middle;
        }
        motions.push_back(between(from, to, outside));
    }
    return motions;
}

double distance(const Waves2N& x, const Waves2N& y)
{
    double most = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        most = std::max(most, std::abs(x[k] - y[k]));
    }
    return most;
}

Continuum traced(const Schedule& schedule, double energy, const Trace& trace = {})
{
    ContinuumOptions options;
    options.scene.bar.gap = schedule.stops.right < 0 ? -1.0 : 1.0;
    if (schedule.stops.left) {
        options.scene.secondStop = schedule.stops.left->value();
    }
    options.trace = trace;
    return traceContinuum(schedule, energy, options);
}

/// The answer lists these motions, and no others.
void checkListed(const Continuum& answer, const std::vector<Waves2N>& motions)
{
    INFO(answer.detail);
    REQUIRE(answer.status == Status::found);
    CHECK(answer.components == static_cast<std::int64_t>(motions.size()));
    CHECK(answer.connected == (motions.size() == 1));
    CHECK(answer.dimension == 0);
    REQUIRE(answer.points.size() == motions.size());
    for (const ContinuumPoint& point : answer.points) {
        const Waves2N waves = test::waves2NOf(point.state);
        CHECK(std::any_of(motions.begin(), motions.end(), [&waves](const Waves2N& motion) {
            return distance(motion, waves) < 1e-7;
        }));
    }
    if (motions.size() == 2) {
        CHECK(distance(test::waves2NOf(answer.points[0].state),
                       test::waves2NOf(answer.points[1].state)) > 1e-6);
    }
}

}  // namespace

TEST_CASE("segment sets: repeated phases have one or two motions of an energy, and they are listed")
{
    std::mt19937_64 generator(41);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    const std::vector<Stops> scenes{{1, {}}, {-1, {}}, {1, Fraction{2, 1}}, {-1, Fraction{3, 1}}};
    int segments = 0;
    int pairs = 0;
    for (int k = 0; k < 4000 && segments < 60; ++k) {
        Schedule schedule{draw(1, 4), {}, scenes[static_cast<std::size_t>(draw(0, 3))]};
        const Phase phase{draw(1, 2 * schedule.cells), draw(1, 4 * schedule.cells)};
        schedule.phases.assign(static_cast<std::size_t>(draw(2, 3)), phase);
        if (draw(0, 3) == 0) {
            schedule.phases.back().free += draw(1, 3);
        }
        const LumpedSet set = lumpedSet(schedule);
        if (set.absence || shapeOf(set).dimension != 1) {
            continue;
        }
        const std::vector<Waves2N> ends = verticesOf(schedule);
        REQUIRE(ends.size() == 2);
        ++segments;
        const double most = std::max(energyOf(ends[0]), energyOf(ends[1]));
        const double least = shapeOf(set).energy.least;
        for (const double part : {0.1, 0.6, 1.0}) {
            const double energy = std::lerp(least, most, part);
            INFO(describe(schedule) << " stops " << schedule.stops.right << ", E = " << energy);
            const auto motions = motionsOn(ends[0], ends[1], energy);
            pairs += motions.size() == 2 ? 1 : 0;
            checkListed(traced(schedule, energy), motions);
            checkListed(traced(schedule, energy, trace::RandomPath{5}), motions);
        }
    }
    CHECK(segments == 60);
    CHECK(pairs > 40);
}

TEST_CASE("segment sets: the ends of a path are joined if they are the same motion only")
{
    const Schedule schedule{2, {{2, 6}, {2, 6}}};
    const Continuum both = traced(schedule, 3.8);
    REQUIRE(both.points.size() == 2);
    const State& first = both.points.front().state;
    const State& second = both.points.back().state;
    CHECK(traced(schedule, 3.8, trace::Path{first, second}).status == Status::none);
    CHECK(traced(schedule, 3.8, trace::Path{second, second}).status == Status::found);
}

TEST_CASE("segment sets: a simplex beside a box without room has the components of the simplex")
{
    const Schedule schedule{4, {{3, 5}, {3, 5}}, {-1, Fraction{3, 1}}};
    const std::vector<Waves2N> corners = verticesOf(schedule);
    REQUIRE(corners.size() == 3);
    ContinuumOptions options;
    options.scene.bar.gap = -1e-3;
    options.scene.secondStop = 3e-3;
    options.trace = trace::RandomPath{2};
    const Continuum apart = traceContinuum(schedule, 7.351381, options);
    CHECK(energyOf(corners[0]) > 7.351381);
    CHECK(apart.components == 3);
    options.trace = trace::SplitPulse{};
    CHECK(traceContinuum(schedule, 7.351381, options).components == 3);
    // Below half of the squares the corners are joined along edges.
    const double half = energyOf(between(corners[0], corners[1], 0.5));
    CHECK(traceContinuum(schedule, 0.999 * half, options).components == 1);
}
