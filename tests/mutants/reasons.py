"""Tables of what is right, each entry below its reason: small_changes.txt, with the small changes that nothing finds, and arms.txt."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests/mutants/small_changes.txt"
ANY_FILE = "any file"  # in place of a file: what follows holds for all


def shown(source, *edits):
    """The changed lines before and after, as small_changes.txt has them: those of more edits with dots between them."""
    before, after = [], []
    for start, end, new in sorted(edits):
        a = source.rfind("\n", 0, start) + 1
        b = (source + "\n").find("\n", end)
        before.append(" ".join(source[a:b].split()))
        after.append(" ".join((source[a:start] + new + source[end:b]).split()))
    return " ... ".join(before), " ... ".join(after)


def entries(table):
    """(line number, file, reason, mark, text) of each line of such a table that begins with a mark, "- " or "+ "."""
    base, why = "", ""
    for number, line in enumerate(table.read_text().splitlines(), 1):
        def fail(what):
            sys.exit(f"{table}:{number}: {what}")
        mark, text = line[:2], " ".join(line[2:].split())
        if line.startswith("== "):
            base, why = line[3:], ""
            if base != ANY_FILE and not (ROOT / base).exists():
                fail(f"there is no {base}; write where it is now")
        elif mark == "- " and base != ANY_FILE:
            source = " ".join((ROOT / base).read_text().split())
            if not all(piece in source for piece in text.split(" ... ")):
                fail(f"{base} has no line '{text}'; the reason may not hold any more")
            yield number, base, why, mark, text
        elif mark in ("- ", "+ "):
            yield number, base, why, mark, text
        elif not line.startswith("#"):
            why = line


def reasons():
    """The (base, line, changed line) that small_changes.txt has a reason for. (base, "", "float") stands for each double that is a float."""
    found, below, line = set(), None, ""
    for number, base, why, mark, text in entries(TABLE):
        if (base, why) != below:
            below, line = (base, why), ""
        if mark == "- ":
            line = text
        elif not why:
            sys.exit(f"{TABLE}:{number}: write the reason above it")
        else:
            found.add((base, line, text))
    return found
