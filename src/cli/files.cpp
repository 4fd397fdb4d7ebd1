#include "files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "arguments.hpp"
#include "faults.hpp"

namespace signorini::cli {

namespace {

bool isStandardOutput(const std::string& path)
{
    struct stat file = {};
    struct stat out = {};
    return stat(path.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &out) == 0 &&
           file.st_dev == out.st_dev && file.st_ino == out.st_ino;
}

}  // namespace

void validateOutputs(const std::vector<OutputOption>& outputs)
{
    for (const auto& [option, path] : outputs) {
        if (!path.empty()) {
            (void)forFile(option, path, [&path = path] { return outputPlace(path); });
        }
    }
    Faults faults;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [option, path] = outputs[i];
        if (path.empty()) {
            continue;
        }
        if (isStandardOutput(path)) {
            faults.add(option, path, "another file than standard output, where the report goes");
        }
        for (std::size_t k = i + 1; k < outputs.size(); ++k) {
            if (!outputs[k].path.empty() && isSameOutput(path, outputs[k].path)) {
                faults.add(fmt::format("{} and {}", option, outputs[k].option), path,
                           "two different files");
            }
        }
    }
    faults.throwIfAny();
}

std::string stage(OutputFiles& files, const OutputOption& output)
{
    if (output.path.empty()) {
        return {};
    }
    std::string staged = forFile(output.option, output.path, [&] {
        return files.stage(output.path, fmt::format("{} {}", output.option, output.path));
    });
    removeOnSignal(staged);
    removeOnSignal(OutputFiles::keptName(staged));
    return staged;
}

}  // namespace signorini::cli
