"""The table of signorini-bench, and what can be read off it."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

TEXTS = ("suite", "case", "back_end", "formulation", "setting", "outcome",
         "claim", "detail", "provenance")


@dataclass
class Record:
    """One measurement: texts that name it, and figures that are known."""

    suite: str
    case: str
    back_end: str
    formulation: str
    setting: str
    outcome: str
    claim: str = ""
    detail: str = ""
    provenance: str = ""
    figures: dict[str, float] = field(default_factory=dict)

    def figure(self, name: str) -> float:
        """Return a figure, NaN if it is not known."""
        return self.figures.get(name, math.nan)

    @property
    def key(self) -> str:
        """What tells it from the others."""
        return "/".join((self.suite, self.case, self.back_end,
                         self.formulation, self.setting))

    @property
    def is_ours(self) -> bool:
        """Does it measure the library, and not a back end?"""
        return self.back_end in ("signorini", "closed-form")

    @property
    def was_tried(self) -> bool:
        """Not if the back end is absent or refuses such programs."""
        return self.outcome not in ("absent", "refused", "reference")

    @property
    def is_claim(self) -> bool:
        """Did it claim something?"""
        return self.claim in ("found", "none")

    def is_right_within(self, error: float) -> bool:
        """Is the verdict right, and the error, if any, at most this?"""
        if self.claim == "none":
            return self.outcome == "right"
        return (self.claim == "found" and self.outcome != "wrong"
                and not self.figure("error") > error)


Table = list[Record]


def read(path: Path) -> Table:
    """Return all whole rows; one cut short by a crash is dropped."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        names = next(rows)
        return [record_of(dict(zip(names, row))) for row in rows
                if len(row) == len(names)]


def record_of(row: dict[str, str]) -> Record:
    """Return one row, its texts and its numbers."""
    figures = {name: float(value) for name, value in row.items()
               if name not in TEXTS and value}
    return Record(*(row[name] for name in TEXTS), figures=figures)


def distinct(values: Iterable[str]) -> list[str]:
    """Return each value once, in the order of first appearance."""
    return list(dict.fromkeys(values))


# A state of so many cells, 16 bytes each, stays in a second-level cache of 1 MB:
# beyond it caches and page faults set the slope, not the work.
MOST_CELLS_IN_CACHE = 65_536


def power_law(points: list[tuple[float, float]]) -> float:
    """Return the exponent of y = f x^e, least squares in logarithms.

    x are cells; only those are looked at whose state stays in the cache.
    """
    logs = [(math.log(x), math.log(y)) for x, y in points
            if 0 < x <= MOST_CELLS_IN_CACHE and y > 0]
    n = len(logs)
    sx = sum(x for x, _ in logs)
    sy = sum(y for _, y in logs)
    spread = n * sum(x * x for x, _ in logs) - sx * sx
    if n < 2 or spread <= 0:
        return math.nan
    return (n * sum(x * y for x, y in logs) - sx * sy) / spread


def profiles(table: Table) -> dict[str, list[tuple[float, float]]]:
    """Return performance profiles (Dolan and More 2002) by back end.

    [(factor, share)]: the share of cases done right within so many times the
    best time of any; what is not right took for ever.
    """
    best: dict[str, float] = {}
    for r in table:
        time = r.figure("seconds_median") if r.outcome == "right" else math.inf
        best[r.case] = min(best.get(r.case, math.inf), time)
    curves = {}
    for who in distinct(r.back_end for r in table):
        ratios = sorted(r.figure("seconds_median") / best[r.case]
                        for r in table
                        if r.back_end == who and r.outcome == "right")
        curves[who] = [(ratio, (k + 1) / len(best))
                       for k, ratio in enumerate(ratios)]
    return curves


def where(table: Table, condition: Callable[[Record], bool]) -> Table:
    """Return the records for which it holds."""
    return [r for r in table if condition(r)]


def total_seconds(r: Record) -> float:
    """Writing the program down and solving it."""
    pose = r.figure("pose_seconds")
    return r.figure("seconds_median") + (0.0 if math.isnan(pose) else pose)
