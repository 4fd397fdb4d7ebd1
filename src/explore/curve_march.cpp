#include "curve_march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace signorini {

namespace {

/// One curve from x to the end.
class CurveMarch {
public:
    CurveMarch(CurveOfMotions& curve, const MarchOptions& options, Eigen::VectorXd start,
               Eigen::VectorXd end)
        : curve_(curve), options_(options), x_(std::move(start)), end_(std::move(end))
    {
        // Each step is kept as two, with its middle.
        const double chord = curve_.distance(x_, end_);
        const auto steps = 0.5 * static_cast<double>(options.points - 1);
        longest_ = std::min(options.resolution * options.norm, chord / steps);
    }

    void run()
    {
        if (!curve_.keep(x_)) {
            return;
        }
        double length = longest_;
        while (!curve_.isCancelled()) {
            const double rest = curve_.distance(x_, end_);
            if (rest <= options_.tolerance * options_.norm) {
                curve_.finish();
                return;
            }
            if (tryStep(std::min(length, rest), rest)) {
                if (!curve_.keep(middle_) || !curve_.keep(x_)) {
                    return;
                }
                length = std::min(longest_, 1.5 * length);
            } else if (length *= 0.5; length < finest * longest_) {
                stopBroken(rest);
                return;
            }
        }
    }

private:
    static constexpr double finest = 1.0 / 64.0;
    /// What a step must gain on the end, of its length, so that the march ends.
    static constexpr double leastGain = 0.02;
    /// How far the middle may be from either neighbour, of their distance; for isolated motions, or
    /// neighbours across a gap as wide as their distance, it is 1.
    static constexpr double middleOff = 0.8;

    /// Predicts on the chord to the end, lands, and looks for the middle. Moves x if all is well.
    bool tryStep(double length, double rest)
    {
        Eigen::VectorXd next = end_;
        if (length < rest) {
            SolverResult landed = curve_.land(x_ + length / rest * (end_ - x_));
            if (landed.status != SolverStatus::optimal) {
                return false;
            }
            next = std::move(landed.x);
        }
        const double step = curve_.distance(x_, next);
        if (!(step <= longest_ * (1.0 + 1e-9)) ||
            !(curve_.distance(next, end_) <= rest - leastGain * length)) {
            return false;
        }
        SolverResult landed = curve_.land(0.5 * (x_ + next));
        if (landed.status != SolverStatus::optimal ||
            !(curve_.distance(landed.x, x_) <= middleOff * step) ||
            !(curve_.distance(landed.x, next) <= middleOff * step)) {
            return false;
        }
        middle_ = std::move(landed.x);
        x_ = std::move(next);
        return true;
    }

    void stopBroken(double rest)
    {
        if (curve_.isCancelled()) {
            return;
        }
        curve_.stop(fmt::format(
            "the trace broke at lambda = {:.6g}, {:.3g} before the other end: no motion of this "
            "energy within {:.3g} continues it, in units of sqrt(E/E_1) = 1",
            curve_.reached(), rest, finest * longest_));
    }

    CurveOfMotions& curve_;
    const MarchOptions& options_;
    Eigen::VectorXd x_;
    Eigen::VectorXd middle_;
    Eigen::VectorXd end_;
    double longest_ = 0.0;
};

/// The first of a few members nearest to a share of the way to shuffled unknowns, later to half of
/// it, that is not the start nor known to lie in another component.
SolverResult farEnd(CurveOfMotions& curve, double norm, double share, const Eigen::VectorXd& start,
                    std::mt19937_64& generator)
{
    constexpr int attempts = 20;
    constexpr double apart = 1e-3;
    Eigen::VectorXd x = start;
    SolverResult landed;
    for (int k = 0; k < attempts && !curve.isCancelled(); ++k) {
        std::shuffle(x.begin(), x.end(), generator);
        landed = curve.land(start + (k < attempts / 2 ? share : 0.5 * share) * (x - start));
        if (landed.status == SolverStatus::optimal &&
            curve.distance(landed.x, start) > apart * norm && curve.mayJoin(start, landed.x)) {
            break;
        }
    }
    return landed;
}

}  // namespace

void marchTo(CurveOfMotions& curve, const MarchOptions& options, Eigen::VectorXd start,
             Eigen::VectorXd end)
{
    CurveMarch(curve, options, std::move(start), std::move(end)).run();
}

void joinMembers(CurveOfMotions& curve, const MarchOptions& options, const Eigen::VectorXd& start,
                 std::uint64_t seed)
{
    constexpr int attempts = 5;
    std::mt19937_64 generator(seed);
    for (int k = 0; k < attempts && !curve.isFinished(); ++k) {
        SolverResult landed = farEnd(curve, options.norm, std::ldexp(1.0, -k), start, generator);
        if (curve.isCancelled()) {
            return;
        }
        if (landed.status != SolverStatus::optimal) {
            curve.stop(fmt::format("the last point: {}", landed.detail));
            continue;
        }
        curve.restart();
        marchTo(curve, options, start, std::move(landed.x));
    }
}

}  // namespace signorini
