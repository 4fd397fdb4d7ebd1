#!/usr/bin/env python3
"""Spoils the library in one place at a time and looks whether its tests notice.

    mutations.py [--folder build/mutants] [--floor sets|check|geometry] [--file NAME] [--count N]
                 [--tests PROGRAMS] [--cmake OPTIONS] [--again] [--list]

A mutant is a comparison, a bound, a sign or a logical word of src/<floor> that became another one. A copy
of the tree is built once with all of them in it, each switched by its number (schemata.py). Then every test
case runs alone without a mutant, which tells its time and which mutants it meets, and every mutant is tried
with the cases that meet it, the quickest first. What is known stays in FOLDER/results.txt: a second run
tries what is new or survived (all of it: --again). Survivors are held against mutants.txt, which explains
those that cannot or need not be noticed. Exit status 1 if some are unexplained.
"""
import argparse
import hashlib
import json
import os
import re
import resource
import shlex
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
TESTS = ["geometry-tests", "paper-tests", "sets-tests", "forms-tests", "contract-tests", "find-tests",
         "explore-tests"]
FLOORS = ["geometry", "check", "sets"]
MEMORY = 4 << 30


def write(path, data):
    """Leaves a file alone that says this already, so that nothing is built again for it."""
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def copy(tree, build, extra):
    """Copies what git knows, but for the code to be spoilt, and configures; returns the code's names."""
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split("\n")
    spoilt = re.compile(r"src/(%s)/\w+\.[ch]pp" % "|".join(FLOORS))
    names = sorted(name for name in names if (ROOT / name).is_file())
    for name in names:
        if not spoilt.fullmatch(name) or not (tree / name).exists():
            write(tree / name, (ROOT / name).read_bytes())
    subprocess.run(["cmake", "-G", "Ninja", "-S", tree, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *shlex.split(extra)],
                   check=True, stdout=subprocess.DEVNULL)
    return list(filter(spoilt.fullmatch, names))


def mutate(folder, extra):
    """Writes the copy, with mutants; returns these: number: (file, line, name)."""
    import schemata
    tree, known = folder / "tree", folder / "mutants.json"
    names = copy(tree, tree / "build/release", extra)
    texts = {name: (ROOT / name).read_text(encoding="utf-8") for name in names}
    digest = hashlib.sha256(repr([texts, Path(schemata.__file__).read_text()]).encode()).hexdigest()
    if known.exists():
        before, mutants = json.loads(known.read_text())
        if before == digest:
            return {int(number): mutant for number, mutant in mutants.items()}
    commands = {Path(entry["file"]).parent.name: shlex.split(entry["command"])
                for entry in json.loads((tree / "build/release/compile_commands.json").read_text())
                if "/tree/src/" in entry["file"]}
    files = {name: schemata.Schemata(text, 1 + 500 * k) for k, (name, text) in enumerate(texts.items())}
    for floor in FLOORS:  # no two names of a floor are the same, so it can be read at once
        of_floor = {str(tree / name): file for name, file in files.items()
                    if name.startswith(f"src/{floor}/")}
        flags = [f for f in commands[floor][1:] if f.startswith(("-I", "-D", "-std", "/usr", "-isystem"))]
        for error in schemata.read(of_floor, flags):
            print(error, file=sys.stderr)
    mutants, seen = {}, Counter()
    for name, file in files.items():
        write(tree / name, file.text(tree / "tests/robustness/mutants.hpp").encode())
        for number, mutant in file.mutants.items():
            # A name that outlives other changes of the file: the line's text, counted where it is repeated.
            text = f"{name}: {mutant.text} -> {mutant.change}"
            seen[text] += 1
            mutants[number] = name, mutant.line, text + (f" ({seen[text]})" if seen[text] > 1 else "")
    known.write_text(json.dumps([digest, mutants]))
    return mutants


def run(build, test, names, mutant=0, met="", limit=600.0):
    """Runs test cases of a program, limited in memory and seconds of CPU: None, or how it failed."""
    def limits():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))

    chosen = build / f"cases-{os.getpid()}.txt"
    chosen.write_text("".join(re.sub(r"([\\,\[])", r"\\\1", name) + "\n" for name in names), encoding="utf-8")
    try:
        status = subprocess.run(
            [build / "bin" / test, "-a", "-w", "NoTests", "-f", chosen], cwd=build, timeout=30 * limit, check=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=limits, env=os.environ | {"SIGNORINI_MUTANT": str(mutant), "RC_PARAMS": "seed=1",
                                                 "SIGNORINI_MUTANTS_RUN": str(met)}).returncode
    except subprocess.TimeoutExpired:
        return "without end"
    return f"status {status}" if status else None


def seconds():
    """CPU time of the programs run so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def baseline(build, test, slowest):
    """Every test case of a program alone: [seconds, program, name, numbers of the mutants that it meets]."""
    program, known, met = build / "bin" / test, build / f"{test}.json", build / f"met-{os.getpid()}.txt"
    if known.exists() and known.stat().st_mtime > program.stat().st_mtime:
        return json.loads(known.read_text())
    names = subprocess.run([program, "--list-test-names-only"], capture_output=True, text=True,
                           check=False).stdout.splitlines()
    cases = []
    for name in filter(None, names):
        begin = seconds()
        met.write_text("")
        failed = run(build, test, [name], 0, met)
        if failed:
            sys.exit(f"{test} '{name}' fails without any mutant: {failed}")
        took = seconds() - begin
        if took <= slowest:
            cases.append([took, test, name, list(map(int, met.read_text().split()))])
        else:
            print(f"left out, {took:.0f} s: {test} '{name}'", flush=True)
    known.write_text(json.dumps(cases))
    return cases


def try_mutant(build, number, cases):
    """The first test that notices; None if the mutant survives."""
    quick = [case for case in cases if case[0] < 0.1]
    groups = [(test, [case for case in quick if case[1] == test]) for test in TESTS]
    groups += [(case[1], [case]) for case in cases if case[0] >= 0.1]
    for test, group in groups:
        if group:
            limit = 5 * sum(case[0] for case in group) + 0.5
            how = run(build, test, [case[2] for case in group], number, limit=limit)
            if how:
                return test + (f" '{group[0][2]}'" if len(group) == 1 else "") + f": {how}"
    return None


def explanations():
    """mutants.txt: keys, each with the reason (the comment) above it."""
    path, reason, result = HERE / "mutants.txt", "", {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        if line.startswith("#"):
            reason = line[1:].strip()
        elif line.strip():
            result[line.strip()] = reason
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--folder", type=Path, default=ROOT / "build/mutants")
    parser.add_argument("--floor", choices=FLOORS)
    parser.add_argument("--file", default="", help="only files whose name contains this")
    parser.add_argument("--count", type=int, help="every so many of them, to have about this many")
    parser.add_argument("--slowest", type=float, default=10,
                        help="test cases that take more seconds are left out")
    parser.add_argument("--tests", default=",".join(TESTS), help="the programs that are asked")
    parser.add_argument("--cmake", default="", help="more options of the build")
    parser.add_argument("--again", action="store_true", help="tries what is known to be noticed, too")
    parser.add_argument("--list", action="store_true", help="all mutants, and build nothing")
    options = parser.parse_args()
    folder = options.folder.resolve()
    build, results = folder / "tree/build/release", folder / "results.txt"
    mutants = mutate(folder, options.cmake)
    chosen = [n for n, (file, _, _) in mutants.items()
              if file.startswith(f"src/{options.floor or ''}") and options.file in file]
    if options.count:
        chosen = chosen[::max(1, len(chosen) // options.count)]
    if options.list:
        for n in chosen:
            print(n, *mutants[n][1:])
        return 0
    tests = options.tests.split(",")
    subprocess.run(["ninja", "-C", build, "-j", os.environ.get("JOBS", "1"), *tests], check=True)
    cases = sorted(sum((baseline(build, test, options.slowest) for test in tests), []))
    # What survived these very programs is not tried again.
    stamp = " ".join(f"{test}:{(build / 'bin' / test).stat().st_mtime:.0f}" for test in tests)
    results.touch()
    known = [json.loads(line) for line in results.read_text().splitlines() if not options.again]
    noticed = {name: how for name, how, when in known if how or when == stamp}
    explained = explanations()
    survivors, in_vain = Counter(), 0
    for n in chosen:
        _, line, name = mutants[n]
        meeting = [case for case in cases if n in case[3]]
        if name not in noticed:
            noticed[name] = try_mutant(build, n, meeting)
            with results.open("a") as out:  # one write a line: several campaigns share the file
                out.write(json.dumps([name, noticed[name], stamp]) + "\n")
        if not noticed[name]:
            what = "explained" if name in explained else "SURVIVES" if meeting else "NEVER MET"
            survivors[what] += 1
            if name not in explained:
                print(f"{what} {line} {name}", flush=True)
    names = {name for _, _, name in mutants.values()}
    for name in explained:
        if name not in names or noticed.get(name):
            print(f"EXPLAINED IN VAIN {name}")
            in_vain += 1
    print(f"{len(chosen)} of {len(mutants)} mutants: {len(chosen) - survivors.total()} noticed, "
          + ", ".join(f"{count} {what.lower()}" for what, count in sorted(survivors.items())))
    return 1 if in_vain or set(survivors) - {"explained"} else 0


if __name__ == "__main__":
    sys.exit(main())
