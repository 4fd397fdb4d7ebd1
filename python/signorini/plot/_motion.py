"""One motion, and a curve of them."""

from __future__ import annotations

import json
from typing import Any, Union

from .._asking import asks
from .._core import (Continuum, ContinuumPoint, ForcedResult, HarmonicResult,
                     ForceRange, Motion, Result, Scene, SceneContinuum, SceneContinuumPoint,
                     SceneForcedResult, SceneHarmonicResult, SceneQuestion, SceneResult,
                     SceneSimulation)
from .._words import whole
from ._draw import draw
from ._style import NothingToDraw, unit_for

#: What has a motion: a Motion itself, a Result, a point of a continuum, or
#: several forced motions.
Moving = Union[Motion, Result, ContinuumPoint, ForcedResult, HarmonicResult,
               SceneResult, SceneForcedResult, SceneHarmonicResult, SceneContinuumPoint]


def motion_of(moving: Moving, index: int) -> tuple[Any, tuple[int, ...]]:
    """Return what draws the motion, and which it is of several. ValueError if there is none."""
    if isinstance(moving, (SceneResult, SceneContinuumPoint)):
        if isinstance(moving, SceneResult) and not moving:
            raise NothingToDraw("no motion was found: there is nothing to draw")
        return moving, (0,)
    several = isinstance(moving, (ForcedResult, HarmonicResult, SceneForcedResult,
                                  SceneHarmonicResult))
    count = len(moving.motions) if several else 1  # type: ignore[union-attr]
    found: Any = moving if several or isinstance(moving, Motion) else (
        moving.motion)  # type: ignore[union-attr]
    if found is None or count == 0:
        raise NothingToDraw("no motion was found: there is nothing to draw")
    if not -count <= whole("index", index) < count:
        raise ValueError(f"index = {index} is out of range: allowed whole numbers "
                         f"{-count}..{count - 1}")
    return found, (index % count,) * several


@asks("figure")
def motion(moving: Moving, *, index: int = -1, figure: Any = None, axes: Any = None
           ) -> dict[str, Any]:
    """Draw a motion as in the paper's Fig. 3.

    Strain and velocity along the bar at t = 0, the displacement u(x, t) over
    one period, and with the same axis of time the path of the tip beside the
    wall and the force of the wall. Under an exact harmonic u(x, t), tip and
    force alone; of several bars u(x, t), how far the contact is open, and its
    force.
    Of a schedule of several bars u(x, t) of all, and the faces at each contact.

    Parameters
    ----------
    index : int
        Which of several forced motions, as in `motions`: the last without,
        which has the largest impulse.

    Returns
    -------
    dict of axes
        "strain", "velocity", "displacement", "tip", "force", "words"; of
        several bars "displacement", "gap", "force", or "displacement",
        "contact 1", ...

    Raises
    ------
    ValueError
        If there is no motion, or none of that index.
    """
    found, which = motion_of(moving, index)
    text = found._figure(*which)
    there = [panel["name"] for panel in json.loads(text)["panels"]]
    usual = ("strain", "velocity", "displacement", "tip", "force", "words")
    panels = tuple(name for name in usual if name in there) if "tip" in there else tuple(there)
    return draw(text, panels, axes, figure)


@asks("figure")
def scene(where: Scene | SceneResult | SceneForcedResult | SceneHarmonicResult
          | SceneQuestion | SceneSimulation | SceneContinuum | SceneContinuumPoint | ForceRange, *,
          axes: Any = None,
          figure: Any = None) -> Any:
    """Draw bars and what stands at them, of one bar with sizes; gaps are not to scale.

    Returns
    -------
    axes
    """
    axes = draw(where._scene(), ("scene",), axes, figure)["scene"]
    if not isinstance(where, Scene):
        return axes
    sizes = []
    for name, size in (("L", where.bar.length), ("g", where.bar.gap),
                       ("h", where.second_stop)):
        if size is not None:
            factor, unit = unit_for(abs(size) or 1.0, "m")
            sizes.append(f"{name} = {factor * size:.4g} {unit}")
    axes.set_title(",  ".join(sizes), fontsize="medium")
    return axes


@asks("figure")
def continuum(curve: Continuum | SceneContinuum, *, members: int | None = None,
              figure: Any = None, axes: Any = None) -> dict[str, Any]:
    """Draw a curve of motions, lambda upwards.

    The force of the wall against time, which tells orbits apart, and strain
    and velocity along the bar at t = 0: the paper's Fig. 2. Below, u(x, t) of
    the first, the middle and the last of them. Of several bars the forces of
    the first two contacts and u(x, 0), of one contact its force, velocity and
    u(x, 0).

    Parameters
    ----------
    members : int, optional
        Of older calls: now all of them are drawn.

    Returns
    -------
    dict of axes
        "force", "strain", "velocity", "first", "middle", "last"; of several
        bars "force", "second force" or "velocity", "displacement", "first", ...

    Raises
    ------
    ValueError
        If the curve has no points.
    """
    if len(curve) == 0:
        raise NothingToDraw("the curve has no points: there is nothing to draw")
    text = curve._figure()
    panels = tuple(panel["name"] for panel in json.loads(text)["panels"])
    return draw(text, panels, axes, figure)
