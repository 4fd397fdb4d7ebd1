#!/usr/bin/env python3
"""lrs (Avis) finds the vertices of our polytopes of two contacts, from rows written down here.

vertices_by_lrs.py PROGRAM [ORDER]

Between the grids: of each type in `modes --phases 2` up to ORDER (25) only its chains are read, and one inner
point, for the order of jumps; the conditions of docs/theory.md, section 18, follow from these. The vertices of lrs
are those of the answer. On grids: the paper's rows of every schedule with two contacts of small atlases; the largest
energy of a vertex, and the dimension that the vertices span, are those that `find` tells.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)
from checkers.smt import rows_of


def vertices(equalities, inequalities):
    """Vertices of the points where (1, x) . row is 0, or >= 0, by lrs in fractions; None if there are rays."""
    rows = equalities + inequalities
    lines = ["rows", "H-representation"]
    if equalities:
        lines.append(f"linearity {len(equalities)} {' '.join(str(k + 1) for k in range(len(equalities)))}")
    lines += ["begin", f"{len(rows)} {len(rows[0])} rational"]
    lines += [" ".join(str(Fraction(value)) for value in row) for row in rows] + ["end"]
    with tempfile.NamedTemporaryFile("w", suffix=".ine") as file:
        file.write("\n".join(lines) + "\n")
        file.flush()
        output = subprocess.run(["lrs", file.name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                check=True).stdout
    found = set()
    if "begin" not in output:
        return found  # no point at all
    for line in output.split("begin")[1].split("end")[0].split("\n")[2:]:
        words = [Fraction(word) for word in line.split()]
        if words and words[0] == 0:
            return None
        if words:
            found.add(tuple(words[1:]))
    return found


def plus(one, other, factor=1):
    """Of two linear forms."""
    return [a + factor * b for a, b in zip(one, other)]


def at(form, point):
    """Its value at a point."""
    return form[0] + sum(a * x for a, x in zip(form[1:], point))


def conditions(chains, inner):
    """(closures, inequalities) of a type with two contacts as forms in 1, T and s_2."""
    one, period = [1, 0, 0], [0, 1, 0]
    arrivals, releases, jumps = [[0, 0, 0], [0, 0, 1]], [None, None], []
    for begin, chain in zip(arrivals, chains):
        releases[chain["release"] - 1] = plus(plus(begin, one, 2 * chain["k"]), period, -chain["turns"])
        jumps += [plus(begin, one, 2 * j) for j in range(1, chain["k"])]

    def turned(form):
        return plus(form, period, -(at(form, inner) // inner[0]))
    points = [("arrival", form) for form in arrivals] + [("release", turned(form)) for form in releases]
    points += [("jump", turned(form)) for form in jumps]
    points.sort(key=lambda point: at(point[1], inner))
    inequalities = [plus(after[1], before[1], -1) for before, after in zip(points, points[1:])]
    inequalities.append(plus(period, points[-1][1], -1))
    closures, level, path, win, after_two = [], 1, [0, 0, 0], [0, 0, 0], turned([2, 0, 0])
    whole, flight = [0, 0, 0], False
    stretches = list(zip(points, [form for _, form in points[1:]] + [period]))
    for (kind, begin), end in stretches:
        if kind == "release":
            level, path, flight = -1, [0, 0, 0], True
        elif kind == "arrival":
            level, flight = 1, False
        else:
            level = -level
        length = plus(end, begin, -1)
        whole = plus(whole, length, level)
        if at(begin, inner) < at(after_two, inner):
            win = plus(win, length, level)
        if flight:
            path = plus(path, length, level)
            inequalities.append([-value for value in path])
            if (kind_after := next((k for k, form in points if form == end), "arrival")) == "arrival":
                closures.append(path)
            assert kind_after != "release"
    win = plus(win, whole, 2 // inner[0])
    return closures, inequalities + [[-value for value in win]]


def between_grids(program, order):
    """Compares every type."""
    words = [program, "modes", "--phases", "2", "--max-order", str(order), "--max-period", "8",
             "--max-energy-ratio", "1e6", "--format", "json", "--quiet"]
    answer = json.loads(subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout)
    count = corners = 0
    for polytope in answer["polytopes"]:
        ours = {tuple(Fraction(*pair) for pair in corner) for corner in polytope["vertices"]}
        inner = tuple(sum(values) / len(ours) for values in zip(*ours))
        theirs = vertices(*conditions(polytope["chains"], inner))
        if ours != theirs:
            sys.exit(f"{polytope['chains']}: lrs has {theirs}, the answer {ours}")
        count, corners = count + 1, corners + len(ours)
    print(f"{count} polytopes of two contacts between the grids, order <= {order}: lrs finds the same {corners} "
          "vertices")


def rank(rows):
    """Of fractions."""
    rows, found = [list(row) for row in rows], 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((row for row in rows[found:] if row[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        rows.insert(found, pivot)
        for row in rows[found + 1:]:
            if row[column]:
                row[:] = plus(row, pivot, -row[column] / pivot[column])
        found += 1
    return found


def on_grids(program):
    """Compares all schedules of two small atlases."""
    count = several = 0
    for cells, contact, free in ((2, 3, 8), (3, 4, 7)):
        for phases in ([[a, b], [c, d]] for a in range(1, contact + 1) for b in range(1, free + 1)
                       for c in range(1, contact + 1) for d in range(1, free + 1)):
            words = [program, "find", *(str(steps) for phase in phases for steps in phase), "--cells", str(cells),
                     "--format", "json", "--quiet"]
            answer = json.loads(subprocess.run(words, stdout=subprocess.PIPE, check=False).stdout)
            if answer["status"] != "found":
                continue
            rows = [([relation], [-right, *left]) for _, left, relation, right in rows_of(cells, phases, 1)]
            found = vertices([row for relation, row in rows if relation == ["="]],
                             [[-value for value in row] for relation, row in rows if relation == ["<="]])
            energy = max(sum(x * x for x in vertex) * Fraction(2, cells) for vertex in found)
            first = next(iter(found))
            dimension = rank([[x - y for x, y in zip(vertex, first)] for vertex in found])
            if abs(float(energy) / answer["energy_ratio_range"][1] - 1) > 1e-12 or \
                    dimension != answer["solution_set"]["dimension"]:
                sys.exit(f"{phases} on {cells} cells: lrs has {float(energy)} E_1, dimension {dimension}, the answer "
                         f"{answer['energy_ratio_range']}, {answer['solution_set']}")
            count, several = count + 1, several + (len(found) > 1)
    print(f"{count} schedules of two contacts, {several} with more than one motion: lrs has the same dimension and "
          "the same largest energy")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    between_grids(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 25)
    on_grids(sys.argv[1])


if __name__ == "__main__":
    main()
