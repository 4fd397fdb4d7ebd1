#pragma once
/// \file
/// The bar of the paper's problem statement, in SI units, and the scales that make it
/// dimensionless.
///
/// A bar of length L, clamped at x = 0, faces a rigid wall at distance g from its tip at rest.
/// Waves travel at c = sqrt(E/rho), equation (15). With lengths in L, displacements in g and times
/// in L/c the equations (30)-(32) lose every physical constant: this header is the only border
/// between metres and pure numbers.

#include <optional>

namespace signorini {

/// The bar and its wall.
struct Bar {
    double length = 1.0;          ///< [m], L
    double waveSpeed = 1.0;       ///< [m/s], c = sqrt(E/rho)
    double axialStiffness = 1.0;  ///< [N], Young's modulus times cross-section area, EA
    double gap = 1e-3;            ///< [m], g, distance from the tip at rest to the wall
    std::optional<double> young = std::nullopt;  ///< [Pa], E: turns strain into stress, if known

    friend bool operator==(const Bar&, const Bar&) = default;
};

/// A bar given by its material: c = sqrt(E/rho), EA = E * area.
/// Units: metre, pascal, kilogram per cubic metre, square metre, metre.
/// \throws std::invalid_argument naming each value that is not finite and positive.
[[nodiscard]] Bar barOfMaterial(double length, double young, double density, double area,
                                double gap);

/// Checks every field and every derived scale; reports all faults in one message.
/// Allowed: finite and positive, with g/L, c g/L, L/c and EA g^2/(2L) representable.
/// \throws std::invalid_argument with field, value and allowed range.
void validate(const Bar& bar);

/// What one dimensionless unit means in SI.
struct Scales {
    double displacement;  ///< [m], g
    double strain;        ///< [-], g/L
    double velocity;      ///< [m/s], c g/L
    double time;          ///< [s], L/c
    double energy;        ///< [J], E_1 = EA g^2/(2L), the energy unit of the paper's Fig. 1
    double frequency;     ///< [rad/s], omega_1 = pi c/(2L), first frequency of the free bar
};

/// The scales of a valid bar.
[[nodiscard]] Scales scales(const Bar& bar);

}  // namespace signorini
