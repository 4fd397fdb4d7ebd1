#include "network_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "excited_amplitude.hpp"
#include "infinity.hpp"
#include "largest.hpp"
#include "network_watched.hpp"
#include "sweep_point.hpp"

namespace signorini {

bool isExcitable(const Network& network, Excited place)
{
    return std::any_of(network.nodes.begin(), network.nodes.end(),
                       [place](const NetworkNode& node) {
                           return place == Excited::tip ? node.isDriven : node.isShaken;
                       });
}

void requireExcitable(Faults& faults, const Network& network, Excited place)
{
    if (!isExcitable(network, place)) {
        faults.add("force", name(place),
                   "tip for a scene with the word driven, base for one with shaken");
    }
}

HarmonicDrive harmonicDrive(const Network& network, Excited place, double amplitude, double omega,
                            double phase, std::string_view field)
{
    const double exact = 2.0 * std::numbers::pi / omega;
    const double steps = std::round(exact);
    if (!(steps >= 3.0 && steps <= static_cast<double>(maxExcitationSteps))) {
        const double time = network.scales.time;
        throwFault(field, omega / (2.0 * std::numbers::pi) / time,
                   fmt::format("about {:.3g}..{:.3g} [Hz]",
                               1.0 / (static_cast<double>(maxExcitationSteps) * time),
                               1.0 / (3.0 * time)));
    }
    const bool isWhole = std::abs(exact - steps) <= 1e-9 * exact;
    HarmonicDrive harmonic;
    harmonic.drive.step = isWhole ? 1.0 : exact / steps;
    harmonic.period = harmonic.drive.step * steps;
    const Excitation excitation = excitationOf({.place = place,
                                                .amplitude = amplitude,
                                                .phase = phase,
                                                .steps = static_cast<std::int64_t>(steps),
                                                .stepsPerCrossing = 1.0 / harmonic.drive.step});
    harmonic.base = excitation.baseDisplacement(0);
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        if (place == Excited::tip) {
            harmonic.drive.forces.push_back(excitation.force(m));
        } else {
            harmonic.drive.velocities.push_back(excitation.baseVelocity(m));
        }
    }
    return harmonic;
}

NetworkDrive driveFrom(const Network& network, const NetworkStart& start,
                       const HarmonicDrive& moved)
{
    constexpr double rounding = 1e-9;
    NetworkDrive drive = moved.drive;
    const auto shaken = std::find_if(network.nodes.begin(), network.nodes.end(),
                                     [](const NetworkNode& node) { return node.isShaken; });
    if (shaken != network.nodes.end() && !drive.velocities.empty()) {
        const double here =
            start.displacements[static_cast<std::size_t>(shaken - network.nodes.begin())];
        const double reach = std::abs(here) + largestSizeOf(drive.velocities) * moved.period;
        const double lead = moved.base - here;
        drive.lead = std::abs(lead) <= rounding * reach ? 0.0 : lead;
    }
    return drive;
}

namespace {

/// The state of a network between two values: all channels in `a`, displacements in `b`.
Waves packed(const Network& network, const NetworkStart& state)
{
    Waves waves;
    for (const std::vector<Piece>& channel : piecesOf(network, state)) {
        waves.a.insert(waves.a.end(), channel.begin(), channel.end());
        waves.b.push_back({static_cast<double>(channel.size()), 0.0});
    }
    for (const double displacement : state.displacements) {
        waves.b.push_back({1.0, displacement});
    }
    return waves;
}

NetworkStart unpacked(const Network& network, const Waves& waves)
{
    NetworkStart state;
    auto next = waves.a.begin();
    for (std::size_t k = 0; k < network.channels(); ++k) {
        const auto end = next + static_cast<std::ptrdiff_t>(waves.b[k].duration);
        state.pieces.emplace_back(next, end);
        next = end;
    }
    for (std::size_t k = network.channels(); k < waves.b.size(); ++k) {
        state.displacements.push_back(waves.b[k].value);
    }
    return state;
}

/// One value of a sweep of a network.
class NetworkValue {
public:
    NetworkValue(const NetworkSweep& sweep, double value, std::string_view field = "frequency")
        : sweep_(sweep), network_(sweep.network)
    {
        const SweepRange& range = sweep.range;
        const bool isFrequency = range.over == Swept::frequency;
        ratio_ = isFrequency ? value : range.frequencyRatio;
        const double size =
            isFrequency ? displacementOf(range.amplitude, range.derivative, ratio_) : value;
        const Scales unit = scales(sweep.bar);
        const NetworkScales& scale = network_.scales;
        force_ = sweep.bar.axialStiffness * unit.strain / scale.force();
        displacement_ = unit.displacement / scale.displacement;
        for (const CellRow& row : network_.rows) {
            strain_ += static_cast<double>(row.cells) * row.speed / displacement_;
        }
        impulse_ = force_ * unit.time / scale.time;
        drive_ = harmonicDrive(network_, range.place,
                               size * (range.place == Excited::tip ? force_ : displacement_),
                               0.5 * std::numbers::pi * ratio_ * scale.time / unit.time,
                               std::numbers::pi / 2.0, isFrequency ? field : "frequency");
        constexpr double most = 1e5;  // looks in a period
        resolution_ = range.resolution > 0.0 ? range.resolution * unit.time / scale.time
                                             : std::max(1.0, drive_.period / most);
        if (drive_.period > most * resolution_ * (1.0 + 1e-9)) {
            throwFault("resolution", range.resolution * unit.time,
                       fmt::format("at least {:.3g} [s], of a period of {:.3g} s",
                                   drive_.period / most * scale.time, drive_.period * scale.time));
        }
    }

    [[nodiscard]] std::optional<SweepPoint> settle(double value, SweepDirection direction,
                                                   Waves& waves, const Cancel& cancel) const
    {
        NetworkSimulation simulation(network_, unpacked(network_, waves), drive_.drive,
                                     {.mergeBelow = mergeBelow(waves)});
        WatchedNetwork watched(simulation, drive_.drive);
        SweepPoint point{.value = value, .frequencyRatio = ratio_, .direction = direction};
        if (!signorini::settle(point, sweep_.range.periods, [&](double periods) {
                return follow(watched, drive_.period, periods, cancel);
            })) {
            return std::nullopt;
        }
        measure(simulation.state(), point, waves);
        return point;
    }

private:
    [[nodiscard]] double mergeBelow(const Waves& waves) const
    {
        return 1e-11 *
               std::max({largestSizeOf(waves.a, &Piece::value), largestSizeOf(drive_.drive.forces),
                         largestSizeOf(drive_.drive.velocities)});
    }

    /// A period, resolution by resolution. \return what all contacts pushed in it.
    double advance(NetworkSimulation& seen, SweepPoint& point) const
    {
        const std::size_t count = network_.contacts.size();
        std::vector<double> before(count);
        double sum = 0.0;
        for (std::size_t j = 0; j < count; ++j) {
            before[j] = seen.impulseAt(j);
            sum -= before[j];
        }
        for (double left = drive_.period; left > 0.0; left -= resolution_) {
            seen.advance(std::min(left, resolution_));
            for (std::size_t j = 0; j < count; ++j) {
                const double now = seen.impulseAt(j);
                point.meanForce =
                    std::max(point.meanForce, (now - before[j]) / resolution_ / force_);
                before[j] = now;
            }
        }
        for (const double now : before) {
            sum += now;
        }
        return sum / impulse_;
    }

    void measure(const NetworkStart& state, SweepPoint& point, Waves& waves) const
    {
        const std::int64_t repeats =
            point.settling.settled ? point.settling.settled->periods : mostPeriods;
        NetworkSimulation seen(network_, state, drive_.drive,
                               {.mergeBelow = mergeBelow(waves), .recordsPaths = true});
        SweepPoint ignored;
        (void)advance(seen, ignored);
        const double begin = seen.time();
        NetworkSimulation strained(network_, seen.state(), drive_.drive,
                                   {.mergeBelow = mergeBelow(waves)});
        for (std::int64_t k = 0; k < repeats; ++k) {
            point.strain = std::max(point.strain, strain_ * largestStrain(strained, drive_.period));
        }
        std::vector<double> impulses;
        for (std::int64_t k = 0; k < repeats; ++k) {
            impulses.push_back(advance(seen, point));
        }
        std::vector<std::int64_t> contacts(static_cast<std::size_t>(repeats));
        for (const NetworkContactEvent& event : merged(seen.contacts())) {
            if (event.start >= begin) {
                const auto at = static_cast<std::size_t>((event.start - begin) / drive_.period);
                ++contacts[std::min(at, contacts.size() - 1)];
                point.impulses.push_back(event.impulse / impulse_);
            }
        }
        enterPeriods(point, contacts, impulses);
        if (point.settling.settled) {
            point.settling.settled->contacts = static_cast<std::int64_t>(point.impulses.size());
            point.settling.settled->impulse = point.meanImpulse * static_cast<double>(repeats);
        }
        point.tip = tipRange(seen, begin);
        waves = packed(network_, seen.state());
    }

    /// Contacts of one place no further apart than the resolution are one.
    [[nodiscard]] std::vector<NetworkContactEvent> merged(
        std::vector<NetworkContactEvent> events) const
    {
        std::stable_sort(events.begin(), events.end(), [](const auto& one, const auto& other) {
            return one.contact < other.contact;
        });
        std::vector<NetworkContactEvent> all;
        for (const NetworkContactEvent& event : events) {
            if (!all.empty() && all.back().contact == event.contact &&
                event.start - all.back().end <= resolution_) {
                all.back().end = event.end;
                all.back().impulse += event.impulse;
            } else if (event.impulse > 0.0) {
                all.push_back(event);
            }
        }
        return all;
    }

    [[nodiscard]] std::array<double, 2> tipRange(const NetworkSimulation& seen, double begin) const
    {
        const std::size_t node = network_.contacts.front().node;
        std::array range{infinity, -infinity};
        for (const NodePoint& point : seen.paths()[node]) {
            if (point.time >= begin) {
                const double u = (point.displacement + network_.nodes[node].rest) / displacement_;
                range = {std::min(range[0], u), std::max(range[1], u)};
            }
        }
        const double last = (seen.displacement(node) + network_.nodes[node].rest) / displacement_;
        return {std::min(range[0], last), std::max(range[1], last)};
    }

    const NetworkSweep& sweep_;
    const Network& network_;
    HarmonicDrive drive_;
    double ratio_ = 1.0;
    double force_ = 1.0;  ///< units of the bar in those of the network
    double displacement_ = 1.0;
    double strain_ = 0.0;  ///< and in those of the bar what one of the network is
    double impulse_ = 1.0;
    double resolution_ = 1.0;  ///< [h]
};

}  // namespace

void NetworkSweep::require() const
{
    (void)NetworkValue(*this, range.least, "least");
    (void)NetworkValue(*this, range.most, "most");
}

SweepBody NetworkSweep::body() const
{
    return {[this] { return packed(network, startAtRest(network)); },
            [this](double value, SweepDirection direction, Waves& waves, const Cancel& cancel) {
                return NetworkValue(*this, value).settle(value, direction, waves, cancel);
            }};
}

}  // namespace signorini
