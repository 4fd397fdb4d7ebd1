#include <cmath>

#include "families_report.hpp"
#include "report.hpp"

namespace signorini::cli {

namespace {

/// Rows and multipliers as pairs, all of them: what says "verified" can be verified by the reader.
Json multipliersAsJson(const std::vector<Multiplier>& rows)
{
    Json pairs = Json::array();
    for (const Multiplier& m : rows) {
        pairs.push_back({m.row, m.value});
    }
    return pairs;
}

Json asJson(const FarkasCertificate& c)
{
    return {{"kind", "farkas"},
            {"verified", true},
            {"rows", "paper"},
            {"gap", c.gap},
            {"size", c.size},
            {"periodicity", multipliersAsJson(c.periodicity)},
            {"pressure", multipliersAsJson(c.pressure)},
            {"penetration", multipliersAsJson(c.penetration)}};
}

Json asJson(const ProgramProof& proof)
{
    return {{"kind", "farkas"},
            {"verified", true},
            {"rows", name(proof.rows)},
            {"equalities", multipliersAsJson(proof.multipliers.equalities)},
            {"inequalities", multipliersAsJson(proof.multipliers.inequalities)}};
}

Json multipliersAsJson(const std::vector<RationalMultiplier>& rows)
{
    Json pairs = Json::array();
    for (const RationalMultiplier& m : rows) {
        pairs.push_back({m.row, m.value});
    }
    return pairs;
}

Json asJson(const SteppedProof& proof)
{
    const double floor = proof.tipFloor - proof.tolerance;
    return {{"kind", "farkas"},
            {"verified", true},
            {"rows", name(Formulation::joints)},
            {"tip_floor", std::isfinite(floor) ? Json(floor) : Json()},
            {"equalities", multipliersAsJson(proof.multipliers.equalities)},
            {"inequalities", multipliersAsJson(proof.multipliers.inequalities)}};
}

Json asJson(const EnergyExclusion& exclusion)
{
    Json json{{"kind", "energy-range"}, {"verified", exclusion.isVerified}};
    if (!exclusion.isVerified) {
        json["note"] = rangeNote;
    }
    return json;
}

Json placeAsJson(const TentPlace& place)
{
    Json json = familyAsJson(place.family);
    json["amplitudes"] = place.amplitudes;
    json["offset"] = place.offset;
    return json;
}

/// Without a gap there is no E_1 to count energies in.
void addMotion(const FoundMotion& motion, bool hasUnit, Json& json)
{
    const Residuals& r = motion.residuals;
    json["contact"] = name(motion.contact);
    json["canonical_schedule"] = phasesAsJson(motion.canonical);
    json["repetitions"] = motion.repetitions;
    json["pressing_phases"] = motion.pressing;
    json["energy"] = motion.energy;
    json["energy_ratio"] = hasUnit ? Json(motion.energyRatio) : Json();
    json["symmetric"] = motion.isSymmetric;
    json["residuals"] = {
        {"periodicity", r.periodicity}, {"gap", r.gap},     {"pressure", r.pressure},
        {"penetration", r.penetration}, {"march", r.march}, {"demands", r.demands}};
    json["physical"] = physicalAsJson(motion.physical);
    json["peak_strain"] = motion.physical.peakCompression;
    json["admissible"] = motion.physical.isAdmissible();
}

}  // namespace

double TargetReport::distanceTo(const State& other) const
{
    return std::sqrt(energyRatio({other.a - state.a, other.b - state.b}) / energyRatio(state));
}

Json physicalAsJson(const Physical& p)
{
    return {{"frequency", p.frequency},
            {"contact_time", p.contactTime},
            {"peak_force", p.peakForce},
            {"impulse", p.impulse},
            {"approach_speed", p.approachSpeed},
            {"peak_compression", p.peakCompression},
            {"peak_tension", p.peakTension},
            {"peak_stress", p.peakStress ? Json(*p.peakStress) : Json()},
            {"tip_lowest", p.tipLowest}};
}

Json answerOf(const PeriodicResult& result, const std::optional<TargetReport>& target)
{
    Json json = newAnswer();
    addScene(result.scene, json);
    json.update(Json{{"status", name(result.status)},
                     {"cells", result.schedule.cells},
                     {"schedule", phasesAsJson(result.schedule.phases)},
                     {"period", result.period},
                     {"period_ratio", period(result.schedule)},
                     {"frequency_ratio", result.frequencyRatio},
                     {"kernel_dimension", nullptr},
                     {"solution_set", nullptr},
                     {"family", nullptr},
                     {"objective", name(result.how.objective)},
                     {"contact", nullptr},
                     {"canonical_schedule", nullptr},
                     {"energy", nullptr},
                     {"energy_ratio", nullptr},
                     {"energy_ratio_range", nullptr},
                     {"energy_section", nullptr},
                     {"physical", nullptr},
                     {"admissible", nullptr},
                     {"residuals", nullptr},
                     {"reason", nullptr},
                     {"certificate", nullptr},
                     {"route", result.how.route},
                     {"route_reason", result.how.reason},
                     {"left_out", result.how.leftOut},
                     {"solver",
                      {{"name", result.how.solver.name},
                       {"iterations", result.how.solver.iterations},
                       {"seconds", result.how.solver.seconds}}}});
    if (result.set.kernelDimension) {
        json["kernel_dimension"] = *result.set.kernelDimension;
    }
    if (const auto& kind = result.set.kind) {
        json["solution_set"] = {{"kind", name(*kind)}, {"dimension", nullptr}};
        if (*kind != SetKind::empty) {
            json["solution_set"]["dimension"] = result.set.dimension;
        }
    }
    if (result.set.family) {
        json["family"] = placeAsJson(*result.set.family);
    }
    if (const auto& held = result.set.held) {
        json["energy_section"] = {
            {"dimension", held->dimension},
            {"connected", held->isConnected},
            {"components", held->components ? Json(*held->components) : Json()}};
    }
    const bool hasUnit = result.scene.bar.gap != 0.0;
    if (result.set.energy && hasUnit) {
        // JSON has no infinity: an unbounded or unknown end prints as null.
        json["energy_ratio_range"] = {result.set.energy->least, result.set.energy->most};
    } else if (result.motion) {
        json["energy_ratio_range"] = {nullptr, nullptr};
    }
    if (result.motion) {
        addMotion(*result.motion, hasUnit, json);
    }
    if (target) {
        json["target"] = target->how;
        json["distance"] = nullptr;
        if (result.motion) {
            json["distance"] = target->distanceTo(result.motion->state);
        }
    }
    if (result.absence) {
        const auto& proof = result.absence->proof;
        json["reason"] = name(result.absence->reason);
        json["certificate"] = std::visit([](const auto& p) { return asJson(p); }, proof);
        if (const auto* exclusion = std::get_if<EnergyExclusion>(&proof)) {
            json["detail"] = describe(*exclusion);
        }
    }
    if (!result.detail.empty()) {
        json["detail"] = result.detail;
    }
    return json;
}

}  // namespace signorini::cli
