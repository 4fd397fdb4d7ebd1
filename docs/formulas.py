"""Formulas: docs/theory.md has them as plain text, displayed ones indented, so that they read well in any editor.

Here they become TeX. Within lines only letters with an index do: the rest is legible as it stands. Letters and signs of Unicode need no change; what does: words among symbols, functions, roots, indices
written as such (₁, ²), and braces that group nothing.
"""

import re

FUNCTIONS = {"max", "min", "gcd", "mod", "win", "exp", "tanh", "ln", "cos", "sin", "floor"}
SHORT_WORDS = {"in", "is", "or", "of", "at", "so", "as", "by", "on", "if", "to", "it"}
SCRIPTS = {"₀": "_0", "₁": "_1", "₂": "_2", "²": "^2", "ᵀ": "^T", "′": "'", "Σ": r"\sum ", "…": r"\dots ", "√": r"\sqrt "}
TOKEN = re.compile(r"[A-Za-z]+(?:-[A-Za-z]+)*|\s+|.")
INDEXED = re.compile(
    r"(?:(?<=\.\.)|(?<=\d)|(?<![\w`$/.]))"  # also n of 0..n, p of 2p
    r"([A-Za-zΑ-Ωα-ω][′']?)_(\{[^{}]+\}|[A-Za-z0-9α-ω]+)(²?)(?![a-z_`])"
)
ASIDE = re.compile(r"(\$\$.*?\$\$|`[^`]*`|\]\([^)]*\)|^    [^\n]*$)", re.DOTALL | re.MULTILINE)
PATTERN = re.compile(r"[+−]  +[+−]")  # a table of signs, no formula


def is_text(token: str) -> bool:
    """A word of English, not a product of letters."""
    return token.isascii() and (
        token in SHORT_WORDS or "-" in token or (len(token) > 2 and token.isalpha())
    ) and token not in FUNCTIONS  # fmt: skip


def with_braces(text: str) -> str:
    """Roots and exponents as long as their brackets; other braces are seen."""
    text = re.sub(r"(?<![_^])\{([^{}]*)\}", r"\\{\1\\}", text)
    text = re.sub(r"\^⌊([^⌋]*)⌋", r"^{⌊\1⌋}", text)
    while (at := text.find("√(")) >= 0:
        depth, end = 0, at + 1
        while True:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            if depth == 0:
                break
            end += 1
        text = f"{text[:at]}\\sqrt{{{text[at + 2:end]}}}{text[end + 1:]}"
    return text


def tex_of(text: str) -> str:
    """A piece of a line without wide gaps."""

    def said(words: str) -> str:
        return rf"\text{{ {words.strip()} }}"

    parts: list[str] = []
    words = ""
    for token in TOKEN.findall(text):
        if is_text(token) or (words and token.isspace()):
            words += token
            continue
        if words:
            parts.append(said(words) + (r"\quad " if words.endswith("  ") else ""))
            words = ""
        if token == "  ":
            token = r" \quad "
        operator = "bmod" if token == "mod" else f"operatorname{{{token}}}"
        parts.append(rf"\{operator} " if token in FUNCTIONS else SCRIPTS.get(token, token))
    if words:
        parts.append(said(words))
    joined = re.sub(r" \}([,;:.)])", r"}\1", "".join(parts)).replace(r"(\text{ ", r"(\text{")
    return joined


def tex(line: str) -> str:
    """One line; three or more spaces part what stands side by side."""
    pieces = re.split(r" {3,}", with_braces(line.strip().replace("*", "")))
    # Commands that with_braces has made are no words.
    return r" \qquad ".join(
        "".join(
            part if part.startswith("\\") else tex_of(part)
            for part in re.split(r"(\\sqrt|\\[{}])", piece)
        )
        for piece in pieces
    )


def displayed(text: str) -> str:
    """A page whose indented blocks are formulas."""

    def block(match: re.Match[str]) -> str:
        lines = match[1].rstrip("\n").split("\n")
        if any(PATTERN.search(line) for line in lines):
            return match[0]
        rows = r" \\ ".join(tex(line) for line in lines)
        if len(lines) > 1:
            rows = rf"\begin{{gathered}} {rows} \end{{gathered}}"
        return f"\n\n$$\n{rows}\n$$\n"

    return indexed(re.sub(r"\n\n((?:    \S.*\n)+)", block, text))


def indexed(text: str) -> str:
    """Letters with an index within lines, but not in code, links and displayed formulas."""

    def one(match: re.Match[str]) -> str:
        index = match[2].strip("{}")
        index = rf"\text{{{index}}}" if len(index) > 2 and index.isalpha() else index
        index = tex_of(index) if " " in index else index
        power = "^2" if match[3] else ""
        return f"${match[1].replace('′', chr(39))}_{{{index.replace('|', chr(92) + 'vert ')}}}{power}$"

    parts = ASIDE.split(text)
    return "".join(part if at % 2 else INDEXED.sub(one, part) for at, part in enumerate(parts))
