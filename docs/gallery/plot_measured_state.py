"""
From a simplex to a measured state
==================================

All motions of a schedule form a simplex, here of 149 dimensions. Gauges saw one of them, with
noise, at 25 places. Which one was it? The nearest, and the answer says how near.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

truth = sg.continuum(150, 900, energy_ratio=8).member(0.1)
place = np.linspace(0.02, 0.98, 25)
cell = (300 * place).astype(int)
noise = np.random.default_rng(2019).normal(0, 2e-4, (2, place.size))
velocity = truth.state.velocity[cell] + noise[0]
strain = truth.state.strain[cell] + noise[1]
table = np.column_stack([place, velocity, strain])
np.savetxt("gauges.csv", table, delimiter=",", header="x,velocity,strain", comments="")

found = sg.find(150, 900, objective="nearest", target="gauges.csv")
print(f"{found.status}: E = {found.energy_ratio:.3f} E₁, relative distance {found.distance:.3f}")

figure, both = plt.subplots(2, 1, sharex=True, figsize=(8, 6))
for axes, name, measured in zip(both, ("strain", "velocity"), (strain, velocity)):
    axes.step(truth.state.x, getattr(truth.state, name), color="#999999", lw=4, label="what it was")
    axes.step(found.state.x, getattr(found.state, name), color="#0072b2", label="nearest motion")
    axes.plot(place, measured, "o", color="#d55e00", label="measured")
    axes.set_ylabel(name)
both[0].legend(ncol=3, loc="lower center", bbox_to_anchor=(0.5, 1))
both[1].set_xlabel("x [m]")
