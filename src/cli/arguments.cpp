#include "arguments.hpp"

#include <unistd.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "faults.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t maxThreads = 1024;

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

[[noreturn]] void refuse(std::string_view name, std::string_view text, std::string_view allowed)
{
    Faults faults;
    faults.add(name, text.empty() ? "''" : text, allowed);
    faults.throwIfAny();
    throw std::logic_error("a fault was added");
}

template <typename Number>
bool readAll(std::string_view text, Number& value)
{
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
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
    std::int64_t value = 0;
    if (!readAll(text, value) || value < low || value > high) {
        refuse(name, text, fmt::format("whole numbers {}..{}", low, high));
    }
    return value;
}

double parsePositive(std::string_view name, std::string_view text, std::string_view unit)
{
    double value = 0.0;
    if (!readAll(text, value) || !std::isfinite(value) || value <= 0.0) {
        refuse(name, text, fmt::format("finite numbers > 0 [{}]", unit));
    }
    return value;
}

double parseReal(std::string_view name, std::string_view text, std::string_view unit)
{
    double value = 0.0;
    if (!readAll(text, value) || !std::isfinite(value)) {
        refuse(name, text, fmt::format("finite numbers [{}]", unit));
    }
    return value;
}

void CommonOptions::addTo(CLI::App& command)
{
    command.add_option("--cells", cells, "N, equal cells of the bar (300)")->type_name("N");
    command.add_option("--length", length, "L (1)")->type_name("M");
    command.add_option("--wave-speed", waveSpeed, "c (1)")->type_name("M/S");
    command.add_option("--axial-stiffness", axialStiffness, "EA (1)")->type_name("N");
    command.add_option("--gap", gap, "g, from the tip at rest to the wall (1e-3)")->type_name("M");
    command.add_option("--young", young, "E, with --density and --area in place of c and EA")
        ->type_name("PA");
    command.add_option("--density", density, "rho")->type_name("KG/M3");
    command.add_option("--area", area, "cross-section")->type_name("M2");
    command.add_option("--format", format, "text or json (text)")->type_name("text|json");
    command.add_flag("--quiet", quiet, "no words for people on stderr but errors");
    command.add_option("--threads", threads, "most threads to use (1)")->type_name("K");
    for (CLI::Option* option : command.get_options()) {
        if (option->get_name().starts_with("--") && option->get_items_expected_max() > 0) {
            option->check([&command](const std::string& value) {
                return value.empty() ? "'' is out of range: allowed a value"
                       : value.starts_with("--") && command.get_option_no_throw(value) != nullptr
                           ? fmt::format("{} is an option: allowed a value", value)
                           : std::string();
            });
        }
    }
}

std::int64_t CommonOptions::parseCells() const
{
    return cells.empty() ? 300 : parseWhole("--cells", cells, 1, maxCells);
}

Bar CommonOptions::parseBar() const
{
    Bar bar;
    const auto number = [](const char* name, const std::string& text, const char* unit,
                           double preset) {
        return text.empty() ? preset : parsePositive(name, text, unit);
    };
    bar.length = number("--length", length, "m", bar.length);
    bar.waveSpeed = number("--wave-speed", waveSpeed, "m/s", bar.waveSpeed);
    bar.axialStiffness = number("--axial-stiffness", axialStiffness, "N", bar.axialStiffness);
    bar.gap = number("--gap", gap, "m", bar.gap);
    if (young.empty() && density.empty() && area.empty()) {
        validate(bar);
        return bar;
    }
    if (!waveSpeed.empty() || !axialStiffness.empty()) {
        throw std::invalid_argument(
            "--young/--density/--area clash with --wave-speed/--axial-stiffness: allowed one set");
    }
    if (young.empty() || density.empty() || area.empty()) {
        throw std::invalid_argument("--young, --density, --area: allowed only all three together");
    }
    return barOfMaterial(bar.length, parsePositive("--young", young, "Pa"),
                         parsePositive("--density", density, "kg/m^3"),
                         parsePositive("--area", area, "m^2"), bar.gap);
}

bool CommonOptions::wantsJson() const
{
    if (format.empty() || format == "text") {
        return false;
    }
    if (format != "json") {
        refuse("--format", format, "text|json");
    }
    return true;
}

std::int64_t CommonOptions::parseThreads() const
{
    return threads.empty() ? 1 : parseWhole("--threads", threads, 1, maxThreads);
}

void CommonOptions::useOneThread(std::string_view command) const
{
    if (parseThreads() > 1 && !quiet) {
        tell(fmt::format("signorini {}: one thread is used\n", command));
    }
}

std::vector<Phase> parsePhases(const std::vector<std::string>& words)
{
    if (words.empty() || words.size() % 2 != 0) {
        refuse("NC NF ...", fmt::format("{} step counts", words.size()),
               "pairs of contact and free steps: an even number of them, at least 2");
    }
    std::vector<Phase> phases;
    for (std::size_t k = 0; k < words.size(); k += 2) {
        const std::size_t number = k / 2 + 1;
        phases.push_back(
            {parseWhole(fmt::format("NC (phase {})", number), words[k], 1, maxSteps),
             parseWhole(fmt::format("NF (phase {})", number), words[k + 1], 1, maxSteps)});
    }
    return phases;
}

}  // namespace signorini::cli
