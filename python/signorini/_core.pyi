"""Types of the compiled part. Its docstrings are the documentation."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Optional, Protocol, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._answers import *

Array = NDArray[np.float64]
Quantity = Union[float, str]
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
    def __init__(self, *, length: Quantity = ...,
                 wave_speed: Optional[Quantity] = ...,
                 axial_stiffness: Optional[Quantity] = ..., gap: Quantity = ...,
                 young: Optional[Quantity] = ...,
                 density: Optional[Quantity] = ...,
                 area: Optional[Quantity] = ...) -> None: ...
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
    stops: list[StopPlace]
    segments: list[Segment]
    static_force: float
    second_stop: Optional[float]
    def _scene(self) -> str: ...
    def __init__(self, bar: Bar = ..., second_stop: Optional[Quantity] = ...,
                 segments: Sequence[Segment] = ...) -> None: ...
    @staticmethod
    def of_pieces(pieces: Sequence[tuple[Quantity, Quantity, Quantity, Quantity]], *,
                  gap: Quantity = ..., second_stop: Optional[Quantity] = ...,
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
    _text: str

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

# What is asked is named as the arguments of the functions around the module.
Asked = dict[str, Any]

def options(question: str, /) -> dict[str, str]: ...
def quantity(name: str, text: str, unit: str, /) -> float: ...
def find(asked: Asked, /) -> Result: ...
def question(asked: Asked, sets: Sequence[Result], /) -> dict[str, Any]: ...
def schedules_of_period(cells: int, steps: int, scene: Scene, /
                        ) -> list[Schedule]: ...
def find_forced(asked: Asked, /) -> ForcedResult: ...
def find_harmonic(asked: Asked, /) -> HarmonicResult: ...
def find_harmonic_bars(asked: Asked, /) -> SceneHarmonicResult: ...
def continuum(asked: Asked, /) -> Continuum: ...
def families(asked: Asked, /) -> list[Family]: ...
def families_figure(rows: list[Family], /) -> str: ...
def frequency_energy_figure(max_order: int, left: float, right: float,
                            top: float, /) -> str: ...
def modes(asked: Asked, /) -> Any: ...
def mode(asked: Asked, /) -> Mode: ...
def polytope(asked: Asked, /) -> Optional[ModePolytope]: ...
def build_atlas(asked: Asked, /) -> AtlasRun: ...
def force_range(asked: Asked, /) -> ForceRange: ...
def response(asked: Asked, /) -> ResponseData: ...
def exact_response(asked: Asked, /) -> ExactResponse: ...
def sweep(asked: Asked, /) -> Sweep: ...
def study(asked: Asked, /) -> list[StudyPoint]: ...
def simulate(asked: Asked, /) -> Simulation: ...
