// Forced motions, and what the bar does from any state.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "excited_names.hpp"
#include "measurements.hpp"
#include "names.hpp"
#include "signorini/settling.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

constexpr double mostDamping = 1.0;
constexpr double mostAmplitude = 10.0;  // [N] or [m], of a bar with EA g/L = 1 mN and g = 1 mm

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

/// Goes on from instant to instant and looks.
class Camera {
public:
    Camera(BarSimulation& simulation, std::int64_t cells) : simulation_(simulation), cells_(cells)
    {
    }

    void look()
    {
        times_.push_back(simulation_.time());
        const Eigen::VectorXd stretched = stretching(simulation_.waves(), cells_);
        const double base = simulation_.base();
        for (const double value : stretched) {
            u_.push_back(base + value);
        }
        for (Eigen::Index i = 1; i < stretched.size(); ++i) {
            s_.push_back((stretched[i] - stretched[i - 1]) * static_cast<double>(cells_));
        }
    }

    /// The mean force until the next look, as a time in units of the simulation and in L/c.
    void goOn(double duration, double crossings)
    {
        const double before = simulation_.impulse();
        simulation_.advance(duration);
        force_.push_back((simulation_.impulse() - before) / crossings);
    }

    void addTo(Reply& reply)
    {
        force_.push_back(force_.empty() ? 0.0 : force_.back());
        reply.json["nodes"] = cells_ + 1;
        reply.add("times", times_);
        reply.add("u", u_);
        reply.add("s", s_);
        reply.add("force", force_);
    }

private:
    BarSimulation& simulation_;
    std::int64_t cells_;
    std::vector<double> times_;
    std::vector<double> u_;
    std::vector<double> s_;
    std::vector<double> force_;
};

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
    double stretch;  ///< a period or 16 L/c, in steps
    double total;    ///< in stretches

    /// Of the excitation [L/c]; 0 without.
    [[nodiscard]] double period() const
    {
        return static_cast<double>(excitation.steps()) / excitation.stepsPerCrossing;
    }
};

/// In all, which a page takes seconds for; longer runs are a matter for the command line.
constexpr std::int64_t mostExcitedSteps = 20'000'000;

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
    course.start = startOf(request.part("start"), cells, course.excitation.baseDisplacement(0));
    return course;
}

}  // namespace

std::string pluckTable(const Request& start)
{
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
    reply.json["period"] = period(answer.set.schedule);
    if (answer.motions.empty()) {
        return reply;
    }
    const auto which = std::min<std::size_t>(static_cast<std::size_t>(request.whole("which", 0, 1)),
                                             answer.motions.size() - 1);
    const ForcedMotion& motion = answer.motions[which].value;
    reply.json["which"] = which;
    BarSimulation simulation(wavesOf(motion.state), motion.damping, motion.excitation);
    Camera camera(simulation, answer.set.schedule.cells);
    const auto perCrossing = static_cast<double>(answer.set.schedule.cells);
    camera.look();
    for (std::int64_t m = 0; m < steps(answer.set.schedule); ++m) {
        camera.goOn(1.0, 1.0 / perCrossing);
        camera.look();
    }
    camera.addTo(reply);
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
                                    .resolution = 1.0 / static_cast<double>(course.cells)})};
    if (isForced) {
        result.answer.drive = answers::Drive{.place = course.excitation.place,
                                             .amplitude = amplitudeOf(request),
                                             .frequencyRatio = 4.0 / course.period()};
        result.answer.drive->follow(course.excitation, bar);
    }
    SettlingWatch watch(static_cast<std::int64_t>(course.total));
    double done = 0.0;
    for (; done + 1.0 <= course.total; done += 1.0) {
        result.simulation.advance(course.stretch);
        watch.see(result.simulation);
    }
    if (isForced) {
        result.answer.settling = watch.settling(result.simulation, course.stretch);
    }
    if (course.total > done) {
        result.simulation.advance((course.total - done) * course.stretch);
    }
    return result;
}

Reply showSimulation(const Request& request)
{
    Reply reply;
    const Simulated whole = simulated(request);
    reply.json["answer"] = Json::parse(cli::asJson(whole.answer, whole.simulation));
    // The same once more, looked at from "from" for "span", in L/c.
    const Course course = courseOf(request);
    const auto perCrossing = static_cast<double>(course.cells);
    const double end = course.total * course.stretch / perCrossing;
    const double from = std::min(request.number("from", 0.0, 1e6), end);
    const double span = std::min(request.number("span", 0.1, 100.0), end - from);
    BarSimulation simulation(course.start, course.damping, course.excitation);
    if (course.excitation.steps() > 0) {
        // Impulse on the wall and highest tip of each period, until the end.
        std::vector<double> impulses;
        BarSimulation watched = simulation;
        for (double done = 0.0; done < course.total; done += 1.0) {
            const double before = watched.impulse();
            watched.advance(course.stretch);
            impulses.push_back(watched.impulse() - before);
        }
        reply.add("impulses", impulses);
    }
    simulation.advance(from * perCrossing);
    const auto frames = static_cast<std::int64_t>(
        std::clamp(span * static_cast<double>(request.whole("frames", 4, 240)), 2.0, 2400.0));
    const double crossings = span / static_cast<double>(frames);
    Camera camera(simulation, course.cells);
    camera.look();
    for (std::int64_t k = 0; k < frames; ++k) {
        camera.goOn(crossings * perCrossing, crossings);
        camera.look();
    }
    camera.addTo(reply);
    reply.json["period"] = span;
    reply.json["end"] = end;
    reply.json["excitation_period"] = course.period();
    return reply;
}

}  // namespace signorini::web
