#include <algorithm>
#include <cmath>

#include "channel_waves.hpp"
#include "faults.hpp"
#include "infinity.hpp"
#include "largest.hpp"
#include "network_simulation.hpp"

namespace signorini {

namespace {

constexpr double sameSize = 1e-12;
constexpr double fewRoundings = 1e-10;  // of an instant, after thousands of bounces

void requirePieces(Faults& faults, const Network& network, const NetworkStart& start)
{
    if (!start.pieces.empty() && start.pieces.size() != network.channels()) {
        faults.add("waves of the start", start.pieces.size(),
                   fmt::format("{}, one for each direction of a bar", network.channels()));
        return;
    }
    for (std::size_t k = 0; k < start.pieces.size(); ++k) {
        const auto delay = static_cast<double>(lengthOf(network, k));
        double total = 0.0;
        for (const Piece& piece : start.pieces[k]) {
            const bool isPiece = piece.duration > 0.0 && std::isfinite(piece.value);
            total = isPiece ? total + piece.duration : infinity;
        }
        if (!(std::abs(total - delay) <= 1e-9 * delay)) {
            faults.add(fmt::format("wave {} of the start", k + 1), total,
                       fmt::format("finite values for durations > 0, {} [h] in all", delay));
        }
    }
}

/// Adds to the means of cells what arrives from one time to another.
void addMean(std::vector<double>& waves, const ChannelWaves& channel, double begin, double end,
             double value)
{
    for (auto order = static_cast<std::size_t>(begin);
         order < channel.size() && static_cast<double>(order) < end; ++order) {
        const auto from = static_cast<double>(order);
        waves[channel.at(order)] += (std::min(end, from + 1.0) - std::max(begin, from)) * value;
    }
}

}  // namespace

std::vector<std::vector<Piece>> piecesOf(const Network& network, const NetworkStart& start)
{
    if (!start.pieces.empty()) {
        return start.pieces;
    }
    std::vector<std::vector<Piece>> pieces(network.channels());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const ChannelWaves channel(network, k);
        for (std::size_t order = 0; order < channel.size(); ++order) {
            const double value = start.waves[channel.at(order)];
            if (order > 0 && value == pieces[k].back().value) {
                pieces[k].back().duration += 1.0;
            } else {
                pieces[k].push_back({1.0, value});
            }
        }
    }
    return pieces;
}

std::vector<double> meansOf(const Network& network, const NetworkStart& start)
{
    Faults faults;
    requirePieces(faults, network, start);
    faults.throwIfAny();
    if (start.pieces.empty()) {
        return start.waves;
    }
    std::vector<double> waves(network.waves(), 0.0);
    for (std::size_t k = 0; k < start.pieces.size(); ++k) {
        const ChannelWaves channel(network, k);
        double begin = 0.0;
        for (const Piece& piece : start.pieces[k]) {
            const double end = begin + piece.duration;
            addMean(waves, channel, begin, end, piece.value);
            begin = end;
        }
    }
    return waves;
}

NetworkStart NetworkSimulation::state() const
{
    NetworkStart state{.waves = std::vector<double>(network_.waves(), 0.0), .displacements = {}};
    for (std::size_t k = 0; k < channels_.size(); ++k) {
        const ChannelWaves channel(network_, k);
        double begin = 0.0;
        std::vector<Piece>& pieces = state.pieces.emplace_back();
        channels_[k].forEachPiece(now_, [&](double duration, double value) {
            if (duration > 0.0) {
                pieces.push_back({duration, value});
            }
            addMean(state.waves, channel, begin, begin + duration, value);
            begin += duration;
        });
    }
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
        state.displacements.push_back(displacement(node));
    }
    return state;
}

NetworkSimulation::NetworkSimulation(const Network& network, const NetworkStart& start,
                                     const NetworkDrive& drive, const NetworkOptions& options)
    : network_(network),
      drive_(drive),
      options_(options),
      channels_(network.channels()),
      nodes_(network.nodes.size()),
      touches_(network.contacts.size()),
      arriving_(network.channels(), 0.0),
      due_((network.channels() + network.contacts.size() + lanes) / lanes * lanes, infinity),
      paths_(network.nodes.size())
{
    validate(network);
    Faults faults;
    const auto areFinite = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    };
    if (start.pieces.empty() &&
        (start.waves.size() != network.waves() || !areFinite(start.waves))) {
        faults.add("waves of the start", start.waves.size(),
                   fmt::format("{}, all finite", network.waves()));
    }
    requirePieces(faults, network, start);
    if (start.displacements.size() != nodes_.size() || !areFinite(start.displacements)) {
        faults.add("displacements of the start", start.displacements.size(),
                   fmt::format("{}, all finite", nodes_.size()));
    }
    if (!areFinite(drive.forces) || !areFinite(drive.velocities) ||
        !(drive.step > 0.0 && std::isfinite(drive.step))) {
        faults.add("excitation", drive.step, "finite values and a step > 0 [h]");
    }
    faults.throwIfAny();
    const std::vector<std::vector<Piece>> pieces = piecesOf(network_, start);
    setScale(pieces);
    place(pieces, start.displacements);
    startEnergy_ = energy();
    startMomentum_ = momentum();
}

void NetworkSimulation::setScale(const std::vector<std::vector<Piece>>& pieces)
{
    double least = infinity;
    double most = 0.0;
    for (std::size_t k = 0; k < channels_.size(); ++k) {
        least = std::min(least, network_.impedanceOf(k));
        most = std::max(most, network_.impedanceOf(k));
    }
    const double speed = std::max(
        {largestOf(pieces, [](const auto& wave) { return largestSizeOf(wave, &Piece::value); }),
         largestSizeOf(network_.nodes, &NetworkNode::force) / least,
         largestSizeOf(drive_.forces) / least, largestSizeOf(drive_.velocities)});
    same_ = sameSize * static_cast<double>(network_.cells());
    together_ = fewRoundings * static_cast<double>(network_.cells());
    slow_ = sameSize * speed;
    small_ = slow_ * most;
}

void NetworkSimulation::place(const std::vector<std::vector<Piece>>& pieces,
                              const std::vector<double>& displacements)
{
    for (std::size_t k = 0; k < channels_.size(); ++k) {
        Channel& channel = channels_[k];
        channel.impedance = network_.impedanceOf(k);
        channel.node = network_.nodeOf(k);
        channel.sign = network_.sign(k);
        nodes_[channel.node].channels.push_back(k);
        channel.delay = static_cast<double>(lengthOf(network_, k));
        channel.now = pieces[k].front().value;
        double begin = 0.0;
        for (const Piece& piece : pieces[k]) {
            if (piece.value != channel.value()) {
                channel.push({begin, piece.value});
            }
            begin += piece.duration;
        }
        arriving_[k] = channel.now;
        due_[k] = channel.due();
    }
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
        const NetworkNode& given = network_.nodes[node];
        nodes_[node].displacement = displacements[node];
        nodes_[node].isActed =
            given.isClamped || given.isDriven || given.dashpot != 0.0 || given.force != 0.0 ||
            std::any_of(nodes_[node].channels.begin(), nodes_[node].channels.end(),
                        [this](std::size_t k) { return channels_[k].sign < 0.0; });
    }
    for (std::size_t j = 0; j < touches_.size(); ++j) {
        forEachSide(network_.contacts[j], [&](std::size_t node, int) {
            nodes_[node].contacts.push_back(j);
            nodes_[node].touching |= ContactSet{1} << j;
            nodes_[node].hasPath = options_.recordsPaths;
        });
    }
    for (std::size_t j = 0; j < touches_.size(); ++j) {
        close_.push_back(slow_ + sameSize * std::abs(network_.contacts[j].gap));
        if (const double size =
                close_[j] + sameSize * std::abs(displacement(network_.contacts[j].node));
            distance(j) < -1000.0 * size) {
            throwFault(fmt::format("distance of contact {} at the start", j + 1),
                       distance(j) * network_.scales.displacement, ">= 0 [m]",
                       "bars do not overlap: start at rest, or from a state");
        }
    }
    if (!drive_.forces.empty() || !drive_.velocities.empty()) {
        takeClock();
    }
    law_ = &lawOf(0);
    Range all{0, nodes_.size() - 1};
    settle(all);
}

}  // namespace signorini
