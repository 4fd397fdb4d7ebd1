"""Errors about kinds of arguments, in words of Python's own."""

from __future__ import annotations

import functools
import re
import reprlib
from typing import Any

from . import _core

#: What pybind11 says of arguments that fit no signature.
_RAW = re.compile(r"incompatible (?:constructor|function) arguments\..*?"
                  r"\n    1\. (?P<signature>.*?)(?: -> .*)?\n", re.DOTALL)


def plainly(name: str, error: TypeError, args: Any,
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


def in_python(words: str) -> str:
    """The library's words with its names as Python has them: "maxOrder = 0 …" is of max_order, and
    --max-order too."""
    words = re.sub(r"--[a-z][a-z-]*", lambda found: _core.argument(found[0]), words)
    return re.sub(r"(?<=[a-z])[A-Z](?=[^ \n,;:.()]* = )|(?<=e)S(?=peed)|(?<=l)S(?=tiffness)",
                  lambda found: "_" + found[0].lower(), words)


def _speaking(method: Any, name: str) -> Any:
    @functools.wraps(method)
    def call(self: Any, *args: Any, **options: Any) -> Any:
        try:
            return method(self, *args, **options)
        except TypeError as error:
            raise plainly(name, error, args, options) from None
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
