#include "motion_file.hpp"

#include <filesystem>
#include <string_view>

#include "given.hpp"

namespace signorini::cli {

namespace {

constexpr std::string_view seriesEnding = ".pvd";

}  // namespace

MotionFile::MotionFile(const Given& given) : path_(given.text("--motion")) {}

OutputOption MotionFile::folderOption() const
{
    return {"--motion", path_.ends_with(seriesEnding)
                            ? path_.substr(0, path_.size() - seriesEnding.size()) + "_files"
                            : ""};
}

void MotionFile::write(Outputs& outputs, const Sampling& sampled) const
{
    const OutputOption folder = folderOption();
    const std::string members = folder.path.empty() ? "" : outputs.stageFolder(folder, ".vtu");
    outputs.put("--motion", [&](const std::string& path) {
        if (!members.empty()) {
            writeMotionSeries(path, members, std::filesystem::path(folder.path).filename().string(),
                              sampled(maxSeriesInstants));
        } else if (path_.ends_with(".vtk")) {
            writeMotionVtk(path, sampled(maxMotionInstants));
        } else {
            writeMotionCsv(path, sampled(maxMotionInstants));
        }
    });
}

}  // namespace signorini::cli
