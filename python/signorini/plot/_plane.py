"""What exists: the frequency-energy plot, families, the existence map."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from .. import _core, _lists
from .._asking import asks
from .._atlas import Atlas
from .._core import Family, ModePolytope
from ._draw import draw
from ._style import NothingToDraw, colours


@asks("figure")
def frequency_energy(atlas: Atlas | None = None, *,
                     max_energy_ratio: float | None = None,
                     max_frequency_ratio: float | None = None,
                     max_order: int = 60,
                     cells: int | None = None,
                     data: Iterable[tuple[float, float]] | None = None,
                     data_label: str = "data", axes: Any = None,
                     figure: Any = None) -> Any:
    """Draw the frequency-energy plot, with your own data over it.

    Exact modes as curves, families as half-lines from their least energy
    upwards, the lower their order the bolder; of an atlas, the families on
    its grid as dots, and sets of several contacts as strokes. An atlas of
    segments or of bars in a row has no families: a dot for each schedule that
    has motions, at their least energy, and no modes.

    Parameters
    ----------
    atlas : Atlas, optional
        To draw besides what exists on no grid.
    max_energy_ratio : float, optional
        Top, E/E_1: 50, or without families that of all schedules.
    max_frequency_ratio : float, optional
        Right end, omega/omega_1: 1.3, or without families that of all
        schedules; further if there are data. Families crowd below 1.3, the
        last mode below 50 E_1 begins at 7.
    max_order : int
        Of families.
    cells : int, optional
        Of one grid of the atlas.
    data : iterable of (frequency_ratio, energy_ratio), optional
        Drawn on top.
    data_label : str
        In the legend.

    Returns
    -------
    axes
    """
    points = np.array(list(data or ()), dtype=float).reshape(-1, 2)
    if atlas is None or atlas._file.has_families():
        right = max([1.3 if max_frequency_ratio is None else max_frequency_ratio,
                     *(1.05 * points[:, 0])])
        top = 50.0 if max_energy_ratio is None else max_energy_ratio
        where = 1.0 - 0.04 * (right - 1.0), right, top
        told = (_core.frequency_energy_figure(max_order, *where) if atlas is None else
                atlas._file.frequency_energy_figure(cells, *where, max_order))
    else:
        told = atlas._file.frequency_energy_figure(
            cells, None, max_frequency_ratio, max_energy_ratio, max_order)
    axes = draw(told, ("energy",), axes, figure)["energy"]
    if len(points):
        axes.plot(points[:, 0], points[:, 1], "D", color=colours["velocity"],
                  mec=colours["ink"], ms=7, zorder=10, label=data_label)
        axes.legend(loc="lower right", fontsize="small")
        axes.set_xlim(right=max(axes.get_xlim()[1], *(1.05 * points[:, 0])))
    return axes


@asks("figure")
def families(rows: Sequence[Family] | None = None, *, max_order: int = 12,
             axes: Any = None, figure: Any = None) -> Any:
    """Draw families as a periodic table: period against order.

    A cell for each (w, nu, k), coloured by its least energy; cells that have
    the same w and nu stand side by side.

    Parameters
    ----------
    rows : sequence of Family, optional
        Those of `max_order` without.
    max_order : int
        Where no rows are given.

    Returns
    -------
    axes
    """
    rows = _lists.families(max_order) if rows is None else rows
    if len(rows) == 0:
        raise NothingToDraw("there are no families to draw")
    return draw(_core.families_figure(list(rows)), ("families",), axes,
                figure)["families"]


@asks("figure")
def polytopes(rows: Sequence[ModePolytope], *, max_energy_ratio: float = 50.0,
              axes: Any = None, figure: Any = None) -> tuple[Any, Any]:
    """Draw motions with several contacts on no grid.

    How long the first contact may last against the period, and all of them on
    the frequency-energy plot beside the modes of one contact.

    Parameters
    ----------
    rows : sequence of ModePolytope
        As `modes(phases=2)` lists them, of one number of contacts.
    max_energy_ratio : float
        Top, E/E_1.

    Returns
    -------
    (axes, axes)
        Of the contact, and of the energy.
    """
    if len(rows) > 0 and rows[0].bar.gap < 0.0:
        raise NothingToDraw("there is no such figure without a gap > 0")
    drawn = draw(_core.polytopes_figure(list(rows), max_energy_ratio), ("contact", "energy"),
                 axes, figure)
    return drawn["contact"], drawn["energy"]


@asks("figure")
def existence_map(atlas: Atlas, *, cells: int | None = None, contact: int = 1,
                  axes: Any = None, figure: Any = None) -> Any:
    """Draw where in time motions with one contact exist.

    A dot at (t_f, t_c) for each schedule that an atlas keeps, coloured by its
    least energy; grazing ones grey, undecided ones crosses. Those of one
    family are a line, its tent.

    Parameters
    ----------
    cells : int, optional
        Of one grid.
    contact : int
        Of bars in a row, the one that is drawn.

    Returns
    -------
    axes
    """
    name = "map" if contact == 1 else f"map{contact}"
    told = atlas._file.existence_figure(cells)
    if f'"{name}"' not in told:
        raise ValueError(f"contact = {contact} is out of range: allowed contacts of the atlas")
    return draw(told, (name,), axes, figure)[name]
