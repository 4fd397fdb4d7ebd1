#include <algorithm>
#include <utility>

#include "network_rows.hpp"
#include "network_simulation.hpp"

namespace signorini {

namespace {

/// Collects multipliers.
template <typename Number>
class FloorMaker {
public:
    FloorMaker(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel,
               const NetworkRows<Number>& rows)
        : blocks_(blocks),
          network_(blocks.network()),
          kernel_(kernel),
          rows_(rows),
          ways_(driftingBars(blocks.network()).size(), 0.0),
          left_(Eigen::VectorXd::Zero(rows.driftBy.rows())),
          works_(VectorOf<Number>::Zero(kernel.coordinates()))
    {
    }

    EnergyFloor run(const Eigen::VectorXd& multipliers)
    {
        for (std::size_t k = 0; k < rows_.conditions.size(); ++k) {
            if (const double value = multipliers[static_cast<Eigen::Index>(k)]; value != 0.0) {
                add(rows_.conditions[k], value);
            }
        }
        const Eigen::VectorXd tied = rows_.driftBy.transpose() * left_;
        for (std::size_t k = 0; k < rows_.tied.size(); ++k) {
            addPlace(rows_.tied[k], tied[static_cast<Eigen::Index>(k)]);
        }
        if (hasWork_ || !ways_.empty()) {
            floor_.periodicity.assign(network_.waves(), 0.0);
            floor_.periodicity.insert(floor_.periodicity.end(), ways_.begin(), ways_.end());
        }
        if (hasWork_) {
            addWork();
        }
        const auto inOrder = [](const ContactMultiplier& x, const ContactMultiplier& y) {
            return std::pair(x.step, x.contact) < std::pair(y.step, y.contact);
        };
        std::sort(floor_.places.begin(), floor_.places.end(), inOrder);
        std::sort(floor_.pushes.begin(), floor_.pushes.end(), inOrder);
        return std::move(floor_);
    }

private:
    void add(const BlockCondition& of, double value)
    {
        switch (of.kind) {
            case BlockCondition::Kind::place:
                addPlace(of, value);
                for (const auto& [bar, sign] : driftsOf(network_, of.contact)) {
                    left_[static_cast<Eigen::Index>(bar)] += sign * value;
                }
                break;
            case BlockCondition::Kind::push:
                addPushes(of, value);
                break;
            case BlockCondition::Kind::tie:
                break;  // any multiple may be taken away
            case BlockCondition::Kind::strain:
                floor_.strains.push_back(
                    {of.contact, static_cast<std::int64_t>(of.type), of.turn, value});
                break;
            case BlockCondition::Kind::drift:
                ways_[of.contact] += value;
                break;
            case BlockCondition::Kind::work:
                hasWork_ = true;
                works_[kernel_.firsts[of.type] + of.turn] += Number(value);
                break;
        }
    }

    [[nodiscard]] std::int64_t stepOf(const BlockCondition& of) const
    {
        return blocks_.stepOf(network_.contacts[of.contact].node, of.type, of.turn);
    }

    /// In a later period bars that drift would have gone on by their way.
    void addPlace(const BlockCondition& of, double value)
    {
        floor_.places.push_back({of.contact, stepOf(of), value});
        const auto periods = static_cast<double>(
            blocks_.periodOf(network_.contacts[of.contact].node, of.type, of.turn));
        for (const auto& [bar, sign] : driftsOf(network_, of.contact)) {
            ways_[bar] += periods * sign * value;
        }
    }

    void addPushes(const BlockCondition& of, double value)
    {
        const std::int64_t width = blocks_.types()[of.type].width;
        const std::int64_t steps = blocks_.unit() * blocks_.turns();
        for (std::int64_t residue = 0; residue < width; ++residue) {
            floor_.pushes.push_back(
                {of.contact, (stepOf(of) + residue) % steps, value / static_cast<double>(width)});
        }
    }

    /// Z times the waves on which there is work.
    void addWork()
    {
        const std::vector<double> waves = wavesAt(
            blocks_, kernel_, works_, VectorOf<Number>(VectorOf<Number>::Zero(kernel_.inputs())));
        const std::vector<double> impedances = impedancesOf(network_);
        for (std::size_t k = 0; k < waves.size(); ++k) {
            floor_.periodicity[k] += impedances[k] * waves[k];
        }
    }

    const NetworkBlocks& blocks_;
    const Network& network_;
    const NetworkKernel<Number>& kernel_;
    const NetworkRows<Number>& rows_;
    EnergyFloor floor_;
    std::vector<double> ways_;  ///< of bars that drift
    Eigen::VectorXd left_;      ///< of displacements that drift
    VectorOf<Number> works_;
    bool hasWork_ = false;
};

}  // namespace

template <typename Number>
EnergyFloor conditionsOf(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel,
                         const NetworkRows<Number>& rows, const Eigen::VectorXd& multipliers)
{
    return FloorMaker<Number>(blocks, kernel, rows).run(multipliers);
}

template <typename Number>
std::vector<double> displacementsAt(const NetworkBlocks& blocks, const NetworkRows<Number>& rows,
                                    std::span<const double> waves, const StepDrive& drive)
{
    const Network& network = blocks.network();
    std::vector<double> places = displacementsOf(network, waves, {});
    for (std::size_t node = 0; node < places.size() && !drive.places.empty(); ++node) {
        const auto clamp = displacementOf(network, node).clamp;
        places[node] += clamp && network.nodes[*clamp].isShaken ? drive.places.front() : 0.0;
    }
    if (rows.tied.empty()) {
        return places;
    }
    // Where bars are when distances close, if those that drift start at 0.
    Eigen::VectorXd missing(static_cast<Eigen::Index>(rows.tied.size()));
    std::vector<double> now = places;
    NetworkWaves<double> moving(network, {waves.begin(), waves.end()});
    std::size_t step = 0;
    for (const ContactSpan& span : blocks.schedule()) {
        const NetworkLaw<double> law(network, span.closed);
        for (std::int64_t m = 0; m < span.steps; ++m, ++step) {
            for (std::size_t k = 0; k < rows.tied.size(); ++k) {
                const auto& [kind, contact, type, turn] = rows.tied[k];
                const NetworkContact& at = network.contacts[contact];
                if (blocks.stepOf(at.node, type, turn) == static_cast<std::int64_t>(step)) {
                    missing[static_cast<Eigen::Index>(k)] =
                        at.gap + openingOf(at, [&now](std::size_t node) { return now[node]; });
                }
            }
            const double force = drive.forces.empty() ? 0.0 : drive.forces[step];
            const double base = drive.velocities.empty() ? 0.0 : drive.velocities[step];
            for (std::size_t node = 0; node < now.size(); ++node) {
                now[node] += law.velocity(node).at(moving.arriving(), force, base);
            }
            moving.step(law, force, base);
        }
    }
    const Eigen::VectorXd drifts = rows.driftBy * missing;
    const std::vector<std::size_t> bars = driftingBars(network);
    for (std::size_t node = 0; node < places.size(); ++node) {
        const auto bar = std::find(bars.begin(), bars.end(), network.nodes[node].bar);
        places[node] += bar != bars.end() ? drifts[bar - bars.begin()] : 0.0;
    }
    return places;
}

#define SIGNORINI_FLOOR_OF(Number)                                                                 \
    template EnergyFloor conditionsOf(const NetworkBlocks&, const NetworkKernel<Number>&,          \
                                      const NetworkRows<Number>&, const Eigen::VectorXd&);         \
    template std::vector<double> displacementsAt(const NetworkBlocks&, const NetworkRows<Number>&, \
                                                 std::span<const double>, const StepDrive&);
SIGNORINI_FLOOR_OF(double)
SIGNORINI_FLOOR_OF(FineNumber)
#undef SIGNORINI_FLOOR_OF

}  // namespace signorini
