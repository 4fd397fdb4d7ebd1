"""
Two contacts in one period
==========================

A schedule is a list: 10 steps of contact, 120 of flight, 30 of contact, 120 of flight. All its
motions are written down exactly, too: a polytope of 38 dimensions.
"""

import signorini as sg

found = sg.find(10, 120, 30, 120, cells=40)
print(found)
print(found.solution_set, found.energy_ratio_range, found.canonical_schedule)
sg.plot.motion(found)
