#include "provenance.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>

#include "clp.hpp"
#include "commit.hpp"
#include "signorini/config.hpp"
#include "solver.hpp"

namespace signorini::bench {

namespace {

std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(": ") + 2);
        }
    }
    return "unknown";
}

}  // namespace

std::string provenanceText(Extent extent, const Limits& limits)
{
    utsname system{};
    uname(&system);
    std::string text = fmt::format(
        "signorini: {}\ncommit: {}\ncompiler: {}\nflags: {}\nprocessor: {}, {} in use\n"
        "system: {} {}\nextent: {}\nlimits of a case: {} s, {} MB of address space\n",
        SIGNORINI_VERSION, SIGNORINI_COMMIT, SIGNORINI_COMPILER, SIGNORINI_FLAGS, processorName(),
        sysconf(_SC_NPROCESSORS_ONLN), system.sysname, system.machine,
        extent == Extent::quick ? "quick" : "full", limits.seconds, limits.megabytes);
    std::string last;
    for (const Backend& backend : backends()) {
        const std::string library(backend.library);
        if (!library.empty() && library != last) {
            text += fmt::format("{}: {}\n", library,
                                backend.available() ? backend.version() : "absent");
            last = library;
        }
    }
    return text + fmt::format("CLP: {}\n", clpVersion());
}

std::string provenanceId(const std::string& text)
{
    std::uint32_t hash = 2166136261U;  // FNV-1a
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    }
    return fmt::format("{:08x}", hash);
}

}  // namespace signorini::bench
