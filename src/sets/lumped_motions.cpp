#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "echo.hpp"
#include "faults.hpp"
#include "lumped_rows.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini {

namespace {

void requireMotion(const LumpedSet& set)
{
    if (set.absence) {
        throw std::invalid_argument("set: the schedule has no motion");
    }
}

void requireSums(const LumpedSet& set, std::span<const double> sums)
{
    requireMotion(set);
    if (sums.size() != set.live.size()) {
        throw std::invalid_argument(
            fmt::format("sums: {} values given: allowed exactly {}", sums.size(), set.live.size()));
    }
}

/// epsilon in a block of the window.
double signOf(const ClassTypes& classes, const ClassType& type, std::int64_t block)
{
    return type.signs[static_cast<std::size_t>(block % classes.members)];
}

/// Writes p in runs of neighbouring classes: fill(run, sign, type, j) sets classes j, j + 1, ... of
/// a live type to sign z; dead classes get 0.
template <typename Fill>
State writeState(const ClassTypes& classes, Fill fill)
{
    const std::int64_t cells = classes.schedule.cells;
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (std::int64_t block = 0; block < classes.window; ++block) {
        for (const ClassType& type : classes.types) {
            const std::int64_t begin = block * classes.classes + type.first;
            fillWaves(
                state, begin, begin + type.count, [&](auto& run, double side, std::int64_t offset) {
                    if (type.isLive()) {
                        fill(run, side * signOf(classes, type, block), type, type.first + offset);
                    } else {
                        run.setZero();
                    }
                });
        }
    }
    return state;
}

/// One z per class: choose(the amplitudes of a type at given sums) for each live type, 0 elsewhere.
template <typename Choose>
std::vector<double> chosenAmplitudes(const LumpedSet& set, const std::vector<double>& sums,
                                     Choose choose)
{
    std::vector<double> z(static_cast<std::size_t>(set.classes.classes), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const std::vector<double> chosen = choose(amplitudesAt(set, sums, i));
        std::copy(chosen.begin(), chosen.end(), z.data() + set.type(i).first);
    }
    return z;
}

}  // namespace

AmplitudeSet amplitudesAt(const LumpedSet& set, std::span<const double> sums, std::size_t index)
{
    requireSums(set, sums);
    if (index >= set.live.size()) {
        throw std::invalid_argument(
            fmt::format("index = {}: allowed 0..{}", index, set.live.size() - 1));
    }
    const ClassType& type = set.type(index);
    AmplitudeSet result{.kind = SetKind::point, .count = type.count, .sum = sums[index]};
    if (type.count == 1) {
        return result;
    }
    result.kind = SetKind::simplex;
    if (type.kind == TypeKind::grazing) {
        result.kind = SetKind::box;
        const auto [lower, upper] = boundsOf<double>(
            set.classes, std::vector<double>(sums.begin(), sums.end()), index, 1.0);
        result.lower = lower;
        result.upper = std::max(lower, upper);
    }
    return result;
}

State motionOf(const ClassTypes& classes, std::span<const double> z)
{
    if (static_cast<std::int64_t>(z.size()) != classes.classes) {
        throw std::invalid_argument(
            fmt::format("z: {} values given: allowed exactly {}", z.size(), classes.classes));
    }
    const Eigen::Map<const Eigen::VectorXd> values(z.data(), static_cast<Eigen::Index>(z.size()));
    return writeState(classes, [&values](auto& run, double sign, const ClassType&, std::int64_t j) {
        run = sign * values.segment(j, run.size());
    });
}

std::vector<double> amplitudesOf(const ClassTypes& classes, const State& state)
{
    requireCells(state, classes.schedule.cells);
    std::vector<double> z(static_cast<std::size_t>(classes.classes), 0.0);
    for (const ClassType& type : classes.types) {
        for (std::int64_t j = type.first; type.isLive() && j < type.first + type.count; ++j) {
            double sum = 0.0;
            for (std::int64_t block = 0; block < classes.window; ++block) {
                sum += signOf(classes, type, block) * waveAt(state, block * classes.classes + j);
            }
            // Last: equal terms cancel without a rest.
            z[static_cast<std::size_t>(j)] = sum / static_cast<double>(classes.window);
        }
    }
    return z;
}

State equalMotion(const LumpedSet& set, std::span<const double> sums)
{
    requireSums(set, sums);
    std::vector<double> z(set.classes.types.size(), 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        z[set.live[i]] = sums[i] / static_cast<double>(set.type(i).count);
    }
    const ClassType* first = set.classes.types.data();
    return writeState(set.classes,
                      [&](auto& run, double sign, const ClassType& type, std::int64_t) {
                          run.setConstant(sign * z[static_cast<std::size_t>(&type - first)]);
                      });
}

State mostEnergyMotion(const LumpedSet& set, const LumpedShape& shape)
{
    requireMotion(set);
    if (!std::isfinite(shape.energy.most)) {
        throw std::invalid_argument("shape: its most energy is infinite or not known");
    }
    const auto squaresOf = [&set](const std::vector<double>& sums) {
        double squares = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            squares += mostSquares(amplitudesAt(set, sums, i));
        }
        return squares;
    };
    const auto& best = *std::max_element(
        shape.vertices.begin(), shape.vertices.end(),
        [&](const auto& left, const auto& right) { return squaresOf(left) < squaresOf(right); });
    return motionOf(set.classes, chosenAmplitudes(set, best, mostAmplitudes));
}

State drawMotion(const LumpedSet& set, const LumpedShape& shape, std::mt19937_64& generator)
{
    requireMotion(set);
    std::vector<double> sums(set.live.size(), 0.0);
    const AmplitudeSet mixture{.kind = SetKind::simplex,
                               .count = static_cast<std::int64_t>(shape.spanning.size()),
                               .sum = 1.0};
    const std::vector<double> weights = drawAmplitudes(mixture, generator);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += weights[k] * shape.spanning[k][i];
        }
    }
    return motionOf(set.classes,
                    chosenAmplitudes(set, sums, [&generator](const AmplitudeSet& type) {
                        return drawAmplitudes(type, generator);
                    }));
}

}  // namespace signorini
