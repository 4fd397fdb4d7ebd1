#!/usr/bin/env python3
"""Motions with one contact under an exact harmonic are those of staircases on ever finer grids, no more, no fewer."""

import json

from campaign import FOUND, NONE, UNDECIDED, arguments, campaign

COARSE = 30   # cells; the period is whole on this grid, so on all finer ones
FINEST = 5    # doublings at most
CLOSE = 0.02  # impulses this near, or nearer than that of a contact that lasts a step, are one


def asked(draw):
    """Words of a bar and what drives it, and its period in steps of the coarse grid."""
    steps = draw.randint(*draw.choice([(54, 240), (84, 140)]))  # the second choice: about the first frequency
    damping = 10 ** draw.uniform(-3, -0.7)
    place = draw.choice(["tip", "base"])
    gap = draw.choices([1.0, -1.0, 0.0], [8, 1, 1])[0]
    size = 10 ** draw.uniform(-1.0, 0.3)
    words = ["--damping", repr(damping), "--force", place, "--amplitude", repr(1e-3 * size),
             "--gap", repr(1e-3 * gap), "--quiet", "--format", "json"]
    if gap > 0 and draw.random() < 0.2:
        words += ["--second-stop", repr(1e-3 * draw.uniform(1.0, 3.0))]
    return words, steps


def answer_of(case, words):
    outcome = case.run(words)
    if outcome.status not in (FOUND, NONE, UNDECIDED):
        return None
    return json.loads(outcome.out)


def staircase(case, words, steps, doublings):
    """Impulses on the grid of so many doublings, or None where the search is not complete."""
    ratio = 4 * COARSE / steps
    cells = str(COARSE << doublings)
    answer = answer_of(case, ["response", "--cells", cells, "--from", repr(ratio), "--to", repr(ratio), *words])
    if answer is None or not answer["frequencies"]:
        return None
    at = answer["frequencies"][0]
    # A contact of one step, on each grid, is an impulse, which no motion has.
    return sorted(motion["impulse"] for motion in at["motions"] if motion["schedule"][0][0] > 1)


def are_one(exact, found):
    if len(exact) != len(found):
        return False
    worst = CLOSE * max(exact + found, default=0.0)
    return all(abs(one - other) <= worst for one, other in zip(exact, found))


def judge(case):
    words, steps = asked(case.random)
    call = ["find", "--frequency", f"{4 * COARSE}/{steps}", *words]
    answer = answer_of(case, call)
    if answer is None:
        return "undecided"
    if answer["complete_from"] is None:
        case.fault(call, "not proved complete")
    exact = sorted(motion["contacts"][0]["impulse"] for motion in answer["motions"])
    seen = []
    for doublings in range(FINEST + 1):
        found = staircase(case, words, steps, doublings)
        seen.append(found)
        if found is not None and doublings > 1 and are_one(exact, found):
            return f"{len(exact)} motions"
    case.fault(call, f"impulses {exact}; on grids of {COARSE} to {COARSE << FINEST} cells {seen}")
    return "apart"


def main():
    given = arguments(__doc__, 300)
    campaign(given, "driven bars", judge, ["0 motions", "1 motions", "2 motions"])


if __name__ == "__main__":
    main()
