"""A bound below the energy of all motions of bars in a row: by stepping backwards in time, as floor.py does for one.

The law of docs/theory.md, section 20, is written down here once more, in fractions: at a node with branches of
impedances Z_k and a dashpot D waves w_k arrive, v = 2 sum Z_k w_k/(sum Z_k + D), and v - w_k leaves. Closed gaps
join nodes, clamps and closed stops hold them. Springs and masses are lines of half a step's length, at the end
clamped and free; what enters comes back a step later, negated or not. Displacements are counted from the shape
under weight; that of a bar that nothing holds is an unknown of its own, which has to drop out."""
import collections
import math
from fractions import Fraction

from .reading import NoProof, integer, number, require_keys, shown, simplest
from .scene import listed, positive

Row = collections.namedtuple("Row", "cells impedance speed left right")
Contact = collections.namedtuple("Contact", "kind node gap")
WORDS = {"clamp": (), "free": (), "driven": (), "shaken": (), "cells": ("cells", "impedance", "speed"),
         "gap": ("gap",), "right stop": ("gap",), "left stop": ("gap",), "dash": ("impedance",),
         "spring": ("stiffness",), "mass": ("mass",), "force": ("force",)}


class Bars:
    """Rows of cells between nodes, contacts at nodes. Lengths in |G|/M, G the first gap that is not 0, M all
    cells; times in steps; impedances as the file has them."""

    def __init__(self, scene):
        require_keys(scene, "scene", ("length", "wave_speed", "axial_stiffness", "gravity", "parts"), ("young",))
        self.length, self.speed, self.stiffness = (
            Fraction(positive(scene, key, "scene")) for key in ("length", "wave_speed", "axial_stiffness"))
        self.rows, self.contacts, self.clamped, self.dashpots = [], [], [False], [Fraction(0)]
        self.stubs, self.forces, self.driven, self.shaken = [], [Fraction(0)], set(), set()
        self.bar_of, self.places, self.travel = [0], [Fraction(0)], Fraction(0)
        for part in listed(scene["parts"], "scene: parts"):
            self.read(part)
        self.cells = sum(row.cells for row in self.rows)
        gaps = [abs(contact.gap) for contact in self.contacts if contact.gap]
        if not self.rows or not self.contacts:
            raise NoProof("scene: allowed cells, and a contact")
        self.delta = (gaps[0] if gaps else self.length) / self.cells
        self.step = self.length / (self.speed * self.travel)
        force = self.stiffness / self.speed * self.delta / self.step
        self.forces = [value / force for value in self.forces]
        stiffness = force / self.delta
        self.stubs = [(-1, node, value / 2 / stiffness) if kind == "spring" else
                      (1, node, 2 * value / self.step ** 2 / stiffness) for kind, node, value in self.stubs]
        self.gaps = [contact.gap / self.delta for contact in self.contacts]
        self.places = [place * self.length / self.travel for place in self.places]
        self.branches = [[] for _ in self.clamped]  # channels 2 row + 0 to the right, 2 row + 1 to the left
        for k, row in enumerate(self.rows):
            self.branches[row.right].append(2 * k)
            self.branches[row.left].append(2 * k + 1)
        for k, (_, node, _) in enumerate(self.stubs):
            self.branches[node].append(2 * len(self.rows) + k)
        self.drifting = [bar for bar in range(self.bar_of[-1] + 1) if self.reference(bar)[0] == "drift"]
        self.gravity = Fraction(number(scene["gravity"], "scene: gravity")) * self.step ** 2 / self.delta
        self.rest = [Fraction(0)] * len(self.clamped)  # of the nodes, under weight
        self.lean(self.gravity)
        if any(self.clamped[contact.node] for contact in self.contacts if contact.kind != "gap"):
            raise NoProof("scene: a stop at a clamp")

    def read(self, part):
        """One word."""
        kind = part.get("kind") if isinstance(part, dict) else None
        if not isinstance(kind, str) or kind not in WORDS:
            raise NoProof(f"scene: {shown(part)} is not known to this checker")
        require_keys(part, "scene: parts", ("kind", *WORDS[kind]))
        node = len(self.clamped) - 1
        if kind == "clamp":
            self.clamped[node] = True
        elif kind in ("driven", "shaken"):
            getattr(self, kind).add(node)
        elif kind == "dash":
            self.dashpots[node] += simplest(positive(part, "impedance", "scene: dash"))
        elif kind in ("spring", "mass"):
            self.stubs.append((kind, node, Fraction(positive(part, WORDS[kind][0], "scene"))))
        elif kind == "force":
            self.forces[node] += Fraction(number(part["force"], "scene: force"))
        elif kind == "cells":
            if not integer(part["cells"], "scene: cells") >= 1:
                raise NoProof("scene: allowed cells above 0")
            speed = Fraction(positive(part, "speed", "scene"))
            self.rows.append(Row(part["cells"], simplest(positive(part, "impedance", "scene")), speed, node, node + 1))
            self.travel += part["cells"] * speed
            self.add_node(self.bar_of[-1])
        elif kind in ("gap", "right stop", "left stop"):
            size = number(part["gap"], "scene: gap")
            self.contacts.append(Contact(kind, node, simplest(size) if size >= 0 else -simplest(-size)))
            if kind == "gap":
                self.add_node(self.bar_of[-1] + 1)

    def add_node(self, bar):
        """Behind the others."""
        self.clamped.append(False)
        self.dashpots.append(Fraction(0))
        self.forces.append(Fraction(0))
        self.bar_of.append(bar)
        self.places.append(self.travel)

    def nodes_of(self, bar):
        """Of one bar, from the left."""
        return [node for node, its in enumerate(self.bar_of) if its == bar]

    def impedance(self, channel):
        """Of the row or stub it belongs to."""
        rows = len(self.rows)
        return self.rows[channel // 2].impedance if channel < 2 * rows else self.stubs[channel - 2 * rows][2]

    def between(self, one, two):
        """Rows between two nodes of a bar."""
        return [k for k, row in enumerate(self.rows) if one <= row.left and row.right <= two]

    def reference(self, bar):
        """What displacements of a bar are counted from: a clamp, else a spring, else its first node."""
        nodes = self.nodes_of(bar)
        springs = [k for k, (sign, node, _) in enumerate(self.stubs) if sign < 0 and node in nodes]
        for node in nodes:
            if self.clamped[node]:
                return "clamp", node, None
        return ("spring", self.stubs[springs[0]][1], springs[0]) if springs else ("drift", nodes[0], None)

    def form(self, node):
        """{row: sign} of the sums of l - r that are the displacement of a node, and -1 of a spring's wave."""
        _, origin, spring = self.reference(self.bar_of[node])
        rows = self.between(min(origin, node), max(origin, node))
        found = {row: 1 if origin < node else -1 for row in rows}
        return found if spring is None else {**found, len(self.rows) + spring: -1}

    def distance(self, contact):
        """The same of a distance, less the gap."""
        total = collections.Counter()
        for node, sign in self.faces(contact):
            for row, factor in self.form(node).items():
                total[row] += sign * factor
        return total

    @staticmethod
    def faces(contact):
        """[(node, sign)] of the displacements in a distance."""
        signs = {"right stop": ((0, -1),), "left stop": ((0, 1),), "gap": ((0, -1), (1, 1))}
        return [(contact.node + offset, sign) for offset, sign in signs[contact.kind]]

    def ties(self):
        """Forms that are 0: displacements of clamps, and of springs' ends less what their waves say."""
        for node, is_clamped in enumerate(self.clamped):
            if is_clamped and self.reference(self.bar_of[node])[1] != node:
                yield self.form(node)
        for k, (sign, node, _) in enumerate(self.stubs):
            if sign < 0 and self.reference(self.bar_of[node])[2] != k:
                form = self.form(node)
                form[len(self.rows) + k] = form.get(len(self.rows) + k, 0) + 1
                yield form

    def ground(self, node, support=None):
        """Stiffness of what holds a node; None: a clamp."""
        if self.clamped[node] or node == support:
            return None
        return sum((2 * z for sign, at, z in self.stubs if sign < 0 and at == node), Fraction(0))

    def spring(self, right):
        """Stiffness of the row that ends at a node."""
        row = next(row for row in self.rows if row.right == right)
        return row.impedance / row.cells

    def shape(self, nodes, forces, support=None):
        """Displacements of a bar's nodes under forces, by elimination from the left."""
        found, stiffness, force = [], Fraction(0), Fraction(0)
        for node in nodes:
            row = self.spring(node) if node != nodes[0] else Fraction(0)
            below, load = (row, Fraction(0)) if stiffness is None else \
                (row * stiffness / (row + stiffness), force * row / (row + stiffness)) if row else (0, 0)
            ground = self.ground(node, support)
            stiffness = None if ground is None else ground + below
            force = forces[node] + load
            found.append((stiffness, force))
        moved, places = Fraction(0), {}
        for node, (stiffness, force) in zip(reversed(nodes), reversed(found)):
            row = self.spring(node + 1) if node != nodes[-1] else Fraction(0)
            moved = Fraction(0) if stiffness is None else (force + row * moved) / (stiffness + row)
            places[node] = moved
        return places

    def lean(self, gravity):
        """Gaps and forces as they are about the shape under weight."""
        if not gravity:
            return
        weights = [Fraction(0)] * len(self.clamped)
        for row in self.rows:
            for node in (row.left, row.right):
                weights[node] += row.impedance * row.cells * gravity / 2
        for sign, node, impedance in self.stubs:
            weights[node] += impedance * gravity / 2 if sign > 0 else 0
        rest = {}
        for bar in range(self.bar_of[-1] + 1):
            nodes, support = self.nodes_of(bar), None
            if bar in self.drifting:
                support = self.support(nodes, gravity > 0)
                self.forces[support] += sum(weights[node] for node in nodes)
            rest.update(self.shape(nodes, weights, support))
        self.rest = [rest[node] for node in range(len(self.clamped))]
        self.gaps = [gap + sum(sign * rest[node] for node, sign in self.faces(contact))
                     for gap, contact in zip(self.gaps, self.contacts)]

    def support(self, nodes, is_right):
        """The node of a bar that nothing holds at which its weight meets a contact, or its last that way."""
        for contact in self.contacts:
            is_gap = contact.kind == "gap"
            node = contact.node + (is_gap and not is_right)
            if (is_gap or (contact.kind == "right stop") == is_right) and node in nodes:
                return node
        return nodes[-1 if is_right else 0]

    def softness(self, node):
        """Displacement by force; None where nothing holds the bar."""
        nodes = self.nodes_of(self.bar_of[node])
        if self.bar_of[node] in self.drifting:
            return None
        return self.shape(nodes, [Fraction(k == node) for k in range(len(self.clamped))])[node]

    def unit(self):
        """E_1, with which contact 1 is reached at least, in Z_1 delta^2/h; and the compliance [m/N]."""
        parts = [self.softness(node) for node, _ in self.faces(self.contacts[0])]
        if None in parts:
            return None, None
        return self.gaps[0] ** 2 / (2 * sum(parts)), sum(parts) * self.step * self.speed / self.stiffness

    def natural(self, steps):
        """An energy that does not need E_1, in the same units: no motion is asked for with 10^9 times it."""
        force = sum(map(abs, self.forces))
        return max(Fraction(self.cells), (force * steps) ** 2 / self.cells)

    def joules(self):
        """Z_1 delta^2/h."""
        return self.stiffness / self.speed * self.delta ** 2 / self.step


class Law:
    """What a set of closed contacts makes of arriving waves."""

    def __init__(self, bars, closed):
        self.bars, self.weights, self.pushes, self.velocities = bars, {}, {}, {}
        nodes, self.clusters = len(bars.clamped), []
        joined = {bars.contacts[j].node for j in closed if bars.contacts[j].kind == "gap"}
        first = 0
        for node in range(nodes):
            if node not in joined:
                self.add(range(first, node + 1), closed)
                first = node + 1

    def add(self, nodes, closed):
        """Nodes that move as one."""
        bars = self.bars
        stops = {bars.contacts[j].node: j for j in closed if bars.contacts[j].kind != "gap"}
        held = [node for node in nodes if bars.clamped[node] or node in stops]
        if len(held) > 1:
            raise NoProof("schedule: what is held twice has pushes that waves do not tell")
        channels = [channel for node in nodes for channel in bars.branches[node]]
        total = sum(map(bars.impedance, channels)) + sum(bars.dashpots[node] for node in nodes)
        if not channels or (not held and not total):
            raise NoProof("scene: a node without cells")
        velocity = {c: Fraction(0) if held else 2 * bars.impedance(c) / total for c in channels}
        self.weights.update(velocity)
        made = {None: sum(bars.forces[node] for node in nodes) / total, "force": len(bars.driven & {*nodes}) / total} \
            if not held else {"base": Fraction(held[0] in bars.shaken)}
        velocity.update(made)
        self.clusters.append((channels, made))
        self.velocities.update((node, velocity) for node in nodes)
        self.find_pushes(nodes, held[0] if held else nodes[-1], velocity, closed, stops)

    def force(self, node, velocity):
        """2 sum Z w + f - (sum Z + D) v: what neighbours have to balance. Under None what is constant, under "force"
        and "base" by the force on what is driven, and by the velocity of the base."""
        bars = self.bars
        total = sum(map(bars.impedance, bars.branches[node])) + bars.dashpots[node]
        form = collections.Counter({c: -total * weight for c, weight in velocity.items()})
        form[None] += bars.forces[node]
        form["force"] += node in bars.driven
        for channel in bars.branches[node]:
            form[channel] += 2 * bars.impedance(channel)
        return form

    def find_pushes(self, nodes, turn, velocity, closed, stops):
        """Forms {channel: factor} of the pushes of closed contacts, from both sides towards `turn`."""
        gaps = {self.bars.contacts[j].node: j for j in closed if self.bars.contacts[j].kind == "gap"}
        left, right = collections.Counter(), collections.Counter()
        for node in range(nodes[0], turn):
            add(left, self.force(node, velocity), 1)
            self.pushes[gaps[node]] = dict(left)
        for node in range(nodes[-1], turn, -1):
            add(right, self.force(node, velocity), -1)
            self.pushes[gaps[node - 1]] = dict(right)
        if turn in stops:
            rest = self.force(turn, velocity)
            add(rest, left, 1)
            add(rest, right, -1)
            sign = 1 if self.bars.contacts[stops[turn]].kind == "right stop" else -1
            self.pushes[stops[turn]] = {c: sign * factor for c, factor in rest.items()}


def add(target, source, factor):
    """A multiple of a form."""
    for key, value in source.items():
        target[key] += factor * value


class Backwards:
    """Derivatives by the waves of each row and of each stub, whole numbers of UNIT."""

    def __init__(self, bars, y):
        self.bars, self.lines, at = bars, [], 0
        for row in bars.rows:
            for _ in range(2):
                self.lines.append(collections.deque(y[at:at + row.cells]))
                at += row.cells
        self.lines += [collections.deque([value]) for value in y[at:]]
        # What constant forces make, and by what drives the bars, in a step.
        self.made = collections.Counter()

    def entry(self, entered, channel):
        """By what leaves along a branch: into the other line of its row, or back from a stub."""
        stub = channel - 2 * len(self.bars.rows)
        return entered[channel ^ 1] if stub < 0 else self.bars.stubs[stub][0] * entered[channel]

    def step(self, law):
        """The transpose of a step, rounded down."""
        # What arrives in channel 2 row + 0 leaves, scattered, into the line of 2 row + 1 at its right end.
        entered = [line.popleft() if k % 2 == 0 else line.pop() for k, line in enumerate(self.lines)]
        self.made.clear()
        for channels, made in law.clusters:
            total = sum(self.entry(entered, channel) for channel in channels)
            add(self.made, made, total)
            for channel in channels:
                weight = law.weights[channel]
                value = weight.numerator * total // weight.denominator - self.entry(entered, channel)
                if channel % 2 == 0:
                    self.lines[channel].append(value)
                else:
                    self.lines[channel].appendleft(value)

    def add(self, form, value):
        """A multiple of a form of the waves that arrive; each is rounded down."""
        for channel, factor in form.items():
            if channel in (None, "force", "base"):
                self.made[channel] += factor * value
            else:
                self.lines[channel][-1 if channel % 2 == 0 else 0] += math.floor(factor * value)

    def place(self, form, value):
        """Of a distance, sums of l - r and waves of springs."""
        for row, sign in form.items():
            stub = row - len(self.bars.rows)
            for channel, turn in (((2 * row, -1), (2 * row + 1, 1)) if stub < 0 else
                                  ((2 * len(self.bars.rows) + stub, 1),)):
                self.lines[channel] = collections.deque(x + turn * sign * value for x in self.lines[channel])

    def waves(self):
        """All of them, as they were given."""
        return [x for line in self.lines for x in line]
