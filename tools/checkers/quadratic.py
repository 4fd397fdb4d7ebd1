"""The least of a positive definite form within conditions, in fractions, and why it is."""
from fractions import Fraction

from .whole import dot


def solved(matrix, right):
    """Solution of a regular system."""
    rows = [[*row, r] for row, r in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [a / rows[k][k] for a in rows[k]]
        for i, row in enumerate(rows):
            if i != k and row[k]:
                rows[i] = [a - row[k] * b for a, b in zip(row, rows[k])]
    return [row[-1] for row in rows]


def least_energy(energy, conditions):
    """The point of least energy that meets all conditions row x >= least, some of them equalities, by
    the dual method of Goldfarb and Idnani; None if there is none. Multipliers prove either."""
    size, point = len(energy), [Fraction(0)] * len(energy)
    active = []  # [row, least, is an equality, multiplier]

    def ways(row):
        """How to move so that row x grows and what is active stays, and what active multipliers lose."""
        matrix = [line + [other[0][i] for other in active] for i, line in enumerate(energy)]
        matrix += [other[0] + [Fraction(0)] * len(active) for other in active]
        found = solved(matrix, row + [Fraction(0)] * len(active))
        return found[:size], found[size:]

    while True:
        misses = [(not is_equality, dot(row, point) - least, row, least, is_equality)
                  for row, least, is_equality in conditions]
        missed = min((miss for miss in misses if miss[1] < 0 or (miss[4] and miss[1])),
                     key=lambda miss: miss[:2], default=None)
        if missed is None:
            require_least(energy, conditions, point, active)
            return point
        _, short, row, least, is_equality = missed
        if short > 0:
            short, row, least = -short, [-a for a in row], -least
        gained = Fraction(0)
        while short:
            move, losses = ways(row)
            rise = dot(row, move)
            limits = [(other[3] / loss, k) for k, (other, loss) in enumerate(zip(active, losses))
                      if not other[2] and loss > 0]
            if not rise and not limits:
                require_conflict([[row, least, is_equality, 1]] +
                                 [[*other[:3], -loss] for other, loss in zip(active, losses)])
                return None
            far, first = min(limits, default=(None, None))
            step = -short / rise if rise and (far is None or -short / rise <= far) else far
            point = [a + step * b for a, b in zip(point, move)]
            short += step * rise
            gained += step
            for other, loss in zip(active, losses):
                other[3] -= step * loss
            if short:
                active.pop(first)
        active.append([row, least, is_equality, gained])


def require_least(energy, conditions, point, active):
    """Karush, Kuhn and Tucker: no other point that meets the conditions has as little energy."""
    pull = [dot(line, point) for line in energy]
    for row, least, is_equality, value in active:
        if dot(row, point) != least or (value < 0 and not is_equality):
            raise ArithmeticError("no least energy")
        pull = [a - value * b for a, b in zip(pull, row)]
    if any(pull) or any(dot(row, point) < least or (is_equality and dot(row, point) != least)
                        for row, least, is_equality in conditions):
        raise ArithmeticError("no least energy")


def require_conflict(combined):
    """Conditions times multipliers say 0 >= something positive."""
    total = [sum(value * a for a, value in zip(column, [c[3] for c in combined]))
             for column in zip(*(c[0] for c in combined))]
    if any(total) or not sum(least * value for _, least, _, value in combined) > 0 or \
            any(value < 0 and not is_equality for _, _, is_equality, value in combined):
        raise ArithmeticError("no conflict")
