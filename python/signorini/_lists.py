"""Families, modes and polytopes: what exists, on no grid."""

from __future__ import annotations

from typing import Literal, overload

from . import _core
from ._blame import named
from ._core import Bar, Family, Mode, ModeMotion, ModePolytope
from ._progress import Progress, listener
from ._tables import Table
from ._words import Number, Steps, bar_of, fraction_of

#: Orders that a few seconds list, by number of contacts.
_USUAL_ORDER = {1: 25, 2: 25, 3: 9, 4: 5}


@named
def families(max_order: int = 12, *, max_energy_ratio: float | None = None,
             bar: Bar | None = None, progress: Progress = None,
             **bar_options: float | None) -> Table[Family]:
    """List all families: every orbit with one contact in a period, once.

    Parameters
    ----------
    max_order : int
        Largest w.
    max_energy_ratio : float, optional
        Only families with a motion of E/E_1 up to it.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    progress : callable of (done, total), bool or tqdm bar, optional

    Returns
    -------
    Table of Family
        By ascending order, nu, contact_blocks; 33 up to order 12.

    Raises
    ------
    ValueError
        If a bound is out of its range.
    """
    units = bar_of(bar, bar_options)
    rows = _core.families(max_order, max_energy_ratio, units,
                          listener(progress))
    scene = _core.Scene(units)
    return Table("families", rows, bar=units, stops=scene.stops,
                 segments=scene.segments, static_force=scene.static_force,
                 complete=True,
                 max_order=max_order, max_energy_ratio=max_energy_ratio,
                 count=len(rows))


@overload
def modes(*, phases: Literal[1] = 1, max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, progress: Progress = None,
          **bar_options: float | None) -> Table[Mode]: ...


@overload
def modes(*, phases: Literal[2, 3, 4, 5], max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, progress: Progress = None,
          **bar_options: float | None) -> Table[ModePolytope]: ...


@named
def modes(*, phases: int = 1, max_order: int | None = None,
          max_energy_ratio: float = 50.0, max_period: float | None = None,
          bar: Bar | None = None, progress: Progress = None,
          **bar_options: float | None) -> Table[Mode] | Table[ModePolytope]:
    """List the continuous families: motions of every period, exact.

    Parameters
    ----------
    phases : int
        K, contacts in a period. With one a mode has one motion of each
        period; with more they fill polytopes, on which the energy depends on
        the period alone.
    max_order : int, optional
        Only contact times p - q T with q up to it (25; with 3, 4, 5 contacts
        9, 5, 3).
    max_energy_ratio : float
        Only with a motion of E/E_1 up to it.
    max_period : float, optional
        Only with a motion of T [L/c] up to it (8, or 4 for each contact).
    progress : callable of (done, total), bool or tqdm bar, optional
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...

    Returns
    -------
    Table of Mode, or of ModePolytope with several contacts
        By ascending order.

    Raises
    ------
    ValueError
        If a bound is out of its range.
    """
    units = bar_of(bar, bar_options)
    order = _USUAL_ORDER.get(phases, 3) if max_order is None else max_order
    period = max(8.0, 4.0 * phases) if max_period is None else max_period
    bounds = {"complete": True, "max_order": order, "max_period_ratio": period,
              "max_energy_ratio": max_energy_ratio}
    words = (order, max_energy_ratio, period, units, listener(progress))
    if phases == 1:
        return Table("modes", _core.modes(*words), bar=units, **bounds)
    return Table("polytopes", _core.polytopes(phases, *words), bar=units,
                 phases=phases, **bounds)


@named
def mode(a4: int, b: int, period: Number | None = None, *,
         bar: Bar | None = None, **bar_options: float | None) -> ModeMotion:
    """Return the motion of one mode at any period.

    Parameters
    ----------
    a4, b : int
        Which mode: t_c = a4 + b T, e.g. 4 and -1.
    period : float, str or Fraction
        T [L/c], inside the interval of the mode.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...

    Returns
    -------
    ModeMotion

    Raises
    ------
    ValueError
        If there is no such mode, or it has no motion of that period.
    """
    found = _core.mode(a4, b, bar_of(bar, bar_options))
    if period is None:
        (p, q), (r, s) = found.period_range
        raise ValueError(f"period is missing: allowed ]{p}/{q}, {r}/{s}[ "
                         "[L/c]")
    exact = fraction_of(period, "period")
    return found.motion(float(exact))


@named
def polytope(*schedule: Steps, cells: int | None = None,
             bar: Bar | None = None, **bar_options: float | None
             ) -> ModePolytope | None:
    """Return the polytope that holds the one motion of a schedule.

    Parameters
    ----------
    *schedule : int, pairs of int, or Schedule
        n_c, n_f of each contact phase in turn; gcd(2N, n) = 1.
    cells : int, optional
        N, cells of the bar (300).
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...

    Returns
    -------
    ModePolytope or None
        None if the schedule has no motion, or one that touches without
        force, or repeats itself.

    Raises
    ------
    ValueError
        If the schedule is invalid, or has another gcd.
    """
    return _core.polytope(schedule, cells, bar_of(bar, bar_options))
