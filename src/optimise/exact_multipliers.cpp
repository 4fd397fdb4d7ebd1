#include "exact_multipliers.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "rational.hpp"

namespace signorini {

namespace {

/// The equalities, by their unknowns.
using ProgramColumns = Eigen::SparseMatrix<double, Eigen::ColMajor>;

/// The rows that are not open, each after all that use the unknown it determines. O(entries).
std::vector<Eigen::Index> followingRows(const Program& program, const std::vector<bool>& isOpen)
{
    const ProgramColumns equal = program.equalities;
    const Eigen::Index unknowns = program.variables();
    const auto isFollowing = [&](Eigen::Index row) {
        return row < unknowns && !isOpen[static_cast<std::size_t>(row)];
    };
    std::vector<int> missing(static_cast<std::size_t>(unknowns), 0);
    std::vector<Eigen::Index> rows;  // ready
    std::size_t following = 0;
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        for (ProgramColumns::InnerIterator entry(equal, k); entry; ++entry) {
            missing[static_cast<std::size_t>(k)] +=
                entry.row() != k && isFollowing(entry.row()) ? 1 : 0;
        }
        following += isFollowing(k) ? 1 : 0;
        if (isFollowing(k) && missing[static_cast<std::size_t>(k)] == 0) {
            rows.push_back(k);
        }
    }
    for (std::size_t next = 0; next < rows.size(); ++next) {
        const Eigen::Index row = rows[next];
        for (SparseRows::InnerIterator entry(program.equalities, row); entry; ++entry) {
            const auto column = static_cast<std::size_t>(entry.col());
            if (entry.col() != row && --missing[column] == 0 && isFollowing(entry.col())) {
                rows.push_back(entry.col());
            }
        }
    }
    if (rows.size() < following) {
        throw std::logic_error("followingRows: rows in a circle without an open one");
    }
    return rows;
}

/// A linear function of the parameters.
using Form = std::map<std::size_t, Rational>;

void add(Form& to, const Form& form, const Rational& factor)
{
    for (const auto& [parameter, value] : form) {
        Rational& sum = to[parameter];
        sum += factor * value;
        if (sum.is_zero()) {
            to.erase(parameter);
        }
    }
}

/// The multipliers of all equalities as functions of the parameters: those of open rows and of rows
/// that determine nothing, then one for each inequality and each bound in use.
class Chain {
public:
    Chain(const Program& program, const ProofSupport& support)
        : program_(program),
          support_(support),
          equal_(program.equalities),
          multipliers_(static_cast<std::size_t>(program.equalities.rows()))
    {
        const Eigen::Index unknowns = program.variables();
        for (Eigen::Index row = 0; row < program.equalities.rows(); ++row) {
            if (row >= unknowns || support.isOpen[static_cast<std::size_t>(row)]) {
                multipliers_[static_cast<std::size_t>(row)] = Form{{parameters_++, 1}};
            }
        }
        given_.resize(static_cast<std::size_t>(unknowns));
        firstCondition_ = parameters_;
        for (const Eigen::Index row : support.inequalities) {
            for (SparseRows::InnerIterator entry(program.inequalities, row); entry; ++entry) {
                add(given_[static_cast<std::size_t>(entry.col())], Form{{parameters_, 1}},
                    Rational(entry.value()));
            }
            ++parameters_;
        }
        for (const UsedBound& bound : support.bounds) {
            add(given_[static_cast<std::size_t>(bound.unknown)], Form{{parameters_++, 1}}, 1);
        }
    }

    /// Every multiplier that follows from others. \throws std::logic_error for a closed circle.
    void follow()
    {
        order_ = followingRows(program_, support_.isOpen);
        for (const Eigen::Index row : order_) {
            determine(row);
        }
    }

    /// The values of the parameters for which all columns vanish and the right side is -1.
    [[nodiscard]] std::optional<RationalVector> close() const
    {
        std::vector<RationalVector> rows;
        RationalVector rhs;
        const auto addRow = [&](const Form& form, const Rational& value) {
            RationalVector& row = rows.emplace_back(parameters_);
            for (const auto& [parameter, factor] : form) {
                row[parameter] = factor;
            }
            rhs.push_back(value);
        };
        for (Eigen::Index k = 0; k < program_.variables(); ++k) {
            if (!isFollowing(k)) {
                addRow(columnOf(k, false), 0);
            }
        }
        addRow(rightSide(), -1);
        return solveSome(std::move(rows), std::move(rhs), parameters_);
    }

    /// Follows the chain once more, in numbers: that is less work than to put them into the forms.
    [[nodiscard]] RationalProof proofOf(const RationalVector& values) const
    {
        const auto at = [&values](const Form& form) {
            Rational sum = 0;
            for (const auto& [parameter, factor] : form) {
                sum += factor * values[parameter];
            }
            return sum;
        };
        RationalVector multipliers(multipliers_.size());
        for (std::size_t row = 0; row < multipliers.size(); ++row) {
            if (!isFollowing(static_cast<Eigen::Index>(row))) {
                multipliers[row] = at(multipliers_[row]);
            }
        }
        RationalVector given(given_.size());
        std::transform(given_.begin(), given_.end(), given.begin(), at);
        for (const Eigen::Index row : order_) {
            Rational sum = given[static_cast<std::size_t>(row)];
            for (ProgramColumns::InnerIterator entry(equal_, row); entry; ++entry) {
                sum += Rational(entry.value()) * multipliers[static_cast<std::size_t>(entry.row())];
            }
            multipliers[static_cast<std::size_t>(row)] = -sum / Rational(equal_.coeff(row, row));
        }
        RationalProof proof;
        for (std::size_t row = 0; row < multipliers.size(); ++row) {
            if (!multipliers[row].is_zero()) {
                proof.equalities.push_back(
                    {static_cast<std::int64_t>(row), multipliers[row].str()});
            }
        }
        for (std::size_t k = 0; k < support_.inequalities.size(); ++k) {
            const Rational& value = values[firstCondition_ + k];
            if (!value.is_zero()) {
                proof.inequalities.push_back({support_.inequalities[k], value.str()});
            }
        }
        return proof;
    }

private:
    [[nodiscard]] bool isFollowing(Eigen::Index row) const
    {
        return row < program_.variables() && !support_.isOpen[static_cast<std::size_t>(row)];
    }

    /// equalities^T y + given in one column, perhaps without the row that is determined there.
    [[nodiscard]] Form columnOf(Eigen::Index k, bool withoutOwn) const
    {
        Form sum = given_[static_cast<std::size_t>(k)];
        for (ProgramColumns::InnerIterator entry(equal_, k); entry; ++entry) {
            if (!withoutOwn || entry.row() != k) {
                add(sum, multipliers_[static_cast<std::size_t>(entry.row())],
                    Rational(entry.value()));
            }
        }
        return sum;
    }

    void determine(Eigen::Index row)
    {
        const Form others = columnOf(row, true);
        add(multipliers_[static_cast<std::size_t>(row)], others,
            -1 / Rational(equal_.coeff(row, row)));
    }

    /// y . equalityRhs + mu . inequalityRhs - what the bounds give.
    [[nodiscard]] Form rightSide() const
    {
        Form sum;
        for (std::size_t row = 0; row < multipliers_.size(); ++row) {
            add(sum, multipliers_[row],
                Rational(program_.equalityRhs[static_cast<Eigen::Index>(row)]));
        }
        std::size_t parameter = firstCondition_;
        for (const Eigen::Index row : support_.inequalities) {
            add(sum, Form{{parameter++, 1}}, Rational(program_.inequalityRhs[row]));
        }
        for (const UsedBound& bound : support_.bounds) {
            add(sum, Form{{parameter++, 1}}, Rational(bound.value));
        }
        return sum;
    }

    const Program& program_;
    const ProofSupport& support_;
    ProgramColumns equal_;
    std::vector<Eigen::Index> order_;  ///< of rows that follow
    std::vector<Form> multipliers_;
    std::vector<Form> given_;
    std::size_t parameters_ = 0;
    std::size_t firstCondition_ = 0;
};

}  // namespace

std::optional<RationalProof> exactMultipliers(const Program& program, const ProofSupport& support)
{
    Chain chain(program, support);
    chain.follow();
    const auto values = chain.close();
    return values ? std::optional(chain.proofOf(*values)) : std::nullopt;
}

}  // namespace signorini
