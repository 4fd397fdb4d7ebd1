"""
Two contacts in one period
==========================

Between the grids the motions with two contacts fill polygons with rational corners: beside the
period T one time is free, how contact is split in two, and the energy depends on T alone.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

figure, (split, energy) = plt.subplots(1, 2, figsize=(9, 4.8))
for mode in sg.modes(max_order=9):
    period = 1 / np.linspace(*mode.frequency_range, 202)[1:-1]  # of the bar with L/c = 1 s
    energy.plot(4 / period, mode.energy_ratio(period), color="black", lw=0.8)
polytopes = sg.modes(phases=2, max_order=9)
for polytope in polytopes:
    period = 1 / np.linspace(*polytope.frequency_range, 202)[1:-1]
    colour, width = ("#d55e00", 2.5) if polytope.free_times else ("#0072b2", 1)
    energy.plot(4 / period, polytope.energy_ratio(period), color=colour, lw=width)
    first = [[polytope.stretches(t, s)[0] for s in polytope.slice(t)] for t in period]
    split.fill_between(period, np.min(first, 1), np.max(first, 1), color=colour, lw=width)
split.set(xlabel="period T [L/c]", ylabel="first contact [L/c]", xlim=(2.2, 3.6), title="polygons")
energy.set(xlabel="ω/ω₁", ylabel="E/E₁", yscale="log", xlim=(0.5, 2), ylim=(0.9, 50))

# %%
# Three motions of one polygon, one period and one energy:

polygon = next(p for p in polytopes if p.period_range == ((5, 2), (8, 3)))
time, (low, high) = np.linspace(0, 2.6, 1041), polygon.slice(2.6)
axes = plt.figure(figsize=(8, 3.6)).subplots()
for share in (0.1, 0.3, 0.5):
    motion = polygon.motion(2.6, low + share * (high - low))
    lengths = np.diff(motion.contacts_ratio).ravel().round(3)
    axes.plot(time, motion.displacement_ratio(1, time), label=f"{lengths}")
axes.set(xlabel="t [L/c]", ylabel="tip u(L, t) [g]", title=f"{motion.energy_ratio:.4g} E₁")
axes.legend(title="contacts")
