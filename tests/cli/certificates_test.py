#!/usr/bin/env python3
"""Certificates the program prints prove absence to a checker that shares no code with it.

certificates_test.py PROGRAM CHECKER [--count N] [--seed S]

Random schedules: every "none" must come with a proof, and a proof spoilt in one number is refused.
"""
import argparse
import copy
import importlib.machinery
import importlib.util
import json
import random
import subprocess
import sys


def load(path):
    """The checker as a module."""
    loader = importlib.machinery.SourceFileLoader("checker", path)
    spec = importlib.util.spec_from_loader("checker", loader)
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def spoilt(answer, draw):
    """The answer with one change that no proof survives."""
    answer = copy.deepcopy(answer)
    certificate = answer["certificate"]
    lists = [name for name in ("periodicity", "pressure", "penetration") if certificate[name]]
    ways = ["gap"] + [(way, name) for name in lists for way in ("value", "drop", "twice")]
    way = draw.choice(ways)
    if way == "gap":
        gap = certificate["gap"]
        certificate["gap"] = draw.choice([v for v in (0, 1, -1, -gap, gap - 1, 1.5) if v != gap])
        return answer, "gap"
    kind, name = way
    rows = certificate[name]
    place = draw.randrange(len(rows))
    if kind == "value":
        rows[place][1] += draw.choice([-1, 1])
    elif kind == "drop":
        del rows[place]
    else:
        rows.append(rows[place])
    return answer, f"{name}, {kind}, row {place}"


def is_without_effect(checker, answer, other):
    """Do they differ only in rows of (30) that read 0 = 0, where W leaves the unknown alone?"""
    first, second = (dict(map(tuple, a["certificate"]["periodicity"])) for a in (answer, other))
    changed = [row for row in first.keys() | second.keys() if first.get(row, 0) != second.get(row, 0)]
    state = [(unknown, 1) for unknown in range(2 * answer["cells"])]
    for contact, free in answer["schedule"]:
        state = checker.carried(checker.carried(state, checker.dd, contact), checker.dn, free)
    return bool(changed) and all(state[row] == (row, 1) for row in changed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("checker")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    checker = load(options.checker)
    draw = random.Random(options.seed)
    proved = refused = 0
    while proved < options.count:
        cells = draw.choice([1, 2, 3, 4, 6, 9, 12, 30, 60])
        phases = [[draw.randint(1, 3 * cells), draw.randint(1, 6 * cells)]]
        call = [options.program, "find", *(str(s) for phase in phases for s in phase),
                "--cells", str(cells), "--format", "json",
                *draw.choice([[], ["--gap", "-1e-3"], ["--gap", "0", "--energy", "1"]])]
        answer = json.loads(subprocess.run(call, capture_output=True, check=False).stdout)
        words = " ".join(call[1:])
        if answer["status"] != "none":
            continue
        try:
            checker.check(answer)
        except checker.NoProof as why:
            sys.exit(f"{words}: {why}")
        proved += 1
        for _ in range(3):
            bad, what = spoilt(answer, draw)
            try:
                checker.check(bad)
            except checker.NoProof:
                refused += 1
                continue
            if not is_without_effect(checker, answer, bad):
                sys.exit(f"{words}: spoilt ({what}), and still taken for a proof")
    print(f"{proved} proofs hold, {refused} spoilt ones are refused")


if __name__ == "__main__":
    main()
