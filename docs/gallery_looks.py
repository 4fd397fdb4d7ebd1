"""Order and looks of the gallery."""

import re
from typing import Any

ORDER = [
    "paper_figure_1",
    "paper_figure_2",
    "paper_figure_3",
    "periodic_table",
    "mode_at_pi",
    "measured_state",
    "connected_or_not",
    "two_contacts",
    "refuted",
    "steel",
    "response_with_fold",
    "what_it_settles_on",
    "free_limit",
    "prestress_and_two_stops",
    "stepped_bar",
    "string_over_obstacle",
    "bouncing_bar",
    "between_two_walls",
    "soft_root",
    "striker_and_rod",
    "two_bars_one_energy",
    "atlas_with_sql",
    "back_ends",
    "animation",
]


class Listed:
    """Sorts the examples as ORDER does; one that is not listed is an error."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def __repr__(self) -> str:
        return "<Listed>"

    def __call__(self, name: str) -> int:
        return ORDER.index(name.removeprefix("plot_").removesuffix(".py"))


def set_looks(_configuration: dict[str, Any], _name: str) -> None:
    """Every picture of the gallery: large enough to be read at the width of a page."""
    import matplotlib
    from matplotlib import animation

    # The buttons of a moving picture would fetch their signs from a network; site.css has them.
    animation.JS_INCLUDE = re.sub(r"<link[^>]*>", "", animation.JS_INCLUDE)
    matplotlib.rcParams.update(
        {
            "figure.figsize": (8, 4.8),
            "figure.dpi": 110,
            "savefig.dpi": 110,
            "figure.constrained_layout.use": True,
            "font.size": 11,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "animation.embed_limit": 30,
        }
    )
