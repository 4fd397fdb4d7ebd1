"""A study: sweeps of frequency over gaps, damping ratios and amplitudes."""

from __future__ import annotations

import csv
import dataclasses
import itertools
import os
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Union

from ._core import Scene, Sweep
from ._forced import sweep
from ._progress import Progress, listener
from ._tables import Table
from ._words import bar_of

#: One number, or several.
Numbers = Union[float, Sequence[float]]


@dataclasses.dataclass(frozen=True)
class StudyPoint:
    """The worst of one sweep of frequency, both directions.

    SI units; frequencies in Hz.
    """

    gap: float
    damping: float
    amplitude: float
    #: Largest in a period of the excitation, and where; 0: it never touches.
    impulse: float
    frequency: float
    #: Largest, averaged over the resolution.
    mean_force: float
    #: Largest over all x and t; None where it is not known.
    peak_strain: float | None
    peak_stress: float | None
    #: Lowest and highest frequency with contact, if there is any.
    rattles_from: float | None
    rattles_to: float | None
    #: Share of values and directions at which no repetition was seen.
    irregular: float

    def to_dict(self) -> dict[str, Any]:
        """The same as a dictionary."""
        return dataclasses.asdict(self)


def _point(gap: float, damping: float, amplitude: float, seen: Sweep
           ) -> StudyPoint:
    points = seen.points
    worst = max(points, key=lambda point: point.impulse_range[1])
    touching = [point.frequency for point in points if point.contacts > 0]
    strains = [p.peak_strain for p in points if p.peak_strain is not None]
    stresses = [p.peak_stress for p in points if p.peak_stress is not None]
    return StudyPoint(
        gap, damping, amplitude, worst.impulse_range[1], worst.frequency,
        max(point.mean_force for point in points),
        max(strains, default=None), max(stresses, default=None),
        min(touching, default=None), max(touching, default=None),
        sum(point.periods is None for point in points) / len(points))


_NAMES = [field.name for field in dataclasses.fields(StudyPoint)]


def _write(path: Path, asked: str, points: Sequence[StudyPoint]) -> None:
    """The whole table, in place of what was there."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=path.name)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            file.write(f"# {asked}\n")
            rows = csv.writer(file)
            rows.writerow(_NAMES)
            rows.writerows([["" if value is None else repr(value)
                             for value in point.to_dict().values()]
                            for point in points])
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise


def _read(path: Path, asked: str) -> list[StudyPoint]:
    """What an earlier run of the same question left."""
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        said = file.readline()
        rows = csv.reader(file)
        if said != f"# {asked}\n" or next(rows, None) != _NAMES:
            raise ValueError(f"file = {str(path)!r} is of another study: "
                             "allowed a new one, or one of this question")
        try:
            return [StudyPoint(*(float(word) if word else None  # type: ignore
                                 for word in row)) for row in rows]
        except (TypeError, ValueError):
            raise ValueError(f"file = {str(path)!r} is damaged") from None


def _listed(name: str, values: Numbers) -> list[float]:
    listed = [float(value) for value in (
        values if isinstance(values, Sequence) else [values])]
    if not listed:
        raise ValueError(f"{name} = [] is out of range: allowed one or more")
    return listed


def study(*, gap: Numbers, damping: Numbers, amplitude: Numbers, force: str,
          start: float = 0.5, to: float = 2.0, points: int = 51,
          periods: int = 1000, cells: int = 100, threads: int = 1,
          second_stop: float | None = None,
          file: str | os.PathLike[str] | None = None,
          progress: Progress = None, **bar_options: float | None
          ) -> Table[StudyPoint]:
    """Sweep the frequency for every gap, damping and amplitude.

    Parameters
    ----------
    gap, damping, amplitude : float or sequence of float
        Gaps [m], damping ratios, amplitudes of the force [N] or base [m].
    force : str
        "tip", a force on the tip, or "base", a base that moves.
    start, to : float
        Lowest and highest omega/omega_1 of each sweep.
    points, periods, cells : int
        As of `sweep`.
    threads : int
        Sweeps at a time.
    second_stop : float, optional
        h [m]: a stop at u(L) = -h.
    file : path, optional
        A table that is whole after each sweep; a later call with the same
        question goes on from it.
    progress : callable of (done, total), bool or tqdm bar, optional
    **bar_options
        `length`, `wave_speed`, `axial_stiffness`, or `young`, `density` and
        `area`.

    Returns
    -------
    Table of StudyPoint
        In the order gap, damping, amplitude, the last fastest.

    Raises
    ------
    ValueError
        If an argument is out of its range, or the file is of another study.
    """
    asked = repr((force, start, to, points, periods, cells, second_stop,
                  sorted(bar_options.items())))
    places = list(itertools.product(
        _listed("gap", gap), _listed("damping", damping),
        _listed("amplitude", amplitude)))
    path = None if file is None else Path(file)
    known = {} if path is None else {
        (p.gap, p.damping, p.amplitude): p for p in _read(path, asked)}
    tell = listener(progress)
    scenes = {at[0]: Scene(bar_of(None, {**bar_options, "gap": at[0]}),
                           second_stop) for at in places}

    def work(at: tuple[float, float, float]) -> StudyPoint:
        seen = sweep("frequency", start, to, force=force, damping=at[1],
                     amplitude=at[2], points=points, periods=periods,
                     cells=cells, scene=scenes[at[0]])
        return _point(*at, seen)

    missing = [at for at in places if at not in known]
    with ThreadPoolExecutor(max(1, threads)) as pool:
        try:
            for at, point in zip(missing, pool.map(work, missing)):
                known[at] = point
                if path is not None:
                    _write(path, asked, list(known.values()))
                if tell is not None:
                    tell(len(known), len(places))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return Table("points", [known[at] for at in places], force=force,
                 cells=cells)
