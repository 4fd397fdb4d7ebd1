"""What is read from untrusted files: JSON, integers, fractions, multipliers."""
import json
import re
import reprlib
import sys
from fractions import Fraction

UNUSABLE = (OSError, ValueError, MemoryError)  # no answer at all: usage error, exit status 2
MOST_TEXT = 10 ** 8  # characters
MOST_BITS = 10 ** 9  # of denominators, added up over all sums


class NoProof(Exception):
    """The numbers prove nothing; says why."""


def each_once(pairs):
    """An object of the file. Of a key that is there twice two readers take two values."""
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError("a key is there twice")
    return found


def read(file):
    """The JSON of an untrusted file."""
    text = file.read(MOST_TEXT + 1)
    if len(text) > MOST_TEXT:
        raise ValueError(f"longer than {MOST_TEXT} characters")
    try:
        return json.loads(text, object_pairs_hook=each_once)
    except RecursionError:
        raise ValueError("nested too deeply") from None


def shown(value):
    """A value of the file, shortened."""
    return reprlib.repr(value)


def told(value):
    """A fraction for people: as it is if that is short, else rounded."""
    value = Fraction(value)
    if max(abs(value.numerator), value.denominator) < 10 ** 9:
        return str(value)
    try:
        return f"{float(value)!r}"
    except OverflowError:
        return f"{'-' * (value < 0)}2^{value.numerator.bit_length() - value.denominator.bit_length()}, about"


class Total:
    """A sum of untrusted fractions, whose common denominator may grow with every one."""

    def __init__(self, value=0):
        self.value, self.spent = value, 0

    def add(self, value):
        """One more."""
        self.value += value
        self.spent += self.value.denominator.bit_length()
        if self.spent > MOST_BITS:
            raise NoProof("multipliers: their common denominator is too long for this checker")


def require_keys(found, what, needed, allowed=()):
    """An object with all of these keys, perhaps some of the others, and none that nobody reads: whatever
    that says would seem proved."""
    if not isinstance(found, dict):
        raise NoProof(f"{what}: {shown(found)} is no object")
    for key in needed:
        if key not in found:
            raise NoProof(f"{what}: {key} is missing")
    for key in found:
        if key not in needed and key not in allowed:
            raise NoProof(f"{what}: {shown(key)} is not known to this checker")
    return found


def integer(value, what):
    """An integer of the file. JSON's true is none."""
    if type(value) is not int:
        raise NoProof(f"{what}: {shown(value)} is not an integer")
    return value


def is_number(value):
    """A finite number of the file. JSON's true is none."""
    return type(value) in (int, float) and abs(value) <= sys.float_info.max


def number(value, what):
    """Such a number as a double."""
    if not is_number(value):
        raise NoProof(f"{what}: {shown(value)} is no number")
    return float(value)


def multiplier(value, what):
    """An integer of the file, or "p/q"."""
    if not isinstance(value, str):
        return integer(value, what)
    if not re.fullmatch("-?[0-9]+(/0*[1-9][0-9]*)?", value):
        raise NoProof(f"{what}: {shown(value)} is no fraction")
    return Fraction(value)


def multipliers(certificate, name, rows, signed, read=integer):
    """The list `name` as pairs (row, value) of distinct rows."""
    listed = certificate.get(name, [])
    if not isinstance(listed, list):
        raise NoProof(f"{name}: not a list")
    pairs = {}
    for pair in listed:
        if not isinstance(pair, list) or len(pair) != 2:
            raise NoProof(f"{name}: {shown(pair)} is not a pair [row, multiplier]")
        row, value = integer(pair[0], name), read(pair[1], name)
        if not 0 <= row < rows or row in pairs:
            raise NoProof(f"{name}: row {row} is given twice or not in 0 .. {rows - 1}")
        if not signed and value < 0:
            raise NoProof(f"{name}: row {row} has the negative multiplier {value}")
        pairs[row] = value
    return list(pairs.items())


def simplest(value):
    """The simplest fraction that is this number when it is rounded to a double."""
    if value == 0:
        return Fraction(0)
    if not is_number(value):
        raise NoProof("a ratio of two numbers is too large")
    before, last = (0, 1), (1, 0)
    above, below = value.as_integer_ratio()

    def at(k):
        return before[0] + k * last[0], before[1] + k * last[1]

    def rounds(k):
        return at(k)[1] > 0 and at(k)[0] / at(k)[1] == value

    while not rounds(above // below):
        before, last = last, at(above // below)
        above, below = below, above % below
    low, high = 0, above // below
    while low + 1 < high:
        middle = (low + high) // 2
        low, high = (low, middle) if rounds(middle) else (middle, high)
    return Fraction(*at(high))


def close(value, exact, tolerance=Fraction(1, 10 ** 12)):
    """Is a number of the file this fraction, rounded a few times?"""
    return is_number(value) and abs(Fraction(value) - exact) <= exact * tolerance
