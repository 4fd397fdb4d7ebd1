#pragma once
// The waves of a bar of several segments, moved by a law written down for the tests: what networks
// and simulations do is compared with it.

#include <utility>
#include <vector>

#include "echo.hpp"
#include "stepped_bar.hpp"

namespace signorini::test {

/// What the ends do to the waves in one step.
struct Ends {
    double reflected = -1.0;    ///< -1 in contact; (Z - eta)/(Z + eta) in flight
    double pulled = 0.0;        ///< F/(Z + eta), the wave that a force on the tip sends out
    double baseVelocity = 0.0;  ///< V [c g/L]
};

/// The waves under way. A step costs O(segments).
class SteppedWaves {
public:
    /// O(N). \throws std::invalid_argument if the state has other cells than the bar.
    SteppedWaves(const SteppedBar& bar, const State& state);

    /// p, the wave about to reach the tip.
    [[nodiscard]] double arriving() const { return lines_.back().rightEnd(); }
    /// Takes one step. Returns what the dashpots of the joints took in it, sum of d v^2, in units
    /// of the first impedance.
    double step(const Ends& ends);
    /// O(N).
    [[nodiscard]] State state() const;

private:
    /// Two delay lines of one segment, in rings.
    struct Line {
        std::vector<double> a;  ///< entry (first + k) mod cells is cell k + 1
        std::vector<double> b;
        std::size_t firstA = 0;
        std::size_t firstB = 0;

        [[nodiscard]] double rightEnd() const { return a[(firstA + a.size() - 1) % a.size()]; }
        [[nodiscard]] double leftEnd() const { return b[firstB]; }
        void push(double fromLeft, double fromRight);
    };

    std::vector<Line> lines_;
    std::vector<JointWeights> joints_;
    std::vector<double> dashpots_;
    std::int64_t cells_;
};

inline SteppedWaves::SteppedWaves(const SteppedBar& bar, const State& state)
    : joints_(bar.joints), cells_(bar.cells)
{
    requireCells(state, cells_);
    Eigen::Index first = 0;
    for (const Segment& segment : bar.segments) {
        Line line;
        line.a.assign(state.a.data() + first, state.a.data() + first + segment.cells);
        line.b.assign(state.b.data() + first, state.b.data() + first + segment.cells);
        lines_.push_back(std::move(line));
        dashpots_.push_back(segment.dashpot);
        first += segment.cells;
    }
}

inline void SteppedWaves::Line::push(double fromLeft, double fromRight)
{
    firstA = (firstA == 0 ? a.size() : firstA) - 1;
    a[firstA] = fromLeft;
    b[firstB] = fromRight;
    firstB = firstB + 1 == b.size() ? 0 : firstB + 1;
}

inline double SteppedWaves::step(const Ends& ends)
{
    double taken = 0.0;
    double entering = ends.baseVelocity - lines_.front().leftEnd();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointWeights& joint = joints_[i];
        const double a = lines_[i].rightEnd();
        const double b = lines_[i + 1].leftEnd();
        const double v = joint.velocity(a, b);
        taken += dashpots_[i] * v * v;
        lines_[i].push(entering, v - a);
        entering = v - b;
    }
    const double p = arriving();
    lines_.back().push(entering, ends.reflected * p + ends.pulled);
    return taken;
}

inline State SteppedWaves::state() const
{
    State state{Eigen::VectorXd(cells_), Eigen::VectorXd(cells_)};
    Eigen::Index next = 0;
    for (const Line& line : lines_) {
        const std::size_t cells = line.a.size();
        for (std::size_t k = 0; k < cells; ++k, ++next) {
            state.a[next] = line.a[(line.firstA + k) % cells];
            state.b[next] = line.b[(line.firstB + k) % cells];
        }
    }
    return state;
}

/// A uniform bar, step by step: values are moved and negated, and nothing is rounded.
class UniformWaves : private SteppedWaves {
public:
    explicit UniformWaves(const State& start)
        : SteppedWaves({{{.cells = start.cells()}}, {}, start.cells()}, start)
    {
    }

    using SteppedWaves::arriving;
    using SteppedWaves::state;

    void contact(std::int64_t count = 1)
    {
        for (; count > 0; --count) {
            step({.reflected = -1.0});
        }
    }
    void free(std::int64_t count = 1)
    {
        for (; count > 0; --count) {
            step({.reflected = 1.0});
        }
    }
};

}  // namespace signorini::test
