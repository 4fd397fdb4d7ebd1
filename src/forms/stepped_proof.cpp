#include "stepped_proof.hpp"

#include <algorithm>

#include "exact_multipliers.hpp"
#include "infeasibility.hpp"

namespace signorini {

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
        if (isUsed({SteppedRule::bound, block})) {
            support.bounds.push_back({unknown, upper});
        }
        if (isUsed({SteppedRule::floor, block})) {
            support.bounds.push_back({unknown, lower});
        }
    }
    return proof();
}

}  // namespace signorini
