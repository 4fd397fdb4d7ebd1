#pragma once
/// \file
/// The files that a call of find names: of a motion, or of the proof that there is none.

#include <functional>

#include "bars_motion.hpp"
#include "files.hpp"
#include "harmonic_field.hpp"
#include "scene_harmonic_answer.hpp"
#include "signorini/assembly.hpp"

namespace signorini::cli {

struct FindCommand;

/// A motion, free or forced, as files hold it.
struct WrittenMotion {
    const State& state;
    const Scene& scene;
    const Bar& bar;  ///< whose scales the state has
    const Schedule& schedule;
    std::function<Motion()> field;
    std::function<FigureData()> figure;
    Damping damping = {};
    Excitation excitation = {};  ///< one period of it
};

/// Says on stderr which files there is nothing for.
class FindOutputs {
public:
    explicit FindOutputs(const FindCommand& words);

    [[nodiscard]] bool areOfMotion() const { return motion_.areWanted(); }
    [[nodiscard]] bool wantsProof() const { return proof_.areWanted(); }

    void writeMotion(const WrittenMotion& motion);
    /// Of a motion under an exact harmonic, on no grid: files and pictures, no state.
    void writeHarmonic(const HarmonicField& field, const Scene& scene, std::int64_t cells);
    /// Of the bars of a scene: the table of their state, their motion and pictures of it.
    void writeBars(const Assembly& assembly, const Network& network, const NetworkClaim& motion);
    /// Of the last motion of bars under an exact harmonic, on no grid.
    void writeHarmonic(const answers::SceneHarmonicAnswer& answer);
    void lackMotion() const;
    void writeProof(const std::function<void(TextFile&)>& write);
    void lackProof() const;

private:
    void writePictures(const Assembly& assembly, const Network& network,
                       const NetworkClaim& motion);
    void writePictures(const Assembly& assembly, const Network& network, const ShownPeriod& motion,
                       const std::function<FigureData()>& figure);

    const FindCommand& words_;
    Outputs motion_;
    Outputs proof_;
};

}  // namespace signorini::cli
