#pragma once
/// \file
/// Where the waves of a channel stand in `Network::waves`, in the order in which they arrive.

#include "network.hpp"

namespace signorini {

/// Steps that a wave takes along the branch of a channel: the cells of a row, 1 of a stub.
[[nodiscard]] inline std::int64_t lengthOf(const Network& network, std::size_t channel)
{
    const std::size_t row = channel / 2;
    return row < network.rows.size() ? network.rows[row].cells : 1;
}

/// The last wave of a row's first channel, which runs to the right, arrives first. O(1) a wave.
class ChannelWaves {
public:
    ChannelWaves(const Network& network, std::size_t channel)
        : size_(static_cast<std::size_t>(lengthOf(network, channel)))
    {
        const std::size_t rows = network.rows.size();
        const bool isOfRow = channel < 2 * rows;
        first_ = isOfRow ? network.firstWave(channel / 2) + (channel % 2) * size_
                         : network.firstWave(rows) + channel - 2 * rows;
        isReversed_ = isOfRow && channel % 2 == 0;
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t at(std::size_t order) const
    {
        return first_ + (isReversed_ ? size_ - 1 - order : order);
    }

private:
    std::size_t size_;
    std::size_t first_ = 0;
    bool isReversed_ = false;
};

}  // namespace signorini
