#include "harmonic_complete.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "harmonic_discs.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using std::numbers::pi;

constexpr double narrowest = 1e-11;   // [rad]
constexpr double sampledBelow = 0.1;  // [rad]: a wider part is not looked at along its motion
constexpr double insideOfBox = 0.9;   // of it, whatever is rounded
constexpr double slack = 1e-12;       // of an angle

Disc conjugate(const Disc& z)
{
    return {std::conj(z.middle), z.radius};
}

/// z/|z|; everything if z may be 0.
Disc unitOf(const Disc& z)
{
    const Interval size = z.magnitude();
    const double middle = 0.5 * (size.low + size.high);
    return z / Disc(middle, (size.high - size.low) * 0.5 + slack * middle);
}

/// A part of the range of an angle.
struct Part {
    double low;
    double high;

    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    [[nodiscard]] double width() const { return high - low; }
};

/// e^{i angle} of all angles.
Disc turn(const Part& angle)
{
    return HarmonicDiscs::turn(angle.middle(), (0.5 + slack) * angle.width());
}

/// Of a number of cells of contact.
struct EnclosedChain {
    std::vector<Disc> waves;  ///< kappa, cell by cell
    Disc sum;                 ///< of kappa e^{i omega m h} over the w cells of 2L/c
};

/// Contact for j cells and theta of the next one, where A is.
struct Candidate {
    std::int64_t cells;
    Part theta;
    Disc excitation;
    Stop stop;
    bool isPinned;
};

class Completeness {
public:
    Completeness(const HarmonicCase& given, std::span<const ProvedHarmonic> known)
        : given_(given), discs_(given), known_(known), cell_(given.omega * given.step)
    {
        for (std::int64_t m = 0; m <= given.cells; ++m) {
            turns_.emplace_back(given.inCells(m), HarmonicDiscs::angleError);
        }
    }

    HarmonicCompleteness run(const Cancel& cancel)
    {
        if (given_.cells + given_.back > mostCompleteCells) {
            return {std::nullopt, "its period has too many cells", rests()};
        }
        late_ = chainOf(0);
        for (std::int64_t j = 0; j + 1 < given_.cells; ++j) {
            early_ = chainOf(j + 1);
            for (const Stop stop : {Stop::right, Stop::left}) {
                if (stop == Stop::right || given_.stops.left) {
                    lookAtSmooth(j, stop);
                    lookAtPinned(j + 1, stop);
                }
            }
            if (!why_.empty() || isRequested(cancel)) {
                return {std::nullopt, why_.empty() ? "stopped" : why_, rests()};
            }
            late_ = std::move(early_);
        }
        return {fliesLonger() ? 0.0 : given_.step, {}, rests()};
    }

private:
    [[nodiscard]] std::size_t index(std::int64_t m) const
    {
        return static_cast<std::size_t>(m % given_.cells);
    }
    [[nodiscard]] const Disc& turnOf(std::int64_t m) const { return turns_[index(m)]; }

    [[nodiscard]] EnclosedChain chainOf(std::int64_t contact) const
    {
        EnclosedChain chain{discs_.waves([contact](std::int64_t m) { return m < contact; }), {}};
        for (std::int64_t m = 0; m < given_.back; ++m) {
            chain.sum = chain.sum + chain.waves[index(m)] * turnOf(m);
        }
        return chain;
    }

    /// Is there no motion that flies for less than h? late_ is the chain that flies in one cell.
    [[nodiscard]] bool fliesLonger() const
    {
        if (given_.isForce || given_.cycles % given_.cells != 0) {
            return true;
        }
        const Interval speed = Interval(given_.admittance()) * Interval(given_.amplitude) *
                               discs_.push(late_.waves.back()).magnitude();
        const Interval least =
            speed * Interval(0.25 * given_.step / static_cast<double>(given_.cells));
        const double left = given_.stops.left ? -given_.placeOf(Stop::left) : infinity;
        return (Interval(std::min(given_.placeOf(Stop::right), left)) - least).isPositive();
    }

    [[nodiscard]] std::optional<bool> rests() const
    {
        const std::int64_t phases = given_.cells / std::gcd(given_.cycles, given_.cells);
        if (!given_.isForce && phases == 1) {
            return false;  // what the base sends adds up
        }
        const double part = pi / static_cast<double>(phases);
        const auto sine = [](double angle) {
            const double error = HarmonicDiscs::angleError * std::max(1.0, angle);
            return Interval(portable::sin(angle)) + Interval(-error, error);
        };
        Interval least = Interval(given_.amplitude) * sine(part) / Interval(part).widened();
        if (!given_.isForce) {
            least = least * Interval(given_.omega) / sine(given_.omega).magnitude();
        }
        bool isClear = true;
        for (const Stop stop : {Stop::right, Stop::left}) {
            if (stop == Stop::right || given_.stops.left) {
                const double side = stop == Stop::right ? 1.0 : -1.0;
                const Interval spare = Interval(-side * given_.placeOf(stop)) - least;
                if (spare.isPositive()) {
                    return true;
                }
                isClear = isClear && spare.isNegative();
            }
        }
        return isClear ? std::optional(false) : std::nullopt;
    }

    /// R(tau) = 0: A e^{i theta} is one of two numbers.
    void lookAtSmooth(std::int64_t j, Stop stop)
    {
        const Disc alpha =
            discs_.place() - (turnOf(1) * late_.sum - early_.sum) * discs_.integrate();
        const Disc beta = (late_.sum - early_.sum) * discs_.integrate();
        const Disc release = conjugate(unitOf(discs_.push(early_.waves[index(j)]))) *
                             conjugate(turnOf(j)) *
                             Disc(HarmonicCase::Complex(0.0, given_.amplitude));
        for (const double sign : {1.0, -1.0}) {
            const Disc atRelease = Disc(sign) * release;
            refute({0.0, cell_ * (1.0 + slack)}, [&](const Part& theta) {
                const Disc excitation = atRelease * conjugate(turn(theta));
                const Interval gap = (alpha * excitation + beta * atRelease).real();
                return isApart(gap, stop) ||
                       isSettled({j, theta, excitation, stop, false}, theta.width());
            });
        }
    }

    /// tau = jh, early_ that of j cells: A has any argument, R passes through 0 there.
    void lookAtPinned(std::int64_t j, Stop stop)
    {
        const Disc gap = discs_.place() - early_.sum * (turnOf(1) - Disc(1.0)) * discs_.integrate();
        const double side = stop == Stop::right ? 1.0 : -1.0;
        const Disc before = Disc(side) * discs_.push(early_.waves[index(j - 1)]) * turnOf(j);
        const Disc after = Disc(side) * discs_.push(early_.waves[index(j)]) * turnOf(j);
        refute({0.0, 2.0 * pi * (1.0 + slack)}, [&](const Part& angle) {
            const Disc excitation = Disc(given_.amplitude) * turn(angle);
            return isApart((gap * excitation).real(), stop) ||
                   (before * excitation).real().isNegative() ||
                   (after * excitation).real().isPositive() ||
                   isSettled({j, {0.0, 0.0}, excitation, stop, true}, angle.width());
        });
    }

    /// Halves a range until a part is settled.
    template <typename Test>
    void refute(const Part& range, const Test& test)
    {
        std::vector<Part> parts{range};
        while (!parts.empty() && why_.empty()) {
            const Part part = parts.back();
            parts.pop_back();
            if (test(part)) {
                continue;
            }
            if (part.width() < narrowest) {
                why_ = "a candidate is neither seen to be wrong nor one of the motions";
            }
            parts.push_back({part.low, part.middle()});
            parts.push_back({part.middle(), part.high});
        }
    }

    [[nodiscard]] bool isApart(const Interval& gap, Stop stop) const
    {
        const Interval missed = gap - Interval(given_.placeOf(stop));
        return missed.isPositive() || missed.isNegative();
    }

    [[nodiscard]] bool isSettled(const Candidate& one, double width) const
    {
        return width < sampledBelow && (isKnown(one) || isWrong(one));
    }

    [[nodiscard]] bool isKnown(const Candidate& one) const
    {
        return std::any_of(known_.begin(), known_.end(), [&](const ProvedHarmonic& proved) {
            const HarmonicContact& contact = proved.motion->contacts.front();
            const double box = insideOfBox * proved.aloneWithin;
            const double whole = static_cast<double>(one.cells) * given_.step;
            const auto isNear = [&](double theta) {
                return std::abs(whole + theta / given_.omega - contact.end) < box;
            };
            return contact.stop == one.stop && contact.isPinned == one.isPinned &&
                   isNear(one.theta.low) && isNear(one.theta.high) &&
                   (one.excitation * HarmonicDiscs::turn(proved.motion->phase) -
                    Disc(given_.amplitude))
                           .magnitude()
                           .high < box * given_.amplitude;
        });
    }

    /// Is a push seen to be a pull, or the tip to be beyond a stop?
    [[nodiscard]] bool isWrong(const Candidate& one) const
    {
        const double side = one.stop == Stop::right ? 1.0 : -1.0;
        Interval tip = given_.placeOf(one.stop);
        for (std::int64_t m = 0; m < given_.cells; ++m) {
            const Disc cut = turnOf(m) * turn(one.theta);
            for (const bool isLate : {false, true}) {
                if (one.isPinned && !isLate) {
                    continue;  // no length
                }
                const EnclosedChain& chain = isLate && !one.isPinned ? late_ : early_;
                const Disc force = discs_.push(chain.waves[index(m)]) * one.excitation;
                const Disc way = Disc(given_.admittance()) * force * discs_.integrate();
                const bool isHeld = isLate ? m < one.cells : m <= one.cells;
                const Disc start = isLate ? cut : turnOf(m);
                const Disc end = isLate ? turnOf(m + 1) : cut;
                const auto isFault = [&](const Disc& now) {
                    return isHeld ? (Disc(side) * force * now).real().isNegative()
                                  : isBeyond(tip + (way * (now - start)).real());
                };
                // So much later push or place is extreme, if it is before the end.
                const double turns = -angleOf((isHeld ? force : way).middle * start.middle);
                const double later = turns - pi * std::floor(turns / pi);
                const double length = isLate ? cell_ - one.theta.high : one.theta.low;
                if (isFault(start) || isFault(end) ||
                    (later < (1.0 - slack) * length &&
                     isFault(start * HarmonicDiscs::turn(later)))) {
                    return true;
                }
                if (!isHeld) {
                    tip = tip + (way * (end - start)).real();
                }
            }
        }
        return false;
    }

    [[nodiscard]] bool isBeyond(const Interval& tip) const
    {
        return (tip - Interval(given_.placeOf(Stop::right))).isPositive() ||
               (given_.stops.left && (tip - Interval(given_.placeOf(Stop::left))).isNegative());
    }

    const HarmonicCase& given_;
    HarmonicDiscs discs_;
    std::span<const ProvedHarmonic> known_;
    double cell_;  ///< [rad], omega h
    std::vector<Disc> turns_;
    EnclosedChain early_;  ///< before theta in each cell
    EnclosedChain late_;   ///< after it
    std::string why_;
};

}  // namespace

HarmonicCompleteness complete(const HarmonicCase& given, std::span<const ProvedHarmonic> known,
                              const Cancel& cancel)
{
    return Completeness(given, known).run(cancel);
}

}  // namespace signorini
