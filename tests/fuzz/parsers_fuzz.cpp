// Text of strangers: state files, segments, scenes, schedules, numbers, questions of the page.
// Whatever it is, it is read or refused with words; and what was read obeys the range that the
// words name, and comes back from text. The first byte says what reads the rest.

#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "arguments.hpp"
#include "json.hpp"
#include "network.hpp"
#include "request.hpp"
#include "scene_answer.hpp"
#include "scene_options.hpp"
#include "segments_text.hpp"
#include "signorini/output.hpp"

namespace {

using namespace signorini;

void require(bool holds)
{
    if (!holds) {
        std::abort();
    }
}

void readsState(std::string_view text)
{
    static const int file = memfd_create("state.csv", 0);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    require(ftruncate(file, 0) == 0 &&
            pwrite(file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()));
    constexpr std::int64_t cells = 7;
    const StateReading read = readState(path, Bar{}, cells);
    require(read.state.a.size() == read.state.b.size() && read.state.a.size() >= 1);
    require(read.state.a.allFinite() && read.state.b.allFinite());
    require(!read.how.empty());
}

/// The sign of a dashpot is for the scene to check.
void requireSegments(const std::vector<Segment>& segments)
{
    for (const Segment& segment : segments) {
        require(segment.cells >= 1 && segment.impedance > 0.0 && segment.speed > 0.0 &&
                std::isfinite(segment.impedance) && std::isfinite(segment.speed) &&
                std::isfinite(segment.dashpot));
    }
    require(segmentsOf(textOf(segments)) == segments);
}

/// As a database holds them: ranges are for its reader to check.
void readsKeptSegments(std::string_view text)
{
    const std::string kept = textOf(segmentsOf(text));
    require(textOf(segmentsOf(kept)) == kept);
}

void readsPhases(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    for (const Phase& phase : cli::parsePhases(words)) {
        require(phase.contact >= 1 && phase.free >= 1);
    }
}

/// Words of a scene: what was read comes back, and what is a scene has a network that is one.
void readsScene(std::string_view text)
{
    const std::vector<AssemblyPart> parts = partsOf(text);
    require(partsOf(textOf(parts)) == parts);
    std::int64_t cells = 0;
    for (const AssemblyPart& part : parts) {
        cells += part.cells;
    }
    const Network network = networkOf(Assembly{.parts = parts});
    require(network.cells() == cells && !network.contacts.empty());
    const SceneReference reference = referenceOf(network);
    require(reference.frequency >= 0.0 && reference.energy.value_or(0.0) >= 0.0);
}

/// The same from a file.
void readsSceneFile(std::string_view text)
{
    const Assembly assembly = cli::assemblyOfJson(text, "scene.json");
    const std::string json = cli::asLine(cli::jsonOf(assembly));
    require(cli::assemblyOfJson(json, "scene.json") == assembly);
}

void readsNumbers(std::string_view text)
{
    const cli::GivenNumber number = cli::parseNumber("--period", text, "L/c");
    require(std::isfinite(number.value) && number.value > 0.0);
    if (number.exact) {
        require(number.exact->numerator > 0 && number.exact->denominator > 0);
        require(std::abs(number.exact->value() - number.value) <= 1e-12 * number.value);
    }
    const ExactPeriod fraction = cli::parseFraction("--period", text, "L/c");
    require(fraction.numerator <= 999'999'999 && fraction.denominator <= 999'999'999);
}

/// A question of the explorer, or nothing if what it is asked for was refused.
template <typename Read>
void asks(Read read)
{
    try {
        read();
    } catch (const std::invalid_argument& refused) {
        require(*refused.what() != '\0' && std::string_view(refused.what()).size() < 400);
    }
}

void readsQuestion(const std::string& text)
{
    const web::Request request = web::requestOf(text);
    asks([&] {
        const std::int64_t turns = request.whole("turns", -10, -1);
        require(turns >= -10 && turns <= -1);
    });
    asks([&] {
        const double period = request.number("period", 0.5, 4.0);
        require(period >= 0.5 && period <= 4.0);
    });
    asks([&] { require(request.positive("energy").value_or(1.0) > 0.0); });
    asks([&] { static_cast<void>(request.word("show")); });
    asks([&] { static_cast<void>(request.isOn("stability")); });
    asks([&] { static_cast<void>(request.part("of").word("show")); });
    asks([&] {
        const Scene scene = request.scene();
        require(std::isfinite(scene.bar.gap));
    });
    asks([&] {
        for (const auto& row : request.triples("chains", 200)) {
            for (const std::int64_t part : row) {
                require(part >= 0 && part <= 200);
            }
        }
    });
    asks([&] {
        const Schedule schedule = request.schedule();
        require(schedule.cells >= 1 && schedule.cells <= web::mostCells);
        require(steps(schedule) >= 2 && steps(schedule) <= 20 * schedule.cells);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) {
        return 0;
    }
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0]) {
            case 's':
                readsState(text);
                break;
            case 'd':
                readsKeptSegments(text);
                break;
            case 'g':
                requireSegments(cli::parseSegments("--segments", text));
                break;
            case 'p':
                readsPhases(text);
                break;
            case 'c':
                readsScene(text);
                break;
            case 'f':
                readsSceneFile(text);
                break;
            case 'n':
                readsNumbers(text);
                break;
            case 'j':
                readsQuestion(text);
                break;
            default:
                return -1;  // not worth keeping
        }
    } catch (const std::invalid_argument& refused) {
        require(*refused.what() != '\0');
    } catch (const FileError& refused) {
        require(*refused.what() != '\0');
    }
    return 0;
}
