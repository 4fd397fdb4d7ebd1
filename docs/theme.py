"""Debian's furo, put right after a build.

Its script is not bundled, which no browser runs; its style sheet begins with one that a server of Debian
would have elsewhere, and has lost the colours for readers whose system is dark. What another furo has of
this is left as it is.
"""

import re
from pathlib import Path

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")
DARK = re.compile(r'body\[data-theme="dark"\] \{(?P<colours>[^}]*)\}')


def bundle(scripts: Path) -> None:
    """One classic script in place of two modules: pages open from a folder, too."""
    script = scripts / "furo.js"
    imported, _, rest = script.read_text(encoding="utf-8").partition("\n")
    if imported == 'import Gumshoe from "./gumshoe-patched.js";':
        spy = (scripts / "gumshoe-patched.js").read_text(encoding="utf-8")
        script.write_text(f"{spy}\n(() => {{\n{rest}\n}})();\n", encoding="utf-8")


def complete(sheet: Path) -> None:
    """What is imported stands in its place, and what is dark on demand is so by the system, too."""
    text = sheet.read_text(encoding="utf-8")
    imported = "@import url(/javascript/normalize.css/normalize.css);"
    if imported in text:
        text = text.replace(imported, NORMALIZE.read_text(encoding="utf-8"))
    if "prefers-color-scheme" not in text:
        body = 'body:not([data-theme="light"])'
        text += f"""
@media screen and (prefers-color-scheme: dark) {{
  {body} {{{DARK.search(text)["colours"]}}}
  html {body} .only-light {{ display: none !important; }}
  {body} .only-dark {{ display: block !important; }}
}}
"""
    sheet.write_text(text, encoding="utf-8")


def repair(app, exception) -> None:
    """When the files of the theme are where the pages are."""
    if exception is None and app.builder.name == "html":
        static = Path(app.outdir) / "_static"
        bundle(static / "scripts")
        complete(static / "styles" / "furo.css")
