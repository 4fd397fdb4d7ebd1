#include "rival_cases.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "driven_march.hpp"
#include "network_simulation.hpp"
#include "signorini/response.hpp"

namespace signorini::bench {

namespace {

/// Samples of a march event by event; `at` has tip and impulse.
template <typename Advance, typename Tip, typename Impulse>
void follow(double period, int periods, int kept, std::int64_t perCrossing, Advance advance,
            Tip tip, Impulse impulse, TimeSteps& steps)
{
    const auto count = static_cast<int>(std::llround(period * static_cast<double>(perCrossing)));
    double before = impulse();
    for (int k = 1; k <= count * periods; ++k) {
        advance();
        if (k <= count * kept) {
            const double now = impulse();
            const double h = period / count;
            steps.samples.push_back({k * h, tip(), (now - before) / h});
            before = now;
        }
    }
}

/// A scene from given waves of its cells or, where there are none, from the speed of its bar. Its
/// contact is the first one.
std::function<TimeSteps(int, int, std::int64_t)> sceneMarch(const std::string& text, double gravity,
                                                            double speed, std::vector<double> waves,
                                                            double period)
{
    return [=](int periods, int kept, std::int64_t perCrossing) {
        const double begin = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
        const Network network = networkOf({.parts = partsOf(text), .gravity = gravity});
        const NetworkScales& scales = network.scales;
        NetworkStart start;
        if (waves.empty()) {
            start = startWithSpeeds(network, std::vector{speed / scales.velocity()});
        } else {
            start.waves = waves;
            for (double& wave : start.waves) {
                wave /= scales.velocity();
            }
            start.displacements = displacementsOf(network, start.waves, {});
        }
        NetworkSimulation simulation(network, start);
        const std::size_t tip = network.contacts.front().node;
        const double step = 1.0 / static_cast<double>(perCrossing) / scales.time;
        TimeSteps steps;
        follow(
            period, periods, kept, perCrossing, [&] { simulation.advance(step); },
            [&] {
                return (simulation.displacement(tip) + network.nodes[tip].rest) *
                       scales.displacement;
            },
            [&] { return simulation.impulse() * scales.force() * scales.time; }, steps);
        const NetworkBalance balance = simulation.balance();
        steps.energyBefore = 1.0;
        steps.energyAfter = 1.0 + balance.error / std::max(balance.size, 1e-300);
        steps.seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC - begin;
        return steps;
    };
}

/// The motion of least energy with contacts of L/(2c) in 7/2 L/c: p = 1 arrives in contact, then
/// -1 until t = 2 and 1 again.
RivalCase mainMode()
{
    RivalCase one;
    one.name = "main mode";
    one.period = 3.5;
    one.reach = 3.0;
    one.bar.displacement = [](double x) { return std::min(1.0, 2.0 * x); };
    one.bar.velocity = [](double x) { return x < 0.5 ? 0.0 : 2.0; };
    one.tip = [](double time) {
        const double t = std::fmod(time, 3.5);
        return t < 0.5 ? 1.0 : t < 2.0 ? 1.0 - 2.0 * (t - 0.5) : -2.0 + 2.0 * (t - 2.0);
    };
    one.impulse = [](double time) {
        return std::floor(time / 3.5) + 2.0 * std::min(0.5, std::fmod(time, 3.5));
    };
    one.ours = sceneMarch("clamp 2 stop=1", 0.0, 0.0, {-1.0, 1.0, 1.0, 1.0}, one.period);
    return one;
}

/// L = 10, c = 30, g = 10, from 5: in these units g = 1/9, and it arrives with v = 3 g. The wave
/// from the foot is v + g t in the first contact; it flies for 6, is strained then, and in the
/// second contact all goes backwards. Time counts from the first contact.
RivalCase bouncingBar()
{
    constexpr double g = 1.0 / 9.0;
    RivalCase one;
    one.name = "bouncing bar";
    one.period = 16.0;
    one.reach = 4.5 * g;
    one.bar.isClamped = false;
    one.bar.wall = 0.0;
    one.bar.weight = g;
    one.bar.displacement = [](double) { return 0.0; };
    one.bar.velocity = [](double) { return 3.0 * g; };
    one.tip = [](double time) {
        const double t = std::fmod(time, 16.0);
        if (t < 2.0 || (t >= 8.0 && t < 10.0)) {
            return 0.0;
        }
        if (t >= 10.0) {
            const double since = t - 10.0;
            return -3.0 * g * since + 0.5 * g * since * since;
        }
        // Falls with 3g + gt, and the wave in it takes away 2 (3g + g tau), tau = t mod 2.
        const double tau = std::fmod(t, 2.0);
        const double rounds = std::floor(t / 2.0) - 1.0;
        return 3.0 * g * (t - 2.0) + 0.5 * g * (t * t - 4.0) - rounds * 16.0 * g -
               2.0 * (3.0 * g * tau + 0.5 * g * tau * tau);
    };
    one.impulse = [](double time) {
        const double t = std::fmod(time, 16.0);
        const double first = std::min(t, 2.0);
        const double second = std::clamp(t - 8.0, 0.0, 2.0);
        return 16.0 * g * std::floor(time / 16.0) + 3.0 * g * first + 0.5 * g * first * first +
               5.0 * g * second - 0.5 * g * second * second;
    };
    return one;
}

/// Half of a string that is plucked by 1 in the middle, an obstacle at 1/2: a bar that is pressed
/// on a wall, u(1) <= -1/2.
RivalCase string()
{
    RivalCase one;
    one.name = "string, obstacle";
    one.period = 2.5;
    one.reach = 0.5;
    one.bar.wall = -0.5;
    one.bar.displacement = [](double x) { return -x; };
    one.bar.velocity = [](double) { return 0.0; };
    one.tip = [](double time) {
        const double t = std::fmod(time, 2.5);
        return t < 0.5 ? -1.0 + t : t < 2.0 ? -0.5 : -0.5 - (t - 2.0);
    };
    one.impulse = [](double time) {
        return 1.5 * std::floor(time / 2.5) + std::clamp(std::fmod(time, 2.5) - 0.5, 0.0, 1.5);
    };
    one.ours = sceneMarch("clamp 1 stop=right:-0.5", 0.0, 0.0, {0.5, -0.5}, one.period);
    return one;
}

constexpr double mostPeriods = 101.0;

/// The motion of larger impulse, (12, 96) on 30 cells: its state is the start of all. The truth is
/// the march under a harmonic that is not sampled.
RivalCase forcedBar()
{
    const Schedule schedule{30, {{12, 96}}};
    const std::vector<ForcedMotion> motions =
        motionsOfAmplitude(forcedMotions(schedule, dampingOfRho(drivenRho), {}), drivenForce);
    if (motions.empty()) {
        throw std::runtime_error("the motion to be followed is not there");
    }
    const ForcedMotion motion = motions.back();
    const auto truth = std::make_shared<DrivenMarch>(
        motion.state, DrivenCase{motion.damping.eta(), drivenForce, motion.phase, drivenPeriod},
        drivenPeriod * mostPeriods);
    RivalCase one;
    one.name = "forced, damped";
    one.period = drivenPeriod;
    one.isSampled = true;
    one.bar.dashpot = motion.damping.eta();
    one.bar.force = [phase = motion.phase](double time) {
        return drivenForce * std::cos(2.0 * std::numbers::pi * time / drivenPeriod - phase);
    };
    const auto nodes = std::make_shared<Eigen::VectorXd>(displacement(motion.state));
    const auto speeds = std::make_shared<Eigen::VectorXd>(velocity(motion.state));
    one.bar.displacement = [nodes](double x) {
        const double place = x * static_cast<double>(nodes->size());
        const auto cell = std::min(static_cast<Eigen::Index>(place + 1e-9), nodes->size() - 1);
        const double from = cell > 0 ? (*nodes)[cell - 1] : 0.0;
        return std::lerp(from, (*nodes)[cell], place - static_cast<double>(cell));
    };
    one.bar.velocity = [speeds](double x) {
        const auto count = static_cast<double>(speeds->size());
        return (*speeds)[std::min(static_cast<Eigen::Index>(x * count), speeds->size() - 1)];
    };
    one.tip = [truth](double time) { return truth->tip(time); };
    one.impulse = [truth](double time) { return truth->impulse(time); };
    double low = 1.0;
    for (int k = 0; k < 1000; ++k) {
        low = std::min(low, truth->tip(0.001 * drivenPeriod * k));
    }
    one.reach = 1.0 - low;
    one.ours = [motion](int periods, int kept, std::int64_t perCrossing) {
        const double begin = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
        const auto steps = static_cast<std::int64_t>(
            std::llround(drivenPeriod * static_cast<double>(perCrossing)));
        BarSimulation simulation(
            wavesOf(motion.state), motion.damping,
            excitationOf({.amplitude = drivenForce,
                          .phase = motion.phase,
                          .steps = steps,
                          .stepsPerCrossing = static_cast<double>(perCrossing)}));
        const double step =
            static_cast<double>(motion.state.cells()) / static_cast<double>(perCrossing);
        TimeSteps result;
        result.energyBefore = simulation.energyRatio();
        follow(
            drivenPeriod, periods, kept, perCrossing, [&] { simulation.advance(step); },
            [&] { return simulation.tip(); }, [&] { return simulation.impulse(); }, result);
        result.energyAfter = simulation.energyRatio();
        result.seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC - begin;
        return result;
    };
    return one;
}

}  // namespace

const std::vector<RivalCase>& rivalCases()
{
    static const std::vector<RivalCase> cases = [] {
        std::vector<RivalCase> all{mainMode(), bouncingBar(), string(), forcedBar()};
        // Its weight is a staircase of cells, whose means are exact.
        all[1].ours = [](int periods, int kept, std::int64_t perCrossing) {
            const auto march = sceneMarch(std::to_string(perCrossing) + " stop=right:0", 1.0 / 9.0,
                                          1.0 / 3.0, {}, 16.0);
            return march(periods, kept, perCrossing);
        };
        return all;
    }();
    return cases;
}

void judgeMarch(const RivalCase& one, const TimeSteps& steps, Record& record)
{
    double tips = 0.0;
    double worst = 0.0;
    double forces = 0.0;
    double size = 0.0;
    double before = 0.0;
    double impulse = 0.0;
    for (const Sample& sample : steps.samples) {
        const double missed = std::abs(sample.tip - one.tip(sample.time));
        tips += missed * missed;
        worst = std::max(worst, missed);
        const double now = one.impulse(sample.time);
        const double force = (now - impulse) / (sample.time - before);
        forces += std::pow(sample.force - force, 2);
        size += force * force;
        impulse = now;
        before = sample.time;
    }
    const auto count = static_cast<double>(steps.samples.size());
    record.figures["tip_error"] = std::sqrt(tips / count) / one.reach;
    record.figures["error"] = worst / one.reach;
    record.figures["force_error"] = std::sqrt(forces / size);
    record.figures["energy_drift"] = steps.energyAfter / steps.energyBefore - 1.0;
    record.figures["seconds_median"] = steps.seconds;
    record.figures["seconds_best"] = steps.seconds;
    record.figures["repeats"] = 0;
    record.claim = "found";
    // A discretisation is judged by its error, not by a threshold; wrong is wrong, though.
    record.outcome = record.figures["tip_error"] < 0.1 ? "approximate" : "wrong";
}

}  // namespace signorini::bench
