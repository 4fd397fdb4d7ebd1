"""Which argument was not what it should be."""

from __future__ import annotations

import functools
import inspect
import operator
import re
import reprlib
from typing import Any, Callable, TypeVar

from ._core import Bar, Scene, Schedule, State, Waves

Function = TypeVar("Function", bound=Callable[..., Any])

_PARAMETERS = ("length", "wave_speed", "axial_stiffness", "gap", "young",
               "density", "area")


def _is_whole(value: Any) -> bool:
    return _is_index(value) and -2 ** 63 <= operator.index(value) < 2 ** 63


def _is_number(value: Any) -> bool:
    if isinstance(value, (str, bytes, bytearray)):
        return False
    try:
        float(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return True


def _is_file(value: Any) -> bool:
    return hasattr(value, "__fspath__")


def _is_text(value: Any) -> bool:
    """A str without half a letter, a lone surrogate."""
    return isinstance(value, str) and not any(
        0xD800 <= ord(letter) < 0xE000 for letter in value)


def _are_steps(value: Any) -> bool:
    if isinstance(value, (tuple, list)):
        return len(value) > 1 and all(map(_is_index, value[:2]))
    return isinstance(value, Schedule) or _is_index(value)


def _is_index(value: Any) -> bool:
    try:
        operator.index(value)
    except TypeError:
        return False
    return True


#: What the words of an annotation take; others take anything.
_KINDS: dict[str, Callable[[Any], bool]] = {
    "None": lambda value: value is None,
    "int": _is_whole,
    "float": _is_number,
    "str": _is_text,
    "bool": lambda value: isinstance(value, bool),
    "os.PathLike[str]": _is_file,
    "Number": lambda value: isinstance(value, str) or _is_number(value),
    "Steps": _are_steps,
    "Segments": lambda value: isinstance(value, (tuple, list)),
    "Bar": lambda value: isinstance(value, Bar),
    "Scene": lambda value: isinstance(value, Scene),
    "State": lambda value: isinstance(value, State) or _is_file(value),
    "Waves": lambda value: isinstance(value, Waves),
}


def _require(name: str, value: Any, annotation: Any) -> None:
    """TypeError with the name if the value is of no kind that is named."""
    if not isinstance(annotation, str):
        return
    words = [word.strip() for word in annotation.split("|")]
    if all(word in _KINDS and not _KINDS[word](value) for word in words):
        wide = ", at most 64 bits" if "int" in words else ""
        raise TypeError(f"{name} = {reprlib.repr(value)}: allowed "
                        f"{annotation}{wide}") from None


def _blame(function: Function, args: Any, options: dict[str, Any]) -> None:
    """TypeError if an argument does not match its annotation."""
    signature = inspect.signature(function)
    try:
        given = signature.bind(*args, **options).arguments
    except TypeError:
        return  # Python itself has named it
    for name, parameter in signature.parameters.items():
        if name not in given:
            continue
        if parameter.kind is parameter.VAR_POSITIONAL:
            for value in given[name]:
                _require(name, value, parameter.annotation)
        elif parameter.kind is parameter.VAR_KEYWORD:
            for word, value in given[name].items():
                if word not in _PARAMETERS:
                    raise TypeError(f"{function.__name__}() has no argument "
                                    f"{word}") from None
                _require(word, value, "float | None")
        else:
            _require(name, given[name], parameter.annotation)


#: What pybind11 says of arguments that fit no signature.
_RAW = re.compile(r"incompatible (?:constructor|function) arguments\..*?"
                  r"\n    1\. (?P<signature>.*?)(?: -> .*)?\n", re.DOTALL)


def _plainly(name: str, error: TypeError, args: Any,
             options: dict[str, Any]) -> TypeError:
    """The same error in words of Python's own: what was given, what fits."""
    raw = _RAW.search(str(error))
    if raw is None:
        return error
    fits = raw["signature"].replace("signorini._core.", "")
    fits = name + re.sub(r"^\w*\((self: \w+(, )?)?", "(", fits)
    given = [reprlib.repr(value) for value in args]
    given += [f"{word}={reprlib.repr(value)}"
              for word, value in options.items()]
    return TypeError(f"{name}({', '.join(given)}): allowed {fits}")


def _speaking(method: Any, name: str) -> Any:
    @functools.wraps(method)
    def call(self: Any, *args: Any, **options: Any) -> Any:
        try:
            return method(self, *args, **options)
        except TypeError as error:
            raise _plainly(name, error, args, options) from None
    return call


def let_speak(module: Any) -> None:
    """Give the compiled classes readable TypeErrors."""
    for cls in vars(module).values():
        if not isinstance(cls, type) or issubclass(cls, Exception):
            continue
        for name, method in list(vars(cls).items()):
            if type(method).__name__ == "instancemethod" and (
                    name == "__init__" or not name.startswith("_")):
                shown = cls.__name__ if name == "__init__" else name
                setattr(cls, name, _speaking(method, shown))


def named(function: Function) -> Function:
    """Have errors about kinds of arguments name the argument."""
    @functools.wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        try:
            return function(*args, **options)
        except (TypeError, ValueError, AttributeError,
                OverflowError) as error:
            _blame(function, args, options)
            if isinstance(error, TypeError):
                raise _plainly(function.__name__, error, args,
                               options) from None
            raise
    return call  # type: ignore[return-value]
