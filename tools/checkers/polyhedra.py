"""Corners of polyhedra, in fractions."""
from fractions import Fraction

from .reading import NoProof

MOST_WORK = 10 ** 7  # pairs of rays, each compared with all


def corners(size, equalities, inequalities):
    """Corners and directions of {x: rows = right sides, rows <= right sides}, by the double
    description of the cone over it: (corners, rays, lines), all fractions."""
    def dot(row, v):
        return sum(a * b for a, b in zip(row, v))

    def less(v, factor, w):
        return [a - factor * b for a, b in zip(v, w)]

    cuts = [([0] * size + [1], False)]
    cuts += [([-c for c in row] + [right], True) for row, right in equalities]
    cuts += [([-c for c in row] + [right], False) for row, right in inequalities]
    lines = [[Fraction(int(i == j)) for j in range(size + 1)] for i in range(size + 1)]
    work, rays = 0, []  # (direction, numbers of the inequalities that hold as equalities)
    for number, (cut, is_equality) in enumerate(cuts):
        across = next((line for line in lines if dot(cut, line)), None)
        if across is not None:
            step = dot(cut, across)
            lines = [less(line, dot(cut, line) / step, across) for line in lines if line is not across]
            rays = [(less(ray, dot(cut, ray) / step, across), tight | {number}) for ray, tight in rays]
            if not is_equality:
                rays.append(([a / step for a in across], frozenset(range(number))))
            continue
        sides = [(dot(cut, ray), ray, tight) for ray, tight in rays]
        kept = [(ray, tight | {number} if not value else tight) for value, ray, tight in sides
                if not value or (value > 0 and not is_equality)]
        ups = sum(side > 0 for side, _, _ in sides)
        work += ups * sum(side < 0 for side, _, _ in sides) * len(rays) + size * len(rays)
        if work > MOST_WORK:
            raise NoProof("corners of too many sums: not known to this checker")
        for above, ray, tight in sides:
            for below, other, touched in sides:
                common = tight & touched
                if above > 0 > below and sum(common <= held for _, held in rays) == 2:
                    mixed = [above * b - below * a for a, b in zip(ray, other)]
                    scale = max(abs(a) for a in mixed)
                    kept.append(([a / scale for a in mixed], common | {number}))
        rays = kept
    points = [[a / ray[-1] for a in ray[:-1]] for ray, _ in rays if ray[-1]]
    return points, [ray[:-1] for ray, _ in rays if not ray[-1]], [line[:-1] for line in lines]
