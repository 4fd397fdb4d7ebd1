#include "segment_lines.hpp"

#include <algorithm>
#include <limits>

#include "faults.hpp"

namespace signorini {

namespace {

/// Deals the pieces of a wave out to stretches of given durations.
class Dealer {
public:
    explicit Dealer(const std::vector<Piece>& pieces) : pieces_(pieces) {}

    std::vector<Piece> take(double duration)
    {
        std::vector<Piece> part;
        while (duration > 0.0 && next_ < pieces_.size()) {
            const double rest = pieces_[next_].duration - used_;
            part.push_back({std::min(rest, duration), pieces_[next_].value});
            duration -= part.back().duration;
            used_ += part.back().duration;
            if (part.back().duration == rest) {
                ++next_;
                used_ = 0.0;
            }
        }
        if (duration > 0.0) {  // what rounding left of the sum of all durations
            part.push_back({duration, pieces_.back().value});
        }
        return part;
    }

private:
    const std::vector<Piece>& pieces_;
    std::size_t next_ = 0;
    double used_ = 0.0;
};

}  // namespace

std::vector<Waves> partsOf(const Waves& waves, std::span<const Segment> segments)
{
    std::vector<Waves> parts(segments.size());
    Dealer fromTip(waves.a);
    Dealer fromBase(waves.b);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t last = parts.size() - 1 - i;
        parts[last].a = fromTip.take(static_cast<double>(segments[last].cells));
        parts[i].b = fromBase.take(static_cast<double>(segments[i].cells));
        parts[i].crossing = static_cast<double>(segments[i].cells);
    }
    return parts;
}

SegmentLines::SegmentLines(const SteppedBar& bar, const Waves& start, double mergeBelow)
    : joints_(bar.joints), crossing_(start.crossing)
{
    if (crossing_ != static_cast<double>(bar.cells)) {
        throwFault("crossing of the start", crossing_,
                   fmt::format("{}, the cells of all segments", bar.cells));
    }
    const auto fill = [](PieceQueue& queue, const std::vector<Piece>& pieces) {
        for (const Piece& piece : pieces) {
            queue.append(piece.duration, piece.value);
        }
    };
    const std::vector<Waves> parts = partsOf(start, bar.segments);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        lines_.push_back({PieceQueue(mergeBelow), PieceQueue(mergeBelow), bar.segments[i].impedance,
                          bar.segments[i].dashpot});
        fill(lines_.back().a, parts[i].a);
        fill(lines_.back().b, parts[i].b);
    }
}

double SegmentLines::lasts() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Line& line : lines_) {
        least = std::min({least, line.a.front().duration, line.b.front().duration});
    }
    return least;
}

double SegmentLines::pass(double duration, double q, double baseVelocity, double same)
{
    const auto move = [duration, same](PieceQueue& queue, double entering) {
        queue.take(duration, same);
        queue.append(duration, entering);
    };
    double taken = 0.0;
    double entering = baseVelocity - atBase();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointWeights& joint = joints_[i];
        const double a = lines_[i].a.front().value;
        const double b = lines_[i + 1].b.front().value;
        const double v = joint.velocity(a, b);
        taken += lines_[i].dashpot * v * v * duration;
        move(lines_[i].a, entering);
        move(lines_[i].b, v - a);
        entering = v - b;
    }
    move(lines_.back().a, entering);
    move(lines_.back().b, q);
    return taken;
}

Waves SegmentLines::waves() const
{
    Waves waves;
    waves.crossing = crossing_;
    const auto put = [](std::vector<Piece>& to, const PieceQueue& queue) {
        for (std::size_t k = 0; k < queue.size(); ++k) {
            to.push_back(queue[k]);
        }
    };
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        put(waves.a, lines_[lines_.size() - 1 - i].a);
        put(waves.b, lines_[i].b);
    }
    return waves;
}

double SegmentLines::squares() const
{
    double sum = 0.0;
    for (const Line& line : lines_) {
        sum += line.impedance * (line.a.squares() + line.b.squares());
    }
    return sum;
}

std::size_t SegmentLines::pieces() const
{
    std::size_t count = 0;
    for (const Line& line : lines_) {
        count += line.a.size() + line.b.size();
    }
    return count;
}

double SegmentLines::merged() const
{
    double sum = 0.0;
    for (const Line& line : lines_) {
        sum += line.a.merged() + line.b.merged();
    }
    return sum;
}

}  // namespace signorini
