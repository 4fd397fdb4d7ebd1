"""Schedules of a range, each once: of those that differ in where they begin the first."""
import itertools


def each_once(run, places):
    """Tuples of phases (n_c, n_f, place), up to the number of phases of a run."""
    phases = list(itertools.product(range(1, run["max_contact"] + 1), range(1, run["max_free"] + 1), places))
    for count in range(1, run["phases"] + 1):
        for chosen in itertools.product(phases, repeat=count):
            if all(chosen <= chosen[k:] + chosen[:k] for k in range(1, count)):
                yield chosen
