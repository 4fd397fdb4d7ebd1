"""Arguments as people give them, on their way to the library."""

from __future__ import annotations

import difflib
import operator
import os
import reprlib
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from numbers import Integral
from typing import Any, Literal, Union

from . import _core
from ._core import Bar, Scene, Schedule, Segment, State

#: Steps n_c and n_f, pairs of them, or a whole Schedule.
Steps = Union[int, "tuple[int, int]", "tuple[int, int, str]", Schedule]

#: Segments, or (cells, impedance, speed, dashpot) of each.
Segments = Sequence[Union[Segment, "tuple[float, ...]"]]

#: Words that arguments are chosen from: those of the program's table of options.
Force = Literal["tip", "base"]
Objective = Literal["auto", "any", "min-energy", "max-energy", "min-peak-strain", "max-impulse",
                    "nearest"]
Over = Literal["frequency", "amplitude", "gap", "damping"]

#: A number that may be exact: 3.5, "7/2", Fraction(7, 2).
Number = Union[int, float, str, Fraction]

#: A number in the unit of its argument, or text with its own: 1e-4, "0.1mm".
Quantity = Union[float, str]

#: What a bar is made of; the diameter is that of a round one, in place of its area.
_OF_BAR = ("length", "wave_speed", "axial_stiffness", "gap", "young", "density", "area", "diameter")

#: Names of all arguments, of which a misspelt one may have been meant.
arguments = set(_OF_BAR)

_usual = Bar()
_usual_scene = Scene(_usual)


def given_of(options: Mapping[str, Quantity | None]) -> dict[str, Quantity]:
    """Those that say something: None is what it is without."""
    return {name: value for name, value in options.items()
            if value is not None}


def whole(name: str, value: Any) -> int:
    """A whole number. TypeError that names the argument."""
    try:
        count = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {reprlib.repr(value)}: allowed int") from None
    if not -2 ** 63 <= count < 2 ** 63:
        raise ValueError(f"{name} = {reprlib.repr(value)} is out of range: allowed "
                         "whole numbers of at most 64 bits")
    return count


def number(name: str, value: Any, unit: str = "") -> float:
    """A number, in the unit of the program's option unless one is given, likewise."""
    if isinstance(value, str):
        return _core.quantity(name, value, unit)
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name} = {reprlib.repr(value)}: allowed float") from None


def path(name: str, value: Any) -> str:
    """The name of a file, likewise."""
    try:
        return os.fspath(value)  # type: ignore[no-any-return]
    except TypeError:
        raise TypeError(f"{name} = {reprlib.repr(value)}: allowed a path") from None


def bar_of(bar: Bar | None, options: Mapping[str, Quantity | None]) -> Bar:
    """A bar, or the one that the options of a call name."""
    given = given_of(options)
    if not given:
        return _usual if bar is None else bar
    if bar is not None:
        names = ", ".join(given)
        raise ValueError(f"bar clashes with {names}: allowed one of them")
    return Bar(**given)


def require_of_bar(names: Iterable[str]) -> None:
    """TypeError if one of them is no argument of a bar."""
    for name in names:
        if name not in _OF_BAR:
            near = difflib.get_close_matches(name, arguments, 1)
            meant = f"; did you mean {near[0]}?" if near and near[0] != name else ""
            raise TypeError(f"{name} is not an argument here: of a bar these are "
                            f"{', '.join(_OF_BAR)}{meant}")


def scene_of(scene: Scene | None, bar: Bar | None, second_stop: Quantity | None,
             segments: Segments | None,
             options: Mapping[str, Quantity | None]) -> Scene:
    """A scene, or the one that the arguments of a call make."""
    if not options and scene is None and bar is None and second_stop is None and segments is None:
        return _usual_scene
    options = given_of(options)
    if scene is not None:
        if (bar, second_stop, segments, options) != (None, None, None, {}):
            raise ValueError("scene clashes with bar, second_stop, segments: "
                             "allowed one of them")
        if not isinstance(scene, Scene):
            raise TypeError(f"scene = {reprlib.repr(scene)}: allowed Scene")
        return scene
    if not isinstance(segments, (tuple, list, type(None))):
        raise TypeError(f"segments = {reprlib.repr(segments)}: allowed list")
    parts = [part if isinstance(part, Segment) else segment_of(part)
             for part in segments or ()]
    return Scene(bar_of(bar, options), second_stop, parts)


def in_words(scene: Scene | str | None) -> bool:
    """Is it of several bars?"""
    return isinstance(scene, str) or scene is not None and scene.words is not None


def cells_of(cells: int | None, scene: Scene,
             schedule: Sequence[Steps] = ()) -> int | None:
    """Cells that were given, or those of all segments; of a whole Schedule
    they are its own."""
    if cells is not None or not scene.segments or any(
            isinstance(word, Schedule) for word in schedule):
        return cells
    return sum(part.cells for part in scene.segments)


def phases_of(words: Sequence[Any]) -> list[tuple[int, int, bool]]:
    """The contacts of n_c, n_f, ..., or of pairs of them, (n_c, n_f, "left") on the second stop:
    n_c, n_f, and whether it is that."""
    steps: list[int] = []
    stops: list[Any] = []
    for word in words:
        if type(word) is not int and hasattr(word, "__getitem__") and hasattr(
                word, "__len__") and not isinstance(word, (str, bytes, dict, type)):
            if len(word) not in (2, 3) or len(steps) % 2:
                raise ValueError("n_c, n_f, ...: allowed pairs of contact and free steps, "
                                 'with "left" those on the second stop')
            steps += whole("n_c", word[0]), whole("n_f", word[1])
            stops.append(word[2] if len(word) == 3 else "right")
        else:
            steps.append(whole("n_f" if len(steps) % 2 else "n_c", word))
            stops += ["right"] * (len(steps) // 2 - len(stops))
    if not steps or len(steps) % 2:
        raise ValueError(f"n_c, n_f, ... = {len(steps)} step counts is out of range: "
                         "allowed an even number of them, at least 2")
    for stop in stops:
        if stop not in ("left", "right"):
            raise ValueError(f"stop = {reprlib.repr(stop)} is out of range: allowed left|right")
    return [(contact, free, stop == "left")
            for contact, free, stop in zip(steps[::2], steps[1::2], stops)]


def schedule_of(words: Sequence[Any], cells: int | None
                ) -> Schedule | list[tuple[int, int, bool]]:
    """The schedule in the arguments of a call: a whole one, or its phases."""
    if len(words) == 2 and type(words[0]) is int and type(words[1]) is int and (
            0 < words[0] < 2 ** 63 > words[1] > 0):
        return [(words[0], words[1], False)]  # at once, as most are
    if len(words) == 1 and isinstance(words[0], Schedule):
        if cells is not None and cells != words[0].cells:
            raise ValueError(f"cells = {cells} clashes with those of the schedule: "
                             f"allowed {words[0].cells}")
        return words[0]
    return phases_of(words)


def spans_of(words: Sequence[Any]) -> list[str]:
    """The same as "SET:STEPS" of a scene, unless it is that."""
    if any(isinstance(word, str) for word in words):
        return list(words)
    is_whole = len(words) == 1 and isinstance(words[0], Schedule)
    schedule: Schedule = words[0] if is_whole else Schedule(*words)
    return schedule._spans.split()


def segment_of(part: Sequence[float]) -> Segment:
    """A segment of (cells, impedance, speed, dashpot)."""
    try:
        cells, *others = part
        if int(cells) == cells:
            return Segment(int(cells), *others)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"segments: {reprlib.repr(part)} is out of range: "
                     "allowed Segment, or (cells >= 1, impedance > 0, "
                     "speed > 0, dashpot)")


def state_of(state: Any, bar: Bar, cells: int | None) -> Any:
    """A state, or the one in a file."""
    if isinstance(state, str) or hasattr(state, "__fspath__"):
        name = str(state)
        if "\0" in name:
            raise ValueError(f"{name!r} is no name of a file")
        return State.read(name, bar, 300 if cells is None else whole("cells", cells))
    return state


def fraction_of(value: Number, name: str) -> Fraction:
    """An exact number > 0. ValueError for anything else."""
    try:
        exact = Fraction(operator.index(value) if isinstance(value, Integral)
                         else value)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        exact = Fraction(0)
    if exact <= 0:
        raise ValueError(f"{name} = {value} is out of range: allowed numbers "
                         "> 0 like 3.5, '7/2' or Fraction(7, 2)")
    return exact
