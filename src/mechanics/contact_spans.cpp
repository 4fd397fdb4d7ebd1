#include "contact_spans.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "faults.hpp"
#include "units.hpp"

namespace signorini {

namespace {

double addDisplacement(std::span<double> derivatives, const Network& network, std::size_t node,
                       double factor)
{
    const DisplacementForm form = displacementOf(network, node);
    for (const auto& stretch : form.rows) {
        const auto cells = static_cast<std::size_t>(network.rows[stretch.row].cells);
        const std::size_t first = network.firstWave(stretch.row);
        for (std::size_t k = first; k < first + cells; ++k) {
            derivatives[k] -= stretch.sign * factor;
            derivatives[k + cells] += stretch.sign * factor;
        }
    }
    if (form.spring) {
        derivatives[network.firstWave(network.rows.size()) + *form.spring] -= factor;
    }
    return form.clamp && network.nodes[*form.clamp].isShaken ? factor : 0.0;
}

}  // namespace

namespace {

ContactSet setOf(std::string_view text, std::size_t contacts, const std::string& word)
{
    if (text == "-") {
        return 0;
    }
    ContactSet closed = 0;
    for (bool isLast = false; !isLast;) {
        const std::size_t plus = text.find('+');
        isLast = plus == std::string_view::npos;
        const auto number = wholeIn(text.substr(0, plus), 1, static_cast<std::int64_t>(contacts));
        const ContactSet one = number ? ContactSet{1} << (*number - 1) : 0;
        if (!number || (closed & one) != 0) {
            throwFault(
                "schedule", word,
                fmt::format("SET:STEPS, SET - or different contacts 1..{} joined by +", contacts));
        }
        closed |= one;
        text.remove_prefix(isLast ? text.size() : plus + 1);
    }
    return closed;
}

}  // namespace

std::vector<ContactSpan> spansOf(const std::vector<std::string>& words, std::size_t contacts)
{
    std::vector<ContactSpan> spans;
    const bool arePairs =
        contacts == 1 && !words.empty() && words.front().find(':') == std::string::npos;
    if (words.empty() || (arePairs && words.size() % 2 != 0)) {
        throwFault("schedule", fmt::format("{} words", words.size()),
                   contacts == 1 ? "NC NF [NC NF ...], or SET:STEPS ..." : "SET:STEPS ...");
    }
    for (const std::string& word : words) {
        const std::size_t colon = word.find(':');
        std::string_view number = word;
        if (!arePairs) {
            number.remove_prefix(colon == std::string::npos ? word.size() : colon + 1);
        }
        const auto steps = wholeIn(number, 1, maxNetworkSteps);
        if (!steps) {
            throwFault(
                "schedule", word,
                fmt::format("{}, steps 1..{}", arePairs ? "NC NF" : "SET:STEPS", maxNetworkSteps));
        }
        spans.push_back({arePairs ? (spans.size() % 2 == 0 ? 1U : 0U)
                                  : setOf(std::string_view(word).substr(0, colon), contacts, word),
                         *steps});
    }
    return spans;
}

std::vector<std::int64_t> numbersOf(ContactSet closed)
{
    std::vector<std::int64_t> numbers;
    for (std::size_t j = 0; j < maxContacts; ++j) {
        if (contains(closed, j)) {
            numbers.push_back(static_cast<std::int64_t>(j) + 1);
        }
    }
    return numbers;
}

std::string textOf(const std::vector<ContactSpan>& schedule)
{
    std::string text;
    for (const ContactSpan& span : schedule) {
        const std::vector<std::int64_t> numbers = numbersOf(span.closed);
        text += fmt::format("{}{}:{}", text.empty() ? "" : " ",
                            numbers.empty() ? "-" : fmt::format("{}", fmt::join(numbers, "+")),
                            span.steps);
    }
    return text;
}

std::int64_t stepsOf(std::span<const ContactSpan> schedule)
{
    std::int64_t steps = 0;
    for (const ContactSpan& span : schedule) {
        steps += span.steps;
    }
    return steps;
}

StepDrive driveOf(const Excitation& excitation)
{
    StepDrive drive;
    for (auto* list : {&drive.forces, &drive.velocities, &drive.places}) {
        list->reserve(excitation.values.size());
    }
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        drive.forces.push_back(excitation.force(m));
        drive.velocities.push_back(excitation.baseVelocity(m));
        drive.places.push_back(excitation.baseDisplacement(m) * excitation.stepsPerCrossing);
    }
    return drive;
}

std::vector<double> wavesOf(const Network& network, const State& state)
{
    std::vector<double> waves;
    waves.reserve(network.waves());
    const double* a = state.a.data();
    const double* b = state.b.data();
    for (const CellRow& row : network.rows) {
        waves.insert(waves.end(), a, a + row.cells);
        waves.insert(waves.end(), b, b + row.cells);
        a += row.cells;
        b += row.cells;
    }
    return waves;
}

State stateOf(const Network& network, std::span<const double> waves)
{
    State state{Eigen::VectorXd(network.cells()), Eigen::VectorXd(network.cells())};
    Eigen::Index first = 0;
    const double* next = waves.data();
    for (const CellRow& row : network.rows) {
        state.a.segment(first, row.cells) = Eigen::Map<const Eigen::VectorXd>(next, row.cells);
        next += row.cells;
        state.b.segment(first, row.cells) = Eigen::Map<const Eigen::VectorXd>(next, row.cells);
        next += row.cells;
        first += row.cells;
    }
    return state;
}

double addDistance(std::span<double> derivatives, const Network& network, std::size_t contact,
                   double factor)
{
    double byBase = 0.0;
    forEachSide(network.contacts[contact], [&](std::size_t node, int sign) {
        byBase += addDisplacement(derivatives, network, node, sign * factor);
    });
    return byBase;
}

std::optional<double> leastDifference(const Network& network, double limit, std::size_t row,
                                      std::int64_t right, std::int64_t left, std::int64_t steps)
{
    const CellRow& of = network.rows[row];
    // They pass d/2 cells to the right of the middle, -N <= d <= N, d = left - right or periods
    // more.
    const std::int64_t least = ((left - right + of.cells) % steps + steps) % steps - of.cells;
    if (least > of.cells) {
        return std::nullopt;
    }
    const std::int64_t most = least + (of.cells - least) / steps * steps;
    // Weight stretches a cell there by so much less than in the middle; they meet on a whole cell.
    const double weight =
        0.5 * network.gravity *
        static_cast<double>(network.gravity > 0.0 ? std::min(most + 1, of.cells)
                                                  : std::max(least - 1, -of.cells));
    const double rest = (network.nodes[of.right].rest - network.nodes[of.left].rest) /
                        static_cast<double>(of.cells);
    return weight - rest - limit * of.speed;
}

Network withoutForces(Network network)
{
    for (NetworkNode& node : network.nodes) {
        node.force = 0.0;
    }
    return network;
}

std::vector<std::size_t> driftingBars(const Network& network)
{
    std::vector<std::size_t> bars;
    for (std::size_t bar = 0; bar < network.bars.size(); ++bar) {
        if (network.bars[bar].drifts()) {
            bars.push_back(bar);
        }
    }
    return bars;
}

std::vector<std::pair<std::size_t, int>> driftsOf(const Network& network, std::size_t contact)
{
    const std::vector<std::size_t> bars = driftingBars(network);
    std::vector<std::pair<std::size_t, int>> drifts;
    forEachSide(network.contacts[contact], [&](std::size_t node, int sign) {
        const auto found = std::find(bars.begin(), bars.end(), network.nodes[node].bar);
        if (found != bars.end()) {
            drifts.emplace_back(found - bars.begin(), sign);
        }
    });
    return drifts;
}

std::vector<std::vector<double>> tiesOf(const Network& network)
{
    std::vector<std::vector<double>> ties;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        if (network.nodes[node].isClamped && displacementOf(network, node).clamp != node) {
            ties.emplace_back(network.waves(), 0.0);
            addDisplacement(ties.back(), network, node, 1.0);
        }
    }
    for (std::size_t k = 0; k < network.stubs.size(); ++k) {
        const std::size_t node = network.stubs[k].node;
        if (network.stubs[k].kind == StubKind::spring &&
            displacementOf(network, node).spring != k) {
            ties.emplace_back(network.waves(), 0.0);
            addDisplacement(ties.back(), network, node, 1.0);
            ties.back()[network.firstWave(network.rows.size()) + k] += 1.0;
        }
    }
    return ties;
}

std::vector<double> impedancesOf(const Network& network)
{
    std::vector<double> impedances;
    impedances.reserve(network.waves());
    for (const CellRow& row : network.rows) {
        impedances.insert(impedances.end(), 2 * static_cast<std::size_t>(row.cells), row.impedance);
    }
    for (const Stub& stub : network.stubs) {
        impedances.push_back(stub.impedance);
    }
    return impedances;
}

}  // namespace signorini
