#pragma once
/// \file
/// From (30)-(32) to a simplex or a box: the complete solution set of a one-phase schedule.
///
/// With the waves p that arrive at the tip, periodicity reads p_{m+2N} = sigma_m p_m, p n-periodic,
/// sigma = +1 in contact and -1 in free steps. Let G = gcd(2N, n). Shifting by 2N splits the n
/// steps into G classes m = alpha G + j of nu = n/G members. Once around a class p is multiplied by
/// (-1)^(free steps of the class): with an even count the class is live and carries one free
/// amplitude z_j, with an odd one p = 0 on it. The live classes are one block of d neighbours, and
/// all follow one sign pattern,
///
///     p_{alpha G + j} = epsilon_alpha z_j,   epsilon_{alpha + w} = sigma_alpha epsilon_alpha,
///
/// with w = 2N/G. Over a window of 2N steps epsilon adds up to `windowSum`; the gap row (31) says
/// windowSum * S = -N with S = sum z, N where the gap is negative, 0 where there is none. What
/// remains of (32):
///
/// - pressing (a live class touches the wall): every contact epsilon is +1, no prefix sum of
///   epsilon over the free blocks is positive, windowSum < 0 (gap < 0: > 0; no gap: 0). The set is
///   {z >= 0, sum z = S}; without a gap S is whatever one likes, and the set a cone.
/// - grazing (no live class does): nu is even and w odd, so epsilon alternates and windowSum = 1;
///   the set is the box -N <= Z_j <= 0, Z_d = S = -N. It is never empty: linear motions that touch
///   the wall without force. Around a tip at rest at the wall, or pressed on it, there are none.
///
/// docs/theory.md derives each step (sections 4-6, 17). Schedules are folded first (schedule.hpp).

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "signorini/amplitude_set.hpp"
#include "signorini/certificate.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What can be said of a schedule in a few integers: does it have a motion, and how many.
struct Verdict {
    std::int64_t cells = 0;               ///< [-], N
    int gapSign = 1;                      ///< [-], of the gap: 1, 0, -1
    std::int64_t classes = 0;             ///< [-], G
    std::int64_t members = 0;             ///< [-], nu, steps in a class
    std::int64_t window = 0;              ///< [-], w = 2N/G, blocks in a window of 2N steps
    std::int64_t contactMembers = 0;      ///< [-], contact steps in a live class
    std::int64_t firstLive = 0;           ///< [-], j of the first live class
    std::int64_t kernelDimension = 0;     ///< [-], d = dim ker(W - 1)
    std::int64_t windowSum = 0;           ///< [-], sum of epsilon over w blocks
    std::optional<Reason> reason;         ///< set exactly when the set is empty
    Contact contact = Contact::pressing;  ///< meaningful when the set is not empty
    AmplitudeSet set;                     ///< in z_j, j = firstLive .. firstLive + d - 1

    /// Does the motion of least energy press at every contact step of the schedule, because no
    /// class that touches the wall is dead? Then the schedule is the canonical one of its motion.
    [[nodiscard]] bool isCanonical() const;
};

/// The verdict and everything needed to write down each motion, or to prove that there is none.
struct OnePhaseSet : Verdict {
    Schedule schedule;               ///< the folded schedule that all counts refer to
    std::vector<std::int8_t> signs;  ///< epsilon_alpha, alpha = 0..nu-1 (empty if d = 0)
    std::int64_t worstBlock = -1;    ///< alpha of the largest prefix sum, when it is > 0
    std::int64_t worstPrefix = 0;    ///< [-], that sum
};

/// Decides a schedule. O(min(n, 12N)/G) steps on integers, one array of that many bytes; no heap
/// use at all when `result` is used again for a schedule that needs no more room. \throws
/// std::invalid_argument on an invalid schedule, more than one phase or a second stop.
void onePhaseSet(const Schedule& schedule, OnePhaseSet& result);

/// The same, returning a fresh object.
[[nodiscard]] OnePhaseSet onePhaseSet(const Schedule& schedule);

/// The verdict alone, for those who ask about millions of schedules: the walk along a class ends
/// at the first contradiction, which most schedules show within a few steps. `signs` is room to
/// work in, to be passed again. \pre the schedule is valid: `validate` holds for cells and phase.
[[nodiscard]] Verdict decide(std::int64_t cells, Phase phase, std::vector<std::int8_t>& signs,
                             int gapSign = 1);

/// [E_min, E_max]/E_1 over the whole set: 2w/N times the extremes of sum z^2, rounded once (where
/// N < 4e7), so that a double beyond an end is beyond it by as much. O(1).
/// A cone has all energies above 0. \throws std::invalid_argument if the set is empty.
[[nodiscard]] EnergyRange energyRange(const Verdict& verdict);

/// The state at t = 0 of the motion with the given amplitudes. O(N).
/// \throws std::invalid_argument if the set is empty, z has the wrong length, or z lies outside
/// the set by more than 1e-9 |S|.
[[nodiscard]] State motionOf(const OnePhaseSet& whole, std::span<const double> amplitudes);

/// The amplitudes nearest to any state: for each live class the mean of epsilon p over its w steps
/// in the window of 2N; those of a motion give it back. O(N).
/// \throws std::invalid_argument if the set is empty or the state has other cells.
[[nodiscard]] std::vector<double> amplitudesOf(const OnePhaseSet& whole, const State& state);

/// The state at t = 0 of the motion of least energy, z = S/d throughout; of a cone the flattest, of
/// some size. O(N), the time needed to
/// write 2N numbers. \throws std::invalid_argument if the set is empty.
[[nodiscard]] State leastEnergyMotion(const OnePhaseSet& whole);

/// The certificate that the closed form gives for a schedule without motion, in least integers. Its
/// rows exist in the original schedule as well as in the folded one. O(N + n/G).
/// `reason` names the first condition that fails; where several do, the certificate uses the rows
/// that prove absence most directly.
/// \throws std::invalid_argument if there are motions.
[[nodiscard]] FarkasCertificate proveAbsence(const OnePhaseSet& whole);

}  // namespace signorini
