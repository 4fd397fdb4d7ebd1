"""Draws figures that the library made as data: the only place that knows how.

A figure is a dictionary, FigureData of include/signorini/figure_data.hpp:
panels with axes, series, legend and words.
"""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np

from ._style import axes_named, colours

MARKERS = {"disc": "o", "ring": "o", "cross": "x", "square": "s",
           "diamond": "D", "open diamond": "D", "triangle": "^"}
DASHES: dict[str, Any] = {"solid": "-", "dashed": "--", "dotted": ":",
                          "long dashed": (0, (10, 4))}
LEGENDS = {"top left": "upper left", "top right": "upper right",
           "bottom left": "lower left", "bottom right": "lower right",
           "above": "lower right", "below": "best"}
BELOW = 0.55  # inches, of an axis with numbers and label
INCHES = 0.52  # a centimetre of a figure on paper


def markup(text: str) -> str:
    """Return words with ω_1 and E_{max} as matplotlib writes them."""
    return re.sub(r"([_^])(?:\{([^}]*)\}|(\w))",
                  lambda m: f"${m[1]}{{\\mathrm{{{m[2] or m[3]}}}}}$",
                  text)


def _numbers(values: list[float | None]) -> Any:
    return np.array(values, dtype=float)


def _norm(panel: dict[str, Any]) -> Any:
    from matplotlib.colors import LogNorm, Normalize
    axis = panel["colour"]
    return (LogNorm if axis["isLogarithmic"] else Normalize)(axis["low"],
                                                             axis["high"])


def _map(panel: dict[str, Any]) -> Any:
    from matplotlib.colors import LinearSegmentedColormap, ListedColormap
    colours = panel["map"]
    return (ListedColormap(colours) if panel["isStepped"] else
            LinearSegmentedColormap.from_list(panel["name"], colours))


def _line(axes: Any, one: dict[str, Any], style: dict[str, Any]) -> None:
    axes.plot(_numbers(one["x"]), _numbers(one["y"]), color=one["colour"],
              ls=DASHES[one["dash"]], lw=0.8 * one["width"], **style)


def _dots(axes: Any, one: dict[str, Any], style: dict[str, Any],
          paint: dict[str, Any]) -> Any:
    size = 5.0 * one["size"]
    marker = MARKERS[one["marker"]]
    if one["z"]:
        return axes.scatter(one["x"], one["y"], s=size * size, c=one["z"],
                            marker=marker, lw=0, **paint, **style)
    is_open = one["marker"] in ("ring", "open diamond")
    axes.plot(one["x"], one["y"], marker, ls="", ms=size, color=one["colour"],
              mfc="none" if is_open else one["colour"], mew=0.8, **style)
    return None


def _strokes(axes: Any, one: dict[str, Any], style: dict[str, Any]) -> None:
    from matplotlib.collections import LineCollection
    ends = np.stack([np.stack([one["x"], one["y"]], -1),
                     np.stack([one["x2"], one["y2"]], -1)], 1)
    axes.add_collection(LineCollection(
        list(ends), colors=one["colour"], lw=0.8 * one["width"],
        ls=DASHES[one["dash"]], capstyle="butt", **style))


def _areas(axes: Any, one: dict[str, Any], style: dict[str, Any],
           paint: dict[str, Any]) -> Any:
    from matplotlib.collections import PolyCollection
    if one["kind"] == "band":
        x, y = _numbers(one["x"]), _numbers(one["y"])
        if one["y2"]:
            axes.fill_between(x, y, _numbers(one["y2"]), color=one["colour"],
                              alpha=one["opacity"], lw=0, **style)
        else:
            axes.fill(x, y, color=one["colour"], alpha=one["opacity"], lw=0,
                      **style)
        return None
    corners = [[(left, low), (right, low), (right, high), (left, high)]
               for left, low, right, high
               in zip(one["x"], one["y"], one["x2"], one["y2"])]
    hatch = {"hatch": "////", "facecolor": "none",
             "edgecolor": one["colour"]} if one["isHatched"] else {}
    boxes = PolyCollection(
        corners, alpha=one["opacity"], lw=0, **style,
        **(paint if one["z"] else hatch or {"facecolor": one["colour"]}))
    if one["z"]:
        boxes.set_array(_numbers(one["z"]))
    axes.add_collection(boxes)
    return boxes if one["z"] else None


def _image(axes: Any, one: dict[str, Any], paint: dict[str, Any]) -> Any:
    x, y = one["x"], one["y"]
    half = [(values[-1] - values[0]) / max(len(values) - 1, 1) / 2
            for values in (x, y)]
    return axes.imshow(
        _numbers(one["z"]).reshape(len(y), len(x)), origin="lower",
        aspect="auto", interpolation="nearest", **paint,
        extent=(x[0] - half[0], x[-1] + half[0], y[0] - half[1],
                y[-1] + half[1]))


def _words(axes: Any, one: dict[str, Any]) -> None:
    where = {"transform": axes.transAxes} if one["isInPanel"] else {
        "clip_on": True}
    for x, y, text in zip(one["x"], one["y"], one["words"]):
        axes.text(x, y, markup(text), rotation=one["turn"], va="center",
                  ha={"centre": "center"}.get(one["align"], one["align"]),
                  color=one["colour"], fontsize=9 * one["size"], **where)


def _series(axes: Any, one: dict[str, Any], panel: dict[str, Any]) -> Any:
    """Draw a series; returns what a colour bar is for."""
    style = {"label": markup(one["legend"])} if one["legend"] else {}
    paint = {"norm": _norm(panel), "cmap": _map(panel)}
    kind = one["kind"]
    if kind == "dots":
        return _dots(axes, one, style, paint)
    if not one["x"] or kind == "line":
        _line(axes, one, style)
    elif kind == "strokes":
        _strokes(axes, one, style)
    elif kind == "image":
        return _image(axes, one, paint)
    elif kind in ("band", "boxes"):
        return _areas(axes, one, style, paint)
    elif kind == "words":
        _words(axes, one)
    else:
        for x, y, to_x, to_y in zip(one["x"], one["y"], one["x2"], one["y2"]):
            axes.annotate("", (to_x, to_y), (x, y), arrowprops={
                "arrowstyle": "-|>", "color": one["colour"]})
    return None


def _axis(axes: Any, side: str, axis: dict[str, Any]) -> None:
    if axis["isLogarithmic"]:
        axes.set(**{f"{side}scale": "log"})
    low, high = axis["low"], axis["high"]
    axes.set(**{f"{side}lim": (low, high), f"{side}label":
                markup(axis["label"])})
    ruler = getattr(axes, f"{side}axis")
    if axis["ticks"]:
        ruler.set_ticks([at for at, _ in axis["ticks"]],
                        [text for _, text in axis["ticks"]])
        ruler.set_ticks([], minor=True)
        axes.set(**{f"{side}lim": (low, high)})
    elif axis["step"]:
        from matplotlib.ticker import MultipleLocator
        ruler.set_major_locator(MultipleLocator(axis["step"]))
    if not axis["hasNumbers"]:
        axes.tick_params(axis=side, **{"labelbottom" if side == "x" else
                                       "labelleft": False})
    other = axis.get("other")
    if other:
        factor = other["factor"]
        there = ((lambda v: factor / np.maximum(v, 1e-9),) * 2
                 if other["isInverse"] else
                 (lambda v: v * factor, lambda v: v / factor))
        second = (axes.secondary_xaxis("top", functions=there) if side == "x"
                  else axes.secondary_yaxis("right", functions=there))
        second.set(**{f"{side}label": markup(other["label"])})
        if other["ticks"]:
            ruler = getattr(second, f"{side}axis")
            ruler.set_ticks(other["ticks"], [f"{tick:g}" for tick in other["ticks"]])
            ruler.set_ticks([], minor=True)


def draw_panel(axes: Any, panel: dict[str, Any], places: bool) -> None:
    """Draw a panel into axes; `places`: the colour bar has its place."""
    painted = [made for made in (_series(axes, one, panel)
                                 for one in panel["series"])
               if made is not None]
    axes.autoscale_view()
    if not panel["isFramed"]:
        axes.axis("off")
    _axis(axes, "x", panel["x"])
    _axis(axes, "y", panel["y"])
    if panel["isEqual"]:
        axes.set_aspect("equal")
    if panel["hasGrid"]:
        axes.grid(color=colours["grid"], linewidth=0.5)
    axes.set_axisbelow(True)
    if panel["title"]:
        axes.set_title(markup(panel["title"]), fontsize="medium")
    count = len(axes.get_legend_handles_labels()[0])
    if panel["legend"] != "none" and count:
        how: dict[str, Any] = {"loc": LEGENDS[panel["legend"]]}
        if panel["legend"] == "above":
            how.update(bbox_to_anchor=(1.0, 1.0), ncols=4, frameon=False)
        elif panel["legend"] == "below" and places:
            left, right, low, _ = panel["place"]
            under = low - BELOW / axes.figure.get_figheight()
            rows = panel["legendRows"] or count
            how.update(loc="upper left", bbox_to_anchor=(left, 0.0, right - left, under),
                       bbox_transform=axes.figure.transFigure, borderaxespad=0.0,
                       ncols=math.ceil(count / rows), frameon=False)
        axes.legend(fontsize="small", **how)
    if panel["colourBar"] and painted:
        left, right, low, high = panel["colourBar"]
        where = ({"cax": axes.figure.add_axes(
            (left, low, right - left, high - low))} if places else
            {"ax": axes})
        axes.figure.colorbar(painted[0], label=markup(
            panel["colour"]["label"]), **where)


def draw(text: str, names: tuple[str, ...], axes: Any = None,
         figure: Any = None) -> dict[str, Any]:
    """Draw the panels of these names of a figure in JSON.

    Into the axes given, or into the figure given or a new one.
    """
    data = json.loads(text)
    panels = {panel["name"]: panel for panel in data["panels"]}

    def make(made: Any) -> dict[str, Any]:
        if data["title"]:
            made.suptitle(markup(data["title"]), fontsize="medium")
        placed = {}
        for name in names:
            if name not in panels:
                placed[name] = made.add_axes((0.9, 0.9, 0.01, 0.01))
                continue
            left, right, low, high = panels[name]["place"]
            placed[name] = made.add_axes((left, low, right - left, high - low))
        return placed

    given = axes is not None
    drawn = axes_named(names, axes, figure, make, layout=None, figsize=(
        INCHES * data["width"], INCHES * data["height"]))
    for name in names:
        if name in panels:
            draw_panel(drawn[name], panels[name], not given)
        else:
            drawn[name].axis("off")
    return drawn
