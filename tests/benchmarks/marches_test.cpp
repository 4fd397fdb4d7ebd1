// The judges of the suite of forced motions: the march under a harmonic as it is, and time steps.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "catch.hpp"
#include "driven_march.hpp"
#include "rival_cases.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/response.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::bench;
using test::onePhase;

namespace {

State rest(std::int64_t cells)
{
    return {Eigen::VectorXd::Zero(cells), Eigen::VectorXd::Zero(cells)};
}

/// The start of the suite: (12, 96) on 30 cells, a force of 0.25 EA g/L, rho = 0.9.
ForcedMotion suiteMotion()
{
    return motionsOfAmplitude(forcedMotions(onePhase(30, 12, 96), dampingOfRho(0.9), {}), 0.25)
        .back();
}

DrivenCase caseOf(const ForcedMotion& motion)
{
    return {motion.damping.eta(), motion.amplitude, motion.phase, 3.6};
}

/// Largest difference of the tip's path with a harmonic in so many steps of L/c.
double errorOfSteps(const ForcedMotion& motion, const DrivenMarch& truth, std::int64_t steps)
{
    BarSimulation bar(wavesOf(motion.state), motion.damping,
                      excitationOf({.amplitude = motion.amplitude,
                                    .phase = motion.phase,
                                    .steps = 36 * steps / 10,
                                    .stepsPerCrossing = static_cast<double>(steps)}),
                      {.mergeBelow = 0.0, .recordsTip = true});
    bar.advance(2.0 * 108.0);
    double worst = 0.0;
    for (const TipPoint& point : bar.tipPath()) {
        worst = std::max(worst, std::abs(point.displacement - truth.tip(point.time)));
    }
    return worst;
}

}  // namespace

TEST_CASE("bench: the march of a harmonic swings as the formula of the linear bar says")
{
    // u = U sin(w x)/sin(w) and s(L) = F - eta v: U = A/|w cot w + i eta w|.
    for (const double period : {2.3, 3.1, 4.0, 5.7}) {
        for (const double eta : {0.05, 0.3, 0.8}) {
            const DrivenCase one{eta, 0.01, 0.4, period};
            const double end = 60.0 * period / eta;
            const DrivenMarch march(rest(1), one, end);
            const double w = 2.0 * std::numbers::pi / period;
            const double size = one.amplitude / std::hypot(w * std::cos(w) / std::sin(w), eta * w);
            double most = 0.0;
            for (int k = 0; k < 4000; ++k) {
                most = std::max(most, std::abs(march.tip(end - period * k / 4000.0)));
            }
            INFO("T = " << period << ", eta = " << eta);
            CHECK(most == Approx(size).epsilon(1e-5));
            CHECK(march.arrivals().empty());
        }
    }
}

TEST_CASE("bench: the march repeats a free motion, contact by contact")
{
    const State state = leastEnergyMotion(onePhaseSet(onePhase(30, 15, 90)));
    const DrivenMarch march(state, {0.0, 0.0, 0.0, 1.0}, 35.0);
    REQUIRE(march.arrivals().size() == 10);
    for (std::size_t k = 0; k < 10; ++k) {
        CHECK(march.arrivals()[k] == Approx(3.5 * static_cast<double>(k + 1)).margin(1e-9));
    }
    for (int k = 0; k < 100; ++k) {
        const double time = 0.035 * k;
        CHECK(march.tip(time + 31.5) == Approx(march.tip(time)).margin(1e-11));
    }
}

TEST_CASE("bench: the simulation tends to the march as the square of the step of its harmonic")
{
    const ForcedMotion motion = suiteMotion();
    const DrivenMarch truth(motion.state, caseOf(motion), 7.4);
    CHECK(truth.arrivals().size() == 2);
    const double coarse = errorOfSteps(motion, truth, 60);
    const double fine = errorOfSteps(motion, truth, 240);
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 12.0);
    CHECK(fine > coarse / 20.0);
}

TEST_CASE("bench: the closed forms of the rivals' cases are what waves on a grid do")
{
    for (const RivalCase& one : rivalCases()) {
        const TimeSteps grid = march("characteristics", one.bar, 20, one.period, 10, 10);
        const TimeSteps ours = one.ours(10, 10, 20);
        for (const TimeSteps* steps : {&grid, &ours}) {
            Record record;
            judgeMarch(one, *steps, record);
            INFO(one.name << (steps == &grid ? ": characteristics" : ": ours"));
            // The harmonic is constant in steps, and its contacts are on no grid.
            CHECK(record.figure("tip_error") < (one.isSampled ? 5e-3 : 1e-12));
            CHECK(record.figure("force_error") < (one.isSampled ? 2e-2 : 1e-11));
            CHECK(std::abs(record.figure("energy_drift")) < (one.isSampled ? 0.1 : 1e-12));
        }
    }
}

TEST_CASE("bench: every scheme of elements comes nearer as they get finer")
{
    for (const RivalCase& one : rivalCases()) {
        for (const std::string_view scheme : schemeNames()) {
            if (scheme == "characteristics" ||
                (scheme.starts_with("CVODE") && !SIGNORINI_HAS_CVODE)) {
                continue;
            }
            std::vector<double> errors;
            for (const int elements : {10, 160}) {
                Record record;
                judgeMarch(one, march(scheme, one.bar, elements, one.period, 1, 1), record);
                errors.push_back(record.figure("tip_error"));
            }
            INFO(one.name << ", " << scheme << ": " << errors[0] << ", " << errors[1]);
            CHECK(errors[1] < 0.7 * errors[0]);
            CHECK(errors[1] > 1e-5);
        }
    }
}

TEST_CASE("bench: without contact the elements swing as the formula of a bar in elements says")
{
    // A sine of the first mode, far from the wall: cos(w t), w^2 = K/M of the mode, no energy lost.
    const double wave = 0.5 * std::numbers::pi;
    const int elements = 8;
    MarchedBar bar;
    bar.wall = 10.0;
    bar.displacement = [wave](double x) { return std::sin(wave * x); };
    bar.velocity = [](double) { return 0.0; };
    const double cell = 1.0 / elements;
    const double cosine = std::cos(wave * cell);
    const double consistent = std::sqrt(6.0 * (1.0 - cosine) / (2.0 + cosine)) / cell;
    for (const std::string_view scheme : {"Newmark, penalty", "Moreau-Jean"}) {
        // The trapezoidal rule turns by 2 atan(w h/2) in a step.
        const double period = 2.0 * std::numbers::pi / consistent;
        const TimeSteps steps = march(scheme, bar, elements, period, 3, 3);
        const double h = steps.samples.front().time;
        for (const Sample& sample : steps.samples) {
            const double turned = 2.0 * std::atan(0.5 * consistent * h) * sample.time / h;
            CHECK(sample.tip == Approx(std::cos(turned)).margin(1e-9));
            CHECK(sample.force == 0.0);
        }
        CHECK(steps.energyAfter == Approx(steps.energyBefore).epsilon(1e-9));
    }
}
