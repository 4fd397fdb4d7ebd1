#!/usr/bin/env python3
"""Makes the sources of the site: stage.py PROGRAM DOXYGEN_XML OUTPUT.

This folder, what lies elsewhere in the project, pages out of program, schemas and headers, and the
formulas' MathJax. What the gallery has made in OUTPUT before stays.
"""

import re
import shutil
import sys
from pathlib import Path

import cpp_pages
import formulas
import program_pages
import python_pages
import schema_pages

ROOT = Path(__file__).resolve().parents[1]
MATHJAX = Path("/usr/share/javascript/mathjax")
# What the pages load: TeX in, SVG out.
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_SVG.js", "jax/output/SVG", "jax/element",
                 "jax/input/TeX", "extensions"]  # fmt: skip
OTHER_FONTS = shutil.ignore_patterns("Asana-Math", "Gyre-*", "Latin-Modern", "Neo-Euler", "STIX-Web")


def copy_mathjax(output: Path) -> None:
    """The few parts of MathJax that draw TeX as SVG."""
    for part in MATHJAX_PARTS:
        target = output / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if (MATHJAX / part).is_dir():
            shutil.copytree(MATHJAX / part, target, ignore=OTHER_FONTS)
        else:
            shutil.copyfile(MATHJAX / part, target)


def write_toctree(folder: Path, names: list[str]) -> None:
    """The list of pages that index.md of the folder includes."""
    text = "```{toctree}\n:maxdepth: 1\n" + "\n".join(names) + "\n```\n"
    (folder / "toctree.txt").write_text(text, encoding="utf-8")


def copy_back_ends(output: Path) -> None:
    """The description of the back ends; its links into the sources are words here."""
    text = (ROOT / "solvers/README.md").read_text(encoding="utf-8")
    output.write_text(re.sub(r"\]\((?!https)[^)]*\)", "]", text), encoding="utf-8")


def main() -> None:
    program, xml, output = (Path(word).resolve() for word in sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    for old in output.iterdir():
        if old.name != "examples":
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    skip = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "docs", output, dirs_exist_ok=True, ignore=skip)
    shutil.copyfile(ROOT / "CITATION.cff", output / "CITATION.cff")
    copy_back_ends(output / "back_ends.md")
    theory = output / "theory.md"
    theory.write_text(formulas.displayed(theory.read_text("utf-8")), encoding="utf-8")
    copy_mathjax(output / "_static/mathjax")
    reference = output / "reference"
    scratch = output.parent / "scratch"
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir()
    for name, names in {
        "program": program_pages.write(program, reference / "program", scratch),
        "schema": schema_pages.write(ROOT / "docs/schema", reference / "schema"),
        "python": python_pages.write(reference / "python"),
        "cpp": cpp_pages.write(xml, reference / "cpp"),
    }.items():
        write_toctree(reference / name, names)


if __name__ == "__main__":
    main()
