"""The small changes of a C++ file, by its tokens."""

import re

TOKEN = re.compile(
    r"""(?P<skip>//[^\n]*|/\*.*?\*/|\#[^\n]*|\s+)
    |(?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])')
    |(?P<number>0[xX][0-9a-fA-F.]+(?:p[-+]?\d+)?|\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)
    |(?P<name>[A-Za-z_]\w*)
    |(?P<mark><<|>>|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|\+\+|--|->|::|.)""",
    re.S | re.X)

BINARY = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
          "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["/"], "&&": ["||"], "||": ["&&"],
          "+=": ["-=", "="], "-=": ["+=", "="], "*=": ["/=", "="], "/=": ["*=", "="], ">>": ["<<"], "<<": [">>"]}
MEMBERS = {"x": "y", "y": "z", "z": "x", "r": "g", "g": "b", "b": "r", "min": "max", "max": "min", "t_min": "t_max",
           "t_max": "t_min", "p0": "p1", "p1": "p2", "p2": "p0", "n0": "n1", "n1": "n2", "n2": "n0", "wi": "wo", "wo": "wi",
           "origin": "direction", "direction": "origin", "from": "to", "to": "from"}
NAMES = {"min": ["max"], "max": ["min"], "sin": ["cos"], "cos": ["sin"], "floor": ["ceil"], "ceil": ["floor"],
         "true": ["false"], "false": ["true"]}


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


def tokens_of(source):
    return [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(source) if m.lastgroup != "skip"]


def partners(tokens):
    """The index of the closing bracket for each opening one."""
    pairs, open_brackets = {}, []
    for i, token in enumerate(tokens):
        if token.text in ("(", "[", "{"):
            open_brackets.append(i)
        elif token.text in (")", "]", "}") and open_brackets:
            pairs[open_brackets.pop()] = i
    return pairs


def arguments(tokens, begin, end):
    """(start, end) in the source of each argument between two brackets."""
    depth, first, found = 0, begin + 1, []
    for i in range(begin + 1, end + 1):
        if tokens[i].text in ("(", "[", "{"):
            depth += 1
        if (tokens[i].text == "," and depth == 0) or i == end:
            if i > first:
                found.append((tokens[first].start, tokens[i - 1].end))
            first = i + 1
        if tokens[i].text in (")", "]", "}"):
            depth -= 1
    return found


def number_changes(text):
    if re.fullmatch(r"\d+", text):
        value = int(text)
        return [str(value + 1)] + ([str(value - 1)] if value > 0 else [])
    return [f"(2 * {text})", f"(1.01 * {text})"]


def declarations(source, tokens):
    """(type, name, index) of each variable and parameter."""
    found = []
    for i in range(1, len(tokens) - 1):
        name, before, after = tokens[i], tokens[i - 1], tokens[i + 1]
        if name.kind != "name" or after.text not in ("=", ",", ")", ";", "{", ":"):
            continue
        if before.text == "&" and i > 1 and tokens[i - 2].kind == "name":
            found.append((tokens[i - 2].text, name.text, i))
        elif before.kind == "name" and before.text not in ("return", "else", "case", "goto", "namespace", "using", "struct"):
            found.append((before.text, name.text, i))
        elif before.text == "," and found and "\n" not in source[tokens[found[-1][2]].start:name.start] and after.text == "=":
            found.append((found[-1][0], name.text, i))
    return found


def changes(source):
    """(start, end, new text) of every small change."""
    tokens = tokens_of(source)
    pairs = partners(tokens)
    spaced = lambda t: source[t.start - 1].isspace() and source[t.end].isspace()
    functions = [(i, pairs[i]) for i in pairs if tokens[i].text == "{" and tokens[i - 1].text in (")", "const")]
    inside = lambda i: next(((a, b) for a, b in functions if a < i < b), None)
    declared = declarations(source, tokens)
    places = {index for _, _, index in declared}
    ends = {tokens[pairs[i]].start for i in pairs if i > 0 and tokens[i - 1].text in ("if", "while", "for")}
    for i, token in enumerate(tokens):
        if token.kind == "name" and token.text == "double":
            yield token.start, token.end, "float"
        if inside(i) is None and token.kind != "number":
            continue
        previous, text = tokens[i - 1], token.text
        if token.kind == "mark" and text in BINARY and spaced(token):
            for other in BINARY[text]:
                yield token.start, token.end, other
        elif text in ("++", "--"):
            yield token.start, token.end, "--" if text == "++" else "++"
        elif text in ("-", "!") and source[token.end] not in " =":
            yield token.start, token.end, ""
        elif token.kind == "number":
            for other in number_changes(text):
                yield token.start, token.end, other
        elif token.kind == "name" and previous.text in (".", "->") and text in MEMBERS and tokens[i + 1].text != "(":
            yield token.start, token.end, MEMBERS[text]
        elif token.kind == "name" and text in NAMES:
            for other in NAMES[text]:
                yield token.start, token.end, other
        elif token.kind == "name" and previous.text not in (".", "->", "::") and i not in places:
            types = {t for t, name, at in declared if name == text and at < i}
            first = source.rfind("\n\n", 0, tokens[inside(i)[0]].start)
            ready = lambda at: any(t.text in (";", "{") for t in tokens[at:i])  # not in its own declaration
            for other in sorted({name for t, name, at in declared if t in types and name != text and at < i and
                                 tokens[at].start > first and ready(at)}):
                yield token.start, token.end, other
        if text in ("=", "return") and (tokens[i + 1].kind == "name" or tokens[i + 1].text == "("):
            yield tokens[i + 1].start, tokens[i + 1].start, "-"
        if text == "[" and i in pairs and pairs[i] > i + 1 and previous.kind == "name":
            yield tokens[pairs[i]].start, tokens[pairs[i]].start, " + 1"
        if text in ("(", "{") and i in pairs and previous.text not in (")", "if", "while", "for"):
            parts = arguments(tokens, i, pairs[i])
            for (a, b), (c, d) in zip(parts, parts[1:]):
                if ";" not in source[a:d] and source[a:b] != source[c:d]:
                    yield a, d, source[c:d] + source[b:c] + source[a:b]
        if text in ("if", "while") and tokens[i + 1].text == "(":
            a, b = tokens[i + 1].end, tokens[pairs[i + 1]].start
            yield a, b, "false"
            if text == "if":
                yield a, b, "true"
        if (previous.text in (";", "{", "}") or previous.start in ends) and token.kind in ("name", "mark") and \
                text not in ("const", "constexpr", "return", "using", "}", "{", "else", "namespace", "for", "while", "if"):
            k = i
            while k < len(tokens) and tokens[k].text not in (";", "{", "}", ")"):
                k = pairs.get(k, k) + 1
            if k < len(tokens) and tokens[k].text == ";" and tokens[k - 1].text != ")" or \
                    k < len(tokens) and tokens[k].text == ";" and i not in places and i + 1 not in places:
                yield token.start, tokens[k].end, ";"


def changed_files(source):
    """Each changed text, with its change."""
    all_files = {}
    for start, end, new in changes(source):
        all_files.setdefault(source[:start] + new + source[end:], (start, end, new))
    all_files.pop(source, None)
    return all_files
