#include <cmath>

#include "compensated_sum.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

double PieceQueue::squares() const
{
    CompensatedSum sum;
    for (std::size_t k = 0; k < count_; ++k) {
        const Piece& piece = (*this)[k];
        sum.add(piece.duration * piece.value * piece.value);
    }
    return sum.value();
}

void PieceQueue::grow()
{
    std::vector<Piece> larger(2 * ring_.size());
    for (std::size_t k = 0; k < count_; ++k) {
        larger[k] = (*this)[k];
    }
    ring_ = std::move(larger);
    head_ = 0;
}

void PieceQueue::append(double duration, double value)
{
    duration += rest_;
    rest_ = 0.0;
    if (count_ > 0) {
        Piece& last = ring_[(head_ + count_ - 1) & (ring_.size() - 1)];
        const double jump = std::abs(last.value - value);
        if (jump == 0.0) {
            last.duration += duration;
            return;
        }
        if (jump <= mergeBelow_) {
            const double share = duration / (last.duration + duration);
            merged_ += share * last.duration * jump;
            last.value += share * (value - last.value);
            last.duration += duration;
            return;
        }
    }
    if (count_ == ring_.size()) {
        grow();
    }
    ring_[(head_ + count_) & (ring_.size() - 1)] = {duration, value};
    ++count_;
}

void PieceQueue::take(double duration, double same)
{
    double left = ring_[head_].duration - duration;
    while (left <= same) {
        head_ = (head_ + 1) & (ring_.size() - 1);
        --count_;
        if (count_ == 0) {
            rest_ = left;
            return;
        }
        left += ring_[head_].duration;
    }
    ring_[head_].duration = left;
}

}  // namespace signorini
