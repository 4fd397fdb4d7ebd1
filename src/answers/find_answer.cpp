#include "find_answer.hpp"

#include <algorithm>
#include <cmath>

#include "arrivals.hpp"
#include "contact_spans.hpp"
#include "demand_names.hpp"
#include "faults.hpp"
#include "near_schedule.hpp"
#include "stepped_bar.hpp"

namespace signorini::answers {

FindOptions searchAsked(const Call& call)
{
    FindOptions options;
    options.solver = call.has("--solver") ? call.text("--solver") : options.solver;
    options.objective = call.named("--objective", objectiveNames).value_or(options.objective);
    call.read("--tolerance", options.tolerance);
    call.read("--time-limit", options.timeLimit);
    const bool isNearest = options.objective == Objective::nearest;
    refuseIf(isNearest && !call.has("--target"),
             fmt::format("{} is missing: {} needs a state file", call.called("--target"),
                         call.with("--objective", "nearest")));
    refuseIf(!isNearest && call.has("--target"),
             fmt::format("{} clashes with {}: allowed only nearest", call.called("--target"),
                         call.called("--objective")));
    return options;
}

FindOptions findAsked(const Call& call, const Scene& scene)
{
    FindOptions options = searchAsked(call);
    const Bar units = unitsOf(scene);
    options.scene = scene;
    options.formulation =
        call.named("--formulation", formulationNames).value_or(options.formulation);
    options.energyRatio = energyAsked(call, units);
    call.read("--strain-limit", options.strainLimit);
    options.strainLimit /= scales(units).strain;
    call.read("--tip-floor", options.tipFloor);
    if (std::isfinite(options.tipFloor) && !(options.tipFloor < scene.bar.gap)) {
        refuse("--tip-floor", fmt::format("{}", options.tipFloor), "below the gap [m]");
    }
    options.tipFloor /= scales(scene.bar).displacement;
    return options;
}

std::optional<double> energyAsked(const Call& call, const Bar& bar)
{
    requireOneEnergy(call);
    const auto energy = call.number("--energy");
    if (!energy) {
        return call.number("--energy-ratio");
    }
    const double ratio = *energy / scales(bar).energy;
    refuseIf(!std::isfinite(ratio), "--energy", fmt::format("{}", *energy),
             "what is finite in E_1");
    return ratio;
}

Bar unitsOf(const Scene& scene)
{
    return unitsOfBar(scene);
}

double forceUnit(const Bar& bar)
{
    return bar.axialStiffness * scales(bar).strain;
}

double impulseUnit(const Bar& bar)
{
    return forceUnit(bar) * scales(bar).time;
}

std::vector<StopPlace> stopsIn(const Scene& scene)
{
    std::vector<StopPlace> stops{{Stop::right, scene.bar.gap}};
    if (scene.secondStop) {
        stops.push_back({Stop::left, -*scene.secondStop});
    }
    return stops;
}

void requireTried(std::int64_t steps)
{
    constexpr std::int64_t most = 1'000'000;
    if (steps > most) {
        throwFault("steps of a period", steps,
                   fmt::format("at most {} where stability is tried", most));
    }
}

void tryStability(FindAnswer& answer, const Cancel& cancel)
{
    const PeriodicResult& result = answer.result;
    for (const double ratio : {0.0, 0.001}) {
        if (result.motion) {
            StabilityOptions options;
            options.cancel = cancel;
            options.segments = result.scene.segments;
            answer.stability.push_back(
                {{ratio},
                 options.periods,
                 stabilityOf(result.motion->state, result.schedule, {ratio}, options),
                 result.scene.bar});
        }
    }
}

FindAnswer answerOf(PeriodicResult result, const FindOptions& options, const std::string& how)
{
    FindAnswer answer{std::move(result)};
    if (const auto& target = options.target) {
        answer.target = {how, {}};
        if (const auto& motion = answer.result.motion) {
            const State& at = motion->state;
            answer.target->distance =
                std::sqrt(energyRatio({at.a - target->a, at.b - target->b}) / energyRatio(*target));
        }
    }
    return answer;
}

std::optional<Schedule> FindAnswer::nearSchedule() const
{
    const Scene& scene = result.scene;
    const bool hasNone = result.absence && result.absence->reason != Reason::constraints;
    if (!hasNone || scene.secondStop || !isUniform(scene.segments)) {
        return std::nullopt;
    }
    return signorini::nearSchedule(result.schedule, stopsOf(scene).right);
}

std::optional<std::string> FindAnswer::detail() const
{
    const auto* exclusion =
        result.absence ? std::get_if<EnergyExclusion>(&result.absence->proof) : nullptr;
    if (!result.detail.empty()) {
        return result.detail;
    }
    return exclusion != nullptr ? std::optional(describe(*exclusion)) : std::nullopt;
}

std::optional<EnergyRange> FindAnswer::energies() const
{
    if (result.set.energy && hasUnit()) {
        return result.set.energy;
    }
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return result.motion ? std::optional(EnergyRange{unknown, unknown}) : std::nullopt;
}

std::optional<std::vector<double>> FindAnswer::approachSpeeds() const
{
    if (!result.motion || result.motion->state.cells() == 0) {
        return keptSpeeds;
    }
    const FoundMotion& motion = *result.motion;
    const std::vector<Segment>& segments = result.scene.segments;
    const Schedule walked =
        isUniform(segments) ? foldedFor(motion.state, result.schedule) : result.schedule;
    if (steps(walked) > Motion::maxKeptValues) {
        return std::nullopt;  // a schedule from a file can be of any length
    }
    const Network network = networkOf(result.scene, walked.cells);
    NetworkWaves<double> waves(network, wavesOf(network, motion.state));
    const NetworkLaw<double> held(network, 1);
    const NetworkLaw<double> open(network, 0);
    const std::size_t atTip = 2 * (network.rows.size() - 1);
    const double least = 1e-9 * amplitude(motion.state);
    const double unit = 2.0 * scales(firstMaterial(result.scene)).velocity;
    std::vector<double> speeds;
    double before = 0.0;       // of the tip when it moved last, since the last contact
    bool isFromBefore = true;  // did the first contact follow a motion in the period before?
    bool wasPressed = false;
    const auto step = [&](bool isHeld) {
        const double p = std::abs(waves.arriving()[atTip]);
        const bool isPressed = isHeld && p > least;
        if (isPressed && !wasPressed) {
            speeds.push_back(unit * before);
        }
        if (isPressed) {
            before = 0.0;
        } else if (p > least) {
            before = p;
            isFromBefore = isFromBefore && !speeds.empty();
        }
        wasPressed = isPressed;
        waves.step(isHeld ? held : open);
    };
    for (const Phase& phase : walked.phases) {
        for (std::int64_t m = 0; m < phase.contact + phase.free; ++m) {
            step(m < phase.contact);
        }
    }
    if (isFromBefore && !speeds.empty()) {
        speeds.front() = unit * before;
    }
    speeds.resize(std::min(speeds.size(), motion.canonical.size()));
    return speeds;
}

}  // namespace signorini::answers
