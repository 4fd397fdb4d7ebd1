#include <algorithm>
#include <cmath>

#include "row_list.hpp"
#include "stepped_form.hpp"

namespace signorini {

namespace {

/// A wave as factor times an unknown.
struct Term {
    Eigen::Index column;
    double factor;
};

class Builder {
public:
    explicit Builder(const SteppedBlocks& blocks) : blocks_(blocks), layout_(blocks)
    {
        result_.program = emptyProgram(layout_.unknowns());
        result_.energyWeights.setZero(layout_.unknowns());
    }

    SteppedProgram build()
    {
        for (std::size_t t = 0; t < blocks_.types.size(); ++t) {
            for (std::int64_t k = 0; k < blocks_.turns; ++k) {
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
        return (turn + blocks_.delays[segment]) % blocks_.turns;
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
        const double unit = 2.0 / static_cast<double>(bar.cells);
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(layout_.waves());
        for (std::size_t i = 0; i < bar.segments.size(); ++i) {
            for (std::size_t t = 0; t < blocks_.types.size(); ++t) {
                for (std::int64_t k = 0; k < blocks_.delays[i]; ++k) {
                    const Eigen::Index r = layout_.arrival(i, t, k % blocks_.turns);
                    sum[r] += 1.0;
                    result_.energyWeights[r] += unit * bar.segments[i].impedance /
                                                static_cast<double>(blocks_.types[t].width);
                }
            }
        }
        Row row;
        for (Eigen::Index k = 0; k < sum.size(); ++k) {
            if (sum[k] != 0.0) {
                row.emplace_back(k, sum[k]);
            }
        }
        equal_.add(row, -blocks_.startPlace() * static_cast<double>(bar.cells));
    }

    const SteppedBlocks& blocks_;
    JointsLayout layout_;
    SteppedProgram result_;
    std::vector<Law> laws_;
    RowList equal_;
    RowList below_;
};

}  // namespace

JointsLayout::JointsLayout(const SteppedBlocks& blocks)
    : turns_(blocks.turns),
      joints_(static_cast<Eigen::Index>(blocks.bar.joints.size())),
      perStep_(joints_ + 1 + std::max<Eigen::Index>(0, joints_ - 1)),
      waves_(static_cast<Eigen::Index>(blocks.types.size()) * turns_ * perStep_)
{
    for (const StepBlock& block : blocks.blocks) {
        flights_ += block.isContact ? 0 : 1;
    }
}

Eigen::Index JointsLayout::arrival(std::size_t joint, std::size_t type, std::int64_t turn) const
{
    return (static_cast<Eigen::Index>(type) * turns_ + turn) * perStep_ +
           static_cast<Eigen::Index>(joint);
}

Eigen::Index JointsLayout::between(std::size_t joint, std::size_t type, std::int64_t turn) const
{
    return arrival(0, type, turn) + joints_ + 1 + static_cast<Eigen::Index>(joint);
}

SteppedProgram jointsForm(const SteppedBlocks& blocks)
{
    return Builder(blocks).build();
}

}  // namespace signorini
