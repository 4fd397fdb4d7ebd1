"""Multipliers of a limit on strain: l - r is no less than the limit allows where two waves pass each other.

Waves of a row of N cells that arrive at its right end in step p and at its left end in step q pass each other if
|p - q| <= N, or if some periods more or less make it so."""
import collections
import math
from fractions import Fraction

from .march import UNIT
from .reading import NoProof, integer, number, shown


def whole(value, what):
    """A double in units, rounded down."""
    return math.floor(Fraction(number(value, what)) * UNIT)


class Strains:
    """Entries [row, step on the right, step on the left, multiplier], rows from 1, of rows of so many cells."""

    def __init__(self, certificate, limit, rows, steps):
        self.all, self.arrivals, self.rows, self.steps = [], collections.defaultdict(list), rows, steps
        entries = certificate.get("strains", [])
        if not isinstance(entries, list) or (entries and limit is None):
            raise NoProof("strains: allowed a list, together with strain_limit")
        for entry in entries:
            if not isinstance(entry, list) or len(entry) != 4:
                raise NoProof(f"strains: {shown(entry)} is not [row, step, step, multiplier]")
            row, right, left = (integer(value, "strains") for value in entry[:3])
            value = whole(entry[3], "strains")
            if not 1 <= row <= len(rows) or not (0 <= right < steps and 0 <= left < steps) or value < 0:
                raise NoProof(f"strains: {shown(entry)} names no row or step, or has a multiplier below 0")
            if not self.apart(row - 1, right, left):
                raise NoProof(f"strains: {shown(entry)}: these waves do not meet")
            self.all.append((row - 1, right, left, value))
            self.arrivals[right].append((row - 1, "right", -value))
            self.arrivals[left].append((row - 1, "left", value))

    def apart(self, row, right, left):
        """[q - p] with which they meet: the place where they do, twice the cells to the right of the middle."""
        cells = self.rows[row]
        first = (left - right + cells) % self.steps - cells
        return range(first, cells + 1, self.steps)
