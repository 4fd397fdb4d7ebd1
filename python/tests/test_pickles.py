"""Pickles that were damaged are refused, and nothing is read beyond them."""

from __future__ import annotations

import marshal
import pickle
import struct
import subprocess
import sys
import zlib
from typing import Any

import pytest
from support import ROOT

import signorini as sg


def resealed(name: str, content: Any) -> Any:
    """The state of a pickle with a sum that fits: what a forger makes."""
    maker = f"{sg.__version__} {name}".encode()
    return content, zlib.crc32(marshal.dumps(content, 2), zlib.crc32(maker))


def state_of(content: Any) -> sg.State:
    state = sg.State.__new__(sg.State)
    state.__setstate__(  # type: ignore[attr-defined]
        resealed("State", content))
    return state


@pytest.mark.parametrize("count", [0, 1, 9, 11, 80, 2 ** 40, 2 ** 62, -1])
def test_waves_of_another_length_are_refused(count: int) -> None:
    """Each has its length before it."""
    state: Any = sg.find(5, 30, cells=10).state
    content, _ = state.__getstate__()
    assert state_of(content).to_dict() == state.to_dict()
    size = struct.pack("<q", 10)
    for at in (content.index(size), content.rindex(size)):
        with pytest.raises(ValueError, match="damaged"):
            state_of(content[:at] + struct.pack("<q", count) + content[at + 8:])


@pytest.mark.parametrize("length", [1, 7, 8, 8 * 10 - 1, 8 * 10, 8 * 10 + 1])
def test_what_was_cut_or_goes_on_is_refused(length: int) -> None:
    state: Any = sg.find(5, 30, cells=10).state
    content, _ = state.__getstate__()
    for whole in (content[:-length], content[length:], content + bytes(length)):
        with pytest.raises(ValueError, match="damaged"):
            state_of(whole)


def test_what_was_changed_on_its_way_is_refused() -> None:
    bar = sg.Bar(gap=2e-3)
    data = pickle.dumps(bar, 4)
    at = data.index(struct.pack("<d", 2e-3))
    with pytest.raises(ValueError, match="damaged"):
        pickle.loads(data[:at] + b"\x3e" + data[at + 1:])
    for state in (None, 3, (), ((), 0), (bar, 0)):
        with pytest.raises(ValueError, match="damaged"):
            sg.Bar.__new__(sg.Bar).__setstate__(  # type: ignore[attr-defined]
                state)


def test_drawn_damages() -> None:
    """The campaign of tests/robustness, in short, in a process of its own."""
    campaign = ROOT / "tests" / "robustness" / "damaged_pickles.py"
    done = subprocess.run([sys.executable, campaign, "--count", "1500"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    assert "forged pickles accepted" in done.stdout


@pytest.mark.parametrize("kind", [sg.Bar, sg.Result, sg.State, sg.Schedule])
def test_what_was_not_made_has_no_value(kind: Any) -> None:
    """An object of __new__ alone, and one of another class."""
    name = kind._keys[0][1] if kind._keys else "energy"
    for other in (kind.__new__(kind), 3):
        for ask in (getattr(kind, name).fget, kind.__hash__, kind.__getstate__):
            with pytest.raises(TypeError):
                ask(other)
