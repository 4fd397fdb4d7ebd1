#include "stepped_atlas.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <variant>

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

}  // namespace

std::optional<SteppedRow> decideStepped(const AtlasRange& range, std::int64_t number,
                                        const Cancel& cancel)
{
    const Schedule schedule{range.cells, phasesAt(range, number)};
    FindOptions options;
    options.scene.bar.gap *= range.gapSign;
    options.scene.segments = range.segments;
    options.objective = Objective::minEnergy;
    options.cancel = cancel;
    const PeriodicResult result = findPeriodic(schedule, options);
    if (isRequested(cancel)) {
        return std::nullopt;
    }
    SteppedRow answer;
    AtlasRow& row = answer.row;
    row.number = number;
    row.status = result.status;
    row.kernelDimension = result.set.kernelDimension.value_or(-1);
    row.steps = steps(schedule);
    if (result.absence) {
        row.reason = result.absence->reason;
        if (const auto* exact = std::get_if<SteppedProof>(&result.absence->proof)) {
            answer.proof = AtlasProof{number, textOf(exact->multipliers)};
        } else if (const auto* floor = std::get_if<EnergyFloorProof>(&result.absence->proof)) {
            answer.proof = AtlasProof{number, textOf(floor->multipliers)};
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
    return answer;
}

}  // namespace signorini
