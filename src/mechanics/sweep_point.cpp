#include "sweep_point.hpp"

#include <algorithm>
#include <deque>

namespace signorini {

namespace {

/// A piece of a wave, and when it is at the tip [crossings].
struct Passing {
    double begin;
    double end;
    double value;
};

/// One wave at the tip, from a time on.
std::vector<Passing> passing(const std::vector<Waves>& states, std::vector<Piece> Waves::*wave,
                             double from)
{
    std::vector<Passing> all;
    for (std::size_t k = 0; k < states.size(); ++k) {
        double at = from + static_cast<double>(k);
        for (const Piece& piece : states[k].*wave) {
            const double end = at + piece.duration / states[k].crossing;
            all.push_back({at, end, piece.value});
            at = end;
        }
    }
    return all;
}

}  // namespace

double largestStrain(const std::vector<Waves>& states)
{
    constexpr double same = 1e-9;
    const std::vector<Passing> arriving = passing(states, &Waves::a, 0.0);
    const std::vector<Passing> leaving = passing(states, &Waves::b, -1.0);
    double worst = 0.0;
    // Of the arriving pieces in sight those that none after them exceeds, the largest first.
    for (const double sign : {1.0, -1.0}) {
        std::deque<const Passing*> inSight;
        auto next = arriving.begin();
        for (const Passing& left : leaving) {
            for (; next != arriving.end() && next->begin < left.end + 2.0 - same; ++next) {
                while (!inSight.empty() && sign * inSight.back()->value <= sign * next->value) {
                    inSight.pop_back();
                }
                inSight.push_back(&*next);
            }
            while (!inSight.empty() && inSight.front()->end <= left.begin + same) {
                inSight.pop_front();
            }
            if (!inSight.empty()) {
                worst = std::max(worst, sign * (inSight.front()->value - left.value));
            }
        }
    }
    return worst;
}

namespace {

/// Waves of a row, one state after another.
class RowStates {
public:
    RowStates(const Network& network, std::size_t row)
        : network_(network), row_(network.rows[row]), channel_(2 * row)
    {
    }

    [[nodiscard]] double due() const
    {
        return static_cast<double>(states_.size()) * static_cast<double>(row_.cells);
    }

    void add(const std::vector<std::vector<Piece>>& channels)
    {
        const double begin = due();
        const auto cells = static_cast<double>(row_.cells);
        const double stretch =
            (network_.nodes[row_.right].rest - network_.nodes[row_.left].rest) / cells;
        states_.push_back({cells, leaned(channels[channel_], begin, 0.0),
                           leaned(channels[channel_ + 1], begin, stretch)});
    }

    [[nodiscard]] double largest() const { return largestStrain(states_) / row_.speed; }

private:
    /// What has come in at the right at t and at the left at t' meets (t' - t)/2 to the right of
    /// the middle, where weight stretches by that times the gravity less: each wave takes half.
    [[nodiscard]] std::vector<Piece> leaned(const std::vector<Piece>& wave, double begin,
                                            double stretch) const
    {
        const double gravity = network_.gravity;
        std::vector<Piece> all;
        for (const Piece& piece : wave) {
            double left = piece.duration;
            while (left > 0.0) {
                const double part = gravity == 0.0 ? left : std::min(left, 1.0);
                const double middle = begin + 0.5 * part;
                all.push_back({part, piece.value + stretch - 0.5 * gravity * middle});
                left -= part;
                begin += part;
            }
        }
        return all;
    }

    const Network& network_;
    const CellRow& row_;
    std::size_t channel_;
    std::vector<Waves> states_;
};

}  // namespace

double largestStrain(NetworkSimulation& simulation, double duration)
{
    const Network& network = simulation.network();
    std::vector<RowStates> rows;
    for (std::size_t row = 0; row < network.rows.size(); ++row) {
        rows.emplace_back(network, row);
    }
    for (double now = 0.0; now < duration;) {
        const std::vector<std::vector<Piece>> channels = piecesOf(network, simulation.state());
        double next = duration;
        for (RowStates& row : rows) {
            if (row.due() <= now) {
                row.add(channels);
            }
            next = std::min(next, row.due());
        }
        simulation.advance(next - now);
        now = next;
    }
    double worst = 0.0;
    for (const RowStates& row : rows) {
        worst = std::max(worst, row.largest());
    }
    return worst;
}

namespace {

/// What of a wave lies between two times of arrival.
std::vector<Piece> between(const std::vector<Piece>& wave, double from, double to)
{
    std::vector<Piece> part;
    double at = 0.0;
    for (const Piece& piece : wave) {
        const double lasts = std::min(at + piece.duration, to) - std::max(at, from);
        if (lasts > 0.0) {
            part.push_back({lasts, piece.value});
        }
        at += piece.duration;
    }
    return part;
}

}  // namespace

Waves partOf(const Waves& waves, double begin, double crossing)
{
    const double before = waves.crossing - begin - crossing;  // towards the tip
    return {crossing, between(waves.a, before, before + crossing),
            between(waves.b, begin, begin + crossing)};
}

}  // namespace signorini
