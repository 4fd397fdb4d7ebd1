"""Atlases: every schedule of a range, decided into an SQLite file."""

from __future__ import annotations

import os
from typing import Any

from . import _core
from ._asking import asks, gathered
from ._core import AtlasFamily, AtlasRun, AtlasSchedule, Bar, Scene
from ._progress import Progress
from ._tables import Table
from ._words import Number, Quantity, Segments, bar_of, fraction_of, in_words
from ._words import path as path_of


class Atlas:
    """An atlas in a file, to be queried.

    The file is SQLite: any other tool can query it, too. Tables `families`,
    `schedules`, `runs`.

    Parameters
    ----------
    database : str or path
        A file that `Atlas.build` or ``signorini atlas`` made.
    bar : Bar, optional
        What units mean in SI; or its parameters as keywords, `length=`, ...

    Raises
    ------
    OSError
        If the file cannot be read, or is no atlas.
    """

    def __init__(self, database: str | os.PathLike[str], *,
                 bar: Bar | None = None, **bar_options: Quantity | None) -> None:
        self.database = path_of("database", database)
        self.bar = bar_of(bar, bar_options)
        self._file = _core.AtlasFile(self.database, self.bar)
        scene = next((run.scene for run in self._file.runs()), None)
        self._units: dict[str, Any] = {"scene": scene} if scene else {"bar": self.bar}

    @classmethod
    @asks("atlas")
    def build(cls, database: str | os.PathLike[str], *, cells: int | None = None,
              max_contact: int | None = None, max_free: int | None = None,
              phases: int = 1, max_energy_ratio: float | None = None,
              all: bool = False, families_only: bool = False,
              resume: bool = False, threads: int = 1,
              bar: Bar | None = None, scene: Scene | str | None = None,
              gravity: Quantity = 0.0, second_stop: Quantity | None = None,
              segments: Segments | None = None, progress: Progress = None,
              **bar_options: Quantity | None) -> Atlas:
        """Decide every schedule of a range, store the results, open the file.

        An interrupted run loses only the batches in progress; the same
        call with `resume` continues it. The sign of the bar's gap decides
        what exists. Of bars in a row each phase closes one contact.

        Parameters
        ----------
        scene : Scene or str, optional
            In place of `bar`, `second_stop` and `segments`; or the words of several
            bars.

        Returns
        -------
        Atlas

        Raises
        ------
        ValueError
            If an argument is out of its range, or the file holds an
            unfinished run and `resume` is not set.
        OSError
            If the file cannot be used.
        """
        if in_words(scene) and cells is not None:
            raise ValueError("cells: allowed only without a scene of words")
        asked = gathered(locals())
        asked["path"] = path_of("database", database)
        _core.build_atlas(asked)
        return cls(asked["path"], bar=asked["scene"].bar)

    @property
    def runs(self) -> Table[AtlasRun]:
        """The runs, completed or interrupted."""
        return Table("runs", self._file.runs())

    def _rows(self, name: str, cells: int | None, near: tuple[Number, float, float] | None = None,
              period: Number | None = None) -> Table[Any]:
        """Families or schedules, all or those that are asked for."""
        point = near and (float(fraction_of(near[0], "frequency_ratio")), *near[1:])
        exact = None if period is None else fraction_of(period, "period").as_integer_ratio()
        rows = getattr(self._file, name)(cells, point, exact)
        return Table(name, rows, **self._units)

    def families(self, cells: int | None = None) -> Table[AtlasFamily]:
        """Return the sets of orbits of all grids, or of one."""
        return self._rows("families", cells)

    def schedules(self, cells: int | None = None) -> Table[AtlasSchedule]:
        """Return the schedules with motions, of all grids, or of one."""
        return self._rows("schedules", cells)

    def near(self, frequency_ratio: Number, energy_ratio: float, *,
             within: float = 0.001,
             cells: int | None = None) -> Table[AtlasFamily]:
        """Return the families near a point of the plot, nearest first.

        Parameters
        ----------
        frequency_ratio : float, str or Fraction
            omega/omega_1.
        energy_ratio : float
            E/E_1.
        within : float
            How near, relative.
        cells : int, optional
            Of one grid.
        """
        return self._rows("families", cells, (frequency_ratio, energy_ratio, within))

    def schedules_near(self, frequency_ratio: Number, energy_ratio: float, *,
                       within: float = 0.001,
                       cells: int | None = None) -> Table[AtlasSchedule]:
        """Return the schedules near a point of the plot, as `near` does."""
        return self._rows("schedules", cells, (frequency_ratio, energy_ratio, within))

    def of_period(self, period: Number, *,
                  cells: int | None = None) -> Table[AtlasFamily]:
        """Return the families of one period, as 3.5 or "7/2" [L/c]."""
        return self._rows("families", cells, period=period)

    def schedules_of_period(self, period: Number, *,
                            cells: int | None = None) -> Table[AtlasSchedule]:
        """Return the schedules of one period, including refuted ones."""
        return self._rows("schedules", cells, period=period)

    def twins(self, cells: int | None = None
              ) -> list[tuple[list[AtlasFamily], list[AtlasSchedule]]]:
        """Return groups of different orbits of equal period and energy."""
        return self._file.twins(cells)

    def query(self, sql: str, parameters: tuple[Any, ...] = ()) -> Any:
        """Query in SQL; returns a pandas frame if pandas is installed, else rows.

        The file is opened read-only.
        """
        import sqlite3
        from urllib.parse import quote
        place = f"file:{quote(os.path.abspath(self.database))}?mode=ro"
        with sqlite3.connect(place, uri=True) as connection:
            try:
                import pandas
            except ImportError:
                return connection.execute(sql, parameters).fetchall()
            return pandas.read_sql_query(sql, connection, params=parameters)

    def __reduce__(self) -> tuple[Any, ...]:
        return _open, (self.database, self.bar)

    def __repr__(self) -> str:
        runs = ", ".join(f"N = {run.cells}" for run in self.runs)
        return f"Atlas({self.database!r}, {runs})"


def _open(database: str, bar: Bar) -> Atlas:
    return Atlas(database, bar=bar)
