#include "commands.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "faults.hpp"
#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "journal.hpp"
#include "json.hpp"
#include "mapped.hpp"
#include "progress.hpp"
#include "ranks.hpp"
#include "scene_figures.hpp"
#include "signorini/output.hpp"
#include "study_file.hpp"
#include "text.hpp"

namespace signorini::cli {

namespace {

using answers::StudyAnswer;
using answers::StudyPoint;

std::string tomlOf(const std::string& path)
{
    constexpr std::size_t most = 10'000'000;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file || text.str().size() > most) {
        throw FileError(path, file ? "too long for a question" : "cannot read it");
    }
    return text.str();
}

/// The row of a case, or nothing if it was cancelled.
RowOf rowsOf(const StudyQuestion& question, const Cancel& cancel)
{
    return
        [&question, cancel](std::size_t k) { return answers::studyRow(question.cases[k], cancel); };
}

std::string asText(const StudyAnswer& answer)
{
    Text text;
    const bool areSeveral =
        std::any_of(answer.points.begin(), answer.points.end(),
                    [&](const StudyPoint& p) { return p.gap != answer.points.front().gap; });
    print(text, "{} sweeps of frequency, {}{}{}\n", answer.points.size(),
          answer.place == Excited::tip ? "force on the tip" : "base moving",
          areSeveral ? "; of several gaps, g and E₁ above are of the first" : "",
          unlessComplete(answer.isComplete));
    const std::string unit = amplitudeUnitName(answer.place, answer.derivative);
    print(text, "{:>12} {:>9} {:>12} {:>12} {:>10} {:>12} {:>12}  {}\n", "gap [m]", "damping",
          "size [" + unit + "]", "impulse [Ns]", "at [Hz]", "force [N]", "stress [Pa]",
          "rattles [Hz]");
    const StudyPoint* worst = nullptr;
    for (const StudyPoint& p : answer.points) {
        print(text, "{:>12.5g} {:>9.4g} {:>12.5g} {:>12.5g} {:>10.5g} {:>12.5g} {:>12}  {}\n",
              p.gap, p.damping, p.amplitude, p.impulse, p.frequency, p.meanForce,
              p.stress ? fmt::format("{:.5g}", *p.stress) : "-",
              p.from ? fmt::format("{:.5g} … {:.5g}", *p.from, *p.to) : "nowhere");
        worst = worst == nullptr || p.impulse > worst->impulse ? &p : worst;
    }
    if (worst != nullptr) {
        print(text,
              "worst       {:.6g} N s per period at {:.6g} Hz: gap {:.5g} m, ζ = {:.4g}, "
              "amplitude {:.5g} {}\n",
              worst->impulse, worst->frequency, worst->gap, worst->damping, worst->amplitude, unit);
    }
    return fmt::to_string(text);
}

/// All rows, those of a run before too.
StudyAnswer answerOf(const Given& given, const StudyQuestion& question, const DealRows& deal)
{
    const std::string csvFile = given.text("--csv");
    Progress progress(!given.has("--quiet"), "sweeps", given.text("--progress"));
    const RowTable table{
        .file = csvFile,
        .question = question.text,
        .header = answers::studyHeader,
        .keys = mapped(question.cases, answers::keyOf),
        .resumes = given.has("--resume"),
        .deal = deal,
        .show = [&progress](double done, double total) { progress.show(done, total); }};
    StudyAnswer answer;
    const answers::SweepAnswer& first = question.cases.front().sweep;
    answer.scene = first.scene;
    answer.cells = static_cast<std::int64_t>(first.range.cells);
    answer.place = first.range.place;
    answer.derivative = first.range.derivative;
    answer.points = answers::studyPointsOf(
        csvFile.empty() ? tabulated(table)
                        : forFile("--csv", csvFile, [&] { return tabulated(table); }));
    answer.isComplete = answer.points.size() == question.cases.size();
    return answer;
}

}  // namespace

ExitStatus runStudy(const Given& given)
{
    const std::int64_t threads = given.whole("--threads").value_or(1);
    const std::string csvFile = given.text("--csv");
    std::optional<Interrupt> interrupt(std::in_place);
    std::unique_ptr<Ranks> ranks;
    if (Ranks::areLaunched()) {
        ranks = std::make_unique<Ranks>();
        if (ranks->rank() != 0) {
            StudyQuestion question;
            const auto rows = [&](const std::string& text) {
                question = studyQuestionOf(text);
                return rowsOf(question, interrupt->cancel());
            };
            return ranks->serveRows(rows, threads) ? exitFound : exitUndecided;
        }
    }
    refuseIf(given.words().empty(), "FILE.toml is missing: allowed the name of a question");
    refuseIf(given.has("--resume") && csvFile.empty(),
             "--resume: allowed only together with --csv");
    const std::string& path = given.words().front();
    if (given.words().size() > 1) {
        throw std::invalid_argument(
            fmt::format("{} is not expected; see signorini --help", shortened(given.words()[1])));
    }
    const std::string text = tomlOf(path);
    StudyQuestion question;
    try {
        question = studyQuestionOf(text);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}: {}", path, error.what()));
    }
    validateOutputs(given, {"--csv", "--figure"});
    Outputs outputs(given, {"--figure"}, {"--csv"});
    const RowOf row = rowsOf(question, interrupt->cancel());
    const StudyAnswer answer = answerOf(
        given, question, ranks ? ranks->dealt(text, row, threads) : byThreads(row, threads));
    interrupt.reset();
    if (answer.isComplete) {
        outputs.draw("--figure", [&] { return studyFigure(answer); });
        outputs.commit();
    } else if (!given.has("--quiet")) {
        tell(fmt::format("signorini study: interrupted; the list is not complete{}\n",
                         csvFile.empty() ? "" : "; the same call with --resume continues"));
    }
    writeOut(given.text("--format") == "json" ? asLine(wholeJsonOf(answer))
                                              : question.restated + asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
