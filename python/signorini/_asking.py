"""What a call asks: its arguments on their way to the library, and their docstrings."""

from __future__ import annotations

import re
import textwrap
from typing import Any, Callable, TypeVar

from . import _core
from ._core import Scene, SceneContinuumPoint
from ._progress import listener
from ._words import (arguments, cells_of, number, path, scene_of, schedule_of,
                     spans_of, state_of)

Function = TypeVar("Function", bound=Callable[..., Any])

#: Arguments that are no options of the program.
_SAID = {
    "schedule": "n_c, n_f of each contact phase in turn; with a second stop "
                'phases on it are (n_c, n_f, "left").',
    "bar": "What units mean in SI; or its parameters as keywords: `length`, "
           "`wave_speed`, `axial_stiffness`, `gap`, `young`, `density`, `area` or "
           "`diameter`.",
    "cells": "N, cells of the bar: those of all segments, or 300.",
    "second_stop": "h [m], to a stop on the other side of the tip.",
    "scene": "In place of `bar`, `second_stop` and `segments`",
    "segments": "A stepped bar, clamp first: (cells, impedance, speed, "
                "dashpot) of each.",
    "progress": "Told how far a long call has come.",
    "figure": "To draw into.",
    "axes": "In its place; several in a sequence, or a dict by their names.",
}

#: A scene that may be of several bars.
_IN_WORDS = ('; or the words of several bars in a row, "clamp 60 dash=0.1 driven gap=1e-3 40 '
             'clamp", whose scales are `length`, `wave_speed` and `axial_stiffness`, and whose '
             "damping is among the words")

#: What annotations mean.
_KINDS = {"Steps": "int, pairs of int, or Schedule", "Segments": "list of Segment",
          "Number": "float, str or Fraction",
          "Quantity": "float or str", "os.PathLike[str]": "path",
          "Moving": "Motion, HarmonicResult, or what has a motion",
          "Progress": "callable of (done, total), bool or tqdm bar, optional"}

#: The flag of code that takes *words.
VARARGS = 0x04

_RAISES = """
Raises
------
ValueError
    If an argument is out of its range; the message is the library's.
"""
_LACKS = """BackendUnavailable
    If no solver of this build can do what is asked.
"""


def _kind(name: str, annotation: str) -> str:
    if annotation == "Any":
        return f"matplotlib {name}, optional"
    words = [_KINDS.get(word, word) for word in annotation.split(" | ")]
    kind = " or ".join(word for word in words if word != "None")
    return kind + ", optional" * ("None" in words)


def _parameters(function: Any, question: str, told: dict[str, str]) -> str:
    """The section of a docstring, of what is told there and of the options."""
    options = _core.options(question)
    text = "\nParameters\n----------\n"
    code = function.__code__
    names = code.co_varnames
    count = code.co_argcount, code.co_argcount + code.co_kwonlyargcount
    arguments.update(names[:count[1]])
    stars = names[count[1]:count[1] + 1] if code.co_flags & VARARGS else ()
    for name in (*names[:count[0]], *stars, *names[count[0]:count[1]]):
        if name in ("self", "cls"):
            continue
        said = _SAID.get(name, options.get(name, ""))
        annotation = function.__annotations__[name]
        kind = _kind(name, annotation)
        if name == "scene":
            said += _IN_WORDS * ("str" in annotation) + "."
        text += told.get(
            name, f"{'*' * (name in stars)}{name} : {kind}\n"
            + textwrap.indent(textwrap.fill(said, 75) + "\n", "    ").lstrip("\n"))
    return text


def documented(function: Any, question: str) -> str:
    """The docstring with all parameters, and what is raised."""
    sentence, rest = str(function.__doc__).split("\n", 1)
    head, *sections = re.split(r"(?m)^(?=\w+\n---)", textwrap.dedent(rest))
    told: dict[str, str] = {}
    if sections and sections[0].startswith("Parameters"):
        said = sections.pop(0).rstrip("\n") + "\n"
        for entry in re.split(r"(?m)^(?=\*?\w+(?:, \w+)* : )", said)[1:]:
            first, *others = entry.split(" : ")[0].strip("*").split(", ")
            told.update({first: entry, **dict.fromkeys(others, "")})
    rest = "".join(sections)
    if "Raises\n---" not in rest:
        may_lack = {"solver", "engine"} & set(function.__annotations__)
        rest = rest.rstrip("\n") + "\n" + _RAISES + _LACKS * bool(may_lack)
    return (f"{sentence}\n{head}".rstrip("\n") + "\n" + _parameters(function, question, told)
            + "\n" + rest.rstrip("\n") + "\n")


def asks(question: str) -> Callable[[Function], Function]:
    """Have a function say what it takes, by the table of the program's options."""
    def asking(function: Function) -> Function:
        function.__doc__ = documented(function, question)
        return function
    return asking


def scheduled(asked: dict[str, Any]) -> dict[str, Any]:
    """The same with one schedule of its steps."""
    asked["schedule"] = schedule_of(asked["schedule"], asked["cells"])
    return asked


def as_bars(asked: dict[str, Any]) -> dict[str, Any]:
    """The same about the words of its bar: what is asked of several bars is asked of one."""
    asked["words"] = _core.words_of(asked)
    asked["scene"] = Scene(asked["scene"].bar)  # its scales
    asked["damping"] = asked["cells"] = None
    if asked.get("schedule"):
        asked["schedule"] = spans_of(asked["schedule"])
    return asked


def gathered(asked: dict[str, Any], *states: str, segments_are_bars: bool = False
             ) -> dict[str, Any]:
    """What the compiled part is asked, of the arguments of a call.

    Of a scene's parts one scene, of a bar under gravity the words of a scene, and of one of
    segments where these are asked about as bars are; of the names of files states.
    """
    get = asked.get
    where, segments = get("scene"), get("segments")
    several = isinstance(where, str)
    if several:
        asked["words"], where = where, None
        if get("second_stop") is not None or segments is not None:
            raise ValueError("scene clashes with second_stop, segments: allowed "
                             "those among its words")
        if asked["bar_options"].get("gap") is not None:
            raise ValueError("scene clashes with gap: allowed gap=G and stop=G among its words")
    scene = asked["scene"] = scene_of(
        where, get("bar"), get("second_stop"), segments, asked["bar_options"])
    if where is not None and scene.words:
        several, asked["words"] = True, scene.words
        scene = asked["scene"] = Scene(scene.bar)  # its scales
    if not several and get("cells") is None:
        asked["cells"] = cells_of(None, scene, get("schedule", ()))
    if not several and ((segments_are_bars and scene.segments) or (
            get("gravity") and number("gravity", asked["gravity"]) != 0.0)):
        as_bars(asked)
        several = True
    for name in states:
        if asked[name] is not None:
            asked[name] = (asked[name] if isinstance(asked[name], SceneContinuumPoint)
                           else path(name, asked[name]) if several
                           else state_of(asked[name], scene.bar, asked["cells"]))
    if get("progress") is not None:
        asked["progress"] = listener(asked["progress"])
    if get("file") is not None:
        asked["file"] = path("file", asked["file"])
    return asked
