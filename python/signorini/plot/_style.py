"""What all figures share: colours, units, the wall."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from .. import _core

#: The library's own colours: ink, strain, velocity, contact, faint, grid and
#: the maps sequence, diverging, fading. A colour means one thing everywhere.
colours: dict[str, Any] = _core.palette()


class NothingToDraw(ValueError):
    """There is no figure of this."""


def new(*arguments: Any, **options: Any) -> Any:
    """Return a figure that lays itself out."""
    from matplotlib import pyplot
    return pyplot.figure(*arguments, **{"layout": "constrained", **options})


def _require_one(axes: Any, figure: Any) -> None:
    if axes is not None and figure is not None:
        raise ValueError("axes clashes with figure: allowed one of them")


def axes_of(axes: Any, figure: Any, **options: Any) -> Any:
    """Return the axes given, or those of the figure given or a new one."""
    _require_one(axes, figure)
    if axes is not None:
        return axes
    return (figure or new(**options)).add_subplot()


def axes_named(names: Sequence[str], axes: Any, figure: Any,
               make: Callable[[Any], Any], **options: Any) -> dict[str, Any]:
    """Return axes by name: those given, or what `make` puts into a figure.

    A sequence has them in the order of the names.
    """
    _require_one(axes, figure)
    if axes is None:
        axes = make(figure or new(**options))
    if not isinstance(axes, Mapping):
        listed = np.ravel(axes)
        axes = dict(zip(names, listed)) if len(listed) == len(names) else {}
    if set(axes) != set(names):
        raise ValueError(f"axes: allowed {len(names)} of them, in a sequence "
                         f"or by the names {', '.join(names)}")
    return {name: axes[name] for name in names}


def colour_map(name: str = "sequence", stops: int | None = None) -> Any:
    """Return one of the library's maps for matplotlib."""
    from matplotlib.colors import LinearSegmentedColormap
    return LinearSegmentedColormap.from_list(name, colours[name][:stops])


def unit_for(size: float, unit: str) -> tuple[float, str]:
    """Return the factor and name of the prefixed unit that suits a size.

    >>> unit_for(0.002, "m")
    (1000.0, 'mm')
    """
    prefixes = {-4: "p", -3: "n", -2: "µ", -1: "m", 0: "", 1: "k", 2: "M",
                3: "G"}
    power = 0
    if size > 0 and math.isfinite(size):
        power = math.floor(math.log10(size) / 3 + 1e-9)
        power = min(max(power, min(prefixes)), max(prefixes))
    return 10.0 ** (-3 * power), prefixes[power] + unit
