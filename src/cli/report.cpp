#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "json.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t maxPrintedPhases = 8;
constexpr const char* rangeNote = "this end of the range is computed, not checked by other code";

const char* explain(Reason reason)
{
    switch (reason) {
        case Reason::noLiveClass:
            return "only the bar at rest repeats with this period: ker(W - 1) = 0";
        case Reason::contactSign:
            return "the same wave would have to push and to pull on the wall";
        case Reason::penetration:
            return "the tip would enter the wall in free flight, whatever the amplitudes";
        case Reason::gap:
            return "the tip cannot be at the wall when contact starts";
        case Reason::constraints:
            return "motions of the schedule exist, but none meets the further demands";
    }
    return "";
}

std::string phasesAsText(const std::vector<Phase>& phases)
{
    std::string text;
    for (std::size_t k = 0; k < std::min(phases.size(), maxPrintedPhases); ++k) {
        text += fmt::format("{}({}, {})", k == 0 ? "" : " ", phases[k].contact, phases[k].free);
    }
    if (phases.size() > maxPrintedPhases) {
        text += fmt::format(" … {} phases in all", phases.size());
    }
    return text.empty() ? "no contact phase" : text;
}

std::string setAsText(const MotionSet& set)
{
    std::string text;
    if (set.kind) {
        text = *set.kind == SetKind::empty ? "empty"
               : *set.kind == SetKind::point
                   ? "a single motion"
                   : fmt::format("{} of dimension {}", name(*set.kind), set.dimension);
    } else {
        text = "not known to this route";
    }
    if (set.kernelDimension) {
        text += fmt::format(", dim ker(W - 1) = {}", *set.kernelDimension);
    }
    return text;
}

/// Which phases press on the wall, and which only touch it.
std::string pressingAsText(const std::vector<bool>& pressing)
{
    std::string numbers;
    std::size_t grazing = 0;
    for (std::size_t k = 0; k < pressing.size(); ++k) {
        if (!pressing[k] && ++grazing <= maxPrintedPhases) {
            numbers += fmt::format("{}{}", grazing > 1 ? ", " : "", k + 1);
        }
    }
    if (grazing == 0) {
        return "all press";
    }
    return fmt::format("{} of {} press; touching without force: {}{}", pressing.size() - grazing,
                       pressing.size(), numbers, grazing > maxPrintedPhases ? ", …" : "");
}

std::string energyAsText(const FoundMotion& motion, const std::optional<EnergyRange>& range)
{
    std::string text = fmt::format("{:.6g} J = {:.10g} E₁", motion.energy, motion.energyRatio);
    if (range && std::isinf(range->most)) {
        text += fmt::format("   (the set reaches from {:.10g} E₁ without bound)", range->least);
    } else if (range && range->most > range->least) {
        text += fmt::format("   (the set reaches {:.10g} … {:.10g} E₁)", range->least, range->most);
    }
    return text;
}

std::string motionAsText(const PeriodicResult& result)
{
    const FoundMotion& motion = *result.motion;
    const Residuals& r = motion.residuals;
    std::string text = fmt::format("energy      {}\n", energyAsText(motion, result.set.energy));
    if (motion.contact == Contact::grazing) {
        text += "contact     grazing: a linear motion that touches the wall without force\n";
    } else if (motion.canonical == result.schedule.phases) {
        text += "contact     pressing at every contact step\n";
    } else {
        text += fmt::format(
            "contact     pressing, canonical schedule {}{}\n", phasesAsText(motion.canonical),
            motion.repetitions > 1 ? fmt::format(", {} times over", motion.repetitions) : "");
    }
    if (motion.pressing.size() > 1 && motion.contact == Contact::pressing) {
        text += fmt::format("phases      {}\n", pressingAsText(motion.pressing));
    }
    text += fmt::format("strain      at most {:.6g} in compression\n", motion.peakStrain);
    text += fmt::format(
        "residuals   periodicity {:.3g}, gap {:.3g}, pressure {:.3g}, penetration {:.3g}, march "
        "{:.3g}, demands {:.3g}\n",
        r.periodicity, r.gap, r.pressure, r.penetration, r.march, r.demands);
    return text;
}

std::string asText(const FarkasCertificate& c)
{
    return fmt::format(
        "Farkas certificate, checked in integers: gap row × {}, {} rows of (30), {} of (10), {} of "
        "(12)",
        c.gap, c.periodicity.size(), c.pressure.size(), c.penetration.size());
}

std::string asText(const ProgramProof& proof)
{
    return fmt::format(
        "Farkas certificate, checked in rationals: {} equalities and {} inequalities of the {} "
        "formulation",
        proof.multipliers.equalities.size(), proof.multipliers.inequalities.size(),
        name(proof.rows));
}

std::string asText(const EnergyExclusion& exclusion)
{
    return fmt::format("{} ({})", describe(exclusion),
                       exclusion.isVerified ? "checked in rationals" : rangeNote);
}

std::string absenceAsText(const Absence& absence)
{
    return fmt::format("reason      {}: {}\nproof       {}\n", name(absence.reason),
                       explain(absence.reason),
                       std::visit([](const auto& proof) { return asText(proof); }, absence.proof));
}

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

Json asJson(const EnergyExclusion& exclusion)
{
    Json json{{"kind", "energy-range"}, {"verified", exclusion.isVerified}};
    if (!exclusion.isVerified) {
        json["note"] = rangeNote;
    }
    return json;
}

void addMotion(const FoundMotion& motion, Json& json)
{
    const Residuals& r = motion.residuals;
    json["contact"] = name(motion.contact);
    json["canonical_schedule"] = phasesAsJson(motion.canonical);
    json["repetitions"] = motion.repetitions;
    json["pressing_phases"] = motion.pressing;
    json["energy"] = motion.energy;
    json["energy_ratio"] = motion.energyRatio;
    json["residuals"] = {
        {"periodicity", r.periodicity}, {"gap", r.gap},     {"pressure", r.pressure},
        {"penetration", r.penetration}, {"march", r.march}, {"demands", r.demands}};
    json["peak_strain"] = motion.peakStrain;
}

}  // namespace

double TargetReport::distanceTo(const State& other) const
{
    return std::sqrt(energyRatio({other.a - state.a, other.b - state.b}) / energyRatio(state));
}

std::string asText(const PeriodicResult& result, const std::optional<TargetReport>& target)
{
    std::string text = fmt::format("{:<12}{}, T = {:.10g} s, ω/ω₁ = {:.10g}\n", name(result.status),
                                   describe(result.schedule), result.period, result.frequencyRatio);
    text += fmt::format("set         {}\n", setAsText(result.set));
    switch (result.status) {
        case Status::found:
            text += motionAsText(result);
            if (target) {
                text += fmt::format("distance    {:.6g} of the target in the norm of the energy\n",
                                    target->distanceTo(result.motion->state));
            }
            break;
        case Status::none:
            text += absenceAsText(*result.absence);
            break;
        case Status::undecided:
            text += fmt::format("why         {}\n", result.detail);
            break;
    }
    if (target) {
        text += fmt::format("target      {}\n", target->how);
    }
    text += fmt::format("route       {}, {:.3g} s: {}\n", result.how.route,
                        result.how.solver.seconds, result.how.reason);
    for (std::size_t k = 0; k < result.how.leftOut.size(); ++k) {
        text += fmt::format("{:<12}{}\n", k == 0 ? "left out" : "", result.how.leftOut[k]);
    }
    return text;
}

std::string asJson(const PeriodicResult& result, const std::optional<TargetReport>& target)
{
    Json json = newAnswer();
    json["bar"] = barAsJson(result.bar);
    json.update(Json{{"status", name(result.status)},
                     {"cells", result.schedule.cells},
                     {"schedule", phasesAsJson(result.schedule.phases)},
                     {"period", result.period},
                     {"frequency_ratio", result.frequencyRatio},
                     {"kernel_dimension", nullptr},
                     {"solution_set", nullptr},
                     {"contact", nullptr},
                     {"canonical_schedule", nullptr},
                     {"energy", nullptr},
                     {"energy_ratio", nullptr},
                     {"energy_ratio_range", nullptr},
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
    if (result.set.energy) {
        // JSON has no infinity: an unbounded or unknown end prints as null.
        json["energy_ratio_range"] = {result.set.energy->least, result.set.energy->most};
    } else if (result.motion) {
        json["energy_ratio_range"] = {nullptr, nullptr};
    }
    if (result.motion) {
        addMotion(*result.motion, json);
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
    return asLine(json);
}

}  // namespace signorini::cli
