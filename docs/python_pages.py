"""The Python reference: what `signorini.__all__` names, functions, figures and classes apart."""

import inspect
from pathlib import Path

import signorini
import signorini.plot


def page(title: str, about: str, directives: list[str]) -> str:
    body = "\n\n".join(directives)
    return f"# {title}\n\n{about}\n\n```{{eval-rst}}\n.. currentmodule:: signorini\n\n{body}\n```\n"


def write(folder: Path) -> list[str]:
    """All pages; returns their names."""
    folder.mkdir(parents=True, exist_ok=True)
    named = [(name, getattr(signorini, name)) for name in sorted(signorini.__all__)]
    drawn = [(name, getattr(signorini.plot, name)) for name in signorini.plot.__all__]
    pages = {
        "functions": page(
            "Functions",
            "Arguments are named as the options of the program.",
            [f".. autofunction:: {n}" for n, what in named if inspect.isroutine(what)],
        ),
        "figures": page(
            "Figures",
            (signorini.plot.__doc__ or "").strip(),
            [f".. autofunction:: signorini.plot.{n}" for n, what in drawn if inspect.isfunction(what)],
        ),
        "classes": page(
            "Answers and what goes into them",
            "Attributes are named as the keys of the JSON answers.",
            [
                f".. autoclass:: {n}\n   :members:\n   :undoc-members:\n   :inherited-members: Exception"
                for n, what in named
                if inspect.isclass(what)
            ],
        ),
    }
    for name, text in pages.items():
        (folder / f"{name}.md").write_text(text, encoding="utf-8")
    return list(pages)
