#pragma once
/// \file
/// Families, modes and polytopes, their motions, and lists of them.

#include <string>

#include "parts.hpp"
#include "watch.hpp"

namespace signorini::answers {

using FamilyOf = Of<Family>;
using ModeOf = Of<Mode>;
using PolytopeOf = Of<ModePolytope>;

/// The motion of a mode, on no grid.
struct ModeAnswer {
    Mode mode;
    Bar bar;
    ModeMotion motion;
    double gravity = 0.0;  ///< as FamilyList::gravity; the shape at rest is in the motion
};

/// The motion of a mode, the shape at rest of its bar under gravity included.
[[nodiscard]] ModeAnswer motionOf(const Mode& mode, const Bar& bar, double period,
                                  double gravity = 0.0);

/// A motion with several contacts, on no grid.
struct PolytopeAnswer {
    ModePolytope polytope;
    Bar bar;
    ModePoint point;
    ModeMotion motion;
};

/// The outcome of one search.
struct FamilyList {
    static constexpr std::int64_t mostOrder = 20'000;
    static constexpr std::size_t most = 20'000'000;  ///< families, 32 bytes each

    std::int64_t maxOrder = 0;
    double maxEnergyRatio = 0.0;
    Bar bar;
    std::vector<Family> families;
    std::string ended;                      ///< why it is not complete; empty: it is
    std::optional<double> secondStop = {};  ///< [m]; families are those of the wall that it leaves
    double gravity = 0.0;  ///< [m/s^2], under which bar and stops are what they are

    [[nodiscard]] bool isComplete() const { return ended.empty(); }
};
struct ModeList {
    ModeBounds bounds;
    Bar bar;
    std::vector<Mode> modes;
    bool isComplete = true;
    double gravity = 0.0;  ///< as FamilyList::gravity
};
struct PolytopeList {
    std::int64_t phases = 2;
    ModeBounds bounds;
    Bar bar;
    std::vector<ModePolytope> polytopes;
    bool isComplete = true;
    double gravity = 0.0;  ///< as FamilyList::gravity
};

/// The sign of the gap. \throws std::invalid_argument where there is none: no mode has a stretch of
/// periods then.
[[nodiscard]] int gapSignOfModes(const Bar& bar);

/// The families that a call asks for, or those found until the list was full; the scene is what it
/// is under this gravity.
[[nodiscard]] Question<FamilyList> familiesAsked(const Call& call, const Scene& scene,
                                                 double gravity);

/// Which modes, or with several contacts polytopes, a call asks for: without bounds those that a
/// few seconds list. \throws std::invalid_argument as gapSignOfModes, and on a larger order.
[[nodiscard]] Question<ModeList> modesAsked(const Call& call, const Bar& bar, double gravity);
[[nodiscard]] Question<PolytopeList> polytopesAsked(const Call& call, std::int64_t phases,
                                                    const Bar& bar, double gravity);

/// (p, q) of the contact time p + q T [L/c], of a polytope that of all contacts together.
[[nodiscard]] std::tuple<std::int64_t, std::int64_t> contactOf(const Mode& mode);
[[nodiscard]] std::tuple<std::int64_t, std::int64_t> contactOf(const ModePolytope& polytope);

/// "main", "twin 1", ..., if the mode has a name.
[[nodiscard]] std::optional<std::string> knownName(const Mode& mode);

void describe(auto& d, Type<FamilyOf>)
{
    d.record("Family", R"(All motions of one period and one contact pattern.

Three whole numbers (w, nu, k) name it, on no grid; on every grid with w | 2N it is one simplex.
)");
    const auto time = [](const FamilyOf& f) { return exactPeriod(f.value).value(); };
    const auto seconds = [time](const FamilyOf& f) { return time(f) * scales(f.bar).time; };
    describeFamily(d, [](const FamilyOf& f) -> const Family& { return f.value; });
    d.key("least_energy_exact", "E_1", "(numerator, denominator) of least_energy_ratio.",
          [](const FamilyOf& f) { return leastEnergy(f.value); });
    d.key("least_energy", "J >= 0", "The same in joules.",
          [](const FamilyOf& f) { return leastEnergy(f.value).value() * scales(f.bar).energy; });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.",
          [time](const FamilyOf& f) { return 4.0 / time(f); });
    d.key("frequency", "Hz > 0", "1/T.", [seconds](const FamilyOf& f) { return 1.0 / seconds(f); });
    d.key("period", "s > 0", "T.", seconds);
    d.key("mode", "-", "(4a, b), on whose curve it stands, inside.", [](const FamilyOf& f) {
        return standsOnMode(f.value) ? std::optional(contactOf(modeThrough(f.value)))
                                     : std::nullopt;
    });
    d.key("bar", "-", "Its units.", &FamilyOf::bar, When::attribute);
}

/// Where the energy of a mode or polytope lies, and its frequency.
template <typename D, typename T>
void describeRanges(D& d, Type<Of<T>>)
{
    d.key("energy_ratio_range", "E_1", "(least, most), neither reached; nothing: infinite.",
          [](const Of<T>& of) { return energyRange(of.value); });
    d.key("frequency_range", "Hz > 0", "(lowest, highest).", [](const Of<T>& of) {
        const double unit = scales(of.bar).time;
        return std::tuple(1.0 / (of.value.highest.value() * unit),
                          1.0 / (of.value.lowest.value() * unit));
    });
    d.key("energy_range", "J", "(least, most), neither reached.",
          [](const Of<T>& of) { return scaled(energyRange(of.value), scales(of.bar).energy); });
}

/// The contact time and the open interval of periods.
template <typename D, typename T>
void describeInterval(D& d, Type<Of<T>>)
{
    d.key("contact", "L/c", "(p, q): contact lasts p + q T.",
          [](const Of<T>& of) { return contactOf(of.value); });
    d.key("period_range", "L/c", "((p, q), (p, q)): p/q < T < p/q.",
          [](const Of<T>& of) { return std::tuple(of.value.lowest, of.value.highest); });
}

void describe(auto& d, Type<ModeOf> type)
{
    d.record("Mode", R"(One continuous family: a motion for every T in an interval.

t_c = a4 + b T and E/E_1 = 1/(kappa T - mu)^2, T in L/c.
)");
    describeInterval(d, type);
    d.key("inverse_sqrt_energy", "-", "(kappa, mu): 1/sqrt(E/E_1) = kappa T - mu.",
          [](const ModeOf& m) { return std::tuple(m.value.kappa, m.value.mu); });
    d.key("family", "-", R"("main", "twin 1", ..., if it has a name.)",
          [](const ModeOf& m) { return knownName(m.value); });
    d.key("ends", "-", "Why it ends there.",
          [](const ModeOf& m) { return std::tuple(m.value.lowestEnd, m.value.highestEnd); });
    describeRanges(d, type);
    d.key("bar", "-", "Its units.", &ModeOf::bar, When::attribute);
    d.key(
        "kappa", "-", "E/E_1 = 1/(kappa T - mu)^2.", [](const ModeOf& m) { return m.value.kappa; },
        When::attribute);
    d.key(
        "mu", "-", "See kappa.", [](const ModeOf& m) { return m.value.mu; }, When::attribute);
}

void describe(auto& d, Type<ModeChain>)
{
    d.record("ModeChain", "Jumps from an arrival to a release: e_release = s + 2 k - turns T.");
    d.key("k", "-", "Jumps.", &ModeChain::k);
    d.key("turns", "-", "Whole periods between.", &ModeChain::turns);
    d.key("release", "- >= 1", "Of which contact, counted from 1.",
          [](const ModeChain& chain) { return chain.release + 1; });
}

void describe(auto& d, Type<PolytopeOf> type)
{
    d.record("ModePolytope", R"(Motions with K contacts in a period, on no grid, exact.

One for each (T, s_2, ..., s_K) in the interior of a polytope with rational corners; s_1 = 0 and
s_l are the arrivals. The energy depends on T alone.
)");
    d.key(
        "chains", "-", "One from each arrival.",
        [](const PolytopeOf& p) -> const auto& { return p.value.chains; });
    d.key("order", "- >= 1", "Sum of all turns, odd.", ofValue(&ModePolytope::order));
    d.key("free_times", "- >= 0", "How many times may be chosen beside T.",
          ofValue(&ModePolytope::dimension));
    describeInterval(d, type);
    d.key(
        "inverse_sqrt_energy", "-", "(kappa, mu, divisor): 1/sqrt(E/E_1) = (kappa T - mu)/divisor.",
        [](const PolytopeOf& p) { return std::tuple(p.value.kappa, p.value.mu, p.value.divisor); });
    d.key("ends", "-", "Why it ends there.",
          [](const PolytopeOf& p) { return std::tuple(p.value.lowestEnd, p.value.highestEnd); });
    d.key(
        "vertices", "L/c", "[[(p, q), ...], ...]: T and the arrivals s_2, ..., s_K of each corner.",
        [](const PolytopeOf& p) -> const auto& { return p.value.vertices; });
    describeRanges(d, type);
    d.key("bar", "-", "Its units.", &PolytopeOf::bar, When::attribute);
    d.key(
        "phases", "-", "K.", [](const PolytopeOf& p) { return p.value.chains.size(); },
        When::attribute);
}

/// Keys that the motions of a mode and of a polytope share.
template <typename D, typename T, typename Energy>
void describeTimes(D& d, Type<T>, Energy energyRatio)
{
    const auto motion = partOf(&T::motion);
    d.key("period", "s > 0", "T.",
          [](const T& m) { return m.motion.period() * scales(m.bar).time; });
    d.key("period_ratio", "L/c > 0", "c T/L.", motion(&ModeMotion::period));
    d.key("frequency", "Hz > 0", "1/T.",
          [](const T& m) { return 1.0 / (m.motion.period() * scales(m.bar).time); });
    d.key("frequency_ratio", "- > 0", "omega/omega_1.",
          [](const T& m) { return 4.0 / m.motion.period(); });
    d.key("contact_time", "s > 0", "Of all contacts together.",
          [](const T& m) { return m.motion.contactTime() * scales(m.bar).time; });
    d.key("contact_time_ratio", "L/c > 0", "The same.", motion(&ModeMotion::contactTime));
    d.key("energy", "J > 0", "E.",
          [energyRatio](const T& m) { return energyRatio(m) * scales(m.bar).energy; });
    d.key("energy_ratio", "E_1 > 0", "E/E_1.", energyRatio);
    d.key("amplitude_ratio", "-", "h = |p| [g/L].", motion(&ModeMotion::amplitude),
          When::attribute);
}

template <typename D, typename T>
void describeGravity(D& d, Type<T>)
{
    d.key("gravity", "m/s^2", "To the right; gap and stops are those that weight leaves at rest.",
          &T::gravity);
}

void describe(auto& d, Type<ModeAnswer> type)
{
    d.record("ModeMotion", R"(The motion of a mode at one period, on no grid.

t = 0 is the start of contact; at jumps velocity and strain take the value right after them.
Displacement and strain are those of the whole bar: under gravity the shape at rest is added.
)");
    d.key("status", "-", R"("found".)", [](const ModeAnswer&) { return Status::found; });
    d.key("bar", "-", "Its units.", &ModeAnswer::bar);
    describeGravity(d, type);
    d.key("mode", "-", "That it is of.", [](const ModeAnswer& m) { return ModeOf{m.mode, m.bar}; });
    describeTimes(d, type,
                  [](const ModeAnswer& m) { return energyRatio(m.mode, m.motion.period()); });
    d.key("jumps", "-", "[(k, turns), ...]: p changes its sign at k + turns T.",
          [](const ModeAnswer& m) {
              std::vector<std::tuple<std::int64_t, std::int64_t>> list;
              for (const ModeJump& jump : jumps(m.mode)) {
                  list.emplace_back(2 * jump.k, -jump.turns);
              }
              return list;
          });
    describePhysical(d, [](const auto& m) { return physicalOf(m.motion.extremes(), m.bar); });
}

void describe(auto& d, Type<PolytopeAnswer> type)
{
    d.record("PolytopeMotion", R"(A motion with several contacts in a period, on no grid.

t = 0 is the start of the first contact; at jumps velocity and strain take the value right after
them.
)");
    const auto contacts = [](const PolytopeAnswer& m, double unit) {
        std::vector<std::tuple<double, double>> list;
        for (const auto& [start, end] : m.motion.contacts()) {
            list.emplace_back(start * unit, end * unit);
        }
        return list;
    };
    d.key("bar", "-", "Its units.", &PolytopeAnswer::bar);
    d.key("polytope", "-", "That it is of.", [](const PolytopeAnswer& m) {
        return PolytopeOf{m.polytope, m.bar};
    });
    describeTimes(d, type, [](const PolytopeAnswer& m) {
        return energyRatio(m.polytope, m.motion.period());
    });
    d.key("contacts", "s", "[(start, end), ...].",
          [contacts](const PolytopeAnswer& m) { return contacts(m, scales(m.bar).time); });
    d.key("contacts_ratio", "L/c", "[(start, end), ...].",
          [contacts](const PolytopeAnswer& m) { return contacts(m, 1.0); });
    describePhysical(d, [](const auto& m) { return physicalOf(m.motion.extremes(), m.bar); });
}

void describe(auto& d, Type<FamilyList> type)
{
    using T = FamilyList;
    d.record("FamilyList", "All families up to an order.");
    describeScene(d, [](const T& list) { return Scene(list.bar, list.secondStop); });
    describeGravity(d, type);
    d.key("complete", "-", "Or interrupted?", &T::isComplete);
    d.key("max_order", "- >= 1", "Largest w.", &T::maxOrder);
    d.key("max_energy_ratio", "E_1 > 0", "All of them reach below it.",
          [](const T& list) { return known(list.maxEnergyRatio); });
    d.key("count", "- >= 0", "How many.", [](const T& list) { return list.families.size(); });
    d.key("families", "-", "By ascending order, nu, contact_blocks.",
          [](const T& list) { return withUnits(list.families, list.bar); });
}

/// What was asked of a search for modes.
template <typename D, typename T>
void describeBounds(D& d, Type<T>)
{
    d.key("max_order", "- >= 1", "Largest b, or sum of turns.",
          [](const T& list) { return list.bounds.maxOrder; });
    d.key("max_period_ratio", "L/c > 0", "All of them reach below it.",
          [](const T& list) { return list.bounds.maxPeriod; });
    d.key("max_energy_ratio", "E_1 > 0", "All of them reach below it.",
          [](const T& list) { return list.bounds.maxEnergyRatio; });
}

void describe(auto& d, Type<ModeList> type)
{
    d.record("ModeList", "The continuous families up to an order.");
    d.key("bar", "-", "Whose units the modes have.", &ModeList::bar);
    describeGravity(d, type);
    d.key("complete", "-", "Or interrupted?", &ModeList::isComplete);
    describeBounds(d, type);
    d.key("modes", "-", "By ascending order.",
          [](const ModeList& list) { return withUnits(list.modes, list.bar); });
}

void describe(auto& d, Type<PolytopeList> type)
{
    d.record("PolytopeList", "The polytopes of several contacts up to an order.");
    d.key("bar", "-", "Whose units the polytopes have.", &PolytopeList::bar);
    describeGravity(d, type);
    d.key("complete", "-", "Or interrupted?", &PolytopeList::isComplete);
    d.key("phases", "- >= 2", "Contacts in a period.", &PolytopeList::phases);
    describeBounds(d, type);
    d.key("polytopes", "-", "By ascending order.",
          [](const PolytopeList& list) { return withUnits(list.polytopes, list.bar); });
}

}  // namespace signorini::answers
