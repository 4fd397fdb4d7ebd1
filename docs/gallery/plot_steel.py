"""
Steel, in newtons and hertz
===========================

A steel rod of 3 m and 1 cm², with 10 µm of play, at 494 Hz: how hard and how long is the wall
pressed, and what does the steel feel?
"""

import matplotlib.pyplot as plt
import numpy as np

import signorini as sg

steel = sg.Bar(young=210e9, density=7800, area=1e-4, length=3, gap=1e-5)
print(steel)
print(f"E₁ = {1e3 * steel.energy_unit:.2f} mJ, first frequency {steel.frequency_unit:.1f} Hz")

softest = sg.find(150, 900, bar=steel)
print(softest.physical)

energies = np.linspace(softest.energy, 20e-3, 60)
physical = [sg.find(150, 900, bar=steel, energy=energy).physical for energy in energies]
figure, both = plt.subplots(1, 3, figsize=(9, 3.6))
shown = {
    "peak force [N]": [p.peak_force for p in physical],
    "contact time [µs]": [1e6 * p.contact_time for p in physical],
    "peak stress [MPa]": [p.peak_stress / 1e6 for p in physical],
}
for axes, (name, values) in zip(both, shown.items()):
    axes.plot(1e3 * energies, values, color="#d55e00")
    axes.set(xlabel="energy [mJ]", title=name, ylim=(0, None))

# %%
# Of all motions of one energy these are the gentlest. Impulse per period is the same for all of
# them: that of 10 µm at 494 Hz.

assert np.allclose([p.impulse for p in physical], softest.physical.impulse)
