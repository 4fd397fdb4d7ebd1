// What exists: families, modes, schedules; and the response to an excitation.

#include <algorithm>

#include "reports.hpp"
#include "signorini/atlas.hpp"
#include "signorini/modes.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

constexpr int samplesOfMode = 240;
constexpr std::int64_t mostMapCells = 1200;

void addFamilies(Reply& reply, std::int64_t order, double energy)
{
    std::vector<double> rows;  // w, nu, k, T, least E/E_1
    forEachFamily(order, {.maxEnergyRatio = energy}, [&rows](const Family& family) {
        rows.insert(rows.end(),
                    {static_cast<double>(family.order), static_cast<double>(family.blocks),
                     static_cast<double>(family.contactBlocks), exactPeriod(family).value(),
                     leastEnergy(family).value()});
        return true;
    });
    reply.add("families", rows);
}

void addModes(Reply& reply, double energy)
{
    reply.json["modes"] = Json::array();
    std::vector<double> samples;  // T and E/E_1, samplesOfMode of them for each mode
    for (const Mode& mode : findModes({.maxEnergyRatio = energy})) {
        Json one = cli::jsonOf(answers::ModeOf{mode, bar});
        one["contact_text"] = cli::contactAsText(mode);
        one["lowest"] = mode.lowest.value();
        one["highest"] = mode.highest.value();
        reply.json["modes"].push_back(std::move(one));
        const double width = mode.highest.value() - mode.lowest.value();
        for (int k = 0; k < samplesOfMode; ++k) {
            const double share = (k + 0.5) / samplesOfMode;
            const double at = mode.lowest.value() + share * width;
            samples.insert(samples.end(), {at, energyRatio(mode, at)});
        }
    }
    reply.add("curves", samples);
    reply.json["samples"] = samplesOfMode;
}

void addSchedules(Reply& reply, std::int64_t cells, double energy)
{
    std::vector<double> rows;  // n_c, n_f, least E/E_1, does it press?
    AtlasRange range = usualRange(cells);
    range.maxEnergyRatio = energy;
    forEachSchedule(range, [&](const Phase& phase, const Verdict& verdict) {
        rows.insert(rows.end(),
                    {static_cast<double>(phase.contact), static_cast<double>(phase.free),
                     energyRange(verdict).least, verdict.contact == Contact::pressing ? 1.0 : 0.0});
        return true;
    });
    reply.add("schedules", rows);
}

/// The last response that was asked for, as far as it was.
struct KeptResponse {
    std::string key;
    std::vector<std::int64_t> steps;
    cli::ResponseAnswer answer;
};

/// The kept response if it answers this question, or a new one.
KeptResponse& responseFor(const Request& request)
{
    static KeptResponse kept;
    const ResponseRange range = rangeOf(request);
    const bool wantsStability = request.isOn("stability");
    const std::string key =
        Json({range.cells, range.damping.ratio, name(range.place), range.amplitude,
              range.leastFrequencyRatio, range.mostFrequencyRatio, wantsStability})
            .dump();
    if (kept.key != key) {
        kept = {key, stepsOf(range), {range, bar, bar, request.number("amplitude", 0.0, 10.0), {}}};
    }
    return kept;
}

void addResponses(Reply& reply, const std::vector<FrequencyResponse>& responses, std::size_t first)
{
    std::vector<double> lines;  // omega/omega_1, highest tip without a wall, would it touch?
    std::vector<double> rows;   // n, omega/omega_1, n_c, impulse, does it stay?
    for (std::size_t k = first; k < responses.size(); ++k) {
        const FrequencyResponse& response = responses[k];
        const auto n = static_cast<double>(response.steps);
        lines.insert(lines.end(),
                     {response.frequencyRatio, response.linearPeak, response.touches ? 1.0 : 0.0});
        for (const ForcedMotion& motion : response.motions) {
            const double stays = motion.stability == Stability::attracts ? 1.0
                                 : motion.stability == Stability::repels ? -1.0
                                                                         : 0.0;
            rows.insert(rows.end(), {n, response.frequencyRatio,
                                     static_cast<double>(motion.schedule.phases.front().contact),
                                     motion.extremes.impulse, stays});
        }
    }
    reply.add("lines", lines);
    reply.add("motions", rows);
}

}  // namespace

ResponseRange rangeOf(const Request& request)
{
    ResponseRange range;
    range.cells = request.whole("cells", 4, mostCells);
    range.damping = {request.number("damping", 1e-4, 1.0)};
    range.place = placeOf(request);
    range.amplitude = amplitudeOf(request) / amplitudeUnit(range.place, bar);
    range.leastFrequencyRatio = request.number("least", 0.1, 10.0);
    range.mostFrequencyRatio = request.number("most", 0.1, 10.0);
    return range;
}

Reply showMap(const Request& request)
{
    Reply reply;
    const double energy = request.number("energy", 1.0, 1e6);
    const std::int64_t cells = request.whole("cells", 1, mostMapCells);
    addFamilies(reply, request.whole("order", 1, 200), energy);
    addModes(reply, energy);
    addSchedules(reply, cells, energy);
    return reply;
}

Reply showFamily(const Request& request)
{
    Reply reply;
    const std::int64_t order = request.whole("order", 1, 2 * mostCells);
    const std::int64_t blocks = request.whole("nu", 1, maxFamilyOrder);
    const std::int64_t contact = request.whole("blocks", 1, maxFamilyOrder);
    const std::optional<Family> family = findFamily(order, blocks, contact);
    if (!family) {
        throw std::invalid_argument("order, nu, blocks: there is no family (" +
                                    std::to_string(order) + ", " + std::to_string(blocks) + ", " +
                                    std::to_string(contact) + ")");
    }
    // The number of cells nearest to the one asked for with w | 2N.
    const std::int64_t least = order % 2 == 0 ? order / 2 : order;
    const std::int64_t wanted = request.whole("cells", 1, mostCells);
    const std::int64_t cells = std::clamp((wanted + least / 2) / least, std::int64_t{1},
                                          std::max(mostCells / least, std::int64_t{1})) *
                               least;
    const Schedule schedule = scheduleOf(*family, cells);
    reply.json["cells"] = cells;
    reply.json["phases"] = cli::jsonOf(schedule.phases);
    return reply;
}

const cli::ResponseAnswer& responseOf(const Request& request)
{
    return responseFor(request).answer;
}

Reply showResponse(const Request& request)
{
    Reply reply;
    KeptResponse& response = responseFor(request);
    std::vector<FrequencyResponse>& done = response.answer.frequencies;
    const auto from = static_cast<std::size_t>(request.whole("done", 0, maxForcedSteps));
    const auto wanted = std::min(response.steps.size(),
                                 from + static_cast<std::size_t>(request.whole("count", 1, 1000)));
    StabilityOptions options;
    while (done.size() < wanted) {
        const std::int64_t steps = response.steps[done.size()];
        FrequencyResponse one = *responseAt(response.answer.range, steps);
        for (ForcedMotion& motion : one.motions) {
            if (request.isOn("stability")) {
                motion.stability = stabilityOf(motion, options).stability;
            }
            motion.state = {};
            motion.excitation.values = {};
        }
        done.push_back(std::move(one));
    }
    response.answer.isComplete = done.size() == response.steps.size();
    reply.json["done"] = done.size();
    reply.json["all"] = response.steps.size();
    addResponses(reply, done, std::min(from, done.size()));
    return reply;
}

}  // namespace signorini::web
