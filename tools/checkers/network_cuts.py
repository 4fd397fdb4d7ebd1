"""What multipliers say of forced motions of any bars: as network_claim.py, with what drives them beside it.

For every motion under C cos + S sin

    c C + s S + eta . x >= delta,     |eta . x| <= sqrt(sum eta^2/Z) sqrt(sum Z x^2),

so a motion of no more than HUGE times E_1 keeps C and S on one side of a line, but for that (forced_network.py).
Cosines and what is made of them are enclosed between numbers of 60 digits."""
import math
from decimal import Decimal
from fractions import Fraction

from .enclosed import NOTHING, Interval, Vector, enclosed, harmonic
from .floor import HUGE
from .forced_network import MOST_AMPLITUDE, MOST_CUTS, leave_none
from .network_claim import Claim, spans
from .reading import NoProof, close, integer, number, require_keys, shown

SAID = ("schema", "version", "status", "scene", "reference", "cells", "schedule", "period", "period_ratio",
        "frequency_ratio", "force", "cycles", "frequency", "amplitude", "kind", "free_waves", "amplitude_range",
        "contacts", "motions", "certificate", "detail")


class Cut:
    """One list of multipliers, and the line that it leaves."""

    def __init__(self, claim, lists, answer):
        require_keys(lists, "cuts", ("periodicity", "places", "pushes"), ("strains",))
        self.bars, self.steps = claim.bars, len(claim.closed)
        self.force, self.cycles = answer["force"], answer["cycles"]
        self.line, self.error = NOTHING, Fraction(0)
        impedances = [row.impedance for row in self.bars.rows] + [z for _, _, z in self.bars.stubs]
        # Waves spoilt by a unit each, times what a force or the base adds to them in a step.
        self.reach = (len(self.bars.driven) + 1 + 2 * sum(impedances)) / min(impedances) + 1
        claim.take(lists, answer)
        self.delta, self.norm = claim.march(self)
        bound = Decimal(math.ceil(2 * self.error))
        slack = Interval(bound.copy_negate(), bound)
        self.line = Vector(self.line.c + slack, self.line.s + slack)
        unit = self.bars.unit()[0]
        self.most = HUGE * (unit or self.bars.natural(self.steps))

    def place(self, step):
        """Of the base when a step begins."""
        return harmonic(self.cycles * step, self.steps)

    def add(self, step, made, moved, spoilt):
        """What a step makes."""
        self.error += spoilt * self.reach
        if self.force == "tip":
            self.line += harmonic(self.cycles * (2 * step + 1), 2 * self.steps).times(enclosed(made["force"]))
        else:
            self.line += (self.place(step + 1) - self.place(step)).times(enclosed(made["base"]))
            self.line += self.place(step).times(enclosed(moved))

    def limit(self):
        """line . (C, S) is at least this."""
        return self.delta - self.norm * (math.isqrt(math.ceil(self.most)) + 1)

    def excludes(self, amplitude):
        """All of them up to this amplitude?"""
        limit = enclosed(self.limit())
        reach = self.line.dot(self.line) * enclosed(Fraction(amplitude) ** 2)
        return limit.sign() > 0 and (limit * limit - reach).sign() > 0


def require_driven(bars, force):
    """Is there something that drives, and are its bars held nowhere else?"""
    if not (bars.driven if force == "tip" else bars.shaken):
        raise NoProof("scene: nothing is driven, or shaken")
    held = any(bars.bar_of[node] in {bars.bar_of[at] for at in bars.shaken}
               for node in [*(k for k, clamped in enumerate(bars.clamped) if clamped and k not in bars.shaken),
                            *(node for sign, node, _ in bars.stubs if sign < 0)])
    if force == "base" and (held or len({bars.bar_of[at] for at in bars.shaken}) < len(bars.shaken)):
        raise NoProof("scene: a bar that is shaken and held elsewhere, too, is not known to this checker")


def check_scene_forced(answer):
    """What an answer of `find --scene ... --force` proves, in a sentence. NoProof if it proves nothing."""
    require_keys(answer, "answer", SAID, ("strain_limit", "phase"))
    claim, certificate = Claim(answer), answer["certificate"]
    require_keys(certificate, "certificate", ("kind", "verified", "rows", "cuts"))
    cycles, force, lists = integer(answer["cycles"], "cycles"), answer["force"], certificate["cuts"]
    if answer["status"] != "none" or force not in ("tip", "base") or not 1 <= 2 * cycles < len(claim.closed) or \
            certificate["rows"] != "network" or not isinstance(lists, list) or not 1 <= len(lists) <= MOST_CUTS:
        raise NoProof(f"answer: allowed status none, force tip or base, cycles below half of the steps, rows of a "
                      f"network, 1 to {MOST_CUTS} cuts")
    require_driven(claim.bars, force)
    claim.require_derived(answer, claim.bars.unit(), cycles)
    if not close(answer["frequency"], cycles / (len(claim.closed) * claim.bars.step), Fraction(1, 10 ** 9)):
        raise NoProof(f"frequency: {shown(answer['frequency'])} does not follow from the schedule")
    if answer["motions"] != [] or answer.get("phase") is not None:
        raise NoProof("motions, phase: none are proved here")
    cuts = [Cut(claim, one, answer) for one in lists]
    words = f"{len(cuts)} sums of {len(claim.y)} waves and conditions, stepped backwards in time, below {HUGE} E_1"
    if certificate["kind"] == "amplitude-range":
        amplitude = Fraction(number(answer["amplitude"], "amplitude"))
        unit = claim.bars.delta if force == "base" else claim.bars.joules() / claim.bars.delta
        if not amplitude > 0 or not leave_none(cuts, amplitude / unit):
            raise NoProof("cuts: they leave an excitation")
        words += f", of amplitude {float(amplitude)!r}"
    elif certificate["kind"] != "forced" or answer["kind"] != "empty" or answer["amplitude_range"] is not None or \
            not any(cut.excludes(MOST_AMPLITUDE) for cut in cuts):
        raise NoProof("cuts: they leave an excitation")
    limit = "" if claim.limit is None else f" with strains >= -{float(claim.limit)!r}"
    return (f"no forced motion of schedule {spans(answer)} of these bars{limit}: {words}; not checked: detail, "
            "free_waves, and the frequency and damping of reference, from which frequency_ratio follows")
