#!/usr/bin/env python3
"""Follows every link of a site: links.py FOLDER.

A link or a picture inside the site must lead to a file, and to a place in it if it names one. Scripts,
pictures, styles and fonts must lie inside: the site works without a network.
"""

import re
import sys
from functools import lru_cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What a page loads by itself, and what a reader may follow.
LOADS = {("img", "src"), ("script", "src"), ("link", "href"), ("source", "src"), ("video", "src")}
LEADS = {("a", "href")}


class Page(HTMLParser):
    """The links of a page, and the places that links may name."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.places: set[str] = set()
        self.loads: list[str] = []
        self.leads: list[str] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if value is None:
                continue
            if name == "id" or (tag, name) == ("a", "name"):
                self.places.add(value)
            elif (tag, name) in LOADS:
                self.loads.append(value)
            elif (tag, name) in LEADS:
                self.leads.append(value)


@lru_cache(maxsize=None)
def page_of(path: Path) -> Page:
    return Page(path)


def fault_of(site: Path, path: Path, link: str) -> str | None:
    """What is wrong with a link inside the site."""
    parts = urlsplit(link)
    target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
    if not target.is_relative_to(site):
        return "leads out of the site"
    if not target.is_file():
        return "there is no such file"
    if parts.fragment and target.suffix == ".html":
        if unquote(parts.fragment) not in page_of(target).places:
            return "there is no such place"
    return None


def main() -> int:
    site = Path(sys.argv[1]).resolve()
    faults: list[str] = []
    inside = outside = 0
    pages = [path for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    for path in pages:
        page = page_of(path)
        for link in page.loads + page.leads:
            scheme = urlsplit(link).scheme
            if scheme in ("", "file"):
                inside += 1
                if fault := fault_of(site, path, link):
                    faults.append(f"{path.relative_to(site)}: {link}: {fault}")
            elif scheme == "data":
                continue
            elif link in page.loads:
                faults.append(f"{path.relative_to(site)}: {link}: loaded from a network")
            elif scheme == "https" and re.fullmatch(r"[\w.-]+\.[a-z]+", urlsplit(link).netloc):
                outside += 1
            else:
                faults.append(f"{path.relative_to(site)}: {link}: neither inside nor https")
    print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
    print(f"links: {inside} inside, {outside} outside, on {len(pages)} pages, {len(faults)} faults")
    return 1 if faults or not inside else 0


if __name__ == "__main__":
    sys.exit(main())
