#include <algorithm>

#include "exact_multipliers.hpp"
#include "infeasibility.hpp"
#include "row_list.hpp"
#include "stepped_form.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// A wave as factor times an unknown.
struct Term {
    Eigen::Index column;
    double factor;
};

/// Where the unknowns and rows of the joints form stand.
class JointsLayout {
public:
    explicit JointsLayout(const SteppedBlocks& blocks)
        : turns_(blocks.network.turns()),
          joints_(static_cast<Eigen::Index>(blocks.bar.joints.size())),
          perStep_(joints_ + 1 + std::max<Eigen::Index>(0, joints_ - 1)),
          waves_(static_cast<Eigen::Index>(blocks.network.types().size()) * turns_ * perStep_),
          flights_(std::count_if(blocks.blocks.begin(), blocks.blocks.end(),
                                 [](const StepBlock& block) { return !block.isContact; }))
    {
    }

    /// r^j of a block, j = 0 for the first joint, or for the tip where there is none.
    [[nodiscard]] Eigen::Index arrival(std::size_t joint, std::size_t type, std::int64_t turn) const
    {
        return (static_cast<Eigen::Index>(type) * turns_ + turn) * perStep_ +
               static_cast<Eigen::Index>(joint);
    }
    /// What arrives from the right at joint j < last.
    [[nodiscard]] Eigen::Index between(std::size_t joint, std::size_t type, std::int64_t turn) const
    {
        return arrival(0, type, turn) + joints_ + 1 + static_cast<Eigen::Index>(joint);
    }
    /// The sum at the end of flight block number k.
    [[nodiscard]] Eigen::Index prefix(std::int64_t k) const { return waves_ + k; }
    [[nodiscard]] Eigen::Index unknowns() const { return waves_ + flights_; }
    /// Number of unknowns that are waves.
    [[nodiscard]] Eigen::Index waves() const { return waves_; }

private:
    Eigen::Index turns_;
    Eigen::Index joints_;
    Eigen::Index perStep_;
    Eigen::Index waves_;
    Eigen::Index flights_;
};

class Builder {
public:
    explicit Builder(const SteppedBlocks& blocks) : blocks_(blocks), layout_(blocks)
    {
        result_.program = emptyProgram(layout_.unknowns());
    }

    SteppedProgram build()
    {
        for (std::size_t t = 0; t < blocks_.network.types().size(); ++t) {
            for (std::int64_t k = 0; k < blocks_.network.turns(); ++k) {
                addJoints(t, k);
            }
        }
        // One row determines each wave: they stand in the order of the waves.
        std::sort(laws_.begin(), laws_.end(),
                  [](const Law& x, const Law& y) { return x.determined < y.determined; });
        for (const Law& law : laws_) {
            equal_.add(law.row, 0.0);
        }
        addTip();
        addGap();
        Program& program = result_.program;
        equal_.moveTo(program.equalities, program.equalityRhs, program.variables());
        below_.moveTo(program.inequalities, program.inequalityRhs, program.variables());
        return std::move(result_);
    }

private:
    struct Law {
        Eigen::Index determined;
        Row row;
    };

    [[nodiscard]] std::int64_t later(std::int64_t turn, std::size_t segment) const
    {
        return (turn + blocks_.delay(segment)) % blocks_.network.turns();
    }

    /// What arrives at joint j from the right.
    [[nodiscard]] Term fromRight(std::size_t joint, std::size_t t, std::int64_t k) const
    {
        const std::size_t last = blocks_.bar.joints.size() - 1;
        return joint == last ? Term{layout_.arrival(last + 1, t, k),
                                    static_cast<double>(blocks_.echoOf(t, k))}
                             : Term{layout_.between(joint, t, k), 1.0};
    }

    void addLaw(Eigen::Index determined, const Row& row)
    {
        // Waves of period n/G may meet themselves: equal columns are one.
        Row merged;
        for (const auto& [column, value] : row) {
            const auto same = std::find_if(merged.begin(), merged.end(),
                                           [c = column](auto& entry) { return entry.first == c; });
            same == merged.end() ? merged.emplace_back(column, value)
                                 : (same->second += value, *same);
        }
        laws_.push_back({determined, std::move(merged)});
    }

    void addJoints(std::size_t t, std::int64_t k)
    {
        const std::size_t joints = blocks_.bar.joints.size();
        if (joints == 0) {
            const Eigen::Index next = layout_.arrival(0, t, later(k, 0));
            addLaw(next, {{next, 1.0},
                          {layout_.arrival(0, t, k), static_cast<double>(blocks_.echoOf(t, k))}});
            return;
        }
        for (std::size_t j = 0; j < joints; ++j) {
            const JointWeights& weights = blocks_.bar.joints[j];
            const auto left = static_cast<double>(2 * weights.left);
            const auto right = static_cast<double>(2 * weights.right);
            const auto all = static_cast<double>(weights.all);
            const Eigen::Index r = layout_.arrival(j, t, k);
            const Term l = fromRight(j, t, k);
            const Eigen::Index onward = layout_.arrival(j + 1, t, later(k, j + 1));
            addLaw(onward, {{onward, all}, {r, -left}, {l.column, (all - right) * l.factor}});
            if (j == 0) {
                const Eigen::Index back = layout_.arrival(0, t, later(k, 0));
                addLaw(back, {{back, all}, {r, left - all}, {l.column, right * l.factor}});
            } else {
                const Eigen::Index back = layout_.between(j - 1, t, k);
                addLaw(back, {{back, all}, {r, all - left}, {l.column, -right * l.factor}});
            }
        }
    }

    void addTip()
    {
        Program& program = result_.program;
        const std::size_t tip = blocks_.bar.joints.size();
        std::int64_t flown = 0;
        bool begins = true;
        for (std::size_t number = 0; number < blocks_.blocks.size(); ++number) {
            const StepBlock& block = blocks_.blocks[number];
            const Eigen::Index p = layout_.arrival(tip, block.type, block.turn);
            if (block.isContact) {
                const auto sign = static_cast<double>(block.push);
                below_.add({{p, -sign}}, 0.0);
                result_.conditions.push_back({SteppedRule::push, number});
                begins = true;
                continue;
            }
            const Eigen::Index y = layout_.prefix(flown++);
            result_.prefixes.emplace_back(y, number);
            Row row{{y, 1.0}, {p, -1.0}};
            if (!begins) {
                row.emplace_back(y - 1, -1.0);
            }
            equal_.add(row, 0.0);
            begins = false;
            program.upper[y] = block.bound;
            program.lower[y] = block.floor;
            if (block.isFlightEnd && flown < layout_.unknowns() - layout_.waves()) {
                program.lower[y] = program.upper[y] = block.landing;
            }
        }
    }

    void addGap()
    {
        const SteppedBar& bar = blocks_.bar;
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout_.waves());
        for (std::size_t i = 0; i < bar.segments.size(); ++i) {
            for (std::size_t t = 0; t < blocks_.network.types().size(); ++t) {
                for (std::int64_t k = 0; k < blocks_.delay(i); ++k) {
                    sum[layout_.arrival(i, t, k % blocks_.network.turns())] += 1.0;
                }
            }
        }
        Row row;
        for (Eigen::Index k = 0; k < sum.size(); ++k) {
            if (sum[k] != 0.0) {
                row.emplace_back(k, sum[k]);
            }
        }
        const Stop first = blocks_.schedule.phases.front().stop;
        equal_.add(
            row, -placeOf(blocks_.schedule.stops, first).value() * static_cast<double>(bar.cells));
    }

    const SteppedBlocks& blocks_;
    JointsLayout layout_;
    SteppedProgram result_;
    std::vector<Law> laws_;
    RowList equal_;
    RowList below_;
};

}  // namespace

SteppedProgram jointsForm(const SteppedBlocks& blocks)
{
    return Builder(blocks).build();
}

std::optional<RationalProof> proofOf(const std::vector<SteppedCondition>& conflict,
                                     const SteppedBlocks& blocks)
{
    const std::size_t types = blocks.network.types().size();
    const auto open = blocks.network.stateSize() * static_cast<std::int64_t>(types);
    if (open > mostExactRows) {
        return std::nullopt;
    }
    const SteppedProgram posed = jointsForm(blocks);
    const Program& program = posed.program;
    const JointsLayout layout(blocks);
    ProofSupport support;
    support.isOpen.resize(static_cast<std::size_t>(program.variables()), false);
    for (std::size_t t = 0; t < types; ++t) {
        for (std::size_t j = 0; j < blocks.bar.segments.size(); ++j) {
            for (std::int64_t k = 0; k < std::min(blocks.delay(j), blocks.network.turns()); ++k) {
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
