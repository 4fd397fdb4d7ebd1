#include "forced_form.hpp"

#include <algorithm>
#include <cmath>

#include "row_list.hpp"

namespace signorini {

namespace {

/// -row, over the largest coefficient, with its right side: what is <= 0 where the row holds.
struct Divided {
    Row entries;
    double limit = 0.0;
    double size = 1.0;  ///< that coefficient
};

Divided divided(const ForcedRow& row, const ForcedUnknowns& unknowns, double sign)
{
    double largest = std::max(std::abs(row.plane.c), std::abs(row.plane.s));
    for (const auto& [place, factor] : row.free) {
        largest = std::max(largest, std::abs(factor));
    }
    const double size = largest > 0.0 ? largest : 1.0;
    const double scale = sign / size;
    Divided result{{{0, -scale * row.plane.c}}, -scale * row.limit, size};
    if (unknowns.isPlane) {
        result.entries.emplace_back(1, -scale * row.plane.s);
    }
    for (const auto& [place, factor] : row.free) {
        result.entries.emplace_back(unknowns.places() + static_cast<Eigen::Index>(place),
                                    -scale * factor);
    }
    return result;
}

}  // namespace

Program forcedProgram(std::span<const ForcedRow> rows, const ForcedUnknowns& unknowns, double far)
{
    Program program = emptyProgram(unknowns.count());
    RowList equal;
    RowList below;
    for (const ForcedRow& row : rows) {
        const Divided one = divided(row, unknowns, 1.0);
        (row.isEquality ? equal : below).add(one.entries, one.limit);
    }
    equal.moveTo(program.equalities, program.equalityRhs, unknowns.count());
    below.moveTo(program.inequalities, program.inequalityRhs, unknowns.count());
    program.lower.head(unknowns.places()).setConstant(-far);
    program.upper.head(unknowns.places()).setConstant(far);
    return program;
}

MissedProgram leastMissed(std::span<const ForcedRow> rows, const ForcedUnknowns& unknowns)
{
    MissedProgram missed{emptyProgram(unknowns.count() + 1), {}, {}};
    RowList below;
    Eigen::Index next = 0;
    for (const ForcedRow& row : rows) {
        missed.first.push_back(next);
        for (const double sign : {1.0, -1.0}) {
            Divided one = divided(row, unknowns, sign);
            if (sign > 0.0) {
                missed.sizes.push_back(one.size);
            }
            one.entries.emplace_back(unknowns.count(), -1.0);
            below.add(one.entries, one.limit);
            ++next;
            if (!row.isEquality) {
                break;
            }
        }
    }
    Program& program = missed.program;
    below.moveTo(program.inequalities, program.inequalityRhs, program.variables());
    program.lower[unknowns.count()] = 0.0;
    program.linear[unknowns.count()] = 1.0;
    return missed;
}

}  // namespace signorini
