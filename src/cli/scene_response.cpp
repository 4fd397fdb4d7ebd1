#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "commands.hpp"
#include "files.hpp"
#include "given.hpp"
#include "hints.hpp"
#include "printing.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "response_summary.hpp"
#include "scene_figures.hpp"
#include "scene_report.hpp"
#include "scene_response_answer.hpp"
#include "share_work.hpp"

namespace signorini::cli {

namespace {

using answers::SceneFrequency;
using answers::SceneHarmonicMotion;
using answers::SceneResponse;

bool neverOpens(const SceneHarmonicMotion& motion)
{
    return motion.inSteps && !motion.inSteps->opens;
}

/// "contact 1", "contacts 1, 2".
std::string contactsOf(const SceneHarmonicMotion& motion)
{
    if (neverOpens(motion)) {
        return "in contact that never opens";
    }
    std::string numbers;
    for (const NetworkHarmonicContact& one : motion.value.contacts) {
        numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", one.contact + 1);
    }
    return (motion.value.contacts.size() == 1 ? "contact " : "contacts ") + numbers;
}

ResponseSummary summaryOf(const SceneResponse& answer)
{
    const answers::SceneRange& range = answer.range;
    const bool hasOne = range.contacts == 1;
    // Of an exact harmonic it is not known whether contacts that are pressed at rest open.
    const auto& contacts = answer.bars.contacts;
    const bool isPressed =
        range.isExact && std::any_of(contacts.begin(), contacts.end(),
                                     [](const auto& one) { return one.gap < 0.0; });
    ResponseSummary summary{{},
                            answer.isComplete,
                            hasOne ? "with one contact" : "with one or two contacts",
                            "the linear response closes a contact",
                            range.isExact ? "; computed, not proved"
                            : hasOne      ? "; see --contacts 2"
                                          : "",
                            false,
                            answer.yieldStress};
    const NetworkScales& scales = answer.scales;
    for (const SceneFrequency& at : answer.frequencies) {
        const bool isKnown = at.distance.has_value() && !isPressed;
        SummedFrequency& here = summary.frequencies.emplace_back(SummedFrequency{
            .hertz = at.hertz,
            .ratio = at.ratio,
            .isKnown = isKnown,
            .mustRattle = isKnown && at.touches() &&
                          std::none_of(at.motions.begin(), at.motions.end(), neverOpens),
            .undecided = std::max<std::int64_t>(at.undecided, at.reason ? 1 : 0),
            .reason = at.reason.value_or("")});
        for (const SceneHarmonicMotion& motion : at.motions) {
            here.motions.push_back({.isImpact = !neverOpens(motion),
                                    .force = motion.value.peakForce * scales.force(),
                                    .impulse = motion.value.impulse * scales.force() * scales.time,
                                    .speed = motion.value.speed * scales.velocity(),
                                    .strain = motion.strains.largest(),
                                    .stress = motion.strains.stress,
                                    .called = contactsOf(motion)});
        }
    }
    std::reverse(summary.frequencies.begin(), summary.frequencies.end());
    return summary;
}

/// How many motions attract, where that is known of any.
std::string stabilityText(const SceneResponse& answer)
{
    std::array<std::size_t, 3> counts{};  // repel, attract, not known
    for (const SceneFrequency& at : answer.frequencies) {
        for (const SceneHarmonicMotion& motion : at.motions) {
            const std::optional<bool> attracts = motion.attracts();
            ++counts.at(attracts ? (*attracts ? 1 : 0) : 2);
        }
    }
    const auto [repelling, attracting, unknown] = counts;
    return repelling + attracting == 0
               ? std::string()
               : fmt::format("stability   {} attract, {} repel, of {} it is not known\n",
                             attracting, repelling, unknown);
}

/// The motions with two contacts, in steps each at an amplitude of its own.
std::string pairsText(const SceneResponse& answer)
{
    constexpr int most = 6;
    const answers::SceneRange& range = answer.range;
    if (range.contacts < 2) {
        return {};
    }
    if (range.isExact) {
        const auto settled = std::count_if(
            answer.frequencies.begin(), answer.frequencies.end(), [](const SceneFrequency& at) {
                return std::any_of(at.motions.begin(), at.motions.end(),
                                   std::mem_fn(&SceneHarmonicMotion::hasTwoContacts));
            });
        return fmt::format("two         contacts at {} of them: what bars at rest settle on\n",
                           settled);
    }
    std::string text;
    int count = 0;
    for (const SceneFrequency& at : answer.frequencies) {
        for (const SceneHarmonicMotion& motion : at.motions) {
            if (motion.hasTwoContacts() && count++ < most) {
                text += fmt::format("            {} at {:.6g} Hz, amplitude {:.6g} {}\n",
                                    textOf(motion.inSteps->spans), at.hertz,
                                    motion.inSteps->amplitude, amplitudeUnitName(range.place, 0));
            }
        }
    }
    return fmt::format("two         contacts: {} motions, of amplitudes within {:.3g} %{}\n{}",
                       count, 100.0 * range.band,
                       count > most ? fmt::format("; the first {}", most) : std::string(), text);
}

std::string asText(const SceneResponse& answer)
{
    const answers::SceneRange& range = answer.range;
    std::string text = fmt::format(
        "{:<12}{} of amplitude {:.6g} {}, {}, {:.6g} … {:.6g} Hz{}\n", name(answer.status()),
        range.place == Excited::tip ? "force on what is driven" : "moving base", range.amplitude,
        amplitudeUnitName(range.place, range.derivative),
        range.isExact ? "an exact harmonic" : "a harmonic in steps", range.leastHertz,
        range.mostHertz, unlessComplete(answer.isComplete));
    text += fmt::format("{} at {} of {} frequencies\n",
                        range.contacts > 1 ? "one or two contacts" : "one contact",
                        std::count_if(answer.frequencies.begin(), answer.frequencies.end(),
                                      [](const SceneFrequency& at) { return !at.motions.empty(); }),
                        answer.frequencies.size());
    const ResponseSummary summary = summaryOf(answer);
    Text lines;
    summary.addRattles(lines, ": the linear response stays clear");
    const std::string held = summary.where([](const SummedFrequency& at) {
        return !at.motions.empty() && !at.motions.front().isImpact;
    });
    if (!held.empty()) {
        print(lines, "permanent   contact: {}\n", held);
    }
    summary.addGaps(lines);
    summary.addWorst(lines);
    return text + pairsText(answer) + fmt::to_string(lines) + stabilityText(answer);
}

void writeSceneResponseCsv(const std::string& path, const SceneResponse& answer)
{
    constexpr std::string_view header =
        "steps,frequency_ratio,frequency,amplitude,touches,motion,contact,contact_time,release,"
        "phase,impulse,peak_force,speed,residual,stability,compression,tension,"
        "growth,attracts,spans,motion_amplitude";
    writeCsv(path, header, [&](CsvRows& row) {
        for (const SceneFrequency& at : answer.frequencies) {
            const auto put = [&](const auto&... values) {
                row(at.steps, at.ratio, at.hertz, at.amplitude, at.touches(), values...);
            };
            if (at.motions.empty()) {
                put(",,,,,,,,,,,,,,,");
            }
            for (std::size_t k = 0; k < at.motions.size(); ++k) {
                const SceneHarmonicMotion& motion = at.motions[k];
                const auto& [value, scales, strains, inSteps] = motion;
                const bool isTried = inSteps && inSteps->stability;
                put(k, value.first().contact + 1, value.contactTime() * scales.time,
                    motion.release(), value.phase, value.impulse * scales.force() * scales.time,
                    value.peakForce * scales.force(), value.speed * scales.velocity(),
                    value.residual,
                    isTried ? name(inSteps->stability->result.stability) : std::string_view(),
                    strains.compression, strains.tension, value.growth, motion.attracts(),
                    inSteps && motion.hasTwoContacts() ? textOf(inSteps->spans) : std::string(),
                    motion.ofTwo(&SceneHarmonicMotion::InSteps::amplitude));
            }
        }
    });
}

void writeSceneMapCsv(const std::string& path, const SceneResponse& answer)
{
    constexpr std::string_view header =
        "steps,frequency_ratio,frequency,which,contact,free,least_amplitude,most_amplitude,"
        "second,second_contact,second_free";
    constexpr std::string_view noSecond = ",,";
    writeCsv(path, header, [&](CsvRows& row) {
        for (const SceneFrequency& at : answer.frequencies) {
            const auto put = [&](const auto&... values) {
                row(at.steps, at.ratio, at.hertz, values...);
            };
            if (at.amplitudes->open) {
                put(std::string_view(), 0, at.steps, 0.0, answers::known(*at.amplitudes->open),
                    noSecond);
            }
            for (const auto& [contact, branch] : at.amplitudes->closed) {
                put(contact + 1, branch.contact, at.steps - branch.contact, branch.least,
                    answers::known(branch.most), noSecond);
            }
            for (const auto& [phases, least, most] : at.amplitudes->pairs) {
                const auto& [first, second] = phases;
                put(static_cast<int>(first.stop) + 1, first.contact, first.free, least,
                    answers::known(most), static_cast<int>(second.stop) + 1, second.contact,
                    second.free);
            }
        }
    });
}

}  // namespace

ExitStatus respondInBars(const Given& given, const CommonOptions& common, const ForceOptions& force,
                         const Assembly& assembly)
{
    refuseIf(given.has("--force-steps"),
             "--force-steps: allowed of a uniform bar: of others the steps are given");
    refuseIf(given.has("--backbone-csv"),
             "--backbone-csv: allowed of a uniform bar, whose modes are known");
    const bool isExact = given.has("--exact");
    for (const char* option : {"--map", "--map-csv"}) {
        refuseIf(
            given.has(option) && (isExact || force.derivative > 0), option, given.text(option),
            "only with --amplitude, without --exact: at other amplitudes an exact harmonic has "
            "contacts of other times");
    }
    refuseIf(isExact && given.has("--stability"),
             "--stability: allowed without --exact, which says by itself how disturbances grow");
    refuseIf(common.choosesCells, "--cells", given.text("--cells"),
             "a number, or auto for a uniform bar: of others the cells are given");
    SceneResponse answer = answers::responseAsked(given, assembly);
    const std::vector<std::int64_t> steps = stepsOf(answer);
    Outputs outputs(given, {"--csv", "--map-csv", "--figure", "--map"});
    watched(common, "frequencies", [&](const answers::Watch& watch) {
        answer.frequencies = shareOut(
            steps, common.threads,
            [&](std::int64_t n) { return frequencyAt(answer, n, watch.cancel); }, watch.show);
        answer.isComplete = answer.frequencies.size() == steps.size();
    });
    if (answer.isComplete) {
        outputs.put("--csv", writeSceneResponseCsv, answer);
        outputs.put("--map-csv", writeSceneMapCsv, answer);
        outputs.draw("--figure", [&] { return sceneResponseFigure(answer); });
        outputs.draw("--map", [&] { return sceneMapFigure(answer); });
        outputs.commit();
    } else {
        common.say("interrupted; the list is not complete");
    }
    report(common, answer, assembly, asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
