"""Several contacts on no grid, against formulas, grids and the wall."""

from __future__ import annotations

import math

import numpy as np
import pytest

import signorini as sg


@pytest.fixture(scope="module")
def polygon() -> sg.ModePolytope:
    """Chains 2/1 and 2/2: docs/theory.md, section 18, has it by formulas."""
    found = [p for p in sg.modes(phases=2, max_order=3)
             if p.period_range == ((5, 2), (8, 3))]
    assert len(found) == 1 and found[0].free_times == 1
    return found[0]


def test_a_polygon_is_the_one_of_the_table(polygon: sg.ModePolytope) -> None:
    for period in np.linspace(2.5, 8 / 3, 7)[1:-1]:
        assert polygon.energy_ratio(period) == \
            pytest.approx(1 / (2 * period - 5) ** 2)
        ends = polygon.slice(period)
        assert ends.shape == (2, 1)
        for share in (0.0, 0.2, 0.9):
            arrivals = ends[0] + share * (ends[1] - ends[0])
            c_1, f_1, c_2, f_2 = polygon.stretches(period, list(arrivals))
            assert f_1 == pytest.approx(2 * period - 4)
            assert f_2 == pytest.approx(2 * period - 4)
            assert c_1 + c_2 == pytest.approx(8 - 3 * period)
        lengths = sorted(polygon.stretches(period, list(end))[0]
                         for end in ends)
        assert lengths == pytest.approx([0, 8 - 3 * period], abs=1e-12)


def test_a_motion_is_that_of_its_schedule() -> None:
    """gcd(2N, n) = 1: the schedule has one motion, and a march knows it."""
    for words in ((1, 26, 6, 26), (3, 26, 4, 26)):
        grid = sg.find(*words, cells=23)
        polytope = sg.polytope(*words, cells=23)
        assert polytope is not None and grid.status == "found"
        contact, free = words[:2]
        arrival = (contact + free) / 23
        motion = polytope.motion(grid.period_ratio, [arrival])
        assert motion.energy_ratio == pytest.approx(529 / 9)
        assert motion.energy_ratio == pytest.approx(grid.energy_ratio)
        assert motion.physical.impulse == \
            pytest.approx(grid.physical.impulse)
        x, t = np.random.default_rng(18).uniform((0, 0), (1, 3), (300, 2)).T
        np.testing.assert_allclose(motion.displacement(x, t),
                                   grid.motion.displacement(x, t), atol=1e-14)
        np.testing.assert_allclose(motion.state(23).a, grid.state.a,
                                   atol=1e-12)
        assert grid.schedule in polytope.schedules(23, 59) or \
            sg.Schedule(*words[2:], *words[:2], cells=23) in \
            polytope.schedules(23, 59)


def test_motions_obey_the_wall_at_random_points() -> None:
    dice = np.random.default_rng(7)
    listed = list(sg.modes(phases=2, max_order=7)) + \
        list(sg.modes(phases=3, max_order=5))
    assert len(listed) > 20
    for polytope in listed:
        low, high = (p / q for p, q in polytope.period_range)
        period = low + (high - low) * dice.uniform(0.1, 0.9)
        corners = polytope.slice(period)
        shares = dice.dirichlet(np.ones(len(corners)))
        motion = polytope.motion(period, list(shares @ corners))
        t = dice.uniform(0, period, 400)
        held = np.zeros(t.shape, bool)
        for start, end in motion.contacts_ratio:
            held |= (start <= t) & (t < end)
        tip = motion.displacement_ratio(1.0, t)
        np.testing.assert_allclose(tip[held], 1.0, atol=1e-9)
        assert tip.max() <= 1 + 1e-9
        force = motion.wall_force_ratio(t)
        assert (force[held] > 0).all() and not force[~held].any()
        # A free tip has no strain, and the clamp does not move.
        np.testing.assert_allclose(motion.strain_ratio(1.0, t[~held]), 0.0,
                                   atol=1e-9)
        np.testing.assert_allclose(motion.displacement_ratio(0.0, t), 0.0,
                                   atol=1e-9)
        np.testing.assert_allclose(
            motion.displacement_ratio(0.3, t + period),
            motion.displacement_ratio(0.3, t), atol=1e-9)
        # The energy, added up over cells that are finer than the waves.
        state = motion.state(4000)
        assert state.energy_ratio == \
            pytest.approx(motion.energy_ratio, rel=0.05)
        total = sum(e - s for s, e in motion.contacts_ratio)
        p, q = polytope.contact
        assert total == pytest.approx(p + q * period)
        assert motion.contact_time_ratio == pytest.approx(total)


def test_points_outside_are_refused(polygon: sg.ModePolytope) -> None:
    with pytest.raises(ValueError, match="allowed"):
        polygon.motion(2.7)
    with pytest.raises(ValueError, match="allowed"):
        polygon.slice(math.nan)
    with pytest.raises(ValueError):
        polygon.motion(2.6, [0.1])
    with pytest.raises(ValueError):
        polygon.motion(2.6, [0.1, 0.2])
    with pytest.raises(ValueError, match="gap > 0"):
        sg.modes(phases=2, gap=-1e-3)
    with pytest.raises(ValueError, match="phases = 6"):
        sg.modes(phases=6)  # type: ignore[call-overload]
    with pytest.raises(ValueError, match="allowed"):
        sg.polytope(150, 900)


def test_a_schedule_without_motion_is_in_no_polytope() -> None:
    assert sg.find(1, 3, 1, 2, cells=4).status == "none"
    assert sg.polytope(1, 3, 1, 2, cells=4) is None
