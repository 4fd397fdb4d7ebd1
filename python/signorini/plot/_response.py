"""Forced motions by frequency, and what a simulation saw."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import Simulation
from ._style import colours, new, quiet, unit_for, words

if TYPE_CHECKING:
    from .._forced import Response

#: stable -> label and marker.
SORTS: dict[bool | None, tuple[str, dict[str, Any]]] = {
    True: ("one contact: attracts", {"marker": "o", "ms": 4}),
    False: ("one contact: repels",
            {"marker": "x", "ms": 3.5, "mew": 0.9}),
    None: ("one contact", {"marker": "o", "ms": 3.5, "mfc": "none",
                           "mew": 0.9}),
}


def response(data: Response, *, figure: Any = None) -> tuple[Any, Any]:
    """Draw impulse on the wall and swing of the tip against frequency.

    Motions with one contact as marks, filled where they attract and crosses
    where they repel (if that was tried), the bar without a wall as a line.

    Parameters
    ----------
    data : Response
    figure : matplotlib figure to draw into, optional

    Returns
    -------
    (axes, axes)
        Of the impulse, and of the tip.

    Raises
    ------
    ValueError
        If the response has no frequency.
    """
    if len(data) == 0:
        raise ValueError("the response has no frequency: nothing to draw")
    figure = figure or new(figsize=(9, 7))
    upper, lower = figure.subplots(2, 1, sharex=True)
    bar = data.bar
    impulses = [m.impulse for _, m in data.motions]
    factor, unit = unit_for(max(impulses, default=bar.impulse_unit), "N s")
    metre, metre_unit = unit_for(bar.gap, "m")
    frequency = np.array([at.frequency_ratio for at in data])
    peak = np.array([at.linear_peak for at in data])
    touches = np.array([at.touches for at in data])
    lower.plot(frequency, np.where(touches, np.nan, peak) * metre,
               color=colours["ink"], lw=1.5, label="no contact")
    lower.plot(frequency, np.where(touches, peak, np.nan) * metre, ls="--",
               color=colours["faint"], lw=1.5, label="no wall in its way")
    for stable, (label, style) in SORTS.items():
        chosen = [(at, m) for at, m in data.motions if m.stable is stable]
        if not chosen:
            continue
        if stable is None and len(chosen) < len(impulses):
            label += ": not clear"
        w = [at.frequency_ratio for at, _ in chosen]
        upper.plot(w, [m.impulse * factor for _, m in chosen], ls="",
                   color=colours["contact"], label=label, **style)
        lower.plot(w, [-m.tip_lowest * metre for _, m in chosen], ls="",
                   color=colours["contact"], **style)
    swings = [-m.tip_lowest * metre for _, m in data.motions]
    lower.set_ylim(0, 1.08 * max([2 * bar.gap * metre, *swings]))
    upper.set_ylim(bottom=0)
    upper.set_ylabel(f"impulse a period  [{unit}]")
    lower.set_ylabel(f"swing  −min u(L)  [{metre_unit}]")
    lower.set_xlabel("frequency of the excitation  ω/ω$_1$")
    size, name = unit_for(data.amplitude, "N" if data.force == "tip" else "m")
    what = "force on the tip" if data.force == "tip" else "base moving"
    upper.set_title(f"{what} of amplitude {words(data.amplitude * size)} "
                    f"{name},  ζ = {words(data.damping.ratio)},  "
                    f"N = {data.cells}", fontsize="medium")
    for axes in (upper, lower):
        quiet(axes)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(loc="upper left", fontsize="small")
    return upper, lower


def simulation(run: Simulation, *, figure: Any = None) -> tuple[Any, Any]:
    """Draw the path of the tip, and the impulse of each contact.

    Parameters
    ----------
    run : Simulation
        With the path of its tip.
    figure : matplotlib figure to draw into, optional

    Returns
    -------
    (axes, axes)
        Of the tip, and of the impulses.

    Raises
    ------
    ValueError
        If the path of the tip was not recorded.
    """
    times = run.tip_time
    if len(times) == 0:
        raise ValueError("the path of the tip was not recorded: tip=True")
    figure = figure or new(figsize=(9, 6))
    upper, lower = figure.subplots(2, 1, sharex=True)
    second, second_unit = unit_for(run.time, "s")
    tip = run.tip_displacement
    metre, metre_unit = unit_for(float(np.abs(tip).max()), "m")
    wall = run.bar.gap * metre
    upper.plot(times * second, tip * metre, color=colours["ink"], lw=0.8)
    top = wall + 0.12 * max(wall - float(tip.min()) * metre, wall)
    upper.axhspan(wall, top, color=colours["faint"], alpha=0.5, lw=0)
    upper.set_ylim(top=top)
    upper.set_ylabel(f"tip u(L, t)  [{metre_unit}]")
    impulse = run.contact_impulse
    most = float(impulse.max()) if len(impulse) else run.bar.impulse_unit
    factor, unit = unit_for(most, "N s")
    lower.vlines(run.contact_start * second, 0, impulse * factor,
                 color=colours["contact"], lw=0.8)
    lower.plot(run.contact_start * second, impulse * factor, ".", ms=3,
               color=colours["contact"])
    lower.set_ylim(bottom=0)
    lower.set_ylabel(f"impulse of a contact  [{unit}]")
    lower.set_xlabel(f"time  [{second_unit}]")
    for axes in (upper, lower):
        quiet(axes)
    return upper, lower
