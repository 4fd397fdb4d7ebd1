#include "stepped_atlas.hpp"

#include <fmt/format.h>

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
        if (const auto* proof = std::get_if<SteppedProof>(&result.absence->proof)) {
            answer.proof = AtlasProof{number, textOf(proof->multipliers)};
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
