"""A proof over sums of waves as one over the paper's own rows."""
import math
from fractions import Fraction

from .certificate import check
from .limits import floor_of, strain_of
from .paper import carried, dd, dn
from .reading import NoProof
from .scene import Scene
from .sums import Sums, folded


class Rows:
    """The paper's rows of one schedule as functions of its 2N unknowns, and what was taken of them."""

    def __init__(self, cells, phases):
        self.cells = cells
        self.arrivals, self.places = [], []  # of each step of the cut period: p, (list, row)
        state = [(unknown, 1) for unknown in range(2 * cells)]
        pressed = flown = 0
        for contact, free in phases:
            cut = folded(cells, contact, free)
            for flow, steps, name, first in ((dd, cut[0], "pressure", pressed),
                                             (dn, cut[1], "penetration", flown)):
                for m in range(steps):
                    place, sign = flow(cells, m, cells)[0]
                    self.arrivals.append((state[place][0], sign * state[place][1]))
                    self.places.append((name, first + m))
                state = carried(state, flow, steps)
            pressed, flown = pressed + contact, flown + free
        self.period = state
        self.total = [0] * (2 * cells)
        self.taken = {"pressure": {}, "penetration": {}, "landing": {}}

    def add(self, steps, factor):
        """factor times the sum of p over these steps."""
        for m in steps:
            unknown, sign = self.arrivals[m]
            self.total[unknown] += factor * sign

    def take(self, name, row, value):
        self.taken[name][row] = self.taken[name].get(row, 0) + value

    def wave(self, u):
        """p_u, u < 2N, as (unknown, sign): what is on its way to the tip at t = 0."""
        cells = self.cells
        return (cells - 1 - u, 1) if u < cells else (u, -1)

    def close(self):
        """Multipliers y of (30) that make the rows add up to 0. (W x - x)_i = s x_j - x_i, so
        y_j = s y_i + total_j; after one turn y is the same again, or its negative."""
        y = {}
        for first in range(2 * self.cells):
            if first in y:
                continue
            path, i = [first], first
            while self.period[i][0] != first:
                i = self.period[i][0]
                path.append(i)

            def turn(value, path=path):
                for i in path:
                    y[i] = value
                    j, sign = self.period[i]
                    value = sign * value + self.total[j]
                return value

            defect = turn(Fraction(0))
            if defect and turn(defect / 2) != defect / 2:
                raise NoProof("the sums do not cancel on ker(W - 1)")
        return y


def lifted(answer):
    """The certificate over the paper's rows."""
    check(answer)
    scene, certificate = Scene(answer), answer["certificate"]
    cells, phases = scene.cells, scene.phases
    if certificate["rows"] != "lumped" or certificate["kind"] != "farkas" or len(scene.where) > 1:
        raise NoProof("allowed: none, with rows \"lumped\" of one stop")
    if strain_of(certificate) is not None or floor_of(certificate) is not None:
        raise NoProof("allowed: without limits of strain or tip, which the paper's rows do not know")
    sums = Sums(cells, phases, scene.stops, scene.where)
    sums.inequalities()  # numbers their last steps
    rows = Rows(cells, phases)
    n, spans = len(rows.arrivals), list(sums.spans())
    gap = size = 0
    for row, value in certificate.get("equalities", []):
        if row == 0:  # (31) is minus this sum
            gap = -value
            for u in range(2 * cells):
                unknown, sign = rows.wave(u)
                rows.total[unknown] += value * sign
        elif row < len(phases):
            rows.take("landing", row - 1, value)
            rows.add(range(*spans[row - 1]), value)
        else:
            size = value
            rows.add([m for m in range(n) if sums.stop[m]], value)
    for row, value in certificate.get("inequalities", []):
        last = sums.last_steps[row]
        begin = max(begin for begin, _ in spans if begin <= last)
        rows.take(*rows.places[last], value)
        rows.add(range(begin, last + 1), value)
    # What is left of z in residues with contact: a row (10) takes it away.
    for residue in range(sums.classes):
        signs, _ = sums.cycle(residue)
        if signs is None:
            continue
        left = 0
        for u in range(2 * cells):
            if u % n % sums.classes == residue:
                unknown, sign = rows.wave(u)
                left += rows.total[unknown] * sign * signs[u % n]
        if left:
            step = next((m for m, sign in signs.items() if sums.stop[m] and sign * left > 0), None)
            if step is None:
                raise NoProof(f"residue {residue}: {left} z is left")
            rows.take(*rows.places[step], abs(left))
            rows.add([step], -abs(left))
    y = rows.close()
    common = math.gcd(gap, size, *(v for taken in rows.taken.values() for v in taken.values()))
    scale = Fraction(1, common or 1)
    scale *= max((Fraction(v * scale).denominator for v in y.values()), default=1)
    lists = {"periodicity": y, **rows.taken}
    return {"kind": "farkas", "verified": True, "rows": "paper", "gap": int(gap * scale),
            "size": int(size * scale),
            **{name: [[row, int(value * scale)] for row, value in sorted(taken.items()) if value]
               for name, taken in lists.items()}}
