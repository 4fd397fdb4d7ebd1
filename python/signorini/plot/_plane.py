"""What exists: the frequency-energy plot, families, the existence map."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from .. import _lists
from .._atlas import Atlas
from .._core import AtlasSchedule, Family, Mode
from ._style import axes_of, colour_map, colours, quiet

#: Up to which order a family counts as so bold; colour and width.
BOLDNESS = tuple(zip((4, 6, 9, 15, 30, 60), colours["fading"],
                     (3.0, 2.0, 1.4, 1.0, 0.7, 0.5)))


def _mode_style(mode: Mode) -> dict[str, Any]:
    name = mode.family or ""
    if name == "main":
        return {"lw": 3, "label": "main mode  $t_c = 4 - T$"}
    if name.startswith("subharmonic"):
        return {"lw": 1.6, "label": "subharmonic modes"}
    if name.startswith("higher"):
        return {"lw": 1.6, "ls": "--", "label": "higher modes"}
    return {"lw": 0.8, "ls": ":", "label": "other modes"}


def _draw_modes(axes: Any, modes: Iterable[Mode], most: float) -> None:
    said = set()
    for mode in modes:
        (p, q), (r, s) = mode.period_range
        periods = np.linspace(p / q, r / s, 402)[1:-1]
        energies = mode.energy_ratio(periods)
        inside = energies <= 1.05 * most
        style = _mode_style(mode)
        if style["label"] in said:
            del style["label"]
        else:
            said.add(style["label"])
        axes.plot(4.0 / periods[inside], energies[inside],
                  color=colours["ink"], **style)
        # Where contact vanishes begins the linear motion.
        axes.plot(4.0 * s / r, mode.contact[1] ** 2, "o", mfc="white", ms=3,
                  mec=colours["ink"], mew=0.8)


def _draw_families(axes: Any, families: Sequence[Family], most: float
                   ) -> None:
    low = 0
    for order, colour, width in BOLDNESS:
        chosen = [f for f in families if low < f.order <= order]
        low = order
        if not chosen:
            continue
        axes.vlines([f.frequency_ratio for f in chosen],
                    [f.least_energy_ratio for f in chosen], most,
                    color=colour, lw=width, zorder=1 + 1 / order,
                    label=f"families of order w ≤ {order}")


def frequency_energy(atlas: Atlas | None = None, *,
                     max_energy_ratio: float = 50.0,
                     max_frequency_ratio: float = 1.3, max_order: int = 60,
                     cells: int | None = None,
                     data: Iterable[tuple[float, float]] | None = None,
                     data_label: str = "data", axes: Any = None,
                     figure: Any = None) -> Any:
    """Draw the frequency-energy plot, with your own data over it.

    Exact modes as curves, families as half-lines from their least energy
    upwards, the lower their order the bolder; of an atlas, the families on
    its grid as dots, and sets of several contacts as strokes.

    Parameters
    ----------
    atlas : Atlas, optional
        To draw besides what exists on no grid.
    max_energy_ratio : float
        Top, E/E_1.
    max_frequency_ratio : float
        Right end, omega/omega_1; further if there are data. Families crowd
        below 1.3, the last mode below 50 E_1 begins at 7.
    max_order : int
        Of families.
    cells : int, optional
        Of one grid of the atlas.
    data : iterable of (frequency_ratio, energy_ratio), optional
        Drawn on top.
    data_label : str
        In the legend.
    axes : matplotlib axes, optional
    figure : matplotlib figure or subfigure, optional

    Returns
    -------
    axes
    """
    axes = axes_of(axes, figure, figsize=(9, 6))
    top = max_energy_ratio
    _draw_families(axes, _lists.families(max_order, max_energy_ratio=top), top)
    _draw_modes(axes, _lists.modes(max_energy_ratio=top), top)
    if atlas is not None:
        _draw_atlas(axes, atlas, cells, top)
    if data is not None:
        points = np.array(list(data), dtype=float).reshape(-1, 2)
        axes.plot(points[:, 0], points[:, 1], "D", color=colours["velocity"],
                  mec=colours["ink"], ms=7, zorder=10, label=data_label)
    axes.set_yscale("log")
    axes.set_ylim(0.8, top)
    ticks = [e for e in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000) if e <= top]
    axes.set_yticks(ticks, [str(e) for e in ticks])
    axes.minorticks_off()
    right = max_frequency_ratio
    if data is not None and len(points):
        right = max(right, 1.05 * float(points[:, 0].max()))
    axes.set_xlim(1.0 - 0.04 * (right - 1.0), right)
    axes.set_xlabel("frequency  ω/ω$_1$ = 4L/(cT)")
    axes.set_ylabel("energy  E/E$_1$")
    quiet(axes)
    axes.legend(loc="lower right", fontsize="small")
    return axes


def _draw_atlas(axes: Any, atlas: Atlas, cells: int | None, most: float
                ) -> None:
    rows = [f for f in atlas.families(cells)
            if f.energy_ratio_range[0] <= most and f.order is not None]
    axes.plot([f.frequency_ratio for f in rows],
              [f.energy_ratio_range[0] for f in rows], ".",
              color=colours["contact"], ms=3, zorder=4,
              label="families on the grid")
    several = [s for s in atlas.schedules(cells) if len(s.schedule) > 1]
    lows = [_least(s) for s in several]
    highs = [_most(s, most) for s in several]
    if several:
        axes.vlines([s.frequency_ratio for s in several], lows, highs,
                    color=colours["contact"], lw=1.2, zorder=3,
                    label="several contacts")


def _least(row: AtlasSchedule) -> float:
    return row.energy_ratio_range[0] if row.energy_ratio_range else np.nan


def _most(row: AtlasSchedule, top: float) -> float:
    most = row.energy_ratio_range[1] if row.energy_ratio_range else None
    return top if most is None else min(most, top)


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
    axes : matplotlib axes, optional
    figure : matplotlib figure or subfigure, optional

    Returns
    -------
    axes
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LogNorm
    from matplotlib.patches import Rectangle
    rows = _lists.families(max_order) if rows is None else rows
    if len(rows) == 0:
        raise ValueError("there are no families to draw")
    axes = axes_of(axes, figure, figsize=(10, 7.5))
    energies = [f.least_energy_ratio for f in rows]
    norm = LogNorm(1.0, max(max(energies), 1.1))
    paint = colour_map()
    cells: dict[tuple[int, int], list[Family]] = {}
    for family in rows:
        cells.setdefault((family.order, family.nu), []).append(family)
    high = 0.09
    for (order, nu), group in cells.items():
        period = 2 * nu / order
        for k, family in enumerate(group):
            wide = 0.9 / len(group)
            left = order - 0.45 + k * wide
            shade = norm(family.least_energy_ratio)
            axes.add_patch(Rectangle((left, period - high / 2), wide, high,
                                     color=paint(shade), lw=0))
            if max(f.order for f in rows) <= 16:
                axes.text(left + wide / 2, period,
                          f"{nu},{family.contact_blocks}", ha="center",
                          va="center",
                          color="black" if shade > 0.6 else "white",
                          fontsize=(9, 7, 5.5)[min(len(group), 3) - 1])
    orders = [f.order for f in rows]
    axes.set_xlim(min(orders) - 0.7, max(orders) + 0.7)
    periods = [2 * f.nu / f.order for f in rows]
    axes.set_ylim(min(periods) - 0.1, max(4.0, max(periods)) + 0.1)
    axes.set_xlabel("order w: equal blocks of time in 2L/c")
    axes.set_ylabel("period  T  [L/c]")
    axes.set_title(f"{len(rows)} families: cells ν,k;  T = 2ν/w,  "
                   "$t_c$ ≤ 2k/w", fontsize="medium")
    if len(set(orders)) <= 20:
        axes.set_xticks(sorted(set(orders)))
    right = axes.secondary_yaxis("right", functions=(_inverse, _inverse))
    right.set_ylabel("frequency  ω/ω$_1$")
    right.set_yticks([1, 1.1, 1.2, 1.3, 1.5, 2, 3])
    right.set_yticklabels(["1", "1.1", "1.2", "1.3", "1.5", "2", "3"])
    quiet(axes)
    axes.figure.colorbar(ScalarMappable(norm, paint), ax=axes,
                         label="least energy  E/E$_1$", pad=0.1)
    return axes


def _inverse(value: Any) -> Any:
    """4/T, and back."""
    return 4.0 / np.maximum(value, 1e-9)


def existence_map(atlas: Atlas, *, cells: int | None = None, axes: Any = None,
                  figure: Any = None) -> Any:
    """Draw where in time motions with one contact exist.

    A dot at (t_c, t_f) for each schedule that an atlas keeps, coloured by its
    least energy; grazing ones grey. Those of one family are a line, its tent.

    Parameters
    ----------
    atlas : Atlas
    cells : int, optional
        Of one grid.
    axes : matplotlib axes, optional
    figure : matplotlib figure or subfigure, optional

    Returns
    -------
    axes
    """
    from matplotlib.colors import LogNorm
    axes = axes_of(axes, figure, figsize=(7, 8))
    rows = [row for row in atlas.schedules(cells) if len(row.schedule) == 1]
    for contact in ("grazing", "pressing"):
        chosen = [row for row in rows if row.contact == contact]
        times = np.array([[row.schedule[0][0] / row.cells,
                           row.schedule[0][1] / row.cells] for row in chosen]
                         ).reshape(-1, 2)
        near = times[:, 1] <= 4.0
        energies = np.array([_least(row) for row in chosen])
        if contact == "grazing":
            axes.plot(times[near, 0], times[near, 1], ".", ms=2,
                      color=colours["faint"], label="grazing")
        elif near.any():
            dots = axes.scatter(
                times[near, 0], times[near, 1], s=5, c=energies[near],
                cmap=colour_map(stops=colours["on_paper"]),
                norm=LogNorm(max(1.0, energies[near].min()),
                             max(energies[near].max(), 1.1)), lw=0)
            axes.figure.colorbar(dots, ax=axes,
                                 label="least energy  E/E$_1$")
    axes.set_xlabel("contact  $t_c$  [L/c]")
    axes.set_ylabel("flight  $t_f$  [L/c]")
    quiet(axes)
    if rows:
        axes.legend(loc="lower right", markerscale=3)
    return axes
