// Free motions: of schedules, of continua, of modes.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "frames.hpp"
#include "reports.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

/// A scene without a gap counts displacements in L: `unit` is what they are counted in, in g of the
/// page's bar.
void addMotion(Reply& reply, const State& state, const Schedule& schedule, double unit)
{
    const Motion motion(state, schedule);
    const auto cells = static_cast<double>(motion.cells());
    const auto inSteps = [&](double t) {
        return std::min(t * cells, static_cast<double>(motion.steps()));
    };
    Frames frames(motion.cells());
    frames.take(
        static_cast<double>(motion.steps()) / cells, motion.steps(),
        [&](double x, double t) { return unit * motion.displacementAt(x * cells, inSteps(t)); },
        [&](double t) { return unit * motion.wallForce(std::llround(inSteps(t))); });
    frames.addTo(reply);
    addState(reply, {unit * state.a, unit * state.b});
}

}  // namespace

void addMode(Reply& reply, const ModeMotion& motion, std::int64_t cells)
{
    Frames frames(cells);
    frames.take(
        motion.period(),
        std::max<std::int64_t>(2, std::llround(motion.period() * static_cast<double>(cells))),
        [&](double x, double t) { return motion.displacement(x, t); },
        [&](double t) { return motion.wallForce(t); });
    frames.addTo(reply);
    addState(reply, cellMeans(motion, cells));
}

void addState(Reply& reply, const State& state)
{
    std::vector<double> x;
    for (std::int64_t i = 0; i < state.cells(); ++i) {
        x.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(state.cells()));
    }
    const Eigen::VectorXd v = velocity(state);
    const Eigen::VectorXd s = strain(state);
    reply.add("x", x);
    reply.add("v0", {v.data(), static_cast<std::size_t>(v.size())});
    reply.add("s0", {s.data(), static_cast<std::size_t>(s.size())});
}

PeriodicResult found(const Request& request)
{
    FindOptions options;
    options.scene = request.scene();
    options.energyRatio = request.positive("energy");
    return findPeriodic(request.schedule(), options);
}

const Continuum& curveOf(const Schedule& schedule, double energyRatio)
{
    static Continuum kept;
    if (kept.points.empty() || !(kept.schedule == schedule) || kept.energyRatio != energyRatio) {
        kept = traceContinuum(schedule, energyRatio, {.scene = bar});
    }
    return kept;
}

Reply showSchedule(const Request& request)
{
    Reply reply;
    const Schedule schedule = request.schedule();
    const PeriodicResult result = found(request);
    reply.json["answer"] = cli::wholeJsonOf(answers::FindAnswer{result});
    // The page has no use for the stopwatch, and two runs are to give one answer.
    reply.json["answer"]["solver"].erase("seconds");
    reply.json["pauses"] = nullptr;
    if (!result.motion) {
        return reply;
    }
    State state = result.motion->state;
    const std::optional<double> energy = request.positive("energy");
    if (energy && result.scene == Scene(bar) && schedule.phases.size() == 1 && result.set.held &&
        result.set.held->dimension > 0) {
        const Continuum& curve = curveOf(schedule, *energy);
        if (curve.status == Status::found && curve.parameter == Parameter::pause) {
            const double first = curve.points.front().lambda;
            const double last = curve.points.back().lambda;
            reply.json["pauses"] = {first, last};
            reply.json["orbits"] = curve.orbits;
            if (request.has("pause")) {
                const Member member = memberAt(curve, request.number("pause", first, last));
                state = member.point.state;
                const Physical physical =
                    physicalOf(extremesOf(member.point.state, curve.schedule), curve.scene.bar);
                reply.json["answer"]["energy_ratio"] = member.point.energyRatio;
                reply.json["answer"]["physical"] = cli::jsonOf(physical);
                reply.json["residual"] = member.point.residual;
            }
        }
    }
    addMotion(reply, state, schedule, scales(result.scene.bar).displacement / bar.gap);
    return reply;
}

Mode modeOf(const Request& request)
{
    const std::int64_t contact = request.whole("contact", 4, 4 * maxModeOrder);
    const std::int64_t turns = request.whole("turns", -maxModeOrder, -1);
    const std::optional<Mode> mode = contact % 4 == 0 ? findMode(contact / 4, turns) : std::nullopt;
    if (!mode) {
        throw std::invalid_argument("contact, turns: there is no mode with the contact time " +
                                    std::to_string(contact) + " - " + std::to_string(-turns) +
                                    " T");
    }
    return *mode;
}

Reply showMode(const Request& request)
{
    Reply reply;
    const Mode mode = modeOf(request);
    const ModeMotion motion(mode, request.number("period", 0.0, 4.0));
    reply.json["answer"] = cli::wholeJsonOf(answers::ModeAnswer{mode, bar, motion});
    addMode(reply, motion, request.whole("cells", 2, mostCells));
    return reply;
}

}  // namespace signorini::web
