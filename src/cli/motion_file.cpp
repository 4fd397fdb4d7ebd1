#include "motion_file.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <string_view>

#include "arguments.hpp"

namespace signorini::cli {

namespace {

constexpr const char* seriesEnding = ".pvd";

sigset_t endingSignals()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&signals, number);
    }
    return signals;
}

}  // namespace

SignalsHeld::SignalsHeld() : before_()
{
    const sigset_t signals = endingSignals();
    (void)pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

SignalsHeld::~SignalsHeld()
{
    (void)pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void MotionFile::addTo(CLI::App& command)
{
    command
        .add_option("--motion", path_,
                    "write u, v, s over one period; .pvd: a time series for ParaView")
        ->type_name("FILE.csv|.vtk|.pvd");
}

void MotionFile::validate() const
{
    if (isWanted() && !path_.ends_with(".csv") && !path_.ends_with(".vtk") &&
        !path_.ends_with(seriesEnding)) {
        refuse("--motion", path_, "a name ending in .csv, .vtk or .pvd");
    }
}

std::string MotionFile::folderOf(const std::string& path)
{
    return path.ends_with(seriesEnding)
               ? path.substr(0, path.size() - std::string_view(seriesEnding).size()) + "_files"
               : "";
}

MotionFile::Staged::Staged(const MotionFile& file, OutputFiles& files)
    : path_(file.path_), files_(files), staged_(stage(files, file.option()))
{
}

void MotionFile::Staged::write(const Sampling& sampled)
{
    if (path_.empty()) {
        return;
    }
    if (!path_.ends_with(seriesEnding)) {
        forFile("--motion", path_, [&] {
            (path_.ends_with(".vtk") ? writeMotionVtk : writeMotionCsv)(staged_,
                                                                        sampled(maxMotionInstants));
        });
        return;
    }
    held_.emplace();
    const std::string folder = folderOf(path_);
    const std::string members = forFile("--motion", folder, [&] {
        return files_.stageFolder(folder, ".vtu", "--motion " + folder);
    });
    forFile("--motion", path_, [&] {
        writeMotionSeries(staged_, members, std::filesystem::path(folder).filename().string(),
                          sampled(maxSeriesInstants));
    });
}

}  // namespace signorini::cli
