"""What the robustness campaigns share: arguments, running the program, judging, the last line."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

if (tools := str(pathlib.Path(__file__).resolve().parents[2] / "tools")) not in sys.path:
    sys.path.append(tools)  # for those that import checkers

FOUND, NONE, WRONG_USE, UNDECIDED, UNAVAILABLE = range(5)
MOST_FAULTS_SHOWN = 50


@dataclass
class Outcome:
    """How one call ended: `status` is negative after a signal, None after the time limit."""

    status: int | None
    out: bytes
    err: bytes


class Case:
    """One case of a campaign: a folder of its own, a generator of its own, a list of faults."""

    def __init__(self, program, number, seed, limit):
        self.number = number
        self.random = random.Random(f"{seed} {number}")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="signorini-robustness-"))
        self.faults = []
        self._program = program
        self._limit = limit
        self._temporary = self.folder.with_name(self.folder.name + "-tmp")
        self._temporary.mkdir()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.rmtree(self._temporary, ignore_errors=True)

    def run(self, words, variables=None):
        """Runs the program in the case's folder; notes crashes, hangs and files left behind."""
        environment = dict(os.environ, TMPDIR=str(self._temporary), **(variables or {}))
        try:
            done = subprocess.run([self._program, *words], cwd=self.folder, env=environment,
                                  stdin=subprocess.DEVNULL, capture_output=True,
                                  timeout=self._limit, check=False)
            outcome = Outcome(done.returncode, done.stdout, done.stderr)
        except subprocess.TimeoutExpired as late:
            outcome = Outcome(None, late.stdout or b"", late.stderr or b"")
        if outcome.status is None:
            self.fault(words, f"no end within {self._limit} s")
        elif outcome.status not in range(5):
            self.fault(words, f"status {outcome.status}: {outcome.err[-300:]!r}")
        else:
            self._judge_words(words, outcome)
        left = [path.name for path in self._temporary.iterdir()]
        left += [path.name for path in self.folder.rglob(".signorini*")]
        if left:
            self.fault(words, f"temporary files left: {left}")
        return outcome

    def fault(self, words, text):
        self.faults.append(f"case {self.number}: signorini {shown(words)}\n    {text}")

    def _judge_words(self, words, outcome):
        lines = outcome.err.split(b"\n")
        for line in [*lines, *outcome.out.split(b"\n")]:
            if any(byte < 32 or byte == 127 for byte in line):
                self.fault(words, f"control characters in the output: {line!r}")
        if outcome.status in (WRONG_USE, UNAVAILABLE):
            if outcome.out:
                self.fault(words, f"status {outcome.status}, but stdout: {outcome.out[:200]!r}")
            if len(lines) != 2 or lines[1] or not lines[0].startswith(b"signorini"):
                self.fault(words, f"status {outcome.status}, not one line: {outcome.err!r}")


def shown(words):
    """The words as a shell reads them."""
    return " ".join(shlex.quote(os.fsdecode(word)) for word in words).encode(
        "utf-8", "backslashreplace").decode()


def strict_json(text):
    """Reads JSON as the standard has it: no NaN, no Infinity. Raises ValueError."""
    def refuse(word):
        raise ValueError(f"{word} is no JSON")
    return json.loads(text, parse_constant=refuse)


def snapshot(folder):
    """The content of every file below a folder."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


def arguments(description, count):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True, help="the program signorini")
    parser.add_argument("--count", type=int, default=count, help=f"cases ({count})")
    parser.add_argument("--seed", type=int, default=1, help="of the random cases (1)")
    parser.add_argument("--first", type=int, default=0, help="number of the first case (0)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="cases at a time")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds for one call (60)")
    given = parser.parse_args()
    given.program = str(pathlib.Path(given.program).resolve(strict=True))
    return given


def campaign(given, what, judge, least=None):
    """Calls judge(case) for every case, prints the faults and the last line, and exits.

    judge returns a word for the outcome; the words are counted, and `least` names those that
    must have come up, so that a campaign which tries nothing cannot pass.
    """
    def one(number):
        with Case(given.program, number, given.seed, given.limit) as case:
            try:
                word = judge(case)
            except Exception as error:  # a fault of the campaign, to be seen with its number
                word = "broken"
                case.faults.append(f"case {number}: the campaign itself: {error!r}")
            return word, case.faults

    start = time.monotonic()
    counts, faults = {}, 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        numbers = range(given.first, given.first + given.count)
        for word, found in pool.map(one, numbers):
            counts[word] = counts.get(word, 0) + 1
            for text in found[:max(0, MOST_FAULTS_SHOWN - faults)]:
                print(text, flush=True)
            faults += len(found)
    if faults > MOST_FAULTS_SHOWN:
        print(f"... {faults - MOST_FAULTS_SHOWN} more")
    missing = [word for word in least or [] if word not in counts] if given.count >= 1000 else []
    if missing:
        faults += 1
        print(f"the campaign never saw: {', '.join(missing)}")
    tally = ", ".join(f"{word} {counts[word]}" for word in sorted(counts))
    print(f"({tally}; {time.monotonic() - start:.0f} s)")
    print(f"{given.count} {what}: " + (f"{faults} faults" if faults else
                                       "no crash, no hang, no wrong status"))
    sys.exit(1 if faults else 0)
