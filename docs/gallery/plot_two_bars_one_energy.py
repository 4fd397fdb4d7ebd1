"""
Two bars: motions of one energy
===============================

Two clamped bars that meet, 1 mm apart, closed for 6 steps and open for 40: no motion has less than 5.25 E₁, and at 8 E₁
they are a set of four dimensions. Its members are drawn evenly, and two of them are joined by a path of motions.
"""

import matplotlib.pyplot as plt

import signorini as sg

bars = "clamp 12 gap=1e-3 16 clamp"
members = sg.continuum("1:6", "-:40", scene=bars, energy_ratio=8, sample=True, points=400)
print(members)
print(f"proved: none has less than {members.energy_ratio_proved:.6g} E_1")

# %%
# All have one impulse, but neither one peak of force nor one of strain: between members both differ by a factor of
# almost two.

impulses = {round(point.contacts[0]["impulse"] * 1e6, 3) for point in members}
print(f"impulse in a period: {impulses} µN s")
figure, axes = plt.subplots()
axes.plot([1e3 * point.contacts[0]["peak_force"] for point in members],
          [1e3 * point.peak_strain for point in members], ".", color="#0072b2")
axes.set(xlabel="peak force at the contact  [mN]", ylabel="peak strain in compression  [10⁻³]",
         title="400 motions of the same schedule and energy")

# %%
# From the one with the least peak force to that with the most: each of the motions in between was verified.

by_force = sorted(members, key=lambda point: point.contacts[0]["peak_force"])
path = sg.continuum("1:6", "-:40", scene=bars, energy_ratio=8, points=61, start=by_force[0], to=by_force[-1])
print(path, "connected:", path.connected)
sg.plot.continuum(path)
