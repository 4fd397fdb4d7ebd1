"""Records as rows of named cells: for pandas frames, and for a notebook."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Generic, NamedTuple, Protocol, TypeVar, overload

from ._core import Schedule


class Row(Protocol):
    """A record with keys."""

    def to_dict(self) -> dict[str, Any]: ...


R = TypeVar("R", bound=Row)


class Cell(NamedTuple):
    """One number, word or truth value of a record, None where there is none."""

    name: str
    value: Any
    unit: str


#: What a docstring says of a pair: "[L/c] (p, q): contact lasts p + q T."
_SAID = re.compile(r"(?:\[(?P<unit>[^]{]*)\] )?(?:\((?P<names>[\w ,]+)\))?")

#: Lists of records, also where they are empty.
_COUNTED = ("segments", "motions", "points", "sets")


def keys_of(record: Any) -> Iterator[tuple[str, Any, str]]:
    """Keys of a record or a dictionary, what they hold, and their docstrings."""
    if isinstance(record, dict):
        for name, value in record.items():
            yield name, value, ""
    elif hasattr(record, "_keys"):
        for name, attribute, lacks in record._keys:
            if lacks is None or not lacks(record):
                said = getattr(type(record), attribute).__doc__
                yield name, getattr(record, attribute), said
    else:
        yield from keys_of(record.to_dict())


def plain(value: Any) -> Any:
    """A value as JSON has it: of records dictionaries, of what is not finite None."""
    if hasattr(value, "to_dict"):
        return value.to_dict()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, dict):
        return {key: plain(held) for key, held in value.items()}
    return value


def is_record(value: Any) -> bool:
    """Is it shown key by key?"""
    return isinstance(value, dict) or (hasattr(value, "_keys") and
                                       not isinstance(value, Schedule))


def text_of(value: Any) -> str:
    """A value as people read it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _phase(phase: Sequence[Any]) -> str:
    return ":".join(map(str, phase))


def _of_schedule(name: str, schedule: Schedule) -> Iterator[Cell]:
    yield Cell(name, ", ".join(map(_phase, schedule)), "")
    if len(schedule) == 1:
        for part, steps in zip(("contact", "free"), schedule[0]):
            yield Cell(f"{part}_steps", steps, "")


def _unit_in(said: str) -> str:
    match = _SAID.match(said)
    unit = match and match["unit"] or ""
    return "" if "..." in unit else unit  # how a list looks


def _names_of(name: str, said: str) -> list[str]:
    """The names of the parts of a pair, if it has some."""
    if name.endswith("_range"):
        return [f"{name[:-len('_range')]}_{end}" for end in ("least", "most")]
    match = _SAID.match(said)
    names = match["names"].split(", ") if match and match["names"] else []
    if "/".join(names) in said and names or name.endswith("_exact"):
        return [name]  # a fraction
    return [f"{name}_{part}" for part in names] if len(names) > 1 else []


def _of_pair(name: str, pair: tuple[Any, ...], said: str, unit: str
             ) -> Iterator[Cell]:
    names = _names_of(name, said)
    if is_record(pair[0]):
        for end, part in zip(("least", "most"), pair):
            for cell in cells_of(part):
                yield cell._replace(name=f"{name}_{end}_{cell.name}")
        return
    if isinstance(pair[0], str):
        yield Cell(name, ", ".join(pair), "")
        return
    if name.endswith("_exact"):
        yield Cell(name, "/".join(map(str, pair)), unit)
        return
    if len(names) == 1:
        yield Cell(name, pair[0] / pair[1], unit)
        return
    if len(names) != len(pair):
        names = [f"{name}_{at}" for at in range(len(pair))]
    for part, value in zip(names, pair):
        if isinstance(value, tuple):
            value = value[0] / value[1]
        yield Cell(part, value, unit)


def _of_list(name: str, values: Sequence[Any], unit: str) -> Cell:
    if name == "stops":
        return Cell(name, ", ".join(f"{stop['side']} {stop['place']:.6g}"
                                    for stop in values), "m")
    if name.endswith("schedule"):
        return Cell(name, ", ".join(map(_phase, values)), "")
    if name in _COUNTED or not all(isinstance(value, (int, float, str))
                                   for value in values):
        return Cell(name, len(values), "")
    return Cell(name, ", ".join(map(text_of, values)), unit)


def cells_of_key(name: str, value: Any, said: str) -> Iterator[Cell]:
    """The cells of one key.

    Records and pairs have a cell for each part, a list of numbers or words
    is text, of a list of records there is the length.
    """
    unit = _unit_in(said)
    if isinstance(value, Schedule):
        yield from _of_schedule(name, value)
    elif is_record(value):
        for part in cells_of(value):
            yield part._replace(name=f"{name}.{part.name}")
    elif isinstance(value, tuple):
        yield from _of_pair(name, value, said, unit)
    elif isinstance(value, list):
        yield _of_list(name, value, unit)
    elif value is None:
        for called in _names_of(name, said) or [name]:
            yield Cell(called, None, unit)
    else:
        yield Cell(name, value, unit)


def cells_of(record: Any) -> Iterator[Cell]:
    """All cells of a record, in the order of its keys."""
    for key in keys_of(record):
        yield from cells_of_key(*key)


def flat(record: Any) -> dict[str, Any]:
    """The row of a record in a frame: numbers, words and truth values."""
    return {cell.name: cell.value for cell in cells_of(record)}


def frame_of(rows: Iterable[dict[str, Any]]) -> Any:
    """A pandas frame, one row a dictionary. ImportError without pandas.

    What is None in all rows is a column of numbers, none of them known.
    """
    import pandas
    listed = list(rows)
    columns = {name: [row.get(name) for row in listed]
               for name in dict.fromkeys(name for row in listed for name in row)}
    # Where some rows have a record its parts are columns.
    whole = {name.rpartition(".")[0] for name in columns}
    kinds = {name: {type(value) for value in column} for name, column in columns.items()}
    return pandas.DataFrame({
        name: [math.nan] * len(column) if kinds[name] == {type(None)}
        else pandas.array(column, "boolean") if kinds[name] == {bool, type(None)} else column
        for name, column in columns.items() if name not in whole})


class Table(Sequence[R], Generic[R]):
    """Records in a row: an immutable sequence with `frame` and `to_dict`.

    Parameters
    ----------
    name : str
        What the rows are, a key of the program's JSON.
    rows : sequence of records
    head : dict
        What else the answer says; each key is an attribute, too.
    """

    def __init__(self, name: str, rows: Sequence[R], **head: Any) -> None:
        self._name = name
        self._rows = tuple(rows)
        self._head = head

    @overload
    def __getitem__(self, at: int) -> R: ...
    @overload
    def __getitem__(self, at: slice) -> Table[R]: ...

    def __getitem__(self, at: int | slice) -> R | Table[R]:
        if isinstance(at, slice):
            return Table(self._name, self._rows[at], **self._head)
        return self._rows[at]

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[R]:
        return iter(self._rows)

    @property
    def count(self) -> int:  # type: ignore[override]
        """How many rows: a key of answers, in place of Sequence's method."""
        return len(self._rows)

    @property
    def found(self) -> bool:
        """Is there a row?"""
        return len(self._rows) > 0

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Table):
            return self._rows == other._rows and self._head == other._head
        if isinstance(other, list) and not self._head:
            return list(self._rows) == other
        return NotImplemented

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name in ("_name", "_rows", "_head"):
            raise AttributeError(name)
        if name == self._name:
            return list(self._rows)
        try:
            return self._head[name]
        except KeyError:
            raise AttributeError(
                f"a table of {self._name} has no {name!r}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), self._name, *self._head]

    def __repr__(self) -> str:
        shown = [f"  {row!r}" for row in self._rows[:5]]
        if len(self) > 5:
            shown.append(f"  … {len(self) - 5} more")
        return "\n".join([f"{len(self)} {self._name}", *shown])

    def to_dict(self) -> dict[str, Any]:
        """The same as a dictionary, with the keys of the program's JSON."""
        head: dict[str, Any] = plain(self._head)
        return {**head, self._name: [row.to_dict() for row in self._rows]}

    def frame(self) -> Any:
        """Return a pandas DataFrame, one row a record, one column a number.

        Parts have columns of their own: `physical.impulse`, and of a range
        `energy_ratio_least` and `energy_ratio_most`.

        Raises
        ------
        ImportError
            Where pandas is not installed.
        """
        return frame_of(map(flat, self._rows))
