#include "exact_answer.hpp"

namespace signorini::answers {

std::vector<HarmonicMotionOf> ExactFrequencyOf::motions() const
{
    std::vector<HarmonicMotionOf> all;
    for (const ExactMotion& one : value.motions) {
        all.push_back({one.motion, bar, one.stability.growth, enclosed(one.given, one.motion),
                       one.stability.attracts});
    }
    return all;
}

std::vector<BranchPointOf> ExactBranchOf::points() const
{
    std::vector<BranchPointOf> all;
    for (std::size_t k = 0; k < value.curve.points.size(); ++k) {
        all.push_back({value.curve.points[k], bar, value.stability[k]});
    }
    return all;
}

std::vector<BranchMarkOf> ExactBranchOf::marks() const
{
    std::vector<BranchMarkOf> all;
    for (const BranchMark& mark : value.curve.marks) {
        all.push_back({mark, bar});
    }
    return all;
}

std::vector<ExactFrequencyOf> ExactAnswer::listed() const
{
    std::vector<ExactFrequencyOf> all;
    for (const ExactFrequency& one : frequencies) {
        all.push_back({one, bar});
    }
    return all;
}

std::vector<ExactBranchOf> ExactAnswer::curves() const
{
    std::vector<ExactBranchOf> all;
    for (const ExactBranch& one : branches) {
        all.push_back({one, bar});
    }
    return all;
}

}  // namespace signorini::answers
