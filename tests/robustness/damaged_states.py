#!/usr/bin/env python3
"""Damaged state files: refused by file and line, or read as a strict parser reads them.

The nearest motion to the file's state is computed. What the program accepts, the parser here must
accept; then the same call on a clean copy of its numbers must give the same motion.
"""

import json
import math
import re
import subprocess
import tempfile
from pathlib import Path

from campaign import FOUND, UNAVAILABLE, WRONG_USE, arguments, campaign

CELLS = 6
MARK = b"\xef\xbb\xbf"
CALL = ["find", "3", "18", "--cells", str(CELLS), "--objective", "nearest", "--format", "json"]
NUMBER = re.compile(r"-?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)
ODD = [b"", b" ", b"\t", b",", b";", b"\n", b"\r", b"\r\n", b"\0", b"\xef\xbb\xbf", b"\xff", b"-",
       b"+", b".", b"e", b"1e400", b"1e-400", b"inf", b"nan", b"0x1p3", b"1,5", b"1 5", b"1_0",
       b"#", b"\"", b"'", b"--1", b"1e", b"9" * 400, b"0." + b"0" * 400 + b"1", b"\xc2\xa0", b"a",
       b"a,b\n", b"\x1a", b"1.5.2", b"\xd9\xa3", b"1d3", b"=1", b"NULL"]


def table(content):
    """The fields of each line that is no comment, or None if the last one has no end."""
    try:
        text = content.removeprefix(MARK).decode("utf-8")
    except UnicodeDecodeError:
        text = content.removeprefix(MARK).decode("latin-1")
    if not text.endswith("\n"):
        return None
    lines = [line.removesuffix("\r") for line in text[:-1].split("\n")]
    lines = [line for line in lines if not line.strip(" \t").startswith("#")]
    separator = ";" if lines and ";" in lines[0] else ","
    return [[field.strip(" \t") for field in line.split(separator)] for line in lines]


def is_measured(content):
    """Without a and b, but with x and velocity: another kind of table, judged by unit tests."""
    header = set((table(content) or [[]])[0])
    return not header & {"a", "b"} and "x" in header and bool(header & {"velocity", "v"})


def strict(content):
    """(a, b) of a state file, or None: one newline after each row, the header's number of fields.

    Blanks around a field and a carriage return before the newline are allowed.
    """
    rows = table(content)
    if not rows:
        return None
    header, rows = rows[0], rows[1:]
    if header.count("a") != 1 or header.count("b") != 1 or not rows:
        return None
    columns = [header.index("a"), header.index("b")]
    if "displacement" in header:  # of the first cell, which says where the base is
        if header.count("displacement") != 1:
            return None
        columns.append(header.index("displacement"))
    numbers = []
    for row in rows:
        wanted = [row[at] for at in columns] if len(row) == len(header) else [""]
        if not all(NUMBER.fullmatch(word) for word in wanted):
            return None
        values = [float(word) for word in wanted]
        if not all(is_representable(*pair) for pair in zip(wanted, values)):
            return None
        numbers.append(values[:2])
        del columns[2:]
    return numbers


def is_representable(word, value):
    """Neither too large for a double, nor so small that it would become 0."""
    return math.isfinite(value) and (value != 0 or not re.match(r"-?[0.]*[1-9]", word))


def damage(random, content):
    """One to three damages."""
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        at = random.randrange(len(content) + 1)
        kind = random.randrange(9)
        lines = content.split(b"\n")
        row = random.randrange(len(lines))
        fields = lines[row].split(b",")
        field = random.randrange(len(fields))
        if kind == 0:
            content = content[:at]
        elif kind == 1:
            content = content[:at] + random.randbytes(1) + content[at + 1:]
        elif kind == 2:
            content = content[:at] + random.choice(ODD) + content[at:]
        elif kind == 3:
            fields[field] = random.choice(ODD)
        elif kind == 4:
            del fields[field]
        elif kind == 5:
            fields.insert(field, random.choice([b"0", b"1.5", b"a", b"b", b"", b"x"]))
        elif kind == 6:
            lines.insert(random.randrange(len(lines) + 1), lines[row])
            content = b"\n".join(lines)
        elif kind == 7:
            del lines[row]
            content = b"\n".join(lines)
        else:
            content = content.replace(*random.choice(
                [(b"\n", b"\r\n"), (b"\n", b"\r"), (b",", b";"), (b".", b","), (b",", b", "),
                 (b",", b"\t"), (b"\n", b"\n\n"), (b"a", b"A"), (b"velocity", b"a"), (b"e", b"E")]))
        if kind in (3, 4, 5):
            lines[row] = b",".join(fields)
            content = b"\n".join(lines)
    if random.random() < 0.02:
        content = content.decode("latin-1").encode("utf-16")
    return content


def clean(numbers):
    return "a,b\n" + "".join(f"{a!r},{b!r}\n" for a, b in numbers)


def judge(case, valid):
    content = damage(case.random, valid)
    (case.folder / "damaged.csv").write_bytes(content)
    words = [*CALL, "--target", "damaged.csv"]
    outcome = case.run(words)
    if is_measured(content) and outcome.status in (FOUND, WRONG_USE):
        return "refused" if outcome.status == WRONG_USE else "accepted"
    numbers = strict(content)
    if outcome.status in (WRONG_USE, UNAVAILABLE):
        if numbers is None:
            if not re.search(rb"damaged\.csv line \d+", outcome.err):
                case.fault(words, f"no line named: {outcome.err!r} for {content!r}")
        elif len(numbers) == CELLS and is_moderate(numbers):
            case.fault(words, f"refused, though right: {outcome.err!r} for {content!r}")
        elif not re.search(rb"damaged\.csv|target", outcome.err):
            case.fault(words, f"no file named: {outcome.err!r} for {content!r}")
        return "refused"
    if numbers is None:
        case.fault(words, f"accepted: {content!r}")
        return "accepted"
    (case.folder / "clean.csv").write_text(clean(numbers), encoding="ascii")
    again = case.run([*CALL, "--target", "clean.csv"])
    if again.status != outcome.status or essence(again) != essence(outcome):
        case.fault(words, f"read as other numbers: {content!r}")
    return "accepted"


def is_moderate(numbers):
    return all(value == 0 or 1e-100 < abs(value) < 1e100 for row in numbers for value in row)


def essence(outcome):
    """The answer without times."""
    if outcome.status != FOUND:
        return outcome.status
    answer = json.loads(outcome.out)
    answer.pop("solver", None)
    return answer


def main():
    given = arguments(__doc__, 5_000)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "state.csv"
        subprocess.run([given.program, "find", "3", "18", "--cells", str(CELLS), "--objective",
                        "max-energy", "--state", path], check=True, capture_output=True)
        valid = path.read_bytes()
    campaign(given, "damaged state files", lambda case: judge(case, valid),
             ["accepted", "refused"])


if __name__ == "__main__":
    main()
