"""What people type, and what they are told."""

from __future__ import annotations

import math
import pickle
from typing import Any, Callable, get_args

import pytest

import signorini as sg
from signorini import _words

#: For calls that types forbid.
untyped: Any = sg
FORCED: dict[str, Any] = {"damping": 0.02, "force": "tip", "amplitude": 1e-4,
                          "frequency": 1.1}


@pytest.mark.parametrize("name, words, ask", [
    ("force", _words.Force,
     lambda word: untyped.find(6, 42, damping=0.02, force=word, amplitude=1e-4)),
    ("objective", _words.Objective, lambda word: untyped.find(150, 900, objective=word)),
    ("over", _words.Over,
     lambda word: untyped.sweep(word, 0.5, 1, damping=0.02, force="tip", amplitude=1e-4)),
])
def test_words_to_choose_from_are_those_of_the_library(
        name: str, words: Any, ask: Callable[[str], Any]) -> None:
    with pytest.raises(ValueError) as refused:
        ask("other")
    allowed = str(refused.value).split("allowed ")[1].split("|")
    assert {*allowed} <= {*get_args(words)} <= {*allowed, "auto"}, name


@pytest.mark.parametrize("time", [-1.0, 0.0, math.nan, math.inf, 1e300])
def test_a_simulation_lasts_some_time(time: float) -> None:
    for options in ({}, FORCED):
        with pytest.raises(ValueError, match="^time = .* allowed "):
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
    (lambda: sg.find(hertz=494), "hertz = 494 .* by default"),
    (lambda: sg.response(damping=0.02, force="tip", amplitude=1e-4, start=530, to=540),
     'start = 530 .*looks like Hz.* start="530Hz"'),
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
    (lambda: untyped.Bar(1, 2), r"Bar\(1, 2\): allowed Bar\(\*, length, wave_speed"),
    (lambda: untyped.Bar(gap=[1]), r"gap = \[1\]: allowed float, or text with its unit"),
    (lambda: untyped.Segment("x"), r"Segment\('x'\): allowed Segment\(cells: int"),
    (lambda: untyped.find(150, 900, energy_ration=20),
     r"energy_ration is not an argument here: .*; did you mean energy_ratio\?$"),
    (lambda: untyped.simulate(rest=True),
     r"rest is not an argument here: of a bar these are [a-z_, ]*$"),
    (lambda: untyped.families()[0].schedule("x"),
     r"schedule\('x'\): allowed schedule\(cells: int\)"),
])
def test_wrong_kinds_are_refused_in_words(ask: Any, told: str) -> None:
    with pytest.raises(TypeError, match=f"^{told}") as refused:
        ask()
    assert "signorini._core" not in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_round_bar_has_its_diameter_in_place_of_its_area() -> None:
    steel: Any = {"young": "210GPa", "density": 7850}
    round_bar = untyped.find(150, 900, diameter="20mm", **steel)
    assert round_bar == untyped.find(150, 900, area=0.25 * math.pi * 0.02 * 0.02, **steel)
    with pytest.raises(ValueError, match="area clashes with diameter"):
        untyped.find(150, 900, diameter="20mm", area=1e-4, **steel)


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


STEEL: dict[str, Any] = {"length": 3.0, "young": 210e9, "density": 7850.0, "area": 314e-6,
                         "gap": 1e-4}
IN_WORDS: dict[str, Any] = {"length": "3000mm", "young": "210GPa", "density": "7.85 g/cm3",
                            "area": "314mm2", "gap": "0.1mm"}


@pytest.mark.parametrize("ask, plain, in_words", [
    (sg.Bar, {}, {}),
    (lambda **bar: sg.find(5, 30, cells=10, **bar), {"energy": 2.5, "tip_floor": -5e-3},
     {"energy": "2500mJ", "tip_floor": "-5mm"}),
    (lambda **bar: sg.find(3, 25, cells=8, force="base", **bar),
     {"damping": 0.05, "second_stop": 2e-4}, {"damping": "5%", "second_stop": "0.2 mm"}),
    (lambda **bar: sg.find(frequency=1.1, force="tip", **bar),
     {"damping": 0.05, "amplitude": 2e3}, {"damping": "5%", "amplitude": "2kN"}),
    (lambda **bar: sg.response(force="base", cells=20, **bar),
     {"damping": 0.05, "amplitude": 2e-5, "start": 4800.0 / math.sqrt(210e9 / 7850.0), "to": 1.2},
     {"damping": "5 %", "amplitude": "20um", "start": "400Hz", "to": "1.2"}),
    (lambda **bar: sg.sweep("amplitude", force="base", cells=10, points=2, periods=20, **bar),
     {"damping": 0.05, "start": 2e-5, "to": 3e-5, "frequency": 1.1},
     {"damping": "5%", "start": "20um", "to": "0.03mm", "frequency": 1.1}),
    (lambda **bar: sg.simulate(force="base", frequency=1.1, cells=20, **bar),
     {"damping": 0.05, "amplitude_acceleration": 150.0, "time": 0.02, "resolve": 2e-5},
     {"damping": "5%", "amplitude_acceleration": "150m/s2", "time": "20ms", "resolve": "20us"}),
    (lambda **bar: sg.continuum(225, 675, points=3, **bar), {"energy": 8.0}, {"energy": "8J"}),
])
def test_numbers_carry_their_units(ask: Any, plain: dict[str, Any],
                                   in_words: dict[str, Any]) -> None:
    asked, told = ask(**STEEL, **plain), ask(**IN_WORDS, **in_words)
    assert repr(asked) == repr(told)


def test_a_study_takes_units() -> None:
    common: dict[str, Any] = {"force": "base", "points": 2, "cells": 10, "periods": 20}
    plain = sg.study(gap=[1e-4, 2e-4], damping=0.05, amplitude=2e-5, **common)
    told = sg.study(gap=["0.1mm", "0.2mm"], damping="5%", amplitude="20um", **common)
    assert [p.to_dict() for p in plain] == [p.to_dict() for p in told]


@pytest.mark.parametrize("ask, named", [
    (lambda: sg.Bar(young="210GHz"),
     r"young = 210GHz is out of range: allowed finite numbers \[Pa\]"),
    (lambda: sg.find(150, 900, energy="2N"), r"energy = 2N .* \[J\]"),
    (lambda: sg.response(damping="5%", force="base", amplitude="20kN"),
     r"amplitude = 20kN .* \[m\]"),
    (lambda: sg.study(gap="1s", damping=0.1, amplitude=1.0, force="tip"), r"gap = 1s .* \[m\]"),
    (lambda: sg.find(hertz="1 m", damping=0.1, force="tip"), r"hertz = 1 m .* \[Hz\]"),
])
def test_a_unit_that_does_not_fit_is_named(ask: Callable[[], object], named: str) -> None:
    with pytest.raises(ValueError, match=f"^{named}"):
        ask()


def test_what_no_question_of_segments_looks_at_is_refused() -> None:
    untimed: dict[str, Any] = {"segments": [(3, 1.0), (3, 2.0)]}
    cases: list[tuple[dict[str, Any], dict[str, Any]]] = [
        ({**untimed, "period": 3.5}, {"cells": 4}),
        ({**untimed, "period": 3.5}, {"contacts": 2}),
        ({**untimed, "period": 3.5}, {"formulation": "state"}),
        ({"cells": 12, "period": 3.5}, {"contacts": 2}),
        ({**untimed, "hertz": 0.5, "force": "tip", "damping": 0.1, "amplitude": 1e-3},
         {"cells": 4})]
    for asked, wrong in cases:
        with pytest.raises(ValueError, match=f"^{next(iter(wrong))}.*allowed"):
            untyped.find(**asked, **wrong)


@pytest.mark.parametrize("wrong", [{"tip_floor": -1.0}, {"formulation": "state"}])
def test_what_segments_under_a_harmonic_do_not_take_names_them(wrong: dict[str, Any]) -> None:
    segments: dict[str, Any] = {"segments": [(3, 1.0), (3, 2.0)], "hertz": 0.5, "force": "tip",
                                "damping": 0.1, "amplitude": 1e-3}
    with pytest.raises(ValueError, match=f"^{next(iter(wrong))}: allowed only .* segments under"):
        untyped.find(**segments, **wrong)


DAMPED: dict[str, Any] = {"force": "tip", "damping": 0.1, "cells": 6}
BARS = "clamp 6 dash=0.1 driven gap=1e-3 6 clamp"


@pytest.mark.parametrize("ask", [
    lambda **wrong: untyped.find(3, 18, **DAMPED, **wrong),
    lambda **wrong: untyped.find(3, 18, force="tip", damping=0.1, segments=[(3, 1.0), (3, 2.0)],
                                 **wrong),
    lambda **wrong: untyped.find(frequency=1.1, amplitude=1e-3, **DAMPED, **wrong),
])
@pytest.mark.parametrize("wrong", [
    {"energy_ratio": 3}, {"energy": 1e-6}, {"objective": "max-impulse"}, {"tip_floor": -1e-3},
    {"solver": "glpk-simplex"}, {"formulation": "state"}, {"tolerance": 1e-3}, {"time_limit": 1},
])
def test_what_motions_under_a_force_do_not_take_is_refused(ask: Any, wrong: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=f"^{next(iter(wrong))}: allowed only without force$"):
        ask(**wrong)


def test_a_schedule_says_by_itself_how_many_contacts_it_has() -> None:
    with pytest.raises(ValueError, match="^contacts: allowed only of a period$"):
        untyped.find(3, 18, contacts=2, **DAMPED)


@pytest.mark.parametrize("wrong", [-1e-3, 0.0, -math.inf, math.nan])
@pytest.mark.parametrize("ask, unit", [
    (lambda amplitude: untyped.find(3, 18, amplitude=amplitude, **DAMPED), "N"),
    (lambda amplitude: untyped.find(frequency=1.1, amplitude=amplitude, **DAMPED), "N"),
    (lambda amplitude: untyped.response(amplitude=amplitude, **{**DAMPED, "force": "base"}), "m"),
    (lambda amplitude: untyped.sweep(amplitude=amplitude, **DAMPED), "N"),
    (lambda amplitude: untyped.find(3, 18, scene=BARS, force="tip", amplitude=amplitude), "N"),
    (lambda amplitude: untyped.exact_response(scene=BARS, force="tip", amplitude=amplitude), "N"),
])
def test_an_amplitude_is_refused_as_it_was_given(ask: Any, unit: str, wrong: float) -> None:
    with pytest.raises(ValueError, match=rf"^amplitude = {wrong:g} is out of range: "
                                         rf"allowed finite numbers > 0 \[{unit}\]$"):
        ask(wrong)


@pytest.mark.parametrize("ask, told", [
    (lambda: untyped.find(3, 18, scene="clamp 6 stop=1e-3", gap=2e-3), "scene clashes with gap"),
    (lambda: untyped.sweep(scene=BARS, force="tip", amplitude=1e-3, cells=9), "cells: allowed"),
    (lambda: untyped.sweep(scene=BARS, force="tip"), "amplitude is missing: allowed"),
])
def test_what_the_words_of_a_scene_say_is_not_said_twice(ask: Callable[[], object],
                                                         told: str) -> None:
    with pytest.raises(ValueError, match=f"^{told}"):
        ask()


def test_a_scene_of_words_is_a_scene() -> None:
    """It answers as its words do, whose scales it has, and is refused as they are."""
    words = "clamp 4 gap=2e-3 4 clamp"
    scene = sg.Scene(words, bar=sg.Bar(length=2.0))
    asked: Any = {"strain_limit": 1e-3}
    assert sg.find(3, 11, scene=scene, **asked) == sg.find(3, 11, scene=words, length=2.0, **asked)
    assert sg.force_range(sg.Scene("clamp 7 driven stop=1 3"), 0, 1, time=2.0) == \
        sg.force_range("clamp 7 driven stop=1 3", 0, 1, time=2.0)
    assert pickle.loads(pickle.dumps(scene)) == scene != sg.Scene(words)
    assert scene.words == words and words in repr(scene) and sg.Scene().words is None
    assert list(scene.to_dict()) == ["words", "bar"] and sg.plot.scene(scene).lines
    for wrong in ("clamp 4 gap=2e-3 4 clmp", ""):
        with pytest.raises(ValueError) as of_words:
            sg.find(3, 11, scene=wrong)
        with pytest.raises(ValueError) as of_scene:
            sg.Scene(wrong)
        assert str(of_words.value) == str(of_scene.value)
    with pytest.raises(ValueError, match="scene clashes with bar"):
        sg.find(3, 11, scene=scene, length=2.0, **asked)
    with pytest.raises(TypeError, match="allowed"):
        sg.Motion(sg.State([1.0], [1.0]), sg.Schedule(1, 6, cells=1), scene)
