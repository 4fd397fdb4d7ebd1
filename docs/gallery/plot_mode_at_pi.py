"""
A mode at T = π
===============

Between the rational periods of the grids lie the others. There a motion is unique, and given by
a few integers: of the main mode the contact time is 4 − T and 1/√(E/E₁) = T − 3, for every T
between 3 and 4.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

motion = sg.mode(4, -1, np.pi)
print(motion, "energy", motion.energy_ratio, "=", 1 / (np.pi - 3) ** 2)

x, t = np.linspace(0, 1, 201), np.linspace(0, np.pi, 629)
figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(8, 6), height_ratios=(3, 1))
u = motion.displacement_ratio(x[:, None], t[None, :])
image = above.pcolormesh(t, x, u, cmap="viridis", shading="gouraud")
figure.colorbar(image, ax=above, label="displacement [g]")
above.set_ylabel("x [L]")
below.plot(t, motion.wall_force_ratio(t), color="#d55e00")
below.set(xlabel="t [L/c]", ylabel="force of the\nwall [EA g/L]")
assert np.isclose(motion.energy_ratio, motion.mode.energy_ratio(np.pi))
