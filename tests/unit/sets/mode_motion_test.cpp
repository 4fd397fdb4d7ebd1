#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "catch.hpp"
#include "modes_support.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using test::coprimeSteps;
using test::find;
using test::periodAt;
using test::upTo;

TEST_CASE("modes: jumps stand at 2i mod T, in order, t_c first")
{
    for (const Mode& mode : findModes(upTo(25))) {
        const std::vector<ModeJump> all = jumps(mode);
        INFO(mode.a << " " << mode.b);
        REQUIRE(all.size() == static_cast<std::size_t>(2 * mode.a));
        REQUIRE(all.front() == ModeJump{2 * mode.a, -mode.b});
        for (const double part : {1e-6, 0.3, 0.7, 1.0 - 1e-6}) {
            const double period = periodAt(mode, part);
            const ModeMotion motion(mode, period);
            double before = 0.0;
            std::set<std::int64_t> seen;
            for (std::size_t k = 0; k < all.size(); ++k) {
                const auto twoK = static_cast<double>(2 * all[k].k);
                const double time = motion.jumpTimes()[k];
                REQUIRE(time == Approx(std::fmod(twoK, period)).margin(1e-13 * twoK));
                REQUIRE(time > before);
                before = time;
                seen.insert(all[k].k);
            }
            REQUIRE(before < period);
            REQUIRE(seen.size() == all.size());
        }
    }
}

TEST_CASE("modes: a motion at a grid period is the state of its schedule, and the march agrees")
{
    const std::int64_t cells = 1009;
    int compared = 0;
    for (const Mode& mode : findModes(upTo(25))) {
        const std::vector<std::int64_t> all = coprimeSteps(mode, cells);
        if (all.empty()) {
            continue;
        }
        ++compared;
        const Schedule schedule = scheduleOf(mode, cells, all[all.size() / 2]);
        const ModeMotion motion(mode, period(schedule));
        INFO(mode.a << " " << mode.b << ": " << describe(schedule));
        // Sampled in the middle of cells and steps, away from the jumps.
        State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
        const double step = 1.0 / static_cast<double>(cells);
        for (Eigen::Index i = 0; i < cells; ++i) {
            const double x = (static_cast<double>(i) + 0.5) * step;
            state.a[i] = 0.5 * (motion.velocity(x, 0.0) - motion.strain(x, 0.0));
            state.b[i] = 0.5 * (motion.velocity(x, 0.0) + motion.strain(x, 0.0));
        }
        const Verification verification = verify(state, schedule);
        REQUIRE(verification.residuals.worst() < 1e-10);
        REQUIRE(verification.canonical == schedule.phases);
        const State solved = leastEnergyMotion(onePhaseSet(schedule));
        REQUIRE((solved.a - state.a).cwiseAbs().maxCoeff() < 1e-10 * motion.amplitude());
        REQUIRE((solved.b - state.b).cwiseAbs().maxCoeff() < 1e-10 * motion.amplitude());
        const Motion field(solved, schedule);
        for (std::int64_t m = 0; m <= field.steps(); m += 37) {
            for (std::int64_t i = 1; i <= cells; i += 56) {
                const double x = static_cast<double>(i) * step;
                const double t = static_cast<double>(m) * step;
                REQUIRE(motion.displacement(x, t) ==
                        Approx(field.displacement(i, m)).margin(1e-10 * motion.amplitude()));
                const double xMid = x - 0.5 * step;
                REQUIRE(motion.velocity(xMid, t) ==
                        Approx(field.velocity(i, m)).margin(1e-10 * motion.amplitude()));
                REQUIRE(motion.strain(xMid, t) ==
                        Approx(field.strain(i, m)).margin(1e-10 * motion.amplitude()));
            }
        }
    }
    CHECK(compared == 65);
}

TEST_CASE("modes: at irrational periods the motion obeys the wave equation and the wall")
{
    const double part = GENERATE(0.1 * std::sqrt(2.0), 1.0 / std::sqrt(3.0), std::sqrt(5.0) - 1.3);
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const Mode& mode : findModes()) {
        const double period = periodAt(mode, part);
        const ModeMotion motion(mode, period);
        const double h = motion.amplitude();
        const double tolerance = 1e-12 * std::max(1.0, h);
        INFO(mode.a << " " << mode.b << " at T = " << period);
        REQUIRE(motion.contactTime() == contactTime(mode, period));
        REQUIRE(4.0 * h * h == Approx(energyRatio(mode, period)).epsilon(1e-12));
        for (int k = 0; k < 400; ++k) {
            const double t = period * (3.0 * unit(generator) - 1.0);
            const double x = unit(generator);
            const double phase = t - period * std::floor(t / period);
            // Periodic, held at the clamp, and u is the integral of s, whose ends are known.
            REQUIRE(motion.displacement(x, t + period) ==
                    Approx(motion.displacement(x, t)).margin(tolerance));
            REQUIRE(motion.displacement(0.0, t) == 0.0);
            REQUIRE(std::abs(motion.displacement(x, t)) <= 2.0 * h * x + tolerance);
            // The wave equation in its exact form: sums over a characteristic rectangle.
            const double d = std::min(x, 1.0 - x) * unit(generator);
            REQUIRE(motion.displacement(x + d, t) + motion.displacement(x - d, t) ==
                    Approx(motion.displacement(x, t + d) + motion.displacement(x, t - d))
                        .margin(4.0 * tolerance));
            // The wall.
            if (phase < motion.contactTime()) {
                REQUIRE(std::abs(motion.tipGap(t)) < tolerance);
                REQUIRE(motion.velocity(1.0, t) == 0.0);
                REQUIRE(motion.strain(1.0, t) == -2.0 * h);
                REQUIRE(motion.wallForce(t) == 2.0 * h);
            } else {
                REQUIRE(motion.tipGap(t) >= -tolerance);
                REQUIRE(motion.strain(1.0, t) == 0.0);
                REQUIRE(motion.wallForce(t) == 0.0);
            }
            // Derivatives: v and s are +-2h or 0, and match differences away from jumps.
            const double small = 1e-7;
            const double v = motion.velocity(x, t);
            const double s = motion.strain(x, t);
            REQUIRE(v * v + s * s == Approx(4.0 * h * h).epsilon(1e-12));  // so energy is constant
            if (motion.velocity(x, t - small) == v && motion.velocity(x, t + small) == v &&
                motion.strain(x, t - small) == s && motion.strain(x, t + small) == s) {
                REQUIRE((motion.displacement(x, t + small) - motion.displacement(x, t)) / small ==
                        Approx(v).margin(1e-5 * h));
            }
        }
        // The tip leaves the wall at once, and comes back.
        const double soon = 1e-9;
        REQUIRE(motion.velocity(1.0, motion.contactTime() + soon) == -2.0 * h);
        REQUIRE(motion.velocity(1.0, period - soon) == 2.0 * h);
    }
}

TEST_CASE("modes: the state on cells is exact where the grid has the period")
{
    const std::vector<Mode> modes = findModes(upTo(7));
    for (const Mode& mode : modes) {
        for (const std::int64_t steps : coprimeSteps(mode, 30)) {
            const ModeMotion motion(mode, static_cast<double>(steps) / 30.0);
            const State state = cellMeans(motion, 30);
            const State exact = leastEnergyMotion(onePhaseSet(scheduleOf(mode, 30, steps)));
            INFO(mode.a << " " << mode.b << " " << steps);
            CHECK(amplitude({state.a - exact.a, state.b - exact.b}) < 1e-9 * amplitude(exact));
        }
    }
}

TEST_CASE("modes: the state on cells holds the mean of velocity and strain, and u at their ends")
{
    const Mode mode = find(findModes(upTo(5)), 2, -3);
    const ModeMotion motion(mode, 0.5 * (mode.lowest.value() + mode.highest.value()) + 1e-3 / 3.0);
    constexpr std::int64_t cells = 17;
    const State state = cellMeans(motion, cells);
    const Eigen::VectorXd u = displacement(state);
    const Eigen::VectorXd v = velocity(state);
    constexpr int points = 20'000;
    for (std::int64_t i = 1; i <= cells; ++i) {
        const double left = static_cast<double>(i - 1) / cells;
        CHECK(u[i - 1] == Approx(motion.displacement(static_cast<double>(i) / cells, 0.0)));
        double mean = 0.0;
        for (int k = 0; k < points; ++k) {
            mean += motion.velocity(left + (k + 0.5) / (points * cells), 0.0) / points;
        }
        CHECK(v[i - 1] == Approx(mean).margin(1e-3));
    }
    CHECK_THROWS_WITH(cellMeans(motion, 0), containsText("cells = 0"));
}

TEST_CASE("modes: a contact holds its first instant and not its last, in every period")
{
    for (const Mode& mode : findModes(upTo(7))) {
        const double period = periodAt(mode, 0.4);
        const ModeMotion motion(mode, period);
        const double force = 2.0 * motion.amplitude();
        INFO(mode.a << " " << mode.b);
        for (const double turns : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
            REQUIRE(motion.wallForce(turns * period) == force);
        }
        const double end = motion.contacts().front().second;
        REQUIRE(motion.wallForce(std::nextafter(end, 0.0)) == force);
        REQUIRE(motion.wallForce(end) == 0.0);
        // So little before 0 that one period later is the period: nothing has been added to p yet.
        const double before = -1e-20;
        REQUIRE(before + period == period);
        REQUIRE(motion.wallForce(before) == motion.wallForce(before + period));
        REQUIRE(motion.meanIncoming(before, 0.5 * end) == Approx(motion.amplitude()));
    }
}

TEST_CASE("modes: on one cell the state has the displacement of the tip")
{
    for (const Mode& mode : findModes(upTo(5))) {
        const ModeMotion motion(mode, periodAt(mode, 0.6));
        const State state = cellMeans(motion, 1);
        REQUIRE(state.a.size() == 1);
        CHECK(displacement(state)[0] == Approx(motion.displacement(1.0, 0.0)));
    }
}

TEST_CASE("modes: under weight the extremes are those of the whole bar")
{
    constexpr int cells = 60;
    constexpr int instants = 1'500;
    for (const int gapSign : {1, -1}) {
        ModeBounds bounds = upTo(5);
        bounds.gapSign = gapSign;
        for (const Mode& mode : findModes(bounds)) {
            for (const double sag : {0.3, -0.3, -4.0}) {
                const double period = periodAt(mode, 0.6);
                const ModeMotion motion(mode, period, sag);
                double least = 0.0;
                double most = -1e9;
                double lowest = 1e9;
                for (int m = 0; m < instants; ++m) {
                    const double t = m * period / instants;
                    lowest = std::min(lowest, motion.displacement(1.0, t));
                    REQUIRE(motion.tipGap(t) > -1e-9);
                    for (int i = 0; i < cells; ++i) {
                        const double strain = motion.strain((i + 0.5) / cells, t);
                        least = std::min(least, strain);
                        most = std::max(most, strain);
                    }
                }
                const Extremes extremes = motion.extremes();
                INFO(mode.a << " " << mode.b << ", " << gapSign << ", " << sag);
                const double cell = 2.0 * std::abs(sag) / cells;
                CHECK(extremes.peakCompression == Approx(-least).margin(1.01 * cell));
                CHECK(extremes.peakTension == Approx(most).margin(1.01 * cell));
                CHECK(extremes.lowestTip == Approx(lowest).margin(motion.amplitude() * 1e-2));
            }
        }
    }
}
