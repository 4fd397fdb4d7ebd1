"""What multipliers say of the excitations of a damped bar of several segments: by stepping backwards in time.

As those of floor.py, with what drives the bar beside it: for every motion under C cos + S sin

    c C + s S + eta . x >= delta,     |eta . x| <= sqrt(sum eta^2/Z) sqrt(sum Z x^2),

so a motion of no more than HUGE times E_1 keeps C and S on one side of a line, but for that. At the tip a
dashpot sends back (Z - d)/(Z + d) of what arrives; that, cosines and what is made of them are enclosed
between numbers of 60 digits."""
import math
from decimal import Decimal
from fractions import Fraction

from .enclosed import NOTHING, ONE, Interval, Vector, decay, enclosed, harmonic
from .floor import HUGE, Backwards, Floor
from .reading import NoProof, require_keys

MOST_CUTS = 20
MOST_AMPLITUDE = 10 ** 9
FINE = 2 ** 180  # parts of what is known to 60 digits


class Damped(Backwards):
    """With what the tip sends back in flight, in whole parts."""

    def __init__(self, scene, joints, y, echo):
        super().__init__(scene, joints, y)
        self.echo = echo

    def step_back(self, is_held):
        """Returns what entered at the base and at the tip."""
        entered = self.right[0][0], self.left[-1][-1]
        self.step(0)
        self.right[-1][-1] = -entered[1] if is_held else (self.echo * entered[1]) // FINE
        return entered


class Cut(Floor):
    """One list of multipliers."""

    def __init__(self, question, multipliers):
        require_keys(multipliers, "cuts", ("periodicity", "places", "pushes"), ("strains",))
        self.question = question
        super().__init__(question.scene, multipliers, needs_gap=False,
                         strain=None if question.most_wave is None else 2 * question.most_wave)
        rho = decay(question.ratio)
        self.dashpot = (ONE - rho) / (ONE + rho)
        self.march()

    def reach(self):
        """1/(Z + d) at the tip."""
        return ONE / (enclosed(self.impedances[-1]) + self.dashpot)

    def cosine(self, part, whole):
        """(cos, sin) of the excitation's angle."""
        return harmonic(self.question.cycles * part, whole)

    def place(self, step):
        """Of the base when a step begins, in |g|/N."""
        return self.cosine(step, self.scene.steps).times(enclosed(self.scene.cells))

    def march(self):
        """The line, and the rest."""
        scene, steps, tip = self.scene, self.scene.steps, enclosed(self.impedances[-1])
        is_force = self.question.excited == "tip"
        echo = ((tip - self.dashpot) * self.reach()).middle().low
        march = Damped(scene, self.joints, self.periodicity, math.floor(Fraction(echo) * FINE))
        twice, line, rounded, size = 2 * self.impedances[-1], NOTHING, 0, self.norm(self.periodicity)
        whole = math.isqrt(math.ceil(sum(2 * s.cells / z for s, z in zip(scene.segments, self.impedances)))) + 1
        for step in range(steps - 1, -1, -1):
            base, entered = march.step_back(self.closed[step])
            # Joints and tip are rounded by a unit each; the echo is known to a part and 60 digits.
            rounded += 2 * len(self.joints) + 2 + 4 * size // FINE
            force = ONE if self.closed[step] is None else NOTHING.c
            driven = enclosed(entered) * self.reach() * force if is_force else enclosed(base)
            for side, value in self.pushes.get(step, ()):
                sign = 1 if side == "right" else -1
                march.push(math.floor(twice * value * sign))
                rounded, size = rounded + 1, size + math.ceil(twice * value) * self.coarse()
                driven += enclosed(sign * value) if is_force else NOTHING.c
            for row, side, value in self.strains.arrivals.get(step, ()):
                march.arrive(row, side, value)
                size += abs(value) * self.coarse()
            if is_force:
                line += self.cosine(2 * step + 1, 2 * steps).times(driven)
            else:
                line += (self.place(step + 1) - self.place(step)).times(driven)
            for side, value in self.places.get(step, ()):
                moved = -value if side == "right" else value
                march.place(moved)
                size += abs(value) * whole
                if not is_force:
                    line += self.place(step).times(enclosed(moved))
        rounded *= self.coarse()
        eta = [x - y for x, y in zip(march.waves(), self.periodicity)]
        self.rest = self.norm(eta) + rounded
        # What rounding does to all that was driven: waves at base and tip, times what drives them.
        error = Decimal(steps * rounded * self.coarse() * (2 if is_force else 8 * scene.cells))
        slack = Interval(error.copy_negate(), error)
        self.line = Vector(line.c + slack, line.s + slack)
        self.delta = self.right_side()

    def coarse(self):
        """At least sqrt(Z) and 1/sqrt(Z) of every segment."""
        most = max(*self.impedances, *(1 / z for z in self.impedances))
        return math.isqrt(math.ceil(most)) + 1

    def norm(self, waves):
        """sqrt(sum v^2/Z), rounded upwards."""
        square, at = Fraction(0), 0
        for segment, impedance in zip(self.scene.segments, self.impedances):
            square += sum(x * x for x in waves[at:at + 2 * segment.cells]) / impedance
            at += 2 * segment.cells
        return math.isqrt(math.ceil(square)) + 1

    def limit(self):
        """line . (C, S) is at least this."""
        return self.delta - self.rest * (math.isqrt(HUGE * self.scene.cells) + 1)

    def excludes(self, amplitude):
        """All of them up to this amplitude?"""
        limit = enclosed(self.limit())
        reach = self.line.dot(self.line) * enclosed(Fraction(amplitude) ** 2)
        return limit.sign() > 0 and (limit * limit - reach).sign() > 0


def leave_none(cuts, amplitude):
    """Do arcs of the circle of this amplitude have nothing in common? Each ends where some other is left."""
    if any(cut.excludes(amplitude) for cut in cuts):
        return True
    is_cut = False
    for cut in cuts:
        squares, limit = cut.line.dot(cut.line), enclosed(cut.limit())
        across = enclosed(Fraction(amplitude) ** 2) * squares - limit * limit
        if limit.sign() <= 0 and across.sign() < 0:
            continue
        if squares.sign() <= 0:
            return False
        is_cut, foot = True, cut.line.times(limit / squares)
        away = Vector(-cut.line.s, cut.line.c).times(across.root() / squares)
        for end in (foot + away, foot - away):
            if not any(other is not cut and (other.line.dot(end) - enclosed(other.limit())).sign() < 0
                       for other in cuts):
                return False
    return is_cut


def check_network(question, certificate):
    """Why there is no motion, in words; or NoProof."""
    require_keys(certificate, "certificate", ("kind", "rows", "cuts"), ("verified", "conditions"))
    listed = certificate["cuts"]
    if certificate["rows"] != "network" or not isinstance(listed, list) or not 1 <= len(listed) <= MOST_CUTS:
        raise NoProof(f"certificate: allowed rows of a network, 1 to {MOST_CUTS} cuts")
    cuts = [Cut(question, one) for one in listed]
    words = (f"{len(cuts)} sums of {len(cuts[0].periodicity)} waves and conditions, stepped backwards in time, "
             f"below {HUGE} E_1")
    if certificate["kind"] == "amplitude-range":
        if question.amplitude is None or not question.amplitude > 0:
            raise NoProof("amplitude: allowed above 0")
        shown = leave_none(cuts, question.amplitude)
    elif question.can_rest():
        words += " times the square of the amplitude"
        shown = all(cut.delta == 0 for cut in cuts) and leave_none(cuts, 1)
    else:
        words += f" and an amplitude of {MOST_AMPLITUDE}"
        shown = any(cut.excludes(MOST_AMPLITUDE) for cut in cuts)
    if not shown:
        raise NoProof("cuts: they leave an excitation")
    return words
