"""Types of the compiled part. Its docstrings are the documentation."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Optional, Protocol, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._answers import *

Array = NDArray[np.float64]
Listener = Optional[Callable[[float, float], object]]
Steps = Union[int, tuple[int, int], tuple[int, int, str], Schedule]


__version__: str

def palette() -> dict[str, Any]: ...
def backends() -> dict[str, Optional[str]]: ...

class BackendUnavailable(RuntimeError): ...

class _Record:
    def to_dict(self) -> dict[str, Any]: ...
    def _repr_html_(self) -> str: ...

class Bar(_Record):
    def __init__(self, *, length: float = ...,
                 wave_speed: Optional[float] = ...,
                 axial_stiffness: Optional[float] = ..., gap: float = ...,
                 young: Optional[float] = ...,
                 density: Optional[float] = ...,
                 area: Optional[float] = ...) -> None: ...
    def __hash__(self) -> int: ...
    length: float
    wave_speed: float
    axial_stiffness: float
    gap: float
    young: Optional[float]
    energy_unit: float
    time_unit: float
    strain_unit: float
    velocity_unit: float
    displacement_unit: float
    force_unit: float
    impulse_unit: float
    frequency_unit: float

class Segment(_Record):
    cells: int
    impedance: float
    speed: float
    dashpot: float
    def __init__(self, cells: int, impedance: float = ..., speed: float = ...,
                 dashpot: float = ...) -> None: ...

class Scene(_Record):
    bar: Bar
    stops: list[dict[str, Any]]
    segments: list[Segment]
    static_force: float
    second_stop: Optional[float]
    def __init__(self, bar: Bar = ..., second_stop: Optional[float] = ...,
                 segments: Sequence[Segment] = ...) -> None: ...
    @staticmethod
    def of_pieces(pieces: Sequence[tuple[float, float, float, float]], *,
                  gap: float = ..., second_stop: Optional[float] = ...,
                  cells: int = ...) -> tuple[Scene, float]: ...

class Schedule:
    def __init__(self, *steps: Union[int, Sequence[int]],
                 cells: Optional[int] = ...) -> None: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[tuple[int, int]]: ...
    @overload
    def __getitem__(self, at: int) -> tuple[int, int]: ...
    @overload
    def __getitem__(self, at: slice) -> list[tuple[int, int]]: ...
    def to_dict(self) -> list[list[int]]: ...
    cells: int
    phases: list[tuple[int, int]]
    steps: int
    period_ratio: float
    frequency_ratio: float

class State:
    def __init__(self, a: ArrayLike, b: ArrayLike,
                 bar: Optional[Bar] = ...,
                 segments: Sequence[Segment] = ...) -> None: ...
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, list[float]]: ...
    cells: int
    bar: Bar
    segments: list[Segment]
    a: Array
    b: Array
    x: Array
    velocity: Array
    strain: Array
    displacement: Array
    velocity_ratio: Array
    strain_ratio: Array
    displacement_ratio: Array
    energy: float
    energy_ratio: float
    def refined(self, factor: int) -> State: ...
    def write(self, path: str) -> None: ...
    @staticmethod
    def read(path: str, bar: Optional[Bar] = ...,
             cells: int = ...) -> State: ...

# Functions of numbers or arrays: a float for numbers, else an Array of the
# shape that they have together.
class _Field(Protocol):
    @overload  # type: ignore[misc]
    def __call__(self, x: float, t: float) -> float: ...
    @overload
    def __call__(self, x: ArrayLike, t: ArrayLike) -> Array: ...

class _OfTime(Protocol):
    @overload  # type: ignore[misc]
    def __call__(self, t: float) -> float: ...
    @overload
    def __call__(self, t: ArrayLike) -> Array: ...

class _OfTimeRatio(Protocol):
    @overload  # type: ignore[misc]
    def __call__(self, t_ratio: float) -> float: ...
    @overload
    def __call__(self, t_ratio: ArrayLike) -> Array: ...

class _OfPeriod(Protocol):
    @overload  # type: ignore[misc]
    def __call__(self, period_ratio: float) -> float: ...
    @overload
    def __call__(self, period_ratio: ArrayLike) -> Array: ...

class _Fields:
    displacement: _Field
    velocity: _Field
    strain: _Field
    displacement_ratio: _Field
    velocity_ratio: _Field
    strain_ratio: _Field
    wall_force: _OfTime
    wall_force_ratio: _OfTime

class Motion(_Fields):
    def __init__(self, state: State, schedule: Schedule,
                 scene: Optional[Scene] = ...) -> None: ...
    scene: Scene
    def _frames(self, most: int, /) -> list[str]: ...
    def _figure(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    bar: Bar
    schedule: Schedule
    state: State
    cells: int
    steps: int
    period: float
    period_ratio: float
    p: Array
    t: Array
    x: Array
    tip: Array
    tip_ratio: Array
    force: Array
    force_ratio: Array
    def state_at(self, step: int) -> State: ...

def find(schedule: Sequence[Steps], cells: Optional[int], scene: Scene,
         solver: str, formulation: str, objective: str,
         target: Optional[State], energy: Optional[float],
         energy_ratio: Optional[float], strain_limit: Optional[float],
         tip_floor: Optional[float], tolerance: float,
         time_limit: Optional[float], /) -> Result: ...
def question(option: str, word: str, steps: int, cells: int, scene: Scene,
             energy_ratio: Optional[float], sets: Sequence[Result], /
             ) -> QuestionData: ...
def schedules_of_period(cells: int, steps: int, scene: Scene, /
                        ) -> list[Schedule]: ...
def find_forced(schedule: Sequence[Steps], cells: Optional[int],
                scene: Scene, damping: float, force: str,
                amplitude: Optional[float], derivative: int, cycles: int,
                strain_limit: Optional[float], /) -> ForcedResult: ...
def find_harmonic(numerator: int, denominator: int, scene: Scene,
                  damping: float, force: str, amplitude: float,
                  derivative: int, cycles: int, contacts: int, /
                  ) -> HarmonicResult: ...
def continuum(schedule: Sequence[Steps], cells: Optional[int], scene: Scene,
              energy_ratio: Optional[float], energy: Optional[float],
              points: int, start: Optional[State],
              to: Optional[State], direction: Optional[State],
              seed: Optional[int], sample: bool, engine: str,
              strain_limit: Optional[float], resolution: float,
              tolerance: float, progress: Listener, /) -> Continuum: ...
def families(max_order: int, max_energy_ratio: Optional[float], bar: Bar,
             progress: Listener, /) -> list[Family]: ...
def families_figure(rows: list[Family], /) -> str: ...
def frequency_energy_figure(max_order: int, left: float, right: float,
                            top: float, /) -> str: ...
def modes(max_order: int, max_energy_ratio: float, max_period: float,
          bar: Bar, progress: Listener, /) -> list[Mode]: ...
def mode(a4: int, b: int, bar: Bar, /) -> Mode: ...
def polytopes(phases: int, max_order: int, max_energy_ratio: float,
              max_period: float, bar: Bar, progress: Listener, /
              ) -> list[ModePolytope]: ...
def polytope(schedule: Sequence[Steps], cells: Optional[int], bar: Bar, /
             ) -> Optional[ModePolytope]: ...
def build_atlas(path: str, cells: int, max_contact: Optional[int],
                max_free: Optional[int], phases: int,
                max_energy_ratio: Optional[float], all: bool,
                families_only: bool, resume: bool, threads: int, bar: Bar,
                progress: Listener, /) -> AtlasRun: ...
def response(damping: float, force: str, amplitude: float, derivative: int,
             start: float, to: float, cycles: int, cells: int, stability: bool,
             threads: int, scene: Scene, progress: Listener, /) -> ResponseData: ...
def sweep(over: str, start: float, to: float, force: str, damping: float,
          amplitude: float, derivative: int, frequency: float, points: int, direction: str,
          periods: int, rest: bool, resolve: Optional[float], cells: int,
          threads: int, scene: Scene, file: str, question: str,
          progress: Listener, /) -> Sweep: ...
def study(cases: Sequence[tuple[Scene, float, float]], force: str, start: float,
          to: float, points: int, periods: int, cells: int, threads: int,
          file: str, question: str, progress: Listener, /) -> list[StudyPoint]: ...
def simulate(start: Union[State, Waves, None], cells: Optional[int],
             scene: Scene, damping: float, force: Optional[str],
             amplitude: Optional[float], derivative: int,
             frequency: Optional[float],
             phase: float, time: Optional[float], periods: Optional[int],
             resolve: Optional[float],
             tip: bool, progress: Listener, /) -> Simulation: ...
