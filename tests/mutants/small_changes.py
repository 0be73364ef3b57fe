#!/usr/bin/env python3
"""small_changes.py BUILD [TASK]... [--guards | --pairs N --seed S] [--list] [--jobs N]

Tries every small change of right code: the reference of a task, and the right solutions that small_changes.txt names. Each
operator, comparison, constant, sign, order of arguments, index, condition, statement and variable is changed alone (King and
Offutt 1991, A Fortran Language System for Mutation-based Software Testing), and the promises must find it.

A change that no promise finds is printed in the form of small_changes.txt. It is one of three: the same function (keep it there, below
the reason), within the contract's precision (as well), or a mistake that escapes: then a promise needs better inputs. A change
whose object file is the same, byte by byte, is the same function, and is not printed (Papadakis 2015, Trivial Compiler
Equivalence). One that takes more than SECONDS and four times the time of the unchanged file counts as too slow: it runs on and on.

With --guards, each change is a guard that people write, at each place (guards.py). With --pairs, it is two edits, small changes or guards;
a seed draws N pairs of each file.

Results are kept in BUILD/small_changes, so that a run can be stopped and started again; they hold as long as the properties'
object files stay the same. --list counts the changes and runs nothing. The exit status is 1 if a change survives that
small_changes.txt does not have, 2 if something cannot be used.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import math
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

import guards
from edits_of_tokens import changed_files
from reasons import ROOT, TABLE, reasons, shown

SECONDS = 2  # of processor time that a program may take, and four times what it takes unchanged
TOGETHER = 100  # changes in one program


def digest(text):
    return hashlib.sha256(text if isinstance(text, bytes) else text.encode()).hexdigest()[:24]


def limits(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


# One program has many versions of a task, each in a namespace of its own, as the known mistakes are compiled
# (cmake/mistakes.cmake). It acts as the one whose number the environment has, and never looks for smaller inputs: that takes most of the time
# of a program that fails.
PROGRAM = """#include "grader/calls.h"
#include <cstdlib>
namespace grader::check { void never_shrink(); }
static const int chosen = (grader::check::never_shrink(), std::atoi(std::getenv("CHANGE")));
#define RENAME(function) changed_##function
#define DECLARE(result, function, parameters, names) result function parameters;
@INCLUDES@
@RENAMED@
@VERSIONS@
@RENAMED_BACK@
#define POINTER(space, function) &space::function,
#define DISPATCH(result, function, parameters, names) \\
  result function parameters { \\
    using Function = result(*) parameters; \\
    static constexpr Function kAll[] = {ALL(changed_##function)}; \\
    return kAll[chosen] names; \\
  }
#define ALL(function) @SPACES@
namespace pt { FIRSTLIGHT_CALLS_@SLUG@(DISPATCH, DISPATCH) }
"""


class Task:
    """Compiles and checks changed files of one task, in the folder of the build."""

    def __init__(self, build, slug):
        self.build, self.slug = build, slug
        commands = json.loads((build / "compile_commands.json").read_text())
        own = f"{slug}.reference.dir"
        found = [c for c in commands if f"CMakeFiles/{own}/" in c["command"]]
        if not found:
            sys.exit(f"{build} has no task {slug}; write the name of a task, or configure the project there")
        compiled = shlex.split(found[0]["command"])
        self.object = compiled[compiled.index("-o") + 1]
        self.flags = [word for word in compiled[:compiled.index("-o")] if word != "-Werror"] + ["-w", "-D_GLIBCXX_ASSERTIONS"]
        program = f"grader/check.{slug}.reference"
        if subprocess.run(["ninja", "-C", build, program], capture_output=True).returncode != 0:
            sys.exit(f"{program} does not build")
        ninja = subprocess.run(["ninja", "-C", build, "-t", "commands", program], capture_output=True, text=True).stdout
        link = ninja.strip().splitlines()[-1]
        self.link = shlex.split(link[link.index("&& ") + 3:link.rindex(" &&")])
        properties = next(p for p in self.link if f"properties.{slug}.dir" in p)
        self.state = digest((build / properties).read_bytes() + (build / "grader/check/libgrader_check.a").read_bytes())
        self.functions = json.loads((ROOT / "grader/tasks" / slug / "task.json").read_text()).get("functions", [slug])

    def compiled(self, text, folder):
        """The object file of a text, or what the compiler says."""
        file, target = folder / f"{self.slug}.cpp", folder / "task.o"
        file.write_text(text)
        run = subprocess.run(self.flags + ["-o", target, "-c", file], cwd=self.build, capture_output=True, text=True)
        return (target.read_bytes(), "") if run.returncode == 0 else (None, run.stderr)

    def program_of(self, texts, folder):
        """A program of all texts, and the indices of those that do not compile."""
        includes = sorted({line for text in texts for line in re.findall(r"^#include .*$", text, re.M)})
        bad = set()
        while len(bad) < len(texts):
            versions = []
            for i, text in enumerate(texts):
                if i not in bad:
                    body = re.sub(r"^#include .*$", "", text, flags=re.M)
                    versions.append(f"namespace in_{i} {{ using namespace ::pt;\nFIRSTLIGHT_CALLS_{self.slug}(DECLARE, DECLARE) }}\n"
                                    f"#define pt in_{i}\n#line 1 \"change_{i}\"\n{body}\n#undef pt")
            parts = {"INCLUDES": "\n".join(includes), "VERSIONS": "\n".join(versions), "SLUG": self.slug,
                     "RENAMED": "\n".join(f"#define {name} changed_{name}" for name in self.functions),
                     "RENAMED_BACK": "\n".join(f"#undef {name}" for name in self.functions),
                     "SPACES": " ".join(f"POINTER(in_{i if i not in bad else good(texts, bad)}, function)" for i in range(len(texts)))}
            made, errors = self.compiled(re.sub(r"@(\w+)@", lambda m: parts[m.group(1)], PROGRAM), folder)
            if made is not None:
                words = [str(folder / "task.o") if word == self.object else word for word in self.link]
                words[words.index("-o") + 1] = str(folder / "check")
                linked = subprocess.run(words, cwd=self.build, capture_output=True, text=True)
                if linked.returncode == 0:
                    return bad
                errors = linked.stderr
            undefined = {int(i) for i in re.findall(r"undefined reference to 'in_(\d+)::", errors)}
            found = undefined or {int(i) for i in re.findall(r"^change_(\d+):\d+:\d+: (?:fatal )?error", errors, re.M)} - bad
            found = found or {int(i) for i in re.findall(r"^change_(\d+):\d+:\d+:   required from", errors, re.M)} - bad
            found = found or {int(i) for i in re.findall(r" error: [^\n]*\bin_(\d+)::", errors)} - bad  # another type of the result
            if not found:
                sys.exit(errors)
            bad |= found
        return bad

    def run(self, folder, number, promises, seconds):
        return subprocess.run([folder / "check", f"--gtest_filter={promises}", "--gtest_fail_fast"], cwd=folder, text=True,
                              env=os.environ | {"CHANGE": str(number)}, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              preexec_fn=lambda: limits(seconds))

    def judge_unchanged(self, source):
        """The bonus promises that it does not keep, and how many seconds a changed one may take."""
        with tempfile.TemporaryDirectory(dir=self.build) as name:
            self.program_of([source], pathlib.Path(name))
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            said = subprocess.run([pathlib.Path(name) / "check"], cwd=name, capture_output=True, text=True,
                                  env=os.environ | {"CHANGE": "0"}).stdout
            took = resource.getrusage(resource.RUSAGE_CHILDREN)
        broken = sorted(set(re.findall(r"^\[  FAILED  \] ([a-z_]+\.[a-z_]+)", said, re.M)))
        if any(not promise.endswith("_bonus") for promise in broken):
            sys.exit(f"{self.slug} breaks {broken} unchanged: mend that first")
        return "-" + ":".join(broken), math.ceil(SECONDS + 4 * (took.ru_utime - before.ru_utime + took.ru_stime - before.ru_stime))

    def outcomes(self, source, texts, promises, seconds, pool):
        """What becomes of each text."""
        with tempfile.TemporaryDirectory(dir=self.build) as name:
            folder = pathlib.Path(name)
            bad = self.program_of(texts, folder)

            def outcome(i):
                if i in bad:
                    return "does not compile"
                status = self.run(folder, i, promises, seconds).returncode
                return {0: "SURVIVES", -signal.SIGKILL: "too slow"}.get(status, "found")

            all_outcomes = list(pool.map(outcome, range(len(texts))))
            unchanged, _ = self.compiled(source, folder)
            for i, text in enumerate(texts):
                if all_outcomes[i] == "SURVIVES" and self.compiled(text, folder)[0] == unchanged:
                    all_outcomes[i] = "same object"
            return all_outcomes


def good(texts, bad):
    return next(i for i in range(len(texts)) if i not in bad)


def bases_of(slug):
    """The reference of a task, and the right solutions that have a heading in small_changes.txt."""
    named = {line[3:] for line in TABLE.read_text().splitlines() if line.startswith("== ")}
    right = sorted((ROOT / "grader/tasks" / slug / "right").glob("*.cpp"))
    return list(ROOT.glob(f"reference/*/{slug}.cpp")) + [file for file in right if str(file.relative_to(ROOT)) in named]


def changes_of(source, options):
    """Each changed text, with its edits."""
    if options.guards:
        return guards.guarded_files(source)
    if options.pairs:
        return guards.paired_files(source, options.pairs, options.seed)
    return {text: (edit,) for text, edit in changed_files(source).items()}


def try_base(task, base, todo, kept, known, pool):
    """Counts of the outcomes, and the changes that survive."""
    source = base.read_text()
    promises, seconds = task.judge_unchanged(source)
    key = lambda text: f"{task.slug} {task.state} {digest(text + promises)}"
    new = [text for text in todo if key(text) not in known]
    for first in range(0, len(new), TOGETHER):
        texts = new[first:first + TOGETHER]
        for text, outcome in zip(texts, task.outcomes(source, texts, promises, seconds, pool)):
            known[key(text)] = outcome
            with kept.open("a") as file:
                file.write(f"{key(text)}\t{outcome}\n")
    counts = collections.Counter(known[key(text)] for text in todo)
    return counts, [(*shown(source, *todo[text]), todo[text][0][2]) for text in todo if known[key(text)] == "SURVIVES"]


def main():
    parser = argparse.ArgumentParser(description=textwrap.dedent(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("tasks", nargs="*")
    parser.add_argument("--guards", action="store_true")
    parser.add_argument("--pairs", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_intermixed_args()
    slugs = options.tasks or sorted(p.parent.name for p in (ROOT / "grader/tasks").glob("*/task.json"))
    known_reasons, escapes = reasons(), 0
    if options.list:
        for base in [base for slug in slugs for base in bases_of(slug)]:
            print(f"{len(changes_of(base.read_text(), options)):5} {base.relative_to(ROOT)}")
        return
    kept = options.build / "small_changes"
    known = dict(line.split("\t") for line in kept.read_text().splitlines()) if kept.exists() else {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for slug in slugs:
            task = Task(options.build, slug)
            for base in bases_of(slug):
                place = base.relative_to(ROOT)
                counts, survivors = try_base(task, base, changes_of(base.read_text(), options), kept, known, pool)
                new = [(line, changed) for line, changed, word in survivors
                       if not {(str(place), line, changed), (str(place), "", word)} & known_reasons]
                escapes += len(new)
                counted = ", ".join(f"{n} {outcome}" for outcome, n in sorted(counts.items()))
                print(f"== {place}\n# {sum(counts.values())} changes: {counted}; {len(new)} without a reason", flush=True)
                for line, changed in new:
                    print(f"- {line}\n+ {changed}", flush=True)
    sys.exit(1 if escapes else 0)


if __name__ == "__main__":
    main()
