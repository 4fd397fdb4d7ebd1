"""That no curve of motions joins two states."""
import csv
from fractions import Fraction

from .energies import Energies
from .reading import NoProof, close, number, require_keys, shown
from .scene import BESIDES, DERIVED, Scene, positive, unsaid
from .sums import Sums

ROUNDING = Fraction(1, 10 ** 9)  # of the states
SAID = ("status", "cells", "schedule", "bar", "stops", "segments", "energy_ratio", "connected")
# What a continuum says besides.
SEEN = ("energy", "points", "components", "dimension", "energy_ratio_range", "resolution", "engine", "parameter",
        "orbits", "member")


def waves_of(path, cells):
    """p_0 .. p_{2N-1} of a state: a_i = p_{N-i}, b_i = -p_{N+i-1}; in fractions of its numbers."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if len(rows) != cells:
        raise NoProof(f"{path}: {len(rows)} rows, not {cells}")
    a, b = ([Fraction(number(float(row[name]), path)) for row in rows] for name in "ab")
    return a[::-1] + [-value for value in b]


class Motion:
    """The amplitudes z of a state, run by run, once it is shown to be a motion of this energy."""

    def __init__(self, path, energies, unit, squares):
        sums = energies.sums
        waves = [wave / unit for wave in waves_of(path, sums.cells)]
        self.size = max(map(abs, waves))
        self.error = ROUNDING * self.size
        steps = len(sums.stop)
        seen = {}  # of each residue: what z is in the steps of the state
        for u, wave in enumerate(waves):
            residue = u % steps % sums.classes
            first = max((run for run in sums.live if run <= residue), default=None)
            if first is not None and residue - first < sums.widths[sums.live[first]]:
                sign = sums.signs[first][(u - residue + first) % steps]
                seen.setdefault(residue, []).append(wave * sign)
            elif abs(wave) > self.error:
                raise NoProof(f"{path}: wave {u} is to be 0")
        if any(max(values) - min(values) > self.error for values in seen.values()):
            raise NoProof(f"{path}: waves that are to be the same differ")
        self.runs = [[seen[first + k][0] for k in range(width)]
                     for first, width in zip(sums.live, sums.widths)]
        self.check(path, energies, squares)

    def check(self, path, energies, squares):
        """Do its amplitudes meet all rows, and have they this energy?"""
        sums = [sum(run) for run in self.runs]

        def excess(row, right):
            return (sum(c * s for c, s in zip(row, sums)) - right) / (1 + sum(map(abs, row)))

        slack = ROUNDING * max([1, self.size, *map(abs, sums)])
        if any(abs(excess(*row)) > slack for row in energies.equalities) or \
                any(excess(*row) > slack for row in energies.inequalities) or \
                any(may_press and min(run) < -self.error
                    for run, may_press in zip(self.runs, energies.sums.pressing)):
            raise NoProof(f"{path}: no motion of this schedule")
        if abs(sum(z * z for run in self.runs for z in run) / squares - 1) > ROUNDING:
            raise NoProof(f"{path}: no motion of this energy")


def least_between(v, w):
    """The least sum of squares on the segment between two points."""
    along = sum(a * (a - b) for a, b in zip(v, w))
    length = sum((a - b) ** 2 for a, b in zip(v, w))
    part = min(max(along / length, 0), 1)
    return sum((a + part * (b - a)) ** 2 for a, b in zip(v, w))


class Corners:
    """Corners of the sums, and which of them are connected at this energy. A corner of the motions is
    one of the sums, each sum in one residue of its run."""

    def __init__(self, energies, squares):
        self.sums = energies.sums
        if any(width > 1 and not may_press
               for width, may_press in zip(self.sums.widths, self.sums.pressing)):
            raise NoProof("several runs, one of several residues of any sign: not known to this checker")
        self.points = energies.corners
        self.parts = list(range(len(self.points)))
        above = [k for k, v in enumerate(self.points) if sum(s * s for s in v) >= squares]
        for i in above:
            for k in above:
                if self.parts[k] < self.parts[i] and \
                        least_between(self.points[i], self.points[k]) >= squares:
                    old, new = self.parts[i], self.parts[k]
                    self.parts = [new if part == old else part for part in self.parts]
        self.squares = squares

    def place(self, motion):
        """To which part it looks, and to which residue of each run."""
        most = [max(run) for run in motion.runs]
        heights = [sum(s * z for s, z in zip(v, most)) for v in self.points]
        best = max(range(len(heights)), key=heights.__getitem__)
        for k, height in enumerate(heights):
            moves = sum(abs(s) + abs(t) for s, t in zip(self.points[k], self.points[best]))
            if self.parts[k] != self.parts[best] and heights[best] - height <= moves * motion.error:
                raise NoProof("a state looks to two parts")
        return self.parts[best], [run.index(z) for run, z in zip(motion.runs, most)]

    def is_locked(self, part, run):
        """Is a sum held in one residue? Halfway to another one its squares are half."""
        return self.sums.widths[run] > 1 and all(
            v[run] > 0 and sum(s * s for s in v) - v[run] ** 2 / 2 < self.squares
            for v, its in zip(self.points, self.parts) if its == part)

    def apart(self, one, two):
        """Why no curve joins two motions, in words."""
        (part, places), (other, others) = self.place(one), self.place(two)
        if part != other:
            return (f"the corners of {len(self.points)} form separate components, the one motion belongs to that "
                    f"of corner {part}, the other to that of corner {other}")
        for run, (here, there) in enumerate(zip(places, others)):
            if here != there and self.is_locked(part, run):
                for motion in (one, two):
                    highest, next_ = sorted(motion.runs[run])[:-3:-1]
                    if highest - next_ <= 2 * motion.error:
                        raise NoProof("a state looks to two residues")
                return (f"the sum of run {run} cannot leave its residue, which is {here} of "
                        f"{self.sums.widths[run]} here and {there} there")
        raise NoProof("nothing keeps them apart")


class Walls:
    """One run of amplitudes z of any sign: each of their partial sums Z but the last lies between the
    same two bounds. d - 1 edges meet in a corner of this box, and one Z alone moves along each."""

    def __init__(self, energies, squares):
        self.squares, (self.total,) = squares, energies.corners[0]
        self.low, self.high = energies.sums.bounds(energies.corners[0], 0)

    def corner(self, motion):
        """The Z of the corner to which it looks."""
        z, = motion.runs
        return [self.high if here > next_ else self.low for here, next_ in zip(z, z[1:])]

    def side(self, corner, motion):
        """-1 on the side of this corner, 1 beyond the plane through the lowest points of its edges.
        That no motion of this energy lies on this plane is shown first."""
        ends = [0, *corner, self.total]
        z, = motion.runs
        place = depth = slack = Fraction(0)
        for j, here in enumerate(corner, start=1):
            before, after, way = ends[j - 1], ends[j + 1], self.low + self.high - 2 * here
            # (Z_j - before)^2 + (after - Z_j)^2 is least in the middle.
            part = min(max(((before + after) / 2 - here) / way, Fraction(0)), Fraction(1))
            lowest = here + part * way
            squares = sum((b - a) ** 2 for a, b in zip(ends, ends[1:]))
            squares += (lowest - before) ** 2 + (after - lowest) ** 2
            squares -= (here - before) ** 2 + (after - here) ** 2
            if not part or squares >= self.squares:
                raise NoProof("the way along an edge is open")
            place += z[j - 1]
            depth += (place - here) / (lowest - here)
            slack += j * motion.error / abs(lowest - here)
        return (depth > 1 + slack) - (depth < 1 - slack)

    def apart(self, one, two):
        """Why no curve joins two motions, in words."""
        for place, other in ((one, two), (two, one)):
            try:
                corner = self.corner(place)
                sides = self.side(corner, place), self.side(corner, other)
            except NoProof:
                continue
            if sides == (-1, 1):
                return (f"a plane without motions of this energy cuts off one of {2 ** len(corner)} "
                        "corners, with one of them")
        raise NoProof("nothing keeps them apart")


def check(answer, begin, end):
    """Why no curve joins them, in a sentence."""
    require_keys(answer, "answer", SAID, (*BESIDES, *DERIVED, *SEEN))
    if answer["connected"] is not False or answer["status"] != "none":
        raise NoProof("the answer does not say \"connected\": false, and \"none\" of the curve")
    scene = Scene(answer)
    scene.require_derived(answer)
    if not scene.is_uniform() or not scene.gap:
        raise NoProof("allowed: one bar, with a gap")
    energies = Energies(Sums(scene.cells, scene.phases, scene.stops, scene.where))
    if not energies.is_bounded or not energies.corners:
        raise NoProof("motions without bound, or none: not known to this checker")
    ratio = Fraction(number(answer["energy_ratio"], "energy_ratio"))
    if not ratio > 0:
        raise NoProof("energy_ratio: allowed above 0")
    require_energy(answer, scene, ratio)
    squares = ratio / energies.unit
    unit = abs(Fraction(scene.gap)) / Fraction(scene.length)
    one, two = (Motion(path, energies, unit, squares) for path in (begin, end))
    is_box = energies.sums.pressing == [False] and energies.sums.widths[0] > 1
    parts = (Walls if is_box else Corners)(energies, squares * (1 - ROUNDING / 1000))
    return (f"motions of E/E_1 = {answer['energy_ratio']!r}, {scene.text()}, free and undamped: {parts.apart(one, two)}"
            f"{unsaid(answer, SEEN[1:])}")


def require_energy(answer, scene, ratio):
    """That in joules, where it is said: E_1 = EA g^2/(2L)."""
    if answer.get("energy") is not None:
        stiffness = Fraction(positive(scene.bar, "axial_stiffness", "bar"))
        truth = ratio * stiffness * Fraction(scene.gap) ** 2 / (2 * Fraction(scene.length))
        if not close(answer["energy"], truth, ROUNDING):
            raise NoProof(f"energy: {shown(answer['energy'])} does not follow from its ratio")
