#include "parts.hpp"

#include <pybind11/stl.h>

namespace signorini::python {

namespace {

/// Of which struct a member is.
template <auto member>
struct Owner;
template <typename T, typename Value, Value T::*member>
struct Owner<member> {
    using Type = T;
};

/// A getter for a member.
template <auto member>
constexpr auto get = [](const typename Owner<member>::Type& value) { return value.*member; };

/// [(row, value), ...].
template <typename Row>
py::list pairs(const std::vector<Row>& rows)
{
    py::list list;
    for (const Row& m : rows) {
        list.append(py::make_tuple(m.row, m.value));
    }
    return list;
}

void addPhysical(py::module_& module)
{
    Record<Physical>(module, "Physical", "What one period of a motion shows, in SI units.")
        .key("frequency", get<&Physical::frequency>, "[Hz]")
        .key("contact_time", get<&Physical::contactTime>, "[s] a period, wall pressed.")
        .key("peak_force", get<&Physical::peakForce>, "[N], of the tip on the wall.")
        .key("impulse", get<&Physical::impulse>, "[N s] a period.")
        .key("approach_speed", get<&Physical::approachSpeed>, "[m/s], largest, meeting the wall.")
        .key("peak_compression", get<&Physical::peakCompression>, "[-], -min s.")
        .key("peak_tension", get<&Physical::peakTension>, "[-], max s.")
        .key(
            "peak_stress", [](const Physical& p) { return orNone(p.peakStress); },
            "[Pa], largest |stress|; None without Young's modulus.")
        .key("tip_lowest", get<&Physical::tipLowest>, "[m], min u(L, t).");
    Record<Residuals>(module, "Residuals",
                      "Relative violations, recomputed; 0 where there are none.")
        .key("periodicity", get<&Residuals::periodicity>, "Of (30).")
        .key("gap", get<&Residuals::gap>, "Of (31).")
        .key("pressure", get<&Residuals::pressure>, "Of (10).")
        .key("penetration", get<&Residuals::penetration>, "Of (11) and (12).")
        .key("march", get<&Residuals::march>, "Seen by a march that decides contact by itself.")
        .key("demands", get<&Residuals::demands>, "Of further demands.")
        .more()
        .def("worst", &Residuals::worst, "The largest of them.");
}

void addCertificates(py::module_& module)
{
    Record<FarkasCertificate>(
        module, "FarkasCertificate",
        "Whole multipliers of the paper's rows that add up to 0 < 0; rows count from 0.")
        .key(
            "kind", [](const FarkasCertificate&) { return "farkas"; }, "\"farkas\".")
        .key(
            "verified", [](const FarkasCertificate&) { return true; }, "Checked in integers.")
        .key(
            "rows", [](const FarkasCertificate&) { return "paper"; }, "\"paper\": (30)-(32).")
        .key("gap", get<&FarkasCertificate::gap>, "Multiplier of (31), negative with a gap.")
        .key("size", get<&FarkasCertificate::size>,
             "Multiplier of the row of size, negative without a gap; else 0.")
        .key(
            "periodicity", [](const FarkasCertificate& c) { return pairs(c.periodicity); },
            "[(row, multiplier), ...] of (30).")
        .key(
            "pressure", [](const FarkasCertificate& c) { return pairs(c.pressure); },
            "[(row, multiplier >= 0), ...] of (10), one row a contact step.")
        .key(
            "penetration", [](const FarkasCertificate& c) { return pairs(c.penetration); },
            "[(row, multiplier >= 0), ...] of (12), one row a free step.");
    Record<ProgramProof>(module, "ProgramProof",
                         "Whole multipliers of the rows of a program, checked in rationals.")
        .key(
            "kind", [](const ProgramProof&) { return "farkas"; }, "\"farkas\".")
        .key(
            "verified", [](const ProgramProof&) { return true; }, "Checked in rationals.")
        .key(
            "rows", [](const ProgramProof& p) { return nameOf(p.rows); }, "Which formulation's.")
        .key(
            "strain_limit",
            [](const ProgramProof& p) {
                return finiteOrNone(p.demands.strainLimit * (1.0 + p.tolerance));
            },
            "[g/L], that the proof rests on, or None.")
        .key(
            "tip_floor",
            [](const ProgramProof& p) { return finiteOrNone(p.demands.tipFloor - p.tolerance); },
            "[g], that the proof rests on, or None.")
        .key(
            "equalities", [](const ProgramProof& p) { return pairs(p.multipliers.equalities); },
            "[(row, multiplier), ...].")
        .key(
            "inequalities", [](const ProgramProof& p) { return pairs(p.multipliers.inequalities); },
            "[(row, multiplier >= 0), ...].");
    Record<SteppedProof>(module, "SteppedProof",
                         "Rational multipliers of the rows of a stepped bar, checked.")
        .key(
            "kind", [](const SteppedProof&) { return "farkas"; }, "\"farkas\".")
        .key(
            "verified", [](const SteppedProof&) { return true; }, "Checked in rationals.")
        .key(
            "rows", [](const SteppedProof&) { return nameOf(Formulation::joints); }, "\"joints\".")
        .key(
            "tip_floor",
            [](const SteppedProof& p) { return finiteOrNone(p.tipFloor - p.tolerance); },
            "[g], that the proof rests on, or None.")
        .key(
            "equalities", [](const SteppedProof& p) { return pairs(p.multipliers.equalities); },
            "[(row, \"p/q\"), ...].")
        .key(
            "inequalities", [](const SteppedProof& p) { return pairs(p.multipliers.inequalities); },
            "[(row, \"p/q\"), ...].");
    Record<EnergyExclusion>(module, "EnergyExclusion", "No motion of the set has the energy held.")
        .key(
            "kind", [](const EnergyExclusion&) { return "energy-range"; }, "\"energy-range\".")
        .key("verified", get<&EnergyExclusion::isVerified>, "Checked in rationals?")
        .keyIfAny(
            "note",
            [](const EnergyExclusion& e) -> py::object {
                return e.isVerified ? py::object(py::none())
                                    : py::str(
                                          "this end of the range is computed, not "
                                          "checked by other code");
            },
            "If not.");
}

}  // namespace

void addParts(py::module_& module)
{
    addPhysical(module);
    addCertificates(module);
    Record<SolutionSet>(module, "SolutionSet", "What all motions of a schedule look like.")
        .key(
            "kind", [](const SolutionSet& s) { return nameOf(s.kind); },
            "\"empty\", \"point\", \"simplex\", \"box\" or \"polytope\".")
        .key(
            "dimension",
            [](const SolutionSet& s) {
                return s.kind == SetKind::empty ? py::object(py::none()) : py::cast(s.dimension);
            },
            "[-], None if empty.");
    Record<HeldEnergy>(module, "EnergySection", "The motions of one energy.")
        .key("dimension", get<&HeldEnergy::dimension>, "[-]")
        .key("connected", get<&HeldEnergy::isConnected>, "Can all of them be joined?")
        .key(
            "components", [](const HeldEnergy& h) { return orNone(h.components); },
            "In so many parts; None beyond 64 bits.");
    Record<SolverReport>(module, "SolverReport", "Who did the work.")
        .key("name", get<&SolverReport::name>, "As in `solver=`.")
        .key("iterations", get<&SolverReport::iterations>, "As the solver counts them.")
        .key("seconds", get<&SolverReport::seconds>, "[s], without verification.");
    Record<TentPlace>(module, "FamilyPlace", "The family of a schedule, and its place there.")
        .key(
            "order", [](const TentPlace& p) { return p.family.order; }, "w.")
        .key(
            "nu", [](const TentPlace& p) { return p.family.blocks; }, "nu.")
        .key(
            "contact_blocks", [](const TentPlace& p) { return p.family.contactBlocks; }, "k.")
        .key(
            "period_ratio",
            [](const TentPlace& p) { return py::make_tuple(2 * p.family.blocks, p.family.order); },
            "T = 2 nu/w [L/c].")
        .key(
            "contact",
            [](const TentPlace& p) {
                return py::make_tuple(2 * p.family.contactBlocks, p.family.order);
            },
            "Longest contact 2k/w [L/c].")
        .key(
            "least_energy_ratio", [](const TentPlace& p) { return leastEnergy(p.family).value(); },
            "(w/win)^2 [E_1].")
        .key("amplitudes", get<&TentPlace::amplitudes>, "d, of this schedule.")
        .key("offset", get<&TentPlace::offset>, "n_c - kG [steps].");
}

}  // namespace signorini::python
