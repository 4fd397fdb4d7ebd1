#include "calls.hpp"

#include <pybind11/stl.h>

#include "described.hpp"
#include "find_answer.hpp"

namespace signorini::python {

void addParts(py::module_& module)
{
    classOf<Physical>(module);
    classOf<Residuals>(module)->more().def("worst", &Residuals::worst, "The largest of them.");
    classOf<FarkasCertificate>(module);
    classOf<ProgramProof>(module);
    classOf<SteppedProof>(module);
    classOf<EnergyFloorProof>(module);
    classOf<EnergyExclusion>(module);
    classOf<answers::SolutionSet>(module);
    classOf<HeldEnergy>(module);
    classOf<SolverReport>(module);
    classOf<TentPlace>(module);
    classOf<Of<Damping>>(module);
}

}  // namespace signorini::python
