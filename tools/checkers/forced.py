"""What an answer of `find` about a forced bar proves."""
import itertools
from fractions import Fraction
from math import gcd

from .enclosed import DIGITS, NOTHING, ONE, ZERO, Interval, Vector, enclosed
from .forced_network import check_network
from .forced_rows import SEEN, Question, Waves
from .reading import NoProof, require_keys, shown
from .scene import unsaid

MOST_CONDITIONS = 200
MOST_AMPLITUDE = 10 ** 30


def without_free(rows):
    """All combinations in which no amplitude z is left, a basis: one factor for each row."""
    columns = sorted({j for row in rows for j in row.free})
    lines = [[Fraction(row.free.get(j, 0)) for j in columns] +
             [Fraction(i == k) for k in range(len(rows))] for i, row in enumerate(rows)]
    for column in range(len(columns)):
        pivot = next((line for line in lines if line[column]), None)
        if pivot:
            lines = [line if not line[column] else
                     [x - y * line[column] / pivot[column] for x, y in zip(line, pivot)]
                     for line in lines if line is not pivot]
    return [line[len(columns):] for line in lines]


def combined(factors, rows):
    """The sum of factors times vectors."""
    total = NOTHING
    for factor, row in zip(factors, rows):
        if factor:
            total += row.vector.times(enclosed(factor))
    return total


def vanishing(vectors):
    """Factors with which some of the vectors add up to 0, and what may be left of it: pairs. Three in a
    plane have such factors, but for their size the only ones; of two or one there may be nothing left but
    rounding."""
    places = range(len(vectors))
    for i, j, k in itertools.combinations(places, 3):
        x, y, z = vectors[i], vectors[j], vectors[k]
        yield {i: y.cross(z), j: z.cross(x), k: x.cross(y)}, ZERO
    for i, j in itertools.combinations(places, 2):
        squares = vectors[j].dot(vectors[j])
        if squares.sign():
            share = (-vectors[i].dot(vectors[j]) / squares).middle()
            yield {i: ONE, j: share}, (vectors[i] + vectors[j].times(share)).size()
    for i in places:
        yield {i: ONE}, vectors[i].size()


def is_contradiction(rows, totals, rest):
    """Do the rows, these times, certainly say 0 = sum total row >= sum total limit > 0, or the same
    negated? `rest` bounds what is left of the 0."""
    slack = (enclosed(MOST_AMPLITUDE) * rest).high
    right = Interval(slack.copy_negate(), slack)
    for total, row in zip(totals, rows):
        right += total * row.limit
    return right.sign() != 0 and all(row.is_equality or total.is_zero() or total.sign() == right.sign()
                                     for total, row in zip(totals, rows))


def check_contradiction(rows):
    """Some combination of the rows in which nothing is left of z, C and S says 0 >= something above 0, or
    NoProof."""
    basis = without_free(rows)
    if not 1 <= len(basis) <= 3:
        raise NoProof(f"the conditions leave {len(basis)} combinations without waves that nothing damps, not 1 to "
                      "3: not known to this checker")
    for factors, rest in vanishing([combined(line, rows) for line in basis]):
        totals = [ZERO] * len(rows)
        for k, factor in factors.items():
            totals = [total + enclosed(part) * factor if part else total
                      for total, part in zip(totals, basis[k])]
        if is_contradiction(rows, totals, rest):
            return
    raise NoProof(f"the conditions do not contradict each other by more than rounding to {DIGITS} digits")


def leave_no_excitation(rows):
    """Is C = S = 0 all that the rows leave? Two works that do not say the same leave no more, and so
    do rows that cut a line through 0, the first row, at 0 from both sides."""
    def is_linear(row):
        return not row.is_free() and row.limit.is_zero()

    works = [row for row in rows if row.is_equality and is_linear(row)]
    if any(works[0].vector.cross(row.vector).sign() for row in works):
        return True
    if not all(map(is_linear, rows)):
        return False
    sides = {rows[0].vector.cross(row.vector).sign() for row in rows}
    return sides >= {1, -1}


def breaks(row, place):
    """Does (C, S) certainly not meet the row?"""
    sign = (row.vector.dot(place) - row.limit).sign()
    return sign < 0 or (row.is_equality and sign > 0)


def check_amplitude(rows, amplitude, count):
    """Why there is no motion of this amplitude; or NoProof."""
    if amplitude is None or not amplitude > 0:
        raise NoProof("amplitude: allowed above 0")
    if leave_no_excitation(rows):
        return f"{count} leave no excitation"
    return f"{count}: {check_places(rows, amplitude)}"


def check_places(rows, amplitude):
    """No (C, S) of this size meets the rows, the first of which leaves two places of it; or NoProof."""
    if any(row.is_free() for row in rows):
        raise NoProof("waves that nothing damps in conditions about an amplitude: not known to this checker")
    gap = rows[0]
    squares = gap.vector.dot(gap.vector)
    reach = enclosed(amplitude ** 2) * squares - gap.limit * gap.limit
    if reach.sign() < 0:
        return "no excitation of this amplitude brings the tip to the stop"
    foot = gap.vector.times(gap.limit / squares)
    away = Vector(-gap.vector.s, gap.vector.c).times(reach.root() / squares)
    for place in (foot + away, foot - away):
        if not any(breaks(row, place) for row in rows[1:]):
            raise NoProof("an excitation of this amplitude that brings the tip to the stop breaks no condition "
                          f"by more than rounding to {DIGITS} digits")
    return "both excitations of this amplitude that bring the tip to the stop break a condition"


def conditions_of(certificate):
    """The list in the file."""
    conditions = certificate["conditions"]
    if not isinstance(conditions, list) or len(conditions) > MOST_CONDITIONS:
        raise NoProof(f"conditions: no list of at most {MOST_CONDITIONS}")
    return conditions


def check(answer):
    """What an answer proves, in a sentence. NoProof if it proves nothing."""
    question = Question(answer)
    certificate = answer["certificate"]
    is_one = not question.is_of_network()
    require_keys(certificate, "certificate", ("kind", "conditions") if is_one else ("kind", "rows", "cuts"),
                 ("verified",) if is_one else ("verified", "conditions"))
    if answer["status"] != "none" or certificate.get("verified", True) is not True:
        raise NoProof("the answer does not say \"none\", or not that this is verified")
    kind = certificate["kind"]
    if kind not in ("forced", "amplitude-range"):
        raise NoProof(f"certificate: kind {shown(kind)} is not known to this checker")
    sized = "of any amplitude" if kind == "forced" else f"of amplitude {answer['amplitude']!r}"
    if not is_one:
        return f"no motion {sized}: {question.text()}: {check_network(question, certificate)}{unsaid(answer, SEEN)}"
    conditions = conditions_of(certificate)
    if kind == "forced" and conditions == [{"rule": "rest", "step": 0}]:
        return f"no motion of any amplitude: schedule {question.text()}: {check_rest(question)}" \
            f"{unsaid(answer, SEEN)}"
    waves = Waves(question)
    rows = [waves.gap()] + [waves.row(condition) for condition in conditions]
    count = f"u(L, 0) at the stop and {len(conditions)} condition{'s' * (len(conditions) != 1)}"
    if kind == "forced":
        why = check_absence(question, rows, count)
    else:
        why = check_amplitude(rows, question.amplitude, count)
    return f"no motion {sized}: {question.text()}: {why}{unsaid(answer, SEEN)}"


def check_rest(question):
    """Without a gap no excitation keeps the tip at the wall all the time. One contact phase, and a flight
    of fewer steps than classes: some class never flies, the others in one step each, where a wave comes
    back as it left, so p = -(rho p + (1 + rho)/2 F), F + 2p = 0, v = 0. So waves are never lost, and the
    pushes, all >= 0, have the mean of F or of the place of the base, which is 0: they are 0. Then so is
    what the excitation adds in 2N steps; a harmonic that adds nothing there has whole cycles in them."""
    flight = question.phases[0][1]
    if not question.can_rest() or len(question.phases) != 1 or \
            flight >= gcd(2 * question.cells, question.steps):
        raise NoProof("rest: allowed without a gap, of one contact, with fewer steps of flight than classes")
    if 2 * question.cells * question.cycles % question.steps == 0:
        raise NoProof("rest: the excitation has whole cycles in 2N steps, and need not be 0")
    return "the tip rests at the wall all the time, and without a gap no excitation lets it"


def check_absence(question, rows, count):
    """That there is no motion of any amplitude."""
    if not question.can_rest():
        check_contradiction(rows)
        return f"{count} contradict each other"
    if not leave_no_excitation(rows):
        raise NoProof("the conditions leave an excitation, but for rounding")
    return f"{count} leave no excitation: at most a bar that nothing excites"
