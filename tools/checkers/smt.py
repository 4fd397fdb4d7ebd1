"""The paper's rows of a schedule as text in SMT-LIB, for solvers that know nothing of our proofs."""
from fractions import Fraction

from .certificate import check
from .energies import Energies
from .paper import carried, dd, dn
from .reading import NoProof, require_keys, told
from .scene import ASKED, Scene
from .sums import Sums

MOST_WORK = 4 * 10 ** 6  # coefficients


def rows_of(cells, phases, sign):
    """Rows (name, coefficients of a_1 .. a_N, b_1 .. b_N, "=" or "<=" or "<", right side) of (30)-(32), as
    docs/certificates.md numbers them; those that repeat others are left out."""
    size = 2 * cells
    if (size + sum(min(contact, size) + min(free, 2 * size) for contact, free in phases)) * size > MOST_WORK:
        raise NoProof(f"cells, schedule: allowed {MOST_WORK} coefficients")
    yield "gap", [-1] * cells + [1] * cells, "=", sign * cells
    state, pressed, flown, arrived = [(unknown, 1) for unknown in range(size)], 0, 0, [0] * size
    for k, (contact, free) in enumerate(phases):
        for m in range(contact if contact < size else size + contact % size):
            unknown, factor = state[dd(cells, m, cells)[0][0]]
            factor *= dd(cells, m, cells)[0][1]
            arrived[unknown] += factor
            if m < size:
                yield f"pressure_{pressed + m}", [-factor * (i == unknown) for i in range(size)], "<=", 0
        state, way = carried(state, dd, contact), [0] * size
        rest = free if free < 2 * size else 2 * size + free % (2 * size)  # over 4N steps the way is 0
        for m in range(rest):
            unknown, factor = state[dn(cells, m, cells)[0][0]]
            way[unknown] += factor * dn(cells, m, cells)[0][1]
            if m < 2 * size:
                yield f"penetration_{flown + m}", list(way), "<=", 0
        if k < len(phases) - 1:
            yield f"landing_{k}", list(way), "=", 0
        state, pressed, flown = carried(state, dn, free), pressed + contact, flown + free
    for row, (unknown, factor) in enumerate(state):
        left = [0] * size
        left[unknown] += factor
        left[row] -= 1
        yield f"periodicity_{row}", left, "=", 0
    if not sign:
        yield "size", arrived, "=", cells


def shallowest(scene, certificate):
    """x* of a bound of energy: x* . x >= x* . x* for all motions x, so that none has less than x*. The point where
    the multipliers lead: sums S = d z of d equal waves z each."""
    sums = Sums(scene.cells, scene.phases, scene.stops, scene.where)
    n, cells = len(sums.stop), scene.cells
    point = Energies(sums).nearest(certificate)
    begins = sorted(sums.signs)
    waves = [Fraction(0)] * (2 * cells)
    for u in range(2 * cells):  # what arrives at the tip in step u: a_{N-u}, later -b_{u-N+1}
        residue = u % n % sums.classes
        first = max((begin for begin in begins if begin <= residue), default=None)
        if first is None or residue >= first + sums.widths[sums.live[first]]:
            continue
        run, signs = sums.live[first], sums.cycle(residue)[0]
        value = point[run] / sums.widths[run] * signs[u % n]
        value *= sums.signs[first][first]  # where z looks the other way
        waves[cells - 1 - u if u < cells else u] = value if u < cells else -value
    return waves


def number(value):
    """A fraction as SMT-LIB writes it."""
    value = Fraction(value)
    text = f"{abs(value.numerator)}.0"
    if value.denominator != 1:
        text = f"(/ {text} {value.denominator}.0)"
    return f"(- {text})" if value < 0 else text


def text_of(answer):
    """The lines of a file that nothing satisfies, if the answer is right."""
    require_keys(answer, "answer", ASKED, answer)  # the file says all that it claims
    scene, certificate, status = Scene(answer), answer["certificate"], answer["status"]
    if not isinstance(certificate, dict) or not scene.is_uniform() or len(scene.where) > 1 or \
            any(certificate.get(key) is not None for key in ("strain_limit", "tip_floor")):
        raise NoProof("allowed: one bar on one stop, without limits of strain or tip")
    cells, rows = scene.cells, list(rows_of(scene.cells, scene.phases, scene.where["right"]))
    lines = [f"; no periodic motion of {scene.text()}, free and undamped"]
    if (status, certificate.get("kind")) == ("found", "energy-range"):
        check(answer)
        nearest = shallowest(scene, certificate)
        squares = sum(value * value for value in nearest)
        lines += [f"; with E/E_1 = 2/N x . x < {told(Fraction(2, cells) * squares)}: by Cauchy and Schwarz",
                  "; it would have a . x < a . a, with the vector a of row nearest"]
        rows.append(("nearest", nearest, "<", squares))
    elif (status, certificate.get("kind")) != ("none", "farkas"):
        raise NoProof("allowed: none, or a motion with a proof of the least energy")
    names = [f"{letter}{i}" for letter in "ab" for i in range(1, cells + 1)]
    lines += ["(set-logic QF_LRA)", *(f"(declare-const {name} Real)" for name in names)]
    for name, left, relation, right in rows:
        terms = [f"(* {number(value)} {unknown})" for value, unknown in zip(left, names) if value]
        total = f"(+ {' '.join(terms)})" if len(terms) > 1 else terms[0] if terms else "0.0"
        lines.append(f"(assert (! ({relation} {total} {number(right)}) :named {name}))")
    return "\n".join([*lines, "(check-sat)", ""])
