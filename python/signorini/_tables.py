"""Lists of records that become pandas frames."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Generic, Protocol, TypeVar, overload


class Row(Protocol):
    """A record with keys."""

    def to_dict(self) -> dict[str, Any]: ...


R = TypeVar("R", bound=Row)


def frame_of(rows: Sequence[dict[str, Any]]) -> Any:
    """A pandas frame, one row a dictionary. ImportError without pandas."""
    import pandas
    return pandas.DataFrame(list(rows))


def flat(row: dict[str, Any]) -> dict[str, Any]:
    """Fractions [p, q] as numbers, what else is nested as it is."""
    return {key: tuple(value) if isinstance(value, list) else value
            for key, value in row.items()}


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

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Table):
            return self._rows == other._rows and self._head == other._head
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
        def plain(value: Any) -> Any:
            if isinstance(value, list):
                return [plain(one) for one in value]
            return value.to_dict() if hasattr(value, "to_dict") else value

        head = {key: plain(value) for key, value in self._head.items()}
        return {**head, self._name: [row.to_dict() for row in self._rows]}

    def frame(self) -> Any:
        """Return a pandas DataFrame, one row a record.

        Raises
        ------
        ImportError
            Where pandas is not installed.
        """
        return frame_of([flat(row.to_dict()) for row in self._rows])
