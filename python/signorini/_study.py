"""A study: sweeps of frequency over gaps, damping ratios and amplitudes."""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterable, Sequence
from typing import Union

from . import _core
from ._asking import asks
from ._core import Scene, StudyPoint
from ._progress import Progress, listener
from ._tables import Table
from ._words import Force, Quantity, bar_of, number, path

#: One number, or several.
Numbers = Union[Quantity, Sequence[Quantity]]


def _listed(name: str, values: Numbers, unit: str = "") -> list[float]:
    listed = [number(name, value, unit) for value in (
        values if isinstance(values, Iterable) and not isinstance(values, str)
        else [values])]
    if not listed:
        raise ValueError(f"{name} = [] is out of range: allowed one or more")
    return listed


@asks("sweep")
def study(*, gap: Numbers, damping: Numbers, amplitude: Numbers, force: Force,
          start: Quantity = 0.5, to: Quantity = 2.0, points: int = 51,
          periods: int = 1000, cells: int = 100, threads: int = 1,
          second_stop: Quantity | None = None,
          file: str | os.PathLike[str] | None = None,
          progress: Progress = None, **bar_options: Quantity | None
          ) -> Table[StudyPoint]:
    """Sweep the frequency for every gap, damping and amplitude.

    Parameters
    ----------
    gap, damping, amplitude : float or str, or a sequence of them
        Gaps [m], damping ratios, amplitudes of the force [N] or base [m].
    threads : int
        Sweeps at a time.
    file : path, optional
        A table that is whole after each sweep; a later call with the same
        question goes on from it.

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
        _listed("amplitude", amplitude, "m" if force == "base" else "N")))
    scenes = {at: Scene(bar_of(None, {**bar_options, "gap": at}), second_stop)
              for at in dict.fromkeys(place[0] for place in places)}
    points_of = _core.study({
        "cases": [(scenes[at], zeta, size) for at, zeta, size in places],
        "force": force, "start": start, "to": to, "points": points,
        "periods": periods, "cells": cells, "threads": threads,
        "file": None if file is None else path("file", file), "question": asked,
        "progress": listener(progress)})
    return Table("points", points_of, force=force, cells=cells)
