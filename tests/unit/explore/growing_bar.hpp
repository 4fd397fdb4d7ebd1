#pragma once
/// \file
/// The growing contact of a bar of segments with one stop beyond a gap of 1.

#include "contact_answers.hpp"
#include "growing_contact.hpp"

namespace signorini::test {

class GrowingBar {
public:
    GrowingBar(const std::vector<Segment>& segments, double eta, Excited place, std::int64_t cycles,
               std::int64_t steps)
        : cells_(0),
          given_{networkOf({}, segments, cellsOf(segments), {}), place, 1.0, steps, cycles},
          open_(withDashpot(given_, eta)),
          waves_(ContactAnswers(given_, open_, 0, Drive::inSteps).period())
    {
        cells_ = static_cast<double>(given_.network.cells());
        unit_ = place == Excited::tip ? 1.0 : cells_;
    }

    GrowingContact& waves() { return waves_; }
    /// A base of 1 in those of the network.
    [[nodiscard]] double unit() const { return unit_; }
    [[nodiscard]] double cells() const { return cells_; }

private:
    static std::int64_t cellsOf(const std::vector<Segment>& segments)
    {
        std::int64_t sum = 0;
        for (const Segment& segment : segments) {
            sum += segment.cells;
        }
        return sum;
    }
    static HarmonicNetwork& withDashpot(HarmonicNetwork& given, double eta)
    {
        given.network.nodes.back().dashpot = eta;
        return given;
    }

    double cells_;
    double unit_ = 1.0;
    HarmonicNetwork given_;
    OpenNetwork open_;
    GrowingContact waves_;
};

}  // namespace signorini::test
