#pragma once
/// \file
/// What is known of a schedule of bars in a row: the motion of least energy or of a wish, or why
/// there is none.

#include <algorithm>

#include "disturbed.hpp"
#include "network_find.hpp"
#include "proofs.hpp"
#include "scene_answer.hpp"
#include "watch.hpp"

namespace signorini::answers {

template <>
inline constexpr bool isDictionary<ContactSpan> = true;

/// What --energy or --energy-ratio asks for, in units of the network, if one does.
/// \throws std::invalid_argument on both, and as heldEnergy.
[[nodiscard]] inline std::optional<double> energyAsked(const Call& call, const Network& network)
{
    requireOneEnergy(call);
    return heldEnergy(network, call.number("--energy"), call.number("--energy-ratio"));
}

/// Bars that a call asks about, the network that they are, within --strain-limit if that is given,
/// and the schedule that they are to follow.
struct BarsAsked {
    Assembly assembly;
    Network network;
    std::vector<ContactSpan> spans = {};

    BarsAsked(const Call& call, Assembly ofBars);
};

/// The waves that an option of a call about bars names, if it is given: those of --target, --from,
/// --to, --direction.
using WavesOf =
    std::function<std::optional<std::vector<double>>(const char* option, const BarsAsked& bars)>;

/// A schedule of bars, and what gives its answers units.
struct SceneSchedule {
    SeveralBars bars;
    std::vector<ContactSpan> spans;
    NetworkScales scales;
    std::int64_t cells = 0;
    std::optional<double> unit = {};         ///< E_1 [Z_1 delta^2/h], if there is one
    std::optional<double> strainLimit = {};  ///< [-], asked for
    std::int64_t cycles = 1;                 ///< K, of what excites them in a period

    /// [s]
    [[nodiscard]] double period() const
    {
        return static_cast<double>(stepsOf(spans)) * scales.time;
    }
    /// cT/L
    [[nodiscard]] double periodRatio() const
    {
        return period() * bars.assembly.waveSpeed / bars.assembly.length;
    }
    /// K/T over the first linear frequency, if there is one
    [[nodiscard]] std::optional<double> frequencyRatio() const;
    [[nodiscard]] double joules(double energy) const { return energy * scales.energy(); }
    /// E/E_1
    [[nodiscard]] std::optional<double> ratio(double energy) const
    {
        return unit ? std::optional(energy / *unit) : std::nullopt;
    }
    [[nodiscard]] Network network() const { return networkOf(bars.assembly); }
};
[[nodiscard]] SceneSchedule scheduleOf(const Assembly& assembly, const Network& network,
                                       const std::vector<ContactSpan>& spans);

/// A contact of bars, and in a motion what it does in a period; in SI units.
struct ContactInPeriod {
    static constexpr bool isDictionary = true;
    SceneContact contact;
    std::optional<double> speed = {};  ///< of approach
    std::optional<double> peakForce = {};
    std::optional<double> impulse = {};  ///< what is rounded below 0 where nothing presses is 0
    std::optional<double> time = {};
};
[[nodiscard]] std::vector<ContactInPeriod> contactsOf(const SceneSchedule& schedule,
                                                      const NetworkResiduals* residuals);

/// Extremes of strain in a period.
struct SceneStrains {
    static constexpr bool isDictionary = true;
    double compression = 0.0;           ///< -min s >= 0
    double tension = 0.0;               ///< max s >= 0
    std::optional<double> stress = {};  ///< [Pa], where all bars have one modulus that is known

    [[nodiscard]] double largest() const { return std::max(compression, tension); }
};
/// What a difference of waves stretches, over the relative speed [-].
[[nodiscard]] double strainUnit(const Assembly& assembly, const NetworkScales& scales);
/// Only motions with strain >= -limit everywhere are asked for, if there is one [-].
[[nodiscard]] std::optional<double> strainLimitOf(const Network& network, const Assembly& assembly);
/// Of the extremes of (l - r)/speed.
[[nodiscard]] SceneStrains strainsOf(const Assembly& assembly, const NetworkScales& scales,
                                     double least, double most);
[[nodiscard]] inline SceneStrains strainsOf(const Assembly& assembly, const NetworkScales& scales,
                                            const NetworkResiduals& residuals)
{
    const NetworkExtremes& seen = residuals.extremes;
    return strainsOf(assembly, scales, std::min(0.0, seen.leastStrain),
                     std::max(0.0, seen.mostStrain));
}

/// What one period of a motion shows, of all contacts together; in SI units.
struct ScenePhysical {
    static constexpr bool isDictionary = true;
    double frequency = 0.0;      ///< [Hz]
    double contactTime = 0.0;    ///< [s], in which contacts are closed that press
    double peakForce = 0.0;      ///< [N]
    double impulse = 0.0;        ///< [N s]
    double approachSpeed = 0.0;  ///< [m/s], the largest
    SceneStrains strains;

    [[nodiscard]] bool isAdmissible() const { return strains.compression < 1.0; }
};
[[nodiscard]] ScenePhysical physicalOf(const SceneSchedule& schedule,
                                       const NetworkResiduals& residuals);

/// What multipliers prove: no motion has less energy.
struct SceneFloor {
    static constexpr bool isDictionary = true;
    EnergyFloor multipliers;
    double energy = 0.0;  ///< [J]
    std::optional<double> ratio = {};
    std::optional<double> strainLimit = {};  ///< [-], that it rests on
};
[[nodiscard]] SceneFloor floorOf(const SceneSchedule& schedule, const LeastMotion& known);

/// What became of disturbances of a motion.
struct SceneStability {
    static constexpr bool isDictionary = true;
    std::int64_t periods = 0;  ///< waited
    StabilityResult result;
};

/// Starts beside a motion.
[[nodiscard]] SceneStability stabilityIn(const Network& network, const NetworkClaim& motion,
                                         const Cancel& cancel);

/// Of a schedule that nothing drives.
struct SceneFindAnswer {
    SceneSchedule schedule;
    bool isOfLeast = true;  ///< NetworkWish::isOfLeast
    LeastMotion motions;
    std::optional<SceneStability> stability = {};  ///< where it was asked for

    [[nodiscard]] Status status() const { return motions.status; }
    [[nodiscard]] bool isFound() const { return motions.status == Status::found; }
    [[nodiscard]] const SceneSchedule& followed() const { return schedule; }
    /// \throws std::invalid_argument if there is none.
    [[nodiscard]] const NetworkClaim& claim(std::size_t = 0) const;
    /// Of the motion, if there is one.
    [[nodiscard]] std::optional<SceneStrains> strains() const
    {
        return isFound() ? std::optional(strainsOf(schedule.bars.assembly, schedule.scales,
                                                   motions.residuals))
                         : std::nullopt;
    }
    [[nodiscard]] std::optional<ScenePhysical> physical() const
    {
        return isFound() ? std::optional(physicalOf(schedule, motions.residuals)) : std::nullopt;
    }
    /// Every motion of the schedule has more.
    [[nodiscard]] std::optional<double> provedCompression() const;
    /// Does any contact press?
    [[nodiscard]] bool presses() const { return motions.residuals.presses(); }
    /// What is proved is that of least energy.
    [[nodiscard]] bool isProof() const
    {
        return motions.status == Status::none || (motions.status == Status::found && isOfLeast);
    }
    [[nodiscard]] std::optional<SceneFloor> certificate() const;
};

/// How a call has motions of bars looked for. \throws std::invalid_argument on demands that do not
/// go together; as WavesOf.
struct SearchInBars {
    FindOptions options;
    NetworkWish wish;

    SearchInBars(const Call& call, const BarsAsked& bars, const WavesOf& wavesOf);
    /// The motion of least energy, or of the wish, or why there is none. \throws as `wishedMotion`.
    [[nodiscard]] SceneFindAnswer of(const BarsAsked& bars, const std::vector<ContactSpan>& spans,
                                     const Cancel& cancel) const;
};

/// What a call asks of a schedule. \throws as SearchInBars.
[[nodiscard]] Question<SceneFindAnswer> motionAsked(const Call& call, const BarsAsked& bars,
                                                    const WavesOf& wavesOf);

/// Starts beside the motion, if there is one, and its waves are not 0.
void tryStability(SceneFindAnswer& answer, const Cancel& cancel);

void describe(auto& d, Type<ContactSpan>)
{
    d.record("ContactSpan", "Steps in a row with the same contacts closed.");
    d.key("closed", "- >= 1", "Contacts, counted from the left.",
          [](const ContactSpan& s) { return numbersOf(s.closed); });
    d.key("steps", "- >= 1", "So many.", &ContactSpan::steps);
}

/// With which an answer begins.
void describeSchedule(auto& d, auto schedule)
{
    const auto of = partOf(schedule);
    describeBars(d, of(&SceneSchedule::bars));
    d.key("cells", "- >= 1", "Of all bars.", of(&SceneSchedule::cells));
    d.key("schedule", "-", R"([{"closed", "steps"}, ...] of one period.)",
          of(&SceneSchedule::spans));
    d.key("period", "s > 0", "T.", of(&SceneSchedule::period));
    d.key("period_ratio", "- > 0", "cT/L, of all bars and the speed 1.",
          of(&SceneSchedule::periodRatio));
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the scene; none where it has no omega_1.",
          of(&SceneSchedule::frequencyRatio));
}

void describeStrainLimit(auto& d, auto schedule)
{
    d.key("strain_limit", "- > 0", "Of all motions, if any.",
          partOf(schedule)(&SceneSchedule::strainLimit), When::any);
}

void describe(auto& d, Type<ContactInPeriod>)
{
    using T = ContactInPeriod;
    d.record("SceneContactForces", "A contact of bars, and what it does in a period of a motion.");
    describeContact(d, &T::contact);
    d.key("approach_speed", "m/s >= 0", "Largest, before it closes.", &T::speed, When::any);
    d.key("peak_force", "N", "Largest.", &T::peakForce, When::any);
    d.key("impulse", "N s >= 0", "In a period.", &T::impulse, When::any);
    d.key("contact_time", "s >= 0", "In a period.", &T::time, When::any);
}

void describeStrains(auto& d, auto of)
{
    d.key("peak_compression", "- >= 0", "-min s over all x and t.", of(&SceneStrains::compression));
    d.key("peak_tension", "- >= 0", "max s over all x and t.", of(&SceneStrains::tension));
    d.key("peak_stress", "Pa >= 0",
          "Largest |stress|, where Young's modulus is known and all bars have one wave speed.",
          of(&SceneStrains::stress));
}

void describe(auto& d, Type<SceneStrains>)
{
    d.record(
        "SceneStrains",
        "Strains of bars in a period of a motion, those at rest under constant forces included.");
    describeStrains(d, std::identity());
}

void describe(auto& d, Type<ScenePhysical>)
{
    using T = ScenePhysical;
    d.record("ScenePhysical", "What one period of a motion of bars shows, in SI units.");
    d.key("frequency", "Hz > 0", "Of the period.", &T::frequency);
    d.key("contact_time", "s >= 0", "In one period, of all contacts that press.", &T::contactTime);
    d.key("peak_force", "N >= 0", "Largest, of any contact.", &T::peakForce);
    d.key("impulse", "N s >= 0", "In one period, of all contacts.", &T::impulse);
    d.key("approach_speed", "m/s >= 0", "Largest, before a contact closes.", &T::approachSpeed);
    describeStrains(d, partOf(&T::strains));
    d.key("tip_lowest", "m", "None: bars in a row have no one tip.",
          [](const T&) { return std::optional<double>(); });
}

void describe(auto& d, Type<SceneFloor>)
{
    using T = SceneFloor;
    d.record("SceneEnergyFloor", "Multipliers by which no motion of bars has less energy.");
    describeProof(d, "energy-floor", [](const T&) { return "network"; });
    d.key("energy_ratio", "- >= 0", "No motion has less; E_1 of the scene, if there is one.",
          &T::ratio);
    d.key("energy", "J >= 0", "No motion has less.", &T::energy);
    d.key("strain_limit", "- > 0", "That the proof rests on.", &T::strainLimit, When::any);
    describeMultipliers(d, [](const T& f) -> const EnergyFloor& { return f.multipliers; });
}

void describe(auto& d, Type<NetworkResiduals>)
{
    using T = NetworkResiduals;
    d.record("SceneResiduals", "Relative violations, recomputed; 0 where there are none.");
    d.key("periodicity", "- >= 0", "Change over the period.", &T::periodicity);
    d.key("tie", "- >= 0", "Of places at the start that follow from the waves.", &T::tie);
    d.key("gap", "- >= 0", "Of contacts that close.", &T::gap);
    d.key("pressure", "- >= 0", "Deepest pull of a closed contact.", &T::pressure);
    d.key("penetration", "- >= 0", "Deepest overlap of an open one.", &T::penetration);
}

template <>
inline constexpr bool isDictionary<StabilityTrial> = true;

void describe(auto& d, Type<StabilityTrial>)
{
    using T = StabilityTrial;
    d.record("SceneStabilityTrial", "One disturbance of bars.");
    d.key("size", "-", "Largest change of a velocity, of the largest wave.", &T::size);
    d.key("start", "- >= 0", "Root of the energy it has at first, of the motion's.", &T::start);
    d.key("end", "- >= 0", "The same at the end.", &T::end);
}

void describe(auto& d, Type<SceneStability>)
{
    using T = SceneStability;
    const auto result = partOf(&T::result);
    d.record("SceneStabilityReport", "What became of disturbances of bars.");
    d.key("verdict", "-", "Do the bars stay near the motion?", result(&StabilityResult::stability));
    d.key("periods", "- >= 1", "Waited.", &T::periods);
    d.key("drift", "- >= 0", "Of the undisturbed motion in a period, as trials are.",
          result(&StabilityResult::drift));
    d.key("contacts", "- >= 0", "Of the undisturbed motion.", result(&StabilityResult::contacts));
    d.key("trials", "-", "One for each disturbance.", result(&StabilityResult::trials));
}

void describe(auto& d, Type<SceneFindAnswer>)
{
    using T = SceneFindAnswer;
    const auto motions = partOf(&T::motions);
    const auto ofMotion = [](auto get) {
        return [get](const T& a) { return a.isFound() ? std::optional(get(a)) : std::nullopt; };
    };
    const auto ratioOfMotion = [](double LeastMotion::*energy) {
        return [energy](const T& a) {
            return a.isFound() ? a.schedule.ratio(a.motions.*energy) : std::nullopt;
        };
    };
    d.record("SceneResult", "What is known of a schedule of bars in a row.");
    d.key("status", "-", R"("found", "none" or "undecided".)", &T::status);
    describeSchedule(d, &T::schedule);
    d.key("kernel_dimension", "- >= 0", "None: rounding hides it.",
          motions(&LeastMotion::kernelDimension));
    describeSolutionSet(d, &T::motions);
    d.key("contacts", "-", "[dict, ...]: each contact, of a motion with its forces.",
          [](const T& a) {
              return contactsOf(a.schedule, a.isFound() ? &a.motions.residuals : nullptr);
          });
    d.key("contact", "-", R"("pressing", or "grazing": nothing presses.)",
          ofMotion([](const T& a) { return a.presses() ? Contact::pressing : Contact::grazing; }));
    d.key("energy", "J >= 0", "Of the waves at the start, about the shape at rest.",
          ofMotion([](const T& a) { return a.schedule.joules(a.motions.energy); }), When::found);
    d.key("energy_ratio", "- >= 0", "E/E_1 of the scene; none where a bar drifts, or a gap is 0.",
          ratioOfMotion(&LeastMotion::energy));
    d.key("energy_ratio_proved", "- >= 0", "No motion has less.",
          ratioOfMotion(&LeastMotion::provedEnergy));
    d.key("strains", "-", "Of the motion.", &T::strains, When::found);
    d.key("physical", "-", "What can be measured, in SI units.", &T::physical, When::found);
    d.key("admissible", "-", "Is s > -1 everywhere?",
          ifThere(&T::physical)(&ScenePhysical::isAdmissible), When::found);
    d.key("peak_compression_proved", "- > 0", "Of a motion with the least: every motion has more.",
          &T::provedCompression, When::any);
    d.key("residuals", "-", "Of the motion.", ofMotion(motions(&LeastMotion::residuals)),
          When::found);
    d.key("stability", "-", "Of the motion when it is perturbed.", &T::stability, When::any);
    d.key("certificate", "-", "No motion has less energy; of none: than any looked for, or held.",
          &T::certificate);
    describeRoute(d, motions(&LeastMotion::how));
    d.key("detail", "-", "Why it is not decided.", motions(&LeastMotion::detail));
    d.key(
        "reason", "-", R"(Of none: "constraints" where motions exist, but not of the energy held.)",
        [](const T& a) {
            return a.status() == Status::none && !a.motions.isEmpty
                       ? std::optional(Reason::constraints)
                       : std::nullopt;
        },
        When::any);
}

}  // namespace signorini::answers
