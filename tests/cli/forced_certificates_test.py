#!/usr/bin/env python3
"""Proofs that there are no forced motions are shown by a checker that shares no code with the program.

forced_certificates_test.py PROGRAM [--count N] [--seed S]

Random schedules of one to three contacts, on one stop and on two, damped or not, under a force on the tip
or a moving base: the checker has to show every "none". What is not so it must not show, whatever the
proof: an amplitude that motions have, a schedule that has motions. Those have to meet every row that the
checker writes down.
"""
import argparse
import copy
import json
import math
import random
import subprocess
import sys
from collections import Counter

from certificates_test import refuse, require_proof
from checkers import forced, forced_rows
from checkers.reading import NoProof

RULES = ("pressure", "held", "penetration", "second-stop", "closure", "work", "strain")


def random_phases(draw, cells):
    """Steps on one stop or two, and whether there are two."""
    if draw.random() < 0.06:  # most waves are always held
        free = draw.randint(1, min(3, 2 * cells - 1))
        return [str(2 * cells * draw.randint(1, 3) - free), str(free)], False
    has_two = draw.random() < 0.35
    words = []
    for _ in range(draw.choice([1, 1, 1, 1, 2, 2, 3])):
        left = "L:" if has_two and draw.random() < 0.5 else ""
        words += [f"{left}{draw.randint(1, 3 * cells)}", str(draw.randint(1, 6 * cells))]
    if has_two and draw.random() < 0.3:  # a pair of mirrored phases
        words = [words[0].replace("L:", ""), words[1]]
        words += ["L:" + words[0], words[1]]
    return words, has_two


def random_question(draw):
    """Words about any schedule."""
    cells = draw.choice([1, 2, 3, 4, 5, 6, 8, 10, 12])
    words, has_two = random_phases(draw, cells)
    steps = sum(int(word.rsplit(":", 1)[-1]) for word in words)
    place, gap = draw.choice(["tip", "base"]), draw.choice(["1e-3", "1e-3", "1e-3", "-1e-3", "0"])
    words += ["--cells", str(cells), "--force", place, "--gap", gap,
              "--damping", draw.choice(["0", "0", "1e-6", "0.001", "0.02", "0.1", "0.5", "3"]),
              "--cycles", str(draw.randint(1, max(1, min(3, (steps - 1) // 2))))]
    if has_two:
        words += ["--second-stop", draw.choice(["2e-3", "1.001e-3", "1.7e-3", "3e-3"])]
    if gap == "0" or draw.random() < 0.4:
        words += ["--amplitude", repr(draw.choice([1, 3]) * 10 ** draw.uniform(-5, -2))]
    if draw.random() < 0.15:
        words += ["--strain-limit", draw.choice(["1e-3", "3e-3"])]
    return words + random_bar(draw)


def random_segments(draw):
    """Words about a bar of several segments, damped or not."""
    parts = [draw.randint(1, 4) for _ in range(draw.randint(2, 3))]
    impedances = [10 ** draw.uniform(-1, 1) for _ in parts]
    if draw.random() < 0.3:  # that differ in speed alone
        impedances = [1] * len(parts)
    words = [f"{count}:{impedance:.3g}:{draw.choice([1, 1, 2])}" for count, impedance in zip(parts, impedances)]
    cells, phases = sum(parts), []
    has_two = draw.random() < 0.3
    for _ in range(draw.choice([1, 1, 2])):
        left = "L:" if has_two and draw.random() < 0.5 else ""
        phases += [f"{left}{draw.randint(1, 2 * cells)}", str(draw.randint(1, 5 * cells))]
    gap = draw.choice(["1e-3", "1e-3", "-1e-3", "0"])
    words = [*phases, "--segments", ",".join(words), "--force", draw.choice(["tip", "base"]), "--gap", gap,
             "--damping", draw.choice(["0", "0.02", "0.1", "0.5"])]
    words += ["--second-stop", draw.choice(["2e-3", "3e-3"])] if has_two else []
    words += ["--strain-limit", repr(10 ** draw.uniform(-4, -2))] if draw.random() < 0.3 else []
    if gap == "0" or draw.random() < 0.4:
        words += ["--amplitude", repr(draw.choice([1, 3]) * 10 ** draw.uniform(-5, -2))]
    return words + random_bar(draw)


def random_bar(draw):
    """Words about units, mostly none."""
    return draw.choice([[], [], ["--length", "2.5", "--axial-stiffness", "3e4", "--wave-speed", "5e3"]])


def likely_question(draw):
    """Words about a schedule that may well have motions."""
    cells = draw.choice([3, 4, 6, 10])
    words = [str(draw.randint(1, cells)), str(draw.randint(2 * cells, 5 * cells))]
    words += ["--cells", str(cells), "--force", draw.choice(["tip", "base"]),
              "--damping", draw.choice(["0.02", "0.1", "0.3"]), "--gap", draw.choice(["1e-3", "-1e-3"])]
    scene = draw.randrange(5)
    if scene == 0:  # gone through twice
        words += ["--cycles", "2"]
    elif scene == 1:
        words += ["--second-stop", draw.choice(["2e-3", "3e-3"])]
    elif scene == 2:
        words = words[:2] + ["L:" + words[0], words[1]] + words[2:-1] + ["1e-3", "--second-stop", "1e-3"]
    elif scene == 3:  # motions of any size, and the bar at rest
        words = words[:-1] + ["0", "--amplitude", "0.01"]
    return words + random_bar(draw)


def inner_amplitudes(answer):
    """Such as motions have, away from the ends, which are rounded."""
    least, most = answer["amplitude_range"]
    most = 10 * least + 1e-3 if most is None else most
    if not most - least > 1e-9 * most:
        return []
    return [least + part * (most - least) for part in (0.001, 0.5, 0.999)]


class Answers:
    """Asks the program, and holds what it says against the checker."""

    def __init__(self, options):
        self.program = options.program
        self.draw = random.Random(options.seed)
        self.counts = Counter()
        self.conflicts = []  # conditions that proved something
        self.cuts = []  # multipliers that did

    def ask(self, words):
        """An answer; None of a question that is refused."""
        call = subprocess.run([self.program, "find", *words, "--format", "json", "--quiet"],
                              capture_output=True, check=False)
        return json.loads(call.stdout) if call.stdout else None

    def look_at_segments(self, words):
        """A bar of several segments: "none" is proved, a multiplier changed or another amplitude is not."""
        answer = self.ask(words)
        if answer is None:
            return
        self.counts[f"segments: {answer['status']}"] += 1
        if answer["status"] == "found":
            for amplitude in inner_amplitudes(answer)[:1]:
                self.segments_without(dict(answer, amplitude=amplitude), words)
            return
        if answer["status"] != "none" or "cuts" not in answer["certificate"]:  # equal segments are one bar
            return
        said = " ".join(words)
        require_proof(forced.check, answer, said)
        self.cuts.append(answer["certificate"]["cuts"])
        for change in range(3):
            bad = copy.deepcopy(answer)
            cut = self.draw.choice(bad["certificate"]["cuts"])
            listed = cut["places"] + cut["pushes"]
            if change == 0:
                cut["periodicity"][self.draw.randrange(len(cut["periodicity"]))] += 1e-2
            elif change == 1:
                bad["certificate"]["cuts"] = []
            elif listed:
                listed[0][2] = -listed[0][2]
            self.counts["segments: changed"] += 1
            try:
                forced.check(bad)
            except NoProof:
                self.counts["segments: refused"] += 1
        if answer["certificate"]["kind"] == "amplitude-range":
            found = self.ask([word for k, word in enumerate(words)
                              if "--amplitude" not in words[max(k - 1, 0):k + 1]])
            for amplitude in inner_amplitudes(found) if found and found["status"] == "found" else []:
                refuse(forced.check, dict(answer, amplitude=amplitude), f"{said}: has {amplitude}")
                self.counts["segments: wrong amplitude"] += 1

    def segments_without(self, answer, words):
        """A schedule that has motions of this amplitude: no multipliers prove the contrary."""
        waves = 2 * answer["cells"]
        for cuts in [[dict(c) for c in cuts] for cuts in self.cuts if len(cuts[0]["periodicity"]) == waves][:5]:
            for kind in ("forced", "amplitude-range"):
                bad = dict(answer, status="none", phase=None, motions=[],
                           certificate={"kind": kind, "rows": "network", "cuts": cuts})
                refuse(forced.check, bad, " ".join(words))
                self.counts["segments: has motions"] += 1

    def look(self, words):
        """One answer, whatever it is."""
        answer = self.ask(words)
        if answer is None:
            return
        if answer["force"] == "base" and answer["strain_limit"] is not None:  # by the waves of a network
            self.counts["limits beside a moving base"] += 1
            self.look_at_segments(words)
            return
        if answer["status"] == "none":
            self.confirm(answer, words)
        elif answer["status"] == "found":
            self.deny(answer, words)
        self.counts[answer["status"]] += 1

    def confirm(self, answer, words):
        """A proof has to hold; spoilt ones must not, unless other conditions prove the same."""
        said = " ".join(words)
        require_proof(forced.check, answer, said)
        certificate = answer["certificate"]
        conditions = certificate["conditions"]
        self.conflicts.append(conditions)
        self.counts["proved"] += 1
        for what in [certificate["kind"], answer["force"], f"{len(answer['schedule'])} phases",
                     f"{len(answer['stops'])} stops", f"gap {answer['bar']['gap']}",
                     "more cycles" if answer["cycles"] > 1 else "one cycle",
                     "damped" if answer["damping"]["ratio"] else "undamped",
                     *{condition["rule"] for condition in conditions}]:
            self.counts[f"proved: {what}"] += 1
        for bad in self.spoilt(answer):
            refuse(forced.check, bad, f"{said}: {bad['certificate']}")
            self.counts["spoilt"] += 1
        for bad in self.changed(answer):
            self.counts["changed"] += 1
            try:
                forced.check(bad)
            except NoProof:
                self.counts["changed: refused"] += 1

    def spoilt(self, answer):
        """What no conditions can prove, and conditions that are none."""
        steps = sum(phase[0] + phase[1] for phase in answer["schedule"])
        takeoff = answer["schedule"][0][0]
        for condition in ({"rule": "pressure", "step": takeoff}, {"rule": "penetration", "step": 0},
                          {"rule": "strain", "step": steps}, {"rule": "gap", "step": 0}):
            bad = copy.deepcopy(answer)
            bad["certificate"]["conditions"].append(condition)
            yield bad
        if answer["certificate"]["conditions"]:  # else u(L, 0) is 0 whatever drives the bar
            bad = copy.deepcopy(answer)
            bad["certificate"]["kind"] = "forced"
            bad["certificate"]["conditions"] = []
            yield bad
        yield dict(answer, status="found")
        if answer["force"] == "base":  # whose speed adds to the strain
            bad = copy.deepcopy(dict(answer, strain_limit=1e-9))
            bad["certificate"]["conditions"].append({"rule": "strain", "step": 0})
            yield bad
        if answer["certificate"]["kind"] == "amplitude-range":
            for amplitude in (None, 0, -1):
                yield dict(answer, amplitude=amplitude)
            for amplitude in inner_amplitudes(answer):
                self.counts["wrong amplitude"] += 1
                yield dict(answer, amplitude=amplitude)

    def changed(self, answer):
        """Another step, another rule, a condition less."""
        steps = sum(phase[0] + phase[1] for phase in answer["schedule"])
        for change in range(3):
            bad = copy.deepcopy(answer)
            conditions = bad["certificate"]["conditions"]
            if not conditions:
                return
            place = self.draw.randrange(len(conditions))
            if change == 0:
                del conditions[place]
            elif change == 1:
                conditions[place]["step"] = self.draw.randrange(steps)
            else:
                conditions[place]["rule"] = self.draw.choice(RULES)
            yield bad

    def deny(self, answer, words):
        """A schedule that has motions: no conditions must prove the contrary, at no amplitude it has."""
        said = " ".join(words)
        waves = forced_rows.Waves(forced_rows.Question(dict(answer, phase=None, motions=[])))
        self.meet(answer, waves, said)
        known = [{"rule": rule, "step": m} for rule in RULES for m in range(waves.steps)
                 if waves.RULES[rule](waves, m)]
        amplitudes = inner_amplitudes(answer)
        for trial in range(8):
            conditions = self.draw.sample(known, min(len(known), self.draw.randint(1, 3)))
            if trial % 2 and self.conflicts:  # what proved something of another schedule
                conditions = [c for c in self.draw.choice(self.conflicts) if c in known]
            if trial % 5 == 4:
                conditions = [{"rule": "rest", "step": 0}]
            kind = self.draw.choice(["forced", "amplitude-range"] if amplitudes else ["forced"])
            bad = dict(answer, status="none", phase=None, motions=[], amplitude=None,
                       certificate={"kind": kind, "conditions": conditions})
            if amplitudes:
                bad["amplitude"] = self.draw.choice(amplitudes)
            refuse(forced.check, bad, f"{said}: has motions, {bad['certificate']}")
            self.counts["has motions"] += 1

    def meet(self, answer, waves, said):
        """Motions meet all rows; those with waves of their own are not told apart by amplitude and phase."""
        unit = waves.question.force_unit if answer["force"] == "tip" else waves.question.reach
        rows = [waves.gap()] + [waves.RULES[rule](waves, m) for rule in RULES for m in range(waves.steps)]
        for motion in answer["motions"]:
            size = motion["amplitude"] / float(unit)
            place = [size * math.cos(motion["phase"]), size * math.sin(motion["phase"])]
            for row in rows:
                if row is None or row.is_free():
                    continue
                values = [float(x.middle().low) for x in (row.vector.c, row.vector.s, row.limit)]
                miss = values[0] * place[0] + values[1] * place[1] - values[2]
                most = 1e-7 * max(1, abs(values[0] * size), abs(values[1] * size))
                if miss < -most or (row.is_equality and miss > most):
                    sys.exit(f"{said}: a motion misses a row by {miss}")
                self.counts["rows met"] += 1

    def beyond(self, words):
        """Of a schedule with motions, amplitudes that none has, and a limit on strain."""
        answer = self.ask(words)
        if not answer or answer["status"] != "found":
            return
        self.deny(answer, words)
        if answer["bar"]["gap"] == 0:
            return
        # Less strain than the least motion has.
        strain = self.draw.uniform(0.6, 0.99) * answer["motions"][0]["physical"]["peak_compression"]
        self.look(words + ["--strain-limit", repr(strain)])
        least, most = answer["amplitude_range"]
        for amplitude in [0.7 * least] + ([1.3 * most] if most is not None else []):
            if amplitude > 0:
                self.look(words + ["--amplitude", repr(amplitude)])


# A force that repeats after 2N steps of flight, and leaves u(L, 0) at 0 whatever its amplitude: what
# rounding makes of that is no motion.
UNMOVED = ("2 10 --cells 2 --damping 1e-6 --cycles 3", "1 11 --cells 2 --damping 1e-6 --cycles 3",
           "2 22 --cells 4 --damping 1e-6 --cycles 3", "2 13 --cells 3 --damping 1e-5 --cycles 5",
           "1 7 --cells 2 --damping 1e-8 --cycles 2", "2 6 --cells 2 --damping 1e-10 --cycles 2",
           "2 6 --cells 2 --damping 1e-12 --cycles 2")


def check_unmoved(answers):
    """None is found, and the checker knows why."""
    for words in UNMOVED:
        answer = answers.ask(words.split() + ["--force", "tip"])
        if answer["status"] == "found":
            sys.exit(f"{words}: a motion of amplitude {answer['amplitude']}")
        certificate = {"kind": "forced", "conditions": []}
        require_proof(forced.check, dict(answer, status="none", certificate=certificate), words)


def require(counts, name, least):
    """Ends the run if there were fewer: then it has shown little."""
    if counts[name] < least:
        sys.exit(f"{name}: {counts[name]}, and at least {least} are wanted")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=450)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    answers = Answers(options)
    while answers.counts["proved"] < options.count:
        answers.look(random_question(answers.draw))
        if answers.draw.random() < 0.3:
            answers.beyond(likely_question(answers.draw))
    for _ in range(options.count // 3):
        answers.look_at_segments(random_segments(answers.draw))
    check_unmoved(answers)
    counts = answers.counts
    for name in sorted(counts):
        print(f"{counts[name]:6} {name}")
    part = options.count
    for name, least in [
            ("proved: forced", part / 2), ("proved: amplitude-range", part / 20), ("proved: tip", part / 4),
            ("proved: base", part / 4), ("proved: 2 phases", part / 10), ("proved: 3 phases", part / 25),
            ("proved: 2 stops", part / 10), ("proved: more cycles", part / 5), ("proved: undamped", part / 25),
            ("proved: gap 0.001", part / 4), ("proved: gap -0.001", part / 20), ("proved: gap 0.0", part / 20),
            *((f"proved: {rule}", 2) for rule in RULES), ("spoilt", 5 * part),
            ("wrong amplitude", part / 10), ("changed: refused", counts["changed"] / 2),
            ("has motions", part / 2), ("rows met", 5 * part), ("segments: none", part / 6),
            ("segments: refused", 0.8 * counts["segments: changed"])]:
        require(counts, name, least)
    print(f"{counts['proved']} proofs hold; {counts['spoilt']} spoilt ones and {counts['has motions']} about schedules "
          f"with motions are refused")


if __name__ == "__main__":
    main()
