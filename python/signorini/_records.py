"""What the compiled records have from Python: dictionaries, text, and sequences."""

from __future__ import annotations

import marshal
import reprlib
import zlib
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from . import _core
from ._core import Schedule
from ._fields import have_fields
from ._tables import Table, keys_of, plain
from ._words import require_of_bar

#: Letters of a value in a text, and of all phases of a schedule.
LONGEST, ALL_PHASES = 60, 120


def to_dict(record: Any) -> dict[str, Any]:
    """The same as a dictionary, key by key what the program prints as JSON."""
    return {name: plain(value) for name, value, _ in keys_of(record)}


def _itself(record: Any, _: Any = None) -> Any:
    """A copy: no record can be changed."""
    return record


def _shown(record: Any) -> str:
    """Name(key=value, ...), of what has a value."""
    words = []
    for _, name, _ in record._keys:
        value = getattr(record, name)
        if value is not None:
            text = repr(value)
            words.append(f"{name}={'…' if len(text) > LONGEST else text}")
    return f"{type(record).__name__}({', '.join(words)})"


def _interval(of: _core.Mode | _core.ModePolytope) -> str:
    (p, q), (r, s) = of.period_range
    return f"{p}/{q} < T < {r}/{s} L/c"


def _contact(mode: _core.Mode) -> str:
    p, q = mode.contact
    return f"t_c = {p} - {-q} T"


def _energy(of: Any) -> str:
    is_without_gap = of.energy_ratio is None or hasattr(of, "bar") and of.bar.gap == 0
    return f"{of.energy:.6g} J" if is_without_gap else f"{of.energy_ratio:.6g} E_1"


def _result(r: _core.Result) -> str:
    text = (f"{r.status}, {r.schedule._text}, T = {r.period:.6g} s, "
            f"omega/omega_1 = {r.frequency_ratio:.6g}")
    if r.status == "found":
        text += f", E = {_energy(r)}, {r.contact}"
    if r.solution_set and r.solution_set.kind != "empty":
        text += f", {r.solution_set.kind} of dimension {r.solution_set.dimension}"
    return text + ", ".join(["", r.reason] if r.reason else []) + _detail(r)


def _detail(of: Any) -> str:
    return f": {of.detail}" if getattr(of, "detail", None) else ""


def _chains(polytope: _core.ModePolytope) -> str:
    return ", ".join(f"{at.k}/{at.turns}->{at.release}" for at in polytope.chains)


def _steps(schedule: Schedule) -> str:
    phases = schedule.phases
    text = ", ".join(map(repr, phases[0] if len(phases) == 1 and len(phases[0]) == 2
                         else phases[:ALL_PHASES]))
    return text if len(text) <= ALL_PHASES else text[:ALL_PHASES] + "…"


#: What stands in the brackets, where it is not all keys.
_TEXTS: dict[type, Callable[[Any], str]] = {
    _core.Family: lambda f: f"order={f.order}, nu={f.nu}, contact_blocks={f.contact_blocks}, "
    f"T = {2 * f.nu}/{f.order} L/c, E >= {f.least_energy_ratio:.6g} E_1",
    _core.Mode: lambda m: f"{_contact(m)}, {_interval(m)}",
    _core.ModePolytope: lambda p: f"{_chains(p)}, {_interval(p)}, {p.free_times} free",
    _core.ModeMotion: lambda m: f"{_contact(m.mode)}, period_ratio={m.period_ratio:.10g}, "
    f"energy_ratio={m.energy_ratio:.10g}",
    _core.PolytopeMotion: lambda m: f"{len(m.contacts)} contacts, "
    f"period_ratio={m.period_ratio:.10g}, energy_ratio={m.energy_ratio:.10g}",
    _core.ContinuumPoint: lambda p: f"lambda={p.lambda_:.6g}, E = {_energy(p)}, "
    f"peak_strain={p.peak_strain:.6g}",
    _core.SceneContinuumPoint: lambda p: f"lambda={p.lambda_:.6g}, E = {_energy(p)}, "
    f"peak_strain={p.peak_strain:.6g}",
    _core.SceneContinuum: lambda c: f"{c.status}, E = {_energy(c)}, {len(c.points)} points"
    f"{_detail(c)}",
    _core.State: lambda s: f"cells={s.cells}, energy_ratio={s.energy_ratio:.10g}",
    Schedule: lambda s: f"{_steps(s)}, cells={s.cells}",
    _core.Result: _result,
    _core.Motion: lambda m: f"{m.schedule._text}, period_ratio={m.period_ratio:.10g}",
    _core.Continuum: lambda c: f"{c.status}, {c.schedule._text}, E = {_energy(c)}, "
    f"{len(c.points)} points, {c.orbits} orbits{_detail(c)}",
    _core.Waves: lambda w: f"{len(w.a) + len(w.b)} pieces, E = {_energy(w)}",
}


def _written(record: Any) -> str:
    return f"{type(record).__name__}({_TEXTS[type(record)](record)})"


def _sum(kind: Any, content: Any) -> int:
    """Changes with what is held, the class, and the version of the library."""
    # Format 2 writes equal values equally, shared or not.
    maker = f"{_core.__version__} {kind.__name__}".encode()
    return zlib.crc32(marshal.dumps(content, 2), zlib.crc32(maker))


def _be_kept(kind: Any) -> None:
    """Have pickles, and comparing: equal are those of the same bytes."""
    def state_of(self: Any) -> tuple[bytes, int]:
        content = kind._bytes(self, False)
        return content, _sum(kind, content)

    def restore(self: Any, state: Any) -> None:
        try:
            content, total = state
            if _sum(kind, content) != total:
                raise ValueError
            self._take(content)
        except MemoryError:
            raise
        except Exception:
            raise ValueError(
                "a pickle that was damaged, or is of another version of signorini") from None

    def is_equal(one: Any, other: Any) -> Any:
        return _is_same(kind, one, other) if isinstance(other, kind) else NotImplemented

    kind.__getstate__, kind.__setstate__, kind.__eq__ = state_of, restore, is_equal
    kind.__hash__ = lambda self: hash(kind._bytes(self, True))


def _is_same(kind: Any, one: Any, other: Any) -> bool:
    return bool(kind._bytes(one, True) == kind._bytes(other, True))


def _is_schedule(one: Schedule, other: object) -> Any:
    if isinstance(other, Schedule):
        return _is_same(Schedule, one, other)
    return isinstance(other, Sequence) and plain(list(other)) == plain(one.phases)


def _be_a_list_of(kind: Any, name: str, some: Callable[[Any], Any] = list) -> None:
    def count(self: Any) -> int:
        return len(getattr(self, name))

    def item(self: Any, at: Any) -> Any:
        rows = getattr(self, name)[at]
        return some(rows) if isinstance(at, slice) else rows

    def each(self: Any) -> Iterator[Any]:
        return iter(getattr(self, name))

    kind.__len__, kind.__getitem__, kind.__iter__ = count, item, each


def _waves_of(state: _core.State) -> dict[str, list[float]]:
    """Lists of numbers; `a` and `b` in g/L, the others in SI units."""
    return {name: getattr(state, name).tolist()
            for name in ("x", "a", "b", "velocity", "strain", "displacement")}


def _phases_of(schedule: Schedule) -> Any:
    """The pairs, as the program's JSON has them."""
    return plain(schedule.phases)


def _places_of(state: _core.State) -> Any:
    """x_1 ... x_N [m], where each cell ends; of a stepped bar the time that waves need counts."""
    import numpy
    speeds = numpy.repeat([part.speed for part in state.segments] or [1.0],
                          [part.cells for part in state.segments] or [state.cells])
    return numpy.cumsum(speeds / speeds[0]) * (state.bar.length / state.cells)


def _instants_of(motion: _core.Motion) -> Any:
    """t_0 ... t_n [s]."""
    import numpy
    return numpy.arange(motion.steps + 1) * (motion.bar.time_unit / motion.cells)


def _nodes_of(motion: _core.Motion) -> Any:
    """x_0 ... x_N [m], clamp to tip."""
    import numpy
    return numpy.arange(motion.cells + 1) * (motion.bar.length / motion.cells)


#: What the classes that people make take.
_MADE_OF: dict[Any, str] = {
    _core.Bar: "length wave_speed axial_stiffness gap young density area diameter",
    _core.Segment: "cells impedance speed dashpot", Schedule: "*steps cells",
    _core.Scene: "bar second_stop segments", _core.State: "a b bar segments",
    _core.Motion: "state schedule scene"}

_STEPS = ("n_c, n_f of each phase in turn, or pairs of them: ``Schedule(150, 900)``, "
          "``Schedule((1, 12), (3, 12), cells=4)``.")


def _document(kind: Any, names: str) -> None:
    """A section of its docstring with the parameters, as its keys say."""
    said = {"*steps": _STEPS, **_core.options("find")}
    words = [f"{name}\n    {getattr(kind, name).__doc__ if hasattr(kind, name) else said[name]}"
             for name in names.split()]
    kind.__doc__ = "\n".join([f"{kind.__doc__}\n", "Parameters", "-" * 10, *words, "",
                              "Raises", "-" * 6, "ValueError",
                              "    If a value is out of its range, or two of them clash."])


def _by_name(make: Any) -> Any:
    """The same of a bar, whose arguments have names."""
    def init(self: Any, *args: Any, **options: Any) -> None:
        if args:
            raise TypeError(f"Bar({', '.join(map(reprlib.repr, args))}): allowed Bar(*, "
                            f"{_MADE_OF[_core.Bar].replace(' ', ', ')})")
        require_of_bar(options)
        make(self, **options)
    return init


def be_records() -> None:
    """Give the compiled classes what all records have."""
    bar: Any = _core.Bar
    bar.__init__ = _by_name(bar.__init__)
    state: Any = _core.State
    schedule: Any = Schedule
    motion: Any = _core.Motion
    state.x = property(_places_of)
    motion.t, motion.x = property(_instants_of), property(_nodes_of)
    for kind in (motion, _core.ModeMotion, _core.PolytopeMotion):
        have_fields(kind)
    for kind, names in _MADE_OF.items():
        _document(kind, names)
    for kind in vars(_core).values():
        if isinstance(kind, type) and hasattr(kind, "_keys"):
            made: Any = kind
            made.to_dict = to_dict
            made.__copy__, made.__deepcopy__ = _itself, _itself
            if hasattr(kind, "_bytes"):
                _be_kept(kind)
            if "__repr__" not in vars(kind):
                made.__repr__ = _written if kind in _TEXTS else _shown
    state.to_dict = _waves_of
    schedule.to_dict, schedule.__eq__ = _phases_of, _is_schedule
    _be_a_list_of(Schedule, "phases")
    for curve in (_core.Continuum, _core.SceneContinuum):
        _be_a_list_of(curve, "points", lambda rows: Table("points", rows))
