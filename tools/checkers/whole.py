"""Vectors of whole numbers over a common denominator."""
import functools
import math
import operator
from fractions import Fraction


def reduced(whole, denominator):
    """A vector of fractions as whole numbers over one denominator, in lowest terms."""
    divisor = functools.reduce(math.gcd, whole, denominator)
    return [a // divisor for a in whole], denominator // divisor


def combination(terms, size):
    """The sum of factor times vector."""
    common = 1
    for _, (_, denominator) in terms:
        common *= denominator // math.gcd(common, denominator)
    total = [0] * size
    for factor, (whole, denominator) in terms:
        factor *= common // denominator
        total = [a + factor * b for a, b in zip(total, whole)]
    return reduced(total, common)


def dot(left, right):
    return sum(map(operator.mul, left, right))


def null_space(rows, size):
    """What all rows of whole numbers send to 0: a basis, each by the unknown that is free in it."""
    def less(row, pivot, at):
        mixed = [a * pivot[at] - row[at] * b for a, b in zip(row, pivot)]
        return reduced(mixed, 0)[0] if any(mixed) else mixed

    pivots = {}
    for row in rows:
        for at, pivot in pivots.items():
            if row[at]:
                row = less(row, pivot, at)
        first = next((i for i, a in enumerate(row) if a), None)
        if first is not None:
            pivots = {at: less(pivot, row, first) if pivot[first] else pivot
                      for at, pivot in pivots.items()}
            pivots[first] = row
    basis = {}
    for free in set(range(size)) - set(pivots):
        vector = [Fraction(int(i == free)) for i in range(size)]
        for at, pivot in pivots.items():
            vector[at] = Fraction(-pivot[free], pivot[at])
        common = math.prod({a.denominator for a in vector})
        basis[free] = reduced([int(a * common) for a in vector], 0)[0]
    return basis


def rank(vectors):
    """How many of them are independent."""
    rows, count = [list(map(Fraction, vector)) for vector in vectors], 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((row for row in rows[count:] if row[column]), None)
        if pivot:
            at = next(i for i in range(count, len(rows)) if rows[i] is pivot)
            rows[count], rows[at] = rows[at], rows[count]
            for i in range(count + 1, len(rows)):
                if rows[i][column]:
                    factor = rows[i][column] / pivot[column]
                    rows[i] = [a - factor * b for a, b in zip(rows[i], pivot)]
            count += 1
    return count
