#!/usr/bin/python3
"""An SMT solver decides, from the rows that tools/export-smt writes, what the program decides.

rows_decided.py PROGRAM

Every schedule of small atlases, one contact and two, gaps of all signs: z3 finds the rows satisfiable if and only
if the program has found a motion, so a file that says "none" of a schedule with motions proves nothing. Files of
least energies are unsat, and sat as soon as that energy is allowed. No multiplier of ours takes part in a verdict
about absence. A file with one sign changed, so that the bar at rest satisfies it, is never unsat.
"""
import copy
import json
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile

import z3

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)
from checkers.reading import NoProof
from checkers.smt import text_of


def is_satisfiable(text):
    """What z3 says of a file."""
    solver = z3.SolverFor("QF_LRA")
    solver.from_string(text)
    verdict = solver.check()
    if verdict == z3.unknown:
        sys.exit(f"z3 does not know:\n{text}")
    return verdict == z3.sat


def claim(cells, phases, gap):
    """An answer that says, with or without right, that there is no motion."""
    return {"status": "none", "cells": cells, "schedule": phases, "bar": {"length": 1, "gap": gap},
            "stops": [{"side": "right", "place": gap}], "segments": [], "certificate": {"kind": "farkas"}}


def with_rest(text, gap):
    """The file with one sign changed, so that x = 0 satisfies it."""
    rows = text.split("\n")
    row = next(i for i, line in enumerate(rows) if line.endswith(":named gap))" if gap else ":named size))"))
    rows[row] = rows[row].replace("(! (= ", "(! (>= " if gap < 0 else "(! (<= ")
    return "\n".join(rows)


def decided(program, folder, words):
    """(phases, is there a motion) of all schedules of an atlas."""
    path = folder / f"{'_'.join(words)}.sqlite"
    subprocess.run([program, "atlas", "--quiet", "--database", str(path), "--all", *words], check=True,
                   stdout=subprocess.DEVNULL)
    base = sqlite3.connect(path)
    for phases, status in base.execute("SELECT phases, status FROM schedules ORDER BY rowid"):
        if status not in ("found", "none"):
            sys.exit(f"{words}: {phases}: {status}")
        yield [list(map(int, phase.split(":"))) for phase in phases.split(",")], status == "found"
    base.close()


def check_verdicts(program, folder):
    """Compares all verdicts; schedules that have motions, with their cells and gap."""
    existing = []
    for gap in (1e-3, -1e-3, 0.0):
        for cells, phases, most in [(1, 1, ()), (2, 1, ()), (3, 1, ()), (4, 1, ()), (5, 1, ()), (1, 2, ()), (2, 2, ()),
                                    (3, 2, (3, 6)), (4, 2, (3, 5))]:
            words = ["--cells", str(cells), "--phases", str(phases), "--gap", repr(gap)]
            words += ["--max-contact", str(most[0]), "--max-free", str(most[1])] if most else []
            count = found = 0
            for schedule, has_motions in decided(program, folder, words):
                text = text_of(claim(cells, schedule, gap))
                if is_satisfiable(text) != has_motions:
                    sys.exit(f"{words}: {schedule}: z3 and the program disagree, found = {has_motions}")
                if not is_satisfiable(with_rest(text, gap)):
                    sys.exit(f"{words}: {schedule}: z3 proves that not even the bar at rest is there")
                count, found = count + 1, found + has_motions
                existing += [(cells, schedule, gap)] if has_motions else []
            print(f"{' '.join(words)}: {count} schedules, {found} with motions: z3 says so, too", flush=True)
    return existing


def check_energies(program, folder, existing):
    """Least energies: nothing below, something at them; a file spoilt is not written."""
    path, count, draw = folder / "proof.json", 0, random.Random(1)
    for cells, schedule, gap in draw.sample([one for one in existing if one[2]], 60):
        words = [str(steps) for phase in schedule for steps in phase]
        path.unlink(missing_ok=True)
        subprocess.run([program, "find", *words, "--cells", str(cells), "--gap", repr(gap), "--quiet", "--certificate",
                        str(path)], check=True, stdout=subprocess.DEVNULL)
        answer = json.loads(path.read_text(encoding="utf-8"))
        text = text_of(answer)
        if is_satisfiable(text):
            sys.exit(f"{words}: z3 has a motion of less energy")
        closed = text.replace("(assert (! (< ", "(assert (! (<= ")
        if closed == text or not is_satisfiable(closed):
            sys.exit(f"{words}: z3 has no motion of the least energy")
        spoilt = copy.deepcopy(answer)
        spoilt["energy_ratio_range"][0] *= 1 + 1e-9
        try:
            sys.exit(f"{words}: another energy was written:\n{text_of(spoilt)}")
        except NoProof:
            count += 1
    print(f"{count} least energies: nothing below, a motion at each; as many spoilt ones refused")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_energies(sys.argv[1], folder, check_verdicts(sys.argv[1], folder))


if __name__ == "__main__":
    main()
