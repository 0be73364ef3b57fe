"""Guards that people write (an epsilon, an early end, a clamp, a remembered value, a copy of the sampler), at each place of a C++ file; and
pairs of edits. A change is a tuple of edits (start, end, new text)."""

import itertools
import random

from edits_of_tokens import changes, declarations, partners, tokens_of

# What is guarded against, of a value of each type.
SMALL = {"double": "std::abs({}) < 1e-6", "Rgb": "max_channel({}) < 1e-3"}


class Code:
    def __init__(self, source):
        self.source, self.tokens = source, tokens_of(source)
        self.pairs = partners(self.tokens)
        self.opens = {close: i for i, close in self.pairs.items()}
        self.declared = declarations(source, self.tokens)

    def blocks(self):
        """(kind, first token, last token) of each function and loop with braces; the header of a loop is a part of it."""
        for i, close in self.pairs.items():
            if self.tokens[i].text != "{" or self.tokens[i - 1].text not in (")", "const"):
                continue
            begin = self.opens.get(i - 1 if self.tokens[i - 1].text == ")" else i - 2)
            word = self.tokens[begin - 1].text if begin else ""
            if word in ("for", "while"):
                yield "loop", i, close
            elif word not in ("if", "switch", ""):
                yield "function", i, close

    def ways_out(self, i):
        """Of the innermost function or loop that token i is in."""
        around = [(a, kind) for kind, a, b in self.blocks() if a < i < b]
        if not around:
            return []
        return ["return {};"] if max(around)[1] == "function" else ["continue;", "break;"]

    def statement(self, i):
        """The first token and the semicolon of the statement that declares token i, if it is one of its own."""
        first = i
        while first > 0 and self.tokens[first - 1].text not in (";", "{", "}", "(", ")"):
            first -= 1
        last = i
        while last < len(self.tokens) and self.tokens[last].text not in (";", ")", "}"):
            last = self.pairs.get(last, last) + 1
        is_one = first > 0 and self.tokens[first - 1].text != "(" and last < len(self.tokens) and self.tokens[last].text == ";"
        return (first, last) if is_one else None


def of_values(code):
    for kind, name, i in code.declared:
        found = code.statement(i)
        if not found or not code.ways_out(i) or code.tokens[i + 1].text not in ("=", "{"):
            continue
        start, end = code.tokens[found[0]].start, code.tokens[found[1]].end
        yield ((start, start, "static "),)
        for out in code.ways_out(i) if kind in SMALL else []:
            yield ((end, end, f" if ({SMALL[kind].format(name)}) {out}"),)
        if kind == "double" and code.tokens[i + 1].text == "=":
            a, b = code.tokens[i + 2].start, code.tokens[found[1]].start
            for clamp in ("std::min<double>({}, 10)", "std::max<double>({}, 1e-3)", "std::clamp<double>({}, 0, 1)"):
                yield ((a, b, clamp.format(code.source[a:b])),)


def of_marks(code):
    for i, token in enumerate(code.tokens[:-1]):
        after = code.tokens[i + 1]
        if not code.ways_out(i):
            continue
        if token.text in ("continue", "break"):
            yield ((token.start, token.end, "break" if token.text == "continue" else "continue"),)
        if token.text == "/" and after.kind == "name" and code.tokens[i + 2].text in (";", ")", ",", "+", "-", "*"):
            for guarded in (f"({after.text} + 1e-4)", f"std::max<double>({after.text}, 1e-3)"):
                yield ((after.start, after.end, guarded),)
        if token.text in ("<", ">", "<=", ">=") and code.source[token.start - 1] == code.source[token.end] == " ":
            for epsilon in ("1e-4 + ", "-1e-4 + "):
                yield ((after.start, after.start, epsilon),)


def of_blocks(code):
    for kind, a, b in code.blocks():
        begin, inside = code.tokens[a].end, code.tokens[a + 1:b]
        header = code.tokens[code.opens.get(a - 1, a):a]
        if kind == "loop" and len(header) > 2 and header[1].text == "int":
            for most in (4, 64):
                yield ((begin, begin, f" if ({header[2].text} >= {most}) break;"),)
        if kind == "function" and any(t.text == "sampler" for t in header):
            for token in inside:
                if token.text == "sampler":
                    yield ((begin, begin, " Sampler own = sampler;"), (token.start, token.end, "own"))


def edited(source, change):
    for start, end, new in sorted(change, reverse=True):
        source = source[:start] + new + source[end:]
    return source


def with_headers(text):
    return "#include <algorithm>\n#include <cmath>\n" + text


def guarded_files(source):
    """Each text with a guard, with its change."""
    code, files = Code(source), {}
    for change in itertools.chain(of_values(code), of_marks(code), of_blocks(code)):
        files.setdefault(with_headers(edited(source, change)), change)
    return files


def paired_files(source, count, seed):
    """Texts with two small changes or guards each, drawn by a seed."""
    drawn, files = random.Random(f"{seed} {source}"), {}
    singles = [(edit,) for edit in changes(source)] + list(guarded_files(source).values())
    for _ in range(20 * count):
        edits = sum(drawn.sample(singles, 2), ())
        ordered = sorted(edits)
        if len(files) < count and all(a[1] <= b[0] and a != b for a, b in zip(ordered, ordered[1:])):
            files.setdefault(with_headers(edited(source, edits)), edits)
    return files
