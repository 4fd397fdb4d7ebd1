"""How the package behaves: copies, threads, Ctrl-C, time and memory."""

from __future__ import annotations

import copy
import inspect
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import signorini as sg


def records(folder: Path) -> list[Any]:
    """One record of each sort."""
    found = sg.find(150, 900, energy_ratio=20, young=210e9, density=7800,
                    area=1e-4)
    forced = sg.find(10, 60, cells=20, damping=0.02, force="tip",
                     amplitude=2e-4)
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)
    run = sg.simulate(damping=0.02, force="tip", amplitude=2e-4,
                      frequency=1.1, periods=40, cells=20)
    response = sg.response(damping=0.02, force="tip", amplitude=2e-4, cells=10,
                           start=1.0, to=1.2)
    atlas = sg.Atlas.build(folder / "a.sqlite", cells=8)
    return [sg.Bar(gap=2e-3), sg.Schedule(150, 900),
            sg.Schedule((1, 12), (3, 12), cells=4), sg.Scene(sg.Bar()),
            found, found.state, found.motion, found.physical,
            sg.find(20, 109, cells=40), sg.find(150, 900, energy_ratio=3),
            sg.find(150, 900, strain_limit=1e-3, formulation="state",
                    cells=300) if sg.backends()["glpk-simplex"] else found,
            forced, curve, curve[2], sg.families()[3], sg.modes()[2],
            sg.mode(4, -1, 3.14159), sg.modes(phases=2, max_order=3)[0],
            sg.modes(phases=2, max_order=3)[0].motion(2.6), run, run.waves, response[1],
            atlas.families()[0], atlas.near("8/7", 4, within=0.5)[0],
            atlas.schedules()[0], atlas.runs[0]]


def test_records_survive_pickle_and_copy(tmp_path: Path) -> None:
    for record in records(tmp_path):
        for again in (pickle.loads(pickle.dumps(record)), copy.copy(record),
                      copy.deepcopy(record)):
            assert type(again) is type(record)
            assert again.to_dict() == record.to_dict(), record
            assert repr(again) == repr(record)
            if not isinstance(record, (sg.Motion, sg.ModeMotion,
                                       sg.PolytopeMotion)):
                assert again == record
                assert hash(again) == hash(record)
    tables: list[Any] = [sg.families(), sg.modes()]
    for table in tables:
        assert pickle.loads(pickle.dumps(table)) == table


def test_records_say_what_they_are(tmp_path: Path) -> None:
    for record in records(tmp_path):
        text = repr(record)
        assert text.startswith(type(record).__name__ + "("), text
        assert 10 < len(text) < 500, text
    assert repr(sg.Schedule(150, 900)) == "Schedule(150, 900, cells=300)"
    schedule = sg.Schedule((1, 12), (3, 12), cells=4)
    assert eval(repr(schedule), {"Schedule": sg.Schedule}) == schedule


def test_bars_are_given_either_way() -> None:
    steel = sg.Bar(young=210e9, density=7800, area=1e-4, gap=1e-5)
    one = sg.find(150, 900, bar=steel)
    other = sg.find(150, 900, young=210e9, density=7800, area=1e-4, gap=1e-5)
    assert one.energy == other.energy and one.bar == other.bar == steel
    assert len({steel, other.bar}) == 1
    with pytest.raises(ValueError, match="clashes"):
        sg.find(150, 900, bar=steel, gap=1.0)
    with pytest.raises(ValueError, match="all three"):
        sg.Bar(young=1.0, density=1.0)


def test_schedules_are_sequences() -> None:
    schedule = sg.Schedule(1, 12, 3, 12, cells=4)
    pairs: object = [(1, 12), (3, 12)]
    assert list(schedule) == pairs == schedule[:]
    assert schedule == pairs and schedule != [pairs]
    assert schedule.steps == 28 and schedule.period_ratio == 7
    assert sg.find(schedule).to_dict()["schedule"] == [[1, 12], [3, 12]]


@settings(max_examples=200, deadline=None)
@given(st.integers(-5, 2 ** 70), st.integers(-5, 2 ** 70),
       st.integers(-5, 40))
def test_any_whole_numbers_get_an_answer_or_a_value_error(
        contact: int, free: int, cells: int) -> None:
    try:
        answer = sg.find(contact, free, cells=cells)
    except ValueError as error:
        assert "allowed" in str(error)
    else:
        assert answer.status in ("found", "none")
        if answer.status == "found":
            assert answer.residuals.worst() < 1e-7
        else:
            assert answer.is_proof()


@settings(max_examples=100, deadline=None)
@given(st.floats(), st.floats(), st.floats())
def test_any_numbers_get_an_answer_or_a_value_error(
        energy: float, limit: float, gap: float) -> None:
    try:
        answer = sg.find(5, 31, cells=10, energy_ratio=energy,
                         strain_limit=limit, gap=gap)
    except ValueError as error:
        assert "allowed" in str(error)
    else:
        assert answer.status in ("found", "none", "undecided")


def needs(backend: str) -> Any:
    """For tests of what this build may be without."""
    return pytest.mark.skipif(sg.backends()[backend] is None,
                              reason=f"no {backend} in this build")


def interrupted(work: Callable[[], object]) -> float:
    """Seconds from Ctrl-C to KeyboardInterrupt."""
    sent = [0.0]

    def press() -> None:
        time.sleep(0.3)
        sent[0] = time.perf_counter()
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=press)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
        return time.perf_counter() - sent[0]
    finally:
        thread.join()


@pytest.mark.parametrize("work", [
    lambda: sg.modes(max_order=10001, max_energy_ratio=1e9),
    lambda: sg.families(20000),
    lambda: sg.response(damping=0.02, force="tip", amplitude=2e-4, cells=900),
    lambda: sg.simulate(damping=0.0, force="tip", amplitude=2e-4,
                        frequency=1.1, time=1e6),
    lambda: sg.find(40000, 1040000, cells=300000, damping=0.03, force="tip"),
])
def test_control_c_ends_a_call_within_a_tenth_of_a_second(
        work: Callable[[], object]) -> None:
    # On a machine that does something else as well we may wait our turn.
    assert min(interrupted(work) for _ in range(2)) < 0.1


def threads_of_this_process() -> int:
    """Also those that Python does not know."""
    return len(list(Path("/proc/self/task").iterdir()))


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="Linux")
@pytest.mark.parametrize("work", [
    lambda: sg.modes(phases=4, max_order=101),
    lambda: sg.response(damping=0.02, force="tip", amplitude=2e-4, cells=900,
                        stability=True, threads=3),
    pytest.param(lambda: sg.find(15000, 90000, cells=30000, objective="any",
                                 formulation="state", solver="glpk-simplex"),
                 marks=needs("glpk-simplex")),
    pytest.param(lambda: sg.find(15000, 90000, cells=30000, objective="any",
                                 formulation="state", solver="glpk-exact"),
                 marks=needs("glpk-exact")),
    pytest.param(lambda: sg.continuum(150, 900, energy_ratio=20, seed=1,
                                      engine="ipopt"), marks=needs("ipopt")),
])
def test_nothing_works_on_after_control_c(work: Callable[[], object]) -> None:
    before = threads_of_this_process()
    interrupted(work)
    until = time.monotonic() + 5
    while threads_of_this_process() > before and time.monotonic() < until:
        time.sleep(0.05)
    assert threads_of_this_process() <= before


def test_an_interrupted_atlas_goes_on(tmp_path: Path) -> None:
    path = tmp_path / "a.sqlite"
    options: dict[str, Any] = {"cells": 600, "phases": 1, "all": True}
    assert interrupted(lambda: sg.Atlas.build(path, **options)) < 2.0
    assert not sg.Atlas(path).runs[0].finished
    with pytest.raises(ValueError, match="resume"):
        sg.Atlas.build(path, **options)


def test_errors_in_a_callback_come_back() -> None:
    def fail(done: float, total: float) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        sg.families(3000, progress=fail)


def test_progress_is_told_in_the_calling_thread() -> None:
    seen = []
    sg.modes(max_order=301, max_energy_ratio=1e9,
             progress=lambda done, total:
             seen.append((done, total, threading.get_ident())))
    assert seen[-1] == (seen[-1][1], seen[-1][1], threading.get_ident())
    assert [done for done, _, _ in seen] == sorted(done for done, _, _ in seen)


def test_progress_takes_tqdm(capsys: pytest.CaptureFixture[str]) -> None:
    tqdm = pytest.importorskip("tqdm").tqdm
    with tqdm(total=0) as bar:
        sg.modes(max_order=301, progress=bar)
        assert bar.n == bar.total > 0
    sg.modes(max_order=101, progress=tqdm)
    sg.modes(max_order=101, progress=True)
    with pytest.raises(TypeError, match="progress"):
        sg.modes(progress=3)
    assert "100%" in capsys.readouterr().err


def test_two_threads_call_at_once() -> None:
    alone = [sg.find(15, 90, cells=30, energy_ratio=e).to_dict()
             for e in range(5, 25)]
    results: dict[int, list[Any]] = {0: [], 1: []}

    def work(number: int) -> None:
        for e in range(5, 25):
            results[number].append(
                sg.find(15, 90, cells=30, energy_ratio=e).to_dict())
            sg.families(30)
            sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)

    threads = [threading.Thread(target=work, args=(k,)) for k in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for answers in [alone, *results.values()]:
        for answer in answers:
            del answer["solver"]["seconds"]
    assert results[0] == results[1] == alone


def test_python_runs_while_the_library_works() -> None:
    ticks = []
    thread = threading.Thread(target=lambda: sg.families(400))
    thread.start()
    while thread.is_alive():
        ticks.append(time.perf_counter())
        time.sleep(0.001)
    assert len(ticks) > 5


LEAK = """
import gc, os, signorini as sg

def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

def call():
    answer = sg.find(5, 31, cells=10, energy_ratio=9)
    answer.state.a.sum()
    answer.motion.displacement(0.5, 1.0)
    answer.motion.p.sum()
    repr(answer)

for _ in range(5000):
    call()
gc.collect()
before = resident()
for _ in range(100_000):
    call()
gc.collect()
print(resident() - before)
"""


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="Linux")
def test_a_hundred_thousand_calls_leak_nothing() -> None:
    grown = subprocess.run([sys.executable, "-c", LEAK], check=True,
                           capture_output=True, text=True).stdout
    assert int(grown) < 1e6


def steps_of(call: Callable[[], object]) -> list[str]:
    """The functions, of Python and others, that a call enters: its cost on any machine."""
    entered: list[str] = []

    def enter(frame: Any, event: str, argument: Any) -> None:
        if event == "call":
            entered.append(frame.f_code.co_name)
        elif event == "c_call":
            entered.append(argument.__name__)

    sys.setprofile(enter)
    try:
        call()
    finally:
        sys.setprofile(None)
    return entered[1:-1]


def test_a_call_takes_few_steps() -> None:
    steps = steps_of(lambda: sg.find(1, 6, cells=2))
    assert steps[0] == "find" and steps[-1] == "find" and len(steps) <= 20, steps
    bar = sg.find(1, 6, cells=2).bar
    assert steps_of(lambda: sg._core.mode({"a4": 4, "b": -1, "bar": bar})) == ["mode"]


def test_import_loads_no_other_package() -> None:
    code = "import sys, signorini; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], check=True,
                            capture_output=True, text=True).stdout.split()
    for heavy in ("numpy", "matplotlib", "pandas", "inspect", "json", "subprocess", "asyncio"):
        assert heavy not in loaded


def test_frames_have_a_row_for_each(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    frame = sg.families().frame()
    assert len(frame) == 33 and frame.order.is_monotonic_increasing
    assert len(sg.modes().frame()) == len(sg.modes())
    atlas = sg.Atlas.build(tmp_path / "a.sqlite", cells=8)
    assert len(atlas.families().frame()) == len(atlas.families())
    counted = atlas.query("SELECT count(*) AS n FROM schedules")
    assert isinstance(counted, pandas.DataFrame)
    assert counted.n[0] == len(atlas.schedules())
    response = sg.response(damping=0.02, force="tip", amplitude=2e-4, cells=10)
    frame = response.frame()
    assert frame.impulse.count() == len(response.motions) > 0


def test_lists_and_motions_on_no_grid_say_that_they_were_found() -> None:
    assert sg.families().found and sg.modes().found and sg.modes(phases=2, max_order=5).found
    motion = sg.mode(4, -1, 3.5)
    assert motion.found and bool(motion)
    none = sg.families(1, max_energy_ratio=0.1)
    assert len(none) == 0 and not none.found and not none


def test_columns_of_frames_are_numbers_truth_values_or_words() -> None:
    pytest.importorskip("pandas")
    bars: Any = {"scene": "clamp 6 driven gap=1e-4 dash=0.1 6 clamp"}
    forced: Any = {"damping": 0.02, "force": "tip", "amplitude": 2e-4, "cells": 6}
    response = sg.response(contacts=2, stability=True, **forced).frame()
    assert response.admissible.dtype == "boolean" and response.admissible.any()
    for frame in (response, sg.families().frame(), sg.modes().frame(),
                  sg.modes(phases=2, max_order=5).frame(), sg.exact_response(**forced).frame(),
                  sg.find(period="7/2", cells=12).frame(),
                  sg.find(frequency=1.1, contacts=2, **forced).frame(),
                  sg.find(5, 31, damping=0.02, force="tip", cells=10).frame(),
                  sg.find(frequency=1.1, **bars).frame(),
                  sg.response(force="tip", amplitude=2e-4, **bars).frame(),
                  sg.continuum(5, 31, segments=[(4, 1), (6, 1.3)], energy_ratio=9,
                               points=5).frame(),
                  sg.simulate(time=9.0, **bars, velocity=[1e-3, 0.0]).frame()):
        for name in frame.columns:
            kinds = {type(cell) for cell in frame[name]}
            assert frame[name].dtype != object or kinds <= {str, type(None)}, (name, kinds)
            assert tuple not in kinds, name


def test_every_function_says_what_it_takes_and_raises() -> None:
    functions: list[Any] = [sg.find, sg.continuum, sg.families, sg.modes,
                            sg.mode, sg.polytope, sg.response, sg.simulate,
                            sg.Atlas.build]
    for function in functions:
        text = inspect.getdoc(function) or ""
        for section in ("Parameters", "Returns", "Raises"):
            assert f"\n{section}\n---" in text, function
        for name in inspect.signature(function).parameters:
            if name not in ("bar_options", "cls"):
                assert name in text, f"{function.__name__}: {name}"


def test_states_can_be_written_and_read(tmp_path: Path) -> None:
    path = tmp_path / "state.csv"
    state = sg.find(150, 900, gap=2e-5).state
    state.write(str(path))
    again = sg.State.read(str(path), state.bar)
    np.testing.assert_allclose(again.a, state.a, rtol=1e-12)
    near = sg.find(150, 900, gap=2e-5, objective="nearest", target=str(path))
    assert near.distance == pytest.approx(0, abs=1e-7)
    with pytest.raises(OSError, match="nothing.csv"):
        sg.State.read(str(tmp_path / "nothing.csv"))
    with pytest.raises(OSError):
        sg.Atlas(tmp_path / "nothing.sqlite")
