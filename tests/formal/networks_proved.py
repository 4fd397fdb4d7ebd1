#!/usr/bin/python3
"""The proved checker of networks says yes to multipliers found here, and its law is that of the program.

Bars, two bars that meet and bars that fork in two have motions where the paper's bar has (docs/theory.md, section 20,
and symmetry): `signorini find` says which. Random networks with dashpots, stops and gaps at any nodes, closed in
any pattern, have no such truth. The rows that `check-proved --networks` prints are eliminated in fractions; what
contradicts itself gives a certificate, which has to be accepted, and refused with one multiplier changed or
with all places negated.

    networks_proved.py [--program PATH] [--count N] [--seed S]
"""
import argparse
import collections
import heapq
import pathlib
import random
import subprocess
import sys
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]


# ---- networks: cells (left, right, impedance), nodes (clamped, dashpot), contacts, closed sets

def line_of(first, cells, impedance, nodes):
    """Cells in a row from the node `first`; the last node."""
    row = [(first, len(nodes), impedance)]
    nodes.append((0, 0))
    for _ in range(cells - 1):
        row.append((len(nodes) - 1, len(nodes), impedance))
        nodes.append((0, 0))
    return row, len(nodes) - 1


def bar(rng, cells):
    nodes = [(1, 0)]
    row, tip = line_of(0, cells, Fraction(rng.randint(1, 3)), nodes)
    return row, nodes, [(0, tip, 1)]


def meeting(rng, cells):
    """Two clamped bars with a gap between them."""
    nodes = [(1, 0)]
    row, face = line_of(0, cells, Fraction(1), nodes)
    nodes.append((0, 0))
    other, last = line_of(len(nodes) - 1, cells, Fraction(rng.randint(1, 9), 3), nodes)
    nodes[last] = (1, rng.randint(0, 2))
    return row + other, nodes, [(2, face, face + 1, 1)]


def fork(rng, cells):
    """A trunk with a free tip and two equal branches to clamps: together one bar."""
    trunk = rng.randint(1, cells - 1) if cells > 1 else 1
    branch = cells - trunk
    nodes = [(0, 0)]
    row, root = line_of(0, trunk, Fraction(1), nodes)
    for _ in range(2 if branch else 0):
        part, end = line_of(root, branch, Fraction(1, 2), nodes)
        nodes[end] = (1, 0)
        row += part
    if not branch:
        nodes[root] = (1, 0)
    return row, nodes, [(1, 0, -1)]


def anything(rng):
    count = rng.randint(2, 4)
    nodes = [(int(rng.random() < 0.3), rng.choice([0, 0, Fraction(1, 2)])) for _ in range(count)]
    cells = [(rng.randrange(i), i, Fraction(rng.randint(1, 4), 2)) for i in range(1, count) if rng.random() < 0.9]
    cells += [tuple(rng.sample(range(count), 2)) + (Fraction(1),)] * (rng.random() < 0.3)
    contacts = []
    for _ in range(rng.randint(1, 3)):
        place = Fraction(rng.randint(1, 4), 2)
        contacts.append(rng.choice([(0, rng.randrange(count), place), (1, rng.randrange(count), -place),
                                    (2, *rng.sample(range(count), 2), place)]))
    steps = [rng.randrange(2 ** len(contacts)) for _ in range(rng.randint(1, 6))]
    return (cells, nodes, contacts), steps


def in_words(network, steps):
    cells, nodes, contacts = network
    words = [len(cells), *(w for cell in cells for w in cell), len(nodes), *(w for node in nodes for w in node),
             len(contacts), *(w for contact in contacts for w in contact), len(steps), *steps]
    return " ".join(map(str, words))


def negated(network):
    cells, nodes, contacts = network
    return cells, nodes, [(*contact[:-1], -contact[-1]) for contact in contacts]


# ---- linear algebra in fractions: rows {unknown: factor}, constant, {tag: multiplier}

def add_to(target, factor, source):
    for key, value in source.items():
        value = target.get(key, 0) + factor * value
        if value:
            target[key] = value
        else:
            target.pop(key, None)


class Elimination:
    """Equations, each solved for one unknown; a later one may contain unknowns of earlier ones no more."""

    def __init__(self):
        self.age = {}     # unknown: when it was solved for
        self.solved = []  # (row, constant, combination)

    def reduced(self, row, constant, combination):
        row, combination = dict(row), dict(combination)
        due = [self.age[x] for x in row if x in self.age]
        heapq.heapify(due)
        while due:
            other, number, tags, unknown = self.solved[heapq.heappop(due)]
            if unknown not in row:
                continue
            factor = -row[unknown] / other[unknown]
            before = set(row)
            add_to(row, factor, other)
            add_to(combination, factor, tags)
            constant += factor * number
            for x in row.keys() - before:
                if x in self.age:
                    heapq.heappush(due, self.age[x])
        return row, constant, combination

    def add(self, row, constant, tag):
        """Multipliers that leave a number alone, if there are; else the row is kept."""
        row, constant, combination = self.reduced(row, constant, {tag: Fraction(1)})
        if not row:
            return {key: -value / constant for key, value in combination.items()} if constant else None
        unknown = max(row)
        self.age[unknown] = len(self.solved)
        self.solved.append((row, constant, combination, unknown))
        return None


def positive_combination(columns, constants):
    """mu >= 0 with sum of mu columns = 0 and sum of mu constants = -1: phase one of the simplex, by Bland's rule."""
    unknowns = sorted({x for column in columns for x in column})
    table = [[column.get(x, Fraction(0)) for column in columns] + [Fraction(0)] for x in unknowns]
    table.append([-c for c in constants] + [Fraction(1)])
    basis = [len(columns) + i for i in range(len(table))]
    while True:
        cost = [sum(row[j] for row, b in zip(table, basis) if b >= len(columns)) for j in range(len(columns) + 1)]
        if cost[-1] == 0:
            mu = [Fraction(0)] * len(columns)
            for row, b in zip(table, basis):
                if b < len(columns):
                    mu[b] = row[-1]
            return mu
        entering = next((j for j in range(len(columns)) if cost[j] > 0), None)
        if entering is None:
            return None
        _, _, i = min((row[-1] / row[entering], b, i)
                      for i, (row, b) in enumerate(zip(table, basis)) if row[entering] > 0)
        table[i] = [value / table[i][entering] for value in table[i]]
        for k, row in enumerate(table):
            if k != i and row[entering]:
                table[k] = [value - row[entering] * pivot for value, pivot in zip(row, table[i])]
        basis[i] = entering


def parsed(text):
    """Start rows, and of each step its lists of rows next, equation, inequality: (form, constant)."""
    start, steps = [], []
    for line in text.splitlines():
        words = line.split()
        if words == ["step"]:
            steps.append(collections.defaultdict(list))
            continue
        form = {}
        for i, c in zip(words[2::2], words[3::2]):
            add_to(form, Fraction(c), {int(i): Fraction(1)})
        (steps[-1][words[0]] if steps else start).append((form, Fraction(words[1])))
    return start, steps


def refuted(text, network):
    """A certificate that there is no motion, as lists of multipliers; nothing if there is one."""
    start, steps = parsed(text)
    size = 2 * len(network[0]) + len(network[1])
    width = size + len(network[1]) + len(network[2])

    def numbered(m, form):
        return {m * width + i: c for i, c in form.items()}

    known = Elimination()
    equations = [(numbered(0, form), c, ("start", i)) for i, (form, c) in enumerate(start)]
    for m, step in enumerate(steps):
        last = m + 1 == len(steps)
        for i, (form, c) in enumerate(step["equation"]):
            equations.append((numbered(m, form), c, ("equation", m, i)))
        for j, (form, c) in enumerate(step["next"]):
            row = numbered(m, form)
            add_to(row, Fraction(-1), {j if last else (m + 1) * width + j: Fraction(1)})
            equations.append((row, c, ("return", j) if last else ("link", m, j)))
    contradiction = None
    for row, c, tag in equations:
        contradiction = contradiction or known.add(row, c, tag)
    if contradiction is None:
        rows = [known.reduced(numbered(m, form), c, {("inequality", m, i): Fraction(1)})
                for m, step in enumerate(steps) for i, (form, c) in enumerate(step["inequality"])]
        mu = positive_combination([row for row, _, _ in rows], [c for _, c, _ in rows])
        if mu is None:
            return None
        contradiction = {}
        for factor, (_, _, combination) in zip(mu, rows):
            add_to(contradiction, factor, combination)

    def take(count, *tag):
        return [contradiction.get((*tag, i), 0) for i in range(count)]

    lists = [take(len(step[kind]), kind, m) for m, step in enumerate(steps) for kind in ("equation", "inequality")]
    return lists + [take(len(start), "start"), take(size, "return")]


def certificate_words(lists):
    return " ".join(str(w) for values in lists for w in [len(values), *values])


def altered(lists, rng):
    lists = [list(values) for values in lists]
    k, i = rng.choice([(k, i) for k, values in enumerate(lists) for i, value in enumerate(values) if value])
    lists[k][i] = rng.choice([-lists[k][i], lists[k][i] + 1, 0 * lists[k][i]])
    return lists


def asked(lines):
    done = subprocess.run([str(ROOT / "build/proofs/check-proved"), "--networks"], input="\n".join(lines) + "\n",
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"check-proved --networks: {done.stderr}")
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/signorini"))
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    questions = []
    for _ in range(options.count):
        kind = rng.choice([bar, meeting, fork, anything])
        if kind is anything:
            questions.append((kind.__name__, *anything(rng), None))
            continue
        cells, contact = rng.randint(1, 3), rng.randint(1, 5)
        free = rng.choice([rng.randint(1, 9), max(1, 4 * cells - 2 * contact)])
        done = subprocess.run([options.program, "find", str(contact), str(free), "--cells", str(cells), "--quiet"],
                              capture_output=True, check=False)
        if done.returncode > 1:
            raise SystemExit(f"signorini find {contact} {free} --cells {cells}: status {done.returncode}")
        questions.append((kind.__name__, kind(rng, cells), [1] * contact + [0] * free, done.returncode == 0))
    texts = asked([f"rows {in_words(network, steps)}" for _, network, steps, _ in questions]).split(".\n")
    lines, wanted, faults, counts = [], [], 0, collections.Counter()
    for (kind, network, steps, has_motion), text in zip(questions, texts):
        lists = refuted(text, network)
        counts[kind, "none" if lists else "motion"] += 1
        if has_motion is not None and has_motion != (lists is None):
            faults += 1
            print(f"{kind} {in_words(network, steps)}: the program says something else")
        if lists:
            for claimed, multipliers, verdict in [(network, lists, "proved"),
                                                  (network, altered(lists, rng), "no proof"),
                                                  (negated(network), lists, "no proof")]:
                lines.append(f"check {in_words(claimed, steps)} {certificate_words(multipliers)}")
                wanted.append(verdict)
    said = asked(lines).splitlines()
    for line, want, have in zip(lines, wanted, said):
        if want != have:
            faults += 1
            print(f"{have} instead of {want}: {line}")
    faults += len(said) != len(wanted)
    print(", ".join(f"{kind} {verdict} {number}" for (kind, verdict), number in sorted(counts.items())))
    print(f"{len(questions)} networks: {wanted.count('proved')} proofs, {wanted.count('no proof')} forgeries, "
          f"{faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
