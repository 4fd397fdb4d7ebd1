#include "signorini/one_phase_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include "echo.hpp"
#include "integers.hpp"

namespace signorini {

namespace {

/// A linear function of p_0 .. p_{2N-1} with integer coefficients.
using Functional = std::vector<std::int64_t>;

/// Multipliers of the gap row, of (32) and of the row of size whose combination vanishes on
/// ker(W - 1).
struct Combination {
    std::int64_t gap;
    std::int64_t size;
    std::vector<Multiplier> pressure;
    std::vector<Multiplier> penetration;
};

/// On the kernel the gap row is -windowSum * sum z, a pressure row of block alpha is
/// -epsilon_alpha z_j, the prefix row at the end of block alpha is prefix_alpha * sum z, and the
/// row of size is contactSum * sum z, contactSum adding up epsilon over contact. The row with a
/// right side, of the gap or of size, gets the sign that makes it negative.
class Combiner {
public:
    explicit Combiner(const OnePhaseSet& r) : r_(r) {}

    [[nodiscard]] Combination combine() const
    {
        const int gapSign = r_.gapSign;
        const std::int64_t lead = gapSign == 0 ? contactSum() : -gapSign * r_.windowSum;
        if (*r_.reason == Reason::noLiveClass || (gapSign == 0 && r_.contactMembers == 0)) {
            return withLead(1);
        }
        if (gapSign == 0 && *r_.reason == Reason::gap) {  // lead > 0: contacts agree
            Combination both = withLead(std::abs(r_.windowSum));
            both.gap = r_.windowSum > 0 ? -lead : lead;
            return both;
        }
        // `lead` times sum z has to vanish. If it is not positive, pressures of block 0 do it: with
        // a gap, such amplitudes move the tip away from the wall.
        if (lead <= 0) {
            return pressed(0, -lead);
        }
        if (*r_.reason == Reason::contactSign) {
            const auto negative = std::find(r_.signs.begin(), r_.signs.end(), std::int8_t{-1});
            return pressed(negative - r_.signs.begin(), lead);
        }
        const std::int64_t lastStep =
            r_.worstBlock * r_.classes + r_.firstLive + r_.kernelDimension - 1;
        const std::int64_t common = std::gcd(r_.worstPrefix, lead);
        Combination both = withLead(r_.worstPrefix / common);
        both.penetration = {{lastStep - r_.schedule.phases.front().contact, lead / common}};
        return both;
    }

private:
    /// The row with a right side alone.
    [[nodiscard]] Combination withLead(std::int64_t multiplier) const
    {
        return r_.gapSign == 0 ? Combination{0, -multiplier, {}, {}}
                               : Combination{-r_.gapSign * multiplier, 0, {}, {}};
    }

    [[nodiscard]] Combination pressed(std::int64_t alpha, std::int64_t multiplier) const
    {
        Combination both = withLead(1);
        if (multiplier == 0) {
            return both;
        }
        both.pressure.reserve(static_cast<std::size_t>(r_.kernelDimension));
        for (std::int64_t j = 0; j < r_.kernelDimension; ++j) {
            both.pressure.push_back({alpha * r_.classes + r_.firstLive + j, multiplier});
        }
        return both;
    }

    [[nodiscard]] std::int64_t contactSum() const
    {
        return std::accumulate(r_.signs.begin(),
                               r_.signs.begin() + static_cast<std::ptrdiff_t>(r_.contactMembers),
                               std::int64_t{0});
    }

    const OnePhaseSet& r_;
};

/// Writes out the combination as a functional of p_0 .. p_{2N-1}, before periodicity is used.
Functional expand(const Combination& combination, const Schedule& schedule)
{
    const std::int64_t size = 2 * schedule.cells;
    const Phase& phase = schedule.phases.front();
    Functional f(static_cast<std::size_t>(size), -combination.gap);
    for (std::int64_t m = 0; combination.size != 0 && m < phase.contact; ++m) {
        f[static_cast<std::size_t>(m % size)] += combination.size;
    }
    for (const Multiplier& m : combination.pressure) {
        f[static_cast<std::size_t>(m.row % size)] -= m.value;
    }
    for (const Multiplier& m : combination.penetration) {
        std::int64_t at = phase.contact % size;
        for (std::int64_t k = 0; k <= m.row; k += size) {  // one more echo with each turn
            const std::int64_t value = flightsFactor(k / size) * m.value;
            for (std::int64_t left = std::min(size, m.row + 1 - k); left > 0; --left) {
                f[static_cast<std::size_t>(at)] += value;
                at = at + 1 < size ? at + 1 : 0;
            }
        }
    }
    return f;
}

/// The signs of the p_{u+n} relative to the p_v, v = (u + n) mod 2N, that they come from: v is sent
/// back in flight once more if it arrives before the last turn ends.
class PeriodSigns {
public:
    explicit PeriodSigns(const Schedule& schedule)
        : size_(2 * schedule.cells),
          firstFree_(schedule.phases.front().contact % size_),
          lastVisit_((schedule.phases.front().free - 1) % size_),
          turns_((schedule.phases.front().free - 1) / size_)
    {
    }

    [[nodiscard]] std::int64_t operator()(std::int64_t v) const
    {
        const std::int64_t firstVisit = v >= firstFree_ ? v - firstFree_ : v - firstFree_ + size_;
        return flightsFactor(firstVisit <= lastVisit_ ? turns_ + 1 : turns_);
    }

private:
    std::int64_t size_;
    std::int64_t firstFree_;
    std::int64_t lastVisit_;
    std::int64_t turns_;
};

/// From f to y with sum_u y_u (p_{u+n} - p_u) + 2 f = 0. The permutation u -> u + n (mod 2N) has G
/// cycles; along one, y_v = sign_v y_u + 2 f_v with v = u + n, and the cycle closes because f
/// vanishes on the kernel (even cycles) or because 2 f is even (odd cycles).
Functional eliminate(Functional y, const OnePhaseSet& r)
{
    const auto size = static_cast<std::int64_t>(y.size());
    const std::int64_t stride =
        (r.schedule.phases.front().contact + r.schedule.phases.front().free) % size;
    const PeriodSigns sign(r.schedule);
    for (std::int64_t start = 0; start < r.classes; ++start) {
        // value = step(v, value) once around the cycle.
        const auto around = [&](std::int64_t value, auto step) {
            std::int64_t u = start;
            do {
                const std::int64_t v = u < size - stride ? u + stride : u + stride - size;
                value = step(v, value);
                u = v;
            } while (u != start);
            return value;
        };
        // From 0 an even cycle returns to 0; an odd one to c, and from c/2 it returns to c/2.
        const std::int64_t defect = around(0, [&](std::int64_t v, std::int64_t value) {
            std::int64_t& here = y[static_cast<std::size_t>(v)];
            return here = checkedAdd(sign(v) * value, checkedMultiply(2, here));
        });
        if (defect != 0) {
            around(defect / 2, [&](std::int64_t v, std::int64_t shift) {
                std::int64_t& here = y[static_cast<std::size_t>(v)];
                here = checkedAdd(here, sign(v) * shift);
                return sign(v) * shift;
            });
        }
    }
    return y;
}

/// Rows of (30) in the order of the unknowns a_1..a_N, b_1..b_N.
std::vector<Multiplier> inUnknowns(const Functional& y)
{
    const auto size = static_cast<std::int64_t>(y.size());
    std::vector<Multiplier> rows;
    rows.reserve(y.size() - static_cast<std::size_t>(std::count(y.begin(), y.end(), 0)));
    for (std::int64_t row = 0; row < size; ++row) {
        const Unknown step = unknownOf(row, size / 2);
        const std::int64_t value = step.sign * y[static_cast<std::size_t>(step.index)];
        if (value != 0) {
            rows.push_back({row, value});
        }
    }
    return rows;
}

}  // namespace

FarkasCertificate proveAbsence(const OnePhaseSet& whole)
{
    if (!whole.reason) {
        throw std::invalid_argument(
            "one phase: the schedule has motions, their absence has no proof");
    }
    Combination combination = Combiner(whole).combine();
    const Functional y = eliminate(expand(combination, whole.schedule), whole);
    FarkasCertificate certificate{.gap = 2 * combination.gap,
                                  .size = 2 * combination.size,
                                  .periodicity = inUnknowns(y),
                                  .pressure = std::move(combination.pressure),
                                  .penetration = std::move(combination.penetration)};
    for (auto* rows : {&certificate.pressure, &certificate.penetration}) {
        for (Multiplier& m : *rows) {
            m.value *= 2;
        }
    }
    divideByCommonFactor(certificate);
    return certificate;
}

}  // namespace signorini
