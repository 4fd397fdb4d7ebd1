// The default continuum: a pulse of force that splits in two.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "continuum_support.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/continuum.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::onePhase;
using signorini::test::paper;
using signorini::test::requirePoints;

namespace {

/// The least over all shifts of the largest difference of two rings.
double leastShiftDistance(const std::vector<double>& first, const std::vector<double>& second)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t shift = 0; shift < first.size(); ++shift) {
        double largest = 0.0;
        for (std::size_t m = 0; m < first.size() && largest < least; ++m) {
            const double other = second[(m + shift) % second.size()];
            largest = std::max(largest, std::abs(first[m] - other));
        }
        least = std::min(least, largest);
    }
    return least;
}

}  // namespace

TEST_CASE("continuum: the paper's case, a pulse of 20 E_1 splits in two in 148 dimensions")
{
    const Continuum curve = traceContinuum(paper, 20.0);
    requirePoints(curve, 201, 1e-12);
    CHECK(curve.dimension == 148);
    CHECK(curve.connected == true);
    CHECK(curve.components == 1);
    CHECK(curve.solver == "closed-form");
    CHECK(curve.parameter == Parameter::pause);
    CHECK(curve.family == "split pulse");
    // The contact of L/2c carries force for 0.5 * 4/20 = 0.1 L/c.
    CHECK(curve.points.front().lambda == 0.0);
    CHECK(curve.points.back().lambda == Approx(0.4));
    CHECK(curve.orbits == 201);
    // No motion of this energy has a smaller peak; cells covered in part add a little.
    const double least = traceContinuum(paper, 20.0, {.points = 2}).points.front().peakStrain;
    for (const ContinuumPoint& point : curve.points) {
        CHECK(point.peakStrain >= least * (1.0 - 1e-12));
        CHECK(point.peakStrain <= least * 1.04);
    }
}

TEST_CASE("continuum: no two members of the split pulse are the same but for a shift in time")
{
    struct Case {
        Schedule schedule;
        double energy;
    };
    const Schedule grazing = onePhase(9, 3, 33);
    // Whole simplex; shorter contact; longer contact; two contact blocks; grazing; rho > 1/2; d
    // = 3.
    for (const auto& [schedule, energy] :
         {Case{onePhase(60, 30, 180), 20.0}, Case{onePhase(60, 22, 188), 20.0},
          Case{onePhase(60, 38, 172), 20.0}, Case{onePhase(50, 40, 120), 40.0},
          Case{grazing, 2.0 * energyRange(onePhaseSet(grazing)).least},
          Case{onePhase(60, 30, 180), 90.0}, Case{onePhase(6, 3, 18), 5.0}}) {
        const Continuum curve = traceContinuum(schedule, energy, {.points = 41});
        INFO(describe(schedule) << " at " << energy << ": " << curve.detail);
        requirePoints(curve, 41, 1e-12);
        std::vector<std::vector<double>> rings;
        for (const ContinuumPoint& point : curve.points) {
            rings.push_back(arrivals(point.state, schedule));
        }
        std::int64_t equal = 0;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            for (std::size_t k = i + 1; k < rings.size(); ++k) {
                equal += leastShiftDistance(rings[i], rings[k]) < 1e-6 ? 1 : 0;
            }
            CHECK(leastShiftDistance(rings[i], rings[i]) == 0.0);
        }
        CHECK(equal == 0);
        CHECK(curve.orbits == 41);
        // The ends look different, whatever the shift.
        const double largest = *std::max_element(rings.front().begin(), rings.front().end());
        CHECK(leastShiftDistance(rings.front(), rings.back()) > 0.1 * largest);
    }
}

TEST_CASE("continuum: the same motion at several instants is one orbit")
{
    // Most energy: one amplitude alone, in each of 150 places.
    const Continuum spikes = traceContinuum(paper, 600.0);
    requirePoints(spikes, 150, 1e-11);
    CHECK(spikes.orbits == 1);
    // Two amplitudes in either order: two motions.
    const Schedule two = onePhase(4, 2, 12);
    CHECK(traceContinuum(two, 6.0).orbits == 2);
    CHECK(traceContinuum(paper, 3.0).orbits == 0);
}

TEST_CASE("continuum: the split pulse is one curve of functions of time, drawn on any grid")
{
    // Force on the wall in contact: two rectangles of equal impulse, force for 0.5 * 4/17.3 L/c.
    constexpr double energy = 17.3;
    constexpr double pulse = 0.5 * 0.5 * 4.0 / energy;
    double previous = 1.0;
    for (const std::int64_t cells : {100, 300, 1000, 3000}) {
        const Schedule schedule = onePhase(cells, cells / 2, 3 * cells);
        const Continuum curve = traceContinuum(schedule, energy, {.points = 9});
        requirePoints(curve, 9, 1e-12);
        const double step = 1.0 / static_cast<double>(cells);
        double worst = 0.0;
        for (std::size_t k = 0; k < 9; ++k) {
            const double pause = (0.5 - 2.0 * pulse) * static_cast<double>(k) / 8.0;
            CHECK(curve.points[k].lambda == Approx(pause).margin(1e-12));
            const std::vector<double> p = arrivals(curve.points[k].state, schedule);
            double impulse = 0.0;
            for (std::int64_t m = 0; m < cells / 2; ++m) {
                impulse += 2.0 * p[static_cast<std::size_t>(m)] * step;
            }
            double off = 0.0;
            for (std::int64_t m = 0; m < cells / 2; ++m) {
                const double middle = (static_cast<double>(m) + 0.5) * step;
                const bool isIn =
                    middle < pulse || (middle > pulse + pause && middle < 2.0 * pulse + pause);
                const double ideal = isIn ? impulse / (2.0 * pulse) : 0.0;
                off += std::abs(2.0 * p[static_cast<std::size_t>(m)] - ideal) * step;
            }
            worst = std::max(worst, off / impulse);
        }
        INFO(cells << " cells: " << worst);
        CHECK(worst < 2.0 * step / pulse);
        CHECK(worst < previous);
        previous = worst;
    }
}
