"""The rows of the paper's (30)-(32), from its (21)-(25), and proofs over them."""
from .reading import NoProof, integer, multipliers


def dd(i, n, cells):
    """Where a_i and b_i after n steps of contact come from, (21) and (22).

    Pairs (place among a_1 .. a_N, b_1 .. b_N counted from 0, sign).
    """
    n %= 2 * cells  # (21), (22) repeat
    left, right = i - n, i + n
    if left >= 1:
        a = (left - 1, 1)
    elif left >= 1 - cells:
        a = (cells - left, -1)
    else:
        a = (left + 2 * cells - 1, 1)
    if right <= cells:
        b = (cells + right - 1, 1)
    elif right <= 2 * cells:
        b = (2 * cells - right, -1)
    else:
        b = (right - cells - 1, 1)
    return a, b


def dn(i, n, cells):
    """The same after n steps of free flight, (24) and (25)."""
    n %= 4 * cells  # (24), (25) repeat
    left, right = i - n, i + n
    if left >= 1:
        a = (left - 1, 1)
    elif left >= 1 - cells:
        a = (cells - left, -1)
    elif left >= 1 - 2 * cells:
        a = (left + 2 * cells - 1, -1)
    elif left >= 1 - 3 * cells:
        a = (-cells - left, 1)
    else:
        a = (left + 4 * cells - 1, 1)
    if right <= cells:
        b = (cells + right - 1, 1)
    elif right <= 2 * cells:
        b = (2 * cells - right, 1)
    elif right <= 3 * cells:
        b = (right - cells - 1, -1)
    elif right <= 4 * cells:
        b = (4 * cells - right, -1)
    else:
        b = (right - 3 * cells - 1, 1)
    return a, b


def carried(state, flow, n):
    """A state, a list of (unknown, sign), after n steps of contact (dd) or flight (dn)."""
    cells = len(state) // 2

    def taken(term):
        unknown, sign = state[term[0]]
        return unknown, sign * term[1]

    pairs = [flow(i, n, cells) for i in range(1, cells + 1)]
    return [taken(a) for a, _ in pairs] + [taken(b) for _, b in pairs]


def split(rows, phases, kind):
    """Pairs (row, multiplier) by phase, rows counted from its first one."""
    parts, first, rows = [], 0, sorted(rows, reverse=True)
    for phase in phases:
        part = []
        while rows and rows[-1][0] < first + phase[kind]:
            row, value = rows.pop()
            part.append((row - first, value))
        parts.append(part)
        first += phase[kind]
    return parts


def check_farkas(cells, phases, sign, certificate):
    """sum of multipliers times rows = 0 on the left, < 0 on the right, or NoProof."""
    size = 2 * cells
    contacts = sum(contact for contact, _ in phases)
    flights = sum(free for _, free in phases)
    gap = integer(certificate.get("gap"), "gap")
    size_row = integer(certificate.get("size", 0), "size")
    if sign and size_row:
        raise NoProof(f"size: {size_row}, and its row is there only without a gap")
    right = (gap * sign if sign else size_row) * cells
    if right >= 0:
        raise NoProof(f"gap: {gap}, size: {size_row}: the rows do not add up to 0 < 0")
    periodicity = multipliers(certificate, "periodicity", size, signed=True)
    pressure = multipliers(certificate, "pressure", contacts, signed=False)
    penetration = multipliers(certificate, "penetration", flights, signed=False)
    landing = dict(multipliers(certificate, "landing", len(phases) - 1, signed=True))

    total = [-gap] * cells + [gap] * cells  # (31): sum(b_i - a_i) = N, -N or 0

    def add(state, term, factor):
        unknown, sign = state[term[0]]
        total[unknown] += factor * sign * term[1]

    state = [(unknown, 1) for unknown in range(size)]
    pressures, penetrations = split(pressure, phases, 0), split(penetration, phases, 1)
    for k, ((contact, free), pushed, fallen) in enumerate(zip(phases, pressures, penetrations)):
        if size_row:  # what arrives in contact adds up to N; 2N steps of it repeat
            counted = contact if contact < size else size + contact % size
            for m in range(counted):
                add(state, dd(cells, m, cells)[0], size_row)
        # (10) in step m of contact: half of s(L) = r2(L + ct) - r1(L - ct) <= 0, where r2 = -r1.
        for m, value in pushed:
            add(state, dd(cells, m, cells)[0], -value)
        state = carried(state, dd, contact)
        # (12) in step m of flight: half the sum of v(L) = r1 + r2 over steps 0 .. m, where r2 = r1.
        # So step k enters with the multipliers of all rows from k on. By (24) r1 changes its sign
        # after 2N steps: the sum of 4N of them is 0, and row m + 4N is row m.
        weight = [0] * min(free, 2 * size)
        for m, value in fallen:
            weight[m % (2 * size)] += value
        if k in landing:  # all of this flight: the tip is back at the wall
            weight[(free - 1) % (2 * size)] += landing[k]
        later = sum(weight)
        for m, value in enumerate(weight):
            if later:
                add(state, dn(cells, m, cells)[0], later)
            later -= value
        state = carried(state, dn, free)
    for row, value in periodicity:  # (30): (W x - x)_row = 0
        unknown, sign = state[row]
        total[unknown] += value * sign
        total[row] -= value

    for unknown, coefficient in enumerate(total):
        if coefficient:
            name = "ab"[unknown // cells] + f"_{unknown % cells + 1}"
            raise NoProof(f"the rows do not cancel: {coefficient} {name} is left")
    listed = len(periodicity) + len(pressure) + len(penetration) + len(landing) + 1
    return (f"{listed} of {size + contacts + flights + len(phases)} rows add up to 0 = {right} or less")
