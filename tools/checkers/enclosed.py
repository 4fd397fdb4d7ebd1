"""Numbers enclosed between two of 60 digits, and pairs of them."""
import functools
from decimal import MAX_EMAX, MIN_EMIN, ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction

from .reading import NoProof

DIGITS = 60
DOWN, UP = (Context(prec=DIGITS, rounding=rounding, Emax=MAX_EMAX, Emin=MIN_EMIN)
            for rounding in (ROUND_FLOOR, ROUND_CEILING))


FINE = Context(prec=DIGITS + 20, Emax=MAX_EMAX, Emin=MIN_EMIN)  # of series
ERROR = Decimal(1).scaleb(-DIGITS)  # that series and all their roundings stay below


class Interval:
    """All numbers from `low` to `high`. No operation loses the true value."""
    __slots__ = ("low", "high")

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __add__(self, other):
        return Interval(DOWN.add(self.low, other.low), UP.add(self.high, other.high))

    def __neg__(self):
        return Interval(self.high.copy_negate(), self.low.copy_negate())

    def __sub__(self, other):
        return Interval(DOWN.subtract(self.low, other.high), UP.subtract(self.high, other.low))

    def __mul__(self, other):
        ends = [(x, y) for x in (self.low, self.high) for y in (other.low, other.high)]
        return Interval(min(DOWN.multiply(x, y) for x, y in ends),
                        max(UP.multiply(x, y) for x, y in ends))

    def __truediv__(self, other):
        if other.sign() == 0:
            raise NoProof(f"a divisor is 0 but for rounding to {DIGITS} digits")
        ends = [(x, y) for x in (self.low, self.high) for y in (other.low, other.high)]
        return Interval(min(DOWN.divide(x, y) for x, y in ends),
                        max(UP.divide(x, y) for x, y in ends))

    def root(self):
        """Of what is not negative in it. A square root is rounded to nearest: one place more."""
        low, high = DOWN.sqrt(max(self.low, Decimal(0))), UP.sqrt(max(self.high, Decimal(0)))
        return Interval(max(DOWN.next_minus(low), Decimal(0)), UP.next_plus(high))

    def sign(self):
        """1 or -1 of all its numbers, or 0."""
        return (self.low > 0) - (self.high < 0)

    def is_zero(self):
        """Is it 0, exactly?"""
        return self.low == 0 == self.high

    def size(self):
        """The largest |x| in it."""
        return max(self.low.copy_abs(), self.high.copy_abs())

    def middle(self):
        """One of its numbers, or next to it: exactly a number."""
        value = DOWN.divide(DOWN.add(self.low, self.high), Decimal(2))
        return Interval(value, value)


def enclosed(value):
    """An integer or a fraction."""
    value = Fraction(value)
    above, below = Decimal(value.numerator), Decimal(value.denominator)
    return Interval(DOWN.divide(above, below), UP.divide(above, below))


ZERO, ONE = enclosed(0), enclosed(1)


@functools.lru_cache(maxsize=None)
def circle():
    """pi, by Machin: arctan(1/x) is the sum of (-1)^k/((2k + 1) x^(2k + 1)), cut where terms are 0."""
    unit = 10 ** (DIGITS + 25)

    def arctan(x):
        power, k, total = unit // x, 0, 0
        while power:
            total += (-1) ** k * (power // (2 * k + 1))
            power, k = power // (x * x), k + 1
        return total

    return FINE.divide(Decimal(16 * arctan(5) - 4 * arctan(239)), Decimal(unit))


@functools.lru_cache(maxsize=None)
def turned(part, whole):
    """cos and sin of 2 pi part/whole, |part/whole| <= 1/2. Series of at most 100 terms below 4^k/k!,
    each with a few roundings in its 80th digit: far less than ERROR is lost."""
    angle = FINE.divide(FINE.multiply(circle(), Decimal(2 * part)), Decimal(whole))
    sums, term, k = [Decimal(1), Decimal(0)], Decimal(1), 0
    while term.copy_abs() > ERROR.scaleb(-10):
        k += 1
        term = FINE.divide(FINE.multiply(term, angle), Decimal(k))
        signed = term if k % 4 < 2 else term.copy_negate()
        sums[k % 2] = FINE.add(sums[k % 2], signed)
    return Vector(*(Interval(DOWN.subtract(x, ERROR), UP.add(x, ERROR)) for x in sums))


def harmonic(part, whole):
    """The same of any whole number of parts."""
    part %= whole
    return turned(part if 2 * part <= whole else part - whole, whole)


def decay(ratio):
    """exp(-pi ratio). The exponent is below 63, and known to 10^-70."""
    if not ratio:
        return ONE
    value = FINE.exp(FINE.multiply(circle(), Decimal(ratio)).copy_negate())
    return Interval(value, value) * Interval(DOWN.subtract(Decimal(1), ERROR), UP.add(Decimal(1), ERROR))


class Vector:
    """The factors of C and S, enclosed."""
    __slots__ = ("c", "s")

    def __init__(self, c, s):
        self.c, self.s = c, s

    def __add__(self, other):
        return Vector(self.c + other.c, self.s + other.s)

    def __neg__(self):
        return Vector(-self.c, -self.s)

    def __sub__(self, other):
        return Vector(self.c - other.c, self.s - other.s)

    def times(self, factor):
        """factor times it."""
        return Vector(factor * self.c, factor * self.s)

    def over(self, divisor):
        """It, over a number."""
        return Vector(self.c / divisor, self.s / divisor)

    def dot(self, other):
        """The scalar product."""
        return self.c * other.c + self.s * other.s

    def size(self):
        """At least its length, as a number."""
        most = UP.add(self.c.size(), self.s.size())
        return Interval(most, most)

    def cross(self, other):
        """The area that they span, positive if `other` is to the left."""
        return self.c * other.s - self.s * other.c


NOTHING = Vector(ZERO, ZERO)
