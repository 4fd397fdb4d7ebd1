#include "exact_answer.hpp"

namespace signorini::answers {

std::vector<HarmonicMotionOf> motionsOf(const ExactFrequencyOf& at)
{
    std::vector<HarmonicMotionOf> all;
    for (const ExactMotion& one : at.value.motions) {
        all.push_back({one.motion, at.bar, one.stability.growth, enclosed(one.given, one.motion),
                       one.stability.attracts});
    }
    return all;
}

std::vector<BranchPointOf> pointsOf(const ExactBranchOf& branch)
{
    std::vector<BranchPointOf> all;
    for (std::size_t k = 0; k < branch.value.curve.points.size(); ++k) {
        all.push_back({branch.value.curve.points[k], branch.bar, branch.value.stability[k]});
    }
    return all;
}

}  // namespace signorini::answers
