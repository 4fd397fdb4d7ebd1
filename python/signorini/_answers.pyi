"""Types of the answers of the compiled part; stubs alone, no module."""

from collections.abc import Iterator, Sequence
from typing import Any, Generic, Literal, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import NotRequired, TypedDict

from ._core import (Bar, Motion, Scene, Schedule, Segment, State, _Drawn, _DrawnEach, _Fields,
                    _Framed, _InScene, _MovingEach, _OfPeriod, _OfTimeRatio, _Record)
from ._tables import Row, Table

Array = NDArray[np.float64]
Bounds = tuple[float, Optional[float]]

_T = TypeVar("_T")
_Row = TypeVar("_Row", bound=Row)
# What it is, or None: who has looked at the status, at the gap or at the
# modulus need not look again.
Known = Union[_T, Any]

class StopPlace(TypedDict):
    side: Literal["right", "left"]
    place: float

class StabilityReport(TypedDict):
    damping: Damping
    verdict: Literal["attracts", "repels", "unclear"]
    periods: int
    drift: float
    contacts: int
    trials: list[StabilityTrial]

class StabilityTrial(TypedDict):
    size: float
    start: float
    end: float

class QuestionPart(TypedDict):
    asked: AskedWords
    steps: NotRequired[int]
    period: float
    period_ratio: float
    frequency: float
    frequency_ratio: NotRequired[float]
    energy: Optional[float]
    energy_ratio: Optional[float]
    nearest: NotRequired[float]

class AskedWords(TypedDict):
    period: NotRequired[str]
    frequency: NotRequired[str]
    hertz: NotRequired[str]

class ForcedSetPart(TypedDict):
    kind: Literal["empty", "point", "segment", "ray", "polytope"]
    free_waves: int

class ForcedProof(TypedDict):
    kind: str
    verified: bool
    conditions: list[ForcedCondition]
    rows: NotRequired[str]
    cuts: NotRequired[list[EnergyFloor]]

class ForcedCondition(TypedDict):
    rule: Literal["gap", "pressure", "held", "penetration", "second-stop", "closure", "work",
        "strain", "rest"]
    step: int

class EnergyFloor(TypedDict):
    periodicity: list[float]
    places: list[tuple[int, int, float]]
    pushes: list[tuple[int, int, float]]
    strains: NotRequired[list[tuple[int, int, int, float]]]

class SceneWords(TypedDict):
    length: float
    wave_speed: float
    axial_stiffness: float
    young: Optional[float]
    gravity: float
    parts: list[ScenePart]

class ScenePart(TypedDict):
    kind: Literal["clamp", "free", "cells", "gap", "right stop", "left stop", "dash", "spring",
        "mass", "force", "driven", "shaken"]
    cells: NotRequired[int]
    impedance: NotRequired[float]
    speed: NotRequired[float]
    gap: NotRequired[float]
    stiffness: NotRequired[float]
    mass: NotRequired[float]
    force: NotRequired[float]

class SceneReference(TypedDict):
    frequency: Optional[float]
    damping: Optional[float]
    energy: Optional[float]
    compliance: Optional[float]

class ContactSpan(TypedDict):
    closed: list[int]
    steps: int

class SceneContactForces(TypedDict):
    number: int
    kind: Literal["right stop", "left stop", "gap"]
    place: float
    gap: float
    approach_speed: NotRequired[float]
    peak_force: NotRequired[float]
    impulse: NotRequired[float]
    contact_time: NotRequired[float]

class SceneStrains(TypedDict):
    peak_compression: float
    peak_tension: float
    peak_stress: Optional[float]

class ScenePhysical(TypedDict):
    frequency: float
    contact_time: float
    peak_force: float
    impulse: float
    approach_speed: float
    peak_compression: float
    peak_tension: float
    peak_stress: Optional[float]
    tip_lowest: Optional[float]

class SceneStabilityReport(TypedDict):
    verdict: Literal["attracts", "repels", "unclear"]
    periods: int
    drift: float
    contacts: int
    trials: list[SceneStabilityTrial]

class SceneStabilityTrial(TypedDict):
    size: float
    start: float
    end: float

class SceneEnergyFloor(TypedDict):
    kind: str
    verified: bool
    rows: str
    energy_ratio: Optional[float]
    energy: float
    strain_limit: NotRequired[float]
    periodicity: list[float]
    places: list[tuple[int, int, float]]
    pushes: list[tuple[int, int, float]]
    strains: NotRequired[list[tuple[int, int, int, float]]]

class SceneContact(TypedDict):
    number: int
    kind: Literal["right stop", "left stop", "gap"]
    place: float
    gap: float

class SceneForcedProof(TypedDict):
    kind: str
    verified: bool
    rows: str
    cuts: list[EnergyFloor]

class SceneSet(TypedDict):
    contact: int
    steps: int
    status: Literal["found", "none", "undecided"]
    detail: NotRequired[str]

class SceneContactTotals(TypedDict):
    number: int
    kind: Literal["right stop", "left stop", "gap"]
    place: float
    gap: float
    count: int
    impulse: float
    peak_force: float
    contact_time: float

class MomentumBalance(TypedDict):
    given: float
    error: float

class ContactReach(TypedDict):
    number: int
    kind: Literal["right stop", "left stop", "gap"]
    place: float
    gap: float
    velocity: tuple[ForcePeak, ForcePeak]
    displacement: tuple[ForcePeak, ForcePeak]

class ForcePeak(TypedDict):
    bound: float
    reached: float
    time: float

class _Found(_Record):
    status: Literal["found", "none", "undecided"]
    found: bool
    def __bool__(self) -> bool: ...

class _OfScene(_Record):
    bar: Bar
    stops: list[StopPlace]
    segments: list[Segment]
    static_force: float

class _OfBars(_InScene):
    scene: SceneWords
    reference: SceneReference

class _InPeriod(_Record):
    period: float
    period_ratio: float
    frequency_ratio: float

class _Excited(_Record):
    force: Literal["tip", "base"]
    cycles: int

class _Measured(_Record):
    physical: Physical
    admissible: bool

class _Proof(_Record):
    kind: str
    verified: bool

class Physical(_Record):
    frequency: float
    contact_time: float
    peak_force: float
    impulse: float
    approach_speed: float
    peak_compression: float
    peak_tension: float
    peak_stress: Known[float]
    tip_lowest: float

class Residuals(_Record):
    periodicity: float
    gap: float
    pressure: float
    penetration: float
    march: float
    demands: float
    def worst(self) -> float: ...

class FarkasCertificate(_Proof):
    rows: str
    gap: int
    size: int
    periodicity: list[tuple[int, int]]
    pressure: list[tuple[int, int]]
    penetration: list[tuple[int, int]]

class ProgramProof(_Proof):
    rows: Literal["auto", "state", "reduced", "lumped", "joints", "kernel"]
    strain_limit: Optional[float]
    tip_floor: Optional[float]
    equalities: list[tuple[int, int]]
    inequalities: list[tuple[int, int]]

class SteppedProof(_Proof):
    rows: Literal["auto", "state", "reduced", "lumped", "joints", "kernel"]
    tip_floor: Optional[float]
    equalities: list[tuple[int, str]]
    inequalities: list[tuple[int, str]]

class EnergyFloorProof(_Proof):
    rows: str
    energy_ratio: float
    tip_floor: Optional[float]
    strain_limit: Optional[float]
    periodicity: list[float]
    places: list[tuple[int, int, float]]
    pushes: list[tuple[int, int, float]]
    strains: Optional[list[tuple[int, int, int, float]]]

class EnergyExclusion(_Proof):
    note: Optional[str]

class SolutionSet(_Record):
    kind: Literal["empty", "point", "simplex", "box", "polytope", "cone"]
    dimension: Optional[int]

class EnergySection(_Record):
    dimension: int
    connected: bool
    components: Optional[int]

class SolverReport(_Record):
    name: str
    iterations: int
    seconds: float

class FamilyPlace(_Record):
    order: int
    nu: int
    contact_blocks: int
    period_ratio: tuple[int, int]
    contact: tuple[int, int]
    least_energy_ratio: float
    amplitudes: int
    offset: int

class Result(_Found, _OfScene, _InPeriod):
    cells: int
    schedule: Schedule
    kernel_dimension: Optional[int]
    solution_set: Known[SolutionSet]
    family: Known[FamilyPlace]
    objective: Literal["auto", "any", "min-energy", "max-energy", "min-peak-strain",
        "max-impulse", "nearest"]
    contact: Optional[Literal["pressing", "grazing"]]
    canonical_schedule: Known[list[tuple[int, int]]]
    approach_speeds: Known[list[float]]
    energy: Known[float]
    energy_ratio: Known[float]
    energy_ratio_range: Known[Bounds]
    energy_section: Known[EnergySection]
    physical: Known[Physical]
    admissible: Optional[bool]
    residuals: Known[Residuals]
    reason: Optional[Literal["no-live-class", "contact-sign", "penetration", "gap",
        "constraints"]]
    near_schedule: Known[Schedule]
    certificate: Known[Union[FarkasCertificate, ProgramProof, EnergyExclusion, SteppedProof,
        EnergyFloorProof]]
    route: str
    route_reason: str
    left_out: list[str]
    solver: SolverReport
    repetitions: Optional[int]
    pressing_phases: Known[list[bool]]
    symmetric: Optional[bool]
    peak_strain: Known[float]
    target: Optional[str]
    distance: Known[float]
    detail: Optional[str]
    stability: Known[list[StabilityReport]]
    scene: Scene
    state: Known[State]
    motion: Known[Motion]
    def is_proof(self) -> bool: ...

class ContinuumPoint(_Measured):
    lambda_: float
    energy: float
    energy_ratio: Known[float]
    residual: float
    peak_strain: float
    exact: Optional[bool]
    state: State
    motion: Motion

class _RowsOf(Generic[_Row]):
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, at: int) -> _Row: ...
    @overload
    def __getitem__(self, at: slice) -> Table[_Row]: ...
    def __iter__(self) -> Iterator[_Row]: ...

class _Curve(_Found, _Framed, _Drawn):
    cells: int
    energy: float
    energy_ratio: Known[float]
    connected: Optional[bool]
    dimension: Optional[int]
    resolution: Optional[float]
    engine: str
    family: str
    parameter: Literal["arc length", "pause", "number"]

class Continuum(_RowsOf[ContinuumPoint], _OfScene, _InPeriod, _Curve):
    schedule: Schedule
    components: Optional[int]
    energy_ratio_range: Optional[Bounds]
    reason: Optional[Literal["no-live-class", "contact-sign", "penetration", "gap",
        "constraints"]]
    orbits: int
    points: list[ContinuumPoint]
    detail: Optional[str]
    lambda_: Array
    peak_strain: Array
    residual: Array
    def member(self, lambda_: float) -> ContinuumPoint: ...

class Family(_Record):
    order: int
    nu: int
    contact_blocks: int
    period_ratio: tuple[int, int]
    contact: tuple[int, int]
    least_energy_ratio: float
    least_energy_exact: tuple[int, int]
    least_energy: float
    frequency_ratio: float
    frequency: float
    period: float
    mode: Optional[tuple[int, int]]
    bar: Bar
    def schedule(self, cells: int) -> Schedule: ...

class Mode(_Record):
    contact: tuple[int, int]
    period_range: tuple[tuple[int, int], tuple[int, int]]
    inverse_sqrt_energy: tuple[int, int]
    family: Optional[str]
    ends: tuple[Literal["contact-vanishes", "energy-infinite", "jumps-meet"],
        Literal["contact-vanishes", "energy-infinite", "jumps-meet"]]
    energy_ratio_range: Bounds
    frequency_range: tuple[float, float]
    energy_range: Bounds
    bar: Bar
    kappa: int
    mu: int
    energy_ratio: _OfPeriod
    contact_time_ratio: _OfPeriod
    def schedule(self, cells: int, steps: int) -> Schedule: ...
    def families(self, max_order: int) -> list[Family]: ...
    def motion(self, period_ratio: float, gravity: float = ...
               ) -> ModeMotion: ...

class _OnNoGrid(_Fields):
    bar: Bar
    frequency: float
    contact_time: float
    contact_time_ratio: float
    energy: float
    energy_ratio: float
    amplitude_ratio: float
    jump_times_ratio: Array
    def to_dict(self) -> dict[str, Any]: ...
    p: _OfTimeRatio
    def state(self, cells: int) -> State: ...

class ModeMotion(_Found, _OnNoGrid, _InPeriod, _Measured):
    gravity: float
    mode: Mode
    jumps: list[tuple[int, int]]

class PolytopeMotion(_OnNoGrid, _InPeriod, _Measured):
    polytope: ModePolytope
    contacts: list[tuple[float, float]]
    contacts_ratio: list[tuple[float, float]]

class ModeChain(_Record):
    k: int
    turns: int
    release: int

class ModePolytope(_Record):
    chains: list[ModeChain]
    order: int
    free_times: int
    contact: tuple[int, int]
    period_range: tuple[tuple[int, int], tuple[int, int]]
    inverse_sqrt_energy: tuple[int, int, int]
    ends: tuple[Literal["contact-vanishes", "energy-infinite", "jumps-meet"],
        Literal["contact-vanishes", "energy-infinite", "jumps-meet"]]
    vertices: list[list[tuple[int, int]]]
    energy_ratio_range: Bounds
    frequency_range: tuple[float, float]
    energy_range: Bounds
    bar: Bar
    phases: int
    energy_ratio: _OfPeriod
    def slice(self, period_ratio: float) -> Array: ...
    def stretches(self, period_ratio: float, arrivals: Sequence[float]
                  ) -> Array: ...
    def motion(self, period_ratio: float,
               arrivals: Optional[Sequence[float]] = ...
               ) -> PolytopeMotion: ...
    def schedules(self, cells: int, steps: int) -> list[Schedule]: ...

class AtlasFamily(_InPeriod):
    id: int
    cells: int
    order: Optional[int]
    nu: Optional[int]
    contact_blocks: Optional[int]
    schedule: Schedule
    frequency: float
    contact: Literal["pressing", "grazing"]
    kind: Literal["empty", "point", "simplex", "box", "polytope", "cone"]
    dimension: int
    energy_range: Bounds
    energy_ratio_range: Bounds
    schedules: int
    dimension_at_energy: Optional[int]
    connected_at_energy: Optional[bool]

class AtlasSchedule(_Found):
    cells: int
    schedule: Optional[Schedule]
    spans: Optional[list[ContactSpan]]
    family: Optional[int]
    period: float
    period_ratio: float
    frequency: float
    frequency_ratio: Optional[float]
    reason: Optional[Literal["no-live-class", "contact-sign", "penetration", "gap",
        "constraints"]]
    kernel_dimension: Optional[int]
    kind: Optional[Literal["empty", "point", "simplex", "box", "polytope", "cone"]]
    dimension: Optional[int]
    contact: Optional[Literal["pressing", "grazing"]]
    canonical: Optional[bool]
    energy_range: Optional[Bounds]
    energy_ratio_range: Optional[Bounds]

class AtlasRun(_Record):
    cells: int
    max_contact: int
    max_free: int
    phases: int
    max_energy_ratio: Optional[float]
    families_only: bool
    scene: Optional[SceneWords]
    finished: bool
    decided: int
    found: int
    pressing: int
    grazing: int
    family_count: int
    refuted: int
    undecided: int
    batches: tuple[int, int]
    seconds: float

class AtlasFile:
    def __init__(self, path: str, bar: Bar) -> None: ...
    def runs(self) -> list[AtlasRun]: ...
    def families(self, cells: Optional[int], near: Optional[tuple[float, float, float]],
                 period: Optional[tuple[int, int]]) -> list[AtlasFamily]: ...
    def schedules(self, cells: Optional[int], near: Optional[tuple[float, float, float]],
                  period: Optional[tuple[int, int]]) -> list[AtlasSchedule]: ...
    def has_families(self) -> bool: ...
    def frequency_energy_figure(self, cells: Optional[int], left: Optional[float],
                                right: Optional[float], top: Optional[float],
                                max_order: int, /) -> str: ...
    def existence_figure(self, cells: Optional[int]) -> str: ...
    def twins(self, cells: Optional[int]
              ) -> list[tuple[list[AtlasFamily], list[AtlasSchedule]]]: ...

class Damping(_Record):
    ratio: float
    dashpot: float

class ForcedMotion(_Measured):
    schedule: Schedule
    amplitude: float
    phase: float
    impulse: float
    peak_force: float
    tip_lowest: float
    residual: float
    stable: Optional[bool]
    impulse_ratio: float
    peak_force_ratio: float
    tip_lowest_ratio: float
    state: State

class ForcedResult(_Found, _Framed, _MovingEach, _OfScene, _InPeriod, _Excited):
    cells: int
    schedule: Schedule
    damping: Damping
    solution_set: ForcedSetPart
    strain_limit: Optional[float]
    amplitude: Optional[float]
    amplitude_range: Optional[Bounds]
    phase: Optional[float]
    motions: list[ForcedMotion]
    reason: Optional[Literal["no-live-class", "contact-sign", "penetration", "gap",
        "constraints"]]
    certificate: Optional[ForcedProof]
    detail: Optional[str]

class HarmonicContact(_Record):
    begin: float
    end: float
    begin_ratio: float
    end_ratio: float
    stop: Literal["right", "left"]
    release: str
    impulse: float
    peak_force: float
    speed: float

class HarmonicMotion(_Measured):
    contact_time_ratio: float
    release: str
    contacts: list[HarmonicContact]
    phase: float
    growth: Optional[float]
    attracts: Optional[bool]
    residual: float
    enclosed: Optional[float]
    alone_within: Optional[float]

class SceneHarmonicContact(_Record):
    contact: int
    begin: float
    end: float
    begin_steps: float
    end_steps: float
    release: str
    impulse: float
    peak_force: float
    speed: float

class SceneHarmonicMotion(_Record):
    contact: int
    contact_time: float
    contact_steps: float
    release: str
    phase: float
    impulse: float
    peak_force: float
    speed: float
    growth: Optional[float]
    attracts: Optional[bool]
    residual: float
    strains: SceneStrains
    admissible: bool
    contacts: Optional[list[SceneHarmonicContact]]
    stability: Optional[SceneStabilityReport]
    spans: Optional[list[ContactSpan]]
    amplitude: Optional[float]

class SceneHarmonicResult(_Found, _Framed, _MovingEach, _OfBars, _Excited):
    question: QuestionPart
    contacts_in_period: int
    amplitude: float
    steps: int
    period: float
    frequency: float
    frequency_ratio: Optional[float]
    motions: list[SceneHarmonicMotion]
    strain_limit: Optional[float]
    beyond_limit: Optional[int]
    contacts: list[SceneContact]
    detail: Optional[str]

class SceneQuestion(_Found, _Framed, _OfBars):
    cells: int
    steps: int
    period: float
    frequency: float
    question: QuestionPart
    strain_limit: Optional[float]
    sets: list[SceneSet]
    motions: list[SceneResult]

class SceneResiduals(_Record):
    periodicity: float
    tie: float
    gap: float
    pressure: float
    penetration: float

class SceneResult(_Found, _MovingEach, _OfBars):
    cells: int
    schedule: list[ContactSpan]
    period: float
    period_ratio: float
    frequency_ratio: Known[float]
    kernel_dimension: Optional[int]
    solution_set: Known[SolutionSet]
    contacts: list[SceneContactForces]
    contact: Optional[Literal["pressing", "grazing"]]
    energy: Known[float]
    energy_ratio: Known[float]
    energy_ratio_proved: Known[float]
    strains: Known[SceneStrains]
    physical: Known[ScenePhysical]
    admissible: Optional[bool]
    peak_compression_proved: Known[float]
    residuals: Known[SceneResiduals]
    stability: Known[SceneStabilityReport]
    certificate: Known[SceneEnergyFloor]
    route: str
    route_reason: str
    left_out: list[str]
    solver: SolverReport
    detail: str
    reason: Optional[Literal["no-live-class", "contact-sign", "penetration", "gap",
        "constraints"]]
    def write(self, path: str, index: int = ...) -> None: ...

class SceneForcedMotion(_Record):
    amplitude: float
    phase: float
    contacts: list[SceneContactForces]
    strains: SceneStrains
    physical: ScenePhysical
    admissible: bool
    residual: float
    stability: Optional[SceneStabilityReport]

class SceneContinuumPoint(_Record, _MovingEach, _InScene):
    lambda_: float
    energy: float
    energy_ratio: Known[float]
    residual: float
    peak_strain: float
    strains: SceneStrains
    physical: ScenePhysical
    admissible: bool
    contacts: list[SceneContactForces]
    def write(self, path: str, index: int = 0) -> None: ...

class SceneContinuum(_RowsOf[SceneContinuumPoint], _OfBars, _Curve):
    schedule: list[ContactSpan]
    period: float
    period_ratio: float
    frequency_ratio: Optional[float]
    energy_ratio_proved: Optional[float]
    strain_limit: Optional[float]
    points: list[SceneContinuumPoint]
    certificate: Optional[SceneEnergyFloor]
    detail: str
    def member(self, lambda_: float) -> SceneContinuumPoint: ...

class SceneForcedResult(_Found, _Framed, _MovingEach, _OfBars, _Excited):
    cells: int
    schedule: list[ContactSpan]
    period: float
    period_ratio: float
    frequency_ratio: Optional[float]
    frequency: float
    amplitude: Optional[float]
    strain_limit: Optional[float]
    kind: Literal["empty", "point", "segment", "ray", "polytope"]
    free_waves: int
    amplitude_range: Optional[Bounds]
    contacts: list[SceneContact]
    phase: Optional[float]
    motions: list[SceneForcedMotion]
    certificate: Optional[SceneForcedProof]
    detail: str
    def write(self, path: str, index: int = ...) -> None: ...

class _Followed(_Record, _Framed, _Drawn):
    status: Literal["done", "interrupted"]
    excitation: Optional[Drive]
    time: float
    settled: Optional[Settled]
    why: Optional[str]
    energy: float
    balance: EnergyBalance
    events: int
    merged: float
    contact_start: Array
    contact_end: Array
    contact_impulse: Array
    contact_peak_force: Array
    contact_speed: Array

class SceneSimulation(_OfBars, _Followed):
    contacts: list[SceneContactTotals]
    momentum: MomentumBalance
    fronts: int
    contact_number: list[int]

class HarmonicResult(_Found, _Framed, _MovingEach, _OfScene, _InPeriod, _Excited):
    question: QuestionPart
    contacts: int
    damping: Damping
    amplitude: float
    exact_period: tuple[int, int]
    motions: list[HarmonicMotion]
    strain_limit: Optional[float]
    beyond_limit: Optional[int]
    complete_from: Optional[float]
    rests: Optional[bool]
    detail: Optional[str]

class PermanentContact(_Measured):
    least_force: float
    peak_force: float
    impulse: float
    residual: float

class ForcedFrequency(_Record):
    steps: int
    cells: int
    frequency_ratio: float
    frequency: float
    touches: bool
    linear_peak: float
    undecided: int
    reason: Optional[str]
    permanent_contact: Optional[PermanentContact]
    motions: list[ForcedMotion]

class ResponseData(_Found, _OfScene, _Excited):
    cells: int
    damping: Damping
    amplitude: float
    amplitude_of: str
    contacts: int
    band: Optional[float]
    frequency_ratio_range: tuple[float, float]
    complete: bool
    frequencies: list[ForcedFrequency]

class ExactFrequency(_Record):
    steps: int
    frequency_ratio: float
    frequency: float
    touches: bool
    linear_peak: float
    motions: list[HarmonicMotion]

class BranchPoint(_Record):
    frequency_ratio: float
    frequency: float
    contacts: int
    phase: float
    impulse: float
    peak_force: float
    tip_lowest: float
    growth: Optional[float]
    attracts: Optional[bool]

class BranchMark(_Record):
    event: str
    after: int
    frequency_ratio: float
    frequency: float

class Branch(_Record):
    points: list[BranchPoint]
    marks: list[BranchMark]

class SceneFrequency(_Record):
    steps: int
    frequency: float
    frequency_ratio: Optional[float]
    amplitude: float
    touches: bool
    distance: Optional[list[float]]
    motions: list[SceneHarmonicMotion]
    undecided: Optional[int]
    reason: Optional[str]

class SceneResponse(_Found, _Framed, _Drawn, _OfBars, _Excited):
    exact: bool
    most_contacts: int
    band: Optional[float]
    amplitude: float
    amplitude_of: str
    frequency_range: tuple[float, float]
    complete: bool
    frequencies: list[SceneFrequency]
    contacts: list[SceneContact]

class ExactResponse(_Found, _Framed, _Drawn, _OfScene, _Excited):
    cells: int
    damping: Damping
    amplitude: float
    complete: bool
    frequencies: list[ExactFrequency]
    branches: list[Branch]

class Drive(_Record):
    force: Literal["tip", "base"]
    amplitude: float
    frequency_ratio: float
    frequency: float
    phase: float
    steps: int

class Settled(_Record):
    periods: int
    residual: float
    contacts: int
    impulse: float

class EnergyBalance(_Record):
    work: float
    dissipated: float
    error: float

class SweepPoint(_Record):
    value: float
    direction: Literal["up", "down"]
    frequency: float
    periods: Optional[int]
    residual: Optional[float]
    why: Optional[str]
    watched: int
    contacts: float
    contacts_range: tuple[int, int]
    impulse: float
    impulse_range: tuple[float, float]
    impulses: list[float]
    mean_force: float
    tip_lowest: float
    tip_highest: float
    peak_strain: float
    peak_stress: Known[float]

class ForceRange(_Record, _InScene):
    status: Literal["done", "interrupted"]
    scene: SceneWords
    force_range: tuple[float, float]
    time: float
    closes: Optional[int]
    contacts: list[ContactReach]

class Sweep(_Record, _Framed, _Drawn):
    status: Literal["done", "interrupted"]
    bar: Optional[Bar]
    stops: Optional[list[StopPlace]]
    segments: Optional[list[Segment]]
    static_force: Optional[float]
    scene: Optional[SceneWords]
    reference: Optional[SceneReference]
    contacts: Optional[list[SceneContact]]
    over: Literal["frequency", "amplitude", "gap", "damping"]
    damping: Optional[Damping]
    force: Literal["tip", "base"]
    amplitude: Optional[float]
    amplitude_of: str
    cells: int
    carried: bool
    yield_stress: Optional[float]
    points: list[SweepPoint]

class StudyPoint(_Record):
    gap: float
    damping: float
    amplitude: float
    impulse: float
    frequency: float
    mean_force: float
    peak_strain: Optional[float]
    peak_stress: Known[float]
    rattles_from: Optional[float]
    rattles_to: Optional[float]
    irregular: float

class Waves:
    def to_dict(self) -> dict[str, Any]: ...
    a: Array
    b: Array
    a_duration: Array
    b_duration: Array
    bar: Bar
    energy: float
    energy_ratio: float
    def stretching(self, cells: int) -> Array: ...

class Simulation(_OfScene, _Followed):
    cells: int
    damping: Damping
    time_ratio: float
    contacts: int
    impulse: float
    resolution: float
    tip: float
    held: bool
    energy_ratio: Known[float]
    pieces: int
    contact_stop: list[str]
    contact_mean_force: Array
    contact_energy: Array
    contact_start_ratio: Array
    contact_end_ratio: Array
    contact_impulse_ratio: Array
    contact_peak_force_ratio: Array
    contact_mean_force_ratio: Array
    contact_speed_ratio: Array
    contact_energy_ratio: Array
    tip_time: Array
    tip_displacement: Array
    tip_time_ratio: Array
    tip_displacement_ratio: Array
    waves: Waves
