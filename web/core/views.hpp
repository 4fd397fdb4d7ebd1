#pragma once
/// \file
/// What the page shows. Each function takes a question and asks the library; numbers are in the
/// library's scaled units: lengths in L, displacements in g, times in L/c, forces in EA g/L.

#include <string>

#include "reports.hpp"
#include "request.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::web {

/// A motion of a schedule: least energy, a held "energy", or a member of the continuum at "pause".
[[nodiscard]] Reply showSchedule(const Request& request);
/// A motion of a mode at any period: "contact" = 4a, "turns" = b, "period", "cells".
[[nodiscard]] Reply showMode(const Request& request);
/// A motion with two contacts of a polygon: "chains", "period", "split" of contact, "cells".
[[nodiscard]] Reply showPolygon(const Request& request);
/// A forced motion of a schedule: "damping", "place", "amplitude" [N or m], "which" 0 or 1.
[[nodiscard]] Reply showForced(const Request& request);
/// What the bar does from a pluck or from rest: see simulation.cpp.
[[nodiscard]] Reply showSimulation(const Request& request);

/// Families, modes and schedules that exist: "cells", "order", "energy".
[[nodiscard]] Reply showMap(const Request& request);
/// The polygons of motions with two contacts in (T, first contact): "order".
[[nodiscard]] Reply showPolygons(const Request& request);
/// The schedule of a family on a grid near the one asked for: "order", "nu", "blocks", "cells".
[[nodiscard]] Reply showFamily(const Request& request);
/// The next "count" frequencies of a response, from number "done" on.
[[nodiscard]] Reply showResponse(const Request& request);

/// The next value of a sweep over the frequency, "up" or "down": see sweeps.cpp.
[[nodiscard]] Reply showSweep(const Request& request);
/// Bars in a row with all that stands at them, in "words": see scenes.cpp.
[[nodiscard]] Reply showScene(const Request& request);

/// A file as the command line writes it: "name" of the motion or response "of" this question.
[[nodiscard]] Reply download(const Request& request);

// What views and files share.

[[nodiscard]] PeriodicResult found(const Request& request);
/// The continuum through the schedule's motions of an energy; the last one is kept.
[[nodiscard]] const Continuum& curveOf(const Schedule& schedule, double energyRatio);
[[nodiscard]] answers::ForcedAnswer forcedAnswer(const Request& request);
/// The response as far as it was asked for with `showResponse`.
[[nodiscard]] const cli::ResponseAnswer& responseOf(const Request& request);

/// A simulation and what the command line says of it.
struct Simulated {
    cli::SimulationAnswer answer;
    BarSimulation simulation;
    std::vector<double> impulses;  ///< on the wall, of each stretch [EA g/c]
};
/// Simulated as the command line does; its tip file needs the path of the tip.
[[nodiscard]] Simulated simulated(const Request& request, bool recordsTip = false);
/// The table from which a bar starts that is not at rest, as `simulate --from` reads it.
[[nodiscard]] std::string startTable(const Request& request);
/// "tip" or "base".
[[nodiscard]] Excited placeOf(const Request& request);
/// "amplitude" [N] or [m].
[[nodiscard]] double amplitudeOf(const Request& request);
/// The same, and damping, grid and frequencies "least" to "most".
[[nodiscard]] ResponseRange rangeOf(const Request& request);
/// The sweep as far as it was asked for with `showSweep`.
[[nodiscard]] const cli::SweepAnswer& sweepOf(const Request& request);

/// x, velocity and strain of a state, the initial values that are drawn.
void addState(Reply& reply, const State& state);

/// u at the nodes, s on the cells, force and initial state of a motion without a grid.
void addMode(Reply& reply, const ModeMotion& motion, std::int64_t cells);

/// Of "chains", "period" and "split".
[[nodiscard]] ModeMotion polygonMotion(const Request& request);
/// All polygons up to "order".
[[nodiscard]] answers::PolytopeList polygonsOf(const Request& request);

/// The mode "contact", "turns". \throws std::invalid_argument if there is none.
[[nodiscard]] Mode modeOf(const Request& request);

}  // namespace signorini::web
