#!/usr/bin/python3
"""SMT solvers decide, from the rows that tools/export-smt writes, what the program decides.

rows_decided.py PROGRAM [COUNT]

Every schedule of small atlases, one contact and two, gaps of all signs: z3 and cvc5 find the rows satisfiable if
and only if the program has found a motion, so a file that says "none" of a schedule with motions proves nothing.
No multiplier of ours takes part in a verdict about absence. A file with one sign changed, so that the bar at rest
satisfies it, is never unsat. Then COUNT (100) files made from certificates, half of absence and half of least
energies, are unsat to both, and as many that were tampered with are sat to both, or are not even written.
"""
import copy
import json
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile

from judges import JUDGES, Judge

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)
from checkers.reading import NoProof
from checkers.smt import text_of

SOLVERS = []


def is_satisfiable(text):
    """What both say of a file."""
    verdicts = {judge.is_satisfiable(text) for judge in SOLVERS}
    if len(verdicts) > 1:
        sys.exit(f"the solvers disagree on:\n{text}")
    return verdicts.pop()


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
    """Compares all verdicts; schedules that have motions, and that have none, with their cells and gap."""
    sorted_out = {True: [], False: []}
    for gap in (1e-3, -1e-3, 0.0):
        for cells, phases, most in [(1, 1, ()), (2, 1, ()), (3, 1, ()), (4, 1, ()), (5, 1, ()), (1, 2, ()), (2, 2, ()),
                                    (3, 2, (3, 6)), (4, 2, (3, 5))]:
            words = ["--cells", str(cells), "--phases", str(phases), "--gap", repr(gap)]
            words += ["--max-contact", str(most[0]), "--max-free", str(most[1])] if most else []
            count = found = 0
            for schedule, has_motions in decided(program, folder, words):
                text = text_of(claim(cells, schedule, gap))
                if is_satisfiable(text) != has_motions:
                    sys.exit(f"{words}: {schedule}: solvers and the program disagree, found = {has_motions}")
                if not is_satisfiable(with_rest(text, gap)):
                    sys.exit(f"{words}: {schedule}: they prove that not even the bar at rest is there")
                count, found = count + 1, found + has_motions
                sorted_out[has_motions].append((cells, schedule, gap))
            print(f"{' '.join(words)}: {count} schedules, {found} with motions: {' and '.join(JUDGES)} say so, too",
                  flush=True)
    return sorted_out


def certified(program, path, cells, schedule, gap):
    """What `find --certificate` writes."""
    path.unlink(missing_ok=True)
    words = [str(steps) for phase in schedule for steps in phase]
    subprocess.run([program, "find", *words, "--cells", str(cells), "--gap", repr(gap), "--quiet", "--certificate",
                    str(path)], stdout=subprocess.DEVNULL, check=False)
    return json.loads(path.read_text(encoding="utf-8"))


def require_refused(text, what):
    """Ends the run if a file that was tampered with proves anything."""
    if not is_satisfiable(text):
        sys.exit(f"{what}: a false claim is proved:\n{text}")


def check_certificates(program, folder, sorted_out, wanted):
    """Certificates of absence and of least energy, and the same tampered with."""
    draw, accepted, refused = random.Random(1), 0, 0
    # Without a gap the size is free, and find wants an energy.
    existing, refuted = ([one for one in sorted_out[is_there] if one[2]] for is_there in (True, False))
    for k in range(wanted):
        cells, schedule, gap = one = draw.choice(refuted if k % 2 else existing)
        answer = certified(program, folder / "proof.json", *one)
        try:
            text = text_of(answer)
        except NoProof as why:
            sys.exit(f"{one}: not written: {why}: {answer}")
        if is_satisfiable(text):
            sys.exit(f"{one}: the solvers have a motion that is not to be there")
        accepted += 1
        if answer["status"] == "none" and k % 4 == 1:
            require_refused(with_rest(text, gap), one)
        elif answer["status"] == "none":  # the same certificate for a schedule that has motions
            cells, schedule, gap = draw.choice(existing)
            require_refused(text_of({**answer, **claim(cells, schedule, gap)}), schedule)
        elif k % 4 == 0:  # the least energy itself is not to be there either
            closed = text.replace("(assert (! (< ", "(assert (! (<= ")
            if closed == text:
                sys.exit(f"{one}: no row of energy")
            require_refused(closed, one)
        else:
            spoilt = copy.deepcopy(answer)
            spoilt["energy_ratio_range"][0] *= 1 + 1e-9
            try:
                sys.exit(f"{one}: another energy was written:\n{text_of(spoilt)}")
            except NoProof:
                pass
        refused += 1
    print(f"{accepted} certificates of absence and of least energy accepted, {refused} tampered with refused")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    SOLVERS.extend(Judge(name) for name in JUDGES)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        sorted_out = check_verdicts(sys.argv[1], folder)
        check_certificates(sys.argv[1], folder, sorted_out, int(sys.argv[2]) if len(sys.argv) > 2 else 100)
    print(", ".join(f"{judge.name} {judge.cpu():.1f} s" for judge in SOLVERS), "of the processor")
    for judge in SOLVERS:
        judge.close()


if __name__ == "__main__":
    main()
