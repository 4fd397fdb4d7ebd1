// The judges of the suite of forced motions: the march under a harmonic as it is, and time steps.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "harmonic_march.hpp"
#include "moreau_jean.hpp"
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

HarmonicCase caseOf(const ForcedMotion& motion)
{
    return {motion.damping.eta(), motion.amplitude, motion.phase, 3.6};
}

/// Largest difference of the tip's path with a harmonic in so many steps of L/c.
double errorOfSteps(const ForcedMotion& motion, const HarmonicMarch& truth, std::int64_t steps)
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
            const HarmonicCase one{eta, 0.01, 0.4, period};
            const double end = 60.0 * period / eta;
            const HarmonicMarch march(rest(1), one, end);
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
    const HarmonicMarch march(state, {0.0, 0.0, 0.0, 1.0}, 35.0);
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
    const HarmonicMarch truth(motion.state, caseOf(motion), 7.4);
    CHECK(truth.arrivals().size() == 2);
    const double coarse = errorOfSteps(motion, truth, 60);
    const double fine = errorOfSteps(motion, truth, 240);
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 12.0);
    CHECK(fine > coarse / 20.0);
}

TEST_CASE("bench: time steps of elements come nearer as they get finer, slowly")
{
    const ForcedMotion motion = suiteMotion();
    const HarmonicMarch truth(motion.state, caseOf(motion), 3.6 * 5);
    const State nodes = refined(motion.state, 20);
    std::vector<double> errors;
    for (const int elements : {50, 200, 800}) {
        double squares = 0.0;
        const TimeSteps steps = runMoreauJean({.state = nodes,
                                               .elements = elements,
                                               .steps = 36 * elements / 10,
                                               .period = 3.6,
                                               .periods = 5,
                                               .dashpot = motion.damping.eta(),
                                               .amplitude = motion.amplitude,
                                               .phase = motion.phase});
        for (const Sample& sample : steps.samples) {
            squares += std::pow(sample.tip - truth.tip(sample.time), 2);
        }
        errors.push_back(std::sqrt(squares / static_cast<double>(steps.samples.size())));
    }
    CHECK(errors[0] < 0.2);
    CHECK(errors[1] < 0.6 * errors[0]);
    CHECK(errors[2] < 0.6 * errors[1]);
    CHECK(errors[2] > 1e-5);
}
