#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "builders.hpp"
#include "echo.hpp"
#include "row_list.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini {

namespace {

/// Builds the reduced and the lumped form.
class AmplitudeForm {
public:
    AmplitudeForm(const Schedule& schedule, double depth, bool lumped)
        : classes_(classTypes(schedule)), depth_(depth), lumped_(lumped)
    {
    }

    Formulated build()
    {
        numberColumns();
        Formulated result;
        result.schedule = classes_.schedule;
        result.program = emptyProgram(columns_);
        setBounds(result.program);
        addSums();
        addPrefixes();
        equal_.moveTo(result.program.equalities, result.program.equalityRhs, columns_);
        below_.moveTo(result.program.inequalities, result.program.inequalityRhs, columns_);
        result.delay = delay();
        result.leftOut = {"rows (30): class amplitudes satisfy them",
                          "rows of (32) inside sign blocks: prefix sums are monotone there"};
        if (lumped_) {
            result.leftOut.emplace_back(
                "single amplitudes: equal ones reach every sum at least energy");
        }
        return result;
    }

private:
    /// Columns of one type; -1 where it has none.
    struct Columns {
        Eigen::Index amplitudes = -1;  ///< z of its first class, or S itself when lumped
        Eigen::Index sum = -1;         ///< S
        Eigen::Index partials = -1;    ///< Z_1 (grazing, d > 1, not lumped); Z_d is S
        Eigen::Index above = -1;       ///< upper bound on the Z_j
        Eigen::Index below = -1;       ///< lower bound on the Z_j
    };

    void numberColumns()
    {
        columns_ = 0;
        for (const ClassType& type : classes_.types) {
            Columns at;
            if (type.isLive()) {
                const bool single = lumped_ || type.count == 1;
                at.amplitudes = std::exchange(columns_, columns_ + (single ? 1 : type.count));
                if (single) {
                    at.sum = at.amplitudes;
                } else if (type.kind == TypeKind::pressing) {
                    at.sum = columns_++;
                } else {
                    at.partials = std::exchange(columns_, columns_ + type.count);
                    at.sum = columns_ - 1;
                    at.above = columns_++;
                    at.below = columns_++;
                }
            }
            at_.push_back(at);
        }
        // A program has at least one unknown; without a live type it stays unused.
        columns_ = std::max<Eigen::Index>(columns_, 1);
    }

    void setBounds(Program& program) const
    {
        for (std::size_t t = 0; t < at_.size(); ++t) {
            if (classes_.types[t].kind == TypeKind::pressing) {
                const bool single = at_[t].sum == at_[t].amplitudes;
                program.lower.segment(at_[t].amplitudes, single ? 1 : classes_.types[t].count)
                    .setZero();
            }
        }
    }

    /// Defines S and Z, and the gap row.
    void addSums()
    {
        Row gap;
        for (std::size_t t = 0; t < at_.size(); ++t) {
            const ClassType& type = classes_.types[t];
            const Columns& at = at_[t];
            if (at.sum < 0) {
                continue;
            }
            gap.emplace_back(at.sum, static_cast<double>(type.windowSum));
            if (at.partials >= 0) {
                for (std::int64_t j = 0; j < type.count; ++j) {
                    Row row{{at.partials + j, -1.0}, {at.amplitudes + j, 1.0}};
                    if (j > 0) {
                        row.emplace_back(at.partials + j - 1, 1.0);
                    }
                    equal_.add(row, 0.0);
                    if (j + 1 < type.count) {
                        below_.add({{at.partials + j, 1.0}, {at.above, -1.0}}, 0.0);
                        below_.add({{at.partials + j, -1.0}, {at.below, 1.0}}, 0.0);
                    }
                }
            } else if (at.sum != at.amplitudes) {
                Row row{{at.sum, -1.0}};
                for (std::int64_t j = 0; j < type.count; ++j) {
                    row.emplace_back(at.amplitudes + j, 1.0);
                }
                equal_.add(row, 0.0);
            }
        }
        std::erase_if(gap, [](const RowList::Entry& entry) { return entry.second == 0.0; });
        equal_.add(gap, static_cast<double>(gapSum(classes_.schedule.cells)));
    }

    /// One row per distinct prefix sum: many blocks repeat the same combination.
    void addPrefixes()
    {
        const std::size_t types = at_.size();
        std::vector<std::int64_t> prefix(types, 0);
        const std::size_t phases = classes_.schedule.phases.size();
        for (const Block& block : blocksOf(classes_)) {
            const Columns& at = at_[block.type];
            if (!block.isContact && at.sum >= 0) {
                const std::int64_t sign =
                    classes_.types[block.type].signs[static_cast<std::size_t>(block.alpha)];
                if (at.partials >= 0) {
                    boundInside(prefix, at, sign);
                }
                prefix[block.type] += sign;
                limit(prefix, {});
            }
            if (block.endsPhase) {
                if (block.phase + 1 < phases) {
                    equal_.add(combination(prefix), 0.0);
                }
                std::fill(prefix.begin(), prefix.end(), 0);
            }
        }
    }

    /// -depth <= P + sign Z_j <= 0 for the inner j of a grazing block.
    void boundInside(const std::vector<std::int64_t>& prefix, const Columns& at, std::int64_t sign)
    {
        const auto upper = sign > 0 ? at.above : at.below;
        const auto lower = sign > 0 ? at.below : at.above;
        const auto factor = static_cast<double>(sign);
        limitAbove(prefix, {upper, factor});
        limitBelow(prefix, {lower, factor});
    }

    void limit(const std::vector<std::int64_t>& prefix, RowList::Entry extra)
    {
        limitAbove(prefix, extra);
        limitBelow(prefix, extra);
    }

    void limitAbove(const std::vector<std::int64_t>& prefix, RowList::Entry extra)
    {
        if (seen_.insert({key(prefix, extra), 1}).second) {
            addBelow(prefix, extra, 1.0, 0.0);
        }
    }

    void limitBelow(const std::vector<std::int64_t>& prefix, RowList::Entry extra)
    {
        std::vector<std::int64_t> tag = key(prefix, extra);
        tag.push_back(-1);
        if (std::isfinite(depth_) && seen_.insert({std::move(tag), 1}).second) {
            addBelow(prefix, extra, -1.0, depth_);
        }
    }

    void addBelow(const std::vector<std::int64_t>& prefix, RowList::Entry extra, double factor,
                  double rhs)
    {
        Row row = combination(prefix);
        if (extra.second != 0.0) {
            row.push_back(extra);
        }
        for (auto& [column, value] : row) {
            value *= factor;
        }
        if (!row.empty()) {
            below_.add(row, rhs);
        }
    }

    [[nodiscard]] Row combination(const std::vector<std::int64_t>& prefix) const
    {
        Row row;
        for (std::size_t t = 0; t < prefix.size(); ++t) {
            if (prefix[t] != 0) {
                row.emplace_back(at_[t].sum, static_cast<double>(prefix[t]));
            }
        }
        return row;
    }

    static std::vector<std::int64_t> key(std::vector<std::int64_t> prefix, RowList::Entry extra)
    {
        prefix.push_back(extra.second == 0.0 ? -1 : extra.first);
        prefix.push_back(static_cast<std::int64_t>(extra.second));
        return prefix;
    }

    [[nodiscard]] std::vector<DelayTerm> delay() const
    {
        std::vector<DelayTerm> terms;
        for (std::int64_t alpha = 0; alpha < classes_.members; ++alpha) {
            for (std::size_t t = 0; t < at_.size(); ++t) {
                const ClassType& type = classes_.types[t];
                for (std::int64_t j = 0; j < type.count; ++j) {
                    terms.push_back(term(type, at_[t], alpha, j));
                }
            }
        }
        return terms;
    }

    [[nodiscard]] DelayTerm term(const ClassType& type, const Columns& at, std::int64_t alpha,
                                 std::int64_t j) const
    {
        if (at.sum < 0) {
            return {};
        }
        const double sign = type.signs[static_cast<std::size_t>(alpha)];
        if (lumped_) {
            return {at.sum, sign / static_cast<double>(type.count)};
        }
        return {at.amplitudes + j, sign};
    }

    ClassTypes classes_;
    double depth_;
    bool lumped_;
    Eigen::Index columns_ = 0;
    std::vector<Columns> at_;
    RowList equal_;
    RowList below_;
    std::map<std::vector<std::int64_t>, int> seen_;
};

}  // namespace

Formulated amplitudeForm(const Schedule& schedule, double depth, bool lumped)
{
    return AmplitudeForm(schedule, depth, lumped).build();
}

}  // namespace signorini
