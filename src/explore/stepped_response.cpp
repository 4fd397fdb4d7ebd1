#include "stepped_response.hpp"

#include "contact_spans.hpp"
#include "forced_case.hpp"
#include "infinity.hpp"

namespace signorini {

std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range, std::int64_t steps,
                                                   const Cancel& cancel)
{
    const auto cells = static_cast<double>(range.cells);
    const double unit = range.place == Excited::tip ? 1.0 : cells;  // in those of the network
    const HarmonicNetwork given{networkOf(range.stops, range.segments, range.cells, range.damping),
                                range.place, unit * range.amplitude, steps, range.cycles};
    const std::vector<Excitation> shapes =
        shapesOf({range.place, range.cycles, {}}, range.cells, steps);
    const MotionFrom motionFrom = [&](const ContactStart& from) {
        const Schedule schedule{
            range.cells,
            {{from.closed, steps - from.closed, from.contact == 0 ? Stop::right : Stop::left}},
            range.stops};
        ForcedMotion motion =
            drivenMotion(schedule, range.damping, shapes, (1.0 / unit) * from.place);
        enterState(motion, range.segments, stateOf(given.network, from.start.waves));
        return motion;
    };
    const auto contacts = contactResponses(given, motionFrom, cancel);
    if (!contacts) {
        return std::nullopt;
    }
    FrequencyResponse all;
    all.steps = steps;
    all.frequencyRatio =
        4.0 * cells * static_cast<double>(range.cycles) / static_cast<double>(steps);
    all.linearPeak = contacts->front().found.linearPeak / cells;
    all.openUpTo = infinity;
    for (const auto& [found, permanent, leastPush, distance] : *contacts) {
        all.openUpTo = std::min(all.openUpTo, found.openUpTo / unit);
        all.touches = all.touches || found.touches;
        all.detail = all.undecided == 0 ? found.detail : all.detail;
        all.undecided += found.undecided;
        all.motions.insert(all.motions.end(), found.motions.begin(), found.motions.end());
        for (const AmplitudeBranch& branch : found.branches) {
            all.branches.push_back({branch.contact, branch.least / unit, branch.most / unit});
        }
        all.permanentUpTo = std::max(all.permanentUpTo, found.permanentUpTo / unit);
        if (permanent) {
            all.permanent = {leastPush, permanent->extremes, permanent->residual};
        }
    }
    return all;
}

}  // namespace signorini
