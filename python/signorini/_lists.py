"""Families and modes: what exists, on no grid."""

from __future__ import annotations

from . import _core
from ._core import Bar, Family, Mode, ModeMotion
from ._progress import Progress, listener
from ._tables import Table
from ._words import Number, bar_of, fraction_of


def families(max_order: int = 12, *, max_energy_ratio: float | None = None,
             bar: Bar | None = None, progress: Progress = None,
             **bar_options: float) -> Table[Family]:
    """List all families: every orbit with one contact in a period, once.

    Parameters
    ----------
    max_order : int
        Largest w.
    max_energy_ratio : float, optional
        Only families with a motion of E/E_1 up to it.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    progress : callable, bool or tqdm bar, optional
        Called with (done, total).

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
    return Table("families", rows, bar=units, complete=True,
                 max_order=max_order, max_energy_ratio=max_energy_ratio,
                 count=len(rows))


def modes(*, max_order: int = 25, max_energy_ratio: float = 50.0,
          max_period: float = 8.0, bar: Bar | None = None,
          progress: Progress = None, **bar_options: float) -> Table[Mode]:
    """List the continuous families: a motion for every period, exact.

    Parameters
    ----------
    max_order : int
        Only contact times a4 + b T with -b up to it.
    max_energy_ratio : float
        Only modes with a motion of E/E_1 up to it.
    max_period : float
        Only modes with a motion of T [L/c] up to it.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...
    progress : callable, bool or tqdm bar, optional
        Called with (done, total).

    Returns
    -------
    Table of Mode
        By ascending -b, then a4.

    Raises
    ------
    ValueError
        If a bound is out of its range.
    """
    units = bar_of(bar, bar_options)
    rows = _core.modes(max_order, max_energy_ratio, max_period, units,
                       listener(progress))
    return Table("modes", rows, bar=units, complete=True, max_order=max_order,
                 max_period_ratio=max_period,
                 max_energy_ratio=max_energy_ratio)


def mode(a4: int, b: int, period: Number | None = None, *,
         bar: Bar | None = None, **bar_options: float) -> ModeMotion:
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
