#!/usr/bin/env python3
"""Damaged pickles of the Python package: refused with ValueError, or read as what was written.

    python3 tests/robustness/damaged_pickles.py [--count 20000] [--seed 1] [--first 0]

with signorini importable. Values of a pickle are changed, cut, dropped, doubled or exchanged. One half of the
cases leaves the sum over them as it was: nothing of it may be let in. The other half seals them anew, as a
forger would: what is accepted must bear to be shown, compared and asked.
A fault of memory ends the run; the number of the case that was under way is printed on stderr.
"""

import argparse
import faulthandler
import marshal
import pickle
import random
import struct
import sys
import zlib

import signorini as sg

#: What stands in for a value.
ODD = [None, True, 0, -1, 1, 3, 2 ** 31, 2 ** 62, -2 ** 63, 2 ** 70, 0.0, -1.5, 1e300, 1e-320, float("nan"),
       float("inf"), "", "x", b"", b"1234567", b"12345678", bytes(8 * 5), bytes(8 * 1000), (), [], (1,), [[]], ((), ())]


#: What stands in for eight bytes of a string of them.
WHOLE = [value for value in ODD if type(value) is int and -2 ** 63 <= value < 2 ** 63]
REAL = [value for value in ODD if isinstance(value, float)]


def records():
    """One of each class that travels."""
    forced = sg.find(10, 60, cells=20, damping=0.02, force="tip", amplitude=2e-4)
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=3)
    run = sg.simulate(damping=0.02, force="tip", amplitude=2e-4, frequency=1.1, periods=5, cells=6)
    found = sg.find(5, 30, cells=10, objective="nearest", target=sg.State([1.0] * 10, [0.5] * 10))
    polytope = sg.modes(phases=2, max_order=3)[0]
    stepped = sg.find(3, 25, cells=8, segments=[(4, 1.0), (4, 1.3)])
    return [sg.Bar(gap=2e-3), sg.Schedule((1, 12), (3, 12), cells=4), sg.Scene(sg.Bar(), 1e-3), found, found.state,
            found.motion, found.physical, sg.find(20, 109, cells=40), sg.find(15, 90, cells=30, energy_ratio=3),
            stepped, stepped.motion, sg.find(4, 20, cells=8, segments=[(4, 1.0), (4, 1.3)]), forced,
            forced.motions[0], curve, curve[1], sg.families()[3], sg.modes()[2], sg.mode(4, -1, 3.14159), polytope,
            polytope.motion(2.6), run, run.waves]


def places(content, path=()):
    """All places of a nest of tuples and lists."""
    yield path
    if isinstance(content, (tuple, list)):
        for at, held in enumerate(content):
            yield from places(held, (*path, at))


def at(content, path):
    for step in path:
        content = content[step]
    return content


def changed(content, path, change):
    """The same with `change` of what stands at a place."""
    if not path:
        return change(content)
    items = list(content)
    items[path[0]] = changed(items[path[0]], path[1:], change)
    return type(content)(items)


def other(dice, value, whole):
    """Something in place of a value."""
    kind = dice.randrange(6)
    if kind in (2, 4, 5) and isinstance(value, bytes) and value:
        where, size = dice.randrange(len(value)), dice.choice([1, 1, 2, 4, 8, 8])
        what = dice.choice([struct.pack("<q", dice.choice(WHOLE)), struct.pack("<d", dice.choice(REAL)),
                            dice.randbytes(8), value[where // 8 * 8:][:8]])[:size]
        return value[:where] + what + value[where + dice.choice([size, size, 0]):]
    if kind == 0 and isinstance(value, bytes) and value:
        cut = dice.randrange(len(value) + 1)
        return dice.choice([value[:cut], value + value[:cut], value + bytes(8 * cut), value[:8 * (cut // 8)]])
    if kind == 1 and isinstance(value, (tuple, list)) and value:
        items = list(value)
        where = dice.randrange(len(items))
        items[where:where + 1] = dice.choice([[], [items[where]] * 2, [dice.choice(ODD)]])
        return type(value)(items)
    if kind == 2 and isinstance(value, (int, float)):
        return dice.choice([value + 1, value - 1, -value, value * 2, value * 1000])
    if kind == 3:
        return at(whole, dice.choice(list(places(whole))))
    return dice.choice(ODD)


def seal(name, content):
    return content, zlib.crc32(marshal.dumps(content, 2), zlib.crc32(f"{sg.__version__} {name}".encode()))


def show(record):
    """What one does with an answer."""
    repr(record)
    for name in dir(record):
        if not name.startswith("_"):
            try:
                value = getattr(record, name)
                if callable(value) and name in ("is_proof", "to_dict", "worst"):
                    value()
            except (ValueError, TypeError, OverflowError, AttributeError, MemoryError):
                pass
    assert isinstance(record == record, bool)
    if isinstance(record, (sg.Motion, sg.ModeMotion, sg.PolytopeMotion)):
        record.displacement_ratio([0.0, 0.5, 1.0], [[0.0], [0.7], [3.0]])
    pickle.dumps(record)


def damaged(dice, content):
    """One to three damages."""
    for _ in range(dice.choice([1, 1, 1, 2, 3])):
        whole = content
        content = changed(content, dice.choice(list(places(whole))), lambda value: other(dice, value, whole))
    return content


def opened(record, state):
    """A record of the same class made of a state, or None where it is refused."""
    blank = type(record).__new__(type(record))
    try:
        blank.__setstate__(state)
    except (ValueError, MemoryError):
        return None
    return blank


def forged(dice, record):
    """Other values under a sum that fits: what gets in must bear to be shown."""
    made = opened(record, seal(type(record).__name__, damaged(dice, record.__getstate__()[0])))
    if made is None:
        return "refused"
    try:
        show(made)
    except (ValueError, MemoryError):
        pass
    return "accepted"


def spoilt(dice, record):
    """Other values under the sum of those that were written: never let in."""
    content, written = record.__getstate__()
    other_content = damaged(dice, content)
    made = opened(record, (other_content, written))
    if marshal.dumps(other_content, 2) == marshal.dumps(content, 2):
        assert made is not None and made.to_dict() == record.to_dict(), f"{record} was refused"
        return "accepted"
    assert made is None, f"{record} came back as {made}"
    return "refused"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--count", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    given = parser.parse_args()
    faulthandler.enable()
    drawn = records()
    seen = {}
    for number in range(given.first, given.first + given.count):
        dice = random.Random(f"{given.seed} {number}")
        faulthandler.dump_traceback_later(30, exit=True)
        kind = dice.choice([forged, spoilt])
        record = dice.choice(drawn)
        print(f"\rcase {number} {type(record).__name__}", end=" ", file=sys.stderr, flush=True)
        came = kind.__name__, kind(dice, record)
        seen[came] = seen.get(came, 0) + 1
    faulthandler.cancel_dump_traceback_later()
    print(file=sys.stderr)
    for (kind, came), count in sorted(seen.items()):
        print(f"{kind} pickles {came}: {count}")
    missing = [name for name in ("forged", "spoilt") if (name, "refused") not in seen]
    return f"no case of {missing}" if missing else 0


if __name__ == "__main__":
    sys.exit(main())
