#pragma once
/// \file
/// The bar of the paper's problem statement, in SI units, and the scales that make it
/// dimensionless.
///
/// A bar of length L, clamped at x = 0, faces a rigid wall at distance g from its tip at rest.
/// Waves travel at c = sqrt(E/rho), equation (15). With lengths in L, displacements in g and times
/// in L/c the equations (30)-(32) lose every physical constant: this header is the only border
/// between metres and pure numbers.
///
/// A `Scene` is a bar with all that may stand around it: a gap of any sign, a second stop, segments
/// of other material. Displacements are in |g|; where g = 0 nothing sets a length but the bar, and
/// they are in L.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace signorini {

/// The bar and its wall.
struct Bar {
    double length = 1.0;          ///< [m], L
    double waveSpeed = 1.0;       ///< [m/s], c = sqrt(E/rho)
    double axialStiffness = 1.0;  ///< [N], Young's modulus times cross-section area, EA
    /// [m], g, distance from the tip of the free bar to the wall; < 0: the bar at rest is pressed
    double gap = 1e-3;
    std::optional<double> young = std::nullopt;  ///< [Pa], E: turns strain into stress, if known

    friend bool operator==(const Bar&, const Bar&) = default;
};

/// A bar given by its material: c = sqrt(E/rho), EA = E * area.
/// Units: metre, pascal, kilogram per cubic metre, square metre, metre.
/// \throws std::invalid_argument naming each value that is not finite and positive, or a gap that
/// is not finite.
[[nodiscard]] Bar barOfMaterial(double length, double young, double density, double area,
                                double gap);

/// Checks every field and every derived scale; reports all faults in one message.
/// Allowed: finite and positive, a gap of any sign, with g/L, c g/L, L/c and EA g^2/(2L)
/// representable.
/// \throws std::invalid_argument with field, value and allowed range.
void validate(const Bar& bar);

/// What one dimensionless unit means in SI.
struct Scales {
    double displacement;  ///< [m], |g|; L where g = 0
    double strain;        ///< [-], displacement/L
    double velocity;      ///< [m/s], c displacement/L
    double time;          ///< [s], L/c
    double energy;        ///< [J], E_1 = EA g^2/(2L), the energy unit of the paper's Fig. 1
    double frequency;     ///< [rad/s], omega_1 = pi c/(2L), first frequency of the free bar
};

/// The scales of a valid bar.
[[nodiscard]] Scales scales(const Bar& bar);

/// Equal cells of one material; a wave crosses each in the same time.
struct Segment {
    std::int64_t cells = 0;  ///< [-], >= 1
    double impedance = 1.0;  ///< [-], Z relative to that of the first segment
    double speed = 1.0;      ///< [-], wave speed relative to that of the first segment
    double dashpot = 0.0;    ///< [-], at the joint after it, relative to the first impedance

    friend bool operator==(const Segment&, const Segment&) = default;
};

/// A bar, its stops, and what it is made of.
struct Scene {
    Bar bar = {};                                     ///< the first segment's material
    std::optional<double> secondStop = std::nullopt;  ///< [m], h > 0: a stop at u(L) = -h
    std::vector<Segment> segments = {};               ///< clamp first; empty: a uniform bar

    Scene() = default;
    /// A uniform bar that faces one wall.
    Scene(const Bar& uniform)
        : bar(uniform) {}  // NOLINT(google-explicit-constructor): a bar is one
    Scene(const Bar& first, std::optional<double> stop, std::vector<Segment> parts = {})
        : bar(first), secondStop(stop), segments(std::move(parts))
    {
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// \throws std::invalid_argument with field, value and allowed range: an invalid bar, a second stop
/// that does not leave the tip some way (g + h > 0), segments that are not positive.
void validate(const Scene& scene);

/// [m], by which the tip of a uniform bar sags under gravity g' [m/s^2], to the right: g' L^2/(2
/// c^2); at x the bar sags by (2 - x/L) x/L of that.
[[nodiscard]] double tipSag(const Bar& bar, double gravity);

/// What a uniform bar is about its rest under gravity g' [m/s^2], to the right: by its
/// sag the gap is smaller and a second stop farther, and all motions about it
/// are those without weight. \throws std::invalid_argument unless |g'| <= 10^6 c^2/L, where the tip
/// would rest at the second stop, or as `validate`. \pre it has no segments.
[[nodiscard]] Scene aboutRest(const Scene& scene, double gravity);

/// [N], what the bar at rest presses on the wall with: -g/sum(l_i/EA_i); 0 where there is a gap.
[[nodiscard]] double staticForce(const Scene& scene);

}  // namespace signorini
