"""Moving pictures: a motion over one period."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .._core import Motion
from ._motion import Moving, motion_of
from ._style import axes_named, colour_map, colours, quiet, unit_for


class Animation:
    """A moving picture: shown in notebooks, saved as .gif or .mp4.

    Attributes
    ----------
    axes : tuple of axes
        Of the bar, and of u(x, t).
    animation : matplotlib.animation.FuncAnimation
    """

    def __init__(self, axes: tuple[Any, Any], animation: Any, fps: int
                 ) -> None:
        self.axes = axes
        self.animation = animation
        self._fps = fps

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file, by the ending of its name .gif or .mp4.

        Raises
        ------
        ValueError
            For another ending.
        """
        name = os.fspath(path)
        writers = {".gif": "pillow", ".mp4": "ffmpeg"}
        ending = os.path.splitext(name)[1].lower()
        if ending not in writers:
            raise ValueError(f"path = {name} is out of range: allowed names "
                             "that end in .gif or .mp4")
        self.animation.save(name, writer=writers[ending], fps=self._fps)

    def _repr_html_(self) -> str:
        text: str = self.animation.to_jshtml(fps=self._fps)
        return text


def _bar(axes: Any, found: Motion, magnified: float) -> Any:
    """Prepare the bar at the wall; returns what draws an instant."""
    from matplotlib.collections import PolyCollection
    length = found.bar.length
    nodes = np.linspace(0.0, length, min(found.cells, 120) + 1)
    middle = (nodes[:-1] + nodes[1:]) / 2
    most = float(np.abs(found.strain(middle[None, :],
                                     found.t[:: 7][:, None])).max()) or 1.0
    paint = colour_map("diverging")
    cells = PolyCollection([], cmap=paint, lw=0)
    cells.set_clim(-most, most)
    axes.add_collection(cells)
    wall = length + magnified * found.bar.gap
    axes.axvspan(wall, wall + 0.06 * length, color=colours["faint"])
    axes.axvspan(-0.04 * length, 0.0, color=colours["faint"])
    axes.set_xlim(-0.04 * length, wall + 0.06 * length)
    axes.set_ylim(-1.6, 1.6)
    axes.set_yticks([])
    metre, unit = unit_for(length, "m")
    ticks = np.linspace(0.0, length, 5)
    axes.set_xticks(ticks, [f"{metre * tick:.3g}" for tick in ticks])
    axes.set_xlabel(f"position x  [{unit}], displacements {magnified:.3g} "
                    "times larger")
    axes.figure.colorbar(cells, ax=axes, label="strain [-]", aspect=8)
    force = axes.text(wall, 1.2, "", ha="right", va="center",
                      color=colours["contact"])
    unit_force, force_unit = unit_for(float(np.abs(found.force).max()), "N")

    def draw(time: float) -> None:
        ends = nodes + magnified * found.displacement(nodes, time)
        cells.set_verts([[(left, -1), (left, 1), (right, 1), (right, -1)]
                         for left, right in zip(ends[:-1], ends[1:])])
        cells.set_array(found.strain(middle, time))
        pressed = found.wall_force(time)
        force.set_text(f"wall {pressed * unit_force:.3g} {force_unit}"
                       if pressed != 0 else "")

    return draw


def _graph(axes: Any, found: Motion) -> Any:
    """Prepare u along the bar; returns what draws an instant."""
    u = found.displacement(found.x[None, :], found.t[:: 5][:, None])
    metre, metre_unit = unit_for(found.bar.length, "m")
    factor, unit = unit_for(float(np.abs(u).max()), "m")
    line, = axes.plot([], [], color=colours["ink"], lw=2)
    axes.axhline(found.bar.gap * factor, color=colours["faint"], lw=1)
    axes.set_xlim(0, found.bar.length * metre)
    low, high = u.min() * factor, max(u.max(), found.bar.gap) * factor
    margin = 0.08 * (high - low)
    axes.set_ylim(low - margin, high + margin)
    axes.set_xlabel(f"position x  [{metre_unit}]")
    axes.set_ylabel(f"displacement u  [{unit}]")
    quiet(axes)
    second, second_unit = unit_for(float(found.t[-1]), "s")

    def draw(time: float) -> None:
        line.set_data(found.x * metre, found.displacement(found.x, time)
                      * factor)
        axes.set_title(f"t = {time * second:.2f} {second_unit}",
                       fontsize="medium", loc="left")

    return draw


def animate(moving: Moving, path: str | os.PathLike[str] | None = None, *,
            frames: int = 100, fps: int = 20, figure: Any = None,
            axes: Any = None) -> Animation:
    """Animate one period: the bar at the wall, and u along it.

    Parameters
    ----------
    moving : Motion, Result or ContinuumPoint
    path : file name, optional
        Saved there: .gif, or .mp4 (needs ffmpeg).
    frames : int
        Instants of the period.
    fps : int
        Frames a second.
    figure : matplotlib figure to draw into, optional
        Or a subfigure.
    axes : two matplotlib axes, optional
        In their place: a sequence, or a dict of "bar" and "displacement".

    Returns
    -------
    Animation
        Moves in notebooks.

    Raises
    ------
    ValueError
        If there is no motion, or the name ends in something else.
    """
    from matplotlib.animation import FuncAnimation
    found = motion_of(moving)
    upper, lower = axes_named(
        ("bar", "displacement"), axes, figure,
        lambda made: made.subplots(2, 1, height_ratios=[1, 2]),
        figsize=(8, 5)).values()
    magnified = 0.12 * found.bar.length / found.bar.displacement_unit
    draws = [_bar(upper, found, magnified), _graph(lower, found)]
    times = np.linspace(0.0, found.t[-1], frames, endpoint=False)

    def draw(frame: int) -> list[Any]:
        for each in draws:
            each(float(times[frame]))
        return []

    # Of a subfigure, the figure it is in.
    moving_picture = FuncAnimation(upper.figure.figure, draw, frames=frames,
                                   interval=1000 / fps, blit=False)
    shown = Animation((upper, lower), moving_picture, fps)
    if path is not None:
        shown.save(path)
    return shown
