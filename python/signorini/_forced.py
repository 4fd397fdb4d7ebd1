"""Forced and damped motions: the response, and what a bar settles on."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

from . import _core
from ._asking import as_bars, asks, gathered
from ._core import (Bar, Damping, ExactResponse, ForcedFrequency, ForcedMotion, ForceRange, Scene,
                    SceneResponse, SceneSimulation, Simulation, State, Sweep, Waves)
from ._progress import Progress
from ._tables import Table, flat, frame_of, keys_of
from ._words import Force, Over, Quantity, Segments

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import (DrivenBar, DrivenBars, ExactRange, Range, RangeOfBars, StepRange,
                            StepRangeOfBars)


class Response(Table[ForcedFrequency]):
    """All motions with one contact in a period, frequency by frequency.

    A sequence of ForcedFrequency. `motions` are all of them in one list.
    """

    _answer: Any  # of which the figure is made

    if TYPE_CHECKING:
        status: str
        complete: bool
        cells: int
        bar: Bar
        damping: Damping
        force: Force
        amplitude: float
        frequency_ratio_range: tuple[float, float]
        frequencies: list[ForcedFrequency]

    @property
    def motions(self) -> list[tuple[ForcedFrequency, ForcedMotion]]:
        """[(frequency, motion), ...]."""
        return [(at, motion) for at in self for motion in at.motions]

    def _rows_of_frame(self) -> Iterator[dict[str, Any]]:
        for at in self:
            head = flat(at)
            del head["motions"]
            for motion in at.motions:
                yield {**head, **flat(motion), "stable": motion.stable}
            if not at.motions:
                yield head

    def frame(self) -> Any:
        """Return a pandas DataFrame: a row for each motion.

        Frequencies without a motion have one row.
        """
        return frame_of(self._rows_of_frame())


@overload
def response(*, scene: Scene | None = None, segments: Segments | None = None,
             **asked: Unpack[StepRange]) -> Response: ...


@overload
def response(**asked: Unpack[StepRangeOfBars]) -> SceneResponse: ...


@overload
def response(*, gravity: Quantity, scene: Scene | None = None, segments: Segments | None = None,
             **asked: Unpack[StepRange]) -> SceneResponse: ...


@asks("response")
def response(*, damping: Quantity | None = None, force: Force, amplitude: Quantity | None = None,
             amplitude_velocity: Quantity | None = None,
             amplitude_acceleration: Quantity | None = None,
             start: Quantity = 0.5, to: Quantity = 2.0, cycles: int = 1,
             contacts: int = 1, band: Quantity | None = None,
             cells: int | None = None, stability: bool = False,
             threads: int = 1, bar: Bar | None = None,
             scene: Scene | str | None = None, gravity: Quantity = 0.0,
             second_stop: Quantity | None = None,
             segments: Segments | None = None, progress: Progress = None,
             **bar_options: Quantity | None) -> Response | SceneResponse:
    """List every forced motion with one contact, or two, for all periods of a range.

    The force goes in steps; `exact_response` takes the harmonic itself.

    Parameters
    ----------
    contacts : int
        Most in a period. 2: also every schedule with two, each at its own amplitude.
    band : number
        Largest deviation of that amplitude from the one asked for, relative (0.05).
    stability : bool
        Perturb each motion to test its stability.

    Returns
    -------
    Response, or of several bars SceneResponse
        The first is a Table of ForcedFrequency.
    """
    asked = _of_bars(gathered(locals()))
    if "words" in asked:
        return _core.response_bars({**asked, "exact": False})
    data = _core.response(asked)
    head = {name: value for name, value, _ in keys_of(data)
            if name != "frequencies"}
    table = Response("frequencies", data.frequencies, **head)
    table._answer = data
    return table


def _of_bars(asked: dict[str, Any]) -> dict[str, Any]:
    """The same, without what clashes. ValueError."""
    if "words" in asked and (asked["damping"] is not None or asked["cells"] is not None):
        raise ValueError("damping, cells: allowed only without a scene of words "
                         "(dash=D among them)")
    if asked.get("contacts") not in (None, 1, 2):
        raise ValueError(f"contacts = {asked['contacts']} is out of range: allowed 1, 2")
    return asked


@overload
def exact_response(*, amplitude: Quantity, scene: Scene | None = None,
                   **asked: Unpack[ExactRange]) -> ExactResponse: ...


@overload
def exact_response(**asked: Unpack[RangeOfBars]) -> SceneResponse: ...


@overload
def exact_response(*, segments: Segments, **asked: Unpack[Range]) -> SceneResponse: ...


@overload
def exact_response(*, gravity: Quantity, scene: Scene | None = None,
                   segments: Segments | None = None,
                   **asked: Unpack[Range]) -> SceneResponse: ...


@asks("response")
def exact_response(*, damping: Quantity | None = None, force: Force,
                   amplitude: Quantity | None = None,
                   amplitude_velocity: Quantity | None = None,
                   amplitude_acceleration: Quantity | None = None,
                   start: Quantity = 0.5, to: Quantity = 2.0, cycles: int = 1,
                   contacts: int = 1, cells: int | None = None,
                   threads: int = 1, bar: Bar | None = None,
                   scene: Scene | str | None = None, gravity: Quantity = 0.0,
                   second_stop: Quantity | None = None,
                   segments: Segments | None = None, progress: Progress = None,
                   **bar_options: Quantity | None) -> ExactResponse | SceneResponse:
    """List motions under an exact harmonic over a range, and the curves they lie on.

    Parameters
    ----------
    contacts : int
        Most in a period, of several bars or segments. 2: also the motion with two
        on which they settle from rest. Of a uniform bar what it settles on is listed
        anyway, where no motion with one contact is known to attract.

    Returns
    -------
    ExactResponse, or of several bars or segments SceneResponse
        The latter has no curves.
    """
    asked = _of_bars(gathered(locals()))
    if "words" not in asked and len(asked["scene"].segments) > 1:
        as_bars(asked)
    if "words" in asked:
        return _core.response_bars({**asked, "exact": True, "stability": False})
    return _core.exact_response(asked)


@overload
def simulate(start: State | Waves | str | None = None, *, resolve: Quantity | None = None,
             tip: bool = True, **asked: Unpack[DrivenBar]) -> Simulation: ...


@overload
def simulate(start: str | None = None, *, velocity: Sequence[Quantity] | None = None,
             **asked: Unpack[DrivenBars]) -> SceneSimulation: ...


@overload
def simulate(start: str | None = None, *, gravity: Quantity,
             velocity: Sequence[Quantity] | None = None,
             **asked: Unpack[DrivenBar]) -> SceneSimulation: ...


@asks("simulate")
def simulate(start: State | Waves | str | None = None, *,
             damping: Quantity = 0.0, force: Force | None = None,
             amplitude: Quantity | None = None,
             amplitude_velocity: Quantity | None = None,
             amplitude_acceleration: Quantity | None = None,
             frequency: Quantity | None = None, phase: Quantity = 0.0,
             time: Quantity | None = None,
             periods: int | None = None, resolve: Quantity | None = None,
             cells: int | None = None, tip: bool = True, bar: Bar | None = None,
             scene: Scene | str | None = None, gravity: Quantity = 0.0,
             velocity: Sequence[Quantity] | None = None,
             second_stop: Quantity | None = None,
             progress: Progress = None,
             **bar_options: Quantity | None) -> Simulation | SceneSimulation:
    """Simulate a bar, or several in a row, exactly, event by event.

    Parameters
    ----------
    start : State, Waves or file name, optional
        To start from; at rest without.
    cells : int, optional
        Steps of the excitation in L/c (those of the state, 300 at rest).
    tip : bool
        Record the path of the tip; of several bars those at the contacts.
    scene : Scene or str, optional
        In place of `bar` and `second_stop`; or the words of several bars in
        a row, "clamp 60 gap=1e-3 40 driven dash=0.1 20 clamp", whose scales
        are `length`, `wave_speed` and `axial_stiffness`.
    velocity : list of float or str, optional
        Of each of several bars at the start [m/s], in place of `start`.

    Returns
    -------
    Simulation, or of several bars SceneSimulation
    """
    if scene is None and bar is None and not bar_options \
            and isinstance(start, State):
        bar = start.bar
    asked = gathered(locals(), "start")
    several = "words" in asked
    if several and (asked["damping"] or asked["cells"] is not None or resolve is not None):
        raise ValueError("damping, cells, resolve: allowed only without a scene of words "
                         "(dash=D among them)")
    if not several and velocity is not None:
        raise ValueError("velocity: allowed only with a scene of words, or gravity")
    if asked["scene"].segments:
        raise ValueError("segments: allowed only where stepped bars are known: find")
    return _core.simulate_bars(asked) if several else _core.simulate(asked)


@asks("sweep")
def sweep(over: Over = "frequency", start: Quantity = 0.5, to: Quantity = 2.0, *,
          force: Force, damping: Quantity = 0.0, amplitude: Quantity | None = None,
          amplitude_velocity: Quantity | None = None,
          amplitude_acceleration: Quantity | None = None,
          frequency: Quantity = 1.0, points: int = 101,
          direction: str = "both", periods: int = 1000, rest: bool = False,
          resolve: Quantity | None = None, cells: int | None = None,
          threads: int = 1, bar: Bar | None = None,
          scene: Scene | str | None = None, gravity: Quantity = 0.0,
          second_stop: Quantity | None = None, segments: Segments | None = None,
          file: str | os.PathLike[str] | None = None,
          progress: Progress = None,
          **bar_options: Quantity | None) -> Sweep:
    """Follow what a driven bar settles on while one number is varied.

    Parameters
    ----------
    direction : str
        "up", "down" or "both".
    cells : int, optional
        Steps of the excitation in L/c: those of all segments, or 300.
    threads : int
        Most threads to use: one for each direction, or each value at rest.
    file : path, optional
        What is done is kept in FILE.part, and a later call with the same
        question goes on from it.

    Returns
    -------
    Sweep
    """
    asked = gathered(locals())
    if "words" in asked and asked["cells"] is not None:
        raise ValueError("cells: allowed only without a scene of words")
    if str(over) in ("frequency", "damping"):
        asked[over] = None  # what it is without is not said
    question = {name: value for name, value in asked.items()
                if name not in ("file", "threads", "progress", "scene", "bar",
                                "bar_options", "second_stop", "segments")}
    return _core.sweep(
        {**asked, "question": f"{question} {asked['scene'].to_dict()}"})


@asks("simulate")
def force_range(scene: Scene | str, low: Quantity, high: Quantity, *, time: Quantity,
                gravity: Quantity = 0.0, bar: Bar | None = None,
                **bar_options: Quantity | None) -> ForceRange:
    """Return what any force between two bounds can do to bars at rest.

    Until a contact first closes, proved for all forces at once, and reached
    by one of them in a simulation.

    Parameters
    ----------
    scene : str
        Bars in a row, "clamp 7 stop=1 3 driven".
    low, high : float
        Between which the force on what is driven is [N].
    time : float
        How long [s].

    Returns
    -------
    ForceRange
    """
    return _core.force_range(gathered(locals()))
