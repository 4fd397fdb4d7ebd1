"""The rows of a bar of several segments, and proofs over them."""
import math
from fractions import Fraction

from .limits import floor_of, within
from .reading import NoProof, Total, multiplier, multipliers, simplest, told

MOST_STEPS = 10 ** 8
MOST_WAVES = 2 * 10 ** 5
MOST_RATIO = 1e100


def weights(left, right, dashpot):
    """Whole numbers Z_1 : Z_2 : Z_1 + Z_2 + d, over a common denominator below 2^50 or to 15 digits."""
    exact = [simplest(value) for value in (left, right, dashpot)]
    common, most = 1, 2 ** 50
    for value in exact:
        common *= value.denominator // math.gcd(common, value.denominator)
    if common <= most and (left + right + dashpot) * common < most:
        whole = [int(value * common) for value in exact]
    else:
        unit = most / (left + right + dashpot)
        whole = [math.floor(Fraction(value * unit) + Fraction(1, 2))
                 for value in (left, right, dashpot)]
    sides = whole[0], whole[1], sum(whole)
    divisor = math.gcd(*sides)
    return tuple(side // divisor for side in sides)


def impedances_of(segments):
    """In units of the first, in doubles."""
    first = segments[0].impedance
    if any(not first / MOST_RATIO <= s.impedance <= first * MOST_RATIO or s.dashpot > first * MOST_RATIO
           for s in segments):
        raise NoProof(f"segments: allowed impedances and dashpots within {MOST_RATIO} of the first impedance")
    return [s.impedance / first for s in segments]


def joints_of(segments):
    """The weights of each joint, clamp first."""
    first = segments[0].impedance
    return [weights(one.impedance / first, two.impedance / first, one.dashpot / first)
            for one, two in zip(segments, segments[1:])]


class JointRows:
    """The rows of a bar of several segments, in blocks of steps (docs/certificates.md)."""

    def __init__(self, scene, floor=None):
        if not scene.segments:
            raise NoProof("segments: none")
        if not scene.where["right"]:
            raise NoProof("bar: gap: allowed other than 0 for rows of joints")
        counts = [s.cells for s in scene.segments]
        self.impedances, self.joints = impedances_of(scene.segments), joints_of(scene.segments)
        self.cells, phases = scene.cells, scene.sided()
        self.place = {side: Fraction(place) for side, place in scene.where.items()}
        self.lowest = max((place for place in (self.place.get("left"), floor) if place is not None), default=None)
        self.unit = steps = scene.steps
        if steps > MOST_STEPS:
            raise NoProof(f"schedule: this checker takes up to {MOST_STEPS} steps between joints")
        for count in counts:
            self.unit = math.gcd(self.unit, 2 * count)
        self.turns = steps // self.unit
        self.delays = [2 * count // self.unit for count in counts]
        self.divide(phases)
        self.per_step = max(2 * len(self.joints), 1)
        self.waves = len(self.types) * self.turns * self.per_step
        if self.waves > MOST_WAVES:
            raise NoProof(f"schedule: this checker takes up to {MOST_WAVES} waves at joints, not {self.waves}")
        self.equalities, self.inequalities, self.bounds = {}, [], {}
        self.add_waves()
        self.add_tip()
        self.add_gap()

    def divide(self, phases):
        """Blocks of steps, in the order of time: (type, turn, stop or None, bounds, sign)."""
        cuts, step = {0}, 0
        for contact, free, _ in phases:
            cuts |= {step % self.unit, (step + contact) % self.unit}
            step += contact + free
        self.types = sorted(cuts)
        self.blocks, self.echo = [], {}
        ends = dict(zip(self.types, self.types[1:] + [self.unit]))
        step = 0
        for k, (contact, free, side) in enumerate(phases):
            for steps, flies in ((contact, False), (free, True)):
                end = step + steps
                while step < end:
                    residue = step % self.unit
                    at = self.types.index(residue), step // self.unit
                    step += ends[residue] - residue
                    self.echo[at] = 1 if flies else -1
                    landing = phases[(k + 1) % len(phases)][2] if step == end else None
                    self.blocks.append((at, flies, side, landing))

    def arrival(self, joint, at):
        """The number of the wave that arrives from the left at a joint, the tip being the last."""
        return (at[0] * self.turns + at[1] % self.turns) * self.per_step + joint

    def between(self, joint, at):
        """That of the wave that arrives from the right at a joint before the last."""
        return self.arrival(len(self.joints) + 1 + joint, at)

    def determine(self, unknown, *terms):
        """The row that determines an unknown; equal unknowns are one."""
        row = self.equalities.setdefault(unknown, {})
        for other, factor in terms:
            row[other] = row.get(other, 0) + factor

    def add_waves(self):
        last = len(self.joints) - 1
        for at in self.echo:
            def later(i, at=at):
                return at[0], at[1] + self.delays[i]
            if not self.joints:
                onward = self.arrival(0, later(0))
                self.determine(onward, (onward, 1), (self.arrival(0, at), self.echo[at]))
            for j, (z1, z2, both) in enumerate(self.joints):
                r = self.arrival(j, at)
                # What comes back from the tip, if no joint lies between.
                left, sign = (self.arrival(j + 1, at), self.echo[at]) if j == last \
                    else (self.between(j, at), 1)
                onward = self.arrival(j + 1, later(j + 1))
                self.determine(onward, (onward, both), (r, -2 * z1), (left, (both - 2 * z2) * sign))
                back, turn = (self.arrival(0, later(0)), -1) if j == 0 \
                    else (self.between(j - 1, at), 1)
                self.determine(back, (back, both), (r, turn * (both - 2 * z1)),
                               (left, -turn * 2 * z2 * sign))

    def add_tip(self):
        half, before, tip, y = Fraction(self.cells, 2), None, len(self.joints), self.waves
        flights = sum(flies for _, flies, _, _ in self.blocks)
        for at, flies, side, landing in self.blocks:
            p = self.arrival(tip, at)
            if not flies:
                self.inequalities.append((p, -1 if side == "right" else 1))
                before = None
                continue
            self.determine(y, (y, 1), (p, -1), *([(before, -1)] if before is not None else []))
            start = self.place[side]
            low = None if self.lowest is None else half * (self.lowest - start)
            self.bounds[y] = low, half * (self.place["right"] - start)
            if landing and y + 1 < self.waves + flights:
                self.bounds[y] = (half * (self.place[landing] - start),) * 2
            before, y = y, y + 1
        self.start = self.place[self.blocks[0][2]]

    def energy_weights(self):
        """w of the waves with E/E_1 = sum of w x^2, x a sum over a block of d residues."""
        weights = {}
        ends = self.types[1:] + [self.unit]
        for i, (delay, impedance) in enumerate(zip(self.delays, self.impedances)):
            for kind, (first, end) in enumerate(zip(self.types, ends)):
                for k in range(delay):
                    unknown = self.arrival(i, (kind, k))
                    weights[unknown] = weights.get(unknown, 0) + \
                        Fraction(2, self.cells) * Fraction(impedance) / (end - first)
        return weights

    def add_gap(self):
        """u(L, 0) = place of the first contact, times -N."""
        row = {}
        for i, delay in enumerate(self.delays):
            for kind in range(len(self.types)):
                for k in range(delay):
                    unknown = self.arrival(i, (kind, k))
                    row[unknown] = row.get(unknown, 0) + 1
        self.equalities[len(self.equalities)] = row


def combined_joints(rows, certificate):
    """Multipliers times rows, less what prefix sums give at their bounds: what is left of the waves,
    the right side, and how many rows there were."""
    equalities = multipliers(certificate, "equalities", len(rows.equalities), True, multiplier)
    inequalities = multipliers(certificate, "inequalities", len(rows.inequalities), False, multiplier)
    total = {}
    for row, value in equalities:
        for unknown, factor in rows.equalities[row].items():
            total[unknown] = total.get(unknown, 0) + value * factor
    for row, value in inequalities:
        unknown, factor = rows.inequalities[row]
        total[unknown] = total.get(unknown, 0) + value * factor
    right = Total(dict(equalities).get(len(rows.equalities) - 1, 0) * -rows.start * rows.cells)
    left = {}
    for unknown, factor in total.items():
        bound = rows.bounds.get(unknown, (None, None))[0 if factor > 0 else 1] if factor else 0
        if bound is None:
            left[unknown] = factor
        elif factor:
            right.add(-factor * bound)
    if not right.value < 0:
        raise NoProof("the rows do not contradict the bounds")
    return left, right.value, len(equalities) + len(inequalities)


def check_joints(scene, certificate):
    """The rows so combined are out of reach of all unknowns within their bounds, or NoProof."""
    floor = floor_of(certificate)
    rows = JointRows(scene, floor)
    return contradiction(rows, certificate) + within(None, floor)


def contradiction(rows, certificate):
    """That multipliers contradict the bounds, in words."""
    left, _, count = combined_joints(rows, certificate)
    for unknown, factor in left.items():
        raise NoProof(f"the rows do not cancel: {told(factor)} times unknown {unknown} is left")
    return (f"{count} of {len(rows.equalities) + len(rows.inequalities)} rows of {len(rows.joints)} "
            "joints contradict each other")
