#!/usr/bin/python3
"""The theorem on one contact phase, checked by an SMT solver for all real amplitudes.

Statement (docs/theory.md, sections 4-6): the states x = (a_1 .. a_N, b_1 .. b_N) that satisfy the
paper's (30), (31) and (32) for n_c contact and n_f free steps are exactly

    empty                          no class is live; or contact signs, prefix sums or win exclude it
    { z >= 0, sum z = -N/win }     some contact step is in a live class (a simplex)
    { -N <= Z_j <= 0, Z_d = -N }   none is (a box)

with p_{alpha G + j} = epsilon_alpha z_j on the live classes j and 0 on the others.

Left side: the rows are written down from the paper's (21)-(25), cell by cell, in integers; nothing
of the theorem is used. Right side: the theorem, from its integers G, nu, w, epsilon. For each
schedule Z3 decides in exact rational arithmetic whether any real x tells them apart.

All n_c < 4N and n_f < 8N are tried. That covers every schedule on these grids: (21)-(22) repeat
after 2N steps and (24)-(25) after 4N, so longer phases have the same W and repeat rows of (32).
"""
import argparse
import math
import sys

import z3


def dd(i, n, cells):
    """(a_i, b_i) after n steps of contact, (21) and (22): (index, sign) among the unknowns."""
    def r1(j):
        if j >= 1:
            return j - 1, 1
        if j >= 1 - cells:
            return cells + (1 - j) - 1, -1
        return j + 2 * cells - 1, 1

    def r2(j):
        if j <= cells:
            return cells + j - 1, 1
        if j <= 2 * cells:
            return (2 * cells + 1 - j) - 1, -1
        return cells + (j - 2 * cells) - 1, 1
    n %= 2 * cells
    return r1(i - n), r2(i + n)


def dn(i, n, cells):
    """(a_i, b_i) after n steps of free flight, (24) and (25)."""
    def r1(j):
        if j >= 1:
            return j - 1, 1
        if j >= 1 - cells:
            return cells + (1 - j) - 1, -1
        if j >= 1 - 2 * cells:
            return j + 2 * cells - 1, -1
        if j >= 1 - 3 * cells:
            return cells + (1 - 2 * cells - j) - 1, 1
        return j + 4 * cells - 1, 1

    def r2(j):
        if j <= cells:
            return cells + j - 1, 1
        if j <= 2 * cells:
            return (2 * cells + 1 - j) - 1, 1
        if j <= 3 * cells:
            return cells + (j - 2 * cells) - 1, -1
        if j <= 4 * cells:
            return (4 * cells + 1 - j) - 1, -1
        return cells + (j - 4 * cells) - 1, 1
    n %= 4 * cells
    return r1(i - n), r2(i + n)


def rows_of_the_paper(cells, contact, free, x):
    """(30), (31) and (32) as constraints on x."""
    def at(term, values):
        return values[term[0]] if term[1] > 0 else -values[term[0]]

    def after(flow, n, values):
        pairs = [flow(i, n, cells) for i in range(1, cells + 1)]
        return [at(a, values) for a, _ in pairs] + [at(b, values) for _, b in pairs]

    rows = []
    for m in range(contact):  # (10): s(L, t) = r2(L + ct) - r1(L - ct) in step m
        s = at(dd(cells, m + 1, cells)[1], x) - at(dd(cells, m, cells)[0], x)
        rows.append(s <= 0)
    start = after(dd, contact, x)
    fallen = 0
    for m in range(free):  # (12): the integral of v(L, t) = r1(L - ct) + r2(L + ct); (11): m = 0
        v = at(dn(cells, m, cells)[0], start) + at(dn(cells, m + 1, cells)[1], start)
        fallen = fallen + v
        rows.append(fallen <= 0)
    back = after(dn, free, start)
    rows += [end == begin for end, begin in zip(back, x)]  # (30)
    rows.append(z3.Sum(x[cells:]) - z3.Sum(x[:cells]) == cells)  # (31), times N/g
    return z3.And(rows)


def theorem(cells, contact, free, x):
    """The set of the theorem as a constraint on x."""
    n = contact + free
    classes = math.gcd(2 * cells, n)
    nu, w = n // classes, 2 * cells // classes
    q, r = divmod(contact, classes)
    # Classes j < r meet contact q + 1 times, the others q times; live: an even number of flights.
    live = [j for j in range(classes) if (nu - q - (1 if j < r else 0)) % 2 == 0]
    if not live:
        return z3.BoolVal(False)
    k = q + 1 if live[0] < r else q
    epsilon = [0] * nu
    epsilon[0], alpha = 1, 0
    for _ in range(nu - 1):
        epsilon[(alpha + w) % nu] = epsilon[alpha] * (1 if alpha < k else -1)
        alpha = (alpha + w) % nu
    win = sum(epsilon[alpha % nu] for alpha in range(w))
    p = [x[cells - 1 - m] if m < cells else -x[m] for m in range(2 * cells)]
    z = [p[j] for j in live]
    rows = []
    for m in range(2 * cells):
        alpha, j = divmod(m, classes)
        if j not in live:
            rows.append(p[m] == 0)
        elif alpha > 0:
            rows.append(p[m] == (p[j] if epsilon[alpha % nu] > 0 else -p[j]))
    if k == 0:
        partial = 0
        for amplitude in z:
            partial = partial + amplitude
            rows += [partial <= 0, partial >= -cells]
        rows.append(partial == -cells)
        return z3.And(rows)
    prefix, worst = 0, 0
    for alpha in range(k, nu):
        prefix += epsilon[alpha]
        worst = max(worst, prefix)
    if -1 in epsilon[:k] or worst > 0 or win >= 0:
        return z3.BoolVal(False)
    rows += [amplitude >= 0 for amplitude in z]
    rows.append(-win * z3.Sum(z) == cells)
    return z3.And(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--cells", type=int, default=4, help="all grids up to N cells (4)")
    most = parser.parse_args().cells
    solver = z3.Solver()
    for cells in range(1, most + 1):
        x = [z3.Real(f"a{i}") for i in range(1, cells + 1)]
        x += [z3.Real(f"b{i}") for i in range(1, cells + 1)]
        total = existing = 0
        for contact in range(1, 4 * cells):
            for free in range(1, 8 * cells):
                claimed = theorem(cells, contact, free, x)
                solver.push()
                solver.add(rows_of_the_paper(cells, contact, free, x) != claimed)
                verdict = solver.check()
                if verdict != z3.unsat:
                    print(f"N = {cells}, ({contact}, {free}): {verdict}, {solver.model()}")
                    return 1
                solver.pop()
                total += 1
                existing += not z3.is_false(claimed)
        print(f"N = {cells}: {total} schedules, {existing} with motions: the theorem holds for all "
              f"real amplitudes", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
