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

void FindOutputs::lackMotion() const
{
    if (motion_.areWanted()) {
        words_.common.say("no motion to write, so no file was written");
    }
}

void FindOutputs::lackProof() const
{
    if (proof_.areWanted()) {
        words_.common.say("no proof to write, so --certificate was not written");
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
    motion_.draw("--figure", motion.figure);
    if (words_.motionFile.isWanted() || words_.given.has("--animate")) {
        writeField(motion);
    }
    motion_.commit();
}

void FindOutputs::writeHarmonic(const HarmonicField& field, const Scene& scene, std::int64_t cells)
{
    motion_.draw("--figure", [&] { return harmonicFigure(field, scene); });
    motion_.draw("--animate", [&] { return motionFrames(MotionSamples(field, scene, cells)); });
    words_.motionFile.write(
        motion_, [&](std::int64_t most) { return MotionSamples(field, scene, cells, most); });
    motion_.commit();
}

void FindOutputs::writeField(const WrittenMotion& motion)
{
    const Motion field = motion.field();
    motion_.draw("--animate", [&] { return motionFrames(MotionSamples(field, motion.scene)); });
    if (words_.motionFile.isWanted() && field.steps() < motion.steps) {
        words_.common.say(
            fmt::format("--motion holds {} of {} steps: the others repeat free oscillations",
                        field.steps(), motion.steps));
    }
    words_.motionFile.write(
        motion_, [&](std::int64_t most) { return MotionSamples(field, motion.scene, most); });
}

}  // namespace signorini::cli
