"""Rewrites C++ so that every place a mutant may stand at is switched by a number while it runs.

`a < b` becomes `mutants::less(17, a, b)`, which is `a <= b` when mutant 17 is on (mutants.hpp). Clang
reads the code (Debian: python3-clang-14), so that the operands are its own, not a guess; what comes
from a macro, and what a compiler must know (constexpr), stays as it is.
"""
from collections import namedtuple

from clang import cindex
from clang.cindex import CursorKind, TypeKind

# text: the line, the place marked by [ ]; change: what it becomes.
Mutant = namedtuple("Mutant", "line text change")

COMPARISONS = {"<": ("less", "<="), "<=": ("less_equal", "<"), ">": ("greater", ">="),
               ">=": ("greater_equal", ">"), "==": ("equal", "!="), "!=": ("unequal", "==")}
SUMS = {"+": ("plus", "-"), "-": ("minus", "+")}
STEPS = {"+=": ("add", "-="), "-=": ("subtract", "+=")}
WORDS = {"&&": "||", "||": "&&"}
SWAPPED = {"min": "max", "max": "min"}
NUMBERS = {TypeKind.BOOL, TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.FLOAT,
           TypeKind.LONGLONG, TypeKind.ULONGLONG, TypeKind.DOUBLE, TypeKind.LONGDOUBLE, TypeKind.CHAR_S,
           TypeKind.UCHAR, TypeKind.SHORT, TypeKind.USHORT, TypeKind.SCHAR}
CONSTANT = {CursorKind.STATIC_ASSERT, CursorKind.TEMPLATE_NON_TYPE_PARAMETER, CursorKind.ENUM_DECL}


def is_number(cursor):
    return cursor.type.get_canonical().kind in NUMBERS


class Schemata:
    """One file: its mutants by number, and its text with all of them in it."""

    def __init__(self, text, first):
        self.data, self.next = text.encode(), first
        self.mutants, self.edits, self.taken = {}, [], set()

    def span(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def new(self, start, end, change):
        """The number of a mutant that changes the text from start to end."""
        begin = self.data.rfind(b"\n", 0, start) + 1
        stop = self.data.find(b"\n", end)
        text = (self.data[begin:start] + b"[" + self.data[start:end] + b"]" + self.data[end:stop])
        self.mutants[self.next] = Mutant(self.data.count(b"\n", 0, start) + 1, text.decode().strip(), change)
        self.next += 1
        return self.next - 1

    def edit(self, start, end, text, rank):
        """Replaces a piece; of insertions at one place, those of a lower rank come first."""
        self.edits.append((start, rank, len(self.edits), end, text))

    def around(self, operands, depth, texts):
        (left, middle), (right, stop) = operands
        self.edit(left, left, texts[0], depth)
        self.edit(middle, right, texts[1], -1000)  # after what closes, before what opens
        self.edit(stop, stop, texts[2], -2000 - depth)

    def operation(self, cursor, operands, depth):
        """A binary operation of two operands, in text order."""
        spans = [self.span(operand) for operand in operands]
        (start, left), (right, stop) = spans
        between = self.data[left:right]
        sign = between.split(b"//")[0].strip().decode()
        # From a macro, or with a comment between: not what it seems.
        if not start < left < right < stop or sign.encode() != between.strip() or (left, right) in self.taken:
            return
        at = left + between.index(sign.encode()) if sign else left
        both_numbers = all(map(is_number, operands))
        if sign in COMPARISONS and cursor.type.get_canonical().kind == TypeKind.BOOL:
            name, change = COMPARISONS[sign]
        elif sign in SUMS and both_numbers:
            name, change = SUMS[sign]
        elif sign in STEPS and both_numbers:
            name, change = STEPS[sign]
        elif sign in WORDS:
            number = f"mutants::is_on({self.new(at, at + 2, WORDS[sign])})"
            self.taken.add((left, right))
            self.around(spans, depth, ("(((bool(", f") != {number}) {sign} (bool(", f") != {number})) != {number})"))
            return
        elif sign == "=" and both_numbers and self.data[right:stop] == b"0":
            self.zero(right, stop)
            return
        else:
            return
        self.taken.add((left, right))
        number = self.new(at, at + len(sign), change)
        self.around(spans, depth, (f"mutants::{name}({number}, ", ", ", ")"))

    def zero(self, start, stop):
        self.edit(start, stop, f"mutants::zero({self.new(start, stop, '1')})", 0)

    def walk(self, cursor, depth):
        kind = cursor.kind
        start, stop = self.span(cursor)
        children = list(cursor.get_children())
        if kind in CONSTANT or (kind == CursorKind.VAR_DECL and b"constexpr" in self.data[start:stop].split(b"=")[0]):
            return
        if kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.operation(cursor, children, depth)
        elif kind == CursorKind.CALL_EXPR:
            arguments = list(cursor.get_arguments())
            if cursor.spelling in SWAPPED:
                self.swap(cursor, children, depth)
            elif len(arguments) == 2 and cursor.spelling.startswith("operator") and all(arguments):
                self.operation(cursor, sorted(arguments, key=lambda a: a.extent.start.offset), depth)
        elif kind == CursorKind.RETURN_STMT and self.data[start:stop] in (b"return true", b"return false"):
            change = "false" if self.data[start:stop].endswith(b"true") else "true"
            self.edit(stop, stop, f" != mutants::is_on({self.new(start + 7, stop, change)})", -1)
        elif kind in (CursorKind.VAR_DECL, CursorKind.FIELD_DECL) and self.data[start:stop].endswith(b" = 0"):
            self.zero(stop - 1, stop)
        for child in children:
            self.walk(child, depth + 1)

    def swap(self, cursor, children, depth):
        """std::min(a, b) becomes mutants::min(17, a, b)."""
        start, stop = self.span(cursor)
        word = f"std::{cursor.spelling}".encode()
        if self.data[start:start + len(word)] != word or (start, stop) in self.taken:
            return
        bracket = self.data.find(b"(", start)
        self.taken.add((start, stop))
        number = self.new(start + 5, start + 8, SWAPPED[cursor.spelling])
        self.edit(start, start + 3, "mutants", depth)
        self.edit(bracket + 1, bracket + 1, f"{number}, ", -500)

    def text(self, header):
        """The file with its mutants."""
        result, last = [f'#include "{header}"\n#line 1\n'.encode()], 0
        for start, _, _, end, piece in sorted(self.edits):
            result += [self.data[last:start], piece.encode()]
            last = max(last, end)
        return b"".join(result + [self.data[last:]]).decode()


def read(files, arguments):
    """Finds the mutants of files (path: Schemata) that can be read as one; returns Clang's errors."""
    texts = [(path, file.data.decode()) for path, file in files.items()]
    texts.append(("all.cpp", "".join(f'#include "{path}"\n' for path in files)))
    unit = cindex.Index.create().parse("all.cpp", arguments, unsaved_files=texts)
    for cursor in unit.cursor.get_children():
        if cursor.location.file and cursor.location.file.name in files:
            files[cursor.location.file.name].walk(cursor, 0)
    return [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
