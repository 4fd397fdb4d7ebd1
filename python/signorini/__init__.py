"""Periodic motions of an elastic bar in unilateral contact with a wall.

>>> import signorini as sg
>>> r = sg.find(150, 900)
>>> r.status, r.energy_ratio
('found', 4.0)

Attributes have the names of the program's JSON, arguments those of its
options. SI units throughout; names in ``_ratio`` are dimensionless: energies
in E_1, periods in L/c, frequencies in omega_1, waves and strains in g/L.
`signorini.plot` draws, and is loaded when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._atlas import Atlas
from ._blame import let_speak
from ._core import (AtlasFamily, AtlasRun, AtlasSchedule, BackendUnavailable, Bar, Branch,
                    BranchMark, BranchPoint, Continuum, ContinuumPoint, Damping, Drive,
                    EnergyBalance, EnergyExclusion, EnergyFloorProof, EnergySection,
                    ExactFrequency, ExactResponse, Family, FamilyPlace, FarkasCertificate,
                    ForcedFrequency, ForcedMotion, ForcedResult, ForceRange, HarmonicContact,
                    HarmonicMotion, HarmonicResult, Mode, ModeChain, ModeMotion, ModePolytope,
                    Motion, PermanentContact, Physical, PolytopeMotion, ProgramProof, Residuals,
                    Result, Scene, SceneContinuum, SceneContinuumPoint, SceneForcedMotion,
                    SceneForcedResult, SceneFrequency, SceneHarmonicContact, SceneHarmonicMotion,
                    SceneHarmonicResult, SceneQuestion, SceneResiduals, SceneResponse,
                    SceneResult, SceneSimulation, Schedule, Segment, Settled, Simulation,
                    SolutionSet, SolverReport, State, SteppedProof, StudyPoint, Sweep,
                    SweepPoint, Waves, __version__, backends)
from ._find import continuum, find
from ._forced import Response, exact_response, force_range, response, simulate, sweep
from ._lists import families, mode, modes, polytope
from ._notebook import be_at_home
from ._question import Question
from ._records import be_records
from ._study import study
from ._tables import Table

let_speak(_core)
be_records()
be_at_home()

if TYPE_CHECKING:
    from types import ModuleType

    from . import plot as plot

__all__ = [
    "Atlas", "AtlasFamily", "AtlasRun", "AtlasSchedule", "BackendUnavailable", "Bar", "Branch",
    "BranchMark", "BranchPoint", "Continuum", "ContinuumPoint", "Damping", "Drive",
    "EnergyBalance", "EnergyExclusion", "EnergyFloorProof", "EnergySection", "ExactFrequency",
    "ExactResponse", "Family", "FamilyPlace", "FarkasCertificate", "ForcedFrequency",
    "ForcedMotion", "ForcedResult", "ForceRange", "HarmonicContact", "HarmonicMotion",
    "HarmonicResult", "Mode", "ModeChain", "ModeMotion", "ModePolytope", "Motion",
    "PermanentContact", "Physical", "PolytopeMotion", "ProgramProof", "Question", "Residuals",
    "Response", "Result", "Scene", "SceneContinuum", "SceneContinuumPoint", "SceneForcedMotion",
    "SceneForcedResult", "SceneFrequency", "SceneHarmonicContact", "SceneHarmonicMotion",
    "SceneHarmonicResult", "SceneQuestion", "SceneResiduals", "SceneResponse", "SceneResult",
    "SceneSimulation", "Schedule", "Segment", "Settled", "Simulation", "SolutionSet",
    "SolverReport", "State", "SteppedProof", "StudyPoint", "Sweep", "SweepPoint", "Table",
    "Waves",
    "__version__", "backends", "continuum", "exact_response", "families", "find", "force_range",
    "mode", "modes", "plot", "polytope", "response", "simulate", "study", "sweep",
]


def __getattr__(name: str) -> ModuleType:
    """Load `signorini.plot`, and with it matplotlib, when it is needed."""
    if name == "plot":
        import importlib
        return importlib.import_module(".plot", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
