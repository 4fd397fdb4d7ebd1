#include "reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"

namespace signorini::cli {

namespace {

constexpr std::size_t maxPrintedPhases = 8;

const char* explain(Reason reason)
{
    switch (reason) {
        case Reason::noLiveClass:
            return "only the bar at rest repeats with this period: ker(W - 1) = 0";
        case Reason::contactSign:
            return "the same wave would have to push and to pull on a stop";
        case Reason::penetration:
            return "the tip would enter a stop in free flight, whatever the amplitudes";
        case Reason::gap:
            return "the tip cannot be at the stop when contact starts";
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

/// Which family, and where in its tent the schedule lies.
std::string familyAsText(const TentPlace& place)
{
    const Family& family = place.family;
    const ExactEnergy least = leastEnergy(family);
    const std::string from =
        family.windowSum == 0
            ? "of every energy"
            : fmt::format("from {} E₁", fractionAsText({least.numerator, least.denominator}));
    return fmt::format(
        "({}, {}, {}): T = {}, t_c up to {} L/c, {}; this schedule is {}", family.order,
        family.blocks, family.contactBlocks, fractionAsText(exactPeriod(family)),
        fractionAsText(longestContact(family)), from,
        place.offset == 0
            ? "its top, all its motions on this grid"
            : fmt::format("a face of it: {} of {} amplitudes", place.amplitudes, place.classes));
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

std::string energyAsText(const FoundMotion& motion, const std::optional<EnergyRange>& range,
                         bool hasUnit)
{
    if (!hasUnit) {
        return fmt::format("{:.6g} J   (without a gap every multiple is a motion)", motion.energy);
    }
    std::string text = fmt::format("{:.6g} J = {:.10g} E₁", motion.energy, motion.energyRatio);
    if (range && std::isinf(range->most)) {
        text += fmt::format("   (the set reaches from {:.10g} E₁ without bound on this grid)",
                            range->least);
    } else if (range && range->most > range->least) {
        text += fmt::format("   (the set reaches {:.10g} … {:.10g} E₁ on this grid)", range->least,
                            range->most);
    }
    return text;
}

/// What else has the energy that was held.
std::string heldAsText(const HeldEnergy& held)
{
    const std::string parts = held.components ? fmt::format("{} parts", *held.components)
                                              : std::string("more than 2^62 parts");
    return held.dimension == 0 && held.components == 1
               ? "the only motion of this energy"
               : fmt::format("the motions of this energy: dimension {}, {}", held.dimension,
                             held.isConnected ? "connected" : parts);
}

std::string motionAsText(const PeriodicResult& result)
{
    const FoundMotion& motion = *result.motion;
    const Residuals& r = motion.residuals;
    std::string text = fmt::format(
        "energy      {}\n", energyAsText(motion, result.set.energy, result.scene.bar.gap != 0.0));
    if (result.set.held) {
        text += fmt::format("            {}\n", heldAsText(*result.set.held));
    }
    const bool isClimbed =
        result.how.objective == Objective::maxEnergy && result.how.solver.name != closedForm;
    text += fmt::format("objective   {}{}\n", name(result.how.objective),
                        isClimbed ? mostFound : std::string_view());
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
    if (result.scene.secondStop) {
        text +=
            fmt::format("symmetric   {}\n",
                        motion.isSymmetric ? "yes: its second half is the first, mirrored" : "no");
    }
    text += signorini::cli::asText(motion.physical);
    text += fmt::format(
        "residuals   periodicity {:.3g}, gap {:.3g}, pressure {:.3g}, penetration {:.3g}, time "
        "stepping {:.3g}, demands {:.3g}\n",
        r.periodicity, r.gap, r.pressure, r.penetration, r.march, r.demands);
    return text;
}

std::string asText(const FarkasCertificate& c)
{
    return fmt::format(
        "Farkas certificate, checked in integers: gap row × {}, {}{} rows of (30), {} of (10), {} "
        "of "
        "(12)",
        c.gap, c.size != 0 ? fmt::format("row of size × {}, ", c.size) : "", c.periodicity.size(),
        c.pressure.size(), c.penetration.size());
}

std::string farkasAsText(const auto& multipliers, Formulation rows)
{
    return fmt::format(
        "Farkas certificate, checked in rationals: {} equalities and {} inequalities of the {} "
        "formulation",
        multipliers.equalities.size(), multipliers.inequalities.size(), name(rows));
}

std::string asText(const ProgramProof& proof)
{
    return farkasAsText(proof.multipliers, proof.rows);
}

std::string asText(const SteppedProof& proof)
{
    return farkasAsText(proof.multipliers, Formulation::joints);
}

std::string asText(const EnergyFloorProof& proof)
{
    const std::size_t strains = proof.multipliers.strains.size();
    return fmt::format(
        "none below {:.3g} E₁: multipliers of {} distances, {} pushes{} and of periodicity, "
        "checked by stepping backwards in time",
        proof.energyRatio, proof.multipliers.places.size(), proof.multipliers.pushes.size(),
        strains > 0 ? fmt::format(", {} strains", strains) : "");
}

std::string asText(const EnergyExclusion& exclusion)
{
    return fmt::format("{} ({})", describe(exclusion),
                       exclusion.isVerified ? "checked in rationals" : answers::rangeNote);
}

std::string asText(const answers::StabilityReport& report)
{
    std::string text = fmt::format("stability   ζ = {}: {}", report.damping.ratio,
                                   stabilityText(report.result, report.periods));
    if (report.result.drift > 1e-9) {
        text += fmt::format("; undisturbed it moved by up to {:.3g} m, with {} contacts",
                            report.result.drift * scales(report.bar).displacement,
                            report.result.contacts);
    }
    return text + "\n";
}

std::string absenceAsText(const Absence& absence)
{
    return fmt::format("reason      {}: {}\nproof       {}\n", name(absence.reason),
                       explain(absence.reason),
                       std::visit([](const auto& proof) { return asText(proof); }, absence.proof));
}

}  // namespace

std::string setText(const std::optional<SetKind>& kind, std::int64_t dimension,
                    const std::optional<std::int64_t>& kernelDimension)
{
    std::string text = "set         ";
    if (kind) {
        text += *kind == SetKind::empty ? "empty"
                : *kind == SetKind::point
                    ? "a single motion"
                    : fmt::format("{} of dimension {}", name(*kind), dimension);
    } else {
        text += "not known to this route";
    }
    if (kernelDimension) {
        text += fmt::format(", dim ker(W - 1) = {}", *kernelDimension);
    }
    return text + "\n";
}

std::string asText(const Provenance& how)
{
    std::string text =
        fmt::format("route       {}, {:.3g} s: {}\n", how.route, how.solver.seconds, how.reason);
    for (std::size_t k = 0; k < how.leftOut.size(); ++k) {
        text += fmt::format("{:<12}{}\n", k == 0 ? "left out" : "", how.leftOut[k]);
    }
    return text;
}

std::string asText(const Physical& p)
{
    return fmt::format(
               "frequency   {:.6g} Hz\n"
               "wall        pressed for {:.6g} s per period, force at most {:.6g} N, impulse "
               "{:.6g} N s; "
               "met at {:.6g} m/s\n"
               "tip         {:.6g} m at the lowest\n"
               "strain      at most {:.6g} in compression, {:.6g} in tension",
               p.frequency, p.contactTime, p.peakForce, p.impulse, p.approachSpeed, p.tipLowest,
               p.peakCompression, p.peakTension) +
           (p.peakStress ? fmt::format("; stress {:.6g} Pa\n", *p.peakStress) : "\n");
}

std::string asText(const answers::FindAnswer& answer, bool isVerbose)
{
    const PeriodicResult& result = answer.result;
    const auto& target = answer.target;
    std::string text = fmt::format("{:<12}{}, T = {:.10g} s, ω/ω₁ = {:.10g}\n", name(result.status),
                                   describe(result.schedule), result.period, result.frequencyRatio);
    text += setText(result.set.kind, result.set.dimension, result.set.kernelDimension);
    if (result.set.family) {
        text += fmt::format("family      {}\n", familyAsText(*result.set.family));
    }
    if (const double force = staticForce(result.scene); force > 0.0) {
        text += fmt::format("at rest     the bar presses on the wall with {:.6g} N\n", force);
    }
    switch (result.status) {
        case Status::found:
            text += motionAsText(result);
            if (target) {
                text += fmt::format("distance    {:.6g} of the target in the norm of the energy\n",
                                    *target->distance);
            }
            break;
        case Status::none:
            text += absenceAsText(*result.absence);
            if (const auto near = answer.nearSchedule()) {
                text += fmt::format("near        {} has motions\n", describe(*near));
            }
            break;
        case Status::undecided:
            text += fmt::format("why         {}\n", result.detail);
            break;
    }
    if (target) {
        text += fmt::format("target      {}\n", target->how);
    }
    if (isVerbose) {
        text += asText(result.how);
    }
    for (const answers::StabilityReport& report : answer.stability) {
        text += asText(report);
    }
    return text;
}

std::string asText(const answers::QuestionAnswer& answer, bool isVerbose)
{
    const std::int64_t cells = answer.period.cells;
    const ExactPeriod exact = exactPeriod(answer.asked.steps, cells);
    std::string text =
        fmt::format("{:<12}T = {} L/c = {:.10g} s, ω/ω₁ = {} ({} steps on {} cells)",
                    name(answer.status()), fractionAsText(exact), answer.seconds(),
                    fractionAsText(exactPeriod(4 * exact.denominator, exact.numerator)),
                    answer.asked.steps, cells);
    if (answer.energyRatio) {
        text += fmt::format(", E = {:.10g} E₁", *answer.energyRatio);
    }
    text += answer.question().nearest();
    std::string found;
    std::string others;
    std::size_t count = 0;
    for (const answers::FindAnswer& set : answer.answers) {
        const bool isFound = set.result.status == Status::found;
        count += isFound ? 1 : 0;
        (isFound ? found : others).append("\n").append(asText(set, isVerbose));
    }
    text +=
        fmt::format("\nsets        {} with this period and one contact in it, {} with a motion\n",
                    answer.answers.size(), count);
    if (const auto why = answer.detail()) {
        text += fmt::format("reason      {}\n", *why);
    }
    return text + found + others;
}

std::string bandsText(std::size_t count, const std::function<bool(std::size_t)>& holds,
                      const std::function<std::string(std::size_t, std::size_t)>& called)
{
    constexpr int most = 4;
    std::string text;
    int bands = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t first = k;
        while (k < count && holds(k)) {
            ++k;
        }
        if (k > first && ++bands <= most) {
            text += (text.empty() ? "" : ", ") + called(first, k - 1);
        }
    }
    return bands > most ? text + fmt::format(" and {} more", bands - most) : text;
}

std::string stabilityText(const StabilityResult& tried, std::int64_t periods)
{
    double least = 1e300;
    double most = 0.0;
    for (const StabilityTrial& trial : tried.trials) {
        const double times = trial.start > 0.0 ? trial.end / trial.start : 0.0;
        least = std::min(least, times);
        most = std::max(most, times);
    }
    return fmt::format(
        "{}; {} disturbances of 0.01 to 0.1 % became {:.3g} to {:.3g} times as large in {} periods",
        name(tried.stability), tried.trials.size(), least, most, periods);
}

std::string yieldText(double stress, std::optional<double> limit, const char* where)
{
    return limit ? fmt::format(": {:.3g} % of the yield stress, {} {}", 100.0 * stress / *limit,
                               stress > *limit ? "the bar yields" : "no yield", where)
                 : "";
}

std::string limitText(const std::optional<double>& strainLimit)
{
    return strainLimit
               ? fmt::format("limit       strain >= -{:.6g} everywhere, always\n", *strainLimit)
               : "";
}

std::string growthText(const std::optional<double>& growth, const std::optional<bool>& attracts)
{
    if (!growth && !attracts) {
        return {};
    }
    return fmt::format(
        "stability   {}{}\n",
        !attracts   ? "not known"
        : *attracts ? "attracts"
                    : "repels",
        growth
            ? fmt::format(": small disturbances become {:.4g} times as large in a period", *growth)
            : " (tried: disturbed a little, 150 periods)");
}

std::string limitText(const answers::HarmonicLimit& limit)
{
    return limitText(limit.strain) +
           (limit.beyond > 0 ? fmt::format("{:<12}{} motion{} beyond it, not listed\n", "",
                                           limit.beyond, limit.beyond == 1 ? "" : "s")
                             : "");
}

}  // namespace signorini::cli
