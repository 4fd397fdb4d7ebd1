"""
An animation
============

The bar over one period, coloured by its strain, with displacements enlarged, and below it u
along the bar. The step of strain that the wall makes runs back and forth for ever.
"""

import signorini as sg

found = sg.find(150, 900)
animation = sg.plot.animate(found, frames=28).animation

# %%
# ``sg.plot.animate(found, "motion.gif")`` or ``"motion.mp4"`` writes it to a file, and in a
# notebook the value of ``sg.plot.animate(found)`` plays.
