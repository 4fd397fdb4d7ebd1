"""The site: pages in Markdown, examples that run, references out of the sources.

tools/docs copies this folder to build/docs/source, adds the pages that are generated (program,
schemas, headers), and runs Sphinx there. Nothing on the site needs a network.
"""

import os
import sys
from pathlib import Path

SOURCE = Path(__file__).parent
sys.path.insert(0, str(SOURCE))

import gallery_looks  # noqa: E402  (all beside this file)
import spelling  # noqa: E402
import theme  # noqa: E402

project = "signorini"
author = "The signorini developers"
project_copyright = author
version = release = os.environ["SIGNORINI_VERSION"]

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "numpydoc",
    "breathe",
    "sphinx_gallery.gen_gallery",
    "sphinxcontrib.spelling",
]
nitpicky = False
exclude_patterns = ["gallery", "octave"]
suppress_warnings = ["config.cache"]

# Pages
smartquotes_action = "qe"  # -- begins an option
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
myst_update_mathjax = False
html_theme = "furo"
# Code in colours of enough contrast.
pygments_style = "xcode"
pygments_dark_style = "github-dark"
html_title = f"signorini {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
    "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"},
}
# Formulas are drawn by the copy of MathJax 2 that lies beside the pages, as SVG: no fonts to fetch.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"showMathMenu": False, "messageStyle": "none", "SVG": {"linebreaks": {"automatic": True}}}

# References
breathe_projects = {"signorini": os.environ["SIGNORINI_DOXYGEN"]}
breathe_default_project = "signorini"
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
toc_object_entries = False

# Gallery
sphinx_gallery_conf = {
    "examples_dirs": "gallery",
    "gallery_dirs": "examples",
    "filename_pattern": r"plot_",
    "within_subsection_order": gallery_looks.Listed,
    "abort_on_example_error": True,
    "download_all_examples": True,
    "min_reported_time": 20,
    "show_memory": False,
    "capture_repr": (),
    "remove_config_comments": True,
    "matplotlib_animations": True,
    "reset_modules": ("matplotlib", gallery_looks.set_looks),
}

# Words
spelling_lang = "en_GB"
spelling_word_list_filename = "words.txt"
spelling_filters = [spelling.Symbols]
spelling_show_suggestions = True
spelling_warning = True
spelling_exclude_patterns = ["reference/cpp/*", "reference/python/*", "reference/schema/*"]


def show_bars(_app, _what, _name, _object, _options, lines):
    """|x| is a size, no substitution of reStructuredText."""
    lines[:] = [line.replace("|", r"\|") for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", show_bars, priority=900)
    app.connect("build-finished", theme.repair)
