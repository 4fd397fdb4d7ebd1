"""
A forced response, with its fold
================================

A harmonic force on the tip and a dashpot of 2 %: every motion with one contact per period,
frequency by frequency. Above the resonance of the free bar there are two of them, and the
motion without any contact besides: the fold of a hardening resonance. No continuation, no time
step. The lines are what the bar settles on when the frequency goes up and down slowly: they follow
the motions that attract, and where none with one contact does they fill the gap.
"""

import matplotlib.pyplot as plt

import signorini as sg

machine = sg.response(
    damping=0.02, force="tip", amplitude=2e-4, cells=48, start=0.9, to=1.4, stability=True
)
axes = plt.figure().subplots()
looks = {True: ("#0072b2", "o"), False: ("#d55e00", "x"), None: ("#999999", "+")}
words = {True: "attracts", False: "repels", None: "unclear"}
for stable, (colour, mark) in looks.items():
    chosen = [(f.frequency_ratio, 1e3 * m.impulse) for f, m in machine.motions if m.stable is stable]
    if chosen:
        axes.plot(*zip(*chosen), mark, ms=5, color=colour, label=words[stable])
for direction, style in (("up", "-"), ("down", "--")):
    seen = sg.sweep("frequency", 0.9, 1.4, force="tip", damping=0.02, amplitude=2e-4, cells=48,
                    points=51, periods=400, direction=direction)
    axes.plot([p.frequency / 0.25 for p in seen.points], [1e3 * p.impulse for p in seen.points],
              style, lw=1, color="black", label=f"settles on, {direction}ward", zorder=0)
quiet = [f.frequency_ratio for f in machine if not f.touches]
axes.plot(quiet, [0] * len(quiet), "|", color="black", label="motion without contact")
axes.set(xlabel="frequency ω/ω₁", ylabel="impulse on the wall [mN s] per period")
axes.set_title("F = 0.2 mN, ζ = 0.02, N = 48")
axes.legend(loc="center right")
