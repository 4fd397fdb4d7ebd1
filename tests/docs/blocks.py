#!/usr/bin/env python3
"""Runs every code block of the pages.

    blocks.py --program SIGNORINI --prefix INSTALLED [--only REGEX] [PAGE...]

The blocks of one page run in one folder, in their order; as many pages at once as there are cores. What is run:

- sh: every command must end with status 0, or with the N of "status N" in its comment;
- python: the blocks of a page as one program;
- cpp: compiled against the installed library, and run; statements without a main get one;
- cmake: configures a project whose example.cpp is the page's first program;
- json: must parse, and an answer (it has a key "schema") be as one of docs/schema says;
- text: not code; but of "text output" each line must be in what the commands above it wrote (runs of
  spaces count as one).

`<!-- tried by FILE: WORDS -->` before a block: FILE, a script or test of the project, runs the same,
and has these words in it.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

import jsonschema

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^( *)```(\S*)(?: (.*))?$")
ELSEWHERE = re.compile(r"<!-- tried by (\S+): (.+?) -->")
STATUS = re.compile(r"#.*\bstatus (\d)")
HEADER = "#include <iostream>\n#include <signorini/signorini.hpp>\nusing namespace signorini;\n"


class Block(NamedTuple):
    """Some code on a page."""

    page: Path
    line: int
    language: str
    text: str
    elsewhere: tuple[str, str] | None  # file, words
    is_output: bool


class Fault(Exception):
    """A block that does not do what it should."""


def blocks_of(page: Path) -> list[Block]:
    """All fenced blocks; those in {braces} are directives of Sphinx, not code."""
    found = []
    lines = page.read_text(encoding="utf-8").split("\n")
    at = 0
    while at < len(lines):
        if match := FENCE.match(lines[at]):
            end = next(i for i in range(at + 1, len(lines)) if lines[i].strip() == "```")
            before = " ".join(lines[max(0, at - 2):at])
            elsewhere = ELSEWHERE.search(before)
            if not match[2].startswith("{"):
                text = "\n".join(line.removeprefix(match[1]) for line in lines[at + 1:end])
                tried = (elsewhere[1], elsewhere[2]) if elsewhere else None
                found.append(Block(page, at + 2, match[2], text + "\n", tried, match[3] == "output"))
            at = end
        at += 1
    return found


def run(command: list[str], folder: Path, environment: dict[str, str], expected: int = 0) -> str:
    """Runs a program and returns what it printed, which a fault shows if it ends otherwise than expected."""
    done = subprocess.run(
        command,
        cwd=folder,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=300,
        check=False,
    )
    if done.returncode != expected:
        shown = command[-1] if command[0] == "bash" else " ".join(command)
        raise Fault(f"{shown.strip()}\nstatus {done.returncode}, not {expected}:\n{done.stdout[-3000:]}")
    return done.stdout


def commands_of(text: str) -> list[str]:
    """One command a line, but for lines that end with a backslash and for here-documents."""
    if "<<" in text:
        return [text]
    joined = text.replace("\\\n", " ")
    return [line for line in joined.split("\n") if line.strip() and not line.startswith("#")]


class Page:
    """The blocks of one page, their folder and what they find on their way."""

    def __init__(self, page: Path, folder: Path, program: Path, prefix: Path) -> None:
        self.page, self.folder, self.prefix = page, folder, prefix
        pkg_config = next(prefix.glob("lib*/**/pkgconfig"))
        self.environment = os.environ | {
            "PATH": f"{program.resolve().parent}:{os.environ['PATH']}",
            "PKG_CONFIG_PATH": str(pkg_config),
            "MPLBACKEND": "Agg",
            "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_rmaps_base_oversubscribe": "1",
        }
        self.python = ""
        self.program = ""  # the first C++ program
        self.written = ""  # by the commands of the last block of them
        for given in (Path(__file__).parent / "given").iterdir():
            (folder / given.name).write_bytes(given.read_bytes())

    def try_block(self, block: Block) -> None:
        """Runs one block by its language."""
        if block.elsewhere:
            name, words = block.elsewhere
            if not (ROOT / name).is_file() or words not in (ROOT / name).read_text("utf-8"):
                raise Fault(f"{name} does not say {words}")
        elif block.language in ("", "text"):
            self.try_output(block)
        elif method := getattr(self, f"try_{block.language}", None):
            method(block)
        else:
            raise Fault(f"blocks in {block.language} are not known to {Path(__file__).name}")

    def try_output(self, block: Block) -> None:
        """Is it a part of what the commands above it wrote?"""
        lines = block.text.splitlines() if block.is_output else []
        if missing := [line for line in lines if " ".join(line.split()) not in self.written]:
            raise Fault(f"not written by the commands above: {missing[0]}")

    def try_sh(self, block: Block) -> None:
        self.written = ""
        for command in commands_of(block.text):
            status = STATUS.search(command)
            expected = int(status[1]) if status else 0
            shown = run(["bash", "-euo", "pipefail", "-c", command], self.folder, self.environment, expected)
            self.written += " ".join(shown.split()) + " "

    def try_python(self, block: Block) -> None:
        """Keeps the block for `finish`, on the line that it has on the page."""
        self.python += "\n" * (block.line - 1 - self.python.count("\n")) + block.text

    def finish(self) -> None:
        """Runs the page's Python."""
        if not self.python:
            return
        (self.folder / "page.py").write_text(self.python, encoding="utf-8")
        run([sys.executable, "page.py"], self.folder, self.environment)

    def try_cpp(self, block: Block) -> None:
        text = block.text
        if "int main(" not in text:
            text = f"{HEADER}int main()\n{{\n#line {block.line}\n{text}}}\n"
        elif not self.program:
            self.program = text
        (self.folder / "example.cpp").write_text(text, encoding="utf-8")
        build = (
            "c++ -std=c++20 -O0 -Wall -Wextra -Werror -Wno-unused example.cpp -o example"
            " $(pkg-config --cflags --libs signorini)"
        )
        run(["bash", "-euo", "pipefail", "-c", build], self.folder, self.environment)
        run(["./example"], self.folder, self.environment)

    def try_cmake(self, block: Block) -> None:
        if not self.program:
            raise Fault("no program before this project")
        folder = self.folder / "project"
        folder.mkdir(exist_ok=True)
        (folder / "example.cpp").write_text(self.program, encoding="utf-8")
        (folder / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.22)\nproject(example CXX)\n"
            f"set(CMAKE_CXX_STANDARD 20)\nadd_executable(example example.cpp)\n{block.text}",
            encoding="utf-8",
        )
        configure = ["cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={self.prefix}"]
        run(configure, folder, self.environment)

    def try_json(self, block: Block) -> None:
        answer = json.loads(block.text)
        if "schema" not in answer:
            return
        files = [json.loads(path.read_text("utf-8")) for path in (ROOT / "docs/schema").iterdir()]
        store = {schema["$id"]: schema for schema in files}
        for schema in files:
            resolver = jsonschema.RefResolver("", schema, store)
            if jsonschema.Draft202012Validator(schema, resolver=resolver).is_valid(answer):
                return
        raise Fault("an answer that no schema describes")


def try_page(path: Path, program: Path, prefix: Path, only: str) -> tuple[int, int]:
    """How many blocks of a page were tried, and how many of them have a fault."""
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        page = Page(path, Path(folder), program, prefix)
        blocks = [one for one in blocks_of(path) if re.search(only, one.language)]
        steps = [(block.line, partial(page.try_block, block)) for block in blocks]
        for line, step in [*steps, (0, page.finish)]:
            begin = time.monotonic()
            try:
                step()
            except (Fault, subprocess.TimeoutExpired, ValueError) as fault:
                print(f"{path}:{line}: {fault}", file=sys.stderr)
                faults += 1
            if (seconds := time.monotonic() - begin) > 10:
                print(f"{path}:{line}: {seconds:.0f} s")
    return sum(block.language not in ("", "text") or block.is_output for block in blocks), faults


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("pages", nargs="*", type=Path, help="README.md and all of docs")
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--prefix", type=Path, required=True)
    parser.add_argument("--only", default="", help="only languages that this expression finds")
    arguments = parser.parse_args()
    pages = arguments.pages or [
        ROOT / "README.md",
        ROOT / "solvers/README.md",
        *sorted((ROOT / "docs").rglob("*.md")),
    ]
    prefix = arguments.prefix.resolve()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        tried = list(pool.map(lambda path: try_page(path, arguments.program, prefix, arguments.only), pages))
    count, faults = (sum(column) for column in zip(*tried))
    print(f"blocks: {count} blocks on {len(pages)} pages, {faults} faults")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
