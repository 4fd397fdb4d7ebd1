#!/usr/bin/env python3
"""The bar as a finite-element model with a unilateral contact at its tip, marched by Siconos.

What a user of a general code for nonsmooth mechanics would run: linear elements, lumped or
consistent mass, Moreau-Jean time stepping with theta = 1/2, Newton's impact law with e = 0.
Dense matrices: the sparse ones of Debian's Siconos 4.4 end the process.

usage: siconos_bar.py STATE.csv ELEMENTS STEPS_PER_PERIOD PERIOD PERIODS [DASHPOT AMPLITUDE PHASE]
DASHPOT at the tip in EA/c; a force AMPLITUDE cos(2 pi t/PERIOD - PHASE) pulls the tip to the wall.
STATE.csv holds columns x, displacement, velocity at equidistant nodes (units L = c = g = 1, EA = 1).
Prints one line "seconds S", then one line "t tip energy" per step.
"""
import csv
import sys
import time

import numpy as np
import siconos.kernel as sk


def read_state(path, elements):
    with open(path, newline="") as file:
        rows = [[float(v) for v in row] for row in list(csv.reader(file))[1:]]
    x, u, v = np.array(rows).T
    nodes = np.linspace(0.0, 1.0, elements + 1)[1:]
    return np.interp(nodes, x, u), np.interp(nodes, x, v)


def bar_matrices(elements):
    h = 1.0 / elements
    mass = np.zeros((elements + 1, elements + 1))
    stiffness = np.zeros_like(mass)
    for e in range(elements):
        at = np.ix_([e, e + 1], [e, e + 1])
        mass[at] += h / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
        stiffness[at] += 1.0 / h * np.array([[1.0, -1.0], [-1.0, 1.0]])
    return mass[1:, 1:], stiffness[1:, 1:]  # clamped at x = 0


def main():
    path, elements, steps, period, periods = sys.argv[1:6]
    dashpot, amplitude, phase = (float(word) for word in sys.argv[6:9] or (0.0, 0.0, 0.0))
    elements, steps, periods = int(elements), int(steps), int(periods)
    h = float(period) / steps
    q0, v0 = read_state(path, elements)
    mass, stiffness = bar_matrices(elements)

    bar = sk.LagrangianLinearTIDS(q0, v0, mass)
    bar.setKPtr(stiffness)
    if dashpot > 0.0:
        damping = np.zeros_like(mass)
        damping[-1, -1] = dashpot
        bar.setCPtr(damping)
    # A vector of Siconos: of an array of NumPy it would keep a copy.
    force = sk.SiconosVector(elements)
    force.zero()
    bar.setFExtPtr(force)
    tip = np.zeros((1, elements))
    tip[0, -1] = -1.0  # gap 1 - u(L) >= 0
    relation = sk.LagrangianLinearTIR(tip, np.array([1.0]))
    contact = sk.Interaction(sk.NewtonImpactNSL(0.0), relation)
    model = sk.NonSmoothDynamicalSystem(0.0, h * steps * periods)
    model.insertDynamicalSystem(bar)
    model.link(contact, bar)
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, h), sk.MoreauJeanOSI(0.5), sk.LCP())

    lines = []
    started = time.perf_counter()
    for k in range(1, steps * periods + 1):
        # Constant in a step, as the state is marched with it.
        push = amplitude * np.cos(2.0 * np.pi * (k - 0.5) / steps - phase)
        force.setValue(elements - 1, push)
        simulation.computeOneStep()
        q, v = bar.q(), bar.velocity()
        lines.append((k * h, q[-1], 0.5 * v @ mass @ v + 0.5 * q @ stiffness @ q))
        simulation.nextStep()
    print("seconds", time.perf_counter() - started)
    for line in lines:
        print(*line)


if __name__ == "__main__":
    main()
