"""Forced motions by frequency, what a simulation saw, and a sweep."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import Simulation, Sweep
from ._style import (axes_of, colour_map, colours, pair, quiet, unit_for,
                     words)

if TYPE_CHECKING:
    from .._forced import Response
    from .._study import StudyPoint
    from .._tables import Table

#: stable -> label and marker.
SORTS: dict[bool | None, tuple[str, dict[str, Any]]] = {
    True: ("one contact: attracts", {"marker": "o", "ms": 4}),
    False: ("one contact: repels",
            {"marker": "x", "ms": 3.5, "mew": 0.9}),
    None: ("one contact", {"marker": "o", "ms": 3.5, "mfc": "none",
                           "mew": 0.9}),
}


def response(data: Response, *, figure: Any = None,
             axes: Any = None) -> tuple[Any, Any]:
    """Draw impulse on the wall and swing of the tip against frequency.

    Motions with one contact as marks, filled where they attract and crosses
    where they repel (if that was tried), the bar without a wall as a line.

    Parameters
    ----------
    data : Response
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : two matplotlib axes, optional
        In their place: a sequence, or a dict of "impulse" and "tip".

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
    upper, lower = pair(("impulse", "tip"), axes, figure, figsize=(9, 7))
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
    for each in (upper, lower):
        quiet(each)
        if each.get_legend_handles_labels()[0]:
            each.legend(loc="upper left", fontsize="small")
    return upper, lower


def simulation(run: Simulation, *, figure: Any = None,
               axes: Any = None) -> tuple[Any, Any]:
    """Draw the path of the tip, and the impulse of each contact.

    Parameters
    ----------
    run : Simulation
        With the path of its tip.
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : two matplotlib axes, optional
        In their place: a sequence, or a dict of "tip" and "impulse".

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
    upper, lower = pair(("tip", "impulse"), axes, figure, figsize=(9, 6))
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
    for each in (upper, lower):
        quiet(each)
    return upper, lower


def sweep(data: Sweep, *, figure: Any = None,
          axes: Any = None) -> tuple[Any, Any]:
    """Draw what a sweep settled on: impulse and swing, up and down.

    Where the bar does not repeat itself, strokes from least to most.

    Parameters
    ----------
    data : Sweep
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : two matplotlib axes, optional
        In their place: a sequence, or a dict of "impulse" and "tip".

    Returns
    -------
    (axes, axes)
        Of the impulse in a period of the excitation, and of the tip.

    Raises
    ------
    ValueError
        If the sweep has no point.
    """
    if not data.points:
        raise ValueError("the sweep has no point: nothing to draw")
    upper, lower = pair(("impulse", "tip"), axes, figure, figsize=(9, 7))
    factor, unit = unit_for(max(p.impulse_range[1] for p in data.points),
                            "N s")
    metre, metre_unit = unit_for(max(abs(p.tip_lowest) for p in data.points),
                                 "m")
    is_frequency = data.over == "frequency"
    for direction, colour, mark in (("up", "contact", "o"),
                                    ("down", "ink", "s")):
        points = [p for p in data.points if p.direction == direction]
        if not points:
            continue
        at = [p.frequency if is_frequency else p.value for p in points]
        style = {"color": colours[colour], "ms": 3, "lw": 1}
        upper.plot(at, [p.impulse * factor for p in points], mark + "-",
                   label=f"{direction}ward", **style)
        lower.plot(at, [-p.tip_lowest * metre for p in points], mark + "-",
                   **style)
        for x, p in zip(at, points):
            if p.periods is None:
                upper.vlines(x, *(i * factor for i in p.impulse_range),
                             color=colours[colour], lw=0.8)
    upper.set_ylim(bottom=0)
    upper.set_ylabel(f"impulse a period  [{unit}]")
    lower.set_ylabel(f"swing  −min u(L)  [{metre_unit}]")
    size = {"frequency": "Hz", "gap": "m", "damping": "–",
            "amplitude": "N" if data.force == "tip" else "m"}[data.over]
    lower.set_xlabel(f"{data.over}  [{size}]")
    for each in (upper, lower):
        quiet(each)
    upper.legend(loc="upper left", fontsize="small")
    return upper, lower


def study(data: Table[StudyPoint], *, x: str = "amplitude", y: str = "gap",
          axes: Any = None, figure: Any = None) -> Any:
    """Draw the worst impulse of a study over a plane; crosses: no contact.

    Parameters
    ----------
    data : Table of StudyPoint
    x, y : str
        Two of "gap", "damping" and "amplitude". Of what is not shown the
        worst counts.
    axes : matplotlib axes, optional
    figure : matplotlib figure or subfigure, optional

    Returns
    -------
    axes
    """
    for name, value in (("x", x), ("y", y)):
        if value not in ("gap", "damping", "amplitude"):
            raise ValueError(f"{name} = {value!r} is out of range: allowed "
                             "gap|damping|amplitude")
    axes = axes_of(axes, figure, figsize=(7, 5.5))
    worst: dict[tuple[float, float], float] = {}
    for point in data:
        place = getattr(point, x), getattr(point, y)
        worst[place] = max(worst.get(place, 0.0), point.impulse)
    force = "N" if data.force == "tip" else "m"
    sizes = {"gap": "m", "damping": "", "amplitude": force}
    shown = {}
    for name, at in ((x, 0), (y, 1)):
        factor, unit = unit_for(max(place[at] for place in worst),
                                sizes[name]) if sizes[name] else (1.0, "–")
        shown[name] = factor, f"{name}  [{unit}]"
    columns, rows = (sorted({place[at] for place in worst}) for at in (0, 1))
    factor, unit = unit_for(max(worst.values()), "N s")
    values = np.array([[worst[a, b] * factor for a in columns] for b in rows])
    dots = axes.pcolormesh([a * shown[x][0] for a in columns],
                           [b * shown[y][0] for b in rows], values,
                           cmap=colour_map(), shading="nearest")
    quiets = [place for place, impulse in worst.items() if impulse == 0.0]
    axes.plot([a * shown[x][0] for a, _ in quiets],
              [b * shown[y][0] for _, b in quiets], "x", ms=4, color="white")
    axes.figure.colorbar(dots, ax=axes,
                         label=f"worst impulse a period  [{unit}]")
    axes.set_xlabel(shown[x][1])
    axes.set_ylabel(shown[y][1])
    return axes
