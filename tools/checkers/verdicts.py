"""What a schedule is, decided here: for atlases."""
import itertools
import math
import re
from fractions import Fraction

from .energies import Energies
from .floor import HUGE, Floor
from .quadratic import least_energy
from .reading import NoProof, shown, told
from .segments import contradiction
from .sums import Sums
from .whole import combination, dot, null_space, rank, reduced

EXACT = Fraction(1, 10 ** 12)  # but for rounding
TOLERANCE = Fraction(1, 10 ** 7)  # of the program, for bars of several segments


class Verdict:
    """What a schedule of one bar is, decided here."""

    accuracy = EXACT
    is_stepped = False

    def __init__(self, cells, phases, where):
        self.cells, self.phases = cells, phases
        stops = ["left" if is_left else "right" for _, _, is_left in phases]
        self.is_any_size = not where["right"] and "left" not in stops  # a motion, and all its multiples
        self.sums = sums = Sums(cells, [phase[:2] for phase in phases], stops,
                                {"right": 0} if self.is_any_size else where)
        self.energies = energies = Energies(sums)
        self.kernel = sums.kernel
        self.exists = bool(energies.corners)
        self.reasons = {None}
        self.least = self.most = self.unknown = self.contact = self.kind = self.family = None
        self.canonical, self.dimension = None, None
        self.steps = sum(sum(phase[:2]) for phase in phases)
        if not self.exists:
            self.reasons = self.true_reasons(sums, energies)
            return
        self.point = self.least_point()
        self.touch()
        self.repeat()
        self.measure()
        self.shape()
        if len(phases) == 1 and not phases[0][2]:
            self.join()

    def least_point(self):
        """The sums of least energy; Karush, Kuhn and Tucker's conditions are checked on the way."""
        energies, widths = self.energies, self.sums.widths
        metric = [[Fraction(int(i == k), width) for k in range(len(widths))] for i, width in enumerate(widths)]

        def times(row, factor):
            return [Fraction(factor * a) for a in row]

        conditions = [(times(row, 1), Fraction(right), True) for row, right in energies.equalities]
        conditions += [(times(row, -1), Fraction(-right), False) for row, right in energies.inequalities]
        conditions += [(row, Fraction(0), False) for row, may_press in
                       zip(([Fraction(int(i == k)) for i in range(len(widths))] for k in range(len(widths))),
                           self.sums.pressing) if may_press]
        return least_energy(metric, conditions)

    def touch(self):
        """Does the motion of least energy press, and at all steps of contact?"""
        sums = self.sums
        runs = {first + k: sums.live[first] for first in sums.live
                for k in range(sums.widths[sums.live[first]])}
        pressed = [self.point[runs[m % sums.classes]] > 0 if m % sums.classes in runs else False
                   for m, stop in enumerate(sums.stop) if stop]
        self.contact = "pressing" if any(pressed) else "grazing"
        self.canonical = int(all(pressed) and self.once() == len(self.phases))

    def once(self):
        """How many of the phases repeat."""
        count = len(self.phases)
        return next(k for k in range(1, count + 1)
                    if count % k == 0 and self.phases == self.phases[:k] * (count // k))

    def repeat(self):
        """After how many steps all motions repeat, and with them p_m = z or -z."""
        sums, once = self.sums, self.once()
        pressed = [bool(sums.stop[m]) for signs in sums.signs.values() for m in signs]
        if not any(pressed) or (len(self.phases) == 1 and all(pressed)):
            self.steps = next(d for d in range(sums.classes, len(sums.stop) + 1, sums.classes)
                              if self.has_period(d))
        elif once < len(self.phases):
            phases = self.phases[:once]
            alone = Sums(self.cells, [phase[:2] for phase in phases],
                         ["left" if is_left else "right" for _, _, is_left in phases], sums.where)
            if alone.kernel == self.kernel:
                self.steps = sum(sum(phase[:2]) for phase in phases)

    def has_period(self, d):
        """Is p the same d steps later, d a whole number of times G?"""
        n = len(self.sums.stop)
        return n % d == 0 and all(signs[(m + d) % n] == sign
                                  for signs in self.sums.signs.values() for m, sign in signs.items())

    def measure(self):
        """Least and most energy; `unknown` if the most is not known here."""
        if self.is_any_size:
            self.least, self.most = 0, math.inf
            return
        energies = self.energies
        self.least = energies.unit * sum(s * s / d for s, d in zip(self.point, self.sums.widths))
        try:
            self.most = energies.most() if energies.is_bounded else math.inf
        except NoProof as why:  # a bound that depends on the sums
            self.unknown = str(why)

    def shape(self):
        """Dimension and kind of the set of all amplitudes: corners of the sums, and what spreads over the
        residues of a run at a point inside."""
        corners, ways, sums = self.energies.corners, self.energies.ways, self.sums
        edges = [[a - b for a, b in zip(corner, corners[0])] for corner in corners[1:]] + ways
        flat = rank(edges)
        centre = [sum(column) / len(corners) for column in zip(*corners)]
        centre = [a + sum(way[i] for way in ways) for i, a in enumerate(centre)]
        self.dimension, spread = flat, set()
        for k, width in enumerate(sums.widths):
            if width > 1 and (centre[k] > 0 if sums.pressing[k] else self.is_open(centre, k)):
                self.dimension += width - 1
                spread.add(sums.pressing[k])
        if self.is_any_size:
            self.dimension, self.kind = self.dimension + 1, "cone"
        elif not self.dimension:
            self.kind = "point"
        elif not flat and True not in spread:
            self.kind = "box"
        else:
            count = sum(math.prod(width if s and may_press else 1 for s, width, may_press in
                                  zip(corner, sums.widths, sums.pressing)) for corner in corners)
            is_simplex = False not in spread and not ways and count == self.dimension + 1
            self.kind = "simplex" if is_simplex else "polytope"

    def is_open(self, centre, k):
        """Is there room between the bounds of a run of any sign?"""
        low, high = self.sums.bounds(centre, k)
        return low < high

    def join(self):
        """The family: w, nu, k or nothing where motions graze, the schedule whose set is the whole, steps."""
        sums = self.sums
        blocks = len(sums.stop) // sums.classes
        signs = next(iter(sums.signs.values()))
        held = sum(bool(sums.stop[m]) for m in signs)
        order, classes = 2 * self.cells // sums.classes, sums.classes
        if not held:
            self.family = (None, None, None), (1, 2 * classes - 1), 2 * classes
        elif held == len(signs):
            self.family = (order, 1, 1), (classes - 1, 1), classes
        else:
            self.family = (order, blocks, held), (held * classes, (blocks - held) * classes), self.steps

    @staticmethod
    def true_reasons(sums, energies):
        """Every reason of docs/theory.md, section 5, that is true here."""
        if not sums.kernel:
            return {"no-live-class"}
        if not sums.pressing:
            return {"contact-sign"}
        gap, right = energies.equalities[0]
        helps = [c * right > 0 if may_press else c for c, may_press in zip(gap, sums.pressing)]
        is_held = any(helps) if right else not (all(c > 0 for c in gap) or all(c < 0 for c in gap))
        # With one sum S >= 0 a row c S <= right <= 0 with c > 0 forbids it; several need more rows,
        # as does a second stop, which may forbid what the gap row asks for.
        may_fall = is_held or not right
        if len(sums.flights) == 1:
            may_fall = any(row[0] > 0 >= most for row, most in energies.inequalities) or \
                (may_fall and "left" in sums.where)
        return ({"gap"} if not is_held else set()) | ({"penetration"} if may_fall else set())


class Waves:
    """All unknowns of JointRows in coordinates of ker(W - 1), by elimination in whole numbers.

    The first waves of each joint and kind are left open; every other unknown follows from them by the
    row that determines it, and the rows of those that are known already close time upon itself.
    """

    def __init__(self, rows):
        self.rows = rows
        kinds = range(len(rows.types))
        opened = [rows.arrival(i, (kind, k)) for kind in kinds for i, delay in enumerate(rows.delays)
                  for k in range(min(delay, rows.turns))]
        self.size = len(opened)
        self.forms = {u: ([int(u == v) for v in opened], 1) for u in opened}
        closures = []
        for key in self.in_time():
            if key in self.forms:
                closures.append(self.sum_of(rows.equalities[key])[0])
            else:
                self.determine(key)
        basis = null_space(closures, self.size)
        self.kernel = sum(self.width(free * len(kinds) // self.size) for free in basis)
        self.forms = {u: reduced([dot(form, vector) for vector in basis.values()], denominator)
                      for u, (form, denominator) in self.forms.items()}
        self.size = len(basis)
        for key in range(rows.waves, len(rows.equalities) - 1):  # the way of the tip in flight
            self.determine(key)

    def width(self, kind):
        """How many residues are of a kind."""
        return (self.rows.types[1:] + [self.rows.unit])[kind] - self.rows.types[kind]

    def in_time(self):
        """The rows of waves, each after those that determine what else is in it."""
        rows = self.rows
        for kind in range(len(rows.types)):
            for k in range(rows.turns):
                for j in reversed(range(len(rows.joints) - 1)):
                    yield rows.between(j, (kind, k))
                for i, delay in enumerate(rows.delays):
                    yield rows.arrival(i, (kind, k + delay))

    def sum_of(self, row):
        return combination([(factor, self.forms[u]) for u, factor in row.items()], self.size)

    def determine(self, key):
        row = dict(self.rows.equalities[key])
        factor = row.pop(key)
        whole, denominator = self.sum_of(row)
        self.forms[key] = reduced([-a for a in whole], denominator * factor)

    def vector(self, unknown, sign=1):
        whole, denominator = self.forms[unknown]
        return [Fraction(sign * a, denominator) for a in whole]

    def energy(self):
        """The matrix of E/E_1."""
        matrix = [[Fraction(0)] * self.size for _ in range(self.size)]
        if not min(self.rows.impedances):
            raise NoProof("segments: an impedance is 0 in units of the first")
        for unknown, weight in self.rows.energy_weights().items():
            whole, denominator = self.forms[unknown]
            weight /= denominator * denominator
            for i, a in enumerate(whole):
                for j in range(i + 1):
                    matrix[i][j] += weight * a * whole[j]
        return [[matrix[max(i, j)][min(i, j)] for j in range(self.size)] for i in range(self.size)]

    def starts(self, slack=0):
        """The conditions (row, least, is it an equality) that contacts start at the wall: the gap, and
        flights but the last. With slack a place may be missed by that."""
        whole, denominator = self.sum_of(self.rows.equalities[len(self.rows.equalities) - 1])
        conditions = [([Fraction(a, denominator) for a in whole], -self.rows.start * self.rows.cells, True)]
        for y, (low, high) in self.rows.bounds.items():
            if low == high:
                conditions += [(self.vector(y), low - self.way(slack), False),
                               (self.vector(y, -1), -high - self.way(slack), False)] if slack else \
                    [(self.vector(y), low, True)]
        return conditions

    def contacts(self, slack=0):
        """The conditions of contact; with slack a wave may pull by that."""
        return [(self.vector(p, -sign), -slack, False) for p, sign in self.rows.inequalities]

    def flights(self, slack=0):
        """The conditions of flight."""
        return [(self.vector(y, -1), -high - self.way(slack), False)
                for y, (low, high) in self.rows.bounds.items() if low != high]

    def way(self, slack):
        return slack * Fraction(self.rows.cells, 2)

    def check(self, point):
        """These coordinates are those of a motion: it meets every row of JointRows."""
        rows = self.rows
        at = {u: Fraction(dot(whole, point), denominator) for u, (whole, denominator) in self.forms.items()}
        last = len(rows.equalities) - 1
        for number, row in rows.equalities.items():
            right = -rows.start * rows.cells if number == last else 0
            if sum(factor * at[u] for u, factor in row.items()) != right:
                raise ArithmeticError(f"row {number} is not met")
        if any(sign * at[p] > 0 for p, sign in rows.inequalities) or \
                any(at[y] > high or (low is not None and at[y] < low)
                    for y, (low, high) in rows.bounds.items()):
            raise ArithmeticError("an inequality is not met")


class SteppedVerdict:
    """What a schedule of a bar of several segments is, decided here."""

    accuracy = TOLERANCE
    is_stepped = True
    unknown = canonical = kind = dimension = family = None  # not decided here

    def __init__(self, rows, scene):
        self.rows, self.scene, self.steps = rows, scene, rows.turns * rows.unit
        self.waves = waves = Waves(rows)
        self.kernel, self.energy = waves.kernel, waves.energy()
        point = least_energy(self.energy, waves.starts() + waves.contacts() + waves.flights())
        self.exists = point is not None
        self.least = self.most = self.contact = None
        self.reasons = {None}
        if self.exists:
            waves.check(point)
            self.least = dot(point, [dot(line, point) for line in self.energy])
            self.most = self.least if self.kernel == 1 else None  # one motion, or not known
            self.contact = "pressing" if any(dot(waves.vector(p), point) for p, _ in rows.inequalities) else "grazing"
        else:
            self.reasons = self.true_reasons()

    def true_reasons(self):
        """Every reason that is true here: what a few rows forbid all of them forbid, too."""
        waves, reasons = self.waves, {"penetration"}
        if least_energy(self.energy, waves.starts() + waves.contacts()) is None:
            reasons.add("contact-sign")
            if least_energy(self.energy, waves.starts()) is None:
                reasons.add("gap")
                if not waves.kernel:
                    reasons.add("no-live-class")
        return reasons

    def is_near(self):
        """Are there motions that miss pushes and places by no more than the tolerance of the program?"""
        waves = self.waves
        return least_energy(self.energy, waves.starts(TOLERANCE) + waves.contacts(TOLERANCE) +
                            waves.flights(TOLERANCE)) is not None

    def check_proof(self, text):
        """The multipliers that a row holds prove its verdict by themselves: "wave ...; contact:step:multiplier
        ...; ..." of periodicity, distances and pushes; in older files "row:multiplier ...; ..." of equalities
        and inequalities."""
        parts = str(text).split(";")
        if len(parts) == 3:
            try:
                waves = [float(value) for value in parts[0].split()]
                places, pushes = ([[int(contact), int(step), float(value)] for contact, step, value in
                                   (entry.split(":") for entry in part.split())] for part in parts[1:])
            except ValueError:
                raise NoProof(f"{shown(text)} is no list of multipliers") from None
            least = Floor(self.scene, {"periodicity": waves, "places": places, "pushes": pushes}).least()
            if least < HUGE:
                raise NoProof(f"{shown(text)}: only {told(least)} E_1 is proved")
            return
        lists = [[re.fullmatch("([0-9]{1,9}):([-0-9/]+)", pair) for pair in part.split()]
                 for part in str(text).split(";")]
        if len(lists) != 2 or not all(itertools.chain(*lists)):
            raise NoProof(f"{shown(text)} is no list of multipliers")
        equalities, inequalities = ([[int(pair[1]), pair[2]] for pair in pairs] for pairs in lists)
        contradiction(self.rows, {"equalities": equalities, "inequalities": inequalities})
