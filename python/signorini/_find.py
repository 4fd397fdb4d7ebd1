"""Motions of a schedule: one, or a curve of them."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, overload

from . import _core
from ._blame import named
from ._core import (Bar, Continuum, ForcedResult, HarmonicResult, Result,
                    Scene, State)
from ._progress import Progress, listener
from ._question import Question, ask, period_of
from ._words import (Number, Segments, Steps, amplitude_of, cells_of, scene_of,
                     state_of)


if TYPE_CHECKING:
    from typing_extensions import TypedDict, Unpack

    class _Parameters(TypedDict, total=False):
        """Of a bar."""

        length: float | None
        wave_speed: float | None
        axial_stiffness: float | None
        gap: float | None
        young: float | None
        density: float | None
        area: float | None

    class _Options(_Parameters, total=False):
        """What any motion can be asked with."""

        cells: int | None
        bar: Bar | None
        scene: Scene | None
        second_stop: float | None
        strain_limit: float | None

    class _Demands(_Options, total=False):
        """What can be asked of a motion that nothing drives."""

        segments: Segments | None
        solver: str
        formulation: str
        objective: str
        target: State | str | None
        energy: float | None
        energy_ratio: float | None
        tip_floor: float | None
        tolerance: float
        time_limit: float | None


@overload
def find(first: Steps, /, *schedule: Steps,
         **demands: Unpack[_Demands]) -> Result: ...


@overload
def find(*, period: Number | None = None, frequency: Number | None = None,
         hertz: float | None = None,
         **demands: Unpack[_Demands]) -> Question: ...


@overload
def find(first: Steps, /, *schedule: Steps, damping: float, force: str,
         segments: Segments | None = None,
         amplitude: float | None = None,
         amplitude_velocity: float | None = None,
         amplitude_acceleration: float | None = None, cycles: int = 1,
         **options: Unpack[_Options]) -> ForcedResult: ...


@overload
def find(*, damping: float, force: str,
         period: Number | None = None, frequency: Number | None = None,
         hertz: float | None = None,
         amplitude: float | None = None,
         amplitude_velocity: float | None = None,
         amplitude_acceleration: float | None = None, cycles: int = 1,
         contacts: int = 1,
         **options: Unpack[_Options]) -> HarmonicResult: ...


@named
def find(
         *schedule: Steps, cells: int | None = None, bar: Bar | None = None,
         scene: Scene | None = None, second_stop: float | None = None,
         segments: Segments | None = None,
         solver: str = "auto", formulation: str = "auto",
         objective: str = "auto", target: State | str | None = None,
         energy: float | None = None, energy_ratio: float | None = None,
         strain_limit: float | None = None, tip_floor: float | None = None,
         tolerance: float = 1e-7, time_limit: float | None = None,
         period: Number | None = None, frequency: Number | None = None,
         hertz: float | None = None,
         damping: float | None = None, force: str | None = None,
         amplitude: float | None = None,
         amplitude_velocity: float | None = None,
         amplitude_acceleration: float | None = None, cycles: int = 1,
         contacts: int = 1,
         **bar_options: float | None
         ) -> Result | Question | ForcedResult | HarmonicResult:
    """Decide a schedule: a verified motion, or the proof that there is none.

    Parameters
    ----------
    *schedule : int, pairs of int, or Schedule
        n_c, n_f of each contact phase in turn.
    cells : int, optional
        N, cells of the bar: those of all segments, or 300.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords: `length`,
        `wave_speed`, `axial_stiffness`, `gap`, `young`, `density`, `area`.
        A gap may be 0, or negative: the bar at rest is pressed.
    scene : Scene, optional
        In place of `bar`, `second_stop` and `segments`.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h. Phases on it are (n_c, n_f, "left").
    segments : list of Segment, or of their parameters, optional
        A stepped bar, clamp first: (cells, impedance, speed, dashpot).
    solver : str
        A back end (`signorini.backends`), or "auto".
    formulation : str
        Unknowns of the problem: "auto", "state", "reduced", "lumped"; of a
        stepped bar "joints", "kernel".
    objective : str
        Which motion: "auto" (least energy; with an energy to hold, least
        peak compression), "any", "min-energy", "max-energy",
        "min-peak-strain", "max-impulse", "nearest".
    target : State or file name, optional
        For "nearest".
    energy, energy_ratio : float, optional
        To hold, in J or in E_1.
    strain_limit : float, optional
        S: strain >= -S everywhere and always [-].
    tip_floor : float, optional
        Lowest displacement of the tip [m].
    tolerance : float
        Largest relative residual.
    time_limit : float, optional
        For a solver [s].
    period, frequency, hertz : float, str or Fraction, optional
        In place of a schedule: all motions of the period T [L/c], of the
        frequency omega/omega_1, or of that of the grid nearest to f [Hz];
        with `damping` and `force` those with one contact under an exact
        harmonic, on no grid, `frequency` being that of the excitation.
    damping : float, optional
        zeta; with `force` it asks for forced, damped motions.
    force : str, optional
        "tip" or "base".
    amplitude : float, optional
        Of the force [N] or the base [m]; without, the least is looked for.
    amplitude_velocity, amplitude_acceleration : float, optional
        In its place, of the velocity [m/s] or acceleration [m/s^2] of the
        base.
    cycles : int
        Of the excitation in a period of the motion.
    contacts : int
        In a period, for a period or frequency with `damping` and `force`; of
        several the motion on which a bar at rest settles.

    Returns
    -------
    Result, Question, ForcedResult or HarmonicResult
        A Question, a sequence of Result, for a period or frequency; a
        ForcedResult where `damping` and `force` are given, and of a period
        or frequency with them a HarmonicResult.

    Raises
    ------
    ValueError
        If an argument is out of its range; the message is the library's.
    BackendUnavailable
        If no solver of this build can do what is asked.
    """
    whole = scene_of(scene, bar, second_stop, segments, bar_options)
    cells = cells_of(cells, whole, schedule)
    units = whole.bar
    if damping is not None or force is not None:
        if damping is None or force is None:
            raise ValueError("damping, force: allowed only together")
        size, derivative = amplitude_of(force, amplitude, amplitude_velocity,
                                        amplitude_acceleration)
        if period is None and frequency is None and hertz is None:
            return _core.find_forced(schedule, cells, whole, damping, force,
                                     size, derivative, cycles, strain_limit)
        if schedule or whole.segments or strain_limit is not None:
            raise ValueError("period, frequency, hertz: allowed with damping "
                             "and force only without a schedule, segments and "
                             "strain_limit")
        if size is None:
            raise ValueError("amplitude is missing: allowed numbers > 0 "
                             "[N or m]")
        exact = period_of({"period": period, "frequency": frequency,
                           "hertz": hertz}, cells, units, cycles)
        return _core.find_harmonic(exact.numerator, exact.denominator, whole,
                                   damping, force, size, derivative, cycles,
                                   contacts)
    if (amplitude, amplitude_velocity, amplitude_acceleration) != (None,) * 3 \
            or cycles != 1:
        raise ValueError("amplitude, cycles: allowed only together with "
                         "damping and force")
    nearest: State | None = None
    if target is not None:
        nearest = state_of(target, units, cells)
    if period is not None or frequency is not None or hertz is not None:
        if schedule:
            raise ValueError("a schedule clashes with period, frequency and "
                             "hertz: allowed one of them")
        return ask({"period": period, "frequency": frequency, "hertz": hertz},
                   cells, whole,
                   (solver, formulation, objective, nearest, energy,
                    energy_ratio, strain_limit, tip_floor, tolerance,
                    time_limit))
    return _core.find(schedule, cells, whole, solver, formulation, objective,
                      nearest, energy, energy_ratio, strain_limit, tip_floor,
                      tolerance, time_limit)


@named
def continuum(*schedule: Steps, energy_ratio: float | None = None,
              energy: float | None = None, cells: int | None = None,
              bar: Bar | None = None, scene: Scene | None = None,
              second_stop: float | None = None, points: int = 201,
              start: State | str | None = None, to: State | str | None = None,
              direction: State | str | None = None, seed: int | None = None,
              sample: bool = False, engine: str = "auto",
              strain_limit: float | None = None, resolution: float = 0.05,
              tolerance: float = 1e-7, progress: Progress = None,
              **bar_options: float | None) -> Continuum:
    """Trace a curve k(lambda) of motions of one schedule and one energy.

    Parameters
    ----------
    *schedule : int, pairs of int, or Schedule
        n_c, n_f of each contact phase in turn.
    energy, energy_ratio : float, optional
        Of every motion, one of them: in J, or in E_1. Without a gap there is
        no E_1: in J.
    cells : int, optional
        N, cells of the bar (300).
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    scene : Scene, optional
        In place of `bar` and `second_stop`; without segments.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h. Phases on it are (n_c, n_f, "left").
    points : int
        Motions along the curve.
    start, to, direction : State or file name, optional
        Both ends of a path, or one and the way to go from there. Without,
        the curve is the split pulse.
    seed : int, optional
        Join two members drawn at random; with `sample`, which ones.
    sample : bool
        Motions spread over the whole set in place of a curve.
    engine : str
        "auto", "geometric", "ipopt", "nlopt", or a back end.
    strain_limit : float, optional
        S: strain >= -S everywhere and always [-].
    resolution : float
        How far neighbours may be apart on a curve by programs [sqrt(E/E_1)].
    tolerance : float
        Largest relative residual.
    progress : callable of (done, total), bool or tqdm bar, optional

    Returns
    -------
    Continuum
        A sequence of ContinuumPoint.

    Raises
    ------
    ValueError
        If an argument is out of its range; the message is the library's.
    BackendUnavailable
        If no solver of this build can do what is asked.
    """
    whole = scene_of(scene, bar, second_stop, None, bar_options)
    units = whole.bar
    if seed is not None and not 0 <= operator.index(seed) < 2 ** 64:
        raise ValueError(f"seed = {seed} is out of range: allowed whole "
                         "numbers 0..2^64 - 1")
    return _core.continuum(schedule, cells, whole, energy_ratio, energy, points,
                           state_of(start, units, cells),
                           state_of(to, units, cells),
                           state_of(direction, units, cells), seed,
                           sample, engine, strain_limit, resolution,
                           tolerance, listener(progress))
