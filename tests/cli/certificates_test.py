#!/usr/bin/env python3
"""Certificates the program prints prove absence to a checker that shares no code with it.

certificates_test.py PROGRAM CHECKER [--count N] [--seed S]

Random schedules: every "none" must come with a proof, and a proof spoilt in one number is refused.
The same with two stops or several phases, where no proof may fit a schedule that has motions.
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


def random_scene(draw):
    """Words for a schedule of one to three phases, on one stop or two."""
    cells = draw.choice([1, 2, 3, 4, 6, 9, 12, 30])
    two = draw.random() < 0.7
    words = []
    for _ in range(draw.choice([1, 2, 3] if two else [2, 3])):
        left = "L:" if two and draw.random() < 0.5 else ""
        words += [f"{left}{draw.randint(1, 3 * cells)}", str(draw.randint(1, 6 * cells))]
    if two and draw.random() < 0.3:  # a pair of mirrored phases
        words = [words[0].replace("L:", ""), words[1]]
        words += ["L:" + words[0], words[1]]
    words += ["--cells", str(cells), "--format", "json"]
    words += draw.choice([[], ["--gap", "-1e-3"], ["--gap", "0", "--energy", "1"]])
    if two:
        words += ["--second-stop", repr(draw.choice([1.001e-3, 2e-3, draw.uniform(1.01e-3, 4e-3),
                                                     4e-3 / 3]))]
    return words


def check_scenes(options, checker, draw):
    """Proofs over the rows of sums; how many hold, and how many are refused where motions exist."""
    proved = refused = 0
    found, proofs = [], []
    while proved < options.count or len(found) < 4:
        words = random_scene(draw)
        call = subprocess.run([options.program, "find", *words], capture_output=True, check=False)
        if call.returncode not in (0, 1):
            continue  # without a gap some schedules are refused
        answer = json.loads(call.stdout)
        if answer["status"] == "found":
            found.append(answer)
            continue
        try:
            checker.check(answer)
        except checker.NoProof as why:
            sys.exit(f"{' '.join(words)}: {why}")
        proved += 1
        proofs.append(answer["certificate"])
    for answer in found:
        for certificate in proofs:
            bad = {**answer, "status": "none", "certificate": certificate}
            try:
                sys.exit(f"{answer['schedule']} has motions: {checker.check(bad)}")
            except checker.NoProof:
                refused += 1
    return proved, refused


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
    print("scenes: {} proofs hold, {} of others are refused".format(
        *check_scenes(options, checker, draw)))


if __name__ == "__main__":
    main()
