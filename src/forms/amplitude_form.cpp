#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "builders.hpp"
#include "row_list.hpp"
#include "signorini/lumped_set.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// Builds the reduced and the lumped form.
class AmplitudeForm {
public:
    AmplitudeForm(const Schedule& schedule, double depth, bool lumped)
        : classes_(classTypes(schedule)),
          limits_(flightLimits(classes_.schedule)),
          floors_(floorsOf(classes_.schedule, depth)),
          lumped_(lumped)
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
        addSize();
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
        const WaveSum start = gapSum(classes_.schedule);
        Row gap;
        for (std::size_t t = 0; t < at_.size(); ++t) {
            const ClassType& type = classes_.types[t];
            const Columns& at = at_[t];
            if (at.sum < 0) {
                continue;
            }
            gap.emplace_back(at.sum, static_cast<double>(start.factor * type.windowSum));
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
        equal_.add(gap, static_cast<double>(start.rhs));
    }

    /// Without a gap: the size that a motion is looked for in.
    void addSize()
    {
        if (!isCone(classes_.schedule.stops)) {
            return;
        }
        Row row;
        for (std::size_t t = 0; t < at_.size(); ++t) {
            if (at_[t].sum >= 0 && classes_.types[t].contactMembers > 0) {
                row.emplace_back(at_[t].sum, static_cast<double>(classes_.types[t].contactMembers));
            }
        }
        equal_.add(row, static_cast<double>(classes_.schedule.cells));
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
                    boundInside(prefix, at, sign, block.phase);
                }
                prefix[block.type] += sign;
                limitAbove(prefix, {}, block.phase);
                limitBelow(prefix, {}, block.phase);
            }
            if (block.endsPhase) {
                if (block.phase + 1 < phases) {
                    const WaveSum& end = limits_[block.phase].end;
                    equal_.add(combination(prefix, end.factor), static_cast<double>(end.rhs));
                }
                std::fill(prefix.begin(), prefix.end(), 0);
            }
        }
    }

    /// The limits on P + sign Z_j for the inner j of a grazing block.
    void boundInside(const std::vector<std::int64_t>& prefix, const Columns& at, std::int64_t sign,
                     std::size_t phase)
    {
        const auto upper = sign > 0 ? at.above : at.below;
        const auto lower = sign > 0 ? at.below : at.above;
        const auto factor = static_cast<double>(sign);
        limitAbove(prefix, {upper, factor}, phase);
        limitBelow(prefix, {lower, factor}, phase);
    }

    void limitAbove(const std::vector<std::int64_t>& prefix, RowList::Entry extra,
                    std::size_t phase)
    {
        const WaveSum& most = limits_[phase].most;
        addOnce(prefix, extra, most.factor, static_cast<double>(most.rhs));
    }

    void limitBelow(const std::vector<std::int64_t>& prefix, RowList::Entry extra,
                    std::size_t phase)
    {
        if (const auto& least = limits_[phase].least) {
            addOnce(prefix, extra, -least->factor, -static_cast<double>(least->rhs));
        }
        if (std::isfinite(floors_[phase])) {
            addOnce(prefix, extra, -1, -floors_[phase]);
        }
    }

    /// factor (P + extra) <= rhs, if that row is not there yet.
    void addOnce(const std::vector<std::int64_t>& prefix, RowList::Entry extra, std::int64_t factor,
                 double rhs)
    {
        Row row = combination(prefix, factor);
        if (extra.second != 0.0) {
            row.emplace_back(extra.first, static_cast<double>(factor) * extra.second);
        }
        if (!row.empty() && seen_.emplace(row, rhs).second) {
            below_.add(row, rhs);
        }
    }

    [[nodiscard]] Row combination(const std::vector<std::int64_t>& prefix,
                                  std::int64_t factor) const
    {
        Row row;
        for (std::size_t t = 0; t < prefix.size(); ++t) {
            if (prefix[t] != 0) {
                row.emplace_back(at_[t].sum, static_cast<double>(factor * prefix[t]));
            }
        }
        return row;
    }

    /// Lower limits on prefix sums by a floor under the tip, `depth` below the wall.
    static std::vector<double> floorsOf(const Schedule& schedule, double depth)
    {
        const auto crossing = crossingSum(schedule);
        std::vector<double> floors;
        for (const Phase& phase : schedule.phases) {
            floors.push_back((phase.stop == Stop::right ? 0.0 : crossing.value().value()) - depth);
        }
        return floors;
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
    std::vector<FlightLimits> limits_;
    std::vector<double> floors_;
    bool lumped_;
    Eigen::Index columns_ = 0;
    std::vector<Columns> at_;
    RowList equal_;
    RowList below_;
    std::set<std::pair<Row, double>> seen_;
};

}  // namespace

Formulated amplitudeForm(const Schedule& schedule, double depth, bool lumped)
{
    return AmplitudeForm(schedule, depth, lumped).build();
}

}  // namespace signorini
