#include "options.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "demand_names.hpp"
#include "excited_names.hpp"
#include "harmonic_motion.hpp"
#include "modes_answer.hpp"
#include "signorini/atlas.hpp"
#include "signorini/continuum.hpp"
#include "signorini/modes.hpp"
#include "signorini/response.hpp"
#include "signorini/schedule.hpp"

namespace signorini::answers {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr std::int64_t mostSteps = maxSteps / (2 * maxAtlasPhases);
constexpr unsigned driven = asks::response | asks::simulation | asks::sweep;

/// What it belongs to, how a value looks in the help, what it does, and what holds without it.
Option flag(std::string_view name, unsigned of, std::string_view sentence)
{
    return {name, of, Takes::nothing, "", "-", 0.0, 0.0, sentence, "", ""};
}

Option whole(std::string_view name, unsigned of, std::string type, std::int64_t low,
             std::int64_t high, std::string_view sentence, std::string_view usual = "",
             std::string_view field = "")
{
    return {name,
            of,
            Takes::whole,
            std::move(type),
            "-",
            static_cast<double>(low),
            static_cast<double>(high),
            sentence,
            usual,
            field};
}

Option positive(std::string_view name, unsigned of, std::string type, std::string_view unit,
                std::string_view sentence, std::string_view usual = "", std::string_view field = "",
                double below = unlimited)
{
    return {name, of, Takes::positive, std::move(type), unit, 0.0, below, sentence, usual, field};
}

Option real(std::string_view name, unsigned of, std::string type, std::string_view unit,
            std::string_view sentence, std::string_view usual = "", std::string_view field = "")
{
    return {name,       of,        Takes::real, std::move(type), unit,
            -unlimited, unlimited, sentence,    usual,           field};
}

Option range(std::string_view name, unsigned of, std::string type, std::string_view unit,
             double low, double high, std::string_view sentence, std::string_view usual = "",
             std::string_view field = "")
{
    return {name, of, Takes::range, std::move(type), unit, low, high, sentence, usual, field};
}

Option words(Takes takes, std::string_view name, unsigned of, std::string type,
             std::string_view sentence, std::string_view usual = "", std::string_view unit = "-",
             std::string_view field = "")
{
    return {name, of, takes, std::move(type), unit, 0.0, 0.0, sentence, usual, field};
}

Option choice(std::string_view name, unsigned of, std::string type, std::string_view sentence,
              std::string_view usual = "")
{
    return words(Takes::choice, name, of, std::move(type), sentence, usual);
}

Option text(std::string_view name, unsigned of, std::string type, std::string_view sentence,
            std::string_view usual = "", std::string_view unit = "-", std::string_view field = "")
{
    return words(Takes::text, name, of, std::move(type), sentence, usual, unit, field);
}

Option file(std::string_view name, unsigned of, std::string_view sentence,
            std::string type = "FILE.csv")
{
    return words(Takes::file, name, of, std::move(type), sentence);
}

Option figure(std::string_view name, unsigned of, std::string_view sentence)
{
    return words(Takes::ending, name, of, "FILE.svg|.png|.pdf", sentence);
}

/// What is asked of a motion of a schedule.
std::vector<Option> ofMotions()
{
    using namespace asks;
    return {
        text("--solver", schedule | period | freeNetwork, "NAME",
             "a back end listed by signorini --version", "auto"),
        choice("--formulation", schedule | period, namesIn(formulationNames),
               "unknowns of the problem", "auto"),
        choice("--objective", schedule | period | freeNetwork, namesIn(objectiveNames),
               "which motion of the set", "least energy; at a given energy, least peak strain"),
        file("--target", schedule | period | freeNetwork,
             "state to come nearest to: as --state writes it, or measured (columns x, velocity and "
             "strain or displacement); may be a pipe"),
        text("--period", period | forcedPeriod | network, "T",
             "in place of NC NF: all motions of this period, 7/2 or 3.5 L/c", "", "L/c"),
        text("--frequency", period | forcedPeriod | network, "W",
             "the same by frequency, 8/7 or 1.25 ω₁", "", "ω₁"),
        positive("--hertz", period | forcedPeriod | network, "F", "Hz",
                 "the same by frequency in Hz: that of the grid nearest to it"),
        positive("--energy-ratio", schedule | period | freeNetwork, "X", "E_1",
                 "hold E/E_1 = X: the motion of least peak compression; of several bars any one"),
        positive("--energy-ratio", continuum, "X", "E_1", "E/E_1 of every motion; this or"),
        positive("--energy", schedule | period | freeNetwork, "J", "J",
                 "hold the energy, in joules", "", "energyRatio"),
        positive("--energy", continuum, "J", "J", "their energy in joules", "", "energyRatio"),
        whole("--points", continuum, "M", 2, maxContinuumPoints, "motions along the curve", "201"),
        file("--from", continuum, "state to start from, as find --state writes it"),
        file("--to", continuum, "state to end at"),
        file("--direction", continuum, "or the direction to take from there, as a state file"),
        flag("--sample", continuum, "motions spread over the whole set instead of a curve"),
        whole("--seed", continuum, "K", 0, std::int64_t{1} << 62U,
              "join two members drawn at random; with --sample, which ones"),
        text("--engine", continuum, "auto|geometric|ipopt|nlopt",
             "method that traces the curve, or a back end", "auto", "-", "solver"),
        positive("--strain-limit", schedule | period | forced | forcedPeriod | continuum | network,
                 "S", "-", "strain >= -S everywhere, always"),
        positive("--resolution", continuum, "X", "-",
                 "largest distance between neighbours on a curve found by solvers, in √(E/E₁)",
                 "0.05"),
        real("--tip-floor", schedule | period, "M", "m", "lowest displacement of the tip"),
        positive("--tolerance", find | continuum, "X", "-", "largest relative residual", "1e-7"),
        positive("--time-limit", find, "S", "s", "for the solver"),
        real("--member", continuum, "LAMBDA", "lambda", "one motion of the curve, for --state"),
    };
}

/// What shakes a bar, and what is asked of that.
std::vector<Option> ofForce()
{
    using namespace asks;
    constexpr unsigned shaken = forced | forcedPeriod | driven;
    return {
        choice("--over", sweep, namesIn(sweptNames), "what is varied", "frequency"),
        range("--damping", shaken, "ZETA", "-", 0.0, maxDampingRatio,
              "damping ratio of the first mode, a dashpot at the tip", "", "damping ratio"),
        choice("--force", shaken | network, namesIn(excitedNames),
               "a harmonic force on the tip, or a moving base"),
        text("--amplitude", shaken | network, "A",
             "of the force in newtons, or of the base in metres", "", "N or m"),
        positive("--amplitude-velocity", shaken | network, "A", "m/s",
                 "or of the velocity of the base", "", "amplitude"),
        positive("--amplitude-acceleration", shaken | network, "A", "m/s^2",
                 "or of the acceleration of the base", "", "amplitude"),
        text("--frequency", simulation, "W", "frequency of the excitation, ω/ω₁", "", "omega_1",
             "frequencyRatio"),
        text("--frequency", sweep, "W",
             "frequency of the excitation, ω/ω₁, where another number is varied", "", "omega_1",
             "frequencyRatio"),
        positive("--hertz", simulation | sweep, "F", "Hz", "the same in Hz", "", "frequencyRatio"),
        real("--phase", simulation, "RAD", "rad", "of the excitation at the start, cos(ωt - phase)",
             "0"),
        text("--from", response, "W", "lowest frequency of the excitation, ω/ω₁", "0.5", "omega_1",
             "leastFrequencyRatio"),
        text("--from", sweep, "V", "lowest value: ω/ω₁ or Hz, N or m, m, or a ratio", "0.5 ω₁", "-",
             "least"),
        positive("--from-hertz", response, "F", "Hz", "the same in Hz", "", "leastFrequencyRatio"),
        positive("--from-hertz", sweep, "F", "Hz", "the same in Hz", "", "least"),
        text("--to", response, "W", "highest frequency of the excitation, ω/ω₁", "2", "omega_1",
             "mostFrequencyRatio"),
        text("--to", sweep, "V", "highest value", "2 ω₁", "-", "most"),
        positive("--to-hertz", response, "F", "Hz", "the same in Hz", "", "mostFrequencyRatio"),
        positive("--to-hertz", sweep, "F", "Hz", "the same in Hz", "", "most"),
        whole("--cycles", forced | forcedPeriod | network | response, "K", 1, maxForcedSteps / 2,
              "cycles of the excitation in a period of the motion", "1"),
        whole("--contacts", forcedPeriod | network, "K", 1, maxHarmonicContacts,
              "with --period, --frequency or --hertz: contacts in a period; of several the motion "
              "on which a bar at rest settles, or bars",
              "1"),
        whole("--contacts", response, "K", 1, 2,
              "largest number of contacts in a period; 2: also every schedule with two, each at "
              "its own amplitude, with --exact of bars that on which they settle from rest",
              "1"),
        flag("--exact", response,
             "the harmonic itself in place of a staircase, contacts of any times: all motions "
             "with one, and what a bar at rest settles on; curves with folds"),
        whole("--force-steps", response, "N", 1, maxCells,
              "with --exact and --figure: draw beside it what a staircase of N steps in L/c has"),
        positive("--band", response, "B", "-",
                 "largest relative deviation from the amplitude for motions with two contacts",
                 "0.05", "", 1.0),
    };
}

/// Simulations and sweeps.
std::vector<Option> ofSimulations()
{
    using namespace asks;
    return {
        file("--from", simulation, "state to start from, as find or simulate --state writes it"),
        flag("--rest", simulation, "start at rest (so without --from)"),
        positive("--time", simulation, "T", "s", "duration in seconds"),
        whole("--periods", simulation, "P", 1, 1'000'000'000,
              "or how many periods of the excitation"),
        whole("--points", sweep, "M", 1, maxSweepPoints, "how many values, at equal distances",
              "101"),
        flag("--up", sweep, "in ascending order only (both)"),
        flag("--down", sweep, "in descending order only (both)"),
        whole("--periods", sweep, "P", 1, maxSweepPeriods,
              "how many periods of the excitation at each value, at most", "1000"),
        flag("--rest", sweep,
             "start at rest at each value, in place of where the one before ended"),
        positive("--resolve", simulation | sweep, "S", "s",
                 "merge contacts no further apart, and average forces over S", "a step, L/(N c)",
                 "resolution"),
        file("--force-file", simulation,
             "force on the tip, or where a scene is driven: columns time [s], force [N]"),
        text("--force-range", simulation, "LO,HI",
             "what any force between these can do where a scene is driven, from rest [N]", "", "N"),
        text("--velocity", simulation, "V1,V2,...",
             "start undeformed, each bar with its own speed [m/s], from the left", "", "m/s",
             "velocity"),
    };
}

/// Lists of families and modes, and atlases.
std::vector<Option> ofLists()
{
    using namespace asks;
    return {
        text("--period", mode, "T", "in L/c: 3.14, 22/7 or 3; required", "", "L/c"),
        whole("--max-order", families, "W", 1, FamilyList::mostOrder,
              "only families of at most W blocks in 2 L/c", "12"),
        whole("--max-order", modes, "B", 1, maxModeOrder,
              "only contact times 4a + b T with |b| <= B", "25; with 3, 4, 5 contacts 9, 5, 3"),
        positive("--max-energy-ratio", families, "X", "E_1",
                 "only families with a motion of E/E_1 <= X", "all"),
        positive("--max-energy-ratio", modes, "X", "E_1", "only modes with a motion of E/E_1 <= X",
                 "50"),
        positive("--max-period", modes, "T", "L/c", "only modes with a motion of T <= X, in L/c",
                 "8, or 4 for each contact"),
        whole("--phases", modes, "K", 1, maxPolytopePhases, "motions with K contacts in a period",
              "1"),
        file("--database", atlas | atlasQuery, "the atlas, created if it does not exist; required",
             "FILE.sqlite"),
        whole("--max-contact", atlas, "NC", 1, mostSteps, "contact steps 1..NC", "2N"),
        whole("--max-free", atlas, "NF", 1, mostSteps, "free steps 1..NF", "4N"),
        whole("--phases", atlas, "K", 1, maxAtlasPhases, "schedules of 1..K contact phases", "1"),
        positive("--max-energy-ratio", atlas, "X", "E_1",
                 "keep schedules with motions of E <= X E_1", "all"),
        flag("--all", atlas, "also store the refuted schedules"),
        flag("--families-only", atlas, "store families only, no schedules"),
        flag("--resume", atlas, "continue an interrupted run"),
        flag("--resume", sweep | study, "go on with a run to the same --csv that was interrupted"),
        text("--near", atlasQuery, "W E", "query: families with motions near omega/omega_1, E/E_1"),
        positive("--within", atlasQuery, "X", "-", "how near, relative", "0.001"),
        text("--period", atlasQuery, "T", "query: families of this period, as 7/2 or 3.5 [L/c]", "",
             "L/c"),
        flag("--twins", atlasQuery, "query: different orbits of equal period and energy"),
        flag("--schedules", atlasQuery, "list the schedules of families as well"),
    };
}

/// What is written beside the answer, or said of it.
std::vector<Option> ofOutputs()
{
    using namespace asks;
    return {
        file("--events", simulation,
             "write all contacts: start, end, impulse, peak and mean force, speed, energy"),
        file("--statistics", simulation,
             "write how impacts are spread: rate, impulse, speed, energy turned over"),
        file("--tip", simulation, "write the path of the tip"),
        file("--csv", continuum,
             "write lambda, a_1..a_N, b_1..b_N, a row per motion; of several bars waves [m/s] and "
             "displacements of nodes [m]"),
        file("--csv", families, "write them as a table, one row per family"),
        file("--csv", modes, "write their curves: T, ω/ω₁, t_c and E/E₁ of motions along each"),
        file(
            "--csv", atlas | atlasQuery,
            "write the families, the bars of the plot, as a table; of segments and of several bars "
            "the schedules"),
        file("--csv", response, "write a row for each motion"),
        file("--csv", sweep, "write a row for each value and direction"),
        file("--csv", study, "write a row for each gap, damping and amplitude"),
        file("--map-csv", response,
             "write a row for each schedule that has motions of any amplitude"),
        file("--backbone-csv", response,
             "write the free motions of the modes, the curves behind the figure"),
        file("--state", schedule | period | forced | network | mode, "write the state at t = 0"),
        file("--state", continuum, "write the state of that motion at t = 0"),
        file("--state", simulation, "write the final state, which --from continues"),
        words(Takes::ending, "--motion", schedule | period | forced | forcedPeriod | network | mode,
              "FILE.csv|.vtk|.pvd",
              "write u, v, s over one period; .pvd: a time series for ParaView, of one bar"),
        figure("--figure", schedule | period | forced | forcedPeriod | network | mode,
               "draw the motion; of several bars u(x, t) and their contacts over a period"),
        figure("--figure", continuum, "draw the curve"),
        figure("--figure", families, "draw them as a periodic table, period against order"),
        figure("--figure", modes, "draw them, energy against frequency"),
        figure("--figure", atlas | atlasQuery, "draw the frequency-energy plot"),
        figure("--figure", response, "draw impulse and tip against frequency"),
        figure("--figure", simulation, "draw tip, contacts and force"),
        figure("--figure", sweep,
               "draw impulse and tip against the value, both directions; over the exact motions "
               "where the frequency is varied"),
        figure("--figure", study, "draw the worst impulse over the plane of amplitude and gap"),
        figure("--figure", scene, "draw it"),
        figure("--map", atlas | atlasQuery, "draw the existence map over contact and flight times"),
        figure("--map", response, "draw how many motions there are, amplitude against frequency"),
        figure("--bifurcation", sweep, "draw the impulse of each contact against the value"),
        words(Takes::ending, "--animate",
              schedule | period | forced | forcedPeriod | network | mode | continuum,
              "FILE.gif|.mp4", "draw it moving (needs gnuplot, and ffmpeg for .mp4)"),
        positive("--yield-stress",
                 schedule | period | forced | forcedPeriod | network | response | sweep, "PA", "Pa",
                 "warn where the stress exceeds it (needs --young)"),
        flag("--stability", schedule | period | forced | network,
             "perturb each motion to test its stability, of one bar undamped and with a damping "
             "ratio of 0.001"),
        flag("--stability", response, "perturb each motion to test its stability"),
        file("--certificate", schedule | forced | network,
             "write the proof that there is no motion, or of the least energy, for "
             "tools/check-certificate, or of a forced bar tools/check-forced",
             "FILE.json"),
    };
}

/// The scene, and how the answer is given.
std::vector<Option> ofAll()
{
    using namespace asks;
    return {
        text("--scene", all, "TEXT|FILE.json",
             "bars in a row, from left to right: clamp, free, N[:Z[:C]], gap=G, stop=G, dash=D, "
             "spring=K, mass=M, force=F, driven, shaken"),
        real("--gravity", all, "M/S2", "m/s^2", "gravity, to the right along all bars", "0"),
        whole("--cells", all & ~response, "N", 1, maxCells, "N, equal cells of the bar", "300"),
        whole("--cells", response, "N|auto", 1, maxCells,
              "N, equal cells of the bar; auto: few, and more where something happens, until the "
              "answer no longer changes",
              "300"),
        positive("--length", all, "M", "m", "L", "1"),
        positive("--wave-speed", all, "M/S", "m/s", "c", "1"),
        positive("--axial-stiffness", all, "N", "N", "EA", "1"),
        real("--gap", all, "M", "m", "g, from the tip at rest to the wall; < 0: pressed at rest",
             "1e-3"),
        positive("--second-stop", all, "M", "m",
                 "h, to a stop on the other side of the tip; phases on it are L:NC NF"),
        text("--segments", all, "N:Z[:C[:D]],...",
             "cells, relative impedance and speed of each segment, clamp first; a fourth number is "
             "the dashpot at the joint after it, in units of the first impedance",
             "one, uniform"),
        file("--segments-file", all,
             "the same of a drawing: columns length [m], young [Pa], density [kg/m^3], and area "
             "[m^2] or diameter [m]; on --cells cells at most"),
        positive("--young", all, "PA", "Pa", "E, with --density and --area in place of c and EA"),
        positive("--density", all, "KG/M3", "kg/m^3", "rho"),
        positive("--area", all, "M2", "m^2", "cross-section"),
        positive("--diameter", all, "M", "m", "of a round bar, in place of --area", "", "area"),
        choice("--format", all | study, "text|json", "text or json", "text"),
        flag("--quiet", all | study, "nothing on stderr but errors"),
        flag("--verbose", all | study,
             "in text, also by which route an answer was found and what that left out"),
        whole("--threads", all | study, "K", 1, 1024, "most threads to use", "1"),
        file("--progress", all | study, "write how far long work has come, a line each second",
             "FILE"),
    };
}

}  // namespace

std::span<const Option> options()
{
    static const std::vector<Option> table = [] {
        std::vector<Option> all;
        for (const auto& rows :
             {ofMotions(), ofForce(), ofSimulations(), ofLists(), ofOutputs(), ofAll()}) {
            all.insert(all.end(), rows.begin(), rows.end());
        }
        return all;
    }();
    return table;
}

std::string_view keptBy(std::string_view name)
{
    constexpr std::string_view isForced =
        "under a force a schedule has one motion, but at resonance, and its energy is an answer";
    constexpr std::array<std::array<std::string_view, 2>, 8> reasons{{
        {"--formulation", "only problems of one bar without force have several"},
        {"--objective", isForced},
        {"--target", isForced},
        {"--energy-ratio", isForced},
        {"--energy", isForced},
        {"--tip-floor", "it bounds u(L) of one bar without force; --strain-limit bounds all"},
        {"--contacts", "elsewhere motions are sought by their schedules, which say how many"},
        {"--certificate", "a proof is of one schedule, in rational numbers, which sines are not"},
    }};
    const auto* const known = std::find_if(reasons.begin(), reasons.end(),
                                           [&](const auto& row) { return row[0] == name; });
    return known == reasons.end() ? "" : (*known)[1];
}

}  // namespace signorini::answers
