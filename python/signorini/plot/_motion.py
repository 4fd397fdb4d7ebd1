"""One motion, and a curve of them."""

from __future__ import annotations

from typing import Any, Union

from .._asking import asks
from .._core import (Continuum, ContinuumPoint, ForcedResult, HarmonicResult,
                     Motion, Result, Scene)
from ._draw import draw
from ._style import unit_for

#: What has a motion: a Motion itself, a Result, a point of a continuum; of
#: several forced motions the one of the largest impulse.
Moving = Union[Motion, Result, ContinuumPoint, ForcedResult, HarmonicResult]


def motion_of(moving: Moving) -> Motion | ForcedResult | HarmonicResult:
    """Return what draws the motion. ValueError if there is none."""
    found: Motion | ForcedResult | HarmonicResult | None
    if isinstance(moving, (ForcedResult, HarmonicResult)):
        found = moving if moving.motions else None
    else:
        found = moving if isinstance(moving, Motion) else moving.motion
    if found is None:
        raise ValueError("no motion was found: there is nothing to draw")
    return found


@asks("figure")
def motion(moving: Moving, *, figure: Any = None, axes: Any = None
           ) -> dict[str, Any]:
    """Draw a motion as in the paper's Fig. 3.

    Strain and velocity along the bar at t = 0, the displacement u(x, t) over
    one period, and with the same axis of time the path of the tip beside the
    wall and the force of the wall. Under an exact harmonic u(x, t), tip and
    force alone.

    Returns
    -------
    dict of axes
        "strain", "velocity", "displacement", "tip", "force", "words".

    Raises
    ------
    ValueError
        If there is no motion.
    """
    panels = ("displacement", "tip", "force")
    if not isinstance(moving, HarmonicResult):
        panels = ("strain", "velocity", *panels, "words")  # type: ignore[assignment]
    return draw(motion_of(moving)._figure(), panels, axes, figure)


@asks("figure")
def scene(where: Scene, *, axes: Any = None, figure: Any = None) -> Any:
    """Draw a bar and its stops, with their sizes; gaps are not to scale.

    Returns
    -------
    axes
    """
    axes = draw(where._figure(), ("scene",), axes, figure)["scene"]
    sizes = []
    for name, size in (("L", where.bar.length), ("g", where.bar.gap),
                       ("h", where.second_stop)):
        if size is not None:
            factor, unit = unit_for(abs(size) or 1.0, "m")
            sizes.append(f"{name} = {factor * size:.4g} {unit}")
    axes.set_title(",  ".join(sizes), fontsize="medium")
    return axes


@asks("figure")
def continuum(curve: Continuum, *, members: int | None = None,
              figure: Any = None, axes: Any = None) -> dict[str, Any]:
    """Draw a curve of motions, lambda upwards.

    The force of the wall against time, which tells orbits apart, and strain
    and velocity along the bar at t = 0: the paper's Fig. 2. Below, u(x, t) of
    the first, the middle and the last of them.

    Parameters
    ----------
    members : int, optional
        Of older calls: now all of them are drawn.

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
    return draw(curve._figure(), ("force", "strain", "velocity", "first",
                                  "middle", "last"), axes, figure)
