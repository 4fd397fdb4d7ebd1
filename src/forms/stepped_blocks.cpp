#include "stepped_blocks.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "faults.hpp"

namespace signorini {

namespace {

/// One phase after another, as blocks.
class Layout {
public:
    explicit Layout(SteppedBlocks& result, double tipFloor)
        : result_(result), tipFloor_(tipFloor), half_(0.5 * static_cast<double>(result.bar.cells))
    {
        result_.echo.resize(result_.types.size() * static_cast<std::size_t>(result_.turns));
    }

    void contact(std::int64_t steps, Stop stop)
    {
        take(steps, [stop](StepBlock& block) {
            block.isContact = true;
            block.push = stop == Stop::right ? 1 : -1;
        });
    }

    /// From one stop to the next that is touched.
    void flight(std::int64_t steps, Stop from, Stop to)
    {
        const Stops& stops = result_.schedule.stops;
        const double start = placeOf(stops, from).value();
        const double low =
            stops.left ? std::max(tipFloor_, placeOf(stops, Stop::left).value()) : tipFloor_;
        take(steps, [&](StepBlock& block) {
            block.bound = half_ * (placeOf(stops, Stop::right).value() - start);
            block.floor = half_ * (low - start);
        });
        result_.blocks.back().isFlightEnd = true;
        result_.blocks.back().landing = half_ * (placeOf(stops, to).value() - start);
    }

private:
    template <typename Fill>
    void take(std::int64_t steps, Fill fill)
    {
        for (const std::int64_t end = step_ + steps; step_ < end;) {
            const std::int64_t residue = step_ % result_.unit;
            const auto after = std::upper_bound(
                result_.types.begin(), result_.types.end(), residue,
                [](std::int64_t value, const ResidueType& type) { return value < type.first; });
            StepBlock block;
            block.type = static_cast<std::size_t>(after - result_.types.begin()) - 1;
            block.turn = step_ / result_.unit;
            fill(block);
            result_.echo[block.type * static_cast<std::size_t>(result_.turns) +
                         static_cast<std::size_t>(block.turn)] = block.isContact ? -1 : 1;
            result_.blocks.push_back(block);
            step_ += result_.types[block.type].width;
        }
    }

    SteppedBlocks& result_;
    double tipFloor_;
    double half_;
    std::int64_t step_ = 0;
};

/// Residues at which a type begins.
std::set<std::int64_t> cutsOf(const Schedule& schedule, std::int64_t unit, bool lumps)
{
    std::set<std::int64_t> cuts{0};
    if (!lumps) {
        for (std::int64_t residue = 0; residue < unit; ++residue) {
            cuts.insert(cuts.end(), residue);
        }
        return cuts;
    }
    std::int64_t step = 0;
    for (const Phase& phase : schedule.phases) {
        cuts.insert(step % unit);
        cuts.insert((step + phase.contact) % unit);
        step += phase.contact + phase.free;
    }
    return cuts;
}

/// Reads waves off the sums, at any step of any joint's clock.
class WaveReader {
public:
    WaveReader(const SteppedBlocks& blocks, const ArrivalSums& sums)
        : blocks_(blocks), sums_(sums), typeOf_(static_cast<std::size_t>(blocks.unit))
    {
        for (std::size_t t = 0; t < blocks.types.size(); ++t) {
            const ResidueType& type = blocks.types[t];
            std::fill_n(typeOf_.begin() + static_cast<std::ptrdiff_t>(type.first), type.width, t);
        }
    }

    /// r^j.
    [[nodiscard]] double fromLeft(std::size_t joint, std::int64_t step) const
    {
        const Place place = placeOf(step);
        return sums_(static_cast<Eigen::Index>(joint), place.column) / place.width;
    }

    /// The wave that arrives at a joint from its right; joint 0 is the clamp, j that after segment
    /// j.
    [[nodiscard]] double fromRight(std::size_t joint, std::int64_t step) const
    {
        const SteppedBar& bar = blocks_.bar;
        const std::size_t tip = bar.segments.size() - 1;
        if (joint == 0) {
            return -fromLeft(0, step + 2 * bar.segments.front().cells);
        }
        double wave = placeOf(step).echo * fromLeft(tip, step);
        for (std::size_t j = tip; j > joint; --j) {
            const JointWeights& w = bar.joints[j - 1];
            const double r = fromLeft(j - 1, step);
            wave = w.velocity(r, wave) - r;
        }
        return wave;
    }

private:
    struct Place {
        Eigen::Index column;
        double width;
        int echo;
    };

    [[nodiscard]] Place placeOf(std::int64_t step) const
    {
        const std::int64_t n = blocks_.unit * blocks_.turns;
        const std::int64_t m = ((step % n) + n) % n;
        const std::size_t t = typeOf_[static_cast<std::size_t>(m % blocks_.unit)];
        const std::int64_t turn = m / blocks_.unit;
        return {static_cast<Eigen::Index>(t) * blocks_.turns + turn,
                static_cast<double>(blocks_.types[t].width), blocks_.echoOf(t, turn)};
    }

    const SteppedBlocks& blocks_;
    const ArrivalSums& sums_;
    std::vector<std::size_t> typeOf_;
};

}  // namespace

std::int64_t SteppedBlocks::stateSize() const
{
    return std::accumulate(delays.begin(), delays.end(), std::int64_t{0});
}

SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule, double tipFloor, bool lumps)
{
    validate(schedule);
    requireCells(bar, schedule.cells);
    Faults faults;
    const std::int64_t n = steps(schedule);
    if (n > maxSteppedSteps) {
        faults.add("steps of the schedule", n,
                   fmt::format("at most {} for a bar of several segments", maxSteppedSteps));
    }
    faults.throwIfAny();
    SteppedBlocks result;
    result.bar = bar;
    result.schedule = schedule;
    result.unit = n;
    for (const Segment& segment : bar.segments) {
        result.unit = std::gcd(result.unit, 2 * segment.cells);
    }
    result.turns = n / result.unit;
    for (const Segment& segment : bar.segments) {
        result.delays.push_back(2 * segment.cells / result.unit);
    }
    const std::set<std::int64_t> cuts = cutsOf(schedule, result.unit, lumps);
    for (auto cut = cuts.begin(); cut != cuts.end(); ++cut) {
        const auto next = std::next(cut);
        result.types.push_back({*cut, (next == cuts.end() ? result.unit : *next) - *cut});
    }
    Layout layout(result, tipFloor);
    const std::vector<Phase>& phases = schedule.phases;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        layout.contact(phases[k].contact, phases[k].stop);
        layout.flight(phases[k].free, phases[k].stop, phases[(k + 1) % phases.size()].stop);
    }
    return result;
}

State stateOf(const SteppedBlocks& blocks, const ArrivalSums& sums)
{
    const WaveReader reader(blocks, sums);
    const SteppedBar& bar = blocks.bar;
    State state{Eigen::VectorXd(bar.cells), Eigen::VectorXd(bar.cells)};
    std::int64_t first = 0;
    for (std::size_t i = 0; i < bar.segments.size(); ++i) {
        const std::int64_t cells = bar.segments[i].cells;
        const std::int64_t ahead = bar.cells - first - cells;  // of the tip's clock
        for (std::int64_t k = 0; k < cells; ++k) {
            state.a[first + cells - 1 - k] = reader.fromLeft(i, k - ahead);
            state.b[first + k] = reader.fromRight(i, k - ahead - cells);
        }
        first += cells;
    }
    return state;
}

}  // namespace signorini
