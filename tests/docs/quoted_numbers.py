#!/usr/bin/env python3
"""Runs the commands of docs/numbers.md and looks for what they are said to show.

    quoted_numbers.py --program SIGNORINI [--only REGEX] [--slow]

A row of its tables: figures as they are quoted, the pages that quote them, a command, what it shows.
Each figure has to stand on each of the pages, and what the command writes has to hold each text of the
last cell (runs of spaces count as one). Rows that end with "slow" are left out but with --slow.
All commands of the page run in one folder, in their order.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SPAN = re.compile(r"`([^`]*)`")


def plain(text):
    """Line ends and runs of spaces as one space."""
    return " ".join(text.split())


def rows_of(text):
    """Cells of all table rows, without heads and rules."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        is_head = number + 1 < len(lines) and lines[number + 1].startswith("|-")
        if line.startswith("|") and not line.startswith("|-") and not is_head:
            cells = re.split(r"(?<!\\)\|", line)[1:-1]
            yield number + 1, [cell.strip().replace(r"\|", "|") for cell in cells]


def spans(cell):
    """The texts in `code`."""
    return [plain(span) for span in SPAN.findall(cell)]


def faults_of(cells, folder, environment):
    """What of a row is not so."""
    quoted, pages, command, shown = cells[:4]
    for page in spans(pages):
        text = plain((ROOT / page).read_text(encoding="utf-8"))
        for figure in spans(quoted):
            if figure not in text:
                yield f"{page} does not quote `{figure}`"
    wanted = spans(shown)
    if not spans(quoted) or not spans(pages) or not wanted or len(spans(command)) != 1:
        yield "a row needs figures, pages, one command, and what it shows"
        return
    call = subprocess.run(["bash", "-o", "pipefail", "-c", SPAN.findall(command)[0]], cwd=folder,
                          env=environment, capture_output=True, text=True, check=False)
    if call.returncode not in (0, 1):
        yield f"exit status {call.returncode}: {call.stderr}"
        return
    written = plain(call.stdout + " " + call.stderr)
    for text in wanted:
        if text not in written:
            yield f"does not show `{text}` but: {written[:1500]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", required=True, type=Path)
    parser.add_argument("--only", type=re.compile, default=re.compile(""))
    parser.add_argument("--slow", action="store_true")
    options = parser.parse_args()
    folders = [options.program.resolve().parent, ROOT / "tools"]
    environment = {**os.environ, "PATH": os.pathsep.join([*map(str, folders), os.environ["PATH"]])}
    count = faults = 0
    with tempfile.TemporaryDirectory() as folder:
        for number, cells in rows_of((ROOT / "docs/numbers.md").read_text(encoding="utf-8")):
            if cells[4:] == ["slow"] and not options.slow or not options.only.search(cells[2]):
                continue
            begin = time.monotonic()
            count += 1
            for fault in faults_of(cells, folder, environment):
                faults += 1
                print(f"docs/numbers.md:{number}: {cells[2]}\n    {fault}")
            if time.monotonic() - begin > 10:
                print(f"docs/numbers.md:{number}: took {time.monotonic() - begin:.0f} s")
    print(f"{count} rows, {faults} faults")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
