#pragma once
/// \file
/// The records that several answers hold: bar, stops, segments, what is measured, residuals,
/// families, sets.

#include "description.hpp"
#include "excited_amplitude.hpp"
#include "signorini/bar.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"

namespace signorini::answers {

/// What units mean: the first material; Young's modulus is known of it only, so not of several.
[[nodiscard]] Bar unitsOf(const Scene& scene);
/// One unit of force [N], EA g/L, and of impulse [N s], EA g/c.
[[nodiscard]] double forceUnit(const Bar& bar);
[[nodiscard]] double impulseUnit(const Bar& bar);

/// Energies in another unit.
[[nodiscard]] inline EnergyRange scaled(const EnergyRange& range, double unit)
{
    return {range.least * unit, range.most * unit};
}

/// Where u(L) is stopped.
struct StopPlace {
    static constexpr bool isDictionary = true;
    Stop side = Stop::right;
    double place = 0.0;  ///< [m]
};
/// The wall, and the second stop if there is one.
[[nodiscard]] std::vector<StopPlace> stopsIn(const Scene& scene);

/// Kind and dimension of a set of motions.
struct SolutionSet {
    SetKind kind = SetKind::empty;
    std::int64_t dimension = -1;
};

void describe(auto& d, Type<Bar>)
{
    d.record("Bar", "A bar and its wall, in SI units.");
    d.key("length", "m > 0", "L.", &Bar::length);
    d.key("wave_speed", "m/s > 0", "c, of the first segment.", &Bar::waveSpeed);
    d.key("axial_stiffness", "N > 0", "EA, of the first segment.", &Bar::axialStiffness);
    d.key("gap", "m", "g, from the tip at rest to the wall.", &Bar::gap);
    d.key("young", "Pa > 0", "Young's modulus, if it is known.", &Bar::young);
    const auto unit = [&d](const char* name, const char* sentence, double Scales::*scale) {
        d.key(
            name, "-", sentence, [scale](const Bar& bar) { return scales(bar).*scale; },
            When::attribute);
    };
    unit("energy_unit", "E_1 = EA g^2/(2L) [J]: the unit of every `energy_ratio`.",
         &Scales::energy);
    unit("time_unit", "L/c [s]: the unit of every `period_ratio` and other times.", &Scales::time);
    unit("strain_unit", "g/L [-]: the unit of waves and strains.", &Scales::strain);
    unit("velocity_unit", "c g/L [m/s]: the unit of velocities.", &Scales::velocity);
    unit("displacement_unit", "g [m]: the unit of displacements.", &Scales::displacement);
    d.key("force_unit", "-", "EA g/L [N]: the unit of forces.", &forceUnit, When::attribute);
    d.key("impulse_unit", "-", "EA g/c [N s]: the unit of impulses.", &impulseUnit,
          When::attribute);
    d.key(
        "frequency_unit", "-", "omega_1/(2 pi) = c/(4L) [Hz]: the unit of `frequency_ratio`.",
        [](const Bar& bar) { return 0.25 / scales(bar).time; }, When::attribute);
}

void describe(auto& d, Type<StopPlace>)
{
    d.record("StopPlace", "A stop.");
    d.key("side", "-", R"(Of the tip: "right", or "left".)", &StopPlace::side);
    d.key("place", "m", "u(L) there: g, or -h.", &StopPlace::place);
}

void describe(auto& d, Type<Segment>)
{
    d.record("Segment", "Equal cells of one material of a stepped bar.");
    d.key("cells", "- >= 1", "Of equal crossing time.", &Segment::cells);
    d.key("impedance", "- > 0", "Relative to the first.", &Segment::impedance);
    d.key("speed", "- > 0", "Relative to the first.", &Segment::speed);
    d.key("dashpot", "- >= 0", "At the joint after it, relative to the first impedance.",
          &Segment::dashpot);
}

/// Keys of the scene asked about: `of(get)` gets of the scene of a record.
void describeKeysOfScene(auto& d, auto of, When when)
{
    d.key("bar", "-", "Asked about.", of(&Scene::bar), when);
    d.key("stops", "-", R"([{"side", "place" [m]}, ...]: the wall, and a second stop.)",
          of(&stopsIn), when);
    d.key("segments", "-", "[Segment, ...] of a stepped bar, clamp first; none: a uniform bar.",
          of(&Scene::segments), when);
    d.key("static_force", "N >= 0", "What the bar at rest presses on the wall with.",
          of(&staticForce), when);
}
void describeScene(auto& d, auto scene)
{
    describeKeysOfScene(d, partOf(scene), When::always);
}

void describe(auto& d, Type<Scene>)
{
    d.record("Scene", "A bar, its stops, and what it is made of.");
    describeScene(d, std::identity());
}

void describe(auto& d, Type<Physical>)
{
    d.record("Physical", "What one period of a motion shows, in SI units.");
    d.key("frequency", "Hz > 0", "Of the motion's own period.", &Physical::frequency);
    d.key("contact_time", "s >= 0", "In one period, in which the wall is pressed.",
          &Physical::contactTime);
    d.key("peak_force", "N >= 0", "Largest, of the tip on the wall.", &Physical::peakForce);
    d.key("impulse", "N s >= 0", "In one period.", &Physical::impulse);
    d.key("approach_speed", "m/s >= 0", "Largest, of the tip just before it meets the wall.",
          &Physical::approachSpeed);
    d.key("peak_compression", "-", "-min s over all x and t.", &Physical::peakCompression);
    d.key("peak_tension", "-", "max s over all x and t.", &Physical::peakTension);
    d.key("peak_stress", "Pa >= 0", "Largest |stress|, where Young's modulus is known.",
          &Physical::peakStress);
    d.key("tip_lowest", "m", "min u(L, t).", &Physical::tipLowest);
}

/// Keys of what get(record) measures.
void describePhysical(auto& d, auto get)
{
    d.key("physical", "-", "What can be measured, in SI units.", get);
    d.key("admissible", "-", "Is s > -1 everywhere?",
          [get](const auto& of) { return std::invoke(get, of).isAdmissible(); });
}

/// The frequency of the excitation that the `value` of a record has.
void describeFrequency(auto& d, auto ratio)
{
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.", ofValue(ratio));
    d.key("frequency", "Hz > 0", "Of the excitation.", [ratio](const auto& of) {
        return std::invoke(ratio, of.value) / 4.0 / scales(of.bar).time;
    });
}

/// What the bar without a wall would do at that frequency.
template <typename D, typename T>
void describeLinear(D& d, bool T::*touches, double T::*linearPeak)
{
    d.key("touches", "-", "Would the bar without a wall go beyond it?", ofValue(touches));
    d.key("linear_peak", "m >= 0", "max u(L) without a wall.",
          ofValue(linearPeak, &Scales::displacement));
}

void describe(auto& d, Type<Residuals>)
{
    d.record("Residuals", "Relative violations, recomputed; 0 where there are none.");
    d.key("periodicity", "- >= 0", "Of (30).", &Residuals::periodicity);
    d.key("gap", "- >= 0", "Of (31).", &Residuals::gap);
    d.key("pressure", "- >= 0", "Of (10).", &Residuals::pressure);
    d.key("penetration", "- >= 0", "Of (11) and (12).", &Residuals::penetration);
    d.key("march", "- >= 0", "Of an independent time-stepping check.", &Residuals::march);
    d.key("demands", "- >= 0", "Of further demands.", &Residuals::demands);
}

void describe(auto& d, Type<SolutionSet>)
{
    d.record("SolutionSet", "What all motions of a schedule look like.");
    d.key("kind", "-", "Its shape.", &SolutionSet::kind);
    d.key("dimension", "- >= 0", "Unless it is empty.", [](const SolutionSet& s) {
        return s.kind == SetKind::empty ? std::nullopt : std::optional(s.dimension);
    });
}

void describe(auto& d, Type<HeldEnergy>)
{
    d.record("EnergySection", "The motions of one energy.");
    d.key("dimension", "- >= 0", "Of that set.", &HeldEnergy::dimension);
    d.key("connected", "-", "Can all of them be joined?", &HeldEnergy::isConnected);
    d.key("components", "- >= 1", "In so many parts, up to 64 bits.", &HeldEnergy::components);
}

void describe(auto& d, Type<SolverReport>)
{
    d.record("SolverReport", "Who did the work.");
    d.key("name", "-", "As the option `solver` has it.", &SolverReport::name);
    d.key("iterations", "- >= 0", "As the solver counts them.", &SolverReport::iterations);
    d.key("seconds", "s >= 0", "Without verification.", &SolverReport::seconds);
}

/// What set(record) is of, if its kind is known.
void describeSolutionSet(auto& d, auto set)
{
    d.key("solution_set", "-", "What the set of all motions looks like.", [set](const auto& of) {
        const auto& known = std::invoke(set, of);
        return known.kind ? std::optional(SolutionSet{*known.kind, known.dimension}) : std::nullopt;
    });
}

/// Who answered: of a Provenance.
void describeRoute(auto& d, auto get)
{
    const auto how = partOf(get);
    d.key("route", "-", "Taken.", how(&Provenance::route));
    d.key("route_reason", "-", "Why that one.", how(&Provenance::reason));
    d.key("left_out", "-", "What the request did not need.", how(&Provenance::leftOut));
    d.key("solver", "-", "Which solver answered.", how(&Provenance::solver));
}

/// Keys that name a family.
void describeFamily(auto& d, auto family)
{
    d.key("order", "- >= 1", "w, blocks in 2 L/c.",
          [family](const auto& a) { return family(a).order; });
    d.key("nu", "- >= 1", "Blocks in a period.",
          [family](const auto& a) { return family(a).blocks; });
    d.key("contact_blocks", "- >= 1", "k, of them in contact.",
          [family](const auto& a) { return family(a).contactBlocks; });
    d.key("period_ratio", "L/c", "(2 nu, w): T = 2 nu/w.",
          [family](const auto& a) { return std::tuple(2 * family(a).blocks, family(a).order); });
    d.key("contact", "L/c", "(2k, w): the longest contact 2k/w.", [family](const auto& a) {
        return std::tuple(2 * family(a).contactBlocks, family(a).order);
    });
    d.key("least_energy_ratio", "E_1 >= 0", "(w/win)^2; 0 where there is no gap: every energy.",
          [family](const auto& a) { return leastEnergy(family(a)).value(); });
}

void describe(auto& d, Type<TentPlace>)
{
    d.record("FamilyPlace", "The family of a schedule, and its place there.");
    describeFamily(d, [](const TentPlace& place) -> const Family& { return place.family; });
    d.key("amplitudes", "- >= 1", "d, of this schedule.", &TentPlace::amplitudes);
    d.key("offset", "steps", "n_c - kG.", &TentPlace::offset);
}

void describe(auto& d, Type<Of<Damping>>)
{
    d.record("Damping", "A dashpot at the tip.");
    d.key("ratio", "- >= 0", "zeta of the first linear mode.",
          [](const Of<Damping>& of) { return of.value.ratio; });
    d.key("dashpot", "N s/m >= 0", "Its constant.",
          [](const Of<Damping>& of) { return dashpot(of.value, of.bar); });
}

}  // namespace signorini::answers
