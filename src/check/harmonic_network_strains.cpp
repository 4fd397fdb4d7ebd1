// Strain anywhere in a network under a harmonic: what has come in at one end of a row meets what
// came in at the other, once in each cell and once between two cells, all times of a step with all
// times. Where steps are long, cells and steps are cut in parts.

#include <algorithm>

#include "harmonic_network_walk.hpp"
#include "harmonic_walk.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

/// Into how many a step is cut, so that a period has about a thousand, and not too many cells.
std::int64_t cutsOf(const HarmonicNetwork& given)
{
    constexpr std::int64_t mostCells = 20'000;
    return std::max<std::int64_t>(1,
                                  std::min(1000 / given.steps, mostCells / given.network.cells()));
}

/// What arrives in a part of each step, channel by channel, cut by cut; nothing in other cuts.
struct StepPart {
    double from;
    double to;
    std::vector<std::vector<HarmonicBounds>> of;
};

/// Of l - r, where these are anything within their bounds.
void widen(HarmonicBounds& seen, const HarmonicBounds& left, const HarmonicBounds& right)
{
    seen = {std::min(seen.least, left.least - right.most),
            std::max(seen.most, left.most - right.least)};
}

class RowStrains {
public:
    RowStrains(const HarmonicNetwork& given, std::span<const double> displaced,
               const std::vector<StepPart>& parts, NetworkHarmonicMotion& motion)
        : given_(given), displaced_(displaced), parts_(parts), motion_(motion)
    {
    }

    void stretch(std::size_t r)
    {
        row_ = &given_.network.rows[r];
        right_ = 2 * r;
        left_ = right_ + 1;
        const std::vector<HarmonicBounds> right = wholeSteps(right_);
        const std::vector<HarmonicBounds> left = wholeSteps(left_);
        const std::int64_t n = steps();
        const std::int64_t all = row_->cells * cuts_;
        // Without weight all cells are the same, and the motion comes back after n steps.
        const std::int64_t cells = given_.network.gravity == 0.0 ? std::min(all, n) : all;
        for (std::int64_t k = 0; k < cells; ++k) {
            const HarmonicBounds* from = right.data() + (all - 1 - k) % n;
            const HarmonicBounds* to = left.data() + k % n;
            HarmonicBounds seen{infinity, -infinity};
            for (std::int64_t m = 0; m < n; ++m) {
                widen(seen, to[m], from[m]);
                if (k + 1 < all) {
                    widen(seen, to[m + 1], from[m]);
                }
            }
            enter(seen, k / cuts_);
        }
        stretchEnds();
    }

private:
    [[nodiscard]] std::int64_t steps() const { return given_.steps * cuts_; }

    /// What enters does so after what arrived.
    void stretchEnds()
    {
        HarmonicBounds atLeft{infinity, -infinity};
        HarmonicBounds atRight = atLeft;
        for (const StepPart& l : parts_) {
            for (const StepPart& r : parts_) {
                for (std::int64_t m = 0; m < steps(); ++m) {
                    const std::int64_t later = m + row_->cells * cuts_;
                    if (l.from <= r.from) {
                        widen(atRight, at(l.of[left_], later), at(r.of[right_], m));
                    }
                    if (r.from <= l.from) {
                        widen(atLeft, at(l.of[left_], m), at(r.of[right_], later));
                    }
                }
            }
        }
        enter(atLeft, 0);
        enter(atRight, row_->cells - 1);
    }

    /// Of two periods, so that places in them need no remainders.
    [[nodiscard]] std::vector<HarmonicBounds> wholeSteps(std::size_t channel) const
    {
        std::vector<HarmonicBounds> all = parts_.front().of[channel];
        for (const StepPart& part : parts_) {
            for (std::size_t m = 0; m < all.size(); ++m) {
                const HarmonicBounds& seen = part.of[channel][m];
                all[m] = {std::min(all[m].least, seen.least), std::max(all[m].most, seen.most)};
            }
        }
        const std::size_t count = all.size();
        all.resize(2 * count);
        std::copy_n(all.begin(), count, all.begin() + static_cast<std::ptrdiff_t>(count));
        return all;
    }

    [[nodiscard]] const HarmonicBounds& at(const std::vector<HarmonicBounds>& of,
                                           std::int64_t m) const
    {
        return of[static_cast<std::size_t>(m % steps())];
    }

    /// What was seen in cell k.
    void enter(const HarmonicBounds& seen, std::int64_t k)
    {
        const double rest =
            given_.network.stretchAtRest(*row_, k) +
            (displaced_[row_->right] - displaced_[row_->left]) / static_cast<double>(row_->cells);
        motion_.leastStrain = std::min(motion_.leastStrain, (seen.least + rest) / row_->speed);
        motion_.mostStrain = std::max(motion_.mostStrain, (seen.most + rest) / row_->speed);
    }

    const HarmonicNetwork& given_;
    std::int64_t cuts_ = cutsOf(given_);
    std::span<const double> displaced_;
    const std::vector<StepPart>& parts_;
    NetworkHarmonicMotion& motion_;
    const CellRow* row_ = nullptr;
    std::size_t right_ = 0;  ///< channels
    std::size_t left_ = 0;
};

}  // namespace

void measureStrains(const HarmonicNetwork& given, std::span<const double> displaced,
                    NetworkHarmonicMotion& motion)
{
    const std::int64_t cuts = cutsOf(given);
    std::vector<StepPart> parts;
    NetworkHarmonicMotion walked = motion;
    const auto keep = [&](std::span<const SteadyHarmonic> arriving, double from, double to) {
        auto part = std::find_if(parts.begin(), parts.end(),
                                 [&](const StepPart& one) { return one.from == from; });
        if (part == parts.end()) {
            part = parts.insert(part, {from, to, {}});
            part->of.resize(arriving.size());
        }
        for (std::int64_t cut = 0; cut < cuts; ++cut) {
            const double begin =
                std::max(from, static_cast<double>(cut) / static_cast<double>(cuts));
            const double end =
                std::min(to, static_cast<double>(cut + 1) / static_cast<double>(cuts));
            for (std::size_t channel = 0; channel < arriving.size(); ++channel) {
                HarmonicBounds& seen =
                    part->of[channel].emplace_back(HarmonicBounds{infinity, -infinity});
                if (begin < end || cuts == 1) {
                    const auto [steady, swing] = arriving[channel];
                    seen = boundsOf(swing, given.omega() * begin, given.omega() * end);
                    seen = {seen.least + steady, seen.most + steady};
                }
            }
        }
    };
    measure(given, walked, {.arrivals = keep});
    motion.leastStrain = 0.0;
    motion.mostStrain = 0.0;
    RowStrains strains(given, displaced, parts, motion);
    for (std::size_t row = 0; row < given.network.rows.size(); ++row) {
        strains.stretch(row);
    }
}

}  // namespace signorini
