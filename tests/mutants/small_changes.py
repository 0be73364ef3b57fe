#!/usr/bin/env python3
"""small_changes.py BUILD [TASK]... [--list] [--jobs N]

Tries every small change of right code: the reference of a task, and two more right solutions. Each operator, comparison,
constant, sign, order of arguments, index, condition, statement and variable is changed alone (King and Offutt 1991, A Fortran
Language System for Mutation-based Software Testing), and the promises must find it.

A change that no promise finds is printed as an entry of small_changes.txt. It is one of three: the same function (write why, and
keep the entry), within the contract's precision (as well), or a mistake that escapes: then a promise needs better inputs. A change
whose object file is the same, byte by byte, is the same function, and is not printed (Papadakis 2015, Trivial Compiler
Equivalence).

Results are kept in BUILD/small_changes, so that a run can be stopped and started again; they hold as long as the properties'
object files stay the same. --list counts the changes and runs nothing. The exit status is 1 if a change survives that
small_changes.txt does not have, 2 if something cannot be used.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests/mutants/small_changes.txt"
SECONDS = 20  # of processor time that a program may take; the slowest right one takes a fifth

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


def entry(name, base, source, start, end, new):
    """The change as an entry of the table: whole lines that stand exactly once in the file."""
    a = source.rfind("\n", 0, start) + 1
    b = (source + "\n").find("\n", end)
    while source.count(source[a:b]) > 1 and a > 0:
        a = source.rfind("\n", 0, a - 1) + 1
    old, changed = source[a:b], source[a:start] + new + source[end:b]
    block = lambda label, text: f"{label:8}" + ("\n" + " " * 8).join(text.split("\n"))
    return "\n".join([f"name    {name}", "says    ", f"base    {base}", block("old", old), block("new", changed)])


def accepted():
    """The hashes of the changed files that the table has."""
    if not TABLE.exists():
        return set()
    awk = ["awk", "-v", f"root={ROOT}", "-v", "needed=says base old"]
    script = ["-f", str(ROOT / "cmake/edits.awk"), str(TABLE)]
    names = subprocess.run(awk + ["-v", "list=name"] + script, capture_output=True, text=True)
    if names.returncode != 0:
        sys.exit(names.stderr)
    return {digest(subprocess.run(awk + ["-v", f"only={name}"] + script, capture_output=True, text=True).stdout)
            for name in names.stdout.split()}


def digest(text):
    return hashlib.sha256(text if isinstance(text, bytes) else text.encode()).hexdigest()[:24]


def limits():
    os.setsid()
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Task:
    """Compiles and checks changed files of one task, in the folder of the build."""

    def __init__(self, build, slug):
        self.build, self.slug = build, slug
        commands = json.loads((build / "compile_commands.json").read_text())
        own = f"{slug}.reference.dir"
        found = [c for c in commands if f"CMakeFiles/{own}/" in c["command"]]
        if not found:
            sys.exit(f"{build} has no task {slug}; write the name of a task, or configure the project there")
        self.source, self.compile = found[0]["file"], shlex.split(found[0]["command"])
        self.object = self.compile[self.compile.index("-o") + 1]
        program = f"grader/check.{slug}.reference"
        if subprocess.run(["ninja", "-C", build, program], capture_output=True).returncode != 0:
            sys.exit(f"{program} does not build")
        ninja = subprocess.run(["ninja", "-C", build, "-t", "commands", program], capture_output=True, text=True).stdout
        link = ninja.strip().splitlines()[-1]
        self.link = shlex.split(link[link.index("&& ") + 3:link.rindex(" &&")])
        properties = next(p for p in self.link if f"properties.{slug}.dir" in p)
        self.state = digest((build / properties).read_bytes() + (build / "grader/check/libgrader_check.a").read_bytes())

    def make(self, source, folder):
        file, target, program = folder / f"{self.slug}.cpp", folder / "task.o", folder / "check"
        file.write_text(source)
        own = {self.object: str(target), self.source: str(file)}
        compiled = [own.get(word, word) for word in self.compile if word != "-Werror"] + ["-w"]
        if subprocess.run(compiled, cwd=self.build, capture_output=True).returncode != 0:
            return None
        words = [own.get(word, word) for word in self.link]
        words[words.index("-o") + 1] = str(program)
        if subprocess.run(words, cwd=self.build, capture_output=True).returncode != 0:
            return None
        return target.read_bytes()

    def judge_unchanged(self, source):
        """Its object file, and the promises that it does not keep: bonus promises only."""
        with tempfile.TemporaryDirectory(dir=self.build) as name:
            made = self.make(source, pathlib.Path(name))
            if made is None:
                sys.exit(f"{self.slug} does not compile unchanged")
            said = subprocess.run([pathlib.Path(name) / "check"], cwd=name, capture_output=True, text=True).stdout
        broken = sorted(set(re.findall(r"^\[  FAILED  \] ([a-z_]+\.[a-z_]+)", said, re.M)))
        if any(not promise.endswith("_bonus") for promise in broken):
            sys.exit(f"{self.slug} breaks {broken} unchanged: mend that first")
        return made, "-" + ":".join(broken)

    def outcome(self, source, unchanged, promises):
        with tempfile.TemporaryDirectory(dir=self.build) as name:
            folder = pathlib.Path(name)
            made = self.make(source, folder)
            if made is None:
                return "does not compile"
            if made == unchanged:
                return "same object"
            run = subprocess.Popen([folder / "check", f"--gtest_filter={promises}", "--gtest_fail_fast"], cwd=folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limits)
            try:
                return "SURVIVES" if run.wait(timeout=6 * SECONDS) == 0 else "found"
            except subprocess.TimeoutExpired:
                os.killpg(run.pid, signal.SIGKILL)
                run.wait()
                return "found"


def bases_of(slug):
    """The reference of a task, and two more right solutions."""
    return list(ROOT.glob(f"reference/*/{slug}.cpp")) + sorted((ROOT / "grader/tasks" / slug / "right").glob("*.cpp"))[:2]


def changed_files(source):
    """Each changed text, with its change."""
    all_files = {}
    for start, end, new in changes(source):
        all_files.setdefault(source[:start] + new + source[end:], (start, end, new))
    all_files.pop(source, None)
    return all_files


def try_base(task, base, kept, known, pool):
    """Counts of the outcomes, and the changes that survive."""
    source = base.read_text()
    todo = changed_files(source)
    unchanged, promises = task.judge_unchanged(source)
    key = lambda text: f"{task.slug} {task.state} {digest(text + promises)}"

    def judge(text):
        if key(text) not in known:
            known[key(text)] = task.outcome(text, unchanged, promises)
            with kept.open("a") as file:
                file.write(f"{key(text)}\t{known[key(text)]}\n")
        return known[key(text)]

    counts, survivors = {}, []
    for text, outcome in zip(todo, pool.map(judge, todo)):
        counts[outcome] = counts.get(outcome, 0) + 1
        if outcome == "SURVIVES":
            survivors.append((text, todo[text]))
    return counts, survivors


def main():
    parser = argparse.ArgumentParser(description=textwrap.dedent(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("tasks", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_intermixed_args()
    slugs = options.tasks or sorted(p.parent.name for p in (ROOT / "grader/tasks").glob("*/task.json"))
    reasons, escapes = accepted(), 0
    if options.list:
        for base in [base for slug in slugs for base in bases_of(slug)]:
            print(f"{len(changed_files(base.read_text())):5} {base.relative_to(ROOT)}")
        return
    kept = options.build / "small_changes"
    known = dict(line.split("\t") for line in kept.read_text().splitlines()) if kept.exists() else {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for slug in slugs:
            task = Task(options.build, slug)
            for base in bases_of(slug):
                place = base.relative_to(ROOT)
                counts, survivors = try_base(task, base, kept, known, pool)
                new = [(text, edit) for text, edit in survivors if digest(text) not in reasons]
                escapes += len(new)
                counted = ", ".join(f"{n} {outcome}" for outcome, n in sorted(counts.items()))
                print(f"# {place}: {sum(counts.values())} changes: {counted}; {len(new)} without a reason", flush=True)
                for text, edit in new:
                    print("\n" + entry(f"{slug}_{digest(text)[:6]}", place, base.read_text(), *edit) + "\n", flush=True)
    sys.exit(1 if escapes else 0)


main()
