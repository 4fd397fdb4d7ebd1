"""The report of signorini-bench: exponents, profiles, words and figures."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import report  # noqa: E402
import report_figures  # noqa: E402
import report_table as tables  # noqa: E402


def row(case: str, who: str, outcome: str, time: float, **more: float
        ) -> tables.Record:
    """A measurement."""
    return tables.Record("s", case, who, "f", "x", outcome, claim="found",
                         figures={"seconds_median": time, **more})


def test_exponents() -> None:
    points = [(n, 3.0 * n * n) for n in (1.0, 10.0, 100.0)]
    assert tables.power_law(points) == pytest.approx(2.0)
    # Caches and page faults beyond are not the work's exponent.
    jump = [*points, (1e5, 1e13), (1e6, 1e18)]
    assert tables.power_law(jump) == pytest.approx(2.0)
    assert math.isnan(tables.power_law([(1.0, 1.0)]))


def test_profiles() -> None:
    curves = tables.profiles([
        row("p", "quick", "right", 1.0), row("p", "slow", "right", 4.0),
        row("q", "quick", "wrong", 0.1), row("q", "slow", "right", 2.0)])
    assert curves == {"quick": [(1.0, 0.5)],
                      "slow": [(1.0, 0.5), (4.0, 1.0)]}


def test_a_row_is_read_as_it_was_written(tmp_path: Path) -> None:
    path = tmp_path / "results.csv"
    names = ",".join([*tables.TEXTS, "cells", "error"])
    path.write_text(f'{names}\ns,"a, ""b""",x,-,1e-06,right,found,"two lines",'
                    "12345678,300,\ns,cut")
    (record,) = tables.read(path)
    assert record.case == 'a, "b"' and record.figure("cells") == 300
    assert math.isnan(record.figure("error"))


def test_numbers_have_units() -> None:
    assert [report.seconds(t) for t in (3e-8, 2e-6, 0.0015, 2.0, math.nan)] \
        == ["30 ns", "2 µs", "1.5 ms", "2 s", "–"]


def test_each_solver_looks_different() -> None:
    looks = list(report_figures.STYLES.values())
    assert len(set(looks)) == len(looks)
    markers = [marker for _, marker in looks]
    assert len(set(markers)) == len(markers)


def test_a_report_is_made_from_the_table_alone(tmp_path: Path) -> None:
    head = [*tables.TEXTS, "cells", "tolerance", "seconds_median", "error"]
    rows = [",".join(head)]
    for cells in (10, 100):
        rows.append(f"scaling,N = {cells},signorini,-,verdict,right,found,,"
                    f"12345678,{cells},1e-6,{1e-6 * cells},0")
    rows.append("accuracy,A ,ipopt,sy,any 1e-06,wrong,none,,12345678,300,"
                "1e-6,1e-3,0.5")
    (tmp_path / "results.csv").write_text("\n".join(rows) + "\n")
    assert report.main([str(tmp_path)]) == 0
    text = (tmp_path / "report.md").read_text()
    assert "| verdict | 1.00 | 10 … 100 | 10 µs | 100 µs | – |" in text
    assert "## Our own failures\n\nNone" in text
    assert "| A  | ipopt | sy | any 1e-06 | none | wrong | 0.5 | – |" in text
    assert (tmp_path / "scaling.png").read_bytes()[:4] == b"\x89PNG"
    assert report.main([]) == 2
    assert report.main([str(tmp_path / "nothing")]) == 4
