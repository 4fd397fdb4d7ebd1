"""What an answer about bars in a row claims, and what the multipliers of its certificate prove (network.py)."""
import collections
import math
from fractions import Fraction

from .floor import HUGE, MOST_WORK
from .march import NEAR
from .network import Backwards, Bars, Law
from .reading import NoProof, close, integer, number, require_keys, shown, told
from .limits import strain_of
from .scene import listed, positive
from .strains import Strains, whole

SAID = ("schema", "version", "status", "scene", "reference", "cells", "schedule", "period", "period_ratio",
        "frequency_ratio", "kernel_dimension", "solution_set", "contacts", "contact", "energy",
        "energy_ratio", "energy_ratio_proved",
        "strains", "physical", "admissible", "residuals", "certificate", "route", "route_reason", "left_out", "solver",
        "detail")
NINE = Fraction(1, 10 ** 9)


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
        if not self.closed:
            raise NoProof("schedule: allowed some steps")

    def take(self, lists, limits):
        """The multipliers of a certificate, and the limit on strain of what says it."""
        self.y = [whole(value, "periodicity") for value in listed(lists["periodicity"], "periodicity")]
        waves = 2 * self.bars.cells + len(self.bars.stubs)
        if len(self.y) != waves + len(self.bars.drifting):
            raise NoProof(f"periodicity: no list of {waves + len(self.bars.drifting)} numbers")
        self.ways = self.y[waves:]
        self.y = self.y[:waves]
        self.places = self.read(lists, "places")
        self.pushes = self.read(lists, "pushes")
        self.limit = strain_of(limits)
        self.strains = Strains(lists, self.limit, [row.cells for row in self.bars.rows], len(self.closed))

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
        delta, norm = self.march(None)
        if not delta > 0:
            raise NoProof("the right sides do not ask for a motion other than rest")
        return (delta / norm) ** 2

    def march(self, drive):
        """(delta, the norm of eta, rounded upwards). `drive` is told what each step makes."""
        bars = self.bars
        laws = {closed: Law(bars, closed) for closed in set(self.closed)}
        distances = [bars.distance(contact) for contact in bars.contacts]
        march, rounded, constant, slack = Backwards(bars, self.y), 0, Fraction(0), Fraction(0)
        drifts = dict(zip(bars.drifting, self.ways))
        least_impedance = min([row.impedance for row in bars.rows] + [z for _, _, z in bars.stubs])
        pull = sum(map(abs, bars.forces)) / least_impedance
        for step in range(len(self.closed) - 1, -1, -1):
            law = laws[self.closed[step]]
            spoilt = rounded
            slack += spoilt * pull  # waves that rounding spoilt so far, times what forces add to them
            march.step(law)
            rounded += len(march.lines)
            for bar, value in drifts.items():
                form = law.velocities[bars.nodes_of(bar)[0]]
                march.add(form, value)
                rounded += len(form)
            for contact, value in self.pushes.get(step, ()):
                march.add(law.pushes[contact], value)
                rounded += len(law.pushes[contact])
            for row, side, value in self.strains.arrivals.get(step, ()):
                march.add({2 * row + (side == "left"): 1}, value)
            moved = 0  # by the place of the base
            for contact, value in self.places.get(step, ()):
                march.place(distances[contact], value)
                for node, sign in bars.faces(bars.contacts[contact]):
                    if bars.bar_of[node] in drifts:
                        drifts[bars.bar_of[node]] += sign * value
                    elif bars.reference(bars.bar_of[node])[1] in bars.shaken:
                        moved += sign * value
            constant += march.made[None]
            if drive:
                drive.add(step, march.made, moved, spoilt)
        if list(drifts.values()) != self.ways:
            raise NoProof("places: the displacement of a bar that nothing holds does not drop out")
        delta = -constant - slack - sum(value * bars.gaps[contact] for found in self.places.values()
                                        for contact, value in found)
        delta += sum(value * self.least_difference(*waves) for *waves, value in self.strains.all)
        eta = [x - y for x, y in zip(march.waves(), self.y)]
        square = self.norm_square(eta)
        # A wave rounded by less than a unit has a norm below 1/sqrt(Z), and no step makes it larger.
        norm = math.isqrt(math.ceil(square)) + 1 + rounded * (math.isqrt(math.ceil(1 / least_impedance)) + 1)
        return delta, norm

    def least_difference(self, row, right, left):
        """What the limit, less the shape under weight, asks of l - r where these waves meet."""
        bars, cells = self.bars, self.bars.rows[row].cells
        asked = -self.limit * bars.rows[row].speed * bars.speed * bars.step / bars.delta
        stretched = bars.rest[bars.rows[row].right] - bars.rest[bars.rows[row].left]
        # They meet on a whole cell, with weight at one of its ends.
        return asked - stretched / cells + max(
            bars.gravity * min(max(apart + end, -cells), cells) / 2
            for apart in self.strains.apart(row, right, left) for end in (-1, 1))

    def norm_square(self, eta):
        """sum eta^2/Z, less what ties take: they are 0 for every motion, so multiples of them may be added."""
        bars, sums, at, square = self.bars, [], 0, Fraction(0)
        for row in bars.rows:
            right, left = eta[at:at + row.cells], eta[at + row.cells:at + 2 * row.cells]
            square += sum(x * x for x in right + left) / row.impedance
            sums.append((Fraction(sum(left) - sum(right)) / row.impedance, 2 * row.cells / row.impedance))
            at += 2 * row.cells
        for value, (_, _, impedance) in zip(eta[at:], bars.stubs):
            square += value * value / impedance
            sums.append((value / impedance, 1 / impedance))
        left = []  # ties at right angles to those before
        for tie in bars.ties():
            along = sum((factor * sums[k][0] for k, factor in tie.items()), Fraction(0))
            for other, other_along, other_square in left:
                part = sum((factor * other.get(k, 0) * sums[k][1] for k, factor in tie.items()), Fraction(0))
                tie = {k: tie.get(k, 0) - part / other_square * other.get(k, 0) for k in {*tie, *other}}
                along -= part / other_square * other_along
            size = sum((factor ** 2 * sums[k][1] for k, factor in tie.items()), Fraction(0))
            if size:
                left.append((tie, along, size))
                square -= along ** 2 / size
        return square

    def require_derived(self, answer, unit, cycles=1):
        """What is said of scene and schedule has to follow from them."""
        bars = self.bars
        period = len(self.closed) * bars.step
        truth = [("cells", answer["cells"], Fraction(bars.cells)),
                 ("period", answer["period"], period),
                 ("period_ratio", answer["period_ratio"], period * bars.speed / bars.length)]
        reference = require_keys(answer["reference"], "reference", ("frequency", "damping", "energy", "compliance"))
        if reference["frequency"] is not None:
            first = Fraction(positive(reference, "frequency", "reference"))
            truth.append(("frequency_ratio", answer["frequency_ratio"], cycles / (period * first)))
        elif answer["frequency_ratio"] is not None:
            raise NoProof(f"frequency_ratio: {shown(answer['frequency_ratio'])}, but there is none")
        for name, value in (("energy", unit[0] and unit[0] * bars.joules()), ("compliance", unit[1])):
            if value:
                truth.append((f"reference: {name}", reference[name], value))
            elif reference[name] is not None:
                raise NoProof(f"reference: {name}: {shown(reference[name])}, but there is none")
        found = listed(answer["contacts"], "contacts")
        if len(found) != len(bars.contacts):
            raise NoProof("contacts: not those of the scene")
        for k, (one, contact) in enumerate(zip(found, bars.contacts), 1):
            require_keys(one, "contacts", ("number", "kind", "place", "gap"),
                         ("approach_speed", "peak_force", "impulse", "contact_time"))
            if one["kind"] != contact.kind:
                raise NoProof(f"contacts: {shown(one['kind'])} is not the kind of contact {k}")
            truth += [("contacts: number", one["number"], Fraction(k)),
                      ("contacts: place", one["place"], bars.places[contact.node]),
                      ("contacts: gap", one["gap"], bars.gaps[k - 1] * bars.delta)]
            if "contact_time" in one:
                truth.append(("contacts: contact_time", one["contact_time"],
                              sum(k - 1 in closed for closed in self.closed) * bars.step))
        for name, value, exact in truth:
            if not close(value if exact >= 0 else -number(value, name), abs(exact), NINE):
                raise NoProof(f"{name}: {shown(value)} does not follow from scene and schedule")


def spans(answer):
    """The schedule in words."""
    return " ".join(f"{'+'.join(map(str, span['closed'])) or '-'}:{span['steps']}" for span in answer["schedule"])


def check_scene(answer):
    """What an answer of `find --scene` proves, in a sentence. NoProof if it proves nothing."""
    require_keys(answer, "answer", SAID, ("reason",))
    claim = Claim(answer)
    certificate = require_keys(answer["certificate"], "certificate",
                               ("kind", "verified", "rows", "energy_ratio", "energy", "periodicity", "places",
                                "pushes"), ("strain_limit", "strains"))
    if (certificate["kind"], certificate["rows"]) != ("energy-floor", "network"):
        raise NoProof("certificate: allowed energy-floor over rows of a network")
    claim.take(certificate, certificate)
    unit = claim.bars.unit()
    claim.require_derived(answer, unit)
    key, size = ("energy_ratio", unit[0]) if unit[0] else ("energy", 1 / claim.bars.joules())
    least = claim.least() / size
    claimed = Fraction(number(answer["certificate"][key], key))
    is_found = answer["status"] == "found"
    if not (is_found or answer["status"] == "none"):
        raise NoProof(f"status: {shown(answer['status'])}: allowed found or none")
    is_held = "reason" in answer  # an energy below the least one: motions may exist
    if is_held and (is_found or answer["reason"] != "constraints"):
        raise NoProof(f"reason: {shown(answer['reason'])}: allowed constraints, where status is none")
    said = answer["solution_set"]
    is_empty = not (is_found or is_held or claim.strains.all)  # by the certificate, whatever limits strains
    if said is not None:
        require_keys(said, "solution_set", ("kind", "dimension"))
        if (said["kind"] == "empty") != is_empty or (is_empty and said["dimension"] is not None):
            raise NoProof(f"solution_set: {shown(said)} is not what is proved")
    huge = HUGE if unit[0] else HUGE * claim.bars.natural(len(claim.closed)) / size
    lowest = 0 if is_found or is_held else huge
    if not lowest * (1 - NINE) <= claimed <= least:
        raise NoProof(f"{key}: {shown(answer['certificate'][key])}: allowed {told(lowest)} to what is proved, "
                      f"{told(least)}")
    unproved = ("energy", "energy_ratio", "energy_ratio_proved", "strains", "physical", "admissible",
                "residuals")
    for key in () if is_found else unproved:
        if answer[key] is not None:
            raise NoProof(f"{key}: {shown(answer[key])} is not proved here")
    if is_found:
        for name in (key, *(("energy_ratio_proved",) if unit[0] else ())):
            if not close(answer[name], least, NEAR):
                raise NoProof(f"{name}: {shown(answer[name])} is not near {told(least)}, which is proved")
        joules = unit[0] and Fraction(number(answer["energy_ratio"], "energy_ratio")) * unit[0] * claim.bars.joules()
        if unit[0] and not close(answer["energy"], joules, NINE):
            raise NoProof(f"energy: {shown(answer['energy'])} is not energy_ratio in joules")
    count = sum(map(len, (*claim.places.values(), *claim.pushes.values()))) + len(claim.strains.all)
    words = f"{count} conditions and {len(claim.y)} waves, stepped backwards in time"
    besides = " (that a motion has this energy is not shown by this file)" if is_found else ""
    limit = "" if claim.limit is None else f" with strains >= -{float(claim.limit)!r}"
    return (f"no periodic motion of schedule {spans(answer)} of these bars{limit} below {float(claimed)!r} "
            f"{'E_1' if unit[0] else 'J'}: {words}{besides}; not checked: contact, detail, kernel_dimension, "
            f"{'' if is_empty else 'solution_set, '}route, route_reason, left_out, solver, "
            f"{'strains, physical, admissible, residuals, ' if is_found else ''}and the frequency and damping of "
            "reference, from which frequency_ratio follows")
