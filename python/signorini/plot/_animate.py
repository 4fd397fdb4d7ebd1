"""Moving pictures: a motion over one period."""

from __future__ import annotations

import json
import os
from typing import Any

from .._asking import asks
from ._draw import draw_panel
from ._motion import Moving, motion_of
from ._style import axes_named


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


@asks("figure")
def animate(moving: Moving, path: str | os.PathLike[str] | None = None, *,
            index: int = -1, frames: int = 100, fps: int = 20,
            figure: Any = None, axes: Any = None) -> Animation:
    """Animate one period: the bar at the wall, or several, and u along it.

    Parameters
    ----------
    path : file name, optional
        Saved there: .gif, or .mp4 (needs ffmpeg).
    index : int
        Which of several forced motions; without, the last.
    frames : int
        Instants of the period, no more than it has steps.
    fps : int
        Frames a second.

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
    found, which = motion_of(moving, index)
    pictures = [json.loads(text) for text in found._frames(max(frames, 1), *which)]
    placed = axes_named(
        ("bar", "displacement"), axes, figure,
        lambda made: made.subplots(2, 1, height_ratios=[1, 2]),
        figsize=(8, 5))

    def draw(frame: int) -> list[Any]:
        panels = {panel["name"]: panel for panel in pictures[frame]["panels"]}
        panels["displacement"]["x"] = panels["fields"]["x"]  # the lowest here
        for name, where in placed.items():
            where.clear()
            draw_panel(where, panels[name], False)
        placed["bar"].set_title(pictures[frame]["title"], fontsize="medium")
        return []

    upper, lower = placed.values()
    # Of a subfigure, the figure it is in.
    moving_picture = FuncAnimation(upper.figure.figure, draw,
                                   frames=len(pictures), interval=1000 / fps,
                                   blit=False)
    draw(0)
    shown = Animation((upper, lower), moving_picture, fps)
    if path is not None:
        shown.save(path)
    return shown
