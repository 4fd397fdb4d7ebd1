"""The pages of the command line, out of what the program says of itself."""

import subprocess
from pathlib import Path

# What each page tries, and shows with its answer.
EXAMPLES = {
    "find": "find 150 900",
    "continuum": "continuum 150 900 --energy-ratio 20 --points 11",
    "families": "families --max-order 6",
    "modes": "modes --max-order 5",
    "mode": "mode 4 -1 --period 3.14159",
    "atlas": "atlas --database atlas.sqlite --cells 30",
    "response": "response --damping 0.02 --force tip --amplitude 2e-4 --from 1.1 --to 1.11",
    "simulate": "simulate --rest --damping 0.02 --force tip --amplitude 2e-4"
    " --frequency 1.1 --periods 300",
    "sweep": "sweep --damping 0.02 --force tip --amplitude 2e-4 --from 1.05 --to 1.25 --points 5 --cells 30",
    "study": "study study.toml --csv study.csv",
    "scene": "scene clamp 150 gap=1e-3 200:1.3 clamp",
}
# Files that they read.
FILES = {
    "study.toml": """\
force = "tip"
damping = [0.02, 0.05]
amplitude = [1e-4, 2e-4]
from = 1.05
to = 1.25
points = 5
cells = 30
""",
}
TITLES = {"Positionals:": "Arguments", "Options:": "Options"}
COLUMN = 30  # where the help has the words that explain an option


def says(program: Path, call: str, folder: Path) -> str:
    """What the program prints; a call that fails is a fault of the page."""
    done = subprocess.run(
        [program, *call.split()], cwd=folder, capture_output=True, text=True, check=True
    )
    return done.stdout


def table(lines: list[str]) -> str:
    """Lines of help, an option or a positional each, as a table."""
    rows: list[list[str]] = []
    for line in lines:
        if line.startswith(" " * COLUMN):  # words of the option above
            rows[-1][1] = (rows[-1][1] + " " + line.strip()).strip()
        elif len(line) <= COLUMN or line[COLUMN - 1] != " ":  # a long one has its words below
            rows.append([line.strip(), ""])
        else:
            rows.append([line[:COLUMN].strip(), line[COLUMN:].strip()])
    text = "| option | meaning |\n|---|---|\n"
    for option, meaning in rows:
        shown = option.replace("|", "\\|")
        text += f"| `{shown}` | {meaning.replace('|', chr(92) + '|').replace('_', chr(92) + '_')} |\n"
    return text


def page(program: Path, command: str, folder: Path) -> str:
    """One subcommand: purpose, call, options, an example with its answer."""
    lines = says(program, f"{command} --help", folder).rstrip().split("\n")
    text = f"# signorini {command}\n\n{lines[0].capitalize()}.\n\n"
    rest = lines[1:]
    while rest:
        line = rest.pop(0)
        if line.startswith("Usage: "):
            text += f"```text\n{line.removeprefix('Usage: ')}\n```\n\n"
        elif line in TITLES:
            end = next((i for i, one in enumerate(rest) if not one.startswith(" ")), len(rest))
            text += f"## {TITLES[line]}\n\n{table(rest[:end])}\n"
            rest = rest[end:]
        elif line:
            text += f"{line}\n"
    text += "\n## An example\n\n"
    for name in EXAMPLES[command].split():
        if name in FILES:
            (folder / name).write_text(FILES[name], encoding="utf-8")
            text += f"`{name}`:\n\n```toml\n{FILES[name]}```\n\n"
    answer = says(program, EXAMPLES[command], folder)
    return text + f"```text\n$ signorini {EXAMPLES[command]}\n{answer}```\n"


def commands(program: Path) -> list[str]:
    """The subcommands, in the order of the help."""
    lines = says(program, "--help", Path()).split("\n")
    begin = lines.index("Subcommands:") + 1
    return [line.split()[0] for line in lines[begin : lines.index("", begin)]]


def write(program: Path, folder: Path, scratch: Path) -> list[str]:
    """All pages; returns their names."""
    folder.mkdir(parents=True, exist_ok=True)
    names = commands(program)
    for name in names:
        (folder / f"{name}.md").write_text(page(program, name, scratch), encoding="utf-8")
    return names
