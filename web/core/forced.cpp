// Forced motions, and what the bar does from any state.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "excited_names.hpp"
#include "frames.hpp"
#include "measurements.hpp"
#include "names.hpp"
#include "signorini/settling.hpp"
#include "text_of.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

constexpr double mostDamping = 1.0;
constexpr double mostAmplitude = 10.0;  // [N] or [m], of a bar with EA g/L = 1 mN and g = 1 mm

}  // namespace

Excited placeOf(const Request& request)
{
    const std::string word = request.word("place");
    const auto place = valueIn(excitedNames, word);
    if (!place) {
        throw std::invalid_argument("place = " + word + ": allowed " + namesIn(excitedNames));
    }
    return *place;
}

double amplitudeOf(const Request& request)
{
    return request.number("amplitude", 1e-9, mostAmplitude);
}

namespace {

/// `rows` + 1 looks at a simulation that goes on for so many of its units, `crossings` L/c: its
/// displacements, and the mean force of the wall until the next look.
void film(Reply& reply, BarSimulation& simulation, std::int64_t cells, std::int64_t rows,
          double duration, double crossings)
{
    Frames frames(cells);
    const auto count = static_cast<double>(rows);
    const double begin = simulation.time();
    for (std::int64_t k = 0; k <= rows; ++k) {
        frames.times.push_back(begin + crossings * static_cast<double>(k) / count);
        const double base = simulation.base();
        for (const double value : stretching(simulation.waves(), frames.places)) {
            frames.u.push_back(base + value);
        }
        frames.tip.push_back(frames.u.back());
        const double before = simulation.impulse();
        if (k < rows) {
            simulation.advance(duration / count);
        }
        frames.force.push_back(k < rows ? (simulation.impulse() - before) * count / crossings
                                        : frames.force.back());
    }
    frames.pathTimes = frames.times;
    frames.addTo(reply);
}

/// The hand's place [L] and how far [g] it has pulled the bar.
struct Pluck {
    double place;
    double drawn;

    explicit Pluck(const Request& start)
        : place(start.number("place", 0.05, 1.0)), drawn(start.number("displacement", -20.0, 1.0))
    {
    }
    /// x [L] and u [m], as the table has them. The part beyond the hand is not strained: its tip is
    /// free.
    [[nodiscard]] std::vector<std::array<double, 2>> rows() const
    {
        std::vector<std::array<double, 2>> rows{{0.0, 0.0}, {place, drawn * bar.gap}};
        if (place < 1.0) {
            rows.push_back({1.0, drawn * bar.gap});
        }
        return rows;
    }
};

/// The state that `simulate --from` reads from the table of a pluck.
Waves startOf(const Request& start, std::int64_t cells, double base)
{
    if (start.word("kind") == "rest") {
        return wavesAtRest(static_cast<double>(cells), {}, base);
    }
    Measurements measured;
    measured.isDisplacement = true;
    for (const auto& [x, u] : Pluck(start).rows()) {
        measured.x.push_back(x);
        measured.velocity.push_back(0.0);
        measured.other.push_back(u / bar.gap);
    }
    return wavesOf(onCells(measured, cells));
}

/// What is asked of a simulation: "cells", "start", "damping", and either "crossings" L/c, or a
/// harmonic of "steps" a period at "place" with "amplitude" for "periods".
struct Course {
    std::int64_t cells;
    Waves start;
    Damping damping;
    Excitation excitation;
    double stretch;      ///< a period or 16 L/c, in steps
    double total;        ///< in stretches
    double phase = 0.0;  ///< [rad], of the harmonic

    /// Of the excitation [L/c]; 0 without.
    [[nodiscard]] double period() const
    {
        return static_cast<double>(excitation.steps()) / excitation.stepsPerCrossing;
    }
};

/// In all, which a page takes seconds for; longer runs are a matter for the command line.
constexpr std::int64_t mostExcitedSteps = 20'000'000;

/// That one of at most two which is asked for by "which".
const ForcedMotion& forcedMotionOf(const Request& request, const answers::ForcedAnswer& answer)
{
    if (answer.motions.empty()) {
        throw std::invalid_argument("there is no such forced motion");
    }
    const auto which = static_cast<std::size_t>(request.whole("which", 0, 1));
    return answer.motions[std::min(which, answer.motions.size() - 1)].value;
}

/// A forced motion, made a little smaller: it starts short of the wall.
State besideState(const Request& request, const ForcedMotion& motion)
{
    const double share = request.part("start").number("share", 0.5, 1.0);
    return {share * motion.state.a, share * motion.state.b};
}

Course courseOf(const Request& request)
{
    const std::int64_t cells = request.whole("cells", 2, mostCells);
    const auto perCrossing = static_cast<double>(cells);
    Course course{cells,
                  {},
                  {request.number("damping", 0.0, mostDamping)},
                  {.stepsPerCrossing = perCrossing},
                  16.0 * perCrossing,
                  0.0};
    if (request.has("steps")) {
        const Excited place = placeOf(request);
        course.excitation =
            excitationOf({.place = place,
                          .amplitude = amplitudeOf(request) / amplitudeUnit(place, bar),
                          .steps = request.whole("steps", 3, 100 * cells),
                          .stepsPerCrossing = perCrossing});
        course.stretch = static_cast<double>(course.excitation.steps());
        course.total = static_cast<double>(request.whole(
            "periods", 1,
            std::min<std::int64_t>(2000, mostExcitedSteps / course.excitation.steps())));
    } else {
        course.total = request.number("crossings", 0.1, 1000.0) * perCrossing / course.stretch;
    }
    const Request start = request.part("start");
    if (start.word("kind") == "beside") {
        const ForcedMotion motion = forcedMotionOf(request, forcedAnswer(request));
        course.excitation = motion.excitation;
        course.phase = motion.phase;
        course.start = wavesOf(besideState(request, motion));
        return course;
    }
    course.start = startOf(start, cells, course.excitation.baseDisplacement(0));
    return course;
}

}  // namespace

std::string startTable(const Request& request)
{
    const Request start = request.part("start");
    if (start.word("kind") == "beside") {
        const State state = besideState(request, forcedMotionOf(request, forcedAnswer(request)));
        return textOf([&](const std::string& path) { writeStateCsv(path, state, bar); });
    }
    std::string table = "x,velocity,displacement\n";
    for (const auto& [x, u] : Pluck(start).rows()) {
        table += fmt::format("{},0,{}\n", x * bar.length, u);
    }
    return table;
}

answers::ForcedAnswer forcedAnswer(const Request& request)
{
    const Excited place = placeOf(request);
    const double amplitude = amplitudeOf(request);
    return answers::answerOf(
        forcedMotions(request.schedule(), {request.number("damping", 1e-6, mostDamping)},
                      {.place = place}),
        bar, amplitude);
}

Reply showForced(const Request& request)
{
    Reply reply;
    const answers::ForcedAnswer answer = forcedAnswer(request);
    reply.json["answer"] = cli::wholeJsonOf(answer);
    if (answer.motions.empty()) {
        return reply;
    }
    const ForcedMotion& motion = forcedMotionOf(request, answer);
    reply.json["which"] = &motion == &answer.motions.front().value ? 0 : 1;
    BarSimulation simulation(wavesOf(motion.state), motion.damping, motion.excitation);
    const std::int64_t count = steps(answer.set.schedule);
    film(reply, simulation, answer.set.schedule.cells, std::min(count, 2 * mostRows),
         static_cast<double>(count), period(answer.set.schedule));
    addState(reply, motion.state);
    return reply;
}

Simulated simulated(const Request& request, bool recordsTip)
{
    const Course course = courseOf(request);
    const bool isForced = course.excitation.steps() > 0;
    Simulated result{{.scene = bar,
                      .damping = course.damping,
                      .cells = course.cells,
                      .resolution = 1.0 / static_cast<double>(course.cells)},
                     BarSimulation(course.start, course.damping, course.excitation,
                                   {.mergeBelow = {},
                                    .recordsTip = recordsTip,
                                    .stops = {},
                                    .segments = {},
                                    .resolution = 1.0 / static_cast<double>(course.cells)}),
                     {}};
    if (isForced) {
        result.answer.drive = answers::Drive{.place = course.excitation.place,
                                             .amplitude = amplitudeOf(request),
                                             .frequencyRatio = 4.0 / course.period(),
                                             .phase = course.phase};
        result.answer.drive->follow(course.excitation, bar);
    }
    double before = 0.0;
    const Followed followed =
        follow(result.simulation, course.stretch, course.total, {}, [&](double, double) {
            result.impulses.push_back(result.simulation.impulse() - before);
            before = result.simulation.impulse();
        });
    if (isForced) {
        result.answer.settling = followed.settling;
    }
    result.answer.see(result.simulation);
    return result;
}

Reply showSimulation(const Request& request)
{
    Reply reply;
    const Simulated whole = simulated(request);
    reply.json["answer"] = cli::wholeJsonOf(whole.answer);
    // The same once more, looked at from "from" for "span", in L/c.
    const Course course = courseOf(request);
    const auto perCrossing = static_cast<double>(course.cells);
    const double end = course.total * course.stretch / perCrossing;
    const double from = std::min(request.number("from", 0.0, 1e6), end);
    const double span = std::min(request.number("span", 0.1, 100.0), end - from);
    BarSimulation simulation(course.start, course.damping, course.excitation);
    if (course.excitation.steps() > 0) {
        reply.add("impulses", whole.impulses);
    }
    simulation.advance(from * perCrossing);
    const auto frames = static_cast<std::int64_t>(std::clamp(
        span * static_cast<double>(request.whole("frames", 4, 240)), 2.0, 2.0 * mostRows));
    film(reply, simulation, course.cells, frames, span * perCrossing, span);
    reply.json["end"] = end;
    return reply;
}

}  // namespace signorini::web
