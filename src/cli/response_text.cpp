// A response in words: what a machine does over its range of frequencies, worst values first.

#include <algorithm>
#include <array>
#include <functional>

#include "reports.hpp"
#include "segments_text.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

using Holds = std::function<bool(const FrequencyResponse&)>;

/// "400 … 410 Hz (0.95 … 0.98 ω₁), 530 Hz (1.26 ω₁) and 2 more"; empty: nowhere.
std::string where(const ResponseAnswer& answer, const Holds& holds)
{
    // Listed with the number of steps ascending, so the highest frequency is the first.
    const std::vector<FrequencyResponse>& all = answer.frequencies;
    const auto at = [&all](std::size_t k) -> const auto&
    {
        return all[all.size() - 1 - k];
    };
    return bandsText(
        all.size(), [&](std::size_t k) { return holds(at(k)); },
        [&](std::size_t first, std::size_t last) {
            const double low = at(first).frequencyRatio;
            const double high = at(last).frequencyRatio;
            const auto hertz = [&answer](double ratio) {
                return answers::hertzOf(ratio, answer.bar);
            };
            return first == last ? fmt::format("{:.6g} Hz ({:.4g} ω₁)", hertz(low), low)
                                 : fmt::format("{:.6g} … {:.6g} Hz ({:.4g} … {:.4g} ω₁)",
                                               hertz(low), hertz(high), low, high);
        });
}

/// The bar without stops would meet one, and does not stay at it: it has to rattle.
bool mustRattle(const FrequencyResponse& response)
{
    return response.touches && !response.permanent;
}

bool canRattle(const FrequencyResponse& response)
{
    return !response.motions.empty() || mustRattle(response);
}

/// The largest of one number over all motions, and where.
struct Worst {
    double value = 0.0;
    const FrequencyResponse* at = nullptr;
    const ForcedMotion* motion = nullptr;  ///< none: contact that never opens
};

void keepLarger(Worst& worst, double value, const FrequencyResponse& at, const ForcedMotion* motion)
{
    if (worst.at == nullptr || value > worst.value) {
        worst = {value, &at, motion};
    }
}

void addWorst(const ResponseAnswer& answer, Text& text)
{
    Worst force;
    Worst impulse;
    Worst speed;
    Worst stress;
    Worst strain;
    const auto keepStrain = [&](const Physical& seen, const FrequencyResponse& at,
                                const ForcedMotion* motion) {
        keepLarger(stress, seen.peakStress.value_or(0.0), at, motion);
        keepLarger(strain, std::max(seen.peakCompression, seen.peakTension), at, motion);
    };
    for (const FrequencyResponse& at : answer.frequencies) {
        if (at.permanent) {
            keepStrain(physicalOf(at.permanent->extremes, answer.bar), at, nullptr);
        }
        for (const ForcedMotion& motion : at.motions) {
            const Physical physical = physicalOf(motion.extremes, answer.bar);
            keepLarger(force, physical.peakForce, at, &motion);
            keepLarger(impulse, physical.impulse, at, &motion);
            keepLarger(speed, physical.approachSpeed, at, &motion);
            keepStrain(physical, at, &motion);
        }
    }
    const auto line = [&](const char* label, const Worst& worst, const char* unit,
                          const std::string& remark = {}) {
        if (worst.at != nullptr) {
            print(text, "{:<12}at most {:.6g} {} at {:.6g} Hz, {}{}\n", label, worst.value, unit,
                  answers::hertzOf(worst.at->frequencyRatio, answer.bar),
                  worst.motion != nullptr ? describe(worst.motion->schedule.phases)
                                          : "in contact that never opens",
                  remark);
        }
    };
    line("force", force, "N");
    line("impulse", impulse, "N s per period");
    line("speed", speed, "m/s before an impact");
    if (!answer.bar.young) {
        line("strain", strain, "[-]");
        return;
    }
    line("stress", stress, "Pa", yieldText(stress.value, answer.yieldStress, "in these motions"));
}

/// Frequencies where the list may not be all there is.
void addGaps(const ResponseAnswer& answer, Text& text)
{
    const bool hasOne = answer.range.contacts == 1;
    const std::string unmet = where(answer, [](const FrequencyResponse& at) {
        return at.motions.empty() && mustRattle(at) && at.undecided == 0;
    });
    if (!unmet.empty()) {
        print(text, "no motion   with {}, though the linear response meets a stop: {}{}\n",
              hasOne ? "one contact" : "one or two contacts", unmet,
              hasOne ? "; see --contacts 2" : "");
    }
    if (answer.undecided() > 0) {
        const auto first =
            std::find_if(answer.frequencies.begin(), answer.frequencies.end(),
                         [](const FrequencyResponse& at) { return at.undecided > 0; });
        print(text, "undecided   {} schedules: {}; the first: {}\n", answer.undecided(),
              where(answer, [](const FrequencyResponse& at) { return at.undecided > 0; }),
              first->detail);
    }
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

void addPermanent(const ResponseAnswer& answer, Text& text)
{
    const std::string held =
        where(answer, [](const FrequencyResponse& at) { return at.permanent.has_value(); });
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
        answer.isComplete ? "" : ": interrupted, the list is not complete");
    if (!answer.scene.segments.empty()) {
        print(text, "segments    {}\n", textOf(answer.scene.segments));
    }
    print(text, "asked       {}\n", where(answer, [](const FrequencyResponse&) { return true; }));
    const std::string all = where(answer, canRattle);
    const std::string must = where(answer, mustRattle);
    if (all.empty()) {
        print(text, "rattles     nowhere{}\n",
              answer.undecided() > 0 ? " that was decided"
              : range.stops.right > 0
                  ? ": the linear response stays clear, and is the only motion found"
                  : "");
    } else {
        print(text, "rattles     can: {}; must, as the linear response meets a stop: {}\n", all,
              must.empty() ? "nowhere" : must);
    }
    addPermanent(answer, text);
    addGaps(answer, text);
    addWorst(answer, text);
    if (answer.motions() > 0) {
        addStability(answer, text);
        print(text, "each motion --csv FILE.csv, --format json, --figure FILE.png\n");
    }
    return fmt::to_string(text);
}

}  // namespace signorini::cli
