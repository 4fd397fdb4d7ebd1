// From what arrives in blocks to the waves at the start of the schedule, and back.

#include <cmath>

#include "channel_waves.hpp"
#include "network_kernel.hpp"

namespace signorini {

namespace {

double scaleOf(const NetworkBlocks& blocks, Eigen::Index channel)
{
    return std::sqrt(blocks.network().impedanceOf(static_cast<std::size_t>(channel)));
}

/// Derivatives by what arrives in a period of one type, a column for each channel: those that are
/// given, and what it does later. Below them those by the state with which the next one begins, in
/// the norm of the energy.
Eigen::MatrixXd carriedBack(const NetworkBlocks& blocks, std::size_t type,
                            NetworkLaws<double>& laws, const Eigen::MatrixXd& given,
                            const Eigen::VectorXd& end)
{
    const Eigen::Index turns = blocks.turns();
    Eigen::MatrixXd waves = Eigen::MatrixXd::Zero(turns + end.size(), given.cols());
    const auto at = [&waves](Eigen::Index turn, std::size_t channel) -> double& {
        return waves(turn, static_cast<Eigen::Index>(channel));
    };
    Eigen::Index next = 0;
    for (Eigen::Index channel = 0; channel < given.cols(); ++channel) {
        const Eigen::Index delay = blocks.delay(static_cast<std::size_t>(channel));
        waves.col(channel).segment(turns, delay) =
            scaleOf(blocks, channel) * end.segment(next, delay);
        next += delay;
    }
    // From left to right: what nodes send to the left arrives at once.
    for (Eigen::Index turn = turns; turn-- > 0;) {
        const auto sent = [&](const NetworkLaw<double>::Branch& branch) {
            return branch.sign * at(turn + blocks.delay(branch.entered), branch.entered);
        };
        for (const auto& node : laws.of(blocks.closed(type, turn)).scatterers()) {
            double sum = 0.0;
            for (const auto& branch : node.branches) {
                sum += sent(branch);
            }
            for (const auto& branch : node.branches) {
                at(turn, branch.channel) = given(turn, static_cast<Eigen::Index>(branch.channel)) +
                                           branch.weight * sum - sent(branch);
            }
        }
    }
    return waves;
}

/// visit(channel, order of arrival, place in `Network::waves`) of each wave.
void forEachWave(const Network& network, const auto& visit)
{
    for (std::size_t channel = 0; channel < network.channels(); ++channel) {
        const ChannelWaves waves(network, channel);
        for (std::size_t order = 0; order < waves.size(); ++order) {
            visit(channel, static_cast<std::int64_t>(order), waves.at(order));
        }
    }
}

}  // namespace

template <typename Number>
std::vector<double> wavesAt(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel,
                            const VectorOf<Number>& z, const VectorOf<Number>& inputs)
{
    std::vector<VectorOf<Number>> arriving;
    for (std::size_t type = 0; type < kernel.waves.size(); ++type) {
        const auto& waves = kernel.waves[type];
        const VectorOf<Number> own = z.segment(kernel.firsts[type], waves.cols());
        arriving.push_back(product<Number>(waves, own) +
                           product<Number>(kernel.driven[type], inputs));
    }
    const auto at = [&](std::size_t channel, std::int64_t step) {
        const auto [type, turn] = blocks.placeOf(blocks.network().nodeOf(channel), step);
        return static_cast<double>(
            arriving[type][static_cast<Eigen::Index>(channel) * blocks.turns() + turn]);
    };
    std::vector<double> all(blocks.network().waves());
    forEachWave(blocks.network(), [&](std::size_t channel, std::int64_t order, std::size_t place) {
        all[place] = at(channel, order);
    });
    return all;
}

Eigen::VectorXd periodicBackwards(const NetworkBlocks& blocks, const NetworkKernel<double>& kernel,
                                  const Eigen::VectorXd& given)
{
    const Network& network = blocks.network();
    const Eigen::Index turns = blocks.turns();
    const auto channels = static_cast<Eigen::Index>(network.channels());
    std::vector<Eigen::MatrixXd> all(blocks.types().size(), Eigen::MatrixXd::Zero(turns, channels));
    const auto at = [&](std::size_t channel, std::int64_t order) -> double& {
        const auto [type, turn] = blocks.placeOf(network.nodeOf(channel), order);
        return all[type](turn, static_cast<Eigen::Index>(channel));
    };
    forEachWave(network, [&](std::size_t channel, std::int64_t order, std::size_t place) {
        at(channel, order) = given[static_cast<Eigen::Index>(place)];
    });
    NetworkLaws<double> laws(network);
    Eigen::VectorXd state(blocks.stateSize());
    for (std::size_t type = 0; type < all.size(); ++type) {
        const Eigen::MatrixXd once =
            carriedBack(blocks, type, laws, all[type], Eigen::VectorXd::Zero(blocks.stateSize()));
        Eigen::Index next = 0;
        for (Eigen::Index channel = 0; channel < channels; ++channel) {
            const Eigen::Index delay = blocks.delay(static_cast<std::size_t>(channel));
            state.segment(next, delay) = once.col(channel).head(delay) / scaleOf(blocks, channel);
            next += delay;
        }
        const Eigen::VectorXd repeated = kernel.factors[type].solveTransposed(state);
        all[type] = carriedBack(blocks, type, laws, all[type], repeated).topRows(turns);
    }
    Eigen::VectorXd made(given.size());
    forEachWave(network, [&](std::size_t channel, std::int64_t order, std::size_t place) {
        made[static_cast<Eigen::Index>(place)] = at(channel, order);
    });
    return made;
}

template std::vector<double> wavesAt(const NetworkBlocks&, const NetworkKernel<double>&,
                                     const VectorOf<double>&, const VectorOf<double>&);
template std::vector<double> wavesAt(const NetworkBlocks&, const NetworkKernel<FineNumber>&,
                                     const VectorOf<FineNumber>&, const VectorOf<FineNumber>&);

}  // namespace signorini
