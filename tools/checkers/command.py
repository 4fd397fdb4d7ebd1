"""What the commands share: their files, one line about each, exit statuses."""
import os
import sqlite3
import sys

from .reading import UNUSABLE, NoProof, read


def opened(name):
    """A file by its name, or standard input as "-"."""
    if name != "-":
        return open(name, encoding="utf-8")
    if sys.stdin is None:
        raise OSError("standard input is closed")
    return sys.stdin


def answer_of(name):
    """The JSON that a file holds."""
    with opened(name) as file:
        return read(file)


def complain(name, error):
    """What kept a command from an answer."""
    print(f"{name}: {str(error) or type(error).__name__}", file=sys.stderr)
    return 2


def is_usage(words):
    """Are these names of files?"""
    return bool(words) and not any(word.startswith("-") and word != "-" for word in words)


def told(name, action, yes, no):
    """Says in a line what `action` finds of a file; the exit status."""
    try:
        print(f"{name}: {yes}: {action()}")
        return 0
    except NoProof as why:
        print(f"{name}: {no}: {why}")
        return 1
    except ArithmeticError as error:
        print(f"{name}: {no}: numbers that this checker does not hold: {error}")
        return 1
    except (*UNUSABLE, sqlite3.Error) as error:
        return complain(name, error)


def run(doc, words, is_right, action):
    """Does `action` with the words of a command; the exit status, 2 if what it says cannot be said."""
    if not is_right(words):
        print(doc.strip(), file=sys.stderr)
        return 2
    if sys.stdout is None:
        return complain("standard output", "closed")
    sys.stdout.reconfigure(errors="backslashreplace")
    try:
        status = action(words)
        sys.stdout.flush()
        return status
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # what is left is written there
        return complain("standard output", error)


def each_file(doc, check, yes, no):
    """A command about files, each by itself: 0 yes to all, 1 no to some, 2 usage error."""
    def action(names):
        status = 0
        for name in names:
            said = told(name, lambda: check(name), yes, no)
            if said == 2:
                return 2
            status = max(status, said)
        return status
    return run(doc, sys.argv[1:], is_usage, action)
