"""What people type, and what they are told."""

from __future__ import annotations

import math
from typing import Any, Callable

import pytest

import signorini as sg

#: For calls that types forbid.
untyped: Any = sg
FORCED: dict[str, Any] = {"damping": 0.02, "force": "tip", "amplitude": 1e-4,
                          "frequency": 1.1}


@pytest.mark.parametrize("time", [-1.0, 0.0, math.nan, math.inf, 1e300])
def test_a_simulation_lasts_some_time(time: float) -> None:
    for options in ({}, FORCED):
        with pytest.raises(ValueError, match="^time = .* allowed numbers > 0"):
            untyped.simulate(time=time, **options)


@pytest.mark.parametrize("periods", [-1, 0, 10 ** 12])
def test_a_simulation_lasts_some_periods(periods: int) -> None:
    with pytest.raises(ValueError, match="^periods = .* allowed whole"):
        sg.simulate(periods=periods, **FORCED)


def test_segments_bring_their_cells() -> None:
    parts = [(4, 1), (4, 1.3)]
    assert sg.find(3, 25, segments=parts) == \
        sg.find(3, 25, cells=8, segments=parts)
    whole = sg.Schedule(3, 25, cells=8)
    assert sg.find(whole, segments=parts).cells == 8
    scene = sg.Scene(segments=[sg.Segment(*part) for part in parts])
    assert sg.find(3, 25, scene=scene).cells == 8


def test_without_a_gap_energies_are_in_joules() -> None:
    """There is no E_1 then."""
    found = sg.find(225, 675, gap=0, energy=1e-6)
    assert found.status == "found"
    assert "E = 1e-06 J" in repr(found) and "E_1" not in repr(found)
    curve = sg.continuum(225, 675, gap=0, energy=1e-6, points=3)
    for shown in (repr(curve), repr(curve[0])):
        assert "E = 1e-06 J" in shown and "E_1" not in shown
    waves = sg.simulate(found.state, gap=0, time=1).waves
    assert "E = 1e-06 J" in repr(waves)
    assert "E_1" in repr(sg.find(150, 900))


@pytest.mark.parametrize("ask, named", [
    (lambda: sg.find(5, 30, cells=10, energy=-1), "energy = -1 "),
    (lambda: sg.continuum(225, 675, energy=math.nan), "energy = nan "),
    (lambda: sg.find(5, 30, cells=10, strain_limit=-1), "strain_limit = -1 "),
    (lambda: sg.find(150, 900, length=2.0).motion.displacement(2.5, 0.1),
     r"x = 2.5 is out of range: allowed 0..2 \[m\]"),
    (lambda: sg.find(150, 900).motion.velocity_ratio(-0.5, 0.1),
     r"x = -0.5 is out of range: allowed 0..1 \[L\]"),
    (lambda: sg.mode(4, -1, 3.3).strain(0.5, math.nan), "t = nan "),
])
def test_an_error_has_the_number_that_was_given(ask: Callable[[], object],
                                                named: str) -> None:
    with pytest.raises(ValueError, match=f"^{named}"):
        ask()


@pytest.mark.parametrize("ask, told", [
    (lambda: untyped.Bar(1, 2), r"Bar\(1, 2\): allowed Bar\(\*, length: float"),
    (lambda: untyped.Bar(gap=None), r"Bar\(gap=None\): allowed Bar\("),
    (lambda: untyped.Segment("x"), r"Segment\('x'\): allowed Segment\(cells: int"),
    (lambda: untyped.families()[0].schedule("x"),
     r"schedule\('x'\): allowed schedule\(cells: int\)"),
])
def test_wrong_kinds_are_refused_in_words(ask: Any, told: str) -> None:
    with pytest.raises(TypeError, match=f"^{told}") as refused:
        ask()
    assert "signorini._core" not in str(refused.value)
    assert "\n" not in str(refused.value)


def test_none_is_a_bar_as_usual() -> None:
    assert sg.find(150, 900, gap=None, length=None) == sg.find(150, 900)


def test_a_continuum_is_sliced_and_gone_through() -> None:
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)
    assert curve[1:3] == [curve[1], curve[2]]
    assert curve[-1] == list(curve)[4] and len(curve[::2]) == 3
    with pytest.raises(IndexError):
        curve[5]


def test_keys_are_not_hidden_by_methods() -> None:
    families = sg.families()
    assert families.count == len(families) == 33
    assert families.index(families[3]) == 3 and families[3] in families
    assert list(reversed(families))[0] == families[-1]


def test_equal_answers_are_equal() -> None:
    """Whatever the stopwatch says."""
    for options in ({}, {"objective": "max-energy"}, {"energy_ratio": 9}):
        one = untyped.find(15, 90, cells=30, **options)
        other = untyped.find(15, 90, cells=30, **options)
        assert one == other
    assert sg.find(15, 90, cells=30) != sg.find(15, 91, cells=30)
