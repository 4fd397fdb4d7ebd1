// One motion under an exact harmonic, by all methods: what it is to cost to have its impulse, time
// of contact and largest force. The truth is proved with enclosed numbers (harmonic_proof.hpp).

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "elements.hpp"
#include "harmonic_contact.hpp"
#include "harmonic_proof.hpp"
#include "rival_cases.hpp"
#include "signorini/response.hpp"
#include "suites.hpp"
#include "timing.hpp"

namespace signorini::bench {

namespace {

/// Of its motions that of larger impulse, on which the bar settles.
constexpr double drivenOmega = 2.0 * std::numbers::pi / drivenPeriod;

/// What is asked of it.
struct Measures {
    double impulse = 0.0;
    double contact = 0.0;
    double peak = 0.0;
};

struct Truth {
    Measures measures;
    double phase = 0.0;
    double within = 0.0;  ///< [L/c], so near are phase and contact proved
};

HarmonicCase drivenQuestion()
{
    return harmonicCase(dampingOfRho(drivenRho),
                        {.amplitude = drivenForce, .steps = 18, .stepsPerCrossing = 5.0});
}

const Truth& truth()
{
    static const Truth one = [] {
        const HarmonicCase given = drivenQuestion();
        const HarmonicMotion motion = harmonicContacts(given).back();
        const HarmonicProof proof = enclosed(given, motion);
        if (!proof.isProved) {
            throw std::runtime_error("the motion is not proved");
        }
        return Truth{
            {motion.extremes.impulse, motion.contacts.front().end, motion.extremes.peakForce},
            motion.phase,
            proof.within};
    }();
    return one;
}

void judgeMeasures(const Measures& seen, Record& record)
{
    const Measures& exact = truth().measures;
    record.figures["impulse_error"] = std::abs(seen.impulse / exact.impulse - 1.0);
    record.figures["contact_error"] = std::abs(seen.contact / exact.contact - 1.0);
    record.figures["peak_error"] = std::abs(seen.peak / exact.peak - 1.0);
    record.figures["error"] =
        std::max({record.figures["impulse_error"], record.figures["contact_error"],
                  record.figures["peak_error"]});
    record.claim = "found";
    record.outcome = record.figures["error"] < 0.1 ? "approximate" : "wrong";
}

/// All motions with one contact, the harmonic itself.
void byHarmonics(Record& record)
{
    std::vector<HarmonicMotion> all;
    bench::record(timeOf([&] { all = harmonicContacts(drivenQuestion()); }), record);
    // The truth itself, so what is left of its error is what its proof leaves.
    record.figures["contact_error"] = truth().within / truth().measures.contact;
    record.figures["error"] = record.figures["contact_error"];
    record.claim = "found";
    record.outcome = "right";
    record.figures["found"] = static_cast<double>(all.size());
    record.detail = "all motions of one contact";
}

/// The same with a staircase on so many cells.
void byStaircase(std::int64_t grid, Record& record)
{
    ResponseRange range;
    range.cells = grid;
    range.damping = dampingOfRho(drivenRho);
    range.amplitude = drivenForce;
    constexpr double ratio = 4.0 / drivenPeriod;
    range.leastFrequencyRatio = ratio * (1.0 - 1e-9);
    range.mostFrequencyRatio = ratio * (1.0 + 1e-9);
    std::vector<FrequencyResponse> all;
    bench::record(timeOf([&] { all = frequencyResponse(range); }), record);
    const ForcedMotion& motion = all.at(0).motions.back();
    judgeMeasures({motion.extremes.impulse, motion.extremes.contactTime, motion.extremes.peakForce},
                  record);
    record.figures["found"] = static_cast<double>(all[0].motions.size());
    record.detail = "all motions of one contact";
}

/// Harmonic balance: the tip's exact compliance up to harmonic H, a stiff spring for the wall seen
/// at 4 H instants; those that press by Newton's method for max(0, u - 1), from the true ones.
class HarmonicBalance {
public:
    explicit HarmonicBalance(int harmonics)
        : count_(4 * harmonics), spring_(penaltyOf(harmonics)), kernel_(count_), excited_(count_)
    {
        const double dashpot = dampingOfRho(drivenRho).eta();
        for (int k = 0; k < count_; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / count_;
            kernel_[k] = 1.0 / count_;
            for (int h = 1; h <= harmonics; ++h) {
                const double w = h * drivenOmega;
                const std::complex<double> impedance(w * std::cos(w), w * dashpot * std::sin(w));
                const std::complex<double> compliance = std::sin(w) / impedance;
                kernel_[k] += 2.0 / count_ * (compliance * std::polar(1.0, h * angle)).real();
                if (h == 1) {
                    excited_[k] =
                        drivenForce * (compliance * std::polar(1.0, angle - truth().phase)).real();
                }
            }
        }
    }

    Measures run(int& rounds)
    {
        std::vector<int> pressed;
        for (int k = 0; k < truth().measures.contact / drivenPeriod * count_; ++k) {
            pressed.push_back(k);
        }
        Eigen::VectorXd push;
        for (rounds = 1; rounds <= 100; ++rounds) {
            push = pushesOf(pressed);
            std::vector<int> next;
            for (int k = 0; k < count_; ++k) {
                double beyond = excited_[k] - 1.0;
                for (const int i : pressed) {
                    beyond -= kernel_[(k - i + count_) % count_] * push[i];
                }
                if (beyond > 0.0) {
                    next.push_back(k);
                }
            }
            if (next == pressed) {
                break;
            }
            pressed = next;
        }
        const double step = drivenPeriod / count_;
        return {push.sum() * step, static_cast<double>(pressed.size()) * step, push.maxCoeff()};
    }

private:
    [[nodiscard]] Eigen::VectorXd pushesOf(const std::vector<int>& pressed) const
    {
        const auto size = static_cast<Eigen::Index>(pressed.size());
        Eigen::MatrixXd matrix(size, size);
        Eigen::VectorXd beyond(size);
        for (Eigen::Index i = 0; i < size; ++i) {
            const int at = pressed[static_cast<std::size_t>(i)];
            beyond[i] = excited_[at] - 1.0;
            for (Eigen::Index j = 0; j < size; ++j) {
                matrix(i, j) =
                    (i == j ? 1.0 / spring_ : 0.0) +
                    kernel_[(at - pressed[static_cast<std::size_t>(j)] + count_) % count_];
            }
        }
        const Eigen::VectorXd solution = matrix.partialPivLu().solve(beyond);
        Eigen::VectorXd push = Eigen::VectorXd::Zero(count_);
        for (Eigen::Index i = 0; i < size; ++i) {
            push[pressed[static_cast<std::size_t>(i)]] = solution[i];
        }
        return push;
    }

    int count_;
    double spring_;            ///< [EA/L], the wall
    Eigen::VectorXd kernel_;   ///< u of a push of one instant
    Eigen::VectorXd excited_;  ///< u without pushes
};

void byBalance(int harmonics, Record& record)
{
    Measures seen;
    int rounds = 0;
    bench::record(timeOf([&] { seen = HarmonicBalance(harmonics).run(rounds); }), record);
    record.figures["iterations"] = rounds;
    judgeMeasures(seen, record);
    record.detail = rounds > 100 ? "what presses goes on changing" : "";
}

/// What a march has come to after so many periods.
void byMarch(std::string_view scheme, int elements, Record& record)
{
    constexpr int periods = 40;
    const RivalCase& driven = rivalCases().back();
    const TimeSteps marched = march(scheme, driven.bar, elements, drivenPeriod, periods, periods);
    Measures seen;
    double before = drivenPeriod * (periods - 1);
    for (const Sample& sample : marched.samples) {
        if (sample.time > drivenPeriod * (periods - 1) + 1e-9) {
            const double step = sample.time - before;
            seen.impulse += sample.force * step;
            seen.contact += sample.force > 0.0 ? step : 0.0;
            seen.peak = std::max(seen.peak, sample.force);
            before = sample.time;
        }
    }
    record.figures["seconds_median"] = marched.seconds;
    record.figures["seconds_best"] = marched.seconds;
    record.figures["repeats"] = 0;
    judgeMeasures(seen, record);
    record.detail = fmt::format("{} periods from near it", periods);
}

}  // namespace

std::vector<Case> harmonicSuite(Extent extent)
{
    const bool isFull = extent == Extent::full;
    std::vector<Case> cases;
    const auto add = [&](std::string_view method, int size, std::string_view unit, auto act) {
        Record row = identified("rivals", "driven bar, any times", std::string(method), "-",
                                size > 0 ? fmt::format("{} {}", size, unit) : "");
        row.figures["cells"] = size;
        cases.push_back({row, size > 0 ? fmt::format("{} driven", method) : "",
                         [size, act](Record& record) { act(size, record); }});
    };
    const auto some = [&](std::vector<int> sizes) {
        return isFull ? sizes : std::vector<int>{sizes.front()};
    };
    add("signorini, harmonic", 0, "", [](int, Record& row) { byHarmonics(row); });
    for (const int size : some({30, 60, 120, 240, 480})) {
        add("signorini, staircase", size, "cells", byStaircase);
    }
    for (const int size : some({10, 20, 50, 100, 200})) {
        add("harmonic balance", size, "harmonics", byBalance);
    }
    for (const std::string_view scheme :
         {"Moreau-Jean", "Newmark, penalty", "damped Newmark, penalty", "mass redistribution"}) {
        for (const int size : some({20, 50, 100, 200, 400})) {
            add(scheme, size, "elements",
                [scheme](int elements, Record& row) { byMarch(scheme, elements, row); });
        }
    }
    return cases;
}

}  // namespace signorini::bench
