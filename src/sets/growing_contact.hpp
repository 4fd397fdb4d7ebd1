#pragma once
/// \file
/// A forced, damped bar of several segments whose one contact phase grows step by step.
///
/// Without stops the tip has the velocity v^0, and a push R_k of the wall in step k, once in each
/// period of n steps, takes h_{m-k} R_k from it. In contact v = 0: a Toeplitz system in the pushes,
/// of which each longer contact is the next one, so all n_c of one n follow from each other by
/// Levinson's recursion. It runs on two pulse trains, the pushes b with v = 1 in the last step of
/// the contact and 0 before, f with 1 in the first and 0 afterwards, each with the v of the whole
/// period, which a shift in time only turns round:
///
///     R <- R + v_k b,   v <- v - v_k (h * b),   b <- (shifted b - beta f)/(1 - alpha beta), ...
///
/// Waves come back to the tip after sums of 2N_i steps, so h is 0 but for multiples of
/// G = gcd(2N_1, ..., 2N_s, n), and the steps of each residue mod G have a system of their own, all
/// with the same h. Where waves can rest beside a tip that is held, the systems become singular
/// before the end, at 1 - alpha beta = 0: what is left of b is a push that moves the tip nowhere in
/// the period, of any size z, and so is it in each later step. docs/theory.md, section 19.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "forced_line.hpp"
#include "signorini/simulation.hpp"
#include "stepped_bar.hpp"

namespace signorini {

class GrowingContact {
public:
    /// A harmonic of so many cycles in n steps, n_c = 0. O(n segments + (n/G)^2).
    GrowingContact(const SteppedBar& bar, double eta, Excited place, std::int64_t cycles,
                   std::int64_t steps);

    /// n_c + 1. O(n/G). \pre n_c + 1 < n.
    void grow();
    [[nodiscard]] std::int64_t contact() const { return contact_; }

    /// Largest u(L) without stops, for a harmonic of size 1 [g].
    [[nodiscard]] double linearPeak() const { return linearPeak_; }
    /// R in contact, 0 in flight.
    [[nodiscard]] Plane push(std::int64_t m) const { return push_[static_cast<std::size_t>(m)]; }
    /// v, 0 in contact but for rounding, if no base does work on waves that rest.
    [[nodiscard]] Plane speed(std::int64_t m) const { return speed_[static_cast<std::size_t>(m)]; }
    /// u(L, 0) [g]. O(n_c).
    [[nodiscard]] Plane tip() const;

    /// Pushes of any size that move the tip nowhere.
    [[nodiscard]] std::int64_t freePushes() const;
    /// What they add to R, with these sizes.
    [[nodiscard]] double freePush(std::int64_t m, std::span<const double> free) const;

    /// The line u(L, 0) = g and what the conditions leave of it; ends when nothing is left. None if
    /// rounding spoils it: v is not 0 in contact. With free pushes the conditions are left out of
    /// the residues that have some, and these do not push on average, the least there can be: then
    /// it is empty only if there is no motion, but its points need not be motions. O(n).
    [[nodiscard]] std::optional<ForcedLine> line();
    /// All conditions, u(L, 0) = g the first; free amplitudes are the z. O(n + entries).
    [[nodiscard]] std::vector<ForcedRow> rows() const;

private:
    /// A pulse train of one residue and the velocities that it causes.
    struct Train {
        std::vector<double> push;
        std::vector<double> speed;
    };

    void setLinear(Excited place, std::int64_t cycles);
    void setKernels();
    void lengthen(std::int64_t contact);
    void setFree(std::int64_t contact, std::vector<double> push);
    /// Free pushes of a residue, and of those before it, which are numbered first. O(1).
    [[nodiscard]] std::int64_t freeOf(std::int64_t residue) const;
    [[nodiscard]] std::int64_t freeBefore(std::int64_t residue) const;
    /// action(k, R of free push k = 1) for those that press in step m.
    template <typename Action>
    void forEachFree(std::int64_t m, Action action) const;
    [[nodiscard]] Plane highestTip() const;
    /// Of numbers that are 0 but for rounding.
    [[nodiscard]] double scale() const;

    const SteppedBar& bar_;
    double eta_;
    std::int64_t steps_;
    std::int64_t residues_;
    std::int64_t members_;  ///< n/G
    std::int64_t contact_ = 0;
    std::int64_t fixed_;  ///< most contact steps of a residue whose pushes are fixed
    bool isRegular_ = true;
    double usual_ = 0.0;  ///< v that a wave of the excitation alone would cause
    double linearPeak_ = 0.0;
    double compliance_ = 0.0;          ///< u(L) of a constant force of 1
    std::vector<Plane> push_;          ///< R
    std::vector<Plane> speed_;         ///< v
    Plane tip_;                        ///< u(L, 0) without stops
    std::vector<double> speedOfPush_;  ///< h of one residue
    std::vector<double> tipOfPush_;  ///< u(L) at the beginning of step m, of a push of -1 in step 0
    Train first_;                    ///< f
    Train last_;                     ///< b
    std::vector<double> freePush_;   ///< that moves nothing, of a contact of fixed_ + 1 steps
    std::array<std::optional<ForcedCondition>, 2> lastRows_;  ///< of the last line
};

}  // namespace signorini
