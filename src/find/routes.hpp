#pragma once
/// \file
/// The ways to an answer, in order of cost. Each answers or declines, and writes nothing else.

#include <optional>
#include <string>
#include <variant>

#include "request.hpp"

namespace signorini {

/// What a route says, before it is believed: a motion, that there is none, or why it cannot tell.
struct Claim {
    Provenance how;
    std::variant<State, Absence, std::string> answer;
};

/// What an exact route says that may not pass a request on.
inline constexpr const char* noExactAnswer =
    "the closed form knows no motion that meets these demands, and no proof that there is none: "
    "try solver auto";

/// Empty: declined.
using Route = std::optional<Claim> (*)(const Request&);

/// Several phases that nothing here can take.
[[nodiscard]] std::optional<Claim> refuseRoute(const Request& request);

/// One phase, by the exact set, O(N); limits on strain and tip are met by the motion of least
/// energy or by none.
[[nodiscard]] std::optional<Claim> closedFormRoute(const Request& request);

/// Several phases, by the exact sums.
[[nodiscard]] std::optional<Claim> sumsRoute(const Request& request);

/// Any demand, as a program for a back end.
[[nodiscard]] std::optional<Claim> programRoute(const Request& request);

/// Several phases with an energy to hold for which no back end finds a motion: one between the
/// motions of least and most energy.
[[nodiscard]] std::optional<Claim> heldEnergyRoute(const Request& request);

/// Does that route have a motion to offer?
[[nodiscard]] bool holdsEnergyInSums(const Request& request);

/// Verifies a claim: a motion by its residuals and demands, absence by its proof. What does not
/// hold becomes undecided. O(N + min(n, 12N)) for a motion.
[[nodiscard]] PeriodicResult accept(const Request& request, Claim claim);

}  // namespace signorini
