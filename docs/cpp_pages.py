"""The C++ reference: one page for each public header, its members in the order of the header."""

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

DIRECTIVES = {"enum": "doxygenenum", "typedef": "doxygentypedef", "variable": "doxygenvariable"}


def directive(member: ET.Element) -> str:
    """What breathe is told, so that it shows this member."""
    name = member.findtext("qualifiedname") or ""
    if member.get("kind") == "function":
        return f"```{{doxygenfunction}} {name}{member.findtext('argsstring')}\n```\n"
    return f"```{{{DIRECTIVES[member.get('kind') or '']}}} {name}\n```\n"


def is_shown(member: ET.Element) -> bool:
    """Comparisons and what is deleted say nothing to a reader."""
    text = (member.findtext("name") or "") + (member.findtext("argsstring") or "")
    return not text.startswith("operator") and "=delete" not in text


def members_of(xml: Path, path: str) -> Iterator[ET.Element]:
    """What a header declares in the library's namespaces."""
    for space in sorted(xml.glob("namespacesignorini*.xml")):
        for member in ET.parse(space).getroot().iter("memberdef"):
            place = member.find("location")
            if place is not None and place.get("file") == path:
                yield member


def line_of(part: ET.Element) -> int:
    place = part.find("location")
    return int(place.get("line") or 0) if place is not None else 0


def page(xml: Path, file: ET.Element) -> str:
    """The page of one header."""
    header = file.findtext("compoundname")
    location = file.find("location")
    assert location is not None
    parts: dict[int, str] = {}
    for inner in file.iter("innerclass"):
        name = inner.text or ""
        found = ET.parse(xml / f"{inner.get('refid')}.xml").getroot().find("compounddef")
        assert found is not None
        if name.rpartition("::")[0] in ("signorini", "signorini::trace"):  # else shown inside
            parts[line_of(found)] = (
                f"```{{doxygen{found.get('kind')}}} {name}\n:members:\n:undoc-members:\n```\n"
            )
    for member in filter(is_shown, members_of(xml, location.get("file") or "")):
        parts[line_of(member)] = directive(member)
    about = f"```{{doxygenfile}} {header}\n:sections: briefdescription detaileddescription\n```\n"
    return "\n".join([f"# {header}\n", about, *(parts[line] for line in sorted(parts))])


def write(xml: Path, folder: Path) -> list[str]:
    """All pages; returns their names."""
    folder.mkdir(parents=True, exist_ok=True)
    names = []
    for path in sorted(xml.glob("*_8hpp.xml")):
        file = ET.parse(path).getroot().find("compounddef")
        assert file is not None
        name = (file.findtext("compoundname") or "").removesuffix(".hpp")
        if name == "signorini":
            continue  # includes the others and holds nothing
        (folder / f"{name}.md").write_text(page(xml, file), encoding="utf-8")
        names.append(name)
    return names
