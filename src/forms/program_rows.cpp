#include "program_rows.hpp"

#include <cmath>
#include <utility>

namespace signorini {

namespace {

constexpr double exactIntegers = 9007199254740992.0;  // 2^53

bool isInteger(double value)
{
    return std::abs(value) < exactIntegers && value == std::trunc(value);
}

/// sign (row) >= sign rhs; false if a number is no integer.
bool append(std::vector<ExactRow>& rows, const SparseRows& matrix, const Eigen::VectorXd& rhs,
            bool isEquality)
{
    const std::int64_t sign = isEquality ? 1 : -1;  // a program's inequalities say <=
    for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
        ExactRow row{std::vector<std::int64_t>(static_cast<std::size_t>(matrix.cols())), 0,
                     isEquality, static_cast<std::int64_t>(rows.size())};
        for (SparseRows::InnerIterator entry(matrix, k); entry; ++entry) {
            if (!isInteger(entry.value())) {
                return false;
            }
            row.coefficients[static_cast<std::size_t>(entry.col())] =
                sign * static_cast<std::int64_t>(entry.value());
        }
        if (!isInteger(rhs[k])) {
            return false;
        }
        row.rhs = sign * static_cast<std::int64_t>(rhs[k]);
        rows.push_back(std::move(row));
    }
    return true;
}

bool appendBounds(std::vector<ExactRow>& rows, const Eigen::VectorXd& bounds, std::int64_t sign)
{
    for (Eigen::Index i = 0; i < bounds.size(); ++i) {
        if (std::isinf(bounds[i])) {
            continue;
        }
        if (!isInteger(bounds[i])) {
            return false;
        }
        ExactRow row{std::vector<std::int64_t>(static_cast<std::size_t>(bounds.size())),
                     sign * static_cast<std::int64_t>(bounds[i]), false,
                     static_cast<std::int64_t>(rows.size())};
        row.coefficients[static_cast<std::size_t>(i)] = sign;
        rows.push_back(std::move(row));
    }
    return true;
}

}  // namespace

std::unique_ptr<ProgramRows> ProgramRows::of(const Program& program)
{
    auto result = std::make_unique<ProgramRows>();
    result->unknowns_ = static_cast<std::size_t>(program.variables());
    const bool isExact =
        append(result->rows_, program.equalities, program.equalityRhs, true) &&
        append(result->rows_, program.inequalities, program.inequalityRhs, false) &&
        appendBounds(result->rows_, program.lower, 1) &&
        appendBounds(result->rows_, program.upper, -1);
    return isExact ? std::move(result) : nullptr;
}

std::optional<ExactRow> ProgramRows::violatedRow(const Homogeneous& point) const
{
    const ExactRow* worst = nullptr;
    Integer most = 0;
    for (const ExactRow& row : rows_) {
        Integer missing = point.denominator * row.rhs;
        for (std::size_t i = 0; i < unknowns_; ++i) {
            if (row.coefficients[i] != 0) {
                missing -= point.numerators[i] * row.coefficients[i];
            }
        }
        if (row.isEquality && !missing.is_zero()) {
            return row;
        }
        if (!row.isEquality && missing > most) {
            most = std::move(missing);
            worst = &row;
        }
    }
    return worst == nullptr ? std::nullopt : std::optional<ExactRow>(*worst);
}

}  // namespace signorini
