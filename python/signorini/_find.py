"""Motions of a schedule: one, or a curve of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

from . import _core
from ._asking import as_bars, asks, gathered, scheduled
from ._core import (Bar, Continuum, ForcedResult, HarmonicResult, Result,
                    Scene, SceneContinuum, SceneContinuumPoint, SceneForcedResult,
                    SceneHarmonicResult, SceneQuestion, SceneResult, State)
from ._progress import Progress
from ._question import (OF_FREE, Question, ask, ask_bars, continuum_of_bars, find_bars,
                        find_harmonic, refuse)
from ._words import Force, Number, Objective, Quantity, Segments, Steps, in_words, whole


if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import (CurveOfBar, CurveOfSegments, CurveOfWords, Demands,
                            DemandsOfBars, Forced, ForcedBars)


@overload
def find(first: Steps, /, *schedule: Steps, **demands: Unpack[Demands]) -> Result: ...


@overload
def find(*, period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None, **demands: Unpack[Demands]) -> Question: ...


@overload
def find(first: Steps, /, *schedule: Steps, segments: Segments | None = None,
         stability: bool = False, **forced: Unpack[Forced]) -> ForcedResult: ...


@overload
def find(*, period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None, contacts: int = 1,
         **forced: Unpack[Forced]) -> HarmonicResult: ...


@overload
def find(*, segments: Segments, period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None, **forced: Unpack[Forced]) -> SceneHarmonicResult: ...


@overload
def find(first: int | str, /, *schedule: int | str,
         **demands: Unpack[DemandsOfBars]) -> SceneResult: ...


@overload
def find(*, period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None,
         **demands: Unpack[DemandsOfBars]) -> SceneQuestion: ...


@overload
def find(first: int | str, /, *schedule: int | str, stability: bool = False,
         **forced: Unpack[ForcedBars]) -> SceneForcedResult: ...


@overload
def find(*, period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None,
         **forced: Unpack[ForcedBars]) -> SceneHarmonicResult: ...


@overload
def find(*schedule: Steps | str, gravity: Quantity, damping: Quantity | None = None,
         force: Force | None = None, period: Number | None = None,
         frequency: Number | None = None, hertz: Quantity | None = None,
         amplitude: Quantity | None = None, amplitude_velocity: Quantity | None = None,
         amplitude_acceleration: Quantity | None = None, cycles: int = 1,
         **demands: Unpack[Demands]
         ) -> SceneResult | SceneForcedResult | SceneHarmonicResult | SceneQuestion: ...


@asks("find")
def find(
         *schedule: Steps | str, cells: int | None = None, bar: Bar | None = None,
         scene: Scene | str | None = None, gravity: Quantity = 0.0,
         second_stop: Quantity | None = None,
         segments: Segments | None = None,
         solver: str = "auto", formulation: str = "auto",
         objective: Objective = "auto", target: State | str | None = None,
         energy: Quantity | None = None, energy_ratio: float | None = None,
         strain_limit: Quantity | None = None, tip_floor: Quantity | None = None,
         tolerance: Quantity = 1e-7, time_limit: Quantity | None = None,
         period: Number | None = None, frequency: Number | None = None,
         hertz: Quantity | None = None,
         damping: Quantity | None = None, force: Force | None = None,
         amplitude: Quantity | None = None,
         amplitude_velocity: Quantity | None = None,
         amplitude_acceleration: Quantity | None = None, cycles: int = 1,
         contacts: int = 1, stability: bool = False,
         **bar_options: Quantity | None
         ) -> (Result | Question | ForcedResult | HarmonicResult
               | SceneResult | SceneForcedResult | SceneHarmonicResult | SceneQuestion):
    """Decide a schedule: a verified motion, or the proof that there is none.

    With `period`, `frequency` or `hertz` in place of a schedule all motions of
    that period on the grid. With `damping` and `force` forced, damped motions:
    of a schedule, the least amplitude or those of one; of a period or frequency
    those with `contacts` contacts under an exact harmonic, on no grid: of one
    contact all, of several the one on which bars at rest settle. Of several
    bars in a row (`scene` in words) a schedule is n_c, n_f, ... at one contact, or
    words "SET:STEPS": ``find("1:4", "1+2:1", "-:9", scene=...)``.

    Parameters
    ----------
    gravity : float, optional
        To the right along all bars [m/s^2]; one bar under it is answered as
        several bars are.
    target : State or file name, optional
        For the objective "nearest"; of several bars the name of a file.
    frequency : float, str or Fraction, optional
        omega/omega_1 of the motion; with `damping` and `force` that of the
        excitation.
    damping : float, optional
        zeta; with `force` it asks for forced, damped motions.
    amplitude : float, optional
        Of the force [N] or the base [m]; without, the least is looked for.

    Returns
    -------
    Result, Question, ForcedResult, HarmonicResult
        A Question, a sequence of Result, for a period or frequency; a
        ForcedResult where `damping` and `force` are given, and of a period
        or frequency with them a HarmonicResult. Of several bars likewise a
        SceneResult, SceneForcedResult or SceneHarmonicResult, and of a period
        without force, as of one bar of several segments, a SceneQuestion.
    """
    asked = gathered(locals(), "target")
    where = asked["scene"]
    if (damping is None) != (force is None) and not in_words(scene):
        raise ValueError("damping, force: allowed only together")
    is_timed = period is not None or frequency is not None or hertz is not None
    times = {"period": period, "frequency": frequency, "hertz": hertz} if is_timed else {}
    if is_timed and stability is not False and force is not None:
        raise ValueError("stability: allowed of a schedule, or without force")
    if "words" in asked:
        return find_bars(asked, times, find.__kwdefaults__)
    if force is not None:
        if is_timed and schedule:
            raise ValueError("period, frequency, hertz: allowed with damping "
                             "and force only without a schedule")
        if is_timed and where.segments:
            return find_bars(as_bars(asked), times, find.__kwdefaults__)
        refuse(asked, find.__kwdefaults__, (*OF_FREE, "tip_floor", "formulation"), "without force")
        if not is_timed:
            refuse(asked, find.__kwdefaults__, ("contacts",), "of a period")
            return _core.find_forced(scheduled(asked))
        return find_harmonic(asked, times)
    has_none = amplitude is amplitude_velocity is amplitude_acceleration is None
    if not has_none or (
            (type(cycles) is not int or cycles != 1) and whole("cycles", cycles) != 1):
        raise ValueError("amplitude, cycles: allowed only together with "
                         "damping and force")
    if contacts != 1:
        raise ValueError("contacts: allowed only of a period, together with damping and force")
    if is_timed and schedule:
        raise ValueError("a schedule clashes with period, frequency and "
                         "hertz: allowed one of them")
    if not is_timed:
        return _core.find(scheduled(asked))
    if not where.segments:
        return ask(times, asked)
    refuse(asked, find.__kwdefaults__, ("tip_floor", "formulation"),
           "of a schedule, or without segments")
    return ask_bars(times, asked)


@overload
def continuum(*schedule: Steps, scene: Scene | None = None,
              **asked: Unpack[CurveOfBar]) -> Continuum: ...


@overload
def continuum(*schedule: int | str, **asked: Unpack[CurveOfWords]) -> SceneContinuum: ...


@overload
def continuum(*schedule: Steps, segments: Segments, gravity: Quantity = 0.0,
              **asked: Unpack[CurveOfSegments]) -> SceneContinuum: ...


@overload
def continuum(*schedule: Steps, gravity: Quantity, scene: Scene | None = None,
              **asked: Unpack[CurveOfSegments]) -> Continuum | SceneContinuum: ...


@asks("continuum")
def continuum(*schedule: Steps | str, energy_ratio: float | None = None,
              energy: Quantity | None = None, cells: int | None = None,
              bar: Bar | None = None, scene: Scene | str | None = None,
              gravity: Quantity = 0.0, second_stop: Quantity | None = None,
              segments: Segments | None = None, points: int = 201,
              start: State | SceneContinuumPoint | str | None = None,
              to: State | SceneContinuumPoint | str | None = None,
              direction: State | SceneContinuumPoint | str | None = None,
              seed: int | None = None,
              sample: bool = False, engine: str = "auto",
              strain_limit: Quantity | None = None, resolution: Quantity = 0.05,
              tolerance: Quantity = 1e-7, progress: Progress = None,
              **bar_options: Quantity | None) -> Continuum | SceneContinuum:
    """Trace a curve k(lambda) of motions of one schedule and one energy.

    Parameters
    ----------
    energy, energy_ratio : float, optional
        Of every motion, one of them: in J, or in E_1. Without a gap there is
        no E_1: in J.
    start, to, direction : State or file name, optional
        Both ends of a path, or one and the way to go from there: of several
        bars, or segments, points of another curve. Without, the curve is the
        split pulse, of several bars a path between two members.
    sample : bool
        Motions spread over the whole set in place of a curve.

    Returns
    -------
    Continuum
        A sequence of ContinuumPoint; of several bars, and of one of segments or
        under gravity, a SceneContinuum, one of SceneContinuumPoint.
    """
    asked = gathered(locals(), "start", "to", "direction", segments_are_bars=True)
    if "words" in asked:
        return continuum_of_bars(asked)
    return _core.continuum(scheduled(asked))
