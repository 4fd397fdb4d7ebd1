#pragma once
/// \file
/// What moves a network harmonically, and a sweep of it. docs/theory.md, sections 16 and 20.

#include "faults.hpp"
#include "network_simulation.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

/// Is there something to excite: a driven node for a force (tip), a shaken clamp for the base?
[[nodiscard]] bool isExcitable(const Network& network, Excited place);

/// Adds a fault of "force" if there is not.
void requireExcitable(Faults& faults, const Network& network, Excited place);

/// A harmonic force or base, constant in each of the whole steps nearest to h that make a period.
struct HarmonicDrive {
    NetworkDrive drive;
    double period = 0.0;  ///< [h]
    double base = 0.0;    ///< [delta], where it has the shaken clamps at the start
};

/// cos(omega t - phase) with omega in 1/h, the amplitude in units of the network.
/// \throws std::invalid_argument naming the field where a period has fewer than 3 steps, or too
/// many.
[[nodiscard]] HarmonicDrive harmonicDrive(const Network& network, Excited place, double amplitude,
                                          double omega, double phase,
                                          std::string_view field = "frequency");

/// What moves it from a start: shaken clamps that stand elsewhere are led to their motion.
[[nodiscard]] NetworkDrive driveFrom(const Network& network, const NetworkStart& start,
                                     const HarmonicDrive& moved);

/// A sweep of a network over the frequency or the amplitude: as that of a bar (signorini/sweep.hpp)
/// from rest or with the state carried over. Numbers of the range and of the points are in units of
/// `bar`, whose first frequency is that of the network; the tip is the node of the first contact,
/// contacts and forces are those of all contacts.
struct NetworkSweep {
    const Network& network;
    const Bar& bar;
    const SweepRange& range;

    /// \throws std::invalid_argument on an end of the range that has no period, or a resolution too
    /// fine for it; before anything is followed or written.
    void require() const;
    /// The body that `sweep` follows. Refers to all of this.
    [[nodiscard]] SweepBody body() const;
};

}  // namespace signorini
