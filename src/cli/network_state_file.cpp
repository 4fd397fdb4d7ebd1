#include "network_state_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "arguments.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr const char* header = "part,number,right,left,displacement";

/// Calls visit(right wave, left wave) with their indices, cell by cell from the left.
template <typename Visit>
void forEachCell(const Network& network, Visit visit)
{
    for (std::size_t row = 0; row < network.rows.size(); ++row) {
        const auto cells = static_cast<std::size_t>(network.rows[row].cells);
        const std::size_t first = network.firstWave(row);
        for (std::size_t k = 0; k < cells; ++k) {
            visit(first + k, first + cells + k);
        }
    }
}

/// Takes lines of a table and says where one is wrong.
class StateLines {
public:
    explicit StateLines(const std::string& path) : path_(path), file_(path)
    {
        if (!file_) {
            throw FileError(path, "cannot read it");
        }
        std::string first;
        std::getline(file_, first);
        if (first != header) {
            refuse(path_ + ", line 1", shortened(first), header);
        }
    }

    /// The next line must be part,number; returns its fields 3 to 5.
    std::array<std::string, 3> take(std::string_view part, std::size_t number)
    {
        std::string line;
        ++line_;
        std::getline(file_, line);
        const std::string start = fmt::format("{},{},", part, number);
        if (line.size() > 400 || !line.starts_with(start)) {
            refuse(where(), shortened(line), fmt::format("{}right,left,displacement", start));
        }
        line.erase(0, start.size());
        std::array<std::string, 3> fields;
        std::size_t at = 0;
        for (std::string& field : fields) {
            const std::size_t comma = std::min(line.find(',', at), line.size());
            field = line.substr(std::min(at, line.size()), comma - std::min(at, line.size()));
            at = comma + 1;
        }
        return fields;
    }

    [[nodiscard]] std::string where() const { return fmt::format("{}, line {}", path_, line_); }

private:
    std::string path_;
    std::ifstream file_;
    std::size_t line_ = 1;
};

}  // namespace

void writeNetworkState(const std::string& path, const Network& network, const NetworkStart& state)
{
    const double speed = network.scales.velocity();
    TextFile file(path);
    file.write(fmt::format("{}\n", header));
    std::size_t number = 0;
    forEachCell(network, [&](std::size_t right, std::size_t left) {
        file.write(fmt::format("cell,{},{},{},\n", ++number, state.waves[right] * speed,
                               state.waves[left] * speed));
    });
    for (std::size_t k = 0; k < network.stubs.size(); ++k) {
        const double wave = state.waves[network.firstWave(network.rows.size()) + k];
        file.write(fmt::format("stub,{},{},,\n", k + 1, wave * speed));
    }
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        file.write(fmt::format("node,{},,,{}\n", node + 1,
                               state.displacements[node] * network.scales.displacement));
    }
    file.close();
}

NetworkStart readNetworkState(const std::string& path, const Network& network)
{
    const double speed = network.scales.velocity();
    StateLines lines(path);
    NetworkStart state{.waves = std::vector<double>(network.waves(), 0.0), .displacements = {}};
    std::size_t number = 0;
    forEachCell(network, [&](std::size_t right, std::size_t left) {
        const auto fields = lines.take("cell", ++number);
        state.waves[right] = parseReal(lines.where(), fields[0], "m/s") / speed;
        state.waves[left] = parseReal(lines.where(), fields[1], "m/s") / speed;
    });
    for (std::size_t k = 0; k < network.stubs.size(); ++k) {
        const auto fields = lines.take("stub", k + 1);
        state.waves[network.firstWave(network.rows.size()) + k] =
            parseReal(lines.where(), fields[0], "m/s") / speed;
    }
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        const auto fields = lines.take("node", node + 1);
        state.displacements.push_back(parseReal(lines.where(), fields[2], "m") /
                                      network.scales.displacement);
    }
    return state;
}

}  // namespace signorini::cli
