"""Sweeps and studies: against simulations, and what a file keeps."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import signorini as sg

SMALL: dict[str, Any] = {"force": "tip", "start": 0.9, "to": 1.2, "points": 4,
                         "cells": 12, "periods": 200}


def test_a_sweep_ends_where_a_simulation_does() -> None:
    seen = sg.sweep("frequency", 1.1, 1.1, force="tip", damping=0.05,
                    amplitude=3e-4, points=1, cells=33, direction="up")
    point, = seen.points
    run = sg.simulate(force="tip", damping=0.05, amplitude=3e-4, cells=33,
                      frequency=1.1, periods=300)
    assert run.settled is not None and point.periods == run.settled.periods
    assert point.contacts * point.periods == run.settled.contacts
    assert point.impulse * point.periods == pytest.approx(run.settled.impulse)


def test_a_study_is_sweeps(tmp_path: Path) -> None:
    table = sg.study(gap=[5e-4, 1e-3], damping=[0.03, 0.1], amplitude=2e-4,
                     threads=2, file=tmp_path / "s.csv", **SMALL)
    assert len(table) == 4
    assert [(p.gap, p.damping) for p in table] == [
        (5e-4, 0.03), (5e-4, 0.1), (1e-3, 0.03), (1e-3, 0.1)]
    seen = sg.sweep("frequency", 0.9, 1.2, force="tip", damping=0.1,
                    amplitude=2e-4, points=4, cells=12, periods=200, gap=5e-4)
    assert table[1].impulse == max(p.impulse_range[1] for p in seen.points)
    again = sg.study(gap=[5e-4, 1e-3], damping=[0.03, 0.1], amplitude=2e-4,
                     file=tmp_path / "s.csv", **SMALL)
    assert again == table
    assert len(list(tmp_path.iterdir())) == 1


def test_a_study_goes_on_from_its_file(tmp_path: Path) -> None:
    file = tmp_path / "s.csv"
    part = sg.study(gap=1e-3, damping=0.05, amplitude=2e-4, file=file, **SMALL)
    asked: list[float] = []
    whole = sg.study(gap=1e-3, damping=0.05, amplitude=[1e-4, 2e-4], file=file,
                     progress=lambda done, total: asked.append(done), **SMALL)
    assert asked == [2] and whole[1] == part[0]
    with pytest.raises(ValueError, match="another question"):
        sg.study(gap=1e-3, damping=0.05, amplitude=2e-4, file=file,
                 **dict(SMALL, points=3))
    file.write_text(file.read_text("utf-8").replace("0.05,0.0002,", "0.05,0.0002,x"), "utf-8")
    with pytest.raises(ValueError, match="a row of a study"):
        sg.study(gap=1e-3, damping=0.05, amplitude=2e-4, file=file, **SMALL)


def test_wrong_studies_are_refused() -> None:
    spoilt: list[dict[str, Any]] = [
        {"gap": []}, {"damping": -1.0}, {"amplitude": float("nan")},
        {"force": "rope"}]
    for one in spoilt:
        asked: dict[str, Any] = {"gap": 1e-3, "damping": 0.05,
                                 "amplitude": 2e-4, **SMALL, **one}
        with pytest.raises(ValueError):
            sg.study(**asked)
