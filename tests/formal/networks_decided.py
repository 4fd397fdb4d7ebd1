#!/usr/bin/env python3
"""Do `find --scene` and z3 agree on which schedules of bars have motions?

    networks_decided.py PROGRAM [--count N] [--seed K]

Rows of random bars, with all kinds of contacts, dashpots, springs and forces, are marched in fractions by a law of
this file's own: unknown are the waves and the displacements of all nodes at the start. z3 decides in rationals.
"""
import argparse
import json
import random
import subprocess
from fractions import Fraction as F

import z3

GAP = F(1, 1000)


class Scene:
    """Words, and what they are in cells, steps, |G|/M and forces of Z_1 |G|/M per step."""

    def __init__(self, rng):
        self.rows, self.stubs, self.contacts = [], [], []  # (cells, Z, left), (Z, node), (kind, node, gap)
        self.clamped, self.dash, self.force, self.words = [False], [F(0)], [F(0)], []
        start = rng.choice(["clamp", "clamp", "spring", "stop", "free"])
        self.end(start, -1)
        for bar in range(rng.randint(1, 3)):
            if bar:
                self.add("gap", F(rng.choice(["0.001", "0.0005", "0.002", "-0.001", "0"])) if self.contacts else GAP)
                self.node()
            for part in range(rng.randint(1, 2)):
                if part:
                    self.middle(rng.choice(["", "dash", "force", "spring"]))
                cells, impedance = rng.randint(1, 3), rng.choice([1, 1, 2, F(1, 2)])
                self.words.append(f"{cells}:{float(impedance)}")
                self.rows.append((cells, F(impedance), len(self.clamped) - 1))
                self.node()
        self.end(rng.choice(["clamp", "free", "spring"]) if self.contacts else "stop", 1)
        self.cells = sum(row[0] for row in self.rows)
        self.stubs = [(k / self.cells / 2, node) for k, node in self.stubs]

    def node(self):
        """One more."""
        for entries, value in ((self.clamped, False), (self.dash, F(0)), (self.force, F(0))):
            entries.append(value)

    def add(self, kind, gap):
        """A contact at the last node."""
        self.contacts.append((kind, len(self.clamped) - 1, gap / GAP))
        self.words.append(f"{'gap' if kind == 'gap' else 'stop'}={float(-gap if kind == 'left' else gap)}")

    def middle(self, word):
        """What is at the last node."""
        node = len(self.clamped) - 1
        if word == "dash":
            self.dash[node] = F(1, 4)
            self.words.append("dash=0.25")
        elif word == "force":
            self.force[node] = F(-1, 8)
            self.words.append("force=-0.000125")
        elif word == "spring":
            self.stubs.append((F(3), node))
            self.words.append("spring=3")

    def end(self, word, side):
        """Of the whole row."""
        if word == "clamp":
            self.clamped[-1] = True
            self.words.append("clamp")
        elif word == "stop":
            self.add("right" if side > 0 else "left", GAP)
        else:
            self.middle(word)


def plus(one, other, factor=1):
    """Of forms {unknown: factor}; what is constant under None."""
    total = dict(one)
    for key, value in other.items():
        total[key] = total.get(key, 0) + factor * value
    return total


class March:
    """Waves, displacements and what is asked of them, as forms."""

    def __init__(self, scene, spans):
        self.scene, self.equal, self.least = scene, [], []
        self.right = [[{("r", k, i): F(1)} for i in range(row[0])] for k, row in enumerate(scene.rows)]
        self.left = [[{("l", k, i): F(1)} for i in range(row[0])] for k, row in enumerate(scene.rows)]
        self.springs = [{("w", k): F(1)} for k in range(len(scene.stubs))]
        self.places = [{} if clamped else {("u", k): F(1)} for k, clamped in enumerate(scene.clamped)]
        first = [*(form for lines in (self.right, self.left) for line in lines for form in line), *self.springs,
                 *self.places]
        for k, (_, _, node) in enumerate(scene.rows):
            form = plus(self.places[node + 1], self.places[node], -1)
            for one, other in zip(self.left[k], self.right[k]):
                form = plus(plus(form, one, -1), other)
            self.equal.append(form)
        self.equal += [plus(self.places[node], self.springs[k]) for k, (_, node) in enumerate(scene.stubs)]
        before = spans[-1][0]
        for closed, steps in spans:
            for j in closed - before:
                self.equal.append(self.distance(j))
            before = closed
            for _ in range(steps):
                self.step(closed)
                self.least += [self.distance(j) for j in range(len(scene.contacts)) if j not in closed]
        last = [*(form for lines in (self.right, self.left) for line in lines for form in line), *self.springs,
                *self.places]
        self.equal += [plus(one, other, -1) for one, other in zip(first, last)]

    def distance(self, number):
        """As a form."""
        kind, node, gap = self.scene.contacts[number]
        form = plus({None: gap * self.scene.cells}, self.places[node], 1 if kind == "left" else -1)
        return plus(form, self.places[node + 1]) if kind == "gap" else form

    def step(self, closed):
        """(N), cluster by cluster."""
        scene = self.scene
        pulls, sums = [{None: f} for f in scene.force], list(scene.dash)
        arrived = []
        for k, (_, impedance, node) in enumerate(scene.rows):
            arrived.append((self.right[k].pop(), self.left[k].pop(0)))
            for at, wave in ((node + 1, arrived[k][0]), (node, arrived[k][1])):
                pulls[at], sums[at] = plus(pulls[at], wave, 2 * impedance), sums[at] + impedance
        for k, (impedance, node) in enumerate(scene.stubs):
            pulls[node], sums[node] = plus(pulls[node], self.springs[k], 2 * impedance), sums[node] + impedance
        joined = {scene.contacts[j][1]: j for j in closed if scene.contacts[j][0] == "gap"}
        stops = {scene.contacts[j][1]: j for j in closed if scene.contacts[j][0] != "gap"}
        speeds, first = [], 0
        for node in range(len(sums)):
            if node in joined:
                continue
            nodes = range(first, node + 1)
            held = [at for at in nodes if scene.clamped[at] or at in stops]
            speed = {}
            if not held:
                for at in nodes:
                    speed = plus(speed, pulls[at], 1 / sum(sums[first:node + 1]))
            speeds += [speed] * len(nodes)
            self.press(nodes, held, [plus(pulls[at], speed, -sums[at]) for at in nodes], joined, stops)
            first = node + 1
        for k, (_, _, node) in enumerate(scene.rows):
            self.right[k].insert(0, plus(speeds[node], arrived[k][1], -1))
            self.left[k].append(plus(speeds[node + 1], arrived[k][0], -1))
        for k, (_, node) in enumerate(scene.stubs):
            self.springs[k] = plus(self.springs[k], speeds[node], -1)
        self.places = [plus(place, speed) for place, speed in zip(self.places, speeds)]

    def press(self, nodes, held, rest, joined, stops):
        """What is left at each node goes on to the one that is held."""
        turn = held[0] if held else nodes[-1]
        total = dict(rest[turn - nodes[0]])
        for side in (range(nodes[0], turn), range(nodes[-1], turn, -1)):
            passed = {}
            for node in side:
                passed = plus(passed, rest[node - nodes[0]])
                self.least.append(passed if side.step > 0 else {k: -v for k, v in passed.items()})
            total = plus(total, passed)
        if turn in stops:
            sign = 1 if self.scene.contacts[stops[turn]][0] == "right" else -1
            self.least.append({k: sign * v for k, v in total.items()})

    def has_motion(self):
        """By z3; None if it does not say."""
        names, solver = {}, z3.SolverFor("QF_LRA")
        solver.set("timeout", 20000)

        def term(form):
            parts = [z3.Q(v.numerator, v.denominator) * (1 if k is None else names.setdefault(k, z3.Real(str(k))))
                     for k, v in form.items() if v]
            return z3.Sum(parts) if parts else z3.RealVal(0)
        solver.add([term(form) == 0 for form in self.equal] + [term(form) >= 0 for form in self.least])
        found = solver.check()
        return None if found == z3.unknown else found == z3.sat


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=20261125)
    given = parser.parse_args()
    rng, said = random.Random(given.seed), {"found": 0, "none": 0, "undecided": 0, "refused": 0, "unsolved": 0}
    for _ in range(given.count):
        scene, spans = Scene(rng), []
        numbers = range(len(scene.contacts))
        for _ in range(rng.randint(1, 2)):
            spans.append((frozenset(rng.sample(numbers, rng.randint(1, min(2, len(numbers))))), rng.randint(1, 6)))
            spans.append((frozenset(), rng.randint(1, 12)))
        words = [given.program, "find", "--quiet", "--format", "json", "--scene", " ".join(scene.words)] + [
            f"{'+'.join(str(j + 1) for j in sorted(closed)) or '-'}:{steps}" for closed, steps in spans]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode == 2:
            said["refused"] += 1
            continue
        status = json.loads(done.stdout)["status"]
        said[status] += 1
        has_motion = March(scene, spans).has_motion()
        if has_motion is None or status == "undecided":
            said["unsolved"] += 1
            continue
        assert (status == "found") == has_motion, (words, status, has_motion)
    print(said)
    assert min(said["found"], said["none"]) >= given.count // 20
    assert said["undecided"] + said["unsolved"] <= 1 + given.count // 100


if __name__ == "__main__":
    main()
