"""small_changes.txt: the small changes that nothing finds, each below the reason why it is right."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests/mutants/small_changes.txt"


def shown(source, *edits):
    """The changed lines before and after, as small_changes.txt has them: those of more edits with dots between them."""
    before, after = [], []
    for start, end, new in sorted(edits):
        a = source.rfind("\n", 0, start) + 1
        b = (source + "\n").find("\n", end)
        before.append(" ".join(source[a:b].split()))
        after.append(" ".join((source[a:start] + new + source[end:b]).split()))
    return " ... ".join(before), " ... ".join(after)


def reasons():
    """The (base, line, changed line) that small_changes.txt has a reason for. (base, "", "float") stands for each double that is a float."""
    found, base, line, why = set(), "", "", ""
    for number, text in enumerate(TABLE.read_text().splitlines(), 1):
        def fail(what):
            sys.exit(f"{TABLE}:{number}: {what}")
        mark, rest = text[:2], " ".join(text[2:].split())
        if text.startswith("== "):
            base, line, why = text[3:], "", ""
            if not (ROOT / base).exists():
                fail(f"there is no {base}; write where it is now")
        elif mark == "- ":
            line = rest
            text = " ".join((ROOT / base).read_text().split())
            if not all(piece in text for piece in line.split(" ... ")):
                fail(f"{base} has no line '{line}'; the reason may not hold any more")
        elif mark == "+ ":
            if not why:
                fail("write the reason above it")
            found.add((base, line, rest))
        elif not text.startswith("#"):
            line, why = "", text
    return found
