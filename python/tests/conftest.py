"""Fixtures: the program to compare with, and figures without a screen."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from typing import Any

import matplotlib
import pytest
from support import Program, place_of_program

matplotlib.use("Agg")


@pytest.fixture(scope="session")
def program() -> Program:
    """The program of the same build: its JSON for these words; None where they are wrong,
    if they may be."""
    place = place_of_program()
    if place is None:
        pytest.skip("the program signorini is not built")

    path: str = place

    def run(*words: object, may_be_wrong: bool = False) -> Any:
        call = [path, *map(str, words), "--format", "json", "--quiet"]
        done = subprocess.run(call, capture_output=True, text=True,
                              check=False)
        if may_be_wrong and done.returncode == 2:
            return None
        assert done.returncode in (0, 1, 3), done.stderr
        return json.loads(done.stdout)

    return run


@pytest.fixture(autouse=True)
def no_figures_left() -> Iterator[None]:
    """Close what a test drew."""
    yield
    from matplotlib import pyplot
    pyplot.close("all")
