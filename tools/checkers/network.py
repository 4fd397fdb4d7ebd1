"""A bound below the energy of all motions of bars in a row: a march backwards, as floor.py has it for one bar.

The law of docs/theory.md, section 20, is written down here once more, in fractions: at a node with branches of
impedances Z_k and a dashpot D waves w_k arrive, v = 2 sum Z_k w_k/(sum Z_k + D), and v - w_k leaves. Closed gaps
join nodes, clamps and closed stops hold them. Springs, masses, constant forces and weight are not known here, nor
bars that drift."""
import collections
import math
from fractions import Fraction

from .floor import HUGE, MOST_WORK, whole
from .march import NEAR
from .reading import NoProof, close, integer, number, require_keys, shown, simplest, told
from .scene import listed, positive

Row = collections.namedtuple("Row", "cells impedance left right")
Contact = collections.namedtuple("Contact", "kind node gap")
WORDS = {"clamp": (), "free": (), "driven": (), "shaken": (), "cells": ("cells", "impedance", "speed"),
         "gap": ("gap",), "right stop": ("gap",), "left stop": ("gap",), "dash": ("impedance",)}
SAID = ("schema", "version", "status", "scene", "reference", "cells", "schedule", "period", "kernel_dimension",
        "contacts", "energy", "energy_ratio", "energy_ratio_proved", "residuals", "certificate", "detail")
NINE = Fraction(1, 10 ** 9)


class Bars:
    """Rows of cells between nodes, contacts at nodes. Lengths in |G|/M, G the first gap that is not 0, M all
    cells; times in steps; impedances as the file has them."""

    def __init__(self, scene):
        require_keys(scene, "scene", ("length", "wave_speed", "axial_stiffness", "gravity", "parts"), ("young",))
        self.length, self.speed, self.stiffness = (
            Fraction(positive(scene, key, "scene")) for key in ("length", "wave_speed", "axial_stiffness"))
        if number(scene["gravity"], "scene: gravity") != 0:
            raise NoProof("scene: bars under their weight are not known to this checker")
        self.rows, self.contacts, self.clamped, self.dashpots = [], [], [False], [Fraction(0)]
        self.bar_of, self.places, self.travel = [0], [Fraction(0)], Fraction(0)
        for part in listed(scene["parts"], "scene: parts"):
            self.read(part)
        self.cells = sum(row.cells for row in self.rows)
        gaps = [contact.gap for contact in self.contacts if contact.gap]
        if not self.rows or not gaps or not self.contacts[0].gap:
            raise NoProof("scene: allowed cells, and contacts of which the first has a gap other than 0")
        self.delta = abs(gaps[0]) / self.cells
        self.step = self.length / (self.speed * self.travel)
        self.places = [place * self.length / self.travel for place in self.places]
        self.branches = [[] for _ in self.clamped]  # channels 2 row + 0 to the right, 2 row + 1 to the left
        for k, row in enumerate(self.rows):
            self.branches[row.right].append(2 * k)
            self.branches[row.left].append(2 * k + 1)
        if any(not any(self.clamped[node] for node in self.nodes_of(bar)) for bar in range(self.bar_of[-1] + 1)):
            raise NoProof("scene: bars that nothing holds are not known to this checker")
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
        elif kind == "dash":
            self.dashpots[node] += simplest(positive(part, "impedance", "scene: dash"))
        elif kind == "cells":
            if not integer(part["cells"], "scene: cells") >= 1:
                raise NoProof("scene: allowed cells above 0")
            self.rows.append(Row(part["cells"], simplest(positive(part, "impedance", "scene")), node, node + 1))
            self.travel += part["cells"] * Fraction(positive(part, "speed", "scene"))
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
        self.bar_of.append(bar)
        self.places.append(self.travel)

    def nodes_of(self, bar):
        """Of one bar, from the left."""
        return [node for node, its in enumerate(self.bar_of) if its == bar]

    def impedance(self, channel):
        """Of the row it belongs to."""
        return self.rows[channel // 2].impedance

    def between(self, one, two):
        """Rows between two nodes of a bar."""
        return [k for k, row in enumerate(self.rows) if one <= row.left and row.right <= two]

    def form(self, node):
        """{row: sign} of the sums of l - r that are the displacement of a node."""
        clamp = next(k for k in self.nodes_of(self.bar_of[node]) if self.clamped[k])
        rows = self.between(min(clamp, node), max(clamp, node))
        return {row: 1 if clamp < node else -1 for row in rows}

    def distance(self, contact):
        """The same of a distance, less the gap."""
        total = collections.Counter()
        signs = {"right stop": ((0, -1),), "left stop": ((0, 1),), "gap": ((0, -1), (1, 1))}
        for offset, sign in signs[contact.kind]:
            for row, factor in self.form(contact.node + offset).items():
                total[row] += sign * factor
        return total

    def ties(self):
        """Rows between neighbouring clamps: their sums of l - r are 0."""
        for bar in range(self.bar_of[-1] + 1):
            clamps = [node for node in self.nodes_of(bar) if self.clamped[node]]
            yield from (self.between(*pair) for pair in zip(clamps, clamps[1:]))

    def softness(self, node):
        """Displacement by force, in steps over impedance; None where nothing holds that side."""
        nodes = self.nodes_of(self.bar_of[node])
        sides = [[k for k in nodes if self.clamped[k] and k <= node][-1:],
                 [k for k in nodes if self.clamped[k] and k >= node][:1]]
        stiffness = Fraction(0)
        for clamp in [side[0] for side in sides if side]:
            stiffness += 1 / sum(Fraction(self.rows[k].cells) / self.rows[k].impedance
                                 for k in self.between(min(clamp, node), max(clamp, node)))
        return 1 / stiffness

    def unit(self):
        """E_1, with which contact 1 is reached at least, in Z_1 delta^2/h; and the compliance [m/N]."""
        first = self.contacts[0]
        softness = self.softness(first.node) + (self.softness(first.node + 1) if first.kind == "gap" else 0)
        return ((first.gap / self.delta) ** 2 / (2 * softness),
                softness * self.step * self.speed / self.stiffness)


class Law:
    """What a set of closed contacts makes of arriving waves."""

    def __init__(self, bars, closed):
        self.bars, self.weights, self.pushes = bars, {}, {}
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
        self.clusters.append(channels)
        self.find_pushes(nodes, held[0] if held else nodes[-1], velocity, closed, stops)

    def force(self, node, velocity):
        """2 sum Z w - (sum Z + D) v: what neighbours have to balance."""
        bars = self.bars
        total = sum(map(bars.impedance, bars.branches[node])) + bars.dashpots[node]
        form = collections.Counter({c: -total * weight for c, weight in velocity.items()})
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
    """Derivatives by the waves of each row, whole numbers of UNIT."""

    def __init__(self, bars, y):
        self.bars, self.lines, at = bars, [], 0
        for row in bars.rows:
            for _ in range(2):
                self.lines.append(collections.deque(y[at:at + row.cells]))
                at += row.cells

    def step(self, law):
        """The transpose of a step, rounded down."""
        # What arrives in channel 2 row + 0 leaves, scattered, into the line of 2 row + 1 at its right end.
        entered = [line.popleft() if k % 2 == 0 else line.pop() for k, line in enumerate(self.lines)]
        for channels in law.clusters:
            total = sum(entered[channel ^ 1] for channel in channels)
            for channel in channels:
                weight = law.weights[channel]
                value = weight.numerator * total // weight.denominator - entered[channel ^ 1]
                if channel % 2 == 0:
                    self.lines[channel].append(value)
                else:
                    self.lines[channel].appendleft(value)

    def push(self, form, value):
        """Of a push, by the waves that arrive; each is rounded down."""
        for channel, factor in form.items():
            line = self.lines[channel]
            line[-1 if channel % 2 == 0 else 0] += math.floor(factor * value)

    def place(self, form, value):
        """Of a distance, sums of l - r."""
        for row, sign in form.items():
            for channel, turn in ((2 * row, -1), (2 * row + 1, 1)):
                self.lines[channel] = collections.deque(x + turn * sign * value for x in self.lines[channel])

    def waves(self):
        """All of them, as they were given."""
        return [x for line in self.lines for x in line]


class Claim:
    """A schedule, the multipliers of a certificate, and what they prove."""

    def __init__(self, answer):
        self.bars = Bars(answer["scene"])
        self.closed = []
        for span in listed(answer["schedule"], "schedule"):
            require_keys(span, "schedule", ("closed", "steps"))
            names = [integer(name, "schedule") for name in listed(span["closed"], "schedule: closed")]
            steps = integer(span["steps"], "schedule")
            if not all(1 <= name <= len(self.bars.contacts) for name in names) or steps < 1 or \
                    (len(self.closed) + steps) * 2 * len(self.bars.rows) > MOST_WORK:
                raise NoProof(f"schedule: allowed contacts of the scene, 1 step or more, {MOST_WORK} of them times "
                              "waves that arrive")
            self.closed += [frozenset(name - 1 for name in names)] * steps
        certificate = require_keys(answer["certificate"], "certificate",
                                   ("kind", "verified", "rows", "energy_ratio", "periodicity", "places", "pushes"))
        if (certificate["kind"], certificate["rows"]) != ("energy-floor", "network") or not self.closed:
            raise NoProof("certificate: allowed energy-floor over rows of a network, and some steps")
        self.y = [whole(value, "periodicity") for value in listed(certificate["periodicity"], "periodicity")]
        if len(self.y) != 2 * self.bars.cells:
            raise NoProof(f"periodicity: no list of {2 * self.bars.cells} numbers")
        self.places = self.read(certificate, "places")
        self.pushes = self.read(certificate, "pushes")

    def read(self, certificate, name):
        """{step: [(contact, multiplier)]} of [contact, step, multiplier]."""
        found, seen = collections.defaultdict(list), set()
        for entry in listed(certificate[name], name):
            if not isinstance(entry, list) or len(entry) != 3:
                raise NoProof(f"{name}: {shown(entry)} is not [contact, step, multiplier]")
            contact, step, value = integer(entry[0], name) - 1, integer(entry[1], name), whole(entry[2], name)
            if not 0 <= contact < len(self.bars.contacts) or not 0 <= step < len(self.closed) or \
                    (contact, step) in seen:
                raise NoProof(f"{name}: {shown(entry)} is there twice, or names no contact or step")
            seen.add((contact, step))
            # A distance is 0 beside a closed step and else >= 0; a push is >= 0, and there while closed.
            is_zero = contact in self.closed[step] or contact in self.closed[step - 1]
            if name == "pushes" and contact not in self.closed[step]:
                raise NoProof(f"pushes: in step {step} that contact is open")
            if value < 0 and (name == "pushes" or not is_zero):
                raise NoProof(f"{name}: a multiplier below 0 in step {step}")
            found[step].append((contact, value))
        if name == "places" and len(seen) * self.bars.cells > MOST_WORK:
            raise NoProof(f"places: this checker takes up to {MOST_WORK} cells times places")
        return found

    def least(self):
        """Every motion has this energy or more, in Z_1 delta^2/h."""
        bars = self.bars
        delta = -sum(value * bars.contacts[contact].gap / bars.delta
                     for found in self.places.values() for contact, value in found)
        if not delta > 0:
            raise NoProof("the right sides do not ask for a motion other than rest")
        laws = {closed: Law(bars, closed) for closed in set(self.closed)}
        distances = [bars.distance(contact) for contact in bars.contacts]
        march, rounded = Backwards(bars, self.y), 0
        for step in range(len(self.closed) - 1, -1, -1):
            law = laws[self.closed[step]]
            march.step(law)
            rounded += 2 * len(bars.rows)
            for contact, value in self.pushes.get(step, ()):
                march.push(law.pushes[contact], value)
                rounded += len(law.pushes[contact])
            for contact, value in self.places.get(step, ()):
                march.place(distances[contact], value)
        eta = [x - y for x, y in zip(march.waves(), self.y)]
        square = self.norm_square(eta)
        least_impedance = min(row.impedance for row in bars.rows)
        # A wave rounded by less than a unit has a norm below 1/sqrt(Z), and no step makes it larger.
        norm = math.isqrt(math.ceil(square)) + 1 + rounded * (math.isqrt(math.ceil(1 / least_impedance)) + 1)
        return (delta / norm) ** 2

    def norm_square(self, eta):
        """sum eta^2/Z, less what ties take: they are 0 for every motion, so multiples of them may be added."""
        lines, at = [], 0
        for row in self.bars.rows:
            lines.append((eta[at:at + row.cells], eta[at + row.cells:at + 2 * row.cells]))
            at += 2 * row.cells
        square = sum(Fraction(sum(x * x for line in pair for x in line)) / row.impedance
                     for pair, row in zip(lines, self.bars.rows))
        for rows in self.bars.ties():
            along = sum(Fraction(sum(lines[k][1]) - sum(lines[k][0])) / self.bars.rows[k].impedance for k in rows)
            square -= along ** 2 / sum(2 * self.bars.rows[k].cells / self.bars.rows[k].impedance for k in rows)
        return square

    def require_derived(self, answer, unit):
        """What is said of scene and schedule has to follow from them."""
        bars = self.bars
        compliance = unit[1]
        energy = bars.contacts[0].gap ** 2 / (2 * compliance)
        truth = [("cells", answer["cells"], Fraction(bars.cells)),
                 ("period", answer["period"], len(self.closed) * bars.step)]
        reference = require_keys(answer["reference"], "reference", ("frequency", "damping", "energy", "compliance"))
        truth += [("reference: energy", reference["energy"], energy),
                  ("reference: compliance", reference["compliance"], compliance)]
        found = listed(answer["contacts"], "contacts")
        if len(found) != len(bars.contacts):
            raise NoProof("contacts: not those of the scene")
        for k, (one, contact) in enumerate(zip(found, bars.contacts), 1):
            require_keys(one, "contacts", ("number", "kind", "place", "gap"), ("peak_force", "impulse", "contact_time"))
            if one["kind"] != contact.kind:
                raise NoProof(f"contacts: {shown(one['kind'])} is not the kind of contact {k}")
            truth += [("contacts: number", one["number"], Fraction(k)),
                      ("contacts: place", one["place"], bars.places[contact.node]),
                      ("contacts: gap", one["gap"], contact.gap)]
            if "contact_time" in one:
                truth.append(("contacts: contact_time", one["contact_time"],
                              sum(k - 1 in closed for closed in self.closed) * bars.step))
        for name, value, exact in truth:
            if not close(value if exact >= 0 else -number(value, name), abs(exact), NINE):
                raise NoProof(f"{name}: {shown(value)} does not follow from scene and schedule")


def check_scene(answer):
    """What an answer of `find --scene` proves, in a sentence. NoProof if it proves nothing."""
    require_keys(answer, "answer", SAID)
    claim = Claim(answer)
    unit = claim.bars.unit()
    claim.require_derived(answer, unit)
    least = claim.least() / unit[0]
    claimed = Fraction(number(answer["certificate"]["energy_ratio"], "energy_ratio"))
    is_found = answer["status"] == "found"
    if not (is_found or answer["status"] == "none"):
        raise NoProof(f"status: {shown(answer['status'])}: allowed found or none")
    if not (0 if is_found else HUGE) <= claimed <= least:
        raise NoProof(f"energy_ratio: {shown(answer['certificate']['energy_ratio'])}: allowed "
                      f"{0 if is_found else HUGE} to what is proved, {told(least)}")
    unproved = ("energy", "energy_ratio", "energy_ratio_proved", "residuals")
    for key in () if is_found else unproved:
        if answer[key] is not None:
            raise NoProof(f"{key}: {shown(answer[key])} is not proved here")
    if is_found:
        for key in ("energy_ratio", "energy_ratio_proved"):
            if not close(answer[key], least, NEAR):
                raise NoProof(f"{key}: {shown(answer[key])} is not near {told(least)}, which is proved")
        joules = Fraction(number(answer["energy_ratio"], "energy_ratio")) * claim.bars.contacts[0].gap ** 2 / (
            2 * unit[1])
        if not close(answer["energy"], joules, NINE):
            raise NoProof(f"energy: {shown(answer['energy'])} is not energy_ratio in joules")
    count = sum(map(len, claim.places.values())) + sum(map(len, claim.pushes.values()))
    words = f"{count} conditions and {len(claim.y)} waves, marched backwards"
    spans = " ".join(f"{'+'.join(map(str, span['closed'])) or '-'}:{span['steps']}" for span in answer["schedule"])
    besides = " (that a motion has this energy is not shown by this file)" if is_found else ""
    return (f"no periodic motion of schedule {spans} of these bars below {float(claimed)!r} E_1: {words}{besides}; "
            "nothing is said of detail, kernel_dimension, and of the frequency and damping of reference")
