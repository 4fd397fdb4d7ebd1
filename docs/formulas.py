"""Formulas: docs/theory.md has them as plain text, displayed ones indented, so that they read well in any editor.

Here they become TeX. Letters and signs of Unicode need no change; what does: words among symbols, functions, roots,
indices and exponents written as such (₁, ¹⁸), and braces that group nothing. Within lines a formula is a row of
symbols, operators and numbers without English between them; "a" is a wave only beside an operator or
a comma.
"""

import re
from collections.abc import Callable

FUNCTIONS = {"max", "min", "gcd", "mod", "win", "exp", "tanh", "ln", "cos", "sin", "floor", "dim", "ker", "diag"}
SHORT_WORDS = {"in", "is", "or", "of", "at", "so", "as", "by", "on", "if", "to", "it"}
SCRIPTS = {"₀": "_0", "₁": "_1", "₂": "_2", "²": "^2", "ᵀ": "^T", "′": "'", "Σ": r"\sum ", "…": r"\dots ", "√": r"\sqrt ",
           "³": "^3", "⁴": "^4", "⁵": "^5", "⁶": "^6", "⁷": "^7", "⁸": "^8", "⁹": "^9"}  # fmt: skip
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "−0123456789")
TOKEN = re.compile(r"[A-Za-z]+(?:-[A-Za-z]+)*|\s+|.")
INDEXED = re.compile(
    r"(?:(?<=\.\.)|(?<=\d)|(?<![\w`$/.]))"  # also n of 0..n, p of 2p
    r"([A-Za-zΑ-Ωα-ω][′']?)_(\{[^{}]+\}|\d+|[A-Za-zα-ω][A-Za-z0-9α-ω]*(?![a-z_`]))(²?)"
)
WORD = re.compile(r"([(*]*)(.*?)([*).,;:]*)", re.DOTALL)
SYMBOLS = re.compile(r"[\w+−±·/=<>≤≥|(){}\[\]⌊⌋^'′√ΣΔ∞,;.…⁻²³¹⁰⁴-⁹₀-₉ᵀ \\*⊕∂∈]+")
OPERATORS = set("=+−·≤≥<>≠∈≡→×∪∩⊂/≪≫≈∼")
NUMBER = re.compile(r"[+−±]?\d+(?:[./]\d+)?|…")
UNITS = {"m/s", "Hz", "J", "kg", "mm", "GPa"}
PAIRS = [("(", ")"), ("[", "]"), ("{", "}"), ("⌊", "⌋")]
OPENED = re.compile(r"[^\s(*][(\[]|[{⌊]")
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
    text = re.sub("[⁻⁰¹²³⁴-⁹]{2,}", lambda match: f"^{{{match[0].translate(RAISED)}}}", text)
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
    tokens = TOKEN.findall(text)
    for at, token in enumerate(tokens):
        is_article = token == "a" and bool(words) and any(map(is_text, tokens[at + 2 : at + 3]))
        if is_text(token) or is_article or (words and token.isspace()):
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


def between_commands(text: str, translated: Callable[[str], str]) -> str:
    """Commands that with_braces has made are no words."""
    parts = re.split(r"(\\sqrt|\\[{}])", text)
    return "".join(part if part.startswith("\\") else translated(part) for part in parts)


def tex(line: str) -> str:
    """One line; three or more spaces part what stands side by side."""
    pieces = re.split(r" {3,}", with_braces(line.strip().replace("*", "")))
    return r" \qquad ".join(between_commands(piece, tex_of) for piece in pieces)


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

    return within_lines(re.sub(r"\n\n((?:    \S.*\n)+)", block, text))


def is_symbolic(word: str) -> bool:
    """Letters, functions and what joins them, but no English and no unit."""
    bare = INDEXED.sub("n", word)
    names = re.findall(r"[A-Za-z]{2,}", bare)
    return (
        word not in UNITS
        and SYMBOLS.fullmatch(bare) is not None
        and not re.search(r"[A-Za-z]\d", bare)
        and re.search(r"[^\W\d_]|[¹²³⁴-⁹]", bare) is not None
        and all(name in FUNCTIONS or re.fullmatch(r"[a-z][A-Z]", name) for name in names)
    )


def inline(formula: str) -> str:
    """A formula within a line."""

    def one(match: re.Match[str]) -> str:
        index = match[2].strip("{}")
        index = rf"\text{{{index}}}" if len(index) > 2 and index.isalpha() else index
        index = tex_of(index) if " " in index else index
        power = "^2" if match[3] else ""
        letter = match[1].replace("′", "'")
        return f"{letter}_{{{index.replace('|', chr(92) + 'vert ')}}}{power}"

    def with_indexes(text: str) -> str:
        out, at = "", 0
        for match in INDEXED.finditer(text):
            out += tex_of(text[at : match.start()]) + one(match)
            at = match.end()
        return out + tex_of(text[at:])

    return f"${between_commands(with_braces(formula), with_indexes).strip()}$"


def words_of(line: str) -> list[str]:
    """Words of a line; brackets and bars of a formula hold theirs together."""
    pieces = line.split(" ")
    words: list[str] = []
    at = 0
    while at < len(pieces):
        end = at + 1

        def depth() -> int:
            text = "".join(pieces[at:end])
            bars = 0 if line.startswith("|") else text.count("|") % 2
            return sum(text.count(left) - text.count(right) for left, right in PAIRS) + bars

        while depth() > 0 and end < len(pieces):
            end += 1
        whole = " ".join(pieces[at:end])
        core = WORD.fullmatch(whole)
        if end > at + 1 and (depth() > 0 or not (OPENED.search(pieces[at]) or core and is_symbolic(core[2]))):
            whole, end = pieces[at], at + 1
        words.append(whole)
        at = end
    return words


def formulas_in(line: str) -> str:
    """A line of text whose formulas are TeX."""

    def kind(core: str, after: str) -> str:
        if core in OPERATORS:
            return "operator"
        if core in {"a", "A", "I"}:
            return "symbol" if core + after[:1] == "a," else "article"
        if NUMBER.fullmatch(core):
            return "number"
        if core in FUNCTIONS:
            return "function"
        return "symbol" if is_symbolic(core) and all(core.count(a) == core.count(b) for a, b in PAIRS) else "text"

    def is_apart(last: tuple[str, str, str, str], one: tuple[str, str, str, str]) -> bool:
        """Between two words: does a formula end with the first of them?"""
        return bool(last[2] or one[0]) or one[3] == "symbol" and (
            last[3] == "number" or last[3] == "symbol" and re.match(r"\(.*[=<>≤≥∈]", one[1]) is not None)  # fmt: skip

    parts: list[tuple[str, str, str, str]] = []  # before a word, the word, after it, its kind
    for word in words_of(line):
        before, core, after = WORD.fullmatch(word).groups()  # type: ignore[union-attr]
        while core.count("(") > core.count(")") and after.startswith(")"):
            core, after = core + ")", after[1:]
        if before.endswith("(") and (core.count(")") > core.count("(") or after.startswith(")") and is_symbolic(core)):
            before, core = before[:-1], "(" + core
            if core.count("(") > core.count(")"):
                core, after = core + ")", after[1:]
        parts.append((before, core, after, kind(core, after)))

    def stands_alone(run: list[tuple[str, str, str, str]], at: int, step: int) -> bool:
        """An operator, a number or an article at an end, beside no operator; a function that is of nothing."""
        beside = run[at + step][3] if len(run) > 1 else ""
        own = run[at][3]
        return own == "operator" or (own in {"article", "number"} and beside != "operator") or (
            own == "function" and beside != "operator" and (step < 0 or beside != "symbol"))  # fmt: skip

    def as_text(one: tuple[str, str, str, str]) -> str:
        """A letter with an index is a formula within other words, too."""
        text = INDEXED.sub(lambda match: inline(match[0]), "".join(one[:3]))
        return text.replace("$$", " ")  # of neighbours

    out: list[str] = []
    at = 0
    while at < len(parts):
        end = at
        while end < len(parts) and parts[end][3] != "text" and (
            end == at or not is_apart(parts[end - 1], parts[end])
        ):
            end += 1
        run = parts[at : max(end, at + 1)]
        at += len(run)
        tail: list[str] = []
        while run and stands_alone(run, 0, 1):
            out.append(as_text(run.pop(0)))
        while run and stands_alone(run, -1, -1):
            tail.insert(0, as_text(run.pop()))
        if any(one[3] == "symbol" for one in run):
            out.append(run[0][0] + inline(" ".join(one[1] for one in run)) + run[-1][2])
        else:
            out += map(as_text, run)
        out += tail
    return re.sub(r"(?<![\w$])(\d*[A-Za-z])-(?=[a-z]{4})", r"$\1$-", " ".join(out))


def within_lines(text: str) -> str:
    """Formulas within lines, but not in code, links, headings and displayed formulas."""
    return "".join(
        part
        if at % 2
        else "\n".join(line if line.startswith("#") else formulas_in(line) for line in part.split("\n"))
        for at, part in enumerate(ASIDE.split(text))
    )
