"""
A bar between two walls
=======================

Nothing holds the bar: it flies from wall to wall. If it is undeformed in flight, it meets a wall with its whole
length at one speed V, is pressed for 2 L/c while a wave runs to its other end and back, and leaves as it came. Over
both gaps together, g, it flies for g/V, and all repeats after T = 4 L/c + 2 g/V. Its energy is m V²/2, m = EA L/c².
Momentum is not kept, as walls push; energy is. ``signorini.find`` is told how long contacts and flights last, no more,
and each of these motions is the one of least energy that has them: proved.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

cells, gap = 8, 1e-3  # on each side; L = c = EA = m = 1
scene = f"stop={-gap} {cells} stop={gap}"
flights = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128]  # steps of L/(8 c)
found = [sg.find(f"2:{2 * cells}", f"-:{f}", f"1:{2 * cells}", f"-:{f}", scene=scene) for f in flights]
speeds = 2.0 * gap * cells / np.array(flights)
periods = np.array([r.period for r in found])
energies = np.array([r.energy or np.nan for r in found])
impulses = np.array([r.contacts[0]["impulse"] for r in found])
print(f"period off by {max(abs(periods / (4.0 + 4.0 * gap / speeds) - 1.0)):.1e}")
print(f"energy off by {max(abs(energies / (0.5 * speeds**2) - 1.0)):.1e}")
print(f"impulse of a wall off from 2 m V by {max(abs(impulses / (2.0 * speeds) - 1.0)):.1e}")
proved = np.array([r.certificate["energy"] if r.certificate else np.nan for r in found])
print(f"proved: none has less than {min(proved / energies):.12f} of the energy")

# %%
# Slow bars move like rigid ones. Fast ones spend their time in contact: no motion of this kind is shorter than 4 L/c.

figure, law = plt.subplots(figsize=(5.5, 4), layout="constrained")
v = np.geomspace(0.8 * speeds.min(), 1.25 * speeds.max())
law.loglog(0.5 * v**2, 4.0 + 4.0 * gap / v, color="black", label="4 L/c + 2 g/V")
law.loglog(0.5 * v**2, 4.0 * gap / v, "--", color="#0072b2", label="2 g/V: a rigid body")
law.axhline(4.0, color="#999999", ls=":", label="4 L/c: two contacts")
law.loglog(energies, periods, "o", color="#d55e00", mfc="none", label="found and proved the least")
law.set(xlabel="energy m V²/2  [J]", ylabel="period T  [L/c]")
law.legend(fontsize="small")

# %%
# One of them over a period. The end that leads stops at once, the other one goes on for L/c.

sg.plot.motion(found[4])
