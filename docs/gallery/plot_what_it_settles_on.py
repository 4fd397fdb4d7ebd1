"""
What a damped bar settles on
============================

The same machine, force and frequency, two starts. From rest the bar stays quiet for ever;
pulled against the wall and let go, it hammers for ever. The simulation goes from event to
event: no time step, no law of restitution.
"""

from functools import partial

import matplotlib.pyplot as plt

import signorini as sg

machine = partial(sg.simulate, damping=0.02, force="tip", amplitude=2e-4, frequency=1.15)
pulled = sg.find(50, 300, cells=100).state
runs = {
    "from rest": machine(cells=100, periods=200),
    "pulled and let go": machine(pulled, periods=200),
}

figure, both = plt.subplots(2, 1, sharex=True, sharey=True, figsize=(8, 5))
for axes, (name, run), colour in zip(both, runs.items(), ("#0072b2", "#d55e00")):
    axes.plot(run.tip_time, 1e3 * run.tip_displacement, color=colour, lw=0.8)
    axes.axhline(1, color="#999999", lw=2)
    axes.set(title=f"{name}: {run.contacts} contacts", ylabel="tip [mm]")
    print(name, run.settled, "balance of energy off by", run.balance.error, "J")
both[1].set(xlabel="t [s]", xlim=(0, 150))
