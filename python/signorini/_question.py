"""A question in physics: all motions of one period."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

from . import _core
from ._asking import as_bars
from ._core import (Bar, HarmonicResult, Result, SceneContinuum, SceneForcedResult,
                    SceneHarmonicResult, SceneQuestion, SceneResult)
from ._tables import Table, plain
from ._words import fraction_of, number, whole

if TYPE_CHECKING:
    from ._core import QuestionPart


class Question(Table[Result]):
    """All motions of one period: a sequence of Result, one for each set.

    Attributes
    ----------
    status : str
        "found", "none" or "undecided".
    question : dict
        What was asked, as a period, a frequency and an energy.
    sets : list of dict
        Every set of motions of this period, also without a motion that
        meets the demands.
    motions : list of Result
    reason, detail : str or None
        Why there is no motion.
    """

    if TYPE_CHECKING:
        status: str
        cells: int
        bar: Bar
        question: QuestionPart
        sets: list[dict[str, Any]]
        motions: list[Result]
        reason: str | None
        detail: str | None


def _one_of(asked: dict[str, Any]) -> tuple[str, Any]:
    """What was asked, and the word for it."""
    given = {name: word for name, word in asked.items() if word is not None}
    if len(given) != 1:
        raise ValueError("period, frequency, hertz: allowed one of them")
    (name, word), = given.items()
    is_hertz = name == "frequency" and isinstance(word, str) and word.endswith("Hz")
    return "hertz" if is_hertz else name, word


def _word(name: str, given: Any) -> str:
    """A period, a frequency or hertz as text, which the library reads."""
    if name == "hertz":
        return repr(number(name, given))
    fraction_of(given, name)  # is it a number?
    return str(given)


def find_harmonic(asked: dict[str, Any], times: dict[str, Any]) -> HarmonicResult:
    """Motions on no grid under an exact harmonic, whose frequency is meant, if one is."""
    return _core.find_harmonic(_timed(times, asked))


#: What is asked of motions without a force, and with one.
OF_FREE = ("energy", "energy_ratio", "target", "time_limit", "objective", "solver", "tolerance")
_OF_FORCED = ("amplitude", "amplitude_velocity", "amplitude_acceleration", "cycles")


def refuse(asked: dict[str, Any], usual: dict[str, Any], names: tuple[str, ...],
           where: str) -> None:
    """ValueError if one of them is not what it is without."""
    clash = [name for name in names if asked[name] != usual.get(name)]
    if clash:
        raise ValueError(f"{', '.join(clash)}: allowed only {where}")


def _spans_in(schedule: Sequence[Any]) -> list[str]:
    return [word if isinstance(word, str) else str(whole("schedule", word)) for word in schedule]


def continuum_of_bars(asked: dict[str, Any]) -> SceneContinuum:
    """Trace motions of several bars, or of a bar of several segments."""
    if asked["cells"] is not None:
        raise ValueError("cells: allowed only without a scene of words")
    asked["steps"] = _spans_in(asked["schedule"])
    return _core.continuum_bars(asked)


def find_bars(asked: dict[str, Any], times: dict[str, Any], usual: dict[str, Any]
              ) -> SceneResult | SceneForcedResult | SceneHarmonicResult | SceneQuestion:
    """Answer what is asked about several bars: of a schedule, or under an exact harmonic."""
    if asked["damping"] is not None:
        raise ValueError("damping clashes with a scene of words: allowed dash=D among them")
    refuse(asked, usual, ("cells", "tip_floor", "formulation"),
           "without a scene of words, gravity, or segments under an exact harmonic")
    if not times or asked["force"] is None:
        refuse(asked, usual, ("contacts",), "of a period, together with force")
    schedule = asked["schedule"]
    if not times:
        forced = asked["force"] is not None
        refuse(asked, usual, OF_FREE if forced else _OF_FORCED,
               "without force" if forced else "together with force")
        asked["steps"] = _spans_in(schedule)
        return _core.find_forced_bars(asked) if forced else _core.find_bars(asked)
    if asked["force"] is None:
        refuse(asked, usual, _OF_FORCED, "together with force")
        return ask_bars(times, asked)
    refuse(asked, usual, OF_FREE, "of a schedule, or without force")
    if schedule:
        raise ValueError("period, frequency, hertz: of a forced scene of words allowed without a "
                         "schedule")
    return _core.find_harmonic_bars(_timed(times, asked))


def _timed(times: dict[str, Any], asked: dict[str, Any]) -> dict[str, Any]:
    """The same with what was asked for as text."""
    name, word = _one_of(times)
    return {**asked, **dict.fromkeys(times), name: _word(name, word)}


def ask_bars(times: dict[str, Any], asked: dict[str, Any]) -> SceneQuestion:
    """All motions of a period of several bars, or of a bar of several segments."""
    if asked["schedule"]:
        raise ValueError("a schedule clashes with period, frequency and hertz: allowed one of "
                         "them")
    return _core.find_period_bars(_timed(times, asked if "words" in asked else as_bars(asked)))


def ask(times: dict[str, Any], asked: dict[str, Any]) -> Question:
    """Answer a question by `find` for each set of motions of a period."""
    _, word = _one_of(times)
    head = _core.find_period(
        {**_timed(times, asked), "said": str(word)})
    motions = head.pop("motions")
    return Question("motions", motions, **{**plain(head), "bar": head["bar"]})
