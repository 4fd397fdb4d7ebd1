"""
A striker, a rod and a soft root
================================

A free bar flies against a long rod, as in a Hopkinson bar or under a rock drill. While it pushes, the end of the rod
moves in steps: V ρ γ^k in the k-th interval of 2 L/c of the striker, with ρ = Z/(Z + Z') and γ = (Z - Z')/(Z + Z').
"""

import math

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

length, speed = 1.0, 1.0  # of the striker, in a scene of 16 m
figure, pushes = plt.subplots(layout="constrained")
for impedance, colour in ((1.0, "black"), (3.0, "#0072b2"), (9.0, "#d55e00")):
    scene = f"20:{impedance} gap=1e-3 300 stop=1"
    ends = np.arange(1, 7) * 2.0 * length
    impulses = []
    for end in ends:
        seen = sg.simulate(scene=scene, length=16, velocity=[speed, 0.0],
                           time=1e-3 / speed + end)
        impulses.append(seen.contacts[0]["impulse"])
    rho, gamma = impedance / (impedance + 1.0), (impedance - 1.0) / (impedance + 1.0)
    steps = 2.0 * length * speed * rho * gamma ** np.arange(len(ends))
    print(f"Z = {impedance:g} Z': off by {max(abs(impulses - np.cumsum(steps))):.1e}")
    pushes.plot(ends, impulses, "o", color=colour, mfc="none")
    pushes.plot(np.append(0.0, ends), np.append(0.0, np.cumsum(steps)), color=colour,
                label=f"Z = {impedance:g} Z'")
pushes.set(xlabel="time since they met  [L/c]", ylabel="impulse  [N s]")
pushes.legend(fontsize="small")

# %%
# Springs and masses are short lines of half a step: energy is kept to rounding, and the one error falls as 1/N².
# Here the first frequency of a bar on a spring of 2 EA/L against the root of k tan k = 2.

low, high = 0.0, 0.5 * math.pi
for _ in range(60):
    middle = 0.5 * (low + high)
    low, high = (middle, high) if middle * math.tan(middle) < 2.0 else (low, middle)
cells = [10, 20, 40, 80, 160]
off = []
for n in cells:
    first = sg.find(1, 4 * n, scene=f"spring=2 {n} stop=1e-3").reference["frequency"] or math.nan
    off.append(abs(2.0 * math.pi * first / low - 1.0))
print("orders", np.round(np.log2(np.divide(off[:-1], off[1:])), 3))
figure, errors = plt.subplots(layout="constrained")
errors.loglog(cells, off, "o-", color="black")
errors.set(xlabel="cells N", ylabel="relative error of ω₁")
