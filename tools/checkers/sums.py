"""The rows of docs/certificates.md, "Sums": of several phases, two stops, limits."""
import math
from fractions import Fraction

from .limits import floor_of, strain_of, within
from .reading import NoProof, Total, integer, multipliers, told


def folded(cells, contact, free):
    """Contact repeats the state and its rows after 2N steps, flight after 4N."""
    def fold(steps, length):
        return steps if steps < length else length + steps % length
    return fold(contact, 2 * cells), fold(free, 4 * cells)


MOST_WORK = 10 ** 7


class Sums:
    """The rows of docs/certificates.md, "Sums", of one schedule: lists of integers, one for each
    live run, and a right side."""

    def __init__(self, cells, phases, stops, where, limits=(None, None)):
        strain, self.floor = limits
        self.largest = None if strain is None else strain / 2  # p: the strain at the clamp is -2 p
        steps = [folded(cells, *phase) for phase in phases]
        self.cells, self.where = cells, where
        self.stop = []  # of each step: what it touches, None in flight
        cuts = {0}
        self.ends = []  # of the flights
        for (contact, free), stop in zip(steps, stops):
            cuts.add(len(self.stop))
            self.stop += [stop] * contact
            cuts.add(len(self.stop))
            self.stop += [None] * free
            self.ends.append(len(self.stop))
        n = len(self.stop)
        self.classes = math.gcd(2 * cells, n)
        starts = sorted({cut % self.classes for cut in cuts})
        self.signs, self.live, self.pressing, self.widths, self.kernel = {}, {}, [], [], 0
        for first, end in zip(starts, starts[1:] + [self.classes]):
            signs, mayPress = self.pattern(first, end - first)
            if signs:
                self.live[first] = len(self.pressing)
                self.signs[first] = signs
                self.pressing.append(mayPress)
                self.widths.append(end - first)
        if n // self.classes * len(self.pressing) ** 2 > MOST_WORK:
            raise NoProof(f"schedule: {n} steps of {len(self.pressing)} sums are too many for this checker")
        self.flights = list(zip(stops, stops[1:] + stops[:1]))

    def cycle(self, first):
        """p_m / p_first in the steps of the class of `first`, nothing if only 0 is possible, and the
        signs of z that pushing the stops asks for. (30) says p_{m + 2N} = p_m after contact, -p_m
        after flight."""
        n, signs, m, sign = len(self.stop), {}, first, 1
        while m not in signs:
            signs[m] = sign
            sign = sign if self.stop[m] else -sign
            m = (m + 2 * self.cells) % n
        if sign != 1:
            return None, set()
        return signs, {sign * (1 if self.stop[m] == "right" else -1)
                       for m, sign in signs.items() if self.stop[m]}

    def pattern(self, first, width):
        """p_m / z in the steps of the class of `first`, and whether z >= 0 is asked for. Nothing where
        only z = 0 is possible."""
        signs, pushes = self.cycle(first)
        if signs is None:
            return None, False
        self.kernel += width
        if len(pushes) == 2:
            return None, False
        if pushes == {-1}:
            signs = {m: -sign for m, sign in signs.items()}
        return signs, bool(pushes)

    def row(self, steps, factor):
        """factor times the sum of p over these steps, which hold runs whole: by their first."""
        coefficients = [0] * len(self.pressing)
        for m in steps:
            run = m % self.classes
            if run in self.live:
                coefficients[self.live[run]] += factor * self.signs[run][m]
        return coefficients

    def bound(self, value):
        """A sum of p that is `value`, as integers: factor, right side."""
        value = Fraction(value)
        return value.denominator, value.numerator

    def equalities(self):
        """The gap row, closures of all flights but the last, and the row of size, if there is one."""
        n, cells = len(self.stop), self.cells
        factor, right = self.bound(-cells * self.where[self.flights[0][0]])
        rows = [(self.row([m % n for m in range(2 * cells)], factor), right)]
        for (begin, end), (source, target) in list(zip(self.spans(), self.flights))[:-1]:
            factor, right = self.bound(Fraction(cells) / 2 * (self.where[target] - self.where[source]))
            rows.append((self.row(range(begin, end), factor), right))
        if self.where == {"right": 0}:
            rows.append((self.row([m for m in range(n) if self.stop[m]], 1), cells))
        return rows

    def bounds(self, point, wanted):
        """Least and largest partial sum of z in one run at these sums, so that no step of a flight
        leaves the stops."""
        low, high = [], []
        half = Fraction(self.cells) / 2
        for (begin, end), (source, _) in zip(self.spans(), self.flights):
            prefix = 0
            for m in range(begin, end):
                run = self.live.get(m % self.classes)
                if run is None:
                    continue
                sign = self.signs[m % self.classes][m]
                if run == wanted:
                    room = half * (self.where["right"] - self.where[source]) - prefix
                    (high if sign > 0 else low).append(sign * room)
                    if "left" in self.where:
                        room = half * (self.where["left"] - self.where[source]) - prefix
                        (low if sign > 0 else high).append(sign * room)
                prefix += sign * point[run]
        if not low or not high:
            raise NoProof("a run has no bounds")
        return max(low), min(high)

    def spans(self):
        """First step and end of each flight."""
        for end in self.ends:
            begin = end
            while self.stop[begin - 1] is None:
                begin -= 1
            yield begin, end

    def limits(self):
        """Least and largest sum of each live run, None where there is none: z >= 0 where it presses,
        and p = z or -z no larger than a limit of strain allows."""
        for first, run in self.live.items():
            most = None if self.largest is None else self.widths[run] * self.largest
            used = set(self.signs[first].values())
            yield (0 if self.pressing[run] else -most if most is not None and -1 in used else None,
                   most if 1 in used else None)

    def inequalities(self):
        """Prefix sums of p at the end of each live run in flight: below the wall, above the second
        stop, above a floor under the tip; each distinct row once, in the order of time."""
        rows, seen = [], set()
        self.last_steps = []  # of each row: that of its run

        def add(coefficients, right, last):
            if any(coefficients) and (tuple(coefficients), right) not in seen:
                seen.add((tuple(coefficients), right))
                rows.append((coefficients, right))
                self.last_steps.append(last)

        for (begin, end), (source, _) in zip(self.spans(), self.flights):
            half = Fraction(self.cells) / 2
            factor, most = self.bound(half * (self.where["right"] - self.where[source]))
            if "left" in self.where:
                below, least = self.bound(half * (self.where["left"] - self.where[source]))
            depth = None if self.floor is None else half * (self.where[source] - self.floor)
            prefix = [0] * len(self.pressing)
            for m in range(begin, end):
                run = m % self.classes
                if run in self.live:
                    prefix[self.live[run]] += self.signs[run][m]
                    last = m + self.widths[self.live[run]] - 1
                    add([factor * c for c in prefix], most, last)
                    if "left" in self.where:
                        add([-below * c for c in prefix], -least, last)
                    if depth is not None:
                        add([-c for c in prefix], depth, last)
        return rows


def combined(sums, certificate, read=integer):
    """The rows of the sums times their multipliers: coefficients, right side, and how many rows."""
    left, right, count = [0] * len(sums.pressing), Total(), 0
    for name, rows, signed in (("equalities", sums.equalities(), True),
                               ("inequalities", sums.inequalities(), False)):
        count += len(rows)
        for row, value in multipliers(certificate, name, len(rows), signed, read):
            left = [a + value * b for a, b in zip(left, rows[row][0])]
            right.add(value * rows[row][1])
    return left, right.value, count


def check_sums(scene, certificate):
    """sum of multipliers times rows on the left more, for all sums there can be, than on the right."""
    strain, floor = strain_of(certificate), floor_of(certificate)
    where = scene.reach() if strain is None and floor is None else scene.where
    sums = Sums(scene.cells, scene.phases, scene.stops, where, (strain, floor))
    left, right, count = combined(sums, certificate)
    for coefficient, (low, high) in zip(left, sums.limits()):
        end = low if coefficient > 0 else high
        if coefficient and end is None:
            raise NoProof(f"a sum without {'lower' if coefficient > 0 else 'upper'} bound has the coefficient "
                          f"{told(coefficient)}")
        right -= coefficient * end if coefficient else 0
    if right >= 0:
        raise NoProof(f"the right sides add up to {told(right)}, not below 0")
    return f"{count} rows of {len(sums.pressing)} sums contradict each other{within(strain, floor)}"
