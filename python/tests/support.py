"""What the tests share."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any, Callable

#: Runs the program and returns its JSON.
Program = Callable[..., Any]

#: The clone that the tests are of.
ROOT = Path(__file__).resolve().parents[2]


def place_of_program() -> str | None:
    """SIGNORINI_PROGRAM, the release build, or what the path has."""
    named = os.environ.get("SIGNORINI_PROGRAM")
    if named:
        return named
    built = ROOT / "build" / "release" / "bin" / "signorini"
    return str(built) if built.exists() else shutil.which("signorini")


#: How long something took, and who says so, is no part of an answer.
UNLIKE = ("schema", "version")


def alike(said: Any, ours: Any, where: str = "") -> None:
    """Compare key by key; numbers to the last bit."""
    if isinstance(said, dict):
        for key, value in said.items():
            if key in UNLIKE or where.endswith("solver") and key == "seconds":
                continue
            assert key in ours, f"{where}.{key} is missing"
            alike(value, ours[key], f"{where}.{key}")
        more = set(ours) - set(said)
        assert not more, f"{where} has {more}, too"
    elif isinstance(said, list):
        assert len(said) == len(ours), where
        for at, (one, other) in enumerate(zip(said, ours)):
            alike(one, other, f"{where}[{at}]")
    else:
        assert said == ours, f"{where}: {said!r} and {ours!r}"


def words_of(options: dict[str, Any]) -> list[str]:
    """The same for the program."""
    words = []
    for key, value in options.items():
        words.append("--" + key.replace("_", "-"))
        if value is not True:
            words.append(repr(value) if isinstance(value, float) else str(value))
    return words
