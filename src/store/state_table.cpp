#include "state_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "contact_spans.hpp"
#include "printing.hpp"
#include "stepped_bar.hpp"
#include "table.hpp"

namespace signorini {

namespace {

/// What one unit of duration, velocity and displacement is.
struct StateUnits {
    double second;
    double velocity;
    double metre;
};

StateUnits unitsOf(const Network& network)
{
    return {network.scales.time, network.scales.velocity(), network.scales.displacement};
}

StateUnits unitsOf(const Bar& bar, double crossing)
{
    return {scales(bar).time / crossing, scales(bar).velocity, scales(bar).displacement};
}

void write(const std::string& path, const NetworkStart& state, const StateUnits& unit)
{
    writeCsv(path, "node,displacement,wave,duration,velocity", [&](CsvRows& row) {
        for (std::size_t node = 0; node < state.displacements.size(); ++node) {
            row(node + 1, state.displacements[node] * unit.metre, 0, 0, 0);
        }
        for (std::size_t wave = 0; wave < state.pieces.size(); ++wave) {
            for (const Piece& piece : state.pieces[wave]) {
                row(0, 0, wave + 1, piece.duration * unit.second, piece.value * unit.velocity);
            }
        }
    });
}

/// A duration that is whole but for the rounding of units is whole.
double wholeIfNear(double duration)
{
    constexpr double rounding = 1e-14;
    const double whole = std::round(duration);
    return std::abs(duration - whole) <= rounding * whole ? whole : duration;
}

NetworkStart read(Table& table, std::size_t waves, std::size_t nodes, const StateUnits& unit)
{
    constexpr std::size_t mostPieces = 100'000'000;
    const std::size_t atNode = table.columnOf("node");
    const std::size_t atDisplacement = table.columnOf("displacement");
    const std::size_t atWave = table.columnOf("wave");
    const std::size_t atDuration = table.columnOf("duration");
    const std::size_t atVelocity = table.columnOf("velocity");
    NetworkStart state;
    state.pieces.resize(waves);
    std::size_t count = 0;
    while (table.next()) {
        if (table.numberAt(atWave) == 0.0) {
            const double expected = static_cast<double>(state.displacements.size()) + 1.0;
            if (table.numberAt(atNode) != expected || state.displacements.size() == nodes) {
                table.refuse(atNode, fmt::format("1..{}, each once, ascending", nodes));
            }
            state.displacements.push_back(table.numberAt(atDisplacement) / unit.metre);
            continue;
        }
        const double wave = table.numberAt(atWave);
        if (!(wave >= 1.0 && wave <= static_cast<double>(waves) && wave == std::floor(wave))) {
            table.refuse(atWave, fmt::format("whole numbers up to {}", waves));
        }
        const double duration = wholeIfNear(table.numberAt(atDuration) / unit.second);
        if (!(duration > 0.0)) {
            table.refuse(atDuration, "numbers > 0 [s]");
        }
        if (++count > mostPieces) {
            table.refuse(fmt::format("allowed at most {} pieces", mostPieces));
        }
        state.pieces[static_cast<std::size_t>(wave) - 1].push_back(
            {duration, table.numberAt(atVelocity) / unit.velocity});
    }
    if (state.displacements.size() != nodes) {
        table.refuse(fmt::format("places of {} nodes: allowed {}, those of the scene",
                                 state.displacements.size(), nodes));
    }
    for (std::size_t wave = 0; wave < waves; ++wave) {
        if (state.pieces[wave].empty()) {
            table.refuse(fmt::format("no wave {}: allowed 1..{}, all of them", wave + 1, waves));
        }
    }
    return state;
}

}  // namespace

void writeStateTable(const std::string& path, const Network& network, const NetworkStart& state)
{
    NetworkStart whole = state;
    whole.pieces = piecesOf(network, state);
    write(path, whole, unitsOf(network));
}

NetworkStart readStateTable(const std::string& path, const Network& network)
{
    Table table(path);
    return read(table, network.channels(), network.nodes.size(), unitsOf(network));
}

std::vector<double> readNearestWaves(const std::string& path, const Network& network,
                                     const std::optional<Scene>& bar)
{
    Table table(path);
    if (bar && haveOneSpeed(bar->segments) && !table.has("wave")) {
        return wavesOf(
            network, readState(table, firstMaterial(*bar), network.cells(), maxMeasurements).state);
    }
    return meansOf(network,
                   read(table, network.channels(), network.nodes.size(), unitsOf(network)));
}

void writeStateTable(const std::string& path, const Waves& waves, double tip, const Bar& bar)
{
    write(path, {{}, {waves.base.value_or(0.0), tip}, {waves.a, waves.b}},
          unitsOf(bar, waves.crossing));
}

Waves readWaves(const std::string& path, const Bar& bar, std::int64_t cells, bool isUniform)
{
    Table table(path);
    if (!table.has("wave")) {
        const StateReading reading = readState(table, bar, cells, maxMeasurements);
        Waves waves = wavesOf(reading.state);
        waves.base = isUniform ? reading.base : std::nullopt;
        return waves;
    }
    const auto crossing = static_cast<double>(cells);
    NetworkStart state = read(table, 2, 2, unitsOf(bar, crossing));
    return {crossing, std::move(state.pieces[0]), std::move(state.pieces[1]),
            state.displacements[0]};
}

}  // namespace signorini
