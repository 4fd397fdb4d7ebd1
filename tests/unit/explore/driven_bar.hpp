#pragma once
/// \file
/// A damped bar under an exact harmonic, as the closed form knows it, and the network that it is.

#include "harmonic_network.hpp"
#include "harmonic_settled.hpp"
#include "signorini/assembly.hpp"

namespace signorini::test {

struct DrivenBar {
    std::int64_t cells;
    std::int64_t steps;  ///< of a cycle
    Damping damping;
    Excited place;
    double amplitude;
    Stops stops = {};
    Scene scene = {};

    DrivenBar(std::int64_t n, std::int64_t cycle, double ratio, bool hasTwoStops, Excited driven,
              double size)
        : cells(n), steps(cycle), damping{.ratio = ratio}, place(driven), amplitude(size)
    {
        if (hasTwoStops) {
            stops.left = Fraction{2, 1};
            scene.secondStop = 2.0 * scene.bar.gap;
        }
    }
    /// As two segments that are equal.
    void halve() { scene.segments = {{cells / 2}, {cells - cells / 2}}; }

    [[nodiscard]] Harmonic excitation() const
    {
        return {place, amplitude, 0.0, 1, steps, static_cast<double>(cells)};
    }
    [[nodiscard]] HarmonicNetwork network(std::int64_t cycles = 1) const
    {
        const double unit = place == Excited::tip ? 1.0 : static_cast<double>(cells);
        return {networkOf(scene, cells, damping), place, unit * amplitude, cycles * steps, cycles};
    }
};

}  // namespace signorini::test
