#include "nlopt/free_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace signorini::nlopt {

namespace {

using Index = Eigen::Index;
using Columns = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

/// Below this an entry of a direction is rounding: those of the programs here are whole numbers.
constexpr double negligible = 1e-12;

std::vector<Index> outsideOf(const std::vector<Index>& basis, Index variables)
{
    std::vector<bool> isBasic(static_cast<std::size_t>(variables), false);
    for (const Index column : basis) {
        isBasic[static_cast<std::size_t>(column)] = true;
    }
    std::vector<Index> outside;
    for (Index i = 0; i < variables; ++i) {
        if (!isBasic[static_cast<std::size_t>(i)]) {
            outside.push_back(i);
        }
    }
    return outside;
}

/// One column for each variable outside the basis: it grows by one, the basis follows.
Columns directionsOf(const Program& program, const Basis& basis, const std::vector<Index>& outside)
{
    const Columns equalities = program.equalities;
    std::vector<Triplet> entries;
    for (std::size_t k = 0; k < outside.size(); ++k) {
        const auto column = static_cast<int>(k);
        entries.emplace_back(static_cast<int>(outside[k]), column, 1.0);
        const Eigen::VectorXd follow = basis.solve(-Eigen::VectorXd(equalities.col(outside[k])));
        for (const Index i : basis.columns()) {
            if (!(std::abs(follow[i]) <= negligible)) {
                entries.emplace_back(static_cast<int>(i), column, follow[i]);
            }
        }
    }
    Columns directions(program.variables(), static_cast<Index>(outside.size()));
    directions.setFromTriplets(entries.begin(), entries.end());
    return directions;
}

/// Collects rows u <= rhs; see the head of the header for what becomes of them.
class RowCollector {
public:
    RowCollector(FreeProgram& result, double tolerance) : result_(result), tolerance_(tolerance) {}

    /// factor * row u <= rhs
    void add(const SparseRows& rows, Index row, double factor, double rhs)
    {
        double largest = 0.0;
        for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
            largest = std::max(largest, std::abs(entry.value()));
        }
        if (largest <= negligible) {
            if (rhs < -tolerance_ * std::max(1.0, std::abs(rhs))) {
                declareInfeasible("an inequality contradicts the equalities");
            }
            return;
        }
        Key key;
        for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
            if (std::abs(entry.value()) > negligible * largest) {
                key.emplace_back(static_cast<int>(entry.col()), factor * entry.value() / largest);
            }
        }
        rhs /= largest;
        if (key.size() > 1) {
            const auto place = rhs_.emplace(std::move(key), rhs).first;
            place->second = std::min(place->second, rhs);
        } else if (key.front().second > 0.0) {
            double& upper = result_.upper[key.front().first];
            upper = std::min(upper, rhs);
        } else {
            double& lower = result_.lower[key.front().first];
            lower = std::max(lower, -rhs);
        }
    }

    void finish()
    {
        for (Index k = 0; k < result_.size(); ++k) {
            double& lower = result_.lower[k];
            double& upper = result_.upper[k];
            if (lower > upper) {
                if (lower - upper > tolerance_ * std::max(1.0, std::abs(upper))) {
                    declareInfeasible("two inequalities contradict each other on the equalities");
                }
                lower = upper = 0.5 * (lower + upper);
            }
        }
        std::vector<Triplet> entries;
        result_.rhs.resize(static_cast<Index>(rhs_.size()));
        int row = 0;
        for (const auto& [key, rhs] : rhs_) {
            for (const auto& [column, value] : key) {
                entries.emplace_back(row, column, value);
            }
            result_.rhs[row++] = rhs;
        }
        result_.rows.resize(row, result_.size());
        result_.rows.setFromTriplets(entries.begin(), entries.end());
    }

private:
    using Key = std::vector<std::pair<int, double>>;

    void declareInfeasible(const char* why)
    {
        result_.decided.emplace();
        result_.decided->status = SolverStatus::infeasible;
        result_.decided->detail = why;
    }

    FreeProgram& result_;
    double tolerance_;
    std::map<Key, double> rhs_;
};

void collectRows(double tolerance, FreeProgram& result)
{
    const Program& program = result.condensed.program;
    RowCollector collector(result, tolerance);
    const SparseRows directions = result.directions;
    for (const Index i : result.condensed.pivots) {
        if (std::isfinite(program.upper[i])) {
            collector.add(directions, i, 1.0, program.upper[i] - result.origin[i]);
        }
        if (std::isfinite(program.lower[i])) {
            collector.add(directions, i, -1.0, result.origin[i] - program.lower[i]);
        }
    }
    const SparseRows inequalities = program.inequalities * result.directions;
    const Eigen::VectorXd room = program.inequalityRhs - program.inequalities * result.origin;
    for (Index row = 0; row < inequalities.rows(); ++row) {
        collector.add(inequalities, row, 1.0, room[row]);
    }
    collector.finish();
}

}  // namespace

FreeProgram withoutEqualities(const Program& program, double tolerance, Index mostUnknowns)
{
    FreeProgram result;
    result.condensed = condense(program, tolerance);
    if (result.condensed.decided) {
        result.decided = result.condensed.decided;
        return result;
    }
    const Program& condensed = result.condensed.program;
    result.outside = outsideOf(result.condensed.pivots, condensed.variables());
    const auto size = static_cast<Index>(result.outside.size());
    if (size > mostUnknowns) {
        throw std::invalid_argument(
            fmt::format("variables - independent equalities = {} is out of range: allowed up to {} "
                        "with this solver (another one has no such limit, e.g. ipopt)",
                        size, mostUnknowns));
    }
    const Basis basis(condensed.equalities, result.condensed.pivots);
    result.origin = basis.solve(condensed.equalityRhs);
    result.directions = directionsOf(condensed, basis, result.outside);
    result.lower = condensed.lower(result.outside);
    result.upper = condensed.upper(result.outside);
    collectRows(tolerance, result);
    return result;
}

}  // namespace signorini::nlopt
