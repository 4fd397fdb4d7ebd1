#include "files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "arguments.hpp"
#include "faults.hpp"
#include "given.hpp"
#include "mapped.hpp"

namespace signorini::cli {

namespace {

bool isStandardOutput(const std::string& path)
{
    struct stat file = {};
    struct stat out = {};
    return stat(path.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &out) == 0 &&
           file.st_dev == out.st_dev && file.st_ino == out.st_ino;
}

/// The folder of a time series, an output like its file; without a name if there is none.
OutputOption folderOf(const OutputOption& file)
{
    constexpr std::string_view ending = ".pvd";
    const bool isSeries =
        file.option == std::string_view("--motion") && file.path.ends_with(ending);
    return {file.option,
            isSeries ? file.path.substr(0, file.path.size() - ending.size()) + "_files" : ""};
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

SignalsHeld::SignalsHeld() : before_()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&signals, number);
    }
    (void)pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

SignalsHeld::~SignalsHeld()
{
    (void)pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

Outputs::Outputs(const std::vector<OutputOption>& outputs, const std::vector<OutputOption>& taken)
{
    std::vector<OutputOption> all = outputs;
    all.insert(all.end(), taken.begin(), taken.end());
    for (std::size_t k = all.size(); k-- > 0;) {
        all.push_back(folderOf(all[k]));
    }
    validateOutputs(all);
    for (const auto& [option, path] : outputs) {
        if (path.empty()) {
            continue;
        }
        const std::string staged = forFile(option, path, [&, option = option, &path = path] {
            return files_.stage(path, fmt::format("{} {}", option, path));
        });
        removeOnSignal(staged);
        removeOnSignal(OutputFiles::keptName(staged));
        entries_.push_back({option, path, staged});
    }
}

Outputs::Outputs(const Given& given, std::initializer_list<const char*> options,
                 const std::vector<OutputOption>& taken)
    : Outputs(mapped(options,
                     [&given](const char* option) {
                         return OutputOption{option, given.text(option)};
                     }),
              taken)
{
}

void Outputs::putMotion(const std::function<MotionSamples(std::int64_t most)>& sampled)
{
    if (!has("--motion")) {
        return;
    }
    const std::string path = entryOf("--motion").path;
    const std::string folder = folderOf({"--motion", path}).path;
    std::string members;
    if (!folder.empty()) {
        held_.emplace();
        members = forFile("--motion", folder,
                          [&] { return files_.stageFolder(folder, ".vtu", "--motion " + folder); });
    }
    put("--motion", [&](const std::string& staged) {
        if (!folder.empty()) {
            writeMotionSeries(staged, members, std::filesystem::path(folder).filename().string(),
                              sampled(maxSeriesInstants));
        } else if (path.ends_with(".vtk")) {
            writeMotionVtk(staged, sampled(maxMotionInstants));
        } else {
            writeMotionCsv(staged, sampled(maxMotionInstants));
        }
    });
}

}  // namespace signorini::cli
