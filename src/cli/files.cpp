#include "files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

#include "arguments.hpp"
#include "faults.hpp"
#include "given.hpp"

namespace signorini::cli {

namespace {

bool isStandardOutput(const std::string& path)
{
    struct stat file = {};
    struct stat out = {};
    return stat(path.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &out) == 0 &&
           file.st_dev == out.st_dev && file.st_ino == out.st_ino;
}

/// The folder of a time series, an output like its file; empty: there is none.
std::string folderOf(std::string_view option, const std::string& path)
{
    constexpr std::string_view ending = ".pvd";
    return option == "--motion" && path.ends_with(ending)
               ? path.substr(0, path.size() - ending.size()) + "_files"
               : "";
}

}  // namespace

void validateOutputs(const Given& given, const std::vector<const char*>& options)
{
    std::vector<std::pair<const char*, std::string>> outputs;
    outputs.reserve(2 * options.size());
    for (const char* option : options) {
        if (const std::string path = given.text(option); !path.empty()) {
            outputs.emplace_back(option, path);
        }
    }
    for (std::size_t k = outputs.size(); k-- > 0;) {
        const auto& [option, path] = outputs[k];
        if (std::string folder = folderOf(option, path); !folder.empty()) {
            outputs.emplace_back(option, std::move(folder));
        }
    }
    for (const auto& [option, path] : outputs) {
        (void)forFile(option, path, [&path = path] { return outputPlace(path); });
    }
    Faults faults;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [option, path] = outputs[i];
        if (isStandardOutput(path)) {
            faults.add(option, path, "another file than standard output, where the report goes");
        }
        for (std::size_t k = i + 1; k < outputs.size(); ++k) {
            if (isSameOutput(path, outputs[k].second)) {
                faults.add(fmt::format("{} and {}", option, outputs[k].first), path,
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

Outputs::Outputs(const Given& given, const std::vector<const char*>& options,
                 const std::vector<const char*>& taken)
{
    std::vector<const char*> all = options;
    all.insert(all.end(), taken.begin(), taken.end());
    validateOutputs(given, all);
    for (const char* option : options) {
        const std::string path = given.text(option);
        if (path.empty()) {
            continue;
        }
        const std::string staged = forFile(
            option, path, [&] { return files_.stage(path, fmt::format("{} {}", option, path)); });
        removeOnSignal(staged);
        removeOnSignal(OutputFiles::keptName(staged));
        entries_.push_back({option, path, staged});
    }
}

void Outputs::putMotion(const std::function<MotionSamples(std::int64_t most)>& sampled)
{
    if (!has("--motion")) {
        return;
    }
    const std::string path = entryOf("--motion").path;
    const std::string folder = folderOf("--motion", path);
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
