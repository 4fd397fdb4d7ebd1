#pragma once
/// \file
/// Bars in a row as answers have them, and what any force between two bounds can do to them.

#include <array>
#include <numbers>

#include "force_range.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "signorini/assembly.hpp"
#include "simulation_answer.hpp"

namespace signorini {

/// "right stop", "left stop", "gap".
[[nodiscard]] std::string_view name(ContactKind kind);

/// A kind of part, as files have it, and what its value is called there.
struct PartName {
    PartKind value;
    std::string_view name;
    std::string_view entry = {};
};
inline constexpr auto partNames = std::to_array<PartName>({
    {PartKind::clamp, "clamp"},
    {PartKind::free, "free"},
    {PartKind::cells, "cells", "cells"},
    {PartKind::gap, "gap", "gap"},
    {PartKind::rightStop, "right stop", "gap"},
    {PartKind::leftStop, "left stop", "gap"},
    {PartKind::dash, "dash", "impedance"},
    {PartKind::spring, "spring", "stiffness"},
    {PartKind::mass, "mass", "mass"},
    {PartKind::force, "force", "force"},
    {PartKind::driven, "driven"},
    {PartKind::shaken, "shaken"},
});
[[nodiscard]] std::string_view name(PartKind kind);

}  // namespace signorini

namespace signorini::answers {

/// What the value of a part is called; empty: it has none.
[[nodiscard]] std::string_view entryOf(PartKind kind);

/// Bars in words, with the scales of a bar. \throws std::invalid_argument on what is no scene.
[[nodiscard]] Assembly assemblyIn(const std::string& words, const Bar& bar, double gravity = 0.0);

/// The bar with stops at its tip that such words are, if they are one: clamped on the left, without
/// weight, springs and masses, its first segment of impedance and speed 1. \pre valid.
[[nodiscard]] std::optional<Scene> barOf(const Assembly& assembly);

/// Today's scenes in the same words. Damping as a dashpot at the tip; the tip is driven, the clamp
/// shaken. \pre a valid scene of so many cells.
[[nodiscard]] Assembly assemblyOf(const Scene& scene, std::int64_t cells, const Damping& damping);

/// A contact of bars.
struct SceneContact {
    static constexpr bool isDictionary = true;
    std::size_t number;  ///< from 1
    ContactKind kind;
    double place;  ///< [m]
    double gap;    ///< [m]
};
[[nodiscard]] std::vector<SceneContact> contactsOf(const Network& network, double length);

template <>
inline constexpr bool isDictionary<AssemblyPart> = true;
template <>
inline constexpr bool isDictionary<Assembly> = true;
template <>
inline constexpr bool isDictionary<SceneReference> = true;

/// omega_1/2 pi [Hz]; 0: they do not vibrate.
[[nodiscard]] inline double firstHertz(const SceneReference& reference)
{
    return reference.frequency / (2.0 * std::numbers::pi);
}

/// All that an answer says of bars which are asked about.
struct SeveralBars {
    Assembly assembly;
    SceneReference reference;
    std::vector<SceneContact> contacts;
};
[[nodiscard]] SeveralBars severalOf(const Assembly& assembly, const Network& network);

void describe(auto& d, Type<AssemblyPart>)
{
    using T = AssemblyPart;
    d.record("ScenePart", "One word of a scene.");
    d.key("kind", "-", "What it is.", &T::kind);
    const auto ofCells =
        ifThere([](const T& p) { return p.kind == PartKind::cells ? &p : nullptr; });
    d.key("cells", "- >= 1", "Of a bar.", ofCells(&T::cells), When::any);
    d.key(
        "impedance", "- > 0", "Of a bar, or a dashpot, relative.",
        [](const T& p) {
            return p.kind == PartKind::cells  ? std::optional(p.impedance)
                   : p.kind == PartKind::dash ? std::optional(p.value)
                                              : std::nullopt;
        },
        When::any);
    d.key("speed", "- > 0", "Of a bar, relative.", ofCells(&T::speed), When::any);
    constexpr std::array entries{std::array{"gap", "m"}, std::array{"stiffness", "N/m > 0"},
                                 std::array{"mass", "kg > 0"}, std::array{"force", "N"}};
    for (const auto& [entry, unit] : entries) {
        d.key(
            entry, unit, "Of what has one.",
            [entry = std::string_view(entry)](const T& p) {
                return entryOf(p.kind) == entry ? std::optional(p.value) : std::nullopt;
            },
            When::any);
    }
}

void describe(auto& d, Type<Assembly>)
{
    d.record("SceneWords", "Bars in a row with all that stands at them.");
    d.key("length", "m > 0", "Of all bars without gaps.", &Assembly::length);
    d.key("wave_speed", "m/s > 0", "Where speed is 1.", &Assembly::waveSpeed);
    d.key("axial_stiffness", "N > 0", "Where impedance and speed are 1.",
          &Assembly::axialStiffness);
    d.key("young", "Pa > 0", "Young's modulus, if it is known.", &Assembly::young);
    d.key("gravity", "m/s^2", "To the right.", &Assembly::gravity);
    d.key("parts", "-", "The words, from left to right.", &Assembly::parts);
}

/// Keys of a contact, of what has one.
void describeContact(auto& d, auto contact)
{
    const auto of = partOf(contact);
    d.key("number", "- >= 1", "From 1.", of(&SceneContact::number));
    d.key("kind", "-", "What it is.", of(&SceneContact::kind));
    d.key("place", "m", "Along the bars without gaps.", of(&SceneContact::place));
    d.key("gap", "m", "At rest, weight included.", of(&SceneContact::gap));
}

void describe(auto& d, Type<SceneContact>)
{
    d.record("SceneContact", "A contact of bars.");
    describeContact(d, std::identity());
}

void describe(auto& d, Type<SceneReference>)
{
    using T = SceneReference;
    d.record("SceneReference", "What bars are measured with.");
    d.key(
        "frequency", "Hz > 0", "omega_1/2 pi: the first linear mode with open contacts.",
        [](const T& r) { return r.frequency > 0.0 ? std::optional(firstHertz(r)) : std::nullopt; });
    d.key("damping", "-", "zeta of that mode, where it vibrates.", &T::damping);
    d.key("energy", "J > 0", "E_1: the least with which contact 1 is reached.",
          [](const T& r) { return r.energy && *r.energy > 0.0 ? r.energy : std::nullopt; });
    d.key("compliance", "m/N >= 0", "Static, at contact 1, unless a bar drifts.", &T::compliance);
}

/// Keys of the bars asked about, of what has them.
void describeBars(auto& d, auto bars)
{
    const auto of = partOf(bars);
    d.key("scene", "-", "Asked about.", of(&SeveralBars::assembly));
    d.key("reference", "-", "What the bars are measured with.", of(&SeveralBars::reference));
}
void describeBarsAndContacts(auto& d, auto bars)
{
    describeBars(d, bars);
    d.key("contacts", "-", "[dict, ...], of the bars.", partOf(bars)(&SeveralBars::contacts));
}

/// Young's modulus [Pa], if it is known and bars have one wave speed.
[[nodiscard]] std::optional<double> modulusOf(const Assembly& assembly);

/// The bar whose units an answer about several bars has: its first frequency is that of the scene.
[[nodiscard]] Bar unitsOf(const Assembly& assembly, const Network& network);

/// Keys of what is asked about: `scene`, or where there are some the bars in `several`.
template <typename T, typename D>
void describeSceneOrBars(D& d)
{
    const auto ofOne = ifThere([](const T& a) { return a.several ? nullptr : &a.scene; });
    const auto ofSeveral = ifThere(&T::several);
    describeKeysOfScene(d, ofOne, When::any);
    d.key("scene", "-", "In their place, of several bars.", ofSeveral(&SeveralBars::assembly),
          When::any);
    d.key("reference", "-", "What several bars are measured with.",
          ofSeveral(&SeveralBars::reference), When::any);
    d.key("contacts", "-", "[dict, ...], of several bars.", ofSeveral(&SeveralBars::contacts),
          When::any);
}

/// What no force exceeds, what one reaches, and when; in SI units.
struct Peak {
    static constexpr bool isDictionary = true;
    ForcePeak value;
    double unit;
    double second;
};

/// Of one contact: least and most.
struct ContactPeaks {
    static constexpr bool isDictionary = true;
    SceneContact contact;
    std::array<Peak, 2> velocity;
    std::array<Peak, 2> displacement;
};

/// What any force between two bounds can do to bars at rest until a contact first closes.
struct ForceRange {
    Assembly assembly;
    std::array<double, 2> newtons;
    double time;                         ///< [s], until the end or the first contact
    std::optional<std::int64_t> closes;  ///< number of the contact that then can
    std::vector<ContactPeaks> contacts;
};

/// \throws std::invalid_argument as `reachUnder`, and on a time [s] that is too long for it.
[[nodiscard]] ForceRange forceRangeOf(const Assembly& assembly, double low, double high,
                                      double time);

void describe(auto& d, Type<Peak>)
{
    d.record("ForcePeak", "What forces between two bounds can reach.");
    d.key("bound", "-", "What no such force goes beyond, rounding included.",
          [](const Peak& p) { return p.value.bound * p.unit; });
    d.key("reached", "-", "By one of them, in a simulation.",
          [](const Peak& p) { return p.value.reached * p.unit; });
    d.key("time", "s >= 0", "When.", [](const Peak& p) { return p.value.time * p.second; });
}

void describe(auto& d, Type<ContactPeaks>)
{
    using T = ContactPeaks;
    d.record("ContactReach", "What forces between two bounds can do at one contact.");
    describeContact(d, &T::contact);
    d.key("velocity", "m/s", "Least and most, of its node, of a gap relative to the next one.",
          [](const T& c) { return std::tuple(c.velocity[0], c.velocity[1]); });
    d.key("displacement", "m", "Least and most, likewise.",
          [](const T& c) { return std::tuple(c.displacement[0], c.displacement[1]); });
}

void describe(auto& d, Type<ForceRange>)
{
    using T = ForceRange;
    d.record("ForceRange",
             "What any force between two bounds can do to bars at rest until a contact closes.");
    d.key("status", "-", R"("done".)", [](const T&) { return Ending::done; });
    d.key("scene", "-", "Asked about.", &T::assembly);
    d.key("force_range", "N", "Least and most.",
          [](const T& r) { return std::tuple(r.newtons[0], r.newtons[1]); });
    d.key("time", "s >= 0", "That was asked for, or until a contact can first close.", &T::time);
    d.key("closes", "- >= 1", "The contact that can then; none: proved.", &T::closes);
    d.key("contacts", "-", "[dict, ...]: each contact, and what can be reached there.",
          &T::contacts);
}

}  // namespace signorini::answers
