"""
The paper's Figure 2: a continuum of one energy
===============================================

201 motions of one schedule, one period and one energy, 20 E₁. The pulse of force on the wall
splits in two; λ is the pause between them. Strain and velocity along the bar when contact
begins.
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

curve = sg.continuum(150, 900, energy_ratio=20)
print(curve, "connected:", curve.connected, "dimension:", curve.dimension)
strain = np.array([point.state.strain for point in curve])
velocity = np.array([point.state.velocity for point in curve])

figure, both = plt.subplots(1, 2, sharey=True)
x = curve[0].state.x
for axes, values, name in zip(both, (strain, velocity), ("strain s(x, 0)", "velocity v(x, 0) [m/s]")):
    image = axes.pcolormesh(x, curve.lambda_, values, cmap="RdBu", vmin=-0.01, vmax=0.01)
    axes.set(title=name, xlabel="x [m]")
    figure.colorbar(image, ax=axes, location="bottom")
both[0].set_ylabel("λ: pause of the force [L/c]")

# %%
# Each of the motions was verified independently of the code that made it:

print("worst residual", curve.residual.max(), "energies", {round(p.energy_ratio, 9) for p in curve})
