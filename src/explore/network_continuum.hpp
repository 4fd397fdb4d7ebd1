#pragma once
/// \file
/// Continua of bars in a row: curves of motions of one schedule and one energy.
///
/// What continuum.hpp does for one bar, for any network: curves by nonlinear programs
/// (curve_march.hpp) on a sphere cut by rows (network_section.hpp), members drawn along its great
/// circles. Each point is walked before it is kept (network_walk.hpp).

#include <functional>

#include "network_find.hpp"
#include "signorini/continuum.hpp"

namespace signorini {

/// What is asked of the curve. States are waves at the start, in the order of `Network::waves`.
struct NetworkCurveOptions {
    std::int64_t points = 201;
    std::optional<std::vector<double>> from = {};  ///< with `to` or `direction`
    std::optional<std::vector<double>> to = {};    ///< a path between two motions
    /// Half a great circle from there, along the faces met.
    std::optional<std::vector<double>> direction = {};
    bool isSample = false;  ///< members spread over the whole set
    std::uint64_t seed = 1;
    std::string solver = "auto";  ///< a back end that holds an energy; of a sample "closed-form"
    double resolution = 0.05;     ///< as ContinuumOptions
    double tolerance = 1e-7;
    Cancel cancel = {};
    std::function<void(double done, double total)> progress = {};
};

/// One motion of the curve.
struct NetworkCurvePoint {
    double lambda = 0.0;
    NetworkClaim motion = {};
    NetworkResiduals residuals = {};
    double energy = 0.0;  ///< recomputed [Z_1 delta^2/h]
};

/// The answer; invariants as of Continuum.
struct NetworkContinuum {
    Status status = Status::undecided;
    std::string detail = {};
    /// True: a curve joins the two given ends at this `resolution`. Empty: not known.
    std::optional<bool> connected;
    std::optional<std::int64_t> dimension;  ///< of the motions of this energy, if known
    std::optional<double> resolution;       ///< largest distance of neighbours, over that of rest
    std::string solver = "closed-form";     ///< who traced
    Parameter parameter = Parameter::arcLength;
    std::string family;
    double energy = 0.0;  ///< asked for [Z_1 delta^2/h]
    double unit = 1.0;    ///< E_1, or where there is none `energy`: lambda is in its root
    LeastMotion known;    ///< what is proved of the schedule
    std::vector<NetworkCurvePoint> points;
};

/// Traces motions of an energy [Z_1 delta^2/h].
/// \throws as `wishedMotion`; std::invalid_argument on ends that are no motions of this energy and
/// options out of range; BackendUnavailable.
[[nodiscard]] NetworkContinuum traceContinuum(const Network& network,
                                              const std::vector<ContactSpan>& schedule,
                                              double energy, const NetworkCurveOptions& options);

/// Which point is nearest to a lambda of the curve's range. \throws std::invalid_argument.
[[nodiscard]] std::size_t pointAt(const NetworkContinuum& curve, double lambda);

}  // namespace signorini
