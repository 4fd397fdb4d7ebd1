#include "stepped_existence.hpp"

#include <algorithm>
#include <cmath>

#include "homogeneous.hpp"
#include "least_norm.hpp"
#include "periodic_multipliers.hpp"

namespace signorini {

namespace {

using Rule = SteppedRule;

constexpr double negligibleMultiplier = 1e-9;  // of the largest multiplier
constexpr double broken = 1e-10;  // a condition, relative to waves of the motion's size
constexpr double mostNorm = 1e8;  // sqrt(E/E_1): more is taken for no motion

/// The rows of the kernel form in coordinates whose squares are energies.
RowSystem rowsOf(const SteppedProgram& posed)
{
    const Program& program = posed.program;
    RowSystem system;
    system.equalities = program.equalities.rows();
    const Eigen::Index below = program.inequalities.rows();
    system.rows.resize(system.equalities + below, program.variables());
    system.rhs.resize(system.equalities + below);
    system.rows.topRows(system.equalities) = Eigen::MatrixXd(program.equalities);
    system.rows.bottomRows(below) = -Eigen::MatrixXd(program.inequalities);
    system.rhs << program.equalityRhs, -program.inequalityRhs;
    system.rows *= posed.energyWeights.cwiseSqrt().cwiseInverse().asDiagonal();
    return system;
}

/// Of the rows of the kernel form, those that are not 0.
std::vector<SteppedMultiplier> named(const SteppedProgram& posed, const Eigen::VectorXd& values)
{
    const double least = negligibleMultiplier * values.cwiseAbs().maxCoeff() * 1e-6;
    std::vector<SteppedMultiplier> result;
    const Eigen::Index equalities = posed.program.equalities.rows();
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        if (std::abs(values[k]) <= least) {
            continue;
        }
        if (k == 0) {
            result.push_back({{Rule::gap}, values[k]});
        } else if (k < equalities) {
            result.push_back(
                {{Rule::landing, posed.landings[static_cast<std::size_t>(k - 1)]}, values[k]});
        } else {
            result.push_back(
                {posed.conditions[static_cast<std::size_t>(k - equalities)], values[k]});
        }
    }
    return result;
}

/// Multipliers of a linear program that has no solution, with those of bounds of prefix sums.
std::vector<SteppedMultiplier> conflictOf(const SteppedProgram& posed, const SolverResult& answer)
{
    const Program& program = posed.program;
    const Eigen::VectorXd y = -answer.equalityDuals.head(program.equalities.rows());
    const Eigen::VectorXd mu = -answer.inequalityDuals.head(program.inequalities.rows());
    const double size = std::max(y.size() > 0 ? y.lpNorm<Eigen::Infinity>() : 0.0,
                                 mu.size() > 0 ? mu.lpNorm<Eigen::Infinity>() : 0.0);
    const double least = negligibleMultiplier * size;
    std::vector<SteppedMultiplier> conflict;
    const auto take = [&](SteppedCondition of, double value) {
        if (std::abs(value) > least) {
            conflict.push_back({of, value});
        }
    };
    const bool isKernel = posed.prefixes.empty();
    take({Rule::gap}, -y[isKernel ? 0 : y.size() - 1]);
    for (std::size_t k = 0; k < posed.landings.size(); ++k) {
        take({Rule::landing, posed.landings[k]}, -y[static_cast<Eigen::Index>(k) + 1]);
    }
    for (Eigen::Index k = 0; k < mu.size(); ++k) {
        take(posed.conditions[static_cast<std::size_t>(k)], std::max(0.0, mu[k]));
    }
    const Eigen::VectorXd combined =
        program.equalities.transpose() * y + program.inequalities.transpose() * mu;
    for (const auto& [unknown, block] : posed.prefixes) {
        const double factor = combined[unknown];
        if (program.lower[unknown] == program.upper[unknown]) {
            take({Rule::landing, block}, factor);
        } else {
            take({factor > 0.0 ? Rule::floor : Rule::bound, block}, std::abs(factor));
        }
    }
    return conflict;
}

/// Writes multipliers down step by step.
class StepByStep {
public:
    StepByStep(const SteppedBlocks& blocks, const Network& network)
        : blocks_(blocks), network_(network)
    {
        std::int64_t start = 0;  // of the flight
        std::size_t phase = 0;
        bool wasContact = true;
        for (const StepBlock& block : blocks.blocks) {
            const std::int64_t first = block.turn * blocks.unit + blocks.types[block.type].first;
            phase += block.isContact && !wasContact ? 1 : 0;
            start = !block.isContact && wasContact ? first : start;
            wasContact = block.isContact;
            places_.push_back({first, first + blocks.types[block.type].width, start, phase});
        }
    }

    void take(const SteppedMultiplier& m)
    {
        const double half = 0.5 * m.value;
        switch (m.of.rule) {
            case Rule::gap:  // N (place - u)
                atStop(stopOf(0), 0, -m.value);
                return;
            case Rule::push:
                push(m);
                return;
            case Rule::bound:
                floor_.places.push_back({0, places_[m.of.block].end, half});
                fromStart(m.of.block, half);
                return;
            case Rule::floor:
                floor_.places.push_back({lowest(), places_[m.of.block].end, half});
                fromStart(m.of.block, -half);
                return;
            case Rule::landing:
                atStop(stopOf(places_[m.of.block].phase + 1), places_[m.of.block].end, half);
                fromStart(m.of.block, -half);
                return;
        }
    }

    [[nodiscard]] EnergyFloor floor() && { return std::move(floor_); }

private:
    struct Place {
        std::int64_t first;
        std::int64_t end;    ///< the step after it
        std::int64_t start;  ///< of its flight
        std::size_t phase;
    };

    [[nodiscard]] Stop stopOf(std::size_t phase) const
    {
        const std::vector<Phase>& phases = blocks_.schedule.phases;
        return phases[phase % phases.size()].stop;
    }

    /// factor times N (u - place of the stop), in terms of the distance to it.
    void atStop(Stop stop, std::int64_t step, double factor)
    {
        const bool isRight = stop == Stop::right;
        floor_.places.push_back({isRight ? 0U : 1U, step, isRight ? -factor : factor});
    }

    /// Prefix sums count from where the flight starts: a place that the tip is at.
    void fromStart(std::size_t block, double factor)
    {
        atStop(stopOf(places_[block].phase), places_[block].start, factor);
    }

    /// The higher of the second stop and the floor.
    [[nodiscard]] std::size_t lowest() const
    {
        std::size_t best = network_.contacts.size() - 1;
        for (std::size_t k = 1; k < network_.contacts.size(); ++k) {
            best = network_.contacts[k].gap < network_.contacts[best].gap ? k : best;
        }
        return best;
    }

    void push(const SteppedMultiplier& m)
    {
        const std::size_t contact = blocks_.blocks[m.of.block].push > 0 ? 0 : 1;
        const double value = m.value / (2.0 * network_.rows.back().impedance);
        for (std::int64_t step = places_[m.of.block].first; step < places_[m.of.block].end;
             ++step) {
            floor_.pushes.push_back({contact, step, value});
        }
    }

    const SteppedBlocks& blocks_;
    const Network& network_;
    std::vector<Place> places_;
    EnergyFloor floor_;
};

/// In order, each place and push once.
void arrange(std::vector<ContactMultiplier>& list)
{
    std::sort(list.begin(), list.end(), [](const auto& x, const auto& y) {
        return std::pair(x.step, x.contact) < std::pair(y.step, y.contact);
    });
    std::vector<ContactMultiplier> merged;
    for (const ContactMultiplier& m : list) {
        if (!merged.empty() && merged.back().step == m.step && merged.back().contact == m.contact) {
            merged.back().value += m.value;
        } else {
            merged.push_back(m);
        }
    }
    list = std::move(merged);
}

}  // namespace

SteppedExistence leastMotion(const SteppedProgram& kernel, const Cancel& cancel)
{
    SteppedExistence result;
    if (kernel.program.variables() == 0) {
        result.status = Status::none;
        // Where no waves repeat u(L, 0) is 0, and the first contact stands elsewhere.
        result.multipliers.push_back({{Rule::gap}, kernel.program.equalityRhs[0]});
        return result;
    }
    const LeastNorm least = leastNorm(rowsOf(kernel), broken, mostNorm, cancel);
    result.iterations = least.steps;
    if (least.end == LeastNormEnd::stopped) {
        result.detail = isRequested(cancel)
                            ? "cancelled"
                            : "rounding does not tell which conditions are in force";
        return result;
    }
    result.multipliers = named(kernel, least.multipliers);
    result.status = least.end == LeastNormEnd::found ? Status::found : Status::none;
    result.x = least.z.cwiseQuotient(kernel.energyWeights.cwiseSqrt());
    return result;
}

SteppedExistence existence(const SteppedProgram& posed, const Solver& simplex,
                           const SolverOptions& options)
{
    SteppedExistence result;
    const SolverResult answer = simplex.solve(homogeneous(posed.program), options);
    result.iterations = answer.iterations;
    if (answer.status != SolverStatus::optimal) {
        result.detail = answer.detail;
        return result;
    }
    const Eigen::Index unknowns = posed.program.variables();
    if (const double theta = answer.x[unknowns]; theta > 0.5) {
        result.status = Status::found;
        result.x = answer.x.head(unknowns) / theta;
        return result;
    }
    result.status = Status::none;
    result.multipliers = conflictOf(posed, answer);
    return result;
}

Network networkOf(const SteppedBlocks& blocks, const Scene& scene, double tipFloor)
{
    Network network = networkOf(scene, blocks.bar.cells);
    if (std::isfinite(tipFloor)) {
        network.contacts.push_back({ContactKind::stopLeft, network.nodes.size() - 1,
                                    -tipFloor * static_cast<double>(blocks.bar.cells)});
    }
    return network;
}

EnergyFloor floorOf(const std::vector<SteppedMultiplier>& multipliers, const SteppedBlocks& blocks,
                    const Network& network, const Cancel& cancel)
{
    StepByStep written(blocks, network);
    for (const SteppedMultiplier& m : multipliers) {
        written.take(m);
    }
    EnergyFloor floor = std::move(written).floor();
    arrange(floor.places);
    arrange(floor.pushes);
    completeFloor(floor, network, spansOf(blocks.schedule), cancel);
    return floor;
}

Reason reasonOf(const std::vector<SteppedMultiplier>& multipliers, const SteppedBlocks& blocks,
                std::optional<std::int64_t> kernelDimension)
{
    if (kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    bool isOfContact = true;
    bool isOfGap = true;
    double size = 0.0;
    for (const SteppedMultiplier& m : multipliers) {
        size = std::max(size, std::abs(m.value));
    }
    for (const SteppedMultiplier& m : multipliers) {
        if (m.of.rule != Rule::gap && std::abs(m.value) > negligibleMultiplier * size) {
            isOfGap = false;
            isOfContact = isOfContact && blocks.blocks[m.of.block].isContact;
        }
    }
    return isOfGap ? Reason::gap : isOfContact ? Reason::contactSign : Reason::penetration;
}

}  // namespace signorini
