#include "stepped_proof.hpp"

#include <algorithm>
#include <cmath>

#include "exact_multipliers.hpp"
#include "homogeneous.hpp"
#include "infeasibility.hpp"

namespace signorini {

namespace {

constexpr double negligibleMultiplier = 1e-9;  // of the largest multiplier

/// Conditions with a multiplier: of inequalities, and of bounds of prefix sums.
std::vector<SteppedCondition> conflictOf(const SteppedProgram& posed, const SolverResult& answer)
{
    const Program& program = posed.program;
    const Eigen::VectorXd y = -answer.equalityDuals.head(program.equalities.rows());
    const Eigen::VectorXd mu = -answer.inequalityDuals.head(program.inequalities.rows());
    const double size = std::max(y.size() > 0 ? y.lpNorm<Eigen::Infinity>() : 0.0,
                                 mu.size() > 0 ? mu.lpNorm<Eigen::Infinity>() : 0.0);
    std::vector<SteppedCondition> conflict;
    for (Eigen::Index k = 0; k < mu.size(); ++k) {
        if (mu[k] > negligibleMultiplier * size) {
            conflict.push_back(posed.conditions[static_cast<std::size_t>(k)]);
        }
    }
    const Eigen::VectorXd combined =
        program.equalities.transpose() * y + program.inequalities.transpose() * mu;
    for (const auto& [unknown, block] : posed.prefixes) {
        const bool isFixed = program.lower[unknown] == program.upper[unknown];
        if (!isFixed && std::abs(combined[unknown]) > negligibleMultiplier * size) {
            conflict.push_back({block, combined[unknown] > 0.0});
        }
    }
    return conflict;
}

}  // namespace

SteppedExistence existence(const SteppedProgram& posed, const Solver& simplex,
                           const SolverOptions& options)
{
    SteppedExistence result;
    if (posed.program.variables() == 0) {
        result.status = Status::none;
        return result;
    }
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
    result.conflict = conflictOf(posed, answer);
    return result;
}

std::optional<RationalProof> proofOf(const std::vector<SteppedCondition>& conflict,
                                     const SteppedBlocks& blocks)
{
    const auto open = blocks.stateSize() * static_cast<std::int64_t>(blocks.types.size());
    if (open > mostExactRows) {
        return std::nullopt;
    }
    const SteppedProgram posed = jointsForm(blocks);
    const Program& program = posed.program;
    const JointsLayout layout(blocks);
    ProofSupport support;
    support.isOpen.resize(static_cast<std::size_t>(program.variables()), false);
    for (std::size_t t = 0; t < blocks.types.size(); ++t) {
        for (std::size_t j = 0; j < blocks.delays.size(); ++j) {
            for (std::int64_t k = 0; k < std::min(blocks.delays[j], blocks.turns); ++k) {
                support.isOpen[static_cast<std::size_t>(layout.arrival(j, t, k))] = true;
            }
        }
    }
    const auto isUsed = [&](const SteppedCondition& condition) {
        return std::find(conflict.begin(), conflict.end(), condition) != conflict.end();
    };
    for (std::size_t row = 0; row < posed.conditions.size(); ++row) {
        if (isUsed(posed.conditions[row])) {
            support.inequalities.push_back(static_cast<Eigen::Index>(row));
        }
    }
    const auto proof = [&]() -> std::optional<RationalProof> {
        auto found = exactMultipliers(program, support);
        return found && isProof(*found, program) ? std::move(found) : std::nullopt;
    };
    if (conflict.empty()) {
        // Where all waves are 0 no flight is needed, and types know nothing of each other.
        if (auto found = proof()) {
            return found;
        }
    }
    for (const auto& [unknown, block] : posed.prefixes) {
        const double lower = program.lower[unknown];
        const double upper = program.upper[unknown];
        if (lower == upper) {
            support.bounds.push_back({unknown, upper});
            continue;
        }
        if (isUsed({block, false})) {
            support.bounds.push_back({unknown, upper});
        }
        if (isUsed({block, true})) {
            support.bounds.push_back({unknown, lower});
        }
    }
    return proof();
}

Reason reasonOf(const std::vector<SteppedCondition>& conflict, const SteppedBlocks& blocks,
                std::optional<std::int64_t> kernelDimension)
{
    if (kernelDimension == 0) {
        return Reason::noLiveClass;
    }
    if (conflict.empty()) {
        return Reason::gap;
    }
    const bool isOfContact =
        std::all_of(conflict.begin(), conflict.end(), [&blocks](const SteppedCondition& condition) {
            return blocks.blocks[condition.block].isContact;
        });
    return isOfContact ? Reason::contactSign : Reason::penetration;
}

}  // namespace signorini
