"""SMT solvers that judge our rows: z3 and cvc5, each asked file after file."""
import subprocess
import sys

JUDGES = {"z3": ["z3", "-in"], "cvc5": ["cvc5", "--lang=smt2", "--incremental", "--produce-models", "-"]}


class Judge:
    """One solver, in a process that goes on."""

    def __init__(self, name):
        self.name = name
        self.process = subprocess.Popen(JUDGES[name], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, text):
        """The one line that a text with one command to answer is answered with."""
        self.process.stdin.write(text)
        self.process.stdin.flush()
        return self.process.stdout.readline().strip()

    def is_satisfiable(self, text):
        """What it says of a file."""
        verdict = self.ask(text)
        self.process.stdin.write("(reset)\n")
        if verdict not in ("sat", "unsat"):
            sys.exit(f"{self.name} says {verdict!r} of:\n{text}")
        return verdict == "sat"

    def values(self, names):
        """Of names in the model that it has just found, as it writes them."""
        text = self.ask(f"(get-value ({' '.join(names)}))\n")
        while text.count("(") > text.count(")"):
            text += " " + self.process.stdout.readline().strip()
        words = text.replace("(", " ").replace(")", " ").split()
        return dict(zip(words[::2], words[1::2]))

    def cpu(self):
        """[s] of the processor so far."""
        with open(f"/proc/{self.process.pid}/stat", encoding="utf-8") as file:
            ticks = file.read().rsplit(")", 1)[1].split()
        return (int(ticks[11]) + int(ticks[12])) / 100.0

    def close(self):
        """Ends it."""
        self.process.stdin.close()
        self.process.wait()
