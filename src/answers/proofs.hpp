#pragma once
/// \file
/// What proves that there is no motion: docs/certificates.md says what each number means.

#include "description.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::answers {

/// Said of a range that has no proof.
inline constexpr const char* rangeNote =
    "this end of the range is computed, not independently verified";

/// What all proofs by multipliers begin with.
void describeProof(auto& d, const char* kind, auto rows)
{
    d.key("kind", "-", "What is proved, in a word.", [kind](const auto&) { return kind; });
    d.key("verified", "-", "Verified exactly, or independently of what found it.",
          [](const auto&) { return true; });
    d.key("rows", "-", "What the multipliers refer to.", rows);
}

void describe(auto& d, Type<FarkasCertificate>)
{
    using T = FarkasCertificate;
    d.record("FarkasCertificate",
             "Whole multipliers of the paper's rows that add up to 0 < 0; rows count from 0.");
    describeProof(d, "farkas", [](const T&) { return "paper"; });
    d.key("gap", "-", "Multiplier of (31), negative with a gap.", &T::gap);
    d.key("size", "-", "Multiplier of the row of size, negative without a gap; else 0.", &T::size);
    d.key("periodicity", "-", "[(row, multiplier), ...] of (30).", &T::periodicity);
    d.key("pressure", "-", "[(row, multiplier >= 0), ...] of (10), one row a contact step.",
          &T::pressure);
    d.key("penetration", "-", "[(row, multiplier >= 0), ...] of (12), one row a free step.",
          &T::penetration);
}

/// The limit and the multipliers of a program.
template <typename D, typename T, typename Floor>
void describeRows(D& d, Type<T>, Floor tipFloor)
{
    d.key("tip_floor", "g", "That the proof rests on, if any.", tipFloor);
    d.key(
        "equalities", "-", "[(row, multiplier), ...].",
        [](const T& p) -> const auto& { return p.multipliers.equalities; });
    d.key(
        "inequalities", "-", "[(row, multiplier >= 0), ...].",
        [](const T& p) -> const auto& { return p.multipliers.inequalities; });
}

void describe(auto& d, Type<ProgramProof> type)
{
    using T = ProgramProof;
    d.record("ProgramProof", "Whole multipliers of the rows of a program, checked in rationals.");
    describeProof(d, "farkas", &T::rows);
    d.key("strain_limit", "g/L > 0", "That the proof rests on, if any.",
          [](const T& p) { return known(p.demands.strainLimit * (1.0 + p.tolerance)); });
    describeRows(d, type, [](const T& p) { return known(p.demands.tipFloor - p.tolerance); });
}

void describe(auto& d, Type<SteppedProof> type)
{
    using T = SteppedProof;
    d.record("SteppedProof",
             R"(Rational multipliers, "p/q", of the rows of a stepped bar, checked.)");
    describeProof(d, "farkas", [](const T&) { return Formulation::joints; });
    describeRows(d, type, [](const T& p) { return known(p.tipFloor - p.tolerance); });
}

/// Multipliers for stepping backwards in time.
void describeMultipliers(auto& d, auto floor)
{
    d.key(
        "periodicity", "-", "One for each wave.", [floor](const auto& a) -> const auto& {
            return floor(a).periodicity;
        });
    d.key(
        "places", "-", "[(contact, step, multiplier), ...], contacts from 1.",
        [floor](const auto& a) -> const auto& { return floor(a).places; });
    d.key(
        "pushes", "-",
        "[(contact, step, multiplier >= 0), ...].", [floor](const auto& a) -> const auto& {
            return floor(a).pushes;
        });
    d.key(
        "strains", "-",
        "[(row of cells, step on its right, step on its left, multiplier >= 0), ...], rows from 1.",
        [floor](const auto& a) {
            const auto& strains = floor(a).strains;
            return strains.empty() ? std::nullopt : std::optional(strains);
        },
        When::any);
}

template <>
inline constexpr bool isDictionary<EnergyFloor> = true;

void describe(auto& d, Type<EnergyFloor>)
{
    d.record("EnergyFloor", "Multipliers, verified by stepping backwards in time.");
    describeMultipliers(d, [](const EnergyFloor& f) -> const EnergyFloor& { return f; });
}

void describe(auto& d, Type<EnergyFloorProof>)
{
    using T = EnergyFloorProof;
    d.record("EnergyFloorProof",
             "Multipliers by which no motion of a stepped bar has less energy.");
    describeProof(d, "energy-floor", [](const T&) { return "network"; });
    d.key("energy_ratio", "E_1", "No motion has less.", &T::energyRatio);
    d.key("tip_floor", "g", "That the proof rests on, if any.",
          [](const T& p) { return known(p.tipFloor - p.tolerance); });
    d.key(
        "strain_limit", "g/L", "That the proof rests on.",
        [](const T& p) { return known(p.strainLimit * (1.0 + p.tolerance)); }, When::any);
    describeMultipliers(d, [](const T& p) -> const EnergyFloor& { return p.multipliers; });
}

void describe(auto& d, Type<EnergyExclusion>)
{
    d.record("EnergyExclusion", "No motion of the set has the energy held.");
    d.key("kind", "-", R"("energy-range".)", [](const EnergyExclusion&) { return "energy-range"; });
    d.key("verified", "-", "Checked in rationals?", &EnergyExclusion::isVerified);
    d.key(
        "note", "-", "If it is not.",
        [](const EnergyExclusion& e) {
            return e.isVerified ? std::nullopt : std::optional<std::string>(rangeNote);
        },
        When::any);
}

}  // namespace signorini::answers
