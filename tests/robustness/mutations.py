#!/usr/bin/env python3
"""Spoils the library in one place at a time and looks whether its tests notice.

    mutations.py [--build build/release] [--floor sets|check|geometry] [--count N] [--seed S] [--list]

A mutant is a comparison, a bound, a sign or a logical word of src/<floor> that became another one. Each
is built with the tests below and run; the file is put back. A mutant that no test notices survives and
is printed with its line: a test is missing there, or the change is none (a bound that cannot be met).
Exit status 1 if some survive.
"""
import argparse
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Quick tests that know a floor, in the order in which they are asked.
TESTS = {
    "sets": ["sets-tests", "find-tests"],
    "check": ["paper-tests", "find-tests", "contract-tests"],
    "geometry": ["geometry-tests", "sets-tests", "find-tests"],
}
CHANGES = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "),
           (" != ", " == "), (" + ", " - "), (" - ", " + "), (" += ", " -= "), (" -= ", " += "),
           (" && ", " || "), (" || ", " && "), ("std::min", "std::max"), ("std::max", "std::min"),
           (" = 0;", " = 1;"), ("return true;", "return false;"), ("return false;", "return true;")]
NO_CODE = re.compile(r'^\s*(//|#|template|using|\*)|"|static_assert|throw |operator')


def places(floor):
    """All mutants of a floor: (file, line, column, old, new)."""
    found = []
    for path in sorted((ROOT / "src" / floor).glob("*.cpp")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines()):
            if NO_CODE.search(line):
                continue
            code = line.split("//")[0]
            for old, new in CHANGES:
                start = code.find(old)
                while start >= 0:
                    found.append((path, number, start, old, new))
                    start = code.find(old, start + len(old))
    return found


def is_noticed(build, tests):
    """How the mutant ends: "build" or the name of a test; None if it survives."""
    for test in tests:
        if subprocess.run(["ninja", "-C", build, test], capture_output=True, check=False).returncode:
            return "build"
        try:
            if subprocess.run([Path(build) / "bin" / test, "-a"], capture_output=True, check=False,
                              timeout=90).returncode:
                return test
        except subprocess.TimeoutExpired:
            return f"{test}, without end"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default=str(ROOT / "build/release"))
    parser.add_argument("--floor", choices=TESTS, default="geometry")
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true", help="all places, and build nothing")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(3))  # the file is put back
    mutants = places(options.floor)
    if options.list:
        for path, number, _, old, new in mutants:
            print(f"{path.relative_to(ROOT)}:{number + 1}: '{old}' -> '{new}'")
        return 0
    if is_noticed(options.build, TESTS[options.floor]) is not None:
        sys.exit("the tests fail, or do not build, without any change")
    survivors = 0
    chosen = random.Random(options.seed).sample(mutants, min(options.count, len(mutants)))
    for path, number, start, old, new in chosen:
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines(keepends=True)
        line = lines[number]
        lines[number] = line[:start] + new + line[start + len(old):]
        begin = time.monotonic()
        try:
            path.write_text("".join(lines), encoding="utf-8")
            noticed = is_noticed(options.build, TESTS[options.floor])
        finally:
            path.write_text(text, encoding="utf-8")
        survivors += noticed is None
        print(f"{path.relative_to(ROOT)}:{number + 1}: '{old}' -> '{new}': "
              f"{noticed or 'SURVIVES: ' + line.strip()} ({time.monotonic() - begin:.0f} s)", flush=True)
    print(f"{len(chosen)} of {len(mutants)} mutants tried, {survivors} survive")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
