#!/usr/bin/python3
"""Rows of the proved checker against those of our C++, on random schedules and networks.

Each question is one line for two programs: build/release/bin/rows-printer prints (30)-(32) of a schedule
from paper/equations.hpp, or pushes, openings and the state at the end from the law of
mechanics/network.hpp; `check-proved --rows` prints the same of the definitions in proofs/.

    rows_compared.py [--count N] [--seed S]
"""
import argparse
import pathlib
import random
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def random_schedule(rng):
    cells = rng.randint(1, 5)
    steps = []
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        steps += [rng.randint(1, 3 * cells), rng.randint(1, 6 * cells)]
    return ["paper", cells] + steps


def random_chain(rng):
    """One or more bars: rows of cells, dashpots, stops on either side, gaps."""
    rows = rng.randint(1, 4)
    words = ["chain", rows]
    for _ in range(rows):
        words += [rng.randint(1, 3), rng.randint(1, 5)]
    contacts = 0
    for k in range(rows + 1):
        inside = 0 < k < rows
        kind = rng.choice([1, 2, 3, 4, 4] if inside else [0, 0, 1, 2, 3])
        words.append(kind)
        words += [rng.randint(0, 3)] * (kind in (1, 2, 3)) + [rng.randint(0, 3) for _ in range(2 * (kind == 4))]
        words += [rng.randint(1, 4)] * (kind >= 2)
        contacts += kind >= 2
    steps = rng.randint(1, 12)
    return words + [steps] + [rng.randrange(2 ** contacts) for _ in range(steps)]


def answers(command, text):
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{command[0]}: {done.stderr}")
    return done.stdout.split(".\n")[:-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    lines = [" ".join(map(str, rng.choice([random_schedule, random_chain])(rng))) for _ in range(options.count)]
    text = "\n".join(lines) + "\n"
    ours = answers([str(ROOT / "build/release/bin/rows-printer")], text)
    proved = answers([str(ROOT / "build/proofs/check-proved"), "--rows"], text)
    if not len(ours) == len(proved) == len(lines):
        raise SystemExit("not as many answers as questions")
    faults, rows = 0, 0
    for line, one, other in zip(lines, ours, proved):
        rows += one.count("\n")
        if one != other or not one:
            faults += 1
            print(f"{line}\nC++:\n{one}proved:\n{other}")
    print(f"{len(lines)} schedules and networks, {rows} rows: {faults} differ")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
