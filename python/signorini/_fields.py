"""What a motion does at places and instants: in SI units, or without."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import _core

#: Of each field [its unit, and that of its ratio] the unit of the bar, and what it is.
_FIELDS = {
    "displacement": ("displacement_unit", "u(x, t) [{}]", "m", "g"),
    "velocity": ("velocity_unit", "v(x, t) [{}]", "m/s", "c g/L"),
    "strain": ("strain_unit", "s(x, t), tension > 0, [{}]", "-", "g/L")}


def _out_of_range(name: str, values: Any, is_in: Any, allowed: str) -> str:
    """The first of them that is, if any."""
    import numpy
    wrong = numpy.atleast_1d(values)[~numpy.atleast_1d(is_in)]
    return f"{name} = {wrong[0]:.10g} is out of range: allowed {allowed}" if wrong.size else ""


def _finite(t: Any) -> Any:
    """Instants."""
    import numpy
    instants = _core.numbers(t, "t")
    fault = _out_of_range("t", instants, numpy.isfinite(instants), "finite numbers")
    if fault:
        raise ValueError(fault)
    return instants


def _cells_of(motion: Any) -> int:
    """In which the compiled fields count lengths and times: 1 on no grid."""
    return getattr(motion, "cells", 1)


def _field(name: str, unit: str, doc: str, length: str, time: str) -> Callable[..., Any]:
    is_ratio = length == "L"

    def at(self: Any, x: Any, t: Any) -> Any:
        import numpy
        most, second, scale = (1.0, 1.0, 1.0) if is_ratio else (
            self.bar.length, self.bar.time_unit, getattr(self.bar, unit))
        places, instants = numpy.broadcast_arrays(_core.numbers(x, "x"), _finite(t))
        fault = _out_of_range("x", places, (places >= 0.0) & (places <= most),
                              f"0..{most:.10g} [{length}]")
        if fault:
            raise ValueError(fault)
        cells = _cells_of(self)
        return scale * getattr(self, f"_{name}")(places / most * cells, instants / second * cells)

    at.__name__ = at.__qualname__ = name
    at.__doc__ = (f"{doc} at x [{length}] and t [{time}], any arrays that NumPy can broadcast "
                  "together.")
    return at


def _wall_force(self: Any, t: Any) -> Any:
    """Force of the tip on the wall [N] at t [s], any array; 0 in flight."""
    return self.bar.force_unit * _wall_force_ratio(self, _finite(t) / self.bar.time_unit)


def _wall_force_ratio(self: Any, t: Any) -> Any:
    """Force of the tip on the wall [EA g/L] at t [L/c], any array."""
    return self._wall_force(0.0, _finite(t) * _cells_of(self))


def have_fields(kind: Any) -> None:
    """Give a class of motions the methods of its fields."""
    for name, (unit, doc, si, ratio) in _FIELDS.items():
        setattr(kind, name, _field(name, unit, doc.format(si), "m", "s"))
        setattr(kind, f"{name}_ratio", _field(name, unit, doc.format(ratio), "L", "L/c"))
    kind.wall_force, kind.wall_force_ratio = _wall_force, _wall_force_ratio
