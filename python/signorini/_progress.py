"""Progress of a long call."""

from __future__ import annotations

import sys
from typing import Any, Callable, Union

#: A function of (done, total), True for a bar, a tqdm bar or its class.
Progress = Union[Callable[[float, float], object], bool, Any, None]


class _Bar:
    """Feeds a tqdm bar."""

    def __init__(self, bar: Any) -> None:
        self.bar = bar

    def __call__(self, done: float, total: float) -> None:
        self.bar.total = total
        self.bar.update(done - self.bar.n)
        if done >= total:
            self.bar.refresh()


def _plain(done: float, total: float) -> None:
    """One line that is overwritten, if tqdm is not installed."""
    end = "\n" if done >= total else ""
    sys.stderr.write(f"\r{100 * done / total:5.1f} %{end}")


def listener(progress: Progress) -> Callable[[float, float], object] | None:
    """What the library is to call."""
    if progress is None or progress is False:
        return None
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return _plain
        return _Bar(tqdm(total=0))
    if isinstance(progress, type) and hasattr(progress, "update"):
        return _Bar(progress(total=0))
    if hasattr(progress, "update") and hasattr(progress, "n"):
        return _Bar(progress)
    if not callable(progress):
        raise TypeError("progress: allowed a function of (done, total), "
                        "True, or a tqdm bar")
    function: Callable[[float, float], object] = progress
    return function
