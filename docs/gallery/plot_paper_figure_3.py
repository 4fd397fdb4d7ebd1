"""
The paper's Figure 3: two motions of one energy
===============================================

Both ends of that continuum: the displacement of every cross-section over one period. The black
line is the tip; it meets the wall, is held there, and leaves.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

curve = sg.continuum(150, 900, energy_ratio=20)
figure = plt.figure(figsize=(9, 5))
x, t = np.linspace(0, 1, 61), np.linspace(0, 3.5, 211)
for place, point in enumerate((curve[0], curve[-1]), start=1):
    axes = figure.add_subplot(1, 2, place, projection="3d")
    u = 1e3 * point.motion.displacement(x[None, :], t[:, None])
    axes.plot_surface(t[:, None], x[None, :], u, cmap="viridis", rstride=3, cstride=3, alpha=0.8)
    axes.plot(t, np.ones_like(t), u[:, -1], color="black", lw=2, zorder=10)
    axes.set(xlabel="t [s]", ylabel="x [m]", title=f"u [mm], {('first', 'last')[place - 1]} motion")
    axes.view_init(25, 65)
