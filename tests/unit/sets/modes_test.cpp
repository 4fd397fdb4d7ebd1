#include "signorini/modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "catch.hpp"
#include "signorini/motion.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every mode of the given order, whatever its energy.
ModeBounds upTo(std::int64_t order)
{
    ModeBounds bounds;
    bounds.maxOrder = order;
    bounds.maxEnergyRatio = 1e300;
    return bounds;
}

const Mode& find(const std::vector<Mode>& modes, std::int64_t a, std::int64_t b)
{
    const auto at = std::find_if(modes.begin(), modes.end(),
                                 [a, b](const Mode& mode) { return mode.a == a && mode.b == b; });
    if (at == modes.end()) {
        throw std::runtime_error("no such mode");
    }
    return *at;
}

/// The numbers n with lowest < n/cells < highest and gcd(2N, n) = 1.
std::vector<std::int64_t> coprimeSteps(const Mode& mode, std::int64_t cells)
{
    std::vector<std::int64_t> result;
    for (std::int64_t n = mode.lowest.numerator * cells / mode.lowest.denominator + 1;
         n * mode.highest.denominator < mode.highest.numerator * cells; ++n) {
        if (std::gcd(2 * cells, n) == 1) {
            result.push_back(n);
        }
    }
    return result;
}

/// Q/P, if jumps meet at the lowest period, which is 2Q/P; Q is odd.
ExactPeriod meeting(const Mode& mode)
{
    const auto [p, q] = mode.lowest;
    return p % 2 == 0 ? ExactPeriod{p / 2, q} : ExactPeriod{p, 2 * q};
}

/// The mode from which this one branches off where jumps meet: a' = a - lQ, |b'| = |b| - 2lP,
/// l = floor(a/Q).
const Mode& stemOf(const std::vector<Mode>& modes, const Mode& mode)
{
    const ExactPeriod end = meeting(mode);
    const std::int64_t l = mode.a / end.numerator;
    return find(modes, mode.a - l * end.numerator, mode.b + 2 * l * end.denominator);
}

/// E/E_1 = 1/(kappa n/N - mu)^2 from integers.
double gridEnergy(const Mode& mode, std::int64_t cells, std::int64_t n)
{
    const double root =
        static_cast<double>(cells) / static_cast<double>(mode.kappa * n - mode.mu * cells);
    return root * root;
}

/// A period in the interval that no short fraction comes near: lowest + (highest - lowest) times
/// a number in ]0, 1[.
double periodAt(const Mode& mode, double part)
{
    return mode.lowest.value() + part * (mode.highest.value() - mode.lowest.value());
}

}  // namespace

TEST_CASE("modes: the closed families have exactly the known intervals and energies")
{
    struct Known {
        std::int64_t a, b;
        ExactPeriod lowest, highest;
        std::int64_t kappa, mu;
        std::string family;
    };
    std::vector<Known> known{{1, -1, {3, 1}, {4, 1}, 1, 3, "main"},
                             {6, -7, {10, 3}, {24, 7}, -2, -7, ""}};
    for (std::int64_t p = 2; p <= 20; ++p) {
        known.push_back({p,
                         1 - 2 * p,
                         {2 * p + 1, p},
                         {4 * p, 2 * p - 1},
                         p,
                         2 * p + 1,
                         "subharmonic " + std::to_string(p)});
    }
    for (std::int64_t m = 1; m <= 19; ++m) {
        known.push_back({1,
                         -2 * m - 1,
                         {2 * m + 3, (m + 1) * (m + 1)},
                         {4, 2 * m + 1},
                         (m + 1) * (m + 1),
                         2 * m + 3,
                         "higher " + std::to_string(m)});
    }
    for (std::int64_t k = 1; k <= 9; ++k) {
        known.push_back({1 + 3 * k,
                         -1 - 4 * k,
                         {3, 1},
                         {4 + 12 * k, 1 + 4 * k},
                         1,
                         3,
                         "twin " + std::to_string(k)});
    }
    const std::vector<Mode> modes = findModes(upTo(41));
    for (const Known& expected : known) {
        INFO(expected.a << " " << expected.b);
        const Mode& mode = find(modes, expected.a, expected.b);
        CHECK(mode.lowest == expected.lowest);
        CHECK(mode.highest == expected.highest);
        CHECK(mode.kappa == expected.kappa);
        CHECK(mode.mu == expected.mu);
        CHECK(familyName(mode) == expected.family);
        CHECK(mode.highestEnd == ModeEnd::contactVanishes);
        CHECK(mode.lowestEnd ==
              (expected.kappa > 0 ? ModeEnd::energyInfinite : ModeEnd::jumpsMeet));
    }
}

TEST_CASE("modes: 29 within the default bounds, 73 of order 25 whatever the energy")
{
    CHECK(findModes().size() == 29);
    const std::vector<Mode> all = findModes(upTo(25));
    CHECK(all.size() == 73);
    // A sample on one grid sees those with enough points on it.
    const auto seen = std::count_if(all.begin(), all.end(), [](const Mode& mode) {
        return coprimeSteps(mode, 1009).size() >= 5;
    });
    CHECK(seen == 38);
}

TEST_CASE("modes: every mode leaves a linear motion at its highest period, with E = b^2")
{
    for (const Mode& mode : findModes(upTo(101))) {
        INFO(mode.a << " " << mode.b);
        REQUIRE(mode.highest == ExactPeriod{4 * mode.a, -mode.b});
        REQUIRE(mode.highest.value() <= 4.0);
        REQUIRE(std::gcd(mode.lowest.numerator, mode.lowest.denominator) == 1);
        const EnergyRange range = energyRange(mode);
        const auto square = static_cast<double>(mode.b * mode.b);
        REQUIRE((range.least == square || range.most == square));
        const bool isInfinite = mode.lowestEnd == ModeEnd::energyInfinite;
        REQUIRE((range.most == infinity) == isInfinite);
        // Near the ends the energy of members is near the limits.
        const double nearLowest = energyRatio(mode, periodAt(mode, 1e-6));
        const double nearHighest = energyRatio(mode, periodAt(mode, 1.0 - 1e-6));
        REQUIRE(nearHighest == Approx(square).epsilon(1e-3));
        if (isInfinite) {
            REQUIRE(nearLowest > 1e6 * square);
        } else {
            REQUIRE(nearLowest == Approx(range.least).epsilon(1e-3));
        }
        REQUIRE(contactTime(mode, periodAt(mode, 1.0 - 1e-6)) < 1e-5);
    }
}

TEST_CASE("modes: where jumps meet a mode branches off just one other, given by a formula")
{
    const std::vector<Mode> all = findModes(upTo(101));
    int branches = 0;
    for (const Mode& mode : all) {
        if (mode.lowestEnd != ModeEnd::jumpsMeet) {
            continue;
        }
        ++branches;
        // Contact time and 1/sqrt(E/E_1) at the end p/q, times q: whole numbers.
        const auto [p, q] = mode.lowest;
        const auto contact = [p = p, q = q](const Mode& m) { return 4 * m.a * q + m.b * p; };
        const auto root = [p = p, q = q](const Mode& m) { return m.kappa * p - m.mu * q; };
        const auto holds = [p = p, q = q](const Mode& m) {
            return m.lowest.numerator * q < p * m.lowest.denominator &&
                   p * m.highest.denominator < m.highest.numerator * q;
        };
        INFO(mode.a << " " << mode.b);
        const auto isMet = [&](const Mode& other) {
            return holds(other) && contact(other) == contact(mode);
        };
        const Mode& stem = stemOf(all, mode);
        REQUIRE(stem.b > mode.b);
        REQUIRE(isMet(stem));
        REQUIRE(root(stem) == root(mode));
        REQUIRE(std::count_if(all.begin(), all.end(), isMet) == 1);
    }
    CHECK(branches == 337);
}

TEST_CASE("modes: at a branch both modes have one sequence of signs")
{
    const std::vector<Mode> all = findModes(upTo(101));
    for (const Mode& mode : all) {
        if (mode.lowestEnd != ModeEnd::jumpsMeet) {
            continue;
        }
        const ModeMotion at(stemOf(all, mode), mode.lowest.value());
        const ModeMotion beside(mode, periodAt(mode, 1e-9));
        INFO(mode.a << " " << mode.b);
        // Signs are constant on the Q units of 2/P; the middles are far from all jumps.
        const std::int64_t units = meeting(mode).numerator;
        const double unit = mode.lowest.value() / static_cast<double>(units);
        for (std::int64_t k = 0; k < units; ++k) {
            const double t = unit * (static_cast<double>(k) + 0.5);
            REQUIRE(beside.incoming(t) == Approx(at.incoming(t)).epsilon(1e-4));
        }
    }
}

TEST_CASE("modes: on grids each is the one motion of its schedules, with its energy")
{
    const std::int64_t cells = GENERATE(1009, 10007);
    for (const Mode& mode : findModes(upTo(25))) {
        const std::vector<std::int64_t> all = coprimeSteps(mode, cells);
        const std::size_t stride = std::max<std::size_t>(1, all.size() / 7);
        for (std::size_t k = 0; k < all.size(); k += stride) {
            const Schedule schedule = scheduleOf(mode, cells, all[k]);
            const OnePhaseSet r = onePhaseSet(schedule);
            INFO(mode.a << " " << mode.b << ": " << describe(schedule));
            REQUIRE_FALSE(r.reason);
            REQUIRE(r.contact == Contact::pressing);
            REQUIRE(r.set.kind == SetKind::point);
            REQUIRE(energyRange(r).least == Approx(gridEnergy(mode, cells, all[k])).epsilon(1e-12));
            REQUIRE(std::sqrt(energyRatio(mode, period(schedule)) / energyRange(r).least) ==
                    Approx(1.0).epsilon(1e-15 * static_cast<double>(std::abs(mode.mu) * cells)));
        }
    }
}

TEST_CASE("modes: at a common divisor a mode is the motion of least energy of a simplex")
{
    const std::vector<Mode> modes = findModes();
    const OnePhaseSet paper = onePhaseSet(scheduleOf(find(modes, 1, -1), 300, 1050));
    CHECK(paper.schedule == onePhase(300, 150, 900));
    CHECK(paper.set.dimension() == 149);
    for (const Mode& mode : modes) {
        for (const std::int64_t cells : {720, 5040}) {
            std::int64_t n = mode.lowest.numerator * cells / mode.lowest.denominator + 1;
            for (; n * mode.highest.denominator < mode.highest.numerator * cells; ++n) {
                const OnePhaseSet r = onePhaseSet(scheduleOf(mode, cells, n));
                INFO(mode.a << " " << mode.b << ": " << n << " steps on " << cells);
                REQUIRE_FALSE(r.reason);
                REQUIRE(r.contact == Contact::pressing);
                REQUIRE(r.kernelDimension == std::gcd(2 * cells, n));
                REQUIRE(energyRange(r).least == Approx(gridEnergy(mode, cells, n)).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("modes: just outside the interval the same contact time has no motion")
{
    const std::int64_t cells = 10007;
    int below = 0;
    int above = 0;
    for (const Mode& mode : findModes(upTo(25))) {
        const std::int64_t first = mode.lowest.numerator * cells / mode.lowest.denominator;
        const std::int64_t last = (mode.highest.numerator * cells + mode.highest.denominator - 1) /
                                  mode.highest.denominator;
        for (std::int64_t k = 0; k < 5; ++k) {
            for (const std::int64_t n : {first - k, last + k}) {
                const std::int64_t contact = 4 * mode.a * cells + mode.b * n;
                INFO(mode.a << " " << mode.b << ": " << contact << " of " << n);
                REQUIRE_THROWS_AS(scheduleOf(mode, cells, n), std::invalid_argument);
                if (n >= last) {
                    REQUIRE(contact <= 0);
                    ++above;
                } else if (std::gcd(2 * cells, n) == 1) {
                    const OnePhaseSet r = onePhaseSet(onePhase(cells, contact, n - contact));
                    REQUIRE((r.reason || r.contact == Contact::grazing));
                    ++below;
                }
            }
        }
    }
    CHECK(below > 150);
    CHECK(above == 5 * 73);
}

TEST_CASE("modes: complete: the pressing schedules with gcd(2N, n) = 1 are those of the modes")
{
    // Prime and composite: powers, products of small primes.
    const std::int64_t cells = GENERATE(31, 101, 211, 12, 30, 64, 81, 105);
    std::set<std::pair<std::int64_t, std::int64_t>> found;
    OnePhaseSet r;
    for (std::int64_t n = 2; n <= 8 * cells; ++n) {
        if (std::gcd(2 * cells, n) != 1) {
            continue;
        }
        for (std::int64_t contact = 1; contact < n; ++contact) {
            onePhaseSet(onePhase(cells, contact, n - contact), r);
            if (!r.reason && r.contact == Contact::pressing) {
                found.emplace(contact, n);
            }
        }
    }
    // 0 < n_c = 4aN - |b| n with 2a < n allows no |b| above 2N.
    std::set<std::pair<std::int64_t, std::int64_t>> predicted;
    std::size_t members = 0;
    for (const Mode& mode : findModes(upTo(2 * cells - 1))) {
        for (const std::int64_t n : coprimeSteps(mode, cells)) {
            if (2 * mode.a < n) {
                predicted.emplace(scheduleOf(mode, cells, n).phases.front().contact, n);
                ++members;
            }
        }
    }
    INFO(cells << " cells: " << found.size() << " schedules");
    CHECK(found == predicted);
    CHECK(members == predicted.size());  // each belongs to one mode
    CHECK(found.size() > static_cast<std::size_t>(cells / 2));
}

TEST_CASE("modes: the bounds select modes and leave their intervals alone")
{
    const std::vector<Mode> all = findModes(upTo(25));
    const auto listed = [](const ModeBounds& bounds, std::int64_t a, std::int64_t b) {
        const std::vector<Mode> modes = findModes(bounds);
        return std::any_of(modes.begin(), modes.end(),
                           [a, b](const Mode& mode) { return mode.a == a && mode.b == b; });
    };
    ModeBounds bounds;
    for (const auto& [energy, order, period, count] :
         {std::tuple{1.0, 25, 8.0, 0}, std::tuple{1.01, 25, 8.0, 1}, std::tuple{4.0, 25, 3.4, 0},
          std::tuple{4.0, 25, 3.5, 1}, std::tuple{9.1, 3, 8.0, 3}, std::tuple{9.1, 3, 3.0, 2},
          std::tuple{9.1, 3, 2.0, 1}, std::tuple{1e300, 1, 8.0, 1}, std::tuple{1e300, 3, 1.25, 0},
          std::tuple{49.0, 7, 8.0, 7}, std::tuple{49.1, 7, 8.0, 10}}) {
        bounds.maxEnergyRatio = energy;
        bounds.maxOrder = order;
        bounds.maxPeriod = period;
        INFO(energy << " " << order << " " << period);
        const std::vector<Mode> modes = findModes(bounds);
        CHECK(modes.size() == static_cast<std::size_t>(count));
        for (const Mode& mode : modes) {
            CHECK(mode == find(all, mode.a, mode.b));
        }
    }
    // 24 - 7T has its energies in ]9, 49[, the least at its shortest period 10/3.
    bounds = {};
    bounds.maxEnergyRatio = 9.0;
    CHECK_FALSE(listed(bounds, 6, -7));
    bounds.maxEnergyRatio = std::nextafter(9.0, 10.0);
    CHECK(listed(bounds, 6, -7));
    bounds.maxPeriod = 10.0 / 3.0;  // rounded up
    CHECK(listed(bounds, 6, -7));
    bounds.maxPeriod = std::nextafter(bounds.maxPeriod, 0.0);
    CHECK_FALSE(listed(bounds, 6, -7));
    bounds.cancel = [] { return true; };
    CHECK(findModes(bounds).empty());
}

TEST_CASE("modes: wrong bounds, periods and grids are refused by name")
{
    const auto message = [](const ModeBounds& bounds) {
        try {
            (void)findModes(bounds);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(message({0, 8.0, 50.0, {}}), containsText("maxOrder = 0"));
    CHECK_THAT(message({10002, 8.0, 50.0, {}}), containsText("1..10001"));
    CHECK_THAT(message({25, -1.0, 50.0, {}}), containsText("maxPeriod = -1"));
    CHECK_THAT(message({25, 8.0, infinity, {}}), containsText("maxEnergyRatio = inf"));
    CHECK_THAT(message({-1, 0.0, std::nan(""), {}}), containsText("maxOrder") &&
                                                         containsText("maxPeriod") &&
                                                         containsText("maxEnergyRatio"));
    const Mode mode = findModes().front();
    for (const double period : {3.0, 4.0, 2.0, 5.0, infinity, std::nan("")}) {
        CHECK_THROWS_AS(ModeMotion(mode, period), std::invalid_argument);
        CHECK_THROWS_AS(energyRatio(mode, period), std::invalid_argument);
        CHECK_THROWS_AS(contactTime(mode, period), std::invalid_argument);
    }
    CHECK_THROWS_WITH(energyRatio(mode, 4.5), containsText("4.5") && containsText("]3/1, 4/1["));
    CHECK_THROWS_WITH(scheduleOf(mode, 0, 3), containsText("cells = 0"));
    CHECK_THROWS_AS(scheduleOf(mode, 10, 30), std::invalid_argument);
    CHECK_THROWS_AS(scheduleOf(mode, 10, 40), std::invalid_argument);
    CHECK_THROWS_AS(scheduleOf(mode, 10, std::numeric_limits<std::int64_t>::max()),
                    std::invalid_argument);
    CHECK(scheduleOf(mode, 10, 31) == onePhase(10, 9, 22));
}

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
    const Mode& mode = find(findModes(upTo(5)), 2, -3);
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
