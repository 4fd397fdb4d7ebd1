"""Families, modes and polytopes: what exists, on no grid."""

from __future__ import annotations

from typing import Any, Literal, overload

from . import _core
from ._asking import asks
from ._core import Bar, Family, Mode, ModeMotion, ModePolytope
from ._progress import Progress, listener
from ._tables import Table
from ._words import Number, Quantity, Steps, bar_of, fraction_of, number, schedule_of


def _table(answer: dict[str, Any]) -> Table[Any]:
    """A list of the program's: its last key has the rows."""
    name, rows = answer.popitem()
    return Table(name, rows, **answer)


@asks("families")
def families(max_order: int = 12, *, max_energy_ratio: float | None = None,
             bar: Bar | None = None, gravity: Quantity = 0.0, progress: Progress = None,
             **bar_options: Quantity | None) -> Table[Family]:
    """List all families: every orbit with one contact in a period, once.

    Returns
    -------
    Table of Family
        By ascending order, nu, contact_blocks; 33 up to order 12.
    """
    return _table(_core.families(
        {**locals(), "bar": bar_of(bar, bar_options), "progress": listener(progress)}))


@overload
def modes(*, phases: Literal[1] = 1, max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, gravity: Quantity = 0.0, progress: Progress = None,
          **bar_options: Quantity | None) -> Table[Mode]: ...


@overload
def modes(*, phases: Literal[2, 3, 4, 5], max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, gravity: Quantity = 0.0, progress: Progress = None,
          **bar_options: Quantity | None) -> Table[ModePolytope]: ...


@asks("modes")
def modes(*, phases: int = 1, max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, gravity: Quantity = 0.0, progress: Progress = None,
          **bar_options: Quantity | None) -> Table[Mode] | Table[ModePolytope]:
    """List the continuous families: motions of every period, exact.

    With one contact a mode has one motion of each period; with more they fill
    polytopes, on which the energy depends on the period alone.

    Returns
    -------
    Table of Mode, or of ModePolytope with several contacts
        By ascending order.
    """
    return _table(_core.modes(
        {**locals(), "bar": bar_of(bar, bar_options), "progress": listener(progress)}))


@asks("mode")
def mode(a4: int, b: int, period: Number | None = None, *,
         bar: Bar | None = None, gravity: Quantity = 0.0,
         **bar_options: Quantity | None) -> ModeMotion:
    """Return the motion of one mode at any period.

    Parameters
    ----------
    a4, b : int
        Which mode: t_c = a4 + b T, e.g. 4 and -1.
    period : float, str or Fraction
        T [L/c], inside the interval of the mode.

    Returns
    -------
    ModeMotion
        Under gravity of the whole bar: the shape at rest is added.

    Raises
    ------
    ValueError
        If there is no such mode, or it has no motion of that period.
    """
    gravity = number("gravity", gravity)
    found = _core.mode({"a4": a4, "b": b, "bar": bar_of(bar, bar_options), "gravity": gravity})
    if period is None:
        (p, q), (r, s) = found.period_range
        raise ValueError(f"period is missing: allowed ]{p}/{q}, {r}/{s}[ "
                         "[L/c]")
    exact = fraction_of(period, "period")
    return found.motion(float(exact), gravity)


@asks("find")
def polytope(*schedule: Steps, cells: int | None = None,
             bar: Bar | None = None, **bar_options: Quantity | None
             ) -> ModePolytope | None:
    """Return the polytope that holds the one motion of a schedule.

    Parameters
    ----------
    *schedule : int, pairs of int, or Schedule
        n_c, n_f of each contact phase in turn; gcd(2N, n) = 1.

    Returns
    -------
    ModePolytope or None
        None if the schedule has no motion, or one that touches without
        force, or repeats itself.
    """
    units = bar_of(bar, bar_options)
    return _core.polytope({"schedule": schedule_of(schedule, cells), "cells": cells, "bar": units})
