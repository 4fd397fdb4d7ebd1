#include "find_outputs.hpp"

#include "exact_figure.hpp"
#include "find_command.hpp"

namespace signorini::cli {

namespace {

OutputOption ofProof(const FindCommand& words)
{
    return {"--certificate", words.given.text("--certificate")};
}

std::vector<OutputOption> ofMotion(const FindCommand& words)
{
    std::vector<OutputOption> outputs;
    for (const char* option : {"--state", "--motion", "--figure", "--animate"}) {
        outputs.push_back({option, words.given.text(option)});
    }
    return outputs;
}

}  // namespace

FindOutputs::FindOutputs(const FindCommand& words)
    : words_(words),
      motion_(ofMotion(words), {words.motionFile.folderOption(), ofProof(words)}),
      proof_({ofProof(words)}, ofMotion(words))
{
}

void FindOutputs::say(std::string_view what) const
{
    if (!words_.common.quiet) {
        tell(fmt::format("signorini find: {}\n", what));
    }
}

void FindOutputs::lackMotion() const
{
    if (motion_.areWanted()) {
        say("no motion to write, so no file was written");
    }
}

void FindOutputs::lackProof() const
{
    if (proof_.areWanted()) {
        say("no proof to write, so --certificate was not written");
    }
}

void FindOutputs::writeProof(const std::function<void(TextFile&)>& write)
{
    proof_.put("--certificate", [&](const std::string& path) {
        TextFile file(path);
        write(file);
        file.close();
    });
    proof_.commit();
}

void FindOutputs::writeMotion(const WrittenMotion& motion)
{
    motion_.put("--state", [&](const std::string& path) {
        writeStateCsv(path, motion.state, motion.bar, motion.base);
    });
    motion_.put("--figure", [&](const std::string& path) {
        motion.draw(figureFormat(words_.given.text("--figure")), path);
    });
    if (words_.motionFile.isWanted() || words_.given.has("--animate")) {
        writeField(motion);
    }
    motion_.commit();
}

void FindOutputs::writeHarmonic(const HarmonicField& field, const Scene& scene, std::int64_t cells)
{
    motion_.put("--figure", [&](const std::string& path) {
        drawFigure(harmonicFigure(field, scene), figureFormat(words_.given.text("--figure")), path);
    });
    motion_.put("--animate", [&](const std::string& path) {
        drawFigures(motionFrames(MotionSamples(field, scene, cells)),
                    animationFormat(words_.given.text("--animate")), path);
    });
    words_.motionFile.write(
        motion_, [&](std::int64_t most) { return MotionSamples(field, scene, cells, most); });
    motion_.commit();
}

void FindOutputs::writeField(const WrittenMotion& motion)
{
    const Motion field = motion.field();
    motion_.put("--animate", [&](const std::string& path) {
        drawFigures(motionFrames(MotionSamples(field, motion.scene)),
                    animationFormat(words_.given.text("--animate")), path);
    });
    if (words_.motionFile.isWanted() && field.steps() < motion.steps) {
        say(fmt::format("--motion holds {} of {} steps: the others repeat free oscillations",
                        field.steps(), motion.steps));
    }
    words_.motionFile.write(
        motion_, [&](std::int64_t most) { return MotionSamples(field, motion.scene, most); });
}

}  // namespace signorini::cli
