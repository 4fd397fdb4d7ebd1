#include "lumped_proof.hpp"

#include <algorithm>
#include <stdexcept>

namespace signorini {

namespace {

/// Number of the inequality of the program with these coefficients and this right side.
std::int64_t rowOf(const Program& program, const PrefixMultiplier& wanted)
{
    const std::vector<std::int64_t>& coefficients = wanted.coefficients;
    const auto entries = static_cast<std::ptrdiff_t>(coefficients.size()) -
                         std::count(coefficients.begin(), coefficients.end(), 0);
    for (Eigen::Index k = 0; k < program.inequalities.rows(); ++k) {
        std::ptrdiff_t same = 0;
        std::ptrdiff_t all = 0;
        for (SparseRows::InnerIterator entry(program.inequalities, k); entry; ++entry, ++all) {
            const auto column = static_cast<std::size_t>(entry.col());
            same += static_cast<double>(coefficients[column]) == entry.value() ? 1 : 0;
        }
        if (same == all && all == entries &&
            program.inequalityRhs[k] == static_cast<double>(wanted.rhs)) {
            return k;
        }
    }
    throw std::invalid_argument("program: it does not hold the rows of the proof");
}

}  // namespace

InfeasibilityProof proofOf(const LumpedSet& set, const Program& program)
{
    if (!set.absence) {
        throw std::invalid_argument("set: the schedule has motions, their absence has no proof");
    }
    // The first equality of the program is the gap row, then one closure per phase but the last,
    // then that of size.
    InfeasibilityProof proof;
    if (set.absence->gap != 0) {
        proof.equalities.push_back({0, set.absence->gap});
    }
    for (const Multiplier& closure : set.absence->closures) {
        proof.equalities.push_back({closure.row + 1, closure.value});
    }
    if (set.absence->size != 0) {
        proof.equalities.push_back({program.equalities.rows() - 1, set.absence->size});
    }
    for (const PrefixMultiplier& prefix : set.absence->prefixes) {
        proof.inequalities.push_back({rowOf(program, prefix), prefix.value});
    }
    const auto ascending = [](const Multiplier& left, const Multiplier& right) {
        return left.row < right.row;
    };
    std::sort(proof.equalities.begin(), proof.equalities.end(), ascending);
    std::sort(proof.inequalities.begin(), proof.inequalities.end(), ascending);
    return proof;
}

}  // namespace signorini
