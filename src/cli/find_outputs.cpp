#include "find_outputs.hpp"

#include "bar_check.hpp"
#include "bars_motion.hpp"
#include "exact_figure.hpp"
#include "find_command.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

FindOutputs::FindOutputs(const FindCommand& words)
    : words_(words),
      motion_(words.given, {"--state", "--motion", "--figure", "--animate"}, {"--certificate"}),
      proof_(words.given, {"--certificate"}, {"--state", "--motion", "--figure", "--animate"})
{
}

void FindOutputs::lackMotion() const
{
    if (motion_.areWanted()) {
        words_.common.sayNoFile("no motion to write");
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
    const double base = motion.excitation.baseDisplacement(0);
    if (!haveOneSpeed(motion.scene.segments)) {  // its nodes are on no even grid
        const Network network = networkOf(motion.scene, motion.schedule.cells, motion.damping);
        const NetworkClaim claim =
            claimOf(network, motion.state, motion.schedule, motion.excitation);
        Waves waves = wavesOf(motion.state);
        waves.base = base;
        const Bar bar = firstMaterial(motion.scene);
        const double tip = claim.displacements.back() * network.scales.displacement;
        motion_.put("--state", [&](const std::string& path) {
            writeStateTable(path, waves, tip / scales(bar).displacement, bar);
        });
        writePictures(answers::assemblyOf(motion.scene, motion.schedule.cells, motion.damping),
                      network, claim);
        return;
    }
    motion_.put("--state", writeStateCsv, motion.state, motion.bar, base);
    motion_.draw("--figure", motion.figure);
    if (motion_.has("--motion") || motion_.has("--animate")) {
        const Motion field = motion.field();
        motion_.draw("--animate", [&] { return motionFrames(MotionSamples(field, motion.scene)); });
        if (motion_.has("--motion") && field.steps() < steps(motion.schedule)) {
            words_.common.say(
                fmt::format("--motion holds {} of {} steps: the others repeat free oscillations",
                            field.steps(), steps(motion.schedule)));
        }
        motion_.putMotion(
            [&](std::int64_t most) { return MotionSamples(field, motion.scene, most); });
    }
    motion_.commit();
}

void FindOutputs::writeHarmonic(const HarmonicField& field, const Scene& scene, std::int64_t cells)
{
    motion_.draw("--figure", [&] { return harmonicFigure(field, scene); });
    motion_.draw("--animate", [&] { return motionFrames(MotionSamples(field, scene, cells)); });
    motion_.putMotion([&](std::int64_t most) { return MotionSamples(field, scene, cells, most); });
    motion_.commit();
}

void FindOutputs::writeBars(const Assembly& assembly, const Network& network,
                            const NetworkClaim& motion)
{
    motion_.put("--state", [&](const std::string& path) {
        writeStateTable(path, network, {motion.waves, motion.displacements});
    });
    writePictures(assembly, network, motion);
}

void FindOutputs::writePictures(const Assembly& assembly, const Network& network,
                                const NetworkClaim& motion)
{
    writePictures(assembly, network, shownPeriod(network, motion),
                  [&] { return periodFigure(network, motion, assembly.length); });
}

void FindOutputs::writeHarmonic(const answers::SceneHarmonicAnswer& answer)
{
    const std::size_t last = answer.motions.size() - 1;
    const Assembly& assembly = answer.bars.assembly;
    writePictures(assembly, networkOf(assembly), shownPeriod(answer, last),
                  [&] { return harmonicFigure(answer, last); });
}

void FindOutputs::writePictures(const Assembly& assembly, const Network& network,
                                const ShownPeriod& motion,
                                const std::function<FigureData()>& figure)
{
    motion_.draw("--figure", figure);
    motion_.draw("--animate", [&] { return barsFrames(assembly, network, motion); });
    motion_.putMotion(
        [&](std::int64_t most) { return samplesOf(assembly, network, motion, most); });
    motion_.commit();
}

}  // namespace signorini::cli
