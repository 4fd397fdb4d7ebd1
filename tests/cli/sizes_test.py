#!/usr/bin/env python3
"""No answer depends on the size of the motion: every command at sizes 1e-9 .. 1e9.

sizes_test.py PROGRAM

Lengths (gap, stops, amplitudes) are multiplied by a factor, energies by its square. All numbers of
an answer must then be what they were, times the factor or its square; only the strain limit has a
size of its own, and may call more motions inadmissible.
"""
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

TIP = "--damping 0.05 --force tip --gap {gap}"
RANGE = "--from 0.9 --to 1.2"
CALLS = [
    "find 150 900 --gap {gap}",
    "find 150 900 --gap {gap} --energy-ratio 20",
    "find 140 910 --gap {gap} --energy-ratio 700",
    "find 3 8 --cells 4 --gap 0 --energy {energy}",
    "find 6 4 --cells 4 --gap -{gap}",
    "find 1 12 3 12 --cells 4 --energy-ratio 6 --gap {gap}",
    "find 1 4 L:1 4 --cells 4 --second-stop {gap} --gap {gap}",
    "find 3 25 --segments 4:1,4:1.3 --gap {gap}",
    "find --frequency 8/7 --energy-ratio 20 --gap {gap}",
    f"find 8 72 --cells 20 {TIP}",
    f"find 8 72 --cells 20 {TIP} --amplitude {{force}}",
    "find 8 72 --cells 20 --damping 0.05 --force base --gap {gap}",
    "find 5 20 --cells 10 --gap 0 --damping 0.05 --force tip --amplitude {force}",
    f"find 6 28 --segments 4:1,4:1.3 {TIP}",
    "continuum 150 900 --energy-ratio 20 --points 5 --gap {gap}",
    "continuum 3 8 --cells 4 --gap 0 --energy {energy} --points 5",
    "continuum 2 6 2 6 --cells 2 --energy-ratio 3.8 --gap {gap}",
    "modes --max-order 5 --gap {gap}",
    "modes --phases 2 --max-order 7 --gap {gap}",
    "mode 4 -1 --period 7/2 --gap {gap}",
    "families --max-order 5 --gap {gap}",
    "families --gap -{gap}",
    f"response --cells 10 {TIP} --amplitude {{force}} {RANGE} --stability",
    f"response --cells 10 {TIP} --amplitude {{force}} {RANGE} --contacts 2",
    f"response --cells 10 --damping 0.02 --force base --gap 0 --amplitude {{force}} {RANGE}",
    f"response --cells 10 --damping 0.02 --force tip --gap -{{gap}} --amplitude {{force}} {RANGE}",
    f"response --segments 4:1,4:1.3 {TIP} --amplitude {{force}} --from 1 --to 1.2",
    f"simulate --rest --cells 20 {TIP} --amplitude {{force}} --frequency 1.05 --periods 300",
    "simulate --rest --cells 20 --damping 0.05 --force base --gap -{gap} --amplitude {force}"
    " --frequency 1.05 --periods 300",
    "simulate --time 30 --gap {gap}",
    "simulate --scene 'clamp 20 gap=-{gap} spring=3 dash=1' --time 3",
    "simulate --scene 'clamp 20 driven stop={gap} dash=0.05' --amplitude {force} --frequency 1"
    " --periods 60",
    "scene clamp 150 gap={gap} 200:1.3 clamp",
    "atlas --database {folder}/{size}.sqlite --cells 8 --gap {gap}",
]
# What rounding decides, what a clock does, and what repeats the call.
LEFT_OUT = ("admissible", "events", "text", "seconds", "iterations", "detail", "residual", "march",
            "error", "certificate", "database")
ROUNDING = 1e-7


def numbers_of(value, path=""):
    """(key, number or word) of everything in an answer."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from numbers_of(inner, f"{path}.{key}")
    elif isinstance(value, list):
        yield f"{path} length", len(value)
        for place, inner in enumerate(value):
            yield from numbers_of(inner, f"{path}[{place}]")
    elif not any(word in path for word in LEFT_OUT):
        yield path, value


def is_as(one, other, size):
    """Are two values equal but for a power of the size?"""
    if isinstance(one, bool) or not isinstance(one, (int, float)) \
            or not isinstance(other, (int, float)):
        return one == other
    expected = [other * size ** power for power in (0, 1, 2)]
    tiny = 1e-12 * max(1.0, size * size)
    return any(abs(one - number) <= ROUNDING * max(abs(one), abs(number)) for number in expected) \
        or (abs(one) < tiny and abs(other) < 1e-12)


def answer(program, call, size, folder):
    """Exit status, and the answer as a dictionary of paths."""
    words = call.format(gap=repr(1e-3 * size), force=repr(3e-4 * size),
                        energy=repr(1e-6 * size * size), folder=folder, size=size)
    run = subprocess.run([program, *shlex.split(words), "--format", "json", "--quiet"],
                         capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1, 3):
        raise SystemExit(f"sizes: {words}: status {run.returncode}, {run.stderr}")
    return run.returncode, dict(numbers_of(json.loads(run.stdout)))


def main():
    """Every call at every size."""
    program = sys.argv[1]
    compared = 0
    with tempfile.TemporaryDirectory() as name:
        for call in CALLS:
            status, usual = answer(program, call, 1.0, pathlib.Path(name))
            for size in (1e-9, 1e9):
                other, scaled = answer(program, call, size, pathlib.Path(name))
                apart = sorted(set(usual) ^ set(scaled)) or [
                    f"{key}: {value}, not {usual[key]}" for key, value in scaled.items()
                    if not is_as(value, usual[key], size)]
                if other != status or apart:
                    raise SystemExit(f"sizes: {call} at {size:g}: status {other}, not {status}; "
                                     f"{apart[:5]}")
                compared += len(scaled)
    print(f"sizes: {len(CALLS)} calls, {compared} values as they should be")


if __name__ == "__main__":
    main()
