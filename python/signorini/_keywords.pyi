"""Keywords that overloads share. Type checkers alone read this file."""

from typing_extensions import Required, TypedDict

from ._core import Bar, Scene, SceneContinuumPoint, State
from ._progress import Progress
from ._words import Force, Objective, Quantity, Segments

class Parameters(TypedDict, total=False):
    """Of a bar, or the scales of several."""

    length: Quantity | None
    wave_speed: Quantity | None
    axial_stiffness: Quantity | None
    gap: Quantity | None
    young: Quantity | None
    density: Quantity | None
    area: Quantity | None
    diameter: Quantity | None

class OneBar(Parameters, total=False):
    """Asked about."""

    cells: int | None
    bar: Bar | None
    second_stop: Quantity | None

class Bars(Parameters, total=False):
    """Several in a row, in words."""

    scene: Required[str]
    gravity: Quantity

class Amplitudes(TypedDict, total=False):
    """Of an excitation, one of them."""

    amplitude: Quantity | None
    amplitude_velocity: Quantity | None
    amplitude_acceleration: Quantity | None

class Excitation(Amplitudes, total=False):
    """A harmonic one, with so many cycles in a period of the motions."""

    force: Required[Force]
    cycles: int

class Wish(TypedDict, total=False):
    """What can be asked of a motion that nothing drives, of one bar or of several."""

    solver: str
    objective: Objective
    energy: Quantity | None
    energy_ratio: float | None
    strain_limit: Quantity | None
    tolerance: Quantity
    time_limit: Quantity | None
    stability: bool

class Demands(Wish, OneBar, total=False):
    """The same of one bar."""

    scene: Scene | None
    segments: Segments | None
    formulation: str
    target: State | str | None
    tip_floor: Quantity | None

class DemandsOfBars(Wish, Bars, total=False):
    """The same of several."""

    target: str | None

class Forced(Excitation, OneBar, total=False):
    """What can be asked of a forced motion of one bar."""

    damping: Required[Quantity]
    scene: Scene | None
    strain_limit: Quantity | None

class ForcedBars(Excitation, Bars, total=False):
    """The same of several."""

    strain_limit: Quantity | None

class Curve(TypedDict, total=False):
    """What can be asked of a curve."""

    energy_ratio: float | None
    energy: Quantity | None
    points: int
    seed: int | None
    sample: bool
    engine: str
    strain_limit: Quantity | None
    resolution: Quantity
    tolerance: Quantity
    progress: Progress

class CurveOfBar(Curve, OneBar, total=False):
    """Between states."""

    start: State | str | None
    to: State | str | None
    direction: State | str | None

class CurveOfBars(Curve, total=False):
    """Between points of another curve."""

    start: SceneContinuumPoint | str | None
    to: SceneContinuumPoint | str | None
    direction: SceneContinuumPoint | str | None

class CurveOfWords(CurveOfBars, Bars): ...

class CurveOfSegments(CurveOfBars, OneBar): ...

class Frequencies(TypedDict, total=False):
    """A range of them, and how one goes through it."""

    force: Required[Force]
    start: Quantity
    to: Quantity
    cycles: int
    contacts: int
    threads: int
    progress: Progress

class ExactRange(Frequencies, OneBar, total=False):
    """Of one bar."""

    damping: Required[Quantity]

class Range(ExactRange, Amplitudes): ...

class RangeOfBars(Frequencies, Amplitudes, Bars): ...

class InSteps(TypedDict, total=False):
    """What can be asked of motions under a harmonic that goes in steps."""

    band: Quantity | None
    stability: bool

class StepRange(Range, InSteps): ...

class StepRangeOfBars(RangeOfBars, InSteps): ...

class Driven(Amplitudes, total=False):
    """What drives a simulation, and how long."""

    force: Force | None
    frequency: Quantity | None
    phase: Quantity
    time: Quantity | None
    periods: int | None
    progress: Progress

class DrivenBar(Driven, OneBar, total=False):
    """One bar."""

    damping: Quantity
    scene: Scene | None

class DrivenBars(Driven, Bars): ...
