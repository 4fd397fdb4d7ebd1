"""The waves of a damped bar that a force on the tip or a moving base drives, and rows of them."""
import math
from fractions import Fraction

from .enclosed import NOTHING, ONE, ZERO, decay, enclosed, harmonic
from .reading import NoProof, integer, number, require_keys, shown
from .scene import ASKED, BESIDES, DERIVED, Scene, Segment, positive

MOST_STEPS = 10 ** 6
MOST_DAMPING = 20
EXCITED = ("damping", "force", "cycles", "strain_limit", "amplitude")
SEEN = ("amplitude_range",)  # of the motions there are
EMPTY = ("phase", "motions")  # what an answer without a motion does not say


class Row:
    """vector . (C, S) + the sum of free[j] z_j >= limit, or = limit. z_j are the amplitudes of waves that
    nothing damps, and their factors whole numbers."""

    def __init__(self, is_equality=False, limit=ZERO):
        self.is_equality, self.limit = is_equality, limit
        self.vector, self.free = NOTHING, {}

    def is_free(self):
        """Is a z in it?"""
        return any(self.free.values())


class Question:
    """What is asked, displacements in |g| (L where g = 0), times in L/c, forces in EA |g|/L."""

    def __init__(self, answer):
        require_keys(answer, "answer", (*ASKED, *EXCITED), (*BESIDES, *DERIVED, *SEEN, *EMPTY))
        self.scene = scene = Scene(answer)
        self.cells, self.phases, self.stops, self.where = scene.cells, scene.phases, scene.stops, scene.where
        self.steps = scene.steps
        self.cycles = integer(answer["cycles"], "cycles")
        if self.steps > MOST_STEPS or self.cells > MOST_STEPS:
            raise NoProof(f"schedule: more than {MOST_STEPS} steps or cells are not known to this checker")
        if not 0 < 2 * self.cycles < self.steps:
            raise NoProof(f"cycles: {self.cycles}, allowed 1 and more, below half of {self.steps} steps")
        for key in EMPTY:
            if answer.get(key) not in (None, []):
                raise NoProof(f"{key}: {shown(answer[key])} is not proved here")
        scene.require_derived(answer, self.cycles)
        self.read_bar(answer)
        self.read_excitation(answer)

    def read_bar(self, answer):
        """Units, and the limit of p: a strain of -2p is met at the clamp, which no force moves. A base that moves adds
        to it: then the bar is a network of one segment."""
        length = Fraction(self.scene.length) / self.scene.lengthening()
        self.reach = Fraction(self.scene.unit)
        self.force_unit = Fraction(positive(self.scene.bar, "axial_stiffness", "bar")) * self.reach / length
        self.limit, self.most_wave = answer["strain_limit"], None
        if self.limit is not None:
            self.most_wave = Fraction(number(self.limit, "strain_limit")) * length / self.reach / 2
            if not self.most_wave > 0:
                raise NoProof("strain_limit: allowed above 0")
            if answer["force"] == "base" and not self.scene.segments:
                self.scene.segments = [Segment(self.scene.cells, 1.0, 1.0, 0.0)]

    def read_excitation(self, answer):
        """Damping, place and amplitude."""
        damping = require_keys(answer["damping"], "damping", ("ratio",), ("dashpot",))
        self.ratio = number(damping["ratio"], "damping: ratio")
        self.excited = answer["force"]
        if not 0 <= self.ratio <= MOST_DAMPING or self.excited not in ("tip", "base"):
            raise NoProof(f"damping, force: allowed a ratio of 0 to {MOST_DAMPING}, \"tip\" or \"base\"")
        if "dashpot" in damping:
            self.require_dashpot(damping["dashpot"])
        self.amplitude = None
        if answer["amplitude"] is not None:
            unit = self.force_unit if self.excited == "tip" else self.reach
            self.amplitude = Fraction(number(answer["amplitude"], "amplitude")) / unit

    def require_dashpot(self, value):
        """d = (EA/c) tanh(pi Z/2): what it says is said by the ratio."""
        bar = self.scene.bar
        truth = math.tanh(math.pi * self.ratio / 2) * bar["axial_stiffness"] / positive(bar, "wave_speed", "bar")
        if not math.isclose(number(value, "damping: dashpot"), truth, rel_tol=1e-9, abs_tol=0):
            raise NoProof(f"damping: dashpot: {shown(value)} does not follow from the ratio, {truth!r} does")

    def text(self):
        """All of it, in words."""
        how = "a force on the tip" if self.excited == "tip" else "a base that moves"
        limit = "" if self.limit is None else f", strains >= -{self.limit!r}"
        return f"{self.scene.text()}, damping ratio {self.ratio!r}, {how}, {self.cycles} cycles in a period{limit}"

    def is_of_network(self):
        """Are its rows those of waves that go through segments?"""
        has_one_speed = len({segment.speed for segment in self.scene.segments}) < 2
        return not self.scene.is_uniform() or not has_one_speed or (
            self.limit is not None and self.excited == "base")

    def can_rest(self):
        """Is the bar at rest, which nothing pushes, a motion? No gap, and only the wall is touched."""
        return self.where["right"] == 0 and "left" not in self.stops


class Waves:
    """p_m, the wave that arrives at the tip in step m, C p^c + S p^s + sign z, and rows made of them.

    In flight it leaves as rho p + (1 + rho)/2 F, in contact as -p; at the base, N steps later, V minus
    that sets out, and is back after N more. Going around all steps that follow each other like this
    multiplies a wave by (-rho)^(its flights): it is what comes back from 0, over 1 - that; or, if that is
    1, it has an amplitude z of its own, and what comes back from 0, its work, has to be 0."""

    def __init__(self, question):
        self.question, self.steps = question, question.steps
        self.rho = decay(question.ratio)
        self.give = (ONE + self.rho) * enclosed(Fraction(1, 2))  # v = give (F + 2p)
        self.stop = []  # of each step: what it touches, None in flight
        self.takeoff = []  # of each step: where the flight of its phase begins,
        self.phase = []    # and which phase it is of
        for k, ((contact, free), stop) in enumerate(zip(question.phases, question.stops)):
            self.takeoff += [len(self.stop) + contact] * (contact + free)
            self.phase += [k] * (contact + free)
            self.stop += [stop] * contact + [None] * free
        self.wave = [None] * self.steps
        self.sign = [0] * self.steps
        self.ring = [None] * self.steps  # the steps that follow each other
        self.work = {}  # by the first of them
        for first in range(self.steps):
            if self.wave[first] is None:
                self.go_around(first)

    def force(self, m):
        """F in the middle of step m."""
        question = self.question
        if question.excited == "base":
            return NOTHING
        return harmonic(question.cycles * (2 * m + 1), 2 * self.steps)

    def base(self, m):
        """The place of the base when step m begins."""
        question = self.question
        return harmonic(question.cycles * m, self.steps) if question.excited == "base" else NOTHING

    def echo(self, m, p):
        """What arrives 2N steps after p."""
        begin = m + self.question.cells
        speed = NOTHING
        if self.question.excited == "base":
            speed = (self.base(begin + 1) - self.base(begin)).times(enclosed(self.question.cells))
        if self.stop[m]:
            return speed + p
        return speed - p.times(self.rho) - self.force(m).times(self.give)

    def go_around(self, first):
        """Waves of the steps first, first + 2N, ... ."""
        ring, m, p = [], first, NOTHING
        while not ring or m != first:
            ring.append(m)
            p = self.echo(m, p)
            m = (m + 2 * self.question.cells) % self.steps
        flights = sum(self.stop[m] is None for m in ring)
        sign = 0
        if flights == 0 or (self.question.ratio == 0 and flights % 2 == 0):
            self.work[first], p, sign = p, NOTHING, 1
        else:
            factor = ONE
            for _ in range(flights):
                factor = factor * -self.rho
            p = p.over(ONE - factor)
        for m in ring:
            self.wave[m], self.sign[m], self.ring[m] = p, sign, ring
            p = self.echo(m, p)
            sign = sign if self.stop[m] else -sign

    def add_wave(self, row, m, factor):
        """factor times p_m."""
        m %= self.steps
        row.vector += self.wave[m].times(enclosed(factor))
        if self.sign[m]:
            first = self.ring[m][0]
            row.free[first] = row.free.get(first, 0) + factor * self.sign[m]

    def add_push(self, row, m, factor):
        """factor times F + 2p, in contact the force on the wall."""
        row.vector += self.force(m).times(enclosed(factor))
        self.add_wave(row, m, 2 * factor)

    def place(self, k):
        """Where contact k, counted around, stops the tip."""
        stops = self.question.stops
        return Fraction(self.question.where[stops[k % len(stops)]])

    def gap(self):
        """N u(L, 0) = N times the place of the first contact."""
        cells = self.question.cells
        row = Row(True, enclosed(cells * self.place(0)))
        row.vector = self.base(cells).times(enclosed(cells))
        for m in range(2 * cells):
            self.add_wave(row, m, -1)
        return row

    def pressure(self, m):
        """The wall pushes."""
        if not self.stop[m]:
            return None
        row = Row()
        self.add_push(row, m, 1 if self.stop[m] == "right" else -1)
        return row

    def held(self, m):
        """It pushes on average in all steps of one ring, if they touch one stop."""
        if any(self.stop[k] != self.stop[m] or not self.stop[m] for k in self.ring[m]):
            return None
        row = Row()
        for k in self.ring[m]:
            self.add_push(row, k, 1 if self.stop[m] == "right" else -1)
        return row

    def flight(self, m, row, place, factor):
        """A row of u(L) after step m of a flight, factor times its bound: it moves by give (F + 2p)/N in a
        step."""
        way = enclosed(factor * self.question.cells * (place - self.place(self.phase[m])))
        row.limit = way / self.give
        for k in range(self.takeoff[m], m + 1):
            self.add_push(row, k, factor)
        return row

    def penetration(self, m):
        """u(L) is at most at the wall."""
        return None if self.stop[m] else self.flight(m, Row(), Fraction(self.question.where["right"]), -1)

    def second_stop(self, m):
        """u(L) is at least at the second stop."""
        if self.stop[m] or "left" not in self.question.where:
            return None
        return self.flight(m, Row(), self.question.where["left"], 1)

    def closure(self, m):
        """A flight ends where the next contact is."""
        if self.stop[m] or (m + 1 < self.steps and not self.stop[m + 1]):
            return None
        return self.flight(m, Row(True), self.place(self.phase[m] + 1), 1)

    def no_work(self, m):
        """The excitation adds nothing to a wave that nothing damps."""
        first = self.ring[m][0]
        if first not in self.work:
            return None
        row = Row(True)
        row.vector = self.work[first]
        return row

    def strain(self, m):
        """p is at most half of the limit on strain."""
        if self.question.most_wave is None or self.question.excited != "tip":
            return None
        row = Row(False, enclosed(-self.question.most_wave))
        self.add_wave(row, m, -1)
        return row

    RULES = {"pressure": pressure, "held": held, "penetration": penetration, "second-stop": second_stop,
             "closure": closure, "work": no_work, "strain": strain}

    def row(self, condition):
        """The row of a condition of the file."""
        rule = require_keys(condition, "conditions", ("rule", "step"))["rule"]
        if not isinstance(rule, str) or rule not in self.RULES:
            raise NoProof(f"conditions: {shown(condition)} is not known to this checker")
        step = integer(condition["step"], "conditions: step")
        row = self.RULES[rule](self, step) if 0 <= step < self.steps else None
        if row is None:
            raise NoProof(f"conditions: the schedule has no {rule} in step {step}")
        return row
