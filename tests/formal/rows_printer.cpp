/// \file
/// Rows of schedules and networks as our C++ makes them, for tests/formal/rows_compared.py.
///
/// Reads lines of whole numbers, "paper N n_c n_f ..." or "chain ...", and prints the rows of each:
/// those of paper/equations.hpp, or, by carrying unit waves, those of the law of
/// mechanics/network.hpp.

#include <fmt/format.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "equations.hpp"
#include "network.hpp"
#include "rational.hpp"

namespace {

using namespace signorini;

std::int64_t next(std::istream& in)
{
    std::int64_t value = 0;
    if (!(in >> value)) {
        throw std::runtime_error("a line ends too early");
    }
    return value;
}

void printRows(const std::string& name, const SparseMatrix& rows)
{
    const Eigen::MatrixXd dense(rows);
    for (Eigen::Index i = 0; i < dense.rows(); ++i) {
        std::cout << name << ' ' << i << ':';
        for (Eigen::Index j = 0; j < dense.cols(); ++j) {
            std::cout << ' ' << dense(i, j);
        }
        std::cout << '\n';
    }
}

void printPaper(std::istream& in)
{
    Schedule schedule;
    schedule.cells = next(in);
    schedule.phases.clear();
    for (std::int64_t contact = 0; in >> contact;) {
        schedule.phases.push_back({contact, next(in)});
    }
    const Inequalities rows = inequalities(schedule);
    printRows("pressure", rows.pressure);
    printRows("penetration", rows.penetration);
    printRows("period", periodMap(schedule));
    printRows("gap", gapRow(schedule.cells));
}

/// R; cells and impedance of each row; of each node 0 (clamp), 1 dashpot, 2 dashpot and place of a
/// right stop, 3 the same of a left one, 4 two dashpots and a gap; steps, and a set of contacts for
/// each.
Network readNetwork(std::istream& in)
{
    Network network;
    const auto rows = static_cast<std::size_t>(next(in));
    for (std::size_t k = 0; k < rows; ++k) {
        const std::int64_t cells = next(in);
        network.rows.push_back({cells, static_cast<double>(next(in)), 1.0, 0, 0});
    }
    network.bars.push_back({});
    for (std::size_t k = 0; k <= rows; ++k) {
        const std::int64_t kind = next(in);
        const auto addNode = [&](bool clamped, std::int64_t dashpot) {
            network.nodes.push_back({.isClamped = clamped,
                                     .dashpot = static_cast<double>(dashpot),
                                     .bar = network.bars.size() - 1});
            network.bars.back().lastNode = network.nodes.size() - 1;
            network.bars.back().clamps += clamped ? 1 : 0;
        };
        const auto place = [&] { return static_cast<double>(next(in)); };
        addNode(kind == 0, kind == 0 ? 0 : next(in));
        const std::size_t node = network.nodes.size() - 1;
        if (k > 0) {
            network.rows[k - 1].right = node;
        }
        if (kind == 2) {
            network.contacts.push_back({ContactKind::stopRight, node, place()});
        } else if (kind == 3) {
            network.contacts.push_back({ContactKind::stopLeft, node, place()});
        } else if (kind == 4) {
            network.bars.push_back({.firstNode = node + 1});
            addNode(false, next(in));
            network.contacts.push_back({ContactKind::gap, node, place()});
        }
        if (k < rows) {
            network.rows[k].left = network.nodes.size() - 1;
        }
    }
    validate(network);
    return network;
}

using Columns = std::vector<Rational>;

void printColumns(const std::string& name, const Columns& columns)
{
    std::cout << name << ':';
    for (const Rational& value : columns) {
        std::cout << ' ' << value;
    }
    std::cout << '\n';
}

void printNetwork(std::istream& in)
{
    const Network network = readNetwork(in);
    const std::size_t size = network.waves();
    std::vector<NetworkLaw<Rational>> laws;
    for (std::int64_t step = next(in); step > 0; --step) {
        laws.emplace_back(network, static_cast<ContactSet>(next(in)));
    }
    // By step and contact: pushes where closed, else how far the contact has opened.
    std::vector<std::vector<Columns>> table(
        laws.size(), std::vector<Columns>(network.contacts.size(), Columns(size)));
    std::vector<Columns> end(size, Columns(size));
    for (std::size_t unit = 0; unit < size; ++unit) {
        std::vector<Rational> start(size);
        start[unit] = 1;
        NetworkWaves<Rational> waves(network, start);
        std::vector<Rational> opened(network.contacts.size());
        for (std::size_t m = 0; m < laws.size(); ++m) {
            const auto velocity = [&](std::size_t node) {
                return laws[m].velocity(node).at(waves.arriving(), 0, 0);
            };
            for (std::size_t j = 0; j < network.contacts.size(); ++j) {
                const NetworkContact& contact = network.contacts[j];
                if (contact.kind == ContactKind::gap) {
                    opened[j] += velocity(contact.node + 1) - velocity(contact.node);
                } else {
                    opened[j] += contact.kind == ContactKind::stopLeft ? velocity(contact.node)
                                                                       : -velocity(contact.node);
                }
                const bool isClosed = ((laws[m].closed() >> j) & 1U) != 0;
                table[m][j][unit] =
                    isClosed ? laws[m].push(j).at(waves.arriving(), 0, 0) : opened[j];
            }
            waves.step(laws[m]);
        }
        const std::vector<Rational> last = waves.waves();
        for (std::size_t i = 0; i < size; ++i) {
            end[i][unit] = last[i];
        }
    }
    for (std::size_t m = 0; m < laws.size(); ++m) {
        for (std::size_t j = 0; j < network.contacts.size(); ++j) {
            printColumns(fmt::format("row {} {}", m, j), table[m][j]);
        }
    }
    for (std::size_t i = 0; i < size; ++i) {
        printColumns(fmt::format("end {}", i), end[i]);
    }
}

}  // namespace

int main()
{
    try {
        for (std::string line; std::getline(std::cin, line);) {
            std::istringstream in(line);
            std::string kind;
            in >> kind;
            kind == "paper" ? printPaper(in) : printNetwork(in);
            std::cout << ".\n";
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
