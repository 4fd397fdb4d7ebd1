// A response in words: what a machine does over its range of frequencies, worst values first.

#include <algorithm>
#include <array>

#include "reports.hpp"
#include "response_summary.hpp"
#include "segments_text.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

/// The bar without stops would meet one, and does not stay at it: it has to rattle.
bool mustRattle(const FrequencyResponse& response)
{
    return response.touches && !response.permanent;
}

SummedMotion summed(const Physical& seen, const ForcedMotion& motion)
{
    return {.force = seen.peakForce,
            .impulse = seen.impulse,
            .speed = seen.approachSpeed,
            .strain = std::max(seen.peakCompression, seen.peakTension),
            .stress = seen.peakStress,
            .called = describe(motion.schedule.phases)};
}

ResponseSummary summaryOf(const ResponseAnswer& answer)
{
    const bool hasOne = answer.range.contacts == 1;
    ResponseSummary summary{{},
                            answer.isComplete,
                            hasOne ? "with one contact" : "with one or two contacts",
                            "the linear response meets a stop",
                            hasOne ? "; see --contacts 2" : "",
                            true,
                            answer.yieldStress};
    // Listed with the number of steps ascending, so the highest frequency is the first.
    for (auto at = answer.frequencies.rbegin(); at != answer.frequencies.rend(); ++at) {
        SummedFrequency& here = summary.frequencies.emplace_back(
            SummedFrequency{.hertz = answers::hertzOf(at->frequencyRatio, answer.bar),
                            .ratio = at->frequencyRatio,
                            .mustRattle = mustRattle(*at),
                            .undecided = at->undecided,
                            .reason = at->detail});
        if (at->permanent) {
            const Physical seen = physicalOf(at->permanent->extremes, answer.bar);
            here.motions.push_back({.isImpact = false,
                                    .strain = std::max(seen.peakCompression, seen.peakTension),
                                    .stress = seen.peakStress,
                                    .called = "in contact that never opens"});
        }
        for (const ForcedMotion& motion : at->motions) {
            here.motions.push_back(summed(physicalOf(motion.extremes, answer.bar), motion));
        }
    }
    return summary;
}

void addStability(const ResponseAnswer& answer, Text& text)
{
    std::array<std::int64_t, 3> counts{};
    for (const FrequencyResponse& at : answer.frequencies) {
        for (const ForcedMotion& motion : at.motions) {
            if (motion.stability) {
                ++counts.at(static_cast<std::size_t>(*motion.stability));
            }
        }
    }
    const auto count = [&counts](Stability which) {
        return counts.at(static_cast<std::size_t>(which));
    };
    if (counts == decltype(counts){}) {
        return;  // nobody asked
    }
    print(text, "stability   tried: {} attract, {} repel, {} unclear\n", count(Stability::attracts),
          count(Stability::repels), count(Stability::unclear));
}

void addPermanent(const ResponseAnswer& answer, const ResponseSummary& summary, Text& text)
{
    const std::string held = summary.where([](const SummedFrequency& at) {
        return !at.motions.empty() && !at.motions.front().isImpact;
    });
    if (held.empty()) {
        return;
    }
    double least = 0.0;
    double most = 0.0;
    bool isFirst = true;
    for (const FrequencyResponse& at : answer.frequencies) {
        if (at.permanent) {
            least = isFirst ? at.permanent->leastForce : std::min(least, at.permanent->leastForce);
            most = std::max(most, at.permanent->extremes.peakForce);
            isFirst = false;
        }
    }
    const double unit = answers::forceUnit(answer.bar);
    print(text, "permanent   contact, {:.6g} to {:.6g} N: {}\n", least * unit, most * unit, held);
}

}  // namespace

std::string asText(const ResponseAnswer& answer)
{
    const ResponseRange& range = answer.range;
    Text text;
    print(
        text,
        "{} motions with {}{} at {} frequencies: N = {}, ζ = {}, {} of amplitude {} {}{}{}{}\n",
        answer.motions(), range.contacts > 1 ? "one or two contacts" : "one contact phase",
        range.stops.left ? " on each stop that is touched" : "", answer.frequencies.size(),
        range.cells, range.damping.ratio, range.place == Excited::tip ? "force on the tip" : "base",
        answer.amplitude, amplitudeUnitName(range.place, range.derivative),
        range.contacts > 1 ? fmt::format(", for two contacts ± {:.3g} %", 100.0 * range.band) : "",
        range.cycles > 1 ? fmt::format(", {} cycles in a period", range.cycles) : "",
        unlessComplete(answer.isComplete));
    if (!answer.scene.segments.empty()) {
        print(text, "segments    {}\n", textOf(answer.scene.segments));
    }
    const ResponseSummary summary = summaryOf(answer);
    print(text, "asked       {}\n", summary.where([](const SummedFrequency&) { return true; }));
    summary.addRattles(text, range.stops.right > 0
                                 ? ": the linear response stays clear, and is the only motion found"
                                 : "");
    addPermanent(answer, summary, text);
    summary.addGaps(text);
    summary.addWorst(text);
    if (answer.motions() > 0) {
        addStability(answer, text);
        print(text, "each motion --csv FILE.csv, --format json, --figure FILE.png\n");
    }
    return fmt::to_string(text);
}

}  // namespace signorini::cli
