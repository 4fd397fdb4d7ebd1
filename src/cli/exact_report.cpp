#include "reports.hpp"

#include <algorithm>

#include "printing.hpp"
#include "response_summary.hpp"

namespace signorini::cli {

using answers::ExactAnswer;

namespace {

/// "in 12 of 30 periods".
std::string countOf(const ExactAnswer& answer, std::size_t least)
{
    const auto count = std::count_if(
        answer.frequencies.begin(), answer.frequencies.end(), [&](const ExactFrequency& at) {
            return std::any_of(at.motions.begin(), at.motions.end(), [&](const ExactMotion& one) {
                return (one.motion.contacts.size() > 1) == (least > 1);
            });
        });
    return fmt::format("at {} of {} frequencies", count, answer.frequencies.size());
}

ResponseSummary summaryOf(const ExactAnswer& answer)
{
    // Of a bar that is pressed at rest it is not known whether contact opens.
    const bool isPressed = answer.range.stops.right < 0;
    ResponseSummary summary{
        {},    answer.isComplete, "in the list", "the linear response meets a stop", "",
        false, answer.yieldStress};
    for (auto at = answer.frequencies.rbegin(); at != answer.frequencies.rend(); ++at) {
        SummedFrequency& here = summary.frequencies.emplace_back(
            SummedFrequency{.hertz = answers::hertzOf(at->frequencyRatio, answer.bar),
                            .ratio = at->frequencyRatio,
                            .isKnown = !isPressed,
                            .mustRattle = at->touches && !isPressed});
        for (const ExactMotion& one : at->motions) {
            const Physical seen = physicalOf(one.motion.extremes, answer.bar);
            const std::size_t count = one.motion.contacts.size();
            here.motions.push_back(
                {.force = seen.peakForce,
                 .impulse = seen.impulse,
                 .speed = seen.approachSpeed,
                 .strain = std::max(seen.peakCompression, seen.peakTension),
                 .stress = seen.peakStress,
                 .called = count == 1 ? "one contact" : fmt::format("{} contacts", count)});
        }
    }
    return summary;
}

}  // namespace

std::string asText(const ExactAnswer& answer)
{
    Text text;
    const auto hertz = [&](double ratio) { return answers::hertzOf(ratio, answer.bar); };
    print(text, "{:<12}{} of amplitude {:.6g} {}, an exact harmonic, {:.6g} … {:.6g} Hz{}\n",
          name(answer.status()),
          answer.range.place == Excited::tip ? "force on the tip" : "base moving", answer.amplitude,
          answer.range.place == Excited::tip ? "N" : "m", hertz(answer.range.leastFrequencyRatio),
          hertz(answer.range.mostFrequencyRatio), unlessComplete(answer.isComplete));
    print(text, "one contact {}{}\n", countOf(answer, 1), answer.isComplete ? ": all of them" : "");
    print(text,
          "several     {}: what a bar at rest settles on, where one is not known to attract\n",
          countOf(answer, 2));
    const ResponseSummary summary = summaryOf(answer);
    summary.addRattles(text, ": the linear response stays clear");
    summary.addGaps(text);
    summary.addWorst(text);
    for (const ExactBranch& branch : answer.branches) {
        const auto& points = branch.curve.points;
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [](const BranchPoint& x, const BranchPoint& y) {
                return x.frequencyRatio < y.frequencyRatio;
            });
        const auto attracting =
            std::count_if(branch.stability.begin(), branch.stability.end(),
                          [](const auto& one) { return one.attracts.value_or(false); });
        print(text, "branch      {:.6g} … {:.6g} Hz, {} points, {} attract",
              hertz(low->frequencyRatio), hertz(high->frequencyRatio), points.size(), attracting);
        for (const BranchMark& mark : branch.curve.marks) {
            if (mark.event != BranchEvent::end) {
                print(text, "; {} at {:.6g} Hz", name(mark.event), hertz(mark.frequencyRatio));
            }
        }
        print(text, "\n");
    }
    return fmt::to_string(text);
}

void writeExactCsv(const std::string& path, const ExactAnswer& answer)
{
    constexpr std::string_view header =
        "steps,frequency_ratio,frequency,touches,linear_peak,motion,contacts,cycles,contact,"
        "begin,end,stop,release,impulse,peak_force,speed,phase,growth,attracts,residual,"
        "peak_compression,peak_tension,peak_stress";
    const Scales unit = scales(answer.bar);
    writeCsv(path, header, [&](CsvRows& row) {
        for (const ExactFrequency& at : answer.frequencies) {
            const std::string begin = fmt::format("{},{},{},{:d},{}", at.steps, at.frequencyRatio,
                                                  answers::hertzOf(at.frequencyRatio, answer.bar),
                                                  at.touches, at.linearPeak * unit.displacement);
            if (at.motions.empty()) {
                row(begin, ",,,,,,,,,,,,,,,,,");
            }
            for (std::size_t k = 0; k < at.motions.size(); ++k) {
                const auto& [given, motion, stability] = at.motions[k];
                const Physical physical = physicalOf(motion.extremes, answer.bar);
                for (std::size_t c = 0; c < motion.contacts.size(); ++c) {
                    const HarmonicContact& one = motion.contacts[c];
                    row(begin, k, motion.contacts.size(), given.cycles, c, one.begin * unit.time,
                        one.end * unit.time, one.stop, answers::releaseOf(one),
                        one.impulse * answers::impulseUnit(answer.bar),
                        one.peakForce * answers::forceUnit(answer.bar), one.speed * unit.velocity,
                        motion.phase, stability.growth, stability.attracts, motion.residual,
                        physical.peakCompression, physical.peakTension, physical.peakStress);
                }
            }
        }
    });
}

}  // namespace signorini::cli
