#!/usr/bin/env python3
"""That no curve joins two motions is shown by a checker that shares no code with the program.

apart_test.py PROGRAM [--count N] [--patience S] [--seed K]

Pairs of motions of random schedules, of one phase and of several, on one stop and on two: on the way
from the middle of all motions to two corners, at one energy. Where the program says that no curve
joins them, the checker has to show it; where it says that one does, and for states that were spoilt, it has to refuse
whatever the answer claims.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
from collections import Counter

from certificates_test import existing
from checkers import apart
from checkers.energies import Energies
from checkers.reading import NoProof, simplest
from checkers.sums import Sums

GAP = 1e-3


class Scene:
    """The motions of a schedule, from words of the program."""

    def __init__(self, words):
        self.words = words
        count = next(k for k, word in enumerate(words) if word.startswith("--"))
        given = dict(zip(words[count::2], words[count + 1::2]))
        steps = [word.rsplit(":", 1) for word in words[:count]]
        stops = ["left" if word[0] == "L" else "right" for word in steps[::2]]
        phases = [[int(a[-1]), int(b[-1])] for a, b in zip(steps[::2], steps[1::2])]
        gap, second = float(given.get("--gap", GAP)), given.get("--second-stop")
        where = {"right": 1 if gap > 0 else -1}
        if second:
            where["left"] = -simplest(float(second) / abs(gap))
        self.cells = int(given["--cells"])
        self.sums = Sums(self.cells, phases, stops, where)
        self.energies = Energies(self.sums)
        self.corners = self.energies.corners
        self.least = [float(sum(column) / len(self.corners)) for column in zip(*self.corners)]
        self.is_box = any(width > 1 and not may_press for width, may_press in
                          zip(self.sums.widths, self.sums.pressing))

    def equal(self):
        """All amplitudes of a run the same, sums in the middle of their corners."""
        return [sum_ / width for sum_, width in zip(self.least, self.sums.widths)
                for _ in range(width)]

    def corner(self, draw):
        """Each sum of one corner in one residue; of a box, jumps between its walls."""
        if self.is_box:
            total, = self.corners[0]
            walls = self.sums.bounds(self.corners[0], 0)
            ends = [0, *(draw.choice(walls) for _ in range(self.sums.widths[0] - 1)), total]
            return [float(b - a) for a, b in zip(ends, ends[1:])]
        z = []
        for sum_, width in zip(draw.choice(self.corners), self.sums.widths):
            run = [0.0] * width
            run[draw.randrange(width)] = float(sum_)
            z += run
        return z

    def lowered(self, z, energy):
        """The motion of this energy on the way from equal amplitudes to z; None if z has less."""
        middle, wanted = self.equal(), energy / float(self.energies.unit)
        way = [b - a for a, b in zip(middle, z)]
        aa, ab, bb = (sum(p * q for p, q in zip(v, w))
                      for v, w in ((middle, middle), (middle, way), (way, way)))
        if not aa <= wanted <= aa + 2 * ab + bb or bb == 0:
            return None
        part = (math.sqrt(ab * ab + bb * (wanted - aa)) - ab) / bb
        return [a + part * b for a, b in zip(middle, way)]

    def energy(self, z):
        return float(self.energies.unit) * sum(a * a for a in z)

    def write(self, z, path):
        """The state with these amplitudes."""
        waves, at, steps = [0.0] * (2 * self.cells), 0, len(self.sums.stop)
        for first, width in zip(self.sums.live, self.sums.widths):
            for u in range(2 * self.cells):
                residue = u % steps % self.sums.classes - first
                if 0 <= residue < width:
                    waves[u] = GAP * z[at + residue] * self.sums.signs[first][(u - residue) % steps]
            at += width
        cells = self.cells
        rows = [f"{(i + 0.5) / cells!r},{waves[cells - 1 - i]!r},{-waves[cells + i]!r}"
                for i in range(cells)]
        path.write_text("x,a,b\n" + "\n".join(rows) + "\n", encoding="utf-8")


def scaled(words, factor):
    """The same schedule on a grid so many times finer."""
    count = next(k for k, word in enumerate(words) if word.startswith("--"))
    steps = [(word[:2] if word[0] == "L" else "") + str(factor * int(word.rsplit(":", 1)[-1]))
             for word in words[:count]]
    rest = words[count:]
    place = rest.index("--cells") + 1
    return steps + rest[:place] + [str(factor * int(rest[place]))] + rest[place + 1:]


def random_scene(calls, draw):
    """A schedule with motions, on a grid on which many differ: one of four sorts."""
    sort = draw.randrange(4)
    while True:
        kind = draw.randrange(len(calls) + 1)
        if kind == len(calls):  # the paper's: a simplex of any size
            half = draw.randint(2, 20)
            words = [str(half), str(6 * half), "--cells", str(2 * half)]
        else:
            words = scaled(draw.choice(calls[kind]), draw.choice([1, 1, 2, 3, 5]))
        scene = Scene(words)
        if scene.energies.is_bounded and sum(scene.sums.widths) > 1 and \
                (not scene.is_box or len(scene.sums.widths) == 1) and \
                (True, len(scene.sums.widths) > 1, len(scene.corners) > 1,
                 scene.is_box and len(scene.sums.flights) == 1 and scene.sums.widths[0] < 7)[sort]:
            return scene


class Pairs:
    """Asks the program and the checker about pairs of motions."""

    def __init__(self, options, folder):
        self.program, self.patience = options.program, options.patience
        self.one, self.two = folder / "one.csv", folder / "two.csv"
        self.counts, self.why = Counter(), None

    def ask(self, scene, pair, energy):
        """What the program says of two motions of this energy."""
        for z, path in zip(pair, (self.one, self.two)):
            scene.write(z, path)
        words = [self.program, "continuum", *scene.words, "--energy-ratio", repr(energy), "--from",
                 str(self.one), "--to", str(self.two), "--format", "json", "--points", "3",
                 "--quiet"]
        try:
            call = subprocess.run(words, capture_output=True, check=False, timeout=self.patience)
        except subprocess.TimeoutExpired:  # a curve by programs; that there is none is said at once
            return {}, " ".join(words)
        if not call.stdout:
            sys.exit(f"{' '.join(words)}: {call.stderr.decode()}")
        return json.loads(call.stdout), " ".join(words)

    def verdict(self, answer, one, two):
        """What the checker shows if the answer says that they are apart, or None."""
        try:
            return apart.check(dict(answer, connected=False), one, two)
        except NoProof as why:
            self.why = why
            return None

    def compare(self, scene, pair, energy):
        """What program and checker say, which have to agree: the answer, or None of it."""
        answer, words = self.ask(scene, pair, energy)
        if not answer:
            self.counts["traced for long"] += 1
            return None
        shown = self.verdict(answer, self.one, self.two)
        if answer["connected"] is None:
            self.counts["not known to the program"] += 1
        elif bool(shown) == answer["connected"]:
            sys.exit(f"{words}: connected is {answer['connected']}, and the checker: {shown or self.why}")
        else:
            self.counts["shown" if shown else "refused"] += 1
        return answer

    def look(self, scene, pair, draw):
        """One pair of corners, each at an energy below both of theirs; or deep below it."""
        low = scene.energy(scene.equal())
        high = min(map(scene.energy, pair))
        energy = low + (high - low) * draw.choice([0.999, draw.random()])
        motions = [scene.lowered(z, energy) for z in pair]
        if None in motions or low >= high:
            return
        answer = self.compare(scene, motions, energy)
        if not answer or answer["connected"] is not False:
            return
        self.counts["of several sums"] += len(scene.sums.widths) > 1
        self.counts["of several corners"] += len(scene.corners) > 1
        self.counts["of boxes"] += scene.is_box
        self.spoil(energy, answer)
        below = low + (energy - low) * draw.choice([0.5, 0.1, 0.01])
        self.compare(scene, [scene.lowered(z, below) for z in pair], below)

    def spoil(self, energy, answer):
        """A state and itself, another energy, a state that is no motion."""
        text = self.two.read_text(encoding="utf-8")
        spoilt = [(answer, self.one, self.one), (answer, self.two, self.two),
                  (dict(answer, energy_ratio=energy * 1.001), self.one, self.two)]
        for case in spoilt:
            self.refuse(*case)
        place = text.index(",", text.index("\n")) + 1
        self.two.write_text(text[:place] + "1" + text[place:].lstrip("-"), encoding="utf-8")
        self.refuse(answer, self.one, self.two)
        self.two.write_text(text, encoding="utf-8")

    def refuse(self, answer, one, two):
        """It must not be shown."""
        if self.verdict(answer, one, two):
            sys.exit(f"{answer['schedule']}: {self.verdict(answer, one, two)}")
        self.counts["spoilt"] += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--patience", type=float, default=0.5, help="seconds for one answer")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    draw = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        calls = existing(options, folder)
        pairs = Pairs(options, folder)
        while pairs.counts["shown"] < options.count:
            scene = random_scene(calls, draw)
            pairs.look(scene, [scene.corner(draw) for _ in range(2)], draw)
    print("continua: {shown} pairs are apart, {of several sums} of several sums, {of several corners} of "
          "several corners, {of boxes} of boxes; {refused} that are not and {spoilt} spoilt ones are "
          "refused; left out are {not known to the program} that the program does not know, and "
          "{traced for long} whose curve takes long".format_map(pairs.counts))


if __name__ == "__main__":
    main()
