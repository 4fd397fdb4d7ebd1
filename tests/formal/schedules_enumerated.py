#!/usr/bin/python3
"""SMT solvers look for schedules themselves, and find those of the atlas.

schedules_enumerated.py PROGRAM [STEPS]

For each period of up to STEPS (9) steps on small grids z3 and cvc5 get one file: waves p_m that arrive at the tip, a
Boolean "step m is in contact" for each step, p_{m+2N} = p_m in contact and -p_m in flight, pushes >= 0, the tip not
beyond the wall, all of it periodic, at most two contacts. Each schedule that they find is forbidden in all its
rotations, until none is left. Prints how many there are, and what that took beside the atlas.
"""
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

from judges import JUDGES, Judge

MOST_CONTACTS = 2


def total(terms):
    """A sum."""
    return f"(+ {' '.join(terms)})" if len(terms) > 1 else terms[0]


def text_of(cells, steps, sign):
    """The rows of all schedules of a period at once."""
    lines = ["(set-option :produce-models true)", "(set-logic QF_LRA)"]
    lines += [f"(declare-const c{m} Bool)" for m in range(steps)]
    lines += [f"(declare-const p{m} Real)" for m in range(steps + 2 * cells)]
    lines += [f"(declare-const w{m} Real)" for m in range(steps + 1)]  # the way of the tip from the wall
    rows = ["c0", f"(not c{steps - 1})", f"(= {total([f'p{m}' for m in range(2 * cells)])} (- {sign * cells}.0))"
            if sign > 0 else f"(= {total([f'p{m}' for m in range(2 * cells)])} {cells}.0)", "(= w0 0.0)"]
    for m in range(steps):
        rows.append(f"(= p{m + 2 * cells} (ite c{m} p{m} (- p{m})))")
        rows.append(f"(= w{m + 1} (ite c{m} w{m} (+ w{m} (* 2.0 p{m}))))")
        rows.append(f"(ite c{m} (and (>= p{m} 0.0) (= w{m} 0.0)) (<= w{m + 1} 0.0))")
    rows += [f"(= p{m + steps} p{m})" for m in range(2 * cells)] + [f"(= w{steps} 0.0)"]
    begins = [f"(ite (and c{m} (not c{(m - 1) % steps})) 1.0 0.0)" for m in range(steps)]
    rows.append(f"(<= {total(begins)} {MOST_CONTACTS}.0)")
    return "\n".join([*lines, *(f"(assert {row})" for row in rows), ""])


def schedule_of(pattern):
    """The least of the rotations of contacts and flights, from a list of Booleans that begins with a contact."""
    phases, m = [], 0
    while m < len(pattern):
        contact = next((k for k in range(m, len(pattern)) if not pattern[k]), len(pattern)) - m
        m += contact
        free = next((k for k in range(m, len(pattern)) if pattern[k]), len(pattern)) - m
        m += free
        phases.append((contact, free))
    return min(tuple(phases[k:] + phases[:k]) for k in range(len(phases)))


def enumerated(judge, cells, steps, sign):
    """All schedules that a solver finds."""
    names, found = [f"c{m}" for m in range(steps)], set()
    judge.process.stdin.write(text_of(cells, steps, sign))
    while judge.ask("(check-sat)\n") == "sat":
        values = judge.values(names)
        pattern = [values[name] == "true" for name in names]
        found.add(schedule_of(pattern))
        for shift in range(steps):
            turned = pattern[shift:] + pattern[:shift]
            same = [name if turned[m] else f"(not {name})" for m, name in enumerate(names)]
            judge.process.stdin.write(f"(assert (not (and {' '.join(same)})))\n")
    judge.process.stdin.write("(reset)\n")
    return found


def of_atlas(program, cells, steps, sign):
    """All schedules of the atlas up to so many steps, by their steps."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        path = str(pathlib.Path(folder) / "atlas.sqlite")
        for phases in range(1, MOST_CONTACTS + 1):
            subprocess.run([program, "atlas", "--quiet", "--database", path, "--cells", str(cells), "--phases",
                            str(phases), "--gap", repr(1e-3 * sign), "--max-contact", str(steps), "--max-free",
                            str(steps)], check=True, stdout=subprocess.DEVNULL)
            base = sqlite3.connect(path)
            rows = base.execute("SELECT phases FROM schedules WHERE status = 'found'").fetchall()
            base.close()
            os.unlink(path)
            for (text,) in rows:
                pairs = [tuple(map(int, phase.split(":"))) for phase in text.split(",")]
                found.setdefault(sum(map(sum, pairs)), set()).add(
                    min(tuple(pairs[k:] + pairs[:k]) for k in range(len(pairs))))
    return found


def children():
    """[s] of the processor, of programs that have ended."""
    times = os.times()
    return times.children_user + times.children_system


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    most = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    judges = [Judge(name) for name in JUDGES]
    for cells, sign in ((1, 1), (2, 1), (3, 1), (2, -1), (3, -1)):
        begin = children()
        ours = of_atlas(sys.argv[1], cells, most, sign)
        seconds, count, begins = children() - begin, 0, [judge.cpu() for judge in judges]
        for steps in range(2, most + 1):
            for judge in judges:
                theirs = enumerated(judge, cells, steps, sign)
                if theirs != ours.get(steps, set()):
                    sys.exit(f"N = {cells}, n = {steps}: {judge.name} has {sorted(theirs)}, "
                             f"the atlas {sorted(ours.get(steps, set()))}")
            count += len(ours.get(steps, ()))
        times = [f"{judge.name} {judge.cpu() - before:.2f} s" for judge, before in zip(judges, begins)]
        print(f"N = {cells}, gap {'>' if sign > 0 else '<'} 0, n <= {most}, at most {MOST_CONTACTS} contacts: the same "
              f"{count} schedules; atlas {seconds:.2f} s, {', '.join(times)} of the processor", flush=True)
    for judge in judges:
        judge.close()


if __name__ == "__main__":
    main()
