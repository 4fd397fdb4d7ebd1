#include "atlas_programs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <stdexcept>

#include "contact_spans.hpp"
#include "network_find.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini {

namespace {

std::string textOf(const RationalProof& proof)
{
    const auto listed = [](const std::vector<RationalMultiplier>& rows) {
        std::string text;
        for (const RationalMultiplier& m : rows) {
            text += fmt::format("{}{}:{}", text.empty() ? "" : " ", m.row, m.value);
        }
        return text;
    };
    return listed(proof.equalities) + "; " + listed(proof.inequalities);
}

std::string textOf(const EnergyFloor& proof)
{
    const auto listed = [](const std::vector<ContactMultiplier>& conditions) {
        std::string text;
        for (const ContactMultiplier& m : conditions) {
            text +=
                fmt::format("{}{}:{}:{}", text.empty() ? "" : " ", m.contact + 1, m.step, m.value);
        }
        return text;
    };
    return fmt::format("{}; {}; {}", fmt::join(proof.periodicity, " "), listed(proof.places),
                       listed(proof.pushes));
}

/// Does the motion, marched without its schedule, press in all steps in which the schedule closes a
/// contact and in no other, and repeat no sooner? O(waves + n nodes).
bool isCanonical(const Network& network, const NetworkClaim& motion,
                 const std::vector<ContactSpan>& schedule)
{
    const NetworkMarch seen = march(network, motion);
    return seen.firstFault < 0 && seen.repeats == stepsOf(schedule) && seen.pressed == schedule;
}

}  // namespace

bool isOfPrograms(const AtlasRange& range)
{
    return range.bars || !range.segments.empty();
}

ProgramRows::ProgramRows(const AtlasRange& range) : range_(range)
{
    if (range.bars) {
        network_ = networkOf(*range.bars);
        energyUnit_ = firstEnergy(*network_).value_or(1.0 / network_->scales.energy());
    }
}

ProgramRow ProgramRows::decide(std::int64_t number, const Cancel& cancel) const
{
    ProgramRow result = network_ ? ofBars(number, cancel) : ofSegments(number, cancel);
    result.row.number = number;
    return result;
}

ProgramRow ProgramRows::ofSegments(std::int64_t number, const Cancel& cancel) const
{
    const Schedule schedule{range_.cells, phasesAt(range_, number)};
    FindOptions options;
    options.scene.bar.gap *= range_.gapSign;
    options.scene.segments = range_.segments;
    options.objective = Objective::minEnergy;
    options.cancel = cancel;
    const PeriodicResult result = findPeriodic(schedule, options);
    ProgramRow made;
    AtlasRow& row = made.row;
    row.status = result.status;
    row.kernelDimension = result.set.kernelDimension.value_or(-1);
    row.steps = steps(schedule);
    if (result.absence) {
        row.reason = result.absence->reason;
        const auto& proof = result.absence->proof;
        if (const auto* floor = std::get_if<EnergyFloorProof>(&proof)) {
            made.proof = textOf(floor->multipliers);
        } else if (const auto* exact = std::get_if<SteppedProof>(&proof)) {
            made.proof = textOf(exact->multipliers);
        }
    }
    if (result.motion) {
        row.kind = result.set.kind.value_or(SetKind::polytope);
        row.dimension = result.set.dimension;
        row.contact = result.motion->contact;
        row.isCanonical =
            result.motion->repetitions == 1 && result.motion->canonical == schedule.phases;
        row.energy = result.set.energy.value();
    }
    return made;
}

ProgramRow ProgramRows::ofBars(std::int64_t number, const Cancel& cancel) const
{
    const std::vector<ContactSpan> schedule =
        spansOf(Schedule{range_.cells, phasesAt(range_, number)});
    ProgramRow made;
    AtlasRow& row = made.row;
    row.steps = stepsOf(schedule);
    LeastMotion motion;
    try {
        motion = leastMotion(*network_, schedule,
                             hugeEnergyRatio * usualEnergy(*network_, schedule), cancel);
    } catch (const std::invalid_argument&) {
        return made;  // bars at rest, or a bar that no contact ties: no question of one size
    }
    row.status = motion.status;
    row.kernelDimension = motion.kernelDimension.value_or(-1);
    if (motion.status == Status::none) {
        row.reason = reasonOf(motion, NetworkBlocks(*network_, schedule));
        made.proof = textOf(motion.multipliers);
    } else if (motion.status == Status::found) {
        row.kind = SetKind::polytope;
        row.contact = motion.residuals.presses() ? Contact::pressing : Contact::grazing;
        row.isCanonical = isCanonical(*network_, *motion.motion, schedule);
        row.energy = {motion.energy / energyUnit_, std::numeric_limits<double>::quiet_NaN()};
    }
    return made;
}

}  // namespace signorini
