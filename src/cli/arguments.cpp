#include "arguments.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <limits>
#include <system_error>
#include <utility>

#include "faults.hpp"
#include "given.hpp"
#include "hints.hpp"
#include "segments_text.hpp"
#include "share_work.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"
#include "units.hpp"

namespace signorini::cli {

namespace {

// What the signal handler can reach: a plain array, written before the handler is installed.
std::array<std::array<char, 4096>, 16> stagedPaths;
volatile std::sig_atomic_t stagedCount = 0;

extern "C" void removeStagedAndQuit(int number)
{
    for (std::sig_atomic_t k = 0; k < stagedCount; ++k) {
        (void)unlink(stagedPaths[static_cast<std::size_t>(k)].data());
    }
    _exit(128 + number);
}

}  // namespace

ExitStatus exitStatusOf(Status status)
{
    switch (status) {
        case Status::found:
            return exitFound;
        case Status::none:
            return exitNone;
        case Status::undecided:
            return exitUndecided;
    }
    throw std::logic_error("unnamed Status");
}

ExitStatus exitStatusOf(answers::Ending ending)
{
    return ending == answers::Ending::done ? exitFound : exitUndecided;
}

void writeOut(std::string_view text)
{
    const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
    if (written != text.size() || std::fflush(stdout) != 0) {
        throw FileError("standard output",
                        "cannot write: " + std::generic_category().message(errno));
    }
}

void tell(std::string_view text) noexcept
{
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

void removeOnSignal(const std::string& path)
{
    const auto count = static_cast<std::size_t>(stagedCount);
    if (count == stagedPaths.size() || path.size() >= stagedPaths.front().size()) {
        return;
    }
    std::copy(path.begin(), path.end(), stagedPaths[count].begin());
    stagedPaths[count][path.size()] = '\0';
    stagedCount = static_cast<std::sig_atomic_t>(count + 1);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        (void)std::signal(number, removeStagedAndQuit);
    }
}

std::int64_t parseWhole(std::string_view name, std::string_view text, std::int64_t low,
                        std::int64_t high)
{
    const auto value = wholeIn(text, low, high);
    refuseIf(!value, name, text, fmt::format("whole numbers {}..{}", low, high));
    return *value;
}

double parseReal(std::string_view name, std::string_view text, std::string_view unit)
{
    const auto value = numberIn(text, unit);
    if (!value) {
        refuse(name, text, fmt::format("finite numbers [{}]", unit));
    }
    return *value;
}

CommonOptions::CommonOptions(const Given& given)
    : command(given.command()),
      cells(given.whole("--cells")),
      choosesCells(given.text("--cells") == "auto"),
      wantsJson(given.text("--format") == "json"),
      quiet(given.has("--quiet")),
      isVerbose(given.has("--verbose")),
      threads(given.whole("--threads").value_or(1)),
      progressFile(given.text("--progress")),
      sceneText(given.text("--scene")),
      gravity(given.number("--gravity").value_or(0.0)),
      dampingRatio(given.knows("--damping") ? given.number("--damping") : std::nullopt),
      piecesFile_(given.text("--segments-file")),
      secondStop_(given.number("--second-stop")),
      given_(&given)
{
    if (given.has("--segments")) {
        segments_ = parseSegments("--segments", given.text("--segments"));
    }
}

std::int64_t CommonOptions::usualCells() const
{
    if (!piecesFile_.empty()) {
        return pieces().cells;
    }
    std::int64_t sum = 0;
    if (!sceneText.empty()) {
        for (const AssemblyPart& part : assembly().parts) {
            sum += part.cells;
        }
        return sum;
    }
    if (segments_.empty()) {
        return cells.value_or(300);
    }
    for (const Segment& segment : segments_) {
        sum += std::min(segment.cells, maxCells);
    }
    if (cells && *cells != sum) {
        throwFault("--cells", *cells, fmt::format("{}, those of --segments", sum));
    }
    return sum;
}

Bar CommonOptions::bar() const
{
    const Bar bar = barOfAnyGap();
    requireGap(bar, bar.gap > 0.0);
    if (bar.gap <= 0.0) {
        refuse("--gap", fmt::format("{}", bar.gap), "finite numbers > 0 [m] for this command");
    }
    return bar;
}

void CommonOptions::requireGap(const Bar& bar, bool isFit) const
{
    refuseIf(
        weight() != 0.0 && !isFit, "--gravity", fmt::format("{}", weight()),
        fmt::format("a weight that leaves another gap than {:.6g} m for this command", bar.gap));
}

Bar CommonOptions::barOfAnyGap() const
{
    const Scene scene = sceneOfOneBar();
    refuseIf(
        scene.secondStop.has_value(),
        fmt::format("{}: allowed of two stops with find, continuum, response, simulate, sweep, "
                    "families and atlas; modes are curves of one wall, and families lists "
                    "what of them a second stop leaves",
                    sceneText.empty() ? "--second-stop" : "--scene"));
    return scene.bar;
}

Scene CommonOptions::sceneOfOneBar() const
{
    Scene one = scene();
    refuseIf(!one.segments.empty(),
             fmt::format("{}: allowed of several segments with find, continuum, response, "
                         "simulate, sweep, atlas and scene; families and modes are theorems "
                         "about the uniform bar, and for others there is no method",
                         !sceneText.empty()    ? "--scene"
                         : piecesFile_.empty() ? "--segments"
                                               : "--segments-file"));
    return one;
}

Scene CommonOptions::shortForms() const
{
    Scene scene(answers::barAsked(*given_, false), secondStop_, segments_);
    if (!piecesFile_.empty()) {
        scene = pieces().scene;
        scene.secondStop = secondStop_;
    }
    validate(scene);
    return scene;
}

std::string CommonOptions::restated(std::optional<std::int64_t> grid,
                                    std::optional<double> damping) const
{
    const Scene meant = scene();
    const Bar first = firstMaterial(meant);
    const Scales unit = scales(first);
    std::string text = fmt::format("bar         {}L = {:.6g} m, c = {:.6g} m/s, EA = {:.6g} N, ",
                                   grid ? fmt::format("N = {}, ", *grid) : "", meant.bar.length,
                                   first.waveSpeed, first.axialStiffness);
    text += fmt::format("g = {:.6g} m", meant.bar.gap);
    if (meant.secondStop) {
        text += fmt::format(", h = {:.6g} m", *meant.secondStop);
    }
    if (weight() != 0.0) {
        text += " under its weight";
    }
    if (damping) {
        text += fmt::format(", ζ = {:.6g}", *damping);
    }
    text += fmt::format("; ω₁ = {:.6g} Hz, ", 0.25 / unit.time);
    text +=
        meant.bar.gap == 0.0 ? "no E₁ without a gap" : fmt::format("E₁ = {:.6g} J", unit.energy);
    if (!meant.segments.empty()) {
        text += fmt::format("; segments {}, c, EA, ω₁, E₁ of the first", textOf(meant.segments));
    }
    text += "\n";
    if (!piecesFile_.empty()) {
        text += fmt::format(
            "pieces      on {} cells; lengths are rounded by at most {:.2g} %, travel times with "
            "them\n",
            pieces().cells, 100.0 * pieces().rounding);
    }
    text += youngNote(given_->number("--young"));
    if (damping && *damping > answers::likelyPercent) {
        text +=
            fmt::format("note        ζ = {0:.6g} is {1:.6g} %: {0:.6g} % are --damping {2:.6g}\n",
                        *damping, *damping * 100.0, *damping / 100.0);
    }
    return text;
}

void CommonOptions::say(std::string_view what) const
{
    if (!quiet) {
        tell(fmt::format("signorini {}: {}\n", command, what));
    }
}

void CommonOptions::warnUnlessAdmissible(const Physical& physical) const
{
    if (!physical.isAdmissible()) {
        say(
            fmt::format("not admissible: the strain reaches {:.6g}, and the paper demands s > -1 "
                        "everywhere",
                        -physical.peakCompression));
    }
}

void CommonOptions::useOneThread() const
{
    if (threads > 1) {
        say("one thread is used");
    }
}

std::vector<Segment> parseSegments(std::string_view name, std::string_view text)
{
    const auto split = [](std::string_view whole, char mark) {
        std::vector<std::string_view> parts;
        for (std::size_t end = 0; end != std::string_view::npos;) {
            end = whole.find(mark);
            parts.push_back(whole.substr(0, end));
            whole.remove_prefix(end == std::string_view::npos ? whole.size() : end + 1);
        }
        return parts;
    };
    std::vector<Segment> segments;
    for (const std::string_view word : split(text, ',')) {
        const auto parts = split(word, ':');
        if (parts.size() < 2 || parts.size() > 4) {
            refuse(name, text, "CELLS:IMPEDANCE[:SPEED[:DASHPOT]], separated by commas");
        }
        Segment segment{.cells = parseWhole(name, parts[0], 1, maxCells),
                        .impedance = parsePositive(name, parts[1], "-")};
        if (parts.size() >= 3) {
            segment.speed = parsePositive(name, parts[2], "-");
        }
        if (parts.size() == 4) {
            segment.dashpot = parseReal(name, parts[3], "-");
        }
        segments.push_back(segment);
    }
    return segments;
}

std::vector<Phase> parsePhases(const std::vector<std::string>& words)
{
    refuseIf(
        words.empty(),
        "NC NF is missing: allowed contact and free steps, as in 150 900; find takes --period, "
        "--frequency or --hertz in their place");
    refuseIf(words.size() % 2 != 0, "NC NF ...", fmt::format("{} step counts", words.size()),
             "pairs of contact and free steps: an even number of them, at least 2");
    std::vector<Phase> phases;
    for (std::size_t k = 0; k < words.size(); k += 2) {
        const std::size_t number = k / 2 + 1;
        std::string_view contact = words[k];
        const bool isLeft = contact.starts_with("L:");
        contact.remove_prefix(isLeft ? 2 : 0);
        phases.push_back(
            {parseWhole(fmt::format("NC (phase {})", number), contact, 1, maxSteps),
             parseWhole(fmt::format("NF (phase {})", number), words[k + 1], 1, maxSteps),
             isLeft ? Stop::left : Stop::right});
    }
    return phases;
}

}  // namespace signorini::cli
