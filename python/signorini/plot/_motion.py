"""One motion, and a curve of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Union

import numpy as np

from .._core import Continuum, ContinuumPoint, Motion, Result
from ._style import (axes_named, colour_map, colours, quiet, unit_for,
                     words)

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: What has a motion: a Motion itself, a Result, a point of a continuum.
Moving = Union[Motion, Result, ContinuumPoint]

NODES = 301
INSTANTS = 701


def motion_of(moving: Moving) -> Motion:
    """Return the motion of what has one. ValueError if it has none."""
    found = moving if isinstance(moving, Motion) else moving.motion
    if found is None:
        raise ValueError("no motion was found: there is nothing to draw")
    return found


def sampled(motion: Motion) -> tuple[NDArray[np.float64],
                                     NDArray[np.float64],
                                     NDArray[np.float64]]:
    """Return x [m], t [s] and u(t, x) [m], as fine as print can show."""
    x = np.linspace(0.0, motion.bar.length, NODES)
    t = np.linspace(0.0, float(motion.t[-1]), INSTANTS)
    return x, t, motion.displacement(x[None, :], t[:, None])


def _profile(axes: Any, values: Any, length: float, **style: Any) -> None:
    """Draw values that are constant on each cell."""
    edges = np.linspace(0.0, length, len(values) + 1)
    axes.stairs(values, edges, baseline=None, **style)


def _initial(upper: Any, lower: Any, motion: Motion, metre: float) -> None:
    state = motion.state
    length = motion.bar.length * metre
    factor, unit = unit_for(float(np.abs(state.velocity).max()), "m/s")
    _profile(upper, state.strain, length, color=colours["strain"], lw=2)
    _profile(lower, state.velocity * factor, length,
             color=colours["velocity"], lw=2, ls="--")
    upper.set_ylabel("strain\ns(x, 0)  [-]")
    lower.set_ylabel(f"velocity\nv(x, 0)  [{unit}]")
    upper.ticklabel_format(axis="y", style="sci", scilimits=(-2, 3),
                           useMathText=True)
    for axes in (upper, lower):
        axes.use_sticky_edges = False
        axes.margins(y=0.25)
        quiet(axes)


def _image(axes: Any, x: Any, t: Any, u: Any, **options: Any) -> Any:
    """Draw u(t, x) in colour."""
    return axes.imshow(u, extent=(x[0], x[-1], t[0], t[-1]), origin="lower",
                       aspect="auto", interpolation="bilinear",
                       cmap=colour_map(), **options)


def _field(axes: Any, motion: Motion, metre: float, second: float) -> Any:
    x, t, u = sampled(motion)
    factor, unit = unit_for(float(np.abs(u).max()), "m")
    image = _image(axes, x * metre, t * second, u * factor)
    bar = axes.figure.colorbar(image, ax=axes, location="left", pad=0.12,
                               aspect=30)
    bar.set_label(f"displacement u  [{unit}]")
    return bar


def _tip(axes: Any, motion: Motion, second: float) -> None:
    tip = motion.tip
    factor, unit = unit_for(float(np.abs(tip).max()), "m")
    times = motion.t * second
    wall = motion.bar.gap * factor
    pressed = np.pad((motion.force != 0.0).astype(int), 1)
    axes.plot(tip * factor, times, color=colours["ink"], lw=1.2,
              label="path of the tip")
    # Where the wall presses the tip stands still.
    ends = np.flatnonzero(np.diff(pressed))
    for first, last in ends.reshape(-1, 2):
        held = tip[first] * factor
        axes.plot([held, held], times[[first, last]], color=colours["contact"],
                  lw=5, solid_capstyle="butt",
                  label="contact: the wall presses" if first == ends[0]
                  else None)
    low, high = tip.min() * factor, tip.max() * factor
    margin = 0.08 * (high - low)
    axes.set_xlim(low - margin, wall + 3 * margin)
    axes.axvspan(wall, wall + 3 * margin, color=colours["faint"], alpha=0.5,
                 lw=0, zorder=0)
    if motion.scene.second_stop is not None:
        stop = -motion.scene.second_stop * factor
        axes.set_xlim(left=min(low - margin, stop - 3 * margin))
        axes.axvspan(axes.get_xlim()[0], stop, color=colours["faint"],
                     alpha=0.5, lw=0, zorder=0)
    axes.text(wall + 1.5 * margin, 0.5, "wall", rotation=90, ha="center",
              va="center", transform=axes.get_xaxis_transform())
    axes.set_xlabel(f"tip u(L, t)  [{unit}]")
    quiet(axes)


def _force(axes: Any, motion: Motion, second: float) -> None:
    force = motion.force
    factor, unit = unit_for(float(np.abs(force).max()), "N")
    edges = motion.t * second
    axes.stairs(force * factor, edges, orientation="horizontal", fill=True,
                color=colours["contact"], alpha=0.3)
    axes.stairs(force * factor, edges, orientation="horizontal",
                color=colours["contact"], lw=1.2)
    axes.set_xlabel(f"wall force  [{unit}]")
    if force.min() >= 0:
        axes.set_xlim(left=0)
    quiet(axes)


def _words(axes: Any, moving: Moving, motion: Motion) -> None:
    # Of a stepped bar the answer knows the energy, the waves alone do not.
    known: Any = moving if isinstance(moving, Result) else motion.state
    energy = known.energy
    factor, unit = unit_for(energy, "J")
    hertz, hertz_unit = unit_for(1.0 / motion.period, "Hz")
    phases = ", ".join("(" + ", ".join(map(str, phase)) + ")"
                       for phase in motion.schedule)
    lines = [
        f"N = {motion.cells}, {phases}",
        f"T = {words(motion.period)} s = {words(motion.period_ratio)} L/c",
        f"f = {words(hertz / motion.period)} {hertz_unit},  "
        f"ω/ω$_1$ = {words(4 / motion.period_ratio)}",
        f"E = {words(energy * factor)} {unit},  "
        f"E/E$_1$ = {words(known.energy_ratio)}"
        if known.energy_ratio is not None else
        f"E = {words(energy * factor)} {unit}",
    ]
    axes.axis("off")
    axes.text(0.0, 1.0, "\n".join(lines), va="top", linespacing=1.6,
              transform=axes.transAxes)


def _motion_axes(figure: Any) -> dict[str, Any]:
    axes: dict[str, Any] = figure.subplot_mosaic(
        [["strain", "words", "words"], ["velocity", "words", "words"],
         ["displacement", "tip", "force"]],
        width_ratios=[2.4, 1, 0.8], height_ratios=[1, 1, 4])
    for name in ("strain", "velocity"):
        axes[name].sharex(axes["displacement"])
        axes[name].tick_params(labelbottom=False)
    for name in ("tip", "force"):
        axes[name].sharey(axes["displacement"])
        axes[name].tick_params(labelleft=False)
    return axes


def motion(moving: Moving, *, figure: Any = None, axes: Any = None
           ) -> dict[str, Any]:
    """Draw a motion as in the paper's Fig. 3.

    Strain and velocity along the bar at t = 0, the displacement u(x, t) over
    one period, and with the same axis of time the path of the tip beside the
    wall and the force of the wall.

    Parameters
    ----------
    moving : Motion, Result or ContinuumPoint
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : dict or sequence of six matplotlib axes, optional
        In their place, by the names or in the order of what is returned.

    Returns
    -------
    dict of axes
        "strain", "velocity", "displacement", "tip", "force", "words".

    Raises
    ------
    ValueError
        If there is no motion.
    """
    found = motion_of(moving)
    axes = axes_named(("strain", "velocity", "displacement", "tip", "force",
                       "words"), axes, figure, _motion_axes, figsize=(9, 8))
    metre, metre_unit = unit_for(found.bar.length, "m")
    second, second_unit = unit_for(float(found.t[-1]), "s")
    _initial(axes["strain"], axes["velocity"], found, metre)
    _field(axes["displacement"], found, metre, second)
    axes["displacement"].set_xlabel(f"position x  [{metre_unit}]")
    axes["displacement"].set_ylabel(f"time t  [{second_unit}]")
    for name in ("strain", "velocity", "displacement"):
        axes[name].set_xlim(0, found.bar.length * metre)
    for name in ("displacement", "tip", "force"):
        axes[name].set_ylim(0, found.t[-1] * second)
    _tip(axes["tip"], found, second)
    _force(axes["force"], found, second)
    _words(axes["words"], moving, found)
    handles, labels = axes["tip"].get_legend_handles_labels()
    axes["words"].legend(handles, labels, loc="lower left", frameon=False,
                         borderaxespad=0)
    return dict(axes)


def _stack(axes: Any, rows: list[Any], edges: list[Any], colour: str) -> None:
    """Draw profiles one above the other, the first at the bottom."""
    size = max((float(np.abs(row).max()) for row in rows), default=0.0) or 1.0
    for level, (row, edge) in enumerate(zip(rows, edges)):
        at = float(level)
        axes.stairs(at + 0.85 * row / size, edge, baseline=at, fill=True,
                    color=colour, alpha=0.25, zorder=len(rows) - level)
        axes.stairs(at + 0.85 * row / size, edge, baseline=at, color=colour,
                    lw=0.9, zorder=len(rows) - level)
    axes.set_yticks([])


def continuum(curve: Continuum, *, members: int = 16, figure: Any = None,
              axes: Any = None) -> dict[str, Any]:
    """Draw a curve of motions, stacked upwards by lambda.

    The force of the wall against time, which tells orbits apart, and strain
    and velocity along the bar at t = 0: the paper's Fig. 2. Below, u(x, t) of
    the first, the middle and the last of them.

    Parameters
    ----------
    curve : Continuum
    members : int
        How many of its motions.
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : dict or sequence of six matplotlib axes, optional
        In their place, by the names or in the order of what is returned.

    Returns
    -------
    dict of axes
        "force", "strain", "velocity", "first", "middle", "last".

    Raises
    ------
    ValueError
        If the curve has no points.
    """
    if len(curve) == 0:
        raise ValueError("the curve has no points: there is nothing to draw")
    axes = axes_named(
        ("force", "strain", "velocity", "first", "middle", "last"), axes,
        figure, lambda made: made.subplot_mosaic(
            [["force", "strain", "velocity"], ["first", "middle", "last"]],
            height_ratios=[1.4, 1]), figsize=(10, 9))
    metre, metre_unit = unit_for(curve.bar.length, "m")
    second, second_unit = unit_for(curve.period, "s")
    chosen = np.unique(np.linspace(0, len(curve) - 1, members).astype(int))
    points = [curve[int(k)] for k in chosen]
    motions = [point.motion for point in points]
    lasting = max(int(np.flatnonzero(m.force)[-1]) + 1 if m.force.any() else 1
                  for m in motions)
    forces = [m.force[:lasting] for m in motions]
    times = motions[0].t[:lasting + 1] * second
    places = motions[0].x * metre
    count = len(points)
    _stack(axes["force"], forces, [times] * count, colours["contact"])
    _stack(axes["strain"], [p.state.strain for p in points],
           [places] * count, colours["strain"])
    _stack(axes["velocity"], [p.state.velocity for p in points],
           [places] * count, colours["velocity"])
    force, unit = unit_for(max(float(f.max()) for f in forces), "N")
    most = max(float(f.max()) for f in forces) * force
    axes["force"].set_title(f"force of the wall, at most {words(most)} {unit}",
                            fontsize="medium")
    axes["strain"].set_title("strain s(x, 0)", fontsize="medium")
    axes["velocity"].set_title("velocity v(x, 0)", fontsize="medium")
    axes["force"].set_xlabel(f"time t  [{second_unit}]")
    axes["force"].set_ylabel(f"λ ({curve.parameter})")
    levels = np.unique(np.linspace(0, count - 1, 6).astype(int))
    axes["force"].set_yticks(
        levels, [words(points[int(k)].lambda_, 3) for k in levels])
    for name in ("strain", "velocity"):
        axes[name].set_xlabel(f"position x  [{metre_unit}]")
    shown = (points[0], points[count // 2], points[-1])
    fields = [sampled(point.motion) for point in shown]
    size = max(float(np.abs(u).max()) for _, _, u in fields)
    factor, unit = unit_for(size, "m")
    for name, point, (x, t, u) in zip(("first", "middle", "last"), shown,
                                      fields):
        image = _image(axes[name], x * metre, t * second, u * factor,
                       vmin=-size * factor, vmax=size * factor)
        axes[name].set_title(f"λ = {words(point.lambda_, 4)}",
                             fontsize="medium")
        axes[name].set_xlabel(f"position x  [{metre_unit}]")
        axes[name].set_ylabel(f"time t  [{second_unit}]")
    axes["last"].figure.colorbar(
        image, ax=[axes["first"], axes["middle"], axes["last"]],
        label=f"displacement u  [{unit}]", pad=0.02)
    return dict(axes)
