"""What a notebook shows, asks for and puts into frames."""

from __future__ import annotations

import io
import pickle
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from matplotlib import pyplot
from PIL import Image

import signorini as sg

FORCED: dict[str, Any] = {"damping": 0.02, "force": "tip", "amplitude": 2e-4}
NEVER_CLOSED = {"img", "br"}


class Page(HTMLParser):
    """Cells of all tables and other text; what is wrongly nested fails."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.rows: list[list[str]] = []
        self.said = ""
        self.attributes: list[tuple[str, str, str | None]] = []
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag: str,
                        attrs: list[tuple[str, str | None]]) -> None:
        self.attributes += [(tag, *pair) for pair in attrs]
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag not in NEVER_CLOSED:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "td" in self.open or "th" in self.open:
            self.rows[-1][-1] += data
        elif "style" not in self.open:
            self.said += data

    @property
    def values(self) -> dict[str, str]:
        """Of rows with a name and a value."""
        return {row[0]: row[1].strip() for row in self.rows if len(row) == 2}

    def under(self, title: str) -> list[dict[str, str]]:
        """The rows of a list: what stands under each of its headings."""
        at = next(k for k, row in enumerate(self.rows)
                  if row[0].startswith(f"{title}: "))
        heads = self.rows[at + 1]
        return [dict(zip(heads, row)) for row in self.rows[at + 3:]
                if len(row) == len(heads)]


def page_of(record: Any) -> Page:
    """What is shown, with nothing from elsewhere in it."""
    page = Page(record._repr_html_())
    for tag, name, value in page.attributes:
        assert name not in ("onclick", "href"), value
        if name == "src":
            assert (value or "").startswith("data:image/png;base64,"), tag
    assert "://" not in record._repr_html_()  # a picture in base64 has no colon
    return page


def png_of(record: Any) -> bytes | None:
    """The figure beside the table."""
    drawn: bytes | None = record._repr_png_()
    return drawn


def size_of(record: Any) -> tuple[int, int]:
    """Of the figure in pixels."""
    image = Image.open(io.BytesIO(png_of(record) or b""))
    assert image.format == "PNG"
    image.load()
    low, high = image.convert("L").getextrema()
    assert low < 100 and high > 200, "nothing is drawn"
    width, height = image.size
    return width, height


def test_a_motion_that_was_found() -> None:
    answer = sg.find(150, 900, young=210e9, density=7800, area=1e-4,
                     length=3, gap=1e-5)
    page = page_of(answer)
    assert "found, there is such a motion" in page.said
    values = page.values
    assert values["schedule"] == "150:900"
    assert f"{(210e9 / 7800) ** 0.5:.6g} m/s" in values["bar"]
    assert values["energy_ratio"] == "4"
    # T = 3.5 L/c.
    assert values["period"] == f"{3.5 * 3 / (210e9 / 7800) ** 0.5:.6g} s"
    assert values["physical.impulse"] == f"{answer.physical.impulse:.6g} N s"
    assert "certificate" not in values
    assert answer.found and bool(answer) is True
    width, height = size_of(answer)
    assert 500 < width < 1000 and 400 < height < 800
    assert size_of(answer.motion) == (width, height)


def test_none_says_why_and_has_no_figure() -> None:
    answer = sg.find(150, 1200)
    page = page_of(answer)
    assert "none, it is proved that there is none (penetration)" in page.said
    assert "kind = farkas, verified = yes" in page.values["certificate"]
    assert not page.values["certificate"].endswith("=")
    assert "energy" not in page.values
    assert not any(tag == "img" for tag, _, _ in page.attributes)
    assert png_of(answer) is None
    assert answer.found is False and bool(answer) is False


def test_undecided_is_not_found() -> None:
    stepped = [(3, 1.0), (3, 3.0)]
    answers: list[Any] = [
        sg.find(5, 26, energy_ratio=30, segments=stepped),
        sg.find(1, 11, cells=6, damping=0.3, force="base", amplitude=1e-3)]
    for answer in answers:
        assert answer.status == "undecided" and answer.detail
        page = page_of(answer)
        assert "undecided, neither a motion nor a proof" in page.said
        assert answer.detail in page.said
        assert answer.found is bool(answer) is False
    assert png_of(answers[0]) is None
    assert page_of(sg.find(5, 26, segments=stepped)).under("segments")


def test_forced_motions() -> None:
    answer = sg.find(10, 60, cells=20, **FORCED)
    page = page_of(answer)
    assert answer and page.values["amplitude"] == "0.0002 N"
    row, = page.under("motions")
    assert row["schedule"] == "10:60" and row["free_steps"] == "60"
    assert float(row["impulse"]) == pytest.approx(answer.motions[0].impulse,
                                                  rel=1e-5)
    assert not sg.find(10, 60, cells=20, damping=0.02, force="tip",
                       amplitude=1.0).found
    based = sg.find(10, 60, cells=20, damping=0.02, force="base")
    assert page_of(based).values["amplitude"].endswith(" m")


def test_a_response_is_found_where_it_has_motions() -> None:
    some = sg.response(cells=10, **FORCED)
    none = sg.response(cells=10, damping=0.5, force="tip", amplitude=1e-6)
    assert some.status == none.status == "found"
    assert some.found and bool(some) and not none.found and not bool(none)
    page = page_of(some)
    assert f"complete: {len(some.motions)} with one contact" in page.said
    assert page.values["amplitude"] == "0.0002 N"
    assert [int(row["steps"]) for row in page.under("frequencies")] == [
        at.steps for at in some[:10]]
    assert size_of(some) == size_of(none)


def test_questions_sweeps_and_simulations() -> None:
    question = sg.find(period="7/2", cells=30)
    assert question and page_of(question).under("motions")[0][
        "schedule"] == "15:90"
    none = sg.find(period=7, cells=30)
    assert not none and (none.detail or "?") in page_of(none).said
    run = sg.simulate(frequency=1.1, periods=40, cells=20, **FORCED)
    page = page_of(run)
    assert page.values["contacts"] == str(run.contacts)
    assert "amplitude = 0.0002 N," in page.values["excitation"]
    size_of(run)
    silent = sg.simulate(frequency=1.1, periods=3, cells=20, tip=False,
                         **FORCED)
    assert png_of(silent) is None and page_of(silent).said
    swept = sg.sweep("frequency", 0.9, 1.2, points=4, cells=10, **FORCED)
    page = page_of(swept)
    assert [row["direction"] for row in page.under("points")] == [
        "up"] * 4 + ["down"] * 4
    size_of(swept)
    assert len(swept.frame()) == 8
    assert swept and run, "what is followed is there"


def test_a_scene_is_its_parts() -> None:
    scene = sg.Scene(sg.Bar(gap=1e-3), 2e-3,
                     [sg.Segment(10, 2.0), sg.Segment(20)])
    page = page_of(scene)
    assert page.values["stops"] == "right 0.001, left -0.002 m"
    assert [(row["cells"], row["impedance"])
            for row in page.under("segments")] == [("10", "2"), ("20", "1")]


def test_a_long_table_shows_its_head() -> None:
    bar = sg.Bar(gap=1e-3)
    rows = list(sg.families(60))[:1000]
    assert len(rows) == 1000
    page = page_of(sg.Table("families", rows, bar=bar))
    assert any(row[0].startswith("families: 1000, the first 10 of them")
               for row in page.rows)
    shown = page.under("families")
    assert len(shown) == 10
    assert [int(row["order"]) for row in shown] == [
        row.order for row in rows[:10]]
    size_of(sg.families())
    assert page_of(sg.families()[3]).said
    assert page_of(sg.Table("families", [])).said == "Table of families"
    assert png_of(sg.Table("families", [])) is None


def test_what_is_shown_is_escaped() -> None:
    evil = "<script>alert('&')</script>"
    table: sg.Table[Any] = sg.Table("<b>", sg.families()[:2], max_order=evil)
    assert page_of(table).values["max_order"] == evil
    assert "<script" not in table._repr_html_()


def test_figures_leave_pyplot_alone() -> None:
    figure = pyplot.figure()
    axes = figure.add_subplot()
    pyplot.sca(axes)
    for record in (sg.find(15, 90, cells=30), sg.families(),
                   sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)):
        assert size_of(record)
        assert pyplot.get_fignums() == [figure.number]
        assert pyplot.gca() is axes and not axes.has_data()


def test_a_figure_is_of_what_is_asked_for() -> None:
    one, other = sg.find(15, 90, cells=30), sg.find(16, 96, cells=32, gap=2e-3)
    first, second = png_of(one), png_of(other)
    assert first and second and first != second
    assert png_of(one) == first


def test_the_same_question_has_the_same_answer(tmp_path: Path) -> None:
    def asked() -> list[Any]:
        return [sg.find(150, 900), sg.find(150, 1200), sg.find(150, 900).motion,
                sg.find(10, 60, cells=20, **FORCED),
                sg.find(period=3.5, cells=30), sg.mode(4, -1, 3.14159),
                sg.response(cells=10, start=1, to=1.2, **FORCED),
                sg.continuum(6, 36, cells=12, energy_ratio=8, points=5),
                sg.simulate(frequency=1.1, periods=9, cells=20, **FORCED)]

    first, again = asked(), asked()
    seconds = {answer.solver.seconds for answer in (
        *(sg.find(150, 900) for _ in range(20)),)}
    assert len(seconds) > 1, "the stopwatch stands still"
    for at, answer in enumerate(first):
        for other, known in enumerate(again):
            assert (answer == known) is (at == other), (answer, known)
    assert first[2] == pickle.loads(pickle.dumps(first[2]))
    assert first[0] != "found" and sg.find(150, 900, gap=2e-3) != first[0]
    runs = [sg.Atlas.build(tmp_path / f"{name}.sqlite", cells=12).runs[0]
            for name in "ab"]
    assert runs[0] == runs[1]


def test_cells_of_frames_are_numbers_or_words(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    atlas = sg.Atlas.build(tmp_path / "a.sqlite", cells=8)
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)
    response = sg.response(cells=10, **FORCED)
    tables: list[Any] = [
        sg.families(), sg.modes(), sg.modes(phases=2, max_order=5),
        atlas.families(), atlas.schedules(), atlas.runs, response, curve,
        sg.find(period=3.5, cells=30), sg.find(10, 60, cells=20, **FORCED)]
    for table in tables:
        frame = table.frame()
        for name in frame:
            kinds = {type(cell) for cell in frame[name]}
            assert not kinds & {list, tuple, dict, sg.Schedule}, name
            if kinds & {int, float}:
                assert pandas.api.types.is_numeric_dtype(frame[name]), name
    families = sg.families().frame()
    assert list(families.period_ratio) == pytest.approx(
        [2 * f.nu / f.order for f in sg.families()])
    assert list(families.least_energy_ratio) == pytest.approx(
        [int(p) / int(q) for p, q in
         (word.split("/") for word in families.least_energy_exact)])
    modes = sg.modes().frame()
    # Contact lasts p + q T, and vanishes where the interval says so.
    ends = modes[modes.ends.str.endswith("contact-vanishes")]
    assert len(ends) and abs(
        ends.contact_p + ends.contact_q * ends.period_most).max() < 1e-12
    schedules = atlas.schedules().frame()
    words = [f"{c}:{f}" for c, f in zip(schedules.contact_steps,
                                        schedules.free_steps)]
    assert list(schedules.schedule) == words
    several = sg.find((1, 12), (3, 12), cells=4)
    assert page_of(several).values["schedule"] == "1:12, 3:12"
    assert (response.frame()["physical.impulse"].count() ==
            len(response.motions))


def test_a_frame_of_contacts() -> None:
    pytest.importorskip("pandas")
    run = sg.simulate(frequency=1.1, periods=40, cells=20, **FORCED)
    frame = run.frame()
    assert len(frame) == run.contacts
    assert frame.impulse.sum() == pytest.approx(run.impulse)
    assert (frame.end > frame.start).all() and set(frame.stop) == {"right"}
    assert len(sg.simulate(frequency=1.1, periods=1, cells=20, damping=0.02,
                           force="tip", amplitude=1e-6).frame()) == 0


def test_curves_are_sequences() -> None:
    curve = sg.continuum(6, 36, cells=12, energy_ratio=8, points=5)
    points = list(curve)
    assert curve[1:4] == points[1:4] and curve[-1] == points[-1]
    assert curve[::-2] == points[::-2] and curve[7:] == []
    with pytest.raises(IndexError):
        curve[5]
    pytest.importorskip("pandas")
    frame = curve.frame()
    assert list(frame["lambda"]) == list(curve.lambda_)
    assert list(curve[1:4].frame()["lambda"]) == list(curve.lambda_[1:4])
    assert list(frame["physical.peak_force"]) == [
        point.physical.peak_force for point in points]
    assert len(page_of(curve).under("points")) == 5
    size_of(curve)
    size_of(curve[2])


def test_motions_known_by_a_state_are_followed_for_their_figure() -> None:
    from signorini import _notebook
    mode = sg.mode(4, -1, 3.5)
    run = _notebook._walked(mode)
    assert run.contact_impulse[1] == pytest.approx(mode.physical.impulse, rel=1e-6)


@pytest.mark.parametrize("shown", [
    sg.find(12, 96, cells=30, **FORCED), sg.mode(4, -1, 3.5), sg.modes(), sg.modes()[0],
    sg.find(frequency=1.02, **FORCED),
    sg.Scene(), sg.Scene(second_stop=1e-3),
    sg.Scene(bar=sg.Bar(gap=-1e-3), segments=[sg.Segment(150), sg.Segment(150, 1.5)])])
def test_forced_motions_modes_and_scenes_have_a_figure(shown: Any) -> None:
    image = Image.open(io.BytesIO(shown._repr_png_()))
    assert image.width > 400 and len(set(image.convert("L").getdata())) > 2
    assert "<img" in shown._repr_html_()
