#!/usr/bin/env python3
"""Speeds whose energies are no numbers, frequencies as fractions, and long lists that end when they are told to.

    extremes_test.py PROGRAM
"""
import json
import signal
import subprocess
import sys
import time


def main():
    program = sys.argv[1]

    def run(*words):
        return subprocess.run([program, *words], capture_output=True, text=True, check=False)

    bar = ("simulate", "--scene", "clamp 4 stop=1e-3", "--time", "3", "--format", "json", "--velocity")
    for speed, is_allowed in (("1e200", False), ("-1e200", False), ("1e300", False), ("1e40", True), ("0", True)):
        done = run(*bar, speed)
        assert done.returncode == (0 if is_allowed else 2), (speed, done.stdout, done.stderr)
        if is_allowed:  # of m = EA L/c² = 1
            energy = json.loads(done.stdout)["energy"]
            assert abs(energy - 0.5 * float(speed) ** 2) <= 1e-12 * energy, (speed, energy)
        else:
            assert "--velocity" in done.stderr and "allowed" in done.stderr, done.stderr

    force = ("simulate", "--rest", "--force", "tip", "--amplitude", "1e-3", "--periods", "2", "--cells", "7",
             "--format", "json", "--frequency")
    one, other = run(*force, "8/7"), run(*force, repr(8 / 7))
    assert one.returncode == 0 and one.stdout == other.stdout, one.stderr
    assert "allowed" in run(*force, "8/0").stderr

    with subprocess.Popen([program, "families", "--max-order", "5000", "--quiet"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True) as listing:
        time.sleep(1)
        listing.send_signal(signal.SIGTERM)
        lines = listing.communicate(timeout=120)[0].splitlines()
    assert listing.returncode in (3, 143), listing.returncode
    assert len(lines) < 11_000 and (not lines or "not complete" in "".join(lines[:3])), len(lines)
    print("refused, read, and ended")


if __name__ == "__main__":
    main()
