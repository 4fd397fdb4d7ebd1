#pragma once
/// \file
/// One contact of a forced, damped network, while its contact phase grows step by step.
///
/// While none of its contacts is closed a network's distance shrinks with the rate v^0 there, and a
/// push R_k in step k, once in each period of n steps, takes h_{m-k} R_k from it. In contact v = 0:
/// a Toeplitz system in the pushes, of which each longer contact is the next one, so all n_c of one
/// n follow from each other by Levinson's recursion. It runs on two pulse trains, the pushes b with
/// v = 1 in the last step of the contact and 0 before, f with 1 in the first and 0 afterwards, each
/// with the v of the whole period, which a shift in time only turns round:
///
///     R <- R + v_k b,   v <- v - v_k (h * b),   b <- (shifted b - beta f)/(1 - alpha beta), ...
///
/// Waves come back to a contact after sums of round trips, so h is 0 but for multiples of G = gcd(2
/// N_1, ..., 2 N_s, n), or 1 with springs and masses, and the steps of each residue mod G have a
/// system of their own, all with the same h. Where waves can rest beside a contact that is held,
/// the systems become singular before the end, at 1 - alpha beta = 0: what is left of b is a push
/// that moves the distance nowhere in the period, of any size z, and so is it in each later step.
/// Other contacts stay open: their distances are carried along. docs/theory.md, section 19.

#include <array>
#include <complex>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "forced_line.hpp"

namespace signorini {

/// How the distance at one contact shrinks while all are open; units of the network.
struct ClosingContact {
    double gap = 0.0;                   ///< at rest, of any sign
    std::complex<double> driven = 0.0;  ///< v in step 0 under a cosine of size 1; the sine is later
                                        ///< by a quarter
    /// Taken from v in the steps offset + i G by a push of 1 at the growing contact in step 0.
    std::vector<double> byPush = {};
    std::int64_t offset = 0;
    double compliance = 0.0;  ///< by which a constant push of 1 widens it
};

/// What is known of a period.
struct ContactPeriod {
    std::int64_t steps = 0;   ///< n
    std::int64_t cycles = 1;  ///< K; 0: `driven` is the same in all steps, and places mean nothing
    std::int64_t residues = 1;  ///< G
    double alone = 1.0;         ///< h of a push before waves return
    double usual = 0.0;         ///< largest v that the excitation alone would cause
    /// The one that grows, with offset 0, and those that stay open.
    std::vector<ClosingContact> contacts;
};

/// How much farther a contact of a period has opened at the beginning of step m by a push in step 0
/// of the one that grows, once in each period. O(n).
[[nodiscard]] std::vector<double> waysOf(const ContactPeriod& period,
                                         const ClosingContact& contact);

class GrowingContact {
public:
    /// n_c = 0. O(n contacts).
    explicit GrowingContact(ContactPeriod period);

    /// n_c + 1. O(n/G contacts). \pre n_c + 1 < n.
    void grow();
    [[nodiscard]] std::int64_t contact() const { return contact_; }

    /// Largest v^0 summed up, for a harmonic of size 1: how far the distance shrinks.
    [[nodiscard]] double linearPeak() const { return linearPeak_; }
    /// R in contact, 0 in flight.
    [[nodiscard]] Plane push(std::int64_t m) const { return push_[static_cast<std::size_t>(m)]; }
    /// v, 0 in contact but for rounding, if no base does work on waves that rest.
    [[nodiscard]] Plane speed(std::int64_t m) const
    {
        return speeds_.front()[static_cast<std::size_t>(m)];
    }
    /// By how much the distance has shrunk at the start of contact. O(n_c).
    [[nodiscard]] Plane place() const { return placeOf(0); }
    /// By how much pushes have widened it there. O(n_c).
    [[nodiscard]] Plane opened() const { return start_.front() - place(); }

    /// Pushes of any size that move the distance nowhere.
    [[nodiscard]] std::int64_t freePushes() const;
    /// What they add to R, with these sizes.
    [[nodiscard]] double freePush(std::int64_t m, std::span<const double> free) const;
    /// Does the distance change while the contact is open, for some (C, S)? O(n).
    [[nodiscard]] bool opens() const;

    /// Is v 0 in contact? If not, rounding spoils all that follows. O(n).
    [[nodiscard]] bool isClear() const;
    /// Does `line` say that there is no motion where it is empty? Always without free pushes; with
    /// some of them if rows scale with the excitation.
    [[nodiscard]] bool lineBounds() const;
    /// The line on which the distance is 0 at the start, and what the conditions leave of it; ends
    /// when nothing is left. With free pushes the conditions are left out of the residues that have
    /// some and of other contacts, and free pushes do not push on average, the least there can be:
    /// its points need not be motions. O(n contacts). \pre isClear().
    [[nodiscard]] ForcedLine line();
    /// All conditions, the distance at the start the first; free amplitudes are the z. O(n +
    /// entries).
    [[nodiscard]] std::vector<ForcedRow> rows() const;

private:
    /// A pulse train of one residue, and the v that it takes at each contact.
    struct Train {
        std::vector<double> push;
        std::vector<std::vector<double>> speeds;  ///< by contact, at offset + i G
    };

    [[nodiscard]] std::size_t index(std::int64_t m) const
    {
        return static_cast<std::size_t>(m % period_.steps);
    }
    [[nodiscard]] Plane placeOf(std::size_t contact) const;
    [[nodiscard]] Train trainOf(std::vector<double> push) const;
    void lengthen(std::int64_t contact);
    void endRecursion(std::int64_t contact, Train train, double usual);
    void setFree(std::int64_t contact, Train train);
    [[nodiscard]] std::vector<double> waysOfFree(std::size_t contact) const;
    /// Free pushes of a residue, and of those before it, which are numbered first. O(1).
    [[nodiscard]] std::int64_t freeOf(std::int64_t residue) const;
    [[nodiscard]] std::int64_t freeBefore(std::int64_t residue) const;
    /// action(k, R of free push k = 1) for those that press in step m.
    template <typename Action>
    void forEachFree(std::int64_t m, Action action) const;
    [[nodiscard]] Plane farthestPlace() const;
    void measure();

    ContactPeriod period_;
    std::int64_t members_;  ///< n/G
    std::int64_t contact_ = 0;
    std::int64_t fixed_;  ///< most contact steps of a residue whose pushes are fixed
    bool isRegular_ = true;
    double linearPeak_ = 0.0;
    double scale_ = 0.0;                      ///< of numbers that are 0 but for rounding
    std::vector<Plane> push_;                 ///< R
    std::vector<std::vector<Plane>> speeds_;  ///< v, by contact
    std::vector<Plane> start_;                ///< shrunk at the start of contact by v^0, by contact
    /// By contact: how much farther it has opened at the beginning of step m by a push in step 0.
    std::vector<std::vector<double>> ways_;
    Train first_;                   ///< f
    Train last_;                    ///< b
    std::vector<double> freePush_;  ///< that moves nothing, of a contact of fixed_ + 1 steps
    std::array<std::optional<ForcedCondition>, 2> lastRows_;  ///< of the last line
};

}  // namespace signorini
