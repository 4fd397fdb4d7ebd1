"""The limits of strain and tip that the motions of a claim keep."""
from fractions import Fraction

from .reading import NoProof, number, shown


def limit_of(certificate, name):
    """A limit of the file as a fraction; None where there is none."""
    value = certificate.get(name)
    return None if value is None else Fraction(number(value, name))


def strain_of(certificate):
    """The largest compression, in |g|/L."""
    strain = limit_of(certificate, "strain_limit")
    if strain is not None and strain <= 0:
        raise NoProof(f"strain_limit: {shown(certificate['strain_limit'])} is not > 0")
    return strain


def floor_of(certificate):
    """The lowest place of the tip, in |g|."""
    return limit_of(certificate, "tip_floor")


def within(strain, floor):
    """Limits in words."""
    words = [] if strain is None else [f"strains >= -{float(strain)!r} |g|/L"]
    words += [] if floor is None else [f"the tip >= {float(floor)!r} |g|"]
    return f" with {' and '.join(words)}" if words else ""
