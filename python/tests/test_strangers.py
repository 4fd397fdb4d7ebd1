"""Untrusted arguments: any kind, size and shape gets an answer or an error.

An error names one of the arguments that were changed. The same examples in
every run.
"""

from __future__ import annotations

import faulthandler
import math
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import signorini as sg

NUMBERS: list[Any] = [
    0, 1, -1, 2, 3, 7, 2 ** 31, -2 ** 63, 2 ** 63 - 1, 2 ** 63, 2 ** 64,
    10 ** 30, -10 ** 400, 10 ** 400, 0.0, -0.0, 0.5, 1.5, -1.5, 3.5, 1e-320,
    1e300, -1e300, math.nan, math.inf, -math.inf, True, Fraction(7, 2),
    Decimal("3.5"), Decimal("nan"), np.float32(1.5), np.int8(3), np.uint64(5),
    np.float64("nan"), np.bool_(True)]
OTHERS: list[Any] = [
    None, "", "x", "7/2", "1/0", "nan", "\0", "\ud800", "auto", "tip", "base",
    b"", b"x", 1j, [], [1], [1.5, "x"], [[]], {}, {"a": 1}, (), (1,), (1, 2),
    (1, 2, "left"), (1, 2, 3, 4), set(), object(), int, len, slice(1),
    sg.Bar(), sg.Scene(), sg.Schedule(5, 30, cells=10), sg.Segment(3),
    [sg.Segment(3)], [(4, 1.0), (4, 1.3)], [(1.5, 1.0)], [(3, "x")],
    sg.State([1.0, 2.0], [0.0, 0.5]), sg.State([1e200], [1e200]),
    np.array(3.0), np.array([1, 2]), np.zeros((2, 3)), np.zeros(0),
    np.arange(8.0)[::-2], np.array(["a"]), np.array([1j]),
    np.array([None]), np.array([math.nan]), np.zeros(3, dtype=np.int8),
    np.zeros(2, dtype=[("a", float)]), np.asfortranarray(np.ones((3, 2))),
    np.broadcast_to(1.0, (2, 2)), np.ma.masked, np.datetime64("2020-01-01")]
ANYTHING = st.sampled_from(NUMBERS + OTHERS)

BAR = ["length", "wave_speed", "axial_stiffness", "gap", "young", "density",
       "area", "bar", "cells"]
SCENE = [*BAR, "scene", "second_stop", "segments"]
DRIVEN: dict[str, Any] = {"damping": 0.05, "force": "tip", "amplitude": 2e-4,
                          "cells": 10}

#: What is called, with what, and what else it takes.
CALLS: dict[str, tuple[Callable[..., Any], dict[str, Any], list[str]]] = {
    "find": (sg.find, {"*": (5, 30), "cells": 10}, [
        *SCENE, "solver", "formulation", "objective", "target", "energy",
        "energy_ratio", "strain_limit", "tip_floor", "tolerance",
        "time_limit", "cycles", "stability", "progress"]),
    "question": (sg.find, {"cells": 10, "period": "7/2"}, [
        *SCENE, "frequency", "hertz", "energy", "energy_ratio"]),
    "forced": (sg.find, {"*": (10, 30), **DRIVEN}, [*SCENE, "cycles", "stability"]),
    "continuum": (sg.continuum, {"*": (5, 30), "cells": 10, "points": 3,
                                 "energy_ratio": 8}, [
        *BAR, "scene", "second_stop", "energy", "start", "to", "direction",
        "seed", "sample", "engine", "strain_limit", "resolution",
        "tolerance", "progress"]),
    "response": (sg.response, {**DRIVEN, "cells": 6, "start": 1.0, "to": 1.1},
                 [*SCENE, "cycles", "stability", "threads", "progress"]),
    "simulate": (sg.simulate, {**DRIVEN, "frequency": 1.1, "periods": 2}, [
        *BAR, "scene", "second_stop", "start", "phase", "time", "tip",
        "progress"]),
    "sweep": (sg.sweep, {**DRIVEN, "points": 2, "periods": 20}, [
        *SCENE, "over", "start", "to", "frequency", "direction", "rest",
        "resolve", "threads", "progress"]),
    "families": (sg.families, {"max_order": 5},
                 [*BAR[:-1], "max_energy_ratio", "progress"]),
    "modes": (sg.modes, {"max_order": 3}, [
        *BAR[:-1], "phases", "max_energy_ratio", "max_period", "progress"]),
    "mode": (sg.mode, {"a4": 4, "b": -1, "period": 3.2}, BAR[:-1]),
    "polytope": (sg.polytope, {"*": (2, 5), "cells": 3}, BAR),
    "Bar": (sg.Bar, {}, BAR[:-2]),
    "Segment": (sg.Segment, {"cells": 3}, ["impedance", "speed", "dashpot"]),
    "Scene": (sg.Scene, {}, ["bar", "second_stop", "segments"]),
    "Schedule": (sg.Schedule, {"*": (5, 30)}, ["cells"]),
    "State": (sg.State, {"a": [1.0, 2.0], "b": [0.0, 1.0]},
              ["bar", "segments"]),
}


@pytest.fixture(autouse=True)
def watched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """In a folder of its own; a call that does not come back ends the run."""
    monkeypatch.chdir(tmp_path)
    faulthandler.dump_traceback_later(120, exit=True)
    yield
    faulthandler.cancel_dump_traceback_later()


def judge(names: list[str], call: Callable[[], Any]) -> Any:
    """An answer that can be shown, or an error with one of the names."""
    try:
        answer = call()
    except (TypeError, ValueError, OverflowError, OSError,
            sg.BackendUnavailable) as error:
        text = str(error)
        if isinstance(error, TypeError) and "unsized" in text:
            return None  # NumPy's word for an array of no dimension
        assert any(name in text for name in names), (names, repr(error))
        return None
    assert repr(answer)
    if hasattr(answer, "to_dict"):
        answer.to_dict()
    return answer


def words_of(name: str, value: Any) -> list[str]:
    """What the library may call an argument, or its value: a file."""
    others = {"*": ["schedule", "n_c", "n_f", "phase", "stop", "steps"],
              "start": ["frequency_ratio", "frequency ratios", "frequency = "],
              "to": ["frequency_ratio", "frequency ratios", "frequency = "],
              "second_stop": ["stop"], "target": ["nearest"],
              "density": ["young"], "area": ["young"], "young": ["density"],
              "cells": ["steps_per_crossing", "frequency = ", "to = ", "period = ",
                        "gcd(2N"],
              "gap": ["period"], "a4": ["a = "], "period": ["schedule"]}
    if name == "progress":
        return [""]  # what it raises is its own
    file = [f"{value}: ", repr(value)] if isinstance(value, str) else []
    return [name, name.replace("_", " "), *others.get(name, []), *file]


def is_long(name: str, value: Any) -> bool:
    """Would what is asked for take long? That is no fault."""
    return name in ("periods", "time", "points", "max_order") \
        and isinstance(value, (int, float)) and 100 < value < math.inf


EVERY = settings(max_examples=100, deadline=None, derandomize=True,
                 database=None, suppress_health_check=list(HealthCheck))


@pytest.mark.parametrize("name", CALLS)
def test_any_argument_gets_an_answer_or_its_name(name: str) -> None:
    function, usual, more = CALLS[name]

    @EVERY
    @given(st.data())
    def tried(data: Any) -> None:
        arguments, words = dict(usual), list[str]()
        changed = data.draw(st.lists(st.sampled_from([*usual, *more]),
                                     min_size=1, max_size=2, unique=True))
        for argument in changed:
            value = data.draw(ANYTHING)
            if argument == "*":
                schedule = list(usual["*"])
                schedule[data.draw(st.integers(0, 1))] = value
                value = tuple(schedule)
            arguments[argument] = value
            words += words_of(argument, value)
            if is_long(argument, value):
                return
        positional = arguments.pop("*", ())
        judge(words, lambda: function(*positional, **arguments))

    tried()


def objects() -> dict[str, Any]:
    """Answers whose methods take numbers."""
    found = sg.find(5, 30, cells=10)
    polytope = sg.modes(phases=2, max_order=3)[0]
    return {"state": found.state, "motion": found.motion,
            "family": sg.families(4)[0], "mode": sg.modes(max_order=3)[0],
            "mode motion": sg.mode(4, -1, 3.2), "polytope": polytope,
            "polytope motion": polytope.motion(
                sum(p / q for p, q in polytope.period_range) / 2),
            "continuum": sg.continuum(5, 30, cells=10, energy_ratio=8,
                                      points=3),
            "waves": sg.simulate(**DRIVEN, frequency=1.1, periods=2).waves}


METHODS = [
    ("state", "refined", ["factor"]), ("motion", "state_at", ["step"]),
    *((owner, field + unit, ["x", "t"])
      for owner in ("motion", "mode motion", "polytope motion")
      for field in ("displacement", "velocity", "strain")
      for unit in ("", "_ratio")),
    *((owner, "wall_force" + unit, ["t"])
      for owner in ("motion", "mode motion", "polytope motion")
      for unit in ("", "_ratio")),
    ("family", "schedule", ["cells"]), ("mode", "schedule", ["cells", "steps"]),
    ("mode", "energy_ratio", ["period_ratio"]),
    ("mode", "contact_time_ratio", ["period_ratio"]),
    ("mode", "families", ["max_order"]), ("mode", "motion", ["period_ratio"]),
    ("mode motion", "p", ["t_ratio"]), ("mode motion", "state", ["cells"]),
    ("polytope", "energy_ratio", ["period_ratio"]),
    ("polytope", "slice", ["period_ratio"]),
    ("polytope", "stretches", ["period_ratio", "arrivals"]),
    ("polytope", "motion", ["period_ratio", "arrivals"]),
    ("polytope", "schedules", ["cells", "steps"]),
    ("continuum", "member", ["lambda_"]), ("waves", "stretching", ["cells"]),
]


def test_any_argument_of_a_method_gets_an_answer_or_its_name() -> None:
    owners = objects()

    @settings(EVERY, max_examples=600)
    @given(st.sampled_from(METHODS), st.lists(ANYTHING, min_size=2,
                                              max_size=2))
    def tried(method: tuple[str, str, list[str]], values: list[Any]) -> None:
        owner, name, names = method
        arguments = dict(zip(names, values))
        judge([*names, "period = ", "t = ", "lambda"],
              lambda: getattr(owners[owner], name)(**arguments))

    tried()


def test_fields_of_arrays_are_those_of_their_numbers() -> None:
    """Whatever the strides, kind and shape, each value is that of one."""
    motion = sg.find(5, 30, cells=10).motion
    grid = np.arange(24.0).reshape(4, 6) / 7
    for t in (grid, grid.T, grid[::-1, ::2], np.asfortranarray(grid),
              grid.astype(np.float32), grid[:, :1], grid.astype(int),
              np.broadcast_to(grid[0], (3, 6)), grid[1:1], grid.tolist(),
              [Fraction(1, 7), 2]):
        said = motion.displacement_ratio(0.7, t)
        assert said.shape == np.shape(t)
        for value, instant in zip(said.ravel(), np.asarray(t).ravel()):
            assert value == motion.displacement_ratio(0.7, float(instant))


ATLAS = ["cells", "max_contact", "max_free", "phases", "max_energy_ratio",
         "all", "families_only", "resume", "threads", "bar", "gap",
         "progress", "database"]


def test_any_argument_of_an_atlas_gets_an_answer_or_its_name() -> None:
    path = "whole.sqlite"
    whole = sg.Atlas.build(path, cells=4)

    @settings(EVERY, max_examples=80)
    @given(st.sampled_from(ATLAS), ANYTHING)
    def built(name: str, value: Any) -> None:
        Path("a.sqlite").unlink(missing_ok=True)
        arguments: dict[str, Any] = {"database": "a.sqlite", "cells": 2,
                                     name: value}
        judge([*words_of(name, value), "a.sqlite"],
              lambda: sg.Atlas.build(**arguments))

    @settings(EVERY, max_examples=150)
    @given(st.sampled_from([
        ("families", ["cells"]), ("schedules", ["cells"]),
        ("near", ["frequency_ratio", "energy_ratio", "within", "cells"]),
        ("schedules_near", ["frequency_ratio", "energy_ratio"]),
        ("of_period", ["period", "cells"]),
        ("schedules_of_period", ["period", "cells"]), ("twins", ["cells"]),
    ]), st.lists(ANYTHING, min_size=4, max_size=4))
    def asked(method: tuple[str, list[str]], values: list[Any]) -> None:
        name, names = method
        judge(names, lambda: getattr(whole, name)(**dict(zip(names, values))))

    built()
    asked()
