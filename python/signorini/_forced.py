"""Forced and damped motions: the response, and what a bar settles on."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from . import _core
from ._blame import named
from ._core import (Bar, Damping, ForcedFrequency, ForcedMotion, Scene, Simulation,
                    State, Sweep, Waves)
from ._progress import Progress, listener
from ._tables import Table, flat, frame_of, keys_of
from ._words import Segments, amplitude_of, cells_of, scene_of, state_of


class Response(Table[ForcedFrequency]):
    """All motions with one contact in a period, frequency by frequency.

    A sequence of ForcedFrequency. `motions` are all of them in one list.
    """

    _answer: Any  # of which the figure is made

    if TYPE_CHECKING:
        status: str
        found: bool
        complete: bool
        cells: int
        bar: Bar
        damping: Damping
        force: str
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


@named
def response(*, damping: float, force: str, amplitude: float | None = None,
             amplitude_velocity: float | None = None,
             amplitude_acceleration: float | None = None,
             start: float = 0.5, to: float = 2.0, cycles: int = 1,
             cells: int | None = None, stability: bool = False,
             threads: int = 1, bar: Bar | None = None,
             scene: Scene | None = None, second_stop: float | None = None,
             segments: Segments | None = None, progress: Progress = None,
             **bar_options: float | None) -> Response:
    """List every forced motion with one contact, for all periods of a range.

    Parameters
    ----------
    damping : float
        zeta of the first linear mode, > 0.
    force : str
        "tip", a force on the tip, or "base", a base that moves.
    amplitude : float, optional
        Of the force [N] or the base [m].
    amplitude_velocity, amplitude_acceleration : float, optional
        In its place, of the velocity [m/s] or acceleration [m/s^2] of the
        base.
    start, to : float
        Lowest and highest omega/omega_1 of the excitation (the program's
        ``--from`` and ``--to``).
    cycles : int
        Of the excitation in a period of the motion.
    cells : int, optional
        N, cells of the bar: those of all segments, or 300.
    stability : bool
        Perturb each motion to test its stability.
    threads : int
        Most threads to use.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    scene : Scene, optional
        In place of `bar`, `second_stop` and `segments`.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h.
    segments : list of Segment, or of their parameters, optional
        (cells, impedance, speed, dashpot) of each, clamp first.
    progress : callable of (done, total), bool or tqdm bar, optional

    Returns
    -------
    Response
        A Table of ForcedFrequency.

    Raises
    ------
    ValueError
        If an argument is out of its range; the message is the library's.
    """
    whole = scene_of(scene, bar, second_stop, segments, bar_options)
    size, derivative = amplitude_of(force, amplitude, amplitude_velocity,
                                    amplitude_acceleration)
    if size is None:
        raise ValueError("amplitude is missing: allowed numbers > 0 [N or m]")
    data = _core.response(damping, force, size, derivative, start, to, cycles,
                          cells_of(cells, whole) or 300, stability, threads,
                          whole, listener(progress))
    head = {name: value for name, value, _ in keys_of(data)
            if name != "frequencies"}
    table = Response("frequencies", data.frequencies, **head)
    table._answer = data
    return table


@named
def simulate(start: State | Waves | str | None = None, *,
             damping: float = 0.0, force: str | None = None,
             amplitude: float | None = None,
             amplitude_velocity: float | None = None,
             amplitude_acceleration: float | None = None,
             frequency: float | None = None, phase: float = 0.0,
             time: float | None = None,
             periods: int | None = None, resolve: float | None = None,
             cells: int | None = None, tip: bool = True, bar: Bar | None = None,
             scene: Scene | None = None, second_stop: float | None = None,
             progress: Progress = None,
             **bar_options: float | None) -> Simulation:
    """Simulate the bar exactly, event by event.

    Parameters
    ----------
    start : State, Waves or file name, optional
        To start from; at rest without.
    damping : float
        zeta of the first linear mode.
    force : str, optional
        "tip" or "base".
    amplitude : float, optional
        Of the force [N] or the base [m].
    amplitude_velocity, amplitude_acceleration : float, optional
        In its place, of the velocity [m/s] or acceleration [m/s^2] of the
        base.
    frequency : float, optional
        omega/omega_1 of the excitation.
    phase : float
        Of the excitation at the start, cos(omega t - phase) [rad].
    time : float, optional
        How long [s].
    periods : int, optional
        Or how many periods of the excitation.
    resolve : float, optional
        Contacts no further apart are one, and forces are averaged over it
        [s]; a step of the excitation, L/(N c), without.
    cells : int, optional
        Steps of the excitation in L/c (those of the state, 300 at rest).
    tip : bool
        Record the path of the tip.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    scene : Scene, optional
        In place of `bar` and `second_stop`.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h.
    progress : callable of (done, total), bool or tqdm bar, optional

    Returns
    -------
    Simulation

    Raises
    ------
    ValueError
        If an argument is out of its range; the message is the library's.
    """
    if scene is None and bar is None and not bar_options \
            and isinstance(start, State):
        bar = start.bar
    whole = scene_of(scene, bar, second_stop, None, bar_options)
    return _core.simulate(state_of(start, whole.bar, cells), cells, whole,
                          damping, force,
                          *amplitude_of(force, amplitude, amplitude_velocity,
                                        amplitude_acceleration),
                          frequency, phase, time,
                          periods, resolve, tip, listener(progress))


@named
def sweep(over: str = "frequency", start: float = 0.5, to: float = 2.0, *,
          force: str, damping: float = 0.0, amplitude: float | None = None,
          amplitude_velocity: float | None = None,
          amplitude_acceleration: float | None = None,
          frequency: float = 1.0, points: int = 101,
          direction: str = "both", periods: int = 1000, rest: bool = False,
          resolve: float | None = None, cells: int | None = None,
          threads: int = 1, bar: Bar | None = None,
          scene: Scene | None = None, second_stop: float | None = None,
          segments: Segments | None = None,
          file: str | os.PathLike[str] | None = None,
          progress: Progress = None,
          **bar_options: float | None) -> Sweep:
    """Follow what a driven bar settles on while one number is varied.

    Parameters
    ----------
    over : str
        "frequency", "amplitude", "gap" or "damping": what is varied.
    start, to : float
        Lowest and highest value: omega/omega_1, N or m, m, or a ratio.
    force : str
        "tip", a force on the tip, or "base", a base that moves.
    damping : float
        zeta of the first linear mode, unless it is varied.
    amplitude : float, optional
        Of the force [N] or the base [m], unless it is varied.
    amplitude_velocity, amplitude_acceleration : float, optional
        In its place, of the velocity [m/s] or acceleration [m/s^2] of the
        base.
    frequency : float
        omega/omega_1 of the excitation, unless it is varied.
    points : int
        How many values, at equal distances.
    direction : str
        "up", "down" or "both".
    periods : int
        How many periods of the excitation at each value, at most.
    rest : bool
        Start at rest at each value, in place of where the one before ended.
    resolve : float, optional
        Contacts no further apart are one, and forces are averaged over it
        [s]; a step of the excitation, L/(N c), without.
    cells : int, optional
        Steps of the excitation in L/c: those of all segments, or 300.
    threads : int
        Most threads to use: one for each direction, or each value at rest.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    scene : Scene, optional
        In place of `bar`, `second_stop` and `segments`.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h.
    segments : list of Segment, or of their parameters, optional
        (cells, impedance, speed, dashpot) of each, clamp first.
    file : path, optional
        What is done is kept in FILE.part, and a later call with the same
        question goes on from it.
    progress : callable of (done, total), bool or tqdm bar, optional

    Returns
    -------
    Sweep

    Raises
    ------
    ValueError
        If an argument is out of its range; the message is the library's.
    """
    whole = scene_of(scene, bar, second_stop, segments, bar_options)
    size, derivative = amplitude_of(force, amplitude, amplitude_velocity,
                                    amplitude_acceleration)
    asked = (over, start, to, force, damping, 0.0 if size is None else size,
             derivative, frequency, points, direction, periods, rest, resolve,
             cells_of(cells, whole) or 300)
    return _core.sweep(*asked, threads, whole,
                       "" if file is None else os.fspath(file),
                       f"{asked} {whole.to_dict()}", listener(progress))
