#include "harmonic_growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "portable.hpp"

namespace signorini {

namespace {

constexpr double faded = 1e-12;          // of a front
constexpr double sameGrowth = 2e-3;      // of all orders
constexpr std::size_t mostTerms = 2000;  // of the equation

/// Are all zeros of lambda^n + a_1 lambda^{n-1} + ... within |lambda| < 1? Schur and Cohn.
bool isContracting(std::vector<double> a)
{
    for (std::size_t m = a.size() - 1; m > 0; --m) {
        const double k = a[m];
        if (!(std::abs(k) < 1.0)) {
            return false;
        }
        std::vector<double> shorter(m);
        for (std::size_t i = 0; i < m; ++i) {
            shorter[i] = (a[i] - k * a[m - i]) / (1.0 - k * k);
        }
        a = std::move(shorter);
    }
    return true;
}

/// Largest |lambda| of 1 + c_1/lambda + ... = 0, or `low`.
double largest(const std::vector<double>& c, double low)
{
    double high = 64.0;
    while (high - low > 1e-7 * high) {
        const double middle = 0.5 * (low + high);
        std::vector<double> scaled = c;
        double power = 1.0;
        for (double& term : scaled) {
            term *= power;
            power /= middle;
        }
        (isContracting(std::move(scaled)) ? high : low) = middle;
    }
    return high;
}

/// One front on its way, on the cells of its motion.
class Front {
public:
    Front(const Damping& damping, const Harmonic& excitation, const HarmonicMotion& motion)
        : rho_(damping.rho())
    {
        const std::int64_t twoCrossings =
            2 * static_cast<std::int64_t>(excitation.stepsPerCrossing);
        const std::int64_t common = std::gcd(twoCrossings, excitation.steps);
        back_ = twoCrossings / common;
        cells_ = excitation.steps / common;
        const double cell = motion.extremes.period / static_cast<double>(cells_);
        place_ = motion.extremes.contactTime / cell;
        if (motion.isPinned) {
            pin_ = std::llround(place_);
            setJump(excitation, motion);
        }
    }

    /// The largest growth with old fronts before the newest, or after it, at the release and at the
    /// beginning of contact; none if they fade too slowly.
    [[nodiscard]] std::optional<double> growth(bool isLateAtRelease, bool isLateAtContact) const
    {
        const double before = isLateAtRelease ? before_ : after_ - jump_;
        const double after = std::abs(isLateAtRelease ? before_ + jump_ : after_);
        const double mu = (before - rho_ * after) / (before + after);
        std::vector<double> terms{1.0};
        double left = 1.0;
        bool isNew = true;
        std::int64_t visits = 0;  // so far
        for (std::int64_t s = 1; std::abs(left) > faded; ++s) {
            if (terms.size() > mostTerms) {
                return std::nullopt;
            }
            for (; visits < s * cells_ / back_; ++visits) {
                const std::int64_t m = (visits + 1) % cells_ * back_ % cells_;
                if (m == 0) {
                    left *= isLateAtContact ? 1.0 : -rho_;
                } else if (m != pin_) {
                    left *= through(m);
                } else {
                    left *= isNew ? mu : isLateAtRelease ? -rho_ : 1.0;
                    isNew = false;
                }
            }
            terms.push_back(left);
        }
        // Beside contacts, waves fade by themselves, by rho in each flight.
        const double flights = std::floor(static_cast<double>(cells_) - place_);
        return largest(terms, portable::pow(rho_, flights / static_cast<double>(back_)));
    }

private:
    [[nodiscard]] double through(std::int64_t m) const
    {
        return static_cast<double>(m) < place_ ? 1.0 : -rho_;
    }

    /// The push on both sides of the release, and what the newest front adds to it there.
    void setJump(const Harmonic& excitation, const HarmonicMotion& motion)
    {
        const double time = motion.extremes.contactTime;
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(excitation.cycles) *
                             time / motion.extremes.period;
        const std::complex<double> turn(portable::cos(angle), portable::sin(angle));
        const auto next = std::find_if(
            motion.pieces.begin(), motion.pieces.end(),
            [&](const auto& piece) { return piece.end > time + 1e-9 * motion.extremes.period; });
        const double force = excitation.place == Excited::tip
                                 ? excitation.amplitude * portable::cos(angle - motion.phase)
                                 : 0.0;
        before_ = force + 2.0 * (std::prev(next)->wave * turn).real();
        after_ = force + 2.0 * (next->wave * turn).real();
        jump_ = 2.0 * motion.extremes.approachSpeed;
        for (std::int64_t m = back_ % cells_; m != pin_; m = (m + back_) % cells_) {
            jump_ *= through(m);
        }
    }

    double rho_;
    std::int64_t back_ = 1;   ///< w
    std::int64_t cells_ = 1;  ///< nu
    double place_ = 0.0;      ///< of the release, in cells
    std::int64_t pin_ = -1;   ///< the same, where a front ends the contact
    double before_ = 1.0;     ///< push
    double after_ = -1.0;     ///< push
    double jump_ = -2.0;
};

}  // namespace

std::optional<double> growthOf(const Damping& damping, const Harmonic& excitation,
                               const HarmonicMotion& motion)
{
    const Front front(damping, excitation, motion);
    double least = 0.0;
    double most = 0.0;
    for (const bool isLateAtRelease : {false, true}) {
        for (const bool isLateAtContact : {false, true}) {
            const auto growth = front.growth(isLateAtRelease, isLateAtContact);
            if (!growth) {
                return std::nullopt;
            }
            least = most == 0.0 ? *growth : std::min(least, *growth);
            most = std::max(most, *growth);
        }
    }
    return most - least <= sameGrowth * most ? std::optional(most) : std::nullopt;
}

}  // namespace signorini
