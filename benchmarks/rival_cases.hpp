#pragma once
/// \file
/// Bars whose motion is known in closed form, and what a march of one misses of it.

#include <functional>
#include <string>
#include <vector>

#include "record.hpp"
#include "schemes.hpp"

namespace signorini::bench {

/// The driven bar of theory.md, sections 15 and 21: a dashpot with this rho, a force [EA g/L] on
/// the tip, a period [L/c] that grids of 30, 60, ... cells have.
inline constexpr double drivenRho = 0.9;
inline constexpr double drivenForce = 0.25;
inline constexpr double drivenPeriod = 3.6;

/// One of them. Units L = EA = c = 1.
struct RivalCase {
    std::string name;
    MarchedBar bar;
    double period = 1.0;
    double reach = 1.0;                     ///< of the tip
    std::function<double(double)> tip;      ///< u(1), of time
    std::function<double(double)> impulse;  ///< of the wall until a time
    /// The same by the library, event by event; the figure is that of the excitation's steps in
    /// L/c.
    std::function<TimeSteps(int periods, int kept, std::int64_t perCrossing)> ours;
    bool isSampled = false;  ///< does that figure matter?
};

/// The paper's main mode; the bouncing bar of Doyen, Ern and Piperno (2011); the string of Cabannes
/// above a point obstacle; a damped bar under a harmonic force.
[[nodiscard]] const std::vector<RivalCase>& rivalCases();

/// Root mean square errors of tip (of its reach) and force (of its root mean square) over the
/// samples, and what became of the energy.
void judgeMarch(const RivalCase& one, const TimeSteps& steps, Record& record);

}  // namespace signorini::bench
