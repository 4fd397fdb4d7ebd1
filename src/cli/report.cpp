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

std::string setAsText(const PeriodicResult& result)
{
    std::string text;
    if (result.setSummary) {
        const SetSummary& set = *result.setSummary;
        text = set.kind == SetKind::empty ? "empty"
               : set.kind == SetKind::point
                   ? "a single motion"
                   : fmt::format("{} of dimension {}", name(set.kind), set.dimension);
    } else {
        text = "not known to this route";
    }
    if (result.kernelDimension) {
        text += fmt::format(", dim ker(W - 1) = {}", *result.kernelDimension);
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

std::string energyAsText(const PeriodicResult& result)
{
    std::string text = fmt::format("{:.6g} J = {:.10g} E₁", result.energy, result.energyRatio);
    if (result.energyRange && std::isinf(result.energyRange->most)) {
        text += fmt::format("   (the set reaches from {:.10g} E₁ without bound)",
                            result.energyRange->least);
    } else if (result.energyRange && result.energyRange->most > result.energyRange->least) {
        text += fmt::format("   (the set reaches {:.10g} … {:.10g} E₁)", result.energyRange->least,
                            result.energyRange->most);
    }
    return text;
}

std::string motionAsText(const PeriodicResult& result)
{
    const Residuals& r = result.residuals;
    std::string text = fmt::format("energy      {}\n", energyAsText(result));
    if (result.contact == Contact::grazing) {
        text += "contact     grazing: a linear motion that touches the wall without force\n";
    } else if (result.canonical == result.schedule.phases) {
        text += "contact     pressing at every contact step\n";
    } else {
        text += fmt::format(
            "contact     pressing, canonical schedule {}{}\n", phasesAsText(result.canonical),
            result.repetitions > 1 ? fmt::format(", {} times over", result.repetitions) : "");
    }
    if (result.pressing.size() > 1 && result.contact == Contact::pressing) {
        text += fmt::format("phases      {}\n", pressingAsText(result.pressing));
    }
    text += fmt::format("strain      at most {:.6g} in compression\n", result.peakStrain);
    text += fmt::format(
        "residuals   periodicity {:.3g}, gap {:.3g}, pressure {:.3g}, penetration {:.3g}, march "
        "{:.3g}, demands {:.3g}\n",
        r.periodicity, r.gap, r.pressure, r.penetration, r.march, r.demands);
    return text;
}

std::string absenceAsText(const PeriodicResult& result)
{
    std::string text =
        fmt::format("reason      {}: {}\n", name(*result.reason), explain(*result.reason));
    if (result.certificate) {
        const FarkasCertificate& c = *result.certificate;
        text += fmt::format(
            "proof       Farkas certificate, checked in integers: gap row × {}, {} rows of (30), "
            "{} "
            "of (10), {} of (12)\n",
            c.gap, c.periodicity.size(), c.pressure.size(), c.penetration.size());
    } else if (result.programProof) {
        text += fmt::format(
            "proof       Farkas certificate, checked in rationals: {} equalities and {} "
            "inequalities of the {} formulation\n",
            result.programProof->equalities.size(), result.programProof->inequalities.size(),
            name(result.proofRows));
    } else {
        text += fmt::format("proof       {} ({})\n", result.detail,
                            result.isRangeVerified ? "checked in rationals" : rangeNote);
    }
    return text;
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

Json certificateAsJson(const PeriodicResult& result)
{
    if (result.certificate) {
        const FarkasCertificate& c = *result.certificate;
        return {{"kind", "farkas"},
                {"verified", true},
                {"rows", "paper"},
                {"gap", c.gap},
                {"periodicity", multipliersAsJson(c.periodicity)},
                {"pressure", multipliersAsJson(c.pressure)},
                {"penetration", multipliersAsJson(c.penetration)}};
    }
    if (result.programProof) {
        return {{"kind", "farkas"},
                {"verified", true},
                {"rows", name(result.proofRows)},
                {"equalities", multipliersAsJson(result.programProof->equalities)},
                {"inequalities", multipliersAsJson(result.programProof->inequalities)}};
    }
    Json json{{"kind", "energy-range"}, {"verified", result.isRangeVerified}};
    if (!result.isRangeVerified) {
        json["note"] = rangeNote;
    }
    return json;
}

}  // namespace

std::string asText(const PeriodicResult& result)
{
    std::string text = fmt::format("{:<12}{}, T = {:.10g} s, ω/ω₁ = {:.10g}\n", name(result.status),
                                   describe(result.schedule), result.period, result.frequencyRatio);
    text += fmt::format("set         {}\n", setAsText(result));
    switch (result.status) {
        case Status::found:
            text += motionAsText(result);
            break;
        case Status::none:
            text += absenceAsText(result);
            break;
        case Status::undecided:
            text += fmt::format("why         {}\n", result.detail);
            break;
    }
    text += fmt::format("route       {}, {:.3g} s: {}\n", result.route, result.solver.seconds,
                        result.routeReason);
    for (std::size_t k = 0; k < result.leftOut.size(); ++k) {
        text += fmt::format("{:<12}{}\n", k == 0 ? "left out" : "", result.leftOut[k]);
    }
    return text;
}

std::string asJson(const PeriodicResult& result)
{
    const bool found = result.status == Status::found;
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
                     {"route", result.route},
                     {"route_reason", result.routeReason},
                     {"left_out", result.leftOut},
                     {"solver",
                      {{"name", result.solver.name},
                       {"iterations", result.solver.iterations},
                       {"seconds", result.solver.seconds}}}});
    if (result.kernelDimension) {
        json["kernel_dimension"] = *result.kernelDimension;
    }
    if (result.setSummary) {
        const SetSummary& set = *result.setSummary;
        json["solution_set"] = {{"kind", name(set.kind)}, {"dimension", nullptr}};
        if (set.kind != SetKind::empty) {
            json["solution_set"]["dimension"] = set.dimension;
        }
    }
    if (result.energyRange) {
        // JSON has no infinity: an unbounded or unknown end prints as null.
        json["energy_ratio_range"] = {result.energyRange->least, result.energyRange->most};
    } else if (found) {
        json["energy_ratio_range"] = {nullptr, nullptr};
    }
    if (found) {
        const Residuals& r = result.residuals;
        json["contact"] = name(result.contact);
        json["canonical_schedule"] = phasesAsJson(result.canonical);
        json["repetitions"] = result.repetitions;
        json["pressing_phases"] = result.pressing;
        json["energy"] = result.energy;
        json["energy_ratio"] = result.energyRatio;
        json["residuals"] = {
            {"periodicity", r.periodicity}, {"gap", r.gap},     {"pressure", r.pressure},
            {"penetration", r.penetration}, {"march", r.march}, {"demands", r.demands}};
        json["peak_strain"] = result.peakStrain;
    }
    if (result.reason) {
        json["reason"] = name(*result.reason);
    }
    if (result.status == Status::none) {
        json["certificate"] = certificateAsJson(result);
    }
    if (!result.detail.empty()) {
        json["detail"] = result.detail;
    }
    return json.dump() + "\n";
}

}  // namespace signorini::cli
