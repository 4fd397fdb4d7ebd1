"""The pages of the JSON answers, out of their schemas."""

import json
from pathlib import Path
from typing import Any


def kind(schema: dict[str, Any]) -> str:
    """The type of a value, in a few words and links."""
    if "$ref" in schema:
        file, _, name = schema["$ref"].partition("#/$defs/")
        page = file.replace(".json", ".md")
        place = f"#{name}" if name else ""
        return f"[{name or file.removesuffix('.json')}]({page}{place})"
    if "enum" in schema:
        return ", ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    for word in ("anyOf", "oneOf"):
        if word in schema:
            return " or ".join(kind(one) for one in schema[word])
    types = schema.get("type", "any")
    types = types if isinstance(types, list) else [types]
    words = []
    for name in types:
        inner = schema.get("items")
        words.append(f"array of {kind(inner)}" if name == "array" and inner else name)
    return " or ".join(words) + bounds(schema)


def bounds(schema: dict[str, Any]) -> str:
    """The range of a number, where there is one."""
    signs = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}
    found = [f"{sign} {schema[word]}" for word, sign in signs.items() if word in schema]
    return f", {' and '.join(found)}" if found else ""


def inside(schema: dict[str, Any]) -> dict[str, Any] | None:
    """The object that a value is or holds, if it has keys of its own."""
    options = [schema, schema.get("items"), *schema.get("anyOf", []), *schema.get("oneOf", [])]
    for one in options:
        if isinstance(one, dict) and "properties" in one:
            return one
        if isinstance(one, dict) and one is not schema and (found := inside(one)):
            return found
    return None


def rows(schema: dict[str, Any], path: str = "") -> list[str]:
    """A row for each key, those of objects inside it after it."""
    out = []
    required = schema.get("required", [])
    for key, value in schema.get("properties", {}).items():
        name = f"{path}{key}"
        always = "" if key in required else " (not always)"
        meaning = value.get("description", "").replace("|", "\\|").replace("_", "\\_")
        out.append(f"| `{name}` | {kind(value)}{always} | {meaning} |")
        if found := inside(value):
            out += rows(found, f"{name}.")
    return out


def table(schema: dict[str, Any]) -> str:
    """All keys of an object; of anything else its type."""
    if not (found := rows(inside(schema) or {})):
        return kind(schema) + (f": {schema['description']}" if "description" in schema else "")
    return "| key | type | meaning |\n|---|---|---|\n" + "\n".join(found)


def sentence(title: str) -> str:
    """The title with its command as code."""
    command, colon, words = title.partition(": ")
    return f"`{command}`: {words}." if colon else f"{title}."


def page(schema: dict[str, Any], name: str) -> str:
    """One schema: its own keys, and the definitions that others refer to."""
    title = schema.get("title", name)
    text = f"# {name}.json\n\n{sentence(title)}\n\n"
    if "properties" in schema:
        text += table(schema) + "\n\n"
    for word, meaning in schema.get("$defs", {}).items():
        text += f"## {word}\n\n{meaning.get('description', '')}\n\n{table(meaning)}\n\n"
    return text + f"The file: {{download}}`{name}.json <../../schema/{name}.json>`\n"


def write(schemas: Path, folder: Path) -> list[str]:
    """All pages; returns their names."""
    folder.mkdir(parents=True, exist_ok=True)
    names = []
    for path in sorted(schemas.glob("*.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        (folder / f"{path.stem}.md").write_text(page(schema, path.stem), encoding="utf-8")
        names.append(path.stem)
    return names
