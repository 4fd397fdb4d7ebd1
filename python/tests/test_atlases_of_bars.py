"""Atlases of several bars, and of one bar that is more than uniform."""

from __future__ import annotations

from pathlib import Path

import pytest
from support import Program

import signorini as sg

BARS = "clamp 3 stop=1e-3 gap=2e-3 4 clamp"


def test_an_atlas_of_bars_is_that_of_the_program(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "bars.sqlite"
    atlas = sg.Atlas.build(path, scene=BARS, length=0.7, wave_speed=5000, max_contact=3,
                           max_free=20, all=True)
    run = atlas.runs[0]
    assert run.finished and run.cells == 7 and run.decided == 120 and run.scene
    said = program("atlas", "--database", path, "--period", "16/7", "--schedules")
    rows = atlas.schedules_of_period("16/7")
    assert said["schedules"] == [row.to_dict() for row in rows] and len(rows) == 6
    found = atlas.schedules()
    assert len(found.frame()) == len(found) == run.found > 5
    for row in found[:6]:
        assert row.schedule is None and row.spans is not None
        sets = ["+".join(map(str, span["closed"])) or "-" for span in row.spans]
        words = [f"{name}:{span['steps']}" for name, span in zip(sets, row.spans)]
        motion = sg.find(words[0], *words[1:], scene=BARS, length=0.7, wave_speed=5000)
        assert row.energy_range is not None and motion.energy == pytest.approx(row.energy_range[0])
        assert motion.period == pytest.approx(row.period)
    # Opened anew, the file knows its bars.
    again = sg.Atlas(path)
    told = again.schedules().to_dict()
    assert told["scene"]["length"] == 0.7 and "bar" not in told
    assert again.schedules()[0] == found[0]
    first = found[0].energy_ratio_range
    assert found[0].frequency_ratio is not None and first is not None
    near = again.schedules_near(found[0].frequency_ratio, first[0], within=0.01)
    assert found[0] in list(near)


def test_atlases_of_segments_and_of_bars_with_weight(tmp_path: Path) -> None:
    stepped = sg.Atlas.build(tmp_path / "a.sqlite", segments=[(2, 1), (2, 1.3)], max_contact=3,
                             max_free=17)
    assert stepped.runs[0].cells == 4 and stepped.runs[0].scene is None
    two = sg.Atlas.build(tmp_path / "b.sqlite", scene="clamp 2 2:1.3 stop=1e-3 stop=-2e-3",
                         max_contact=3, max_free=17)
    assert two.runs[0].scene and two.runs[0].decided == 2 * stepped.runs[0].decided
    axes = sg.plot.existence_map(two, contact=2)
    assert "contact 2" in axes.get_ylabel()
    with pytest.raises(ValueError, match="contact = 3 is out of range"):
        sg.plot.existence_map(two, contact=3)
    axes = sg.plot.frequency_energy(two)
    contacts = {row.spans[0]["closed"][0] for row in two.schedules() if row.spans}
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        f"contact {contact} presses" for contact in sorted(contacts)]
    seen = {round(x, 9) for line in axes.get_lines() for x in line.get_xdata()}
    assert seen == {round(row.frequency_ratio or 0.0, 9) for row in two.schedules()}
    axes = sg.plot.frequency_energy(stepped, data=[(9.0, 20.0)])
    assert axes.get_xlim()[1] > 9.0
    axes = sg.plot.frequency_energy(stepped, max_frequency_ratio=1.2, max_energy_ratio=9)
    assert axes.get_xlim()[1] == pytest.approx(1.2)
    assert axes.get_ylim()[1] == pytest.approx(9)
    with pytest.raises(ValueError, match="cells: allowed only without a scene"):
        sg.Atlas.build(tmp_path / "d.sqlite", scene=BARS, cells=9)
    heavy = sg.Atlas.build(tmp_path / "c.sqlite", cells=4, gravity=1e-4, max_contact=3,
                           max_free=17)
    assert heavy.runs[0].scene and heavy.runs[0].undecided == 0
    with pytest.raises(ValueError, match="for bars in a row"):
        sg.Atlas.build(tmp_path / "d.sqlite", scene=BARS, families_only=True)
