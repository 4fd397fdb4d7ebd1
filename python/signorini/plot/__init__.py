"""Figures with matplotlib, in the colours of all figures of the project.

Each function draws into a new figure, or into what it is given, and returns
its axes: what is not to your liking can be changed there, and your own data
go over it. Units are SI with a prefix, or the ratios E/E_1 and omega/omega_1.
"""

from ._animate import Animation, animate
from ._motion import continuum, motion, scene
from ._plane import existence_map, families, frequency_energy, polytopes
from ._response import response, simulation, study, sweep
from ._style import colours, unit_for

__all__ = ["Animation", "animate", "colours", "continuum", "existence_map",
           "families", "frequency_energy", "motion", "polytopes", "response",
           "scene", "simulation", "study", "sweep", "unit_for"]
