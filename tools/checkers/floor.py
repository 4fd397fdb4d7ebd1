"""A bound below the energy of all motions of a bar of several segments: by stepping backwards in time.

Multipliers y of W x - x, of distances and of pushes add up to eta . x - delta >= 0 for every motion x, so
its energy sum Z x^2 is delta^2/(sum eta^2/Z) or more, whatever was rounded in finding them. They are taken
for whole numbers of 2^-400, rounded down (what is >= 0 stays so), and marched back through the period. At a
joint results are rounded down. A joint takes no energy from outside, so neither does the transposed step
from sum v^2/Z: what rounding adds never grows, and all of it is added to the norm of eta."""
import collections
import math
from fractions import Fraction

from .limits import floor_of, strain_of, within
from .march import NEAR, March
from .reading import NoProof, close, integer, number, shown, told
from .segments import impedances_of, joints_of
from .strains import Strains, whole

MOST_WORK = 10 ** 7  # steps times segments, and waves times places
HUGE = 10 ** 9  # E/E_1 that no bar bears


class Backwards:
    """Derivatives by the waves of each segment, in the order of its cells."""

    def __init__(self, scene, joints, y):
        self.scene, self.joints = scene, joints
        self.right, self.left, at = [], [], 0
        for segment in scene.segments:
            middle, end = at + segment.cells, at + 2 * segment.cells
            self.right.append(collections.deque(y[at:middle]))
            self.left.append(collections.deque(y[middle:end]))
            at = end

    def step(self, echo):
        """The transpose of a step in which the tip sends back `echo` times what arrives."""
        into_right = [line.popleft() for line in self.right]
        into_left = [line.pop() for line in self.left]
        self.left[0].appendleft(-into_right[0])
        for j, (one, two, both) in enumerate(self.joints):
            met = into_left[j] + into_right[j + 1]
            self.right[j].append((2 * one * met) // both - into_left[j])
            self.left[j + 1].appendleft((2 * two * met) // both - into_right[j + 1])
        self.right[-1].append(echo * into_left[-1])

    def push(self, value):
        """Of the wave that reaches the tip."""
        self.right[-1][-1] += value

    def arrive(self, segment, side, value):
        """Of the wave that reaches an end of a segment."""
        if side == "right":
            self.right[segment][-1] += value
        else:
            self.left[segment][0] += value

    def place(self, value):
        """Of u(L) = sum of b - a over all cells, in units of |g|/N."""
        self.right = [collections.deque(x - value for x in line) for line in self.right]
        self.left = [collections.deque(x + value for x in line) for line in self.left]

    def waves(self):
        """All of them, as they were given."""
        return [x for one, two in zip(self.right, self.left) for x in (*one, *two)]


class Floor:
    """The multipliers of a certificate, and what they prove."""

    def __init__(self, scene, certificate, needs_gap=True, strain=None):
        if not scene.segments or (needs_gap and not scene.where["right"]):
            raise NoProof("rows: those of a network need segments and a gap other than 0")
        self.scene, self.floor = scene, floor_of(certificate)
        self.joints, self.impedances = joints_of(scene.segments), [Fraction(1)]
        for one, two, _ in self.joints:
            if not one or not two:
                raise NoProof("segments: an impedance is 0 beside its neighbour")
            self.impedances.append(self.impedances[-1] * Fraction(two, one))
        self.closed = []  # the side of the stop that holds the tip in each step, or None
        if scene.steps * len(scene.segments) > MOST_WORK:
            raise NoProof(f"schedule: this checker marches up to {MOST_WORK} steps times segments")
        for contact, free, side in scene.sided():
            self.closed += [side] * contact + [None] * free
        self.contacts = ["right", *(["left"] if "left" in scene.where else []),
                         *(["floor"] if self.floor is not None else [])]
        self.periodicity = self.read_periodicity(certificate["periodicity"])
        self.places = self.read(certificate, "places")
        self.pushes = self.read(certificate, "pushes")
        self.strain = strain if strain is not None else strain_of(certificate)
        self.strains = Strains(certificate, self.strain, [s.cells for s in scene.segments], scene.steps)
        if len(self.places) * scene.cells > MOST_WORK:
            raise NoProof(f"places: this checker takes up to {MOST_WORK} cells times places")

    def read_periodicity(self, listed):
        """One of each wave."""
        if not isinstance(listed, list) or len(listed) != 2 * self.scene.cells:
            raise NoProof(f"periodicity: no list of {2 * self.scene.cells} numbers")
        return [whole(value, "periodicity") for value in listed]

    def read(self, certificate, name):
        """{step: [(side, multiplier)]} of the list `name` of [contact, step, multiplier]."""
        listed = certificate[name]
        if not isinstance(listed, list):
            raise NoProof(f"{name}: not a list")
        found, seen = collections.defaultdict(list), set()
        for entry in listed:
            if not isinstance(entry, list) or len(entry) != 3:
                raise NoProof(f"{name}: {shown(entry)} is not [contact, step, multiplier]")
            contact, step = integer(entry[0], name), integer(entry[1], name)
            if not 1 <= contact <= len(self.contacts) or not 0 <= step < self.scene.steps or \
                    (contact, step) in seen:
                raise NoProof(f"{name}: {shown(entry)} is there twice, or names no contact or step")
            seen.add((contact, step))
            side, value = self.contacts[contact - 1], whole(entry[2], name)
            self.require_sign(name, side, step, value)
            found[step].append((side, value))
        return found

    def require_sign(self, name, side, step, value):
        """A distance is 0 beside a closed step and else >= 0; a push is >= 0, and there while closed."""
        here, before = self.closed[step], self.closed[step - 1]
        if name == "pushes" and side != here:
            raise NoProof(f"pushes: in step {step} that contact is open")
        if value < 0 and (name == "pushes" or side not in (here, before)):
            raise NoProof(f"{name}: a multiplier below 0 in step {step}")

    def right_side(self):
        """delta, of distances and limits of strain."""
        return -sum(value * self.gap(side) for listed in self.places.values() for side, value in listed) - \
            sum(value * self.strain * self.scene.speed(row)
                for row, _, _, value in self.strains.all)

    def least(self):
        """E/E_1 of any motion is this or more."""
        delta = self.right_side()
        if not delta > 0:
            raise NoProof("the right sides do not ask for a motion other than rest")
        march = Backwards(self.scene, self.joints, self.periodicity)
        twice = 2 * self.impedances[-1]
        rounded = 2 * len(self.joints) * self.scene.steps
        for step in range(self.scene.steps - 1, -1, -1):
            march.step(-1 if self.closed[step] else 1)
            for side, value in self.pushes.get(step, ()):
                march.push(math.floor(twice * value * (1 if side == "right" else -1)))
                rounded += 1
            for row, side, value in self.strains.arrivals.get(step, ()):
                march.arrive(row, side, value)
            for side, value in self.places.get(step, ()):
                march.place(-value if side == "right" else value)
        square, at = Fraction(0), 0
        eta = [x - y for x, y in zip(march.waves(), self.periodicity)]
        for segment, impedance in zip(self.scene.segments, self.impedances):
            square += sum(x * x for x in eta[at:at + 2 * segment.cells]) / impedance
            at += 2 * segment.cells
        # A wave rounded by less than a unit has a norm below 1/sqrt(Z).
        norm = math.isqrt(math.ceil(square)) + 1 + rounded * (math.isqrt(math.ceil(1 / min(self.impedances))) + 1)
        return Fraction(2, self.scene.cells) * (delta / norm) ** 2

    def gap(self, side):
        """The distance when u(L) = 0, in units of |g|/N."""
        where = {"right": self.scene.where["right"], "left": -self.scene.where.get("left", 0),
                 "floor": -(self.floor or 0)}
        return self.scene.cells * Fraction(where[side])

    def text(self):
        """What they are, in words."""
        count = sum(map(len, (*self.places.values(), *self.pushes.values()))) + len(self.strains.all)
        return f"{count} conditions and {len(self.periodicity)} waves, stepped backwards in time"


def check_floor(scene, answer):
    """That no motion has less energy than the file says: more than any bar bears, or, where the reason is a
    constraint, than the one that was to be held."""
    certificate = answer["certificate"]
    for key in ("energy_ratio", "energy_ratio_range"):
        if answer.get(key) is not None:
            raise NoProof(f"{key}: {shown(answer[key])} is not proved here")
    floor = Floor(scene, certificate)
    least, claimed = floor.least(), Fraction(number(certificate["energy_ratio"], "energy_ratio"))
    lowest = 0 if answer.get("reason") == "constraints" else HUGE
    if not lowest <= claimed <= least:
        raise NoProof(f"energy_ratio: {shown(certificate['energy_ratio'])}: allowed {lowest} to what is proved, "
                      f"{told(least)}")
    return f"none below {float(claimed)!r} E_1{within(floor.strain, floor.floor)}: {floor.text()}"


def check_least(scene, answer):
    """No motion has less energy than the state of the file, which is one, but for 1e-7."""
    certificate = answer["certificate"]
    floor = Floor(scene, certificate)
    least, claimed = floor.least(), answer.get("energy_ratio_range")
    if answer["status"] != "found" or answer.get("objective") != "min-energy" or \
            not isinstance(claimed, list) or len(claimed) != 2 or claimed[1] is not None:
        raise NoProof("of several segments only the least energy is known to this checker")
    for value in (answer.get("energy_ratio"), claimed[0], certificate["energy_ratio"]):
        if not close(value, least, NEAR):
            raise NoProof(f"energy: {shown(value)} is not near {float(least)!r}, which is proved")
    march = March(scene, floor.joints, impedances_of(scene.segments), certificate["state"])
    if abs(march.energy() / least - 1) > NEAR:
        raise NoProof(f"state: an energy of {float(march.energy())!r}, and {float(least)!r} is proved")
    off = march.off(floor.floor, floor.strain)
    return (f"{floor.text()}: E/E_1 >= {float(least)!r}{within(floor.strain, floor.floor)}; the state of the file is a "
            f"motion with {float(march.energy())!r}, to {off:.1g} of its largest wave")
