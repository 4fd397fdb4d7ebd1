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
