#!/usr/bin/env python3
"""What `find --scene` says of the set of all motions, and how it was decided.

    solution_set_test.py PROGRAM

The dimension is that of the closed form where there is one wall, that of exact polytopes where there are several
contacts or two stops (both proved, by other code); of stepped bars what rank and kernel leave at most, in fractions.
"""
import json
import random
import subprocess
import sys
from fractions import Fraction


def rank(rows):
    """Of rows of fractions."""
    rows, found = [row[:] for row in rows], 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((row for row in rows[found:] if row[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        rows.insert(found, pivot)
        for k in range(found + 1, len(rows)):
            factor = rows[k][column] / pivot[column]
            rows[k] = [x - factor * y for x, y in zip(rows[k], pivot)]
        found += 1
    return found


def step(right, left, closed, cells, ratio):
    """Waves of a clamped bar whose first cells have impedance 1 and whose others have `ratio`, a step later.

    `right` and `left` are velocities, in the order in which they arrive at the node ahead.
    """
    one, two = cells
    a, b = right[0], left[one]  # that meet at the joint
    joint = 2 * (a + ratio * b) / (1 + ratio)
    tip = right[one]
    new_right = right[1:one] + [-left[0]] + right[one + 1:] + [joint - b]
    new_left = left[1:one] + [joint - a] + left[one + 1:] + [-tip if closed else tip]
    assert len(new_right) == len(new_left) == one + two
    return new_right, new_left


def stepped(cells, ratio, contact, free):
    """dim ker(W - 1), and what the distance that is closed at the start leaves of it."""
    size = 2 * sum(cells)
    columns = []
    for k in range(size):
        waves = [Fraction(int(k == j)) for j in range(size)]
        right, left = waves[:size // 2], waves[size // 2:]
        for closed in [True] * contact + [False] * free:
            right, left = step(right, left, closed, cells, ratio)
        columns.append(right + left)
    change = [[columns[k][j] - (j == k) for k in range(size)] for j in range(size)]
    tip = [Fraction(-1)] * (size // 2) + [Fraction(1)] * (size // 2)  # strain is the difference of waves
    return size - rank(change), size - rank(change + [tip])


def main():
    program = sys.argv[1]

    def find(*words):
        done = subprocess.run([program, "find", *map(str, words), "--format", "json", "--quiet"], capture_output=True,
                              text=True, check=False)
        assert done.returncode in (0, 1, 3), (words, done.stderr)
        return json.loads(done.stdout)

    known = {"bar": 0, "bars": 0, "stepped": 0}
    rng = random.Random(18)
    for _ in range(60):
        cells = rng.randint(1, 7)
        phases = rng.choice([1, 1, 2])
        stops = rng.choice(["right", "both"])
        sides = ["", "L:"] if stops == "both" else [""]
        steps = [(rng.choice(sides), rng.randint(1, 2 * cells), rng.randint(1, 5 * cells)) for _ in range(phases)]
        if steps[0][0] or (rng.random() < 0.6 and phases == 1):  # one with many motions
            steps = [("", max(1, cells // 2), 3 * cells)]
        elif phases == 2 and rng.random() < 0.6:  # the same twice
            steps = [("", max(1, cells // 2), 3 * cells)] * 2
        one = find(*[word for side, c, f in steps for word in (f"{side}{c}", f)], "--cells", cells,
                   *(["--second-stop", "1.5e-3"] if stops == "both" else []))
        left = "stop=-1.5e-3 " if stops == "both" else ""
        scene = f"clamp {cells} {left}stop=1e-3"
        number = {"": 2, "L:": 1} if left else {"": 1}
        row = find("--scene", scene, *[word for side, c, f in steps for word in (f"{number[side]}:{c}", f"-:{f}")])
        assert row["status"] == one["status"], (scene, steps, row["status"], one["status"])
        said, truth = row["solution_set"], one["solution_set"]
        if row["status"] == "none":
            assert said == {"kind": "empty", "dimension": None}, (scene, steps, said)
        elif said is not None and truth is not None:
            assert said["dimension"] == truth["dimension"], (scene, steps, said, truth)
            known["bar" if phases == 1 else "bars"] += 1
        assert row["solver"]["name"] == "active-set" and row["solver"]["iterations"] >= 0, row["solver"]
        assert row["route"] == "active-set on the kernel formulation", row["route"]
    for _ in range(100):
        cells, ratio = (rng.randint(1, 4), rng.randint(1, 4)), rng.choice([1, 2, Fraction(1, 2)])
        contact, free = rng.randint(1, 5), rng.randint(1, 24)
        row = find("--scene", f"clamp {cells[0]} {cells[1]}:{float(ratio)} stop=1e-3", f"1:{contact}", f"-:{free}")
        kernel, left = stepped(cells, ratio, contact, free)
        assert row["kernel_dimension"] == kernel, (cells, ratio, contact, free, row["kernel_dimension"], kernel)
        if row["status"] == "found" and row["solution_set"]:
            assert row["solution_set"]["dimension"] <= left, (cells, ratio, contact, free, row["solution_set"], left)
            known["stepped"] += 1
    print(known)
    assert min(known.values()) > 2 and known["bar"] > 9, known


if __name__ == "__main__":
    main()
