#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "integers.hpp"
#include "mode_line.hpp"
#include "signorini/modes.hpp"

namespace signorini {

namespace {

/// The gaps between the 2a jumps, in order of position from t_c to T: gap r lasts alpha, or alpha
/// + t_c if it is wide, and epsilon is -1 in even ones. Jump 2i is followed by jump 2(i - Q), or
/// after a wide gap by 2(i - Q + 2a); jump 2a stands at t_c, and "jump 0" is T.
class Gaps {
public:
    Gaps(std::int64_t a, std::int64_t order)
        : count(2 * a), numerator(count - inverseOf(order, count)), index_(count)
    {
    }

    const std::int64_t count;      ///< 2a
    const std::int64_t numerator;  ///< Q: alpha = P T - 2Q with 2a P - |b| Q = 1

    /// i of the jump before the present gap.
    [[nodiscard]] std::int64_t index() const { return index_; }

    /// Steps over the present gap. \returns 1 if it is wide, else 0.
    std::int64_t next()
    {
        index_ -= numerator;
        if (index_ < 0) {
            index_ += count;
            return 1;
        }
        return 0;
    }

private:
    std::int64_t index_;
};

}  // namespace

std::vector<ModeJump> jumps(const Mode& mode)
{
    Gaps gaps(mode.a, -mode.b);
    std::vector<ModeJump> result;
    result.reserve(static_cast<std::size_t>(gaps.count));
    for (std::int64_t r = 0; r < gaps.count; ++r) {
        // Just below highest = 2 * 2a/|b|, 2i/T is just above i |b|/(2a).
        result.push_back({gaps.index(), gaps.index() * -mode.b / gaps.count});
        (void)gaps.next();
    }
    return result;
}

ModeMotion::ModeMotion(const Mode& mode, double period, double sag)
    : period_(period), gapSign_(mode.gapSign), sag_(sag)
{
    contactTime_ = signorini::contactTime(mode, period);
    contacts_.emplace_back(0.0, contactTime_);
    amplitude_ = 0.5 * gapSign_ / linear(mode.kappa, period, -mode.mu);
    Gaps gaps(mode.a, -mode.b);
    const std::int64_t p = (1 - gaps.numerator * mode.b) / gaps.count;
    const double alpha = linear(p, period, -2 * gaps.numerator);
    std::int64_t surplus = 0;
    for (const ModeJump& jump : jumps(mode)) {
        const bool isBeforeNegative = times_.size() % 2 == 0;
        times_.push_back(linear(-jump.turns, period, 2 * jump.k));
        const auto turns = static_cast<double>(1 - surplus);
        integrals_.push_back(isBeforeNegative ? turns * contactTime_
                                              : turns * contactTime_ - alpha);
        surplus += isBeforeNegative ? gaps.next() : -gaps.next();
    }
}

ModeMotion::Place ModeMotion::locate(double t) const
{
    double turns = std::floor(t / period_);
    double time = std::fma(-turns, period_, t);
    if (time < 0.0) {
        turns -= 1.0;
        time += period_;
    } else if (time >= period_) {
        turns += 1.0;
        time -= period_;
    }
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    return {turns, time, static_cast<std::size_t>(after - times_.begin())};
}

double ModeMotion::integral(double t) const
{
    const auto [turns, time, jumps] = locate(t);
    const double whole = turns * contactTime();
    if (jumps == 0) {
        return whole + time;
    }
    const double rest = time - times_[jumps - 1];
    return whole + integrals_[jumps - 1] + (jumps % 2 == 0 ? rest : -rest);
}

double ModeMotion::incoming(double t) const
{
    return locate(t).jumps % 2 == 0 ? amplitude_ : -amplitude_;
}

double ModeMotion::meanIncoming(double from, double to) const
{
    return amplitude_ * (integral(to) - integral(from)) / (to - from);
}

double ModeMotion::displacement(double x, double t) const
{
    return amplitude_ * (integral(t + 1.0 - x) - integral(t + 1.0 + x)) + sag_ * (2.0 - x) * x;
}

double ModeMotion::velocity(double x, double t) const
{
    return incoming(t + 1.0 - x) - incoming(t + 1.0 + x);
}

double ModeMotion::strain(double x, double t) const
{
    return -incoming(t + 1.0 - x) - incoming(t + 1.0 + x) + 2.0 * sag_ * (1.0 - x);
}

double ModeMotion::wallForce(double t) const
{
    const double time = locate(t).time;
    const auto after =
        std::upper_bound(contacts_.begin(), contacts_.end(), time,
                         [](double at, const auto& contact) { return at < contact.first; });
    return time < std::prev(after)->second ? 2.0 * amplitude_ : 0.0;
}

Extremes ModeMotion::extremes() const
{
    // The tip turns where p jumps.
    const double most = 2.0 * amplitude_;
    double least = 0.0;
    double atWall = 0.0;
    auto contact = contacts_.begin();
    for (std::size_t k = 0; k < times_.size(); ++k) {
        if (contact != contacts_.end() && times_[k] == contact->second) {
            atWall = integrals_[k];
            ++contact;
        }
        least = std::min(least, integrals_[k] - atWall);
    }
    // Strains are 0 and +-2h: both at the clamp; compression at the tip in contact. Tension comes
    // as near to the tip as two times with p < 0 are 2 apart: there where p jumps from + to - in
    // flight, which the two jumps of a = 1 do not; then they are 2 - t_c apart at most.
    const double strainAtClamp = 2.0 * sag_;
    const double fromTip = times_.size() > 2 ? 0.0 : 0.5 * contactTime();
    return {.period = period_,
            .contactTime = contactTime(),
            .peakForce = most,
            .impulse = most * contactTime(),
            .approachSpeed = most,
            .peakCompression = most + std::max(0.0, -strainAtClamp),
            .peakTension =
                sag_ < 0.0 ? std::max(0.0, most + strainAtClamp * fromTip) : most + strainAtClamp,
            .lowestTip = gapSign_ + sag_ + most * least};
}

State cellMeans(const ModeMotion& motion, std::int64_t cells)
{
    if (cells < 1 || cells > maxCells) {
        throwFault("cells", cells, fmt::format("1..{}", maxCells));
    }
    const auto end = [cells](std::int64_t i) {
        return static_cast<double>(i) / static_cast<double>(cells);
    };
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (std::int64_t i = 1; i <= cells; ++i) {
        state.a[i - 1] = motion.meanIncoming(1.0 - end(i), 1.0 - end(i - 1));
        state.b[i - 1] = -motion.meanIncoming(1.0 + end(i - 1), 1.0 + end(i));
    }
    return state;
}

}  // namespace signorini
