#include "harmonic_tip.hpp"

#include <numbers>

#include "portable.hpp"

namespace signorini {

HarmonicTip::HarmonicTip(const SteppedBar& bar, double eta, std::int64_t steps)
    : bar_(bar), eta_(eta)
{
    for (std::int64_t k = 0; k < steps; ++k) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(steps);
        turns_.emplace_back(portable::cos(angle), portable::sin(angle));
    }
}

HarmonicTip::Complex HarmonicTip::turn(std::int64_t k) const
{
    const auto n = static_cast<std::int64_t>(turns_.size());
    return turns_[static_cast<std::size_t>((k % n + n) % n)];
}

HarmonicTip::Complex HarmonicTip::speed(std::int64_t k, double force, double base) const
{
    const auto n = static_cast<std::int64_t>(turns_.size());
    const auto through = [&](std::int64_t cells) { return turn(-(k % n) * (cells % n)); };
    Complex back = -1.0;   // G
    Complex sent = base;   // S
    double nearer = 1.0;   // Z_1
    double dashpot = 0.0;  // d
    for (std::size_t i = 0; i < bar_.segments.size(); ++i) {
        const Segment& segment = bar_.segments[i];
        if (i > 0) {
            const Complex sum = (segment.impedance + dashpot) * (1.0 + back);
            const Complex all = sum + nearer * (1.0 - back);
            sent *= 2.0 * nearer / all;
            back = (sum - 2.0 * dashpot * (1.0 + back) - nearer * (1.0 - back)) / all;
        }
        back *= through(2 * segment.cells);
        sent *= through(segment.cells);
        nearer = segment.impedance;
        dashpot = segment.dashpot;
    }
    const Complex all = eta_ * (1.0 + back) + nearer * (1.0 - back);
    return sent + (1.0 + back) * (force + (nearer - eta_) * sent) / all;
}

}  // namespace signorini
