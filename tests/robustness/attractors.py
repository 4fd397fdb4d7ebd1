#!/usr/bin/env python3
"""What `sweep` says a driven bar settles on is what `simulate` sees ten times as long, and `response` lists."""

import json
import math

from campaign import FOUND, arguments, campaign

PERIODS = 400
WILD_PERIODS = 100  # whose waves have very many pieces


def asked(draw, is_wild):
    """A bar, what moves it, and a frequency that its grid has: 4N/n.

    Wild ones have little damping and a frequency just above the first one, where many do not repeat themselves.
    """
    cells = draw.randint(20, 30 if is_wild else 60)
    low, high = (1.0, 1.06) if is_wild else (0.7, 1.5)
    steps = draw.randint(math.ceil(4 * cells / high), math.floor(4 * cells / low))
    place = draw.choice(["tip", "base"])
    size = draw.uniform(0.2, 1.0) if place == "tip" else draw.uniform(0.1, 0.6)
    damping = draw.uniform(0.01, 0.025) if is_wild else draw.uniform(0.02, 0.1)
    words = ["--cells", str(cells), "--damping", repr(damping), "--force", place,
             "--amplitude", repr(1e-3 * size), "--quiet", "--format", "json"]
    return cells, repr(4 * cells / steps), words


def answer_of(case, words):
    outcome = case.run(words)
    if outcome.status != FOUND:
        case.fault(words, f"status {outcome.status}: {outcome.err!r}")
        return None
    return json.loads(outcome.out)


def is_near(one, other, tolerance):
    return abs(one - other) <= tolerance * max(abs(one), abs(other), 1e-6)


def judge(case):
    is_wild = case.number % 2 == 1
    cells, frequency, words = asked(case.random, is_wild)
    periods = WILD_PERIODS if is_wild else PERIODS
    sweep = ["sweep", "--from", frequency, "--to", frequency, "--points", "1", "--up", "--periods", str(periods),
             *words]
    longer = ["simulate", "--rest", "--frequency", frequency, "--phase", repr(math.pi / 2),
              "--periods", str(10 * periods), *words]
    seen, run = answer_of(case, sweep), answer_of(case, longer)
    if seen is None or run is None:
        return "no answer"
    point = seen["points"][0]
    settled = run["settled"]
    if point["periods"] is None:
        # Said to go on without end, and not only to be on its way: then it does.
        if settled and point["why"].startswith("does not repeat"):
            case.fault(sweep, f"{point['why']}, followed longer {settled}")
        return "settled later" if settled else "does not repeat itself"
    if not settled or settled["periods"] != point["periods"]:
        case.fault(sweep, f"repeats after {point['periods']}, followed longer: {settled or run['why']}")
        return "settled"
    if not is_near(point["impulse"] * point["periods"], settled["impulse"], 0.01):
        case.fault(sweep, f"impulse {point['impulse']}, followed longer {settled}")
    if round(point["contacts"] * point["periods"]) != settled["contacts"]:
        case.fault(sweep, f"{point['contacts']} contacts, followed longer {settled}")
    if point["periods"] == 1 and point["contacts"] == 1:
        closer = answer_of(case, [*sweep, "--resolve", "1e-9"])  # may be several that are one within a step
        if closer["points"][0]["contacts"] != 1:
            return "several within a step"
        listed = answer_of(case, ["response", "--from", frequency, "--to", frequency, *words])
        impulses = [motion["impulse"] for at in listed["frequencies"] for motion in at["motions"]]
        if not any(is_near(point["impulse"], impulse, 4 / cells) for impulse in impulses):
            case.fault(sweep, f"impulse {point['impulse']}, response lists {impulses}")
        return "one contact"
    return "several contacts" if point["contacts"] else "no contact"


def main():
    given = arguments(__doc__, 100)
    campaign(given, "attractors", judge, ["one contact", "no contact", "does not repeat itself"])


if __name__ == "__main__":
    main()
