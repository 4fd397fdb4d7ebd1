#include "formulation.hpp"

#include <stdexcept>

#include "builders.hpp"
#include "demand_names.hpp"
#include "echo.hpp"

namespace signorini {

std::string_view name(Formulation formulation)
{
    return nameIn(formulationNames, formulation);
}

Formulated formulate(const Schedule& schedule, Formulation formulation, double depth)
{
    validate(schedule);
    Formulated result;
    switch (formulation) {
        case Formulation::automatic:
        case Formulation::joints:
        case Formulation::kernel:
            throw std::invalid_argument(std::string("formulation = ") +
                                        std::string(name(formulation)) +
                                        ": allowed state|reduced|lumped for a uniform bar");
        case Formulation::state:
            result = stateForm(schedule, depth);
            break;
        case Formulation::reduced:
            result = amplitudeForm(schedule, depth, false);
            break;
        case Formulation::lumped:
            result = amplitudeForm(schedule, depth, true);
            break;
    }
    result.leftOut.emplace_back("closure of the last flight: periodicity implies it");
    if (result.schedule != schedule) {
        result.leftOut.emplace_back(
            "steps beyond 2N in contact and 4N in flight: their rows repeat");
    }
    return result;
}

State stateOf(const Formulated& formulated, const Eigen::VectorXd& x)
{
    const auto n = static_cast<std::int64_t>(formulated.delay.size());
    return stateOfWaves(formulated.schedule.cells, [&](std::int64_t m) {
        const DelayTerm& term = formulated.delay[static_cast<std::size_t>(m % n)];
        return term.factor * x[term.column];
    });
}

}  // namespace signorini
