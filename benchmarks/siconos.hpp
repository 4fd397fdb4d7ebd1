#pragma once
/// \file
/// A general code for nonsmooth mechanics on our bar: Siconos, if it is there.

#include <vector>

#include "signorini/motion.hpp"

namespace signorini::bench {

struct Sample {
    double time;    ///< [L/c]
    double tip;     ///< [g]
    double energy;  ///< [EA g^2/L]
};

struct TimeSteps {
    double seconds = 0.0;
    std::vector<Sample> samples;
};

/// What it is to march: linear elements, `steps` equal steps in a period, a dashpot and a force on
/// the tip.
struct SiconosRun {
    const State& state;
    int elements = 50;
    int steps = 175;
    double period = 3.5;  ///< [L/c]
    int periods = 1;
    double dashpot = 0.0;    ///< [EA/c], eta
    double amplitude = 0.0;  ///< [EA g/L], of a force cos(2 pi t/period - phase)
    double phase = 0.0;      ///< [rad]
};

/// \throws BackendUnavailable if no Python here has it, std::runtime_error if it ends too early.
[[nodiscard]] TimeSteps runSiconos(const SiconosRun& run);

}  // namespace signorini::bench
