#pragma once
/// \file
/// Rows of an atlas, how far its ranges are decided, and what is said when it is asked.

#include <functional>
#include <string>

#include "call.hpp"
#include "family_section.hpp"
#include "scene_find_answer.hpp"
#include "signorini/atlas.hpp"

namespace signorini::answers {

/// What rows are measured in.
struct AtlasUnits {
    double time = 1.0;    ///< [s], in which a wave crosses all N cells: L/c
    double energy = 1.0;  ///< [J] of their energies: E_1, or a joule
    bool isRatio = true;  ///< are they in E_1?
    /// omega_1 of a uniform bar of this L/c over that of the bars; infinite: nothing holds them.
    double frequency = 1.0;
};
[[nodiscard]] inline AtlasUnits atlasUnitsOf(const Bar& bar)
{
    return {.time = scales(bar).time, .energy = scales(bar).energy};
}
[[nodiscard]] AtlasUnits atlasUnitsOf(const Assembly& bars);

/// The usual range of what is asked about: one bar, or bars in a row, as any are in whose words
/// there is more than a uniform bar and its stops. \throws std::invalid_argument on an invalid
/// scene.
[[nodiscard]] AtlasRange atlasRangeOf(const Scene& scene, std::int64_t cells);
[[nodiscard]] AtlasRange atlasRangeOf(const Assembly& bars);

/// The range that a call asks for, what is usual being so. \throws std::invalid_argument
[[nodiscard]] AtlasRange atlasAsked(const Call& call, AtlasRange usual);

/// A row, or a group of them.
template <typename T>
struct InUnits {
    T value;
    AtlasUnits units;
};
/// A set of orbits; its motions of one energy, where one was asked for.
struct AtlasFamilyOf {
    AtlasFamily value;
    AtlasUnits units;
    std::optional<FamilySection> section = {};
};
using AtlasEntryOf = InUnits<AtlasEntry>;
using TwinsOf = InUnits<Twins>;

/// A point of the frequency-energy plot, and how near rows are to be.
struct AtlasPoint {
    double frequencyRatio = 0.0;  ///< [omega_1]
    double energyRatio = 0.0;     ///< [E_1]
    double distance = 0.0;        ///< [-], relative
    AtlasUnits units = {};

    /// The frequency as databases have it: 4N/n.
    [[nodiscard]] double onGrid() const { return frequencyRatio / units.frequency; }
};
/// \throws std::invalid_argument unless bars have what it is measured in.
void validate(const AtlasPoint& point);

/// What was asked of a database, and what was found: twins, or rows.
struct AtlasAnswer {
    std::optional<Bar> bar = {};        ///< of which the database is
    std::optional<Assembly> bars = {};  ///< in its place
    AtlasUnits units = {};
    std::optional<AtlasPoint> near = {};
    std::optional<ExactPeriod> period = {};  ///< [L/c], asked about
    std::optional<std::vector<TwinsOf>> twins = {};
    std::optional<std::vector<AtlasFamilyOf>> families = {};
    std::optional<std::vector<AtlasEntryOf>> schedules = {};
    std::vector<AtlasRun> runs = {};  ///< of the grids asked about
    bool isComplete = false;          ///< have they decided all that was asked?

    [[nodiscard]] bool isEmpty() const
    {
        return twins ? twins->empty() : families->empty() && schedules->empty();
    }
};

/// The outcome of deciding a range.
struct AtlasBuilt {
    AtlasRun run;
    std::string database;
    Scene scene;
    std::optional<SeveralBars> several = {};  ///< in its place

    [[nodiscard]] Ending status() const
    {
        return run.isFinished() ? Ending::done : Ending::interrupted;
    }
};

/// Families with their units and, where an energy is given, their motions of it.
[[nodiscard]] inline std::vector<AtlasFamilyOf> withUnits(const std::vector<AtlasFamily>& list,
                                                          const AtlasUnits& units,
                                                          std::optional<double> energyRatio = {})
{
    std::vector<AtlasFamilyOf> all = rowsOf<AtlasFamilyOf>(list, units);
    for (AtlasFamilyOf& one : all) {
        one.section =
            energyRatio ? std::optional(sectionOf(one.value, *energyRatio)) : std::nullopt;
    }
    return all;
}

template <typename T>
[[nodiscard]] std::vector<InUnits<T>> withUnits(const std::vector<T>& list, const AtlasUnits& units)
{
    return rowsOf<InUnits<T>>(list, units);
}

/// Keys of a range and its limits.
template <typename D, typename Get>
void describeRange(D& d, Get run)
{
    const auto of = [run](auto member) {
        return [=](const auto& a) { return run(a).range.*member; };
    };
    d.key("cells", "- >= 1", "N.", of(&AtlasRange::cells));
    d.key("max_contact", "steps >= 1", "Longest contact.", of(&AtlasRange::maxContact));
    d.key("max_free", "steps >= 1", "Longest flight.", of(&AtlasRange::maxFree));
    d.key("phases", "- >= 1", "Contacts in a period, at most.", of(&AtlasRange::maxPhases));
    d.key("max_energy_ratio", "E_1 > 0", "Kept up to it; nothing: all.",
          [run](const auto& a) { return known(run(a).range.maxEnergyRatio); });
    d.key("families_only", "-", "Were no schedules kept?", of(&AtlasRange::familiesOnly));
}

/// Keys of what has been decided of it.
template <typename D, typename Get>
void describeTally(D& d, Get run, When when = When::always)
{
    const auto key = [&d, run, when](const char* name, const char* sentence, auto get) {
        d.key(
            name, "- >= 0", sentence, [=](const auto& a) { return std::invoke(get, run(a).tally); },
            when);
    };
    key("decided", "Schedules.", &AtlasTally::decided);
    key("found", "Of them with motions.",
        [](const AtlasTally& tally) { return tally.pressing + tally.grazing; });
    key("pressing", "With force.", &AtlasTally::pressing);
    key("grazing", "Without.", &AtlasTally::grazing);
    key("family_count", "Sets of orbits on this grid that those with one phase belong to.",
        &AtlasTally::families);
    key("refuted", "Proved to have none.", &AtlasTally::refuted);
    key("undecided", "Beyond the limits of exact arithmetic.", &AtlasTally::undecided);
    d.key(
        "batches", "- >= 0", "(decided, all).",
        [run](const auto& a) { return std::tuple(run(a).nextBatch, run(a).batches); }, when);
    d.key(
        "seconds", "s >= 0", "Spent.", [run](const auto& a) { return run(a).seconds; }, when);
}

template <typename D>
void describe(D& d, Type<AtlasRun>)
{
    d.record("AtlasRun", "A range of schedules, and how far it is decided.");
    describeRange(d, std::identity());
    d.key(
        "scene", "-", "Of bars in a row.", [](const AtlasRun& run) { return run.range.bars; },
        When::any);
    d.key("finished", "-", "Is all of it decided?", &AtlasRun::isFinished);
    describeTally(d, std::identity(), When::python);
}

template <typename D>
void describe(D& d, Type<AtlasBuilt>)
{
    d.record("AtlasBuilt", "The outcome of deciding a range.");
    d.key("status", "-", R"("done", or "interrupted".)", &AtlasBuilt::status);
    d.key("database", "-", "Its file.", &AtlasBuilt::database);
    describeRange(d, std::mem_fn(&AtlasBuilt::run));
    describeTally(d, std::mem_fn(&AtlasBuilt::run));
    describeSceneOrBars<AtlasBuilt>(d);
}

/// Keys of when motions repeat.
template <typename D, typename T, typename Ratio>
void describePeriod(D& d, Type<T>, Ratio frequencyRatio)
{
    const auto seconds = [](const T& of) { return period(of.value) * of.units.time; };
    d.key("period", "s > 0", "T, of the motions: a repetition has that of what it repeats.",
          seconds);
    d.key("period_ratio", "L/c > 0", "c T/L.", [](const T& of) { return period(of.value); });
    d.key("frequency", "Hz > 0", "1/T.", [seconds](const T& of) { return 1.0 / seconds(of); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.", frequencyRatio);
}

/// omega/omega_1 of a row of one bar, and where there may be bars in a row.
inline constexpr auto ratioOfOne = [](const auto& of) { return frequencyRatio(of.value); };
inline constexpr auto ratioOfAny = [](const auto& of) {
    return known(frequencyRatio(of.value) * of.units.frequency);
};

/// Keys of energies; `energy` gives them in a unit, `ratio` in E_1.
template <typename D, typename Get, typename Ratio>
void describeEnergies(D& d, Get energy, Ratio ratio, When when = When::always)
{
    d.key(
        "energy_range", "J >= 0", "(least, most on this grid); nothing: unbounded or unknown.",
        [energy](const auto& of) { return energy(of, of.units.energy); }, when);
    d.key("energy_ratio_range", "E_1 >= 0", "(least, most on this grid).", ratio, when);
}

template <typename D>
void describe(D& d, Type<AtlasFamilyOf> type)
{
    using T = AtlasFamilyOf;
    d.record("AtlasFamily", R"(A set of orbits on a grid, a row of an atlas.

Either a family, or all grazing motions of one period: those have no (order, nu, contact_blocks).
)");
    const auto number = [](std::int64_t Family::*member) {
        return [member](const T& f) {
            const std::optional<Family>& family = f.value.family;
            return family ? std::optional(*family.*member) : std::nullopt;
        };
    };
    d.key("id", "-", "Of its row.", ofValue(&AtlasFamily::id));
    d.key("cells", "- >= 1", "N.", ofValue(&AtlasFamily::cells));
    d.key("order", "- >= 1", "w.", number(&Family::order));
    d.key("nu", "- >= 1", "nu.", number(&Family::blocks));
    d.key("contact_blocks", "- >= 1", "k.", number(&Family::contactBlocks));
    d.key("schedule", "-", "That has the whole set.", [](const T& f) {
        return Schedule{f.value.cells, {f.value.top}};
    });
    describePeriod(d, type, ratioOfOne);
    d.key("contact", "-", R"("pressing" or "grazing".)", ofValue(&AtlasFamily::contact));
    d.key("kind", "-", "Of the set.", ofValue(&AtlasFamily::kind));
    d.key("dimension", "- >= 0", "Of the set.", ofValue(&AtlasFamily::dimension));
    describeEnergies(
        d, [](const T& f, double unit) { return scaled(f.value.energy, unit); },
        [](const T& f) { return f.value.energy; });
    d.key("schedules", "- >= 1", "How many of the range show some of its motions.",
          ofValue(&AtlasFamily::schedules));
    d.key(
        "dimension_at_energy", "- >= 0",
        "Of its motions of the energy that was asked for, or the nearest it has.",
        [](const T& f) { return f.section ? std::optional(f.section->dimension) : std::nullopt; },
        When::any);
    d.key(
        "connected_at_energy", "-",
        "Are those connected? Nothing: not known, or no energy was asked for.",
        [](const T& f) {
            using Answer = std::optional<bool>;
            return f.section ? std::optional<Answer>(f.section->isConnected) : std::nullopt;
        },
        When::any);
}

template <typename D>
void describe(D& d, Type<AtlasEntryOf> type)
{
    using T = AtlasEntryOf;
    d.record("AtlasSchedule", "A schedule that an atlas keeps.");
    const auto ofRow = [](auto get) {
        return [get](const T& e) { return std::invoke(get, e.value.row); };
    };
    const auto ifFound = [](auto get) {
        return [get](const T& e) {
            const AtlasRow& row = e.value.row;
            return row.status == Status::found ? std::optional(std::invoke(get, row))
                                               : std::nullopt;
        };
    };
    d.key("cells", "- >= 1", "N.", [](const T& e) { return e.value.schedule.cells; });
    d.key(
        "schedule", "-", "What it is of.",
        [](const T& e) {
            return e.value.isOfBars ? std::nullopt : std::optional(e.value.schedule);
        },
        When::any);
    d.key(
        "spans", "-", R"([{"closed", "steps"}, ...], in its place, of bars in a row.)",
        [](const T& e) {
            return e.value.isOfBars ? std::optional(spansOf(e.value.schedule)) : std::nullopt;
        },
        When::any);
    d.key("family", "-", "id of its AtlasFamily; nothing: several phases, or no motion.",
          ofValue(&AtlasEntry::family));
    describePeriod(d, type, ratioOfAny);
    d.key("status", "-", "Decided.", ofRow(&AtlasRow::status));
    d.key("reason", "-", "Why there is no motion.", ofRow(&AtlasRow::reason));
    d.key("kernel_dimension", "- >= 0", "dim ker(W - 1).", ofRow([](const AtlasRow& row) {
              const std::int64_t dimension = row.kernelDimension;
              return dimension >= 0 ? std::optional(dimension) : std::nullopt;
          }));
    d.key("kind", "-", "Of the set.", ifFound(&AtlasRow::kind), When::any);
    d.key("dimension", "-", "Of the set.", ifFound(&AtlasRow::dimension), When::any);
    d.key("contact", "-", R"("pressing" or "grazing".)", ifFound(&AtlasRow::contact), When::any);
    d.key("canonical", "-", "Does its motion of least energy press at every contact step?",
          ifFound(&AtlasRow::isCanonical), When::any);
    describeEnergies(
        d,
        [ifFound](const T& e, double unit) {
            return ifFound([unit](const AtlasRow& row) { return scaled(row.energy, unit); })(e);
        },
        [ifFound](const T& e) {
            const auto energy = ifFound(&AtlasRow::energy)(e);
            return e.units.isRatio ? energy : std::nullopt;
        },
        When::any);
}

template <typename D>
void describe(D& d, Type<TwinsOf> type)
{
    using T = TwinsOf;
    d.record("AtlasTwins", "Different orbits of equal period and energy.");
    describePeriod(d, type, ratioOfAny);
    d.key("energy", "J > 0", "The least of each.",
          [](const T& t) { return energyRatio(t.value) * t.units.energy; });
    d.key("energy_ratio", "E_1 > 0", "The same.", [](const T& t) {
        return t.units.isRatio ? std::optional(energyRatio(t.value)) : std::nullopt;
    });
    d.key("families", "-", "Of one phase.",
          [](const T& t) { return withUnits(t.value.families, t.units); });
    d.key("schedules", "-", "Of several.",
          [](const T& t) { return withUnits(t.value.schedules, t.units); });
}

template <typename D>
void describe(D& d, Type<AtlasPoint>)
{
    using T = AtlasPoint;
    d.record("AtlasPoint", "A point of the frequency-energy plot.");
    d.key("frequency", "Hz > 0", "1/T.",
          [](const T& p) { return p.frequencyRatio / (4.0 * p.units.time * p.units.frequency); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.", &T::frequencyRatio);
    d.key("energy", "J > 0", "E.", [](const T& p) { return p.energyRatio * p.units.energy; });
    d.key("energy_ratio", "E_1 > 0", "E/E_1.", &T::energyRatio);
    d.key("within", "- > 0", "How near, relative.", &T::distance);
}

template <typename D>
void describe(D& d, Type<AtlasAnswer>)
{
    using T = AtlasAnswer;
    d.record("AtlasAnswer", "What a database says.");
    d.key("bar", "-", "What units mean.", &T::bar, When::any);
    d.key("scene", "-", "In its place, of bars in a row.", &T::bars, When::any);
    d.key("near", "-", "The point asked about.", &T::near, When::any);
    d.key("exact_period", "L/c", "c T/L as a fraction, that was asked about.", &T::period,
          When::any);
    d.key("twins", "-", "Groups of different orbits.", &T::twins, When::any);
    d.key("families", "-", "Sets of orbits.", &T::families, When::any);
    d.key("schedules", "-", "Those of no family; with --schedules all.", &T::schedules, When::any);
    d.key("complete", "-", "Have the ranges decided all that was asked?", &T::isComplete);
    d.key("ranges", "-", "Of the grids asked about.", &T::runs);
}

}  // namespace signorini::answers
