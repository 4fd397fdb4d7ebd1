#include "calls.hpp"

#include "journal.hpp"
#include "share_work.hpp"
#include "study_answer.hpp"

namespace signorini::python {

namespace {

/// With faults in the words of the call.
SweepAnswer required(const Asked& asked, const std::function<SweepAnswer()>& made,
                     const Network* bars = nullptr)
{
    try {
        SweepAnswer answer = made();
        answer.require(bars);
        return answer;
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(asked.inOptions(error.what(), asks::sweep));
    }
}

SweepAnswer sweep(const Asked& asked)
{
    const std::string direction = asked.get<std::string>("direction");
    std::vector<SweepDirection> directions{SweepDirection::up, SweepDirection::down};
    if (direction != "both") {
        directions = {asked.named("direction", sweepDirections).value()};
    }
    std::shared_ptr<const Network> bars;
    SweepAnswer answer;
    if (asked.has("words")) {
        const Assembly assembly = asked.assembly();
        bars = std::make_shared<const Network>(networkOf(assembly));
        refuseIf(asked.damping().ratio != 0.0,
                 "damping: allowed dash=D among the words of a scene");
        answer = required(
            asked, [&] { return sweepAsked(asked, assembly, *bars, bars->cells()); }, bars.get());
    } else {
        answer = required(asked, [&] { return sweepAsked(asked, asked.scene(), asked.cells()); });
    }
    const auto threads = asked.get<std::int64_t>("threads");
    const auto file = asked.text("file");
    const auto question = asked.get<std::string>("question");
    return patiently(asked, [=](const Watch& watch) mutable {
        std::optional<Journal> journal;
        if (!file.empty()) {
            journal.emplace(file, question, true);
        }
        answer.points = sweepThrough(answer.range, bars.get(), answer.bar, directions,
                                     journal ? &*journal : nullptr, threads,
                                     {.cancel = watch.cancel, .show = watch.show});
        answer.isComplete = answer.points.size() ==
                            directions.size() * static_cast<std::size_t>(answer.range.points);
        return answer;
    });
}

/// "cases" are (scene, damping, amplitude).
std::vector<StudyPoint> study(Asked asked)
{
    std::vector<StudyCase> all;
    for (const auto& [scene, damping, amplitude] :
         py::cast<std::vector<std::tuple<Scene, double, double>>>(asked.object("cases"))) {
        asked["damping"] = damping;
        asked["amplitude"] = amplitude;
        all.push_back(
            {required(asked, [&, &of = scene] { return sweepAsked(asked, of, asked.cells()); }),
             amplitude});
    }
    const auto threads = asked.get<std::int64_t>("threads");
    const auto file = asked.text("file");
    const auto question = asked.get<std::string>("question");
    return patiently(asked, [=](const Watch& watch) {
        const RowOf row = [&](std::size_t k) { return studyRow(all[k], watch.cancel); };
        return studyPointsOf(tabulated({.file = file,
                                        .question = question,
                                        .header = studyHeader,
                                        .keys = mapped(all, keyOf),
                                        .resumes = true,
                                        .deal = byThreads(row, threads),
                                        .show = watch.show}));
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
