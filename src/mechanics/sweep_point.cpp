#include "sweep_point.hpp"

#include <algorithm>
#include <deque>
#include <numeric>
#include <utility>

#include "segment_lines.hpp"

namespace signorini {

namespace {

constexpr double same = 1e-9;  // crossings: one time

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
            if (end - at > same) {  // else two fronts at one time
                all.push_back({at, end, piece.value});
            }
            at = end;
        }
    }
    return all;
}

/// Largest |b - a| over all x while waves are watched for so many crossings, exactly: what left the
/// right end at t_1 meets what arrives there at t_2, t_1 <= t_2 <= t_1 + 2 crossings. `states` are
/// those at the beginning, and after each crossing. O(pieces).
double largestStrain(const std::vector<Waves>& states)
{
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

/// Goes on for so long by advance(duration); see(now): the waves of each row.
double strainOfRows(const std::vector<double>& speeds, double duration,
                    const std::function<std::vector<Waves>(double now)>& see,
                    const std::function<void(double duration)>& advance)
{
    std::vector<std::vector<Waves>> states(speeds.size());
    for (double now = 0.0; now < duration;) {
        std::vector<Waves> seen = see(now);
        double next = duration;
        for (std::size_t row = 0; row < states.size(); ++row) {
            const double crossing = seen[row].crossing;
            if (static_cast<double>(states[row].size()) * crossing <= now) {
                states[row].push_back(std::move(seen[row]));
            }
            next = std::min(next, static_cast<double>(states[row].size()) * crossing);
        }
        advance(next - now);
        now = next;
    }
    double worst = 0.0;
    for (std::size_t row = 0; row < states.size(); ++row) {
        worst = std::max(worst, largestStrain(states[row]) / speeds[row]);
    }
    return worst;
}

/// What has come in at the right at t and at the left at t' meets (t' - t)/2 to the right of the
/// middle, where weight stretches by that times the gravity less: each wave takes half.
std::vector<Piece> leaned(const std::vector<Piece>& wave, double begin, double stretch,
                          double gravity)
{
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

}  // namespace

double largestStrain(BarSimulation& simulation, double duration)
{
    if (simulation.segments().empty()) {
        return strainOfRows(
            {1.0}, duration, [&](double) { return std::vector<Waves>{simulation.waves()}; },
            [&](double way) { simulation.advance(way); });
    }
    // Looks at segments end at no common time and would part pieces: they are at a copy.
    BarSimulation copy = simulation;
    const std::vector<Segment> segments = steppedBar(simulation.segments()).segments;
    std::vector<double> speeds;
    speeds.reserve(segments.size());
    for (const Segment& segment : segments) {
        speeds.push_back(segment.speed);
    }
    simulation.advance(duration);
    return strainOfRows(
        speeds, duration, [&](double) { return partsOf(copy.waves(), segments); },
        [&](double way) { copy.advance(way); });
}

double largestStrain(NetworkSimulation& simulation, double duration)
{
    const Network& network = simulation.network();
    std::vector<double> speeds;
    speeds.reserve(network.rows.size());
    for (const CellRow& row : network.rows) {
        speeds.push_back(row.speed);
    }
    const auto see = [&](double now) {
        const std::vector<std::vector<Piece>> channels = piecesOf(network, simulation.state());
        std::vector<Waves> seen;
        for (std::size_t k = 0; k < network.rows.size(); ++k) {
            const CellRow& row = network.rows[k];
            const auto cells = static_cast<double>(row.cells);
            const double stretch =
                (network.nodes[row.right].rest - network.nodes[row.left].rest) / cells;
            seen.push_back({cells, leaned(channels[2 * k], now, 0.0, network.gravity),
                            leaned(channels[2 * k + 1], now, stretch, network.gravity)});
        }
        return seen;
    };
    return strainOfRows(speeds, duration, see, [&](double way) { simulation.advance(way); });
}

bool settle(SweepPoint& point, std::int64_t most,
            const std::function<Followed(double periods)>& follow)
{
    constexpr std::int64_t firstLook = 50;  // [periods]
    for (std::int64_t look = std::min(firstLook, most);
         !point.settling.settled && point.watched < most;
         look = std::min(2 * look, most - point.watched)) {
        Followed followed = follow(static_cast<double>(look));
        if (!followed.isComplete) {
            return false;
        }
        point.watched += look;
        point.settling = std::move(followed.settling);
    }
    return true;
}

void enterPeriods(SweepPoint& point, const std::vector<std::int64_t>& contacts,
                  const std::vector<double>& impulses)
{
    const auto [fewest, most] = std::minmax_element(contacts.begin(), contacts.end());
    const auto [least, largest] = std::minmax_element(impulses.begin(), impulses.end());
    point.contacts = {*fewest, *most};
    point.impulse = {*least, *largest};
    const auto count = static_cast<double>(contacts.size());
    point.meanContacts =
        static_cast<double>(std::accumulate(contacts.begin(), contacts.end(), std::int64_t{0})) /
        count;
    point.meanImpulse = std::accumulate(impulses.begin(), impulses.end(), 0.0) / count;
}

}  // namespace signorini
