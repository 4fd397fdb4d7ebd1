#!/usr/bin/env python3
"""Random questions over all scenes, each answer judged by code that shares nothing with ours.

A motion is marched over its period, in every step, by the few lines below, and its energy is
added up; what an answer proves is checked by tools/check-certificate and tools/check-forced.
Of a forced bar the range of
amplitudes, or that it is empty, is found again from the response of the bar that is held and let go
as the schedule says: all conditions are linear in the cosine and the sine of the excitation.
"""

import collections
import json
import math

from campaign import FOUND, NONE, UNDECIDED, WRONG_USE, arguments, campaign
from checkers import certificate, forced
from checkers.reading import NoProof

GAP = 1e-3
TOLERANCE = 1e-8  # of the largest wave, the gap and the way the tip goes

Segment = collections.namedtuple("Segment", "cells impedance dashpot")
Force = collections.namedtuple("Force", "place ratio amplitude phase cycles")


class March:
    """A bar of length 1, wave speed 1 and EA = 1 in its first segment, cell by cell."""

    def __init__(self, answer, waves, force=None):
        segments = [Segment(s["cells"], s["impedance"], s["dashpot"]) for s in answer["segments"]]
        segments = segments or [Segment(answer["cells"], 1.0, 0.0)]
        self.impedance = [s.impedance / segments[0].impedance
                          for s in segments for _ in range(s.cells)]
        self.dashpot = [d for s in segments for d in [0.0] * (s.cells - 1) + [s.dashpot]]
        self.right, self.left = [list(column) for column in zip(*waves)]
        self.cells = answer["cells"]
        self.places = {stop["side"]: stop["place"] for stop in answer["stops"]}
        self.phases = [(*phase[:2], (phase[2:] or ["right"])[0]) for phase in answer["schedule"]]
        self.force = force
        self.steps = sum(contact + free for contact, free, _ in self.phases)
        self.size = max(GAP, *map(abs, self.right + self.left))
        self.largest, self.lowest = 0.0, self.tip()  # wave that arrives at the tip; its place

    def angle(self, m):
        return 2 * math.pi * self.force.cycles * m / self.steps - self.force.phase

    def push(self, m):
        """Of the excitation on the tip in step m."""
        if self.force is None or self.force.place != "tip":
            return 0.0
        return self.force.amplitude * math.cos(self.angle(m + 0.5))

    def base(self, m):
        """Displacement of the base before step m."""
        if self.force is None or self.force.place != "base":
            return 0.0
        return self.force.amplitude * math.cos(self.angle(m))

    def tip(self, m=0):
        strains = sum(b - a for a, b in zip(self.right, self.left))
        return self.base(m) + strains / self.cells

    def energy(self):
        """In EA g^2/2L, without an excitation."""
        whole = sum(z * (a * a + b * b)
                    for z, a, b in zip(self.impedance, self.right, self.left)) / self.cells
        return whole / (0.5 * GAP * GAP)

    def step(self, m, is_held):
        """One step: the force of the wall, or the speed of the tip."""
        loss = math.exp(-math.pi * self.force.ratio) if self.force else 1.0
        dashpot = (1 - loss) / (1 + loss)
        z, a, b = self.impedance, self.right, self.left
        wave, push = a[-1], self.push(m)
        self.largest = max(self.largest, wave)
        if is_held:
            back, seen = -wave, push + 2 * wave * z[-1]
        else:
            # dashpot v = push + Z (wave - back), v = wave + back
            seen = (2 * z[-1] * wave + push) / (z[-1] + dashpot * z[0])
            back = seen - wave
        met = [(2 * z[i] * a[i] + 2 * z[i + 1] * b[i + 1]) / (z[i] + z[i + 1] + self.dashpot[i])
               for i in range(self.cells - 1)]
        speed = (self.base(m + 1) - self.base(m)) * self.cells
        self.right = [speed - b[0]] + [v - b[i + 1] for i, v in enumerate(met)]
        self.left = [v - a[i] for i, v in enumerate(met)] + [back]
        return seen

    def faults(self):
        """What a period breaks."""
        start = self.right + self.left
        allowed = TOLERANCE * self.size * max(1.0, self.steps / self.cells)
        tip, m = self.tip(), 0
        for contact, free, side in self.phases:
            if abs(tip - self.places[side]) > allowed:
                yield f"contact begins at step {m} with the tip at {tip}"
            tip = self.places[side]
            for _ in range(contact):
                pressure = self.step(m, True) * (1 if side == "right" else -1)
                if pressure < -allowed * max(1.0, *self.impedance):
                    yield f"the wall pulls in step {m}: {pressure}"
                m += 1
            for _ in range(free):
                tip += self.step(m, False) / self.cells
                m += 1
                self.lowest = min(self.lowest, tip)
                if tip > self.places["right"] + allowed:
                    yield f"the tip is inside the wall after step {m}: {tip}"
                if tip < self.places.get("left", -math.inf) - allowed:
                    yield f"the tip is inside the second stop after step {m}: {tip}"
        off = max(abs(x - y) for x, y in zip(start, self.right + self.left))
        if off > allowed:
            yield f"after a period the state is another: {off}"


class Held:
    """What a schedule leaves of (C, S), the excitation C cos + S sin, where u(L, 0) = g."""

    PERIODS = 4000  # at most; where nothing fades there is no verdict

    def __init__(self, answer):
        self.isKnown = True
        columns = [self.response(answer, phase) for phase in (0.0, math.pi / 2)]
        rows = list(zip(*columns)) if self.isKnown else []
        self.low, self.high = -math.inf, math.inf
        if not self.isKnown:
            return
        (_, _, gap, _, c), (*_, s) = rows[0]
        self.norm = math.hypot(c, s)
        self.isKnown = self.norm > 1e-9
        if not self.isKnown:
            return
        self.foot = (gap * c / self.norm ** 2, gap * s / self.norm ** 2)
        way = (-s / self.norm, c / self.norm)
        for (_, _, bound, sort, c), (*_, s) in rows[1:]:
            # c C + s S <= bound, or = bound
            here = c * self.foot[0] + s * self.foot[1]
            slope = c * way[0] + s * way[1]
            size = math.hypot(c, s)
            self.cut(bound - here, slope, size)
            if sort == "=":
                self.cut(here - bound, -slope, size)

    def response(self, answer, phase):
        """Rows (phase, step, bound, sort, coefficient) of an excitation of amplitude 1."""
        force = Force(answer["force"], answer["damping"]["ratio"], 1.0, phase, answer["cycles"])
        march = March(answer, [(0.0, 0.0)] * answer["cells"], force)
        for _ in range(self.PERIODS):
            before, m, rows = march.right + march.left, 0, []
            for contact, free, side in march.phases:
                rows.append((side, m, march.places[side], "=", march.tip(m)))
                for _ in range(contact):
                    rows.append((side, m, 0.0, "<", -march.step(m, True)))
                    m += 1
                for _ in range(free):
                    march.step(m, False)
                    m += 1
                    rows.append((side, m, march.places["right"], "<", march.tip(m)))
            size = max(map(abs, before))
            if max(abs(x - y) for x, y in zip(before, march.right + march.left)) <= 1e-13 * size:
                return rows
        self.isKnown = False
        return []

    def cut(self, room, slope, size):
        """slope t <= room, of a row of this size: all of it, or nothing, where it is parallel."""
        if abs(slope) <= 1e-9 * size:
            if room < -1e-9 * (GAP + size * math.hypot(*self.foot)):
                self.high = -math.inf
        elif slope > 0:
            self.high = min(self.high, room / slope)
        else:
            self.low = max(self.low, room / slope)

    def amplitudes(self):
        """Least and most."""
        ends = [math.hypot(*self.foot, t) for t in (self.low, self.high)]
        nearest = min(max(0.0, self.low), self.high)
        return math.hypot(*self.foot, nearest), max(ends)

    def judge(self, answer):
        """A fault, or None."""
        size = max(GAP, *(abs(t) for t in (self.low, self.high) if math.isfinite(t)), GAP)
        room = self.high - self.low
        told = answer["amplitude_range"]
        if answer["status"] == "found" or told is not None:
            if room < -1e-7 * size:
                return f"there is none: t in {self.low} ... {self.high}"
            mine = self.amplitudes()
            for x, y in zip(mine, told):
                if y is not None and abs(x - y) > 1e-6 * max(size, abs(y)):
                    return f"amplitudes {mine}, not {told}"
        elif room > 1e-7 * size:
            return f"there are motions: t in {self.low} ... {self.high}"
        return None


def question(draw):
    """Words for a question about a random schedule in a random scene."""
    scene = draw.choice(["gap"] * 3 + ["pressed", "touching", "stops", "stops", "stepped",
                                       "stepped", "forced", "forced"])
    cells = draw.choice([1, 2, 3, 4, 5, 6, 8, 9, 12, 15, 20, 30])
    words = []
    if scene == "stepped":
        parts = [(draw.randint(1, 5), draw.choice([1, 1.3, 0.2, 7, 1e-3, 1e3]))
                 for _ in range(draw.choice([2, 2, 3]))]
        cells = sum(part for part, _ in parts)
        words += ["--segments", ",".join(f"{part}:{impedance}" for part, impedance in parts)]
    else:
        words += ["--cells", str(cells)]
    words += {"pressed": ["--gap", "-1e-3"], "touching": ["--gap", "0", "--energy", "1e-6"],
              "stops": ["--second-stop",
                        repr(draw.choice([1.2e-3, 2e-3, draw.uniform(1.01e-3, 4e-3)]))],
              }.get(scene, [])
    if scene == "forced":
        cells = min(cells, 8)
        words[1] = str(cells)
        words += ["--damping", draw.choice(["0.02", "0.1", "0.3"]), "--force",
                  draw.choice(["tip", "base"])]
        if draw.random() < 0.5:
            words += ["--amplitude", repr(draw.uniform(1e-5, 1e-3))]
        if draw.random() < 0.2:
            words += ["--cycles", "2"]
    elif scene == "gap" and draw.random() < 0.4:
        words += ["--energy-ratio", repr(draw.choice([1, 4, 9, draw.uniform(0.5, 40)]))]
    if scene in ("gap", "pressed", "stops") and draw.random() < 0.25:
        words += draw.choice([["--strain-limit", draw.choice(["1e-3", "1.9e-3", "2.5e-3", "4e-3"])],
                              ["--tip-floor", draw.choice(["-1.1e-3", "-1e-4", "-9e-4", "-3e-3"])]])
    # Near T = 4 - t_c, where motions are, or anywhere.
    contact = draw.randint(1, max(1, cells))
    free = 4 * cells - contact - draw.randint(0, cells) if draw.random() < 0.5 else \
        draw.randint(1, 6 * cells)
    schedule = [str(contact), str(max(1, free))]
    if scene == "stops" or draw.random() < 0.2:
        side = "L:" if scene == "stops" else ""
        again = (contact, max(1, free // 2)) if draw.random() < 0.5 else \
            (draw.randint(1, cells), draw.randint(1, 4 * cells))
        schedule = [str(contact), str(again[1] if again[0] == contact else max(1, free)),
                    side + str(again[0]), str(again[1])]
    return ["find", *schedule, *words]


def waves_of(path):
    rows = [line.split(",") for line in path.read_text().split()]
    columns = rows[0].index("a"), rows[0].index("b")
    return [tuple(float(row[column]) for column in columns) for row in rows[1:]]


def judge_motion(case, words, answer, has_proof):
    """The motion in the state file, marched; its energy added up."""
    force = None
    if "force" in answer:
        last = answer["motions"][-1]
        force = Force(answer["force"], answer["damping"]["ratio"], last["amplitude"],
                      last["phase"], answer["cycles"])
    march = March(answer, waves_of(case.folder / "state.csv"), force)
    energy = march.energy()
    for fault in march.faults():
        case.fault(words, fault)
    limits = dict(zip(words, words[1:]))
    if 2 * march.largest > float(limits.get("--strain-limit", "inf")) * (1 + 1e-7 + TOLERANCE) or \
            march.lowest < float(limits.get("--tip-floor", "-inf")) - GAP * (1e-7 + TOLERANCE):
        case.fault(words, f"beyond a limit: waves to {march.largest}, the tip to {march.lowest}")
    told = answer.get("energy_ratio")
    if told is not None and abs(energy - told) > TOLERANCE * max(1.0, energy):
        case.fault(words, f"energy_ratio {told}, but the state has {energy}")
    return f"found{', energies or amplitudes confirmed' if has_proof else ''}"


def judge(case):
    """One question."""
    words = question(case.random)
    outcome = case.run([*words, "--format", "json", "--quiet", "--state", "state.csv",
                        "--certificate", "proof.json"])
    if outcome.status == WRONG_USE:
        return "refused"
    if outcome.status not in (FOUND, NONE, UNDECIDED):
        return "broken"
    answer = json.loads(outcome.out)
    proof = case.folder / "proof.json"
    proved = json.loads(proof.read_text()) if proof.exists() else answer
    proves = proved["certificate"] is not None
    if proves:
        try:
            (forced if "force" in answer else certificate).check(proved)
        except NoProof as why:
            case.fault(words, f"no proof: {why}")
    if "force" in answer and answer["solution_set"]["free_waves"] == 0:
        held = Held(answer)
        if held.isKnown and (wrong := held.judge(answer)):
            case.fault(words, wrong)
        proves = proves or held.isKnown
    if outcome.status == FOUND:
        return judge_motion(case, words, answer, proves)
    if outcome.status == UNDECIDED:
        return "undecided"
    return "none, confirmed" if proves else "none, without a proof for this checker"


def main():
    given = arguments(__doc__.split("\n")[0], 100_000)
    campaign(given, "verdicts", judge, ["found", "none, confirmed"])


main()
