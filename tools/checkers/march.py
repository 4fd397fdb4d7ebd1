"""A state of a bar of several segments, marched through one period.

Waves are whole numbers of 2^-400 |g|; at a joint they are rounded down. A joint takes no energy from
outside, so in the norm sum Z x^2 what rounding adds to a state never grows: after n steps no wave is off by
more than n (2 J) sqrt(most Z/least Z) of these units, J joints. That is added to every fault that is found.
"""
import collections
import math
from fractions import Fraction

from .reading import NoProof, number, shown

NEAR = Fraction(1, 10 ** 7)  # of the largest wave or the gap: as the program marches
UNIT = 2 ** 400
MOST_WORK = 10 ** 6  # steps times segments
MOST_WEIGHT = 2 ** 200


def numbers(state, name, cells):
    """A list of N doubles."""
    values = state.get(name) if isinstance(state, dict) else None
    if not isinstance(values, list) or len(values) != cells:
        raise NoProof(f"state: {name}: no list of {cells} numbers")
    return [Fraction(number(value, f"state: {name}")) for value in values]


class March:
    """The waves a, to the right, and b, to the left, of all cells at t = 0, in |g|/L."""

    def __init__(self, scene, joints, impedances, state):
        if not isinstance(state, dict) or set(state) != {"a", "b"}:
            raise NoProof(f"state: {shown(state)} is not a and b")
        if scene.steps * len(scene.segments) > MOST_WORK:
            raise NoProof(f"state: this checker marches up to {MOST_WORK} steps times segments")
        self.scene, self.joints, self.impedances = scene, joints, impedances
        self.right, self.left = (numbers(state, name, scene.cells) for name in "ab")
        self.size = max(1, *map(abs, self.right + self.left))

    def energy(self):
        """E/E_1."""
        total, at = 0, 0
        for segment, impedance in zip(self.scene.segments, self.impedances):
            cells = slice(at, at + segment.cells)
            total += Fraction(impedance) * sum(x * x for x in self.right[cells] + self.left[cells])
            at += segment.cells
        return Fraction(2, self.scene.cells) * total

    def rounding(self):
        """That no wave is off by more than, in units; also after all places were added up."""
        most = least = Fraction(1)
        here = Fraction(1)
        for one, two, _ in self.joints:
            if not one or not two:
                raise NoProof("segments: an impedance is 0 beside its neighbour")
            here = here * two / one
            most, least = max(most, here), min(least, here)
        if most > MOST_WEIGHT * least:
            raise NoProof("segments: impedances differ by more than this checker marches")
        return (1 + math.isqrt(int(most / least) + 1)) * (2 * len(self.joints) * self.scene.steps + 1)

    def off(self, floor, limit):
        """By how much the waves miss a motion, in units of the largest; NoProof if that is more than NEAR."""
        worst = self.worst(floor, limit) / (UNIT * self.size)
        if worst > NEAR:
            raise NoProof(f"state: it misses a motion by {float(worst):.2g} of its largest wave")
        return float(worst)

    def worst(self, floor, limit):
        """The worst fault, in units."""
        scene, half = self.scene, Fraction(self.scene.cells, 2)
        lines = Lines(self)
        start = lines.waves()
        place = -sum(a - b for a, b in zip(self.right, self.left)) * UNIT / 2
        faults = [self.rounding() * (scene.steps + 1)]
        for (contact, free), side in zip(scene.phases, scene.stops):
            # Places times N/2: in a step of flight the tip moves by 2 p/N.
            faults.append(abs(place - half * scene.where[side] * UNIT) / half)
            place = half * scene.where[side] * UNIT
            sign = 1 if side == "right" else -1
            for _ in range(contact):
                faults.append(-sign * lines.step(-1))
            for _ in range(free):
                place += lines.step(1)
                faults.append((place - half * scene.where["right"] * UNIT) / half)
                for lowest in (scene.where.get("left"), floor):
                    if lowest is not None:
                        faults.append((half * lowest * UNIT - place) / half)
            faults = [max(faults)]
        faults.append(abs(place - half * scene.where[scene.stops[0]] * UNIT) / half)
        faults += [abs(x - y) for x, y in zip(start, lines.waves())]
        if limit is not None:
            faults.append(self.strained(lines.arrived, limit))
        return max(faults)

    def strained(self, arrived, limit):
        """By how much strain goes below -limit at most, in units: two waves of a segment of N cells meet if they
        arrive at its ends in steps that differ by no more than N, periods left out."""
        steps, most = self.scene.steps, []
        if any(steps * min(steps, 2 * s.cells + 1) > 10 * MOST_WORK for s in self.scene.segments):
            raise NoProof("state: too many waves meet for this checker")
        for k, segment in enumerate(self.scene.segments):
            right, left = [ends[k] for ends, _ in arrived], [begins[k] for _, begins in arrived]
            around = range(min(steps, 2 * segment.cells + 1))
            meets = (right[p] - left[(p + d - segment.cells) % steps] for p in range(steps) for d in around)
            most.append(max(meets) / self.scene.speed(k))
        return max(most) - limit * UNIT


class Lines:
    """The waves of each segment in the order in which they arrive at its ends."""

    def __init__(self, march):
        self.joints, self.arrived, at = march.joints, [], 0
        self.right, self.left = [], []
        for segment in march.scene.segments:
            cells = slice(at, at + segment.cells)
            self.right.append(collections.deque(math.floor(x * UNIT) for x in march.right[cells]))
            self.left.append(collections.deque(math.floor(x * UNIT) for x in march.left[cells]))
            at += segment.cells

    def waves(self):
        """All of them, by cells."""
        return [x for line in self.right for x in line] + [x for line in self.left for x in line]

    def step(self, echo):
        """One step, the tip sending back `echo` times what arrives; what arrived."""
        ends = [line.pop() for line in self.right]
        begins = [line.popleft() for line in self.left]
        self.arrived.append((ends, begins))
        self.right[0].appendleft(-begins[0])
        for j, (one, two, both) in enumerate(self.joints):
            a, b = ends[j], begins[j + 1]
            met = 2 * one * a + 2 * two * b
            self.left[j].append((met - both * a) // both)
            self.right[j + 1].appendleft((met - both * b) // both)
        self.left[-1].append(echo * ends[-1])
        return ends[-1]
