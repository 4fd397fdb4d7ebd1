"""Forced motions by frequency, what a simulation saw, and a sweep."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._asking import asks
from .._core import ExactResponse, SceneResponse, SceneSimulation, Simulation, Sweep
from ._draw import draw
from ._style import NothingToDraw, axes_of, colour_map, unit_for

if TYPE_CHECKING:
    from .._forced import Response
    from .._core import StudyPoint
    from .._tables import Table


@asks("figure")
def response(data: Response | ExactResponse | SceneResponse, *, figure: Any = None,
             axes: Any = None) -> tuple[Any, Any]:
    """Draw impulse on the wall and swing of the tip against frequency.

    Motions with contact as marks, large where they attract and small where
    they repel (if that was tried), the bar without a wall as a line. Under an
    exact harmonic curves of the largest force, and of the impulse: full where
    they attract.

    Returns
    -------
    (axes, axes)
        Of the impulse, and of the tip; of the force, and of the impulse.

    Raises
    ------
    ValueError
        If the response has no frequency.
    """
    if len(data.frequencies) == 0:
        raise NothingToDraw("the response has no frequency: nothing to draw")
    if isinstance(data, (ExactResponse, SceneResponse)):
        drawn = draw(data._figure(), ("force", "impulse"), axes, figure)
        return drawn["force"], drawn["impulse"]
    drawn = draw(data._answer._figure(), ("impulse", "tip"), axes, figure)
    return drawn["impulse"], drawn["tip"]


@asks("figure")
def simulation(run: Simulation | SceneSimulation, *, figure: Any = None,
               axes: Any = None) -> tuple[Any, ...]:
    """Draw the path of the tip, and what the stops get in each period.

    Of several bars the faces at each contact, up to six.

    Parameters
    ----------
    Returns
    -------
    (axes, axes)
        Of the tip, and of the impulses; of several bars one for each contact.

    Raises
    ------
    ValueError
        If the path of the tip was not recorded.
    """
    if isinstance(run, SceneSimulation):
        contacts = tuple(f"contact {one['number']}" for one in run.contacts[:6])
        if not run._figure():
            raise NothingToDraw("the paths at the contacts were not recorded: tip=True")
        return tuple(draw(run._figure(), contacts, axes, figure).values())
    if len(run.tip_time) == 0:
        raise NothingToDraw("the path of the tip was not recorded: tip=True")
    drawn = draw(run._figure(), ("tip", "impulse"), axes, figure)
    return drawn["tip"], drawn["impulse"]


@asks("figure")
def sweep(data: Sweep, *, figure: Any = None,
          axes: Any = None) -> tuple[Any, Any]:
    """Draw what a sweep settled on: impulse and swing, up and down.

    Where the bar does not repeat itself, strokes from least to most.

    Parameters
    ----------
    data : Sweep

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
        raise NothingToDraw("the sweep has no point: nothing to draw")
    drawn = draw(data._figure(), ("impulse", "tip"), axes, figure)
    return drawn["impulse"], drawn["tip"]


@asks("figure")
def study(data: Table[StudyPoint], *, x: str = "amplitude", y: str = "gap",
          axes: Any = None, figure: Any = None) -> Any:
    """Draw the worst impulse of a study over a plane; crosses: no contact.

    Parameters
    ----------
    data : Table of StudyPoint
    x, y : str
        Two of "gap", "damping" and "amplitude". Of what is not shown the
        worst counts.

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
                         label=f"worst impulse per period  [{unit}]")
    axes.set_xlabel(shown[x][1])
    axes.set_ylabel(shown[y][1])
    return axes
