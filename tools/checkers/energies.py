"""The least and the most energy of all motions of a schedule of one bar."""
from fractions import Fraction

from .limits import strain_of, within
from .polyhedra import corners
from .reading import NoProof, close, multiplier, number, shown, told
from .sums import Sums, combined

MOST_PLACES = 10 ** 4  # times steps, in a walk with steps of limited length


class Energies:
    """E/E_1 of all motions of a schedule with a gap. p is z or -z in 2N/G of 2N steps, so it is
    2/N times 2N/G times the sum of z^2."""

    def __init__(self, sums):
        self.sums, self.unit = sums, Fraction(4, sums.classes)
        self.equalities, self.inequalities = sums.equalities(), sums.inequalities()
        signs = [([-int(i == k) for i in range(len(sums.pressing))], 0)
                 for k, may_press in enumerate(sums.pressing) if may_press]
        self.corners, rays, lines = corners(len(sums.pressing), self.equalities,
                                            self.inequalities + signs)
        self.ways = rays + lines  # to go on for ever
        self.is_bounded = not self.ways

    def holds(self, point):
        """Are these sums those of a motion of equal amplitudes?"""
        def at(row):
            return sum(a * b for a, b in zip(row, point))
        return (all(at(row) == right for row, right in self.equalities) and
                all(at(row) <= right for row, right in self.inequalities) and
                all(s >= 0 for s, may_press in zip(point, self.sums.pressing) if may_press))

    def nearest(self, certificate):
        """r S <= right < 0 for the rows r that the multipliers combine; S >= 0 lets positive r go. So
        right^2 <= (sum of d r^2) (sum of S^2/d), and the sum of z^2 over d residues is S^2/d or
        more. Equal only for S = right d r / sum of d r^2, if that is a motion: that S."""
        left, right, _ = combined(self.sums, certificate, multiplier)
        if right >= 0:
            raise NoProof(f"the right sides add up to {told(right)}, not below 0")
        left = [min(r, 0) if may_press else r for r, may_press in zip(left, self.sums.pressing)]
        squares = sum(d * r * r for d, r in zip(self.sums.widths, left))
        if not squares:
            raise NoProof("the multipliers prove that there is no motion")
        point = [Fraction(right * d * r, squares) for d, r in zip(self.sums.widths, left)]
        if not self.holds(point):
            raise NoProof("the multipliers lead to no motion: there may be a better bound")
        return point

    def least(self, certificate):
        """The sum of z^2 there."""
        return self.unit * sum(s * s / d for s, d in zip(self.nearest(certificate), self.sums.widths))

    def most(self):
        """The sum of z^2 is convex, so it is largest in a corner: nothing if there is no end to it."""
        if not self.is_bounded:
            return None
        best = 0
        for point in self.corners:
            squares = 0
            for k, sum_ in enumerate(point):
                width = self.sums.widths[k]
                squares += sum_ * sum_ if self.sums.pressing[k] or width == 1 else \
                    self.most_of_walk(point, k)
            best = max(best, squares)
        return self.unit * best

    def most_within(self, limit):
        """The same where no strain is below -limit, so no p above limit/2. If p = z in some step, z <= limit/2,
        and if p = -z in one, z >= -limit/2; z >= 0 needs the first alone, and has none of it in a run that
        only the second stop touches, p = -z always. Then |z| <= limit/2. Of several corners only what holds
        for all sums in between: the sum of z^2 is no more than limit/2 times the sum of |z|, which is S where
        z >= 0, else d limit/2 at most."""
        sums, largest = self.sums, limit / 2
        is_held = all(({1} if may_press else {1, -1}) <= set(sums.signs[first].values())
                      for first, may_press in zip(sums.live, sums.pressing))
        if not self.is_bounded or not is_held:
            return None
        if len(self.corners) == 1:
            return self.unit * self.most_of_steps(self.corners[0], largest)
        return self.unit * largest * max(
            sum(s if may_press else d * largest
                for s, may_press, d in zip(point, sums.pressing, sums.widths))
            for point in self.corners)

    def most_of_steps(self, point, largest):
        """The sum of z^2 with no |z| above `largest`, or 0 if some sum needs more: convex, so in a corner,
        where of a sum of z >= 0 all z but one are 0 or `largest`."""
        squares = 0
        for k, (sum_, width) in enumerate(zip(point, self.sums.widths)):
            if self.sums.pressing[k] or width == 1:
                full, rest = divmod(abs(sum_), largest)
                if full * largest + rest > width * largest:
                    return 0
                squares += full * largest ** 2 + rest ** 2
            else:
                squares += self.most_of_short_walk(point, k, largest)
        return squares

    def most_of_short_walk(self, point, k, largest):
        """As below, with no step longer than `largest`: between two places at a bound or an end all steps
        but one have that length."""
        low, high = self.sums.bounds(point, k)
        places = set()
        for anchor in (Fraction(0), Fraction(point[k]), low, high):
            first, last = -((anchor - low) // largest), (high - anchor) // largest
            if (last - first) * self.sums.widths[k] > MOST_PLACES:
                raise NoProof(f"a run of more than {MOST_PLACES} places is not known to this checker")
            places |= {anchor + n * largest for n in range(first, last + 1)}
        ways = {Fraction(0): 0}
        for _ in range(self.sums.widths[k]):
            longer = {}
            for place, most in ways.items():
                for end in places:
                    if abs(end - place) <= largest:
                        longer[end] = max(longer.get(end, 0), most + (end - place) ** 2)
            ways = longer
        return ways.get(point[k], 0)

    def most_of_walk(self, point, k):
        """z of any sign in one run: their partial sums Z walk from 0 to S between two bounds, and at
        most they jump between these."""
        if len(self.corners) > 1:
            raise NoProof("the bounds of a run depend on sums: not known to this checker")
        low, high = self.sums.bounds(point, k)
        ways = {Fraction(0): 0}  # places after some steps, with the most squares
        for _ in range(self.sums.widths[k] - 1):
            ways = {end: max(most + (end - place) ** 2 for place, most in ways.items())
                    for end in {low, high}}
        return max(most + (point[k] - place) ** 2 for place, most in ways.items())


def require_range(answer, energies):
    """The least and the most energy (None: not claimed), which the answer has to claim; in words."""
    least, most = energies.least(answer["certificate"]), None
    claimed = answer.get("energy_ratio_range")
    if not isinstance(claimed, list) or len(claimed) != 2 or not close(claimed[0], least):
        raise NoProof(f"energy_ratio_range: {shown(claimed)}, and the least is {told(least)}")
    what = f"E/E_1 >= {told(least)}, and there is a motion with that"
    if claimed[1] is not None:
        most = energies.most()
        if most is None or not close(claimed[1], most):
            raise NoProof(f"energy_ratio_range: {shown(claimed)}, and the most is "
                          f"{'without bound' if most is None else told(most)}")
        what += f", and <= {told(most)}"
    return least, most, what


def check_energies(scene, answer):
    """The least and the most energy, and that what the answer claims of them is so."""
    if not scene.where["right"]:
        raise NoProof("energies: without a gap every multiple of a motion is one")
    energies = Energies(Sums(scene.cells, scene.phases, scene.stops, scene.where))
    least, most, what = require_range(answer, energies)
    if answer["status"] == "none":
        return check_exclusion(energies, answer["certificate"], least, most, what)
    ratio, objective = answer.get("energy_ratio"), answer.get("objective")
    ends = {"min-energy": least, "max-energy": most}
    if not isinstance(objective, str) or objective not in ends:
        if ratio is not None or objective is not None:
            raise NoProof(f"objective, energy_ratio: allowed {', '.join(ends)}, and the energy of its motion; or "
                          "neither")
        return what
    end = ends[objective]
    if end is None or not close(ratio, end, Fraction(1, 10 ** 7)):
        raise NoProof(f"energy_ratio: {shown(ratio)} is not the end of that range")
    off = float(abs(Fraction(ratio) / end - 1))
    return f"{what}; the motion of {ratio!r} misses that end by {off:.1g} of it"


def check_exclusion(energies, certificate, least, most, what):
    """That no motion has an energy, perhaps within a limit of strain."""
    wanted = certificate.get("energy_ratio")
    ratio = Fraction(number(wanted, "energy_ratio"))
    if ratio <= 0:
        raise NoProof(f"energy_ratio: {wanted!r}: allowed numbers > 0")
    strain = strain_of(certificate)
    if strain is not None:
        highest = energies.most_within(strain)
        if highest is not None and ratio > highest:
            return f"{what}: none has {wanted!r}{within(strain, None)}"
    if ratio < least or (most is not None and ratio > most):
        return f"{what}: none has {wanted!r}"
    raise NoProof(f"{wanted!r} is an energy of motions: {what}")
