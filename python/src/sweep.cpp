#include "calls.hpp"

#include "journal.hpp"
#include "share_work.hpp"
#include "study_answer.hpp"

namespace signorini::python {

namespace {

/// A sweep without points, its numbers being in SI units, of a scene or of what `bars` are.
/// \throws std::invalid_argument.
SweepAnswer inUnits(SweepRange range, const Scene& scene, const Asked& asked, double amplitude,
                    const Network* bars = nullptr)
{
    validate(scene);
    const Bar bar = unitsOf(scene);
    const auto end = [&](const char* name) {
        return range.over == Swept::frequency
                   ? asked.frequency(name, bar)
                   : asked.inUnit(name, unitName(range.over, range.place));
    };
    const double least = end("start");
    const double most = end("to");
    const double unit = unitOf(range.over, range.place, bar);
    if (asked.has("frequency")) {
        range.frequencyRatio = asked.frequency("frequency", bar);
    }
    range.least = least / unit;
    range.most = most / unit;
    range.amplitude = range.over == Swept::amplitude
                          ? range.least
                          : amplitude / amplitudeUnit(range.place, bar, range.derivative);
    range.stops = stopsOf(scene);
    range.segments = scene.segments;
    range.resolution /= scales(bar).time;
    Faults faults;
    faults.requirePositive("start", least, "ω₁, N or m, m, -");
    faults.requirePositive("to", most, "ω₁, N or m, m, -");
    if (most < least) {
        faults.add("to", most, fmt::format("at least start = {}", least));
    }
    faults.throwIfAny();
    SweepAnswer answer{range, scene, bar, {}, true, {}};
    try {
        answer.require(bars);
    } catch (const std::invalid_argument& error) {
        const std::string fault = error.what();
        const bool isFirst = fault.starts_with("least = ");
        throw std::invalid_argument(isFirst || fault.starts_with("most = ")
                                        ? (isFirst ? "start" : "to") +
                                              fault.substr(fault.find(" ="))
                                        : fault);
    }
    return answer;
}

SweepRange rangeOf(const Asked& asked)
{
    return {.points = asked.get<std::int64_t>("points"),
            .periods = asked.get<std::int64_t>("periods"),
            .cells = static_cast<double>(asked.maybe<std::int64_t>("cells").value_or(usualCells)),
            .place = asked.place()};
}

/// What is known of several bars. \throws std::invalid_argument.
void requireBars(const Network& bars, const SweepRange& range)
{
    Faults faults;
    if (range.over == Swept::gap || range.over == Swept::damping) {
        faults.add("over", name(range.over), "frequency|amplitude of a scene of several bars");
    }
    if (range.damping.ratio != 0.0) {
        faults.add("damping", range.damping.ratio, "dash=D among the words of the scene");
    }
    requireExcitable(faults, bars, range.place);
    faults.throwIfAny();
}

SweepAnswer sweep(const Asked& asked)
{
    const auto direction = asked.get<std::string>("direction");
    std::vector<SweepDirection> directions{SweepDirection::up, SweepDirection::down};
    if (direction != "both") {
        directions = {asked.named("direction", sweepDirections)};
    }
    SweepRange range = rangeOf(asked);
    range.over = asked.named("over", sweptNames);
    range.isCarried = !asked.get<bool>("rest");
    range.derivative = asked.get<int>("derivative");
    range.damping = asked.dampingIfGiven();
    asked.read("resolve", range.resolution);
    const auto amplitude = asked.maybe<double>("amplitude").value_or(0.0);
    std::shared_ptr<const Network> bars;
    SweepAnswer answer;
    if (asked.has("words")) {
        const Assembly assembly = asked.assembly();
        bars = std::make_shared<const Network>(networkOf(assembly));
        requireBars(*bars, range);
        range.cells = static_cast<double>(bars->cells());
        answer = inUnits(range, unitsOf(assembly, *bars), asked, amplitude, bars.get());
        answer.several = severalOf(assembly, *bars);
    } else {
        answer = inUnits(range, asked.scene(), asked, amplitude);
    }
    const auto threads = asked.get<std::int64_t>("threads");
    const auto file = asked.maybe<std::string>("file").value_or("");
    const auto question = asked.get<std::string>("question");
    return patiently(asked, [=](const Wires& wires) mutable {
        std::optional<Journal> journal;
        if (!file.empty()) {
            journal.emplace(file, question, true);
        }
        answer.points = sweepThrough(answer.range, bars.get(), answer.bar, directions,
                                     journal ? &*journal : nullptr, threads,
                                     {.cancel = wires.cancel, .show = wires.progress});
        answer.isComplete = answer.points.size() ==
                            directions.size() * static_cast<std::size_t>(answer.range.points);
        return answer;
    });
}

/// "cases" are (scene, damping, amplitude).
std::vector<StudyPoint> study(const Asked& asked)
{
    std::vector<StudyCase> all;
    for (const auto& [scene, damping, amplitude] :
         py::cast<std::vector<std::tuple<Scene, double, double>>>(asked.object("cases"))) {
        SweepRange range = rangeOf(asked);
        range.damping = {damping};
        all.push_back({inUnits(range, scene, asked, amplitude), amplitude});
    }
    const auto threads = asked.get<std::int64_t>("threads");
    const auto file = asked.maybe<std::string>("file").value_or("");
    const auto question = asked.get<std::string>("question");
    return patiently(asked, [=](const Wires& wires) {
        const RowOf row = [&](std::size_t k) { return studyRow(all[k], wires.cancel); };
        return studyPointsOf(tabulated({.file = file,
                                        .question = question,
                                        .header = studyHeader,
                                        .keys = mapped(all, keyOf),
                                        .resumes = true,
                                        .deal = byThreads(row, threads),
                                        .show = wires.progress}));
    });
}

}  // namespace

void addSweep(py::module_& module)
{
    addClasses<SweepPointOf, StudyPoint>(module);
    Record<SweepAnswer>(module).draws([](const SweepAnswer& answer) {
        return sweepFigure(answer.points, answer.range, answer.bar, {});
    });
    module.def("sweep", &sweep);
    module.def("study", &study);
}

}  // namespace signorini::python
